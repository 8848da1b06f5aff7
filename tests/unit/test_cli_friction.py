"""`rolamento friction`: what it prints, writes and draws, and the exit code that it ends with."""

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
import typer
from typer.testing import CliRunner

from rolamento import InputError, analyse, load_case
from rolamento.cli.requested import program_of
from rolamento.plots.friction import friction_figure
from rolamento.studies.friction_curves import friction_curve, read_range
from rolamento.words import speaking

Run = Callable[..., tuple[int, str, str]]
CASES = ("ricci_fleury.toml", "6305_film.toml", "218_combined.toml")
LOADS = "duty.load.fx=10..200N"
SPEEDS = "duty.inner_speed=0.5..30000rpm"

app = program_of("inside:FrictionRequest", "friction")


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, examples: Path) -> Run:
    """Run the command in a directory that holds case files."""
    monkeypatch.chdir(tmp_path)
    for name in CASES:
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


# --- ranges ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "first", "last"),
    [
        ("duty.load.fx=10..200N", 10.0, 200.0),
        ("duty.load.fx=10N..2kN", 10.0, 2000.0),
        ("duty.load.fx=0.1..2 kN", 100.0, 2000.0),
        (" duty.load.fx = 1e1 N .. 0.2 kN ", 10.0, 200.0),
        ("duty.load.fx=-5..5N", -5.0, 5.0),
        ("duty.inner_speed=30..60rpm", np.pi, 2.0 * np.pi),
        ("lubricant.friction_coefficient=0.05..0.3", 0.05, 0.3),
        ("temperature.lubricant=20..80degC", 293.15, 353.15),
        ("bearing.contact_angle=10deg..0.3rad", np.radians(10.0), 0.3),
    ],
)
def test_a_range_is_read_with_its_units(text: str, first: float, last: float) -> None:
    values = read_range(text, 5).values
    assert len(values) == 5
    assert values[[0, -1]] == pytest.approx([first, last], rel=1e-14)
    np.testing.assert_allclose(np.diff(values), (last - first) / 4.0, rtol=1e-9)


def test_log_has_equal_ratios() -> None:
    values = read_range(SPEEDS, 9, log=True).values
    np.testing.assert_allclose(values[1:] / values[:-1], (60000.0) ** 0.125)


@pytest.mark.parametrize(
    ("text", "points", "log", "words"),
    [
        ("duty.load.fx", 5, False, "FIELD=FIRST..LAST"),
        ("duty.load.fx=10N", 5, False, "FIELD=FIRST..LAST"),
        ("x" * 300, 5, False, "FIELD=FIRST..LAST"),
        ("duty.load.fx=10..200", 5, False, "needs a unit"),
        ("duty.load.fx=10..200rpm", 5, False, "force"),
        ("duty.load.fq=10..200N", 5, False, "duty.load.f"),
        ("bearing.ball_count=3..9", 5, False, "takes no range"),
        ("model.raceway_control=a..b", 5, False, "takes no range"),
        ("bearing.inner_conformity=a..b", 5, False, "must be a number"),
        ("bearing.inner_conformity=0.4..0.6", 5, False, "inner_conformity"),
        ("duty.load.fx=0..200N", 5, True, "must not be zero or change sign"),
        ("duty.load.fx=10..200N", 1, False, "must be 2 to 1000"),
        ("duty.load.fx=10..200N", 10**9, False, "must be 2 to 1000"),
    ],
)
def test_a_wrong_range_is_refused(text: str, points: int, log: bool, words: str) -> None:
    with pytest.raises(InputError, match=re.escape(words)):
        read_range(text, points, log=log)


# --- one case --------------------------------------------------------------------------------


def test_a_case_has_torque_power_and_heat_by_source(run: Run, examples: Path) -> None:
    code, out, err = run("ricci_fleury.toml")
    assert (code, err) == (0, "")
    found = analyse(load_case(examples / "ricci_fleury.toml")).friction
    assert found is not None
    assert re.search(rf"friction torque +{1e3 * found.torque[0]:.3f} +N·mm", out)
    assert re.search(rf"starting torque +{1e3 * found.starting_torque[0]:.3f} +N·mm", out)
    assert "elastic hysteresis" in out
    assert "heat, inner" in out


def test_a_coefficient_stands_for_a_lubricant(run: Run) -> None:
    code, out, _ = run("218_combined.toml", "--coefficient", "0.07")
    assert code == 0
    assert "μ = 0.07" in out
    assert "no: inertia" in out


def test_torque_goes_with_the_coefficient(run: Run) -> None:
    torques = []
    for mu in ("0.05", "0.1"):
        _, out, _ = run("ricci_fleury.toml", "--coefficient", mu, "--hysteresis", "0", "--json")
        torques.append(strict(out)["friction"]["torque"])
    assert torques[1] == pytest.approx(2.0 * torques[0])


def test_json_of_a_case(run: Run) -> None:
    code, out, err = run("ricci_fleury.toml", "--json")
    assert (code, err) == (0, "")
    data = strict(out)
    assert data["kind"] == "friction"
    assert data["friction"]["friction_coefficient"] == 0.17
    assert data["friction"]["models"]["todd"]["valid"] is True


def test_without_a_result_the_reason_is_told(run: Run) -> None:
    code, out, _ = run("ricci_fleury.toml", "--set", "duty.load.fx=-100 N")
    assert code == 1
    assert "there is no equilibrium" in out
    code, out, err = run("ricci_fleury.toml", "--set", "duty.load.fx=-100 N", "--json")
    assert code == 1
    assert strict(out)["friction"] is None
    assert "there is no equilibrium" in err


# --- over a field ----------------------------------------------------------------------------


def test_the_models_keep_their_order_over_load(run: Run) -> None:
    """Ricci and Fleury's bearing, figure 8: what the models are known to differ by."""
    code, out, err = run(
        "ricci_fleury.toml", "--over", LOADS, "--points=9", "--hysteresis=0", "--json"
    )
    assert (code, err) == (0, "")
    data = strict(out)
    assert (data["kind"], data["field"], data["unit"]) == ("friction_curve", "duty.load.fx", "N")
    assert data["values"][0] == 10.0
    assert data["values"][-1] == 200.0
    (curve,) = data["curves"]
    torque = {name: np.array(model["torque"]) for name, model in curve["models"].items()}
    np.testing.assert_allclose(torque["todd"], torque["jones_control"], rtol=5e-3)
    full, simplified = torque["jones_full"], torque["jones_simplified"]
    assert (simplified > 1.05 * torque["jones_control"]).all()
    assert (1.2 * full < simplified).all()
    assert (simplified < 1.6 * full).all()
    assert (full > torque["harris_1971"]).all()
    assert (np.diff(full) > 0.0).all()
    assert all(all(model["valid"]) for model in curve["models"].values())


def test_figure_9_inner_and_outer_ratios_over_speed(run: Run) -> None:
    """At low speed friction shares the spin; the outer race takes control at high speed."""
    code, out, _ = run(
        "ricci_fleury.toml", "--over", SPEEDS, "--log", "--points=12", "--json",
        "--variant", "bearing.outer_conformity=0.57",
    )  # fmt: skip
    assert code == 0
    own, variant = strict(out)["curves"]
    assert (own["label"], variant["label"]) == ("", "bearing.outer_conformity=0.57")
    found = own["friction_control"]
    inner = np.abs(found["inner_spin_to_roll"])
    outer = np.abs(found["outer_spin_to_roll"])
    assert inner[0] == pytest.approx(outer[0], rel=0.01)
    assert inner[-1] > 3.0 * inner[0]
    assert outer[-1] < inner[-1]
    # at low speed a more open outer groove moves the spin there, and costs less torque
    wide = variant["friction_control"]
    assert abs(wide["inner_spin_to_roll"][0]) < inner[0]
    assert abs(wide["outer_spin_to_roll"][0]) > outer[0]
    assert wide["torque"][0] < found["torque"][0]
    assert own["models"]["todd"]["valid"][0] is True
    assert own["models"]["todd"]["valid"][-1] is False
    assert own["models"]["todd"]["reasons"]["inertia"][-1] is True


def test_an_array_is_the_cases_one_by_one(examples: Path) -> None:
    case = load_case(examples / "ricci_fleury.toml")
    curve = friction_curve(case, read_range(LOADS, 3))
    for index, load in enumerate(curve.values):
        loaded = case.replace(duty=case.duty.replace(load={"fx": float(load)}))
        one = analyse(loaded).friction
        assert one is not None
        assert curve.friction.torque[index] == pytest.approx(one.torque[0], rel=1e-6)


def test_a_field_that_needs_cases_of_its_own(examples: Path) -> None:
    case = load_case(examples / "6305_film.toml")
    curve = friction_curve(case, read_range("surface.ball_roughness=0.02..0.2um", 3))
    assert curve.converged
    assert (np.diff(curve.friction.film_parameter) < 0.0).all()
    assert curve.friction.regime.tolist()[-1] == "boundary"
    with pytest.raises(InputError, match="at most 200"):
        friction_curve(case, read_range("surface.ball_roughness=0.02..0.2um", 201))


def test_a_warmer_oil_resists_less(examples: Path) -> None:
    case = load_case(examples / "6305_film.toml")
    curve = friction_curve(case, read_range("temperature.lubricant=40..110degC", 4))
    assert (np.diff(curve.friction.torque_by_source["rolling_resistance"]) < 0.0).all()
    assert (np.diff(curve.friction.film_parameter) < 0.0).all()


def test_a_coefficient_may_be_what_varies(examples: Path) -> None:
    case = load_case(examples / "ricci_fleury.toml")
    curve = friction_curve(
        case, read_range("lubricant.friction_coefficient=0.05..0.2", 3), hysteresis=0.0
    )
    ratio = curve.friction.torque / curve.values
    np.testing.assert_allclose(ratio, ratio[0], rtol=1e-6)


def test_the_table_marks_what_does_not_hold(run: Run) -> None:
    code, out, _ = run("ricci_fleury.toml", "--over", SPEEDS, "--log", "--points", "6")
    assert code == 0
    assert "* the model is not valid there" in out
    assert "inertia not negligible at 30 000 rpm: all models except friction control" in out
    assert "Spin-to-roll ratio over inner ring speed" in out
    assert max(map(len, out.splitlines())) <= 80


def test_the_table_speaks_portuguese(run: Run) -> None:
    _, out, _ = run("ricci_fleury.toml", "--over", SPEEDS, "--log", "--points", "6", "--lang", "pt")
    assert "Torque de atrito por modelo em função de rotação do anel interno" in out
    assert "* o modelo não vale ali" in out
    assert max(map(len, out.splitlines())) <= 80


def test_points_without_a_result_are_told(run: Run) -> None:
    code, out, _ = run("ricci_fleury.toml", "--over", "duty.load.fx=-100..100N", "--points", "4")
    assert code == 1
    assert "2 of 4 points without a result: there is no equilibrium" in out
    code, _, err = run(
        "ricci_fleury.toml", "--over", "duty.load.fx=-100..100N", "--points=4", "--csv", "-"
    )
    assert code == 1
    assert "2 / 4: there is no equilibrium" in err


def test_csv_has_a_line_for_every_point_of_every_curve(run: Run) -> None:
    code, out, _ = run(
        "ricci_fleury.toml", "--over", LOADS, "--points=4", "--csv", "-",
        "--variant", "bearing.outer_conformity=0.57",
    )  # fmt: skip
    assert code == 0
    lines = list(csv.DictReader(io.StringIO(out)))
    assert [line["variant"] for line in lines] == [""] * 4 + ["bearing.outer_conformity=0.57"] * 4
    assert [line["duty.load.fx_N"] for line in lines[:4]] == [
        "10", "73.33333333333334", "136.66666666666669", "200",
    ]  # fmt: skip
    assert {line["status"] for line in lines} == {"converged"}
    assert {line["valid_todd"] for line in lines} == {"yes"}
    assert all(float(line["torque_todd_Nm"]) > 0.0 for line in lines)


@pytest.mark.parametrize(
    ("kind", "mark"), [("png", b"\x89PNG"), ("svg", b"<?xml"), ("pdf", b"%PDF")]
)
@pytest.mark.parametrize("over", [LOADS, SPEEDS])
@pytest.mark.thirds
def test_a_figure_is_drawn(run: Run, tmp_path: Path, kind: str, mark: bytes, over: str) -> None:
    code, out, _ = run(
        "ricci_fleury.toml", "--over", over, "--log", "--points=5", "--plot", f"friction.{kind}"
    )
    assert code == 0
    assert "Todd" in out
    assert (tmp_path / f"friction.{kind}").read_bytes().startswith(mark)


def test_the_figure_shows_the_ratios_over_speed_only(examples: Path) -> None:
    case = load_case(examples / "ricci_fleury.toml")
    assert len(friction_figure([friction_curve(case, read_range(LOADS, 4))]).axes) == 1
    curves = [friction_curve(case, read_range(SPEEDS, 4, log=True))]
    with speaking("pt"):
        above, below = friction_figure(curves).axes
    assert above.get_ylabel() == "Torque de atrito (N·mm)"
    assert below.get_xlabel() == "Rotação do anel interno (rpm)"
    inner = below.get_lines()[0].get_ydata()
    controlled = curves[0].controlled
    assert controlled is not None
    np.testing.assert_array_equal(inner, np.abs(controlled.inner_spin_to_roll))


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("nothing.toml",), "cannot be opened"),
        (("218_combined.toml",), "is missing; the friction calculation needs it"),
        (("218_combined.toml", "--over", LOADS), "is missing; the friction calculation needs it"),
        (("ricci_fleury.toml", "--over", "duty.load.fx"), "FIELD=FIRST..LAST"),
        (("ricci_fleury.toml", "--plot", "f.png"), "needs --over"),
        (("ricci_fleury.toml", "--variant", "bearing.outer_conformity=0.57"), "needs --over"),
        (("ricci_fleury.toml", "--over", LOADS, "--plot", "f.gif"), "must end in .png"),
        (("ricci_fleury.toml", "--over", LOADS, "--json", "--csv", "-"), "only one of"),
        (
            ("ricci_fleury.toml", "--over", LOADS, "--csv", "ricci_fleury.toml"),
            "is one of the input files",
        ),
        (("ricci_fleury.toml", "--coefficient", "2"), "must be from 0 to 1"),
        (("ricci_fleury.toml", "--hysteresis", "nan"), "must be a number"),
        (("ricci_fleury.toml", "--over", LOADS, "--variant", "bearing.q=1"), "bearing.q"),
        (("ricci_fleury.toml", "--over", LOADS, *["--variant", "title=a"] * 6), "at most 5"),
    ],
)
def test_wrong_input_is_one_message(run: Run, arguments: tuple[str, ...], words: str) -> None:
    code, out, err = run(*arguments)
    assert (code, out) == (2, "")
    assert words in err
    assert err.startswith("rolamento: ")
    assert err.count("\n") == 1


GUIDE = (Path(__file__).resolve().parents[2] / "docs" / "friction.md").read_text("utf-8")


@pytest.mark.parametrize("block", re.findall(r"```python\n(.*?)```", GUIDE, re.DOTALL))
def test_the_examples_of_the_guide_run(run: Run, block: str) -> None:
    exec(compile(block, "example", "exec"), {})


def test_the_guide_names_every_option() -> None:
    options = {
        option
        for parameter in typer.main.get_command(app).params
        for option in parameter.opts
        if option.startswith("--") and option != "--help"
    }
    assert options == set(re.findall(r"[|,] `(--[\w-]+)", GUIDE))


def test_the_commands_of_the_guide_run(run: Run, tmp_path: Path) -> None:
    commands = re.findall(r"^    rolamento friction (ricci_fleury.*?[^\\])\n", GUIDE, re.S | re.M)
    assert len(commands) == 3
    for command in commands:
        code, _, err = run(*command.replace("\\", "").split(), "--points", "4")
        assert (code, err) == (0, "")
    assert (tmp_path / "torque.png").exists()
    assert (tmp_path / "speed.png").exists()


def test_what_is_missing_is_given_by_the_options_of_the_command(run: Run) -> None:
    oil = "--lubricant 'ISO VG 68' --temperature '70 degC'"
    for words, field, example in (
        ((), "lubricant.friction_coefficient", oil),
        (("--lubricant", "ISO VG 68"), "temperature.lubricant", "--temperature '70 degC'"),
    ):
        code, _, error = run("6305", "--fr", "1kN", *words)
        assert code == 2
        assert error.startswith(f"rolamento: {field}: is missing")
        assert f"(example: {example})" in error


def test_a_setting_takes_a_decimal_comma_as_every_option_does(run: Run) -> None:
    texts = [
        run("ricci_fleury.toml", "--set", f"bearing.inner_conformity={conformity}")[1]
        for conformity in ("0,53", "0.53")
    ]
    assert texts[0] == texts[1] != run("ricci_fleury.toml")[1]
