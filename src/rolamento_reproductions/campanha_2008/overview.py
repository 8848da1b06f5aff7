"""What of the dissertation changes when it is computed as it should be, in one table."""

from __future__ import annotations

from rolamento_reproductions.campanha_2008.contact import contact_numbers
from rolamento_reproductions.campanha_2008.film import film_numbers
from rolamento_reproductions.campanha_2008.inputs import GIVEN
from rolamento_reproductions.campanha_2008.nsk import nsk_numbers
from rolamento_reproductions.campanha_2008.numbers import Number, by_key, said_like
from rolamento_reproductions.campanha_2008.rating import rating_numbers
from rolamento_reproductions.campanha_2008.shear import shear_numbers
from rolamento_reproductions.campanha_2008.weibull import lives_of_tests
from rolamento_reproductions.campanha_2008.zone_life import load_zone_numbers
from rolamento_reproductions.record import Section, Table, TableColumn
from rolamento_reproductions.text import Text, said

__all__ = ["overview_section"]


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
    return Section(title, (_table(rows),))


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
        "The elastic approach is no clearance; a C3 bearing loses 5 to 10 %.",
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


def _table(rows: list[tuple[Number, Text]]) -> Table:
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
