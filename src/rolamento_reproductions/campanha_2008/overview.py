"""What changes when it is computed as it should be, in one table; and slips of the text."""

from __future__ import annotations

from dataclasses import dataclass

from rolamento.life.ioannides_harris import fatigue_limit_of_pressure
from rolamento.life.iso281_modified import FATIGUE_PRESSURE
from rolamento.verification.campanha_2008 import as_plotted, four_failures
from rolamento_reproductions.campanha_2008.contact import contact_numbers, shear_numbers
from rolamento_reproductions.campanha_2008.film import film_numbers
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    Number,
    by_key,
    contact_at,
    printed,
    said_like,
)
from rolamento_reproductions.campanha_2008.load_zone import load_zone_numbers
from rolamento_reproductions.campanha_2008.rating import nsk_numbers, rating_numbers
from rolamento_reproductions.campanha_2008.weibull import (
    Tested,
    life_by_all,
    lives_of_tests,
    six_failures,
)
from rolamento_reproductions.record import Section, Table, TableColumn
from rolamento_reproductions.text import Text, formula, said, same


def overview_section(title: Text) -> Section:
    """Gather the numbers that matter from the tables below."""
    numbers = by_key(
        (
            *rating_numbers(),
            *nsk_numbers(),
            *load_zone_numbers(),
            *lives_of_tests(),
            *shear_numbers(),
            *contact_numbers(),
            *film_numbers(),
        )
    )
    rows = [(numbers[key], told) for key, told in _MEANING.items()]
    return Section(title, (_overview_table(rows),))


_MEANING = {
    "basic_life": said(
        "Right, but P/C is above 1/2, where rating life ends.",
        "Certo, mas P/C passa de 1/2, onde a vida nominal termina.",
    ),
    "measured_rating": said(
        "Closer grooves raise no rating: do not enter the catalogue with a higher C.",
        "Canais mais fechados não elevam a capacidade: não se use um C maior que o do catálogo.",
    ),
    "catalogue_I": said(
        "The maker's method refuses this load.", "O método do fabricante recusa esta carga."
    ),
    "measured_I": said("It rests on the raised rating.", "Baseia-se na capacidade elevada."),
    "reduction": said(
        "The elastic deflection is no clearance; a C3 bearing loses 5 to 10 %.",
        "A aproximação elástica não é folga; um rolamento C3 perde de 5 a 10 %.",
    ),
    "life_I": said(
        "The early failure is left out. With all bearings the tests do not contradict (C/P)³.",
        "A falha precoce fica de fora. Com todos os rolamentos os ensaios não contradizem (C/P)³.",
    ),
    "life_II": said(
        "Nothing failed; the tests give a lower limit only.",
        "Nada falhou; os ensaios só dão um limite inferior.",
    ),
    "depth": said(
        "Right by chance: three choices cancel.", "Certo por acaso: três escolhas se compensam."
    ),
    "viscosity_I": said(
        "At the mean temperature; with the right density the dynamic viscosity is nearly as"
        " printed.",
        "À temperatura média; com a densidade certa a viscosidade dinâmica é quase a impressa.",
    ),
    "speed": said("Half: the film wants the mean.", "A metade: o filme pede a média."),
    "film_I": said(
        "A quarter more film than printed.", "Um quarto a mais de filme do que o impresso."
    ),
    "film_II": said("Likewise.", "Da mesma forma."),
    "lambda_I_new": said(
        "A full film while new: nothing but subsurface fatigue is to be expected.",
        "Filme completo enquanto novo: só se espera fadiga sub-superficial.",
    ),
    "lambda_I_7": said(
        "Worn, still a partial film, not boundary lubrication.",
        "Gasto, ainda filme parcial, e não lubrificação limítrofe.",
    ),
    "lambda_II_18": said(
        "Boundary lubrication, yet no failure in condition II.",
        "Lubrificação limítrofe; ainda assim, nenhuma falha na condição II.",
    ),
}


def _overview_table(rows: list[tuple[Number, Text]]) -> Table:
    """Words and numbers only: the numbers are compared below, each in its place."""
    return Table(
        number="A",
        caption=said(
            "What matters most: as printed, as it should be, and what that means. All other numbers"
            " that can be computed are below, with the reason for each.",
            "O que mais importa: como impresso, como deve ser e o que isso significa. Todos os"
            " outros números calculáveis estão abaixo, cada um com seu motivo.",
        ),
        source=GIVEN.source_of("overview"),
        columns=(
            TableColumn(
                "quantity", said("Quantity", "Grandeza"), tuple(row.quantity for row, _ in rows)
            ),
            TableColumn(
                "printed",
                said("printed", "impresso"),
                tuple(said_like(row.printed, float(row.printed)) for row, _ in rows),
            ),
            TableColumn("right", said("right", "correto"), tuple(r.right_text for r, _ in rows)),
            TableColumn(
                "meaning",
                said("what it means", "o que significa"),
                tuple(told for _, told in rows),
                sentences=True,
            ),
        ),
    )


@dataclass(frozen=True, slots=True)
class _Slip:
    """One slip: where it stands, as printed, as it should be, and why."""

    place: Text
    printed: Text
    right: Text
    reason: Text


def slips_section(title: Text) -> Section:
    """List the slips."""
    slips = (*_EQUATIONS, _fatigue_limit(), *_of_weibull(), *_WORDS)

    def column(name: str, head: Text, cells: tuple[Text, ...]) -> TableColumn:
        return TableColumn(name, head, cells, sentences=name != "place")

    table = Table(
        number="K",
        caption=said(
            "Equations and statements that do not hold as printed, but for those told above.",
            "Equações e afirmações que não valem como impressas, além das citadas acima.",
        ),
        source=GIVEN.source_of("slips"),
        columns=(
            column("place", said("Chapter", "Capítulo"), tuple(slip.place for slip in slips)),
            column("printed", said("printed", "impresso"), tuple(slip.printed for slip in slips)),
            column("right", said("right", "correto"), tuple(slip.right for slip in slips)),
            column("reason", said("why", "por quê"), tuple(slip.reason for slip in slips)),
        ),
    )
    return Section(title, (table,))


_EQUATIONS = (
    _Slip(
        same("2.4.6, (2.4.5), (2.4.6)"),
        said("R′ in the groups and as the scale of h", "R′ nos grupos e como escala de h"),
        said("R_x, of the direction of rolling", "R_x, da direção de rolagem"),
        said(
            "So Hamrock and Dowson have it: the inlet, which makes the film, is bent along rolling."
            " With R′ the film of table J is 35 % thinner.",
            "Assim fazem Hamrock e Dowson: a entrada, que forma o filme, tem a curvatura da direção"
            " de rolagem. Com R′ o filme da tabela J é 35 % mais fino.",
        ),
    ),
    _Slip(
        same("2.4.6, (2.4.9)"),
        said("if R_x > R_y, exchange x and y", "se R_x > R_y, trocar x e y"),
        said("no exchange", "não trocar"),
        said(
            "x is the direction of rolling; an ellipse that is long along rolling has k < 1, and"
            " another fit. In a bearing R_y is far greater than R_x anyhow.",
            "x é a direção de rolagem; uma elipse longa nessa direção tem k < 1 e outro ajuste."
            " Em um rolamento R_y é de todo modo muito maior que R_x.",
        ),
    ),
    _Slip(
        same("4.4.3, (4.4.3)"),
        formula("U = D_pw/2 [(1 − γ)(ω_i − ω_m) + φ ω_esf]"),
        formula("U = D_pw/4 [(1 − φ)(ω_i − ω_m) + φ ω_esf]"),
        said(
            "The two terms are the speeds of ring and ball, seen from the cage; their mean, eq."
            " 2.4.8, has another 1/2. γ and φ are the same.",
            "Os dois termos são as velocidades do anel e da esfera, vistas da gaiola; a média, eq."
            " 2.4.8, tem mais um 1/2. γ e φ são o mesmo.",
        ),
    ),
    _Slip(
        same("2.6, (2.6.9)"),
        said("risk ∝ ∫ … dV (1/f − 1)", "risco ∝ ∫ … dV (1/f − 1)"),
        said("risk ∝ ∫ … dV [1 + (1/f − 1)]", "risco ∝ ∫ … dV [1 + (1/f − 1)]"),
        said(
            "Printed is the share of the surface alone: with perfect lubrication, f = 1, nothing"
            " could fail. The share below the surface stands beside it.",
            "Está impressa só a parcela da superfície: com lubrificação perfeita, f = 1, nada"
            " poderia falhar. A parcela sub-superficial soma-se a ela.",
        ),
    ),
)


def _fatigue_limit() -> _Slip:
    """1500 MPa is a pressure."""
    measured = printed("life")["measured_conformity"]
    shape = float(contact_at(1.0, measured, "inner").ellipticity)
    shear = float(fatigue_limit_of_pressure(FATIGUE_PRESSURE, shape))
    return _Slip(
        same("2.6, (2.6.5)"),
        said(
            "the fatigue limit τ_u is about 1500 MPa", "a tensão limite τ_u é da ordem de 1500 MPa"
        ),
        same("{:.0f} MPa", shear / 1e6),
        said(
            "1500 MPa is the contact pressure below which the steel does not tire; the orthogonal"
            " shear under it is a quarter.",
            "1500 MPa é a pressão de contato abaixo da qual o aço não sofre fadiga; o cisalhamento"
            " ortogonal sob ela é um quarto.",
        ),
    )


def _of_weibull() -> tuple[_Slip, ...]:
    """Likelihood equations, and the name of η."""
    four, six, whole = Tested.of(four_failures()).fit, Tested.of(six_failures()), life_by_all()
    printed = as_plotted(four_failures())
    return (
        _Slip(
            same("2.7, (2.7.5)"),
            formula("1/β + (Σ ln t/Σ t^β ln t)/n − Σ ln t/Σ t^β = 0"),
            formula("1/β + (Σ ln t)/n − Σ t^β ln t/Σ t^β = 0"),
            said(
                "As printed it has no solution: Σ t^β > β Σ ln t for lives above 1, so that the"
                " left side is above zero. Put right it gives the four failures of procedure II"
                " β = {:.2f} and L_10h = {:.0f} h, so that the printed lives do not come from it.",
                "Como impressa não tem solução: Σ t^β > β Σ ln t para vidas acima de 1, e o lado"
                " esquerdo fica acima de zero. Corrigida, dá às quatro falhas do procedimento II"
                " β = {:.2f} e L_10h = {:.0f} h, de modo que as vidas impressas não vêm dela.",
                four.shape,
                four.l10,
            ),
        ),
        _Slip(
            same("2.7, (2.7.5), (2.7.6)"),
            said("n bearings, all failed", "n componentes, todos em falha"),
            said(
                "Σ ln t over the r that failed, over r; Σ t^β over all, over r",
                "Σ ln t das r falhas, sobre r; Σ t^β de todos, sobre r",
            ),
            said(
                "The text itself says that all have to fail for them; {} of {} did. For tests in"
                " which some did not, a bearing that still ran counts with its time: L_10h ="
                " {:.0f} h, against {:.0f} h of the failures by themselves.",
                "O próprio texto diz que para elas todos devem falhar; falharam {} de {}. Em"
                " ensaios em que alguns não falham, um rolamento que ainda girava conta com seu"
                " tempo: L_10h = {:.0f} h, contra {:.0f} h das falhas por si sós.",
                whole.test.failures,
                whole.test.size,
                whole.fit.l10,
                six.fit.l10,
            ),
        ),
        _Slip(
            same("2.7"),
            said("η is called mean life", "η é chamado de vida média"),
            said("the 63.2 % life; mean η Γ(1 + 1/β)", "a vida de 63,2 %; média η Γ(1 + 1/β)"),
            said(
                "The text gives the 63.2 % itself. All of condition I: η = {:.0f} h, mean {:.0f} h;"
                " the printed line: {:.0f} and {:.0f} h.",
                "O próprio texto dá os 63,2 %. Toda a condição I: η = {:.0f} h, média {:.0f} h; a"
                " reta impressa: {:.0f} e {:.0f} h.",
                whole.fit.scale,
                whole.fit.mean,
                printed.scale,
                printed.mean,
            ),
        ),
    )


_WORDS = (
    _Slip(
        same("2.2"),
        said(
            "R_z: from the highest peak to the deepest valley in a measuring length",
            "R_z: do pico mais alto ao vale mais baixo em um comprimento de medição",
        ),
        said(
            "mean of that over the sampling lengths, five by custom",
            "média disso nos comprimentos de amostragem, em geral cinco",
        ),
        said(
            "What is described is R_t. R_z is the smaller.", "O que se descreve é R_t. R_z é menor."
        ),
    ),
    _Slip(
        same("2.8"),
        same("anderon: MIL/rad"),
        said("micro-inch per radian", "micropolegada por radiano"),
        said("See table 4.1.4.", "Ver a tabela 4.1.4."),
    ),
    _Slip(
        same("3.4.4"),
        said("clearance measured by ISO 492, 199 and 582", "folga medida pelas ISO 492, 199 e 582"),
        same("ISO 5753-1"),
        said(
            "492 and 199 are tolerances of radial and thrust bearings, 582 corner radii.",
            "492 e 199 são tolerâncias de rolamentos radiais e axiais, 582, raios de canto.",
        ),
    ),
    _Slip(
        same("4.1.2"),
        said("with the failure of bearing 5", "considerando a falha do rolamento 5"),
        said("of test 5, that is bearing 9", "do ensaio 5, isto é, do rolamento 9"),
        said("Bearing 5 did not fail.", "O rolamento 5 não falhou."),
    ),
    _Slip(
        same("4.1.2"),
        said(
            "L_able = 117.4 h by Weibull's distribution",
            "L_able = 117,4 h segundo a distribuição de Weibull",
        ),
        same("L_10h"),
        said(
            "L_able is the maker's calculated life; this one is of the tests.",
            "L_able é a vida calculada do fabricante; esta é a dos ensaios.",
        ),
    ),
    _Slip(
        said("4.3.1, table 4.3.1", "4.3.1, tabela 4.3.1"),
        said("second column: test", "segunda coluna: ensaio"),
        said("sample of the condition", "amostra da condição"),
        said(
            "It counts the bearings of a condition from 1 to 10, as table 4.4.1 does; bearings 9"
            " and 10 are of test 5.",
            "Ela numera os rolamentos de uma condição de 1 a 10, como a tabela 4.4.1; os rolamentos"
            " 9 e 10 são do ensaio 5.",
        ),
    ),
    _Slip(
        same("4.4.3"),
        said("7.03 cSt, see annex C", "7,03 cSt, vide Anexo C"),
        said("annex D", "Anexo D"),
        said(
            "Annex C is of condition I (chapter 3.4.1).",
            "O anexo C é da condição I (capítulo 3.4.1).",
        ),
    ),
)
