"""Beams of any straight section: stiffness, inertia, and what is left of a load between nodes.

An element joins two nodes of five degrees of freedom. Its stiffness follows from the flexibility of
the element held at its left end, integrated over the section as it varies: exact for cylinders and
cones, bending and shear after Timoshenko. With r = L - x,

    f = ∫ [r² r; r 1]/(E I) + [1 0; 0 0]/(κ G A) dx,    K = T' f⁻¹ T,   T = [-1 -L 1 0; 0 -1 0 1]

for (v, θ) at both ends, v' = θ. In our axes θ is rz in the plane of y and -ry in that of z. The
shear coefficient κ is Cowper's (1966). Between the nodes an unloaded element has the shape of its
static deflection; mass, rotary inertia and gyroscopic matrix are consistent with that.

Przemieniecki, Theory of Matrix Structural Analysis (1968), chapters 5 and 11; Friswell, Penny,
Garvey and Lees, Dynamics of Rotating Machines (2010), chapter 5.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Final

import numpy as np

from rolamento.numerics import FloatArray, IntArray
from rolamento.records import frozen

POINTS: Final = 16
"""Points of Gauss's quadrature along an element."""
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(POINTS)
_AT: Final = 0.5 * (1.0 + _NODES)
_SHARE: Final = 0.5 * _WEIGHTS

_BY_Y: Final = np.array([1, 4, 6, 9])
"""Degrees of freedom of an element that bend it in the plane of y: y, rz at both ends."""
_BY_Z: Final = np.array([2, 3, 7, 8])
"""In the plane of z: z, ry at both ends; θ is -ry."""
_ALONG: Final = np.array([0, 5])
_TURN: Final = np.array([1.0, -1.0, 1.0, -1.0])
"""From (v, θ) to (z, ry) at both ends."""


@frozen(eq=False)
class Elements:
    """Beam elements one after the other; (elements,) each, SI.

    Diameters and bores at the left and right ends, between which they are straight.
    """

    length: FloatArray
    left_diameter: FloatArray
    right_diameter: FloatArray
    left_bore: FloatArray
    right_bore: FloatArray
    youngs_modulus: FloatArray
    poisson_ratio: FloatArray
    density: FloatArray

    def __len__(self) -> int:
        """Count the elements."""
        return len(self.length)

    def _at(self, part: FloatArray) -> _Section:
        """The sections at some parts of the lengths; part (elements or 1, …)."""
        shape = (len(self.length), *(1,) * (part.ndim - 1))

        def between(left: FloatArray, right: FloatArray) -> FloatArray:
            return np.asarray(left.reshape(shape) + (right - left).reshape(shape) * part)

        nu = self.poisson_ratio.reshape(shape)
        modulus = self.youngs_modulus.reshape(shape)
        return _Section.of(
            between(self.left_diameter, self.right_diameter),
            between(self.left_bore, self.right_bore),
            modulus,
            nu,
        )

    # --- stiffness ------------------------------------------------------------------------------

    def flexibility(self) -> FloatArray:
        """Flexibility of elements held at their left ends, by F and M at the right; (n, 2, 2)."""
        section, length = self._at(_AT[np.newaxis]), self.length[:, np.newaxis]
        r = length * (1.0 - _AT)
        bend = length * _SHARE / section.bending
        f = np.empty((len(self), 2, 2))
        f[:, 0, 0] = (r * r * bend + length * _SHARE / section.shear).sum(axis=1)
        f[:, 0, 1] = f[:, 1, 0] = (r * bend).sum(axis=1)
        f[:, 1, 1] = bend.sum(axis=1)
        return f

    def stretch(self) -> FloatArray:
        """Stretch of each element by an axial force; (n,), m/N."""
        section = self._at(_AT[np.newaxis])
        return np.asarray(self.length * (_SHARE / section.axial).sum(axis=1))

    def stiffness(self) -> FloatArray:
        """Force of both ends by their displacement; (n, 10, 10)."""
        t = ends_taken_along(self.length)
        k = np.zeros((len(self), 10, 10))
        _put(k, np.swapaxes(t, 1, 2) @ np.linalg.solve(self.flexibility(), t))
        both = np.array([[1.0, -1.0], [-1.0, 1.0]])
        k[:, _ALONG[:, np.newaxis], _ALONG] = both / self.stretch()[:, np.newaxis, np.newaxis]
        return k

    # --- inertia --------------------------------------------------------------------------------

    def _shapes(self) -> tuple[FloatArray, FloatArray]:
        """V and θ at the points of quadrature by (v, θ) at both ends; (n, points, 4) each."""
        n, length = len(self), self.length
        # integrals from the left end to each point, by a quadrature of their own
        part = _AT[:, np.newaxis] * _AT  # (points, points to there)
        section = self._at(part[np.newaxis])
        step = length[:, np.newaxis, np.newaxis] * _AT[:, np.newaxis] * _SHARE
        s = length[:, np.newaxis, np.newaxis] * part
        x = length[:, np.newaxis] * _AT
        r = length[:, np.newaxis, np.newaxis] - s
        curved = step / section.bending
        by_force = np.empty((n, POINTS, 2, 2))  # (v, θ) by (force, moment) at the right end
        arm = x[..., np.newaxis] - s
        by_force[..., 0, 0] = (r * arm * curved + step / section.shear).sum(axis=2)
        by_force[..., 0, 1] = (arm * curved).sum(axis=2)
        by_force[..., 1, 0] = (r * curved).sum(axis=2)
        by_force[..., 1, 1] = curved.sum(axis=2)
        ends = np.linalg.solve(self.flexibility(), ends_taken_along(self.length))
        shapes = by_force @ ends[:, np.newaxis]
        shapes[..., 0, 0] += 1.0
        shapes[..., 0, 1] += x
        shapes[..., 1, 1] += 1.0
        return shapes[..., 0, :], shapes[..., 1, :]

    def inertia(self) -> tuple[FloatArray, FloatArray]:
        """Mass and gyroscopic matrix at a speed of 1 rad/s; (n, 10, 10) each."""
        v, theta = self._shapes()
        section = self._at(_AT[np.newaxis])
        weight = self.length[:, np.newaxis] * _SHARE * self.density[:, np.newaxis]
        mass, rotary = weight * section.area, weight * section.inertia

        def summed(shapes: FloatArray, by: FloatArray) -> FloatArray:
            return np.asarray(np.einsum("np,npi,npj->nij", by, shapes, shapes))

        turning = summed(theta, rotary)
        m = np.zeros((len(self), 10, 10))
        _put(m, summed(v, mass) + turning)
        # along: the shape of a bar, strained as its section lets it
        to_here = self._at((_AT[:, np.newaxis] * _AT)[np.newaxis])
        way = (_AT[:, np.newaxis] * _SHARE / to_here.axial).sum(axis=2)
        way /= (_SHARE / section.axial).sum(axis=1)[:, np.newaxis]
        bar = np.stack([1.0 - way, way], axis=-1)
        m[:, _ALONG[:, np.newaxis], _ALONG] = summed(bar, mass)
        # I_p rz' against ry, -I_p ry' against rz; I_p is twice the rotary inertia
        g = np.zeros_like(m)
        coupling = -2.0 * _TURN[:, np.newaxis] * turning  # of (z, -θ) rows, (y, θ) columns
        g[:, _BY_Z[:, np.newaxis], _BY_Y] = coupling
        g[:, _BY_Y[:, np.newaxis], _BY_Z] = -np.swapaxes(coupling, 1, 2)
        return m, g

    def mass(self) -> FloatArray:
        """Mass of each element; (n,), kg."""
        section = self._at(_AT[np.newaxis])
        return np.asarray(self.density * self.length * (_SHARE * section.area).sum(axis=1))

    # --- loads between the nodes ----------------------------------------------------------------

    def body_load(self, acceleration: FloatArray) -> FloatArray:
        """Forces on both ends that stand for the weight of the elements; (n, 10).

        acceleration: along x, y, z; (3,), m/s². Exact at the nodes: what the ends would be held
        by, turned round.
        """
        section, length = self._at(_AT[np.newaxis]), self.length[:, np.newaxis]
        weight = self.density[:, np.newaxis] * section.area * length * _SHARE  # per unit of a
        shapes, _ = self._shapes()
        plane = np.einsum("np,npi->ni", weight, shapes)
        to_here = self._at((_AT[:, np.newaxis] * _AT)[np.newaxis])
        way = (_AT[:, np.newaxis] * _SHARE / to_here.axial).sum(axis=2)
        way /= (_SHARE / section.axial).sum(axis=1)[:, np.newaxis]
        out = np.zeros((len(self), 10))
        out[:, _BY_Y] = acceleration[1] * plane
        out[:, _BY_Z] = acceleration[2] * plane * _TURN
        out[:, 0] = acceleration[0] * (weight * (1.0 - way)).sum(axis=1)
        out[:, 5] = acceleration[0] * (weight * way).sum(axis=1)
        return out

    def sections(self, right: bool) -> _Section:
        """The sections at the elements' left or right ends; (n,)."""
        return self._at(np.full(len(self), float(right)))


@frozen(eq=False)
class _Section:
    """Sections of beams: area, second moment of area, E I, κ G A and E A; arrays of any shape."""

    diameter: FloatArray
    area: FloatArray
    inertia: FloatArray
    bending: FloatArray
    shear: FloatArray
    axial: FloatArray

    @classmethod
    def of(
        cls, diameter: FloatArray, bore: FloatArray, modulus: FloatArray, nu: FloatArray
    ) -> _Section:
        """Circular sections; bore 0 of solid ones."""
        area = 0.25 * np.pi * (diameter**2 - bore**2)
        inertia = np.pi / 64.0 * (diameter**4 - bore**4)
        shear = modulus / (2.0 * (1.0 + nu)) * shear_coefficient(bore / diameter, nu) * area
        return cls(diameter, area, inertia, modulus * inertia, shear, modulus * area)


def shear_coefficient(ratio: FloatArray, poisson_ratio: FloatArray) -> FloatArray:
    """Shear coefficient of a hollow circular section; ratio: of its diameters, inner to outer.

    Cowper, The shear coefficient in Timoshenko's beam theory (1966), Table 1.
    """
    nu, square = poisson_ratio, (1.0 + ratio**2) ** 2
    thin = (20.0 + 12.0 * nu) * ratio**2
    return np.asarray(6.0 * (1.0 + nu) * square / ((7.0 + 6.0 * nu) * square + thin))


def ends_taken_along(length: FloatArray) -> FloatArray:
    """T: (v, θ) of the right ends against where the left ones take them; (n, 2, 4)."""
    t = np.zeros((len(length), 2, 4))
    t[:, 0, 0], t[:, 0, 1], t[:, 0, 2] = -1.0, -length, 1.0
    t[:, 1, 1], t[:, 1, 3] = -1.0, 1.0
    return t


@frozen(eq=False)
class Chain:
    """Elements in a row, in one plane, by the nodes at which they are held or joined to others.

    Flexibilities are summed up from node to node: nothing cancels, however short an element is.
    Displacements (v, θ) and loads (F, M) of all nodes are one vector, node after node.

    Attributes
    ----------
    stiffness
        between the kept nodes; (2 kept, 2 kept)
    follow
        how all nodes follow the kept; (2 nodes, 2 kept). Its transpose puts loads on the kept.
    by_load
        how they yield to loads of their own, the kept held; (2 nodes, 2 nodes)
    """

    stiffness: FloatArray
    follow: FloatArray
    by_load: FloatArray

    @classmethod
    def of(cls, length: FloatArray, flexibility: FloatArray, kept: IntArray) -> Chain:
        """Sum up elements (n,), (n, 2, 2) between the kept nodes, from left to right."""
        nodes, held = len(length) + 1, len(kept)
        x = np.concatenate([[0.0], np.cumsum(length)])
        found = cls(
            np.zeros((2 * held, 2 * held)),
            np.zeros((2 * nodes, 2 * held)),
            np.zeros((2 * nodes, 2 * nodes)),
        )
        for place, (a, z) in enumerate(pairwise(kept)):
            found._add_span(place, int(a), int(z), x, _hung(length[a:z], flexibility[a:z]))
        first, last = int(kept[0]), int(kept[-1])
        right = _hung(length[last:], flexibility[last:])
        found._add_end(held - 1, last, np.arange(last, nodes), x, right)
        # the left end hangs the other way: of its elements, the force is at the left
        left = _hung(length[:first][::-1], _by_left_end(length, flexibility)[:first][::-1])
        turned = np.array([1.0, -1.0])
        left *= turned[:, np.newaxis, np.newaxis] * turned
        found._add_end(0, first, np.arange(first, -1, -1), x, left)
        return found

    @classmethod
    def along(cls, stretch: FloatArray, kept: IntArray) -> Chain:
        """The same along the axis, of x and N at each node; stretch (n,)."""
        nodes, held = len(stretch) + 1, len(kept)
        c = np.concatenate([[0.0], np.cumsum(stretch)])
        stiffness, follow = np.zeros((held, held)), np.zeros((nodes, held))
        by_load = np.zeros((nodes, nodes))
        for place, (a, z) in enumerate(pairwise(kept)):
            own, whole = c[a : z + 1] - c[a], c[z] - c[a]
            rate = np.array([[1.0, -1.0], [-1.0, 1.0]]) / whole
            stiffness[place : place + 2, place : place + 2] += rate
            follow[a : z + 1, place], follow[a : z + 1, place + 1] = 1.0 - own / whole, own / whole
            within = np.minimum.outer(own, own) - np.outer(own, own) / whole
            by_load[a : z + 1, a : z + 1] += within
        first, last = int(kept[0]), int(kept[-1])
        follow[: first + 1, 0] = follow[last:, -1] = 1.0
        for some, away in (
            (slice(0, first + 1), c[first] - c[: first + 1]),
            (slice(last, nodes), c[last:] - c[last]),
        ):
            by_load[some, some] += np.minimum.outer(away, away)
        return cls(stiffness, follow, by_load)

    def _add_end(
        self, place: int, node: int, nodes: IntArray, x: FloatArray, hung: FloatArray
    ) -> None:
        """Put in what hangs on a kept node; nodes: from that on."""
        at = (2 * nodes[:, np.newaxis] + np.arange(2)).ravel()
        self.by_load[at[:, np.newaxis], at] += hung.reshape(len(at), len(at))
        self.follow[2 * nodes, 2 * place] = 1.0
        self.follow[2 * nodes, 2 * place + 1] = x[nodes] - x[node]
        self.follow[2 * nodes + 1, 2 * place + 1] = 1.0

    def _add_span(self, place: int, first: int, last: int, x: FloatArray, hung: FloatArray) -> None:
        """Put in what lies between two kept nodes, as it would hang on the left one."""
        nodes = np.arange(first, last + 1)
        t = ends_taken_along(x[[last]] - x[first])[0]
        by_tip = hung[:, :, -1]  # (nodes, 2, 2)
        pushed = np.linalg.solve(by_tip[-1], t)  # the tip's force, by both ends
        own = slice(2 * place, 2 * place + 4)
        self.stiffness[own, own] += t.T @ pushed
        carried = np.zeros((len(nodes), 2, 4))
        carried[:, 0, 0] = carried[:, 1, 1] = 1.0
        carried[:, 0, 1] = x[nodes] - x[first]
        carried += by_tip @ pushed
        carried[-1] = np.eye(2, 4, 2)
        self.follow[2 * first : 2 * last + 2, own] = carried.reshape(-1, 4)
        size = 2 * len(nodes)
        whole = hung.reshape(size, size)
        held = whole - by_tip.reshape(size, 2) @ np.linalg.solve(by_tip[-1], whole[-2:])
        held[-2:], held[:, -2:] = 0.0, 0.0
        at = slice(2 * first, 2 * last + 2)
        self.by_load[at, at] += held


def _hung(length: FloatArray, flexibility: FloatArray) -> FloatArray:
    """(v, θ) of all nodes by (F, M) on each, the first node held; (nodes, 2, nodes, 2)."""
    n = len(length)
    x = np.concatenate([[0.0], np.cumsum(length)])
    inner = np.zeros((n, 2, n + 1, 2))  # force and moment at the elements' right ends
    beyond = np.arange(n + 1) > np.arange(n)[:, np.newaxis]
    inner[:, 0, :, 0] = inner[:, 1, :, 1] = beyond
    inner[:, 1, :, 0] = np.where(beyond, x - x[1:, np.newaxis], 0.0)
    bent = np.einsum("eij,ejnk->eink", flexibility, inner)
    hung = np.zeros((n + 1, 2, n + 1, 2))
    hung[1:, 1] = np.cumsum(bent[:, 1], axis=0)
    steps = length[:, np.newaxis, np.newaxis] * hung[:-1, 1] + bent[:, 0]
    hung[1:, 0] = np.cumsum(steps, axis=0)
    return hung


def _by_left_end(length: FloatArray, flexibility: FloatArray) -> FloatArray:
    """Flexibilities of elements held at their right ends, by force and moment at the left."""
    a, b, c = flexibility[:, 1, 1], flexibility[:, 0, 1], flexibility[:, 0, 0]
    f = np.empty_like(flexibility)
    f[:, 0, 0] = length * length * a - 2.0 * length * b + c
    f[:, 0, 1] = f[:, 1, 0] = length * a - b
    f[:, 1, 1] = a
    return f


def _put(matrix: FloatArray, plane: FloatArray) -> None:
    """Put what holds in a plane (n, 4, 4) into both; matrix (n, 10, 10)."""
    matrix[:, _BY_Y[:, np.newaxis], _BY_Y] = plane
    matrix[:, _BY_Z[:, np.newaxis], _BY_Z] = plane * _TURN[:, np.newaxis] * _TURN
