"""Figure 8 and a table of it: torque over axial load by the rival models."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from itertools import pairwise

import numpy as np

from rolamento.friction import Torque
from rolamento.friction.harris_1971 import harris_1971
from rolamento.friction.jones_control import jones_control
from rolamento.friction.jones_full import jones_full_motion
from rolamento.friction.jones_simplified import jones_simplified
from rolamento.friction.minimum_power import loaded_contacts
from rolamento.friction.model import controlling_race
from rolamento.friction.todd import todd
from rolamento.numerics.elliptic import complete
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento_reproductions.given import MILLI, grid, status_column
from rolamento_reproductions.record import (
    Claim,
    Curves,
    Figure,
    Floats,
    Line,
    Panel,
    Section,
    Series,
    Table,
    TableColumn,
)
from rolamento_reproductions.ricci_fleury.spin import GIVEN, case
from rolamento_reproductions.text import Text, said, same

_MODELS = (
    ("jones_simplified", said("Jones, simplified", "Jones simplificado")),
    ("todd", said("Todd, with hysteresis", "Todd, com histerese")),
    ("todd_bare", said("Todd, without", "Todd, sem histerese")),
    ("jones_control", said("Jones, with control", "Jones com controle")),
    ("jones_full", said("Jones, full", "Jones completo")),
    ("harris", same("Harris (1971)")),
)
_MOST_OF_FRICTION = 0.80
_NEAR_TODD = 3e-3
_BY_E = 0.01
"""How near the ratio of Jones's full model to Harris's is to E: its own spread over a contact."""


@dataclass(frozen=True, slots=True, eq=False)
class _TorqueSweep:
    """Torques of all models at the loads of the figure; N and N·m."""

    loads: Floats
    solved: Solved
    totals: dict[str, Floats]
    todd: Torque
    spins: tuple[Floats, Floats]


@cache
def _solved_over_load() -> _TorqueSweep:
    given = GIVEN.inputs_of("torque")
    loads = grid(given["lowest_load_N"], given["highest_load_N"], given["step_N"])
    solved = solve(case(float(loads[0]), given["speed_rpm"]), fx=loads)
    mu = given["friction_coefficient"]
    full, motion = jones_full_motion(solved, mu)
    by_todd = todd(solved, mu, hysteresis=given["hysteresis"])
    assert motion is not None  # every ball is loaded under thrust
    inner, outer = (
        np.abs(motion.relative_motion(patch).spin_to_roll) for patch in loaded_contacts(solved)[:2]
    )
    torques = {
        "jones_full": full,
        "jones_control": jones_control(solved, mu),
        "jones_simplified": jones_simplified(solved, mu),
        "harris": harris_1971(solved, mu),
        "todd": by_todd,
        "todd_bare": todd(solved, mu, hysteresis=0.0),
    }
    totals = {name: torque.total for name, torque in torques.items()}
    return _TorqueSweep(loads, solved, totals, by_todd, (inner, outer))


def torque_section(title: Text) -> Section:
    """Compute figure 8 and its table."""
    found = _solved_over_load()
    return Section(title, (_torque_figure(found), _torque_table(found)))


def _torque_figure(found: _TorqueSweep) -> Figure:
    columns = (
        Series("axial_load", "N", said("Axial load F_a", "Carga axial F_a"), found.loads),
        *(Series(name, "N·mm", title, found.totals[name] / MILLI) for name, title in _MODELS),
        Series(
            "contact_angle",
            "°",
            said("Contact angle α", "Ângulo de contato α"),
            np.degrees(found.solved.inner.contact_angle[:, 0]),
        ),
        status_column(found.solved.status.code),
    )
    lines = tuple(Line(name, look, title) for look, (name, title) in enumerate(_MODELS))
    return Figure(
        number="8",
        caption=_caption(),
        source=GIVEN.source_of("torque"),
        columns=columns,
        picture=Curves(
            (
                Panel(
                    "axial_load",
                    said("Friction torque T", "Torque de atrito T"),
                    "N·mm",
                    lines,
                    tick=20.0,
                ),
            )
        ),
        claims=(*_of_the_text(found), *_of_theory(found)),
        notes=(
            said(
                "The text finds that Jones's simplified model fits Todd's measurements perfectly."
                " Neither the measured points nor the printed curves are in the text, so this is"
                " not checked here. Over the load the contact angle rises from {:.1f}° to {:.1f}°,"
                " the maximum pressure from {:.2f} to {:.2f} GPa.",
                "O texto conclui que o modelo simplificado de Jones se ajusta perfeitamente às"
                " medições de Todd. Nem os pontos medidos nem as curvas impressas estão no texto,"
                " de modo que isso não é verificado aqui. Com a carga o ângulo de contato sobe de"
                " {:.1f}° a {:.1f}°, e a maior pressão, de {:.2f} a {:.2f} GPa.",
                *np.degrees(found.solved.inner.contact_angle[[0, -1], 0]),
                *(found.solved.inner.max_pressure[[0, -1], 0] / 1e9),
            ),
            _beyond(),
        ),
    )


def _caption() -> Text:
    given = GIVEN.inputs_of("torque")
    return said(
        "Friction torque over axial load by the rival models: three balls without a cage,"
        " {:.1f} rpm, μ = {:.2f}.",
        "Torque de atrito em função da carga axial pelos modelos rivais: três esferas sem gaiola,"
        " {:.1f} rpm, μ = {:.2f}.",
        given["speed_rpm"],
        given["friction_coefficient"],
    )


def _beyond() -> Text:
    """Tell the ratios at loads outside the range drawn, where the expectations end."""
    given = GIVEN.inputs_of("torque")
    loads, mu = [float(load) for load in given["beyond_N"]], given["friction_coefficient"]
    solved = solve(case(loads[0], given["speed_rpm"]), fx=np.array(loads))
    simplified = jones_simplified(solved, mu).total
    over_control = 100.0 * (simplified / jones_control(solved, mu).total - 1.0)
    over_full = 100.0 * (simplified / jones_full_motion(solved, mu)[0].total - 1.0)
    pairs = np.column_stack([loads, over_control, over_full]).ravel()
    return said(
        "The range of load was chosen so that these expectations cover it; beyond it they do not:"
        " at {:.0f} N the simplified model lies {:.1f} % above that with control and {:.1f} % above"
        " the full one, at {:.0f} N {:.1f} % and {:.1f} %.",
        "A faixa de carga foi escolhida de modo que essas expectativas a cubram; fora dela não:"
        " com {:.0f} N o modelo simplificado fica {:.1f} % acima do com controle e {:.1f} % acima"
        " do completo, com {:.0f} N {:.1f} % e {:.1f} %.",
        *(float(value) for value in pairs),
    )


# --- statements of the text -------------------------------------------------


def _of_the_text(found: _TorqueSweep) -> tuple[Claim, ...]:
    parts = found.todd.parts
    slip = (parts["spin"] + parts["rolling_slip"]) / found.todd.total
    inner, outer = found.solved.inner, found.solved.outer
    eccentric = [
        float(np.sqrt(1.0 - (patch.semi_minor / patch.semi_major)[0, 0] ** 2))
        for patch in (inner, outer)
    ]
    held = controlling_race(found.solved, "jones")
    return (
        Claim(
            said(
                "Slip in the contacts makes more than 80 % of the friction.",
                "Os microdeslizamentos nos contatos representam mais de 80 % do atrito.",
            ),
            said(
                "{:.1f} to {:.1f} % by Todd's model; the rest is hysteresis. Without a cage.",
                "{:.1f} a {:.1f} % pelo modelo de Todd; o resto é histerese. Sem gaiola.",
                100.0 * slip.min(),
                100.0 * slip.max(),
            ),
            bool(slip.min() > _MOST_OF_FRICTION),
        ),
        Claim(
            said(
                "At equal conformities and low speed the ball rolls without spin on the inner race,"
                " whose ellipse is the more eccentric.",
                "Com conformidades iguais e baixa velocidade a esfera rola sem pivotar na pista"
                " interna, cuja elipse é mais excêntrica.",
            ),
            said(
                "Eccentricity {:.4f} inside, {:.4f} outside; Jones's criterion names the inner race"
                " for every load. (In his full model both contacts spin, see below.)",
                "Excentricidade {:.4f} na interna, {:.4f} na externa; o critério de Jones aponta a"
                " pista interna em todas as cargas. (No modelo completo os dois contatos pivotam,"
                " ver abaixo.)",
                *eccentric,
            ),
            eccentric[0] > eccentric[1] and bool(np.all(held < 0)),
        ),
    )


# --- what theory lets expect ------------------------------------------------


def _expected(statement: Text, finding: Text, holds: object) -> Claim:
    return Claim(statement, finding, bool(holds), of_theory=True)


def _extremes(values: Floats) -> tuple[float, float]:
    return float(values.min()), float(values.max())


def _of_theory(found: _TorqueSweep) -> tuple[Claim, ...]:
    t = found.totals
    return (
        _harris(found),
        _bare_todd(t),
        _simplified_over_control(t),
        _simplified_over_full(t),
        _both_spin(found),
        _order(t),
    )


def _harris(found: _TorqueSweep) -> Claim:
    ratio = found.totals["jones_full"] / found.totals["harris"]
    patches = (found.solved.inner, found.solved.outer)
    second = np.mean(
        [complete((patch.semi_minor / patch.semi_major)[:, 0] ** 2)[1] for patch in patches], axis=0
    )
    return _expected(
        said(
            "Harris, without slip across rolling, lies below Jones's full model by about the"
            " integral E of the ellipse, 1.02 to 1.03.",
            "Harris, sem deslizamento transversal, fica abaixo do modelo completo de Jones por"
            " cerca da integral E da elipse, 1,02 a 1,03.",
        ),
        said(
            "Jones full over Harris: {:.3f} to {:.3f}; E = {:.3f}.",
            "Jones completo sobre Harris: {:.3f} a {:.3f}; E = {:.3f}.",
            *_extremes(ratio),
            float(second.mean()),
        ),
        np.all(np.abs(ratio - second) < _BY_E) and ratio.min() > 1.015 and ratio.max() < 1.035,
    )


def _bare_todd(t: dict[str, Floats]) -> Claim:
    ratio = t["jones_control"] / t["todd_bare"]
    return _expected(
        said(
            "Jones with control is Todd without hysteresis, within 0.3 %.",
            "Jones com controle é Todd sem histerese, com diferença de até 0,3 %.",
        ),
        said(
            "They differ by at most {:.2f} %.",
            "Diferem em no máximo {:.2f} %.",
            100.0 * float(np.abs(ratio - 1.0).max()),
        ),
        np.all(np.abs(ratio - 1.0) < _NEAR_TODD),
    )


def _above(values: Floats) -> Text:
    return said(
        "{:.0f} to {:.0f} % above, more with more load.",
        "{:.0f} a {:.0f} % acima, mais com mais carga.",
        *(100.0 * (value - 1.0) for value in _extremes(values)),
    )


def _simplified_over_control(t: dict[str, Floats]) -> Claim:
    ratio = t["jones_simplified"] / t["jones_control"]
    return _expected(
        said(
            "The simplified model, which adds spin and rolling slip, overrates the model with"
            " control by 10 to 17 %.",
            "O modelo simplificado, que soma pivotamento e rolamento, supera o modelo com controle"
            " em 10 a 17 %.",
        ),
        _above(ratio),
        ratio.min() > 1.10 and ratio.max() < 1.18,
    )


def _simplified_over_full(t: dict[str, Floats]) -> Claim:
    ratio = t["jones_simplified"] / t["jones_full"]
    return _expected(
        said(
            "It overrates Jones's full model by 27 to 53 %.",
            "Ele supera o modelo completo de Jones em 27 a 53 %.",
        ),
        _above(ratio),
        ratio.min() > 1.27 and ratio.max() < 1.54,
    )


def _both_spin(found: _TorqueSweep) -> Claim:
    inner, outer = found.spins
    return _expected(
        said(
            "In the full model both contacts spin: no race controls the ball.",
            "No modelo completo os dois contatos pivotam: nenhuma pista controla a esfera.",
        ),
        said(
            "Spin over roll {:.3f} to {:.3f} at the inner contact, {:.3f} to {:.3f} at the outer.",
            "Pivotamento sobre rolamento {:.3f} a {:.3f} no contato interno, {:.3f} a {:.3f} no"
            " externo.",
            *_extremes(inner),
            *_extremes(outer),
        ),
        min(inner.min(), outer.min()) > 0.01,
    )


def _order(t: dict[str, Floats]) -> Claim:
    names = ("harris", "jones_full", "todd_bare", "todd", "jones_simplified")
    rising = all(np.all(t[a] < t[b]) for a, b in pairwise(names))
    smaller = np.all(t["jones_full"] <= t["jones_control"])
    return _expected(
        said(
            "From below: Harris, Jones full, Todd without hysteresis (Jones with control), Todd"
            " with it, Jones simplified. What friction decides costs no more than what control"
            " prescribes.",
            "De baixo para cima: Harris, Jones completo, Todd sem histerese (Jones com controle),"
            " Todd com histerese, Jones simplificado. O que o atrito decide não custa mais do que o"
            " controle prescreve.",
        ),
        said(
            "So at all {} loads." if rising and smaller else "Not at all {} loads.",
            "Assim em todas as {} cargas." if rising and smaller else "Não em todas as {} cargas.",
            t["jones_full"].size,
        ),
        rising and smaller,
    )


# --- table ------------------------------------------------------------------


def _torque_table(found: _TorqueSweep) -> Table:
    loads = GIVEN.inputs_of("table")["loads_N"]
    rows = [int(np.argmin(np.abs(found.loads - load))) for load in loads]
    full = found.totals["jones_full"]
    return Table(
        number="8",
        caption=said(
            "Torques of figure 8 in N·mm, and in brackets over that of Jones's full model.",
            "Torques da figura 8 em N·mm e, entre parênteses, em relação ao modelo completo de"
            " Jones.",
        ),
        source=GIVEN.source_of("table"),
        columns=(
            TableColumn("axial_load_N", same("F_a (N)"), tuple(f"{load:.0f}" for load in loads)),
            *(
                TableColumn(
                    f"{name}_Nmm",
                    title,
                    tuple(
                        same(
                            "{:.3f} ({:.3f})",
                            float(found.totals[name][row] / MILLI),
                            float(found.totals[name][row] / full[row]),
                        )
                        for row in rows
                    ),
                )
                for name, title in _MODELS
            ),
        ),
    )
