"""From a signal to verdicts: one cause that explains most, then only what has evidence of its own.

A part is a candidate where its lines stand out of the noise as noise does not; among several, the
deepest modulation is the cause. What that explains (its multiples, and sidebands of them) is no
evidence of another part. A stronger line that it does not explain leaves the verdict undecided.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import chain
from math import ceil, floor, hypot, log, nan, pi
from typing import Final

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.vibration.diagnosis import describe
from rolamento.vibration.diagnosis.band_spectra import BandSpectra, Plan, band_spectra
from rolamento.vibration.diagnosis.blocks import blocks_of
from rolamento.vibration.diagnosis.field import (
    Field,
    cage_slip,
    explained,
    field_of,
    slips_of,
    unexplained_lines,
)
from rolamento.vibration.diagnosis.lines import envelope_leakage, leaked
from rolamento.vibration.diagnosis.record import (
    ComponentVerdict,
    Diagnosis,
    EnvelopeSpectra,
    SpeedSource,
    UnexplainedLine,
    Verdict,
)
from rolamento.vibration.diagnosis.search import Finding, Scores, chance, highest_order
from rolamento.vibration.diagnosis.settings import (
    COMPONENTS,
    Component,
    DiagnosisSettings,
    FaultOrders,
)
from rolamento.vibration.diagnosis.shaft import ShaftLines, shaft_lines
from rolamento.vibration.diagnosis.size import DAMAGE, grade_of, is_smooth
from rolamento.vibration.diagnosis.whitening import Whitening
from rolamento.vibration.signal import Signal
from rolamento.words import Note, said
from rolamento.words.naming import of_element

_SLOW: Final = 0.25
"""Fraction of the lowest order that is looked for: modulations up to there are of the load."""
_SPARE: Final = 1.0
"""Orders beyond the highest that is looked for, in which the noise about that is seen."""


def diagnose(
    signal: Signal | Iterable[Signal],
    orders: FaultOrders,
    settings: DiagnosisSettings | None = None,
) -> Diagnosis:
    """Return which parts of a bearing a vibration signal shows to be damaged.

    Two things decide. The probability that noise without lines of the bearing gives any finding is
    at most ``settings.false_alarm``: the search counts all that it tries. And the modulation is as
    deep as healthy bearings do not have it: see `size`. "Nothing found" is a verdict about this
    record, not a certificate: docs/diagnosis-rates.md gives the rates of detection.

    Parameters
    ----------
    signal
        Acceleration, or anything else that rings, with the shaft's speed; or consecutive parts of
        one, which are read once, and of which only a block is held at a time.
    orders
        Of the bearing's faults.
    settings
        By default a false-alarm probability of 1 %, ±2 % for slip and ±3 % for the speed.

    Raises
    ------
    InputError
        If there are no samples, the speed is missing, comes near zero or changes its sign, or
        parts do not belong together.
    """
    chosen = DiagnosisSettings() if settings is None else settings
    if not isinstance(orders, FaultOrders):
        raise InputError(
            said("must be FaultOrders"), field="orders", example="FaultOrders(outer_race=3.585)"
        )
    blocks = map(Whitening, blocks_of(signal, chosen.block_revolutions))
    first = next(blocks, None)
    if first is None:
        raise InputError(said("has no samples"), field="signal")
    own = _combs(orders, chosen.tolerance, 0.0)
    shaft = shaft_lines(first, chosen.speed_tolerance, own)
    freedom = 0.0 if shaft.confirmed else chosen.speed_tolerance
    present = [part for part in COMPONENTS if orders.fundamental(part) is not None]
    plan = Plan(
        highest_order=_SPARE
        + max(highest_order(orders, part, chosen.tolerance + freedom) for part in present),
        slow_order=_SLOW * min(orders.fundamental(part) or np.inf for part in present),
        regular=(1.0, *orders.known),
        remove_tones=chosen.remove_tones,
        combs=_combs(orders, chosen.tolerance, freedom),
        speed_uncertainty=chosen.speed_uncertainty,
        speed_factor=shaft.factor,
    )
    all_of_them = chain([first], blocks)
    del first  # a block is released when the next one comes
    return judge(band_spectra(all_of_them, plan), orders, chosen, shaft)


def _combs(
    orders: FaultOrders, tolerance: float, freedom: float
) -> tuple[tuple[float, float, float], ...]:
    combs = []
    for part in COMPONENTS:
        nominal = orders.fundamental(part)
        if nominal is not None and part != "cage":
            allowed = orders.tolerance(part, tolerance) + freedom
            low, high = nominal * (1.0 - allowed), nominal * (1.0 + allowed)
            combs.append((low, high, orders.spacing(part)))
    return tuple(combs)


# --- the judgement -------------------------------------------------------------------------------


_FAIR_SHARE: Final = 0.5
"""Fraction of the first part's depth, which a second one needs."""
_SAME_CAGE: Final = 0.005
"""Fraction of the cage's speed, by which two parts may differ: slip on two races need not be the
same."""
_CLEAR_BAND: Final = 0.5
"""Evidence in a band over that in the clearest one, from which on the depth there counts."""
_ABOVE_SHAFT: Final = 2.0
"""Depth of a line on a multiple of the shaft over that of all lower multiples, from which on it is
not the shaft's alone: what turns with the shaft has its own first multiples."""
_FOOT: Final = 3
"""Lines within which one counts as lying on a multiple of the shaft."""
_BESIDE: Final = 0.01
"""Orders likewise."""
_OFF_STEP: Final = 1.0
"""Lines by which one may lie beside a multiple of the shaft and still keep step with it."""
_OFF_STEP_EACH: Final = 0.05
"""And for each multiple: as well the shaft's first line is known."""
_IN_STEP: Final = 0.9
"""Depth of the line on the multiple over that of all about it, from which on it keeps step."""
_HUMP: Final = 16
"""Lines about it that are the same hump."""
_OVER_SKIRTS: Final = 4.0
"""Power of a sideband over the skirts of stronger lines."""
_WIDEST_SLIP: Final = 0.05
"""Part by which a cage may be off for an unexplained peak to be named as a part's."""
_MULTIPLES: Final = 5
"""Number of multiples of a first part's order, near which a second part's lines mean nothing."""
_CLOSE_CALL: Final = 1.3
"""Depth over the limit of damage, up to which the verdict is a close one."""
_SURE: Final = 1.64
"""Standard deviations that 95 of 100 do not exceed."""
_FEW_REVOLUTIONS: Final = 100.0


@frozen(eq=False)
class _Candidate:
    """A part whose lines noise does not give.

    field: in which they were found; order; depth, and its standard deviation by noise; evidence:
    -log10 of the chance in noise; shaft: the multiple of the shaft on which they lie, 0 for none;
    turns_with_shaft: whether they keep step with it, as only what turns with it does.
    """

    part: Component
    finding: Finding
    field: Field
    order: float
    depth: float
    error: float
    evidence: float
    shaft: int = 0
    turns_with_shaft: bool = False

    @property
    def is_open(self) -> bool:
        """Whether noise may have lifted the depth over the limit of damage."""
        return self.depth - _SURE * self.error < DAMAGE <= self.depth

    @property
    def is_smooth(self) -> bool:
        """Whether the modulation is as deep as damage, but comes without impacts."""
        return self.depth >= DAMAGE and is_smooth(
            self.depth, *self.field.kurtosis(self.finding.band)
        )


def judge(
    spectra: BandSpectra, orders: FaultOrders, settings: DiagnosisSettings, shaft: ShaftLines
) -> Diagnosis:
    """Judge a bearing by its squared-envelope spectra, at the speed that its shaft's lines give."""
    freedom = 0.0 if shaft.confirmed else settings.speed_tolerance
    whole = field_of(spectra, orders, settings, freedom)
    findings = whole.findings(COMPONENTS)
    trials = sum(finding.trials for finding in findings.values() if finding)
    found = _candidates(whole, findings, trials)
    hidden: set[Component] = set()
    with_shaft = whole.with_shaft()
    for part in COMPONENTS:
        apart = found.get(part)
        if apart is None or apart.depth < DAMAGE:
            by_shaft = _by_shaft(with_shaft, part, trials, seen=apart is not None)
            if isinstance(by_shaft, _Candidate):
                found[part] = max(by_shaft, apart or by_shaft, key=lambda one: one.depth)
            elif by_shaft and (apart is None or apart.depth < _FAIR_SHARE * DAMAGE):
                found.pop(part, None)
                hidden.add(part)
    found = {part: _kept_step(one, with_shaft) for part, one in found.items()}
    first = _first(found)
    unexplained = tuple(
        line
        for line in unexplained_lines(
            whole, None if first is None else (first.part, first.order, first.depth)
        )
        if not orders.is_elsewhere(line.order, settings.tolerance)
    )
    verdict = _verdict_of(first, unexplained, spectra.dropouts)
    second = _seconds(first, found) if verdict == "fault" else []
    if first is not None:
        found[first.part] = first
    verdicts = []
    for part in COMPONENTS:
        one = found.get(part)
        if one is not None and one is first and verdict != "nothing_found":
            verdicts.append(_stated(one, verdict, trials, shaft, unexplained))
        elif one is not None and one in second:
            verdicts.append(_stated(one, "fault", trials, shaft, unexplained))
        else:
            why = _why_not(part, findings[part], found, first, whole, trials)
            if part in hidden:
                why = Note("peaks_hidden")
            verdicts.append(
                describe.no_fault(
                    part,
                    findings[part],
                    whole,
                    trials,
                    why,
                    untested=part in hidden,
                    depth=nan if one is None else one.depth,
                )
            )
    undecided = _other_speeds(verdict, unexplained, whole, shaft)
    searched = settings.tolerance
    impacts = None if undecided else _impacts(verdict, unexplained, orders, searched)
    notes = [*_notes(spectra), *_of_unexplained(unexplained)]
    element = orders.element
    return Diagnosis(
        components=tuple(part.of_element(element) for part in verdicts),
        false_alarm=settings.false_alarm,
        tolerance=settings.tolerance,
        trials=trials,
        shaft_frequency=spectra.shaft_frequency,
        speed_factor=shaft.factor,
        speed_source=_speed_source(shaft, first),
        speed_confirmed=shaft.confirmed,
        undecided=undecided,
        impacts=impacts,
        slips=() if impacts is None else _slips(impacts, orders, searched),
        kurtosis=spectra.kurtosis,
        revolutions=spectra.turns * spectra.blocks,
        blocks=spectra.blocks,
        resolution=1.0 / spectra.turns,
        spectra=_pictured(
            first.field if first is not None else whole,
            {part: np.array(f.per_band) for part, f in findings.items() if f},
        ),
        unexplained=unexplained,
        notes=tuple(of_element(note, element) for note in notes),
        element=element,
    )


# --- candidates ------------------------------------------------------------------------------


def _candidates(
    field: Field, findings: dict[Component, Finding | None], trials: int
) -> dict[Component, _Candidate]:
    found = {}
    for part, finding in findings.items():
        if finding is None:
            continue
        probability, evidence = chance(finding.evidence, trials)
        if probability <= field.settings.false_alarm:
            fundamental = describe.refined(finding, field)
            clear = _CLEAR_BAND * finding.evidence
            depth, error, band = max(
                (*_depth(part, finding, fundamental, field, band), band)
                for band, value in enumerate(finding.per_band)
                if value >= clear
            )
            finding = replace(finding, band=band)
            order = fundamental / field.turns
            one = _Candidate(part, finding, field, order, depth, error, evidence)
            if not _is_of_others(one):
                found[part] = one
    return found


def _is_of_others(one: _Candidate) -> bool:
    """Whether lines are likely the foot, or a sideband, of what lies outside of a part's window.

    A race's sidebands at the shaft's spacing fall into the windows of ball and cage, and hardly
    ever into the other race's; a ball's own sidebands are at the spacing of its cage.
    """
    small = one.depth < DAMAGE or one.part in ("ball", "cage")
    if small and describe.at_edge(one.finding):
        return True
    if one.part != "ball" or not one.field.orders.cage:
        return False
    by_shaft, by_cage = (
        max(
            one.field.depth(one.finding.band, (one.order + side) * one.field.turns)
            for side in (-spacing, spacing)
        )
        for spacing in (1.0, one.field.orders.cage)
    )
    return by_shaft >= max(by_cage, _FAIR_SHARE * one.depth)


def _depth(
    part: Component, finding: Finding, fundamental: float, field: Field, band: int
) -> tuple[float, float]:
    """Depth at the fundamental; of a ball or at its spin, of a cage of three multiples together.

    Damage to a ball strikes twice a turn, and harder on one race; what a cage does comes but once
    in some turns of the shaft, and the depth of rare impacts is spread over many multiples. Beside
    it stands its standard deviation by noise.
    """
    multiples = {"ball": (1.0, 0.5), "cage": (1.0, 2.0, 3.0)}.get(part, (1.0,))
    width = finding.hypothesis.width / finding.hypothesis.highest
    lines = [multiple * fundamental for multiple in multiples]
    pairs = [
        (field.depth(band, line, round(width * multiple)), field.depth_error(band, line))
        for multiple, line in zip(multiples, lines, strict=True)
    ]
    if part != "cage":
        return max(pairs)
    depth = hypot(*(one for one, _ in pairs))
    # d² = Σ dₖ²
    return depth, hypot(*(one * error for one, error in pairs)) / depth if depth else 0.0


def _by_shaft(field: Field, part: Component, trials: int, *, seen: bool) -> _Candidate | bool:
    """Look for a part at or beside a multiple of the shaft that its window holds.

    seen: whether the part is a candidate by what lies about the multiple. Returns the candidate, if
    it stands beside a multiple and is no foot of it, or on one and stands out of all lower ones;
    else whether a line lies there that may be of the part, so that nothing can be said of it.
    """
    low, high = field.window(part)
    foot = _FOOT / field.turns
    numbers = range(max(2, ceil(low - foot)), floor(high + foot) + 1)
    if part == "cage" or not numbers or not (seen or _is_deep(field, low - foot, high + foot)):
        return False
    one = _candidates(field, field.findings([part]), trials).get(part)
    if one is None or one.depth < _FAIR_SHARE * DAMAGE:
        if any(_may_hide(field, number) for number in numbers):
            return True
        if one is None:
            return False
    number = round(one.order)
    of_shaft = _of_shaft(field, one.finding.band, number)
    if number not in numbers or abs(one.order - number) > max(foot, _BESIDE):
        # a hump that reaches the multiple has what that has
        narrow = field.depth(one.finding.band, one.order * field.turns)
        return one if number not in numbers or narrow >= of_shaft[-1] else one.depth >= DAMAGE
    # a comb of the shaft's first multiples has them all; what stands out may still turn with it
    stands_out = one.depth >= _ABOVE_SHAFT * max(of_shaft[:-1])
    return replace(one, shaft=number) if stands_out else one.depth >= DAMAGE


def _kept_step(one: _Candidate, with_shaft: Field) -> _Candidate:
    """Mark a candidate whose line is discrete and lies on a multiple of the shaft.

    What turns with the shaft (blades, lobes, teeth) never gains or loses against it; a bearing's
    cage does, unless the slip happens to be that of the multiple. Then its sidebands decide.
    """
    number, turns = round(one.order), with_shaft.turns
    if number < 1 or one.part == "cage":
        return one
    band = one.finding.band
    apart = abs(one.order - number) * turns
    locked = with_shaft.depth(band, number * turns)
    whole = with_shaft.depth(band, one.order * turns, _HUMP)
    keeps = apart <= _OFF_STEP + _OFF_STEP_EACH * number and locked >= _IN_STEP * whole
    if not keeps or _has_cage_sidebands(one, with_shaft):
        return one
    return replace(one, shaft=number, turns_with_shaft=True)


def _has_cage_sidebands(one: _Candidate, field: Field) -> bool:
    """Whether lines one turn of the cage away from a part's stand clear of the noise, in pairs."""
    cage = field.orders.cage
    if not cage:
        return False
    band, reach = one.finding.band, np.arange(-_FOOT, _FOOT + 1)
    spacing = cage * (1.0 + np.nan_to_num(cage_slip(one.part, one.order, field.orders)))
    scores = Scores(field.spectra.power, field.left_out, field.medians, field.spectra.blocks)
    power = field.spectra.power[band]
    for multiple in (1, 2, 3):
        places = (multiple * one.order + spacing * np.array([-1.0, 1.0])) * field.turns
        lines = np.rint(places[:, None] + reach).astype(np.int64)
        sides = [scores.about(some, 1)[band] for some in lines]
        highest = [int(some[np.argmax(side)]) for some, side in zip(lines, sides, strict=True)]
        least = log(6 * len(reach) / field.settings.false_alarm)
        if all(np.max(side) >= least for side in sides) and all(
            power[line] >= _OVER_SKIRTS * leaked(power, line, envelope_leakage(), 2 * _FOOT)
            for line in highest
        ):
            return True
    return False


def _of_shaft(field: Field, band: int, number: int) -> list[float]:
    """Depths of the shaft's multiples up to one."""
    return [field.depth(band, n * field.turns) for n in range(1, number + 1)]


def _may_hide(field: Field, number: int) -> bool:
    """Whether a line at a multiple of the shaft stands out of noise and of all lower multiples.

    It may be the part's then: of a shaft alone the lower multiples are as strong.
    """
    reach = round(max(_FOOT, _BESIDE * field.turns))
    lines = round(number * field.turns) + np.arange(-reach, reach + 1)
    scores = Scores(field.spectra.power, field.left_out, field.medians, field.spectra.blocks)
    seen = scores.about(lines, 1)
    clear = np.max(seen, axis=1) > log(seen.size / field.settings.false_alarm)
    for band in np.flatnonzero(clear):
        lower = _of_shaft(field, int(band), number - 1)
        own = field.depth(int(band), float(lines[np.argmax(seen[band])]))
        if own >= max(_FAIR_SHARE * DAMAGE, _ABOVE_SHAFT * max(lower)):
            return True
    return False


def _is_deep(field: Field, low: float, high: float) -> bool:
    """Whether any line between two orders may be deep enough for damage, or half of a hump is."""
    lines = slice(max(1, int(low * field.turns)), ceil(high * field.turns) + 1)
    return bool(np.max(field.depths[:, lines], initial=0.0) >= (_FAIR_SHARE * DAMAGE) ** 2)


def _first(found: dict[Component, _Candidate]) -> _Candidate | None:
    """The cause: the deepest if any is deep, else the clearest; a ball before the cage it is in."""
    deep = [one for one in found.values() if one.depth >= DAMAGE]
    if not deep:
        return max(found.values(), key=lambda one: one.evidence, default=None)
    first = max(deep, key=lambda one: one.depth)
    ball = found.get("ball")
    if first.part != "cage" or ball is None or _explains(first, ball):
        return first
    # the lines of the cage that carries it are the ball's as well
    own = ball.depth >= _FAIR_SHARE * first.depth
    deepest = max(ball, first, key=lambda one: one.depth)
    return replace(ball, depth=deepest.depth, error=deepest.error) if own else first


def _explains(first: _Candidate, other: _Candidate) -> bool:
    """Whether a part's line is a multiple or a sideband of the first's."""
    # the cage carries what it makes to all orders: twelve of it are near the ball's
    multiples = 15 if first.part == "cage" else _MULTIPLES
    return bool(
        explained(
            np.array([other.order]),
            first.part,
            first.order,
            first.field.orders,
            first.field.turns,
            multiples=multiples,
            cage=first.part == "ball",
        )[0]
    )


def _seconds(first: _Candidate | None, found: dict[Component, _Candidate]) -> list[_Candidate]:
    """Parts that are damaged beside the first: deep, not explained by it, of the same cage."""
    if first is None:
        return []
    return [
        one
        for one in found.values()
        if one is not first
        and one.depth >= max(DAMAGE, _FAIR_SHARE * first.depth)
        and not (one.is_open or one.is_smooth or one.turns_with_shaft)
        and not describe.at_edge(one.finding)
        and {one.part, first.part} != {"ball", "cage"}
        and not _explains(first, one)
        and _same_cage(first, one)
    ]


def _same_cage(first: _Candidate, other: _Candidate) -> bool:
    slips = [_cage_slip(one) for one in (first, other)]
    return not abs(slips[0] - slips[1]) > _SAME_CAGE


def _cage_slip(one: _Candidate) -> float:
    """Part by which the cage is faster than nominal, by one part; NaN if it does not show it."""
    orders = one.field.orders
    carried = one.part == "cage" and orders.outer_spacing > 0.0  # by the outer ring
    lone = one.part == "inner_race" and not (orders.outer_race and orders.inner_race)
    return nan if carried or lone or one.part == "ball" else cage_slip(one.part, one.order, orders)


# --- verdicts --------------------------------------------------------------------------------


def _verdict_of(
    first: _Candidate | None, unexplained: Sequence[UnexplainedLine], dropouts: bool
) -> Verdict:
    """Verdict on the cause; stronger lines of other origin, mains or noise leave it undecided."""
    if first is None:
        return "nothing_found"
    stronger = any(line.depth >= first.depth for line in unexplained)
    stronger = stronger or dropouts or _on_mains(first)
    if first.depth < DAMAGE:
        return "nothing_found" if stronger else "watch"
    if stronger or first.is_open or first.turns_with_shaft:
        return "undecided"
    return "watch" if first.is_smooth else "fault"


def _slips(
    line: UnexplainedLine, orders: FaultOrders, searched: float
) -> tuple[tuple[Component, float], ...]:
    """Return parts whose line it would be with more slip than was searched, and how much."""
    near = slips_of(line.order, orders, max(_WIDEST_SLIP, searched))
    return tuple((part, slip) for part, slip in near if abs(slip) > searched)


def _impacts(
    verdict: Verdict, unexplained: Sequence[UnexplainedLine], orders: FaultOrders, searched: float
) -> UnexplainedLine | None:
    """Return the deepest impacts that nothing explains, over which "nothing found" is not said.

    A smooth modulation is that of a load, unless it is near the line of a part.
    """
    deep = [
        one
        for one in unexplained
        if one.depth >= DAMAGE
        and not one.of_mains
        and (not one.smooth or _slips(one, orders, searched))
    ]
    if verdict in ("fault", "undecided") or not deep:
        return None
    return max(deep, key=lambda line: line.depth)


def _on_mains(one: _Candidate) -> bool:
    return one.field.on_mains(one.finding.band, one.order * one.field.turns)


def _stated(
    one: _Candidate,
    verdict: Verdict,
    trials: int,
    shaft: ShaftLines,
    unexplained: Sequence[UnexplainedLine],
) -> ComponentVerdict:
    deviation = one.order / (one.field.orders.fundamental(one.part) or nan) - 1.0
    shaft_frequency = one.field.spectra.shaft_frequency
    doubts: list[Note] = []
    if any(line.depth >= one.depth for line in unexplained):
        line = unexplained[0]
        values = {"order": line.order, "frequency": line.frequency, "depth": line.depth}
        doubts.append(Note("stronger_peak", values))
    if _on_mains(one):
        doubts.append(Note("on_mains", {"frequency": one.order * shaft_frequency}))
    if one.field.spectra.dropouts:
        doubts.append(Note("dropouts"))
    if one.field.spectra.has_comb and one.depth >= DAMAGE:
        doubts.append(Note("no_slip"))
    if one.turns_with_shaft:
        doubts.append(Note("keeps_step", _to_decide(one)))
    elif one.shaft:
        doubts.append(Note("on_shaft", {"multiple": one.shaft}))
    slip = one.field.orders.tolerance(one.part, one.field.settings.tolerance)
    if not shaft.confirmed and abs(deviation) > slip:
        doubts.append(Note("speed_open", {"deviation": deviation}))
    elif abs(shaft.factor - 1.0) > one.field.settings.speed_tolerance:
        values = {"speed": 2.0 * pi * shaft_frequency, "deviation": shaft.factor - 1.0}
        doubts.append(Note("other_speed", values))
    if describe.at_edge(one.finding):
        doubts.append(Note("at_edge"))
    if one.is_open:
        doubts.append(Note("open_depth", {"limit": DAMAGE}))
    elif verdict == "fault" and one.depth < _CLOSE_CALL * DAMAGE:
        doubts.append(Note("close_call", {"limit": DAMAGE}))
    return describe.stated(
        one.part,
        one.finding,
        one.field,
        trials,
        verdict,
        "watch" if verdict == "watch" else grade_of(one.depth),
        one.depth,
        tuple(doubts),
    )


def _to_decide(one: _Candidate) -> dict[str, float]:
    """Return the multiple of the shaft, and the slip at which the part's line would lie on it."""
    slip = cage_slip(one.part, float(one.shaft), one.field.orders)
    return {"multiple": one.shaft, "slip": slip}


def _why_not(
    part: Component,
    finding: Finding | None,
    found: dict[Component, _Candidate],
    first: _Candidate | None,
    field: Field,
    trials: int,
) -> Note | None:
    """Why lines that noise does not give are not stated; None if there are none."""
    one = found.get(part)
    if one is None or first is None:
        clear = finding is not None and (
            chance(finding.evidence, trials)[0] <= field.settings.false_alarm
        )
        return Note("of_others") if clear else None
    if one is first:
        return Note("not_strongest")
    if first.part == "ball" and part == "cage":
        return Note("carries_the_ball")
    key = "of_first" if _explains(first, one) else "beside_first"
    return Note(key, {"first": first.part})


def _other_speeds(
    verdict: Verdict, unexplained: Sequence[UnexplainedLine], field: Field, shaft: ShaftLines
) -> tuple[tuple[Component, float], ...]:
    """Whose damage it would be at which speed, if what stands out is deep.

    Where the speed is open, at any that is near; else at the given one, if the shaft was heard at
    another.
    """
    if verdict == "fault":
        return ()
    given = field.spectra.shaft_frequency / shaft.factor
    for line in unexplained:
        if line.depth < DAMAGE:
            continue
        if field.freedom and line.shaft_frequencies:
            return line.shaft_frequencies
        at_given = slips_of(line.order * shaft.factor, field.orders, field.settings.tolerance)
        if at_given and shaft.confirmed and shaft.is_another:
            return tuple((part, given) for part, _ in at_given)
    return ()


def _speed_source(shaft: ShaftLines, first: _Candidate | None) -> SpeedSource:
    if shaft.confirmed:
        return "shaft_lines" if shaft.factor != 1.0 else "given"
    return "fault_lines" if first is not None and first.depth >= DAMAGE else "given"


def _pictured(field: Field, per_band: dict[Component, FloatArray]) -> EnvelopeSpectra:
    power, level = field.spectra.power, field.level
    above = np.full(power.shape, nan)
    np.divide(power, level, out=above, where=level > 0.0)
    return EnvelopeSpectra(
        order=np.arange(power.shape[1], dtype=np.float64) / field.turns,
        bands=field.spectra.bands,
        above_noise=above,
        squared_depth=field.depths,
        evidence=per_band,
    )


def _notes(spectra: BandSpectra) -> Iterator[Note]:
    turns = spectra.turns * spectra.blocks
    if turns < _FEW_REVOLUTIONS:
        yield Note("few_revolutions", {"revolutions": turns})
    if spectra.still and np.any(spectra.power):
        yield Note("still_blocks", {"left_out": spectra.still, "used": spectra.blocks})
    if spectra.dropouts:
        yield Note("dropouts")
    if spectra.repeats_after is not None:
        yield Note("repeated_data", {"after": spectra.repeats_after / spectra.rate})
    if len(spectra.bands) == 1:
        yield Note("one_band")


def _of_unexplained(lines: Sequence[UnexplainedLine]) -> Iterator[Note]:
    """Return which peaks nothing explains, the deepest first."""
    if lines:
        deepest = sorted(lines, key=lambda line: -line.depth)
        yield Note("unexplained_peaks", {"peaks": [line.to_mapping() for line in deepest]})
