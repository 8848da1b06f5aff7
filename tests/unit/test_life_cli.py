"""`rolamento life`: what it prints and writes, how it ends, and what wrong input is told."""

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

import rolamento
from rolamento import load_case
from rolamento.cli.app import app
from rolamento.life import life, sensitivity
from rolamento.solution import solve
from rolamento.tasks.life import life_of_shaft
from rolamento.tasks.life_spectrum import life_of_duty_spectrum, read_spectrum

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = Path(rolamento.__file__).parent / "examples"
FILES = ("6305_life.toml", "6305_steps.csv", "6012_pair.toml", "218_combined.toml")
CASE = "6305_life.toml"
UNSOLVABLE = ("--set", "bearing.contact_angle=30 deg", "--set", "duty.load.fx=0 N")

Outcome = tuple[int, str, str]
Run = Callable[..., Outcome]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """Run the command in a directory that holds the examples."""
    monkeypatch.chdir(tmp_path)
    for name in FILES:
        (tmp_path / name).write_text((EXAMPLES / name).read_text("utf-8"), encoding="utf-8")

    def runner(*arguments: str, command: str = "life", given: str | None = None) -> Outcome:
        environment = {"LC_ALL": "C.UTF-8", "COLUMNS": "80"}
        result = CliRunner().invoke(app, [command, *arguments], input=given, env=environment)
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result.exit_code, result.stdout, result.stderr

    return runner


def strict(text: str) -> Any:
    def refuse(constant: str) -> None:
        raise AssertionError(f"{constant} in JSON")

    return json.loads(text, parse_constant=refuse)


def table(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(text)))


# --- a case -----------------------------------------------------------------------------------


def test_a_case(run: Run) -> None:
    code, out, err = run(CASE)
    assert (code, err) == (0, "")
    headings = [line for line in out.splitlines() if re.match(r"[A-Z][a-z ]+$", line)]
    assert headings == [
        "Caution",
        "Life",
        "Life by theory",
        "Scope of each theory",
        "Ratings and loads",
        "What limits it",
        "What would help",
        "Friction",
        "Notes",
    ]
    assert re.search(r"power loss +[\d.]+ +W", out)
    assert "is not published; it is estimated" in out
    assert "rolamento life" not in out


def test_in_portuguese(run: Run) -> None:
    code, out, _ = run(CASE, "--lang", "pt")
    assert code == 0
    assert "Com 90 % de confiabilidade este rolamento atinge" in out
    assert "\nO que ajudaria\n" in out


def test_json_is_what_the_engine_says(run: Run) -> None:
    code, out, err = run(CASE, "--json")
    assert (code, err) == (0, "")
    data = strict(out)
    state = solve(load_case(CASE))
    found = life(state)
    assert data["kind"] == "life"
    assert data["life"] == json.loads(json.dumps(found.to_mapping()))
    assert [entry["change"] for entry in data["sensitivity"]] == [
        change.name for change in sensitivity(state)
    ]
    assert data["life"]["required_life"]["reliability"] == pytest.approx(
        float(found.reliability_after(5000.0 * 3600.0)[0])
    )
    assert data["notes"] == [note.to_mapping() for note in state.notes[0]]


def test_solve_has_the_same_life(run: Run) -> None:
    theories = [
        strict(run(CASE, "--json", command=command)[1])["life"]["theories"]
        for command in ("life", "solve")
    ]
    assert theories[0] == theories[1]
    assert "With 90 % reliability this bearing reaches" in run(CASE, command="solve")[1]


def test_a_case_that_does_not_ask_for_life_gets_it(run: Run) -> None:
    assert strict(run("218_combined.toml", "--json", command="solve")[1])["life"] is None
    code, out, _ = run("218_combined.toml")
    assert code == 0
    assert "from the geometry, ISO 281" in out


def test_reliability(run: Run) -> None:
    hours = {}
    for s in ("0.9", "0.95"):
        data = strict(run(CASE, "--reliability", s, "--json")[1])
        hours[s] = data["life"]["theories"]["iso281"]["hours"]
        assert data["life"]["theories"]["iso281"]["reliability"] == float(s)
    assert hours["0.95"] / hours["0.9"] == pytest.approx(0.64, abs=0.005)  # ISO 281, table 12


def test_a_chart_of_the_user(run: Run) -> None:
    Path("chart.csv").write_text("kappa,1e-3,10\n0.1,2,2\n10,2,2\n", encoding="utf-8")
    code, out, _ = run(
        CASE, "--nsk-table", "chart.csv", "--set", "life.nsk_cleanliness=0.8", "--json"
    )
    assert code == 0
    theories = strict(out)["life"]["theories"]
    assert theories["l_able"]["factors"]["a_nsk"] == pytest.approx(2.0)
    assert theories["l_able"]["hours"] == pytest.approx(2.0 * theories["iso281"]["hours"])


def test_the_case_may_come_from_standard_input(run: Run) -> None:
    assert run("-", given=Path(CASE).read_text("utf-8"))[1] == run(CASE)[1]


def test_without_load_there_is_no_life(run: Run) -> None:
    settings = ("duty.load.fz=0 N", "duty.load.fx=0 N")
    code, out, _ = run(CASE, *(part for text in settings for part in ("--set", text)), "--json")
    found = strict(out)["life"]
    assert code == 0
    for record in (found["headline"], *found["theories"].values()):
        assert (record["life"], record["hours"]) == (None, None)
        assert (record["unlimited"], record["valid"], record["upper_bound"]) == (
            False,
            False,
            False,
        )
    assert found["headline"]["reason"]["key"] == "unloaded"
    assert found["limit"]["race"] is None


# --- no result, no theory ---------------------------------------------------------------------


def test_without_equilibrium_there_is_no_life(run: Run) -> None:
    code, out, err = run(CASE, *UNSOLVABLE)
    assert (code, err) == (1, "")
    assert "there is no equilibrium" in out
    assert "\nLife\n" not in out
    code, out, err = run(CASE, *UNSOLVABLE, "--json")
    assert code == 1
    assert strict(out)["life"] is None
    assert err.startswith("rolamento: there is no equilibrium: Nothing supports")


@pytest.mark.parametrize(
    ("settings", "said"),
    [
        (("life.viscosity_ratio=0.05",), "κ is below 0.1, where the standard gives no factor"),
        (("duty.load.fz=12 kN",), "exceeds half of the dynamic load rating"),
        (("temperature.lubricant=130 degC",), "exceed 120 °C, the limit"),
        (("life.contamination=0",), "wear, not fatigue, ends the life"),
        (
            ("duty.load.fz=12 kN", "life.nsk_cleanliness=0.8"),
            "permanent indentations are to be expected",
        ),
    ],
)
def test_a_theory_that_does_not_hold_is_told(
    run: Run, settings: tuple[str, ...], said: str
) -> None:
    code, out, err = run(CASE, *(part for text in settings for part in ("--set", text)))
    assert (code, err) == (0, "")
    text = " ".join(out.split())
    assert said in text
    assert "not valid (" in text


# --- several bearings -------------------------------------------------------------------------


def test_a_shaft(run: Run) -> None:
    Path("right.toml").write_text(
        Path(CASE).read_text("utf-8").replace('fz = "2 kN"', 'fz = "3 kN"'), encoding="utf-8"
    )
    code, out, err = run(CASE, "right.toml", "--json")
    assert (code, err) == (0, "")
    data = strict(out)
    hours = [b["life"]["theories"]["iso281"]["hours"] for b in data["bearings"]]
    together = data["together"]["iso281"]["hours"]
    # reliabilities multiply: (t/L)^(10/9) add up
    assert sum((together / own) ** (10.0 / 9.0) for own in hours) == pytest.approx(1.0)
    assert together < min(hours)
    code, out, _ = run(CASE, "right.toml")
    assert code == 0
    assert "Bearing 2 limits it" in out
    assert "right.toml" in out  # of one title, the files tell them apart


def test_equal_bearings_on_a_shaft() -> None:
    case = load_case(EXAMPLES / CASE)
    found = life_of_shaft([case] * 3)
    for theory, together in found.theories.items():
        own = together.bearing_hours[0]
        assert together.hours == pytest.approx(own * 3.0**-0.9), theory
        assert found[theory].risk == pytest.approx(np.full(3, 1.0 / 3.0))


def test_a_shaft_with_a_bearing_without_equilibrium(run: Run) -> None:
    code, out, err = run(CASE, "218_combined.toml", "--set", "duty.load.fx=-5 kN")
    assert (code, err) == (1, "")
    assert "bearing 2: there is no equilibrium" in out
    code, out, err = run(CASE, "218_combined.toml", "--set", "duty.load.fx=-5 kN", "--json")
    assert code == 1
    assert strict(out)["together"]["iso281"]["hours"] is None
    assert err.count("\n") == 1


def test_a_set_and_a_bearing_on_one_shaft(run: Run) -> None:
    code, out, _ = run(CASE, "6012_pair.toml")
    assert code == 0
    assert "the 2 bearings together reach" in out


# --- a spectrum -------------------------------------------------------------------------------


def test_a_spectrum(run: Run) -> None:
    code, out, err = run(CASE, "--spectrum", "6305_steps.csv")
    assert (code, err) == (0, "")
    found = life_of_duty_spectrum(load_case(CASE), read_spectrum("6305_steps.csv"))
    damage = 100.0 * found["iso16281_modified"].damage
    assert f"Step 3 contributes most: {damage[2]:.3g} % of the damage in 10 % of the time." in out
    rows = re.findall(r"^ +(\d) .*?(\d+\.\d)(?: +[█▏▎▍▌▋▊▉]*)?$", out, re.MULTILINE)
    assert rows[-3:] == [(str(n + 1), f"{damage[n]:.1f}") for n in range(3)]


def test_data_of_a_spectrum(run: Run) -> None:
    code, out, _ = run(CASE, "--spectrum", "6305_steps.csv", "--json", "s.json", "--csv", "-")
    assert code == 0
    data, rows = strict(Path("s.json").read_text("utf-8")), table(out)
    assert data["kind"] == "life_spectrum"
    assert [row["duty.load.fz"] for row in rows] == ["1 kN", "2 kN", "4 kN"]
    assert [float(row["time_share_percent"]) for row in rows] == [50.0, 40.0, 10.0]
    for name in ("iso281", "iso16281_modified"):
        damage = data["theories"][name]["damage"]
        assert sum(damage) == pytest.approx(1.0)
        written = [float(row[f"{name}_damage_percent"]) / 100.0 for row in rows]
        assert written == pytest.approx(damage)
    assert data["steps"]["values"]["duty.load.fz"] == [1000.0, 2000.0, 4000.0]


def test_a_spectrum_with_a_step_without_equilibrium(run: Run) -> None:
    Path("s.csv").write_text("share,duty.load.fx\n.5,20 kN\n.5,-20 kN\n", encoding="utf-8")
    code, out, _ = run("218_combined.toml", "--spectrum", "s.csv")
    assert code == 1
    assert "Without a result of every step there is no life." in out
    assert "step 2 (line 3): there is no equilibrium" in out


# --- over a field -----------------------------------------------------------------------------


def test_over_a_field(run: Run) -> None:
    code, out, err = run(
        CASE, "--over", "duty.load.fz=1..12kN", "--points", "4", "--plot", "c.svg",
        "--csv", "c.csv", "--json", "c.json", "--variant", "life.contamination=0.8",
    )  # fmt: skip
    assert (code, err) == (0, "")
    assert "Life over radial load Fz" in out
    assert "with contamination factor e_C = 0.8" in out
    rows, data = table(Path("c.csv").read_text("utf-8")), strict(Path("c.json").read_text("utf-8"))
    assert [row["variant"] for row in rows] == [""] * 4 + ["life.contamination=0.8"] * 4
    assert data["field"] == "duty.load.fz"
    for number, curve in enumerate(data["curves"]):
        own = rows[4 * number : 4 * number + 4]
        for name, theory in curve["theories"].items():
            assert [float(row[f"{name}_h"]) for row in own] == pytest.approx(theory["hours"])
            assert [row[f"{name}_valid"] == "yes" for row in own] == theory["valid"]
    assert Path("c.svg").read_text("utf-8").lstrip().startswith("<?xml")


def test_over_a_field_where_some_points_have_no_result(run: Run) -> None:
    arguments = (CASE, "--over", "mounting.shaft_interference=0..500um", "--points", "3")
    code, out, _ = run(*arguments)
    assert code == 1
    assert "2 of 3 points without a result: invalid input" in out
    code, out, err = run(*arguments, "--csv", "-")
    assert code == 1
    assert [row["iso281_h"] != "" for row in table(out)] == [True, False, False]
    assert err == "rolamento: 2 / 3: invalid input\n"


# --- wrong input ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("settings", "said"),
    [
        (("life.cleanliness=17/14",), "is not an ISO 4406 code"),
        (("life.cleanliness=-/30/27",), "has a number above 28"),
        (("life.cleanliness=-/24/21",), "life.cleanliness = \"-/24/21\": is dirtier than"),
        (("life.contamination=0.5", "life.oil_supply=bath"), "needs cleanliness"),
        (("life.filter_size=12 um",), "life.filter_ratio: is missing; filter_size needs it"),
        (("life.filter_size=90 um", "life.filter_ratio=2"), "is coarser than the last filter"),
        (("life.grease_cleanliness=norml",), "must be one of high, normal"),
        (("life.contamination=0.5", "life.grease_cleanliness=high"), "cannot be combined with con"),
        (("life.contamination=2",), "must be at least 0 and at most 1"),
        (("life.clealiness=x",), "did you mean cleanliness?"),
        (("life.dynamic_rating=20",), "needs a unit"),
        (("life.dynamic_rating=-5 kN",), "must be greater than 0 N"),
        (("life.required_life=20000",), "needs a unit"),
        (("life.edition=1991",), "must be one of 2007, 1990"),
        (("life.nsk_cleanliness=0.01",), "at least 0.05"),
        (("bearing.designation=6305/C7",), "names no clearance class"),
        (("bearing.designation=9999",), "is in no catalogue"),
        (("bearing.contact_angle=60 deg", "duty.load.fx=9 kN"), 'kind = "thrust"'),
        (("mounting.bore=30 mm",), "must be 25 mm, the value of 6305/C3"),
        (("mounting.shaft_interference=0.9 mm",), "closes the bearing"),
        (("mounting.shaft_tolerance=zz9",), "must be one of"),
        (("temperature.lubricant=500 degC",), "at most 400 °C"),
    ],
)  # fmt: skip
def test_wrong_values(run: Run, settings: tuple[str, ...], said: str) -> None:
    code, out, err = run(CASE, *(part for text in settings for part in ("--set", text)))
    assert (code, out) == (2, "")
    assert said in err
    assert err.count("\n") == 1
    assert len(err) < 600


def test_both_ways_to_say_how_dirty_in_one_file(run: Run) -> None:
    text = Path(CASE).read_text("utf-8") + "contamination = 0.5\n"
    Path("both.toml").write_text(text, encoding="utf-8")
    code, _, err = run("both.toml")
    assert code == 2
    assert "both.toml, line " in err
    assert "life.cleanliness: cannot be combined with contamination" in err


def test_a_setting_takes_the_place_of_its_rival(run: Run) -> None:
    code, out, _ = run(CASE, "--set", "life.contamination=0.5", "--json")
    assert code == 0
    assert strict(out)["life"]["contamination_factor"] == 0.5
    code, out, _ = run(
        CASE, "--set", "life.filter_size=12 um", "--set", "life.filter_ratio=200", "--json"
    )
    assert code == 0


SMALL = """
[bearing]
ball_count = 7
ball_diameter = "0.8 mm"
pitch_diameter = "4 mm"
diametral_clearance = "5 um"
inner_conformity = 0.52
outer_conformity = 0.53
[mounting]
bore = "2 mm"
outside_diameter = "6 mm"
clearance_class = "C3"
[duty.load]
fz = "5 N"
[life]
"""


def test_a_class_outside_the_table_of_bores(run: Run) -> None:
    Path("small.toml").write_text(SMALL, encoding="utf-8")
    code, out, err = run("small.toml")
    assert (code, out) == (2, "")
    assert "mounting.bore" in err
    assert "over 2.5 mm up to 500 mm" in err


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("none.toml",), "none.toml: cannot be opened"),
        ((CASE, "--reliability", "95"), "--reliability: 95.0: must be at least 0.01"),
        ((CASE, "--reliability", "nan"), '--reliability: "nan": must be a number'),
        ((CASE, "--over", "duty.load.fz=1..8"), "needs a unit"),
        ((CASE, "--over", "duty.load.fz=1..8kN", "--points", "9999"), "must be 2 to 1000"),
        ((CASE, "--over", "life.edition=a..b"), "takes no range"),
        (
            (CASE, "--over", "duty.load.fz=1..8kN", "--spectrum", "6305_steps.csv"),
            "combined with --over",
        ),
        ((CASE, CASE, "--over", "duty.load.fz=1..8kN"), "is for a single case; several are given"),
        ((CASE, "--variant", "life.contamination=1"), "needs --over"),
        ((CASE, "--plot", "x.png"), "needs --over"),
        ((CASE, "--over", "duty.load.fz=1..8kN", "--plot", "x.doc"), "x.doc"),
        ((CASE, "--over", "duty.load.fz=1..8kN", "--csv", "-", "--json"), "only one of"),
        ((CASE, "--spectrum", "none.csv"), "none.csv: cannot be opened"),
        ((CASE, "--spectrum", "6012_pair.toml"), "6012_pair.toml, line "),
        (
            (CASE, "--spectrum", "6305_steps.csv", "--csv", "6305_steps.csv"),
            "one of the input files",
        ),
        (
            (CASE, "--json", "218_combined.toml"),
            "is taken as the FILE of --json; put --json last, or follow",
        ),
        ((CASE, "--nsk-table", "6305_steps.csv"), "life.nsk_cleanliness: is missing"),
        (("-", "--spectrum", "-"), "can be read only once"),
        ((CASE,) * 51, "must be from 2 to 50 on one shaft"),
        ((CASE, "--over", "duty.load.fz=1..2kN", *("--variant", "title=x") * 6), "at most 5"),
    ],
)
def test_wrong_options(run: Run, arguments: tuple[str, ...], said: str) -> None:
    before = {path: path.read_bytes() for path in Path().iterdir()}
    code, out, err = run(*arguments)
    assert (code, out) == (2, "")
    assert said in err
    assert err.count("\n") == 1
    assert {path: path.read_bytes() for path in Path().iterdir()} == before


def test_reliabilities_of_a_shaft_that_differ(run: Run) -> None:
    text = Path(CASE).read_text("utf-8") + "reliability = 0.95\n"
    Path("surer.toml").write_text(text, encoding="utf-8")
    code, _, err = run(CASE, "surer.toml")
    assert code == 2
    assert 'life.reliability = "0.9, 0.95": must be the same for all bearings of a shaft' in err
    assert run(CASE, "surer.toml", "--reliability", "0.98")[0] == 0


# --- what the guides show ---------------------------------------------------------------------


def shown_in(page: str, first: str, last: str) -> list[str]:
    """The indented lines of a page from one that begins so to one that begins so."""
    lines = (ROOT / page).read_text("utf-8").splitlines()
    begin = next(i for i, line in enumerate(lines) if line.startswith(f"    {first}"))
    end = next(i for i in range(begin, len(lines)) if lines[i].startswith(f"    {last}"))
    return [line[4:] for line in lines[begin : end + 1] if line]


def test_the_guide_shows_true_reports(run: Run) -> None:
    Path("left.toml").write_text(Path(CASE).read_text("utf-8"), encoding="utf-8")
    Path("right.toml").write_text(
        Path(CASE).read_text("utf-8").replace('fz = "2 kN"', 'fz = "3 kN"'), encoding="utf-8"
    )
    for arguments, first, last in (
        ((CASE,), "6305/C3 in a gearbox", "    load ratings, and"),
        (("left.toml", "right.toml"), "Life of 2 bearings", "  10/9)"),
        ((CASE, "--spectrum", "6305_steps.csv"), "Life under 3 steps", "  life, ISO/TS 16281"),
    ):
        report = run(*arguments)[1].splitlines()
        shown = shown_in("docs/life.md", first, last)
        assert len(shown) > 8
        true = [line for line in shown if not line.startswith("status")]  # its residual varies
        assert [line for line in true if line not in report] == []


@pytest.mark.parametrize(
    ("page", "language", "first", "last"),
    [
        ("docs/tour.md", "en", "With 90 %", "Reliability at"),
        ("docs/tour.pt-BR.md", "pt", "Com 90 %", "Confiabilidade nas"),
    ],
)
def test_the_tours_show_true_statements(
    run: Run, page: str, language: str, first: str, last: str
) -> None:
    report = [line.strip() for line in run(CASE, "--lang", language)[1].splitlines()]
    assert all(line in report for line in shown_in(page, first, last))


def test_the_guide_shows_the_shipped_files(run: Run) -> None:
    text = (ROOT / "docs" / "life.md").read_text("utf-8")
    (block,) = re.findall(r"```toml\n(.*?)```", text, re.DOTALL)
    assert rolamento.parse_case(block) == load_case(CASE)
    (steps,), (chart,) = (
        re.findall(rf"```\n({first}.*?)```", text, re.DOTALL) for first in ("share", "kappa")
    )
    assert steps == Path("6305_steps.csv").read_text("utf-8").split("\n", 1)[1]
    Path("chart.csv").write_text(chart, encoding="utf-8")
    assert run(CASE, "--nsk-table", "chart.csv", "--set", "life.nsk_cleanliness=0.8")[0] == 0


def test_the_guides_examples_in_python_run(run: Run) -> None:
    text = (ROOT / "docs" / "life.md").read_text("utf-8")
    blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    assert len(blocks) == 2
    for block in blocks:
        exec(compile(block, "example", "exec"), {})
