"""A bearing in operation: its clearance, how fast it may run, its frequencies if damaged."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final

from rolamento.case import is_designation
from rolamento.errors import InputError, arguments
from rolamento.tasks.case_request import CaseRequest, Finding, in_json
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import Input
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.vibration.frequency_band import Tolerances

__all__ = ["ClearanceRequest", "FrequenciesRequest", "SpeedRequest"]


class ClearanceRequest(CaseRequest):
    """Show the clearance in operation, and the preload of a set.

    After fits, temperatures, speed and wear, step by step.

    Parameters
    ----------
    case
        Case file with a [mounting], or a designation and its fits by `changes`; - for standard
        input.
    samples
        Number of bearings to sample from their tolerances, up to a million.
    seed
        Seed of the random numbers.
    """

    samples: Annotated[int | None, Input("", "count", example="10000")] = None
    seed: Annotated[int, Input("", "count", example="0", default="0")] = 0

    examples: ClassVar = "Example: clearance case.toml --samples 10000."

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, a `Mounted`."""
        from rolamento.io.json import dumps
        from rolamento.pages.clearance import clearance_page
        from rolamento.tasks.clearance import mounted_clearance, mounted_samples

        case = self.loaded(needs_load=False)
        if case.mounting is None and is_designation(self.case):
            fits = {"mounting.shaft_tolerance": "k5", "mounting.housing_tolerance": "H7"}
            raise InputError(
                said("is missing: without it the bearing runs at its own clearance"),
                source=self.case,
                field="mounting",
                example=arguments(changes=fits),
            )
        found = mounted_clearance(case)
        sampled = None if self.samples is None else mounted_samples(case, self.samples, self.seed)
        scatter = {} if sampled is None else {"samples": sampled.to_mapping()}
        return Finding(
            found, partial(clearance_page, found, sampled, title=case.title),
            lambda: dumps({"schema": 2, **found.to_mapping(), **scatter}, indent=2),
        )  # fmt: skip


class SpeedRequest(CaseRequest):
    """Show how fast a bearing may run, and the load that it needs.

    Thermal reference and permissible speed, the maker's n·d_m, minimum load.

    Parameters
    ----------
    series
        Series of the bearing, such as 62, 70 or NU2, where no designation has it.
    width
        Width of the bearing, B or T of tapered rollers, such as '20 mm'.
    minimum_load_factor
        Factor A of a thrust ball bearing, as its maker lists it, such as '12 N'.
    """

    series: Annotated[str | None, Input()] = None
    width: Annotated[
        float | None,
        Input("", "quantity", example="20 mm", dimension="length", metavar="LENGTH"),
    ] = None
    minimum_load_factor: Annotated[
        float | None,
        Input("", "quantity", example="12 N", dimension="force", metavar="FORCE"),
    ] = None

    examples: ClassVar = (
        "Examples: speed 6210 --fr '2 kN' --speed '6000 rpm' --lubricant 'ISO VG 32'"
        " --temperature '70 degC'; speed case.toml --json."
    )

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, `SpeedLimits`."""
        from rolamento.analysis.speed_limits import speed_limits
        from rolamento.pages.speed import speed_page

        own = {name: getattr(self, name) for name in ("series", "width", "minimum_load_factor")}
        found = speed_limits(self.loaded(needs_load=False), **own)
        return Finding(found, partial(speed_page, found), in_json(found, schema=1))


class FrequenciesRequest(CaseRequest):
    """Show the fault frequencies of a bearing, also under load.

    BPFO, BPFI, BSF and FTF, from its geometry, and from what rolls under the case's load if any.

    Parameters
    ----------
    case
        Designation such as 6205, or a case file; - for a case on standard input.
    speed
        Speed of the inner ring, such as '1797 rpm'.
    outer_speed
        Speed of the outer ring, with its sign.
    slip
        Fraction by which the cage lags, such as 0.01; from -1 to 1.
    angle
        Contact angle of a bearing given by its clearance: zero (radial load) or free (axial load);
        or any angle, such as '15 deg'.
    tolerances
        Tolerance of ball_diameter or roller_diameter, pitch_diameter, contact_angle, speed (a
        fraction) or slip, such as speed=0.01.
    harmonics
        Harmonics to show, 1 to 100.
    sidebands
        Sidebands on either side of each harmonic, 0 to 10.

    >>> found = FrequenciesRequest(case="6205", speed="1800 rpm").run().found.nominal
    >>> print(f"{found.cage.frequency:.2f} Hz")
    11.93 Hz
    """

    case: Annotated[Any, Input("Bearing", "file", essential=True, metavar="BEARING")]
    speed: Annotated[
        float | None,
        Input("", "quantity", CaseRequest.headings[0], "1797 rpm", dimension="angular_speed"),
    ] = None
    outer_speed: Annotated[
        float | None,
        Input(
            "", "quantity", CaseRequest.headings[0], "0 rpm", dimension="angular_speed",
            metavar="SPEED",
        ),
    ] = None  # fmt: skip
    slip: Annotated[
        float, Input("", "number", example="0.01", default="0.0", metavar="FRACTION")
    ] = 0.0
    angle: Annotated[str | float, Input(example="15 deg", default="zero")] = "zero"
    tolerances: Annotated[
        Any,
        Input(
            "", "values", example="speed=0.01", choices=lambda: dict.fromkeys(_TOLERANCES, ""),
            option="--tolerance", metavar="KEY=VALUE",
        ),
    ] = None  # fmt: skip
    harmonics: Annotated[int, Input("", "count", example="3", default="3", metavar="N")] = 3
    sidebands: Annotated[int, Input("", "count", example="1", default="1", metavar="N")] = 1

    examples: ClassVar = (
        "Examples: frequencies 6205 --speed '1797 rpm'; frequencies case.toml --json."
    )

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, a `FrequencyResult`."""
        from rolamento.pages.frequencies import frequencies_page
        from rolamento.tasks.frequencies import fault_frequencies

        own = ("speed", "outer_speed", "slip", "angle", "harmonics", "sidebands", "changes")
        given = {name: getattr(self, name) for name in own}
        found = fault_frequencies(self.case, tolerances=_tolerances(self.tolerances or {}), **given)
        has_state = found.solved is None or bool(found.solved.converged[0])
        return Finding(found, partial(frequencies_page, found), in_json(found), is_result=has_state)


_TOLERANCES: Final[dict[str, Any]] = {
    "ball_diameter": "length", "roller_diameter": "length", "pitch_diameter": "length",
    "contact_angle": "angle", "speed": None, "slip": None,
}  # fmt: skip
"""What a tolerance may be of, by its dimension; parts have none."""


def _tolerances(given: Mapping[str, Any]) -> Tolerances:
    from rolamento.units import to_si
    from rolamento.vibration.frequency_band import Tolerances

    found: dict[str, Any] = {}
    try:
        for key, value in given.items():
            dimension = _TOLERANCES[key]
            if isinstance(value, str):
                value = to_si(value, dimension) if dimension else _part_of_one(key, value)
            found["ball_diameter" if key == "roller_diameter" else key] = value
        return Tolerances(**found)
    except InputError as error:
        raise error.with_details(source="tolerances") from None


def _part_of_one(key: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        rule = said("must be a fraction")
        raise InputError(rule, field=key, value=text, example=f"{key}=0.01") from None
