"""The tables of a result: the ring, the elements, the contacts, the rows; arrays over cases, SI."""

from __future__ import annotations

from dataclasses import field, fields, replace
from functools import cached_property
from operator import attrgetter
from typing import Any, Final, NamedTuple, Protocol, Self, TypeVar, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from rolamento.case.duty import AXES, LOADS
from rolamento.contact.hertz import HertzContact, elliptical_contact
from rolamento.contact.subsurface import (
    MaximumShear,
    OrthogonalShear,
    line_maximum_shear,
    line_orthogonal_shear,
    maximum_shear,
    orthogonal_shear,
)
from rolamento.errors import UnknownKeyError
from rolamento.geometry import Angle, Race, RaceCurvature, race_curvature
from rolamento.kinematics import SurfaceSpeeds, spin_to_roll, surface_speeds
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.solved.rollers import Line, Rollers, line_contact
from rolamento.status import CONVERGED, STATUS_NAMES
from rolamento.words import Note, said

RACES: Final[tuple[Race, Race]] = ("inner", "outer")

ELEMENT_COLUMNS: Final = (
    "azimuth", "centrifugal_force", "gyroscopic_moment", "orbital_speed", "ball_speed", "attitude",
)  # fmt: skip
CONTACT_COLUMNS: Final = (
    "load", "contact_angle", "deflection", "semi_major", "semi_minor", "max_pressure",
    "mean_pressure", "max_shear", "max_shear_depth", "orthogonal_shear", "orthogonal_shear_depth",
    "spin_to_roll",
)  # fmt: skip
MORE_COLUMNS: Final = ("approach", "spin", "roll")
"""What a contact has besides, that laws and notes need."""
GEOMETRY_COLUMNS: Final = (
    "ball_diameter", "pitch_diameter", "inner_conformity", "outer_conformity",
    "free_contact_angle", "modulus",
)  # fmt: skip

IntArray = NDArray[np.int64]
Index = slice | NDArray[Any]
T = TypeVar("T")


class RingDisplacement(NamedTuple):
    """Displacement of the inner ring: x, y, z (m), ry, rz (rad); (cases,) each."""

    x: FloatArray
    y: FloatArray
    z: FloatArray
    ry: FloatArray
    rz: FloatArray

    @property
    def array(self) -> FloatArray:
        """(cases, 5)."""
        return np.stack(self, axis=-1)


class RingLoad(NamedTuple):
    """What the shaft puts on the inner ring: fx, fy, fz (N), my, mz (N·m); (cases,) each."""

    fx: FloatArray
    fy: FloatArray
    fz: FloatArray
    my: FloatArray
    mz: FloatArray

    @property
    def array(self) -> FloatArray:
        """(cases, 5)."""
        return np.stack(self, axis=-1)


@frozen(eq=False)
class Stiffness:
    """Derivative of the load by the displacement, the speed's effects included.

    ``stiffness["fz", "z"]`` is (cases,); `array` is (cases, 5, 5), in the order x, y, z, ry, rz
    (N/m, N/rad, N·m/m, N·m/rad).
    """

    array: FloatArray

    def __getitem__(self, names: tuple[str, str]) -> FloatArray:
        """Return the derivative of a load by a displacement; (cases,)."""
        load, axis = names
        if load not in LOADS or axis not in AXES:
            raise UnknownKeyError(
                said(
                    "must be one of {loads} and one of {axes}",
                    loads=", ".join(LOADS),
                    axes=", ".join(AXES),
                ),
                field="stiffness",
                value=f"{load}, {axis}",
                example='solved.stiffness["fz", "z"]',
            )
        return np.asarray(self.array[..., LOADS.index(load), AXES.index(axis)])


@frozen(eq=False)
class Status:
    """How the solution of each case ended; (cases,) each.

    Attributes
    ----------
    number
        of the status, a key of `rolamento.status.STATUS_NAMES`
    residual
        the largest unbalanced load of ring and elements, each over the scale of its own loads
    iterations
        Newton steps
    safe_path
        whether the fast path needed help
    unsupported
        of "no_equilibrium", the degree of freedom (0 to 4) that nothing holds; else -1
    """

    number: IntArray
    residual: FloatArray
    iterations: IntArray
    safe_path: BoolArray
    unsupported: IntArray

    @property
    def code(self) -> NDArray[np.str_]:
        """Its name: "converged", or why there is no result (docs/theory/equilibrium.md)."""
        return np.array([STATUS_NAMES[int(number)] for number in self.number], dtype=np.str_)

    @property
    def converged(self) -> BoolArray:
        """Whether there is a result."""
        return np.asarray(self.number == CONVERGED)


@frozen(eq=False)
class Elements:
    """The rolling elements, row after row; (cases, elements), SI.

    Attributes
    ----------
    row
        of each element, counted from 0; (elements,)
    azimuth
        0 at +z, a quarter turn at +y (rad)
    centrifugal_force
        (N)
    gyroscopic_moment
        (N·m), signed: negative when the inner ring turns
    orbital_speed
        about the bearing's axis (rad/s)
    ball_speed
        about its own axis (rad/s), signed against the orbit
    attitude
        angle of its axis to the bearing's axis (rad)
    yaw
        β' = atan(ω_y/ω_x) of its axis, toward increasing azimuth and seen from the cage (rad)
    raceway_control
        1 outer, -1 inner, 0 where neither race controls
    """

    row: IntArray
    azimuth: FloatArray
    centrifugal_force: FloatArray
    gyroscopic_moment: FloatArray
    orbital_speed: FloatArray
    ball_speed: FloatArray
    attitude: FloatArray
    yaw: FloatArray
    raceway_control: IntArray


@frozen(eq=False)
class Pressed:
    """What the rows answer of their contacts with one race; (cases, elements), SI.

    load (N), angle of the contact (rad), deflection (m), approach (m; a gap is below zero), and the
    angular speed of the element over the ring about the contact's normal and its tangent (rad/s).
    """

    load: FloatArray
    angle: Angle
    deflection: FloatArray
    approach: FloatArray
    spin: FloatArray
    roll: FloatArray


@frozen(eq=False)
class RollingContacts:
    """Friction of a race on elements that friction alone moves; (cases, elements).

    Attributes
    ----------
    power
        lost in the contact (W)
    slip
        speed of the element's surface over the race at the ellipse's centre, along increasing
        azimuth (m/s)
    force_along, force_across
        friction on the element, along increasing azimuth and along t = (cos α, -sin α) (N)
    """

    power: FloatArray
    slip: FloatArray
    force_along: FloatArray
    force_across: FloatArray


@frozen(eq=False)
class Rolling:
    """The motion of elements and cage under friction alone, and what it costs; (cases,).

    Attributes
    ----------
    cage_speed
        of all elements about the bearing's axis (rad/s)
    control_cage_speed
        the same under outer raceway control, the elements' mean weighted by their loads (rad/s)
    inner_torque, outer_torque
        that shaft and housing put on the rings against the friction at the races (N·m)
    imbalance
        what is missing between the work of shaft and housing and the losses, over the losses
    angular_velocity
        of the elements along x, along increasing azimuth, and outward; (cases, elements, 3), rad/s
    inner, outer
        the friction of the races
    """

    cage_speed: FloatArray
    control_cage_speed: FloatArray
    inner_torque: FloatArray
    outer_torque: FloatArray
    imbalance: FloatArray
    angular_velocity: FloatArray
    inner: RollingContacts
    outer: RollingContacts

    @property
    def skid(self) -> FloatArray:
        """How far the cage lags behind outer raceway control's, relative to it; below 0 ahead."""
        usual = self.control_cage_speed
        known = np.where(usual == 0.0, np.nan, usual)
        return np.asarray(1.0 - self.cage_speed / known)

    @property
    def power(self) -> FloatArray:
        """Lost at all races; (cases,), W."""
        lost = np.stack([self.inner.power, self.outer.power], axis=-1)
        return np.asarray(lost.reshape(len(lost), -1).sum(axis=1))


@frozen(eq=False)
class Tables:
    """What the rows answer of their elements and contacts, once they are solved."""

    elements: Elements
    inner: Pressed
    outer: Pressed
    rolling: Rolling | None = None
    rollers: Rollers | None = None


class Answer(Protocol):
    """Solved rows, which make their tables when they are asked."""

    def tables(self) -> Tables:
        """Evaluate every element of every case."""
        ...

    def grip(self) -> FloatArray:
        """How deep each element is pressed into the inner ring where it is deepest; m.

        (cases, elements); a gap is negative.
        """
        ...

    def part(self, index: Index) -> Self:
        """Return some of the cases."""
        ...


@runtime_checkable
class Loaded(Protocol):
    """Solved rows that know their contacts without the motion of their elements."""

    def pressed_on(self, race: Race) -> tuple[FloatArray, Angle]:
        """Load and angle of every contact with a race; (cases, elements), N and rad."""
        ...


class Refusals(Protocol):
    """Cases of which some are no case at all, and the rules that these violate."""

    def note(self, case: int) -> Note:
        """Return the note on a case that is not valid."""
        ...

    def part(self, index: Index) -> Self:
        """Return some of the cases."""
        ...


@frozen(eq=False)
class Rows:
    """The rows of rolling elements, from -x to +x; (cases, rows) each, SI.

    Attributes
    ----------
    sign
        +1 where a row carries axial load of the shaft toward +x, -1 where it faces the other way;
        (rows,)
    element_count
        (rows,)
    position
        of the elements' plane along x (m)
    load
        that the shaft puts on the inner ring through this row, about the bearing's origin;
        (cases, rows, 5), N and N·m
    ball_diameter, pitch_diameter, inner_conformity, outer_conformity
        of the row; of rollers their mean diameter, and no conformity: NaN
    free_contact_angle
        of a row that is given by its contact angle; 0 of one given by its clearance (rad)
    modulus
        E' of element and ring (Pa)
    element
        what rolls in each row, as a case file has it: "ball", "tapered" …; (rows,)
    effective_length
        L_we of the line of contact of rollers, NaN of balls (m)
    """

    sign: FloatArray
    element_count: IntArray
    position: FloatArray
    load: FloatArray
    ball_diameter: FloatArray
    pitch_diameter: FloatArray
    inner_conformity: FloatArray
    outer_conformity: FloatArray
    free_contact_angle: FloatArray
    modulus: FloatArray
    element: tuple[str, ...]
    effective_length: FloatArray

    def __len__(self) -> int:
        """Count the rows."""
        return len(self.sign)

    @property
    def starts(self) -> IntArray:
        """Index of the first element of each row; (rows,)."""
        return np.cumsum(self.element_count) - self.element_count

    @property
    def row_of_element(self) -> IntArray:
        """The row of each element, counted from 0; (elements,)."""
        return np.repeat(np.arange(len(self)), self.element_count)

    def per_element(self, values: FloatArray) -> FloatArray:
        """Repeat numbers of the rows for their elements; (cases, elements), only to be read."""
        if len(self) == 1:
            return np.broadcast_to(values, (*values.shape[:-1], int(self.element_count[0])))
        return values[..., self.row_of_element]


_Shapes = TypeVar("_Shapes", HertzContact, MaximumShear, OrthogonalShear)


def _column(path: str, meaning: str) -> cached_property[FloatArray]:
    """A column of contacts that stands in a record of theirs, made when it is first asked for."""
    found = cached_property[FloatArray](attrgetter(path))
    found.__doc__ = meaning
    return found


@frozen(eq=False, slots=False)
class Contacts:
    """The contacts of one race; (cases, elements), SI, NaN where a case has no result.

    `load`, `contact_angle`, `deflection` and `approach` (signed: a gap is below zero) are the
    kernels' own; `spin` and `roll` are the element's angular speeds over the ring about the normal
    and the tangent (rad/s). The rest follows from them.
    """

    race: Race
    load: FloatArray
    angle: Angle
    deflection: FloatArray
    approach: FloatArray
    spin: FloatArray
    roll: FloatArray
    ball_diameter: FloatArray = field(repr=False)
    pitch_diameter: FloatArray = field(repr=False)
    conformity: FloatArray = field(repr=False)
    modulus: FloatArray = field(repr=False)
    ring_poisson_ratio: float = field(repr=False)
    ring_speed: FloatArray = field(repr=False)
    elements: Elements = field(repr=False)
    line: Line | None = field(repr=False, default=None)
    effective_length: FloatArray | None = field(repr=False, default=None)

    contact_angle = _column("angle.value", "Angle of the contact (rad).")
    rolling_curvature = _column("curvature.rolling", "1/R_x, summed over element and ring (1/m).")
    semi_major = _column("_hertz.semi_major", "A of the contact ellipse, across rolling (m).")
    semi_minor = _column("_hertz.semi_minor", "B of the contact ellipse, along rolling (m).")
    ellipticity = _column("_hertz.ellipticity", "a/b, of an unloaded contact too.")
    max_pressure = _column("_hertz.max_pressure", "Hertz pressure in the middle (Pa).")
    mean_pressure = _column("_hertz.mean_pressure", "Load over the area of the ellipse (Pa).")
    resistance_to_spin = _column("_hertz.resistance_to_spin", "Q a E(m) (N·m).")
    max_shear = _column(
        "_maximum_shear.shear", "The maximum shear stress in the ring under the centre (Pa)."
    )
    max_shear_depth = _column("_maximum_shear.depth", "Depth (m).")
    orthogonal_shear = _column(
        "_orthogonal_shear.amplitude",
        "Amplitude of the shear that alternates along the surface (Pa).",
    )
    orthogonal_shear_depth = _column("_orthogonal_shear.depth", "Depth (m).")
    entrainment = _column(
        "surface_speeds.entrainment", "Mean speed of the two surfaces along rolling (m/s)."
    )

    @cached_property
    def curvature(self) -> RaceCurvature:
        """Curvatures along and across rolling at the loaded angle (1/m)."""
        return race_curvature(
            self.ball_diameter, self.pitch_diameter, self.conformity, self.angle, self.race
        )

    @cached_property
    def _hertz(self) -> HertzContact:
        curvature = self.curvature
        point = elliptical_contact(self.load, curvature.rolling, curvature.across, self.modulus)
        if self.line is None or self.effective_length is None:
            return point
        return self._of_lines(line_contact(self.line, self.effective_length, self.load), point)

    @cached_property
    def _maximum_shear(self) -> MaximumShear:
        p0, a, b = self.max_pressure, self.semi_major, self.semi_minor
        point = maximum_shear(p0, a, b, self.ring_poisson_ratio)
        if self.line is None:
            return point
        return self._of_lines(line_maximum_shear(p0, b, self.ring_poisson_ratio), point)

    @cached_property
    def _orthogonal_shear(self) -> OrthogonalShear:
        p0, a, b = self.max_pressure, self.semi_major, self.semi_minor
        point = orthogonal_shear(p0, a, b)
        return point if self.line is None else self._of_lines(line_orthogonal_shear(p0, b), point)

    def _of_lines(self, line: _Shapes, point: _Shapes) -> _Shapes:
        """Take what a line contact has for rollers, and what an ellipse has for balls."""
        if self.effective_length is None:
            return point
        rollers = np.isfinite(self.effective_length)
        names = [part.name for part in fields(point)]
        both = {n: np.where(rollers, getattr(line, n), getattr(point, n)) for n in names}
        return type(point)(**both)

    @cached_property
    def spin_to_roll(self) -> FloatArray:
        """Ratio of the angular speeds about the normal and along the surface."""
        return spin_to_roll(self.spin, self.roll) + 0.0

    @cached_property
    def surface_speeds(self) -> SurfaceSpeeds:
        """Speeds of ring and element along rolling, seen from the contact (m/s)."""
        motion = self.elements
        return surface_speeds(
            self.race, self.ball_diameter, self.pitch_diameter, self.angle,
            self.ring_speed, motion.orbital_speed, motion.ball_speed, motion.attitude, motion.yaw,
        )  # fmt: skip


@frozen
class PreloadStage:
    """The preload of a mounted set after one of the things that happen to it; no external load.

    Attributes
    ----------
    name
        "unmounted", "mounted" (after the fits), "warm", "rings_grown" (as the rings are at speed,
        the balls without inertia) or "at_speed"
    preload
        axial force between the rows that face each other with all tolerances at their loosest, at
        their mean and at their tightest (N); NaN where there is none, 0 where the rows have play
    contact_angle
        free contact angle of each row, at the tolerances that are solved with (rad)
    offset
        how far each row is pressed in from first contact; likewise (m)
    axial_stiffness
        of the set; likewise (N/m)
    max_pressure
        the largest of all contacts; likewise (Pa)
    """

    name: str
    preload: tuple[float, float, float]
    contact_angle: tuple[float, ...]
    offset: tuple[float, ...]
    axial_stiffness: float
    max_pressure: float


@frozen
class Preloading:
    """How the rows of a set press on each other, and what takes that away.

    Attributes
    ----------
    kind
        "force", "offset" or "level" where the rings are clamped, "spring"
    at_rest
        axial force between the rows that face each other, without external load, at rest (N); of
        a mounted set after the fits, at its temperatures
    at_speed
        the same at the duty's speeds (N)
    lift_factor
        multiple of the external load at which a ball first loses contact with the inner ring; NaN
        and None as below
    lift_row
        whose ball that is; None if none
    loss_factor
        the preload-loss point: multiple of the external load at which a row first loses all
        contact with the inner ring; NaN where there is no external load, or none is lost before
        the set has no equilibrium; None where nobody looked for it
    lost_row
        which row that is; None if none
    """

    kind: str
    at_rest: float
    at_speed: float
    lift_factor: float | None = None
    lift_row: int | None = None
    loss_factor: float | None = None
    lost_row: int | None = None
    stages: tuple[PreloadStage, ...] = ()
    """Stages of a mounted set: what becomes of its preload, step by step."""


def taken(record: T, index: Index, shared: tuple[str, ...] = ("row",)) -> T:
    """Some cases of a record of arrays over cases; shared: what has no axis of cases."""
    changed = {}
    for part in fields(record):  # type: ignore[arg-type]
        value = getattr(record, part.name)
        if part.name in shared or value is None:
            continue
        changed[part.name] = value[index] if isinstance(value, np.ndarray) else taken(value, index)
    return replace(record, **changed)  # type: ignore[type-var]
