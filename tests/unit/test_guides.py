"""What the tutorials show is what the program prints; they run as a reader copies them."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[2]


def _script() -> ModuleType:
    spec = importlib.util.spec_from_file_location("guides", ROOT / "scripts" / "guides.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["guides"] = module
    spec.loader.exec_module(module)
    return module


guides = _script()
PAGES = [pytest.param(page, id=page.stem) for page in guides.PAGES]


@pytest.fixture(autouse=True)
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("page", PAGES)
def test_a_page_begins_as_it_shows(page: Path) -> None:
    """To the first output; the rest is of the sweep."""
    assert guides.run(page, outputs=1).printed


@pytest.mark.sweep
@pytest.mark.parametrize("page", PAGES)
def test_a_page_shows_what_is_printed(page: Path) -> None:
    ran = guides.run(page)
    assert ran.text == page.read_text("utf-8")
    assert guides.unfounded(ran) == []
    for committed, fresh in guides.pictures(ran):
        assert not guides.other_picture(committed, fresh), committed.name


def test_every_tutorial_is_among_them() -> None:
    written = {path.name for path in (ROOT / "docs" / "tutorials").glob("*.md")} - {"index.md"}
    assert written == {page.name for page in guides.PAGES if page.parent.name == "tutorials"}
    folder = ROOT / "docs" / "tutorials" / "pictures"
    pictures = {path.name for path in folder.iterdir()}
    shown = {
        name
        for page in guides.PAGES
        for link, name in guides._PICTURE.findall(page.read_text("utf-8"))
        if (page.parent / link).resolve().parent == folder.resolve()
    }
    assert pictures == shown


# --- how they are compared ----------------------------------------------------------------------

PRINTED = "Head\n\nLife\n  12 300 h, 1.23 million   ████▍\n  of 40\nNotes\n  • none\n"


def test_a_line_may_be_left_out_and_a_last_digit_may_differ() -> None:
    shown = "Head\n…\n  12 301 h, 1.24 million   ███\n…\n  • none\n"
    assert guides.compared(shown, PRINTED, "here") == shown


@pytest.mark.parametrize(
    "shown",
    [
        "  12 305 h, 1.23 million   ████\n",  # another number
        "  12 300 h, 1.25 million\n",
        "  12 300 h, 1.23 billion\n",  # another word
        "Notes\n…\nHead\n",  # another order
        "Head\nLife\n",  # a line left out in silence
    ],
)
def test_a_page_that_has_drifted_is_named(shown: str) -> None:
    with pytest.raises(guides.DriftError, match="here"):
        guides.compared(shown, PRINTED, "here")


def test_outputs_are_renewed_in_place() -> None:
    assert guides.renewed("…\n  11 000 h, 9 million\n…\n", PRINTED, "here") == (
        "…\n  12 300 h, 1.23 million   ████▍\n…\n"
    )
    assert guides.renewed("> Life\n", PRINTED, "here") == (
        "Life\n  12 300 h, 1.23 million   ████▍\n  of 40\nNotes\n  • none\n"
    )


def test_a_number_in_the_prose_stands_in_an_output(tmp_path: Path) -> None:
    text = "Of 12.3 kN or 12 300 h, 40 %, and 7 µm, and 3 mm.\n<!-- known: 3 mm -->\n"
    page = guides.Page(tmp_path / "page.md", text, [PRINTED])
    assert [found.strip() for found in guides.unfounded(page)] == ["7 µm"]
