"""The page of `synthesise`: what was planted, and where it was written."""

from __future__ import annotations

import os
from collections.abc import Iterable
from math import isfinite
from typing import TYPE_CHECKING, Final

from rolamento import document as doc
from rolamento import plots
from rolamento.pages.frequencies import balls_of, contact_angle
from rolamento.vibration.synthesis import Fault, SwingingSpeed, WanderingSpeed
from rolamento.words import counted, manner, marked, said, said_in
from rolamento.words.naming import PARTS, listed, one_line, part_name, the_part

if TYPE_CHECKING:
    from rolamento.tasks.synthesis import PlantedFault, PlantedLine, SynthesisResult

__all__ = ["synthesis_page"]

_SMALLEST, _GREATEST = 1e-6, 1e9
"""Beyond these a number is written by its order of magnitude."""
_MOST_LINES: Final = 15
_MOST_MODES: Final = 5
_STANDARD_INPUT: Final = "-"
_SURFACES: Final = {
    "outer": PARTS["outer_race"],
    "inner": PARTS["inner_race"],
    "shaft": marked("shaft"),
}
_NOISES: Final = {"white": marked("white"), "pink": marked("pink")}
_HOLDS: Final = {
    ".wav": marked("32-bit floats in m/s²; sampling rate"),
    ".csv": marked("nine digits; sampling rate, unit, mean speed"),
    ".npz": marked("samples to the last bit; sampling rate, mean speed"),
}


def synthesis_page(found: SynthesisResult) -> doc.Document:
    """Return the page of a synthetic signal."""
    sections = [
        doc.Section("", (doc.Statement(_written(found), "strong"),), "verdict"),
        _facts(found),
    ]
    if found.faults:
        sections.append(_planted(found))
    if found.lines:
        sections.append(_lines(found))
    remarks = tuple(doc.Remark(note.text, note.key) for note in found.notes)
    if remarks:
        sections.append(doc.Section(said("Notes"), (doc.Notes(remarks),), "notes"))
    if found.source != _STANDARD_INPUT:
        command = doc.Statement(found.command, indent=2, verbatim=True)
        sections.append(doc.Section(said("To look for it:"), (command,), "next"))
    sections.append(doc.Section("", tuple(_figures(found)), "figures"))
    return doc.Document(one_line(found.name), tuple(sections), kind="synthesise")


def _written(found: SynthesisResult) -> str:
    given = {"path": one_line(found.path), "duration": found.recipe.duration}
    if not found.faults:
        return said("Written: {path}, {duration:.6 s} of a healthy bearing.", **given)
    return said(
        "Written: {path}, {duration:.6 s} of a bearing with damage to {parts}.",
        parts=_together((one.fault for one in found.faults), found.recipe.frequencies.element),
        **given,
    )


def _together(faults: Iterable[Fault], element: str) -> str:
    """Name the damaged parts, each once."""
    return listed(dict.fromkeys(the_part(fault.kind, element) for fault in faults))


# --- what the signal is made of ----------------------------------------------------------------


def _facts(found: SynthesisResult) -> doc.Section:
    own = found.recipe.frequencies
    balls, angle = balls_of(found.bearing, own), contact_angle(own)
    of_impacts = (
        doc.Entry(said("load"), _load(found)),
        doc.Entry(said("resonances"), _modes(found)),
    )
    entries = (
        doc.Entry(said("bearing"), f"{one_line(found.name)}: {balls}; {angle}"),
        doc.Entry(said("shaft"), "; ".join(_shaft(found))),
        doc.Entry(said("signal"), _signal(found)),
        *(of_impacts if found.faults else ()),
        doc.Entry(said("noise"), _noise(found)),
        doc.Entry(said("seed"), str(found.recipe.seed)),
        doc.Entry(said("files"), "\n".join(_files(found))),
    )
    return doc.Section("", (doc.Title(said("Synthetic signal")), doc.KeyValues(entries)), "given")


def _shaft(found: SynthesisResult) -> Iterable[str]:
    own, profile = found.recipe.frequencies, found.recipe.speed
    if own.shaft == "inner":
        yield said(
            "{speed:.6 rpm} ({frequency:.5 Hz})",
            speed=own.inner_speed,
            frequency=own.shaft_frequency,
        )
    else:
        yield said("inner ring {speed:.6 rpm}", speed=own.inner_speed)
    if own.outer_speed != 0.0:
        yield said("outer ring {speed:.6 rpm}", speed=own.outer_speed)
    if own.slip != 0.0:
        yield said("the cage lags by {slip:.3 %}", slip=own.slip)
    if isinstance(profile, SwingingSpeed):
        yield said(
            "oscillating by {depth:.3 %} at {frequency:.4 Hz}",
            depth=profile.depth,
            frequency=profile.frequency,
        )
    elif isinstance(profile, WanderingSpeed):
        yield said(
            "wandering by {deviation:.3 %} (standard deviation), memory {memory:.4 s}",
            deviation=profile.deviation,
            memory=profile.memory,
        )
    else:
        yield said("constant")


def _signal(found: SynthesisResult) -> str:
    return said(
        "acceleration, {count} samples at {rate:.8 Hz}; RMS {rms} m/s²",
        count=len(found.made.signal.samples),
        rate=found.recipe.rate,
        rms=_written_number(found.rms),
    )


def _load(found: SynthesisResult) -> str:
    if found.load == "radial":
        text = said("radial, load zone ε {extent:.4}", extent=found.extent)
    elif found.load == "solved":
        text = said("of the solved case")
    else:
        text = said("uniform around the circumference")
    turns = found.recipe.load_turns
    if turns == 0.0:
        return text
    turning = said("turning at {turns:.4} times the shaft speed", turns=turns)
    return f"{text}; {turning}"


def _modes(found: SynthesisResult) -> str:
    modes = found.recipe.modes
    texts = [
        said(
            "{frequency:.6 Hz} (damping {damping:.5})",
            frequency=mode.frequency,
            damping=mode.damping,
        )
        for mode in modes[:_MOST_MODES]
    ]
    return ", ".join(texts) + (" …" if len(modes) > _MOST_MODES else "")


def _noise(found: SynthesisResult) -> str:
    noise, level = found.recipe.noise, found.made.truth.noise_level
    if noise is None or level == 0.0:
        return said_in("noise", "none")
    colour = said(_NOISES[noise.colour])
    values = {"colour": colour, "level": _written_number(level), "ratio": noise.ratio}
    if noise.ratio is None:
        return said("{colour}, RMS {level} m/s²", **values)
    if noise.of == "faults":
        return said("{colour}, RMS {level} m/s², faults to noise {ratio:.4 dB}", **values)
    return said("{colour}, RMS {level} m/s², signal to noise {ratio:.4 dB}", **values)


def _files(found: SynthesisResult) -> Iterable[str]:
    ending = os.path.splitext(found.path)[1].lower()
    yield f"{one_line(found.path)} ({said(_HOLDS[ending])})"
    if found.truth_path is not None:
        contents = said("every impact, and all that is known")
        yield f"{one_line(found.truth_path)} ({contents})"


# --- what was planted ----------------------------------------------------------------------------


def _planted(found: SynthesisResult) -> doc.Section:
    faults, noisy = found.faults, found.made.truth.noise_level > 0.0
    element = found.recipe.frequencies.element
    to_noise = doc.Column(
        said("to noise"), [one.to_noise for one in faults], "to_noise", "dB", form=".2f [dB]"
    )
    columns = (
        doc.Column("", [part_name(one.truth.kind, element) for one in faults], "part"),
        doc.Column(said("order"), [one.truth.order for one in faults], "order", form=".4f"),
        doc.Column(
            said("frequency"),
            [one.truth.frequency for one in faults],
            "frequency",
            "Hz",
            form=".2f [Hz]",
        ),
        doc.Column(said("impacts"), [_impacts(one) for one in faults], "impacts"),
        doc.Column("RMS", [_number(one.truth.rms, "m/s²") for one in faults], "rms", "m/s²"),
        *((to_noise,) if noisy else ()),
        doc.Column(
            said("jitter"), [one.fault.jitter for one in faults], "jitter", "%", form=".3 [%]"
        ),
    )
    legend = said(
        "Order: of the shaft. Impacts: with non-zero force. RMS: of what the fault alone produces."
        " Jitter: standard deviation of the intervals."
    )
    if noisy:
        legend = said(
            "Order: of the shaft. Impacts: with non-zero force. RMS: of what the fault alone"
            " produces. To noise: its power over that of the noise. Jitter: standard deviation of"
            " the intervals."
        )
    table = doc.Table(columns, "planted", legends=(legend,))
    return doc.Section(said("Planted"), (table,), "planted")


def _impacts(one: PlantedFault) -> float | int:
    return one.impacts if one.fault.modulation == "amplitude" else float("nan")


def _lines(found: SynthesisResult) -> doc.Section:
    """Show the strongest peaks of waviness and shaft, of those that the rate holds."""
    held = [line for line in found.lines if line.frequency < 0.5 * found.recipe.rate]
    element = found.recipe.frequencies.element
    blocks: list[doc.Block] = [_line_table(held[:_MOST_LINES], element)] if held else []
    blocks += [doc.Statement(text, "faint", indent=2) for text in _left_out(found, len(held))]
    return doc.Section(said("Peaks"), tuple(blocks), "lines")


def _left_out(found: SynthesisResult, held: int) -> Iterable[str]:
    if held > _MOST_LINES:
        yield counted(
            "{n} weaker peak is left out here.",
            "{n} weaker peaks are left out here.",
            held - _MOST_LINES,
        )
    beyond = len(found.lines) - held
    if beyond > 0:
        yield counted(
            "{n} peak beyond half the sampling rate is not in the signal.",
            "{n} peaks beyond half the sampling rate are not in the signal.",
            beyond,
        )


def _line_table(lines: list[PlantedLine], element: str) -> doc.Table:
    waves = [float("nan") if line.source == "shaft" else line.waves for line in lines]
    columns = (
        doc.Column(
            "",
            [
                part_name("ball", element)
                if line.source == "ball"
                else said(_SURFACES[line.source])
                for line in lines
            ],
            "source",
        ),
        doc.Column(said("waves"), waves, "waves"),
        doc.Column(said("order"), [line.order for line in lines], "order", form=".4f"),
        doc.Column(
            said("frequency"),
            [line.frequency for line in lines],
            "frequency",
            "Hz",
            form=".2f [Hz]",
        ),
        doc.Column(
            said("amplitude"),
            [_number(line.amplitude, "nm", 3) for line in lines],
            "amplitude",
            "nm",
        ),
        doc.Column("RMS", [_number(line.rms, "m/s²", 3) for line in lines], "rms", "m/s²"),
    )
    return doc.Table(columns, "lines")


def _number(value: float, unit: str, figures: int = 4) -> doc.Number:
    """Return a number to so many figures; by its order of magnitude if it is far out."""
    shown = 1e9 * value if unit == "nm" else value
    far = isfinite(shown) and shown != 0.0 and not _SMALLEST <= abs(shown) < _GREATEST
    return doc.Number(value, f".1e [{unit}]" if far else f".{figures} [{unit}]")


def _written_number(value: float) -> str:
    return manner().number(value, _number(value, "").form)


def _figures(found: SynthesisResult) -> Iterable[doc.Figure]:
    yield doc.Figure(
        said("The signal over time"), lambda: plots.waveform_figure(found.made.signal), "waveform"
    )
