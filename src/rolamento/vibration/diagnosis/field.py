"""The spectra that are searched: which lines are left out, and the noise about the others.

A fault explains multiples of its own lines, and sidebands of the shaft and the cage. A line of
another part's window that is one of them is no evidence of that part. The sidebands fold
at zero: 4 - f of an outer race lies near the cage's order, f + 1 near the ball's.

Other lines may stand out that no part of the bearing and no turn of the shaft explains. A wrong
speed or another bearing than was thought shows so, and so does another machine nearby.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from itertools import product
from math import log, nan
from typing import Final

import numpy as np

from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.vibration.diagnosis.band_spectra import (
    BandSpectra,
    filled,
    lines_about,
    lines_connected,
    most_spread,
)
from rolamento.vibration.diagnosis.lines import MAINS, is_near_mains
from rolamento.vibration.diagnosis.record import UnexplainedLine
from rolamento.vibration.diagnosis.search import (
    Finding,
    Look,
    Scores,
    chance,
    hypotheses_of,
    search,
)
from rolamento.vibration.diagnosis.settings import (
    COMPONENTS,
    Component,
    DiagnosisSettings,
    FaultOrders,
)
from rolamento.vibration.diagnosis.size import DAMAGE, depth_error, depth_of, is_smooth
from rolamento.vibration.noise_floor import mean_over_median, running_medians

SEEN: Final = 0.8
"""Fraction of a band's width: up to there the noise of its squared envelope falls slowly."""
_HIGHEST_MAINS: Final = 360.0
"""Hz; higher harmonics of a supply are hardly felt, and every line is near one of them."""
_DISCRETE: Final = 0.95
"""Depth of a line alone over that of all lines about it: from there on it is discrete."""
_HUMP: Final = 16


@frozen(eq=False, slots=False)
class Field:
    """The lines that are searched, and what is known of them.

    Attributes
    ----------
    spectra
        that were measured
    medians
        (bands, lines), of the noise about each line
    plain_medians
        (bands, lines), likewise of the squared envelopes as they are
    left_out
        (bands, lines)
    shaft
        (bands, lines), of those the lines of what turns, and those too fast for a band
    orders, settings
        as given
    freedom
        part by which the speed may still be off
    """

    spectra: BandSpectra
    medians: FloatArray
    plain_medians: FloatArray
    left_out: BoolArray
    shaft: BoolArray
    orders: FaultOrders
    settings: DiagnosisSettings
    freedom: float

    @property
    def turns(self) -> float:
        """Lines per order."""
        return self.spectra.turns

    @property
    def level(self) -> FloatArray:
        """Mean power of the noise about each line; (bands, lines)."""
        return self.medians * mean_over_median(self.spectra.blocks)

    @cached_property
    def depths(self) -> FloatArray:
        """Mean squares of the modulation depth, less those of noise about each; (bands, lines).

        0 at lines of what turns.
        """
        return np.where(self.shaft, 0.0, self.spectra.depth - self._depth_levels)

    @cached_property
    def _depth_levels(self) -> FloatArray:
        """Mean squares of the modulation depth that the noise about each line has."""
        depth, plain = self.spectra.depth, self.spectra.plain
        if self.spectra.blocks == 1:
            # all lines of a band were divided by the same
            highest = np.max(plain, axis=1, keepdims=True)
            scale = np.max(depth, axis=1, keepdims=True) / np.where(highest > 0.0, highest, 1.0)
            medians = self.plain_medians * scale
        else:
            medians = running_medians(depth)
        return np.asarray(np.nan_to_num(medians * mean_over_median(self.spectra.blocks)))

    def window(self, component: Component) -> tuple[float, float]:
        """Orders between which a component's is looked for."""
        nominal = self.orders.fundamental(component) or 0.0
        within = self.orders.tolerance(component, self.settings.tolerance) + self.freedom
        return nominal * (1.0 - within), nominal * (1.0 + within)

    def depth(self, band: int, line: float, width: int = 1) -> float:
        """Modulation depth of a band at a line."""
        return depth_of(self.depths[band], line, width)

    def depth_error(self, band: int, line: float) -> float:
        """Standard deviation of the depth at a line by the noise about it."""
        place = min(round(line), self._depth_levels.shape[1] - 1)
        return depth_error(float(self._depth_levels[band, place]), self.spectra.blocks)

    def kurtosis(self, band: int) -> tuple[float, float]:
        """Return that of the record, and of its whitened band; 3 for noise."""
        return self.spectra.kurtosis, float(self.spectra.band_kurtosis[band])

    def on_mains(self, band: int, line: float) -> bool:
        """Whether a line is of the mains and discrete: a bearing slips, a grid hardly."""
        per_line = self.spectra.shaft_frequency / self.turns
        hertz = np.array([line * per_line])
        near = any(is_near_mains(hertz, per_line, mains)[0] for mains in MAINS)
        return (
            near
            and line * per_line <= _HIGHEST_MAINS
            and self.depth(band, line) >= _DISCRETE * self.depth(band, line, _HUMP)
        )

    def findings(self, parts: Sequence[Component]) -> dict[Component, Finding | None]:
        """Return the best match for each of some components among the lines that are left."""
        scores = Scores(self.spectra.power, self.left_out, self.medians, self.spectra.blocks)
        looks = [
            Look(
                hypotheses_of(self.orders, part),
                *self.window(part),
                self.settings.tolerance if part == "ball" else 0.0,
            )
            for part in parts
        ]
        return dict(zip(parts, search(scores, looks, self.turns), strict=True))

    def with_shaft(self) -> Field:
        """Return the field with the lines of what turns, as they are."""
        spectra = replace(self.spectra, power=self.spectra.plain)
        return replace(
            self,
            spectra=spectra,
            medians=self.plain_medians,
            left_out=_too_fast(spectra),
            shaft=_too_fast(spectra),
        )


def field_of(
    spectra: BandSpectra, orders: FaultOrders, settings: DiagnosisSettings, freedom: float
) -> Field:
    """Leave out lines of what turns and those too fast for a band, and take the noise's level."""
    lines = spectra.power.shape[1]
    plain_medians = running_medians(spectra.plain)
    plain_level = mean_over_median(spectra.blocks) * plain_medians
    shaft = lines_about(spectra.plain, plain_level, spectra.regular, most_spread(spectra.turns))
    left_out = shaft | lines_connected(spectra.spreads, spectra.regular, spectra.turns, lines)
    medians = running_medians(filled(spectra.power, left_out))
    fast = _too_fast(spectra)
    return Field(
        spectra, medians, plain_medians, left_out | fast, shaft | fast, orders, settings, freedom
    )


def _too_fast(spectra: BandSpectra) -> BoolArray:
    """Lines beyond what a band's width shows; (bands, lines)."""
    frequency = np.arange(spectra.power.shape[1]) * (spectra.shaft_frequency / spectra.turns)
    widths = np.array([high - low for low, high in spectra.bands])
    return np.asarray(frequency[None] > SEEN * widths[:, None])


# --- what lines a fault explains -----------------------------------------------------------------


_SHAFT: Final = 5
"""Sidebands of the shaft on either side."""
_CAGE: Final = 2
"""And of the cage about each."""
_NEAR: Final = 0.004
"""Fraction of an order: as near, a line is the same."""
_LINES: Final = 2.5


def explained(
    places: FloatArray,
    component: Component,
    order: float,
    orders: FaultOrders,
    turns: float,
    *,
    multiples: int,
    cage: bool,
) -> BoolArray:
    """Which orders are multiples of a fault's, or sidebands of one.

    Parameters
    ----------
    places
        Orders in question.
    component, order
        Of the fault.
    turns
        Lines per order.
    multiples
        Of the fault's order, up to which they count.
    cage
        Whether sidebands of the cage count too.
    """
    step = 0.5 * order if component == "ball" else order
    highest = 2 * multiples if component == "ball" else multiples
    near = np.maximum(_LINES / turns, _NEAR * places)
    carried = orders.cage if cage and orders.cage and component != "cage" else 0.0
    # of the cage itself, all that turns with it lies near some sideband of the shaft's
    shaft = 1 if component == "cage" else _SHAFT
    found = np.zeros(places.shape, dtype=np.bool_)
    sides = range(-_CAGE, _CAGE + 1) if carried else range(1)
    for of_shaft, of_cage in product(range(-shaft, shaft + 1), sides):
        offset = of_shaft + of_cage * carried
        for sign in (1.0, -1.0):
            number = np.rint((sign * places - offset) / step)
            close = np.abs(sign * places - offset - number * step) <= near
            found |= close & (np.abs(number) <= highest) & ((number != 0.0) | (of_cage != 0))
    return found


# --- what nothing explains -----------------------------------------------------------------------


_WIDTHS: Final = (1, 4)
_MOST: Final = 3
_BEYOND_SLOW: Final = 2.5
"""Times the slow orders: nearer, the level about a line is theirs, which was divided out."""
_APART: Final = 0.01
"""Fraction of a line's order: nearer ones are of the same origin."""
_MULTIPLES: Final = 20
"""Number of multiples of a fault's order, and sidebands of them, that are not unexplained."""
_SIDEBAND: Final = 2.0
"""Depth of a sideband over that of the deepest multiple, at most."""
_LOWER: Final = (2, 3, 4)
"""Multiples of another comb that a part's line may be; of a ball's the half is its spin's."""
_SAME: Final = 0.004
"""Fraction of an order: as near, a line is a multiple."""
_NEAR_SPEED: Final = 0.25
"""By which a speed may be wrong for a line to be named as a part's at another speed."""


def slips_of(
    order: float, orders: FaultOrders, within: float
) -> tuple[tuple[Component, float], ...]:
    """Return of which part a line would be the lowest, and by which part its cage were off.

    Parameters
    ----------
    order
        Of the line.
    orders
        Of the bearing's faults.
    within
        Part by which the cage may be off, at most.
    """
    found = []
    for part in COMPONENTS:
        nominal = orders.fundamental(part)
        allowed = orders.tolerance(part, within)
        if nominal is not None and abs(order / nominal - 1.0) <= allowed:
            found.append((part, cage_slip(part, order, orders)))
    return tuple(sorted(found, key=lambda one: abs(one[1])))


def cage_slip(part: Component, order: float, orders: FaultOrders) -> float:
    """Part by which the cage is faster than nominal, by the order found of a part."""
    deviation = order / (orders.fundamental(part) or nan) - 1.0
    if part == "inner_race" and orders.outer_race and orders.inner_race:
        return -deviation * orders.inner_race / orders.outer_race
    return deviation


def unexplained_lines(
    field: Field, fault: tuple[Component, float, float] | None, most: int = _MOST
) -> tuple[UnexplainedLine, ...]:
    """Return a few lines that noise would not give, the deepest first.

    Parameters
    ----------
    field
        As searched.
    fault
        The part that explains most, its order, and its depth: from where it counts as damage on,
        only lines as deep are listed, so that none is taken for what a fault makes besides its
        multiples and their sidebands. One that is no damage explains no line as deep as damage.
    most
        How many.
    """
    if fault is not None and fault[2] < DAMAGE:
        deep = [line for line in unexplained_lines(field, None) if line.depth >= DAMAGE]
        rest = [
            line
            for line in _unexplained_beside(field, fault)
            if all(abs(line.order - one.order) > _APART * one.order for one in deep)
        ]
        return (*deep, *rest)[:most]
    return _unexplained_beside(field, fault, most)


def _unexplained_beside(
    field: Field, fault: tuple[Component, float, float] | None, most: int = _MOST
) -> tuple[UnexplainedLine, ...]:
    """Return lines that stand out beside what a fault explains."""
    left_out = field.left_out.copy()
    orders = np.arange(left_out.shape[1]) / field.turns
    if fault is not None:
        of_fault = explained(
            orders, *fault[:2], field.orders, field.turns, multiples=_MULTIPLES, cage=True
        )
        near = np.maximum(2.0 / field.turns, _SAME * orders)
        step = 0.5 * fault[1] if fault[0] == "ball" else fault[1]
        multiples = np.abs(orders - np.rint(orders / step) * step) <= near
        deepest = np.max(field.depths[:, multiples], initial=fault[2] ** 2)
        if fault[0] != "cage":
            # of a comb of a lower frequency the part's line is but one; the part makes none of it
            numbers = [n for n in _LOWER if fault[0] != "ball" or n > 2]
            lower = fault[1] / np.array(numbers)[:, None]
            of_fault &= ~np.any(np.abs(orders - lower) <= 2.0 / field.turns, axis=0)
        left_out |= multiples | of_fault & (field.depths <= _SIDEBAND**2 * deepest)
    scores = Scores(field.spectra.power, left_out, field.medians, field.spectra.blocks)
    lines = np.arange(scores.lines)
    clearness = np.maximum.reduce([scores.about(lines, width) for width in _WIDTHS])
    clearness[:, : int(_BEYOND_SLOW * field.spectra.slow_order * field.turns)] = 0.0
    trials = max(1, len(_WIDTHS) * int(np.count_nonzero(clearness)))
    squares = np.where(left_out, 0.0, field.depths)
    peaks = np.where(clearness < log(trials / field.settings.false_alarm), 0.0, squares)
    strongest = fault[2] if fault is not None and fault[2] >= DAMAGE else 0.0
    found: list[UnexplainedLine] = []
    while len(found) < most:
        band, line = (int(place) for place in np.unravel_index(peaks.argmax(), peaks.shape))
        depth = depth_of(squares[band], line, 1) if peaks[band, line] > 0.0 else 0.0
        if depth == 0.0 or depth < strongest:
            break
        probability, _ = chance(float(clearness[band, line]), trials)
        about = slice(max(0, line - max(_WIDTHS)), line + max(_WIDTHS) + 1)
        ratio = field.spectra.power[band, about] / field.level[band, about]
        above = 10.0 * float(np.log10(np.max(ratio[~left_out[band, about]])))
        found.append(_unexplained_line(line, above, depth, band, probability, field))
        apart = max(2 * max(_WIDTHS), int(_APART * line))
        peaks[:, max(0, line - apart) : line + apart + 1] = 0.0
    return tuple(found)


def _unexplained_line(
    line: int, above: float, depth: float, band: int, probability: float, field: Field
) -> UnexplainedLine:
    order = line / field.turns
    shaft = field.spectra.shaft_frequency
    of_mains = field.on_mains(band, line)
    return UnexplainedLine(
        order=order,
        frequency=order * shaft,
        above_noise=above,
        depth=depth,
        band=field.spectra.bands[band],
        probability=probability,
        shaft_frequencies=() if of_mains else _shaft_frequencies(order, shaft, field.orders),
        of_mains=of_mains,
        smooth=depth >= DAMAGE and is_smooth(depth, *field.kurtosis(band)),
    )


def _shaft_frequencies(
    order: float, shaft: float, orders: FaultOrders
) -> tuple[tuple[Component, float], ...]:
    """At which speeds of the shaft, not far from the given one, a line would be a part's."""
    speeds = []
    for part in COMPONENTS:
        nominal = orders.fundamental(part)
        if nominal is not None and abs(order / nominal - 1.0) <= _NEAR_SPEED:
            speeds.append((part, shaft * order / nominal))
    return tuple(speeds)
