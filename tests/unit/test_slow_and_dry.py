"""Slow and dry mechanisms: torque over the angle, space lubricants, preload over its field."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import Case, Lubricant
from rolamento.case import case_of, load_case
from rolamento.studies.cage_turn import cage_turn
from rolamento.studies.torque_turn import torque_over_turn

DRY = {"lubricant.kind": "dry", "lubricant.friction_coefficient": 0.1}
PAIR = "src/rolamento/examples/6012_pair.toml"


def slow(**more: object) -> Case:
    return case_of("6205", {"duty.load.fz": "100 N", "duty.inner_speed": "1 rpm", **DRY, **more})


def test_the_torque_repeats_with_the_balls() -> None:
    found = torque_over_turn(cage_turn(slow(), points=16))
    assert found is not None
    assert found.peak_to_peak == pytest.approx(np.ptp(found.torque))
    # the mean and the harmonics make the torque again
    angles = 2.0 * np.pi * np.arange(16) / 16.0
    orders = np.arange(1, len(found.harmonics) + 1)
    waves = (found.harmonics[:, np.newaxis] * np.exp(1j * np.outer(orders, angles))).real
    assert found.mean + waves.sum(axis=0) == pytest.approx(found.torque, rel=0.02)


def test_an_axial_load_alone_gives_a_torque_without_noise() -> None:
    case = slow(**{"duty.load.fx": "200 N", "duty.load.fz": "0 N"})
    found = torque_over_turn(cage_turn(case, points=8))
    assert found is not None
    assert found.peak_to_peak == 0.0
    assert found.noise == 0.0


def test_torque_is_in_proportion_to_the_coefficient() -> None:
    """But for hysteresis, which has none."""
    means = []
    for mu in (0.05, 0.1):
        case = slow(**{"lubricant.friction_coefficient": mu})
        found = torque_over_turn(cage_turn(case, points=8))
        assert found is not None
        means.append(found.mean)
    assert 1.2 < means[1] / means[0] <= 2.0


def test_without_friction_there_is_no_torque() -> None:
    assert torque_over_turn(cage_turn(case_of("6205", {"duty.load.fz": "100 N"}), points=4)) is None


@pytest.mark.parametrize(
    ("name", "kind"),
    [("MoS2", "dry"), ("Fomblin Z25", "oil"), ("Krytox 143AC", "oil"), ("Brayco 815Z", "oil"),
     ("Braycote 601EF", "grease"), ("Rheolube 2000", "grease")],
)  # fmt: skip
def test_space_lubricants_are_known_by_name(name: str, kind: str) -> None:
    found = Lubricant.named(name)
    assert found.kind == kind
    assert found.source


def test_fomblin_has_the_viscosity_of_nasas_table_at_20_degrees() -> None:
    """255 mm²/s at 20 °C: Jones and Jansen; here from 40 and 100 °C by ASTM D341."""
    from rolamento.oil.state import oil_state

    state = oil_state(Lubricant.named("Fomblin Z25"), 293.15)
    assert 1e6 * float(state.kinematic_viscosity) == pytest.approx(255.0, rel=0.15)


@pytest.mark.parametrize("way", ["force", "spring"])
def test_the_preload_is_a_field_that_varies(way: str) -> None:
    from rolamento.studies.ranges import read_range

    chosen = read_range(f"bearing.preload.{way}=100..500N", 3)
    assert chosen.values.tolist() == [100.0, 300.0, 500.0]


def test_the_torque_of_a_pair_grows_with_its_preload() -> None:
    means = []
    for force in ("100 N", "500 N"):
        case = load_case(PAIR, {"bearing.preload": {"force": force}, "duty.inner_speed": "1 rpm",
                                "duty.load.fx": "0 N", "duty.load.fz": "10 N", **DRY})  # fmt: skip
        found = torque_over_turn(cage_turn(case, points=4))
        assert found is not None
        means.append(found.mean)
    assert means[1] > 2.0 * means[0]
