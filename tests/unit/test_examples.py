"""The scripts in examples/ run, and what they show is there."""

from __future__ import annotations

import csv
import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = sorted((ROOT / "examples").glob("*.py"))
GALLERY = ROOT / "docs" / "gallery" / "sets"


def loaded(path: Path) -> ModuleType:
    """Import a script as a module: scripts are not a package."""
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def test_every_script_is_tried() -> None:
    assert [path.name for path in SCRIPTS] == ["preload_over_speed.py"]


def test_rigid_and_spring_preload_differ_with_speed(tmp_path: Path) -> None:
    script = loaded(ROOT / "examples" / "preload_over_speed.py")
    curves = script.main(tmp_path)
    rigid, spring = curves["force"], curves["spring"]
    # at rest: one force; the springs leave one row to resist axially
    assert rigid.force[0] == pytest.approx(script.FORCE)
    assert spring.force == pytest.approx(np.full(81, script.FORCE))
    assert rigid.axial_stiffness[0] == pytest.approx(2.0 * spring.axial_stiffness[0], rel=1e-6)
    assert rigid.radial_stiffness[0] == pytest.approx(spring.radial_stiffness[0], rel=1e-6)
    # at speed: the clamped force more than doubles, and with it the stiffness stays
    assert (np.diff(rigid.force) > 0.0).all()
    assert rigid.force[-1] > 2.0 * script.FORCE
    assert rigid.axial_stiffness.min() > 0.8 * rigid.axial_stiffness[0]
    assert spring.axial_stiffness.min() < 0.55 * spring.axial_stiffness[0]
    assert spring.radial_stiffness[-1] < 0.6 * rigid.radial_stiffness[-1]
    assert (tmp_path / "preload_over_speed.png").read_bytes().startswith(b"\x89PNG")

    def table(folder: Path) -> list[list[str]]:
        with open(folder / "preload_over_speed.csv", encoding="utf-8", newline="") as file:
            return list(csv.reader(file))

    written, shown = table(tmp_path), table(GALLERY)
    assert written[0] == shown[0]
    assert len(written) == len(shown) == 82
    # what the gallery shows is what the script gives, but for the last digit
    for new, old in zip(written[1:], shown[1:], strict=True):
        assert np.array(new, float) == pytest.approx(np.array(old, float), abs=0.11)
