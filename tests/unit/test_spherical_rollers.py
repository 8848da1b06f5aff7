"""Spherical roller bearings from designation to report: what a user gets of one."""

from __future__ import annotations

from math import atan, degrees

import numpy as np
import pytest

import rolamento as ro
from rolamento.catalogue import catalogue
from rolamento.errors import InputError
from rolamento.friction.line_losses import curved_slip_moment
from rolamento.friction.skf import series_constants, skf_moment
from rolamento.pages.given import head, model_text
from rolamento.ratings import roller_dynamic_rating
from rolamento.ratings.rollers import roller_static_rating

FAN = {
    "bearing": {"designation": "22220 EAK/C3"},
    "duty": {"inner_speed": "1500 rpm", "load": {"fz": "30 kN", "fx": "5 kN"}},
    "lubricant": "ISO VG 150",
    "temperature": {"lubricant": "70 degC"},
    "surface": {
        "inner_roughness": "0.2 um", "outer_roughness": "0.2 um", "ball_roughness": "0.1 um",
    },
}  # fmt: skip


@pytest.fixture(scope="module")
def fan() -> ro.Analysis:
    return ro.analyse(ro.Case.from_mapping(FAN))


@pytest.mark.parametrize(
    ("text", "listed", "clearance"),
    [
        ("22211 E", "22211 E", 52.5e-6),  # 40 to 65 µm over 50 mm to 65 mm
        ("22211 EA", "22211EA", 52.5e-6),
        ("22220 EK/C3", "22220 E", 125e-6),  # tapered bore: 110 to 140
        ("22220", "22220EA", 80e-6),
        ("NSK 22320 E", "22320EA", 80e-6),
        ("SKF 22320 CC/W33", "22320 E", 80e-6),
        ("24122 CE4", "24122C", 97.5e-6),
        ("23952", "23952CA", 215e-6),
    ],
)
def test_designations_of_any_maker_are_read(text: str, listed: str, clearance: float) -> None:
    bearing = ro.RollerBearing.named(text)
    assert bearing.published is not None
    assert (bearing.published.designation, bearing.kind) == (listed, "spherical")
    assert bearing.diametral_clearance == pytest.approx(clearance)
    assert bearing.origins["contact_angle"] == "inferred"
    assert len(bearing.places) == 2


def test_the_inside_reproduces_the_ratings() -> None:
    for one in catalogue().bearings:
        if one.kind != "spherical":
            continue
        bearing = ro.RollerBearing.named(f"{one.maker} {one.designation}")
        assert bearing.published == one
        shape = (
            bearing.roller_count, bearing.roller_diameter, bearing.effective_length,
            bearing.pitch_diameter, bearing.row_angle,
        )  # fmt: skip
        dynamic = float(roller_dynamic_rating(*shape, kind="spherical", rows=2))
        ratings = [dynamic, 1.146 * dynamic] if one.maker == "SKF" else [dynamic]  # Explorer
        assert min(abs(rating / one.dynamic_rating - 1.0) for rating in ratings) < 0.012
        assert float(roller_static_rating(*shape, rows=2)) == pytest.approx(
            one.static_rating, rel=0.01
        )
        height = 0.5 * (one.outside_diameter - one.bore)
        assert 0.38 < bearing.roller_diameter / height < 0.6
        assert one.width is not None
        assert 2.0 * bearing.effective_length < one.width


@pytest.mark.parametrize(("maker", "count"), [("NSK", 230), ("SKF", 264)])
def test_the_lists_agree_with_the_formulas_of_the_standard(maker: str, count: int) -> None:
    """e = 1.5 tan α, Y = 0.45 cot α and Y_0 = 0.44 cot α, as far as they are printed."""
    own = [one for one in catalogue().bearings if (one.maker, one.kind) == (maker, "spherical")]
    assert len(own) == count
    for row in own:
        limit, factor, static = row.axial_limit, row.axial_factor, row.static_axial_factor
        assert limit is not None
        assert factor is not None
        assert static is not None
        assert abs(limit - 0.675 / factor) < 0.0055 + 0.675 / factor**2 * 0.055, row
        # SKF rounds Y_0 to preferred numbers (R 20), steps of 12 %
        room = 0.11 if maker == "NSK" else 0.065 * factor + 0.05
        assert abs(static - 0.44 / 0.45 * factor) < room, row


def test_a_bore_without_a_class_asks_for_its_clearance() -> None:
    with pytest.raises(InputError, match="ISO 5753-1 has no range at a bore of 20 mm"):
        ro.RollerBearing.named("21304 K")  # tapered bores begin over 24 mm


def test_its_life_is_rated_as_two_rows(fan: ro.Analysis) -> None:
    """P = F_r + Y F_a up to e; C of the list."""
    assert fan.life is not None
    cotangent = 1.0 / np.tan(fan.solved.rows.free_contact_angle[0, 0])
    assert cotangent == pytest.approx(2.9 / 0.45)
    load = 30e3 + 2.9 * 5e3
    hours = float(fan.life.theories["iso281"].hours[0])
    assert hours * 60.0 * 1500.0 == pytest.approx(1e6 * (365e3 / load) ** (10.0 / 3.0), rel=1e-6)


def test_contacts_and_skf_agree_on_the_torque(fan: ro.Analysis) -> None:
    """Two models that share nothing: within 15 % running and starting."""
    assert fan.friction is not None
    skf = fan.friction.models["skf"]
    assert fan.friction.torque[0] == pytest.approx(skf.total[0], rel=0.15)
    assert skf.starting is not None
    assert fan.friction.starting_torque[0] == pytest.approx(skf.starting[0], rel=0.15)


def test_formula_of_skf_by_hand() -> None:
    """222 E, d = 100 mm, D = 180 mm, 30 kN and 5 kN, 1500 r/min, 37 mm²/s."""
    made = skf_moment(
        series_constants("spherical", "222E"), speed=1500 * np.pi / 30, bore_diameter=0.1,
        outside_diameter=0.18, kinematic_viscosity=37e-6, radial_load=30e3, axial_load=5e3,
        supply="bath",
    )  # fmt: skip
    mean, fr, fa = 140.0, 30e3, 5e3
    point = 1.6e-6 * mean**1.85 * (fr + 5.84 * fa) ** 0.54
    line = 2.81e-6 * mean**2.3 * (fr + 5.8 * fa) ** 0.31
    rolling = min(point, line) * (37.0 * 1500.0) ** 0.6
    factors = made.inlet_heating * made.replenishment
    assert made.rolling == pytest.approx(1e-3 * factors * rolling)
    sliding = min(
        3.62e-3 * mean**0.25 * (fr**4 + 508.0 * fa**4) ** (1 / 3),
        8.8e-3 * mean**0.94 * (fr**3 + 117.0 * fa**3) ** (1 / 3),
    )
    assert made.sliding == pytest.approx(1e-3 * sliding * made.sliding_coefficient)


def test_slip_along_a_curved_contact_balances() -> None:
    """A uniform load: ∫|x² - x_0²| q dx/2R = q l³/32R with x_0 = l/4 on either side."""
    n, length, radius = 4001, 0.01, 0.08
    place = (np.arange(n) - (n - 1) / 2) * length / n
    found = curved_slip_moment(np.full(n, 2e5), place, np.asarray(1.0 / radius))
    assert float(found) == pytest.approx(2e5 * length**3 / 32.0 / radius, rel=1e-3)


def test_frequencies_have_no_cones() -> None:
    found = ro.fault_frequencies("22220 EA", speed="1500 rpm")
    assert "no_common_apex" not in [note.key for note in found.notes]
    nominal = found.nominal
    ratio = 20.88 / 140.0 * np.cos(atan(0.45 / 2.9))
    assert nominal.ball_pass_outer.order == pytest.approx(0.5 * 19 * (1.0 - ratio), rel=1e-3)
    assert nominal.ball_pass_inner.order == pytest.approx(0.5 * 19 * (1.0 + ratio), rel=1e-3)


def test_its_page_names_the_arcs(fan: ro.Analysis) -> None:
    assert "elliptical contacts" in model_text(fan.solved.case)
    bearing = " ".join(str(entry.content) for entry in head(fan.solved).blocks[1].entries)
    assert "two rows of 19 barrel-shaped rollers" in bearing
    assert "outer raceway a sphere of radius" in bearing
    assert "ribs" not in bearing


def test_misalignment_has_the_makers_limit() -> None:
    case = ro.Case.from_mapping({**FAN, "lubricant": None, "surface": None, "temperature": None})
    keys = [n.key for n in ro.solve(case, ry="30 mrad").notes[0]]
    assert "rollers_misaligned" in keys or "tilt_beyond_self_aligning" in keys
    fine = [n.key for n in ro.solve(case, ry="10 mrad").notes[0]]
    assert "rollers_misaligned" not in fine
    assert degrees(atan(0.018)) == pytest.approx(1.03, abs=0.01)  # where makers begin: 1°


def test_a_torus_has_its_own_limits() -> None:
    """0.5° of tilt, not the 1.5° of a sphere, and no axial load (SKF, CARB)."""
    case = ro.Case(
        bearing={"designation": "C 2210"}, duty={"inner_speed": "500 rpm", "load": {"fz": "5 kN"}}
    )
    assert [one.key for one in case.bearing.row_types] == ["toroidal"]
    tilted = ro.solve(case, {"duty.displacement.ry": [0.01]})
    (note,) = [note for note in tilted.notes[0] if note.key == "rollers_misaligned"]
    assert note.values["limit"] == pytest.approx(np.radians(0.5))
    pushed, free = (ro.solve(case.with_(fx=fx)) for fx in (2e3, 0.0))
    keys = {note.key for note in pushed.notes[0]}
    assert "toroidal_under_axial_load" in keys
    assert "direction_unsupported" not in keys
    assert "toroidal_under_axial_load" not in {note.key for note in free.notes[0]}
    spherical = ro.RollerBearing.named("22211 E")
    assert [one.key for one in spherical.row_types] == ["spherical", "spherical"]


# --- mounted ----------------------------------------------------------------------------------


def mounted(designation: str, **tables: object) -> ro.Case:
    seats = {"bore": "50 mm", "outside_diameter": "90 mm", **tables.pop("mounting", {})}  # type: ignore[dict-item]
    return ro.Case.from_mapping({
        "bearing": {"designation": designation}, "mounting": seats,
        "duty": {"load": {"fz": "5 kN", "fx": "0 N"}}, **tables,
    })  # fmt: skip


@pytest.mark.parametrize("designation", ["22210", "C 2210"])
def test_a_press_fit_takes_its_share_of_the_clearance(designation: str) -> None:
    """A ring on a solid shaft of its own steel: δ d/D_raceway, whatever its wall (Lamé)."""
    case = mounted(designation, mounting={"shaft_interference": "20 um", "shaft_roughness": "0 um"})
    solved, bearing = ro.solve(case), case.bearing
    across = bearing.element_diameter * np.cos(bearing.contact_angle or 0.0)
    play = bearing.diametral_clearance - 20e-6 * 0.05 / (bearing.pitch_diameter - across)
    free = ro.solve(case.replace(mounting=None).with_({"bearing.diametral_clearance": play}))
    assert solved.displacement.z[0] == pytest.approx(free.displacement.z[0], rel=1e-9)
    batch = ro.solve(case, {"duty.load.fz": np.array([5e3, 8e3])})
    assert batch.displacement.z[0] == pytest.approx(solved.displacement.z[0], rel=1e-12)


@pytest.mark.parametrize("designation", ["22210", "C 2210"])
def test_even_warming_is_a_similarity(designation: str) -> None:
    """One expansion everywhere: under loads that grow by (1 + ε)² pressures stay as they were."""
    growth = 1.0 + 12.5e-6 * 100.0
    cold = mounted(designation).with_({"bearing.diametral_clearance": 0.0})
    warm = {f"temperature.{ring}_ring": 393.15 for ring in ("inner", "outer")}
    expansions = {f"mounting.{part}_expansion": 12.5e-6 for part in ("ring", "ball")}
    hot = cold.with_({"duty.load.fz": 5e3 * growth**2, **warm, **expansions})
    before, after = ro.solve(cold), ro.solve(hot)
    assert after.displacement.z[0] == pytest.approx(growth * before.displacement.z[0], rel=1e-9)
    assert after.inner.max_pressure.max() == pytest.approx(before.inner.max_pressure.max())


def test_a_tapered_bore_is_driven_up_and_not_fitted() -> None:
    with pytest.raises(InputError, match="how far the ring is driven"):
        mounted("22210 K")
