"""Cleanliness in words, in both languages: names, ranges of e_C, the option of the command."""

from __future__ import annotations

import json
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento.case.life_model import LEVELS, LifeModel
from rolamento.cli.app import app
from rolamento.errors import InputError
from rolamento.life.contamination import (
    ContaminationLevel,
    class_of_code,
    contamination_factor,
    level_of,
)

CASE = """
[bearing]
designation = "6305"
[duty]
inner_speed = "2000 rpm"
[duty.load]
fz = "2 kN"
[lubricant]
base_oil = "ISO VG 68"
name = "oil"
[temperature]
lubricant = "70 degC"
"""


@pytest.mark.parametrize(
    ("word", "level"),
    [
        ("normal", "normal"),
        ("Normal cleanliness", "normal"),
        ("limpeza normal", "normal"),
        ("Contaminação leve", "slight"),
        ("slight contamination", "slight"),
        ("contaminação típica", "typical"),
        ("very severe", "very_severe"),
        ("contaminação muito severa", "very_severe"),
        ("alta limpeza", "high"),
    ],
)
def test_words_of_both_languages(word: str, level: str) -> None:
    assert LifeModel(cleanliness=word).cleanliness == level
    if level != "typical":
        assert LifeModel(grease_cleanliness=word).grease_cleanliness == level


def test_a_level_needs_no_supply_and_a_code_does() -> None:
    assert LifeModel(cleanliness="normal", oil_supply="bath").cleanliness == "normal"
    with pytest.raises(InputError, match="oil_supply"):
        LifeModel(cleanliness="-/17/14")
    with pytest.raises(InputError, match=r"neither an ISO 4406 code nor a level.*normal"):
        LifeModel(cleanliness="normall")
    with pytest.raises(InputError, match="not an ISO 4406 code"):
        LifeModel(cleanliness="17-14", oil_supply="bath")


def test_levels_fall_and_join() -> None:
    """None is cleaner than the one above it; a level of large bearings is not dirtier."""
    levels = [level_of(name) for name in LEVELS]
    for below_hundred in (True, False):
        ends = [level.small if below_hundred else level.large for level in levels]
        for cleaner, dirtier in pairwise(ends):
            assert dirtier[0] <= dirtier[1]
            assert dirtier[1] <= cleaner[1]
            assert dirtier[0] <= cleaner[0]
    for level in levels:
        assert level.large[0] >= level.small[0]
        assert level.large[1] >= level.small[1]


def test_the_middle_of_the_range_is_taken() -> None:
    normal = level_of("normal")
    found = contamination_factor(normal, [0.4, 2.0], [0.0999, 0.1])
    np.testing.assert_allclose(found, [0.55, 0.7])
    low, high = normal.range_at(0.05)
    assert (float(low), float(high)) == (0.5, 0.6)


def test_codes_and_words_are_of_one_order() -> None:
    """At κ of 1 and 50 mm the words lie about the codes that describe the same oil."""
    fine = float(contamination_factor(class_of_code("-/13/10", "circulating"), 1.0, 0.05))
    coarse = float(contamination_factor(class_of_code("-/19/16", "bath"), 1.0, 0.05))
    assert isinstance(level_of("high"), ContaminationLevel)
    assert fine > level_of("normal").small[0]
    assert coarse < level_of("slight").small[1]


def test_the_option(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("case.toml").write_text(CASE, "utf-8")

    def run(*arguments: str) -> tuple[int, str, str]:
        result = CliRunner().invoke(app, ["life", *arguments], env={"LC_ALL": "C.UTF-8"})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result.exit_code, result.stdout, " ".join(result.stderr.split())

    code, out, _ = run("case.toml", "--cleanliness", "limpeza normal", "--json")
    assert code == 0
    assert '"cleanliness": "normal"' in out
    assert json.loads(out)["life"]["contamination_factor"] == pytest.approx(0.55)
    assert "cleanliness_in_words" in out
    code, _, error = run("case.toml", "--cleanliness", "clean")
    assert code == 2
    assert '--cleanliness: "clean": is neither an ISO 4406 code nor a level' in error
    grease = ("--set", 'lubricant.kind="grease"')
    assert "grease_cleanliness" in run("case.toml", *grease, "--cleanliness", "leve", "--json")[1]
