"""The makers' lists of preloads: found by designation, class and contact angle."""

from __future__ import annotations

import tomllib
from importlib import resources
from math import radians
from statistics import median
from typing import Any

import pytest

from rolamento import InputError
from rolamento.case.preload_classes import listed_designations, listed_preload


def lists() -> dict[str, Any]:
    file = resources.files("rolamento") / "data" / "preloads.toml"
    return tomllib.loads(file.read_text(encoding="utf-8"))


@pytest.mark.parametrize(
    ("designation", "level", "angle", "force"),
    [
        ("S 6012 C", "light", 15.0, 170.0),
        ("S 6012 C", "medium", 15.0, 515.0),
        ("S 6012 C", "heavy", 15.0, 1030.0),
        ("s6012e", "light", 25.0, 270.0),
        ("SEA 10", "heavy", 15.0, 60.0),
        ("SEA 10", "heavy", 25.0, 100.0),
        ("  sea  10 ", "medium", 25.9, 48.0),
    ],
)
def test_a_preload_is_found(designation: str, level: Any, angle: float, force: float) -> None:
    assert listed_preload(designation, level, radians(angle)) == force


@pytest.mark.parametrize(
    ("designation", "angle", "message"),
    [
        ("S 6012 D", 15.0, "in no maker's list of preloads; did you mean S 6012 [CE]"),
        ("7014", 15.0, "in no maker's list"),
        ("", 15.0, "give the preload as a force"),
        ("S 6012 C", 25.0, "listed for contact angles of 15° only"),
        ("SEA 10", 40.0, "15°, 25° only"),
        ("SEA 10", None, "15°, 25° only"),
    ],
)
def test_what_is_not_listed_is_refused(
    designation: str, angle: float | None, message: str
) -> None:  # fmt: skip
    with pytest.raises(InputError, match=message) as caught:
        listed_preload(designation, "light", None if angle is None else radians(angle))
    assert caught.value.field == "designation"
    assert caught.value.example


def test_every_listed_bearing_is_found_and_its_classes_rise() -> None:
    count = 0
    for maker in lists()["maker"]:
        for line in maker["bearings"]:
            angle = float(line["contact_angle"].removesuffix(" deg"))
            forces = [
                listed_preload(line["designation"], level, radians(angle))
                for level in ("light", "medium", "heavy")
            ]  # fmt: skip
            expected = [
                float(line[level].removesuffix(" N")) for level in ("light", "medium", "heavy")
            ]
            assert forces == expected
            assert 0.0 < forces[0] < forces[1] < forces[2]
            count += 1
    assert count > 450
    names = listed_designations()
    assert len(set(names)) == len(names)
    assert {"S 6012 C", "SEA 10"} <= set(names)


def test_heavy_is_about_six_times_light_and_medium_three() -> None:
    lines = [line for maker in lists()["maker"] for line in maker["bearings"]]

    def of(line: dict[str, str], level: str) -> float:
        return float(line[level].removesuffix(" N"))

    assert median(of(line, "medium") / of(line, "light") for line in lines) == pytest.approx(
        3.0, rel=0.03
    )
    assert median(of(line, "heavy") / of(line, "light") for line in lines) == pytest.approx(
        6.0, rel=0.03
    )


def test_every_list_names_its_source() -> None:
    data = lists()
    for part in ("maker", "set", "share_of_dynamic_rating"):
        assert data[part]
        assert all(entry["source"] for entry in data[part])
