"""Electricity in a bearing: plates, series, parallel; scaling and limits; what is said."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import Case, Electrical, solve
from rolamento.case import case_of
from rolamento.electrical import (
    apparent_current_density,
    electrics_of,
    film_capacitance,
    in_series,
    share_of_voltage,
)
from rolamento.errors import InputError

MOTOR = {
    "duty.load.fz": "1 kN",
    "duty.inner_speed": "1500 rpm",
    "lubricant": "ISO VG 100",
    "temperature.lubricant": "70 degC",
    "electrical.voltage": "10 V",
    "electrical.current": "0.5 A",
}


def motor(designation: str = "6310", **more: object) -> Case:
    return case_of(designation, {**MOTOR, **more})


def test_a_plate_capacitor() -> None:
    """ε_0 A/h of a square centimetre and a tenth of a millimetre: 8.854 pF."""
    assert film_capacitance(1e-4, 1e-4, 1.0) == pytest.approx(8.854e-12, rel=1e-4)


def test_without_contact_there_is_no_capacitor_and_without_film_a_conductor() -> None:
    assert film_capacitance(0.0, np.nan, 2.2) == 0.0
    assert np.isinf(film_capacitance(1e-6, 0.0, 2.2))


def test_a_conductor_in_series_changes_nothing() -> None:
    assert in_series(3e-12, np.inf) == pytest.approx(3e-12)


def test_a_gap_in_series_leaves_nothing() -> None:
    assert in_series(3e-12, 0.0) == 0.0


def test_the_shares_of_the_voltage_make_the_whole() -> None:
    assert share_of_voltage(2.0, 5.0) + share_of_voltage(5.0, 2.0) == pytest.approx(1.0)


def test_the_voltages_of_an_element_add_to_that_of_the_bearing() -> None:
    found = electrics_of(motor())
    both = (found.inner.voltage + found.outer.voltage)[0]
    assert both[np.isfinite(both)] == pytest.approx(10.0)
    assert np.isfinite(both).sum() == found.solved.loaded_elements[0, 0]


def test_the_bearing_is_its_elements_in_parallel() -> None:
    found = electrics_of(motor())
    one = found.inner.capacitance[0], found.outer.capacitance[0]
    elements = [1.0 / (1.0 / i + 1.0 / o) for i, o in zip(*one, strict=True) if i > 0.0 and o > 0.0]
    assert found.capacitance[0] == pytest.approx(sum(elements))


def test_capacitance_follows_permittivity_and_the_gap_around() -> None:
    plain = electrics_of(motor(**{"electrical.outside_factor": 1.0})).capacitance[0]
    assert electrics_of(motor()).capacitance[0] == pytest.approx(2.0 * plain)
    polar = electrics_of(motor(**{"electrical.permittivity": 4.4})).capacitance[0]
    assert polar == pytest.approx(4.0 * plain)


def test_the_field_is_that_of_the_given_voltage() -> None:
    single, double = (electrics_of(motor(**{"electrical.voltage": v})) for v in ("10 V", "20 V"))
    assert double.field == pytest.approx(2.0 * single.field)
    assert double.energy == pytest.approx(4.0 * single.energy)
    assert double.capacitance == pytest.approx(single.capacitance)


def test_at_the_breakdown_voltage_the_thinnest_film_has_the_breakdown_field() -> None:
    """By central films; breakdown takes the minimum film, which is thinner."""
    found = electrics_of(motor())
    field = found.breakdown[0].low
    at = electrics_of(motor(**{"electrical.voltage": f"{found.breakdown_voltage[0, 0, 0]} V"}))
    assert 0.4 * field < at.field[0] < field


def test_current_density_is_current_over_the_areas() -> None:
    found = electrics_of(motor())
    contacts = found.solved.inner
    areas = np.pi * contacts.semi_major * contacts.semi_minor
    assert found.inner.total_area[0] == pytest.approx(areas[0].sum())
    assert found.inner.current_density[0] == pytest.approx(0.5 / areas[0].sum())
    assert found.current_density[0] == max(
        found.inner.current_density[0], found.outer.current_density[0]
    )


def test_twice_the_current_is_twice_the_density() -> None:
    assert apparent_current_density(2.0, 1e-6) == 2.0 * apparent_current_density(1.0, 1e-6)


def test_a_faster_bearing_has_thicker_films_and_less_capacitance() -> None:
    slow, fast = (electrics_of(motor(**{"duty.inner_speed": n})) for n in ("500 rpm", "3000 rpm"))
    assert fast.capacitance[0] < slow.capacitance[0]
    assert fast.breakdown_voltage[0, 0, 0] > slow.breakdown_voltage[0, 0, 0]


def test_ceramic_balls_insulate_and_say_so() -> None:
    found = electrics_of(motor("6310/HC5"))
    assert found.insulated
    assert "ceramic_insulates" in {note.key for note in found.notes}
    assert found.ceramic_capacitance[0] < 0.2 * found.capacitance[0]


def test_rollers_have_areas_by_their_slices() -> None:
    found = electrics_of(motor("NU 210"))
    line = found.solved.rollers.inner  # type: ignore[union-attr]
    width = 2.0 * line.half_width.mean(axis=2) * found.solved.rows.effective_length[0, 0]
    loaded = found.inner.area > 0.0
    assert found.inner.area[loaded] == pytest.approx(width[loaded])


def test_a_bearing_at_rest_conducts() -> None:
    found = electrics_of(motor(**{"duty.inner_speed": "0 rpm"}))
    assert "no_film_conducts" in {note.key for note in found.notes}


def test_without_an_equilibrium_there_are_no_numbers() -> None:
    oil = {"lubricant": "ISO VG 100", "temperature.lubricant": "70 degC"}
    given = {"electrical.voltage": "5 V", "electrical.current": "1 A"}
    solved = solve(case_of("7210 B", {**oil, **given}), fx=[5e3, -5e3], inner_speed=100.0)
    found = electrics_of(solved)
    for race in (found.inner, found.outer):
        every = (race.total_area, race.capacitance.sum(axis=1), race.current_density)
        for values in (*every, found.energy, found.capacitance, found.capacitance_of_ellipses):
            assert np.isfinite(values[0])
            assert np.isnan(values[1])


def test_without_a_lubricant_it_says_what_is_missing() -> None:
    with pytest.raises(InputError, match="film"):
        electrics_of(case_of("6310", {"duty.load.fz": "1 kN"}))


def test_thin_films_are_bridged_and_the_page_says_so() -> None:
    rough = {"surface.inner_roughness": "1 um", "surface.outer_roughness": "1 um",
             "surface.ball_roughness": "0.5 um"}  # fmt: skip
    found = electrics_of(motor(**rough))
    assert "asperities_conduct" in {note.key for note in found.notes}


def test_the_bands_cover_everything_from_zero() -> None:
    bands = {band.key: band for band in electrics_of(motor()).density}
    assert bands["harmless"].high == bands["between"].low == 1e5
    assert bands["between"].high == bands["fluting"].low == 7e5


@pytest.mark.parametrize("field", ["voltage", "current"])
def test_negative_values_are_refused(field: str) -> None:
    with pytest.raises(InputError):
        Electrical(**{field: -1.0})  # type: ignore[arg-type]


def test_the_page_says_it_in_both_languages() -> None:
    from rolamento.document.terminal import terminal
    from rolamento.pages.electrical import electrical_page
    from rolamento.words import speaking

    found = electrics_of(motor())
    for language in ("en", "pt_BR"):
        with speaking(language):
            assert "A/mm²" in terminal(electrical_page(found))


def test_a_study_has_them() -> None:
    from rolamento.studies.outputs import Evaluation, outputs_of

    found = electrics_of(motor())
    given = Evaluation(found.solved)
    names = ("bearing_capacitance", "current_density", "film_field", "static_safety_by_stress")
    values = [output.compute(given)[0] for output in outputs_of(names)]
    assert values[0] == found.capacitance[0]
    assert values[1] == found.current_density[0]
    assert values[2] == found.field[0]
    assert values[3] > 1.0


def test_a_study_without_a_current_says_what_is_missing() -> None:
    from rolamento.studies.outputs import outputs_of, refuse_missing

    plain = motor(**{"electrical.current": None})
    refuse_missing(outputs_of(["bearing_capacitance", "film_field"]), plain, ())
    with pytest.raises(InputError, match="current"):
        refuse_missing(outputs_of(["current_density"]), plain, ())
