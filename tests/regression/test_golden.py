"""The commands answer as they did: a part of the golden runs, and what counts as a difference."""

from __future__ import annotations

import copy
import importlib.util
import math
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest


def _golden() -> ModuleType:
    path = Path(__file__).with_name("golden.py")
    spec = importlib.util.spec_from_file_location("golden", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


golden = _golden()
FILES = {path.stem: path for path in golden.GOLDEN.glob("*.json")}


@pytest.fixture(scope="module", autouse=True)
def _compiled() -> None:
    golden.load_kernels()


@pytest.mark.parametrize("name", golden.spread(6))
def test_the_numbers_are_as_they_were(name: str) -> None:
    assert golden.differences(golden._load(name), golden.answer(name), golden.ELSEWHERE) == []


def test_every_run_has_its_numbers() -> None:
    assert FILES.keys() == golden.RUNS.keys()
    assert len(FILES) >= 60


# --- what counts ------------------------------------------------------------------------------

BALLS: dict[str, Any] = {
    "status": "converged",
    "balls": [{"load": 5000.0, "y": 0.0}, {"load": 1e-9, "y": 2e-5}, {"load": None, "y": -1e-5}],
    "solved": True,
}


@pytest.mark.parametrize(
    ("ball", "field", "value", "told"),
    [
        (0, "load", 5000.0 * (1.0 + 1e-13), 0),
        (0, "load", 5000.0 * (1.0 + 1e-11), 1),
        (1, "load", 2e-9, 0),  # rounding beside 5 kN
        (1, "load", 1e-7, 1),
        (0, "y", 1e-18, 0),
        (0, "load", None, 1),
        (0, "load", math.inf, 1),
        (2, "load", 0.0, 1),
    ],
)
def test_a_number_is_compared_with_the_greatest_of_its_kind(
    ball: int, field: str, value: float | None, told: int
) -> None:
    now = copy.deepcopy(BALLS)
    now["balls"][ball][field] = value
    differences = golden.differences(BALLS, now)
    assert len(differences) == told
    assert all(line.startswith(f"balls[{ball}].{field}: ") for line in differences)


def test_words_truths_and_what_is_gone_or_new_are_told() -> None:
    now = {"status": "overloaded", "balls": BALLS["balls"][:2], "solved": 1, "rows": []}
    told = golden.differences(BALLS, now)
    assert [line.partition(":")[0] for line in told] == [
        "balls[2].load", "balls[2].y", "rows", "status"
    ]  # fmt: skip


def test_named_items_are_each_on_their_own_scale() -> None:
    checks = [{"unit": "N", "computed": 1e6}, {"unit": "mm", "computed": 1e-3}]
    now = [checks[0], {"unit": "mm", "computed": 1e-3 * (1.0 + 1e-9)}]
    assert len(golden.differences(checks, now)) == 1


def test_what_is_kept() -> None:
    value = {
        "notes": ["not kept"], "x": math.nan, "advice": "a sentence", "code": "converged",
        "samples": [float(number) for number in range(97)],
    }  # fmt: skip
    assert golden.kept(value) == {
        "x": None,
        "code": "converged",
        "samples": {
            "#count": 97, "#every": 3, "#items": [float(n) for n in range(0, 97, 3)],
            "#mean": 48.0, "#rms": pytest.approx(math.sqrt(96 * 97 * 193 / 6 / 97)),
        },
    }  # fmt: skip


def test_where_nothing_bears_only_the_load_and_the_gap_are_kept() -> None:
    """The line from ball to groove is then none: what turns about it is rounding."""
    contact = {"load": 0.0, "approach": -5e-5, "contact_angle": 1.57, "spin_to_roll": 1.6e16}
    assert golden.kept({"inner": contact}) == {"inner": {"load": 0.0, "approach": -5e-5}}
    assert golden.kept(contact | {"load": 1.0}) == contact | {"load": 1.0}


def test_last_digits_may_differ_on_another_processor() -> None:
    now = copy.deepcopy(BALLS)
    now["balls"][0]["load"] *= 1.0 + 1e-10
    assert golden.differences(BALLS, now)
    assert not golden.differences(BALLS, now, golden.ELSEWHERE)


def test_the_wave_of_nothing_has_no_phase() -> None:
    first, second = ({"amplitude": [2.0, 1e-17], "phase": [0.5, phase]} for phase in (0.0, 3.0))
    assert golden.differences(golden.kept(first), golden.kept(second)) == []
    assert golden.differences(
        golden.kept(first), golden.kept({"amplitude": [2.0, 1e-17], "phase": [0.6, 0.0]})
    )
