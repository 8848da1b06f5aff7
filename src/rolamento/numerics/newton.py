"""A guarded Newton's method for many small systems at once.

For forces that resist displacement steadily (a convex potential, or nearly so): along a Newton
step the unbalanced force falls, and a step is shortened until it does not overshoot by much. A
system without stiffness is given a little, so that it moves until it finds some; so is one whose
steps have to be shortened much.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, Protocol

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen

STEPS: Final = 150
SHORTENINGS: Final = 25
LEAST_DAMPING: Final = 1e-10
MOST_DAMPING: Final = 1e4
OVERSHOOT: Final = 0.5
MUCH_SHORTER: Final = 0.3
LEAST_HELP: Final = 1e-5

Indices = NDArray[np.int64]


class Evaluation(Protocol):
    """The force that resists at a displacement, of some of the systems."""

    @property
    def force(self) -> FloatArray:
        """(systems, unknowns)."""
        ...

    @property
    def stiffness(self) -> FloatArray:
        """Derivative of the force; (systems, unknowns, unknowns)."""
        ...

    @property
    def scale(self) -> FloatArray:
        """The size of the forces that make up the sum; (systems,)."""
        ...

    @property
    def sound(self) -> BoolArray:
        """Whether the force could be evaluated; (systems,)."""
        ...


@frozen
class Balance:
    """Where the systems came to rest: whether each did, its place, residual and steps.

    escaping: the unknown along which a system ran off beyond the limit, or -1.
    """

    settled: BoolArray
    displacement: FloatArray
    residual: FloatArray
    steps: Indices
    escaping: Indices


def balance(
    evaluate: Callable[[Indices, FloatArray], Evaluation],
    start: FloatArray,
    target: FloatArray,
    free: BoolArray,
    *,
    precision: float,
    longest: FloatArray,
    limit: FloatArray,
    reference: FloatArray,
) -> Balance:
    """Find displacements at which the force on every free unknown is the target.

    Parameters
    ----------
    evaluate : takes the indices of some systems and their displacements.
    start : (systems, unknowns).
    target : (systems, unknowns), the force wanted; free : which unknowns may move.
    precision : unbalanced force over the scale of the forces that counts as none.
    longest : (systems,), the longest step; limit : (systems,), how far an unknown may go.
    reference : (systems,), a stiffness that is small against any real one.

    Returns
    -------
    Balance; a system that does not settle keeps its last place, and its residual.
    """
    n, unknowns = start.shape
    u = start.copy()
    steps = np.zeros(n, np.int64)
    damping = np.zeros(n)
    residual = np.full(n, np.inf)
    escaping = np.full(n, -1)
    settled = np.zeros(n, np.bool_)
    force, stiffness = np.zeros((n, unknowns)), np.zeros((n, unknowns, unknowns))
    scale, sound = np.zeros(n), np.zeros(n, np.bool_)

    def look(which: Indices) -> None:
        found = evaluate(which, u[which])
        force[which], stiffness[which] = found.force, found.stiffness
        scale[which], sound[which] = found.scale, found.sound

    active = np.arange(n)
    look(active)
    for _ in range(STEPS):
        rest = np.where(free[active], target[active] - force[active], 0.0)
        size = np.maximum(scale[active], np.abs(np.where(free, target, 0.0)[active]).max(axis=1))
        error = np.abs(rest).max(axis=1)
        residual[active] = np.divide(error, size, out=error.copy(), where=size > 0.0)
        settled[active] = sound[active] & (residual[active] <= precision)
        beyond = np.abs(u[active]) > limit[active, np.newaxis]
        escaping[active] = np.where(beyond.any(axis=1), beyond.argmax(axis=1), -1)
        lost = ~np.isfinite(error) | (damping[active] > MOST_DAMPING) | ~sound[active]
        going = ~settled[active] & (escaping[active] < 0) & ~lost
        active, rest = active[going], rest[going]
        if not len(active):
            break
        steps[active] += 1
        step = _step(stiffness[active], rest, free[active], damping[active], reference[active])
        slope = (step * rest).sum(axis=1)
        downhill = np.isfinite(slope) & (slope > 0.0)
        stuck = active[~downhill]
        damping[stuck] = np.maximum(100.0 * damping[stuck], LEAST_DAMPING)
        moving, step, slope = active[downhill], step[downhill], slope[downhill]
        part = _line_search(
            look, u, force, sound, target, free, moving, step, slope, longest[moving]
        )
        damping[moving] = _adapted(damping[moving], part)
    return Balance(settled, u, residual, steps, escaping)


def _step(
    stiffness: FloatArray,
    rest: FloatArray,
    free: BoolArray,
    damping: FloatArray,
    reference: FloatArray,
) -> FloatArray:
    """Newton steps on the free unknowns, with some stiffness added."""
    unknowns = rest.shape[1]
    diagonal = np.abs(np.einsum("nii->ni", stiffness))
    greatest = np.maximum(np.where(free, diagonal, 0.0).max(axis=1), reference)
    matrix = np.where(free[:, :, np.newaxis] & free[:, np.newaxis, :], stiffness, 0.0)
    added = np.where(free, (damping * greatest)[:, np.newaxis], greatest[:, np.newaxis])
    matrix[:, range(unknowns), range(unknowns)] += added
    # scaled for the determinant and for the solution alike: both meet the same pivots
    matrix /= greatest[:, np.newaxis, np.newaxis]
    singular = ~(np.abs(np.linalg.slogdet(matrix)[0]) > 0.0)
    matrix[singular] = np.eye(unknowns)
    step = np.linalg.solve(matrix, (rest / greatest[:, np.newaxis])[..., np.newaxis])[..., 0]
    step[singular] = np.nan
    return np.asarray(step)


def _line_search(
    look: Callable[[Indices], None],
    u: FloatArray,
    force: FloatArray,
    sound: BoolArray,
    target: FloatArray,
    free: BoolArray,
    moving: Indices,
    step: FloatArray,
    slope: FloatArray,
    longest: FloatArray,
) -> FloatArray:
    """Move along the steps, each shortened until it does not overshoot by much: which part."""
    origin = u[moving].copy()
    length = np.sqrt((step * step).sum(axis=1))
    part = np.minimum(1.0, longest / length)
    whole = part.copy()
    taken = part.copy()
    trying = np.arange(len(moving))
    for _ in range(SHORTENINGS):
        if not len(trying):
            break
        which = moving[trying]
        taken[trying] = part[trying]
        u[which] = origin[trying] + part[trying, np.newaxis] * step[trying]
        look(which)
        rest = np.where(free[which], target[which] - force[which], 0.0)
        ahead = (step[trying] * rest).sum(axis=1)
        good = sound[which] & (ahead >= -OVERSHOOT * slope[trying])
        with np.errstate(invalid="ignore", divide="ignore"):
            nearer = np.clip(slope[trying] / (slope[trying] - ahead), 0.1, 0.6)
        part[trying] *= np.where(sound[which] & np.isfinite(nearer), nearer, 0.3)
        trying = trying[~good]
    return np.asarray(taken / whole)


def _adapted(damping: FloatArray, part: FloatArray) -> FloatArray:
    """More damping where a step had to be shortened much, less where it did not.

    A step that runs along a direction without stiffness would be cut to nothing in all the
    others as well; damping bends it toward them.
    """
    more = np.maximum(4.0 * damping, LEAST_HELP)
    less = np.where(damping > LEAST_DAMPING, 0.03 * damping, 0.0)
    return np.asarray(np.where(part < MUCH_SHORTER, more, np.where(part == 1.0, less, damping)))
