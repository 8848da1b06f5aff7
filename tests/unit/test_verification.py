"""The verification: verdicts, the run, the report in two languages, the page, the command."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import replace
from decimal import Decimal
from functools import cache
from importlib import resources
from math import inf, isfinite, nan
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from rolamento.cli.optional_value import with_values
from rolamento.cli.requested import program_of
from rolamento.document import Medium
from rolamento.document.cells import cell
from rolamento.document.markdown import markdown
from rolamento.document.terminal import terminal
from rolamento.errors import InputError
from rolamento.pages.verification import COMMAND, term, verification_page
from rolamento.verification import Check, Source, Verification, held_out, registry, run, sources
from rolamento.verification.check import cut, half_unit, rounded
from rolamento.words import Note, speaking

PAGE = Path(__file__).resolve().parents[2] / "docs" / "verification.md"
BOTH = pytest.mark.parametrize("language", ["en", "pt"])
WORDS = Note("verify_harris_cut")
NAMES = {
    "harris_1991",
    "iso_281",
    "iso_16281",
    "campanha_2008",
    "radaelli_2013",
    "case_western",
    "makers",
}


@cache
def everything() -> Verification:
    return run()


def check(**changes: Any) -> Check:
    fields: dict[str, Any] = {
        "source": "Somebody 1950, table 1", "quantity": "Q", "unit": "N", "printed": "12.3",
        "computed": 12.34,
    }  # fmt: skip
    return Check(**(fields | changes))


# --- one number -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("printed", "half"),
    [("12.3", 0.05), ("0.0675", 0.00005), ("4520", 0.5), ("-0.0471", 0.00005), ("1.0217e6", 50.0)],
)
def test_half_a_unit_of_the_last_printed_digit(printed: str, half: float) -> None:
    assert half_unit(printed) == half


@pytest.mark.parametrize("printed", ["", " 1.0", "nan", "inf", "-Infinity", "about 3", "1,5"])
def test_what_is_no_printed_number_is_refused(printed: str) -> None:
    with pytest.raises((ValueError, ArithmeticError)):
        half_unit(printed)


def test_cutting_and_rounding() -> None:
    assert cut(41.4949, "41.494") == 41.494
    assert cut(-41.4949, "41.494") == -41.494
    assert rounded(48.76497, "48.77") == 48.76
    assert rounded(48.76497, "48.77", 1) == 48.765
    assert rounded(2.5, "3") == 3.0
    assert cut(1021696.6, "1.0217e6") == 1021600.0
    assert cut(inf, "1") == inf


@pytest.mark.parametrize(
    ("computed", "verdict"),
    [(12.3, "agrees"), (12.35, "agrees"), (12.25, "agrees"), (12.351, "fails"), (12.249, "fails"),
     (-12.3, "fails"), (nan, "fails"), (inf, "fails")],
)  # fmt: skip
def test_a_number_agrees_within_half_a_digit(computed: float, verdict: str) -> None:
    assert check(computed=computed).verdict == verdict


def test_a_stated_tolerance_takes_the_place_of_half_a_digit() -> None:
    assert check(computed=12.8, tolerance=0.5).verdict == "agrees"
    assert check(computed=12.3, tolerance=0.0).verdict == "agrees"
    assert check(computed=12.34, tolerance=0.0).verdict == "fails"


@pytest.mark.parametrize(
    ("changes", "verdict"),
    [
        ({"explanation": WORDS}, "fails"),
        ({"evidence": 12.3}, "fails"),  # proved, but nobody says what
        ({"explanation": WORDS, "evidence": 12.34, "deviation": 8.0}, "explained"),
        ({"explanation": WORDS, "evidence": 12.34, "deviation": 7.0}, "fails"),
        ({"explanation": WORDS, "evidence": 12.34}, "fails"),
        ({"explanation": WORDS, "evidence": 12.36, "deviation": 8.0}, "fails"),
        ({"explanation": WORDS, "evidence": nan, "deviation": 8.0}, "fails"),
        ({"explanation": WORDS, "corrected": "20.0", "deviation": 8.0}, "explained"),
        ({"explanation": WORDS, "corrected": "20.0", "deviation": 7.0}, "fails"),
        ({"explanation": WORDS, "corrected": "20.0"}, "fails"),
        ({"explanation": WORDS, "corrected": "20.1", "deviation": 8.0}, "fails"),
        ({"corrected": "20.0", "deviation": 8.0}, "fails"),
        ({"explanation": WORDS, "corrected": "20.0", "deviation": 8.0, "evidence": 20.04},
         "explained"),
        ({"explanation": WORDS, "corrected": "20.0", "deviation": 8.0, "evidence": 12.3},
         "fails"),
    ],
)  # fmt: skip
def test_an_explanation_has_to_be_proved(changes: dict[str, Any], verdict: str) -> None:
    assert check(computed=20.0, **changes).verdict == verdict


def test_evidence_that_does_not_hold_spoils_a_number_that_agrees() -> None:
    assert check(explanation=WORDS, evidence=12.3).verdict == "agrees"
    assert check(explanation=WORDS, evidence=13.3).verdict == "fails"


# --- all numbers ----------------------------------------------------------------


def test_no_published_number_fails() -> None:
    assert [c for c in everything().checks if c.verdict == "fails"] == []
    assert everything().passed
    assert len(everything().checks) >= 164


def _wrong(printed: str) -> str:
    """The number with its first digit that is not zero changed, or a one for a zero."""
    place = re.search("[1-9]", printed)
    if place is None:
        return "1000"
    digit = str((int(place[0]) + 3) % 9 + 1)
    return printed[: place.start()] + digit + printed[place.end() :]


def test_every_number_fails_if_it_is_printed_wrong() -> None:
    """No tolerance is so wide, and no explanation so good, that anything may stand there."""
    for found in everything().checks:
        wrong = _wrong(found.printed)
        assert Decimal(wrong) != Decimal(found.printed)
        assert replace(found, printed=wrong).verdict == "fails", found


def test_every_number_fails_if_it_is_not_computed() -> None:
    assert {replace(found, computed=nan).verdict for found in everything().checks} == {"fails"}


def test_every_number_fails_if_it_is_computed_wrong() -> None:
    for found in everything().checks:
        for wrong in (
            0.3 * found.computed - 1.0,
            -found.computed - 1.0,
            1.6 * found.computed + 1.0,
        ):
            assert replace(found, computed=wrong).verdict == "fails", found


def test_every_explained_number_fails_without_what_proves_it() -> None:
    for found in everything().checks:
        if found.verdict == "explained":
            bare = replace(found, evidence=None, corrected="")
            assert bare.verdict == "fails", found
            assert replace(found, explanation=None).verdict == "fails", found


def test_sources_are_found_by_name() -> None:
    assert {source.name for source in sources()} >= NAMES
    one = run(["iso_16281"])
    assert [result.name for result in one.results] == ["iso_16281"]
    both = run(["radaelli-2013", "harris_1991", "radaelli_2013"])
    assert [result.name for result in both.results] == ["harris_1991", "radaelli_2013"]


def test_an_unknown_source_is_refused_with_the_nearest_one() -> None:
    with pytest.raises(InputError, match="did you mean radaelli_2013") as caught:
        run(["radaeli2013"])
    assert (caught.value.field, caught.value.value) == ("source", "radaeli2013")
    with pytest.raises(InputError, match="known: harris_1991, iso_281, iso_16281"):
        run(["zzz"])


def test_progress_is_told_before_each_source() -> None:
    told: list[tuple[str, int, int]] = []
    run(
        ["iso_16281", "case_western"],
        progress=lambda *given: told.append((given[0].name, *given[1:])),
    )
    assert told == [("iso_16281", 0, 2), ("case_western", 1, 2)]


def test_nothing_compared_is_nothing_passed() -> None:
    assert not Verification(()).passed


def test_every_data_file_names_its_source_at_the_top_and_is_used() -> None:
    folder = resources.files("rolamento.verification") / "data"
    files = [file for file in folder.iterdir() if file.name.endswith(".toml")]
    assert {file.name.removesuffix(".toml") for file in files} == {s.name for s in sources()}
    for file in files:
        text = file.read_text(encoding="utf-8")
        assert next(iter(tomllib.loads(text))) == "title"
        assert text.startswith("#")


# --- shown ----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("changes", "written"),
    [
        ({}, ("12.3", "12.34", "+0.04", "0.05", "")),
        ({"computed": 12.3}, ("12.3", "12.30", "0.00", "0.05", "")),
        ({"printed": "-12.3", "computed": -12.34}, ("−12.3", "−12.34", "−0.04", "0.05", "")),
        ({"printed": "1.02e6", "computed": 1021234.0, "evidence": 1018765.0},
         ("1.02e6", "1.021e6", "+1234", "5000", "1.019e6")),
        ({"computed": nan, "corrected": "12.4"}, ("12.3", "–", "–", "0.05", "12.4")),
        ({"tolerance": 1.2345e-5}, ("12.3", "12.34", "+0.04", "0.000012", "")),
        ({"tolerance": 0.0}, ("12.3", "12.34", "+0.04", "0", "")),
    ],
)  # fmt: skip
def test_numbers_are_shown_with_one_digit_more_than_the_print(
    changes: dict[str, Any], written: tuple[str, ...]
) -> None:
    source = registry.SourceResult("x", "Somebody", (check(**changes),))
    (table,) = verification_page(Verification((source,))).tables()
    columns = {column.key: cell(column.values[0]) for column in table.columns}
    names = ("printed", "computed", "difference", "tolerance", "proof")
    assert tuple(columns.get(name, "") for name in names) == written


def _shown_numbers(found: Check) -> Iterator[tuple[float, float]]:
    """What is rounded for the page, and the unit of the last digit shown."""
    unit = 2.0 * half_unit(found.printed) / 10.0
    yield found.computed, unit
    yield found.difference, max(unit, 1.0) if "e" in found.printed else unit
    if found.evidence is not None and not found.corrected:
        yield found.evidence, unit


def test_no_number_shown_hangs_on_the_last_bits_of_a_machine() -> None:
    """Another processor may compute 1e-10 more or less, and would write the same page."""
    for found in everything().checks:
        for value, unit in _shown_numbers(found):
            from_tie = abs((value / unit) % 1.0 - 0.5) * unit
            assert from_tie > 1e-10 * abs(float(found.printed)), found


def shown(found: Verification, language: str = "en", medium: Medium | None = None) -> str:
    with speaking(language):
        return terminal(verification_page(found), medium)


@BOTH
@pytest.mark.parametrize("width", [80, 120])
def test_no_line_is_wider_than_the_medium(language: str, width: int) -> None:
    lines = shown(everything(), language, Medium(width=width)).splitlines()
    assert max(map(len, lines)) == width
    assert all(line == line.rstrip() for line in lines)


@BOTH
def test_the_page_shows_every_number(language: str) -> None:
    text = shown(everything(), language)
    mark = "." if language == "en" else ","
    shown_numbers = set(re.findall(r"[\d.,e]+", text.replace(" ", "").replace("−", " ")))
    shown_numbers |= set(re.findall(r"[\d.,e]+", text))
    for found in everything().checks:
        decimals = len(found.printed.partition("e")[0].partition(".")[2]) + 1
        if "e" not in found.printed and abs(found.computed) < 1e4:
            number = f"{abs(found.computed):.{decimals}f}".replace(".", mark)
            assert number in shown_numbers, found
    agree, explained = (everything().count(verdict) for verdict in ("agrees", "explained"))
    sums = {
        "en": f"{agree + explained} numbers: {agree} agree, {explained} explained, 0 fail",
        "pt": f"{agree + explained} números: {agree} conferem, {explained} explicados, 0 falham",
    }
    assert text.endswith(f"✓ {sums[language]}\n")
    assert "nan" not in text.split()


def test_the_tables_hold_every_number() -> None:
    tables = verification_page(everything()).tables()
    assert sum(len(table.columns[0].values) for table in tables) == len(everything().checks)


def test_every_explanation_is_said_in_portuguese_with_the_same_numbers() -> None:
    for note in {found.explanation for found in everything().checks if found.explanation}:
        english = note.text
        with speaking("pt"):
            portuguese = note.text
        assert english != note.key
        assert portuguese != english
        numbers = re.findall(r"\d+(?:\.\d+)?", english)
        assert re.findall(r"\d+(?:[.,]\d+)?", portuguese) == [n.replace(".", ",") for n in numbers]


def test_citations_and_quantities_are_said_in_portuguese() -> None:
    with speaking("pt"):
        names = {term(text) for c in everything().checks for text in (c.source, c.quantity, c.unit)}
    english = re.compile(r"\b(table|example|text|chapter|race|load|of|the|in|at|ball|cage|turn)\b")
    assert [name for name in names if english.search(name)] == []


def test_a_plain_medium_gets_plain_characters() -> None:
    shown(everything(), "pt", Medium(encoding="ascii")).encode("ascii")


def test_a_failed_number_stands_out() -> None:
    wrong = check(computed=13.0, explanation=WORDS)
    found = Verification((registry.SourceResult("x", "Somebody", (wrong,)),))
    text = shown(found)
    assert "fails [1]" in text
    assert text.endswith("✗ 1 numbers: 0 agree, 0 explained, 1 fail\n")
    assert "\x1b[" in shown(found, medium=Medium(colors=True))


def test_the_page_in_the_documentation_is_up_to_date() -> None:
    written = PAGE.read_text(encoding="utf-8")
    page = markdown(verification_page(everything(), introduction=True))
    assert written == page, f"stale: run {COMMAND}"
    assert "rolamento verify --markdown" in written


def test_json_holds_every_number_and_nothing_that_is_none() -> None:
    def refuse(constant: str) -> None:
        raise AssertionError(constant)

    lost = check(computed=nan, evidence=nan, explanation=WORDS)
    found = Verification((registry.SourceResult("x", "X", (lost,)),))
    mapping = json.loads(found.to_json(), parse_constant=refuse)
    (entry,) = mapping["sources"][0]["checks"]
    assert (entry["computed"], entry["difference"], entry["evidence"]) == (None, None, None)
    assert (entry["printed"], entry["verdict"]) == ("12.3", "fails")
    assert mapping["verdicts"] == {"agrees": 0, "explained": 0, "fails": 1}
    assert mapping["passed"] is False
    whole = json.loads(everything().to_json(), parse_constant=refuse)
    assert whole["numbers"] == len(everything().checks)
    assert all(isfinite(c["computed"]) for s in whole["sources"] for c in s["checks"])


# --- the command ----------------------------------------------------------------


class Outcome:
    def __init__(self, code: int, out: str, err: str) -> None:
        self.code, self.out, self.err = code, out, err


Command = Callable[..., Outcome]


@pytest.fixture
def command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Command:
    """Run the command in an empty directory."""
    monkeypatch.chdir(tmp_path)
    app = program_of("verifying:VerificationRequest", "verify")

    def runner(*arguments: str, **environment: str) -> Outcome:
        result = CliRunner().invoke(app, arguments, env={"LC_ALL": "C.UTF-8", **environment})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return Outcome(result.exit_code, result.stdout, result.stderr)

    return runner


def _only(monkeypatch: pytest.MonkeyPatch, *checks: Check) -> None:
    """Put one source in the place of all."""
    monkeypatch.setattr(registry, "sources", lambda: (Source("one", "One", lambda: checks),))


def test_all_agree_and_the_exit_code_is_0(command: Command) -> None:
    outcome = command()
    assert (outcome.code, outcome.err) == (0, "")
    assert outcome.out == shown(everything())


def test_one_wrong_number_and_the_exit_code_is_1(
    command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    right = everything().checks[-1]
    _only(monkeypatch, right, replace(right, printed=_wrong(right.printed)))
    outcome = command()
    assert outcome.code == 1
    assert outcome.out.endswith("✗ 2 numbers: 1 agree, 0 explained, 1 fail\n")


def test_a_failure_is_told_beside_the_data(
    command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    _only(monkeypatch, check(computed=13.0))
    outcome = command("--json")
    assert (outcome.code, json.loads(outcome.out)["passed"]) == (1, False)
    assert outcome.err == "rolamento: 1 numbers: 0 agree, 0 explained, 1 fail\n"


def test_the_language_is_asked_for(command: Command) -> None:
    assert "veredito" in command("--source", "iso_16281", "--lang", "pt").out
    assert "verdict" in command("--source", "iso_16281", LC_ALL="en_GB.UTF-8").out


def test_files_are_written_beside_the_report(command: Command) -> None:
    outcome = command("--markdown", "page.md", "--json", "all.json")
    assert (outcome.code, outcome.err) == (0, "")
    assert "verdict" in outcome.out
    assert Path("page.md").read_text("utf-8") == PAGE.read_text("utf-8")
    assert json.loads(Path("all.json").read_text("utf-8"))["passed"] is True


def test_the_page_may_go_to_standard_output(command: Command) -> None:
    outcome = command("--markdown", "-", "--source", "case_western")
    assert (outcome.code, outcome.err) == (0, "")
    assert outcome.out.startswith("# Verification\n")
    assert "Harris" not in outcome.out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ("--source", "harris"),
            '--source: "harris": is an unknown source; did you mean harris_1991',
        ),
        (("--json", "--markdown", "-"), "standard output: only one of --json and --markdown can"),
        (("--json", "x", "--markdown", "x"), "x: only one of --json and --markdown can"),
        (("--source", "iso_16281", "--json", "no/such/place"), "no/such/place: cannot be written"),
    ],
)
def test_wrong_input_is_told_in_one_line(
    command: Command, arguments: tuple[str, ...], message: str
) -> None:
    outcome = command(*arguments)
    assert (outcome.code, outcome.out) == (2, "")
    assert message in outcome.err
    assert outcome.err.count("\n") == 1


@pytest.mark.parametrize(
    ("given", "parsed"),
    [
        ([], []),
        (["--json"], ["--json=-"]),
        (["--json", "out.json"], ["--json=out.json"]),
        (["--json", "-"], ["--json=-"]),
        (["--json", "--lang", "pt"], ["--json=-", "--lang", "pt"]),
        (["--lang", "pt", "--json"], ["--lang", "pt", "--json=-"]),
        (["--json=a"], ["--json=a"]),
    ],
)
def test_the_file_of_json_may_be_left_out(given: list[str], parsed: list[str]) -> None:
    assert with_values(given, {"--source", "--markdown", "--lang"}, False) == parsed


def test_what_was_held_out_says_how_much_of_it_holds() -> None:
    for one in held_out():
        assert one.what.text != one.what.key
        assert (one.of is None) == (one.hold is None)
        assert one.within or one.of is not None
        if one.of is not None and one.hold is not None:
            assert 0 < one.hold <= one.of
