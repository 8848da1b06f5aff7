"""The verbs at the top of the package: what a person guesses without reading."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import rolamento as ro

OIL = {"lubricant": "ISO VG 68", "temperature": "70 degC"}
DUTY = {"fz": 5e3, "inner_speed": "1480 rpm"}


def test_every_public_name_is_there() -> None:
    for name in ro.__all__:
        assert getattr(ro, name) is not None
    assert set(ro.__all__) <= set(dir(ro))
    with pytest.raises(AttributeError, match="no attribute 'bearings'"):
        _ = ro.bearings


def test_subpackages_are_there_whatever_was_imported_before() -> None:
    names = ", ".join(f"ro.{name}" for name in ("life", "weibull", "plots", "speeds", "errors"))
    code = f"import rolamento as ro; print(*(one.__name__ for one in ({names})))"
    found = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    expected = [f"rolamento.{name}" for name in ("life", "weibull", "plots", "speeds", "errors")]
    assert found.stdout.split() == expected


class TestOneCaseOneAnswer:
    """Whatever the door: a designation, a case, solved cases, the analysis of it all."""

    solved = ro.solve(ro.load_case("6310/C3").with_(fz=5e3, inner_speed="1480 rpm"))
    analysis = ro.analyse("6310/C3", **DUTY, **OIL)  # type: ignore[arg-type]

    def test_life(self) -> None:
        found = ro.rating_life("6310/C3", **DUTY)  # type: ignore[arg-type]
        again = ro.rating_life(self.solved).headline.hours
        assert found.headline.hours == pytest.approx(again, rel=1e-9)  # compiled or not
        # C = 62 kN, p = 3: ISO 281 by hand
        assert found["iso281"].life[0] == pytest.approx((62.0 / 5.0) ** 3, rel=1e-12)

    def test_film(self) -> None:
        found = ro.lubricant_film("6310/C3", **DUTY, **OIL)  # type: ignore[arg-type]
        assert self.analysis.film is not None
        assert found.viscosity_ratio == self.analysis.film.viscosity_ratio
        assert found.inner.central_thickness == pytest.approx(
            self.analysis.film.inner.central_thickness, rel=1e-9, nan_ok=True
        )

    def test_friction(self) -> None:
        found = ro.friction_torque("6310/C3", **DUTY, **OIL)  # type: ignore[arg-type]
        assert self.analysis.friction is not None
        assert found.torque == pytest.approx(self.analysis.friction.torque, rel=1e-9)
        assert tuple(found.models) == tuple(self.analysis.friction.models)

    def test_many_cases(self) -> None:
        loads = np.array([2e3, 5e3])
        found = ro.rating_life("6310/C3", fz=loads, inner_speed="1480 rpm")
        assert found["iso281"].life == pytest.approx((62e3 / loads) ** 3, rel=1e-12)

    def test_frequencies(self) -> None:
        found = ro.fault_frequencies("6205", speed="1797 rpm").best
        assert found.ball_pass_outer.order == pytest.approx(3.5848, rel=3e-3)  # CWRU's table

    def test_a_bearing_will_do(self) -> None:
        bearing = ro.Bearing(designation="6310/C3")
        assert ro.rating_life(bearing, **DUTY)["iso281"].life[0] == pytest.approx(12.4**3)  # type: ignore[arg-type]
        roller = ro.RollerBearing(designation="NU 210")
        assert ro.analyse(roller, fz=5e3, inner_speed=100.0).solved.converged.all()

    def test_what_is_solved_does_not_change(self) -> None:
        with pytest.raises(ro.InputError, match="fz: cannot change: the case is solved already"):
            ro.friction_torque(self.solved, fz=1e3)
        with pytest.raises(ro.InputError, match=r"temperature.lubricant: cannot change"):
            ro.lubricant_film(self.solved, temperature="70 degC")

    def test_friction_needs_a_lubricant(self) -> None:
        with pytest.raises(ro.InputError, match="friction_coefficient"):
            ro.friction_torque("6310/C3", **DUTY)  # type: ignore[arg-type]


class TestCase:
    def test_of_a_designation(self) -> None:
        case = ro.Case(bearing="6310/C3")
        assert case == ro.load_case("6310/C3").replace(title="")
        assert ro.Case(bearing="NU 210").bearing.element == "cylindrical"

    def test_short_names(self) -> None:
        case = ro.Case(bearing="6310/C3").with_(fz="5 kN", inner_speed=155.0)
        assert (case.duty.load.fz, case.duty.inner_speed) == (5e3, 155.0)
        assert case == ro.Case(bearing="6310/C3").with_({"fz": 5e3, "duty.inner_speed": 155.0})
        with pytest.raises(ro.InputError, match=r"duty.load.fz: is given twice"):
            case.with_({"duty.load.fz": 1.0}, fz=2.0)
        with pytest.raises(ro.InputError, match=r"duty.load.fz: is given twice"):
            case.with_({"duty.load.fz": 1.0, "fz": 2.0})

    def test_changes_over_a_designation_are_values(self) -> None:
        case = ro.load_case("6310/C3", {"fz": 5e3, "temperature.lubricant": "70 degC"})
        assert (case.duty.load.fz, case.lubricant_temperature) == (5e3, pytest.approx(343.15))
        with pytest.raises(ro.InputError) as refused:
            ro.load_case("6310/C3", {"duty.load.fz": "5 m"})
        assert refused.value.source == ""  # it was no option

    def test_a_file_says_it_with_a_table(self, tmp_path: Path) -> None:
        path = tmp_path / "case.toml"
        path.write_text('bearing = "6310/C3"\n[duty]\n', encoding="utf-8")
        with pytest.raises(ro.InputError, match="must be a table"):
            ro.load_case(path)


class TestSweep:
    def test_of_a_designation(self, tmp_path: Path) -> None:
        path = tmp_path / "found.csv"
        told: list[tuple[int, ...]] = []
        found = ro.sweep(
            "6310/C3",
            {"bearing.inner_conformity": [0.51, 0.52, 0.53]},
            path,
            fz=np.array([2e3, 4e3]),
            inner_speed="1000 rpm",
            outputs=["max_inner_load"],
            progress=lambda *done: told.append(done),
        )
        assert sorted(found.sizes.values()) == [1, 2, 3]
        one = ro.solve(
            ro.load_case("6310/C3").with_(inner_speed="1000 rpm"),
            {"bearing.inner_conformity": [0.53]},
            fz=4e3,
        )
        there = found.sel(fz=4e3, inner_conformity=0.53)
        assert float(there.max_inner_load.squeeze()) == pytest.approx(one.inner.load.max())
        assert len(path.read_text(encoding="utf-8").splitlines()) >= 7
        assert told[-1][:2] == (6, 6)

    def test_of_a_study(self, tmp_path: Path) -> None:
        path = tmp_path / "study.toml"
        path.write_text(
            'case = "6310/C3"\noutputs = ["max_inner_load"]\n[[axes]]\nfield = "duty.load.fz"\n'
            'values = ["1 kN", "2 kN"]\n',
            encoding="utf-8",
        )
        assert ro.sweep(path).sizes["fz"] == 2
        assert ro.sweep(ro.studies.load_study(path)).equals(ro.sweep(path))
        with pytest.raises(ro.InputError, match="source: has axes of its own"):
            ro.sweep(ro.studies.load_study(path), fz=[1.0])

    def test_a_netcdf_file_holds_what_is_returned(self, tmp_path: Path) -> None:
        path = tmp_path / "found.nc"
        found = ro.sweep("6310/C3", path=path, fz=[2e3, 4e3], outputs=["max_inner_load"])
        again = ro.sweep("6310/C3", fz=[2e3, 4e3], outputs=["max_inner_load"])
        assert path.is_file()
        assert found.max_inner_load.values == pytest.approx(again.max_inner_load.values, rel=1e-9)

    def test_refusals(self) -> None:
        with pytest.raises(ro.InputError, match="axes: must be given"):
            ro.sweep("6310/C3")
        with pytest.raises(ro.InputError, match="source: must be a case"):
            ro.sweep(ro.solve("6310/C3"), fz=[1.0])
        with pytest.raises(ro.InputError, match="force"):
            ro.sweep("6310/C3", force=[1.0])


@pytest.mark.parametrize("ending", [".md", ".html", ".json", ".txt"])
def test_report(tmp_path: Path, examples: Path, ending: str) -> None:
    path = tmp_path / f"report{ending}"
    found = ro.report(
        [examples / "218_combined.toml", "6310/C3"], path, head={"author": "A. Bearing"}
    )
    text = path.read_text(encoding="utf-8")
    assert "A. Bearing" in text
    assert "6310/C3" in text
    assert [one.name for one in found.cases] == ["A", "B"]
    if ending == ".json":
        assert json.loads(text)["kind"] == "report"


def test_report_of_solved_cases_has_their_loads_and_speeds() -> None:
    solved = ro.solve("6310/C3", fz=[2e3, 5e3], inner_speed="1480 rpm")
    found = ro.report(solved)
    for index, one in enumerate(found.cases):
        again = one.analysis.solved
        assert again.field("duty.load.fz") == [2e3, 5e3][index]
        assert again.inner.load[0] == pytest.approx(solved.inner.load[index], rel=1e-9)
    assert len(found.cases) == 2


def test_report_refuses_other_files(tmp_path: Path) -> None:
    with pytest.raises(ro.InputError, match=r"must end in one of .html, .pdf"):
        ro.report("6310/C3", tmp_path / "report.docx")


class TestWeibull:
    times = (55.2, 81.0, 104.5, 132.1, 150.0, 150.0)
    failed = (1, 1, 1, 1, 0, 0)

    def test_times(self) -> None:
        test = ro.weibull.LifeTest(self.times, failed=self.failed)
        assert repr(ro.fit_weibull(self.times, self.failed)) == repr(
            ro.weibull.maximum_likelihood(test)
        )
        assert ro.fit_weibull(test).shape == ro.fit_weibull(self.times, self.failed).shape

    @pytest.mark.parametrize("method", ro.weibull.FIT_METHODS)
    def test_methods(self, method: ro.weibull.FitMethod) -> None:
        assert ro.fit_weibull(self.times, self.failed, method=method).method == method

    def test_a_file(self, tmp_path: Path) -> None:
        path = tmp_path / "lives.csv"
        rows = "".join(
            f"{t},{'yes' if f else 'no'}\n" for t, f in zip(self.times, self.failed, strict=True)
        )
        path.write_text(f"time,failed\n{rows}", encoding="utf-8")
        found = ro.fit_weibull(path, unit="h")
        assert found.shape == ro.fit_weibull(self.times, self.failed).shape
        with pytest.raises(ro.InputError, match="failed: is in the file"):
            ro.fit_weibull(path, self.failed)

    def test_an_unknown_method(self) -> None:
        with pytest.raises(ro.InputError, match="method"):
            ro.fit_weibull(self.times, method="guess")  # type: ignore[arg-type]


def test_find_bearings() -> None:
    assert "6205" in [one.designation for one in ro.find_bearings("25x52x15")]
    assert len(ro.find_bearings("62", 3)) == 3
    (one,) = ro.find_bearings("NU 210 EW", 1)
    assert repr(one) == "<NSK NU 210 EW, cylindrical, 50 x 90 x 20 mm, C 69 kN, C_0 76.5 kN>"
    with pytest.raises(ro.InputError, match="must be text"):
        ro.find_bearings(6205)  # type: ignore[arg-type]


def test_a_signal_in_memory_is_diagnosed() -> None:
    noise = np.random.default_rng(0).normal(size=48_000)
    found = ro.diagnose(noise, "6205", speed="1797 rpm", rate=12_000.0)
    assert (found.status, found.faults) == ("diagnosed", ())
    short = ro.diagnose(noise[:600], "6205", speed="1797 rpm", rate=12_000.0)
    assert (short.status, short.verdict, short.faults) == ("record_too_short", "no_verdict", ())


@pytest.mark.parametrize("bearing", ["6310/C3", "NU 210"])
def test_many_cases_have_the_models_of_whole_bearings_where_all_are_compared(bearing: str) -> None:
    loads = np.linspace(3e3, 7e3, 70)
    duty = {"inner_speed": 155.0, "compare": True, **OIL}
    many = ro.friction_torque(bearing, fz=loads, **duty)
    assert {"palmgren", "skf"} <= set(many.models)
    for index in (0, 69):
        one = ro.friction_torque(bearing, fz=float(loads[index]), **duty)
        for name in one.models:
            np.testing.assert_allclose(
                many.models[name].total[index], one.models[name].total[0], rtol=1e-9
            )
