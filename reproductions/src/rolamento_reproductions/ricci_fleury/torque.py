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
from rolamento_reproductions.ricci_fleury.inputs import GIVEN, said
from rolamento_reproductions.ricci_fleury.spin import case
from rolamento_reproductions.text import Text, same

_MODELS = (
    ("jones_simplified", said("models.jones_simplified")),
    ("todd", said("models.todd")),
    ("todd_bare", said("models.todd_bare")),
    ("jones_control", said("models.jones_control")),
    ("jones_full", said("models.jones_full")),
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
        Series("axial_load", "N", said("torque_figure.axial_load"), found.loads),
        *(Series(name, "N·mm", title, found.totals[name] / MILLI) for name, title in _MODELS),
        Series(
            "contact_angle",
            "°",
            said("torque_figure.contact_angle"),
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
        picture=Curves((Panel("axial_load", said("friction_torque_t"), "N·mm", lines, tick=20.0),)),
        claims=(*_of_the_text(found), *_of_theory(found)),
        notes=(
            said(
                "torque_figure.text_finds_that",
                *np.degrees(found.solved.inner.contact_angle[[0, -1], 0]),
                *(found.solved.inner.max_pressure[[0, -1], 0] / 1e9),
            ),
            _beyond(),
        ),
    )


def _caption() -> Text:
    given = GIVEN.inputs_of("torque")
    return said(
        "caption", speed_rpm=given["speed_rpm"], friction_coefficient=given["friction_coefficient"]
    )


def _beyond() -> Text:
    """State the ratios at loads outside the range drawn, where the expectations end."""
    given = GIVEN.inputs_of("torque")
    loads, mu = [float(load) for load in given["beyond_N"]], given["friction_coefficient"]
    solved = solve(case(loads[0], given["speed_rpm"]), fx=np.array(loads))
    simplified = jones_simplified(solved, mu).total
    over_control = 100.0 * (simplified / jones_control(solved, mu).total - 1.0)
    over_full = 100.0 * (simplified / jones_full_motion(solved, mu)[0].total - 1.0)
    pairs = np.column_stack([loads, over_control, over_full]).ravel()
    return said("beyond", *(float(value) for value in pairs))


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
            said("of_the_text.statement"),
            said("of_the_text.finding", slip_min=100.0 * slip.min(), slip_max=100.0 * slip.max()),
            bool(slip.min() > _MOST_OF_FRICTION),
        ),
        Claim(
            said("of_the_text.statement.at_equal_conformities"),
            said("of_the_text.finding.eccentricity_inside_outsid", *eccentric),
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
        said("harris.harris_without_slip"),
        said("harris.jones_full_over", *_extremes(ratio), float(second.mean())),
        np.all(np.abs(ratio - second) < _BY_E) and ratio.min() > 1.015 and ratio.max() < 1.035,
    )


def _bare_todd(t: dict[str, Floats]) -> Claim:
    ratio = t["jones_control"] / t["todd_bare"]
    return _expected(
        said("bare_todd.jones_with_control"),
        said("bare_todd.they_differ_by", ratio_max=100.0 * float(np.abs(ratio - 1.0).max())),
        np.all(np.abs(ratio - 1.0) < _NEAR_TODD),
    )


def _above(values: Floats) -> Text:
    return said("above", *(100.0 * (value - 1.0) for value in _extremes(values)))


def _simplified_over_control(t: dict[str, Floats]) -> Claim:
    ratio = t["jones_simplified"] / t["jones_control"]
    return _expected(
        said("simplified_over_control.simplified_model_which"),
        _above(ratio),
        ratio.min() > 1.10 and ratio.max() < 1.18,
    )


def _simplified_over_full(t: dict[str, Floats]) -> Claim:
    ratio = t["jones_simplified"] / t["jones_full"]
    return _expected(
        said("simplified_over_full.it_overrates_jones"),
        _above(ratio),
        ratio.min() > 1.27 and ratio.max() < 1.54,
    )


def _both_spin(found: _TorqueSweep) -> Claim:
    inner, outer = found.spins
    return _expected(
        said("both_spin.in_full_model"),
        said("both_spin.spin_over_roll", *_extremes(inner), *_extremes(outer)),
        min(inner.min(), outer.min()) > 0.01,
    )


def _order(t: dict[str, Floats]) -> Claim:
    names = ("harris", "jones_full", "todd_bare", "todd", "jones_simplified")
    rising = all(np.all(t[a] < t[b]) for a, b in pairwise(names))
    smaller = np.all(t["jones_full"] <= t["jones_control"])
    return _expected(
        said("order.from_below_harris"),
        said(
            "at_all_loads" if rising and smaller else "not_at_all_loads", loads=t["jones_full"].size
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
        caption=said("torque_table.caption"),
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
