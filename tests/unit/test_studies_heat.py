"""Heat outputs of studies: the balance of each case, as `heat_balance` finds it."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import Case, InputError
from rolamento.heat import heat_balance
from rolamento.studies import Study, run
from rolamento.studies.heat_curves import heat_over
from rolamento.studies.ranges import read_range

RPM = np.pi / 30.0


@pytest.fixture(scope="module")
def pair() -> Case:
    """A rigid spindle pair."""
    return Case(
        bearing={"designation": "7014 C DB", "preload": "240 N", "spacing": "20 mm"},
        duty={"inner_speed": "6000 rpm"},
        mounting={"shaft_interference": "5 um", "housing_interference": "-2 um"},
        lubricant="ISO VG 32",
        heat={"shaft_ambient": 2.0, "housing_ambient": 6.0},
    )


def test_a_study_finds_the_balance_of_each_case(pair: Case) -> None:
    speeds = np.array([3000.0, 6000.0, 16000.0]) * RPM
    names = ("warm_inner_ring", "warm_preload", "warm_power", "warm_max_pressure", "warm_slope")
    study = Study(
        case=pair, axes=[{"field": "duty.inner_speed", "values": speeds.tolist()}], outputs=names
    )
    found = run(study)
    for place, speed in enumerate(speeds.tolist()):
        own = heat_balance(pair.with_({"duty.inner_speed": speed}), look_for_speed=False)
        np.testing.assert_allclose(found["warm_power"][place], own.power, rtol=1e-7)
        np.testing.assert_allclose(
            found["warm_inner_ring"][place], own.temperatures["inner_ring"], rtol=1e-9
        )
        preload = np.nan if own.warm is None else own.warm.preload
        np.testing.assert_allclose(found["warm_preload"][place], preload, rtol=1e-6)
    assert np.isnan(found["warm_slope"][2])


def test_a_single_mounted_bearing_is_taken_before_its_mounting(pair: Case) -> None:
    single = Case(
        bearing={"designation": "6210"},
        duty={"inner_speed": "3000 rpm", "load": {"fz": "3 kN"}},
        mounting={"shaft_tolerance": "k5", "housing_tolerance": "H6"},
        lubricant="ISO VG 68",
        heat={"housing_ambient": 4.0},
    )
    loads = np.array([2000.0, 4000.0])
    study = Study(
        case=single,
        axes=[{"field": "duty.load.fz", "values": loads.tolist()}],
        outputs=("warm_power",),
    )
    found = run(study)
    for place, load in enumerate(loads.tolist()):
        own = heat_balance(single.with_({"duty.load.fz": load}))
        np.testing.assert_allclose(found["warm_power"][place], own.power, rtol=1e-7)


def test_without_the_table_it_is_refused(pair: Case) -> None:
    with pytest.raises(InputError, match=r"\[heat\] table"):
        run(
            Study(
                case=pair.with_({"heat": None}),
                axes=[{"field": "duty.inner_speed", "values": [100.0, 200.0]}],
                outputs=("warm_power",),
            )
        )


def test_a_lubricant_that_varies_keeps_its_temperature(pair: Case) -> None:
    over = read_range("temperature.lubricant=60..90degC", 2)
    found = heat_over(pair, over)
    for value, own in zip(over.values.tolist(), found.balances, strict=True):
        alone = heat_balance(pair.with_({"temperature.lubricant": value}), look_for_speed=False)
        assert own.status == alone.status
        np.testing.assert_allclose(own.power, alone.power, rtol=1e-7)


def test_what_is_warm_over_a_field_is_that_of_its_states(pair: Case) -> None:
    found = heat_over(pair, read_range("duty.inner_speed=2000..6000rpm", 2))
    alone = heat_balance(pair).warm
    assert alone is not None
    assert found.axial_stiffness[1] == pytest.approx(alone.axial_stiffness, rel=1e-6)
    assert found.contact_angle[1] == pytest.approx(alone.contact_angle[0], rel=1e-6)
    assert found.viscosity_ratio[1] == pytest.approx(alone.viscosity_ratio, rel=1e-6)
    assert alone.analysis.solved.stiffness.array[0, 0, 0] == pytest.approx(
        alone.axial_stiffness, rel=1e-6
    )
