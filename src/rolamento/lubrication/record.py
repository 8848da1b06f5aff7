"""The film of one state: what a user sees of it.

Plain frozen records in SI units. A number that does not exist is NaN, and null in JSON.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass
from math import isfinite
from typing import Any

from rolamento._json import plain
from rolamento.geometry import Race


@dataclass(frozen=True, slots=True)
class ContactFilm:
    """The film at one contact, SI; NaN where the ball does not touch the race.

    Attributes
    ----------
    entrainment_speed
        mean of the two surface speeds (m/s)
    speed_parameter, load_parameter, material_parameter, ellipticity
        U, W, G and k = a/b
    central_thickness, minimum_thickness
        h_c and h_0 with all reductions (m); 0 where nothing turns
    thermal_factor, starvation_factor
        what heat of shear and lack of oil leave of the central film
    film_parameter
        λ = h_c over the combined RMS roughness
    regime
        "full_film", "partial", "boundary" or "adhesive"; empty without λ
    expected_failures
        names of `regime.failure_modes`, the most likely first
    """

    entrainment_speed: float
    speed_parameter: float
    load_parameter: float
    material_parameter: float
    ellipticity: float
    central_thickness: float
    minimum_thickness: float
    thermal_factor: float
    starvation_factor: float
    film_parameter: float
    regime: str
    expected_failures: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class BallFilm:
    """The films of one ball: row, azimuth (rad), and its contacts."""

    row: int
    azimuth: float
    inner: ContactFilm
    outer: ContactFilm


@dataclass(frozen=True, slots=True)
class Film:
    """The lubricant film of a bearing under a duty, SI.

    Attributes
    ----------
    lubricant
        its name
    temperature
        of the lubricant (K)
    kinematic_viscosity, dynamic_viscosity, density
        there, at ambient pressure; of a grease, its base oil's (m²/s, Pa·s, kg/m³)
    pressure_viscosity
        α there (1/Pa)
    reference_viscosity
        ν_1, needed by the bearing (m²/s); infinite at rest
    viscosity_ratio
        κ = ν/ν_1
    balls
        from the first ball on, row after row
    notes
        what the user should know about the film
    """

    lubricant: str
    temperature: float
    kinematic_viscosity: float
    dynamic_viscosity: float
    density: float
    pressure_viscosity: float
    reference_viscosity: float
    viscosity_ratio: float
    balls: tuple[BallFilm, ...]
    notes: tuple[str, ...] = ()

    def thinnest(self, race: Race) -> ContactFilm | None:
        """Return the contact of a race with the thinnest central film; None if there is none."""
        films = [getattr(ball, race) for ball in self.balls]
        found = [film for film in films if isfinite(film.central_thickness)]
        return min(found, key=lambda film: film.central_thickness, default=None)

    def to_mapping(self) -> dict[str, Any]:
        """Give the film as plain mappings and lists in SI units, NaN and infinity as None."""
        mapping: dict[str, Any] = plain(asdict(self))
        return mapping
