"""A turn of the cage for a reader: a page for a terminal, a table for spreadsheets, JSON."""

from __future__ import annotations

import csv
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from io import StringIO
from math import degrees, isfinite, pi
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from rich.text import Text

from rolamento._json import dumps
from rolamento.case.duty import AXES, LOADS
from rolamento.document.medium import Medium
from rolamento.report.language import ENGLISH, Words
from rolamento.report.page import Lines, Page, rendered
from rolamento.report.plain_data import csv_number
from rolamento.studies.cage_turn import BallHistory, CageTurn, Compared, ContactHistory, Variation

SCHEMA: Final = 1
_RPM: Final = 30.0 / pi
_SHIFTS: Final = 3
_HARMONICS: Final = 3


@dataclass(frozen=True, slots=True)
class _Words:
    turn: str
    points: str
    all_converged: str
    some_failed: str
    cage: str
    spread: str
    passage: str
    at_rest: str
    displacement: str
    load: str
    stiffness: str
    mean: str
    extent: str
    harmonic: str
    relative: str
    no_variation: str
    one_ball: str
    maximum_load: str
    minimum_load: str
    loaded_over: str
    at: str
    contact_angle: str
    pressure: str
    row: str


_WORDS: Final[Mapping[str, _Words]] = {
    "en": _Words(
        turn="turn",
        points="{count} instants of the first ball over {period}°",
        all_converged="every instant converged",
        some_failed="{failed} of {count} instants without a result: {reasons}",
        cage="cage",
        spread="{mean} rpm, the mean of the loaded balls ({least} to {greatest})",
        passage="balls pass under the load at {frequency} Hz",
        at_rest="at rest: no frequency",
        displacement="Displacement of the inner ring",
        load="Load on the inner ring",
        stiffness="Stiffness",
        mean="mean",
        extent="peak to peak",
        harmonic="harm. {order}",
        relative="of mean",
        no_variation="no variation: the ring stands still while the balls pass",
        one_ball="One ball on its way round",
        maximum_load="maximum load",
        minimum_load="minimum load",
        loaded_over="loaded over",
        at="at",
        contact_angle="contact angle there",
        pressure="pressure there",
        row="row {number}",
    ),
    "pt": _Words(
        turn="volta",
        points="{count} instantes da primeira esfera em {period}°",
        all_converged="todos os instantes convergiram",
        some_failed="{failed} de {count} instantes sem resultado: {reasons}",
        cage="gaiola",
        spread="{mean} rpm, média das esferas carregadas ({least} a {greatest})",
        passage="as esferas passam sob a carga a {frequency} Hz",
        at_rest="em repouso: sem frequência",
        displacement="Deslocamento do anel interno",
        load="Carga no anel interno",
        stiffness="Rigidez",
        mean="média",
        extent="pico a pico",
        harmonic="harm. {order}",
        relative="da média",
        no_variation="sem variação: o anel fica parado enquanto as esferas passam",
        one_ball="Uma esfera em sua volta",
        maximum_load="maior carga",
        minimum_load="menor carga",
        loaded_over="carregada em",
        at="em",
        contact_angle="ângulo de contato ali",
        pressure="pressão ali",
        row="carreira {number}",
    ),
}


def turn_report(turn: CageTurn, words: Words = ENGLISH, medium: Medium | None = None) -> str:
    """Return the report of a turn of the cage as text that ends in a newline.

    Parameters
    ----------
    turn
        Converged or not; what needs every instant is left out if one has no result.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    page, said = Page(words, medium or Medium()), _WORDS.get(words.code, _WORDS["en"])
    parts = [_head(page, said, turn)]
    if turn.converged:
        parts += [_ring(page, said, turn), _stiffness(page, said, turn)]
        parts += [_ball(page, said, history, turn) for history in turn.histories]
    return rendered(page.medium, parts)


def _head(page: Page, said: _Words, turn: CageTurn) -> Lines:
    points = said.points.format(
        count=len(turn), period=page.digits.short(degrees(turn.period), digits=4)
    )
    good, status = turn.converged, _status(page, said, turn)
    entries = [
        (said.turn, points, ""),
        (page.words.status, status, "green" if good else "bold red"),
    ]
    if turn.advice:
        entries.append((page.words.advice_label, page.words.note(turn.advice), ""))
    if good:
        entries.insert(1, (said.cage, _cage(page, said, turn), ""))
    return [*page.title(turn.case.title or page.words.untitled), *page.labelled(entries)]


def _status(page: Page, said: _Words, turn: CageTurn) -> str:
    if turn.converged:
        return f"✓ {said.all_converged}"
    failed = turn.status[turn.status != "converged"]
    reasons = (page.words.reasons.get(code, code) for code in np.unique(failed).tolist())
    text = said.some_failed.format(failed=len(failed), count=len(turn), reasons=", ".join(reasons))
    return f"✗ {text}"


def _cage(page: Page, said: _Words, turn: CageTurn) -> str:
    if not isfinite(turn.passage_frequency):
        return said.at_rest
    speed = turn.cage_speed
    mean, lowest, highest = (
        page.digits.short(_RPM * value) for value in (speed.mean, speed.minimum, speed.maximum)
    )
    spread = said.spread.format(mean=mean, least=lowest, greatest=highest)
    frequency = page.digits.short(turn.passage_frequency)
    return f"{spread}\n{said.passage.format(frequency=frequency)}"


def _ring(page: Page, said: _Words, turn: CageTurn) -> Lines:
    """Show mean, peak to peak and the first harmonics of displacements and loads."""
    displacement, load = turn.variation("displacement"), turn.variation("load")
    lines = [
        page.heading(said.displacement),
        *_table(page, said, AXES, displacement, (("µm", 1e6), ("nm", 1e9)),
                (("mrad", 1e3), ("µrad", 1e6))),
    ]  # fmt: skip
    if not displacement.peak_to_peak.any():
        lines += page.hanging(Text("  "), said.no_variation, "dim")
    lines += [
        Text(),
        page.heading(said.load),
        *_table(page, said, LOADS, load, (("N", 1.0),) * 2, (("N·m", 1.0),) * 2),
    ]
    return lines


Unit = tuple[str, float]


def _table(
    page: Page,
    said: _Words,
    names: Sequence[str],
    variation: Variation,
    shifts: tuple[Unit, Unit],
    tilts: tuple[Unit, Unit],
) -> Lines:
    """Set the five degrees of freedom; each pair of units is that of the mean and of the rest."""
    amplitudes = np.abs(variation.harmonics[:_HARMONICS])
    orders = [said.harmonic.format(order=order + 1) for order in range(len(amplitudes))]
    heads = ["", said.mean, "", said.extent, *orders, ""]
    rows = [[page.text(head, "dim") for head in heads]]
    for group, units in ((slice(0, _SHIFTS), shifts), (slice(_SHIFTS, 5), tilts)):
        (mean_unit, mean_factor), (unit, factor) = units
        means = page.digits.column((mean_factor * variation.mean[group]).tolist(), most=3)
        varied = np.vstack([variation.peak_to_peak[group], amplitudes[:, group]]) * factor
        columns = [_compact(page, values) for values in varied]
        for index, name in enumerate(names[group]):
            rows.append(
                [
                    Text(name),
                    page.text(means[index]),
                    page.text(mean_unit),
                    *(
                        page.text(column[index], "" if number else "bold")
                        for number, column in enumerate(columns)
                    ),
                    page.text(unit),
                ]
            )
    return page.columns(rows, "lrl" + "r" * (1 + len(amplitudes)) + "l", gap=2)


def _compact(page: Page, values: NDArray[np.float64]) -> list[str]:
    """Write what varies with four digits, and what does not as a plain 0."""
    texts = page.digits.column(values.tolist(), digits=4)
    return ["0" if value == 0.0 else text for text, value in zip(texts, values, strict=True)]


def _stiffness(page: Page, said: _Words, turn: CageTurn) -> Lines:
    variation = turn.variation("stiffness")
    heads = ("", said.mean, said.extent, "", said.relative, "")
    rows = [[page.text(head, "dim") for head in heads]]
    means, extents = np.diagonal(variation.mean), np.diagonal(variation.peak_to_peak)
    for index, (load, axis) in enumerate(zip(LOADS, AXES, strict=True)):
        factor, unit = (1e-6, "N/µm") if index < _SHIFTS else (1e-3, "N·m/mrad")
        mean, extent = factor * float(means[index]), factor * float(extents[index])
        share = 100.0 * extent / abs(mean) if mean else float("nan")
        cells = (page.digits.short(mean), page.digits.short(extent, 4))
        rows.append(
            [
                Text(f"{load} {axis}"),
                page.text(cells[0]),
                page.text(cells[1], "bold"),
                page.text(unit),
                page.text(page.digits.short(share, 3)),
                Text("%"),
            ]
        )
    return [page.heading(said.stiffness), *page.columns(rows, "lrrlrl", gap=2)]


def _ball(page: Page, said: _Words, history: BallHistory, turn: CageTurn) -> Lines:
    """Show where one ball of a row carries most and least."""
    words = page.words
    number = said.row.format(number=history.row) if len(turn.histories) > 1 else ""
    races = (history.inner, history.outer)
    short = page.digits.short
    heaviest = [contact.heaviest for contact in races]

    def along(values: Sequence[float], unit: str) -> list[Text]:
        return [*(page.text(short(value)) for value in values), page.text(unit)]

    def there(name: str, factor: float) -> list[float]:
        pairs = zip(races, heaviest, strict=True)
        return [factor * float(getattr(contact, name)[index]) for contact, index in pairs]

    rows = [
        [Text(), page.text(words.inner, "dim"), page.text(words.outer, "dim"), Text()],
        [page.text(said.maximum_load), *along(there("load", 1.0), "N")],
        [page.text(f"  {said.at}"), *along(np.degrees(history.azimuth[heaviest]).tolist(), "°")],
        [page.text(f"  {said.pressure}"), *along(there("max_pressure", 1e-6), "MPa")],
        [
            page.text(f"  {said.contact_angle}"),
            *along(there("contact_angle", 180.0 / pi), "°"),
        ],
        [page.text(said.minimum_load), *along([float(race.load.min()) for race in races], "N")],
        [page.text(said.loaded_over), *along([_loaded_over(race) for race in races], "°")],
    ]
    title = ", ".join(part for part in (said.one_ball, number) if part)
    return [page.heading(title), *page.columns(rows, "lrrl", gap=2)]


def _loaded_over(contact: ContactHistory) -> float:
    """Return the part of the way on which the contact carries load, in degrees."""
    return 360.0 * float(np.mean(contact.load > 0.0))


# --- data -------------------------------------------------------------------------------------


def turn_csv(turn: CageTurn) -> str:
    """Return the instants, one a line below a header that names the units (RFC 4180).

    A decimal point, ten significant digits, an empty field for what does not exist.
    """
    text = StringIO(newline="")
    writer = csv.writer(text)
    balls = turn.solved.inner.load.shape[1]
    shifts = [f"{axis}_um" if len(axis) == 1 else f"{axis}_mrad" for axis in AXES]
    loads = [f"{load}_N" if load[0] == "f" else f"{load}_Nm" for load in LOADS]
    writer.writerow(
        [
            "angle_deg",
            "time_ms",
            "status",
            *shifts,
            *loads,
            *(f"stiffness_{load}_{axis}_SI" for load in LOADS for axis in AXES),
            *(f"ball_{ball}_{race}_load_N" for race in ("inner", "outer") for ball in range(balls)),
        ]
    )
    writer.writerows(_lines(turn))
    return text.getvalue()


def _lines(turn: CageTurn) -> Iterator[list[str]]:
    factors = np.array([1e6, 1e6, 1e6, 1e3, 1e3])
    time = 1e3 * turn.time
    for point in range(len(turn)):
        numbers = np.concatenate(
            [
                factors * turn.solved.displacement.array[point],
                turn.solved.load.array[point],
                turn.solved.stiffness.array[point].ravel(),
                turn.solved.inner.load[point],
                turn.solved.outer.load[point],
            ]
        )
        first = [csv_number(degrees(turn.angle[point])), csv_number(time[point])]
        yield [*first, str(turn.status[point]), *map(csv_number, numbers.tolist())]


def turn_json(turn: CageTurn) -> str:
    """Return everything as one JSON object in SI units, ``null`` for what does not exist."""
    speed = turn.cage_speed
    mapping = {
        "schema": SCHEMA,
        "kind": "cage_turn",
        "title": turn.case.title,
        "status": {"converged": turn.converged, "codes": turn.status.tolist()},
        "period": turn.period,
        "angle": turn.angle,
        "time": turn.time,
        "cage_speed": {"mean": speed.mean, "least": speed.minimum, "greatest": speed.maximum},
        "passage_frequency": turn.passage_frequency,
        "orders": turn.orders.tolist(),
        "frequencies": turn.frequencies,
        "displacement": _variation_mapping(turn, "displacement"),
        "load": _variation_mapping(turn, "load"),
        "stiffness": _variation_mapping(turn, "stiffness"),
        "balls": [
            {
                "row": history.row,
                "azimuth": history.azimuth,
                "inner": _contact_mapping(history.inner),
                "outer": _contact_mapping(history.outer),
            }
            for history in turn.histories
        ],
    }
    return dumps(mapping)


def _variation_mapping(turn: CageTurn, quantity: Compared) -> dict[str, Any]:
    variation = turn.variation(quantity)
    return {
        "values": getattr(turn.solved, quantity).array,
        "mean": variation.mean,
        "peak_to_peak": variation.peak_to_peak,
        "amplitude": np.abs(variation.harmonics),
        "phase": np.angle(variation.harmonics),
    }


def _contact_mapping(contact: ContactHistory) -> dict[str, Any]:
    return {
        "load": contact.load,
        "contact_angle": contact.contact_angle,
        "max_pressure": contact.max_pressure,
    }
