"""Variants of a case: how they are written, what they change, and where they stand side by side."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import typer
import xarray as xr
from matplotlib.figure import Figure
from typer.testing import CliRunner

from rolamento import Case, load_case
from rolamento.case.variant import (
    AS_GIVEN,
    Variant,
    cases_compared,
    read_variant,
    read_variants,
    settings_in,
)
from rolamento.cli.app import app
from rolamento.errors import InputError
from rolamento.plots.sweep import compared_histograms, compared_lines, study_lines
from rolamento.solution import solve
from rolamento.studies import Axis, Study, parse_study, run, study_to_json, study_to_toml
from rolamento.system.preload import first_lift_off, preload_at, preload_loss, preload_of
from rolamento.tasks.drawing import draw

SPRING = 'spring:bearing.preload={ spring = "500 N" }'
Run = Callable[..., tuple[int, str, str]]


@pytest.fixture(scope="module")
def pair(examples: Path) -> Case:
    return load_case(examples / "6012_pair.toml")


# --- how they are written -------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "name", "changes"),
    [
        (SPRING, "spring", {"bearing.preload": {"spring": "500 N"}}),
        ("bearing.ball_material=Si3N4", "bearing.ball_material=Si3N4",
         {"bearing.ball_material": "Si3N4"}),
        ("two of them:duty.load.fx=1 kN, duty.inner_speed=9000 rpm", "two of them",
         {"duty.load.fx": "1 kN", "duty.inner_speed": "9000 rpm"}),
        ('t:title="a, b=c",duty.load.fz=1 kN', "t", {"title": "a, b=c", "duty.load.fz": "1 kN"}),
        ("rigid:", "rigid", {}),
    ],
)  # fmt: skip
def test_a_variant_in_a_line(text: str, name: str, changes: dict[str, object]) -> None:
    found = read_variant(text)
    assert (found.name, found.changes) == (name, changes)


def test_commas_inside_tables_and_quotes_do_not_part() -> None:
    text = 'x:bearing.preload={ level = "light", designation = "a, b=c" },duty.load.fx=1 N'
    assert settings_in(text) == (
        "x",
        ('bearing.preload={ level = "light", designation = "a, b=c" }', "duty.load.fx=1 N"),
    )


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "must be NAME:FIELD=VALUE"),
        ("spring", "must be KEY=VALUE"),
        ("x:duty.load.fx=3", "needs a unit"),
        ("x:duty.load.fxx=3 N", "did you mean"),
        ("x:bearing.preload={ spring = ", "TOML"),
    ],
)
def test_what_is_no_variant(text: str, says: str) -> None:
    with pytest.raises(InputError, match=says) as refused:
        read_variant(text)
    assert refused.value.source == "--variant"


def test_a_table_takes_the_place_of_the_whole(pair: Case) -> None:
    found = cases_compared(pair, read_variants([SPRING]))
    assert list(found) == [AS_GIVEN, "spring"]
    assert found["spring"].bearing.preload is not None
    assert found["spring"].bearing.preload.spring == 500.0
    assert found[AS_GIVEN] is pair


def test_an_empty_table_takes_it_away(pair: Case) -> None:
    tandem = read_variant("tandem:bearing.arrangement=DT,bearing.preload={}").of(pair)
    assert (tandem.bearing.arrangement, tandem.bearing.preload) == ("DT", None)


def test_a_variant_without_changes_names_the_case(pair: Case) -> None:
    assert list(cases_compared(pair, read_variants([SPRING, "rigid:"]))) == ["spring", "rigid"]


def test_a_variant_of_another_case_is_named(pair: Case) -> None:
    with pytest.raises(InputError, match=r"heavy: bearing\.preload") as refused:
        cases_compared(pair, read_variants(["heavy:bearing.preload={ spring = 3 }"]))
    assert refused.value.source == "--variant"
    with pytest.raises(InputError, match=r'^--variant: "a": occurs twice'):
        cases_compared(pair, read_variants(["a:duty.load.fx=1 N", "a:duty.load.fx=2 N"]))
    many = [f"v{i}:duty.load.fx={i} N" for i in range(1, 21)]
    with pytest.raises(InputError, match="at most 20"):
        cases_compared(pair, read_variants(many))


def test_in_python_values_are_si(pair: Case) -> None:
    variant = Variant(name="heavy", changes={"bearing.preload": {"force": 900.0}})
    assert variant.of(pair).bearing.preload.force == 900.0  # type: ignore[union-attr]
    assert Variant(name="x", changes={"duty.load.fx": 5.0}).changes == {"duty.load.fx": "5 N"}


# --- in a study ---------------------------------------------------------------------------------

STUDY = """
case = "6012_pair.toml"
outputs = ["preload_at_speed", "stiffness_xx", "row_fx"]
[[axes]]
field = "duty.inner_speed"
values = ["0 rpm", "9000 rpm", "15000 rpm"]
[[variants]]
name = "rigid"
[[variants]]
name = "spring"
changes = { "bearing.preload" = { spring = "500 N" } }
[[variants]]
name = "triple"
changes = { bearing.arrangement = "TBT", bearing.preload = { force = "515 N" } }
"""


@pytest.fixture(scope="module")
def result(examples: Path) -> xr.Dataset:
    return run(parse_study(STUDY, folder=examples))


def test_variants_are_the_first_dimension(result: xr.Dataset, pair: Case) -> None:
    assert dict(result.sizes) == {"variant": 3, "inner_speed": 3, "row": 3}
    assert result["variant"].values.tolist() == ["rigid", "spring", "triple"]
    assert (result["status"] == 0).all()
    for place, speed in enumerate(result["inner_speed"].values):
        rigid = pair.with_({"duty.inner_speed": speed})
        own = preload_of(rigid)
        assert own is not None
        at_speed = result["preload_at_speed"].sel(variant="rigid")[place]
        assert float(at_speed) == pytest.approx(own.at_speed, rel=1e-9)
        found = solve(read_variant(SPRING).of(rigid)).rows.load[0, :, 0]
        np.testing.assert_allclose(result["row_fx"].sel(variant="spring")[place, :2], found,
                                   rtol=1e-7, atol=1e-4)  # fmt: skip
    assert np.isnan(result["row_fx"].sel(variant="spring")[:, 2]).all()
    np.testing.assert_allclose(result["row_fx"].sel(variant="triple").sum("row"), 1000.0)
    spring = result["preload_at_speed"].sel(variant="spring")
    np.testing.assert_allclose(spring, 500.0)
    assert (np.diff(result["preload_at_speed"].sel(variant="rigid")) > 0.0).all()


def test_a_study_with_variants_is_written_and_read(examples: Path) -> None:
    study = parse_study(STUDY, folder=examples)
    assert parse_study(study_to_toml(study)) == study
    assert parse_study(study_to_json(study), format="json") == study


def test_an_output_that_one_variant_has_is_nan_in_the_others(pair: Case) -> None:
    oil = {"lubricant": "ISO VG 32", "temperature.lubricant": "60 degC"}
    study = Study(case=pair, outputs=("x", "viscosity_ratio"),
                  variants=[Variant(name="oil", changes=oil)])  # fmt: skip
    found = run(study)
    assert np.isnan(found["viscosity_ratio"].sel(variant=AS_GIVEN))
    assert float(found["viscosity_ratio"].sel(variant="oil")) > 0.0
    with pytest.raises(InputError, match="needs a lubricant"):
        Study(case=pair, outputs=("viscosity_ratio",), variants=[read_variant(SPRING)])


def test_what_varies_cannot_be_a_variant(pair: Case) -> None:
    speeds = Axis(field="duty.inner_speed", values=[0.0, 500.0])
    with pytest.raises(InputError, match="varies in the study"):
        Study(case=pair, axes=[speeds], variants=[read_variant("a:duty.inner_speed=9000 rpm")])


# --- preload of many cases ----------------------------------------------------------------------


@pytest.mark.sweep
def test_load_factors_of_many_cases_are_those_of_each(pair: Case) -> None:
    """Clamped and by springs, at rest and at speed, with and without a radial load."""
    fx = np.array([1000.0, 1000.0, -500.0, 800.0, 0.0])
    fz = np.array([500.0, 0.0, 0.0, 0.0, 0.0])
    speed = np.array([0.0, 600.0, 600.0, 0.0, 900.0])
    for case in (pair, read_variant(SPRING).of(pair)):
        many = solve(case, fx=fx, fz=fz, inner_speed=speed)
        lift, loss = first_lift_off(many), preload_loss(many)
        at_speed = preload_at(many, running=True)
        for place in range(len(fx)):
            own = preload_of(
                case.with_(
                    {
                        "duty.load.fx": fx[place],
                        "duty.load.fz": fz[place],
                        "duty.inner_speed": speed[place],
                    }
                )
            )
            assert own is not None
            assert at_speed[place] == pytest.approx(own.at_speed, rel=1e-9)
            assert lift.factor[place] == pytest.approx(own.lift_factor, rel=1e-5, nan_ok=True)
            assert loss.factor[place] == pytest.approx(own.loss_factor, rel=1e-5, nan_ok=True)
            if not np.isnan(own.loss_factor):
                assert loss.row[place] == own.lost_row


def test_the_search_goes_on_where_the_grip_flattens_out(pair: Case) -> None:
    """At 1000 rpm six secants do not arrive: the factor lies between those of its neighbours."""
    found = first_lift_off(solve(pair, inner_speed=np.array([90.0, 104.7, 120.0])))
    assert np.isfinite(found.factor).all()
    assert found.factor[0] > found.factor[1] > found.factor[2]


# --- on the command line --------------------------------------------------------------------------


@pytest.fixture
def run_command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, examples: Path) -> Run:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "pair.toml").write_text((examples / "6012_pair.toml").read_text("utf-8"), "utf-8")
    study = STUDY.replace("6012_pair", "pair").partition("[[variants]]")[0]
    (tmp_path / "study.toml").write_text(study, "utf-8")

    def runner(*arguments: str) -> tuple[int, str, str]:
        found = CliRunner().invoke(app, arguments, env={"LC_ALL": "C.UTF-8"})
        if found.exception and not isinstance(found.exception, SystemExit | typer.Exit):
            raise found.exception
        return found.exit_code, found.stdout, found.stderr

    return runner


def test_solve_shows_the_cases_side_by_side(run_command: Run) -> None:
    code, out, _ = run_command("solve", "pair.toml", "--variant", "rigid:", "--variant", SPRING,
                               "--json", "both.json")  # fmt: skip
    assert code == 0
    assert "case rigid" in out
    assert "case spring" in out
    assert "axial preload at speed" in out
    both = json.loads(Path("both.json").read_text("utf-8"))
    assert [case["name"] for case in both["cases"]] == ["rigid", "spring"]
    assert "analysis.preload.at_speed" in both["differences"][0]["numbers"]


def test_sweep_and_plot(run_command: Run) -> None:
    code, _, _ = run_command("sweep", "study.toml", "--variant", SPRING, "-o", "a.nc")
    assert code == 0
    assert run_command("plot", "a.nc", "--variable", "stiffness_xx", "-o", "a.png")[0] == 0
    assert run_command("plot", "a.nc", "--variable", "row_fx", "-o", "b.png")[0] == 0
    code, _, err = run_command("sweep", "study.toml", "--variant", "a:duty.load.fxx=1 N")
    assert (code, "--variant: duty.load.fxx" in err) == (2, True)
    code, _, err = run_command("sweep", "study.toml", "--variant", "a:bearing.ball_count=90")
    assert (code, "--variant: a: bearing" in err) == (2, True)


# --- figures ------------------------------------------------------------------------------------


def of_speed(speeds: list[float], values: list[float], unit: str = "N/m") -> xr.Dataset:
    status = {"flag_values": [0], "flag_meanings": "converged"}
    return xr.Dataset(
        {
            "stiffness_xx": ("inner_speed", values, {"units": unit}),
            "status": ("inner_speed", [0] * len(speeds), status),
        },
        coords={"inner_speed": ("inner_speed", speeds, {"units": "rad/s"})},
        attrs={"title": "one", "study": ""},
    )


def names(axes: object) -> list[str]:
    return [text.get_text() for text in axes.get_legend().get_texts()]  # type: ignore[attr-defined]


def test_variants_are_lines_with_their_names(result: xr.Dataset) -> None:
    axes = study_lines(result, "stiffness_xx", Figure().add_subplot())
    assert names(axes) == ["rigid", "spring", "triple"]
    assert axes.get_legend().get_title().get_text() == ""
    axes = study_lines(result.isel(variant=[0, 1], row=[0, 1]), "row_fx", Figure().add_subplot())
    assert names(axes) == ["rigid, row 0", "rigid, row 1", "spring, row 0", "spring, row 1"]


def test_studies_with_grids_of_their_own_share_a_figure() -> None:
    a, b = of_speed([0.0, 100.0], [1e8, 2e8]), of_speed([50.0, 60.0, 70.0], [3e8, 4e8, 5e8])
    axes = compared_lines({"a": a, "b": b}, "stiffness_xx", Figure().add_subplot())
    assert names(axes) == ["a", "b"]
    np.testing.assert_allclose(axes.lines[0].get_ydata(), [100.0, 200.0])
    np.testing.assert_allclose(axes.lines[1].get_xdata(), np.array([50.0, 60.0, 70.0]) * 30 / np.pi)


def test_lines_in_one_unit_whatever_their_size() -> None:
    """Where one study reads best in N and another in kN, both are drawn in kN."""
    small, large = of_speed([0.0, 1.0], [1.0, 2.0], "N"), of_speed([0.0, 1.0], [2e4, 3e4], "N")
    axes = compared_lines({"small": small, "large": large}, axes=Figure().add_subplot())
    np.testing.assert_allclose(axes.lines[0].get_ydata(), [1e-3, 2e-3])
    np.testing.assert_allclose(axes.lines[1].get_ydata(), [20.0, 30.0])


def test_studies_that_do_not_fit_are_refused(tmp_path: Path) -> None:
    a, other = of_speed([0.0, 1.0], [1.0, 2.0]), of_speed([0.0, 1.0], [1.0, 2.0], "N")
    with pytest.raises(InputError, match=r"not the same in a \(N/m\) and b \(N\)"):
        compared_lines({"a": a, "b": other}, "stiffness_xx")
    drawn_speeds = a.rename({"inner_speed": "sample"}).assign_coords(
        inner_speed=("sample", [0.0, 1.0], {"units": "rad/s"})
    )
    with pytest.raises(InputError, match="cannot show a study of samples alone"):
        compared_lines({"a": a, "b": drawn_speeds}, "stiffness_xx")
    loads = a.rename({"inner_speed": "fx"})
    with pytest.raises(InputError, match="is not an axis"):
        compared_lines({"a": a, "b": loads}, "stiffness_xx")
    for name, data in (("a", a), ("b", a.rename({"stiffness_xx": "x"}))):
        data.to_netcdf(tmp_path / f"{name}.nc", engine="h5netcdf")
    with pytest.raises(InputError, match="no output in common"):
        draw([tmp_path / "a.nc", tmp_path / "b.nc"])
    with pytest.raises(InputError, match="once for each file"):
        draw([tmp_path / "a.nc", tmp_path / "a.nc"], labels=["one"])
    drawn = draw([tmp_path / "a.nc", tmp_path / "a.nc"], labels=["one", "two"])
    assert names(drawn.figure.axes[0]) == ["one", "two"]


def test_distributions_of_variants_share_a_frame() -> None:
    random = np.random.default_rng(1)
    status = {"flag_values": [0], "flag_meanings": "converged"}
    study = xr.Dataset(
        {
            "x": (("variant", "sample"), random.normal([[1e-6], [3e-6]], 1e-7, (2, 300)),
                  {"units": "m"}),
            "status": (("variant", "sample"), np.zeros((2, 300), np.int8), status),
        },
        coords={"variant": ["rigid", "spring"]},
    )  # fmt: skip
    axes = compared_histograms({"": study}, "x", Figure().add_subplot())
    assert names(axes)[0].startswith("rigid: median 0.99")
    assert names(axes)[1].startswith("spring: median ")


def test_states_share_a_frame(pair: Case, tmp_path: Path) -> None:
    for name, case in (("rigid", pair), ("spring", read_variant(SPRING).of(pair))):
        (tmp_path / f"{name}.json").write_text(solve(case).to_json(), encoding="utf-8")
    paths = [tmp_path / "rigid.json", tmp_path / "spring.json"]
    axes = draw(paths).figure.axes[0]
    assert len(axes.lines) == 4
    assert names(axes)[0] == "rigid: inner, row 0"
    again = draw(paths[0], "pressures", variants=[read_variant(SPRING)]).figure.axes[0]
    assert names(again)[-1] == "spring: inner, row 1"
    with pytest.raises(InputError, match="does not suit several states"):
        draw(paths, "ellipses")
