"""A synthetic signal for a reader: what was planted, and where it was written."""

from __future__ import annotations

import os
from dataclasses import asdict
from math import degrees
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.errors import InputError
from rolamento.report.frequencies_words import FREQUENCY_WORDS
from rolamento.report.language import ENGLISH, Words
from rolamento.report.numbers import ABSENT
from rolamento.report.page import Lines, Page, one_line, rendered, short_number, table
from rolamento.report.plain_data import json_text
from rolamento.report.synthesis_words import SYNTHESIS_WORDS, SynthesisWords
from rolamento.units import rpm_of
from rolamento.vibration.synthesis import Fault, GivenSpeed, SwingingSpeed, WanderingSpeed

if TYPE_CHECKING:
    from rolamento.tasks.synthesis import PlantedFault, PlantedLine, SynthesisResult

SCHEMA: Final = 1

_MOST_IMPACTS: Final = 1_000_000
"""In a file of truth."""
_MM: Final = 1e3
_NANO: Final = 1e9
_MOST_LINES: Final = 15
_MOST_MODES: Final = 5
_STANDARD_INPUT: Final = "-"


def synthesis_report(
    found: SynthesisResult, words: Words = ENGLISH, medium: Medium | None = None
) -> str:
    """Return the page of a synthetic signal as text that ends in a newline.

    Parameters
    ----------
    found
        What the command made.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    page = Page(words, medium or Medium())
    said = SYNTHESIS_WORDS[words.code]
    parts = [_statement(page, said, found), _facts(page, said, found)]
    if found.faults:
        parts.append(_planted(page, said, found))
    if found.lines:
        parts.append(_lines(page, said, found))
    parts += [_notes(page, said, found), _next(page, said, found)]
    return rendered(page.medium, [part for part in parts if part])


def _statement(page: Page, said: SynthesisWords, found: SynthesisResult) -> Lines:
    what = said.sound
    if found.faults:
        what = said.damaged.format(faults=_together(said, [one.fault for one in found.faults]))
    text = said.written.format(
        path=one_line(found.path), duration=page.digits.short(found.recipe.duration, 6), what=what
    )
    return page.hanging(Text(), text, "bold")


def _together(said: SynthesisWords, faults: list[Fault]) -> str:
    """Name the damaged parts, each once."""
    names = list(dict.fromkeys(said.the_faults[fault.kind] for fault in faults))
    if len(names) == 1:
        return names[0]
    return said.all_of.format(list=", ".join(names[:-1]), last=names[-1])


def _facts(page: Page, said: SynthesisWords, found: SynthesisResult) -> Lines:
    damage = 2 if found.faults else 0  # load and resonances are of impacts alone
    entries = [
        (said.bearing, _bearing(page, found)),
        (said.shaft, _shaft(page, said, found)),
        (said.signal, _signal(page, said, found)),
        *((said.load, _load(page, said, found)), (said.modes, _modes(page, said, found)))[:damage],
        (said.noise, _noise(page, said, found)),
        (said.seed, str(found.recipe.seed)),
        (said.files, _files(said, found)),
    ]
    width = max(len(label) for label, _ in entries)
    lines = [page.rule(page.medium.width)]
    for label, content in entries:
        lines += page.hanging(page.text(f"{label:{width}}  ", "dim"), content)
    return lines


def _bearing(page: Page, found: SynthesisResult) -> str:
    digits, bearing, said = page.digits, found.bearing, FREQUENCY_WORDS[page.words.code]
    inside = said.inside.format(
        count=bearing.ball_count,
        ball=digits.short(_MM * bearing.ball_diameter),
        pitch=digits.short(_MM * bearing.pitch_diameter, 6),
    )
    angle = degrees(found.recipe.frequencies.inner_contact_angle)
    return f"{one_line(found.name)}: {inside}; {said.angle.format(angle=digits.short(angle, 4))}"


def _shaft(page: Page, said: SynthesisWords, found: SynthesisResult) -> str:
    digits, own, profile = page.digits, found.recipe.frequencies, found.recipe.speed
    parts = [
        said.speeds[own.shaft].format(
            speed=digits.short(rpm_of(own.inner_speed), 6),
            frequency=digits.short(own.shaft_frequency),
        )
    ]
    if own.outer_speed != 0.0:
        parts.append(said.outer_speed.format(speed=digits.short(rpm_of(own.outer_speed), 6)))
    if own.slip != 0.0:
        parts.append(said.slip.format(slip=digits.short(100.0 * own.slip, 3)))
    if isinstance(profile, SwingingSpeed):
        depth, frequency = digits.short(100.0 * profile.depth, 3), profile.frequency
        parts.append(said.swinging.format(depth=depth, frequency=digits.short(frequency, 4)))
    elif isinstance(profile, WanderingSpeed):
        deviation = digits.short(100.0 * profile.deviation, 3)
        memory = digits.short(profile.memory, 4)
        parts.append(said.wandering.format(deviation=deviation, memory=memory))
    else:
        parts.append(said.steady)
    return "; ".join(parts)


def _signal(page: Page, said: SynthesisWords, found: SynthesisResult) -> str:
    return said.samples.format(
        count=page.digits.fixed(len(found.made.signal.samples), 0),
        rate=page.digits.short(found.recipe.rate, 8),
        rms=short_number(page, found.rms),
    )


def _load(page: Page, said: SynthesisWords, found: SynthesisResult) -> str:
    text = said.loads[found.load].format(extent=page.digits.short(found.extent, 4))
    turns = found.recipe.load_turns
    if turns != 0.0:
        text += "; " + said.load_turns.format(turns=page.digits.short(turns, 4))
    return text


def _modes(page: Page, said: SynthesisWords, found: SynthesisResult) -> str:
    modes = found.recipe.modes
    texts = [
        said.mode.format(
            frequency=page.digits.short(mode.frequency, 6), damping=page.digits.short(mode.damping)
        )
        for mode in modes[:_MOST_MODES]
    ]
    return ", ".join(texts) + (" …" if len(modes) > _MOST_MODES else "")


def _noise(page: Page, said: SynthesisWords, found: SynthesisResult) -> str:
    noise, level = found.recipe.noise, found.made.truth.noise_level
    if noise is None or level == 0.0:
        return said.noises["none"]
    parts = [said.noises[noise.colour], said.level.format(level=short_number(page, level))]
    if noise.ratio is not None:
        parts.append(said.ratios[noise.of].format(ratio=page.digits.short(noise.ratio, 4)))
    return ", ".join(parts)


def _files(said: SynthesisWords, found: SynthesisResult) -> str:
    ending = os.path.splitext(found.path)[1].lower()
    lines = [f"{one_line(found.path)} ({said.holds[ending]})"]
    if found.truth_path is not None:
        lines.append(f"{one_line(found.truth_path)} ({said.truth})")
    return "\n".join(lines)


def _planted(page: Page, said: SynthesisWords, found: SynthesisResult) -> Lines:
    noisy = found.made.truth.noise_level > 0.0
    keep = [i for i in range(len(said.heads)) if noisy or i != 5]
    rows = [[_fault_cells(page, said, one)[i] for i in keep] for one in found.faults]
    return [
        page.heading(said.planted),
        *table(page, [said.heads[i] for i in keep], rows),
        *page.hanging(Text("  "), said.legend if noisy else said.legend_no_noise, "dim"),
    ]


def _fault_cells(page: Page, said: SynthesisWords, one: PlantedFault) -> list[str]:
    digits, truth = page.digits, one.truth
    return [
        said.faults[truth.kind],
        digits.fixed(truth.order, 4),
        digits.fixed(truth.frequency, 2),
        digits.fixed(one.impacts, 0) if one.fault.modulation == "amplitude" else ABSENT,
        short_number(page, truth.rms),
        digits.fixed(one.to_noise, 2),
        digits.short(100.0 * one.fault.jitter, 3),
    ]


def _lines(page: Page, said: SynthesisWords, found: SynthesisResult) -> Lines:
    """Show the strongest lines of waviness and shaft, of those that the rate holds."""
    held = [line for line in found.lines if line.frequency < 0.5 * found.recipe.rate]
    lines = [page.heading(said.lines)]
    if held:
        rows = [_line_cells(page, said, line) for line in held[:_MOST_LINES]]
        lines += table(page, said.line_heads, rows)
    for template, count in (
        (said.more, len(held) - _MOST_LINES),
        (said.too_high, len(found.lines) - len(held)),
    ):
        if count > 0:
            lines += page.hanging(Text("  "), template.format(count=count), "dim")
    return lines


def _line_cells(page: Page, said: SynthesisWords, line: PlantedLine) -> list[str]:
    digits = page.digits
    return [
        said.shaft_line if line.source == "shaft" else said.surfaces[line.source],
        ABSENT if line.source == "shaft" else str(line.waves),
        digits.fixed(line.order, 4),
        digits.fixed(line.frequency, 2),
        short_number(page, _NANO * line.amplitude, 3),
        short_number(page, line.rms, 3),
    ]


def _notes(page: Page, said: SynthesisWords, found: SynthesisResult) -> Lines:
    sentences = []
    unstruck = [one.fault for one in found.faults if not one.impacts]
    if unstruck:
        sentences.append(said.note["unstruck"].format(faults=_together(said, unstruck)))
    if any(one.fault.modulation == "frequency" for one in found.faults):
        sentences.append(said.note["frequency"])
    if "inferred" in found.bearing.origins.values():
        sentences.append(said.note["inferred_inside"])
    if not sentences:
        return []
    lines = [page.heading(said.notes)]
    for sentence in sentences:
        lines += page.hanging(page.text("  • ", "yellow"), sentence)
    return lines


def _next(page: Page, said: SynthesisWords, found: SynthesisResult) -> Lines:
    """Give the command that looks for what was planted, in one line to be copied."""
    if found.source == _STANDARD_INPUT:
        return []
    return [page.heading(said.next), page.text(f"  {found.command}")]


def truth_json(found: SynthesisResult) -> str:
    """Return the truth and the recipe as one JSON object, in SI units, Hz and dB.

    Raises
    ------
    InputError
        If it would be very long.
    """
    recipe, truth = found.recipe, found.made.truth
    if sum(len(one.times) for one in truth.faults) > _MOST_IMPACTS:
        rule = f"would hold more than {_MOST_IMPACTS} impacts"
        raise InputError(rule, field="truth", value=found.truth_path)
    return json_text(
        {
            "schema": SCHEMA,
            "kind": "synthesis",
            "bearing": found.name,
            "file": found.path,
            "unit": found.made.signal.unit,
            "rms": found.rms,
            **truth.to_mapping(),
            "faults": [
                {**one.truth.to_mapping(), "to_noise": one.to_noise} for one in found.faults
            ],
            "recipe": {
                "faults": [asdict(fault) for fault in recipe.faults],
                "load": {"kind": found.load, "extent": found.extent},
                "load_turns": recipe.load_turns,
                "path": asdict(recipe.path),
                "modes": [asdict(mode) for mode in recipe.modes],
                "shaft_harmonics": list(recipe.shaft_harmonics),
                "waviness": [asdict(one) for one in recipe.waviness],
                "noise": None if recipe.noise is None else asdict(recipe.noise),
                "speed": _speed_profile(found),
            },
        }
    )


def _speed_profile(found: SynthesisResult) -> dict[str, Any]:
    profile = found.recipe.speed
    if profile is None or isinstance(profile, GivenSpeed):
        return {"kind": "SteadySpeed", "speed": float(np.mean(found.made.truth.speed))}
    return {"kind": type(profile).__name__, **asdict(profile)}
