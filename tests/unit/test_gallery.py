"""The gallery is made of executed examples."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

from rolamento.tasks.examples import EXAMPLES

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def gallery() -> ModuleType:
    """The script that makes it."""
    spec = importlib.util.spec_from_file_location("gallery", ROOT / "scripts" / "gallery.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_every_example_is_drawn(gallery: ModuleType) -> None:
    scripts = {name for name, example in EXAMPLES.items() if "python" in example.command}
    assert set(gallery.FIGURES) == set(EXAMPLES) - scripts


@pytest.mark.parametrize(
    "name", ["51210_turntable", pytest.param("contact_angles", marks=pytest.mark.sweep)]
)
def test_a_page_has_source_output_and_figures(
    name: str, gallery: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    page, pictures = gallery.executed(name, EXAMPLES[name])
    assert EXAMPLES[name].source(EXAMPLES[name].files[0]).read_text("utf-8").strip() in page
    assert page.count("```") == 4
    assert [path.suffix for path in pictures] == [".png"]
    assert f"({name}-{pictures[0].name})" in page
    cell = gallery.card(name, EXAMPLES[name], [pictures[0].name])
    assert f"]({name}.md)" in cell
    assert gallery.rows([cell] * 4)[-1].count("|") == 4


def test_a_command_that_fails_ends_it(gallery: ModuleType) -> None:
    with pytest.raises(RuntimeError, match="exit code 2: rolamento solve"):
        gallery.done("rolamento solve nowhere.toml")
