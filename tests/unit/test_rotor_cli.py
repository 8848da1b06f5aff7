"""`rolamento rotor`: page, files, refusals."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

import rolamento as ro
from rolamento.cli.app import app
from rolamento.document.terminal import terminal
from rolamento.pages.rotor import vibration_page
from rolamento.rotors import natural_modes
from rolamento.tasks import RotorRequest
from rolamento.vibration.frequencies import frequencies_of

EXAMPLES = Path(ro.__file__).parent / "examples" / "machines"
MOTOR = EXAMPLES / "motor.toml"


def run(*words: str, code: int = 0) -> str:
    done = CliRunner().invoke(app, ["rotor", *words, "--lang", "en"])
    assert done.exit_code == code, done.output
    return str(done.output)


def test_the_page_has_modes_critical_speeds_and_unbalance(tmp_path: Path) -> None:
    """The axial mode is met at 3150 rpm, and the response is sought at the criticals too."""
    files = [tmp_path / name for name in ("campbell.svg", "vibration.json", "modes.csv")]
    text = run(
        str(MOTOR), "--speeds", "0..16000rpm", "--points", "9", "--orders", "1,2",
        "--plot", str(files[0]), "--json", str(files[1]), "--csv", str(files[2]),
    )  # fmt: skip
    for words in (
        "Critical speeds", "axial", "The damping is assumed", "drive end", "order", "to 16 000 rpm",
    ):  # fmt: skip
        assert words in text
    assert all(file.stat().st_size > 200 for file in files)
    mapping = json.loads(files[1].read_text(encoding="utf-8"))
    assert mapping["kind"] == "machine_vibration"
    own = natural_modes(MOTOR).frequency
    assert mapping["modes"]["frequency"] == pytest.approx(own.tolist())
    critical = [one["speed"] for one in mapping["campbell"]["critical"] if one["order"] == 1.0]
    assert len(critical) == 3
    assert set(critical) <= set(mapping["unbalance_response"]["speed"])


@pytest.mark.parametrize("picture", ["modes", "unbalance"])
def test_other_pictures(picture: str, tmp_path: Path) -> None:
    file = tmp_path / "picture.svg"
    run(str(MOTOR), "--points", "3", "--picture", picture, "--plot", str(file))
    assert "<svg" in file.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("--speeds", "5..9"), "with a unit"),
        (("--speeds", "0..5kN"), "with a unit"),
        (("--speeds", "9..3rpm"), "must rise"),
        (("--speeds", "9" * 500), "at most 300 characters"),
        (("--orders", "x"), "--orders"),
        (("--orders", "nan"), "--orders"),
        (("--damping", "-1"), "--damping"),
        (("--modes", "0"), "--modes"),
        (("--points", "1"), "--points"),
        (("--picture", "x"), "campbell, modes, unbalance"),
        (("--shaft", "x"), "rotor shaft"),
        (("--set", "masses=[]", "--picture", "unbalance", "--plot", "x.svg"), "unbalanced"),
    ],
)
def test_what_is_wrong_is_refused(
    words: tuple[str, ...], says: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert says in run(str(MOTOR), *words, "--points" if "--points" not in words else "--modes",
                       "3", code=2).replace("\n", " ")  # fmt: skip
    assert not list(tmp_path.iterdir())


def test_a_machine_that_nothing_holds_says_so(tmp_path: Path) -> None:
    located = 'name = "drive end"'
    text = MOTOR.read_text(encoding="utf-8").replace(located, f'{located}\nlocated = "floating"')
    file = tmp_path / "loose.toml"
    file.write_text(text, encoding="utf-8")
    assert "has no equilibrium" in run(str(file), code=2).replace("\n", " ")


def test_the_nearest_critical_speed_leads() -> None:
    found = RotorRequest(machine=MOTOR, speeds="1000..5000rpm", points=5).run().found
    assert found.nearest is not None
    assert found.nearest.whirl == "axial"
    assert f"{found.nearest.speed * 30.0 / np.pi:.1f}"[:4] in terminal(vibration_page(found))
    quiet = RotorRequest(machine=MOTOR, points=3).run().found
    assert quiet.nearest is None
    assert "No natural frequency meets" in terminal(vibration_page(quiet))


def test_frequencies_of_a_machine_are_those_of_its_parts() -> None:
    """Each bearing's own, under its load; shafts and teeth by their speeds."""
    found = ro.analyse_machine(EXAMPLES / "gear_shaft.toml")
    step = found.hardest_step()
    lines = {(one.part, one.line): one for one in found.frequencies(step)}
    own = frequencies_of(found.solved.bearings["locating"].solved[step])
    assert lines["locating", "ball_pass_outer"].frequency == own.ball_pass_outer.frequency
    assert lines["locating", "ball_pass_outer"].order == pytest.approx(own.ball_pass_outer.order)
    rotation = lines["output shaft", "rotation"]
    assert rotation.order == 1.0
    assert lines["wheel", "mesh"].frequency == pytest.approx(58.0 * rotation.frequency)
    between = {(one.part, one.line): one.order
               for one in ro.analyse_machine(EXAMPLES / "coaxial.toml").frequencies()}  # fmt: skip
    assert between["inner shaft", "rotation"] == pytest.approx(1.5)
    assert between["between", "ball_pass_outer"] > 12.0
