"""The lubricant film of solved cases: the oil, the films of all contacts, the viscosity ratio."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.case.case import lubricant_of
from rolamento.case.film_model import FilmModel
from rolamento.errors import InputError
from rolamento.geometry import Race
from rolamento.io.json import plain
from rolamento.lubrication.film_thickness import (
    FilmGroups,
    aihara,
    central_film,
    film_groups,
    flooded_distance_central,
    flooded_distance_minimum,
    gupta_cheng,
    inlet_distance_central,
    inlet_distance_minimum,
    minimum_film,
    murch_wilson,
    replenishment,
    thermal_loading,
)
from rolamento.lubrication.line_film import line_film, line_groups
from rolamento.lubrication.notes import notes_on
from rolamento.lubrication.regime import Regime, regime_indices, regime_of, regimes
from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.blocks import in_blocks
from rolamento.oil.state import OilState, reference_viscosity
from rolamento.records import frozen, span
from rolamento.solved import NO_LOAD, RACES, Contacts, Solved, refuse_other
from rolamento.types import BALL
from rolamento.words import Note, said


@frozen(eq=False)
class ContactFilms:
    """The films at the contacts of one race; (cases, elements), SI.

    Attributes
    ----------
    entrainment_speed
        u, mean of both surfaces (m/s)
    speed_parameter, load_parameter, material_parameter, ellipticity
        U, W, G and k; of a roller W' of its slice with the most load, where the film is thinnest,
        and k infinite
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

    @property
    def regime(self) -> NDArray[np.str_]:
        """Names of `regimes`: "full_film", "partial", "boundary", "adhesive"; empty without λ."""
        names = np.array([*(regime.name for regime in regimes()), ""])
        return np.asarray(names[regime_indices(self.film_parameter)])

    def expected_failures(self, case: int, element: int) -> tuple[str, ...]:
        """Names of `regime.failure_modes` at one contact, the most likely first."""
        regime = regime_of(self.film_parameter[case, element])
        return () if regime is None else tuple(mode.name for mode in regime.expects)

    def entries(self, case: int) -> list[dict[str, Any]]:
        """Give every contact of a case as a plain mapping, NaN as None."""
        columns = {part.name: plain(getattr(self, part.name)[case]) for part in fields(self)}
        own = [
            ("", []) if index < 0 else _named(regimes()[index])
            for index in regime_indices(self.film_parameter[case]).tolist()
        ]
        return [
            {**dict(zip(columns, row, strict=True)), "regime": name, "expected_failures": [*modes]}
            for row, (name, modes) in zip(zip(*columns.values(), strict=True), own, strict=True)
        ]


def _named(regime: Regime) -> tuple[str, list[str]]:
    return regime.name, [mode.name for mode in regime.expects]


@frozen(eq=False)
class Film:
    """The lubricant film of solved cases, SI; NaN without a result, and of dry lubrication.

    Attributes
    ----------
    case
        what was solved
    temperature
        of the lubricant, (cases,) (K)
    kinematic_viscosity, dynamic_viscosity, density
        there, at ambient pressure; of a grease, its base oil's; (cases,) (m²/s, Pa·s, kg/m³)
    pressure_viscosity
        α there, (cases,) (1/Pa)
    reference_viscosity
        ν_1 of the row that needs most, (cases,) (m²/s); infinite at rest
    viscosity_ratio
        κ = ν/ν_1, (cases,)
    row, azimuth
        of each rolling element, (cases, elements) (rad)
    inner, outer
        the films of each race
    """

    case: Case
    temperature: FloatArray
    kinematic_viscosity: FloatArray
    dynamic_viscosity: FloatArray
    density: FloatArray
    pressure_viscosity: FloatArray
    reference_viscosity: FloatArray
    viscosity_ratio: FloatArray
    row: NDArray[np.int64]
    azimuth: FloatArray
    inner: ContactFilms
    outer: ContactFilms

    def __len__(self) -> int:
        """Count the cases."""
        return len(self.temperature)

    def _shown(self) -> dict[str, str]:
        thickness = [self.of(race).minimum_thickness for race in ("inner", "outer")]
        return {
            "": f"{self.lubricant}, {self.case.title or 'a case without a title'}",
            "cases": str(len(self)),
            "temperature": span(self.temperature - 273.15, "degC"),
            "viscosity there": span(1e6 * self.kinematic_viscosity, "mm^2/s"),
            "viscosity ratio": span(self.viscosity_ratio),
            "minimum film at the inner race": span(1e6 * thickness[0], "um"),
            "minimum film at the outer race": span(1e6 * thickness[1], "um"),
            "film parameter": span(self.minimum_film_parameter),
        }

    @property
    def lubricant(self) -> str:
        """Name of the lubricant."""
        return lubricant_of(self.case).name

    @property
    def minimum_film_parameter(self) -> FloatArray:
        """The minimum λ of all contacts; (cases,), NaN where there is none."""
        parameters = np.concatenate([self.inner.film_parameter, self.outer.film_parameter], axis=1)
        return np.asarray(np.fmin.reduce(parameters, axis=1))

    @property
    def notes(self) -> tuple[tuple[Note, ...], ...]:
        """What to know about the film of each case; a tuple over cases of tuples."""
        return tuple(self.notes_of(case) for case in range(len(self)))

    def notes_of(self, case: int = 0) -> tuple[Note, ...]:
        """The notes on one case."""
        return tuple(notes_on(self, case))

    def of(self, race: Race) -> ContactFilms:
        """The films of one race."""
        return self.inner if race == "inner" else self.outer

    def thinnest(self, race: Race, case: int = 0) -> int | None:
        """The element whose central film at a race is the thinnest; None if there is no film."""
        thickness = self.of(race).central_thickness[case]
        return int(np.nanargmin(thickness)) if np.isfinite(thickness).any() else None

    def to_mapping(self, case: int = 0) -> dict[str, Any]:
        """Give one case as plain mappings and lists in SI units, NaN and infinity as None."""
        return {
            "lubricant": self.lubricant,
            **self.whole(case),
            **self._entries(case),
            "notes": plain([note.to_mapping() for note in self.notes_of(case)]),
        }

    def whole(self, case: int = 0) -> dict[str, Any]:
        """The numbers of a case in `to_mapping` that are not of its elements."""
        names = [part.name for part in fields(self)]
        whole = names[names.index("temperature") : names.index("row")]
        return {name: plain(float(getattr(self, name)[case])) for name in whole}

    def _entries(self, case: int) -> dict[str, list[dict[str, Any]]]:
        """The elements of one case: balls, and rollers where there are some."""
        kinds = _kinds(self.case)
        found: dict[str, list[dict[str, Any]]] = {"balls": []}
        if set(kinds) != {BALL}:
            found["rollers"] = []
        rows, azimuths = self.row[case].tolist(), plain(self.azimuth[case])
        races = (self.inner.entries(case), self.outer.entries(case))
        for row, azimuth, inner, outer in zip(rows, azimuths, *races, strict=True):
            found["balls" if kinds[row] == BALL else "rollers"].append(
                {"row": row, "azimuth": azimuth, "inner": inner, "outer": outer}
            )
        return found


def _kinds(case: Case) -> tuple[str, ...]:
    """What rolls in each row."""
    return tuple(place.bearing.element for place in case.bearing.places)


def film(solved: Solved, *, threads: int | None = None) -> Film:
    """Find the lubricant film of solved cases: lubricant, surface and film model are the case's.

    Parameters
    ----------
    solved
        From `rolamento.solve`; its case needs a lubricant, and its temperature, which may vary.
    threads
        As many as there are processors by default.

    Raises
    ------
    InputError
        If there is no lubricant, or no temperature of it.

    Hamrock and Dowson (1977) for balls, Pan and Hamrock (1989) or Dowson and Toyoda (1979) for
    rollers, with the reductions that `case.film` names.
    """
    refuse_other(solved, "film")
    lubricant_of(solved.case)
    if "temperature.lubricant" not in solved.varied and solved.case.lubricant_temperature is None:
        raise InputError(
            said("is missing: the film needs the lubricant's temperature"),
            field="temperature.lubricant",
            example='[temperature] with lubricant = "70 degC"',
        )
    return in_blocks(_film_of_some, solved, threads)


def has_film(solved: Solved) -> bool:
    """Whether the case has an oil or a grease, at a known temperature."""
    case = solved.case
    warm = "temperature.lubricant" in solved.varied or case.lubricant_temperature is not None
    return warm and case.lubricant is not None and case.lubricant.kind != "dry"


def _film_of_some(solved: Solved) -> Film:
    case, elements, oil = solved.case, solved.elements, solved.oil
    model = case.film or FilmModel()
    speed = solved.relative_speed
    needed = reference_viscosity(speed[:, np.newaxis], solved.rows.pitch_diameter).max(axis=1)
    refill = _refill(case, model, oil, speed)
    inner, outer = (
        _films_of_race(solved, race, oil.columns(), model, refill[:, np.newaxis]) for race in RACES
    )
    return Film(
        case=case,
        temperature=oil.temperature,
        kinematic_viscosity=oil.kinematic_viscosity,
        dynamic_viscosity=oil.dynamic_viscosity,
        density=oil.density,
        pressure_viscosity=oil.pressure_viscosity,
        reference_viscosity=np.asarray(needed),
        viscosity_ratio=np.asarray(oil.kinematic_viscosity / needed),
        row=np.broadcast_to(elements.row, elements.azimuth.shape),
        azimuth=elements.azimuth,
        inner=inner,
        outer=outer,
    )


def resistance_left(solved: Solved, race: Race, viscosity: FloatArray) -> FloatArray:
    """Share of the oil's isothermal, flooded rolling resistance at each contact of a race.

    Parameters
    ----------
    solved
        With an oil at its temperature; its `case.film` says what is taken off, as of the film.
    race
        Which of the two.
    viscosity
        η₀ at the inlets, (cases, 1), Pa·s.

    Returns
    -------
    (cases, elements), 0 to 1: Aihara's factor of the heat in the inlets, times what the starvation
    leaves. An inlet distance takes more off the resistance than off the film, by which it is
    counted here (`rolamento.friction` calls the torque an upper bound then).
    """
    model = solved.case.film or FilmModel()
    contacts, oil = solved.contacts[race], solved.oil
    left = _starvation_left(solved, race, model, oil)
    if model.thermal == "none":
        return left
    u = np.where(np.isfinite(contacts.entrainment), np.abs(contacts.entrainment), 0.0)
    warm = oil.columns()
    loading = thermal_loading(viscosity, warm.viscosity_temperature, u, warm.thermal_conductivity)
    return np.asarray(left * aihara(loading))


def _starvation_left(solved: Solved, race: Race, model: FilmModel, oil: OilState) -> FloatArray:
    """What lack of oil leaves of the film at each contact, (cases, elements); 1 where none is."""
    shape = solved.contacts[race].load.shape
    if model.starvation == "none":
        return np.ones(shape)
    if model.starvation == "inlet_distance":
        factor = _film_of_some(solved).of(race).starvation_factor
        return np.where(np.isnan(factor), 1.0, factor)
    speed = solved.relative_speed
    refill = _refill(solved.case, model, oil, speed)
    return np.broadcast_to(refill[:, np.newaxis], shape)


def _films_of_race(
    solved: Solved, race: Race, oil: OilState, model: FilmModel, refill: FloatArray
) -> ContactFilms:
    """The formulas with the reductions of the model; oil and refill (cases, 1)."""
    contacts = solved.contacts[race]
    other = solved.contacts["outer" if race == "inner" else "inner"]
    with np.errstate(invalid="ignore"):
        touching = contacts.load > NO_LOAD * other.load
    u = np.where(touching, contacts.entrainment, np.nan)
    groups, central, minimum = _isothermal_films(contacts, touching, u, oil, model)
    thermal = _thermal_factor(contacts, u, oil, model)
    central, minimum = central * thermal, minimum * thermal
    starved, starved_minimum = _starvation_factors(contacts, central, minimum, model, refill)
    radius = 1.0 / contacts.rolling_curvature
    thickness = central * starved * radius
    surface = solved.case.surface
    roughness = np.nan if surface is None else getattr(surface, f"{race}_combined")
    return ContactFilms(
        *np.broadcast_arrays(
            u,
            groups.speed,
            groups.load,
            groups.material,
            groups.ellipticity,
            thickness,
            minimum * starved_minimum * radius,
            thermal,
            np.where(touching, starved, np.nan),
            thickness / roughness,
        )
    )


def _isothermal_films(
    contacts: Contacts, touching: BoolArray, u: FloatArray, oil: OilState, model: FilmModel
) -> tuple[FilmGroups, FloatArray, FloatArray]:
    """The groups, and both films over R_x, of points of contact and of lines."""
    curvature, modulus = contacts.rolling_curvature, contacts.modulus
    fluid = (oil.dynamic_viscosity, oil.pressure_viscosity)
    points = touching if contacts.line is None else touching & np.isfinite(contacts.conformity)
    load, ellipticity = (
        np.where(points, values, np.nan) for values in (contacts.load, contacts.ellipticity)
    )
    groups = film_groups(u, load, curvature, ellipticity, modulus, *fluid)
    central, minimum = central_film(groups), minimum_film(groups)
    if contacts.line is None:
        return groups, central, minimum
    lines = touching & ~points
    most = np.where(lines, contacts.line.load_per_length.max(axis=-1), np.nan)
    of_lines = line_groups(u, most, curvature, modulus, *fluid)
    both = FilmGroups(
        of_lines.speed,
        *(
            np.where(lines, getattr(of_lines, name), getattr(groups, name))
            for name in ("load", "material", "ellipticity")
        ),
    )
    middle, least = line_film(of_lines, model.line or "pan_hamrock")
    return both, np.where(lines, middle, central), np.where(lines, least, minimum)


def _thermal_factor(
    contacts: Contacts, u: FloatArray, oil: OilState, model: FilmModel
) -> FloatArray:
    if model.thermal == "none":
        return np.where(np.isnan(u), np.nan, 1.0)
    loading = thermal_loading(
        oil.dynamic_viscosity, oil.viscosity_temperature, u, oil.thermal_conductivity
    )
    if model.thermal == "murch_wilson":
        return murch_wilson(loading)
    with np.errstate(divide="ignore", invalid="ignore"):
        slide_to_roll = np.where(u > 0.0, contacts.surface_speeds.sliding / u, 0.0)
    return gupta_cheng(loading, contacts.max_pressure, contacts.modulus, slide_to_roll)


def _starvation_factors(
    contacts: Contacts,
    central: FloatArray,
    minimum: FloatArray,
    model: FilmModel,
    refill: FloatArray,
) -> tuple[FloatArray, FloatArray]:
    """Starvation factors of central and minimum film, from the fully flooded films over R_x.

    The inlet distance is of ellipses only: lines are flooded, and a note says so.
    """
    if model.starvation != "inlet_distance":
        return refill, refill
    assert model.inlet_distance is not None
    radius = 1.0 / contacts.rolling_curvature
    b = np.where(contacts.semi_minor > 0.0, contacts.semi_minor, np.nan)
    with np.errstate(divide="ignore", invalid="ignore"):
        distance = model.inlet_distance / b
        found = (
            inlet_distance_central(distance, flooded_distance_central(central, radius, b)),
            inlet_distance_minimum(distance, flooded_distance_minimum(minimum, radius, b)),
        )
    if contacts.line is None:
        return found
    flooded = np.isnan(contacts.conformity)
    return np.where(flooded, 1.0, found[0]), np.where(flooded, 1.0, found[1])


def _refill(case: Case, model: FilmModel, oil: OilState, speed: FloatArray) -> FloatArray:
    """The factor of replenishment, (cases,); 1 where it does not apply."""
    if model.starvation != "replenishment":
        return np.ones_like(speed)
    assert model.supply is not None
    assert model.bore is not None
    assert model.outside_diameter is not None
    return replenishment(
        oil.kinematic_viscosity,
        speed,
        model.bore,
        model.outside_diameter,
        model.supply,
        kind=refilled_kind(case),
    )


def refilled_kind(case: Case) -> str:
    """The kind of bearing that the factor of replenishment has a constant for."""
    return case.bearing.listed_type.key
