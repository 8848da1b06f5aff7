"""The page of `shaft`: bearings, shafts and gears of a machine, and what they reach together."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from math import inf, isfinite
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento import document as doc
from rolamento import plots
from rolamento.analysis import analyse
from rolamento.numerics import FloatArray
from rolamento.pages.frequencies import line_name
from rolamento.pages.given import picture
from rolamento.pages.life import LONGEST_LIFE, hours_text, none_valid
from rolamento.pages.notes import notes_section
from rolamento.pages.shaft import together_sentences
from rolamento.pages.state import state_page
from rolamento.units import HOUR
from rolamento.vibration.frequencies import ABBREVIATIONS
from rolamento.words import ENDLESS, Note, counted, marked, said
from rolamento.words.headlines import parted
from rolamento.words.naming import machine_title
from rolamento.words.quantities import called
from rolamento.words.reasons import reason

if TYPE_CHECKING:
    from rolamento.analysis.machine import MachineAnalysis
    from rolamento.solved.machine import SeatedBearing, SolvedMachine, SolvedShaft
    from rolamento.tasks.machines import MachineCurve
    from rolamento.vibration.machine import MachineFrequency

__all__ = ["PICTURES", "machine_over_page", "machine_page", "machine_picture", "machine_report"]

_MOST_STEPS: Final = 12
"""Steps that a page shows; files have all of them."""


def machine_page(found: MachineAnalysis) -> doc.Document:
    """Return the page of a machine: without a result it says why and what to do.

    Parameters
    ----------
    found
        Of `rolamento.analysis.machine.analyse_machine`.
    """
    solved = found.solved
    title = machine_title(solved.title)
    sections = [
        doc.Section("", (doc.Title(title), _given(solved)), "given"),
        doc.Section(said("Life of all bearings together"), _life(found), "life"),
        *_picture(solved),
        _bearings(found),
        _shafts(solved),
        *_gears(solved),
        *_housed(solved),
        *_frequencies(found),
        *notes_section(_remarks(found)),
    ]
    if not solved.status.converged.any():
        sections = [sections[0], *notes_section(_remarks(found))]
    return doc.Document(title, tuple(sections), kind="machine", main="bearings")


def machine_report(found: MachineAnalysis) -> doc.Document:
    """Return the page of a machine with a chapter for each bearing, in its hardest step.

    Parameters
    ----------
    found
        As of `machine_page`.
    """
    page = machine_page(found)
    sections: list[doc.Section | doc.Beside] = list(page.sections)
    for name, own in found.bearings.items():
        if not own.solved.converged.any():
            continue
        case = found.hardest_step(name)
        alone = own if len(own.solved) == 1 else analyse(own.solved.case_at(case))
        heading = said("Bearing {bearing}", bearing=name)
        if len(own.solved) > 1:
            heading = said("Bearing {bearing}: {step}", bearing=name, step=found.solved.steps[case])
        sections.append(doc.Section(heading, key=f"bearing_{name}", level=1))
        head, *rest = state_page(alone.solved, alone).sections
        if isinstance(head, doc.Section):  # the chapter has a heading already
            head = replace(
                head, blocks=tuple(b for b in head.blocks if not isinstance(b, doc.Title))
            )
        sections += [head, *rest]
    return replace(page, sections=tuple(sections))


# --- the head -------------------------------------------------------------------------------------


def _given(solved: SolvedMachine) -> doc.KeyValues:
    machine = solved.machine
    shafts = [
        said(
            "{name}: {length:.6g mm} long, {speed:.5 rpm}",
            name=shaft.name, length=shaft.length, speed=machine.speed(shaft.name),
        )
        for shaft in machine.shafts
    ]  # fmt: skip
    bearings = [
        said(
            "{name}: {bearing} on {shaft} at {position:.5g mm}{how}",
            name=one.name,
            bearing=one.case.bearing.designation or said("own geometry"),
            shaft=one.shaft,
            position=one.position,
            how=_how(one.located, one.turned),
        )
        for one in machine.bearings
    ]
    entries = [
        doc.Entry(said("shafts"), "\n".join(shafts)),
        doc.Entry(said("bearings"), "\n".join(bearings)),
    ]
    if machine.spectrum:
        steps = counted("{n} step", "{n} steps", len(solved))
        entries.append(doc.Entry(said("spectrum"), steps))
    return doc.KeyValues((*entries, *_status(solved)))


def _how(located: str, turned: bool) -> str:
    parts = []
    if located == "floating":
        parts.append(said("floating"))
    elif located != "both":
        parts.append(said("located against {way} only", way=located))
    if turned:
        parts.append(said("faces {way}", way="−x"))
    return "".join(f", {part}" for part in parts)


def _status(solved: SolvedMachine) -> list[doc.Entry]:
    status = solved.status
    if status.converged.all():
        text = said(
            "✓ converged in {iterations} iterations, residual {residual:.1e}",
            iterations=int(status.iterations.max()),
            residual=float(status.residual.max()),
        )
        return [doc.Entry(said("status"), text, "good")]
    entries = []
    for case in np.flatnonzero(~status.converged)[:_MOST_STEPS].tolist():
        why = f"✗ {reason(str(status.code[case]))}"
        name = solved.steps[case]
        entries.append(doc.Entry(said("status"), f"{name}: {why}" if name else why, "bad-strong"))
        if (advice := solved.advice[case]) is not None:
            entries.append(doc.Entry(said("advice"), advice.text))
    return entries


def _picture(solved: SolvedMachine) -> list[doc.Section]:
    """Draw the machine and how it bends in its hardest step."""
    if not solved.status.converged.any():
        return []
    stresses = [
        max(float(np.nan_to_num(one.stress[case]).max()) for one in solved.shafts.values())
        for case in range(len(solved))
    ]
    step = int(np.argmax(stresses))
    name = solved.steps[step]
    caption = said("Shafts to scale, deflection, bending moment, shear force and stress")

    caption = f"{caption}: {name}" if name else caption
    return [picture(caption, lambda: plots.machine_figure(solved, step=step), "machine", "picture")]


PICTURES: Final = {
    "deflection": marked("Deflection along the shafts"),
    "forces": marked("Forces, moments and stress along the shafts"),
    "bearings": marked("Contact loads in the bearings"),
}
"""What is drawn of a machine besides itself, by key."""


def machine_picture(solved: SolvedMachine, key: str, step: int) -> doc.Figure:
    """Return a picture of a machine.

    Parameters
    ----------
    solved
        From `rolamento.shaft`.
    key
        Of `PICTURES`.
    step
        Of its spectrum, from 0.
    """
    draw = {
        "deflection": lambda: plots.draw_deflection(solved, step=step),
        "forces": lambda: plots.draw_section_forces(solved, step=step),
        "bearings": lambda: plots.draw_bearings_in_place(solved, step=step),
    }[key]
    return doc.Figure("", draw, key, alternative=said(PICTURES[key]))


# --- life -----------------------------------------------------------------------------------------


def _life(found: MachineAnalysis) -> tuple[doc.Block, ...]:
    together = found.together
    sentences: list[tuple[str, doc.Tone]] = []
    names = list(found.lives)
    missing = [name for name, life in found.lives.items() if life is None]
    if not found.converged:
        text = said("Without a result of every step there is no life of the machine.")
        sentences.append((text, "bad-strong"))
    elif together is None:
        text = counted(
            "There is no life of all bearings together: {names} has none.",
            "There is no life of all bearings together: {names} have none.",
            len(missing),
            names=_listed(missing),
        )
        sentences.append((text, "warning"))
    elif not (together.valid or together.below):
        sentences.append((none_valid("element"), "bad-strong"))
    elif np.isnan(together.hours):
        text = said("Nothing turns at one of the bearings: there are no hours.")
        sentences.append((text, "warning"))
    else:
        first = next(life for life in found.lives.values() if life is not None)
        sentences += together_sentences(together, first.reliability, names)
    statements = tuple(doc.Statement(text, tone, indent=2) for text, tone in sentences)
    return (*statements, *_cautions(found))


def _cautions(found: MachineAnalysis) -> tuple[doc.Notes, ...]:
    """What qualifies the headline, with the bearings that it is about."""
    named: dict[Note, list[str]] = {}
    for name, own in found.bearings.items():
        for case in range(len(found.solved)):
            leading = () if own.life is None else own.life.qualifications(case)
            for note in (*leading, *parted(own.solved.notes[case])[0]):
                if name not in named.setdefault(note, []):
                    named[note].append(name)
    remarks = []
    for note, names in _each_once(named):
        text = note.text
        if len(names) < len(found.bearings):
            text = said("{bearing}: {text}", bearing=_listed(names), text=text)
        remarks.append(doc.Remark(text, note.key, "warning"))
    return (doc.Notes(tuple(remarks)),) if remarks else ()


def _listed(names: Sequence[str]) -> str:
    """Names with commas between them, or with semicolons where they have commas of their own."""
    return ("; " if any("," in name for name in names) else ", ").join(names)


def _remarks(found: MachineAnalysis) -> list[Note]:
    """What else the reader should know, of the machine and of its bearings."""
    first: dict[tuple[str, object], Note] = {}
    for note in (note for case in found.solved.notes for note in case):
        first.setdefault((note.key, note.values.get("shaft", note.text)), note)
    notes = list(first.values())
    named: dict[Note, list[str]] = {}
    for name, own in found.bearings.items():
        of_cases = (note for case in own.solved.notes for note in parted(case)[1])
        for note in dict.fromkeys((*own.notes, *of_cases)):
            named.setdefault(note, []).append(name)
    for note, names in _each_once(named):
        text = said("{bearing}: {text}", bearing=_listed(names), text=note.text)
        notes.append(Note("text", {"text": text}))
    return list(dict.fromkeys(notes))


def _each_once(named: dict[Note, list[str]]) -> Iterable[tuple[Note, list[str]]]:
    """Notes of one key, said once for each group of bearings: those of the first case count."""
    seen: set[tuple[str, str]] = set()
    for note, names in named.items():
        fresh = [name for name in names if (note.key, name) not in seen]
        seen |= {(note.key, name) for name in names}
        if fresh:
            yield note, fresh


# --- tables ---------------------------------------------------------------------------------------


def _by_step(
    solved: SolvedMachine,
    parts: Sequence[str],
    key: str,
    legends: Sequence[str],
    columns_of: Callable[[list[tuple[str, int]]], tuple[doc.Column, ...]],
) -> tuple[doc.Table, ...]:
    """A table of parts in every step; of many steps a page shows the first, and files have all.

    columns_of: of parts, each with the number of a step.
    """
    count = len(solved)

    def table(shown: int, key: str, only_in_files: bool) -> doc.Table:
        lines = [(part, case) for case in range(shown) for part in parts]
        columns = columns_of(lines)
        if count > 1:
            names = [solved.steps[case] for _, case in lines]
            columns += (doc.Column("step", names, "step", only_in_files=True),)
        heads = tuple(
            (
                case * len(parts),
                said(
                    "{name}: {share:.4g %} of the time",
                    name=solved.steps[case],
                    share=float(solved.share[case]),
                ),
            )
            for case in range(shown if count > 1 else 0)
        )
        return doc.Table(
            columns, key, legends=tuple(legends), groups=heads, only_in_files=only_in_files
        )

    if count <= _MOST_STEPS:
        return (table(count, key, False),)
    first = table(_MOST_STEPS, "", False)
    more = said(
        "the first {shown} of {count} steps; files have all", shown=_MOST_STEPS, count=count
    )
    return replace(first, legends=(*first.legends, more)), table(count, key, True)


def _bearings(found: MachineAnalysis) -> doc.Section:
    solved = found.solved

    def columns_of(named: list[tuple[str, int]]) -> tuple[doc.Column, ...]:
        return _of_bearings(found, [(solved.bearings[name], case) for name, case in named])

    legends = [
        said("forces and moment of the shaft on the inner ring, F_a toward +x"),
        called("ring_tilt"),
    ]
    if any(isfinite(permissible_tilt(one)) for one in solved.bearings.values()):
        legends.append(said("permissible: what makers permit for such bearings"))
    if len(solved) > 1:
        legends.append(said("life of each step alone"))
    tables = _by_step(solved, list(solved.bearings), "bearings", ["; ".join(legends)], columns_of)
    return doc.Section(said("Bearings"), tables, "bearings")


def _of_bearings(
    found: MachineAnalysis, lines: list[tuple[SeatedBearing, int]]
) -> tuple[doc.Column, ...]:
    """What is known of bearings, each in a step."""
    hours = [_hours(found, one, case) for one, case in lines]
    columns = (
        doc.Column(said("bearing"), [one.name for one, _ in lines], "bearing"),
        doc.Column(
            "F_r",
            doc.finite_cells(float(one.radial_force[c]) for one, c in lines),
            "radial_force",
            "N",
        ),
        doc.Column(
            "F_a", doc.finite_cells(float(one.force[c, 0]) for one, c in lines), "axial_force", "N"
        ),
        doc.Column(
            "M",
            doc.finite_cells(float(np.hypot(*one.force[c, 3:])) for one, c in lines),
            "moment",
            "N·m",
            most=3,
        ),
        doc.Column(
            said("tilt"),
            doc.finite_cells(float(one.tilt[c]) for one, c in lines),
            "tilt",
            "mrad",
            figures=3,
            most=3,
            tones=[_tilt_tone(one, c) for one, c in lines],
        ),
        doc.Column(
            said("permissible"),
            doc.finite_cells(permissible_tilt(one) for one, _ in lines),
            "permissible_tilt",
            "mrad",
            figures=3,
        ),
        doc.Column(
            "p_max",
            doc.finite_cells(_pressure(one, c) for one, c in lines),
            "max_pressure",
            "MPa",
            most=0,
        ),
        doc.Column(
            "S_0",
            doc.finite_cells(_safety(found, one, c) for one, c in lines),
            "static_safety",
            figures=3,
        ),
        doc.Column(
            "κ",
            doc.finite_cells(_kappa(found, one, c) for one, c in lines),
            "viscosity_ratio",
            figures=3,
        ),
        doc.Column(said("life"), hours, "life", "h", form=".3r [h]", align="right"),
        doc.Column(
            said("loss"),
            doc.finite_cells(_power(found, one, c) for one, c in lines),
            "power",
            "W",
            figures=3,
        ),
    )
    return tuple(
        column
        for column in columns
        if any(value is not None for value in column.values) or column.key in ("bearing", "tilt")
    )


def permissible_tilt(one: SeatedBearing) -> float:
    """The misalignment that makers let pass of such a bearing; NaN where no source says; rad."""
    bearing = one.solved.case.bearing
    known = (kind.misalignment_of(bearing.designation) for kind in bearing.row_types)
    return min((tilt for tilt in known if tilt is not None), default=float("nan"))


def _tilt_tone(one: SeatedBearing, case: int) -> doc.Tone:
    return "warning" if float(one.tilt[case]) > permissible_tilt(one) else ""


def _pressure(one: SeatedBearing, case: int) -> float:
    found = [contacts.max_pressure[case] for contacts in one.solved.contacts.values()]
    return float(np.max(found)) if np.isfinite(found).any() else float("nan")


def _safety(found: MachineAnalysis, one: SeatedBearing, case: int) -> float:
    life = found.bearings[one.name].life
    return float("nan") if life is None else float(life.loads.safety[case])


def _kappa(found: MachineAnalysis, one: SeatedBearing, case: int) -> float:
    film = found.bearings[one.name].film
    return float("nan") if film is None else float(film.viscosity_ratio[case])


def _hours(found: MachineAnalysis, one: SeatedBearing, case: int) -> doc.CellContent:
    life = found.bearings[one.name].life
    if life is None:
        return None
    headline = life.headline
    hours = float(headline.hours[case])
    if not (headline.valid[case] or headline.below[case]) or np.isnan(hours):
        return None
    if hours == inf:
        return ENDLESS
    if hours > LONGEST_LIFE and not headline.below[case]:
        return hours_text(hours)
    return doc.Number(hours * HOUR, ".3r [h]", before="<" if headline.below[case] else "")


def _power(found: MachineAnalysis, one: SeatedBearing, case: int) -> float:
    friction = found.bearings[one.name].friction
    return float("nan") if friction is None else float(friction.power[case])


def _shafts(solved: SolvedMachine) -> doc.Section:
    legends = (
        said(
            "greatest values along each shaft, and how far from its left end; nominal equivalent"
            " stress at the surface (von Mises), without notches"
        ),
    )

    def columns_of(named: list[tuple[str, int]]) -> tuple[doc.Column, ...]:
        return _of_shafts([(solved.shafts[name], case) for name, case in named])

    tables = _by_step(solved, list(solved.shafts), "shafts", legends, columns_of)
    return doc.Section(said("Shafts"), (*tables, *_curves(solved)), "shafts")


def _of_shafts(lines: list[tuple[SolvedShaft, int]]) -> tuple[doc.Column, ...]:
    """The greatest values along shafts, each in a step, and where."""

    def peak(values: FloatArray, one: SolvedShaft) -> tuple[float, float]:
        if not np.isfinite(values).any():
            return float("nan"), float("nan")
        place = int(np.nanargmax(values))
        return float(values[place]), float(one.position[place])

    deflections = [peak(one.deflection[c], one) for one, c in lines]
    stresses = [peak(one.stress[c].max(axis=1), one) for one, c in lines]
    moments = [peak(one.bending_moment[c].max(axis=1), one) for one, c in lines]

    def column(head: str, key: str, unit: str, values: list[float], most: int = 2) -> doc.Column:
        return doc.Column(head, doc.finite_cells(values), key, unit, most=most)

    at = said("at")
    return (
        doc.Column(said("shaft"), [one.name for one, _ in lines], "shaft"),
        column(said("deflection"), "deflection", "µm", [v for v, _ in deflections]),
        column(at, "deflection_at", "mm", [x for _, x in deflections], 1),
        column(said("slope"), "slope", "mrad", [float(o.slope[c].max()) for o, c in lines], 3),
        column(said("bending\nmoment"), "bending_moment", "N·m", [v for v, _ in moments]),
        column(at, "bending_moment_at", "mm", [x for _, x in moments], 1),
        column(said("torque"), "torque", "N·m",
               [float(np.abs(o.torque[c]).max()) for o, c in lines]),
        column(said("stress"), "stress", "MPa", [v for v, _ in stresses], 1),
        column(at, "stress_at", "mm", [x for _, x in stresses], 1),
    )  # fmt: skip


def _curves(solved: SolvedMachine) -> tuple[doc.Table, ...]:
    """All nodes of all shafts, for files."""
    steps = range(len(solved))
    lines = [
        (case, one, node)
        for case in steps
        for one in solved.shafts.values()
        for node in range(len(one.position))
    ]

    def column(key: str, unit: str, values: Iterable[float]) -> doc.Column:
        return doc.Column(key, doc.finite_cells(values), key, unit)

    columns = (
        doc.Column("step", [solved.steps[c] or "1" for c, _, _ in lines], "step"),
        doc.Column("shaft", [one.name for _, one, _ in lines], "shaft"),
        column("position", "mm", (float(one.position[n]) for _, one, n in lines)),
        *(
            column(name, unit, (float(one.displacement[c, n, i]) for c, one, n in lines))
            for i, (name, unit) in enumerate(
                (("x", "µm"), ("y", "µm"), ("z", "µm"), ("ry", "mrad"), ("rz", "mrad"))
            )
        ),
        *(
            column(f"{name}_{side}", unit, (float(one.force[c, n, j, i]) for c, one, n in lines))
            for j, side in enumerate(("left", "right"))
            for i, (name, unit) in enumerate(
                (("fx", "N"), ("fy", "N"), ("fz", "N"), ("my", "N·m"), ("mz", "N·m"))
            )
        ),
        column("stress", "MPa", (float(one.stress[c, n].max()) for c, one, n in lines)),
    )
    return (doc.Table(columns, "nodes", only_in_files=True),)


def _gears(solved: SolvedMachine) -> list[doc.Section]:
    machine = solved.machine
    if not machine.gears:
        return []
    names = [gear.name or f"{said('gear')} {i + 1}" for i, gear in enumerate(machine.gears)]
    gears = dict(zip(names, machine.gears, strict=True))

    def column(head: str, key: str, unit: str, values: list[float]) -> doc.Column:
        return doc.Column(head, doc.finite_cells(values), key, unit, figures=3, most=3)

    def columns_of(named: list[tuple[str, int]]) -> tuple[doc.Column, ...]:
        places = [
            solved.shafts[gears[name].shaft].displacement_at(gears[name].position)[case]
            for name, case in named
        ]
        shafts = [gears[name].shaft for name, _ in named]
        return (
            doc.Column(said("gear"), [name for name, _ in named], "gear"),
            doc.Column(said("shaft"), shafts, "shaft"),
            *(
                column(axis, axis, unit, [float(u[i]) for u in places])
                for i, (axis, unit) in enumerate(_AXES)
            ),
        )

    legends = (said("displacement and slope of the shaft at each gear"),)
    tables = _by_step(solved, names, "gears", legends, columns_of)
    return [doc.Section(said("Gears"), tables, "gears")]


_AXES: Final = (("x", "µm"), ("y", "µm"), ("z", "µm"), ("ry", "mrad"), ("rz", "mrad"))


def _housed(solved: SolvedMachine) -> list[doc.Section]:
    """How outer rings move that are not held."""
    moved = [
        one
        for one in solved.bearings.values()
        if one.bearing.outer_shaft is None and np.nan_to_num(one.outer).any()
    ]
    if not moved:
        return []

    def columns_of(named: list[tuple[str, int]]) -> tuple[doc.Column, ...]:
        return (
            doc.Column(said("bearing"), [name for name, _ in named], "bearing"),
            *(
                doc.Column(
                    axis,
                    [float(solved.bearings[name].outer[case, i]) for name, case in named],
                    axis,
                    unit,
                    figures=3,
                    most=3,
                )
                for i, (axis, unit) in enumerate(_AXES)
            ),
        )

    legends = (said("displacement of outer rings in yielding or sliding seats"),)
    names = [one.name for one in moved]
    tables = _by_step(solved, names, "outer_rings", legends, columns_of)
    return [doc.Section(said("Outer rings"), tables, "outer_rings")]


_LINES: Final = {"rotation": marked("rotation"), "mesh": marked("tooth mesh")}


def _named(one: MachineFrequency) -> tuple[str, str]:
    """What a frequency is called, and for short."""
    if one.line == "rotation" or one.line == "mesh":
        return said(_LINES[one.line]), ""
    return line_name(one.line, one.element), ABBREVIATIONS[one.line]


def _frequencies(found: MachineAnalysis) -> list[doc.Section]:
    """What turns, meshes and passes how often, in the hardest step."""
    step = found.hardest_step()
    lines = found.frequencies(step)
    if not lines:
        return []
    columns = (
        doc.Column(said("part"), [one.part for one in lines], "part"),
        doc.Column(said("frequency"), [_named(one)[0] for one in lines], "line"),
        doc.Column("", [_named(one)[1] for one in lines], "abbreviation"),
        doc.Column("Hz", [one.frequency for one in lines], "hertz", form=".2f", align="right"),
        doc.Column(said("order"), [one.order for one in lines], "order", form=".4f", align="right"),
    )
    legends = (said("under load; orders of the rotation of the first shaft that turns"),)
    name = found.solved.steps[step]
    heading = said("Frequencies")
    table = doc.Table(columns, "frequencies", legends=legends)
    return [doc.Section(f"{heading}: {name}" if name else heading, (table,), "frequencies")]


# --- over a field ---------------------------------------------------------------------------------


def machine_over_page(found: MachineCurve) -> doc.Document:
    """Return the page of a machine over one of its fields.

    Parameters
    ----------
    found
        Of a `rolamento.tasks.ShaftRequest`.
    """
    machine = found.first.solved

    def column(head: str, key: str, unit: str, values: FloatArray, most: int = 2) -> doc.Column:
        form = ".3r [h]" if unit == "h" else ""
        return doc.Column(head, doc.finite_cells(values.tolist()), key, unit, most=most, form=form)

    columns = [
        doc.Column(f"{found.key}\n{found.unit}", found.values.tolist(), "value", most=4, figures=5),
        column(said("life"), "hours", "h", HOUR * found.hours),
    ]
    for name in machine.bearings:
        columns += [
            column(f"{name}\nF_r", f"{name}_radial_force", "N",
                   found.of_bearing(name, "radial_force"), 1),
            column(said("tilt"), f"{name}_tilt", "mrad", found.of_bearing(name, "tilt"), 3),
            column("p_max", f"{name}_max_pressure", "MPa",
                   found.of_bearing(name, "max_pressure"), 0),
            column(said("life"), f"{name}_hours", "h", HOUR * found.of_bearing(name, "hours")),
        ]  # fmt: skip
    for name in machine.shafts:
        columns += [
            column(f"{name}\n{said('deflection')}", f"{name}_deflection", "µm",
                   found.of_shaft(name, "deflection")),
            column(said("stress"), f"{name}_stress", "MPa", found.of_shaft(name, "stress"), 1),
        ]  # fmt: skip
    each = 4
    heads = [*machine.bearings, said("Shafts")]
    breaks = tuple(doc.Break(2 + each * index, name) for index, name in enumerate(heads))
    legends = (said("the greatest of all steps; life of all bearings together, and of each"),)
    table = doc.Table(tuple(columns), "over", legends=legends, fixed=2, breaks=breaks)
    title = machine_title(machine.title)
    heading = said("{title} over {field}", title=title, field=found.key)

    figure = doc.Figure(heading, lambda: plots.machine_over_figure(found), "over")
    refused = {text: Note("text", {"text": text}) for text in found.refused if text}
    sections = [
        doc.Section("", (doc.Title(heading),), "given"),
        doc.Section("", (figure, table), "over"),
        *notes_section(refused.values()),
    ]
    return doc.Document(heading, tuple(sections), kind="machine_over", main="over")
