"""The examples of the Python guides run as they stand (those of the README: test_cli)."""

from __future__ import annotations

import json
import re
import shlex
import shutil
import tomllib
from pathlib import Path

import pytest
from typer.testing import CliRunner

from rolamento.case.machine import (
    Belt,
    Gear,
    Gravity,
    Housing,
    Machine,
    MachineBearing,
    Mass,
    Section,
    Shaft,
    ShaftLoad,
    Spring,
    Step,
    parse_machine,
)
from rolamento.cli.app import app
from rolamento.tasks.examples import EXAMPLES

DOCS = Path(__file__).resolve().parents[2] / "docs"
GUIDES = ["case-file.md", "machine-file.md", "python.md", "report.md", "studies.md"]
BLOCKS = [
    pytest.param(block, id=f"{guide}-{number}")
    for guide in GUIDES
    for number, block in enumerate(
        re.findall(r"```python\n(.*?)```", (DOCS / guide).read_text("utf-8"), re.DOTALL)
    )
]


@pytest.mark.parametrize("block", BLOCKS)
def test_example_runs(
    block: str, examples: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copy(examples / "218_combined.toml", tmp_path / "case.toml")
    shutil.copytree(examples / "machines", tmp_path / "machines")
    monkeypatch.chdir(tmp_path)
    exec(compile(block, "example", "exec"), {})


ROOT = DOCS.parent
FRONT_PAGES = ("README.md", "README.pt-BR.md")


def links_of(page: Path) -> set[str]:
    """The files of the project that a page leads to, without their sections."""
    found = re.findall(r"\]\(([^)#\s]+)", page.read_text("utf-8"))
    return {link for link in found if "://" not in link}


def in_english(links: set[str]) -> set[str]:
    """The same pages by the names of their English texts."""
    return {link.replace(".pt-BR.md", ".md") for link in links}


def test_both_front_pages_lead_to_the_same_pages() -> None:
    english, portuguese = (links_of(ROOT / page) for page in FRONT_PAGES)
    own = {"README.md", "docs/tutorials/maintenance.md"}  # the only tutorial in Portuguese
    assert in_english(english) - own == in_english(portuguese) - own
    assert all((ROOT / link).exists() for link in english | portuguese)
    assert {"docs/tour.md", "docs/index.md"} <= english
    assert {"docs/tour.pt-BR.md", "docs/index.md"} <= portuguese


def test_both_tours_lead_to_the_same_pages() -> None:
    english, portuguese = (links_of(DOCS / page) for page in ("tour.md", "tour.pt-BR.md"))
    assert in_english(english) - {"tour.md"} == in_english(portuguese) - {"tour.md"}
    assert all((DOCS / link).exists() for link in english | portuguese)


def test_both_front_pages_have_the_same_sections_and_commands() -> None:
    shapes = []
    for page in FRONT_PAGES:
        text = (ROOT / page).read_text("utf-8")
        commands = re.findall(r"^ {4}(?:\.venv/bin/)?rolamento (\w+)", text, re.M)
        shapes.append((len(re.findall(r"^## ", text, re.M)), commands))
        for way in ("pipx install .", ".venv\\Scripts\\pip install .", "%pip install ."):
            assert way in text
    assert shapes[0] == shapes[1]


def test_every_guide_is_reached_from_the_index() -> None:
    guides = {path.name for path in DOCS.glob("*.md")} - {"index.md"}
    assert guides <= links_of(DOCS / "index.md")


@pytest.mark.parametrize("page", FRONT_PAGES)
def test_the_front_page_is_short(page: str) -> None:
    """What it is, how to begin, what it is proven against, what it cannot; the rest has pages."""
    assert len((ROOT / page).read_text("utf-8").split()) < 1100


@pytest.mark.parametrize("page", FRONT_PAGES)
def test_a_bearing_by_its_designation_as_the_front_page_has_it(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    text = (ROOT / page).read_text("utf-8")
    blocks = re.findall(r"((?:^ {4}rolamento .*\n)+)", text, re.M)
    lines = [line for block in blocks for line in block.splitlines()]
    assert len(lines) == 4
    for line in lines[:3]:  # the fourth is the app
        words = shlex.split(line, comments=True)
        result = CliRunner().invoke(app, words[1:], env={"LC_ALL": "C.UTF-8"})
        assert result.exit_code == 0, result.output
    assert (tmp_path / "6310-C3.toml").is_file()
    assert (tmp_path / "motor.pdf").read_bytes().startswith(b"%PDF")


MACHINE_PAGE = (DOCS / "machine-file.md").read_text("utf-8")
PLAIN_MACHINE = """
[[shafts]]
name = "shaft"
speed = "1000 rpm"
sections = [{ length = "300 mm", diameter = "40 mm" }]
[[bearings]]
name = "A"
shaft = "shaft"
position = "20 mm"
designation = "6208"
"""


@pytest.mark.parametrize("block", re.findall(r"```toml\n(.*?)```", MACHINE_PAGE, re.DOTALL))
def test_the_machine_file_s_page_shows_valid_tables(block: str) -> None:
    given = tomllib.loads(block)
    machine = parse_machine(json.dumps({**tomllib.loads(PLAIN_MACHINE), **given}))
    assert given.keys() <= machine.to_mapping().keys()


RECORDS = {
    "Top level": Machine, "Shafts": Shaft, "Bearings": MachineBearing, "Housings": Housing,
    "Springs": Spring, "Loads": ShaftLoad, "Gears": Gear, "Belts": Belt, "Masses": Mass,
    "Gravity": Gravity, "Spectrum": Step,
}  # fmt: skip


@pytest.mark.parametrize("heading", RECORDS)
def test_the_machine_file_s_page_has_every_field(heading: str) -> None:
    part = MACHINE_PAGE.partition(f"\n## {heading}\n")[2].partition("\n## ")[0]
    shown = set(
        re.findall(r"`\[{0,2}(\w+)\]{0,2}`", "".join(re.findall(r"^\|[^|]*\|", part, re.M)))
    )
    known = set(RECORDS[heading].model_fields)
    of_files = {"Bearings": {"case"}, "Housings": {"nodes", "others"}}
    known |= {"Shafts": set(Section.model_fields), **of_files}.get(heading, set())
    assert shown == known


def test_the_machine_file_s_page_has_every_example() -> None:
    shown = re.findall(r"^\| `(\w+)` \| `(\w+\.toml)` \|", MACHINE_PAGE, re.M)
    assert sorted(file for _, file in shown) == sorted(
        path.name for path in (ROOT / "src" / "rolamento" / "examples" / "machines").glob("*.toml")
    )
    assert {name for name, _ in shown} <= set(EXAMPLES)
