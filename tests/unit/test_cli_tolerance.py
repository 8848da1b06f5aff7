"""`rolamento tolerance`: what it prints, writes and draws, and the exit code that it ends with."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
from typer.testing import CliRunner

from rolamento.cli.requested import program_of
from rolamento.studies.sensitivity import rank_correlation
from rolamento.studies.tolerance import tolerance_bands

Run = Callable[..., tuple[int, str, str]]

app = program_of("studying:ToleranceRequest", "tolerance")

STUDY = """
title = "218 with its tolerances"
case = "case.toml"
outputs = ["z", "max_inner_load", "mz"]
[scatter]
count = 600
[scatter.fields."duty.load.fz"]
distribution = "normal"
mean = "15 kN"
standard_deviation = "1 kN"
[scatter.fields."bearing.contact_angle"]
distribution = "uniform"
minimum = "38 deg"
maximum = "42 deg"
"""


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, examples: Path) -> Run:
    """Run the command in a directory that holds a study."""
    monkeypatch.chdir(tmp_path)
    case = (examples / "218_combined.toml").read_text(encoding="utf-8")
    (tmp_path / "case.toml").write_text(case, encoding="utf-8")
    (tmp_path / "study.toml").write_text(STUDY, encoding="utf-8")

    def runner(*arguments: str) -> tuple[int, str, str]:
        result = CliRunner().invoke(app, arguments, env={"LC_ALL": "C.UTF-8"})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result.exit_code, result.stdout, result.stderr

    return runner


def dataset(failed: int = 7, count: int = 1000, speeds: int = 0) -> xr.Dataset:
    """A result of a scatter study, made by hand."""
    load, angle, noise = np.random.default_rng(0).normal(size=(3, count))
    values = 5000.0 + 400.0 * load - 100.0 * angle + 10.0 * noise
    status = np.zeros(count, np.int8)
    status[:failed] = 1
    values[:failed] = np.nan
    dims: tuple[str, ...] = ("sample",)
    coordinates: dict[str, Any] = {
        "fz": ("sample", 15e3 + 1e3 * load, {"units": "N", "field": "duty.load.fz"}),
        "contact_angle": ("sample", 0.7 + 0.02 * angle, {"units": "rad"}),
    }
    if speeds:
        dims = ("inner_speed", "sample")
        values, status = np.tile(values, (speeds, 1)), np.tile(status, (speeds, 1))
        coordinates["inner_speed"] = (
            "inner_speed",
            np.pi / 30.0 * 1000.0 * np.arange(1.0, speeds + 1.0),
            {"units": "rad/s"},
        )
    flags = {
        "flag_values": np.arange(2, dtype=np.int8),
        "flag_meanings": "converged no_equilibrium",
    }
    return xr.Dataset(
        {"status": (dims, status, flags), "max_inner_load": (dims, values, {"units": "N"})},
        coordinates,
        {"title": "By hand", "study": "{}"},
    )


def strict(text: str) -> Any:
    def refuse(constant: str) -> None:
        raise AssertionError(f"{constant} in JSON")

    return json.loads(text, parse_constant=refuse)


def test_the_report_of_a_result_tells_failures_first(run: Run) -> None:
    given = dataset()
    given.to_netcdf("result.nc", engine="h5netcdf")
    code, out, err = run("result.nc")
    assert (code, err) == (0, "")
    lines = out.splitlines()
    assert lines[0] == "By hand"
    assert "7 of 1000 samples have no result (0.7 %): there is no equilibrium 7" in lines[3]
    (row,) = [line.split() for line in lines if line.startswith("  max_inner_load ")]
    band = tolerance_bands(given)["max_inner_load"]
    found = [float(cell) for cell in row[1:5]]
    expected = [*band.percentile[1:4], band.standard_deviation]
    np.testing.assert_allclose(found, expected, atol=0.06)
    assert row[5] == "N"


def test_the_inputs_are_ranked_with_bars(run: Run) -> None:
    given = dataset()
    given.to_netcdf("result.nc", engine="h5netcdf")
    _, out, _ = run("result.nc")
    rows = [line.split() for line in out.splitlines() if "█" in line]
    assert [row[0] for row in rows] == ["fz", "contact_angle"]
    ranks = rank_correlation(given)["max_inner_load"]
    assert float(rows[0][1]) == pytest.approx(ranks.coefficient[0], abs=0.006)
    assert float(rows[1][1].replace("−", "-")) == pytest.approx(ranks.coefficient[1], abs=0.006)
    assert len(rows[0][-1]) > len(rows[1][-1])


def test_a_study_file_is_run(run: Run) -> None:
    code, out, err = run("study.toml")
    assert (code, err) == (0, "")
    assert "600 samples of 2 inputs" in out
    assert "all samples have a result" in out
    ranks = out[out.index("Rank correlation") :].split("\n  mz\n")
    assert "fz" in ranks[0]
    assert ranks[1].strip() == "does not vary"


def test_indices_of_a_study_file_stand_beside_it(run: Run) -> None:
    code, out, _ = run("study.toml", "--sobol", "64")
    assert code == 0
    assert "Sobol indices from 256 runs, 95 % interval" in out
    indices = out[out.index("Sobol") :]
    rows = [line.split() for line in indices[indices.index("max_inner_load") :].splitlines()]
    first = next(row for row in rows if row[:1] == ["fz"])
    assert 0.5 < float(first[1]) < 1.1


def test_the_report_speaks_portuguese(run: Run) -> None:
    dataset().to_netcdf("result.nc", engine="h5netcdf")
    _, out, _ = run("result.nc", "--lang", "pt")
    assert "7 de 1000 amostras não têm resultado (0,7 %)" in out
    assert "Correlação de postos" in out


def test_json_holds_everything(run: Run) -> None:
    given = dataset()
    given.to_netcdf("result.nc", engine="h5netcdf")
    code, out, err = run("--json", "result.nc")
    assert (code, err) == (0, "")
    data = strict(out)
    assert data["kind"] == "tolerance"
    assert (data["samples"], data["without_result"]) == (1000, 7)
    assert data["failures"] == {"no_equilibrium": 7}
    assert data["percentiles"] == [0.135, 5.0, 50.0, 95.0, 99.865]
    band = tolerance_bands(given)["max_inner_load"]
    one = data["outputs"]["max_inner_load"]
    assert one["percentile"] == pytest.approx(list(band.percentile))
    assert one["low"][0] is None  # open: too few samples below it
    assert one["count"] == 993
    ranks = data["rank_correlation"]
    assert ranks["inputs"] == ["fz", "contact_angle"]
    found = ranks["outputs"]["max_inner_load"]["coefficient"]
    assert found == pytest.approx(list(rank_correlation(given)["max_inner_load"].coefficient))
    assert data["inputs"]["fz"] == {"field": "duty.load.fz", "units": "N"}


def test_percentiles_are_asked_for(run: Run) -> None:
    dataset().to_netcdf("result.nc", engine="h5netcdf")
    _, out, _ = run("result.nc", "--percentiles", "90, 10")
    (heads,) = [line.split() for line in out.splitlines() if "std. dev." in line]
    assert heads[:4] == ["10", "%", "90", "%"]


def test_every_point_of_the_axes_has_its_part(run: Run) -> None:
    dataset(speeds=2).to_netcdf("result.nc", engine="h5netcdf")
    code, out, _ = run("result.nc")
    assert code == 0
    assert "inner_speed = 1000 rpm" in out
    assert "inner_speed = 2000 rpm" in out
    assert out.count("Percentiles of the outputs") == 2


def test_more_points_than_a_page_takes_go_to_json(run: Run) -> None:
    dataset(speeds=21, count=60).to_netcdf("result.nc", engine="h5netcdf")
    code, _, err = run("result.nc")
    assert code == 2
    assert "make 21 points" in err
    code, out, _ = run("result.nc", "--json")
    assert code == 0
    assert np.shape(strict(out)["outputs"]["max_inner_load"]["percentile"]) == (5, 21)


def test_a_figure_is_drawn(run: Run, tmp_path: Path) -> None:
    dataset().to_netcdf("result.nc", engine="h5netcdf")
    code, _, _ = run("result.nc", "--plot", "bands.png")
    assert code == 0
    assert (tmp_path / "bands.png").read_bytes().startswith(b"\x89PNG")


def test_without_any_result_the_exit_code_says_so(run: Run) -> None:
    dataset(failed=1000).to_netcdf("result.nc", engine="h5netcdf")
    code, out, _ = run("result.nc")
    assert code == 1
    assert "1000 of 1000 samples have no result (100 %)" in out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("nothing.nc",), "cannot be opened"),
        (("case.toml",), "case.toml"),
        (("result.nc", "--percentiles", "5,x"), "must be a number"),
        (("result.nc", "--percentiles", "0,5"), "between 0 and 100"),
        (("result.nc", "--sobol", "64"), "needs the study file"),
        (("study.toml", "--sobol", "65"), "power of two"),
        (("result.nc", "--plot", "x.gif"), "must end in .png, .svg or .pdf"),
        (("result.nc", "--json", "result.nc"), "is one of the input files"),
        (("sweep.nc",), "has no scatter"),
        (
            ("axes.nc", "--plot", "x.png"),
            "has axes besides its samples; a figure of tolerance bands",
        ),
    ],
)
def test_wrong_input_is_one_message(run: Run, arguments: tuple[str, ...], words: str) -> None:
    dataset().to_netcdf("result.nc", engine="h5netcdf")
    dataset().rename(sample="speed").to_netcdf("sweep.nc", engine="h5netcdf")
    dataset(speeds=2, count=50).to_netcdf("axes.nc", engine="h5netcdf")
    code, out, err = run(*arguments)
    assert (code, out) == (2, "")
    assert words in err
    assert err.startswith("rolamento: ")
    assert err.count("\n") == 1


def test_a_study_without_scatter_is_refused(run: Run, tmp_path: Path) -> None:
    text = 'case = "case.toml"\n[[axes]]\nfield = "duty.load.fx"\nvalues = ["1 kN", "2 kN"]\n'
    (tmp_path / "sweep.toml").write_text(text, encoding="utf-8")
    code, _, err = run("sweep.toml")
    assert code == 2
    assert "nothing to take percentiles of" in err


def test_the_example_of_the_guide_runs(run: Run) -> None:
    guide = Path(__file__).resolve().parents[2] / "docs" / "tolerance.md"
    (block,) = re.findall(r"```python\n(.*?)```", guide.read_text("utf-8"), re.DOTALL)
    dataset().rename(max_inner_load="max_inner_max_pressure").to_netcdf(
        "result.nc", engine="h5netcdf"
    )
    names: dict[str, Any] = {}
    exec(compile(block, "example", "exec"), names)
    assert names["indices"].runs == 1024 * 4
