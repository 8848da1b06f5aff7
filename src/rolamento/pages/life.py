"""The page of `life`: a statement, all theories side by side, what the life rests on, what helps.

Three figures are what a life is worth. Lives come in millions of revolutions and in hours, and
stand in tables as revolutions and seconds.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import floor, isfinite, isinf, isnan, log10, nan
from typing import TYPE_CHECKING, Final

from rolamento import document as doc
from rolamento import plots
from rolamento.life.iso16281 import THEORY as REFERENCE
from rolamento.life.iso16281_modified import THEORY as MODIFIED_REFERENCE
from rolamento.life.record import BOUNDS, OUTSIDE, note_of
from rolamento.life.theories import THEORIES
from rolamento.pages.given import case_page, head
from rolamento.pages.notes import cautions
from rolamento.units import HOUR
from rolamento.words import ABSENT, Note, manner, said
from rolamento.words.quantities import called
from rolamento.words.theories import theory_life, theory_name, theory_scope

if TYPE_CHECKING:
    from rolamento.friction import Friction
    from rolamento.life import Change, Headline, Life, LifeSummary
    from rolamento.life.rib_load import RibLoad
    from rolamento.life.row_ratings import Ratings
    from rolamento.solved import Solved

__all__ = [
    "FACTORS",
    "LONGEST_LIFE",
    "MILLION",
    "changes_section",
    "hours_text",
    "life_notes",
    "life_page",
    "life_section",
    "limit_section",
    "limiting_sentences",
    "percent",
    "rating_source",
    "ratings_section",
    "reached",
    "remarks",
    "required_sentence",
    "theories_section",
    "theory_table",
    "validity_section",
    "verdict",
]

MILLION: Final = 1e6
LIFE: Final = ".3r [10⁶ rev]"
HOURS: Final = ".3r [h]"
FACTOR: Final = ".3"
FACTORS: Final = (
    ("a_1", "a_1"),
    ("a_ISO", "a_iso"),
    ("a_2", "a_2"),
    ("a_3", "a_3"),
    ("a_NSK", "a_nsk"),
    ("κ", "viscosity_ratio"),
    ("e_C", "contamination_factor"),
)
"""Columns of the table: heading, and name in the engine."""
_CONDITIONS: Final = ("viscosity_ratio", "contamination_factor")
"""No factors of the life, and the same for all theories: they stand below the table."""
_CHOSEN: Final = "▸"
_KILO: Final = 1e3
_WORTH: Final = 1.05
_NEARLY_ALL, _HARDLY_ANY = 0.9995, 0.0005
LONGEST_LIFE: Final = 100_000.0
"""Hours from which on a machine does not end by the fatigue of this bearing."""
_FAR: Final = 1.5
"""The life over that of the catalogue, or the other way round, from which on it is explained."""
_NOTABLE: Final = 1.1
"""The same for a single factor."""


def hours_text(hours: float) -> str:
    """Return a life in hours, or in words that it is longer than what fatigue decides."""
    if hours > LONGEST_LIFE:
        return said("> {hours}", hours=int(LONGEST_LIFE))
    return said("{hours:.4r}", hours=hours)


def life_page(
    solved: Solved,
    summary: LifeSummary | None,
    changes: Sequence[Change] = (),
    figures: Sequence[doc.Figure] = (),
    friction: Friction | None = None,
) -> doc.Document:
    """Return the page of the life of one case.

    Parameters
    ----------
    solved
        What was solved: a single case.
    summary
        Its life by every theory; None without a result.
    changes
        What would help, of `rolamento.life.sensitivity`.
    figures
        Pictures of the life that need more than that, such as of life over load.
    friction
        Of the same case, of which torque and power loss are shown.
    """
    notes = solved.notes[0]
    sections: list[doc.Section] = []
    if summary is not None:
        lines = statement(solved, summary, changes)
        sections += [
            doc.Section(said("Life"), lines, "life"),
            theories_section(summary),
            validity_section(summary),
            ratings_section(summary),
            limit_section(solved, summary),
            *changes_section(summary, changes),
        ]
        if friction is not None:
            from rolamento.pages.friction import torque_and_power  # with a page that has it

            sections.append(torque_and_power(solved, friction))
        pictures = (*_charts(summary), *figures)
        sections += [doc.Section("", pictures, "figures")] * bool(pictures)
    return case_page(solved.case, head(solved), sections, "life", "theories", notes=notes)


def _charts(summary: LifeSummary) -> Iterator[doc.Figure]:
    """Show a_ISO where κ and e_C are known."""
    if summary.contamination_factor is None:
        return

    yield doc.Figure(
        said("a_ISO for the film and the cleanliness"), lambda: plots.aiso_chart(summary), "aiso"
    )


# --- numbers -----------------------------------------------------------------------------------


def percent(share: float) -> str:
    """Write a share or a reliability that was found, with three figures; nearly all is not all."""
    if isnan(share):
        return ABSENT
    if _NEARLY_ALL <= share < 1.0:
        return said("more than {value:.3 %}", value=0.999)
    if 0.0 < share < 2.0 * _HARDLY_ANY:
        return said("less than {value:.3 %}", value=0.001)
    return said("{share:.3 %}", share=share)


def _unit_of_force(values: Iterable[float]) -> str:
    """Return the unit of forces that stand below each other; values in N."""
    greatest = max((abs(value) for value in values if isfinite(value)), default=0.0)
    return "kN" if greatest >= _KILO else "N"


def _force(value: float, unit: str) -> doc.Number:
    """Write a force with four figures and no more than three decimals."""
    scaled = abs(value) / (_KILO if unit == "kN" else 1.0)
    small = isfinite(scaled) and 0.0 < scaled < 1.0
    figures = max(4 + floor(log10(scaled)), 1) if small else 4
    return doc.Number(value, f".{figures} [{unit}]")


# --- notes -------------------------------------------------------------------------------------


def remarks(found: Iterable[tuple[str, Note, str]], count: int) -> tuple[doc.Block, ...]:
    """List what refuses theories, then what they leave out.

    Parameters
    ----------
    found
        Theory, note, and where it holds, if not everywhere.
    count
        How many theories there are.
    """
    about: dict[tuple[Note, str], list[str]] = {}
    for theory, note, place in found:
        about.setdefault((note, place), []).append(theory)
    refused: list[doc.Block] = []
    noted: list[doc.Remark] = []
    for (note, place), theories in about.items():
        every = len(theories) == count > 1
        names = said("all theories") if every else "; ".join(map(theory_name, theories))
        if place:
            names = said("{theories}, {place}", theories=names, place=place)
        text = note.text
        if note.key in OUTSIDE:
            text = said("not valid ({theories}): {reason}", theories=names, reason=text)
            refused.append(doc.Statement(text, "warning", indent=2, mark="✗"))
        else:
            noted.append(
                doc.Remark(said("{theories}: {remark}", theories=names, remark=text), note.key)
            )
    return (*refused, *([doc.Notes(tuple(noted))] if noted else []))


def verdict(valid: bool, below: bool) -> str:
    """Say in a word whether a theory is valid, or gives an upper bound of the life."""
    if below:
        return said("bound")
    return said("yes") if valid else said("no")


# --- the statement -----------------------------------------------------------------------------


def statement(
    solved: Solved, summary: LifeSummary, changes: Sequence[Change] | None = None
) -> tuple[doc.Block, ...]:
    """State the life that leads, or its bound and the reason; warn if nothing does.

    changes: what would help; None where nobody looked, and what costs most is said instead.
    """
    leading = summary.headline
    if not leading.leads[0]:
        sentences = _warning(summary)
    elif isinf(leading.life[0]):
        sentences = [_endless(solved, leading), *_required(summary)]
    else:
        sentences = [_life(solved, leading), *_bounded(leading), *_beyond_fatigue(leading)]
        sentences += [*_beside_the_catalogue(summary), *_limit(solved, summary)]
        sentences += [*_help(summary, changes), *_required(summary)]
    first, *others = (doc.Statement(text, tone, indent=2) for text, tone in sentences)
    return (first, *cautions(summary.qualifications()), *others)


_Sentence = tuple[str, doc.Tone]


def reached(
    theory: str, life: float, hours: float, reliability: float, what: str, *, below: bool = False
) -> str:
    """Say how long something runs, by a theory; life in millions of revolutions.

    below: whether these are bounds that it does not reach.
    """
    values = {
        "reliability": reliability,
        "what": what,
        "hours": hours * HOUR,
        "life": life * MILLION,
        "theory": theory_life(theory),
    }
    if below and isfinite(hours):
        return said(
            "With {reliability:.7 %} reliability {what} reaches less than {hours:.3r h}, "
            "{life:.3r [10⁶ rev]} million revolutions (upper bound of the {theory}).",
            **values,
        )
    if below:
        return said(
            "With {reliability:.7 %} reliability {what} reaches less than {life:.3r [10⁶ rev]} "
            "million revolutions (upper bound of the {theory}); nothing turns, so there are no "
            "hours.",
            **values,
        )
    if isfinite(hours):
        return said(
            "With {reliability:.7 %} reliability {what} reaches {hours:.3r h}, "
            "{life:.3r [10⁶ rev]} million revolutions ({theory}).",
            **values,
        )
    return said(
        "With {reliability:.7 %} reliability {what} reaches {life:.3r [10⁶ rev]} million "
        "revolutions ({theory}); nothing turns, so there are no hours.",
        **values,
    )


def required_sentence(required: float, reliability: float, *, below: bool = False) -> str:
    """Say with which reliability a required life (s) is reached, or below which."""
    values = {"life": required, "reliability": percent(reliability)}
    if below:
        return said("Reliability at the required {life:.3r h}: below {reliability}.", **values)
    return said("Reliability at the required {life:.3r h}: {reliability}.", **values)


def _what(solved: Solved) -> str:
    bearing = solved.case.bearing
    is_set = bearing.is_set and bearing.rows_of_one_bearing == 1
    return said("this set") if is_set else said("this bearing")


def _life(solved: Solved, leading: Headline) -> _Sentence:
    theory, life, hours = str(leading.theory[0]), float(leading.life[0]), float(leading.hours[0])
    below = bool(leading.below[0])
    text = reached(theory, life, hours, leading.reliability, _what(solved), below=below)
    return text, "strong"


def _endless(solved: Solved, leading: Headline) -> _Sentence:
    theory = theory_life(str(leading.theory[0]))
    text = said("Fatigue does not end the life of {what} ({theory}).", what=_what(solved),
                theory=theory)  # fmt: skip
    return text, "strong"


def _beyond_fatigue(leading: Headline) -> list[_Sentence]:
    """Say of a life that no machine reaches that something else will end it."""
    if leading.below[0] or not leading.hours[0] > LONGEST_LIFE:
        return []
    text = said("More than {hours:.3r h}: fatigue will not end it.", hours=LONGEST_LIFE * HOUR)
    return [(text, "")]


def _beside_the_catalogue(summary: LifeSummary) -> list[_Sentence]:
    """Say why a life is far from L_10, by the factors between the two."""
    leading, basic = summary.headline, summary.theories.get("iso281")
    if basic is None or not basic.valid[0] or not leading.valid[0]:
        return []
    rating, life = float(basic.basic[0]), float(leading.life[0])
    ratio = life / rating if rating > 0.0 else nan
    if not isfinite(ratio) or 1.0 / _FAR < ratio < _FAR:
        return []
    hours = rating * float(basic.hours[0]) / float(basic.life[0])
    values = {
        "life": said("{hours:.3r h}", hours=hours * HOUR)
        if isfinite(hours)
        else said("{life:.3r [10⁶ rev]} million revolutions", life=rating * MILLION),
        "ratio": ratio,
        "reasons": "; ".join(_reasons(summary, rating)),
    }
    if leading.element == "ball":
        text = said(
            "The catalogue life L_10 = (C/P)³ is {life}. This one is {ratio:.3} times as long: "
            "{reasons}.",
            **values,
        )
    else:
        text = said(
            "The catalogue life L_10 = (C/P)^(10/3) is {life}. This one is {ratio:.3} times as "
            "long: {reasons}.",
            **values,
        )
    return [(text, "")]


def _reasons(summary: LifeSummary, rating: float) -> Iterator[str]:
    """Name the factors between the life of the catalogue and that which leads."""
    leading = summary.headline
    own = summary.theories[str(leading.theory[0])]
    reliability, modification = (float(own.factors.get(n, [1.0])[0]) for n in ("a_1", "a_iso"))
    if not _alike(modification):
        values = {
            "factor": modification,
            "kappa": float(own.factors["viscosity_ratio"][0]),
            "clean": float(own.factors["contamination_factor"][0]),
        }
        costliest = str(summary.limit.factor[0])
        if modification > 1.0:
            yield said(
                "low load, film and cleanliness (a_ISO = {factor:.3}, κ = {kappa:.3}, "
                "e_C = {clean:.3})",
                **values,
            )
        elif costliest == "contamination":
            yield said(
                "contamination (a_ISO = {factor:.3}, κ = {kappa:.3}, e_C = {clean:.3})", **values
            )
        elif costliest == "viscosity_ratio":
            yield said(
                "thin lubricant film (a_ISO = {factor:.3}, κ = {kappa:.3}, e_C = {clean:.3})",
                **values,
            )
        else:
            yield said(
                "load, film and cleanliness (a_ISO = {factor:.3}, κ = {kappa:.3}, "
                "e_C = {clean:.3})",
                **values,
            )
    if not _alike(reliability):
        yield said(
            "reliability of {reliability:.7 %} (a_1 = {factor:.3})",
            reliability=leading.reliability,
            factor=reliability,
        )
    shared = float(own.basic[0]) / rating
    if not _alike(shared) and leading.element == "ball":
        yield said("load distribution among the balls (factor {factor:.3})", factor=shared)
    elif not _alike(shared):
        yield said(
            "load distribution among the rollers and along them (factor {factor:.3})", factor=shared
        )


def _alike(factor: float) -> bool:
    return 1.0 / _NOTABLE < factor < _NOTABLE


def limiting_sentences(solved: Solved, summary: LifeSummary) -> list[str]:
    """Say in sentences which race limits a single case's life, and what costs most of it."""
    cost = _cost(summary)
    return [*(text for text, _ in _limit(solved, summary)), *([cost] if cost else [])]


def _limit(solved: Solved, summary: LifeSummary) -> list[_Sentence]:
    race, row = str(summary.limit.race[0]), int(summary.limit.row[0])
    if not race:
        return []
    inner = race == "inner"
    if not solved.case.bearing.is_set:
        text = said("The inner race limits it.") if inner else said("The outer race limits it.")
    elif inner:
        text = said("The inner race of row {row} limits it.", row=row)
    else:
        text = said("The outer race of row {row} limits it.", row=row)
    return [(text, "")]


def _help(summary: LifeSummary, changes: Sequence[Change] | None) -> list[_Sentence]:
    """Name the change that helps most; where none was tried, what costs most."""
    if changes is None:
        cost = _cost(summary)
        return [(cost, "")] if cost else []
    known = [change for change in changes if isfinite(change.life_ratio)]
    if not known:
        return []
    best = max(known, key=lambda change: change.life_ratio)
    if best.life_ratio < _WORTH:
        return [(said("None of the changes below extends the life by 5 %."), "")]
    return [(_helps(best.name, best.life_ratio), "")]


def _helps(change: str, ratio: float) -> str:
    return {
        "less_load": said("10 % less load would help most: life × {ratio:.3}.", ratio=ratio),
        "less_clearance": said(
            "5 µm less clearance would help most: life × {ratio:.3}.", ratio=ratio
        ),
        "more_clearance": said(
            "5 µm more clearance would help most: life × {ratio:.3}.", ratio=ratio
        ),
        "thicker_oil": said("A thicker oil would help most: life × {ratio:.3}.", ratio=ratio),
        "cleaner_oil": said("Cleaner oil would help most: life × {ratio:.3}.", ratio=ratio),
        "less_tilt": said("Half the tilt would help most: life × {ratio:.3}.", ratio=ratio),
        "profiled_rollers": said(
            "Rollers with a logarithmic profile would help most: life × {ratio:.3}.", ratio=ratio
        ),
    }[change]


def _cost(summary: LifeSummary) -> str:
    """Say which of oil, contamination and load costs most; empty where lubrication is unknown."""
    name = str(summary.limit.factor[0])
    if not name or summary.viscosity_ratio is None or summary.contamination_factor is None:
        return ""
    if name == "viscosity_ratio":
        kappa = float(summary.viscosity_ratio[0])
        return said("The thin lubricant film costs the most life (κ = {kappa:.3}).", kappa=kappa)
    if name == "contamination":
        clean = float(summary.contamination_factor[0])
        return said("Contamination costs the most life (e_C = {clean:.3}).", clean=clean)
    return said("The load governs: neither thicker nor cleaner oil would give +50 % life.")


def _required(summary: LifeSummary) -> list[_Sentence]:
    """Say how reliable the required life is, if there is one and the theory for it is valid."""
    required = summary.conditions.required_life
    if required is None:
        return []
    reliability = float(summary.reliability_after(required)[0])
    if not isfinite(reliability):
        return []
    below = bool(summary.headline.below[0])
    return [(required_sentence(required, reliability, below=below), "")]


def _bounded(leading: Headline) -> list[_Sentence]:
    """Say why the life is but a bound."""
    reason = leading.reason_of() if leading.below[0] else None
    return [] if reason is None else [(reason.text, "warning")]


def _warning(summary: LifeSummary) -> list[_Sentence]:
    """Say that there is no life to go by, why not, and what the numbers are."""
    best = summary.theories.get(MODIFIED_REFERENCE.name, summary[REFERENCE.name])
    notes = {note.key: note.text for note in best.notes_of()}
    if "unloaded" in notes:
        return [(notes["unloaded"], "strong")]
    none = none_valid(best.element)
    found: list[_Sentence] = [(none, "bad-strong")]
    found += [(text, "") for key, text in notes.items() if key in OUTSIDE - BOUNDS]
    if any(isfinite(float(life.life[0])) for life in summary.theories.values()):
        found.append((formulas_only(), "strong"))
    return found


def none_valid(element: str) -> str:
    """Say that nothing leads; element: as of `Life`."""
    if element == "ball":
        return said("No theory that considers the load of every ball is valid for this case.")
    return said("No theory that considers the load of every element is valid for this case.")


def formulas_only() -> str:
    """Say what numbers are worth that no valid theory gives."""
    return said("The numbers below are what the formulas give; do not rely on them.")


# --- the theories ------------------------------------------------------------------------------


def theories_section(summary: LifeSummary) -> doc.Section:
    """Set the theories side by side, and say for what reliability."""
    legend = doc.Statement(_legend(summary), "faint", indent=2)
    blocks = (theory_table(summary, "theories"), *_conditions(summary), legend)
    return doc.Section(said("Life by theory"), blocks, "theories")


def _chosen(summary: LifeSummary) -> Life | None:
    """The most complete of the valid theories, if one leads."""
    leading = summary.headline
    return summary.theories.get(str(leading.theory[0])) if leading.leads[0] else None


def theory_table(summary: LifeSummary, name: str) -> doc.Table:
    """Set the theories side by side: lives, factors, and whether each is valid for the case."""
    chosen, lives = _chosen(summary), list(summary.theories.values())
    tones: list[doc.Tone] = [
        "strong" if life is chosen else "" if life.valid[0] or life.below[0] else "faint"
        for life in lives
    ]
    columns = [
        doc.Column(
            "", [_CHOSEN if life is chosen else "" for life in lives], "leads", tone="good-strong"
        ),
        doc.Column("", [theory_name(life.theory) for life in lives], "theory", tones=tones),
        *life_columns(
            [float(life.life[0]) for life in lives], [float(life.hours[0]) for life in lives], tones
        ),
        *_factor_columns(lives, tones),
    ]
    judged = [(bool(life.valid[0]), bool(life.below[0])) for life in lives]
    columns.append(
        doc.Column(
            said("valid here"),
            [verdict(*one) for one in judged],
            "valid",
            tones=["good" if valid else "warning" for valid, _ in judged],
        )
    )
    return doc.Table(tuple(columns), name, fixed=2, units="behind", indent=0)


def life_columns(
    lives: Sequence[float], hours: Sequence[float], tones: Sequence[doc.Tone] = ()
) -> tuple[doc.Column, doc.Column]:
    """Return the columns of lives in millions of revolutions and in hours."""
    return (
        doc.Column(
            "", [life * MILLION for life in lives], "life", "10⁶ rev", form=LIFE, tones=tones
        ),
        doc.Column("", [life * HOUR for life in hours], "hours", "h", form=HOURS, tones=tones),
    )


def _factor_columns(lives: Sequence[Life], tones: Sequence[doc.Tone]) -> Iterator[doc.Column]:
    for symbol, name in FACTORS:
        if any(name in life.factors for life in lives):
            values: list[doc.CellContent] = [
                float(life.factors[name][0]) if name in life.factors else None for life in lives
            ]
            yield doc.Column(
                symbol, values, name, form=FACTOR, tones=tones, only_in_files=name in _CONDITIONS
            )


def _conditions(summary: LifeSummary) -> list[doc.Block]:
    """Write κ and e_C, which no theory has otherwise than the others."""
    found = ((name, getattr(summary, name)) for name in _CONDITIONS)
    known = [
        f"{called(name)} = {manner().number(float(value[0]), FACTOR)}"
        for name, value in found
        if value is not None
    ]
    return [doc.Statement(", ".join(known), indent=2)] if known else []


def _legend(summary: LifeSummary) -> str:
    lives = list(summary.theories.values())
    reliability = said("for {reliability:.7 %} reliability", reliability=lives[0].reliability)
    parts = [reliability]
    if any(life.below[0] for life in lives):
        parts.append(said("bound: the life is below the number"))
    if _chosen(summary) is not None:
        parts.append(said("▸ most complete valid theory"))
    return "; ".join(parts)


def validity_section(summary: LifeSummary) -> doc.Section:
    """Say what every theory is for, then what stands against it here, and what it leaves out."""
    lives = list(summary.theories.values())
    entries = tuple(
        doc.Entry(theory_name(life.theory), theory_scope(life.theory, life.element), "faint")
        for life in lives
    )
    found = [(life.theory, note, "") for life in lives for note in life.notes_of()]
    blocks = (doc.KeyValues(entries, 2, label_tone=""), *remarks(found, len(lives)))
    return doc.Section(said("Scope of each theory"), blocks, "validity")


# --- what it rests on --------------------------------------------------------------------------


def ratings_section(summary: LifeSummary) -> doc.Section:
    """Show ratings with their sources, and the loads that stand against them."""
    ratings, loads = summary.ratings, summary.loads
    load = float(loads.dynamic[0])
    dynamic = float(ratings.dynamic_of_set[0])
    axial = "a" if ratings.is_axial else ""
    rows = [
        (symbol, float(values[0]), rating_source(summary, name))
        for symbol, name, values in (
            (f"C{'_a' if axial else ''}", "dynamic", ratings.dynamic_of_set),
            (f"C_0{axial}", "static", ratings.static_of_set),
            ("C_u", "fatigue", ratings.fatigue_of_set),
        )
    ]
    if ratings.mixed:
        rows = [*_ratings_of_rows(ratings)]
    if isfinite(load):
        values = {
            "x": float(loads.radial_factor[0]),
            "y": float(loads.axial_factor[0]),
            "e": float(loads.limit[0]),
            "ratio": dynamic / load if load > 0.0 else nan,
        }
        text = (
            said("X = {x:.3}, Y = {y:.3}, e = {e:.3}, the maker's; C/P = {ratio:.3}", **values)
            if loads.listed
            else said("X = {x:.3}, Y = {y:.3}, e = {e:.3}; C/P = {ratio:.3}", **values)
        )
        rows.append((f"P{'_a' if axial else ''}", load, text))
        rows.append((f"P_0{axial}", float(loads.static[0]), _safety(float(loads.safety[0]))))
    reference = float(summary.reference_load[0])
    if isfinite(reference):
        text = said("equivalent load whose rating life is the reference life")
        rows.append(("P_ref", reference, text))
    if summary.rib_load is not None:
        rows.append(_permissible(summary.rib_load))
    unit = _unit_of_force(value for _, value, _ in rows)
    columns = (
        doc.Column("", [symbol for symbol, _, _ in rows], "symbol"),
        doc.Column(
            "",
            [_force(value, unit) for _, value, _ in rows],
            "value",
            unit,
            tone="strong",
            align="right",
        ),
        doc.Column("", [unit for _ in rows], "unit"),
        doc.Column("", [text for _, _, text in rows], "source", tone="faint"),
    )
    table = doc.Table(columns, "ratings", headless=True)
    return doc.Section(said("Ratings and loads"), (table,), "ratings")


def _ratings_of_rows(ratings: Ratings) -> Iterator[tuple[str, float, str]]:
    """Ratings of the rows of a set that has balls and rollers, and none of its own."""
    for index in range(len(ratings.kinds)):
        for symbol, values in (
            ("C", ratings.dynamic), ("C_0", ratings.static), ("C_u", ratings.fatigue)
        ):  # fmt: skip
            yield symbol, float(values[0, index]), said("of row {row}", row=index)


def _permissible(load: RibLoad) -> tuple[str, float, str]:
    """How much axial load the ribs may carry for long, beside what they do."""
    values = {"axial": float(load.axial[0]), "nsk": float(load.nsk[0]), "skf": float(load.skf[0])}
    both = isfinite(values["nsk"])
    text = (
        said(
            "axial load that the ribs may carry continuously: {nsk:.4 N} by NSK, {skf:.4 N} by "
            "SKF; they carry {axial:.4 N}",
            **values,
        )
        if both
        else said(
            "axial load that the ribs may carry continuously, by SKF; they carry {axial:.4 N}",
            **values,
        )
    )
    return "F_ap", float(load.permissible[0]), text


def rating_source(summary: LifeSummary, rating: str) -> str:
    """Say where C, C_0 or C_u of the first case comes from: the catalogue's source, or how.

    rating: ``"dynamic"``, ``"static"`` or ``"fatigue"``.
    """
    text, share = _rating_source(summary, rating), summary.ratings.static_share
    own = ("given", "contacts")
    if share == 1.0 or rating == "dynamic" or summary.rating_sources[rating] in own:
        return text
    return said("{source}; × {share:.3}, stiffness of the elements", source=text, share=share)


def _rating_source(summary: LifeSummary, rating: str) -> str:
    ratings, source = summary.ratings, summary.rating_sources[rating]
    if not isfinite(getattr(ratings, f"{rating}_of_set")[0]):
        return said("not known")
    if source == "estimate" and ratings.fatigue_by_contacts is not None:
        own = float(ratings.fatigue_by_contacts[0])
        return (
            said(
                "estimate C_0/8.2, ISO 281; by its contacts this interior has {own:.4 [kN]} kN",
                own=own,
            )
            if ratings.rollers.all()
            else said(
                "estimate C_0/22, ISO 281; by its contacts this interior has {own:.4 [kN]} kN",
                own=own,
            )
        )
    return {
        "given": said("given"),
        "geometry": said("from the geometry, ISO 281")
        if rating == "dynamic"
        else said("from the geometry, ISO 76"),
        "contacts": said("where the weaker race reaches 1500 MPa, ISO 281"),
    }.get(source, source)


def _safety(safety: float) -> str:
    if not isfinite(safety):
        return ""
    return said("static safety factor C_0/P_0 = {safety:.3}", safety=safety)


def limit_section(solved: Solved, summary: LifeSummary) -> doc.Section:
    """Name the race that fails first, its heaviest element, and what costs most."""
    limit, element = summary.limit, summary.headline.element
    race, ball = str(limit.race[0]), int(limit.ball[0])
    if not race:
        texts = [note_of("unloaded", element).text]
    else:
        texts = [_share(race, int(limit.row[0]), float(limit.share[0]), solved)]
        if ball >= 0:
            contacts = solved.inner if race == "inner" else solved.outer
            values = {
                "ball": ball,
                "azimuth": float(solved.elements.azimuth[0, ball]),
                "load": float(contacts.load[0, ball]),
            }
            texts.append(
                said("Highest load on it: {load:.4 N}, ball {ball} at {azimuth:.5 °}.", **values)
                if solved.rows.element[int(limit.row[0])] == "ball"
                else said(
                    "Highest load on it: {load:.4 N}, roller {ball} at {azimuth:.5 °}.", **values
                )
            )
        texts.append(_cost(summary))
    blocks = tuple(doc.Statement(text, indent=2) for text in texts if text)
    return doc.Section(said("What limits it"), blocks, "limit")


def _share(race: str, row: int, share: float, solved: Solved) -> str:
    values = {"share": percent(share), "row": row}
    if solved.case.bearing.is_set:
        if race == "inner":
            return said(
                "The inner race of row {row} contributes {share} of the failure probability.",
                **values,
            )
        return said(
            "The outer race of row {row} contributes {share} of the failure probability.", **values
        )
    if race == "inner":
        return said("The inner race contributes {share} of the failure probability.", **values)
    return said("The outer race contributes {share} of the failure probability.", **values)


def changes_section(summary: LifeSummary, changes: Sequence[Change]) -> list[doc.Section]:
    """Show the life after each change over that before; nothing if none is known."""
    known = [change for change in changes if isfinite(change.life_ratio)]
    if not known:
        return []
    bars = doc.Bars(
        bars=tuple(
            doc.Bar(
                change.note.text,
                doc.Number(change.life_ratio, FACTOR, before="× "),
                max(change.life_ratio - 1.0, 0.0),
                "strong" if change.life_ratio > 1.0 else "",
            )
            for change in known
        ),
        key="changes",
        legends=(
            said(
                "life after one change over the life before, by the {theory}",
                theory=theory_life(str(summary.headline.theory[0])),
            ),
        ),
        tone="good",
    )

    figure = doc.Figure(said("What would help"), lambda: plots.helps_figure(changes), "helps")
    return [doc.Section(said("What would help"), (bars, figure), "changes")]


# --- beside the state of a bearing -------------------------------------------------------------


def life_section(solved: Solved, summary: LifeSummary) -> doc.Section:
    """Show the statement, the lives by the standards, and how far the loads are from the ratings.

    All theories and what would help are for a page of their own.
    """
    loads = summary.loads
    turns = any(not isnan(life.hours[0]) for life in summary.theories.values())
    numbers = [
        text for life in _standard_lives(summary) for text in [_shortly(life, hours=turns)] if text
    ]
    load = float(loads.dynamic[0])
    if load > 0.0:
        ratio = float(summary.ratings.dynamic_of_set[0]) / load
        numbers.append(said("C/P = {ratio:.3}", ratio=ratio))
    numbers += [text for text in [_safety(float(loads.safety[0]))] if text]
    blocks: list[doc.Block] = list(statement(solved, summary))
    if numbers:
        blocks.append(doc.Statement("; ".join(numbers), indent=2))
    hint = said("all theories, and what would help: `rolamento life`")
    blocks.append(doc.Statement(hint, "faint", indent=2))
    return doc.Section(said("Life"), tuple(blocks), "life")


def _shortly(life: Life, *, hours: bool) -> str:
    """A life by a theory in a word; empty without one."""
    value = float(life.hours[0]) * HOUR if hours else float(life.life[0]) * MILLION
    if isnan(value):
        return ""
    text = manner().number(value, ".3r h" if hours else ".3r 10⁶ rev")
    return f"{theory_name(life.theory)}: {'<' * bool(life.below[0])}{text}"


def life_notes(summary: LifeSummary) -> list[Note]:
    """Return what is to be known of the lives that are shown beside the one that leads, once."""
    leading = {note.key for note in summary.qualifications()}
    notes = [note for life in _standard_lives(summary) for note in life.notes_of()]
    return list({note.key: note for note in notes if note.key not in leading}.values())


def _standard_lives(summary: LifeSummary) -> list[Life]:
    return [summary[name] for name in summary.theories if THEORIES[name].standard]
