"""Figures of life: what is drawn is what was reckoned, and each can be written."""

from __future__ import annotations

import io
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_hex

from rolamento import (
    Bearing,
    Case,
    Duty,
    InputError,
    Load,
    override,
)
from rolamento.charts.frame import decades, figure_of
from rolamento.charts.style import new_figure, of_look
from rolamento.life import Change, LifeConditions, life, sensitivity
from rolamento.plots.life import (
    BearingTests,
    aiso_chart,
    helps_figure,
    life_figure,
    life_over_zone,
    lives_by_theory,
    load_over_life,
    load_zone_figure,
    sn_figure,
    theory_look,
    what_helps,
)
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.studies.names import setting_name
from rolamento.studies.ranges import read_range
from rolamento.tasks.life_over import (
    LifeCurve,
    LoadLives,
    life_curve,
    lives_over_load,
    lives_over_zone,
)
from rolamento.words import speaking

CONTAMINATION_FIELDS = {"cleanliness": "-/17/14", "oil_supply": "circulating"}
THEORIES = {"iso281", "iso281_modified", "iso16281", "iso16281_modified", "ioannides_harris"}


@pytest.fixture(scope="module")
def case() -> Case:
    return Case(
        title="6305 under 4 kN",
        bearing=Bearing.named("6305/C3"),
        duty=Duty(inner_speed=209.44, load=Load(fz=4000.0)),
        lubricant="ISO VG 68",
        temperature={"lubricant": 343.15},
        life={**CONTAMINATION_FIELDS, "required_life": 2000.0 * 3600.0},
    )


@pytest.fixture(scope="module")
def state(case: Case) -> Solved:
    return solve(case)


@pytest.fixture(scope="module")
def lives(state: Solved) -> LoadLives:
    return lives_over_load(state, points=25)


@pytest.fixture(scope="module")
def curve(case: Case) -> LifeCurve:
    return life_curve(case, read_range("duty.load.fz=1..14kN", 14))


def labels(axes: Axes) -> list[str]:
    legend = axes.get_legend()
    return [] if legend is None else [text.get_text() for text in legend.get_texts()]


def line(axes: Axes, label: str) -> Any:
    return next(one for one in axes.get_lines() if one.get_label() == label)


def slopes(axes: Axes, label: str) -> Any:
    """Of life over load, both in logarithms, where the theory holds."""
    life, load = (np.log(np.asarray(data, np.float64)) for data in line(axes, label).get_data())
    found = np.diff(life) / np.diff(load)
    return found[np.isfinite(found)]


def texts(axes: Axes) -> list[str]:
    return [text.get_text() for text in axes.texts]


def drawn(figure: Any) -> bytes:
    content = io.BytesIO()
    FigureCanvasAgg(figure).print_png(content)
    return content.getvalue()


# --- life over a field -----------------------------------------------------------------------


def test_lives_are_drawn_in_full_where_they_hold_and_faintly_where_not(curve: LifeCurve) -> None:
    axes = lives_by_theory([curve])
    full = line(axes, "ISO 281, basic")
    faint = next(
        one for one in axes.get_lines()
        if one.get_alpha() is not None and one.get_color() == full.get_color()
    )  # fmt: skip
    y, z = np.asarray(full.get_ydata()), np.asarray(faint.get_ydata())
    np.testing.assert_allclose(np.asarray(full.get_xdata()), curve.values / 1e3)
    holds = curve["iso281"].valid
    assert 0 < holds.sum() < len(holds)
    np.testing.assert_array_equal(y[holds], curve["iso281"].hours[holds])
    np.testing.assert_array_equal(z[~holds], curve["iso281"].hours[~holds])
    assert np.isnan(y[~holds][1:]).all()
    assert np.isnan(z[holds][:-1]).all()
    legend = axes.get_legend()
    assert legend is not None
    assert legend.get_title().get_text() == "faint: the theory is not valid there"
    assert axes.get_yscale() == "log"
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("Radial load Fz (kN)", "Life (h)")
    assert {"ISO/TS 16281, modified", "ISO/TS 16281, basic", "required life"} <= set(labels(axes))


def test_a_bound_far_above_does_not_lead_the_axis(curve: LifeCurve, case: Case) -> None:
    axes = lives_by_theory([curve])
    others = np.concatenate([curve[t].hours for t in THEORIES - {"ioannides_harris"}])
    assert np.max(curve["ioannides_harris"].hours) > 100.0 * others.max()
    low, high = axes.get_ylim()
    assert low < others.min()
    assert others.max() < high < 20.0 * others.max()
    assert "Ioannides and Harris (upper bound)" in labels(axes)
    # under one load it lies wholly above
    warm = life_curve(case, read_range("temperature.lubricant=40..90degC", 5))
    axes = lives_by_theory([warm])
    assert "Ioannides and Harris (upper bound), above" in labels(axes)
    assert axes.get_ylim()[1] < np.min(warm["ioannides_harris"].hours)
    assert axes.get_xlabel() == "Lubricant temperature (°C)"
    np.testing.assert_allclose(axes.get_xlim(), (40.0, 90.0))


def test_variants_stand_beside_by_the_theory_that_knows_most(case: Case) -> None:
    chosen = read_range("bearing.diametral_clearance=0..40um", 6)
    setting = "duty.load.fz=3kN"
    variant = life_curve(override(case, [setting]), chosen, label=setting)
    figure = life_figure([life_curve(case, chosen), variant])
    (axes,) = figure.axes
    found = line(axes, "ISO/TS 16281, modified, radial load Fz = 3kN")
    np.testing.assert_array_equal(found.get_ydata(), variant["iso16281_modified"].hours)
    assert axes.get_xlabel() == "Diametral clearance (µm)"
    assert figure.get_suptitle() == case.title
    assert drawn(figure).startswith(b"\x89PNG")


def test_the_wanted_life_is_a_line(curve: LifeCurve) -> None:
    wanted = line(lives_by_theory([curve]), "required life")
    np.testing.assert_allclose(wanted.get_ydata(), 2000.0)


def test_where_nothing_turns_revolutions_are_drawn(case: Case) -> None:
    still = override(case, ["duty.inner_speed=0 rpm"])
    curve = life_curve(still, read_range("duty.load.fz=1..5kN", 4))
    axes = lives_by_theory([curve])
    assert axes.get_ylabel() == "Life (10⁶ rev)"
    shown = np.asarray(line(axes, "ISO 281, basic").get_ydata())
    np.testing.assert_array_equal(shown, curve["iso281"].life)
    assert "required life" not in labels(axes)


def test_points_without_a_result_are_marked(case: Case) -> None:
    curve = life_curve(case, read_range("bearing.diametral_clearance=-0.2..0.05mm", 6))
    failed = int((curve.status != "converged").sum())
    assert failed
    assert f"no result: {failed} of 6" in labels(lives_by_theory([curve]))


def test_without_any_life_the_frame_says_so(case: Case) -> None:
    unheld = override(case, ["duty.load.fx=5kN", "bearing.contact_angle=15deg"])
    curve = life_curve(unheld, read_range("duty.load.fx=-9..-5kN", 3))
    axes = lives_by_theory([curve])
    assert texts(axes) == ["No result"]


def test_endless_lives_are_told(curve: LifeCurve) -> None:
    endless = replace(curve["iso16281"], hours=np.full(len(curve), np.inf))
    axes = lives_by_theory([replace(curve, theories={"iso16281": endless})])
    assert texts(axes) == ["fatigue ends no life here"]


def test_decades_are_numbered_however_many_there_are() -> None:
    _, axes = new_figure()
    decades(axes, "y", (0.5, 3e8))
    figure = figure_of(axes)
    drawn(figure)
    shown = [tick.get_text() for tick in axes.get_yticklabels()]
    assert {"100", "10⁶", "10⁸"} <= set(shown)
    _, axes = new_figure()
    with speaking("pt"):
        decades(axes, "x", (0.2, 1.1))
    drawn(figure_of(axes))
    assert {"0,2", "0,5"} <= {tick.get_text() for tick in axes.get_xticklabels()}


def test_a_setting_is_told_by_its_last_part() -> None:
    assert setting_name("duty.load.fz=3kN") == "radial load Fz = 3kN"
    assert setting_name("new grease") == "new grease"


# --- a_ISO -------------------------------------------------------------------------------------


def test_the_case_lies_on_the_chart_where_its_factor_is(state: Solved) -> None:
    summary = life(state, stress_volume=False)
    axes = aiso_chart(summary)
    for theory, name in (("iso16281_modified", "ISO/TS 16281"), ("iso281_modified", "ISO 281")):
        record = summary[theory]
        mark = next(one for one in axes.get_lines() if str(one.get_label()).startswith(name))
        load = record.factors.get("equivalent_load", summary.loads.dynamic)
        clean = record.factors["contamination_factor"]
        strength = clean * summary.ratings.fatigue_of_set / load
        np.testing.assert_allclose(mark.get_xdata(), strength)
        np.testing.assert_allclose(mark.get_ydata(), record.factors["a_iso"])
        assert to_hex(mark.get_color()) == of_look(theory_look(theory)).color.lower()
    assert any("$κ$ = 1.31" in label for label in labels(axes))


def test_the_curves_are_those_of_the_standard() -> None:
    axes = aiso_chart()
    curves = [one for one in axes.get_lines() if not str(one.get_label()).startswith("ISO")]
    assert len(curves) == 13
    names = texts(axes)
    assert names[-1] == "$κ$ = 4"
    assert names[0] == "0.1"
    x, y = (np.asarray(data) for data in curves[-1].get_data())
    # ISO 281:2007, 9.3.3.3, ball bearings, κ from 1 to 4
    inner = (2.5671 - 1.9987 / 4.0**0.071739) ** 0.83 * np.cbrt(x)
    with np.errstate(invalid="ignore"):
        expected = np.where(inner < 1.0, 0.1 * (1.0 - inner) ** -9.3, 50.0)
    np.testing.assert_allclose(y, np.minimum(expected, 50.0), rtol=1e-9)
    assert all(np.all(np.diff(np.asarray(one.get_ydata())) >= 0.0) for one in curves)
    assert "ISO" not in "".join(labels(axes))


def test_a_chart_with_a_case_far_out_holds_it(state: Solved) -> None:
    clean = LifeConditions(viscosity_ratio=4.0, contamination=1.0, fatigue_load_limit=4e5)
    summary = life(state, clean, stress_volume=False)
    axes = aiso_chart(summary)
    assert axes.get_xlim()[1] > 100.0
    thin = LifeConditions(viscosity_ratio=0.05, contamination=0.5)
    axes = aiso_chart(life(state, thin, stress_volume=False))
    assert any(text.startswith("there is no $a_") for text in texts(axes))


def test_several_cases_lie_on_one_chart(case: Case) -> None:
    batch = solve(case, fz=[1e3, 4e3, 8e3])
    summary = life(batch)
    axes = aiso_chart(summary)
    mark = line(axes, "ISO/TS 16281, modified")
    np.testing.assert_allclose(
        mark.get_ydata(), summary["iso16281_modified"].factors["a_iso"], rtol=1e-12
    )
    assert len(mark.get_xdata()) == 3


def test_additives_are_told(state: Solved) -> None:
    given = LifeConditions(viscosity_ratio=0.5, contamination=0.5, additives=True)
    assert any("with additives" in label for label in labels(aiso_chart(life(state, given))))


# --- life over load ----------------------------------------------------------------------------


def test_lives_over_load_are_those_of_the_cases(case: Case, lives: LoadLives) -> None:
    assert set(lives.theories) == THEORIES
    assert lives.factor[lives.own] == 1.0
    assert not lives.by_reference
    for place in (3, lives.own):
        changed = case.duty.replace(load=Load(fz=4000.0 * float(lives.factor[place])))
        alone = life(solve(case.replace(duty=changed)))
        for theory, record in alone.theories.items():
            found = lives.theories[theory].life[place]
            assert found == pytest.approx(record.life[0], rel=1e-5), theory
        rating = alone.ratings.dynamic_of_set[0]
        assert lives.load[place] == pytest.approx(alone.loads.dynamic[0] / rating)
        assert lives.fatigue_load == pytest.approx(alone.ratings.fatigue_of_set[0] / rating)


def test_the_basic_line_is_straight_and_those_with_a_limit_bend(lives: LoadLives) -> None:
    axes = load_over_life(lives)
    assert axes.get_xscale() == axes.get_yscale() == "log"
    np.testing.assert_allclose(slopes(axes, "ISO 281, basic"), -3.0, rtol=1e-9)
    bent = slopes(axes, "ISO 281, modified")
    assert bent[0] < 1.2 * bent[-1] < -3.0
    steep = slopes(axes, "Ioannides and Harris (upper bound)")
    assert steep[0] < 2.0 * steep[-1] < -3.0
    own = line(axes, "this case")
    np.testing.assert_allclose(own.get_ydata(), lives.load[lives.own])
    assert len(own.get_xdata()) == len(THEORIES)
    np.testing.assert_allclose(line(axes, "fatigue load limit C_u").get_ydata(), lives.fatigue_load)
    assert axes.get_ylabel() == "P/C (ISO 281)"


def test_tests_stand_beside_the_theories(lives: LoadLives) -> None:
    failed = np.array([True, True, False])
    ran = BearingTests("rig", np.array([0.02, 50.0, 80.0]), np.full(3, 0.5), failed)
    axes = load_over_life(lives, tests=[ran])
    np.testing.assert_array_equal(line(axes, "rig: failed").get_xdata(), [0.02, 50.0])
    hollow = line(axes, "rig: suspended")
    np.testing.assert_array_equal(hollow.get_xdata(), [80.0])
    assert hollow.get_markerfacecolor() == "white"
    assert axes.get_xlim()[0] < 0.02


def test_over_pressure(lives: LoadLives) -> None:
    axes = load_over_life(lives, by="pressure")
    own = line(axes, "this case")
    np.testing.assert_allclose(own.get_ydata(), lives.pressure[lives.own] / 1e6)
    assert axes.get_ylabel() == "Maximum contact pressure (MPa)"
    assert "fatigue load limit C_u" not in labels(axes)
    heaviest = float(solve(lives.case).inner.max_pressure.max())
    assert lives.pressure[lives.own] == pytest.approx(heaviest, rel=1e-5)


def test_a_set_without_a_load_of_the_standard_takes_the_reference(case: Case) -> None:
    bearing = Bearing(
        ball_count=14, ball_diameter=0.0127, pitch_diameter=0.0675, contact_angle=0.4363,
        inner_conformity=0.52, outer_conformity=0.53, arrangement="TBT", spacing=0.02,
        preload={"force": 300.0},
    )  # fmt: skip
    found = lives_over_load(solve(case.replace(bearing=bearing)), points=6)
    assert found.by_reference
    assert np.isnan(found.theories["iso281"].life).all()
    axes = load_over_life(found)
    assert axes.get_ylabel() == "P/C (ISO/TS 16281)"
    np.testing.assert_allclose(slopes(axes, "ISO/TS 16281, basic"), -3.0, rtol=1e-9)


def test_life_over_load_needs_a_load(case: Case) -> None:
    held = case.replace(duty=Duty(inner_speed=100.0, displacement={"z": 2e-5}))
    with pytest.raises(InputError, match="needs forces on the ring"):
        lives_over_load(solve(held))


# --- load zone ---------------------------------------------------------------------------------


def test_life_is_longest_with_a_little_preload(state: Solved) -> None:
    zone = lives_over_zone(state)
    assert zone.best[0] == pytest.approx(0.73, abs=0.01)
    # NSK, Rolling Bearings (E1102), 9.2: no clearance at 0.5, where life is the rating life
    place = int(np.argmin(np.abs(zone.zone - 0.5)))
    assert zone.life_ratio[place] == pytest.approx(1.0, abs=1e-6)
    assert zone.clearance[place] == pytest.approx(0.0, abs=1e-9)
    assert (np.diff(zone.clearance) < 0.0).all()
    axes = life_over_zone(zone)
    assert zone.own is not None
    found = next(one for one in axes.get_lines() if str(one.get_label()).startswith("this case"))
    np.testing.assert_allclose(found.get_data(), np.reshape(zone.own, (2, 1)))
    clearance = float(np.interp(zone.own[0], zone.zone, zone.clearance))
    assert clearance == pytest.approx(state.case.bearing.diametral_clearance, rel=1e-4)
    assert "0.5\n0" in [tick.get_text() for tick in axes.get_xticklabels()]


def test_the_own_zone_is_about_that_of_the_solved_balls(state: Solved) -> None:
    own = lives_over_zone(state).own
    assert own is not None
    deflected = float((state.inner.deflection + state.outer.deflection).max())
    clearance = state.case.bearing.diametral_clearance
    assert clearance is not None
    epsilon = 0.5 * deflected / (deflected + 0.5 * clearance)
    assert own[0] == pytest.approx(epsilon, rel=0.02)


def test_under_axial_load_there_is_no_clearance_to_tell(case: Case) -> None:
    zone = lives_over_zone(solve(override(case, ["duty.load.fx=500 N"])))
    assert zone.own is None
    assert np.isnan(zone.clearance).all()
    axes = life_over_zone(zone)
    assert axes.get_xlabel() == "Load zone ε"
    assert not any("this case" in label for label in labels(axes))


def test_a_load_zone_is_that_of_radial_contact(bearing_218: Bearing, case: Case) -> None:
    angular = case.replace(bearing=bearing_218, duty=Duty(inner_speed=50.0, load=Load(fx=5e3)))
    with pytest.raises(
        InputError, match="needs a single radial-contact bearing given by its clearance"
    ):
        lives_over_zone(solve(angular))


# --- what helps --------------------------------------------------------------------------------


def test_bars_are_the_ratios(state: Solved) -> None:
    changes = sensitivity(state)
    axes = what_helps(changes)
    assert len(axes.patches) == len(changes) == 5
    for bar, change in zip(axes.patches, changes, strict=True):
        assert bar.get_x() + bar.get_width() == pytest.approx(change.life_ratio)  # type: ignore[attr-defined]
    names = [tick.get_text() for tick in axes.get_yticklabels()]
    assert names[0] == "Contamination factor +0.2, at most 1"
    least, most = axes.get_xlim()
    assert least < min(change.life_ratio for change in changes) < 1.0 < most
    assert f"× {changes[0].life_ratio:.3g}" in texts(axes)


def test_a_change_without_a_ratio_has_no_bar() -> None:
    axes = what_helps([Change("less_load", 1.4), Change("less_clearance", float("nan"))])
    assert [bar.get_width() for bar in axes.patches] == pytest.approx([0.4, 0.0])  # type: ignore[attr-defined]
    assert texts(axes) == ["× 1.4", "No result"]
    axes = what_helps([Change("less_load", float("nan"))])
    assert "No result" in texts(axes)[0]


# --- all of them -------------------------------------------------------------------------------


def test_all_figures_can_be_drawn_in_both_languages(
    curve: LifeCurve, lives: LoadLives, state: Solved
) -> None:
    zone, changes, summary = lives_over_zone(state), sensitivity(state), life(state)
    pictures: dict[str, list[bytes]] = {"en": [], "pt": []}
    for language, kept in pictures.items():
        with speaking(language):
            figures = (
                life_figure([curve]),
                sn_figure(lives),
                load_zone_figure(zone),
                helps_figure(changes, state.title),
                figure_of(aiso_chart(summary)),
            )
        kept.extend(drawn(figure) for figure in figures)
    for english, portuguese in zip(*pictures.values(), strict=True):
        assert english != portuguese
    with speaking("pt"):
        figure = life_figure([curve])
    (axes,) = figure.axes
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("Carga radial Fz (kN)", "Vida (h)")
