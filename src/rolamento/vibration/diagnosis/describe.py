"""What is said of a component: its order to a fraction of a line, its lines, and the reasons."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite, nan
from typing import Final

import numpy as np

from rolamento.vibration.diagnosis.field import SEEN, Field
from rolamento.vibration.diagnosis.record import ComponentVerdict, MatchedLine, Verdict
from rolamento.vibration.diagnosis.search import Finding, SearchedLine, chance
from rolamento.vibration.diagnosis.settings import Component
from rolamento.vibration.diagnosis.size import DAMAGE, Grade, is_smooth
from rolamento.vibration.noise_floor import LOWEST_LINE
from rolamento.words import Note

_CLEAR_SIDEBAND: Final = 9.0
"""dB above the noise from which a sideband is reported; noise alone is above it once in
three thousand lines."""


def stated(
    component: Component,
    finding: Finding,
    field: Field,
    trials: int,
    verdict: Verdict,
    grade: Grade,
    depth: float,
    doubts: tuple[Note, ...],
) -> ComponentVerdict:
    """Return the verdict of a part whose lines noise does not give."""
    probability, evidence = chance(finding.evidence, trials)
    nominal = field.orders.fundamental(component) or nan
    fundamental = refined(finding, field)
    order = fundamental / field.turns
    frequency = order * field.spectra.shaft_frequency
    lines = tuple(_matched(line, fundamental, finding, field) for line in finding.hypothesis.lines)
    sidebands = _sidebands(component, fundamental, finding, field)
    band = field.spectra.bands[finding.band]
    record, in_band = field.kurtosis(finding.band)
    reasons = [
        Note("modulation_depth", {"depth": depth, "grade": grade}),
        _above_noise(order, frequency, lines),
    ]
    if sidebands:
        reasons.append(_modulated(component, _spacing(component, finding, field), sidebands))
    if is_smooth(depth, record, in_band) and depth >= DAMAGE:
        values = {"record": record, "band": in_band}
        reasons.insert(1, Note("smooth_modulation", values))
    reasons += [
        Note("clearest_band", {"low": band[0], "high": band[1]}),
        Note("improbable_in_noise", {"evidence": evidence, "trials": trials}),
        Note("off_nominal", {"deviation": order / nominal - 1.0}),
    ]
    return ComponentVerdict(
        component=component,
        verdict=verdict,
        grade=grade,
        depth=depth,
        probability=probability,
        evidence=evidence,
        nominal_order=nominal,
        order=order,
        deviation=order / nominal - 1.0,
        frequency=frequency,
        band=band,
        lines=tuple(line for line in lines if line.sideband == 0),
        sidebands=sidebands,
        reasons=tuple(reasons),
        doubts=doubts,
        band_kurtosis=in_band,
    )


def no_fault(
    component: Component,
    finding: Finding | None,
    field: Field,
    trials: int,
    why: Note | None = None,
    *,
    untested: bool = False,
    depth: float = nan,
) -> ComponentVerdict:
    """Return the verdict that nothing was found, or that nothing can be said.

    why: nothing can be said, or its lines are there without being evidence of it; depth: of those.
    """
    nominal = field.orders.fundamental(component)
    probability, evidence = (nan, nan) if finding is None else chance(finding.evidence, trials)
    if why is not None:
        reason = why
    elif finding is None:
        reason = Note(_why_untested(nominal, field))
    else:
        values = {"probability": min(probability, 1.0), "trials": trials}
        reason = Note("nothing_above_noise", values)
    nothing = (finding is not None or why is not None) and not untested
    return ComponentVerdict(
        component=component,
        verdict="nothing_found" if nothing else "not_tested",
        grade="nothing",
        depth=depth,
        probability=probability,
        evidence=evidence,
        nominal_order=nan if nominal is None else nominal,
        order=nan,
        deviation=nan,
        frequency=nan,
        band=None,
        lines=(),
        sidebands=(),
        reasons=(reason,),
    )


def _above_noise(order: float, frequency: float, lines: Sequence[MatchedLine]) -> Note:
    """Return by how much the multiples of a fault stand out."""
    plain = [line for line in lines if line.sideband == 0 and isfinite(line.above_noise)]
    values = {
        "order": order,
        "frequency": frequency,
        "multiples": [line.multiple for line in plain],
        "levels": [line.above_noise for line in plain],
    }
    return Note("harmonics_above_noise", values)


def _modulated(component: Component, spacing: float, lines: Sequence[MatchedLine]) -> Note:
    """Return that there are sidebands, and what modulates."""
    levels = [line.above_noise for line in lines if isfinite(line.above_noise)]
    values = {
        "spacing": spacing,
        "strongest": max(levels, default=None),
        "carrier": "cage" if component == "ball" else "ring",
    }
    return Note("sidebands", values)


def _why_untested(nominal: float | None, field: Field) -> str:
    if nominal is None:
        return "no_order"
    if not np.any(field.spectra.power):
        return "only_tones" if field.spectra.bare else "no_change"
    if nominal * field.turns < LOWEST_LINE + 1:
        return "unresolved_from_shaft"
    widest = max(high - low for low, high in field.spectra.bands)
    too_high = nominal * field.spectra.shaft_frequency > SEEN * widest
    return "rate_too_low" if too_high else "peaks_hidden"


def at_edge(finding: Finding) -> bool:
    """Whether a fundamental is the first or last that was tried of many."""
    step = finding.hypothesis.step
    to_edge = min(finding.fundamental - finding.low, finding.high - finding.fundamental)
    return finding.high - finding.low > 6.0 * step and to_edge < 1.5 * step


def refined(finding: Finding, field: Field) -> float:
    """Fundamental as the middle of the power above noise of the lines that were matched."""
    power, level = field.spectra.power[finding.band], field.level[finding.band]
    weighted = weights = 0.0
    for line in finding.hypothesis.lines:
        centre = line.multiple * finding.fundamental + line.sideband * finding.spacing
        places = np.arange(max(1, round(centre) - line.width), round(centre) + line.width + 1)
        places = places[places < len(power)]
        with np.errstate(invalid="ignore", divide="ignore"):
            above = np.clip(power[places] / level[places] - 1.0, 0.0, None)
        total = float(np.sum(above))
        if np.isfinite(total) and total > 0.0:
            middle = float(np.sum(above * places)) / total
            # a line gives the order by its multiple, and the less the wider it is
            weight = line.multiple**2 * total / (1.0 + line.width**2)
            weighted += weight * (middle - line.sideband * finding.spacing) / line.multiple
            weights += weight
    middle = weighted / weights if weights > 0.0 else finding.fundamental
    return min(max(middle, finding.low), finding.high)


def _matched(line: SearchedLine, fundamental: float, finding: Finding, field: Field) -> MatchedLine:
    """A line in the spectrum without its regular part, in which it was searched."""
    place = line.multiple * fundamental + line.sideband * finding.spacing
    near = _lines_near(place, line.width)
    usable = ~field.left_out[finding.band, near] & (field.medians[finding.band, near] > 0.0)
    above = nan
    if np.any(usable):
        ratio = field.spectra.power[finding.band, near] / field.level[finding.band, near]
        above = 10.0 * float(np.log10(np.max(ratio[usable])))
    return _line_at(line.multiple, line.sideband, place, above, field)


def _sidebands(
    component: Component, fundamental: float, finding: Finding, field: Field
) -> tuple[MatchedLine, ...]:
    """Sidebands of the matched multiples that are clear in the squared envelope as it is."""
    spacing = _spacing(component, finding, field) * field.turns
    if spacing == 0.0:
        return ()
    found = []
    for line in finding.hypothesis.lines:
        for side in (-1, 1) if line.sideband == 0 else ():
            place = line.multiple * fundamental + side * spacing
            near = _lines_near(place, max(1, line.width // 2))
            level = field.level[finding.band, near]
            if near.start >= len(field.left_out[0]) or not np.all(level > 0.0):
                continue
            ratio = float(np.max(field.spectra.plain[finding.band, near] / level))
            above = 10.0 * float(np.log10(ratio)) if ratio > 0.0 else -np.inf
            if above > _CLEAR_SIDEBAND:
                found.append(_line_at(line.multiple, side, place, above, field))
    return tuple(found)


def _spacing(component: Component, finding: Finding, field: Field) -> float:
    """Spacing of the sidebands that were matched, or else that are expected; orders."""
    return finding.spacing / field.turns or field.orders.spacing(component)


def _line_at(
    multiple: float, sideband: int, place: float, above: float, field: Field
) -> MatchedLine:
    order = place / field.turns
    return MatchedLine(multiple, sideband, order, order * field.spectra.shaft_frequency, above)


def _lines_near(place: float, width: int) -> slice:
    reach = max(1, width // 2)
    return slice(max(0, round(place) - reach), max(0, round(place) + reach + 1))
