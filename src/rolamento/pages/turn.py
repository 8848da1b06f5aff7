"""The page of `turn`: what varies while the cage turns by one pitch."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite, nan
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento import document as doc
from rolamento import plots
from rolamento.case.duty import AXES, LOADS
from rolamento.numerics import FloatArray
from rolamento.pages.friction import torque_unit
from rolamento.pages.given import title_of
from rolamento.solved import RACES
from rolamento.words import decimals_for, in_unit, said, said_in, worded
from rolamento.words.reasons import reason

if TYPE_CHECKING:
    from rolamento.studies.cage_turn import BallHistory, CageTurn, Variation
    from rolamento.studies.torque_turn import TorqueTurn

__all__ = ["turn_page"]

_SHIFTS: Final = 3
"""x, y, z come before the tilts, forces before moments."""
_HARMONICS: Final = 3
_MEAN_UNITS: Final = ("µm",) * _SHIFTS + ("mrad",) * 2
_VARIED_UNITS: Final = ("nm",) * _SHIFTS + ("µrad",) * 2
_LOAD_UNITS: Final = ("N",) * _SHIFTS + ("N·m",) * 2
_STIFFNESS_UNITS: Final = ("N/µm",) * _SHIFTS + ("N·m/mrad",) * 2


def turn_page(turn: CageTurn, torque: TorqueTurn | None = None) -> doc.Document:
    """Return the page of a turn of the cage.

    Parameters
    ----------
    turn
        Converged or not; what needs every instant is left out if one has no result.
    torque
        Its friction torque, if that is known.
    """
    title = title_of(turn.case)
    sections = [doc.Section("", (doc.Title(title), _head(turn)), "given")]
    if turn.converged:
        sections += [_displacement(turn), _load(turn), _stiffness(turn)]
        sections += [_torque(torque)] if torque is not None else []
        sections += [_ball(history, turn) for history in turn.histories]
    figure = doc.Figure(
        worded(
            turn.elements,
            said("Displacement, stiffness and ball load over one pitch of the cage"),
            said("Displacement, stiffness and roller load over one pitch of the cage"),
        ),
        lambda: plots.cage_turn_figure(turn),
        "turn",
    )
    sections.append(doc.Section("", (figure, _instants(turn)), "instants"))
    return doc.Document(title, tuple(sections), kind="turn", main="instants")


def _head(turn: CageTurn) -> doc.KeyValues:
    over = {"count": len(turn), "period": turn.period}
    points = worded(
        turn.elements,
        said("{count} instants of the first ball over {period:.4 °}", **over),
        said("{count} instants of the first roller over {period:.4 °}", **over),
        said("{count} instants over {period:.4 °}", **over),
    )
    entries = [doc.Entry(said("turn"), points)]
    if turn.converged:
        entries.append(doc.Entry(said("cage"), _cage(turn)))
        status = said("✓ all instants converged")
    else:
        failed = turn.status[turn.status != "converged"]
        status = said(
            "✗ {failed} of {count} instants without a result: {reasons}",
            failed=len(failed),
            count=len(turn),
            reasons=[reason(code) for code in np.unique(failed).tolist()],
        )
    entries.append(doc.Entry(said("status"), status, "good" if turn.converged else "bad-strong"))
    if turn.advice is not None:
        entries.append(doc.Entry(said("advice"), turn.advice.text))
    return doc.KeyValues(tuple(entries))


def _cage(turn: CageTurn) -> str:
    if not isfinite(turn.passage_frequency):
        return said("at rest: no frequency")
    speed = turn.cage_speed
    values = {
        "mean": speed.mean,
        "least": speed.minimum,
        "greatest": speed.maximum,
        "frequency": turn.passage_frequency,
    }
    return worded(
        turn.elements,
        said(
            "{mean:.5 rpm}, mean of the loaded balls ({least:.5 [rpm]} to {greatest:.5 [rpm]})\n"
            "balls pass under the load at {frequency:.5 Hz}",
            **values,
        ),
        said("{mean:.5 rpm}\nrollers pass under the load at {frequency:.5 Hz}", **values),
        said(
            "{mean:.5 rpm}, mean of the loaded balls and rollers ({least:.5 [rpm]} to"
            " {greatest:.5 [rpm]})\nall stand as before at {frequency:.5 Hz}",
            **values,
        ),
    )


# --- the ring ----------------------------------------------------------------------------------


def _displacement(turn: CageTurn) -> doc.Section:
    variation = turn.variation("displacement")
    blocks: list[doc.Block] = [
        _variation_table(AXES, variation, _MEAN_UNITS, _VARIED_UNITS, key="displacement")
    ]
    if not variation.peak_to_peak.any():
        text = worded(
            turn.elements,
            said("no variation: the ring does not move while the balls pass"),
            said("no variation: the ring does not move while the rollers pass"),
        )
        blocks.append(doc.Statement(text, "faint", indent=2))
    heading = said("Displacement of the inner ring")
    return doc.Section(heading, tuple(blocks), "displacement")


def _torque(found: TorqueTurn) -> doc.Section:
    """Show how the friction torque varies, as far as an ideal bearing's does."""
    unit = torque_unit([found.mean])
    amplitudes = np.abs(found.harmonics[:_HARMONICS])
    rows = [
        (said("mean"), found.mean),
        (said("peak to peak"), found.peak_to_peak),
        *(
            (said("harm. {order}", order=order), float(value))
            for order, value in enumerate(amplitudes, start=1)
        ),
    ]
    shares = [value / found.mean if found.mean else nan for _, value in rows]
    values = [doc.Number(value, f".3 [{unit}]") for _, value in rows]
    columns = (
        doc.Column("", [label for label, _ in rows], "quantity"),
        doc.Column("", values, "value", align="right"),
        doc.Column("", [unit] * len(rows), "unit"),
        doc.Column("", [doc.Number(share, ".3 %") for share in shares], "share"),
    )
    legend = said("of an ideal bearing; unlike elements, waviness and the cage add more")
    table = doc.Table(columns, "torque", headless=True, legends=(legend,))
    return doc.Section(said("Friction torque"), (table,), "torque")


def _load(turn: CageTurn) -> doc.Section:
    table = _variation_table(LOADS, turn.variation("load"), _LOAD_UNITS, _LOAD_UNITS, key="load")
    return doc.Section(said("Load on the inner ring"), (table,), "load")


def _variation_table(
    names: Sequence[str],
    variation: Variation,
    mean_units: Sequence[str],
    units: Sequence[str],
    key: str,
) -> doc.Table:
    """Show mean, peak to peak and the first harmonics of the five degrees of freedom."""
    amplitudes = np.abs(variation.harmonics[:_HARMONICS])
    columns = [
        doc.Column("", names, "direction"),
        doc.Column(said("mean"), _alike(variation.mean, mean_units, 5, 3, zero=False), "mean"),
        doc.Column("", mean_units, "mean_unit"),
        doc.Column(
            said("peak to peak"),
            _alike(variation.peak_to_peak, units, 4, 4),
            "peak_to_peak",
            tone="strong",
        ),
        *(
            doc.Column(
                said("harm. {order}", order=order), _alike(values, units, 4, 4), f"harmonic_{order}"
            )
            for order, values in enumerate(amplitudes, start=1)
        ),
        doc.Column("", units, "unit"),
    ]
    return doc.Table(tuple(columns), key)


def _alike(
    values: FloatArray, units: Sequence[str], figures: int, most: int, *, zero: bool = True
) -> list[doc.CellContent]:
    """Write shifts, and tilts, each with the decimals of the greatest; zero: nothing as 0."""
    cells: list[doc.CellContent] = []
    for part in (slice(None, _SHIFTS), slice(_SHIFTS, None)):
        pairs = list(zip(values[part].tolist(), units[part], strict=True))
        decimals = decimals_for([float(in_unit(v, u)) for v, u in pairs], figures, most)
        cells += [
            doc.Number(value, f".{decimals if value or not zero else 0}f [{unit}]")
            for value, unit in pairs
        ]
    return cells


def _stiffness(turn: CageTurn) -> doc.Section:
    variation = turn.variation("stiffness")
    means, extents = np.diagonal(variation.mean), np.diagonal(variation.peak_to_peak)
    shares = [float(e / abs(m)) if m else nan for e, m in zip(extents, means, strict=True)]
    columns = (
        doc.Column(
            "", [f"{load} {axis}" for load, axis in zip(LOADS, AXES, strict=True)], "direction"
        ),
        doc.Column(said("mean"), _short(means, 5), "mean"),
        doc.Column(said("peak to peak"), _short(extents, 4), "peak_to_peak", tone="strong"),
        doc.Column("", _STIFFNESS_UNITS, "unit"),
        doc.Column(said("of mean"), [doc.Number(share, ".3 %") for share in shares], "share"),
    )
    return doc.Section(said("Stiffness"), (doc.Table(columns, "stiffness"),), "stiffness")


def _short(values: FloatArray, figures: int) -> list[doc.CellContent]:
    pairs = zip(values.tolist(), _STIFFNESS_UNITS, strict=True)
    return [doc.Number(value, f".{figures} [{unit}]") for value, unit in pairs]


# --- one ball ----------------------------------------------------------------------------------


def _ball(history: BallHistory, turn: CageTurn) -> doc.Section:
    """Show where one ball of a row carries most and least."""
    races = {"inner": history.inner, "outer": history.outer}
    shown = (
        (said("maximum load"), "N"),
        ("  " + said_in("azimuth", "at"), "°"),
        ("  " + said("pressure there"), "MPa"),
        ("  " + said("contact angle there"), "°"),
        (said("minimum load"), "N"),
        (said("loaded over"), "°"),
    )
    columns = [doc.Column("", [label for label, _ in shown], "quantity")]
    heads = {"inner": said_in("race", "inner"), "outer": said_in("race", "outer")}
    for race in RACES:
        contact = races[race]
        most = contact.heaviest
        values = (
            contact.load[most],
            history.azimuth[most],
            contact.max_pressure[most],
            contact.contact_angle[most],
            contact.load.min(),
            2.0 * np.pi * np.mean(contact.load > 0.0),
        )
        cells = [
            doc.Number(float(value), f".5 [{unit}]")
            for value, (_, unit) in zip(values, shown, strict=True)
        ]
        columns.append(doc.Column(heads[race], cells, race, align="right"))
    columns.append(doc.Column("", [unit for _, unit in shown], "unit"))
    element = (turn.elements[history.row],)
    heading = worded(element, said("One ball over its orbit"), said("One roller over its orbit"))
    if len(turn.histories) > 1:
        heading = worded(
            element,
            said("One ball of row {number} over its orbit", number=history.row),
            said("One roller of row {number} over its orbit", number=history.row),
        )
    key = f"ball_{history.row}"
    return doc.Section(heading, (doc.Table(tuple(columns), key),), key)


# --- the instants ------------------------------------------------------------------------------


def _instants(turn: CageTurn) -> doc.Table:
    """Return a line for every instant; for files."""
    solved = turn.solved
    columns = [
        doc.Column("ψ", turn.angle.tolist(), "angle", "°"),
        doc.Column("t", turn.time.tolist(), "time", "ms"),
        doc.Column(said("status"), turn.status.tolist(), "status"),
    ]
    for names, units, values in (
        (AXES, _MEAN_UNITS, solved.displacement.array),
        (LOADS, _LOAD_UNITS, solved.load.array),
    ):
        columns += [
            doc.Column(name, values[:, place].tolist(), name, unit)
            for place, (name, unit) in enumerate(zip(names, units, strict=True))
        ]
    columns += [
        doc.Column(
            f"{load} {axis}",
            solved.stiffness.array[:, row, column].tolist(),
            f"stiffness_{load}_{axis}",
            _stiffness_unit(row, column),
        )
        for row, load in enumerate(LOADS)
        for column, axis in enumerate(AXES)
    ]
    columns += [
        doc.Column(
            f"Q_{race[0]},{ball}",
            solved.contacts[race].load[:, ball].tolist(),
            f"ball_{ball}_{race}_load",
            "N",
        )
        for race in RACES
        for ball in range(solved.inner.load.shape[1])
    ]
    return doc.Table(tuple(columns), "instants", only_in_files=True)


def _stiffness_unit(row: int, column: int) -> str:
    force = "N/µm" if column < _SHIFTS else "N/mrad"
    moment = "N·m/mm" if column < _SHIFTS else "N·m/mrad"
    return force if row < _SHIFTS else moment
