"""What acts on the shafts of a machine: forces, gears, belts, masses, gravity.

Axes as everywhere: x along the shaft, z up, y = z × x. The azimuth φ of a mesh point counts from +z
toward +y, and a shaft turns positively about +x. With e_r = (0, sin φ, cos φ) toward the mesh point
and e_t = x × e_r, its velocity is ω d/2 e_t. Forces are those on the shaft, moments about its axis
at the place of the part: r × F.
"""

from __future__ import annotations

import math
from typing import Annotated, Any, Final, Literal, NamedTuple, Self

from pydantic import AfterValidator, Field, model_validator

from rolamento.case.quantity import Count, Line, Quantity, Replaces
from rolamento.case.record import Record, refuse_rivals
from rolamento.errors import ABSENT, InputError
from rolamento.units import readable
from rolamento.words import said

__all__ = [
    "Belt",
    "Gear",
    "Gravity",
    "Inertia",
    "Mass",
    "Name",
    "OperatingMesh",
    "Place",
    "ShaftLoad",
    "Six",
    "Speed",
    "mirrored",
    "operating_mesh",
]

Six = tuple[float, float, float, float, float, float]
"""fx, fy, fz, mx, my, mz on the shaft, in N and N·m."""
Vector = tuple[float, float, float]

STANDARD_GRAVITY: Final = 9.80665
"""m/s²; the conventional value of ISO 80000-3."""
SLIP: Final = 1e-9
"""What rounding may leave of a belt's pull."""


def _named(text: str) -> str:
    if not text.strip():
        raise InputError(said("must not be empty"), value=text)
    return text


Name = Annotated[Line, AfterValidator(_named)]
"""What a part of a machine is called."""
Place = Annotated[float, Quantity("length", at_least="0 mm", at_most="100 m", varies=True)]
Speed = Annotated[
    float, Quantity("angular_speed", at_least="-1e6 rpm", at_most="1e6 rpm", varies=True)
]
_Force = Annotated[float, Quantity("force", at_least="-1e6 kN", at_most="1e6 kN", varies=True)]
_Pull = Annotated[float, Quantity("force", at_least="0 N", at_most="1e6 kN", varies=True)]
_Moment = Annotated[float, Quantity("moment", at_least="-1e9 N m", at_most="1e9 N m", varies=True)]
_Torque = Annotated[float, Quantity("moment", at_least="0 N m", at_most="1e9 N m", varies=True)]
_Power = Annotated[float, Quantity("power", at_least="0 W", at_most="1e9 W", varies=True)]
_Diameter = Annotated[float, Quantity("length", above="0 mm", at_most="20 m", varies=True)]
_Azimuth = Annotated[float, Quantity("angle", at_least="-360 deg", at_most="360 deg", varies=True)]
_PressureAngle = Annotated[
    float, Quantity("angle", at_least="0 deg", at_most="45 deg", varies=True)
]


class ShaftLoad(Record):
    """A force and a moment on a shaft at a place.

    Parameters
    ----------
    name
        What to call it.
    shaft
        On which it acts.
    position
        From the shaft's left end, in m.
    fx, fy, fz
        Forces, in N.
    my, mz
        Moments that bend the shaft, in N·m.
    mx
        Torque about the shaft's axis, in N·m; it does not bend.

    Raises
    ------
    InputError
        If a value is out of range.
    """

    name: Line = Field("", examples=["coupling"])
    shaft: Name = Field(examples=["shaft"])
    position: Place = Field(examples=["150 mm"])
    fx: _Force = Field(0.0, examples=["1 kN"])
    fy: _Force = Field(0.0, examples=["1 kN"])
    fz: _Force = Field(0.0, examples=["-5 kN"])
    my: _Moment = Field(0.0, examples=["50 N m"])
    mz: _Moment = Field(0.0, examples=["50 N m"])
    mx: _Moment = Field(0.0, examples=["100 N m"])

    def forces(self, speed: float = 0.0) -> Six:
        """Return force and moment on the shaft; speed: of the shaft, which has no say."""
        return self.fx, self.fy, self.fz, self.mx, self.my, self.mz


# --- gears ----------------------------------------------------------------------------------------

GearKind = Literal["spur", "helical", "bevel", "worm", "worm_wheel"]
_NEEDED: Final = {
    "helical": {"helix_angle": 'helix_angle = "15 deg"'},
    "bevel": {"cone_angle": 'cone_angle = "20 deg"', "apex": 'apex = "-x"'},
    "worm": {
        "lead_angle": 'lead_angle = "10 deg"',
        "friction_coefficient": "friction_coefficient = 0.05",
    },
    "worm_wheel": {
        "lead_angle": 'lead_angle = "10 deg"',
        "friction_coefficient": "friction_coefficient = 0.05",
    },
}
"""What a kind of gear cannot do without, and examples."""
_OF_KINDS: Final = {
    "helix_angle": ("helical", "bevel"),
    "hand": ("helical", "bevel", "worm", "worm_wheel"),
    "cone_angle": ("bevel",),
    "apex": ("bevel",),
    "lead_angle": ("worm", "worm_wheel"),
    "friction_coefficient": ("worm", "worm_wheel"),
    "mate": ("spur", "helical"),
}
"""Fields that only some kinds have."""
_ALIKE: Final = ("pressure_angle", "helix_angle")
"""What gears in mesh have in common."""


class Gear(Record):
    """A gear on a shaft, for the forces of its mesh.

    Tangential force F_t = 2T/d at the pitch diameter d. Spur, helical and bevel gears
    (Niemann/Winter, Maschinenelemente 2, 21.5 and 24.4; Shigley, Mechanical Engineering Design,
    13-14 to 13-16), with δ = 0 of a cylindrical gear: F_t tan α_n/cos β into the pitch cone, normal
    to it, and F_t tan β along its generator. Worms with friction: Shigley, 13-17.

    Parameters
    ----------
    name
        What to call it; a mate names it so.
    shaft
        On which it is.
    position
        Of its mid-plane from the shaft's left end, in m.
    kind
        ``"spur"``, ``"helical"``, ``"bevel"``, ``"worm"`` or ``"worm_wheel"``.
    pitch_diameter
        d at which the mesh acts, in m: the operating pitch diameter; of a bevel gear in the middle
        of the face. Or:
    teeth, module
        z and the normal module m_n, in m: d = z m_n/cos β; of a bevel gear with its module at the
        heel d = z m - b sin δ, with the face width.
    face_width
        b, in m.
    pressure_angle
        α_n, in the normal section, in rad.
    helix_angle
        β, in rad; of a bevel gear the spiral angle in the middle of the face.
    hand
        ``"right"`` or ``"left"``, of helix, spiral or thread.
    cone_angle
        δ, between the shaft and the pitch cone of a bevel gear, in rad.
    apex
        Where the tip of a bevel gear's pitch cone points: ``"+x"`` or ``"-x"``.
    lead_angle
        γ of the worm, in rad; its wheel has the same.
    friction_coefficient
        μ between worm and wheel.
    torque
        About the shaft's axis, in N·m, without a sign: `drives` gives its sense. Or:
    power
        In W, with the shaft's speed.
    mesh_azimuth
        φ of the mesh point about the shaft, in rad: 0 at +z, π/2 at +y.
    drives
        Whether this gear drives the other one: power leaves the shaft through the mesh.
    mate
        Name of the gear in mesh with it, on a parallel shaft: action and reaction are equal. One
        of the two gives the torque; the other takes it, and the azimuth, from its mate.

    Raises
    ------
    InputError
        If a value is missing or out of range, or not one of its kind.
    """

    name: Line = Field("", examples=["pinion"])
    shaft: Name = Field(examples=["shaft"])
    position: Place = Field(examples=["150 mm"])
    kind: GearKind = Field("spur", examples=["helical"])
    pitch_diameter: Annotated[_Diameter | None, Replaces("teeth", "module")] = Field(
        None, examples=["120 mm"]
    )
    teeth: (
        Annotated[int, Count, Field(strict=True, ge=1, le=10_000), Replaces("pitch_diameter")]
        | None
    ) = Field(None, examples=[29])
    module: Annotated[
        Annotated[float, Quantity("length", above="0 mm", at_most="1 m", varies=True)] | None,
        Replaces("pitch_diameter"),
    ] = Field(None, examples=["4 mm"])
    face_width: _Diameter | None = Field(None, examples=["40 mm"])
    pressure_angle: _PressureAngle = Field(math.radians(20.0), examples=["20 deg"])
    helix_angle: Annotated[
        float, Quantity("angle", at_least="0 deg", at_most="60 deg", varies=True)
    ] = Field(0.0, examples=["15 deg"])
    hand: Literal["right", "left"] = Field("right", examples=["left"])
    cone_angle: (
        Annotated[float, Quantity("angle", above="0 deg", at_most="90 deg", varies=True)] | None
    ) = Field(None, examples=["20 deg"])
    apex: Literal["+x", "-x"] | None = Field(None, examples=["-x"])
    lead_angle: (
        Annotated[float, Quantity("angle", above="0 deg", at_most="60 deg", varies=True)] | None
    ) = Field(None, examples=["10 deg"])
    friction_coefficient: (
        Annotated[float, Quantity(at_least=0.0, at_most=0.5, varies=True)] | None
    ) = Field(None, examples=[0.05])
    torque: Annotated[_Torque | None, Replaces("power")] = Field(None, examples=["250 N m"])
    power: Annotated[_Power | None, Replaces("torque")] = Field(None, examples=["30 kW"])
    mesh_azimuth: _Azimuth | None = Field(None, examples=["90 deg"])
    drives: bool | None = Field(None, examples=[True])
    mate: Name | None = Field(None, examples=["wheel"])

    @model_validator(mode="after")
    def _of_its_kind(self) -> Self:
        for name, kinds in _OF_KINDS.items():
            default = type(self).model_fields[name].default
            if self.kind not in kinds and getattr(self, name) != default:
                raise InputError(
                    said("is not for kind {kind}", kind=f'"{self.kind}"'),
                    field=name,
                    value=_shown(self, name),
                    example=f'kind = "{kinds[0]}"',
                )
        for name, example in _NEEDED.get(self.kind, {}).items():
            if not getattr(self, name) and getattr(self, name) != 0.0:
                raise _missing(name, self.kind, example)
        if self.kind == "helical" and self.helix_angle == 0.0:
            raise _missing("helix_angle", self.kind, 'helix_angle = "15 deg", or kind = "spur"')
        return self

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        if self.pitch_diameter is not None:
            for name in ("teeth", "module"):
                if getattr(self, name) is not None:
                    raise InputError(
                        said("cannot be combined with {before}", before="pitch_diameter"),
                        field=name,
                        value=_shown(self, name),
                    )
        elif self.teeth is None or self.module is None:
            raise InputError(
                said("is missing; or teeth and module"),
                field="pitch_diameter",
                example='pitch_diameter = "120 mm"',
            )
        elif self.kind == "worm":
            raise InputError(
                said("is missing: that of a worm does not follow from threads and module"),
                field="pitch_diameter",
                example='pitch_diameter = "50 mm"',
            )
        if not self.diameter > 0.0:
            raise InputError(
                said("is wider than the pitch cone is long"),
                field="face_width",
                value=_shown(self, "face_width"),
            )
        if self.torque is not None and self.power is not None:
            raise InputError(
                said("cannot be combined with {before}", before="torque"),
                field="power",
                value=_shown(self, "power"),
            )
        if not self.follows_mate:
            self._check_of_its_own()
        return self

    def _check_of_its_own(self) -> None:
        if self.torque is None and self.power is None:
            raise InputError(
                said("is missing; or power, or the name of a mate that has it"),
                field="torque",
                example='torque = "250 N m"',
            )
        for name, example in (("mesh_azimuth", '"90 deg"'), ("drives", "true")):
            if getattr(self, name) is None:
                raise InputError(said("is missing"), field=name, example=f"{name} = {example}")
        if self.kind in ("worm", "worm_wheel"):
            self._worm_parts()

    @property
    def follows_mate(self) -> bool:
        """Whether its torque is that of its mate."""
        return self.mate is not None and self.torque is None and self.power is None

    @property
    def diameter(self) -> float:
        """Pitch diameter d at which the mesh acts; m."""
        if self.pitch_diameter is not None:
            return self.pitch_diameter
        assert self.teeth is not None
        assert self.module is not None
        if self.kind == "bevel":
            return self.teeth * self.module - (self.face_width or 0.0) * math.sin(self._cone)
        if self.kind == "worm_wheel":  # its transverse module is the worm's axial one
            return self.teeth * self.module
        return self.teeth * self.module / math.cos(self.helix_angle)

    @property
    def _cone(self) -> float:
        return self.cone_angle or 0.0

    @property
    def _sense(self) -> float:
        """+1 of a right hand."""
        return 1.0 if self.hand == "right" else -1.0

    def torque_at(self, speed: float) -> float:
        """Return the torque, without a sign; N·m.

        Parameters
        ----------
        speed
            Of the shaft, in rad/s.

        Raises
        ------
        InputError
            If the power is given and nothing turns, or the torque is its mate's.
        """
        if self.torque is not None:
            return self.torque
        if self.power is None:
            raise InputError(
                said("is missing: it is that of its mate"), field="torque", value=ABSENT
            )
        return _torque_of(self.power, speed)

    def forces(self, speed: float) -> Six:
        """Return force and moment on the shaft, at its axis.

        Parameters
        ----------
        speed
            Of the shaft, in rad/s; its sign gives the sense of rotation. A gear at rest has the
            forces of one that is about to turn positively.

        Returns
        -------
        fx, fy, fz, mx, my, mz, in N and N·m.

        Raises
        ------
        InputError
            As of `torque_at`.

        >>> gear = Gear(shaft="s", position=0.1, pitch_diameter=0.1, torque=50.0, drives=True,
        ...             mesh_azimuth=0.0)
        >>> [round(value, 3) for value in gear.forces(100.0)]
        [0.0, 1000.0, -363.97, -50.0, 0.0, 0.0]
        """
        tangential = 2.0 * self.torque_at(speed) / self.diameter
        turning = -1.0 if speed < 0.0 else 1.0
        along = -turning if self.drives else turning  # of the force, by e_t
        if self.kind in ("worm", "worm_wheel"):
            axial, inward = self._worm_forces(tangential, along)
        else:
            axial, inward = self._tooth_forces(tangential, along)
        return at_radius(
            0.5 * self.diameter, self.mesh_azimuth or 0.0, (axial, -inward, along * tangential)
        )

    def _tooth_forces(self, tangential: float, along: float) -> tuple[float, float]:
        """Axial and inward force of spur, helical and bevel gears."""
        cone, apex = self._cone, -1.0 if self.apex == "-x" else 1.0
        pressed = tangential * math.tan(self.pressure_angle) / math.cos(self.helix_angle)
        # of the tooth's slant: from the tip of the cone to its heel
        slant = self._sense * apex * along * tangential * math.tan(self.helix_angle)
        axial = -apex * (pressed * math.sin(cone) + slant * math.cos(cone))
        return axial, pressed * math.cos(cone) - slant * math.sin(cone)

    def _worm_parts(self) -> tuple[float, float]:
        """What a unit of normal force gives along the worm's axis, and about it.

        Raises
        ------
        InputError
            If friction holds what drives: the worm is self-locking, or jams.
        """
        lead, friction = self.lead_angle or 0.0, self.friction_coefficient or 0.0
        worm_drives = bool(self.drives) == (self.kind == "worm")
        rubbing = friction if worm_drives else -friction
        pressed = math.cos(self.pressure_angle)
        push = pressed * math.cos(lead) - rubbing * math.sin(lead)
        turn = pressed * math.sin(lead) + rubbing * math.cos(lead)
        if min(push, turn) <= 0.0:
            raise InputError(
                said("is too large for this lead angle: the worm is self-locking"),
                field="friction_coefficient",
                value=self.friction_coefficient,
                example="friction_coefficient = 0.03",
            )
        return push, turn

    def _worm_forces(self, tangential: float, along: float) -> tuple[float, float]:
        """Axial and inward force of a worm, or of its wheel."""
        push, turn = self._worm_parts()
        own, other = (turn, push) if self.kind == "worm" else (push, turn)
        normal = tangential / own
        return -self._sense * along * normal * other, normal * math.sin(self.pressure_angle)


def at_radius(radius: float, azimuth: float, force: Vector) -> Six:
    """Return force and moment at the axis of a force at a point of a circle.

    Parameters
    ----------
    radius
        Of the circle, in m.
    azimuth
        φ of the point, in rad.
    force
        Its parts along x, e_r and e_t, in N.
    """
    sine, cosine = math.sin(azimuth), math.cos(azimuth)
    axial, radial, tangential = force
    # e_r = (0, sin, cos), e_t = (0, -cos, sin); r × F = r (F_t x - F_x e_t)
    return (
        axial + 0.0,
        radial * sine - tangential * cosine + 0.0,
        radial * cosine + tangential * sine + 0.0,
        radius * tangential + 0.0,
        radius * axial * cosine + 0.0,
        -radius * axial * sine + 0.0,
    )


def mirrored(gear: Gear, mate: Gear, forces: Six) -> Six:
    """Return the forces on a gear whose mate has given ones: equal and opposite at the mesh point.

    Parameters
    ----------
    gear, mate
        The gear, and the one that gives the torque, on parallel shafts.
    forces
        On the shaft of the mate, of its method `forces`.
    """
    azimuth = mate.mesh_azimuth or 0.0
    sine, cosine = math.sin(azimuth), math.cos(azimuth)
    fx, fy, fz = (-part for part in forces[:3])
    # seen from the other shaft the mesh point is on the other side
    radial, tangential = -(fy * sine + fz * cosine), -(-fy * cosine + fz * sine)
    return at_radius(0.5 * gear.diameter, azimuth + math.pi, (fx, radial, tangential))


class OperatingMesh(NamedTuple):
    """Normal module, in m, normal pressure angle and helix angle, in rad, at the pitch circles."""

    module: float
    pressure_angle: float
    helix_angle: float


def operating_mesh(
    centre_distance: float,
    teeth: int,
    module: float,
    pressure_angle: float,
    helix_angle: float = 0.0,
) -> OperatingMesh:
    """Return what acts where the pitch circles of two cylindrical gears roll on each other.

    With profile shift these circles are not the reference circles: cos α_wt = a_0/a cos α_t and
    tan β_w = a/a_0 tan β, with the reference centre distance a_0 = Σz m_n/(2 cos β) (ISO 21771).

    Parameters
    ----------
    centre_distance
        a of the two axes, in m.
    teeth
        Σz of both gears.
    module, pressure_angle, helix_angle
        m_n, α_n and β at the reference circles, in m and rad.

    Raises
    ------
    InputError
        If the axes are so close that no such gears mesh.

    >>> found = operating_mesh(0.092, 90, 0.002, math.radians(20.0))
    >>> [round(value, 4) for value in (1e3 * found.module, math.degrees(found.pressure_angle))]
    [2.0444, 23.1812]
    """
    reference = 0.5 * teeth * module / math.cos(helix_angle)
    stretched = centre_distance / reference
    transverse = math.atan(math.tan(pressure_angle) / math.cos(helix_angle))
    cosine = math.cos(transverse) / stretched
    if not 0.0 < cosine <= 1.0:
        raise InputError(
            said("is too short for these gears, whose reference circles need {reference}",
                 reference=readable(reference, "length")),
            field="centre_distance",
            value=readable(centre_distance, "length"),
        )  # fmt: skip
    helix = math.atan(stretched * math.tan(helix_angle))
    normal = math.atan(math.tan(math.acos(cosine)) * math.cos(helix))
    return OperatingMesh(2.0 * centre_distance / teeth * math.cos(helix), normal, helix)


# --- belts and chains -----------------------------------------------------------------------------


class Belt(Record):
    """A pulley or a chain wheel: the pull of its two strands.

    Parameters
    ----------
    name
        What to call it.
    shaft
        On which it is.
    position
        Of its mid-plane from the shaft's left end, in m.
    diameter
        Effective diameter of the pulley, in m.
    tight, slack
        Pulls of the two strands, in N; or:
    tension
        Pull of each strand at rest, in N, with
    torque
        about the shaft's axis, in N·m, without a sign; or
    power
        in W, with the shaft's speed.
    azimuth
        Where the other pulley is, as seen from this shaft, in rad: 0 at +z, π/2 at +y.
    wrap_angle
        Of the belt on the pulley, in rad; π with parallel strands.
    drives
        Whether this pulley drives the other one: power leaves the shaft through the belt.

    Raises
    ------
    InputError
        If a value is missing or out of range, or a strand would have no tension left.
    """

    name: Line = Field("", examples=["pulley"])
    shaft: Name = Field(examples=["shaft"])
    position: Place = Field(examples=["20 mm"])
    diameter: _Diameter = Field(examples=["160 mm"])
    tight: Annotated[_Pull | None, Replaces("tension", "torque", "power")] = Field(
        None, examples=["1500 N"]
    )
    slack: Annotated[_Pull | None, Replaces("tension", "torque", "power")] = Field(
        None, examples=["500 N"]
    )
    tension: Annotated[_Pull | None, Replaces("tight", "slack")] = Field(None, examples=["1000 N"])
    torque: Annotated[_Torque | None, Replaces("tight", "slack", "power")] = Field(
        None, examples=["80 N m"]
    )
    power: Annotated[_Power | None, Replaces("tight", "slack", "torque")] = Field(
        None, examples=["11 kW"]
    )
    azimuth: _Azimuth = Field(examples=["180 deg"])
    wrap_angle: Annotated[float, Quantity("angle", above="0 deg", below="360 deg", varies=True)] = (
        Field(math.pi, examples=["180 deg"])
    )
    drives: bool = Field(examples=[False])

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        refuse_rivals(self)
        strands = self.tight is not None or self.slack is not None
        names = ("tight", "slack") if strands else ("tension",)
        for name in names:
            if getattr(self, name) is None:
                rule = (
                    said("is missing; a belt has two strands")
                    if strands
                    else said("is missing; or tight and slack")
                )
                raise InputError(rule, field=name, example=f'{name} = "1000 N"')
        if self.tension is not None and self.torque is None and self.power is None:
            raise InputError(
                said("is missing; tension needs it"), field="torque", example='torque = "80 N m"'
            )
        if self.tight is not None and self.slack is not None and self.slack > self.tight:
            raise InputError(
                said("must be at most {most}, the pull of the tight strand",
                     most=readable(self.tight, "force")),
                field="slack",
                value=readable(self.slack, "force"),
            )  # fmt: skip
        if self.torque is not None:
            self.strands(0.0)
        return self

    def strands(self, speed: float) -> tuple[float, float]:
        """Return the pulls of the tight and of the slack strand; N.

        speed: of the shaft, in rad/s.

        Raises
        ------
        InputError
            If the power is given and nothing turns, or the tension is too low for the torque.
        """
        if self.tight is not None and self.slack is not None:
            return self.tight, self.slack
        assert self.tension is not None
        torque = self.torque if self.power is None else _torque_of(self.power, speed)
        half = (torque or 0.0) / self.diameter
        if half > self.tension * (1.0 + SLIP):
            raise InputError(
                said(
                    "must be at least {least}: with less the slack strand has no tension left",
                    least=readable(half, "force"),
                ),
                field="tension",
                value=readable(self.tension, "force"),
                example=f'tension = "{readable(1.5 * half, "force")}"',
            )
        return self.tension + half, max(self.tension - half, 0.0)

    def forces(self, speed: float) -> Six:
        """Return force and moment on the shaft, at its axis.

        Parameters
        ----------
        speed
            Of the shaft, in rad/s; its sign gives the sense of rotation. A pulley at rest has the
            forces of one that is about to turn positively.

        Returns
        -------
        fx, fy, fz, mx, my, mz, in N and N·m.

        Raises
        ------
        InputError
            As of `strands`.
        """
        tight, slack = self.strands(speed)
        turning = -1.0 if speed < 0.0 else 1.0
        # a strand at the side +e_t of the pulley turns it negatively
        side = turning if self.drives else -turning
        opening = 0.5 * (math.pi - self.wrap_angle)
        toward = (tight + slack) * math.cos(opening)
        across = side * (tight - slack) * math.sin(opening)
        fx, fy, fz, *_ = at_radius(0.0, self.azimuth, (0.0, toward, across))
        torque = -side * 0.5 * self.diameter * (tight - slack)
        return fx, fy, fz, torque + 0.0, 0.0, 0.0


# --- masses ---------------------------------------------------------------------------------------


class Inertia(NamedTuple):
    """Mass, in kg, and moments of inertia about a transverse axis and the shaft's, in kg·m²."""

    mass: float
    transverse: float
    polar: float


class Mass(Record):
    """What a shaft carries, such as a rotor, a flywheel or an impeller.

    Parameters
    ----------
    name
        What to call it.
    shaft
        On which it is.
    position
        Of its centre from the shaft's left end, in m.
    mass
        In kg; or the sizes of a disk.
    transverse_inertia, polar_inertia
        About a transverse axis through its centre and about the shaft's axis, in kg·m².
    diameter, bore, width
        Of a disk, in m.
    density
        Of the disk, in kg/m³; that of steel if not given.
    unbalance
        Mass times eccentricity, in kg·m.
    unbalance_azimuth
        Where the unbalance is when the shaft's angle is zero, in rad.

    Raises
    ------
    InputError
        If a value is missing or out of range, or no body has such moments of inertia.
    """

    name: Line = Field("", examples=["rotor"])
    shaft: Name = Field(examples=["shaft"])
    position: Place = Field(examples=["200 mm"])
    mass: Annotated[
        Annotated[float, Quantity("mass", at_least="0 kg", at_most="1e7 kg", varies=True)] | None,
        Replaces("diameter", "bore", "width", "density"),
    ] = Field(None, examples=["12 kg"])
    transverse_inertia: (
        Annotated[float, Quantity("inertia", at_least="0 kg m^2", at_most="1e9 kg m^2")] | None
    ) = Field(None, examples=["0.05 kg m^2"])
    polar_inertia: (
        Annotated[float, Quantity("inertia", at_least="0 kg m^2", at_most="1e9 kg m^2")] | None
    ) = Field(None, examples=["0.08 kg m^2"])
    diameter: Annotated[_Diameter | None, Replaces("mass")] = Field(None, examples=["280 mm"])
    bore: Annotated[float, Quantity("length", at_least="0 mm", at_most="20 m", varies=True)] = (
        Field(0.0, examples=["50 mm"])
    )
    width: Annotated[_Diameter | None, Replaces("mass")] = Field(None, examples=["70 mm"])
    density: Annotated[
        float, Quantity("density", at_least="100 kg/m^3", at_most="25000 kg/m^3", varies=True)
    ] = Field(7850.0, examples=["7810 kg/m^3"])
    unbalance: Annotated[
        float, Quantity("unbalance", at_least="0 g mm", at_most="1e6 kg m", varies=True)
    ] = Field(0.0, examples=["30 g mm"])
    unbalance_azimuth: _Azimuth = Field(0.0, examples=["0 deg"])

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        disk = self.diameter is not None or self.width is not None
        if self.mass is None:
            for name, example in (("diameter", '"280 mm"'), ("width", '"70 mm"')):
                if getattr(self, name) is None:
                    rule = (
                        said("is missing; the mass of a disk needs it")
                        if disk
                        else said("is missing; or diameter and width of a disk")
                    )
                    field, text = (name, f"{name} = {example}") if disk else ("mass", '"12 kg"')
                    raise InputError(rule, field=field, example=text)
            for name in ("transverse_inertia", "polar_inertia"):
                if getattr(self, name) is not None:
                    raise InputError(
                        said("cannot be combined with {before}", before="diameter"),
                        field=name,
                        value=_shown(self, name),
                    )
        elif disk:
            name = "diameter" if self.diameter is not None else "width"
            raise InputError(
                said("cannot be combined with {before}", before="mass"),
                field=name,
                value=_shown(self, name),
            )
        if self.diameter is not None and self.bore >= self.diameter:
            raise InputError(
                said(
                    "must be less than {limit}, {outer}",
                    limit="diameter",
                    outer=readable(self.diameter, "length"),
                ),
                field="bore",
                value=readable(self.bore, "length"),
            )
        _, transverse, polar = self.inertia
        if self.mass is not None and polar > 2.0 * transverse * (1.0 + 1e-9):
            raise InputError(
                said(
                    "must be at most twice the transverse moment of inertia, {most}",
                    most=readable(2.0 * transverse, "inertia"),
                ),
                field="polar_inertia",
                value=readable(polar, "inertia"),
            )
        return self

    @property
    def inertia(self) -> Inertia:
        """Its mass and moments of inertia; those of a disk follow from its sizes."""
        if self.mass is not None:
            return Inertia(self.mass, self.transverse_inertia or 0.0, self.polar_inertia or 0.0)
        assert self.diameter is not None
        assert self.width is not None
        squares = self.diameter**2 + self.bore**2
        area = 0.25 * math.pi * (self.diameter**2 - self.bore**2)
        mass = self.density * area * self.width
        polar = mass * squares / 8.0
        return Inertia(mass, 0.5 * polar + mass * self.width**2 / 12.0, polar)


Direction = Literal["+x", "-x", "+y", "-y", "+z", "-z"]


class Gravity(Record):
    """Gravity, or another acceleration of the whole machine, which gives its masses their weight.

    Parameters
    ----------
    acceleration
        In m/s².
    direction
        In which weights pull, such as ``"-z"``; ``"-x"`` of a vertical shaft that stands on its
        left end.

    Raises
    ------
    InputError
        If a value is out of range.
    """

    acceleration: Annotated[
        float, Quantity("acceleration", at_least="0 m/s^2", at_most="1e6 m/s^2", varies=True)
    ] = Field(STANDARD_GRAVITY, examples=["9.81 m/s^2"])
    direction: Direction = Field("-z", examples=["-z"])

    @property
    def vector(self) -> Vector:
        """Acceleration along x, y and z; m/s²."""
        sign = 1.0 if self.direction[0] == "+" else -1.0
        x, y, z = (sign * self.acceleration * (axis == self.direction[1]) + 0.0 for axis in "xyz")
        return x, y, z


def _torque_of(power: float, speed: float) -> float:
    if speed == 0.0:
        raise InputError(
            said("needs a shaft that turns; at rest give the torque"),
            field="power",
            value=readable(power, "power"),
            example='torque = "250 N m"',
        )
    return power / abs(speed)


def _missing(name: str, kind: str, example: str) -> InputError:
    rule = said('is missing; kind = "{kind}" needs it', kind=kind)
    return InputError(rule, field=name, example=example)


def _shown(record: Record, name: str) -> Any:
    """A value as a file has it."""
    return record.to_mapping().get(name, getattr(record, name))
