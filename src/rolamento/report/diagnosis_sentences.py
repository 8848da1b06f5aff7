"""Sentences of a diagnosis in a person's language, made of its numbers.

The engine gives a name and an English sentence for every reason; what has a name that is not known
here is said in the engine's own words.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import floor, isfinite
from typing import TYPE_CHECKING, Final

from rolamento.report.diagnosis_words import DIAGNOSIS_WORDS, DiagnosisWords
from rolamento.report.frequencies import said_failure
from rolamento.report.frequencies_words import FREQUENCY_WORDS
from rolamento.report.language import words_for
from rolamento.report.numbers import Digits
from rolamento.units import rpm_of
from rolamento.vibration.diagnosis.size import DAMAGE

if TYPE_CHECKING:
    from rolamento.tasks.diagnosis import DiagnosisResult, TooShort
    from rolamento.vibration.diagnosis import ComponentVerdict, Diagnosis, Reason

__all__ = [
    "listed",
    "said_advice",
    "said_chance",
    "said_doubts",
    "said_note",
    "said_own_note",
    "said_reasons",
    "said_result",
    "said_statements",
    "said_too_short",
]

_DIGITS: Final = 15.0
"""Evidence beyond which a probability is no more than small: no noise is known so well."""
_MOST_LINES: Final = 5
"""Unexplained lines that are said one by one."""


def said_result(found: DiagnosisResult, language: str) -> list[str]:
    """Return what all comes to, sentence by sentence."""
    if found.speed_lost and not found.still and not _stated(found.diagnosis):
        return [_words_and_digits(language)[0].no_speed]
    if found.verdict == "no_verdict" and not found.still:
        return _said_untested(found.diagnosis, language)
    return said_statements(found.diagnosis, language, still=found.still)


def _said_untested(diagnosis: Diagnosis, language: str) -> list[str]:
    """Return what could not be tested, why, and that nothing stands out of the rest."""
    said, _ = _words_and_digits(language)
    tested = [said.parts[p.component] for p in diagnosis.components if p.verdict != "not_tested"]
    untested = [part for part in diagnosis.components if part.verdict == "not_tested"]
    reasons = dict.fromkeys(text for p in untested for text in said_reasons(p, diagnosis, language))
    first = said.no_verdict
    if tested:
        parts = listed((said.parts[part.component] for part in untested), said)
        first = said.no_verdict_without.format(parts=parts)
    rest = [said.rest.format(parts=listed(tested, said))] if tested else []
    return [first, *reasons, *rest]


def said_too_short(found: TooShort, language: str) -> str:
    """Return that a record is too short for any race, or its shaft too slow for its rate."""
    said, digits = _words_and_digits(language)
    times = found.least_revolutions / found.revolutions
    return (said.too_slow if found.is_stretch else said.too_short).format(
        turns=digits.short(found.revolutions, 2),
        duration=digits.short(found.duration, 3),
        least=digits.short(found.least_revolutions, 2),
        seconds=digits.short(found.duration * times, 2),
        times=digits.short(times, 2),
    )


def said_statements(diagnosis: Diagnosis, language: str, *, still: bool = False) -> list[str]:
    """Return what the diagnosis comes to: the verdict, what to do, and what speaks against it.

    still: whether the signal does not change at all, of which the spectra tell nothing.
    """
    said, digits = _words_and_digits(language)
    parts = diagnosis.components
    if still and not diagnosis.faults:
        return [said.no_change]
    tested = [said.parts[p.component] for p in parts if p.verdict not in ("not_tested", "fault")]
    untested = [said.parts[p.component] for p in parts if p.verdict == "not_tested"]
    stated = _stated(diagnosis)
    if not stated and not tested:
        return [said.no_verdict]
    sentences = [_verdict(part, diagnosis, said, digits) for part in stated]
    if diagnosis.undecided:
        sentences.append(_at_speeds(diagnosis, said, digits))
    elif not stated:
        clear = any(part.probability <= diagnosis.false_alarm for part in parts)
        nothing = said.nothing_own if clear else said.nothing_found
        sentences.append(nothing.format(parts=listed(tested, said)))
    if diagnosis.unexplained and not stated:
        sentences.append(said.other_lines)
    if untested:
        sentences.append(said.untested.format(parts=listed(untested, said)))
    return sentences


def said_advice(diagnosis: Diagnosis, language: str) -> list[str]:
    """Return what to do, and what speaks against a verdict; nothing where nothing is found."""
    said, _ = _words_and_digits(language)
    stated = _stated(diagnosis)
    if diagnosis.undecided:
        return [said.to_do["undecided_speed"]]
    if not stated:
        return []
    first = stated[0]
    doubts: list[str] = []
    for part in stated:
        for doubt in said_doubts(part, diagnosis, language):
            doubts += [doubt] if doubt not in doubts else []
    key = "undecided" if first.verdict == "undecided" else diagnosis.grade
    against = said.against.format(doubts=" ".join(doubts)) if doubts else said.nothing_against
    return [said.to_do[key], against]


def said_doubts(part: ComponentVerdict, diagnosis: Diagnosis, language: str) -> list[str]:
    """Return what speaks against a part's verdict, sentence by sentence."""
    return [_reason(doubt, part, diagnosis, language) for doubt in part.doubts]


def said_chance(evidence: float, said: DiagnosisWords) -> str:
    """Return a probability of ten to the minus evidence, at most; a very small one as a limit."""
    if evidence > _DIGITS:
        return said.chance_below.format(number=f"1e-{_DIGITS:.0f}")
    if evidence < 2.0:
        digits = Digits(words_for("pt" if said is DIAGNOSIS_WORDS["pt"] else "en").decimal_mark)
        return said.chance.format(number=digits.short(10.0**-evidence, 2))
    power = floor(-evidence)
    mantissa = int(10.0 ** (-evidence - power) * 0.9999999) + 1  # rounded up: it is a bound
    if mantissa == 10:
        mantissa, power = 1, power + 1
    return said.chance.format(number=f"{mantissa}e-{-power}")


def said_reasons(part: ComponentVerdict, diagnosis: Diagnosis, language: str) -> list[str]:
    """Return why a verdict is what it is, sentence by sentence."""
    return [_reason(reason, part, diagnosis, language) for reason in part.reasons]


def said_note(note: Reason, diagnosis: Diagnosis, language: str) -> str:
    """Return what a user should know about a diagnosis."""
    said, digits = _words_and_digits(language)
    if note.name == "unexplained_lines" and diagnosis.unexplained:
        return _unexplained(diagnosis, said, digits)
    if note.name not in said.note:
        return note.text
    return said.note[note.name].format(
        turns=digits.short(diagnosis.revolutions, 3), blocks=diagnosis.blocks
    )


def said_own_note(name: str, found: DiagnosisResult, language: str) -> str:
    """Return one of the result's own notes."""
    said, digits = _words_and_digits(language)
    numbers = {
        "tolerance": digits.short(100.0 * found.settings.tolerance, 3),
        "rows": listed((said.row.format(row=row) for row in found.other_rows), said),
    }
    if name == "no_loaded_frequencies":
        numbers["reason"] = _why_not_loaded(found, language)
    tracking = None if found.speed is None else found.speed.tracking
    if name == "speed_not_found" and tracking is not None and tracking.lost is not None:
        numbers["start"], numbers["end"] = (digits.short(end, 4) for end in tracking.lost)
        numbers["within"] = digits.short(100.0 * tracking.within, 3)
        numbers["nominal"] = digits.short(rpm_of(abs(tracking.nominal)), 6)
    return said.note[name].format(**numbers)


def listed(items: Iterable[str], said: DiagnosisWords, last: str | None = None) -> str:
    """Return words one after the other, the last two with "and", or as a template has them."""
    words = list(items)
    if len(words) < 2:
        return "".join(words)
    return (last or said.all_of).format(list=", ".join(words[:-1]), last=words[-1])


def _words_and_digits(language: str) -> tuple[DiagnosisWords, Digits]:
    words = words_for(language)
    return DIAGNOSIS_WORDS[words.code], Digits(words.decimal_mark)


def _stated(diagnosis: Diagnosis) -> list[ComponentVerdict]:
    """Parts that are named by the verdict, the deepest first."""
    named = [p for p in diagnosis.components if p.verdict in ("fault", "undecided", "watch")]
    return sorted(named, key=lambda part: -part.depth)


def _verdict(
    part: ComponentVerdict, diagnosis: Diagnosis, said: DiagnosisWords, digits: Digits
) -> str:
    seen = sum(line.multiple != 1.0 and isfinite(line.above_noise) for line in part.lines)
    lines = {0: said.one_line, 1: said.line_and_multiple}.get(seen, said.line_and_multiples)
    cause = diagnosis.cause(part.component)
    whole = f"{said.subjects[cause][0].lower()}{said.subjects[cause][1:]}"
    template = said.severe if part.grade == "severe" else said.damaged
    if part.verdict != "fault":
        template = said.undecided if part.verdict == "undecided" else said.watched
    return template.format(
        subject=said.subjects[cause],
        part=whole,
        lines=lines.format(frequency=_hertz(part.frequency, digits), count=seen),
        depth=_percent(part.depth, digits),
    )


def _at_speeds(diagnosis: Diagnosis, said: DiagnosisWords, digits: Digits) -> str:
    """Say whose damage it would be at which speed."""
    each = [
        said.if_speed.format(part=said.the_parts[part], speed=digits.fixed(60.0 * frequency, 0))
        for part, frequency in diagnosis.undecided
    ]
    return said.undecided_speed.format(parts=listed(each, said, last=said.any_of))


def _percent(part: float, digits: Digits) -> str:
    return digits.fixed(100.0 * part, 0)


def _unexplained(diagnosis: Diagnosis, said: DiagnosisWords, digits: Digits) -> str:
    """Say the clearest of the lines that nothing explains."""
    lines = sorted(diagnosis.unexplained, key=lambda line: -line.depth)
    entries = [
        said.unexplained_line.format(
            frequency=_hertz(line.frequency, digits),
            order=digits.short(line.order, 4),
            level=digits.fixed(line.above_noise, 0),
            depth=_percent(line.depth, digits),
            low=digits.fixed(line.band[0], 0),
            high=digits.fixed(line.band[1], 0),
        )
        for line in lines[:_MOST_LINES]
    ]
    more = len(lines) - len(entries)
    if more:
        entries.append(said.more_lines.format(count=more))
    several = len(lines) > 1
    sentence = said.unexplained[several].format(lines="; ".join(entries))
    if lines[0].of_mains:
        return f"{sentence} {said.of_mains[several]}"
    speeds = lines[0].shaft_frequencies
    if not speeds:
        return sentence
    parts = listed(
        (
            said.at_speed.format(part=said.parts[part], speed=digits.fixed(60.0 * frequency, 0))
            for part, frequency in speeds
        ),
        said,
    )
    return f"{sentence} {said.lowest_line[several].format(parts=parts)}"


def _why_not_loaded(found: DiagnosisResult, language: str) -> str:
    """Say why a load gives no frequencies."""
    words, said = words_for(language), FREQUENCY_WORDS[words_for(language).code]
    if found.solved is None or found.solved.converged[0]:
        return said.note["no_loaded_ball"]
    return said.failed.format(reason=said_failure(found.solved, words))


def _hertz(frequency: float, digits: Digits) -> str:
    return digits.fixed(frequency, 1 if frequency >= 100.0 else 2)


def _reason(reason: Reason, part: ComponentVerdict, diagnosis: Diagnosis, language: str) -> str:
    said, digits = _words_and_digits(language)
    template = said.reason.get(reason.name)
    if template is None:
        return reason.text
    if part.verdict in ("nothing_found", "not_tested"):
        chance = digits.short(min(part.probability, 1.0), 2)
        stated = _stated(diagnosis)
        first = said.the_parts[stated[0].component] if stated else ""
        return template.format(trials=diagnosis.trials, probability=chance, first=first)
    low, high = part.band or (0.0, 0.0)
    plain = [line for line in part.lines if isfinite(line.above_noise)]
    deviation = digits.fixed(100.0 * abs(part.deviation), 2)
    if reason.name == "harmonics_above_noise" and [line.multiple for line in plain] == [1.0]:
        template = said.one_harmonic
    if reason.name == "off_nominal" and not any(digit in "123456789" for digit in deviation):
        template = said.at_expected
    spacing = _spacing(part) if part.sidebands else 0.0
    other = diagnosis.unexplained[0] if diagnosis.unexplained else None
    return template.format(
        depth=_percent(part.depth, digits),
        worth=said.worth.get(part.grade, ""),
        damage=_percent(DAMAGE, digits),
        line=_hertz(other.frequency, digits) if other else "",
        line_order=digits.short(other.order, 4) if other else "",
        line_depth=_percent(other.depth, digits) if other else "",
        multiple=round(part.order),
        off=_signed(100.0 * part.deviation, digits),
        speed=digits.fixed(60.0 * diagnosis.shaft_frequency, 0),
        factor=_signed(100.0 * (diagnosis.speed_factor - 1.0), digits),
        multiples=listed((digits.short(line.multiple) for line in plain), said),
        levels=listed((digits.fixed(line.above_noise, 0) for line in plain), said),
        order=digits.short(part.order),
        frequency=_hertz(part.frequency, digits),
        spacing=digits.short(spacing, 4),
        orders=_orders(spacing, said, digits),
        strongest=_strongest(part, said, digits),
        carries=said.carries["ball" if part.component == "ball" else "ring"],
        low=digits.fixed(low, 0),
        high=digits.fixed(high, 0),
        chance=said_chance(part.evidence, said),
        trials=diagnosis.trials,
        deviation=deviation,
        side=said.sides[0 if part.deviation > 0.0 else 1],
    )


def _spacing(part: ComponentVerdict) -> float:
    """Of the sidebands; orders."""
    side = part.sidebands[0]
    return abs(side.order - side.multiple * part.order) / max(abs(side.sideband), 1)


def _orders(number: float, said: DiagnosisWords, digits: Digits) -> str:
    """Return the word for so many orders."""
    one = digits.short(number, 4) == "1" or number < said.one_below
    return said.order_words[0 if one else 1]


def _strongest(part: ComponentVerdict, said: DiagnosisWords, digits: Digits) -> str:
    levels = [line.above_noise for line in part.sidebands if isfinite(line.above_noise)]
    return said.strongest.format(level=digits.fixed(max(levels), 0)) if levels else ""


def _signed(number: float, digits: Digits) -> str:
    sign = "+" if number >= 0.0 else "-"
    return f"{sign}{digits.fixed(abs(number), 1)}"
