"""The page of `speed`: how fast a bearing may run, and what load its balls need."""

from __future__ import annotations

from math import isfinite, pi
from typing import TYPE_CHECKING, Final

from rolamento.document import (
    Column,
    Document,
    Entry,
    KeyValues,
    Number,
    Section,
    Statement,
    Table,
    Title,
    Tone,
)
from rolamento.pages.notes import cautions_section, notes_section, remarks_of
from rolamento.words import marked, said, said_in
from rolamento.words.sentences.speeds import LIMIT_NAMES, factor_text

if TYPE_CHECKING:
    from rolamento.analysis.speed_limits import MinimumLoad, SpeedLimit, SpeedLimits

__all__ = ["speed_page"]

_RPM: Final = 30.0 / pi
_LOADS: Final = {
    "share": marked("equivalent load P"),
    "radial": marked("radial load F_r"),
    "axial": marked("axial load F_a"),
    "thrust": marked("axial load F_a"),
}


def speed_page(found: SpeedLimits) -> Document:
    """Return the limits of the speed and the minimum loads.

    Parameters
    ----------
    found
        What `rolamento.analysis.speed_limits.speed_limits` gives.
    """
    title = found.title or said("Limiting speeds")
    sections = [Section("", (Title(title),), "head"), *cautions_section(found.notes)]
    sections.append(_given(found))
    if found.limits:
        sections.append(_limits(found))
    if found.minimum_loads:
        sections.append(_loads(found.minimum_loads))
    if found.general_loads:
        sections.append(_general(found.general_loads))
    if found.cage_slip is not None:
        slip = found.cage_slip
        text = (
            said("Under friction alone the cage lags {slip:.3 %} behind that of outer raceway"
                 " control.", slip=slip)
            if slip >= 0.0
            else said("Under friction alone the cage is {slip:.3 %} ahead of that of outer raceway"
                      " control.", slip=-slip)
        )  # fmt: skip
        blocks = (Statement(text, indent=2),)
        sections.append(Section(said("Slip of the cage"), blocks, "cage_slip"))
    sections += notes_section(remarks_of(found.notes))
    return Document(title, tuple(sections), kind="speed")


def _given(found: SpeedLimits) -> Section:
    """What it rests on."""
    given = found.boundary
    entries = []
    if given.series:
        entries.append(Entry(said("series"), given.series))
    if given.bore is not None and given.outside_diameter is not None:
        size = said(
            "{bore:.6 [mm]} × {outside:.6 mm}", bore=given.bore, outside=given.outside_diameter
        )
        if given.width is not None:
            size = said(
                "{bore:.6 [mm]} × {outside:.6 [mm]} × {width:.6 mm}",
                bore=given.bore,
                outside=given.outside_diameter,
                width=given.width,
            )
        entries.append(Entry(said("size"), size))
    if given.rows > 1:
        entries.append(Entry(said("bearings"), Number(given.rows)))
    entries += [
        Entry("C, C_0", said(
            "{dynamic:.4 [kN]}, {static:.4 kN}",
            dynamic=given.dynamic_rating, static=given.static_rating,
        )),
        Entry(said("speed"), Number(found.speed, ".6 rpm")),
        Entry("n·d_m", said("{value:.4} million mm·rpm", value=1e-6 * found.n_dm)),
    ]  # fmt: skip
    if found.viscosity is not None:
        entries.append(Entry("ν", Number(found.viscosity, ".4 mm²/s")))
    if found.shares is not None:
        entries.append(Entry("K_L, K_P", said(
            "{lubricant:.3}, {load:.3}",
            lubricant=found.shares.lubricant, load=found.shares.load,
        )))  # fmt: skip
    return Section(said("Bearing"), (KeyValues(tuple(entries), 2),), "bearing")


def _limits(found: SpeedLimits) -> Section:
    limits = found.limits
    tones = [_tone(limit) for limit in limits]
    columns = [
        Column("", [said(LIMIT_NAMES[one.name]) for one in limits], "limit", tones=tones),
        Column("n", [one.speed for one in limits], "speed", "rpm", figures=4, tones=tones),
        Column(
            "n·d_m",
            [1e-3 * _RPM * one.speed * found.mean_diameter for one in limits],
            "n_dm",
            figures=4,
            tones=tones,
        ),
    ]
    if found.speed:
        shares = [one.share for one in limits]
        columns.append(
            Column(said_in("speed", "share"), shares, "share", "%", figures=3, tones=tones)
        )
    legend = said("n·d_m in million mm·rpm; share: the speed of the case over the limit")
    origins: dict[str, str] = {}
    for one in limits:
        thermal = one.name in ("catalogue", "reference", "permissible")
        name = said(LIMIT_NAMES[one.name]) if thermal else said("limiting speeds")
        texts = (one.source.text, *(factor_text(*factor) for factor in one.factors))
        origins.setdefault(name, "; ".join(texts))
    table = Table(tuple(columns), "limits", legends=(legend,), rule=True, fixed=1)
    entries = tuple(Entry(f"{name}:", text, "faint") for name, text in origins.items())
    block = KeyValues(entries, 2)
    return Section(said("Limits of the speed"), (table, block), "limits")


def _loads(loads: tuple[MinimumLoad, ...]) -> Section:
    tones: list[Tone] = ["" if one.enough or not one.given else "warning" for one in loads]
    columns = (
        Column("", [said(_LOADS[one.name]) for one in loads], "load", tones=tones),
        Column(said("needed"), [one.load for one in loads], "needed", "N", figures=3, tones=tones),
        Column(
            said("of the case"), [one.given for one in loads], "given", "N", figures=4, tones=tones
        ),
        Column(said("rule"), [one.source.text for one in loads], "rule"),
    )
    table = Table(columns, "minimum_loads", rule=True, fixed=1)
    return Section(said("Minimum load"), (table,), "minimum_loads")


def _general(loads: tuple[MinimumLoad, ...]) -> Section:
    makers = [str(one.source.values["maker"]) for one in loads]
    columns = (
        Column("", makers, "maker"),
        Column(said("needed"), [one.load for one in loads], "needed", "N", figures=3),
        Column(said("of the case"), [one.given for one in loads], "given", "N", figures=4),
        Column(said("rule"), [one.source.text for one in loads], "rule"),
    )
    table = Table(columns, "general_loads", rule=True, fixed=1)
    return Section(said("Makers' rules for all bearings"), (table,), "general_loads")


def _tone(limit: SpeedLimit) -> Tone:
    return "warning" if isfinite(limit.share) and limit.share > 1.0 else ""
