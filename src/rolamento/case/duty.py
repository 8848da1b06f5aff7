"""What a bearing is asked to bear: speeds, loads and displacements of the inner ring."""

from typing import Annotated, Final, Self

from pydantic import Field, model_validator

from rolamento.case.quantity import Quantity, Replaces
from rolamento.case.record import Record
from rolamento.errors import InputError
from rolamento.units import readable
from rolamento.words import said

__all__ = ["AXES", "LOADS", "SHORT_NAMES", "Displacement", "Duty", "Load", "Oscillation"]

AXES: Final = ("x", "y", "z", "ry", "rz")
"""The five degrees of freedom of the inner ring, in the order used everywhere."""

LOADS: Final = ("fx", "fy", "fz", "my", "mz")
"""The load on each degree of freedom, in the same order."""

SHORT_NAMES: Final = {
    **{name: f"duty.{name}" for name in ("inner_speed", "outer_speed", "first_ball_azimuth")},
    **{name: f"duty.load.{name}" for name in LOADS},
    **{name: f"duty.displacement.{name}" for name in AXES},
}
"""Short names of the duty's fields, which need not be distinguished from others."""

Five = tuple[float, float, float, float, float]

_Force = Annotated[float, Quantity("force", at_least="-1e6 kN", at_most="1e6 kN", varies=True)]
_Moment = Annotated[float, Quantity("moment", at_least="-1e9 N m", at_most="1e9 N m", varies=True)]
_Shift = Annotated[float, Quantity("length", at_least="-1 m", at_most="1 m", varies=True)]
_Tilt = Annotated[float, Quantity("angle", at_least="-5 deg", at_most="5 deg", varies=True)]
_Speed = Annotated[
    float, Quantity("angular_speed", at_least="-1e6 rpm", at_most="1e6 rpm", varies=True)
]
_Azimuth = Annotated[float, Quantity("angle", at_least="-360 deg", at_most="360 deg", varies=True)]


class Load(Record):
    """Forces and moments that the shaft puts on the inner ring.

    ``None`` means that nothing is said about that degree of freedom. A moment of zero
    is something else: it leaves the ring free to tilt.

    Parameters
    ----------
    fx, fy, fz
        Forces, in N.
    my, mz
        Moments, in N·m.

    Raises
    ------
    InputError
        If a value is out of range.
    """

    fx: Annotated[_Force | None, Replaces("duty.displacement.x")] = Field(None, examples=["20 kN"])
    fy: Annotated[_Force | None, Replaces("duty.displacement.y")] = Field(None, examples=["1 kN"])
    fz: Annotated[_Force | None, Replaces("duty.displacement.z")] = Field(None, examples=["15 kN"])
    my: Annotated[_Moment | None, Replaces("duty.displacement.ry")] = Field(
        None, examples=["50 N m"]
    )
    mz: Annotated[_Moment | None, Replaces("duty.displacement.rz")] = Field(
        None, examples=["50 N m"]
    )


class Displacement(Record):
    """Displacements of the inner ring that are imposed on it; the outer ring is fixed.

    Parameters
    ----------
    x, y, z
        Shifts, in m.
    ry, rz
        Tilts, in rad, at most 5 degrees.

    Raises
    ------
    InputError
        If a value is out of range.
    """

    x: Annotated[_Shift | None, Replaces("duty.load.fx")] = Field(None, examples=["0.01 mm"])
    y: Annotated[_Shift | None, Replaces("duty.load.fy")] = Field(None, examples=["0.01 mm"])
    z: Annotated[_Shift | None, Replaces("duty.load.fz")] = Field(None, examples=["0.01 mm"])
    ry: Annotated[_Tilt | None, Replaces("duty.load.my")] = Field(None, examples=["0.05 deg"])
    rz: Annotated[_Tilt | None, Replaces("duty.load.mz")] = Field(None, examples=["0.05 deg"])


class Oscillation(Record):
    """A ring that swings to and fro instead of turning.

    Parameters
    ----------
    angle
        φ between the end points, in rad: half of it to each side of the middle. An oscillation
        goes there and back, 2 φ.
    frequency
        Oscillations in a second, in Hz; without it the life has no hours.

    Raises
    ------
    InputError
        If a value is out of range.
    """

    angle: Annotated[
        Annotated[float, Quantity("angle", above="0 deg", at_most="3600 deg")],
        Replaces("duty.inner_speed", "duty.outer_speed"),
    ] = Field(examples=["30 deg"])
    frequency: Annotated[float, Quantity("frequency", above="0 Hz", at_most="1000 Hz")] | None = (
        Field(None, examples=["2 Hz"])
    )


class Duty(Record):
    """Speeds, loads and imposed displacements.

    Each degree of freedom takes a load or a displacement. One with neither is free
    under no load if it is a shift, and held at zero, as by a stiff shaft, if it is a
    tilt.

    Parameters
    ----------
    inner_speed, outer_speed
        Speeds of the rings about +x, in rad/s.
    first_ball_azimuth
        ψ of ball 0, in rad: 0 at +z, π/2 at +y.
    load
        A `Load`.
    displacement
        A `Displacement`.
    oscillation
        An `Oscillation`, in the place of speeds: which of the rings swings makes no difference but
        by `life.rotating_load`.

    Raises
    ------
    InputError
        If a value is out of range, or a degree of freedom is given twice.
    """

    inner_speed: _Speed = Field(0.0, examples=["10000 rpm"])
    outer_speed: _Speed = Field(0.0, examples=["10000 rpm"])
    first_ball_azimuth: _Azimuth = Field(0.0, examples=["11.25 deg"])
    load: Load = Field(default_factory=Load.model_construct)
    displacement: Displacement = Field(default_factory=Displacement.model_construct)
    oscillation: Oscillation | None = Field(None, examples=["[duty.oscillation] as a table"])

    @model_validator(mode="after")
    def _one_of_rivals(self) -> Self:
        """A degree of freedom takes a load or a displacement; a ring turns or it swings."""
        for axis, name in zip(AXES, LOADS, strict=True):
            shift, load = getattr(self.displacement, axis), getattr(self.load, name)
            if shift is not None and load is not None:
                raise InputError(
                    said(
                        "cannot be combined with load.{name}: a degree of freedom takes a load "
                        "or a displacement",
                        name=name,
                    ),
                    field=f"displacement.{axis}",
                    value=readable(shift, "length" if len(axis) == 1 else "angle"),
                    example=f'{axis} = "{"10 um" if len(axis) == 1 else "0.05 deg"}"',
                )
        for name in ("inner_speed", "outer_speed") if self.oscillation is not None else ():
            speed = getattr(self, name)
            if speed != 0.0:
                raise InputError(
                    said("cannot be combined with an oscillation: the ring turns or it swings"),
                    field=name,
                    value=readable(speed, "angular_speed"),
                    example='[duty.oscillation] angle = "20 deg", frequency = "2 Hz"',
                )
        return self

    @property
    def free(self) -> tuple[bool, bool, bool, bool, bool]:
        """Which of x, y, z, ry, rz is an unknown of the equilibrium."""
        shift, load = self.displacement, self.load
        return (
            shift.x is None,
            shift.y is None,
            shift.z is None,
            load.my is not None,
            load.mz is not None,
        )

    @property
    def turns(self) -> bool:
        """Whether a ring turns."""
        return self.inner_speed != 0.0 or self.outer_speed != 0.0

    @property
    def applied_load(self) -> Five:
        """Loads on x, y, z, ry, rz, in N and N·m; zero where none is given."""
        load = self.load
        return (load.fx or 0.0, load.fy or 0.0, load.fz or 0.0, load.my or 0.0, load.mz or 0.0)

    @property
    def imposed_displacement(self) -> Five:
        """Displacements of x, y, z, ry, rz, in m and rad; zero where none is given."""
        shift = self.displacement
        return (shift.x or 0.0, shift.y or 0.0, shift.z or 0.0, shift.ry or 0.0, shift.rz or 0.0)
