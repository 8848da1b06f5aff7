"""Many duties for one case: the parameters of a batch, one column a case."""

from __future__ import annotations

from typing import Final, TypedDict, cast

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Case
from rolamento.duty import AXES, LOADS
from rolamento.equilibrium import rows
from rolamento.equilibrium.problem import Floats, case_parameters, ring_arms
from rolamento.errors import InputError, UnknownKeyError, nearest

_SPEEDS: Final = {"inner_speed": rows.INNER_SPEED, "outer_speed": rows.OUTER_SPEED}


class DutyFields(TypedDict, total=False):
    """What a batch may vary: scalars, or arrays of one length, in SI units."""

    inner_speed: ArrayLike
    outer_speed: ArrayLike
    first_ball_azimuth: ArrayLike
    fx: ArrayLike
    fy: ArrayLike
    fz: ArrayLike
    my: ArrayLike
    mz: ArrayLike
    x: ArrayLike
    y: ArrayLike
    z: ArrayLike
    ry: ArrayLike
    rz: ArrayLike


def spread(case: Case, fields: DutyFields) -> Floats:
    """Repeat the case's parameters over a batch, and put the fields in.

    fields: scalars or arrays of one length, by the names of the duty's fields, SI units.
    Returns (rows.PARAMETERS, cases).

    Raises
    ------
    InputError
        For an unknown field, lengths that differ, or a load beside a displacement.
    """
    known = (*_SPEEDS, "first_ball_azimuth", *LOADS, *AXES)
    for name in fields:
        if name not in known:
            raise UnknownKeyError(
                f"is not known; perhaps {nearest(name, known) or 'one of ' + ', '.join(known)}",
                field=name,
                example="fx=[1e3, 2e3]",
            )
    given = cast("dict[str, ArrayLike]", fields)
    arrays = {name: np.asarray(value, dtype=np.float64) for name, value in given.items()}
    lengths = {array.shape for array in arrays.values() if array.ndim}
    if len(lengths) > 1 or any(len(shape) != 1 for shape in lengths):
        raise InputError(
            "must be scalars or one-dimensional arrays of one length",
            field=", ".join(arrays),
            value=str(sorted(lengths)),
            example="fx=[1e3, 2e3], fz=[0.0, 500.0]",
        )
    cases = lengths.pop()[0] if lengths else 1
    p = np.repeat(case_parameters(case)[:, np.newaxis], cases, axis=1)
    arms = ring_arms(p)
    for name, array in arrays.items():
        if name in _SPEEDS:
            p[_SPEEDS[name]] = array
        elif name == "first_ball_azimuth":
            p[rows.COS_FIRST], p[rows.SIN_FIRST] = np.cos(array), np.sin(array)
        elif name in LOADS:
            _free(p, LOADS.index(name), array / arms[LOADS.index(name)])
        else:
            axis = AXES.index(name)
            if LOADS[axis] in arrays:
                raise InputError(
                    f"is given beside {LOADS[axis]}: a degree of freedom takes a load or a "
                    "displacement",
                    field=name,
                    example=f"{name} without {LOADS[axis]}",
                )
            _hold(p, axis, array * arms[axis])
    return p


def _free(p: Floats, axis: int, load: Floats) -> None:
    p[rows.FREE + axis], p[rows.APPLIED + axis], p[rows.IMPOSED + axis] = 1.0, load, 0.0


def _hold(p: Floats, axis: int, displacement: Floats) -> None:
    p[rows.FREE + axis], p[rows.APPLIED + axis], p[rows.IMPOSED + axis] = 0.0, 0.0, displacement
