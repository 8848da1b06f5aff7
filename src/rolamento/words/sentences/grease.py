"""What is said of greases and of the choice of an oil."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

from rolamento.words.speaking import marked, said

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["BASE_OILS", "FACTORS", "LAWS", "SENTENCES", "SETS", "THICKENERS"]

LAWS: Final = {
    "nsk_general": marked("NSK, general-purpose grease"),
    "nsk_wide_range": marked("NSK, wide-range grease"),
    "kawamura_lithium": marked("Kawamura and others, lithium grease"),
    "kawamura_urea": marked("Kawamura and others, urea grease"),
    "jtekt": marked("JTEKT"),
}
"""Names of `rolamento.grease.GreaseLife.name`."""
SETS: Final = {"skf": marked("SKF"), "noria": marked("Noria"), "fag": marked("FAG")}
"""Names of `rolamento.grease.Interval.name`."""
FACTORS: Final = {
    "temperature": marked("temperature"),
    "vertical_shaft": marked("vertical shaft"),
    "large_bore": marked("large bore"),
    "outer_ring": marked("outer ring turns"),
    "contamination": marked("contamination"),
    "load": marked("load"),
}
"""Names of the factors of an interval."""
THICKENERS: Final = {"lithium": marked("lithium soap"), "urea": marked("urea")}
BASE_OILS: Final = {
    "mineral": marked("mineral oil"),
    "pao": marked("PAO"),
    "ester": marked("ester"),
    "diester": marked("diester"),
    "silicone": marked("silicone"),
    "ether": marked("ether"),
}


def _kind(values: Mapping[str, Any]) -> str:
    thickener, oil = THICKENERS[values["thickener"]], BASE_OILS[values["base_oil"]]
    return said(
        "The grease is taken as {thickener} with {base_oil}: give `grease.thickener` and"
        " `grease.base_oil`.",
        thickener=said(thickener),
        base_oil=said(oil),
    )


def _pair(values: Mapping[str, Any]) -> str:
    thickener, oil = THICKENERS[values["thickener"]], BASE_OILS[values["base_oil"]]
    return said(
        "there is no factor for {thickener} with {base_oil}",
        thickener=said(thickener),
        base_oil=said(oil),
    )


SENTENCES: Final[dict[str, Sentence]] = {
    # of a single law
    "grease_without_limiting_speed": marked("the limiting speed N with grease is not known"),
    "grease_without_load_ratio": marked("P/C is not known"),
    "grease_too_fast": marked("n/N is {ratio:.3}, above 1"),
    "grease_too_hot": marked("hotter than {limit:.4 °C}"),
    "grease_loaded_too_much": marked("P/C is {ratio:.3}, above {limit:.3}"),
    "grease_speed_factor": marked("d_m n is above {limit:.6}"),
    "grease_size": marked("d_m of {size:.4 mm} is not from 10 to 100 mm"),
    "grease_unknown_pair": _pair,
    "grease_slow_counts_as": marked("n/N counts as {ratio:.3}"),
    "grease_cool_counts_as": marked("the temperature counts as {temperature:.4 °C}"),
    "grease_law_of_lithium": marked("for lithium greases alone"),
    "grease_law_unchecked": marked("from general knowledge, not checked against the print"),
    # of the whole
    "grease_assumed": marked("The case has no lubricant: it is taken to be greased."),
    "grease_instead_of_oil": marked(
        "The case is lubricated by an oil, {oil}: this is what a grease would do in its place."
    ),
    "grease_kind_inferred": _kind,
    "grease_open_assumed": marked(
        "Without a designation the bearing is taken as open, to be relubricated: give"
        " `grease.sealed`."
    ),
    "grease_sealed_by_designation": marked(
        "By its designation ({part}) the bearing is sealed or shielded on both sides: greased for"
        " life."
    ),
    "grease_open_by_designation": marked(
        "By its designation the bearing is open, to be relubricated; `grease.sealed` says"
        " otherwise."
    ),
    "grease_laws_of_deep_groove": marked(
        "The laws of the life of a grease are for sealed deep-groove ball bearings of one row: of"
        " this one there is none."
    ),
    "grease_beyond_tests": marked(
        "No test bears out a life of a grease beyond {limit:.5 h}: do not count on more."
    ),
    "grease_at_rest": marked("Nothing turns: grease ages by time then, and no law counts it."),
    "grease_oscillates": marked(
        "The ring swings; the grease is judged at the mean speed, {speed:.4 rpm}. Swings wear it"
        " more than that: makers' factors for them are charts and are not included."
    ),
    "grease_temperature_assumed": marked(
        "No temperature is given: {temperature:.4 °C} is assumed. 15 K more halve the life."
    ),
    "grease_limit_of_class": marked(
        "N = {speed:.3 rpm} is the mean of the maker's class of such open bearings with grease"
        " (NSK, E1102); contact seals lower it: give `grease.limiting_speed`."
    ),
    "grease_limit_missing": marked(
        "The limiting speed with grease is not known: give `grease.limiting_speed`."
    ),
    "grease_without_sizes": marked(
        "Without bore, outside diameter and width there is no interval and no amount: name the"
        " bearing by its designation, or give a mounting."
    ),
    "grease_beyond_interval": marked(
        "The speed is beyond the formula of the interval: grease will hardly do."
    ),
    "grease_cleanliness_assumed": marked(
        "Normal cleanliness is assumed for the interval: give `life.grease_cleanliness`."
    ),
    "grease_beyond_fag": marked(
        "FAG has no factors above 120 °C or P/C of 0.35: a special grease, or oil."
    ),
    "grease_above_its_limit": marked(
        "At {temperature:.4 °C} the grease is above its {most:.4 °C}: it ages by hours. Take one"
        " for such temperatures, or cool."
    ),
    "grease_under_its_limit": marked(
        "At {temperature:.4 °C} the grease is below its {least:.4 °C}: it gives off too little"
        " oil, and may not start."
    ),
    "grease_above_speed": marked("The speed is {ratio:.3} of the limiting speed with grease."),
    "oil_index_assumed": marked(
        "Grades are taken with a viscosity index of {index:.3}; oils of a higher index are thicker"
        " when hot and thinner when cold."
    ),
    "no_oil_thick_enough": marked(
        "No ISO grade is thick enough: the thickest gives κ = {kappa:.3}. Cool, or accept less"
        " with effective EP additives."
    ),
    "oil_drags_in_the_cold": marked(
        "At the coldest temperature κ is {kappa:.3}: above 4 nothing is gained, and friction rises."
    ),
}
"""By key."""
