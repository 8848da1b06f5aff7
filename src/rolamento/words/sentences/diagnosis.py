"""What a diagnosis says: its verdict, advice, reasons, doubts and notes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import floor
from typing import TYPE_CHECKING, Any, Final

from rolamento.words.naming import (
    by_element,
    either,
    listed,
    part_name,
    the_part,
    the_part_first,
)
from rolamento.words.speaking import counted, manner, marked, said

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["SENTENCES", "hertz"]

_DIGITS: Final = 15.0
"""Evidence beyond which a probability is given as a limit: no noise is known so well."""
_MOST_PEAKS: Final = 5
"""Unexplained peaks that are said one by one."""

Values = Mapping[str, Any]


def hertz(frequency: float) -> str:
    """Write a frequency to a tenth of a hertz, or to a hundredth below 100 Hz."""
    return manner().fixed(frequency, 1 if frequency >= 100.0 else 2)


def _parts(values: Values) -> str:
    return listed(map(part_name, values["parts"]))


# --- verdict and advice ----------------------------------------------------------------------


def _peaks(values: Values) -> str:
    """Name the peaks of a part: the fundamental, and how many multiples were seen."""
    frequency, count = hertz(values["frequency"]), values["multiples"]
    if not count:
        return said("a peak at {frequency} Hz", frequency=frequency)
    return counted(
        "peaks at {frequency} Hz and {n} multiple",
        "peaks at {frequency} Hz and {n} multiples",
        count,
        frequency=frequency,
    )


def _damaged(values: Values) -> str:
    return said(
        "{part} is damaged: {peaks}, modulation depth {depth:.0f %}.",
        part=the_part_first(values["part"]), peaks=_peaks(values), depth=values["depth"],
    )  # fmt: skip


def _severely_damaged(values: Values) -> str:
    return said(
        "{part} is severely damaged: {peaks}, modulation depth {depth:.0f %}.",
        part=the_part_first(values["part"]), peaks=_peaks(values), depth=values["depth"],
    )  # fmt: skip


def _watched(values: Values) -> str:
    return said(
        "No damage stated. Watch: {peaks}, modulation depth {depth:.0f %}, as in many healthy"
        " bearings.",
        peaks=_peaks(values), depth=values["depth"],
    )  # fmt: skip


def _smooth(values: Values) -> str:
    return said(
        "No damage stated. Watch {part}: {peaks}, modulation depth {depth:.0f %}, a smooth"
        " modulation without impacts.",
        part=the_part(values["part"]), peaks=_peaks(values), depth=values["depth"],
    )  # fmt: skip


def _undecided(values: Values) -> str:
    return said(
        "Undecided: {peaks}, modulation depth {depth:.0f %}, would mean damage to {part}, but the"
        " evidence against it is as strong.",
        part=the_part(values["part"]), peaks=_peaks(values), depth=values["depth"],
    )  # fmt: skip


def _undecided_speed(values: Values) -> str:
    cases = either(
        said("{part} if the shaft ran at {speed:.0f rpm}", part=the_part(part), speed=speed)
        for part, speed in values["speeds"]
    )
    return said("Undecided: damage to {cases}.", cases=cases)


def _undecided_slip(values: Values) -> str:
    cases = either(_at_slip(part, slip) for part, slip in values["slips"])
    return said(
        "Undecided: a peak at {frequency} Hz, modulation depth {depth:.0f %}, would be damage to"
        " {cases}.",
        frequency=hertz(values["frequency"]), depth=values["depth"], cases=cases,
    )  # fmt: skip


def _at_slip(part: str, slip: float) -> str:
    if slip < 0.0:
        return said("{part} if the cage is {slip:.1f %} slow", part=the_part(part), slip=-slip)
    return said("{part} if the cage is {slip:.1f %} fast", part=the_part(part), slip=slip)


def _undecided_impacts(values: Values) -> str:
    return said(
        "Undecided: a peak at {frequency} Hz, modulation depth {depth:.0f %}, is explained by no"
        " part of this bearing and by no multiple of the shaft speed.",
        frequency=hertz(values["frequency"]), depth=values["depth"],
    )  # fmt: skip


def _unexplained_modulation(values: Values) -> str:
    return said(
        "No damage stated. Watch: a peak at {frequency} Hz, modulation depth {depth:.0f %}, a"
        " smooth modulation without impacts, is explained by no part of this bearing and by no"
        " multiple of the shaft speed.",
        frequency=hertz(values["frequency"]), depth=values["depth"],
    )  # fmt: skip


def _other_peaks(values: Values) -> str:
    return said(
        "Other peaks are there, the deepest at {frequency} Hz, modulation depth {depth:.0f %}: see"
        " the notes.",
        frequency=hertz(values["frequency"]), depth=values["depth"],
    )  # fmt: skip


def _nothing_found(values: Values) -> str:
    return said(
        "Nothing found: no peaks of {parts} rise above the noise by more than chance explains.",
        parts=_parts(values),
    )


def _nothing_own(values: Values) -> str:
    return said(
        "Nothing found: the peaks at the frequencies of {parts} have another origin, or are too"
        " small to count.",
        parts=_parts(values),
    )


def _untested(values: Values) -> str:
    return said("Not tested: {parts}.", parts=_parts(values))


def _no_verdict_without(values: Values) -> str:
    return said("No verdict: {parts} could not be tested.", parts=_parts(values))


def _rest(values: Values) -> str:
    return said("Nothing rises above the noise for: {parts}.", parts=_parts(values))


def _doubts(values: Values) -> str:
    from rolamento.words.sentences import sentence

    doubts = " ".join(sentence(one["key"], one["values"]) for one in values["doubts"])
    return said("Evidence against: {doubts}", doubts=doubts)


def _shared_lines(values: Values) -> str:
    nearest = ", ".join(
        said("{name} ({difference:.2f %} apart)", name=one["designation"],
             difference=one["difference"])
        for one in values["nearest"]
    )  # fmt: skip
    return counted(
        "These peaks do not show which bearing it is: {n} other of the {compared} in the catalogue"
        " has them too, within slip and speed: {nearest}. The evidence speaks against noise, not"
        " against another bearing: check the designation.",
        "These peaks do not show which bearing it is: {n} others of the {compared} in the catalogue"
        " have them too, within slip and speed; nearest: {nearest}. The evidence speaks against"
        " noise, not against another bearing: check the designation.",
        values["count"],
        compared=values["compared"],
        nearest=nearest,
    )


_COUNTED: Final = by_element(
    marked(
        "They have {own} and {other} balls: the orders of both races add up to that number,"
        " whatever the slip."
    ),
    marked(
        "They have {own} and {other} rollers: the orders of both races add up to that number,"
        " whatever the slip."
    ),
)


def _telling(values: Values) -> str:
    """Say by which lines two bearings differ, and what it takes to see that."""
    lines = said(
        "Greatest difference from {other}: {part}, {own} Hz against {others} Hz"
        " ({difference:.2f %}).",
        other=values["other"], part=part_name(values["best_part"]),
        own=hertz(values["best_frequency"]), others=hertz(values["best_other_frequency"]),
        difference=values["best_difference"],
    )  # fmt: skip
    needed = said(
        "To tell the two apart by it, speed and slip must be known to within {within:.2f %}, and"
        " one spectrum must cover at least {duration:.3 s}.",
        within=values["known_within"], duration=values["duration"],
    )  # fmt: skip
    sentences = [lines, needed]
    if values["best_difference"] < values["slip"]:
        sentences.append(
            said("Slip of up to {slip:.3 %} is usual and hides that.", slip=values["slip"])
        )
    own, other = values["balls"]
    if own != other:
        sentences.append(_COUNTED({**values, "own": own, "other": other}))
    return " ".join(sentences)


# --- reasons ---------------------------------------------------------------------------------


def _depth(values: Values) -> str:
    depth = values["depth"]
    if values["grade"] == "severe":
        return said(
            "Modulation depth {depth:.0f %}: the band contains little but impacts.", depth=depth
        )
    if values["grade"] == "damage":
        return said("Modulation depth {depth:.0f %}: more than in healthy bearings.", depth=depth)
    return said("Modulation depth {depth:.0f %}: as in many healthy bearings.", depth=depth)


def _harmonics(values: Values) -> str:
    write = manner()
    levels = listed(write.fixed(level, 0) for level in values["levels"])
    frequency = hertz(values["frequency"])
    if values["multiples"] == [1.0]:
        return said(
            "The squared envelope has a peak at order {order:.5} ({frequency} Hz), {levels} dB"
            " above the surrounding noise.",
            order=values["order"], frequency=frequency, levels=levels,
        )  # fmt: skip
    return said(
        "The squared envelope has peaks at {multiples} times order {order:.5} ({frequency} Hz),"
        " {levels} dB above the surrounding noise.",
        multiples=listed(write.short(one) for one in values["multiples"]),
        order=values["order"], frequency=frequency, levels=levels,
    )  # fmt: skip


_CARRIED: Final = by_element(
    marked(
        "Sidebands at ±{spacing:.4} × shaft speed: the damaged spot passes through the load"
        " zone as the cage carries the ball round."
    ),
    marked(
        "Sidebands at ±{spacing:.4} × shaft speed: the damaged spot passes through the load"
        " zone as the cage carries the roller round."
    ),
)


def _turned(values: Values) -> str:
    return said(
        "Sidebands at ±{spacing:.4} × shaft speed: the damaged spot passes through the load"
        " zone as the ring turns.",
        spacing=values["spacing"],
    )


def _sidebands(values: Values) -> str:
    strongest = values["strongest"]
    first = (_CARRIED if values["carrier"] == "cage" else _turned)(values)
    if strongest is None:
        return first
    second = said("The strongest is {level:.0f dB} above the noise.", level=strongest)
    return f"{first} {second}"


def _chance(values: Values) -> str:
    """Give a probability of ten to the minus evidence: at most that, a very small one as a limit.

    It is a bound, and so rounded up.
    """
    evidence, trials = values["evidence"], values["trials"]
    if evidence > _DIGITS:
        return said(
            "Noise alone gives a match this clear with a probability below {chance}, all {trials}"
            " trials counted.",
            chance=f"1e-{_DIGITS:.0f}", trials=trials,
        )  # fmt: skip
    if evidence < 2.0:
        chance = manner().short(10.0**-evidence, 2)
    else:
        power = floor(-evidence)
        mantissa = int(10.0 ** (-evidence - power) * 0.9999999) + 1
        chance = f"1e-{-power - 1}" if mantissa == 10 else f"{mantissa}e-{-power}"
    return said(
        "Noise alone gives a match this clear with a probability of at most {chance}, all {trials}"
        " trials counted.",
        chance=chance, trials=trials,
    )  # fmt: skip


def _nothing_above(values: Values) -> str:
    return said(
        "Noise alone gives the best match of {trials} trials with a probability of"
        " {probability:.2}.",
        trials=values["trials"], probability=values["probability"],
    )  # fmt: skip


def _off_nominal(values: Values) -> str:
    deviation = values["deviation"]
    if abs(deviation) < 0.5e-4:
        return said("At the expected order.")
    if deviation > 0.0:
        return said("{deviation:.2f %} above the expected order.", deviation=deviation)
    return said("{deviation:.2f %} below the expected order.", deviation=-deviation)


def _of_first(values: Values) -> str:
    return said(
        "The peaks at its frequencies are multiples of those of {first}, or sidebands of them."
        " Nothing else points to this part.",
        first=the_part(values["first"]),
    )


def _beside_first(values: Values) -> str:
    return said(
        "The peaks at its frequencies are too small beside those of {first}, or belong to another"
        " cage speed, to be stated as well.",
        first=the_part(values["first"]),
    )


def _stronger(values: Values) -> str:
    return said(
        "A peak at {frequency} Hz (order {order:.4}) that this part does not explain is as deep:"
        " {depth:.0f %}.",
        frequency=hertz(values["frequency"]), order=values["order"], depth=values["depth"],
    )  # fmt: skip


def _on_mains(values: Values) -> str:
    return said(
        "{frequency} Hz is a multiple of 50 or 60 Hz, and the peak shows no slip: the mains give"
        " the same.",
        frequency=hertz(values["frequency"]),
    )


# --- notes -----------------------------------------------------------------------------------


def _unexplained(values: Values) -> str:
    """Say the clearest of the peaks that nothing explains, and what they may be."""
    peaks = values["peaks"]
    entries = [
        said(
            "{frequency} Hz (order {order:.4}), depth {depth:.0f %}, {level:.0f dB} above the"
            " noise between {low:.0f} and {high:.0f Hz}",
            frequency=hertz(one["frequency"]), order=one["order"], depth=one["depth"],
            level=one["above_noise"], low=one["band"][0], high=one["band"][1],
        )
        for one in peaks[:_MOST_PEAKS]
    ]  # fmt: skip
    more = len(peaks) - len(entries)
    if more > 0:
        entries.append(counted("{n} more", "{n} more", more))
    first = counted(
        "A peak of the envelope spectrum is explained by no part of this bearing and by no multiple"
        " of the shaft speed: {peaks}. Check the speed and the bearing.",
        "Peaks of the envelope spectrum are explained by no part of this bearing and by no multiple"
        " of the shaft speed: {peaks}. Check the speed and the bearing.",
        len(peaks),
        peaks="; ".join(entries),
    )
    origin = _origin(peaks[0], len(peaks))
    return f"{first} {origin}" if origin else first


def _origin(peak: Values, count: int) -> str:
    """Say what the clearest of so many unexplained peaks may be."""
    if peak["of_mains"]:
        return counted(
            "It is a multiple of 50 or 60 Hz and shows no slip: possibly the mains.",
            "The first is a multiple of 50 or 60 Hz and shows no slip: possibly the mains.",
            count,
        )
    told = []
    if peak["smooth"]:
        told.append(
            counted(
                "It is a modulation without impacts, as a load that varies makes it.",
                "The first is a modulation without impacts, as a load that varies makes it.",
                count,
            )
        )
    if peak["speeds"]:
        told.append(
            counted(
                "It would be the lowest peak of: {parts}.",
                "The first would be the lowest peak of: {parts}.",
                count,
                parts=listed(_at_speeds(peak["speeds"])),
            )
        )
    return " ".join(told)


def _at_speeds(speeds: Iterable[tuple[str, float]]) -> Iterable[str]:
    for part, speed in speeds:
        yield said("{part} at {speed:.0f rpm}", part=part_name(part), speed=speed)


def _rows(values: Values) -> str:
    rows = listed(said("row {row}", row=row) for row in values["rows"])
    return said(
        "The orders of {rows} differ and were not searched: allow more slip, or give that row as a"
        " bearing of its own.",
        rows=rows,
    )


def _other_count(values: Values) -> str:
    return said(
        "The number of rollers is estimated: if there are {count}, the peak at {frequency} Hz is"
        " that of {part}. Count them and give `bearing.roller_count=N`.",
        frequency=hertz(values["frequency"]), part=the_part(values["part"]), count=values["count"],
    )  # fmt: skip


def _not_loaded(values: Values) -> str:
    from rolamento.words.sentences import sentence

    reason = sentence(values["reason"]["key"], values["reason"]["values"])
    return said("The frequencies sought are those of the geometry. {reason}", reason=reason)


SENTENCES: Final[dict[str, Sentence]] = {
    # verdict
    "part_damaged": _damaged,
    "part_severely_damaged": _severely_damaged,
    "peaks_watched": _watched,
    "part_smooth": _smooth,
    "undecided_slip": _undecided_slip,
    "undecided_impacts": _undecided_impacts,
    "unexplained_modulation": _unexplained_modulation,
    "part_undecided": _undecided,
    "undecided_speed": _undecided_speed,
    "nothing_found": _nothing_found,
    "nothing_own": _nothing_own,
    "other_peaks": _other_peaks,
    "parts_untested": _untested,
    "no_part_tested": marked("No verdict: this signal says nothing about any part of the bearing."),
    "no_verdict_without": _no_verdict_without,
    "nothing_in_the_rest": _rest,
    "signal_constant": marked("No verdict: the signal does not change."),
    "no_speed_no_verdict": marked(
        "No verdict: the speed was not found in the vibration, and at a constant speed nothing"
        " rises above the noise."
    ),
    "shaft_too_slow": marked(
        "No verdict: the shaft is too slow for this sampling rate. The longest stretch analysed at"
        " once, {duration:.3 s}, covers {revolutions:.2} revolutions; below {required:.2} nothing"
        " can be said about either race. Give the signal at a sampling rate at least {times:.2}"
        " times lower."
    ),
    "record_short": marked(
        "No verdict: the record is too short. It covers {revolutions:.2} revolutions of the shaft,"
        " {duration:.3 s}; below {required:.2} revolutions, {seconds:.2 s}, nothing can be said"
        " about either race."
    ),
    # advice
    "replace_bearing": marked("Recommendation: replace the bearing at the next stop, no later."),
    "plan_replacement": marked(
        "Recommendation: measure again soon and plan to replace the bearing."
    ),
    "measure_as_usual": marked(
        "Recommendation: no action; measure at the usual interval and compare the depth."
    ),
    "resolve_doubts": marked(
        "Recommendation: remove the causes of doubt, or measure for longer or elsewhere."
    ),
    "compare_with_healthy": marked(
        "Recommendation: compare with records of the same machine in good order (`baseline`): a"
        " modulation that was always there is not damage."
    ),
    "find_cage_speed": marked(
        "Recommendation: check the load and the contact angle, which set the speed of the cage, and"
        " the designation; give a case with the load, or allow more `slip`."
    ),
    "explain_impacts": marked(
        "Recommendation: check the speed and the designation, and name the other bearings, shafts"
        " and gears of the machine (`machine`): one of them may have this frequency."
    ),
    "find_speed": marked(
        "Recommendation: determine the speed of the shaft and give it with `speed`."
    ),
    "lines_of_other_bearings": _shared_lines,
    "lines_of_no_other_bearing": marked(
        "None of the {compared} other bearings in the catalogue has these peaks within slip and"
        " speed."
    ),
    "doubts": _doubts,
    "no_doubts": marked("Evidence against: none in this record."),
    # reasons
    "modulation_depth": _depth,
    "smooth_modulation": marked(
        "Nothing is impulsive (kurtosis {record:.3} of the record, {band:.3} of the band; 3 for"
        " noise): load that varies makes such a modulation, and damage seldom does."
    ),
    "harmonics_above_noise": _harmonics,
    "sidebands": _sidebands,
    "clearest_band": marked("Clearest between {low:.0f} and {high:.0f Hz}."),
    "improbable_in_noise": _chance,
    "off_nominal": _off_nominal,
    "nothing_above_noise": _nothing_above,
    "no_order": marked("Its order was not given."),
    "peaks_hidden": marked(
        "Its peaks coincide with multiples of the shaft speed, or of another known rotation:"
        " nothing can be said about it."
    ),
    "only_tones": marked("The signal contains tones and nothing else."),
    "unresolved_from_shaft": marked(
        "The record is too short to separate its peaks from those of the shaft."
    ),
    "rate_too_low": marked("The sampling rate is too low for its frequency."),
    "no_change": marked("The signal does not change: most samples only repeat the previous one."),
    "at_edge": marked(
        "It lies at the limit of the allowed slip and may lie beyond: check the speed, the bearing"
        " and the contact angle."
    ),
    "carries_the_ball": by_element(
        marked(
            "Its peaks accompany those of the ball: a damaged ball enters and leaves the load zone"
            " once in each revolution of the cage. Nothing else points to the cage."
        ),
        marked(
            "Its peaks accompany those of the roller: a damaged roller enters and leaves the load"
            " zone once in each revolution of the cage. Nothing else points to the cage."
        ),
    ),
    "of_first": _of_first,
    "beside_first": _beside_first,
    "of_others": marked(
        "The peaks at its frequencies lie at the edge of the search window, or have sidebands of"
        " the shaft: they probably have another origin."
    ),
    "not_strongest": marked(
        "The peaks at its frequencies are as small as in many healthy bearings, and peaks of"
        " another origin are as deep."
    ),
    # doubts
    "stronger_peak": _stronger,
    "on_mains": _on_mains,
    "dropouts": marked(
        "Repeatedly, some samples only repeat the previous one: transmission gaps, or clipping,"
        " produce peaks of their own."
    ),
    "on_shaft": marked(
        "It lies at {multiple} times the shaft speed, though it stands out from all lower"
        " multiples: anything with as many lobes that turns with the shaft gives the same."
    ),
    "keeps_step": marked(
        "It keeps step with {multiple} times the shaft speed, as blades, lobes or teeth on the"
        " shaft do; of this bearing it would be only with the cage off by just {slip:+.2f %}. What"
        " decides: a record at another load or speed, where the cage slips otherwise and the shaft"
        " does not; or whether anything on the shaft repeats {multiple} times a turn."
    ),
    "speed_open": marked(
        "The shaft's own peaks do not reveal its speed; without slip it would deviate by"
        " {deviation:+.1f %} from the given one."
    ),
    "other_speed": marked(
        "By its own peaks the shaft ran at {speed:.0f rpm}, {deviation:+.1f %} from the given"
        " speed: check it."
    ),
    "no_slip": marked(
        "Its impacts are as regular as a clock, whereas those of a rolling bearing slip: another"
        " machine, or its drive, may give the same."
    ),
    "open_depth": marked(
        "The record is too short, or too noisy, to tell this depth from one below the limit of"
        " {limit:.0f %}: measure for longer."
    ),
    "close_call": marked(
        "The depth is near the limit of {limit:.0f %}, which a few healthy bearings reach, above"
        " all beside a damaged one."
    ),
    # notes
    "distinguishing_lines": _telling,
    "no_distinguishing_line": marked(
        "No frequency tells the bearing from {other}: all of them are the same."
    ),
    "few_revolutions": marked(
        "The record covers {revolutions:.3} revolutions of the shaft; with more, weaker faults can"
        " be detected."
    ),
    "one_band": marked(
        "The sampling rate leaves a single band for the modulations sought; a higher one shows"
        " where a fault resonates."
    ),
    "still_blocks": marked(
        "Blocks of the record that hardly change were left out: {left_out}; used: {used}."
    ),
    "repeated_data": marked(
        "After {after:.4 s} the record begins again, identical sample by sample: copies contain no"
        " noise of their own, and the probabilities do not hold. Give one copy only."
    ),
    "not_a_certificate": marked(
        "“Nothing found” is a verdict about this record: damage too weak for its noise remains"
        " undetected."
    ),
    "weak_peaks": marked(
        "None of the multiples of a part said to be damaged stands out by itself: peaks of another"
        " cause may lie nearby. Check the speed, the bearing and the figure."
    ),
    "frequencies_of_estimated_geometry": marked(
        "The internal geometry was estimated from the load ratings: another geometry has other"
        " frequencies."
    ),
    "speed_not_found": marked(
        "From {start:.4} to {end:.4 s} the shaft does not stand out from the vibration's noise,"
        " within {within:.3 %} of {nominal:.6 rpm}: the speed was taken as constant. If it was"
        " not, damage may remain undetected. Give a measured speed, or a part of the record."
    ),
    "path_lost": marked(
        "From {start:.4} to {end:.4 s} the speed found within {within:.3 %} of {nominal:.6 rpm}"
        " does not follow the shaft: at most {share:.0f %} of the power about a harmonic lies on"
        " it. The speed was taken as constant, and damage may remain undetected. Give a measured"
        " speed; one that changes by more than 2 % within 12 revolutions is not followed."
    ),
    "no_loaded_frequencies": _not_loaded,
    "peak_of_other_count": _other_count,
    "range_not_covered": by_element(
        marked(
            "Under this load the orders of some balls deviate by more than {tolerance:.3 %}: those"
            " were not searched."
        ),
        marked(
            "Under this load the orders of some rollers deviate by more than {tolerance:.3 %}:"
            " those were not searched."
        ),
    ),
    "other_rows": _rows,
    "unexplained_peaks": _unexplained,
}
