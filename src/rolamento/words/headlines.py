"""Which notes qualify a headline: the one mark, for every page, report and file.

A headline is what a page says first: a status, a life, a power loss, a limiting speed. A note
qualifies it if the headline would be another, or not be given, without what the note says: a model
used outside its range, a part that the number leaves out, an input that was estimated or not
understood. Such notes stand with the headline; the others are remarks, and follow the tables.

A note is held to qualify unless it is listed here, so that a new one cannot be overlooked.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

import numpy as np
from numpy.typing import NDArray

from rolamento.words.note import Note

__all__ = ["REMARKS", "Qualified", "over_cases", "parted", "qualifies"]

Qualified = tuple[Note, NDArray[np.bool_]]
"""A note, and the cases whose headline it qualifies; (cases,)."""

REMARKS: Final = frozenset(
    {
        # of the state: what its numbers contain, or what changes none of them
        "balls_unloaded", "rollers_unloaded", "orbit_assumed", "jones_undecided",
        "gyroscopic_moment_left_out", "friction_control_at_rest", "spin_at_both_races",
        "roller_on_part_of_its_length", "edge_pressure_peak",
        "geometry_estimated_uniquely", "designation_listed_as", "designation_without_effect",
        # of the clearance: the result itself, in a sentence
        "clearance_in_operation", "interference", "interference_of_rollers",
        "preload_in_operation", "first_contact_moves",
        "clearance_of_tapered", "distance_of_rings", "distance_of_seats",
        # of the film: what its numbers contain, methods as they are generally used
        "film_dry", "film_at_rest", "film_heated", "film_starved", "roughness_missing",
        "pressure_viscosity_estimated", "outside_hamrock_dowson",
        # of friction: what its numbers contain
        "partial_film", "torque_at_rest",
        # of the life: what its number contains, what the headline says itself, parts not asked for
        "viscosity_ratio_capped", "below_fatigue_limit", "hours_at_rest", "no_static_rating",
        "open_grooves", "close_grooves", "factors_of_the_user", "theory_of_balls",
        "no_temperature", "l_able_without_viscosity", "edge_factor_left_out",
        "without_friction_models", "without_stress_volume", "without_preload_loss",
        # of an oscillation: what its number contains
        "oscillation_without_lubrication", "oscillation_without_frequency",
        "oscillation_as_own_loads",
        # of speeds: a limit that is not given
        "no_reference_speed_of_thrust", "no_boundary_dimensions", "no_static_rating_for_speed",
        "no_permissible_speed", "no_permissible_speed_under_axial_load", "no_load_to_compare",
        # of the heat balance: what it found anew
        "temperatures_of_balance",
        # of a grease or an oil: how it was found
        "grease_sealed_by_designation", "grease_open_by_designation", "oil_index_assumed",
        "grease_limit_of_class",
        # of life tests: how the numbers were found
        "location_at_zero", "censoring_modelled", "inspected_without_ranks",
        "inspected_groups_not_compared", "too_many_for_ranks", "group_without_failures",
        "fleet_failed_left_out", "modes_independent", "modes_at_inspections",
        "modes_of_suspended", "running_on_day_of_data", "inspections_shared",
        "lives_from_dates_and_use", "lives_from_dates_and_column",
        # of vibration: what is always so, how it was read, what the verdict says itself
        "not_a_certificate", "unexplained_peaks", "severity_not_bearings", "scaled_by_sensitivity",
        "velocity_from_acceleration", "velocity_from_displacement",
        "samples_multiplied", "angle_zero", "angle_free", "orders_at_rest", "cage_by_friction",
    }
)  # fmt: skip
"""Keys of notes that change no headline."""


def qualifies(note: Note) -> bool:
    """Return whether a headline has to carry a note, by its key."""
    return note.key not in REMARKS


def parted(notes: Iterable[Note]) -> tuple[tuple[Note, ...], tuple[Note, ...]]:
    """Return the notes that qualify a headline, and the remarks; each note once, in its order."""
    own = tuple(dict.fromkeys(notes))
    return tuple(filter(qualifies, own)), tuple(note for note in own if not qualifies(note))


def over_cases(notes: Iterable[Iterable[Note]]) -> tuple[Qualified, ...]:
    """Return what qualifies the headline of any of many cases, by key: its first note, and where.

    notes: of each case.
    """
    rows = [parted(own)[0] for own in notes]
    found: dict[str, Qualified] = {}
    for case, row in enumerate(rows):
        for note in row:
            found.setdefault(note.key, (note, np.zeros(len(rows), np.bool_)))[1][case] = True
    return tuple(found.values())
