"""A case to start from: it solves at once, has every field, and each of them can be woken up."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from typer.testing import CliRunner

from rolamento import solve
from rolamento.case import Case, parse_case
from rolamento.catalogue import catalogue
from rolamento.cli.app import app
from rolamento.errors import InputError
from rolamento.tasks.new_case import TABLES, case_template, file_name
from rolamento.words import speaking

HEADING = re.compile(r"(?:# )?\[([a-z._]+)\]")
FIELD = re.compile(r"(?:# )?([a-z_0-9]+) = ")
DESIGNATIONS = (
    *("6310/C3", "6008", "6212-2Z", "6320", "S 6012 C", "EX 70 25deg", "S 61912 C"),
    *("SKF 6205", "QJ210", "1210", "51210"),
    *("NU 205/C3", "NJ 2210", "30206", "NA 4905"),
)
WOKEN = (
    *("6310/C3", "7014 C/HCP4A DBA", "S 6012 C", "QJ210", "1210", "51210", "3205-BD"),
    *("NU 205/C3", "NA 4905", "30206", "32210 J2/QDB"),
)


@pytest.mark.parametrize("designation", [*DESIGNATIONS, None])
def test_it_solves_at_once(designation: str | None) -> None:
    case = parse_case(case_template(designation))
    assert case.bearing.designation == designation
    assert case.lubricant is not None
    solved = solve(case)
    assert solved.converged.all()
    assert solved.inner.max_pressure.max() < 3.5e9
    if designation is not None:
        assert case.title == designation
        assert 0.05 < (case.duty.load.fz or case.duty.load.fx or 0.0) / 1e3 < 100.0


def fields_in(text: str) -> list[str]:
    table, found = "", []
    for line in text.splitlines():
        if heading := HEADING.fullmatch(line):
            table = f"{heading[1]}."
        elif one := FIELD.match(line):
            found.append(f"{table}{one[1]}")
    return found


def test_it_has_every_field_once() -> None:
    found: list[str] = []
    for designation in ("6310", "NU 205", "30206", "22220 E"):
        own = fields_in(case_template(designation))
        assert len(own) == len({*own})
        found += own
    left = {name for name in Case.fields() if name not in found}
    # what is given by its name as a whole, and the factors of one theory
    whole = (*(f"{name}." for name in Case.fields()), "life.tallian_")
    assert {name for name in left if not name.startswith(whole)} == {
        *("bearing.element", "bearing.outer_raceway_radius", "lubricant")
    }
    assert {*TABLES} >= {name.rpartition(".")[0] for name in found}


def test_balls_have_no_fields_of_rollers_and_rollers_none_of_balls() -> None:
    balls, needles, cones = (
        {*fields_in(case_template(name))} for name in ("6310", "NA 4905", "30206")
    )
    assert not any("roller" in name or "_ribs" in name for name in balls)
    assert not any(name.startswith("bearing.ball") for name in needles | cones)
    assert "model.slices" in needles
    assert "model.raceway_control" not in needles
    assert "bearing.roller_half_angle" in cones - needles
    assert "bearing.inner_ribs" in needles - cones


@dataclass
class Lines:
    """The lines of a template by the names of their fields, to be woken as their comments say."""

    text: list[str]
    place: dict[str, int] = field(default_factory=dict)
    heading: dict[str, int] = field(default_factory=dict)

    def __post_init__(self) -> None:
        table = ""
        for index, line in enumerate(self.text):
            if heading := HEADING.fullmatch(line):
                table = heading[1]
                self.heading[table] = index
            elif found := FIELD.match(line):
                self.place[f"{table}.{found[1]}" if table else found[1]] = index

    @property
    def asleep(self) -> list[str]:
        return [name for name, index in self.place.items() if self.text[index].startswith("# ")]

    def woken(self, name: str) -> str:
        """The file with a field woken, what it goes with too, and what it replaces asleep."""
        text, waiting, awake = list(self.text), [name], set()
        while waiting:
            needed, _, value = waiting.pop().partition(" = ")
            awake.add(needed)
            index = self.place[needed]
            line = text[index].removeprefix("# ")
            text[index] = f"{needed.rpartition('.')[2]} = {value}" if value else line
            table = needed.rpartition(".")[0]
            above = self.heading.get(table)
            if above is not None:
                text[above] = text[above].removeprefix("# ")
            for rival in self._named(line, "; instead of ", table) - awake:
                if rival in self.place and not text[self.place[rival]].startswith("# "):
                    text[self.place[rival]] = f"# {text[self.place[rival]]}"
            waiting += self._named(line, "; with ", table) - awake if needed == name else ()
        return "\n".join(text)

    def _named(self, line: str, words: str, table: str) -> set[str]:
        """The fields that a comment names behind some words, by their full names."""
        named = line.partition(words)[2].partition(";")[0]
        full = {f"{table}.{one}" for one in named.split(", ")} if named else set()
        return {
            one if one.partition(" = ")[0] in self.place else one.removeprefix(f"{table}.")
            for one in full
        }


def every_line_loads(designation: str | None, only: Collection[str] = ()) -> int:
    """Wake every field, or only some, and return how many they were."""
    lines = Lines(case_template(designation).splitlines())
    chosen = [name for name in lines.asleep if not only or name in only]
    for name in chosen:
        try:
            case = parse_case(lines.woken(name))
        except InputError as error:
            pytest.fail(f"{designation}: {name}: {error}")
        assert name == "bearing.designation" or case.bearing.designation == designation
    return len(chosen)


@pytest.mark.parametrize("designation", [*WOKEN, None])
def test_every_line_loads_again_when_it_is_woken(designation: str | None) -> None:
    assert every_line_loads(designation) > 60


@pytest.mark.sweep
@pytest.mark.parametrize("part", range(20))
def test_every_line_of_every_bearing_of_the_catalogue(part: int) -> None:
    """Of what a line shows of the bearing itself; the other lines are those of its kind."""
    own = {name for name in Case.fields() if name.startswith(("bearing.", "mounting.", "life."))}
    kinds: set[object] = set()
    for bearing in catalogue().bearings[part::20]:
        name = bearing.designation
        try:
            template = case_template(name)
        except InputError as error:
            assert "has no inner ring" in str(error)  # its clearance follows from shaft and housing
            continue
        shown = {
            one for one in own
            if one in (lines := Lines(template.splitlines())).place
            and Case.fields()[one].example not in lines.text[lines.place[one]]
        }  # fmt: skip
        every_line_loads(name, () if bearing.kind not in kinds else shown)
        kinds.add(bearing.kind)


@pytest.mark.parametrize("designation", ["7014 C/HCP4A DBA", "6205/HC5C3"])
def test_the_material_of_a_designation_is_a_name(designation: str) -> None:
    assert '# ball_material = "Si3N4"' in case_template(designation)


def test_what_a_bearing_cannot_have_is_left_out() -> None:
    washers, set_of_two = (fields_in(case_template(name)) for name in ("51210", "7014 C/P4A DB"))
    assert not any(name.startswith("mounting.") for name in washers)
    assert "bearing.kind" not in set_of_two
    assert "bearing.kind" in fields_in(case_template("6310"))


def test_what_the_bearing_has_stands_in_the_comments() -> None:
    text = case_template("6310/C3")
    for line in (
        "# ball_count = 8 ",
        '# ball_diameter = "19.05 mm"',
        '# bore = "50 mm"',
        '# dynamic_rating = "62 kN"',
        '# diametral_clearance = "0.027 mm"',
    ):
        assert line in text


def test_axial_load_where_it_is_wanted() -> None:
    assert parse_case(case_template("6310")).duty.load.fx is None
    for designation in ("EX 70 25deg", "S 6012 C"):
        assert parse_case(case_template(designation)).duty.load.fx
    fast, slow = (parse_case(case_template(d)).duty.inner_speed for d in ("S 6012 C", "6012"))
    assert fast > 2.0 * slow


def test_it_is_in_the_language_that_is_spoken() -> None:
    with speaking("pt"):
        text = case_template("6310")
    assert "rotação do anel interno" in text
    assert parse_case(text) == parse_case(case_template("6310"))


@pytest.mark.parametrize(
    ("designation", "name"),
    [
        ("6310/C3", "6310-C3.toml"),
        ("EX 70 25deg", "EX-70-25deg.toml"),
        (None, "case.toml"),
        ("../../etc", "etc.toml"),
        ("/", "case.toml"),
    ],
)
def test_its_name(designation: str | None, name: str) -> None:
    assert file_name(designation) == name


def test_no_such_bearing() -> None:
    with pytest.raises(InputError, match="is in no catalogue"):
        case_template("6299")


def test_the_command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)

    def run(*arguments: str, code: int = 0) -> str:
        result = CliRunner().invoke(app, ["new", *arguments], env={"LC_ALL": "C.UTF-8"})
        assert result.exit_code == code, result.stderr
        return result.stderr if code else result.stdout

    told = "Wrote 6310-C3.toml; now try: rolamento solve 6310-C3.toml\n"
    assert run("6310/C3") == told
    assert (tmp_path / "6310-C3.toml").read_text("utf-8") == case_template("6310/C3")
    assert "already exists; --force overwrites it" in run("6310/C3", code=2)
    assert run("6310/C3", "--force") == told
    assert run("6310/C3", "-o", "-") == case_template("6310/C3")
    assert "must end in .toml" in run("6310", "-o", "case.txt", code=2)
    unknown = run("6299", code=2)
    assert "is in no catalogue" in unknown
    assert "(example: 6310/C3)" in unknown  # as a command line has it, not a file
    (tmp_path / "own.csv").write_text(
        "designation,bore_mm,outside_diameter_mm,width_mm,dynamic_rating_kN,static_rating_kN\n"
        "My-1,50,110,27,62,38.5\n",
        encoding="utf-8",
    )
    assert "rolamento solve My-1.toml --catalogue own.csv" in run("My-1", "--catalogue", "own.csv")
