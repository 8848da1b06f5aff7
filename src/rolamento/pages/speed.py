"""The page of `speed`: how fast a bearing may run, and what load its balls need."""

from __future__ import annotations

from math import isfinite, pi
from typing import TYPE_CHECKING, Final

from rolamento import document as doc
from rolamento.pages.notes import cautions_section, notes_section, remarks_of
from rolamento.words import marked, said, said_in
from rolamento.words.quantities import CALLED
from rolamento.words.sentences.speeds import LIMIT_NAMES, factor_text

if TYPE_CHECKING:
    from rolamento.analysis.speed_limits import MinimumLoad, SpeedLimit, SpeedLimits

__all__ = ["speed_page"]

_RPM: Final = 30.0 / pi
_LOADS: Final = {
    "share": CALLED["equivalent_load"],
    "radial": marked("radial load F_r"),
    "axial": marked("axial load F_a"),
    "thrust": marked("axial load F_a"),
}


def speed_page(found: SpeedLimits) -> doc.Document:
    """Return the limits of the speed and the minimum loads.

    Parameters
    ----------
    found
        What `rolamento.analysis.speed_limits.speed_limits` gives.
    """
    title = found.title or said("Limiting speeds")
    sections = [doc.Section("", (doc.Title(title),), "head"), *cautions_section(found.notes)]
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
        blocks = (doc.Statement(text, indent=2),)
        sections.append(doc.Section(said("Slip of the cage"), blocks, "cage_slip"))
    sections += notes_section(remarks_of(found.notes))
    return doc.Document(title, tuple(sections), kind="speed")


def _given(found: SpeedLimits) -> doc.Section:
    """What it rests on."""
    given = found.boundary
    entries = []
    if given.series:
        entries.append(doc.Entry(said("series"), given.series))
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
        entries.append(doc.Entry(said("size"), size))
    if given.rows > 1:
        entries.append(doc.Entry(said("bearings"), doc.Number(given.rows)))
    entries += [
        doc.Entry("C, C_0", said(
            "{dynamic:.4 [kN]}, {static:.4 kN}",
            dynamic=given.dynamic_rating, static=given.static_rating,
        )),
        doc.Entry(said("speed"), doc.Number(found.speed, ".6 rpm")),
        doc.Entry("n·d_m", said("{value:.4} million mm·rpm", value=1e-6 * found.n_dm)),
    ]  # fmt: skip
    if found.viscosity is not None:
        entries.append(doc.Entry("ν", doc.Number(found.viscosity, ".4 mm²/s")))
    if found.shares is not None:
        entries.append(doc.Entry("K_L, K_P", said(
            "{lubricant:.3}, {load:.3}",
            lubricant=found.shares.lubricant, load=found.shares.load,
        )))  # fmt: skip
    return doc.Section(said("Bearing"), (doc.KeyValues(tuple(entries), 2),), "bearing")


def _limits(found: SpeedLimits) -> doc.Section:
    limits = found.limits
    tones = [_tone(limit) for limit in limits]
    columns = [
        doc.Column("", [said(LIMIT_NAMES[one.name]) for one in limits], "limit", tones=tones),
        doc.Column("n", [one.speed for one in limits], "speed", "rpm", figures=4, tones=tones),
        doc.Column(
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
            doc.Column(said_in("speed", "share"), shares, "share", "%", figures=3, tones=tones)
        )
    legend = said("n·d_m in million mm·rpm; share: the speed of the case over the limit")
    origins: dict[str, str] = {}
    for one in limits:
        thermal = one.name in ("catalogue", "reference", "permissible")
        name = said(LIMIT_NAMES[one.name]) if thermal else said("limiting speeds")
        texts = (one.source.text, *(factor_text(*factor) for factor in one.factors))
        origins.setdefault(name, "; ".join(texts))
    table = doc.Table(tuple(columns), "limits", legends=(legend,), rule=True, fixed=1)
    entries = tuple(doc.Entry(f"{name}:", text, "faint") for name, text in origins.items())
    block = doc.KeyValues(entries, 2)
    return doc.Section(said("Limits of the speed"), (table, block), "limits")


def _loads(loads: tuple[MinimumLoad, ...]) -> doc.Section:
    tones: list[doc.Tone] = ["" if one.enough or not one.given else "warning" for one in loads]
    columns = (
        doc.Column("", [said(_LOADS[one.name]) for one in loads], "load", tones=tones),
        doc.Column(
            said("needed"), [one.load for one in loads], "needed", "N", figures=3, tones=tones
        ),
        doc.Column(
            said("of the case"), [one.given for one in loads], "given", "N", figures=4, tones=tones
        ),
        doc.Column(said("rule"), [one.source.text for one in loads], "rule"),
    )
    table = doc.Table(columns, "minimum_loads", rule=True, fixed=1)
    return doc.Section(said("Minimum load"), (table,), "minimum_loads")


def _general(loads: tuple[MinimumLoad, ...]) -> doc.Section:
    makers = [str(one.source.values["maker"]) for one in loads]
    columns = (
        doc.Column("", makers, "maker"),
        doc.Column(said("needed"), [one.load for one in loads], "needed", "N", figures=3),
        doc.Column(said("of the case"), [one.given for one in loads], "given", "N", figures=4),
        doc.Column(said("rule"), [one.source.text for one in loads], "rule"),
    )
    table = doc.Table(columns, "general_loads", rule=True, fixed=1)
    return doc.Section(said("Makers' rules for all bearings"), (table,), "general_loads")


def _tone(limit: SpeedLimit) -> doc.Tone:
    return "warning" if isfinite(limit.share) and limit.share > 1.0 else ""
