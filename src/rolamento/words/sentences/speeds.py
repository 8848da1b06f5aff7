"""What is said of limiting speeds and minimum loads: notes, and where the numbers come from."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

from rolamento.words.naming import listed
from rolamento.words.speaking import marked, said

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["FACTOR_NAMES", "LIMIT_NAMES", "SENTENCES", "factor_text"]

LIMIT_NAMES: Final = {
    "catalogue": marked("limiting speed of the catalogue, oil"),
    "reference": marked("thermal reference speed"),
    "permissible": marked("thermally permissible speed"),
    "grease": marked("limiting speed, grease"),
    "oil_bath": marked("limiting speed, oil bath"),
    "high_speed": marked("limiting speed, oil-air, mist or jet"),
}
"""Names of `rolamento.analysis.speed_limits.SpeedLimit.name`."""


def _above(values: Mapping[str, Any]) -> str:
    names = "; ".join(said(LIMIT_NAMES[name]) for name in values["limits"])  # which have commas
    return said("The speed is above: {names}.", names=names)


FACTOR_NAMES: Final = {
    "ceramic": marked("ceramic balls ×{value:.3} (GMN)"),
    "matched": marked("side by side ×{value:.3} (NSK, matched bearings)"),
    "spring": marked("pair preloaded by springs ×{value:.3} (GMN)"),
    "rigid_pair": marked("pair with {level} rigid preload ×{value:.3} (GMN)"),
    "rigid_set": marked("set with {level} rigid preload ×{value:.3} or more (GMN)"),
}
"""Names of `rolamento.speeds.SpeedFactor.name`."""
_LEVELS: Final = {"light": marked("light"), "medium": marked("medium"), "heavy": marked("heavy")}


def factor_text(name: str, value: float, level: str) -> str:
    """Say what a factor on the maker's limiting speeds is, and whose."""
    known = _LEVELS.get(level, "")
    return said(FACTOR_NAMES[name], value=value, level=said(known) if known else "")


def _what(values: Mapping[str, Any]) -> str:
    """What of a bearing a limit leaves out, as a list."""
    what = [said("bearings side by side")] if values["rows"] else []
    what += [said("ceramic balls")] if values["ceramic"] else []
    what += [
        said("{part} ({meaning})", part=part, meaning=said(meaning))
        for part, meaning in values["parts"]
    ]
    return listed(what)


def _class_leaves_out(values: Mapping[str, Any]) -> str:
    texts = []
    if what := _what(values):
        texts.append(
            said(
                "The maker's limiting speeds are of single open bearings with steel balls and"
                " ordinary cages. Not considered, though it may change them much: {what}.",
                what=what,
            )
        )
    if values["preload"]:
        texts.append(
            said(
                "The preload of the set is not known: the limits are those of NSK's matched"
                " bearings. GMN gives a pair 0.8 of the single bearing's speed at light, 0.7 at"
                " medium and 0.5 at heavy rigid preload: give `bearing.preload`."
            )
        )
    return " ".join(texts)


def _reference_leaves_out(values: Mapping[str, Any]) -> str:
    return said(
        "Thermal reference and permissible speed are those of one open standard bearing alone"
        " (ISO 15312). Not considered: {what}.",
        what=_what(values),
    )


def _no_class(values: Mapping[str, Any]) -> str:
    if values["angle"] is None:
        return said(
            "No limiting speeds of a maker are on file for the series {series}.",
            series=values["series"],
        )
    return said(
        "No limiting speeds of a maker are on file for the series {series} at {angle:.3}°.",
        series=values["series"],
        angle=values["angle"],
    )


def _below(values: Mapping[str, Any]) -> str:
    if values.get("paired"):
        return said(
            "The load does not reach the minimum load: the rollers may slide. Preload the pair."
        )
    if "element" in values:
        return said(
            "The load does not reach the minimum load: the rollers may slide, and smear. A"
            " smaller bearing or more load helps."
        )
    return said(
        "The load does not reach a minimum load: the balls may slide. Preload them by springs."
    )


def _general(values: Mapping[str, Any], rating: str) -> str:
    source = values["source"]
    if not values["checked"]:
        source = said("{source}; general knowledge", source=source)
    return said(
        "{share:.3} {rating}; {source}", share=values["share"], rating=rating, source=source
    )


SENTENCES: Final[dict[str, Sentence]] = {
    "source_listed_speed": lambda values: str(values["source"]),
    "source_minimum_of_maker": marked(
        "the greater of (C_0/100) (n/n_max)² and C_0/1000; NSK catalogue E1102"
    ),
    "source_reference_speed": marked("ISO 15312:2003, f_0r {f_0r:.3}, f_1r {f_1r:.3}"),
    "source_permissible_speed": marked(
        "DIN 732-2, ν {viscosity:.3 mm²/s}, P_1 {load:.4 N}, reference heat flow"
    ),
    "source_speed_class": marked("{source}: mean n·d_m of {bearings}"),
    "source_minimum_share": marked("P ≥ {share:.3} C; SKF catalogue 10000 EN"),
    "source_minimum_of_rollers": marked("{share:.3} C; {source}"),
    "source_minimum_static": marked("{share:.3} C_0; SKF, CARB toroidal roller bearings, loads"),
    "source_minimum_of_cylindrical": marked(
        "k_r (6 + 4 n/n_r) (d_m/100)², k_r {factor:.3}; SKF catalogue 10000 EN"
    ),
    "source_minimum_radial": marked(
        "k_r (ν n/1000)^(2/3) (d_m/100)², k_r {factor:.3}; SKF catalogue 10000 EN"
    ),
    "source_minimum_axial": marked(
        "k_a C_0/1000 (n d_m/100 000)², k_a {factor:.3}; SKF catalogue 10000 EN"
    ),
    "source_minimum_general_dynamic": lambda values: _general(values, "C"),
    "source_minimum_general_static": lambda values: _general(values, "C_0"),
    "source_minimum_thrust": marked("A (n/1000)², A {factor:.4 N} as given"),
    "no_reference_speed_of_thrust": marked(
        "ISO 15312 excludes thrust ball bearings: they have no thermal reference speed."
    ),
    "no_series_for_speed": marked(
        "The series is not known, and so neither a thermal reference speed nor a maker's limiting"
        " speeds: give `series`."
    ),
    "no_reference_coefficients": marked(
        "No coefficients of ISO 15312 are on file for the series {series}: there is no thermal"
        " reference speed."
    ),
    "reference_coefficients_unchecked": marked(
        "f_0r and f_1r of the series {series} are from general knowledge of ISO 15312 and of a"
        " maker's table, not checked against a print."
    ),
    "no_boundary_dimensions": marked(
        "Bore, outside diameter and width are needed for the thermal reference speed: give a"
        " designation, or `mounting.bore`, `mounting.outside_diameter` and `width`."
    ),
    "no_static_rating_for_speed": marked(
        "The thermal reference speed needs C_0: give `life.static_rating`."
    ),
    "no_permissible_speed_under_axial_load": marked(
        "How an axial load of such bearings counts in their friction is not on file: there is no"
        " thermally permissible speed under one."
    ),
    "no_permissible_speed": marked(
        "The permissible speed needs a lubricant and its temperature: `lubricant`, `temperature`."
    ),
    "reference_speed_leaves_out": _reference_leaves_out,
    "permissible_speed_of_thin_oil": marked(
        "ν n is below 2000 mm²/s·rpm, where the friction of the oil no longer falls: the"
        " permissible speed is too high."
    ),
    "heat_flow_of_reference": marked(
        "The permissible speed takes the heat flow of the reference conditions (outer ring at"
        " 70 °C, ambient at 20 °C): oil circulation raises it, a warm machine lowers it."
    ),
    "no_speed_class": _no_class,
    "speed_class_leaves_out": _class_leaves_out,
    "speed_class_of_light_load": marked(
        "The maker's limiting speeds are for C/P of 12 and above and F_a/F_r up to 0.2; this load"
        " lowers them."
    ),
    "speed_above_limits": _above,
    "load_below_minimum": _below,
    "preload_for_minimum_load": marked(
        "The set is preloaded, which the loads given here leave out; `rolamento solve` shows the"
        " preload at speed."
    ),
    "no_load_to_compare": lambda values: (
        said("The case has no load: only what its rollers need is shown.")
        if "element" in values
        else said("The case has no load: only what its balls need is shown.")
    ),
    "minimum_load_factors_unchecked": marked(
        "k_r and k_a of the series are from general knowledge of SKF's tables, not checked against"
        " a print."
    ),
}
