"""The command `plot`: what it draws of which file, where it writes, how it ends."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import xarray as xr
from typer.testing import CliRunner

import rolamento as ro
from rolamento.cli.requested import program_of
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.tasks.drawing import Kind

Run = Callable[..., tuple[int, str]]
PNG = b"\x89PNG"
FLAGS = {"flag_values": [0, 1], "flag_meanings": "converged no_equilibrium"}


@pytest.fixture(scope="module")
def state(case_218: ro.Case) -> Solved:
    return solve(case_218)


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, state: Solved) -> Run:
    """Run `plot` in a directory with a state, a failed state and studies."""
    monkeypatch.chdir(tmp_path)
    mapping = {**state.to_mapping(), "case": state.case.to_mapping()}
    Path("state.json").write_text(json.dumps(mapping), encoding="utf-8")
    failed = solve(ro.override(state.case, ["duty.load.fx=-20 kN"]))
    Path("failed.json").write_text(failed.to_json(), encoding="utf-8")
    write_study("sweep.nc", (0, 0, 0))
    write_study("nothing.nc", (1, 1, 1))
    write_samples("samples.nc")
    app = program_of("studying:PlotRequest", "plot")

    def runner(*arguments: str, given: str | None = None) -> tuple[int, str]:
        result = CliRunner().invoke(app, arguments, input=given, env={"LC_ALL": "C.UTF-8"})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result.exit_code, result.stdout + result.stderr

    return runner


def write_study(name: str, status: tuple[int, ...]) -> None:
    xr.Dataset(
        {
            "x": ("fx", [1e-6, 2e-6, 3e-6], {"units": "m"}),
            "z": ("fx", [4e-6, 5e-6, 6e-6], {"units": "m"}),
            "status": ("fx", list(status), FLAGS),
        },
        coords={"fx": ("fx", [1e3, 2e3, 3e3], {"units": "N"})},
        attrs={"title": "a sweep", "study": ""},
    ).to_netcdf(name, engine="h5netcdf")


def write_samples(name: str) -> None:
    values = [float(value) for value in range(40)]
    xr.Dataset(
        {
            "max_inner_load": ("sample", values, {"units": "N"}),
            "status": ("sample", [0] * 40, FLAGS),
        },
        coords={"diametral_clearance": ("sample", [1e-6 * v for v in values], {"units": "m"})},
        attrs={"title": "samples", "study": ""},
    ).to_netcdf(name, engine="h5netcdf")


def test_a_state_is_a_rosette_beside_it(run: Run) -> None:
    assert run("state.json") == (0, "Wrote state.png\n")
    assert Path("state.png").read_bytes().startswith(PNG)
    before = Path("state.png").read_bytes()
    assert run("state.json", "--kind", "rosette")[0] == 0
    assert Path("state.png").read_bytes() == before


@pytest.mark.parametrize("kind", ["rosette", "balls", "angles", "pressures", "ellipses"])
def test_kinds_of_states(kind: str, run: Run) -> None:
    code, out = run("state.json", "--kind", kind, "--output", f"{kind}.svg")
    assert (code, out) == (0, f"Wrote {kind}.svg\n")
    assert "<svg" in Path(f"{kind}.svg").read_text(encoding="utf-8")


LIVING = {"viscosity_ratio": 1.2, "contamination": 0.4}


def write_living(name: str, bearing: ro.Bearing, life: dict[str, Any] | None) -> None:
    """Write the state of a bearing under load, with a life or without."""
    load = ro.Load(fx=8e3) if bearing.contact_angle else ro.Load(fz=3e3)
    duty = ro.Duty(inner_speed=200.0, load=load)
    solved = solve(ro.Case(title="living", bearing=bearing, duty=duty, life=life))
    mapping = {**solved.to_mapping(), "case": solved.case.to_mapping()}
    Path(name).write_text(json.dumps(mapping), encoding="utf-8")


@pytest.mark.parametrize("kind", ["aiso", "sn", "zone", "helps"])
def test_kinds_of_lives(kind: str, run: Run) -> None:
    write_living("living.json", ro.Bearing.named("6305"), LIVING)
    code, out = run("living.json", "--kind", kind, "--output", f"{kind}.svg")
    assert (code, out) == (0, f"Wrote {kind}.svg\n")
    assert "<svg" in Path(f"{kind}.svg").read_text(encoding="utf-8")
    again = run("living.json", "--kind", kind, "--output", "pt.svg", "--lang", "pt")
    assert again[0] == 0
    assert Path("pt.svg").read_bytes() != Path(f"{kind}.svg").read_bytes()


@pytest.mark.parametrize("kind", ["aiso", "sn", "zone", "helps"])
def test_a_failed_state_has_no_life_to_draw(kind: str, run: Run) -> None:
    code, out = run("failed.json", "--kind", kind)
    assert code == 1
    assert "there is no equilibrium" in out
    assert Path("failed.png").read_bytes().startswith(PNG)


@pytest.mark.parametrize(
    ("file", "kind", "message"),
    [
        ("state.json", "sn", "case.life: is missing"),
        ("steep.json", "sn", "such a bearing is rated for axial load"),
        ("angular.json", "zone", "needs a single radial-contact bearing given by its clearance"),
        ("oilless.json", "aiso", '--kind: "aiso": needs a viscosity ratio'),
        ("bare.json", "helps", "case = None: must be a table"),
        ("sweep.nc", "aiso", '--kind: "aiso": does not suit a study; possible: lines, map'),
    ],
)
def test_lives_that_cannot_be_drawn(
    file: str, kind: str, message: str, run: Run, state: Solved
) -> None:
    angular = state.case.bearing
    if file == "steep.json":
        write_living(file, angular.replace(contact_angle=1.1), LIVING)
    elif file == "angular.json":
        write_living(file, angular, LIVING)
    elif file == "oilless.json":
        write_living(file, ro.Bearing.named("6305"), None)
    elif file == "bare.json":
        mapping = {**state.to_mapping(), "case": None}
        Path(file).write_text(json.dumps(mapping), encoding="utf-8")
    code, out = run(file, "--kind", kind, "-o", "figure.png")
    assert code == 2
    assert message in out
    assert not Path("figure.png").exists()


@pytest.mark.parametrize(
    ("file", "kind"),
    [("sweep.nc", "lines"), ("samples.nc", "histogram"), ("samples.nc", "scatter")],
)
def test_kinds_of_studies(file: str, kind: str, run: Run) -> None:
    assert run(file, "--kind", kind, "-o", "figure.pdf") == (0, "Wrote figure.pdf\n")
    assert Path("figure.pdf").read_bytes().startswith(b"%PDF")


def test_every_kind_has_a_place() -> None:
    assert {kind.value for kind in Kind} == {
        "rosette", "balls", "angles", "pressures", "ellipses", "along", "between", "aiso", "sn",
        "zone", "helps", "lines", "map", "histogram", "scatter",
    }  # fmt: skip


def test_a_study_without_a_kind(run: Run) -> None:
    for file, kind in (("sweep", "lines"), ("samples", "histogram")):
        assert run(f"{file}.nc") == (0, f"Wrote {file}.png\n")
        assert run(f"{file}.nc", "--kind", kind, "-o", "same.png")[0] == 0
        assert Path(f"{file}.png").read_bytes() == Path("same.png").read_bytes()


def test_over_makes_a_scatter_plot_of_samples(run: Run) -> None:
    assert run("samples.nc", "--over", "diametral_clearance", "-o", "a.png")[0] == 0
    assert run("samples.nc", "--kind", "scatter", "-o", "b.png")[0] == 0
    assert Path("a.png").read_bytes() == Path("b.png").read_bytes()


def test_variable_is_chosen(run: Run) -> None:
    assert run("sweep.nc", "--variable", "z", "-o", "z.png")[0] == 0
    assert run("sweep.nc", "--variable", "x", "-o", "x.png")[0] == 0
    assert Path("z.png").read_bytes() != Path("x.png").read_bytes()


def test_a_study_is_known_by_its_content(run: Run) -> None:
    Path("sweep.nc").rename("sweep.data")
    assert run("sweep.data") == (0, "Wrote sweep.png\n")


def test_standard_input(run: Run) -> None:
    assert run("-", given=Path("state.json").read_text(encoding="utf-8"))[0] == 0
    assert Path("state.png").exists()


def test_portuguese(run: Run) -> None:
    assert run("state.json", "--lang", "pt", "-o", "pt.svg") == (0, "pt.svg gravado\n")
    assert run("state.json", "-o", "en.svg")[0] == 0
    assert Path("pt.svg").read_bytes() != Path("en.svg").read_bytes()


def test_a_failed_state_is_drawn_and_told(run: Run) -> None:
    code, out = run("failed.json")
    assert code == 1
    assert "Wrote failed.png" in out
    assert "rolamento: No result: there is no equilibrium" in out
    assert Path("failed.png").read_bytes().startswith(PNG)


def test_a_study_of_failures_is_drawn_and_told(run: Run) -> None:
    code, out = run("nothing.nc")
    assert code == 1
    assert "there is no equilibrium" in out
    assert Path("nothing.png").exists()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("state.json", "-o", "figure.gif"), "must end in .png, .svg or .pdf"),
        (("state.json", "-o", "-"), "must end in .png, .svg or .pdf"),
        (("state.json", "-o", "no/figure.png"), "cannot be written"),
        (
            ("state.json", "--kind", "lines"),
            '--kind: "lines": does not suit the JSON of a state; possible: rosette, balls',
        ),
        (("sweep.nc", "--kind", "rosette"), '--kind: "rosette": does not suit a study; possible:'),
        (("state.json", "--variable", "x"), '--variable: "x": is for studies'),
        (("state.json", "--over", "x"), '--over: "x": is for studies'),
        (("sweep.nc", "--variable", "q"), "is not in the study; known: x, z"),
        (("sweep.nc", "--over", "fz"), "is not an axis of x"),
        (("sweep.nc", "--kind", "map"), "needs a study with two axes"),
        (
            ("samples.nc", "--kind", "histogram", "--over", "sample"),
            "cannot be combined with a histogram",
        ),
        (("failed.json", "--kind", "ellipses", "--over", "x"), "is for studies"),
        (("nowhere.json",), "cannot be opened: no such file"),
        ((".",), "is a directory"),
        (("case.toml",), "is not the JSON of a solved state; solve a case first"),
        (("photograph.json",), "photograph.json"),
        (("photograph.nc",), "is not a readable NetCDF file"),
        (("nowhere.nc",), "no such file"),
        (("other.json",), "is not the JSON of a solved state"),
        (("bare.json", "--kind", "ellipses"), "case = None: must be a table"),
    ],
)
def test_wrong_input(arguments: tuple[str, ...], message: str, run: Run, state: Solved) -> None:
    ro.save_case(state.case, "case.toml")
    for ending in ("json", "nc"):
        Path(f"photograph.{ending}").write_bytes(bytes(range(256)))
    Path("other.json").write_text('{"a": 1}', encoding="utf-8")
    bare: dict[str, Any] = {**state.to_mapping(), "case": None}
    Path("bare.json").write_text(json.dumps(bare), encoding="utf-8")
    before = {path.name for path in Path().iterdir()}
    code, out = run(*arguments)
    assert code == 2
    assert message in out
    assert out.count("\n") == 1
    assert {path.name for path in Path().iterdir()} == before


def test_the_result_itself_is_not_overwritten(run: Run) -> None:
    Path("state.png").symlink_to("state.json")
    before = Path("state.json").read_bytes()
    code, out = run("state.json")
    assert code == 2
    assert "is one of the input files" in out
    assert Path("state.json").read_bytes() == before
