"""Advice begins where its source says: just inside a limit no note, just outside the note.

Each limit is found by halving an interval of duties until its two ends are alike, one with the
note and one without; what they are measured by then has to be the number that is printed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import degrees, isclose, pi, radians
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from tests.one_case import keys

from rolamento import Case, Solved, analyse, solve
from rolamento.analysis.speed_limits import speed_limits
from rolamento.clearance import sets
from rolamento.clearance.chain import Strains
from rolamento.friction import Friction, friction
from rolamento.friction.bounds import upper_bounds
from rolamento.friction.model import Setting, inertia_counts
from rolamento.life import LifeSummary, life
from rolamento.lubrication.film_thickness import aihara, thermal_loading
from rolamento.solved.notes import notes_on
from rolamento.weibull import LifeTest, maximum_likelihood
from rolamento.weibull.drawing import Drawing
from rolamento.weibull.goodness import DogLeg, GoodnessOfFit

RPM = pi / 30.0
MINUTE = radians(1.0 / 60.0)

BALL = {
    "ball_count": 8, "ball_diameter": "19.05 mm", "pitch_diameter": "80 mm",
    "diametral_clearance": "0.014 mm", "inner_conformity": 0.52, "outer_conformity": 0.52,
}  # fmt: skip
ANGULAR = {
    "ball_count": 16, "ball_diameter": "22.23 mm", "pitch_diameter": "125.26 mm",
    "contact_angle": "40 deg", "inner_conformity": 0.5232, "outer_conformity": 0.5232,
}  # fmt: skip
ROLLER = {
    "element": "cylindrical", "roller_count": 13, "roller_diameter": "7.5 mm",
    "effective_length": "8.4 mm", "pitch_diameter": "38.5 mm", "diametral_clearance": "0.02 mm",
}  # fmt: skip


def case(bearing: Any, **tables: Any) -> Case:
    """A case of a bearing, or of a designation, with its duty's loads and so on."""
    named = {"designation": bearing} if isinstance(bearing, str) else bearing
    names = ("life", "model", "temperature", "lubricant", "surface", "mounting", "film")
    others = {name: tables.pop(name) for name in names if name in tables}
    return Case(bearing=named, duty=tables, **others)


def ends(
    make: Callable[[float], Any], told: Callable[[Any], bool], low: float, high: float
) -> tuple[Any, Any]:
    """Halve from where nothing is told to where it is; return what is made on either side."""
    assert not told(make(low)), "told already"
    assert told(make(high)), "never told"
    for _ in range(60):
        middle = 0.5 * (low + high)
        if isclose(low, high, rel_tol=3e-8):
            break
        low, high = (low, middle) if told(make(middle)) else (middle, high)
    return make(low), make(high)


# --- the state ------------------------------------------------------------------------------------


def pressure(solved: Solved) -> float:
    """Of the most pressed contact, MPa."""
    return 1e-6 * max(float(race.max_pressure[0].max()) for race in (solved.inner, solved.outer))


def tilt(solved: Solved) -> float:
    """Between the rings, rad."""
    return float(np.hypot(solved.displacement.ry[0], solved.displacement.rz[0]))


def speed_factor(solved: Solved) -> float:
    """n d_m, million mm·r/min."""
    speed = float(solved.field("duty.inner_speed")[0]) / RPM
    return 1e-3 * speed * float(solved.rows.pitch_diameter[0, 0])


def value_of(key: str, name: str) -> Callable[[Solved], float]:
    """What a note says; of the state without it the limit cannot be read, and NaN is returned."""

    def read(solved: Solved) -> float:
        found = [note for note in notes_on(solved) if note.key == key]
        return float(found[0].values[name]) if found else float("nan")

    return read


def loose(ry: float, **bearing: Any) -> Case:
    """A bearing so loose that its tilt presses nothing."""
    open_grooves = {"inner_conformity": 0.6, "outer_conformity": 0.6}
    given = BALL | open_grooves | {"diametral_clearance": "5 mm", **bearing}
    return case(given, displacement={"x": 0.0, "y": 0.0, "z": 0.0, "ry": ry})


@dataclass(frozen=True)
class Limit:
    """A limit of a note on the state: from the source, measured on states on either side of it."""

    key: str
    make: Callable[[float], Case]
    low: float
    high: float
    measured: Callable[[Solved], float]
    printed: float
    accuracy: float = 1e-6


STATE = (
    # ISO 76:2006, introduction: 4200 MPa of ball bearings, 4000 MPa of roller bearings
    Limit("contact_pressure_high", lambda fz: case(BALL, load={"fz": fz}), 1e4, 1e5, pressure,
          4200.0),
    Limit("line_pressure_high", lambda fz: case(ROLLER, load={"fz": fz}), 1e4, 4e4, pressure,
          4000.0),
    # and 4600 MPa of self-aligning ball bearings
    Limit("contact_pressure_high", lambda fz: case("1210", load={"fz": fz}), 2e3, 6e4, pressure,
          4600.0),
    # Bamberger, Zaretsky and Signer (1976): main-shaft bearings ran at 3 million mm·r/min
    Limit("speed_factor_high",
          lambda n: case(BALL, inner_speed=n * RPM, load={"fz": 5e3},
                         model={"centrifugal_force": False, "gyroscopic_moment": False}),
          3e4, 5e4, speed_factor, 3.0),
    # docs/theory/equilibrium.md: first order in the tilt, 2 % of BD at 1 degree
    Limit("tilt_large", loose, radians(0.5), radians(2.0), lambda s: degrees(tilt(s)), 1.0),
    # makers permit 1.5° to 3° of self-aligning ball bearings; SKF's 1.5° (12, 22), 2.5° (most), 3°
    Limit("tilt_beyond_self_aligning",
          lambda ry: case("1210", displacement={"ry": ry}, load={"fz": 1e3}),
          radians(1.0), radians(4.0), lambda s: degrees(tilt(s)), 2.5),
    # NSK E1102: 0.0012 rad (4′) of cylindrical rollers, 0.0009 rad (3′) of tapered ones; SKF: 1′
    # of needle rollers
    Limit("rollers_misaligned",
          lambda ry: case(ROLLER, displacement={"ry": ry}, load={"fz": 2e3}),
          1e-4, 5e-3, lambda s: tilt(s) / MINUTE, 4.0),
    Limit("rollers_misaligned",
          lambda ry: case("30206", displacement={"ry": ry}, load={"fz": 2e3, "fx": 1e3}),
          1e-4, 5e-3, lambda s: tilt(s) / MINUTE, 3.0),
    Limit("rollers_misaligned",
          lambda ry: case("NA 4905", displacement={"ry": ry}, load={"fz": 2e3}),
          1e-4, 5e-3, lambda s: tilt(s) / MINUTE, 1.0),
    # SKF, Rolling bearings, four-point contact ball bearings: F_a/F_r of 1.27 and more
    Limit("four_point_under_radial_load",
          lambda fz: case("QJ 210", load={"fx": 5e3, "fz": fz}), 1e3, 8e3,
          lambda s: float(s.load.fx[0] / s.load.fz[0]), 1.27),
    # a hundredth: what an alignment leaves
    Limit("thrust_under_radial_load",
          lambda fz: case("51210", load={"fx": 5e3, "fz": fz}), 1.0, 200.0,
          lambda s: float(s.load.fz[0] / s.load.fx[0]), 0.01),
    # Harris 1991: lubricated contacts hold with coefficients up to about 0.1
    Limit("gyroscopic_slip",
          lambda n: case(ANGULAR, inner_speed=n * RPM, load={"fx": 2e3},
                         model={"raceway_control": "none"}), 1e3, 2e4,
          value_of("gyroscopic_slip", "friction_coefficient"), 0.1, 1e-5),
    Limit("gyroscopic_moment_not_held",
          lambda n: case("51210", inner_speed=n * RPM, load={"fx": 500.0}), 100.0, 8e3,
          value_of("gyroscopic_moment_not_held", "friction_coefficient"), 0.1, 1e-5),
)  # fmt: skip


@pytest.mark.parametrize("limit", STATE, ids=lambda one: f"{one.key} {one.printed:g}")
def test_a_note_on_the_state_begins_at_its_limit(limit: Limit) -> None:
    inside, outside = ends(
        lambda value: solve(limit.make(value)),
        lambda solved: limit.key in keys(notes_on(solved)),
        limit.low,
        limit.high,
    )
    found = [limit.measured(solved) for solved in (inside, outside)]
    found = [value for value in found if not np.isnan(value)]
    assert found == pytest.approx([limit.printed] * len(found), rel=limit.accuracy)


@pytest.fixture(scope="module")
def rolling() -> Solved:
    """A bearing whose balls friction alone moves."""
    given = case(
        ANGULAR, inner_speed=3e3 * RPM, load={"fx": 2e4},
        model={"raceway_control": "friction"},
        lubricant={"base_oil": "ISO VG 68", "friction_coefficient": 0.07},
    )  # fmt: skip
    solved = solve(given)
    assert solved.converged[0]
    assert solved.rolling is not None
    return solved


@pytest.mark.parametrize(("skid", "told"), [(0.0499, False), (0.0501, True), (-0.0501, True)])
def test_a_cage_skids_beyond_a_twentieth(
    rolling: Solved, skid: float, told: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """5 %: docs/theory/friction-control.md."""
    motion = rolling.rolling
    assert motion is not None
    skids = replace(motion, cage_speed=(1.0 - skid) * motion.control_cage_speed)
    monkeypatch.setattr(Solved, "rolling", property(lambda _: skids))
    assert ("cage_skids" in keys(notes_on(rolling))) is told


@pytest.mark.parametrize(("spin", "told"), [(0.0499, False), (0.0501, True)])
def test_a_ball_spins_at_both_races_beyond_a_twentieth(
    rolling: Solved, spin: float, told: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    spins = property(lambda contacts: np.full_like(contacts.load, spin))
    monkeypatch.setattr(type(rolling.inner), "spin_to_roll", spins)
    assert ("spin_at_both_races" in keys(notes_on(rolling))) is told


@pytest.mark.parametrize(("factor", "told"), [(1.0999, True), (1.1001, False), (0.999, False)])
def test_a_preload_is_nearly_lost_within_a_tenth(factor: float, told: bool) -> None:
    pair = ANGULAR | {"arrangement": "DB", "spacing": "40 mm", "preload": {"force": "2 kN"}}
    solved = solve(case(pair, load={"fx": 1e3}))
    assert solved.preload is not None
    near = replace(solved, preloading=replace(solved.preload, lost_row=1, loss_factor=factor))
    assert ("preload_nearly_lost" in keys(notes_on(near))) is told


def test_a_roller_bears_on_part_of_its_length_below_seven_tenths() -> None:
    inside, outside = ends(
        lambda ry: solve(case(ROLLER, displacement={"ry": ry}, load={"fz": 1e3})),
        lambda solved: "roller_on_part_of_its_length" in keys(notes_on(solved)),
        1e-4, 2e-2,
    )  # fmt: skip
    share = value_of("roller_on_part_of_its_length", "share")(outside)
    assert share == pytest.approx(24 / 35)  # of 35 slices 24 are below 0.7, 25 above
    assert inside.rollers is not None
    one = int(np.argmax(inside.inner.load[0]))
    lines = (inside.rollers.inner, inside.rollers.outer)
    assert min(float((line.load_per_length[0, one] > 0.0).mean()) for line in lines) == 25 / 35


@pytest.mark.parametrize(
    ("contact", "key", "printed"),
    [("slices", "edges_bear", 0.7), ("coupled", "edge_pressure_peak", 1.2)],
)
def test_the_ends_of_rollers_are_told(contact: str, key: str, printed: float) -> None:
    straight = ROLLER | ({"roller_profile": "iso"} if contact == "slices" else {})
    _, outside = ends(
        lambda ry: solve(
            case(straight, displacement={"ry": ry}, load={"fz": 4e3},
                 model={"roller_contact": contact})
        ),
        lambda solved: key in keys(notes_on(solved)),
        0.0, 8e-3,
    )  # fmt: skip
    assert value_of(key, "ratio")(outside) == pytest.approx(printed, rel=1e-3)


# --- the life -------------------------------------------------------------------------------------


def lived(given: Case) -> tuple[Solved, LifeSummary]:
    solved = solve(given)
    return solved, life(solved, stress_volume=False)


Lived = tuple[Solved, LifeSummary]


@dataclass(frozen=True)
class LifeLimit:
    """As `Limit`, of the note of a theory."""

    key: str
    theory: str
    make: Callable[[float], Case]
    low: float
    high: float
    measured: Callable[[Lived], float]
    printed: float
    accuracy: float = 1e-6


def over_rating(found: Lived) -> float:
    return float(found[1].loads.dynamic[0] / found[1].ratings.dynamic_of_set[0])


def reference_over_rating(found: Lived) -> float:
    return float(found[1].reference_load[0] / found[1].ratings.dynamic_of_set[0])


def ratio(found: Lived) -> float:
    kappa = found[1].viscosity_ratio
    assert kappa is not None
    return float(kappa[0])


LIFE = (
    # ISO 281:2007, clause 1 and 7.1: P up to C/2, and up to C_0
    LifeLimit("load_above_half_rating", "iso281",
              lambda fz: case("6310", load={"fz": fz}), 1e4, 6e4, over_rating, 0.5),
    LifeLimit("load_above_static_rating", "iso281",
              lambda fz: case("6310", load={"fz": fz}, life={"static_rating": 1e4}), 5e3, 3e4,
              lambda found: float(found[1].loads.dynamic[0]), 1e4),
    # SKF, Rolling bearings (10000 EN), minimum load: 0.01 C of ball bearings, 0.02 C of rollers
    LifeLimit("light_load", "iso281", lambda fz: case("6310", load={"fz": -fz}), -2e3, -1e2,
              over_rating, 0.01),
    LifeLimit("light_load_of_rollers", "iso281",
              lambda fz: case("NU 205", load={"fz": -fz}), -2e3, -1e2, over_rating, 0.02),
    LifeLimit("light_load", "iso16281", lambda fz: case("6310", load={"fz": -fz}), -2e3, -1e2,
              reference_over_rating, 0.01),
    # a twentieth more load outside than inside
    LifeLimit("centrifugal_left_out", "iso281",
              lambda n: case("6310", inner_speed=n * RPM, load={"fz": 5e3, "fx": 2e3}), 1e3, 2e4,
              lambda found: float(found[0].outer.load.sum() / found[0].inner.load.sum()), 1.05),
    # a hundredth of the load on the arm d_m; half of it governs
    LifeLimit("moment_left_out", "iso281",
              lambda my: case("6310", load={"fz": 5e3, "my": my, "mz": 0.0}), 0.1, 40.0,
              lambda found: float(found[0].load.my[0] / 5e3 / found[0].rows.pitch_diameter[0, 0]),
              0.01),
    LifeLimit("moment_governs", "iso281",
              lambda my: case("NU 205", load={"fz": 500.0, "my": my, "mz": 0.0}), 0.1, 40.0,
              lambda found: float(found[0].load.my[0] / 500.0 / found[0].rows.pitch_diameter[0, 0]),
              0.5),
    # ISO 281:2007, 9.3.3: κ from 0.1, and at most 4
    LifeLimit("viscosity_ratio_too_small", "iso16281_modified",
              lambda kappa: case("6310", load={"fz": 5e3},
                                 life={"viscosity_ratio": -kappa, "contamination": 0.5}),
              -0.5, -0.01, ratio, 0.1),
    LifeLimit("viscosity_ratio_capped", "iso16281_modified",
              lambda kappa: case("6310", load={"fz": 5e3},
                                 life={"viscosity_ratio": kappa, "contamination": 0.5}),
              1.0, 9.0, ratio, 4.0),
)  # fmt: skip


@pytest.mark.parametrize("limit", LIFE, ids=lambda one: f"{one.theory} {one.key} {one.printed:g}")
def test_a_note_on_the_life_begins_at_its_limit(limit: LifeLimit) -> None:
    both = ends(
        lambda value: lived(limit.make(value)),
        lambda found: limit.key in keys(found[1][limit.theory].notes_of()),
        limit.low,
        limit.high,
    )
    found = [limit.measured(one) for one in both]
    assert found == pytest.approx([limit.printed] * 2, rel=limit.accuracy)


@pytest.mark.parametrize(
    ("celsius", "told"), [(119.9, False), (120.0, False), (120.1, True)]
)  # Saurer and SMB Bearings: 120 °C for standard bearing steel
def test_steel_that_is_not_stabilised_is_told_above_120_degrees(celsius: float, told: bool) -> None:
    given = case("6310", load={"fz": 5e3}, temperature={"inner_ring": celsius + 273.15})
    assert ("too_hot_for_steel" in keys(lived(given)[1]["iso16281"].notes_of())) is told


@pytest.mark.parametrize(
    ("rpm", "celsius", "told"),
    [(20.1, 129.9, set()), (19.9, 129.9, {"too_slow"}), (20.1, 130.1, {"too_hot"})],
)  # NSK: no life below 20 r/min, nor above 130 °C
def test_the_limits_of_l_able(rpm: float, celsius: float, told: set[str]) -> None:
    given = case(
        "6310", inner_speed=rpm * RPM, load={"fz": 5e3},
        temperature={"outer_ring": celsius + 273.15},
        life={"viscosity_ratio": 1.0, "nsk_cleanliness": 0.8},
    )  # fmt: skip
    found = keys(lived(given)[1]["l_able"].notes_of())
    assert found & {"too_slow", "too_hot"} == told


# --- film, friction, clearance --------------------------------------------------------------------


OIL = {"base_oil": "ISO VG 68"}


def lubricated(celsius: float, speed: float = 1500.0) -> Any:
    given = case(
        "6310", inner_speed=speed * RPM, load={"fz": 5e3}, lubricant=OIL,
        temperature={"lubricant": celsius + 273.15},
        surface={
            "inner_roughness": 0.3e-6, "outer_roughness": 0.3e-6, "ball_roughness": 0.05e-6,
        },
    )  # fmt: skip
    return analyse(given, quick=True)


@pytest.mark.parametrize(
    ("key", "low", "high", "measured", "printed"),
    [
        # κ = 1: the oil just separates the surfaces (ISO 281:2007, 9.3.2)
        ("viscosity_ratio_low", 40.0, 110.0, lambda f: float(f.viscosity_ratio[0]), 1.0),
        # Campanha 2008, 2.4.7: boundary below λ = 1, adhesion below 0.3
        ("film_boundary", 30.0, 100.0, lambda f: float(f.minimum_film_parameter[0]), 1.0),
    ],
)
def test_a_note_on_the_film_begins_at_its_limit(
    key: str, low: float, high: float, measured: Callable[[Any], float], printed: float
) -> None:
    both = ends(
        lambda celsius: lubricated(celsius).film,
        lambda film: key in keys(film.notes_of()), low, high,
    )  # fmt: skip
    assert [measured(film) for film in both] == pytest.approx([printed] * 2, rel=1e-6)


def test_adhesive_wear_is_told_below_three_tenths() -> None:
    both = ends(
        lambda slow: lubricated(70.0, 1.0 / slow).film,
        lambda film: "film_adhesive" in keys(film.notes_of()), 1.0 / 400.0, 1.0,
    )  # fmt: skip
    found = [float(film.minimum_film_parameter[0]) for film in both]
    assert found == pytest.approx([0.3] * 2, rel=1e-6)


# --- friction -------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def turning() -> tuple[Solved, Friction]:
    """A 6310 in oil, and its friction."""
    given = case(
        "6310", inner_speed=1500.0 * RPM, load={"fz": 5e3},
        lubricant={"base_oil": "ISO VG 68", "friction_coefficient": 0.05},
        temperature={"lubricant": 343.15}, film={"thermal": "none"},
    )  # fmt: skip
    found = analyse(given)
    assert found.friction is not None
    return found.solved, found.friction


@pytest.mark.parametrize(
    ("ratio", "side", "key"),
    [(1.5001, 1, "torque_above_models"), (1.4999, 1, None),
     (1.0 / 1.5001, 0, "torque_below_models"), (1.0 / 1.4999, 0, None)],
)  # fmt: skip
def test_a_torque_is_apart_from_other_models_beyond_half_as_much(
    turning: tuple[Solved, Friction], ratio: float, side: int, key: str | None
) -> None:
    """docs/torque-models.md: one and a half times what the models of whole bearings give."""
    solved, found = turning
    apart = replace(found, torque=ratio * found.of_whole_bearings[:, side])
    told = {"torque_above_models", "torque_below_models"} & keys(apart.qualifications(solved))
    assert told == ({key} if key else set())


@pytest.mark.parametrize(("part", "told"), [(1.0 - 1e-6, True), (1.0 + 1e-6, False)])
def test_a_bound_is_told_where_it_may_take_a_twentieth(
    turning: tuple[Solved, Friction], part: float, told: bool
) -> None:
    """Of heat in the inlets, which leaves φ of Aihara: 0.05 of the torque is (1 - φ) of theirs."""
    solved, _ = turning
    oil = solved.oil
    fastest = max(np.abs(race.entrainment).max() for race in (solved.inner, solved.outer))
    left = aihara(
        thermal_loading(
            oil.dynamic_viscosity, oil.viscosity_temperature, fastest, oil.thermal_conductivity
        )
    )
    whole = part * (1.0 - np.asarray(left)) / 0.05
    found = upper_bounds(
        Setting(solved, *[np.ones((1, 1))] * 4),
        np.atleast_1d(whole),
        {"rolling_resistance": np.ones(1)},
    )
    assert bool(found["inlets_isothermal"][0]) is told


# --- speeds, life tests, clearance ----------------------------------------------------------------


@pytest.mark.parametrize(("part", "told"), [(1.0 - 1e-6, False), (1.0 + 1e-6, True)])
def test_a_speed_is_above_a_limit_from_the_limit_on(part: float, told: bool) -> None:
    limits = speed_limits("6210").limits
    lowest = min(one.speed for one in limits if one.speed > 0.0)
    found = speed_limits("6210", [f"duty.inner_speed={part * lowest / RPM!r} rpm"])
    assert ("speed_above_limits" in keys(found.notes)) is told


@pytest.mark.parametrize(("part", "told"), [(1.0 - 1e-6, True), (1.0 + 1e-6, False)])
def test_a_load_is_too_small_up_to_the_minimum(part: float, told: bool) -> None:
    settings = ["duty.inner_speed=1500 rpm", "duty.load.fz=1 N"]
    least = max(one.load for one in speed_limits("6210", settings).minimum_loads)
    settings[1] = f"duty.load.fz={part * least!r} N"
    assert ("load_below_minimum" in keys(speed_limits("6210", settings).notes)) is told


def test_an_oil_is_thin_below_a_product_of_two_thousand() -> None:
    """ν n in mm²/s·r/min below which M_0 no longer falls: Palmgren, as Harris (1991), ch. 14."""

    def limits(load: float) -> Any:
        hot = ["lubricant=ISO VG 10", "temperature.lubricant=120 degC"]
        return speed_limits("6210", [*hot, f"duty.load.fz={load!r} N"])

    def product(found: Any) -> float:
        speed = next(one.speed for one in found.limits if one.name == "permissible")
        return float(1e6 * found.viscosity * speed / RPM)

    inside, outside = ends(
        limits, lambda found: "permissible_speed_of_thin_oil" in keys(found.notes), 3e4, 3e5
    )
    assert product(inside) == pytest.approx(2000.0, rel=1e-6)
    assert product(outside) < 2000.0 <= product(inside)


@pytest.mark.parametrize(("load", "counts"), [(4.999, False), (5.001, True)])
def test_balls_under_a_twentieth_of_the_load_are_not_judged(load: float, counts: bool) -> None:
    """A ball that hardly bears has much inertia for its load, and next to no friction."""
    solved: Any = SimpleNamespace(
        balls_bear=np.array([[True, True]]),
        elements=SimpleNamespace(
            gyroscopic_moment=np.zeros((1, 2)), centrifugal_force=np.array([[1.0, 1.0]])
        ),
        inner=SimpleNamespace(load=np.array([[100.0, load]]), ball_diameter=np.full((1, 2), 0.01)),
        outer=SimpleNamespace(load=np.array([[101.0, load + 1.0]])),
    )
    assert inertia_counts(solved, np.full((1, 1), 0.1)).tolist() == [counts]


@pytest.mark.parametrize(("part", "shut"), [(0.2499, False), (0.2501, True)])
def test_a_clearance_is_past_sense_a_quarter_of_the_way_in(part: float, shut: bool) -> None:
    """Of the distance of the groove centres, A = (f_i + f_o - 1) D."""
    bearing = SimpleNamespace(
        ball_diameter=0.01, pitch_diameter=0.05, inner_conformity=0.52, outer_conformity=0.53
    )
    cold = Strains(*np.zeros(7))
    found = sets._balls(bearing, np.array([-part * 0.05 * 0.01]), cold)
    assert found.shut.tolist() == [shut]


@pytest.mark.parametrize(("failures", "told"), [(4, True), (5, False)])
def test_few_failures_are_fewer_than_five(failures: int, told: bool) -> None:
    fit = maximum_likelihood(LifeTest([1.0, 2.0, 2.5, 3.1, 4.4][:failures]))
    assert ("few_failures" in keys(fit.notes)) is told


@pytest.mark.parametrize(("p_value", "told"), [(0.0999, True), (0.1, False)])
def test_data_contradict_a_distribution_below_a_tenth(p_value: float, told: bool) -> None:
    found = GoodnessOfFit("anderson_darling", "converged", p_value=p_value)
    assert found.contradicted is told
    assert ("weibull_contradicted" in keys(found.contradictions("h"))) is told
    bend = DogLeg(100.0, -1.0, 1.0, 3.0, -50.0, 4.0, p_value)
    assert bend.significant is told


@pytest.mark.parametrize(("dropped", "told"), [(100, False), (101, True)])
def test_many_samples_without_a_fit_are_more_than_a_tenth(dropped: int, told: bool) -> None:
    drawn = Drawing.resampled(1000, dropped)
    assert ("many_without_fit" in keys(drawn.notes)) is told
    assert Drawing.resampled(1000, 950).code == "converged"
    assert Drawing.resampled(1000, 951).code == "not_converged"


def spinning(rpm: float) -> tuple[Solved, Friction]:
    """An angular-contact bearing under thrust, all balls alike, and its friction."""
    given = case(
        ANGULAR, inner_speed=rpm * RPM, load={"fx": 2e3},
        lubricant={"base_oil": "ISO VG 68", "friction_coefficient": 0.07},
        temperature={"lubricant": 343.15},
    )  # fmt: skip
    solved = solve(given)
    return solved, friction(solved, model="jones_simplified")


def test_inertia_counts_from_a_tenth_on() -> None:
    """docs/theory/friction.md: 2|M_g|/(D Q_o) of μ, or F_c of Q_i."""

    def told(found: tuple[Solved, Friction]) -> bool:
        return any("inertia" in {n.key for n in own.notes_of()} for own in found[1].judged)

    for solved, _ in ends(spinning, told, 100.0, 6e3):
        moment = np.abs(solved.elements.gyroscopic_moment[0, 0])
        demand = 2.0 * moment / (22.23e-3 * solved.outer.load[0, 0]) / 0.07
        thrown = solved.elements.centrifugal_force[0, 0] / solved.inner.load[0, 0]
        assert max(demand, thrown) == pytest.approx(0.1, rel=1e-6)
