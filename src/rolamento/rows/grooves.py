"""Rows of balls on grooves of other forms: two arcs a ring (four-point), or face to face (thrust).

A flank k = ±1 of a row is an arc of the inner and one of the outer ring, whose centres stand off
the middle of their grooves by k s_i and -k s_o: the pair that carries load of the shaft toward k x.
With the inner ring's groove displaced by (x, r) at a ball, whose centre is at X, the flank's
contacts stretch

    Y_o = (X1 + k s_o, X2),        Y_i = (x + k s_i - X1, A2 + r - X2)

and press with Q = K(cos α) (|Y| - L)^1.5 along Y. A ball is in balance when

    Σ_k (F_i - F_o) + (0, F_c) = 0.

Held F_c and K make that the minimum of a convex potential, with one or two flanks. Contact angles
are counted from the radial plane and may pass 90°. The balls orbit with the cage, at its nominal
speed; a ball with more than two contacts cannot roll without slip, so that raceway control says
nothing of its gyroscopic moment: it is left out of the balance, and told (docs/adr/0018).

Hertz (1881); Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapters 2 and 8; Hamrock and
Anderson (1973), Analysis of an arched outer-race ball bearing, for the arcs.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from typing import Any, Final, Self, cast

import numpy as np
from numpy.polynomial import chebyshev

from rolamento.case import Case
from rolamento.case.bearing import RowPlace
from rolamento.contact.hertz import effective_modulus, series_stiffness
from rolamento.geometry import edge_cosine, groove_places
from rolamento.kinematics import (
    ball_mass,
    ball_motion,
    centrifugal_force,
    nominal_orbit,
)
from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.newton import Balance, balance
from rolamento.rows.ball.problem import directions
from rolamento.rows.row import Held, Indices, IntArray, RowGeometry, RowSizes
from rolamento.solved import Elements, Index, Pressed, Tables
from rolamento.static import race_stiffness
from rolamento.status import (
    CONVERGED,
    INVALID_INPUT,
    NOT_CONVERGED,
    OVER_SHOULDER,
    OVERLOADED,
    TOLERANCE,
)

__all__ = ["GrooveRow", "four_point_row", "thrust_row"]

TERMS: Final = 14
"""Chebyshev terms in cos α, from -1 to 1, that give K to 1e-13 of its value up to D/d_m = 0.3,
to 2e-10 up to 0.5."""
PRECISION: Final = 1e-11
NEGLIGIBLE: Final = 1e-7
"""Of the ball's diameter: an approach whose load is none, beside which balls are in balance."""
ROUNDING: Final = 1e-13
"""Of an arc's length L: a lesser approach is no contact."""
POSITION_ROUNDING: Final = 4.0 * np.finfo(np.float64).eps
"""Of an arc's length L: how exactly a ball has a place beside it."""
EDGE: Final = 1e-9
"""Cosine: a contact at the very end of a half circle is past it."""
GREATEST_APPROACH: Final = 0.02
"""Of the ball's diameter: beyond is no elastic contact."""


@dataclass(frozen=True, slots=True)
class _Race:
    """One ring's arcs: L, their shift, the edge, and K as polynomials; (cases,), (terms, cases)."""

    length: FloatArray
    shift: FloatArray
    edge: FloatArray
    stiffness: FloatArray
    slope: FloatArray


@dataclass(frozen=True, slots=True)
class _Numbers:
    """The numbers of the cases of a row; (cases,) each, SI.

    toward: direction of the flank's own side, from the arc's centre; bottom: of its deepest point.
    Both (cases, 2), of the flank that carries toward +x.
    """

    inner: _Race
    outer: _Race
    radial_offset: FloatArray
    arm: FloatArray
    diameter: FloatArray
    pitch: FloatArray
    angle: FloatArray
    toward: FloatArray
    bottom: FloatArray
    mass: FloatArray
    inner_speed: FloatArray
    outer_speed: FloatArray
    first: FloatArray
    orbit: FloatArray
    force: FloatArray
    shown_moment: FloatArray
    rest: FloatArray
    """Where F_c alone presses a ball into the outer ring; (cases, 2)."""


@dataclass(frozen=True, slots=True)
class _Contact:
    """One arc on some balls: load, force (…, 2), its derivative (…, 2, 2), approach, angle."""

    load: FloatArray
    force: FloatArray
    tangent: FloatArray
    approach: FloatArray
    direction: FloatArray


@dataclass(slots=True)
class HeldOnGrooves:
    """Balls in their places; position (cases, balls, 2), place (cases, 5)."""

    place: FloatArray
    position: FloatArray
    face_forces: FloatArray
    stiffness: FloatArray
    scale: FloatArray
    number: IntArray
    residual: FloatArray
    safe_path: BoolArray

    @property
    def force(self) -> FloatArray:
        """(cases, 5), N and N·m."""
        return np.asarray(self.face_forces.sum(axis=1))

    def put(self, cases: Indices, part: Self) -> None:
        """Copy what some of the cases answered to their places."""
        for one in fields(self):
            getattr(self, one.name)[cases] = getattr(part, one.name)


@dataclass(frozen=True, slots=True)
class GrooveRow:
    """Many cases of a row of balls on one or two flanks, each +1 or -1."""

    numbers: _Numbers
    element_count: int
    flanks: tuple[float, ...]
    geometry: RowGeometry
    sound: BoolArray

    @property
    def cases(self) -> int:
        """How many."""
        return len(self.sound)

    @property
    def faces(self) -> tuple[float, ...]:
        """The rows of contacts that the balls make, by the way each faces."""
        return self.flanks

    @property
    def valid(self) -> BoolArray:
        """Which cases have numbers that can be solved; (cases,)."""
        n = self.numbers
        given = (
            n.inner.length, n.outer.length, n.radial_offset, n.arm, n.force, n.first,
            n.inner.stiffness.sum(axis=0), n.outer.stiffness.sum(axis=0),
        )  # fmt: skip
        return np.asarray(self.sound & np.isfinite(np.sum(given, axis=0)))

    @property
    def sizes(self) -> RowSizes:
        """For the assembly."""
        n = self.numbers
        reach = n.inner.length + n.outer.length
        return RowSizes(
            arm=n.arm,
            diameter=n.diameter,
            reach=reach,
            stiffness=_both(n),
            sine=np.sin(n.angle),
        )

    @property
    def driven(self) -> BoolArray:
        """Whether a centrifugal force acts on the balls; (cases,)."""
        return np.asarray(self.numbers.force > 0.0)

    def refuse(self, cases: BoolArray) -> None:
        """Take some cases for invalid: they are left alone."""
        self.sound[cases] = False

    # --- solving --------------------------------------------------------------------------------

    def held(self, place: FloatArray, which: Indices, control: FloatArray) -> HeldOnGrooves:
        """Hold some of the cases at a place; (len(which), 5)."""
        if not len(which):
            return self.nothing(0)
        n = _taken(self.numbers, which)
        cases, balls = len(which), self.element_count
        cosine, sine = self._azimuth(n)
        centre = _inner_centres(n, place, cosine, sine)
        share = (n.outer.length / (n.outer.length + n.inner.length))[:, np.newaxis, np.newaxis]
        of_ball = np.repeat(np.arange(cases), balls)
        ball = _taken(n, of_ball)
        centres = centre.reshape(-1, 2)
        line = (share * centre).reshape(-1, 2)
        if len(self.flanks) == 1:  # two flanks are even about the middle
            line[:, 0] += np.repeat(share.ravel() * (n.inner.shift + n.outer.shift), balls)
            line[:, 0] -= ball.outer.shift
        gripped = [_flank(ball, k, centres, line)[0].load > ball.force for k in self.flanks]
        loose = (ball.rest[:, 1] > 0.0) & ~np.any(gripped, axis=0)
        start = np.where(loose[:, np.newaxis], ball.rest, line)
        found = _balanced(ball, self.flanks, centres, start)
        at_rest = found.displacement
        parts = [_flank(ball, flank, centres, at_rest) for flank in self.flanks]
        by_ring = np.sum([inner.tangent for inner, _ in parts], axis=0)
        by_ball = by_ring + np.sum([outer.tangent for _, outer in parts], axis=0)
        tangent = by_ring - by_ring @ _solved_2x2(by_ball, by_ring)
        lever = _levers(n, cosine, sine)
        forces = np.stack([inner.force.reshape(cases, balls, 2) for inner, _ in parts], axis=1)
        face_forces = np.einsum("nbij,nfbi->nfj", lever, forces)
        tangents = tangent.reshape(cases, balls, 2, 2)
        load = np.max([inner.load for inner, _ in parts], axis=0).reshape(cases, balls).max(axis=1)
        total = face_forces.sum(axis=1)
        arms = np.stack([np.ones(cases)] * 3 + [n.arm] * 2, axis=1)
        residual = found.residual.reshape(cases, balls).max(axis=1)
        return HeldOnGrooves(
            place=place.copy(),
            position=at_rest.reshape(cases, balls, 2),
            face_forces=face_forces,
            stiffness=np.einsum("nbij,nbik,nbkl->njl", lever, tangents, lever, optimize=True),
            scale=np.maximum(np.maximum(load, np.abs(total / arms).max(axis=1)), _floor(n)),
            number=self._judged(ball, parts, residual, cases),
            residual=residual,
            safe_path=np.zeros(cases, np.bool_),
        )

    def _judged(
        self,
        ball: _Numbers,
        parts: list[tuple[_Contact, _Contact]],
        residual: FloatArray,
        cases: int,
    ) -> IntArray:
        """Return the gravest of what happens to the balls of each case; (cases,)."""
        number = np.full(cases, CONVERGED)
        deep, past = np.zeros(cases, np.bool_), np.zeros(cases, np.bool_)
        for flank, contacts in zip(self.flanks, parts, strict=True):
            bottom = ball.bottom * [flank, 1.0]
            for contact, race in zip(contacts, (ball.inner, ball.outer), strict=True):
                pressed = contact.load > 0.0
                end = race.edge + EDGE
                over = pressed & ((contact.direction * bottom).sum(axis=-1) < end)
                past |= over.reshape(cases, -1).any(axis=1)
                sunk = pressed & (contact.approach > GREATEST_APPROACH * ball.diameter)
                deep |= sunk.reshape(cases, -1).any(axis=1)
        number[deep] = OVERLOADED
        number[past & ~deep] = OVER_SHOULDER
        number[~(residual <= TOLERANCE)] = NOT_CONVERGED
        return number

    def nothing(self, cases: int) -> HeldOnGrooves:
        """Make room for so many cases without a result."""
        return HeldOnGrooves(
            place=np.full((cases, 5), np.nan),
            position=np.full((cases, self.element_count, 2), np.nan),
            face_forces=np.full((cases, len(self.flanks), 5), np.nan),
            stiffness=np.full((cases, 5, 5), np.nan),
            scale=np.full(cases, np.nan),
            number=np.full(cases, INVALID_INPUT),
            residual=np.full(cases, np.nan),
            safe_path=np.zeros(cases, np.bool_),
        )

    def first_contact(self) -> FloatArray:
        """Place along x where the unloaded balls touch; (cases,), m."""
        n = self.numbers
        reach = n.inner.length + n.outer.length
        aside = np.sqrt(np.maximum(reach**2 - n.radial_offset**2, 0.0))
        return np.asarray(aside - n.inner.shift - n.outer.shift)

    def pressed_in(self, force: FloatArray) -> FloatArray:
        """No preload is put on such rows; (cases,), NaN."""
        return np.full(self.cases, np.nan)

    def verdict(self, held: Held, control: FloatArray, which: Index) -> IntArray:
        """Return the control as it is: what guides a ball has no part in this balance."""
        return control.astype(np.int64)

    def answer(
        self, held: Held, control: FloatArray, shown: IntArray, lost: BoolArray
    ) -> GrooveAnswer:
        """Keep what the tables are made from, of cases that are not lost."""
        balls = cast(HeldOnGrooves, held)
        balls.position[lost], balls.place[lost] = np.nan, np.nan
        codes = np.broadcast_to(shown, (self.cases, self.element_count))
        return GrooveAnswer(self.numbers, self.flanks, balls.place, balls.position, codes)

    def _azimuth(self, n: _Numbers) -> tuple[FloatArray, FloatArray]:
        return _directions(n.first, self.element_count)


@dataclass(frozen=True, slots=True)
class GrooveAnswer:
    """Where the balls of solved cases are: what their tables are made from."""

    numbers: _Numbers
    flanks: tuple[float, ...]
    place: FloatArray
    position: FloatArray
    shown: IntArray

    def part(self, index: Index) -> GrooveAnswer:
        """Return some of the cases."""
        return GrooveAnswer(
            _taken(self.numbers, index), self.flanks, self.place[index], self.position[index],
            self.shown[index],
        )  # fmt: skip

    def tables(self) -> Tables:
        """Evaluate every contact of every case: flank after flank, each in its own frame."""
        cases, balls = self.shown.shape
        case = np.repeat(np.arange(cases), balls)
        ball = _taken(self.numbers, case)
        cosine, sine = _directions(self.numbers.first, balls)
        centre = _inner_centres(self.numbers, self.place, cosine, sine).reshape(-1, 2)
        at_rest = self.position.reshape(-1, 2)
        parts = [_flank(ball, flank, centre, at_rest) for flank in self.flanks]
        angles = [
            [np.arctan2(flank * one.direction[:, 0], one.direction[:, 1]) for one in contacts]
            for flank, contacts in zip(self.flanks, parts, strict=True)
        ]
        control = self.shown.ravel()
        ratio = ball.diameter / ball.pitch
        motions = [
            ball_motion(
                inner, outer, ratio, ball.inner_speed, ball.outer_speed, control, orbit=ball.orbit
            )
            for inner, outer in angles
        ]
        # a ball has one rotation: that of its flanks, each as raceway control would have it,
        # weighted by their loads
        loads = np.stack([inner.load + outer.load for inner, outer in parts])
        share = np.where(loads.sum(axis=0) > 0.0, loads, 1.0)
        share = share / share.sum(axis=0)
        axis_x, axis_r = np.zeros_like(ball.orbit), np.zeros_like(ball.orbit)
        for flank, part, motion in zip(self.flanks, share, motions, strict=True):
            axis_x = axis_x + part * motion.ball_speed * np.cos(motion.attitude)
            axis_r = axis_r + part * motion.ball_speed * np.sin(motion.attitude) * flank
        way = np.where(motions[0].ball_speed < 0.0, -1.0, 1.0)
        speed = way * np.hypot(axis_x, axis_r)
        attitude = np.arctan2(way * axis_r, way * axis_x)
        columns = []
        for index, flank in enumerate(self.flanks):
            inner, outer = angles[index]
            own = flank * attitude
            ball_x, ball_r = ball.orbit + speed * np.cos(own), -speed * np.sin(own)
            # the moment of a ball counts once
            inertia = ball.shown_moment * ball.mass * ball.diameter**2 / 10.0
            moment = inertia * speed * ball.orbit * np.sin(own) * (1.0 if index == 0 else 0.0)
            behind, ahead = ball_x - ball.inner_speed, ball_x - ball.outer_speed
            columns.append(
                (
                    own,
                    moment,
                    _pressed(
                        parts[index][0], inner,
                        behind * np.sin(inner) + ball_r * np.cos(inner),
                        behind * np.cos(inner) - ball_r * np.sin(inner),
                    ),
                    _pressed(
                        parts[index][1], outer,
                        -ahead * np.sin(outer) - ball_r * np.cos(outer),
                        ahead * np.cos(outer) - ball_r * np.sin(outer),
                    ),
                )
            )  # fmt: skip
        faces = len(self.flanks)

        def wide(columns_of_flanks: list[FloatArray]) -> FloatArray:
            return np.concatenate([c.reshape(cases, balls) for c in columns_of_flanks], axis=1)

        known = 0.0 * at_rest[:, 0]
        turned = self.numbers.first[:, np.newaxis] + 2.0 * np.pi * np.arange(balls) / balls
        wrapped = np.mod(turned, 2.0 * np.pi)
        azimuth = np.where(wrapped < 2.0 * np.pi, wrapped, 0.0)
        elements = Elements(
            row=np.repeat(np.arange(faces), balls),
            azimuth=np.tile(azimuth, (1, faces)),
            centrifugal_force=wide([ball.force + known] * faces),
            gyroscopic_moment=wide([column[1] for column in columns]),
            orbital_speed=wide([ball.orbit + known] * faces),
            ball_speed=wide([speed] * faces),
            attitude=wide([column[0] for column in columns]),
            yaw=np.zeros((cases, faces * balls)),
            raceway_control=np.tile(self.shown, (1, faces)),
        )
        inner_race, outer_race = (
            Pressed(*(wide([getattr(c[i], one.name) for c in columns]) for one in fields(Pressed)))
            for i in (2, 3)
        )
        return Tables(elements, inner_race, outer_race)


# --- from a case to its numbers -------------------------------------------------------------------


def four_point_row(
    case: Case, place: RowPlace, bearing: Any, varied: Mapping[str, FloatArray], cases: int
) -> GrooveRow:
    """The numbers of a four-point row; bearing: attributes, numbers or arrays (cases,).

    Both arcs of a ring stand off its middle by s = (f - ½) D sin α_s.
    """
    with np.errstate(invalid="ignore", divide="ignore"):
        return _row(case, place, bearing, varied, cases, (1.0, -1.0))


def thrust_row(
    case: Case, place: RowPlace, bearing: Any, varied: Mapping[str, FloatArray], cases: int
) -> GrooveRow:
    """The numbers of a thrust row; as `four_point_row`."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return _row(case, place, bearing, varied, cases, (1.0,))


def _row(
    case: Case,
    place: RowPlace,
    bearing: Any,
    varied: Mapping[str, FloatArray],
    cases: int,
    flanks: tuple[float, ...],
) -> GrooveRow:
    diameter, pitch = (_column(getattr(bearing, n), cases) for n in _BALLS)
    given = {n: getattr(bearing, n) for n in ("contact_angle", "diametral_clearance")}
    shim = bearing.shim_angle if len(flanks) > 1 else None
    places = groove_places(
        diameter, pitch, bearing.inner_conformity, bearing.outer_conformity,
        shim_angle=shim, **given,
    )  # fmt: skip
    inner_length, outer_length, axial, radial, arm = (_column(one, cases) for one in places)
    reach = inner_length + outer_length
    angle = np.arccos(np.clip(radial / reach, -1.0, 1.0))
    if shim is None:
        own = _column(bearing.contact_angle, cases)
        shifts = {"inner": axial, "outer": 0.0 * axial}
        toward = np.stack([np.sin(own), np.cos(own)], axis=1)
        bottom, angle = toward, own
    else:
        sine = np.sin(_column(shim, cases))
        shifts = {"inner": inner_length * sine, "outer": outer_length * sine}
        toward = np.tile([1.0, 0.0], (cases, 1))
        bottom = np.tile([0.0, 1.0], (cases, 1))
    nodes = chebyshev.chebpts1(TERMS)
    exact = race_stiffness(bearing, np.arccos(nodes)[:, np.newaxis])
    races = {}
    for race, length in (("inner", inner_length), ("outer", outer_length)):
        values = np.broadcast_to(getattr(exact, race), (TERMS, cases))
        # the discrete transform at the nodes; exact.inner may be NaN, which a fit would not take
        fit = np.linalg.solve(chebyshev.chebvander(nodes, TERMS - 1), values)
        races[race] = _Race(
            length=length,
            shift=shifts[race],
            edge=_column(edge_cosine(bearing, race), cases),  # type: ignore[arg-type]
            stiffness=fit,
            slope=np.asarray(chebyshev.chebder(fit)),
        )
    duty, model = case.duty, case.model
    speeds = [_column(varied.get(f"duty.{n}", getattr(duty, n)), cases) for n in _SPEEDS]
    first = varied.get("duty.first_ball_azimuth", np.asarray(duty.first_ball_azimuth))
    mass = ball_mass(diameter, bearing.ball_material.density)
    orbit = nominal_orbit(diameter / pitch * np.cos(angle), *speeds)
    modulus = effective_modulus(bearing.ring_material, bearing.ball_material)
    numbers = _Numbers(
        inner=races["inner"],
        outer=races["outer"],
        radial_offset=radial,
        arm=arm,
        diameter=diameter,
        pitch=pitch,
        angle=angle,
        toward=toward,
        bottom=bottom,
        mass=_column(mass, cases),
        inner_speed=speeds[0],
        outer_speed=speeds[1],
        first=_column(first + place.phase, cases),
        orbit=_column(orbit, cases),
        force=_column(model.centrifugal_force * centrifugal_force(mass, pitch, orbit), cases),
        shown_moment=np.full(cases, float(model.gyroscopic_moment)),
        rest=np.zeros((cases, 2)),
    )
    if len(flanks) > 1 and (numbers.force > 0.0).any():
        numbers = replace(numbers, rest=_rest(numbers, flanks))
    shown = 0.0 if bearing.contact_angle is None else bearing.contact_angle
    geometry = (
        diameter, pitch, bearing.inner_conformity, bearing.outer_conformity, shown, modulus,
    )  # fmt: skip
    return GrooveRow(
        numbers,
        place.bearing.element_count,
        flanks,
        RowGeometry(*(_column(one, cases) for one in geometry)),
        np.ones(cases, np.bool_),
    )


_BALLS: Final = ("ball_diameter", "pitch_diameter")
_SPEEDS: Final = ("inner_speed", "outer_speed")


def _column(value: Any, cases: int) -> FloatArray:
    return np.array(np.broadcast_to(np.asarray(value, np.float64), cases))


def _taken(numbers: _Numbers, index: Index) -> _Numbers:
    """Some of the cases, as often as they are named; polynomials have them last."""

    def of_race(race: _Race) -> _Race:
        stiffness, slope = race.stiffness[:, index], race.slope[:, index]
        return _Race(race.length[index], race.shift[index], race.edge[index], stiffness, slope)

    plain = {
        one.name: getattr(numbers, one.name)[index]
        for one in fields(numbers)
        if one.name not in ("inner", "outer")
    }
    return _Numbers(inner=of_race(numbers.inner), outer=of_race(numbers.outer), **plain)


# --- the mechanics --------------------------------------------------------------------------------


def _directions(first: FloatArray, balls: int) -> tuple[FloatArray, FloatArray]:
    """Cosine and sine of every ball's azimuth; (cases, balls) each."""
    c0, s0 = np.cos(first)[:, np.newaxis], np.sin(first)[:, np.newaxis]
    c, s = directions(balls)
    return c * c0 - s * s0, s * c0 + c * s0


def _levers(n: _Numbers, cosine: FloatArray, sine: FloatArray) -> FloatArray:
    """d(x, r)/d place of the inner groove's centre at a ball; (cases, balls, 2, 5)."""
    lever = np.zeros((*cosine.shape, 2, 5))
    lever[..., 0, 0] = 1.0
    lever[..., 1, 1], lever[..., 1, 2] = sine, cosine
    arm = n.arm[:, np.newaxis]
    lever[..., 0, 3], lever[..., 0, 4] = arm * cosine, -arm * sine
    return lever


def _inner_centres(
    n: _Numbers, place: FloatArray, cosine: FloatArray, sine: FloatArray
) -> FloatArray:
    """The middle of the inner ring's groove centres over that of the outer's; (cases, balls, 2)."""
    centre = np.einsum("nbij,nj->nbi", _levers(n, cosine, sine), place)
    centre[..., 1] += n.radial_offset[:, np.newaxis]
    return np.asarray(centre)


def _flank(
    n: _Numbers, flank: float, centre: FloatArray, position: FloatArray
) -> tuple[_Contact, _Contact]:
    """The inner and the outer contact of one flank on every ball; n, centre, position by ball."""
    own_side = n.toward * [flank, 1.0]
    inward, outward = centre - position, position.copy()
    inward[:, 0] += flank * n.inner.shift
    outward[:, 0] += flank * n.outer.shift
    return _contact(n.inner, inward, own_side), _contact(n.outer, outward, own_side)


def _contact(race: _Race, stretch: FloatArray, own_side: FloatArray) -> _Contact:
    """What an arc answers to a ball at a stretch from its centre, on its own side; see the head."""
    distance = np.maximum(np.hypot(stretch[:, 0], stretch[:, 1]), 1e-30)
    normal = stretch / distance[:, np.newaxis]
    approach = distance - race.length
    on_it = (normal * own_side).sum(axis=-1) > 0.0
    on_it &= approach > ROUNDING * race.length
    pressed = np.where(on_it, approach, 0.0 * approach)
    root = np.sqrt(pressed)
    cosine = normal[:, 1]
    stiffness, slope = _with_slope(race, cosine)
    load = stiffness * pressed * root
    turn = np.stack([-normal[:, 0] * normal[:, 1], normal[:, 0] ** 2], axis=1)
    turn /= distance[:, np.newaxis]  # gradient of cos α
    rise = (1.5 * stiffness * root)[:, np.newaxis] * normal
    rise += (slope * pressed * root)[:, np.newaxis] * turn
    across = np.eye(2) - normal[:, :, np.newaxis] * normal[:, np.newaxis, :]
    tangent = normal[:, :, np.newaxis] * rise[:, np.newaxis, :]
    tangent += (load / distance)[:, np.newaxis, np.newaxis] * across
    return _Contact(load, load[:, np.newaxis] * normal, tangent, approach, normal)


def _polynomial(coefficients: FloatArray, cosine: FloatArray) -> FloatArray:
    return np.asarray(chebyshev.chebval(cosine, coefficients, tensor=False))


def _with_slope(race: _Race, cosine: FloatArray) -> tuple[FloatArray, FloatArray]:
    """K and dK/d cos α, both of the same Chebyshev polynomials T_k = 2 cos α T_k-1 - T_k-2."""
    basis = np.empty((TERMS, len(cosine)))
    basis[0], basis[1] = 1.0, cosine
    twice = 2.0 * cosine
    for k in range(2, TERMS):
        basis[k] = twice * basis[k - 1] - basis[k - 2]
    slope = np.einsum("kn,kn->n", race.slope, basis[:-1])
    return np.einsum("kn,kn->n", race.stiffness, basis), slope


@dataclass(frozen=True, slots=True)
class _OnBalls:
    """What resists the balls, as `numerics.newton` asks for it."""

    force: FloatArray
    stiffness: FloatArray
    scale: FloatArray
    sound: BoolArray


def _on_balls(
    n: _Numbers,
    flanks: tuple[float, ...],
    centre: FloatArray,
    position: FloatArray,
    floor: FloatArray,
) -> _OnBalls:
    force, stiffness = np.zeros(position.shape), np.zeros((len(position), 2, 2))
    scale = np.maximum(floor, n.force)
    for flank in flanks:
        inner, outer = _flank(n, flank, centre, position)
        force += outer.force - inner.force
        stiffness += outer.tangent + inner.tangent
        scale = np.maximum(scale, np.maximum(inner.load, outer.load))
    # a light contact's approach is the difference of two lengths: no step betters its rounding
    rounding = POSITION_ROUNDING * np.maximum(n.inner.length, n.outer.length)
    stiffest = np.einsum("nii->ni", stiffness).max(axis=1)
    scale = np.maximum(scale, rounding * stiffest / PRECISION)
    return _OnBalls(force, stiffness, scale, np.asarray(np.isfinite(force).all(axis=1)))


def _both(n: _Numbers) -> FloatArray:
    """K of both contacts in line at the free contact angle."""
    middle = np.cos(n.angle)
    return series_stiffness(
        _polynomial(n.inner.stiffness, middle), _polynomial(n.outer.stiffness, middle)
    )


def _floor(n: _Numbers) -> FloatArray:
    """A load that counts as none (N)."""
    return np.asarray(_both(n) * (NEGLIGIBLE * n.diameter) ** 1.5)


def _balanced(
    n: _Numbers, flanks: tuple[float, ...], centre: FloatArray, start: FloatArray
) -> Balance:
    """Where the balls are in balance, from a start; n, centre, start by ball."""
    floor, stiffness = _floor(n), _both(n)
    target = np.zeros(start.shape)
    target[:, 1] = n.force
    reach = n.inner.length + n.outer.length
    return balance(
        lambda some, x: _on_balls(_taken(n, some), flanks, centre[some], x, floor[some]),
        start,
        target,
        np.ones(target.shape, np.bool_),
        precision=PRECISION,
        longest=0.3 * reach,
        limit=n.diameter + reach,
        reference=1.5e-6 * stiffness,
    )


def _rest(n: _Numbers, flanks: tuple[float, ...]) -> FloatArray:
    """Where F_c alone presses a ball into the outer ring, the inner far away; (cases, 2)."""
    start = np.zeros((len(n.force), 2))
    start[:, 1] = n.outer.length
    far = start.copy()  # the inner arcs' centres near the ball's own: none touches it
    return _balanced(n, flanks, far, start).displacement


def _solved_2x2(matrix: FloatArray, right: FloatArray) -> FloatArray:
    """M⁻¹ R of small matrices; zero where M has no inverse: nothing holds that ball."""
    a, b, c, d = matrix[:, 0, 0], matrix[:, 0, 1], matrix[:, 1, 0], matrix[:, 1, 1]
    determinant = a * d - b * c
    adjoint = np.stack([np.stack([d, -b], axis=1), np.stack([-c, a], axis=1)], axis=1)
    known = determinant != 0.0
    inverse = np.divide(
        adjoint, determinant[:, np.newaxis, np.newaxis], where=known[:, np.newaxis, np.newaxis],
        out=np.zeros_like(adjoint),
    )  # fmt: skip
    return np.asarray(inverse @ right)


def _pressed(contact: _Contact, angle: FloatArray, spin: FloatArray, roll: FloatArray) -> Pressed:
    deflection = np.where(contact.load > 0.0, contact.approach, 0.0 * contact.approach)
    return Pressed(contact.load, angle, deflection, contact.approach, spin, roll)
