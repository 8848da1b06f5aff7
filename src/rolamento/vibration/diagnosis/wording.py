"""The sentences of a diagnosis."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import isfinite
from typing import Final

from rolamento.vibration._checks import Band
from rolamento.vibration.diagnosis.record import MatchedLine, Reason, UnexplainedLine
from rolamento.vibration.diagnosis.settings import Component
from rolamento.vibration.diagnosis.size import DAMAGE, Grade

PART: Final[dict[Component, str]] = {
    "outer_race": "outer race",
    "inner_race": "inner race",
    "ball": "ball",
    "cage": "cage",
}

_UNTESTED: Final = {
    "no_order": "Its order is not given.",
    "no_change": "The signal does not change: most samples only repeat the one before.",
    "only_tones": "The signal holds tones, and beside them nothing.",
    "hidden": ("Its lines coincide with multiples of the shaft or of what else is known to turn."),
    "record_too_short": "The record is too short to tell its lines from the shaft's.",
    "rate_too_low": "The sampling rate is too low for its frequency.",
}


def above_noise(order: float, frequency: float, lines: Sequence[MatchedLine]) -> Reason:
    """Return by how much the multiples of a fault stand out."""
    plain = [line for line in lines if line.sideband == 0 and isfinite(line.above_noise)]
    levels = _listed(f"{line.above_noise:.0f}" for line in plain)
    multiples = _listed(f"{line.multiple:g}" for line in plain)
    return Reason(
        "harmonics_above_noise",
        f"At {multiples} times order {order:.4g} ({frequency:.4g} Hz) the squared envelope rises "
        f"{levels} dB above the noise about it.",
    )


def of_ball() -> Reason:
    """Return that the lines of the cage are those of a damaged ball that it carries."""
    return Reason(
        "carries_the_ball",
        "Its lines stand out as those of the ball do: a damaged ball goes in and out of the load "
        "once in each turn of the cage. Nothing else points to the cage.",
    )


def of_first(first: Component) -> Reason:
    """Return that lines of a part are multiples of another's, or sidebands of them."""
    return Reason(
        "of_first",
        f"What stands out at its lines lies on multiples of the {PART[first]}'s, or on sidebands "
        "of them: nothing else points to this part.",
    )


def beside_first(first: Component) -> Reason:
    """Return that lines of a part are too small to be stated beside another's."""
    return Reason(
        "beside_first",
        f"What stands out at its lines is too little beside the {PART[first]}, or of another cage "
        "speed, to be stated as well.",
    )


def of_others() -> Reason:
    """Return that lines are likely the foot, or a sideband, of what lies outside of a window."""
    return Reason(
        "of_others",
        "What stands out at its lines is at the edge of where they are looked for, or has "
        "sidebands of the shaft: it probably comes from something else.",
    )


def not_strongest() -> Reason:
    """Return that lines are small, and that there are stronger ones that are of no part."""
    return Reason(
        "not_strongest",
        "What stands out at its lines is as small as in many healthy bearings, and lines of "
        "another origin are as deep.",
    )


def deep(depth: float, grade: Grade) -> Reason:
    """Return how deep the modulation is, and what that is worth."""
    worth = {
        "watch": "as many healthy bearings have",
        "damage": "more than healthy bearings have",
        "severe": "the band holds little but impacts",
    }
    return Reason(
        "depth", f"Modulation depth {100.0 * depth:.0f} %: {worth.get(grade, 'nothing')}."
    )


# --- what speaks against it ------------------------------------------------------------------


def stronger_line(line: UnexplainedLine, depth: float) -> Reason:
    """Return that something else is as strong."""
    return Reason(
        "stronger_line",
        f"A line at order {line.order:.4g} ({line.frequency:.4g} Hz) that the part does not "
        f"explain is as deep: {100.0 * line.depth:.0f} % against {100.0 * depth:.0f} %.",
    )


def on_mains(frequency: float) -> Reason:
    """Return that a line is one of the mains'."""
    return Reason(
        "on_mains",
        f"{frequency:.4g} Hz is a multiple of 50 or 60 Hz, and the line does not slip: the mains "
        "give the same.",
    )


def dropouts() -> Reason:
    """Return that the record has gaps."""
    return Reason(
        "dropouts",
        "Again and again some samples only repeat the one before: gaps of a transmission, or a "
        "signal that is clipped, make lines of their own.",
    )


def no_slip() -> Reason:
    """Return that the blows come as even as a clock's."""
    return Reason(
        "no_slip",
        "Its impacts follow each other as evenly as a clock's, and those of a rolling bearing slip:"
        " another machine, or its drive, may give the same.",
    )


def on_shaft(multiple: int) -> Reason:
    """Return that a line lies on a multiple of the shaft."""
    return Reason(
        "on_shaft",
        f"It lies on {multiple} times the shaft's frequency, but stands out of all lower "
        "multiples: what has as many lobes and turns with the shaft would give the same.",
    )


def speed_open(deviation: float) -> Reason:
    """Return that nothing tells the speed."""
    return Reason(
        "speed_open",
        "The shaft's own lines do not tell its speed; with the expected slip it would be "
        f"{100.0 * deviation:+.1f} % off the given one.",
    )


def other_speed(rpm: float, factor: float) -> Reason:
    """Return that the shaft's lines tell another speed than was given."""
    return Reason(
        "other_speed",
        f"By its own lines the shaft ran at {rpm:.0f} rpm, {100.0 * (factor - 1.0):+.1f} % off the "
        "given speed: check it.",
    )


def close_call(depth: float) -> Reason:
    """Return that the depth is near the limit."""
    return Reason(
        "close_call",
        f"A depth of {100.0 * depth:.0f} % is near the limit of {100.0 * DAMAGE:.0f} %: a few "
        "healthy bearings reach it, above all beside a damaged one.",
    )


def open_depth() -> Reason:
    """Return that noise may have lifted the depth over the limit."""
    return Reason(
        "open_depth",
        "The record is too short, or its noise too great, to tell this depth from one below the "
        f"limit of {100.0 * DAMAGE:.0f} %: measure longer.",
    )


def of_sidebands(component: Component, spacing: float, lines: Sequence[MatchedLine]) -> Reason:
    """Return that sidebands were matched, and what modulates."""
    levels = [line.above_noise for line in lines if line.sideband and isfinite(line.above_noise)]
    cause = "the cage carries the ball" if component == "ball" else "the ring turns"
    strongest = f", up to {max(levels):.0f} dB above the noise" if levels else ""
    return Reason(
        "sidebands",
        f"Sidebands {spacing:.4g} of the shaft's frequency away{strongest}: the damage goes "
        f"through the load as {cause}.",
    )


def at_band(band: Band) -> Reason:
    """Return where a fault is clearest."""
    return Reason("band", f"Clearest between {band[0]:.0f} and {band[1]:.0f} Hz.")


def chance_of_noise(probability: float, evidence: float, trials: int) -> Reason:
    """Return how improbable a finding is without damage."""
    text = f"{probability:.1g}" if evidence < 15.0 else f"10^-{evidence:.0f}"
    return Reason(
        "improbable_in_noise",
        f"Noise without such lines gives anything as clear with a probability of at most {text}, "
        f"all {trials} trials counted.",
    )


def off_nominal(deviation: float) -> Reason:
    """Return how far an order is off the nominal one."""
    side = "above" if deviation > 0.0 else "below"
    return Reason("off_nominal", f"{abs(deviation):.2%} {side} the nominal order.")


def at_edge() -> Reason:
    """Return that a fault lies where the search ends."""
    return Reason(
        "at_edge",
        "It lies at the edge of what the allowed slip reaches, and may go on beyond: check speed, "
        "bearing and contact angle.",
    )


def nothing_above_noise(probability: float, trials: int) -> Reason:
    """Return that the best match is one of noise."""
    return Reason(
        "nothing_above_noise",
        f"The best of {trials} trials is what noise gives with a probability of "
        f"{'1' if probability >= 1.0 else f'{probability:.2g}'}.",
    )


def unexplained(line: UnexplainedLine) -> Reason:
    """Return that a line belongs to nothing that is known, and whose it would be at what speed."""
    others = _listed(
        f"{PART[part]} at {60.0 * frequency:.0f} rpm" for part, frequency in line.shaft_frequencies
    )
    hint = f" It would be the lowest line of: {others}." if line.shaft_frequencies else ""
    if line.of_mains:
        hint = " It is a multiple of 50 or 60 Hz, and does not slip: perhaps the mains."
    return Reason(
        "unexplained_lines",
        f"At order {line.order:.4g} ({line.frequency:.4g} Hz) the squared envelope rises "
        f"{line.above_noise:.0f} dB above the noise, which no part of this bearing and no turn of "
        f"the shaft explains: check speed and bearing.{hint}",
    )


def untested(name: str) -> Reason:
    """Return why a component could not be told of."""
    return Reason(name, _UNTESTED[name])


def _listed(words: Iterable[str]) -> str:
    items = list(words)
    return "".join(items) if len(items) < 2 else f"{', '.join(items[:-1])} and {items[-1]}"
