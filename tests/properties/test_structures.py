"""What people write, changed by its structure: read, or refused in one message.

Some hundreds of each kind; `python -m benchmarks.faults --only structures` reads many more.
"""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from benchmarks.structures import KINDS, Kind, Late, kinds, run, take

from rolamento.errors import InputError, UnknownKeyError
from rolamento.studies import parse_study

UNKNOWN_BESIDE_ANOTHER = """
case = "218_combined.toml"
[scatter]
count = 10
[scatter.fields."duty.load.fx"]
distribution = "uniform"
minimum = "1 kN"
maximum = "2 kN"
[scatter.fields."duty.load.fw"]
distribution = "uniform"
minimum = "1 kN"
maximum = "2 kN"
"""


def test_an_unknown_field_beside_another_one(examples: Path) -> None:
    with pytest.raises(UnknownKeyError) as raised:
        parse_study(UNKNOWN_BESIDE_ANOTHER, folder=examples)
    assert raised.value.value == "duty.load.fw"
    zipped = 'case = "218_combined.toml"\n[[axes]]\nzipped = {"duty.load.fx" = ["1 kN"], "z" = [1]}'
    with pytest.raises(UnknownKeyError) as raised:
        parse_study(zipped, folder=examples)
    assert (raised.value.field, raised.value.value) == ("axes.0.zipped", "z")


@pytest.mark.parametrize("name", KINDS)
def test_every_text_ends_well(name: str) -> None:
    (found,) = run(250, 36, [name])
    assert found.bad == {}
    assert found.outcomes["read"] > 0
    assert found.outcomes.total() == 250


def test_bad_ends_are_found() -> None:
    """A reader that lets through what it should refuse, is not short, or does not end."""

    def read(text: str, further: bool) -> object:
        if text == "long":
            raise InputError("x" * 5000)
        if text == "endless":
            raise Late
        return {"known": 1}[text]

    kind = Kind("made", [], lambda samples, rng: "", read)
    for text, wrong in (("long", "message"), ("endless", "Late"), ("other", "KeyError")):
        found = take(kind, [text])
        assert [end.partition(" ")[0].rstrip(":") for end in found.bad] == [wrong]
    assert take(kind, ["known"]).outcomes == {"read": 1}


def test_changes_are_the_same_for_a_seed(tmp_path: Path) -> None:
    for kind in kinds(tmp_path):
        first, again = (
            [kind.mutated(kind.samples, rng) for _ in range(30)]
            for rng in (random.Random(1), random.Random(1))
        )
        assert first == again
        assert len(set(first)) > 20
