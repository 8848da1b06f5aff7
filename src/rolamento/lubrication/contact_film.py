"""The films of many contacts of one race: from what the contacts are to how thick the oil is."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rolamento.case.film_model import FilmModel
from rolamento.lubrication.film_thickness import (
    central_film,
    film_groups,
    flooded_distance_central,
    flooded_distance_minimum,
    gupta_cheng,
    inlet_distance_central,
    inlet_distance_minimum,
    minimum_film,
    murch_wilson,
    thermal_loading,
)
from rolamento.lubrication.oil_state import OilState
from rolamento.lubrication.running import RunningContacts
from rolamento.numerics import FloatArray


@dataclass(frozen=True, slots=True)
class ContactFilms:
    """The films at the contacts of one race; arrays (cases, balls), SI.

    Attributes
    ----------
    entrainment_speed
        u, mean of both surfaces (m/s)
    speed_parameter, load_parameter, material_parameter, ellipticity
        U, W, G and k
    central_thickness, minimum_thickness
        h_c and h_0 with all reductions (m); 0 where nothing turns, NaN where nothing touches
    thermal_factor, starvation_factor
        what the heat of shear and the lack of oil leave of the central film
    film_parameter
        λ = h_c over the combined RMS roughness; NaN where no roughness is given
    """

    entrainment_speed: FloatArray
    speed_parameter: FloatArray
    load_parameter: FloatArray
    material_parameter: FloatArray
    ellipticity: FloatArray
    central_thickness: FloatArray
    minimum_thickness: FloatArray
    thermal_factor: FloatArray
    starvation_factor: FloatArray
    film_parameter: FloatArray


def contact_films(
    contacts: RunningContacts,
    modulus: FloatArray,
    oil: OilState,
    model: FilmModel,
    refill: FloatArray,
    combined_roughness: float,
) -> ContactFilms:
    """Films of the contacts of a race: Hamrock and Dowson with the reductions of the model.

    Parameters
    ----------
    contacts, modulus
        (cases, balls), Pa.
    oil
        With fields (cases, 1).
    model
        Which reductions.
    refill
        Factor of replenishment, (cases, 1); 1 where it does not apply.
    combined_roughness
        Of ball and race, RMS, in m; NaN if not known.
    """
    touching = ~np.isnan(contacts.load)
    u = np.where(touching, contacts.speeds.entrainment, np.nan)
    groups = film_groups(
        u,
        contacts.load,
        contacts.rolling_curvature,
        np.where(touching, contacts.ellipticity, np.nan),
        modulus,
        oil.dynamic_viscosity,
        oil.pressure_viscosity,
    )
    thermal = _thermal_factor(contacts, u, modulus, oil, model)
    central, minimum = central_film(groups) * thermal, minimum_film(groups) * thermal
    starved, starved_minimum = _starvation_factors(contacts, central, minimum, model, refill)
    radius = 1.0 / contacts.rolling_curvature
    thickness = central * starved * radius
    fields = np.broadcast_arrays(
        u,
        groups.speed,
        groups.load,
        groups.material,
        groups.ellipticity,
        thickness,
        minimum * starved_minimum * radius,
        thermal,
        np.where(touching, starved, np.nan),
        thickness / combined_roughness,
    )
    return ContactFilms(*fields)


def _thermal_factor(
    contacts: RunningContacts,
    u: FloatArray,
    modulus: FloatArray,
    oil: OilState,
    model: FilmModel,
) -> FloatArray:
    if model.thermal == "none":
        return np.where(np.isnan(u), np.nan, 1.0)
    loading = thermal_loading(
        oil.dynamic_viscosity, oil.viscosity_temperature, u, oil.thermal_conductivity
    )
    if model.thermal == "murch_wilson":
        return murch_wilson(loading)
    with np.errstate(divide="ignore", invalid="ignore"):
        slide_to_roll = np.where(u > 0.0, contacts.speeds.sliding / u, 0.0)
    return gupta_cheng(loading, contacts.max_pressure, modulus, slide_to_roll)


def _starvation_factors(
    contacts: RunningContacts,
    central: FloatArray,
    minimum: FloatArray,
    model: FilmModel,
    refill: FloatArray,
) -> tuple[FloatArray, FloatArray]:
    """Of the central and of the minimum film; the films over R_x without starvation are given."""
    if model.starvation != "inlet_distance":
        return refill, refill
    assert model.inlet_distance is not None
    radius = 1.0 / contacts.rolling_curvature
    b = np.where(contacts.semi_minor > 0.0, contacts.semi_minor, np.nan)
    with np.errstate(divide="ignore", invalid="ignore"):
        distance = model.inlet_distance / b
        return (
            inlet_distance_central(distance, flooded_distance_central(central, radius, b)),
            inlet_distance_minimum(distance, flooded_distance_minimum(minimum, radius, b)),
        )
