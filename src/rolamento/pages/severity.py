"""The page of `severity`: the zone of a machine's vibration, its alarm, and when it is reached."""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite
from typing import TYPE_CHECKING, Any, Final

from rolamento import document as doc
from rolamento import plots
from rolamento.pages.data import signal_entry
from rolamento.pages.limit import limit_section, limit_statement
from rolamento.pages.notes import about
from rolamento.units import HOUR
from rolamento.words import ABSENT, said
from rolamento.words.naming import listed, one_line
from rolamento.words.sentences.severity import class_name, zone_meaning

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Picture

    from rolamento.tasks.severity import MeasuredSeverity, SeverityResult

__all__ = ["severity_page", "severity_statement", "trend_picture", "zones_picture"]

_TONES: Final[dict[str, doc.Tone]] = {
    "A": "good-strong",
    "B": "good-strong",
    "C": "warning-strong",
    "D": "bad-strong",
}
_LONGEST_NAME: Final = 32


def severity_page(found: SeverityResult) -> doc.Document:
    """Return the page of the severity of one signal or of several.

    Parameters
    ----------
    found
        Of `rolamento.tasks.VibrationSeverity`.
    """
    title = said("Severity of vibration")
    if len(found.measured) == 1:
        title = said("Severity of vibration: {name}", name=one_line(found.measured[0].title))
    leading, notes = about([(one.title, one.notes) for one in found.measured], found.notes)
    sections = [
        doc.Section("", (*_statements(found), *_growth(found), *leading), "verdict"),
        doc.Section("", (doc.Title(title), doc.KeyValues(_facts(found))), "given"),
        _signals(found),
        _classes(found),
    ]
    if found.forecast is not None:
        time = (found.time_unit, found.start)
        growth = _growth(found)
        sections.append(limit_section([("", found.forecast)], "mm/s", *time, leading=growth))
    sections += [*notes, doc.Section("", (_figure(found),), "figures")]
    return doc.Document(title, tuple(sections), kind="severity", main="signals")


def severity_statement(found: SeverityResult) -> str:
    """Return in which zone the vibration is."""
    worst = found.worst
    if worst is None:
        return said("No severity: the sampling rate does not contain the band.")
    values: dict[str, Any] = {"velocity": worst.severity.velocity}
    zone = found.zone
    if zone is None:
        return said(
            "{velocity:.3 mm/s} RMS; the zone depends on the class of the machine, which is not"
            " given (`power` and `support`, or `machine_class`).",
            **values,
        )
    values |= {"zone": zone, "meaning": zone_meaning(zone)}
    if found.machine is None:
        return said(
            "Zone {zone}, {meaning}: {velocity:.3 mm/s} RMS, whichever of these classes the machine"
            " is of.",
            **values,
        )
    by_velocity = found.machine.zone_of(worst.severity.velocity)
    if by_velocity != zone:
        return said(
            "Zone {zone}, {meaning}, by displacement: {displacement:.3 µm} RMS; zone {by_velocity}"
            " by velocity: {velocity:.3 mm/s} RMS ({standard}, {name}).",
            standard=found.machine.standard,
            name=class_name(found.machine.name),
            by_velocity=by_velocity,
            displacement=worst.severity.displacement,
            **values,
        )
    return said(
        "Zone {zone}, {meaning}: {velocity:.3 mm/s} RMS ({standard}, {name}).",
        standard=found.machine.standard,
        name=class_name(found.machine.name),
        **values,
    )


def _statements(found: SeverityResult) -> tuple[doc.Block, ...]:
    tone: doc.Tone = "faint" if found.worst is None else "warning-strong"
    blocks: list[doc.Block] = [
        doc.Statement(severity_statement(found), _TONES[found.zone] if found.zone else tone)
    ]
    worst, machine = found.worst, found.machine
    if worst is not None and machine is not None:
        zones = worst.severity.certain_zones(machine)
        if len(zones) > 1:
            text = said(
                "The record is too short, or the machine too unsteady, to tell the zones {zones}"
                " apart: {lower:.3 [mm/s]} to {upper:.3 mm/s} at {confidence:.3 [%]} % confidence.",
                zones=listed(zones),
                lower=worst.severity.lower,
                upper=worst.severity.upper,
                confidence=worst.severity.confidence,
            )
            blocks.append(doc.Statement(text, "faint"))
    return tuple(blocks)


def _growth(found: SeverityResult) -> tuple[doc.Statement, ...]:
    """What qualifies the zone of the last reading: that the limit is reached, and when."""
    if found.forecast is None or found.forecast.crossing.code not in ("reached", "exceeded"):
        return ()
    return (limit_statement(found.forecast, "", "mm/s", found.time_unit, found.start),)


def _facts(found: SeverityResult) -> tuple[doc.Entry, ...]:
    one = found.measured[0].severity
    speed = said("{speed:.6 rpm}", speed=one.speed) if isfinite(one.speed) else said("not given")
    entries = [
        doc.Entry(said("speed"), speed),
        doc.Entry(
            said("band"), said("{low:.4} to {high:.6 Hz}", low=one.band[0], high=one.band[1])
        ),
    ]
    if len(found.measured) == 1:
        entries.append(signal_entry(one))
    setting = found.setting
    if setting is not None:
        text = (
            said(
                "{alarm:.3 mm/s}: baseline of {baseline:.3 mm/s} and 25 % of the boundary B/C, at"
                " most 1.25 times it",
                alarm=setting.alarm,
                baseline=setting.baseline,
            )
            if isfinite(setting.baseline)
            else said(
                "{alarm:.3 mm/s}: boundary B/C, as no baseline is given (`baseline`)",
                alarm=setting.alarm,
            )
        )
        entries.append(doc.Entry(said("alarm"), text))
        text = said("at most {trip:.3 mm/s}: 1.25 times the boundary C/D", trip=setting.trip)
        entries.append(doc.Entry(said("trip"), text))
    return tuple(entries)


def _signals(found: SeverityResult) -> doc.Section:
    signals = [one.severity for one in found.measured]
    columns = [
        doc.Column(
            said("signal"), [one_line(one.title, _LONGEST_NAME) for one in found.measured], "signal"
        ),
        *_time_columns(found),
        doc.Column("RMS", [one.velocity for one in signals], "velocity", "mm/s", form=".3 [mm/s]"),
        doc.Column(said("from"), [one.lower for one in signals], "lower", "mm/s", form=".3 [mm/s]"),
        doc.Column(said("to"), [one.upper for one in signals], "upper", "mm/s", form=".3 [mm/s]"),
        doc.Column(
            said("displacement"),
            [one.displacement for one in signals],
            "displacement",
            "µm",
            form=".3 [µm]",
        ),
    ]
    if found.machine is not None:
        zones = [found.zone_of(one, found.machine) for one in found.measured]
        columns.append(
            doc.Column(
                said("zone"),
                [zone or ABSENT for zone in zones],
                "zone",
                tones=[_TONES[zone] if zone else "" for zone in zones],
            )
        )
    legend = said(
        "RMS: broadband velocity in the band. From–to: its {confidence:.3 [%]} % interval, by how"
        " the segments of the record differ. Displacement: RMS in the same band.",
        confidence=signals[0].confidence,
    )
    table = doc.Table(tuple(columns), "signals", legends=(legend,))
    return doc.Section(said("Signals"), (table,), "signals")


def _time_columns(found: SeverityResult) -> Iterator[doc.Column]:
    """Dates or running hours, if they are given."""
    if found.start:
        dates = [found.date_of(one) for one in found.measured]
        yield doc.Column(said("date"), dates, "date")
    elif any(isfinite(one.hours) for one in found.measured):
        times = [HOUR * one.hours for one in found.measured]
        yield doc.Column(said("time"), times, "hours", "h", form=".6 [h]")


def _classes(found: SeverityResult) -> doc.Section:
    worst = found.worst
    zones = [None if worst is None else found.zone_of(worst, machine) for machine in found.classes]
    edges = ("A/B", "B/C", "C/D")
    with_displacement = any(machine.displacement for machine in found.classes)
    columns = [
        doc.Column(
            said("standard"), [machine.standard for machine in found.classes], "standard", once=True
        ),
        doc.Column(
            said("class of machines"),
            [class_name(machine.name) for machine in found.classes],
            "class",
        ),
        *(
            doc.Column(
                edge,
                [machine.velocity[place] for machine in found.classes],
                edge,
                "mm/s",
                form=".3 [mm/s]",
            )
            for place, edge in enumerate(edges)
        ),
        *(
            doc.Column(
                edge,
                [_edge(machine.displacement, place) for machine in found.classes],
                f"displacement {edge}",
                "µm",
                form=".3 [µm]",
            )
            for place, edge in enumerate(edges)
            if with_displacement
        ),
        doc.Column(
            said("zone"),
            [zone or ABSENT for zone in zones],
            "zone",
            tones=[_TONES[zone] if zone else "" for zone in zones],
        ),
    ]
    sources = dict.fromkeys(machine.source for machine in found.classes)
    legends = [said("Boundaries: {source}.", source="; ".join(sources))]
    if with_displacement:
        legends.append(
            said(
                "Group 1: above 300 kW; group 2: above 15 and up to 300 kW. A support is rigid if"
                " the lowest natural frequency of machine and support is at least 25 % above the"
                " main excitation. The boundaries of displacement were not checked against a public"
                " copy of the standard."
            )
        )
    table = doc.Table(tuple(columns), "classes", legends=tuple(legends), fixed=2)
    return doc.Section(said("Zones"), (table,), "zones")


def _edge(edges: tuple[float, ...], place: int) -> doc.CellContent:
    return edges[place] if edges else None


def _figure(found: SeverityResult) -> doc.Figure:
    if found.forecast is not None:
        caption = said("Velocity over time, on the zones")
        return doc.Figure(caption, lambda: trend_picture(found), "trend")
    return doc.Figure(said("Measured velocity on the zones"), lambda: zones_picture(found), "zones")


def zones_picture(found: SeverityResult) -> Picture:
    """Draw the velocities on the zones."""
    measured = [(one.title, one.severity) for one in found.measured]
    figure: Picture = plots.severity_figure(measured, found.classes, setting=found.setting)
    return figure


def trend_picture(found: SeverityResult) -> Picture:
    """Draw the velocity over time."""
    assert found.forecast is not None
    series: list[MeasuredSeverity] = [one for one in found.measured if one.severity.measured]
    figure: Picture = plots.severity_trend_figure(
        [one.hours / found.time_scale for one in series],
        [1e3 * one.severity.velocity for one in series],
        found.forecast,
        found.machine,
        start=found.start,
    )
    return figure
