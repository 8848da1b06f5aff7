"""A bearing between shaft and housing: capacitor, or conductor where its film breaks down.

Capacitance, areas and films are of the contacts that bear load at both races; an element that
touches one race only, or none, is left out: its gaps are wide. Balls of a ceramic do not conduct:
the capacitance that is left is that of the balls themselves, about ε_0 ε_r π D/4 each, a slab of
their mean section as thick as the ball.

What is published on harmless and harmful currents is a band, not a limit; a current density is put
beside the bands and never judged. Where the film parameter is small, asperities conduct and no
film holds a voltage: the notes say so.

Sources: data/electrical.toml.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.electrical import Electrical
from rolamento.electrical.contacts import (
    VACUUM,
    apparent_current_density,
    film_capacitance,
    in_series,
    share_of_voltage,
)
from rolamento.errors import InputError
from rolamento.geometry import Race
from rolamento.io.data import toml_of
from rolamento.lubrication.films import Film, film, has_film
from rolamento.numerics import FloatArray
from rolamento.records import frozen, span
from rolamento.solution import solve
from rolamento.solved import RACES, Solved
from rolamento.words import Note, said

__all__ = ["Band", "BearingElectrics", "RaceElectrics", "electrics_of", "has_electrics"]

_PARTIAL: Final = 3.0
"""λ below which asperities touch now and then."""
_CERAMIC_DENSITY: Final = 6200.0
"""kg/m³, above that of bearing ceramics (zirconia 6000) and below that of steels."""


@frozen
class Band:
    """A published band: of a current density (A/m²) or of a field (V/m).

    Attributes
    ----------
    key
        what it is of
    low, high
        its ends
    source
    checked
        whether the figure was held against a published text
    """

    key: str
    low: float
    high: float
    source: str
    checked: bool


@frozen(eq=False)
class RaceElectrics:
    """The contacts of one race; (cases, elements) but for the sums, SI.

    Attributes
    ----------
    area
        of each contact (m²)
    thickness
        central film (m)
    capacitance
        of each contact (F)
    voltage
        across each contact (V); NaN without a given voltage
    field
        across the central film (V/m); likewise
    total_area
        of all contacts that conduct to the other race too, (cases,) (m²)
    current_density
        apparent, (cases,) (A/m²); NaN without a given current
    """

    area: FloatArray
    thickness: FloatArray
    capacitance: FloatArray
    voltage: FloatArray
    field: FloatArray
    total_area: FloatArray
    current_density: FloatArray


@frozen(eq=False)
class BearingElectrics:
    """A bearing as an electrical part; (cases,), SI.

    Attributes
    ----------
    solved, given
        what was solved, and its [electrical] table
    inner, outer
        the contacts
    capacitance
        of the whole bearing, with steel elements (F)
    capacitance_of_ellipses
        the same without the gaps around the ellipses (F)
    ceramic_capacitance
        of the bearing with balls of silicon nitride in their place, by order of magnitude (F)
    insulated
        whether its elements are of a ceramic
    breakdown_voltage
        between the rings, at which the film of some element breaks down, for each of
        `breakdown`'s fields: (bands, 2, cases) (V)
    energy
        ½ C V² that a discharge sets free (J); NaN without a given voltage
    breakdown, density
        published bands of fields and of current densities
    notes
    """

    solved: Solved
    given: Electrical
    inner: RaceElectrics
    outer: RaceElectrics
    capacitance: FloatArray
    capacitance_of_ellipses: FloatArray
    ceramic_capacitance: FloatArray
    insulated: bool
    breakdown_voltage: FloatArray
    energy: FloatArray
    breakdown: tuple[Band, ...]
    density: tuple[Band, ...]
    notes: tuple[Note, ...]

    def _shown(self) -> dict[str, str]:
        return {
            "": self.solved.title or "a case without a title",
            "capacitance": span(1e12 * self.capacitance, "pF"),
            "current density": span(1e-6 * self.current_density, "A/mm²"),
            "field": span(1e-6 * self.field, "V/µm"),
        }

    @property
    def current_density(self) -> FloatArray:
        """The greater of both races; (cases,), A/m²."""
        return np.asarray(np.maximum(self.inner.current_density, self.outer.current_density))

    @property
    def field(self) -> FloatArray:
        """The maximum field of all contacts; (cases,), V/m."""
        both = [_maximum(self.of(race).field) for race in RACES]
        return np.asarray(np.fmax(*both))

    def of(self, race: Race) -> RaceElectrics:
        """Return the contacts of a race, ``"inner"`` or ``"outer"``."""
        found: RaceElectrics = getattr(self, race)
        return found

    def to_mapping(self) -> dict[str, Any]:
        """Give a single case as plain mappings and lists in SI units, NaN as None."""
        from rolamento.io.json import plain

        def race(name: Race) -> dict[str, Any]:
            own = self.of(name)
            columns = ("area", "thickness", "capacitance", "voltage", "field")
            return {
                "total_area": float(own.total_area[0]),
                "current_density": float(own.current_density[0]),
                **{column: getattr(own, column)[0].tolist() for column in columns},
            }

        found: dict[str, Any] = {
            "title": self.solved.title,
            "converged": bool(self.solved.converged[0]),
            "capacitance": float(self.capacitance[0]),
            "capacitance_of_ellipses": float(self.capacitance_of_ellipses[0]),
            "ceramic_capacitance": float(self.ceramic_capacitance[0]),
            "insulated": self.insulated,
            "energy": float(self.energy[0]),
            "inner": race("inner"),
            "outer": race("outer"),
            "breakdown_voltage": [
                {"key": band.key, "low": float(low), "high": float(high), "source": band.source}
                for band, (low, high) in zip(
                    self.breakdown, self.breakdown_voltage[:, :, 0].tolist(), strict=True
                )
            ],
            "current_density_bands": [
                {"key": band.key, "low": band.low, "high": band.high, "source": band.source}
                for band in self.density
            ],
            "notes": [note.to_mapping() for note in (*self.solved.notes[0], *self.notes)],
        }
        return dict(plain(found))


def has_electrics(solved: Solved) -> bool:
    """Whether there is a film to be a capacitor: an oil or a grease at its temperature."""
    return has_film(solved)


def electrics_of(source: Case | Solved, known: Film | None = None) -> BearingElectrics:
    """Capacitance, field and current density of a case, or of solved ones.

    Parameters
    ----------
    source
        A case with a lubricant and its temperature, or what `rolamento.solve` returned of it.
    known
        Its film, if that is known already.

    Raises
    ------
    InputError
        If the case has no oil or grease, or no temperature of it.

    >>> from rolamento.case import case_of
    >>> case = case_of("6310", {"duty.load.fz": "1 kN", "duty.inner_speed": "1500 rpm",
    ...                "lubricant": "ISO VG 100", "temperature.lubricant": "70 degC"})
    >>> found = electrics_of(case)
    >>> bool(50 < 1e12 * found.capacitance[0] < 500)  # pF
    True
    """
    solved = solve(source) if isinstance(source, Case) else source
    if not has_electrics(solved):
        raise InputError(
            said("is missing: without the film of an oil or a grease there is no capacitor"),
            field="temperature.lubricant" if solved.case.lubricant else "lubricant",
            example='lubricant = "ISO VG 68" and [temperature] lubricant = "70 degC"',
        )
    films = film(solved) if known is None else known
    given = solved.case.electrical or Electrical()
    data = toml_of("electrical")
    permittivity = given.permittivity or float(data["permittivity"]["oil"])
    area: dict[Race, FloatArray] = {race: _area(solved, race) for race in RACES}
    both = (area["inner"] > 0.0) & (area["outer"] > 0.0)
    conducting = {race: np.where(both | np.isnan(area[race]), area[race], 0.0) for race in RACES}
    thickness: dict[Race, FloatArray] = {race: films.of(race).central_thickness for race in RACES}
    plain = {
        race: film_capacitance(conducting[race], thickness[race], permittivity) for race in RACES
    }
    whole = {race: given.outside_factor * plain[race] for race in RACES}
    voltage = np.nan if given.voltage is None else given.voltage
    current = np.nan if given.current is None else given.current
    others: dict[Race, Race] = {"inner": "outer", "outer": "inner"}
    shares = {
        race: np.where(both, share_of_voltage(whole[race], whole[other]), np.nan)
        for race, other in others.items()
    }
    races: dict[Race, RaceElectrics] = {}
    for race in RACES:
        across = shares[race] * voltage
        total = conducting[race].sum(axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            field = across / thickness[race]
            density = np.where(total > 0.0, apparent_current_density(current, total), np.nan)
        races[race] = RaceElectrics(
            area[race], thickness[race], whole[race], across, field, total, density
        )
    capacitance = in_series(whole["inner"], whole["outer"]).sum(axis=1)
    bands = _bands("breakdown")
    lowest = np.fmin(*(_minimum_over(shares[r], films.of(r).minimum_thickness) for r in RACES))
    ends = np.array([[band.low, band.high] for band in bands])
    balls = solved.rows.per_element(solved.rows.ball_diameter)
    slab = VACUUM * float(data["permittivity"]["ceramic"]) * np.pi * balls / 4.0
    return BearingElectrics(
        solved,
        given,
        races["inner"],
        races["outer"],
        capacitance,
        capacitance / given.outside_factor,
        np.where(solved.converged, slab.sum(axis=1), np.nan),
        _insulated(solved),
        ends[:, :, np.newaxis] * lowest,
        0.5 * capacitance * voltage**2,
        bands,
        _bands("density"),
        tuple(_notes(solved, films, given, thickness)),
    )


def _area(solved: Solved, race: Race) -> FloatArray:
    """Area of each contact: its load over its mean pressure; (cases, elements), m²."""
    contacts = solved.contacts[race]
    load, mean = contacts.load, contacts.mean_pressure
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(mean > 0.0, load / np.where(mean > 0.0, mean, 1.0), 0.0 * load)


def _minimum_over(share: FloatArray, thickness: FloatArray) -> FloatArray:
    """Least h/share of all contacts: V between the rings at a field of 1 V/m; (cases,)."""
    with np.errstate(divide="ignore", invalid="ignore"):
        each = thickness / share
    known = np.where(np.isnan(each), np.inf, each).min(axis=1)
    return np.where(np.isinf(known), np.nan, known)


def _maximum(values: FloatArray) -> FloatArray:
    known = np.where(np.isnan(values), -np.inf, values).max(axis=1)
    return np.where(np.isinf(known), np.nan, known)


def _bands(name: str) -> tuple[Band, ...]:
    return tuple(
        Band(row["key"], float(row["low"]), float(row["high"]), row["source"], row["checked"])
        for row in toml_of("electrical")[name]
    )


def _insulated(solved: Solved) -> bool:
    """Whether the elements of every row are of a ceramic: far lighter than any bearing steel."""
    return all(
        place.bearing.element_material.density < _CERAMIC_DENSITY
        for place in solved.case.bearing.places
    )


def _notes(
    solved: Solved, films: Film, given: Electrical, thickness: dict[Race, FloatArray]
) -> list[Note]:
    found: list[Note] = []
    if not solved.converged[0]:
        return found
    if _insulated(solved):
        found.append(Note("ceramic_insulates"))
    parameter = float(films.minimum_film_parameter[0])
    if parameter < _PARTIAL:
        found.append(Note("asperities_conduct", {"film_parameter": parameter}))
    elif np.isnan(parameter):
        found.append(Note("conduction_unknown"))
    if any(np.nanmin(one[0], initial=np.inf) == 0.0 for one in thickness.values()):
        found.append(Note("no_film_conducts"))
    if given.permittivity is None:
        value = float(toml_of("electrical")["permittivity"]["oil"])
        found.append(Note("permittivity_assumed", {"permittivity": value}))
    found.append(Note("outside_of_ellipses", {"factor": given.outside_factor}))
    return found
