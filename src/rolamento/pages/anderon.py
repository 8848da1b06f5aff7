"""The page of `anderon`: the noise of a bearing in anderons, the verdict first."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from math import exp, isfinite, nan
from typing import TYPE_CHECKING, Final

from rolamento import document as doc
from rolamento import plots
from rolamento.pages.data import in_files, signal_entry
from rolamento.pages.notes import about
from rolamento.units import HOUR
from rolamento.vibration.anderon import BANDS, velocity_of_anderons
from rolamento.vibration.anderon_trend import AnderonTrend, BandTrend
from rolamento.words import ABSENT, manner, said, said_in
from rolamento.words.naming import one_line
from rolamento.words.sentences.noise import band_name

if TYPE_CHECKING:
    from rolamento.tasks.noise import MeasuredNoise, NoiseResult

__all__ = ["anderon_page", "noise_statement"]

_TONES: Final[dict[str, doc.Tone]] = {
    "accepted": "good",
    "rejected": "bad-strong",
    "not_measured": "warning-strong",
    "none": "faint",
}
_LONGEST_NAME: Final = 32


def anderon_page(found: NoiseResult) -> doc.Document:
    """Return the page of one signal's noise, or of several."""
    leading, notes = about([(one.title, (*one.notes, *one.choices)) for one in found.measured])
    head = _statement(found)
    sections = [replace(head, blocks=(*head.blocks, *leading))]
    if len(found.measured) == 1:
        sections += [_facts(found.measured[0]), _bands(found)]
    else:
        sections.append(_signals(found))
        if found.trend is not None:
            sections += _over_time(found.trend)
    sections += notes
    sections.append(doc.Section("", tuple(_figures(found)), "figures"))
    sections.append(in_files("levels", _COLUMNS, _levels(found)))
    return doc.Document(_title(found), tuple(sections), kind="anderon", main="levels")


_COLUMNS: Final = {
    "signal": "", "hours": "", "band": "", "low": "Hz", "high": "Hz", "velocity": "µm/s",
    "anderons": "", "full_scale_anderons": "", "accepted_to_anderons": "", "verdict": "",
}  # fmt: skip


def _levels(found: NoiseResult) -> Iterator[tuple[doc.CellContent, ...]]:
    """Return each band of each signal."""
    for place, one in enumerate(found.measured):
        scales = found.scales_of(one)
        for band in one.noise.bands:
            scale = scales.get(band.name, nan)
            verdict = found.verdict_of(place, band.name)
            levels = (band.velocity, band.anderons, scale, found.part * scale)
            yield one_line(one.title), one.hours, band.name, *band.band, *levels, verdict


def _title(found: NoiseResult) -> str:
    if len(found.measured) == 1:
        return one_line(found.measured[0].title)
    return said("Noise of bearing {name}", name=found.bearing)


def noise_statement(found: NoiseResult) -> str:
    """Return what the noise of one signal, or of several, comes to."""
    count, rejected = len(found.measured), found.verdicts.count("rejected")
    if not found.full_scales:
        return said("No verdict: no full scale is given (`full_scale`).")
    if rejected and count > 1:
        return said("Rejected: {rejected} of {count} signals.", rejected=rejected, count=count)
    if rejected:
        bands = "; ".join(_rejections(found))
        if any(isfinite(level) for level in _levels_rejected(found)):
            return said("Rejected: {bands}.", bands=bands)
        return said("Not accepted: {bands}.", bands=bands)
    if count > 1:
        return said(
            "Accepted: all {count} signals; no band is above {part:.4 %} of its full scale.",
            count=count,
            part=found.part,
        )
    return said("Accepted: no band is above {part:.4 %} of its full scale.", part=found.part)


def _levels_rejected(found: NoiseResult) -> list[float]:
    """Anderons of the only signal in the bands that it is rejected for; NaN if not measured."""
    acceptance, noise = found.acceptances[0], found.measured[0].noise
    return [noise.of(name).anderons for name in acceptance.rejected] if acceptance else []


def _rejections(found: NoiseResult) -> Iterable[str]:
    """Say in which bands the only signal is rejected."""
    one, acceptance = found.measured[0], found.acceptances[0]
    limits = found.limits_of(one)
    for name in acceptance.rejected if acceptance else ():
        value, band = one.noise.of(name).anderons, band_name(name)
        if isfinite(value):
            yield said(
                "{band} band with {value:.3} anderon, the limit is {limit:.3}",
                band=band,
                value=value,
                limit=limits[name],
            )
        else:
            yield said("{band} band not measured", band=band)


def _statement(found: NoiseResult) -> doc.Section:
    tone: doc.Tone = "good-strong" if found.full_scales else "warning-strong"
    tone = "bad-strong" if "rejected" in found.verdicts else tone
    return doc.Section("", (doc.Statement(noise_statement(found), tone),), "verdict")


# --- one signal ------------------------------------------------------------------------------


def _facts(one: MeasuredNoise) -> doc.Section:
    entries = (doc.Entry(said("speed"), _speed(one)), signal_entry(one.noise.velocity))
    return doc.Section("", (doc.Title(one_line(one.title)), doc.KeyValues(entries)), "given")


def _speed(one: MeasuredNoise) -> str:
    if not one.speed_known:
        return said("not given; the test's 1800 rpm are assumed")
    if one.at_test_speed:
        return said("{speed:.6 rpm}, as in the test", speed=one.noise.speed)
    return said("{speed:.6 rpm}; the test runs at 1800 rpm", speed=one.noise.speed)


def _bands(found: NoiseResult) -> doc.Section:
    one, scales = found.measured[0], found.scales_of(found.measured[0])
    bands = one.noise.bands
    columns = [
        doc.Column("", [band_name(band.name) for band in bands], "band"),
        doc.Column(
            said("band"),
            ["–".join(manner().fixed(edge, 0) for edge in band.band) for band in bands],
            "edges",
            "Hz",
            align="right",
        ),
        *(
            doc.Column(head, [band.band[place] for band in bands], key, "Hz", only_in_files=True)
            for place, (head, key) in enumerate(((said("from"), "low"), (said("to"), "high")))
        ),
        doc.Column("RMS", [band.velocity for band in bands], "velocity", "µm/s"),
        doc.Column("anderon", [band.anderons for band in bands], "anderons", figures=3),
        *(_verdicts(found) if scales else ()),
    ]
    factors = ", ".join(
        said(
            "{factor:.3f [µm/s]} ({band})",
            factor=velocity_of_anderons(1.0, edges, one.noise.speed),
            band=band_name(name),
        )
        for name, edges in BANDS.items()
    )
    legend = said(
        "RMS: radial velocity of the outer ring, in the bands of ISO 15242-2 for radial ball"
        " bearings. Anderon: microinch RMS of motion per radian of rotation and per square root of"
        " the band's octaves; at {speed:.6 rpm} one is {factors} µm/s.",
        speed=one.noise.speed,
        factors=factors,
    )
    table = doc.Table(tuple(columns), "bands", legends=(legend,))
    return doc.Section(said("Bands"), (table,), "bands")


def _verdict(verdict: str) -> str:
    return {
        "accepted": said_in("noise", "accepted"),
        "rejected": said_in("noise", "rejected"),
        "not_measured": said_in("noise", "not measured"),
        "none": said_in("noise", "no verdict"),
    }[verdict]


def _verdicts(found: NoiseResult) -> Iterable[doc.Column]:
    """Compare the bands of the only signal with their full scales."""
    one, scales = found.measured[0], found.scales_of(found.measured[0])
    bands = one.noise.bands
    full = [scales.get(band.name, nan) for band in bands]
    verdicts = [found.verdict_of(0, band.name) for band in bands]
    yield doc.Column(said("full scale"), full, "full_scale", form=".4")
    yield doc.Column(
        said("ratio"),
        [band.anderons / scale for band, scale in zip(bands, full, strict=True)],
        "of_full_scale",
        "%",
        form=".1f [%]",
    )
    yield doc.Column(said("limit"), [found.part * scale for scale in full], "limit", form=".4")
    yield doc.Column(
        said("verdict"),
        [_verdict(verdict) for verdict in verdicts],
        "verdict",
        tones=[_TONES[verdict] for verdict in verdicts],
    )


# --- several ---------------------------------------------------------------------------------


def _signals(found: NoiseResult) -> doc.Section:
    columns = (
        doc.Column("", [one_line(one.title, _LONGEST_NAME) for one in found.measured], "signal"),
        doc.Column(
            said("time"), [HOUR * one.hours for one in found.measured], "hours", "h", form=".6 [h]"
        ),
        *(
            doc.Column(
                band_name(name),
                [one.noise.of(name).anderons for one in found.measured],
                name,
                figures=3,
            )
            for name in BANDS
        ),
        doc.Column(
            said("verdict"),
            [_verdict(verdict) for verdict in found.verdicts],
            "verdict",
            tones=[_TONES[verdict] for verdict in found.verdicts],
        ),
    )
    table = doc.Table(columns, "signals", legends=(said("Bands in anderon."),))
    return doc.Section(said("Signals"), (table,), "signals")


def _over_time(trend: AnderonTrend) -> list[doc.Section]:
    bands = [band for band in trend.bands if band.anderons]
    if not bands:
        return []
    times = ((said("from"), "rejected_after"), (said("to"), "rejected_by"))
    columns = (
        doc.Column("", [band_name(band.name) for band in bands], "band"),
        doc.Column(said("first"), [band.anderons[0] for band in bands], "first", form=".3"),
        doc.Column(said("last"), [band.anderons[-1] for band in bands], "last", form=".3"),
        doc.Column(said("ratio"), [band.ratio for band in bands], "ratio", form=".3"),
        doc.Column(
            said("growth per 100 h"),
            [exp(min(100.0 * band.growth, 700.0)) - 1.0 for band in bands],
            "growth_per_100_h",
            "%",
            form=".3 [%]",
        ),
        doc.Column(
            said_in("noise", "rejected"),
            [_rejected(band) for band in bands],
            "rejected",
            "h",
            align="right",
        ),
        *(
            doc.Column(
                head,
                [_in_seconds(getattr(band, key)) for band in bands],
                key,
                "h",
                only_in_files=True,
            )
            for head, key in times
        ),
    )
    legend = said(
        "Ratio: last to first. Growth: of the logarithm, by least squares through all measurements."
        " Rejected: between the last measurement before and the first above the limit."
    )
    table = doc.Table(columns, "trend", legends=(legend,))
    return [doc.Section(said("Over the test"), (table,), "trend")]


def _in_seconds(hours: float) -> doc.CellContent:
    return HOUR * hours if isfinite(hours) else None


def _rejected(band: BandTrend) -> str:
    if not isfinite(band.rejected_by):
        return ABSENT
    return "–".join(manner().short(hours) for hours in (band.rejected_after, band.rejected_by))


# --- notes and pictures ----------------------------------------------------------------------


def _figures(found: NoiseResult) -> Iterable[doc.Figure]:
    one = found.measured[0]
    if len(found.measured) == 1:
        yield doc.Figure(
            said("Noise in thirds of octaves, with the level and limit of each band"),
            lambda: plots.noise_figure(one.noise, limits=found.limits_of(one)),
            "noise",
        )
    elif found.trend is not None:
        from rolamento.weibull import parse_trend

        trend, limits = parse_trend(found.record()), found.limits_of(one)
        caption = said("Levels of the bands over the test")
        yield doc.Figure(caption, lambda: plots.noise_trend_figure(trend, limits=limits), "trend")
