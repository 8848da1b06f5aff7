"""`rolamento turn`: what it prints, writes and draws, and the exit code that it ends with."""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento import load_case
from rolamento.cli.requested import program_of
from rolamento.document.terminal import terminal
from rolamento.io.json import dumps
from rolamento.pages.turn import turn_page
from rolamento.studies.cage_turn import DEFAULT_POINTS, cage_turn

Run = Callable[..., tuple[int, str, str]]
UNSOLVABLE = ("--set", "duty.load.fx=-20 kN")

app = program_of("inside:TurnRequest", "turn")


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, examples: Path) -> Run:
    """Run the command in a directory that holds two case files."""
    monkeypatch.chdir(tmp_path)
    for name in ("218_combined.toml", "209_radial.toml"):
        text = (examples / name).read_text(encoding="utf-8")
        (tmp_path / name).write_text(text, encoding="utf-8")

    def runner(*arguments: str) -> tuple[int, str, str]:
        result = CliRunner().invoke(app, arguments, env={"LC_ALL": "C.UTF-8"})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result.exit_code, result.stdout, result.stderr

    return runner


def strict(text: str) -> Any:
    def refuse(constant: str) -> None:
        raise AssertionError(f"{constant} in JSON")

    return json.loads(text, parse_constant=refuse)


def test_the_report_tells_of_cage_ring_and_ball(run: Run, examples: Path) -> None:
    turned = cage_turn(load_case(examples / "218_combined.toml"), points=64)
    code, out, err = run("218_combined.toml", "--points", "64")
    assert (code, err) == (0, "")
    assert "64 instants of the first ball over 22.5°" in out
    assert f"balls pass under the load at {turned.passage_frequency:.1f} Hz" in out
    assert "peak to peak" in out
    assert f"maximum load           {turned.solved.inner.load.max():.1f}" in out


def test_by_default_as_many_points_as_the_engine_takes(run: Run) -> None:
    assert f"{DEFAULT_POINTS} instants" in run("218_combined.toml")[1]


def test_numbers_of_the_report_are_those_of_the_engine(examples: Path) -> None:
    turned = cage_turn(load_case(examples / "209_radial.toml"), points=32)
    report = terminal(turn_page(turned))
    (line,) = [line for line in report.splitlines() if line.startswith("  y ")]
    variation = turned.variation("displacement")
    extent, first = 1e9 * variation.peak_to_peak[1], 1e9 * abs(variation.harmonics[0, 1])
    cells = line.split()
    assert float(cells[3]) == pytest.approx(extent, rel=1e-3)
    assert float(cells[4]) == pytest.approx(first, rel=1e-3)
    assert cells[-1] == "nm"


def test_at_rest_there_is_no_frequency(run: Run) -> None:
    code, out, _ = run("209_radial.toml")
    assert code == 0
    assert "at rest: no frequency" in out
    assert "Hz" not in out


def test_what_does_not_vary_is_told(run: Run) -> None:
    _, out, _ = run("218_combined.toml", "--set", "duty.load.fz=0 N")
    assert "no variation: the ring does not move while the balls pass" in out


def test_the_report_speaks_portuguese(run: Run, examples: Path) -> None:
    turned = cage_turn(load_case(examples / "218_combined.toml"))
    _, out, _ = run("218_combined.toml", "--lang", "pt")
    frequency = f"{turned.passage_frequency:.1f}".replace(".", ",")
    assert f"as esferas passam sob a carga a {frequency} Hz" in out
    assert "pico a pico" in out


@pytest.mark.parametrize(
    "arguments", [("218_combined.toml", "--json"), ("--json", "--points", "8", "218_combined.toml")]
)
def test_json_goes_to_standard_output_alone(run: Run, arguments: tuple[str, ...]) -> None:
    code, out, err = run(*arguments)
    assert (code, err) == (0, "")
    data = strict(out)
    assert data["kind"] == "cage_turn"
    assert data["status"]["converged"] is True


def test_json_holds_the_turn_in_si(examples: Path) -> None:
    turned = cage_turn(load_case(examples / "218_combined.toml"), points=8)
    data = strict(dumps(turned.to_mapping()))
    np.testing.assert_array_equal(data["angle"], turned.angle)
    np.testing.assert_array_equal(data["displacement"]["values"], turned.solved.displacement.array)
    variation = turned.variation("stiffness")
    waves = np.array(data["stiffness"]["amplitude"]) * np.exp(
        1j * np.array(data["stiffness"]["phase"])
    )
    np.testing.assert_allclose(waves, variation.harmonics, atol=1e-3)
    assert data["orders"] == [16, 32, 48]
    assert data["passage_frequency"] == turned.passage_frequency
    assert len(data["balls"][0]["outer"]["max_pressure"]) == 128


def test_csv_has_a_line_for_every_instant(run: Run, examples: Path) -> None:
    code, out, _ = run("218_combined.toml", "--points=8", "--csv", "-")
    assert code == 0
    lines = list(csv.DictReader(io.StringIO(out)))
    turned = cage_turn(load_case(examples / "218_combined.toml"), points=8)
    assert len(lines) == 8
    assert [line["status"] for line in lines] == ["converged"] * 8
    found = [float(line["z_um"]) for line in lines]
    np.testing.assert_allclose(found, 1e6 * turned.solved.displacement.array[:, 2], rtol=1e-9)
    found = [float(line["ball_15_outer_load_N"]) for line in lines]
    np.testing.assert_allclose(found, turned.solved.outer.load[:, 15], rtol=1e-9)
    found = [float(line["time_ms"]) for line in lines]
    np.testing.assert_allclose(found, 1e3 * turned.time, rtol=1e-9)


@pytest.mark.parametrize(
    ("kind", "mark"), [("png", b"\x89PNG"), ("svg", b"<?xml"), ("pdf", b"%PDF")]
)
@pytest.mark.thirds
def test_a_figure_is_drawn(run: Run, tmp_path: Path, kind: str, mark: bytes) -> None:
    code, out, _ = run("218_combined.toml", "--points", "16", "--plot", f"turn.{kind}")
    assert code == 0
    assert "peak to peak" in out
    assert (tmp_path / f"turn.{kind}").read_bytes().startswith(mark)


def test_without_a_result_the_reason_and_the_advice_are_told(run: Run) -> None:
    code, out, err = run("218_combined.toml", *UNSOLVABLE)
    assert (code, err) == (1, "")
    assert "256 of 256 instants without a result: there is no equilibrium" in out
    assert "advice" in out
    assert "peak to peak" not in out


def test_json_without_a_result_is_written_all_the_same(run: Run) -> None:
    code, out, err = run("218_combined.toml", *UNSOLVABLE, "--json", "--points", "8")
    assert code == 1
    assert "there is no equilibrium" in err
    data = strict(out)
    assert data["status"] == {"converged": False, "codes": ["no_equilibrium"] * 8}
    assert data["displacement"]["values"] == [[None] * 5] * 8
    assert data["cage_speed"]["mean"] is None


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("218_combined.toml", "--points", "2"), "must be an integer from 4 to 4096"),
        (("nothing.toml",), "cannot be opened"),
        (("218_combined.toml", "--plot", "turn.gif"), "must end in .png, .svg or .pdf"),
        (("218_combined.toml", "--json", "--csv", "-"), "only one of"),
        (("218_combined.toml", "--csv", "218_combined.toml"), "is one of the input files"),
        (("218_combined.toml", "--set", "duty.load.fq=1 N"), "duty.load.fq"),
    ],
)
def test_wrong_input_is_one_message(run: Run, arguments: tuple[str, ...], words: str) -> None:
    code, out, err = run(*arguments)
    assert (code, out) == (2, "")
    assert words in err
    assert err.startswith("rolamento: ")
    assert err.count("\n") == 1


def test_the_example_of_the_guide_runs(run: Run, tmp_path: Path) -> None:
    guide = Path(__file__).resolve().parents[2] / "docs" / "cage-turn.md"
    (block,) = re.findall(r"```python\n(.*?)```", guide.read_text("utf-8"), re.DOTALL)
    (tmp_path / "218_combined.toml").rename(tmp_path / "218.toml")
    exec(compile(block, "example", "exec"), {})
    assert (tmp_path / "turn.png").exists()
