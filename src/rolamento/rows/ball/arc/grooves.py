"""Rows of balls on grooves of other forms: two arcs a ring (four-point), or face to face (thrust).

A flank k = ±1 of a row is an arc of the inner and one of the outer ring, whose centres stand off
the middle of their grooves by k s_i and -k s_o: the pair that carries load of the shaft toward k x.
With the inner ring's groove displaced by (x, r) at a ball, whose centre is at X, the flank's
contacts stretch

    Y_o = (X1 + k s_o, X2),        Y_i = (x + k s_i - X1, A2 + r - X2)

and press with Q = K(cos α) (|Y| - L)^1.5 along Y. A ball is in balance when

    Σ_k (F_i - F_o) + (0, F_c) = 0.

With F_c and K constant that is the minimum of a convex potential, with one or two flanks. Contact
angles are counted from the radial plane and may pass 90°. The balls orbit with the cage, at its
nominal speed; a ball with more than two contacts cannot roll without slip, so that raceway control
says nothing of its gyroscopic moment: it is left out of the balance, with a note (docs/adr/0018).

Hertz (1881); Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapters 2 and 8; Hamrock and
Anderson (1973), Analysis of an arched outer-race ball bearing, for the arcs.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields
from functools import lru_cache
from typing import Any, Final, Self, cast

import numpy as np
from numpy.polynomial import chebyshev

from rolamento.case.bearing import Bearing
from rolamento.case.parameters import BallParameters
from rolamento.contact.hertz import effective_modulus, series_stiffness
from rolamento.contact.race import race_stiffness
from rolamento.geometry import edge_cosine, groove_places
from rolamento.kinematics import (
    ball_mass,
    ball_motion,
    centrifugal_force,
    nominal_orbit,
)
from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.compiled import Kernel
from rolamento.numerics.threads import share_out
from rolamento.records import frozen
from rolamento.rows.ball.arc import flanks as kernels
from rolamento.rows.ball.arc.flanks import ROUNDING, TERMS
from rolamento.rows.ball.arc.together import settle_together
from rolamento.rows.ball.problem import directions
from rolamento.rows.row import Indices, IntArray, Response, RowGeometry, RowSizes, Running
from rolamento.solved import Elements, Index, Pressed, Tables
from rolamento.status import INVALID_INPUT

__all__ = ["GrooveRow", "four_point_row", "thrust_row"]

NEGLIGIBLE: Final = 1e-7
"""Fraction of the ball's diameter: an approach whose load is none, beside which balls are in
balance."""
CHUNK: Final = 64
FEW_CONTACTS: Final = 100
"""Balls of one case that are solved without the compiler, if it is not loaded."""


@frozen
class _Race:
    """One ring's arcs: L, their shift, the edge, K as a polynomial; (cases,), (terms, cases)."""

    length: FloatArray
    shift: FloatArray
    edge: FloatArray
    stiffness: FloatArray


@frozen
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


@frozen
class _Contact:
    """One arc on some balls: load, approach and the normal (…, 2)."""

    load: FloatArray
    approach: FloatArray
    direction: FloatArray


@dataclass(slots=True)
class GroovesResponse:
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

    @property
    def memory(self) -> FloatArray | None:
        """It begins anew at every place."""
        return None

    def put(self, cases: Indices, part: Self) -> None:
        """Copy what some of the cases answered to their places."""
        for one in fields(self):
            getattr(self, one.name)[cases] = getattr(part, one.name)


@frozen
class GrooveRow:
    """Many cases of a row of balls on one or two flanks, each +1 or -1.

    p: the numbers as the kernels have them, a column a case; sound: which cases can be solved.
    """

    numbers: _Numbers
    p: FloatArray
    element_count: int
    flanks: tuple[float, ...]
    geometry: RowGeometry
    sound: BoolArray
    threads: int | None = None

    @property
    def cases(self) -> int:
        """Number of cases."""
        return len(self.sound)

    @property
    def faces(self) -> tuple[float, ...]:
        """The rows of contacts that the balls make, by the way each faces."""
        return self.flanks

    @property
    def floats(self) -> bool:
        """Whether the row locates the shaft axially: its grooves do."""
        return False

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
    def aside(self) -> FloatArray | None:
        """It is held by the place of its own plane."""
        return None

    @property
    def sizes(self) -> RowSizes:
        """For the system."""
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

    def invalidate(self, cases: BoolArray) -> None:
        """Take some cases for invalid: they are left alone."""
        self.sound[cases] = False

    # --- solving --------------------------------------------------------------------------------

    def respond(
        self, place: FloatArray, which: Indices, memory: FloatArray | None = None
    ) -> GroovesResponse:
        """Hold some of the cases at a place; (len(which), 5)."""
        held = self.no_response(len(which))
        held.place[:] = place
        out = (
            held.position, held.face_forces, held.stiffness, held.scale, held.residual, held.number
        )  # fmt: skip
        p, flanks, cosines, sines = self._arrays(which)

        def run(kernel: Callable[..., Any], first: int, last: int) -> None:
            kernel(p, flanks, cosines, sines, held.place, first, last, out)

        self._share_out(kernels.hold_cases, run, len(which))
        return held

    def equilibrium(
        self, free: BoolArray, load: FloatArray, place: FloatArray, which: Indices
    ) -> tuple[FloatArray, BoolArray, IntArray, None]:
        """Equilibrium of the ring of a bearing that is this row, as of `rows.row.SelfBalancing`."""
        rings = np.ascontiguousarray(place)
        settled, steps = np.zeros(len(which), np.bool_), np.zeros(len(which), np.int64)
        p = self.p[:, which]
        for kernel in (settle_together, kernels.settle_cases):
            left = np.flatnonzero(~settled)
            if len(left):
                own = rings[left], settled[left], steps[left]
                self._settle(kernel, which[left], free[left], load[left], own)
                rings[left], settled[left], steps[left] = own
        return rings, settled | kernels.beyond(p, rings), steps, None

    def _settle(
        self,
        kernel: Kernel[..., None],
        which: Indices,
        free: BoolArray,
        load: FloatArray,
        found: tuple[FloatArray, BoolArray, IntArray],
    ) -> None:
        """Let the rings of some cases go: places, whether they came to rest, steps; written."""
        arrays, (rings, settled, steps) = self._arrays(which), found

        def run(kernel: Callable[..., Any], first: int, last: int) -> None:
            kernel(*arrays, free, load, rings, first, last, settled, steps)

        self._share_out(kernel, run, len(which))

    def _arrays(self, which: Indices) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        """What the kernels take of some cases: numbers, flanks, and the directions of the balls."""
        p = np.ascontiguousarray(self.p[:, which])
        return (p, np.array(self.flanks), *directions(self.element_count))

    def _share_out(self, kernel: Kernel[..., None], run: Callable[..., None], cases: int) -> None:
        little = cases == 1 and self.element_count * len(self.flanks) <= FEW_CONTACTS
        share_out(kernel, run, cases, chunk=CHUNK, threads=self.threads, little=little)

    def no_response(self, cases: int) -> GroovesResponse:
        """Make room for so many cases without a result."""
        return GroovesResponse(
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

    def press_in(self, force: FloatArray) -> FloatArray:
        """No preload is put on such rows; (cases,), NaN."""
        return np.full(self.cases, np.nan)

    def answer(self, held: Response, shown: IntArray, lost: BoolArray) -> GrooveAnswer:
        """Keep what the tables are made from, of cases that are not lost."""
        balls = cast(GroovesResponse, held)
        balls.position[lost], balls.place[lost] = np.nan, np.nan
        codes = np.broadcast_to(shown, (self.cases, self.element_count))
        return GrooveAnswer(self.numbers, self.flanks, balls.place, balls.position, codes)


@frozen
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

    def grip(self) -> FloatArray:
        """How deep each element is pressed into the inner ring."""
        return self.tables().inner.approach

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


def four_point_row(bearing: BallParameters, running: Running) -> GrooveRow:
    """The numbers of a four-point row.

    Both arcs of a ring stand off its middle by s = (f - ½) D sin α_s.
    """
    with np.errstate(invalid="ignore", divide="ignore"):
        return _row(bearing, running, (1.0, -1.0))


def thrust_row(bearing: BallParameters, running: Running) -> GrooveRow:
    """The numbers of a thrust row; as `four_point_row`."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return _row(bearing, running, (1.0,))


def _row(bearing: BallParameters, running: Running, flanks: tuple[float, ...]) -> GrooveRow:
    cases, column, model = running.cases, running.column, running.model
    diameter, pitch = (column(getattr(bearing, n)) for n in _BALLS)
    given = {n: getattr(bearing, n) for n in ("contact_angle", "diametral_clearance")}
    shim = bearing.shim_angle if len(flanks) > 1 else None
    places = groove_places(
        diameter, pitch, bearing.inner_conformity, bearing.outer_conformity,
        shim_angle=shim, **given,
    )  # fmt: skip
    inner_length, outer_length, axial, radial, arm = (column(one) for one in places)
    reach = inner_length + outer_length
    angle = np.arccos(np.clip(radial / reach, -1.0, 1.0))
    if shim is None:
        own = column(bearing.contact_angle)
        shifts = {"inner": axial, "outer": 0.0 * axial}
        toward = np.stack([np.sin(own), np.cos(own)], axis=1)
        bottom, angle = toward, own
    else:
        sine = np.sin(column(shim))
        shifts = {"inner": inner_length * sine, "outer": outer_length * sine}
        toward = np.tile([1.0, 0.0], (cases, 1))
        bottom = np.tile([0.0, 1.0], (cases, 1))
    record = running.record
    fits = _stiffness(bearing, cases) if record is None else _stiffness_of(record)
    races = {
        race: _Race(
            length=length,
            shift=shifts[race],
            edge=column(edge_cosine(bearing, race)),  # type: ignore[arg-type]
            stiffness=np.broadcast_to(fit, (TERMS, cases)),
        )
        for race, length, fit in zip(
            ("inner", "outer"), (inner_length, outer_length), fits, strict=True
        )
    }
    speeds = column(running.inner_speed), column(running.outer_speed)
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
        mass=column(mass),
        inner_speed=speeds[0],
        outer_speed=speeds[1],
        first=column(running.azimuth),
        orbit=column(orbit),
        force=column(model.centrifugal_force * centrifugal_force(mass, pitch, orbit)),
        shown_moment=np.full(cases, float(model.gyroscopic_moment)),
    )
    shown = 0.0 if bearing.contact_angle is None else bearing.contact_angle
    geometry = (
        diameter, pitch, bearing.inner_conformity, bearing.outer_conformity, shown, modulus, np.nan,
    )  # fmt: skip
    return GrooveRow(
        numbers,
        _columns(numbers),
        bearing.element_count,
        flanks,
        RowGeometry(*(column(one) for one in geometry)),
        np.ones(cases, np.bool_),
        running.threads,
    )


@lru_cache(maxsize=256)
def _stiffness_of(bearing: Bearing) -> tuple[FloatArray, FloatArray]:
    """K of both races of one bearing; not to be written to."""
    return _stiffness(bearing, 1)


def _stiffness(bearing: Any, cases: int) -> tuple[FloatArray, FloatArray]:
    """K of both races as polynomials in cos α; (TERMS, cases) each."""
    nodes = chebyshev.chebpts1(TERMS)
    exact = race_stiffness(bearing, np.arccos(nodes)[:, np.newaxis])
    # the discrete transform at the nodes; exact.inner may be NaN, which a fit would not take
    at_nodes = chebyshev.chebvander(nodes, TERMS - 1)
    inner, outer = (
        np.asarray(np.linalg.solve(at_nodes, np.broadcast_to(values, (TERMS, cases))), np.float64)
        for values in (exact.inner, exact.outer)
    )
    return inner, outer


def _columns(n: _Numbers) -> FloatArray:
    """The numbers as the kernels have them; (kernels.COLUMN, cases)."""
    p = np.empty((kernels.COLUMN, len(n.arm)))
    for first, race in ((kernels.INNER, n.inner), (kernels.OUTER, n.outer)):
        p[first + kernels.LENGTH], p[first + kernels.SHIFT] = race.length, race.shift
        p[first + kernels.RACE_EDGE] = race.edge
        p[first + kernels.STIFFNESS : first + kernels.SLOPE] = race.stiffness
        slope = np.asarray(chebyshev.chebder(race.stiffness))
        p[first + kernels.SLOPE : first + kernels.SLOPE + TERMS - 1] = slope
    p[kernels.RADIAL_OFFSET], p[kernels.ARM], p[kernels.DIAMETER] = (
        n.radial_offset, n.arm, n.diameter
    )  # fmt: skip
    p[kernels.TOWARD : kernels.TOWARD + 2] = n.toward.T
    p[kernels.BOTTOM : kernels.BOTTOM + 2] = n.bottom.T
    p[kernels.FORCE] = n.force
    p[kernels.COS_FIRST], p[kernels.SIN_FIRST] = np.cos(n.first), np.sin(n.first)
    p[kernels.BOTH] = both = _both(n)
    p[kernels.FLOOR] = both * (NEGLIGIBLE * n.diameter) ** 1.5
    return p


_BALLS: Final = ("ball_diameter", "pitch_diameter")
_SPEEDS: Final = ("inner_speed", "outer_speed")


def _column(value: Any, cases: int) -> FloatArray:
    return np.array(np.broadcast_to(np.asarray(value, np.float64), cases))


def _taken(numbers: _Numbers, index: Index) -> _Numbers:
    """Some of the cases, as often as they are named; polynomials have them last."""

    def of_race(race: _Race) -> _Race:
        lengths = race.length[index], race.shift[index], race.edge[index]
        return _Race(*lengths, race.stiffness[:, index])

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
    load = _polynomial(race.stiffness, normal[:, 1]) * pressed * np.sqrt(pressed)
    return _Contact(load, approach, normal)


def _polynomial(coefficients: FloatArray, cosine: FloatArray) -> FloatArray:
    return np.asarray(chebyshev.chebval(cosine, coefficients, tensor=False))


def _both(n: _Numbers) -> FloatArray:
    """K of both contacts in line at the free contact angle."""
    middle = np.cos(n.angle)
    return series_stiffness(
        _polynomial(n.inner.stiffness, middle), _polynomial(n.outer.stiffness, middle)
    )


def _pressed(contact: _Contact, angle: FloatArray, spin: FloatArray, roll: FloatArray) -> Pressed:
    deflection = np.where(contact.load > 0.0, contact.approach, 0.0 * contact.approach)
    return Pressed(contact.load, angle, deflection, contact.approach, spin, roll)
