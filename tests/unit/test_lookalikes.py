"""Bearings that share the lines of a diagnosis: counted, named, told apart as far as can be."""

from __future__ import annotations

from math import pi
from pathlib import Path
from time import perf_counter

import numpy as np
import pytest

from rolamento import Bearing
from rolamento.catalogue import (
    RollingBearing,
    catalogue,
    inferred_geometry,
    inferred_rollers,
    rolling_bearings,
)
from rolamento.document.terminal import terminal
from rolamento.errors import InputError
from rolamento.pages.diagnosis import diagnosis_page
from rolamento.tasks.diagnosis import DiagnosisResult, diagnose
from rolamento.vibration.diagnosis import COMPONENTS, FaultOrders
from rolamento.vibration.frequencies import nominal_frequencies
from rolamento.vibration.lookalikes import lookalikes, orders_of
from rolamento.vibration.synthesis import Fault, Noise, Recipe, synthesise
from rolamento.words import speaking

SPEED = 1480.0 * pi / 30.0


@pytest.fixture(scope="module")
def of_6310(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A record of a 6310 with a damaged outer race."""
    recipe = Recipe(
        frequencies=nominal_frequencies(Bearing.named("6310"), SPEED),
        duration=6.0,
        rate=25_600.0,
        faults=(Fault(kind="outer_race"),),
        noise=Noise(ratio=-5.0),
    )
    path = tmp_path_factory.mktemp("records") / "motor.npy"
    np.save(path, synthesise(recipe).signal.samples)
    return path


def of(path: Path, bearing: str) -> DiagnosisResult:
    found = diagnose(path, bearing, speed=SPEED, rate=25_600.0, unit="m/s^2")
    assert found.too_short is None
    return found


def test_a_neighbours_bearing_is_not_certain(of_6310: Path) -> None:
    """6312 for 6310: the outer pass is 0.1 % apart, and the verdict says so."""
    found = of(of_6310, "6312")
    assert found.verdict == "fault"
    assert found.lookalikes is not None
    (true,) = [one for one in found.lookalikes.found if one.designation == "6310"]
    orders = [
        nominal_frequencies(Bearing.named(name), SPEED).ball_pass_outer.order
        for name in ("6310", "6312")
    ]
    assert true.differences["outer_race"] == pytest.approx(orders[0] / orders[1] - 1.0, abs=1e-7)
    assert abs(true.differences["outer_race"]) < 0.002
    shared = found.advice[-1]
    assert shared.key == "lines_of_other_bearings"
    assert shared.values["count"] == len(found.lookalikes.found) > 1
    distances = [one.distance(["outer_race"]) for one in found.lookalikes.found]
    assert distances == sorted(distances)
    assert [near["difference"] for near in shared.values["nearest"]] == distances[:3]
    assert "These peaks do not show which bearing it is" in shared.text
    # the true bearing is among those that share what its neighbour found
    own = of(of_6310, "6310")
    assert own.lookalikes is not None
    assert "6312" in [one.designation for one in own.lookalikes.found]
    assert own.lookalikes.compared == found.lookalikes.compared


@pytest.mark.parametrize("language", ["en", "pt"])
def test_page_and_json_name_the_neighbour(of_6310: Path, language: str) -> None:
    found = of(of_6310, "6312")
    with speaking(language):
        page = terminal(diagnosis_page(found))
    assert found.lookalikes is not None
    nearest = found.lookalikes.found[0].designation
    verdict, _ = page.split("motor", 1)
    assert f"{nearest} (" in verdict
    assert f"{nearest}: " in verdict  # what would tell the two apart
    mapping = found.to_mapping()
    assert mapping["lookalikes"]["count"] == len(mapping["lookalikes"]["bearings"])
    assert mapping["advice"][-1]["key"] == "lines_of_other_bearings"
    assert "distinguishing_lines" in [note["key"] for note in mapping["notes"]]


def test_what_tells_them_apart(of_6310: Path) -> None:
    """A spectrum over a time T has lines 1/T apart; two peaks need two of them."""
    found = of(of_6310, "6312")
    assert found.lookalikes is not None
    nearest, values = found.lookalikes.found[0], found.lookalikes.telling.values
    widest = max(nearest.differences.values(), key=abs)
    assert values["best_difference"] == pytest.approx(abs(widest))
    apart = abs(values["best_frequency"] - values["best_other_frequency"])
    assert values["duration"] == pytest.approx(2.0 / apart)
    assert values["known_within"] == pytest.approx(0.5 * abs(widest))
    assert values["balls"] == [8, 8]


def test_a_signal_without_damage_names_nobody(tmp_path: Path) -> None:
    path = tmp_path / "healthy.npy"
    np.save(path, np.random.default_rng(1).normal(size=36_000))
    found = of(path, "6205")
    assert found.lookalikes is None
    assert found.to_mapping()["lookalikes"] is None


def test_bearings_that_none_or_all_resemble(of_6310: Path) -> None:
    found = of(of_6310, "6310")
    sought = FaultOrders.of(found.frequencies)

    def among(*bearings: RollingBearing) -> str:
        shared = lookalikes(found.diagnosis, sought, bearings, speed_tolerance=0.03)
        assert shared is not None
        return shared.telling.key if shared.found else shared.shared.key

    six, bearing = Bearing.named("6310"), found.bearing
    ratio = bearing.ball_diameter / bearing.pitch_diameter
    twin = RollingBearing("twin", six.element_count, ratio, 0.0, False)
    assert among(twin) == "no_distinguishing_line"
    assert among(RollingBearing("other", 31, ratio, 0.0, False)) == "lines_of_no_other_bearing"
    more = RollingBearing("more", 9, 0.319, 0.0, False)
    shared = lookalikes(found.diagnosis, sought, [more], speed_tolerance=0.03)
    assert shared is not None
    assert "They have 8 and 9 balls" in shared.telling.text


def test_orders_are_those_of_the_frequencies() -> None:
    by_name = {bearing.designation: bearing for bearing in rolling_bearings()}
    for name in ("6205", "6310", "EX 70 15deg"):
        rolls, orders = by_name[name], FaultOrders.of(nominal_frequencies(Bearing.named(name)))
        for part in COMPONENTS:
            assert orders_of(rolls).fundamental(part) == pytest.approx(
                orders.fundamental(part), rel=1e-8
            )


def test_balls_are_kept_for_every_bearing_that_has_none() -> None:
    """After a change of the catalogue: python scripts/rolling.py."""
    kept = {bearing.designation: bearing for bearing in rolling_bearings()}
    balls = [b for b in catalogue().bearings if not b.has_rollers]
    without = [b for b in balls if not b.knows_elements]
    for bearing in [b for b in without if b.designation not in kept]:
        with pytest.raises((InputError, IndexError)):
            inferred_geometry(bearing, most=1)[0]
    for bearing in without[::15]:
        if bearing.designation in kept:
            best, found = inferred_geometry(bearing, most=1)[0], kept[bearing.designation]
            assert found.is_inferred
            assert found.element_count == best.ball_count
            assert found.diameter_ratio == pytest.approx(best.ball_diameter / best.pitch_diameter)


def test_rollers_are_kept_likewise() -> None:
    kept = {bearing.designation: bearing for bearing in rolling_bearings(of_rollers=True)}
    listed = [b for b in catalogue().bearings if b.has_rollers and not b.knows_elements]
    for bearing in listed[::60]:
        if bearing.designation in kept:
            best, found = inferred_rollers(bearing, most=1)[0], kept[bearing.designation]
            assert found.is_inferred
            assert found.element_count == best.roller_count
            ratio = best.roller_diameter / best.pitch_diameter
            assert found.diameter_ratio == pytest.approx(ratio)
    assert len(kept) > 1000


def test_it_takes_no_time(of_6310: Path) -> None:
    found = of(of_6310, "6310")
    began = perf_counter()
    lookalikes(
        found.diagnosis, FaultOrders.of(found.frequencies), rolling_bearings(), speed_tolerance=0.03
    )
    assert perf_counter() - began < 0.2
