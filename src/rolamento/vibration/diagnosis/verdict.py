"""From spectra to verdicts: the clearest fault first, its lines put aside, then the next."""

from __future__ import annotations

from dataclasses import replace
from math import nan
from typing import Final

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.vibration.diagnosis import describe, wording
from rolamento.vibration.diagnosis.band_spectra import BandSpectra
from rolamento.vibration.diagnosis.field import Field, field_of
from rolamento.vibration.diagnosis.orders import COMPONENTS, Component, FaultOrders
from rolamento.vibration.diagnosis.record import (
    ComponentVerdict,
    Diagnosis,
    EnvelopeSpectra,
    Note,
)
from rolamento.vibration.diagnosis.search import Finding, chance
from rolamento.vibration.diagnosis.settings import DiagnosisSettings
from rolamento.vibration.diagnosis.unexplained import unexplained_lines

__all__ = ["judge"]

_BALL_OVER_CAGE: Final = 0.5
"""Evidence of a ball over the cage's. Damage to a ball marks both, its own lines more; damage to
the cage hardly marks a ball's: synthetic faults had over 0.8 and under 0.3."""
_BESIDE_CAGE: Final = 0.1
"""Evidence of another part over the cage's, below which it counts for nothing: multiples of the
cage's order lie on those of the outer race and near those of all parts."""
_FEW_REVOLUTIONS: Final = 100.0
_DOUBT: Final = 0.003
"""Of the cage's speed by a single fault: slip on two races need not be the same to the last."""


def judge(spectra: BandSpectra, orders: FaultOrders, settings: DiagnosisSettings) -> Diagnosis:
    """Judge a bearing by its squared-envelope spectra."""
    whole = field_of(spectra, orders, settings)
    findings = whole.findings(COMPONENTS)
    trials = sum(finding.trials for finding in findings.values() if finding)
    per_band = {part: np.array(f.per_band) for part, f in findings.items() if f}
    found, field, others = _found(whole, findings, trials)
    verdicts = {part: describe.fault(part, best, whole, trials) for part, best in found.items()}
    for part, finding in others.items():
        why = None
        if _is_clear(finding, trials, settings):
            why = wording.of_cage()
        elif part == "cage" and "ball" in found and _is_clear(findings["cage"], trials, settings):
            why = wording.of_ball()
        verdicts[part] = describe.no_fault(part, finding, field, trials, why)
    verdicts = _with_cage_agreement(verdicts, orders)
    unexplained = unexplained_lines(whole, verdicts.values())
    return Diagnosis(
        components=tuple(verdicts[part] for part in COMPONENTS),
        false_alarm=settings.false_alarm,
        tolerance=settings.tolerance,
        trials=trials,
        shaft_frequency=spectra.shaft_frequency,
        revolutions=spectra.turns * spectra.blocks,
        blocks=spectra.blocks,
        resolution=1.0 / spectra.turns,
        spectra=_pictured(whole, per_band),
        unexplained=unexplained,
        notes=(*_notes(spectra), *map(wording.unexplained, unexplained[:1])),
    )


def _found(
    field: Field, findings: dict[Component, Finding | None], trials: int
) -> tuple[dict[Component, Finding], Field, dict[Component, Finding | None]]:
    """Faults, the clearest first; the field without their lines, and the others' findings in it."""
    found: dict[Component, Finding] = {}
    while findings:
        clearest = _clearest(findings, trials, field.settings)
        best = findings[clearest]
        if best is None or not _is_clear(best, trials, field.settings):
            break
        if _is_of_cage(best, found):
            break
        found[clearest] = best
        field = field.without(clearest, best)
        findings = field.findings([part for part in findings if part != clearest])
    return found, field, findings


def _clearest(
    findings: dict[Component, Finding | None], trials: int, settings: DiagnosisSettings
) -> Component:
    """The part with the most evidence; a clear ball before its cage, if it has half as much."""
    evidence = {part: f.evidence if f else -1.0 for part, f in findings.items()}
    clearest = max(evidence, key=lambda part: evidence[part])
    ball = findings.get("ball")
    if clearest == "cage" and ball is not None and _is_clear(ball, trials, settings):
        return "ball" if ball.evidence >= _BALL_OVER_CAGE * evidence["cage"] else "cage"
    return clearest


def _is_of_cage(finding: Finding, found: dict[Component, Finding]) -> bool:
    """Whether a finding is so weak beside the cage's that it may be of the cage's multiples."""
    cage = found.get("cage")
    return cage is not None and finding.evidence < _BESIDE_CAGE * cage.evidence


def _is_clear(finding: Finding | None, trials: int, settings: DiagnosisSettings) -> bool:
    return finding is not None and chance(finding.evidence, trials)[0] <= settings.false_alarm


def _with_cage_agreement(
    verdicts: dict[Component, ComponentVerdict], orders: FaultOrders
) -> dict[Component, ComponentVerdict]:
    """Add whether faults that were found together tell of one cage speed."""
    slips = {
        part: slip
        for part, verdict in verdicts.items()
        if verdict.verdict == "fault" and not np.isnan(slip := _cage_slip(verdict, orders))
    }
    described = dict(verdicts)
    for part, slip in slips.items():
        others = [other for other in COMPONENTS if other in slips and other != part]
        if others:
            agrees = all(abs(slip - slips[other]) <= _DOUBT for other in others)
            reasons = (*verdicts[part].reasons, wording.cage_agreement(agrees, others))
            described[part] = replace(verdicts[part], reasons=reasons)
    return described


def _cage_slip(verdict: ComponentVerdict, orders: FaultOrders) -> float:
    """Part by which the cage is faster than nominal, by one fault; NaN if it does not tell."""
    if verdict.component == "cage" and orders.outer_spacing > 0.0:
        return nan  # the outer ring carries the cage along
    if verdict.component in ("outer_race", "cage"):
        return verdict.deviation
    if verdict.component == "inner_race" and orders.outer_race and orders.inner_race:
        return -verdict.deviation * orders.inner_race / orders.outer_race
    return nan


def _pictured(field: Field, per_band: dict[Component, FloatArray]) -> EnvelopeSpectra:
    power, level = field.spectra.power, field.level
    above = np.full(power.shape, nan)
    np.divide(power, level, out=above, where=level > 0.0)
    return EnvelopeSpectra(
        order=np.arange(power.shape[1], dtype=np.float64) / field.turns,
        bands=field.spectra.bands,
        above_noise=above,
        evidence=per_band,
    )


def _notes(spectra: BandSpectra) -> tuple[Note, ...]:
    notes = []
    turns = spectra.turns * spectra.blocks
    if turns < _FEW_REVOLUTIONS:
        notes.append(
            Note(
                "few_revolutions",
                f"The record holds {turns:.3g} revolutions of the shaft; with more, weaker faults "
                "can be told.",
            )
        )
    if spectra.still and np.any(spectra.power):
        notes.append(
            Note(
                "still_blocks",
                f"{spectra.still} of {spectra.blocks + spectra.still} stretches of the record "
                "hardly change and were left out.",
            )
        )
    if spectra.repeats_after is not None:
        notes.append(
            Note(
                "repeated_data",
                f"After {spectra.repeats_after / spectra.rate:.4g} s the record begins anew, "
                "sample by sample the same: copies hold no noise of their own, and the "
                "probabilities do not hold. Give one copy alone.",
            )
        )
    if len(spectra.bands) == 1:
        notes.append(
            Note(
                "one_band",
                "The sampling rate leaves one band for the modulations that are looked for; a "
                "higher one tells where a fault rings.",
            )
        )
    return tuple(notes)
