"""The page of `electrical`: capacitance, current density beside published bands, breakdown."""

from __future__ import annotations

from math import isfinite
from typing import TYPE_CHECKING

import numpy as np

from rolamento import document as doc
from rolamento.io.data import toml_of
from rolamento.pages.given import case_page, head, race_name
from rolamento.solved import RACES
from rolamento.words import said
from rolamento.words.sentences.electrical import BREAKDOWNS, DENSITIES

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rolamento.electrical import Band, BearingElectrics
    from rolamento.numerics import FloatArray

__all__ = ["electrical_page", "electrical_sections"]


def electrical_page(found: BearingElectrics) -> doc.Document:
    """Return the page of a bearing as an electrical part, of one case.

    Parameters
    ----------
    found
        What `rolamento.electrical.electrics_of` gives, of a single case.
    """
    solved = found.solved
    notes = (*solved.notes[0], *found.notes)
    sections = electrical_sections(found) if solved.converged[0] else []
    return case_page(
        solved.case, head(solved), sections, "electrical", "electrical_races", notes=notes
    )


def electrical_sections(found: BearingElectrics, level: int = 2) -> list[doc.Section]:
    """Return the tables of one case, for a page of its own or a report.

    Parameters
    ----------
    found
        As of `electrical_page`.
    level
        Of their headings.
    """
    return [
        doc.Section(said("Bearing as a capacitor"), _headline(found), "electrical", level),
        doc.Section("", (_races(found),), "electrical_contacts", level),
        *_density(found, level),
        doc.Section(
            said("Breakdown of the film"), _breakdown(found), "electrical_breakdown", level
        ),
    ]


def _headline(found: BearingElectrics) -> tuple[doc.Block, ...]:
    entries = [
        doc.Entry(said("capacitance"), doc.Number(float(found.capacitance[0]), ".3 pF")),
        doc.Entry(
            said("of the ellipses alone"),
            doc.Number(float(found.capacitance_of_ellipses[0]), ".3 pF"),
        ),
        doc.Entry(
            said("with ceramic elements"),
            said("about {value:.2 pF}", value=float(found.ceramic_capacitance[0])),
        ),
    ]
    if isfinite(found.current_density[0]):
        value = float(found.current_density[0])
        entries.append(doc.Entry(said("current density"), doc.Number(value, ".3 A/mm²")))
    if isfinite(found.field[0]):
        entries.append(doc.Entry(said("field"), doc.Number(float(found.field[0]), ".3 V/µm")))
        entries.append(
            doc.Entry(said("energy of a discharge"), doc.Number(float(found.energy[0]), ".3 nJ"))
        )
    return (doc.KeyValues(tuple(entries)),)


def _most(values: FloatArray, places: FloatArray) -> float:
    known = values[0][places[0] > 0.0]
    known = known[np.isfinite(known)]
    return float(known.max()) if known.size else float("nan")


def _races(found: BearingElectrics) -> doc.Table:
    own = [found.of(race) for race in RACES]
    columns = [
        doc.Column("", [race_name(race) for race in RACES], "race"),
        doc.Column(
            "ΣA", [float(one.total_area[0]) for one in own], "area", "mm²", figures=3, most=3
        ),
        doc.Column(
            "h_c",
            [-_most(-one.thickness, one.area) for one in own],
            "thickness",
            "µm",
            figures=3,
            most=3,
        ),
        doc.Column(
            "C", [_most(one.capacitance, one.area) for one in own], "capacitance", "pF", figures=3
        ),
    ]
    legends = [said("ΣA area of all contacts; h_c minimum central film; C maximum of a contact")]
    if found.given.current is not None:
        columns.append(
            doc.Column(
                "J",
                [float(one.current_density[0]) for one in own],
                "current_density",
                "A/mm²",
                figures=3,
                most=4,
            )
        )
        legends.append(said("J apparent current density: amplitude over ΣA"))
    if found.given.voltage is not None:
        columns += [
            doc.Column(
                "V", [_most(one.voltage, one.area) for one in own], "voltage", "V", figures=3
            ),
            doc.Column(
                "E", [_most(one.field, one.area) for one in own], "field", "V/µm", figures=3
            ),
        ]
        legends.append(said("V maximum voltage across a contact; E maximum V/h_c"))
    return doc.Table(tuple(columns), "electrical_races", legends=tuple(legends), rule=True)


def _marks(bands: Sequence[Band]) -> list[str]:
    return [f"[{number}]" for number, _ in enumerate(bands, start=1)]


def _sources(bands: Sequence[Band]) -> list[doc.Statement]:
    """Sources by number, below their table."""
    texts = map(_source, bands)
    return [
        doc.Statement(text, "faint", indent=2, mark=mark)
        for text, mark in zip(texts, _marks(bands), strict=True)
    ]


def _source(band: Band) -> str:
    return band.source if band.checked else said("{source}; general knowledge", source=band.source)


def _density(found: BearingElectrics, level: int) -> list[doc.Section]:
    """Put the current density beside the published bands."""
    value = float(found.current_density[0])
    if not isfinite(value):
        return []
    bands = found.density
    inside = [band.low <= value and (value < band.high or band is bands[-1]) for band in bands]
    tones: list[doc.Tone] = ["strong" if one else "" for one in inside]
    limits: list[doc.CellContent] = [
        said("{low:.3 [A/mm²]} to {high:.3 [A/mm²]}", low=band.low, high=band.high)
        if band.low
        else said("below {high:.3 [A/mm²]}", high=band.high)
        for band in bands
    ]
    columns = (
        doc.Column(said("current density"), limits, "band", "A/mm²", tones=tones),
        doc.Column("", ["▸" if one else "" for one in inside], "here"),
        doc.Column("", [said(DENSITIES[band.key]) for band in bands], "meaning", tones=tones),
        doc.Column("", _marks(bands), "mark", tone="faint"),
        doc.Column(said("source"), [_source(band) for band in bands], "source", only_in_files=True),
    )
    legend = said("▸ bands in which this bearing is; published experience, no limits")
    table = doc.Table(columns, "electrical_bands", legends=(legend,), rule=True)
    blocks: tuple[doc.Block, ...] = (table, *_sources(bands))
    return [doc.Section(said("Published bands"), blocks, "electrical_density", level)]


def _breakdown(found: BearingElectrics) -> tuple[doc.Block, ...]:
    bands = found.breakdown
    voltages: list[doc.CellContent] = []
    fields: list[doc.CellContent] = []
    for band, (low, high) in zip(bands, found.breakdown_voltage[:, :, 0].tolist(), strict=True):
        one = low == high
        voltages.append(
            said("{low:.3 [V]}", low=low)
            if one
            else said("{low:.3 [V]} to {high:.3 [V]}", low=low, high=high)
        )
        fields.append(
            said("{low:.3 [V/µm]}", low=band.low)
            if one
            else said("{low:.3 [V/µm]} to {high:.3 [V/µm]}", low=band.low, high=band.high)
        )
    columns = (
        doc.Column("", [said(BREAKDOWNS[band.key]) for band in bands], "lubricant"),
        doc.Column(said("field"), fields, "field", "V/µm", align="right"),
        doc.Column(said("between the rings"), voltages, "voltage", "V", align="right"),
        doc.Column("", _marks(bands), "mark", tone="faint"),
        doc.Column(said("source"), [_source(band) for band in bands], "source", only_in_files=True),
    )
    data = toml_of("electrical")["threshold"]
    text = said(
        "Motor bearings were seen to discharge between {low:.2 V} and {high:.2 V} ({source}).",
        low=data["low"],
        high=data["high"],
        source=data["source"],
    )
    table = doc.Table(columns, "electrical_breakdown", rule=True)
    return (table, *_sources(bands), doc.Statement(text, indent=2))
