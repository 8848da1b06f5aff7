"""The table of coupled and independent slices in the documentation is what the program gives."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

from rolamento import solve
from rolamento.life import life
from rolamento.words import speaking

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "slices.py"


@pytest.fixture(scope="module")
def script() -> ModuleType:
    spec = importlib.util.spec_from_file_location("slices_script", SCRIPT)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def test_the_table_is_what_the_program_gives(script: ModuleType) -> None:
    written = script.PAGE.read_text(encoding="utf-8").split(script.BEGIN)[1].split(script.END)[0]
    assert written == script.table()


def test_a_life_of_coupled_slices_says_what_independent_ones_give(script: ModuleType) -> None:
    one = script.Comparison("NU 205", "none", 6e3, moment=6.0)
    independent, coupled = (
        life(solve(one.case(contact)), stress_volume=False) for contact in ("slices", "coupled")
    )
    assert independent.independent is None
    keys = [note.key for note in independent.qualifications()]
    assert "life_of_coupled_slices" not in keys
    (note,) = (n for n in coupled.qualifications() if n.key == "life_of_coupled_slices")
    assert note.values["revolutions"] == pytest.approx(1e6 * independent.headline.life[0])
    assert note.values["life"] == pytest.approx(3600.0 * independent.headline.hours[0])
    assert coupled.headline.life[0] > 2.0 * independent.headline.life[0]
    hours = float(independent.headline.hours[0])
    assert f"{float(f'{hours:.3g}'):g} h" in note.text.replace(" ", "").replace("h,", " h,")
    with speaking("pt"):
        assert "fatias independentes" in note.text


def test_so_does_each_of_many(script: ModuleType) -> None:
    case = script.Comparison("NU 205", "none", 6e3, moment=6.0).case("coupled")
    alone = life(solve(case), stress_volume=False)
    many = life(solve(case, fz=[6e3, 3e3]), stress_volume=False)
    assert many.independent is not None
    assert alone.independent is not None
    assert many.independent.life[0] == pytest.approx(alone.independent.life[0], rel=1e-9)
    assert many.independent.life[1] > many.independent.life[0]


def test_nothing_is_said_where_nothing_leads(script: ModuleType) -> None:
    case = script.Comparison("NU 205", "", 28e3).case("coupled")
    found = life(solve(case), stress_volume=False)
    assert not found.headline.leads[0]
    assert found.qualifications() == ()
