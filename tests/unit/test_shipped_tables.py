"""The tables that come with the package are read as their TOML files hold them."""

from __future__ import annotations

import json
import tomllib
from importlib import resources
from pathlib import Path

import pytest

from rolamento.io import data

PACKAGE = Path(str(resources.files("rolamento")))
TABLES = sorted(PACKAGE.glob("**/data/*.toml"))


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The data of a package of its own, read anew."""
    monkeypatch.setattr(resources, "files", lambda package: tmp_path)
    data.toml_of.cache_clear()
    (tmp_path / "data").mkdir()
    return tmp_path / "data"


@pytest.fixture(autouse=True)
def _forgotten() -> object:
    yield
    data.toml_of.cache_clear()


@pytest.mark.parametrize("table", TABLES, ids=lambda path: path.stem)
def test_a_table_is_the_same_as_json(table: Path, folder: Path) -> None:
    text = table.read_bytes()
    (folder / "own.toml").write_bytes(text)
    as_toml = data.toml_of("own")
    data.toml_of.cache_clear()
    (folder / "own.json").write_text(data.as_json(text), encoding="utf-8")
    assert repr(data.toml_of("own")) == repr(as_toml) == repr(tomllib.loads(text.decode()))


def test_json_is_read_in_the_place_of_its_text(folder: Path) -> None:
    (folder / "own.toml").write_text("size = 1\n")
    ready = json.loads(data.as_json(b"size = 1\n"))
    (folder / "own.json").write_text(json.dumps(ready | {"tables": {"size": "of the JSON"}}))
    assert data.toml_of("own") == {"size": "of the JSON"}


def test_json_of_another_text_is_passed_over(folder: Path) -> None:
    (folder / "own.toml").write_text("size = 2\n")
    (folder / "own.json").write_text(data.as_json(b"size = 1\n"))
    assert data.toml_of("own") == {"size": 2}
