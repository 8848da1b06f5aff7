"""Results as files: NetCDF, CSV and Parquet hold the same numbers, and bad files are refused."""

from __future__ import annotations

import csv
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from random import Random

import h5netcdf
import numpy as np
import pyarrow.parquet
import pytest
import xarray as xr

import rolamento
from rolamento import Case
from rolamento.errors import FileError
from rolamento.io.foreign import isolated
from rolamento.studies import (
    Axis,
    Distribution,
    Scatter,
    Study,
    load_result,
    parse_study,
    run,
    run_to_file,
    study_to_toml,
)
from rolamento.studies.plan import Part, Plan
from rolamento.studies.runner import _WRITERS, open_result


@pytest.fixture(scope="module")
def study(case_218: Case) -> Study:
    """Axes of numbers, names, switches and pairs; scatter; an output per ball; failures."""
    law = Distribution(distribution="uniform", minimum=0.52, maximum=0.53)
    return Study(
        title='Files, "quoted"',
        case=case_218,
        outputs=("x", "inner_load", "iterations"),
        axes=[
            Axis(name="force", field="duty.load.fx", values=["20 kN", "-20 kN"]),
            Axis(field="model.raceway_control", values=["outer", "none"]),
            Axis(field="model.gyroscopic_moment", values=[True, False]),
            Axis(zipped={"bearing.ball_count": [16, 12], "duty.load.fz": ["1 kN", "2 kN"]}),
        ],
        scatter=Scatter(count=3, fields={"bearing.inner_conformity": law}),
    )


@pytest.fixture(scope="module")
def result(study: Study) -> xr.Dataset:
    return run(study)


@pytest.mark.parametrize("chunk", [5, 48])
def test_netcdf(study: Study, result: xr.Dataset, tmp_path: Path, chunk: int) -> None:
    run_to_file(study, tmp_path / "r.nc", chunk=chunk)
    loaded = load_result(tmp_path / "r.nc")
    xr.testing.assert_allclose(loaded, result, rtol=1e-9)
    assert set(loaded.coords) == set(result.coords)
    assert {"ball_count", "fz", "inner_conformity"} <= set(loaded.coords)
    assert loaded.gyroscopic_moment.dtype == bool
    assert loaded.status.dtype == np.int8
    assert loaded.iterations.dtype == np.int32
    for name in result.variables:
        for key, value in result[name].attrs.items():
            assert np.array_equal(loaded[name].attrs[key], value), (name, key)
    assert parse_study(loaded.attrs["study"]) == study
    assert {k: v for k, v in loaded.attrs.items() if k != "seed"} == {
        k: v for k, v in result.attrs.items() if k != "seed"
    }


def test_what_xarray_writes_loads_too(result: xr.Dataset, tmp_path: Path) -> None:
    result.to_netcdf(tmp_path / "own.nc", engine="h5netcdf")
    xr.testing.assert_equal(load_result(tmp_path / "own.nc"), result)


def test_csv(study: Study, result: xr.Dataset, tmp_path: Path) -> None:
    run_to_file(study, tmp_path / "r.csv", chunk=5)
    with (tmp_path / "r.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 48
    assert list(rows[0])[:10] == [
        "sample", "force [N]", "raceway_control", "gyroscopic_moment", "ball_count", "fz [N]",
        "inner_conformity", "status", "reason", "x [m]",
    ]  # fmt: skip
    x = [float(row["x [m]"] or "nan") for row in rows]
    assert np.allclose(x, result.x.values.ravel(), rtol=1e-9, equal_nan=True)
    assert {row["status"] for row in rows} == {"converged", "no_equilibrium"}
    failed = next(row for row in rows if row["status"] != "converged")
    assert "inner ring" in failed["reason"]
    assert {row["reason"] for row in rows if row["status"] == "converged"} == {""}
    assert failed["x [m]"] == failed["inner_load_3 [N]"] == ""
    assert (rows[0]["raceway_control"], rows[0]["gyroscopic_moment"]) == ("outer", "true")
    assert rows[0]["inner_load_15 [N]"] != ""
    assert next(r for r in rows if r["ball_count"] == "12")["inner_load_15 [N]"] == ""


def test_parquet(study: Study, result: xr.Dataset, tmp_path: Path) -> None:
    run_to_file(study, tmp_path / "r.parquet", chunk=5)
    table = pyarrow.parquet.read_table(tmp_path / "r.parquet")
    assert table.num_rows == 48
    x = table.column("x").to_numpy()
    assert np.allclose(x, result.x.values.ravel(), rtol=1e-9, equal_nan=True)
    assert table.schema.field("x").metadata == {b"units": b"m"}
    record = json.loads(table.schema.metadata[b"rolamento"])
    assert record["sizes"] == study.sizes
    assert parse_study(record["attributes"]["study"]) == study


def test_only_a_study_s_result_is_loaded(tmp_path: Path) -> None:
    path = tmp_path / "r.nc"
    for content in (b"", b"no", b"\x89HDF\r\n\x1a\n" + b"\0" * 500, b"CDF\x01" + b"\xff" * 100):
        path.write_bytes(content)
        with pytest.raises(FileError):
            load_result(path)
    xr.Dataset({"x": ("n", [1.0])}).to_netcdf(path, engine="h5netcdf")
    with pytest.raises(FileError, match="not the result of a study"):
        load_result(path)
    with pytest.raises(FileError, match="no such file"):
        load_result(tmp_path / "none.nc")
    with pytest.raises(FileError):
        load_result(tmp_path)


@pytest.mark.parametrize("storage", [{}, {"zlib": True}])
def test_what_is_loaded_is_what_xarray_reads(
    study: Study, tmp_path: Path, storage: dict[str, bool]
) -> None:
    run_to_file(study, tmp_path / "r.nc")
    with xr.open_dataset(tmp_path / "r.nc", engine="h5netcdf") as opened:
        whole = opened.load()
    whole.to_netcdf(tmp_path / "again.nc", engine="h5netcdf", encoding={"x": storage})
    loaded = load_result(tmp_path / "again.nc")
    xr.testing.assert_identical(loaded, whole)
    for name, variable in whole.variables.items():
        assert loaded[name].dtype.kind.replace("U", "O") == variable.dtype.kind.replace("U", "O")
        for key, value in variable.attrs.items():
            assert type(loaded[name].attrs[key]) is type(value)


@pytest.mark.slow
@pytest.mark.sweep
def test_a_damaged_result_is_refused_in_one_sentence(
    study: Study, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """Wrong bytes, holes and missing ends: no traceback of a library, and an end."""
    run_to_file(study, tmp_path / "r.nc")
    whole, random = (tmp_path / "r.nc").read_bytes(), Random(5)
    refused = 0
    for _ in range(30):
        content = bytearray(whole)
        for _ in range(random.choice((1, 4, 20))):
            place = random.randrange(random.choice((300, 5000, len(whole) - 8)))
            content[place : place + 1] = random.randbytes(1)
        if random.random() < 0.2:
            del content[random.randrange(8, len(content)) :]
        (tmp_path / "damaged.nc").write_bytes(content)
        try:
            load_result(tmp_path / "damaged.nc")
        except FileError as error:
            refused += 1
            assert str(error).isprintable()
            assert len(str(error)) < 500
    assert refused > 10
    assert capfd.readouterr() == ("", "")


def test_a_reader_that_comes_to_no_end(
    study: Study, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run_to_file(study, tmp_path / "r.nc")
    monkeypatch.setattr(isolated, "PATIENCE", 0.5)
    for text in ("import time; time.sleep(60)", "import os; os.abort()"):
        monkeypatch.setattr(isolated, "_PROGRAM", text)
        with pytest.raises(FileError, match="broke off, or came to no end"):
            load_result(tmp_path / "r.nc")


def test_a_small_file_that_claims_to_be_large_is_not_loaded(tmp_path: Path) -> None:
    with h5netcdf.File(tmp_path / "r.nc", "w") as file:
        file.dimensions = {"n": 10**12}
        file.create_variable("x", ("n",), np.float64, chunks=(1000,))
    assert (tmp_path / "r.nc").stat().st_size < 100_000
    with pytest.raises(FileError, match="GB"):
        load_result(tmp_path / "r.nc")


@pytest.mark.parametrize("ending", [".nc", ".csv", ".parquet"])
def test_what_the_disk_refuses_is_told(study: Study, tmp_path: Path, ending: str) -> None:
    plan = Plan(study)
    place = tmp_path / "none" / f"r{ending}"
    with (
        pytest.raises(FileError, match="cannot be written"),
        open_result(place, _WRITERS[place.suffix], plan, {}, ()) as file,
    ):
        file.put(Part(0, plan.empty(48)))


PROGRAM = """
import resource, sys
from pathlib import Path
from rolamento.errors import FileError
from rolamento.studies import load_study, run_to_file, runner

runner._LONGEST_UNWRITTEN = -1.0  # parts in small files
most = int(sys.argv[2])
resource.setrlimit(resource.RLIMIT_FSIZE, (most, resource.RLIM_INFINITY))
try:
    run_to_file(load_study("study.toml"), sys.argv[1], chunk=500)
except FileError as error:
    print(error)
"""


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="needs limits of POSIX")
@pytest.mark.parametrize(
    "ending",
    [".nc", *(pytest.param(other, marks=pytest.mark.sweep) for other in (".csv", ".parquet"))],
)
@pytest.mark.sweep
def test_a_disk_that_fills_up(study: Study, tmp_path: Path, ending: str) -> None:
    """A limit on the size of files stands for a full disk: one sentence, and nothing is lost.

    The HDF5 library used to bring the process down.
    """
    law = Distribution(distribution="uniform", minimum="20 kN", maximum="40 kN")
    scatter = Scatter(count=5000, fields={"duty.load.fx": law})
    small = Study(case=study.case, outputs=("x", "z"), scatter=scatter)
    (tmp_path / "study.toml").write_text(study_to_toml(small), "utf-8")

    def ended(most: int, folder: Path = tmp_path) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, "-c", PROGRAM, f"r{ending}", str(most)],
            cwd=folder,
            env={**os.environ, "PYTHONPATH": str(Path(rolamento.__file__).parents[1])},
            capture_output=True,
            text=True,
        )

    for most in (40_000, 80_000):
        full = ended(most)
        assert (full.returncode, full.stderr) == (0, "")
        assert full.stdout.startswith(f"r{ending}: cannot be written: ")
        assert full.stdout.endswith(f"what was solved is kept in r{ending}.parts\n")
        assert full.stdout.count("\n") == 1
        names = sorted(path.name for path in tmp_path.iterdir())
        assert names == [f"r{ending}.parts", "study.toml"]
        assert len(list((tmp_path / f"r{ending}.parts").glob("part-*.npz"))) == 10
    assert ended(10**9).stdout == ""
    # in a process of its own too: one that compiles its kernels differs in the last bits
    straight = tmp_path / "straight"
    straight.mkdir()
    (straight / "study.toml").write_text(study_to_toml(small), "utf-8")
    assert ended(10**9, straight).stdout == ""
    assert (tmp_path / f"r{ending}").read_bytes() == (straight / f"r{ending}").read_bytes()


def test_a_result_larger_than_the_disk(
    study: Study, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    usage = shutil.disk_usage(tmp_path)
    monkeypatch.setattr(shutil, "disk_usage", lambda path: usage._replace(free=1000))
    with pytest.raises(FileError, match=r"it needs .* MB, and 0.001 MB are free; what"):
        run_to_file(study, tmp_path / "r.nc")
