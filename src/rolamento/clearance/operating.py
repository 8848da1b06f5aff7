"""The clearance in operation, step by step, at its limits.

The chain: clearance before mounting, less what the measuring load shows too much, press fit on the
shaft, press fit in the housing, expansion, rotation, wear. Each step is a record that tells what it
adds to the clearance and from what.

The limits are those of all tolerances at their worst together: the least clearance goes with the
tightest fits. `rolamento.clearance.sampling` draws them independently instead.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.mounting import Mounting
from rolamento.clearance.assembly import Assembly, Temperatures
from rolamento.clearance.chain import Chain, ChainResult
from rolamento.clearance.classes import CLEARANCE_SOURCE
from rolamento.clearance.fits import FIT_SOURCE
from rolamento.clearance.iso286 import TOLERANCE_SOURCE
from rolamento.clearance.iso492 import BEARING_TOLERANCE_SOURCE
from rolamento.clearance.measuring_load import usual_measuring_load
from rolamento.clearance.record import OperatingClearance, Step
from rolamento.clearance.speed import SPEED_SOURCE
from rolamento.clearance.temperature import TEMPERATURE_SOURCE
from rolamento.errors import InputError

__all__ = ["clearance_of_case", "operating_case", "operating_clearance"]

_TIGHTEST: Final = 1e-3
"""Greatest interference over the bore. NTN, Ball and Roller Bearings, chapter 7.3.3."""


def operating_clearance(
    bearing: Bearing,
    mounting: Mounting,
    temperatures: Temperatures | None = None,
    *,
    inner_speed: float = 0.0,
    outer_speed: float = 0.0,
) -> OperatingClearance:
    """Clearance of a mounted bearing in operation, each step shown.

    Parameters
    ----------
    bearing
        Before mounting; one row.
    mounting
        A `Mounting`.
    temperatures
        A `PartTemperatures`; everything as at assembly if not given.
    inner_speed, outer_speed
        Of the rings with shaft and housing, in rad/s.

    Raises
    ------
    InputError
        If something is missing, contradicts itself or is not in the tables.
    """
    chain = Chain.of(bearing, mounting, temperatures, inner_speed, outer_speed)
    tight = chain.shaft and chain.shaft.mirrored
    held = chain.housing and chain.housing.mirrored
    result = chain.run(_three(chain.initial), _three(tight), _three(held))
    steps = _steps(chain, result)
    low, mean, high = steps[-1].clearance
    return OperatingClearance(bearing, steps, low, mean, high, _warnings(chain, result, low, mean))


def clearance_of_case(case: Case) -> OperatingClearance:
    """Clearance in operation of a case that has a mounting, at its temperatures and speeds.

    Raises
    ------
    InputError
        As `operating_clearance`, and if the case has no mounting.
    """
    if case.mounting is None:
        raise InputError(
            "is missing: without it the bearing runs with its own clearance",
            field="mounting",
            example='[mounting] with bore = "25 mm" and outside_diameter = "62 mm"',
        )
    return operating_clearance(
        case.bearing,
        case.mounting,
        case.temperature,
        inner_speed=case.duty.inner_speed,
        outer_speed=case.duty.outer_speed,
    )


def operating_case(case: Case) -> Case:
    """The case with its bearing as it runs, and no mounting; what `solve` solves.

    A case without a mounting is returned as it is.

    Raises
    ------
    InputError
        As `operating_clearance`, and if no bearing is left.
    """
    if case.mounting is None:
        return case
    running = clearance_of_case(case).operating_bearing(case.mounting.limit)
    warm = case.temperature
    of_bearing = None if warm is None else warm.of_bearing
    return case.replace(bearing=running, mounting=None, temperature=of_bearing)


def _three(band: Any) -> Any:
    """Minimum, mean and maximum as an array; None of None."""
    return None if band is None else np.array([band.low, band.middle, band.high])


def _triple(values: NDArray[np.float64] | float) -> tuple[float, float, float]:
    low, mean, high = np.broadcast_to(values, (3,))
    return float(low), float(mean), float(high)


def _steps(chain: Chain, result: ChainResult) -> tuple[Step, ...]:
    assembly, mounting = chain.assembly, chain.assembly.mounting
    steps: list[Step] = []

    def add(name: str, change: Any, formula: str, source: str, **details: Any) -> None:
        before = np.array(steps[-1].clearance) if steps else np.zeros(3)
        shown = {key: _triple(value) for key, value in details.items()}
        after = _triple(before + change)
        steps.append(Step(name, _triple(change), after, formula, source, shown))

    if chain.reading is None:
        add("initial", result.initial, "P_d before mounting", _origin(assembly))
    else:
        add("initial", chain.reading, "reading under the measuring load", "measured")
        add(
            "measuring_load",
            result.initial - chain.reading,
            "-2 [δ_r(F) - P_d/2]",
            "radial equilibrium",
            load=mounting.measuring_load or usual_measuring_load(mounting.bore),
        )
    tolerances = f"{TOLERANCE_SOURCE}; {BEARING_TOLERANCE_SOURCE}; {FIT_SOURCE}"
    for name, fit, given in (
        ("shaft_fit", result.shaft, mounting.shaft_tolerance),
        ("housing_fit", result.housing, mounting.housing_tolerance),
    ):
        if fit is not None:
            formula = "-growth of the raceway under p(δ - smoothing + expansion - rotation)"
            add(
                name,
                fit.change,
                formula.replace("growth", "shrinkage") if name == "housing_fit" else formula,
                FIT_SOURCE if given is None else tolerances,
                interference=fit.interference,
                smoothing=fit.smoothing,
                expansion=fit.expansion,
                rotation=fit.rotation,
                effective_interference=fit.effective,
                pressure=fit.pressure,
            )
    if assembly.expansion_change:
        add(
            "temperature",
            assembly.expansion_change,
            "α_r (T_e d_e - T_i d_i) - 2 α_b T_b D",
            TEMPERATURE_SOURCE,
            inner_raceway=assembly.inner_raceway,
            outer_raceway=assembly.outer_raceway,
        )
    if assembly.spin_change:
        add("speed", assembly.spin_change, "growth of the turning raceways", SPEED_SOURCE)
    if mounting.wear:
        add("wear", mounting.wear, "as given", "given")
    return tuple(steps)


def _origin(assembly: Assembly) -> str:
    named = assembly.mounting.clearance_class or assembly.bearing.clearance_class
    if named is not None:
        return f"{CLEARANCE_SOURCE}, class {named}"
    return "the bearing's own"


def _warnings(chain: Chain, result: ChainResult, low: float, mean: float) -> tuple[str, ...]:
    found = []
    if mean < 0.0:
        found.append("interference")
    elif low < 0.0:
        found.append("interference_at_minimum")
    for name, fit in (("inner_ring_loose", result.shaft), ("outer_ring_loose", result.housing)):
        if fit is not None and fit.interference[1] > 0.0 and fit.effective.min() <= 0.0:
            found.append(name)
    shaft = chain.shaft
    if shaft is not None and shaft.high > _TIGHTEST * chain.assembly.mounting.bore:
        found.append("tight_shaft")
    return tuple(found)
