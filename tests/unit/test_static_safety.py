"""Static safety, launch loads and hardness: limits, scaling, what is said."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import Case, Static, solve
from rolamento.case import case_of, load_case
from rolamento.errors import InputError
from rolamento.safety import (
    case_depth,
    hardness_needed,
    launch_of,
    load_of_rating,
    pressure_limit,
    recommended_safety,
    rockwell_of_vickers,
    static_safety_of,
    stress_safety,
    vickers_of_rockwell,
)

PAIR = "src/rolamento/examples/6012_pair.toml"


def deep_groove(**more: object) -> Case:
    return case_of("6310", {"duty.load.fz": "19 kN", **more})


def test_twice_the_pressure_is_an_eighth_of_a_point_and_a_quarter_of_a_line() -> None:
    assert stress_safety(8.4e9, 4.2e9) == pytest.approx(1.0 / 8.0)
    assert stress_safety(8.0e9, 4.0e9, line=True) == pytest.approx(1.0 / 4.0)


def test_without_load_the_safety_is_infinite() -> None:
    assert np.isinf(stress_safety(0.0, 4.2e9))


def test_the_limits_are_those_of_the_kinds() -> None:
    limits = {kind: 1e-6 * pressure_limit(kind) for kind in ("radial", "self_aligning", "roller")}
    assert limits == {"radial": 4200.0, "self_aligning": 4600.0, "roller": 4000.0}


def test_an_unknown_kind_is_refused_by_name() -> None:
    with pytest.raises(InputError, match="self_aligning"):
        pressure_limit("conical")  # type: ignore[arg-type]


def test_the_load_factor_multiplies_the_loads() -> None:
    plain = static_safety_of(deep_groove(**{"duty.load.fz": "38 kN"}))
    factored = static_safety_of(deep_groove(**{"static.load_factor": 2.0}))
    assert factored.minimum("stress") == pytest.approx(plain.minimum("stress"), rel=1e-9)
    assert factored.safety == pytest.approx(plain.safety)


def test_a_solved_case_and_its_case_give_the_same() -> None:
    case = deep_groove()
    assert static_safety_of(solve(case)).minimum() == pytest.approx(
        static_safety_of(case).minimum()
    )


def test_without_clearance_the_rating_loads_the_heaviest_ball_as_it_says() -> None:
    """C_0/P_0 = 1: five times the mean on the ball with the most load (4.37 without clearance)."""
    case = case_of("6310", {"bearing.diametral_clearance": "0 mm"})
    found = static_safety_of(case.with_(fz=38.5e3))
    assert found.safety[0, 0] == pytest.approx(1.0, rel=2e-2)
    assert found.minimum("load")[0] == pytest.approx(5.0 / 4.37, rel=0.03)


def test_q_0_of_a_thrust_bearing_shares_its_rating_evenly() -> None:
    assert load_of_rating(60e3, 12, np.pi / 2, "thrust") == pytest.approx(5e3)


def test_the_pressure_of_rollers_counts_as_that_of_lines() -> None:
    found = static_safety_of(case_of("NU 205", {"duty.load.fz": "10 kN"}))
    p = found.hardening["inner"].max_pressure[0, 0]
    assert found.of_rows("inner", "stress")[0, 0] == pytest.approx((4.0e9 / p) ** 2)


def test_soft_raceways_bear_less_and_say_so() -> None:
    hard = static_safety_of(deep_groove(**{"static.surface_hardness": 58}))
    soft = static_safety_of(deep_groove(**{"static.surface_hardness": 50}))
    assert soft.minimum()[0] < 0.7 * hard.minimum()[0]
    assert "soft_raceways" in {note.key for note in soft.notes}


def test_a_pair_pulled_apart_shows_its_gaps() -> None:
    case = load_case(PAIR, {"duty.load.fx": "8 kN", "duty.load.fz": "0 N", "duty.inner_speed": 0.0})
    found = launch_of(solve(case))
    assert found.lost[0].tolist() == [False, True]
    assert found.gap[0, 1] > 1e-6
    assert found.gap[0, 0] == 0.0


def test_rows_pressed_together_have_no_gap() -> None:
    case = load_case(PAIR, {"duty.load.fx": "10 N", "duty.load.fz": "0 N", "duty.inner_speed": 0.0})
    assert not launch_of(solve(case)).gap.any()


def test_the_margin_is_zero_at_the_allowable_pressure() -> None:
    solved = solve(deep_groove())
    found = launch_of(solved, float(solved.inner.max_pressure.max()))
    assert found.allowables[-1].margin[0] == pytest.approx(0.0, abs=1e-12)


def test_allowables_stand_beside_the_materials_that_have_them() -> None:
    found = launch_of(solve(deep_groove(**{"bearing.ring_material": "440C"})))
    assert [1e-6 * one.pressure for one in found.allowables] == [2310.0, 2760.0]


def test_a_mean_pressure_is_two_thirds_of_that_of_a_point() -> None:
    found = launch_of(solve(deep_groove()))
    assert found.mean_pressure[0] == pytest.approx(found.max_pressure[0] * 2.0 / 3.0)


def test_hardness_converts_there_and_back() -> None:
    rockwell = np.array([25.0, 45.0, 58.0, 64.0])
    assert rockwell_of_vickers(vickers_of_rockwell(rockwell)) == pytest.approx(rockwell)


def test_hardness_outside_the_scale_is_not_converted() -> None:
    assert np.isnan(vickers_of_rockwell(75.0))
    assert np.isnan(rockwell_of_vickers(120.0))


def test_the_case_ends_where_the_core_bears_the_shear() -> None:
    from rolamento.contact.subsurface import axis_stresses

    depth = float(case_depth(3e9, 1.5e-3, 0.3e-3, 350.0))
    s = axis_stresses(depth, 3e9, 1.5e-3, 0.3e-3, 0.3)
    principal = np.stack([s.minor, s.major, s.normal])
    assert hardness_needed(0.5 * (principal.max() - principal.min())) == pytest.approx(350.0)


def test_a_hard_core_needs_no_case() -> None:
    assert case_depth(2e9, 1e-3, 0.3e-3, 800.0) == 0.0


def test_a_long_ellipse_goes_over_into_a_line() -> None:
    assert case_depth(3e9, 0.3, 0.3e-3, 350.0) == pytest.approx(
        float(case_depth(3e9, np.inf, 0.3e-3, 350.0)), rel=2e-3
    )


def test_the_case_scales_with_the_contact() -> None:
    single, double = (float(case_depth(3e9, f * 1e-3, f * 3e-4, 350.0)) for f in (1.0, 2.0))
    assert double == pytest.approx(2.0 * single)


def test_makers_recommend_more_for_rollers() -> None:
    balls = {one.maker: one.safety for one in recommended_safety("ball", "normal", "high")}
    rollers = {one.maker: one.safety for one in recommended_safety("cylindrical", "normal", "high")}
    assert all(rollers[maker] > balls[maker] for maker in balls)  # type: ignore[operator]


def test_a_maker_of_needles_has_a_table_for_needles_only() -> None:
    assert "IKO" not in {one.maker for one in recommended_safety("tapered")}
    assert "IKO" in {one.maker for one in recommended_safety("needle")}


def test_an_operation_that_is_none_is_refused() -> None:
    with pytest.raises(InputError, match="smooth"):
        Static(operation="gentle")  # type: ignore[arg-type]


def test_the_table_comes_back_from_a_file() -> None:
    case = deep_groove(**{"static.load_factor": 1.4, "static.case_depth": "1.5 mm"})
    assert case.from_mapping(case.to_mapping()).static == case.static


def test_the_page_says_it_in_both_languages() -> None:
    from rolamento.document.terminal import terminal
    from rolamento.pages.static import static_page
    from rolamento.words import speaking

    found = static_safety_of(deep_groove())
    for language in ("en", "pt_BR"):
        with speaking(language):
            assert "C_0/P_0" in terminal(static_page(found))


def test_a_report_shows_it_where_the_case_asks_for_it() -> None:
    from rolamento.document.markdown import markdown
    from rolamento.pages.report import report_page
    from rolamento.tasks import calculation_report

    plain, asked = (
        markdown(report_page(calculation_report([one])))
        for one in (deep_groove(), deep_groove(**{"static.requirement": "high"}))
    )
    assert "Hardness below the surface" not in plain
    assert "Hardness below the surface" in asked


def test_over_the_load_the_safety_falls_and_the_gaps_open() -> None:
    from rolamento.safety import static_over_load

    case = load_case(PAIR, {"duty.load.fx": "4 kN", "duty.load.fz": "0 N", "duty.inner_speed": 0.0,
                            "static.load_factor": 2.0})  # fmt: skip
    curve = static_over_load(case, most=1.5, points=6)
    assert curve.factor.tolist() == pytest.approx([0.25, 0.5, 0.75, 1.0, 1.25, 1.5])
    assert np.all(np.diff(curve.safety) < 0.0)
    assert np.all(np.diff(curve.gap[:, 1]) >= 0.0)
    # at the design load it is what the page has
    assert curve.safety[3] == pytest.approx(static_safety_of(case).minimum()[0])


def test_without_a_load_there_is_nothing_to_vary() -> None:
    from rolamento.safety import static_over_load

    with pytest.raises(InputError, match="load"):
        static_over_load(case_of("6310"))


@pytest.mark.parametrize("language", ["en", "pt_BR"])
def test_the_picture_has_safety_and_gaps(language: str) -> None:
    from rolamento.plots import static_figure
    from rolamento.safety import static_over_load
    from rolamento.words import speaking

    with speaking(language):
        figure = static_figure(static_over_load(load_case(PAIR), points=4))
    assert len(figure.axes) == 2
    assert len(figure.axes[1].lines) == 3  # two rows and the design load


def test_many_cases_have_the_load_factor_too() -> None:
    """What varies is multiplied where it is a load, and left alone where it is not."""
    case = deep_groove(**{"static.load_factor": 1.5})
    loads = static_safety_of(solve(case, {"duty.load.fz": np.array([10e3, 19e3])})).minimum()
    alone = [static_safety_of(case.with_(fz=load)).minimum()[0] for load in (10e3, 19e3)]
    assert loads == pytest.approx(alone)
    play = {"bearing.diametral_clearance": np.array([0.0, 2e-5])}
    found = static_safety_of(solve(case, play)).minimum()
    tight = case.with_({"bearing.diametral_clearance": 0.0})
    assert found[0] == pytest.approx(static_safety_of(tight).minimum()[0])
    assert found[1] < found[0]


def test_a_case_without_an_equilibrium_has_no_safety() -> None:
    found = static_safety_of(deep_groove(**{"duty.load.fz": "4000 kN"}))
    assert not found.solved.converged[0]
    assert not np.isfinite(found.minimum()[0])
    assert found.to_mapping()["safety_by_stress"] is None
