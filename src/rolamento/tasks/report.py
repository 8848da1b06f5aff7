"""What a report of one case or several rests on: inputs with their origins, results, checks."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from dataclasses import asdict
from datetime import date
from functools import cached_property
from math import inf, isfinite
from typing import TYPE_CHECKING, Any, Final, Literal, NamedTuple

import numpy as np

from rolamento.analysis import Analysis, analyse
from rolamento.analysis.needs import has_life, has_oil
from rolamento.case import Case, case_of, is_designation, parse_case
from rolamento.case.case import BearingLike
from rolamento.case.duty import SHORT_NAMES
from rolamento.case.fields import Changes, Field, of_elements
from rolamento.case.film_model import FilmModel
from rolamento.case.life_model import LifeModel
from rolamento.case.report import ReportHead
from rolamento.case.variant import Variant, cases_compared, with_the_case
from rolamento.contact.line import PRESSURE_LIMIT
from rolamento.errors import InputError
from rolamento.io.json import dumps, plain
from rolamento.io.text import format_of_path, format_of_text, parse_mapping, read_text
from rolamento.life.iso281 import MAXIMUM_LOAD
from rolamento.lubrication.film_thickness import COMPUTED_RANGE
from rolamento.records import frozen
from rolamento.solved import RACES
from rolamento.solved.notes import (
    SPEED_LIMIT,
    TILT_LIMIT,
    misalignment,
    pressure_limit,
    usual_misalignments,
)
from rolamento.studies.names import setting_name
from rolamento.units import Dimension
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.analysis.speed_limits import LimitName, SpeedLimit
    from rolamento.electrical import BearingElectrics
    from rolamento.heat import HeatBalance
    from rolamento.safety import StaticSafety

__all__ = [
    "MOST_CASES",
    "CaseReport",
    "Check",
    "Input",
    "Origin",
    "Report",
    "analysis_of",
    "calculation_report",
    "checksum_of",
    "compare_variants",
    "inputs_of",
    "names_in",
    "number_of_field",
    "with_life",
]

SCHEMA: Final = 3
MOST_CASES: Final = 20

Origin = Literal[
    "given", "set", "published", "inferred", "assumed", "designation", "data", "default"
]
"""Where an input comes from: the case file, a setting of the command line, a maker's catalogue, the
ratings, common practice, the letters of the designation, a data file of the program, a default."""

_FORCES: Final = ("kN", "N")
_UNITS: Final[Mapping[str, str]] = {
    "mm": "mm", "um": "µm", "m": "m", "deg": "°", "rpm": "rpm", "N": "N", "kN": "kN",
    "N m": "N·m", "N mm": "N·mm", "GPa": "GPa", "MPa": "MPa", "kg/m^3": "kg/m³",
    "degC": "°C", "mm^2/s": "mm²/s", "1/GPa": "1/GPa", "W/m/K": "W/(m·K)", "1/K": "10⁻⁶/K",
    "h": "h", "Hz": "Hz",
}  # fmt: skip
"""How a reader's unit is written, by how a case file writes it."""
_OF_DIMENSION: Final[Mapping[Dimension, str]] = {"length": "mm", "angle": "°", "force": "N"}
_OF_FRICTION_CONTROL: Final = ("cage_drag", "mesh", "traction", "film_in_contact")
_SIZES: Final = ("bore", "outside_diameter")


@frozen
class Input:
    """One field of a case.

    Attributes
    ----------
    field
        its dotted name
    value
        in SI; what is no number as a case file has it
    unit
        in which people read it, of `rolamento.words.UNITS`; empty without one
    origin
        see `Origin`
    source
        of what is published, inferred or on file
    """

    field: str
    value: float | int | bool | str
    unit: str
    origin: Origin
    source: str = ""


@frozen
class Check:
    """A limit of a model, and where the case stands.

    Attributes
    ----------
    name
        such as ``"pressure"``
    least, greatest
        of the case, SI
    low, high
        the limits, SI; None where there is none
    """

    name: str
    least: float
    greatest: float
    low: float | None = None
    high: float | None = None

    @property
    def met(self) -> bool:
        """Whether the case lies within the limits."""
        above = self.low is None or self.least >= self.low
        return above and (self.high is None or self.greatest <= self.high)


@frozen(slots=False)
class CaseReport:
    """One case of a report.

    Attributes
    ----------
    name
        A, B, C …; of a variant its own
    source
        the file, or the designation, that it was read from; empty of a `Case`
    case
        as given, before mounting
    inputs
        what the case says, and what it does not and still counts
    analysis
        solved, with film, friction, life
    """

    name: str
    source: str
    case: Case
    inputs: tuple[Input, ...]
    analysis: Analysis

    def _shown(self) -> dict[str, str]:
        return {"": self.title, **self.analysis._shown(), "checksum": self.checksum[:12]}

    @property
    def title(self) -> str:
        """The title of the case, or what it was read from."""
        return self.case.title or os.path.basename(self.source)

    @property
    def converged(self) -> bool:
        """Whether there is a result."""
        return bool(self.analysis.solved.converged[0])

    @cached_property
    def clearance(self) -> Any:
        """The chain of clearances (`OperatingClearance`) of a mounted bearing; else None.

        Of a set that of its first row.
        """
        if self.case.mounting is None:
            return None
        from rolamento.tasks.clearance import mounted_clearance

        return mounted_clearance(self.case).rows[0]

    @cached_property
    def static_safety(self) -> StaticSafety | None:
        """Static safety of a case that asks for it with [static], and has a result; else None."""
        if self.case.static is None or not self.converged:
            return None
        from rolamento.safety import static_safety_of

        return static_safety_of(self.analysis.solved)

    @cached_property
    def electrics(self) -> BearingElectrics | None:
        """The bearing as an electrical part, of a case with [electrical] and a film; else None."""
        if self.case.electrical is None or self.analysis.film is None:
            return None
        from rolamento.electrical import electrics_of

        return electrics_of(self.analysis.solved, self.analysis.film)

    @cached_property
    def service_life(self) -> Any:
        """What ends it first (`ServiceLife`), where that may be another thing than fatigue."""
        from rolamento.tasks.time_line import service_life_of

        if not self.converged:
            return None
        found = service_life_of(self.analysis)
        return found if found.beside_fatigue else None

    @cached_property
    def heat(self) -> HeatBalance | None:
        """The heat balance of a case with a [heat] table; else None."""
        if self.case.heat is None:
            return None
        from rolamento.tasks.heat import balance_of

        return balance_of(self.case)

    @cached_property
    def speed_limit(self) -> SpeedLimit | None:
        """What the speed is held against: a maker's limit with its lubricant, else ISO 15312's.

        None at rest, and where none is known.
        """
        from rolamento.analysis.speed_limits import limiting_speeds

        try:
            limits = {one.name: one for one in limiting_speeds(self.case)}
        except InputError:  # different rolling elements have no limit together
            return None
        oil, film = self.case.lubricant, self.case.film
        first: tuple[LimitName, ...] = ("catalogue", "oil_bath")
        if oil is not None and oil.kind == "grease":
            first = ("grease",)
        elif film is not None and film.supply == "oil_air":
            first = ("high_speed", *first)
        known = (limits[name] for name in (*first, "reference") if name in limits)
        return next((one for one in known if one.share > 0.0), None)

    @cached_property
    def checksum(self) -> str:
        """SHA-256 of the normalised inputs."""
        return checksum_of(self.case)

    @cached_property
    def checks(self) -> tuple[Check, ...]:
        """Limits of the models, and where the case stands; empty without a result."""
        return tuple(_checks(self.analysis)) if self.converged else ()

    @cached_property
    def numbers(self) -> Mapping[str, Any]:
        """Everything as plain mappings and lists in SI; the numbers of every page and file."""
        analysis = self.analysis.to_mapping()
        analysis.pop("case")
        return {
            "name": self.name,
            "source": self.source,
            "title": self.case.title,
            "checksum": self.checksum,
            "inputs": [asdict(one) for one in self.inputs],
            "extremes": self._extremes if self.converged else None,
            "checks": [{**asdict(one), "met": one.met} for one in self.checks],
            "clearance": self._chain,
            **self._ends,
            "analysis": analysis,
            "case": self.case.to_mapping(),
        }

    def number(self, path: str) -> float | None:
        """Return a number of `numbers` by its dotted path; None where there is none."""
        found: Any = self.numbers
        for part in path.split("."):
            if isinstance(found, list) and part.isdigit() and int(part) < len(found):
                found = found[int(part)]
            elif isinstance(found, Mapping):
                found = found.get(part)
            else:
                return None
        known = isinstance(found, int | float) and not isinstance(found, bool)
        return float(found) if known else None

    def extreme(self, name: str) -> float | None:
        """Return a number of the heaviest contacts by its name; None where there is none."""
        value = (self._brief if name in _BRIEF else self._extremes).get(name)
        return None if value is None else float(value)

    @cached_property
    def _chain(self) -> Any:
        return None if self.clearance is None else self.clearance.to_mapping()

    @cached_property
    def _ends(self) -> Mapping[str, Any]:
        found = self.service_life
        return {} if found is None else {"service_life": plain(found.to_mapping())}

    @cached_property
    def _extremes(self) -> Mapping[str, Any]:
        return _extremes(self.analysis) if self.converged else {}

    @cached_property
    def _brief(self) -> Mapping[str, Any]:
        return plain(_brief_extremes(self.analysis)) if self.converged else {}

    def input(self, field: str) -> Input | None:
        """Return the input of a field; None where the case has none."""
        return next((one for one in self.inputs if one.field == field), None)


@frozen
class Report:
    """A report of one case or several.

    Attributes
    ----------
    head
        project, author, revision, date
    cases
        in the order in which they were given; the first is what the others are compared with
    version
        of the program
    """

    head: ReportHead
    cases: tuple[CaseReport, ...]
    version: str

    def _shown(self) -> dict[str, str]:
        solved = sum(one.converged for one in self.cases)
        return {
            "": self.head.project or ", ".join(one.title for one in self.cases[:3]),
            "cases": f"{len(self.cases)}, {solved} with a result",
            **{one.name: f"{one.title or 'without a title'}" for one in self.cases[:6]},
        }

    @property
    def converged(self) -> bool:
        """Whether every case has a result."""
        return all(one.converged for one in self.cases)

    def difference(self, path: str, case: int) -> tuple[float | None, float | None]:
        """Return by how much a number of a case differs from that of the first, and its share.

        None where either has no such number; no share of zero, nor of temperatures.
        """
        return _difference(self.cases[0].number(path), self.cases[case].number(path))

    def input_difference(self, field: str, case: int) -> tuple[float | None, float | None]:
        """As `difference`, of an input by the name of its field."""
        return _difference(
            *(_number_of(own.input(field)) for own in (self.cases[0], self.cases[case]))
        )

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain mappings and lists in SI units, NaN as None."""
        return {
            "schema": SCHEMA,
            "kind": "report",
            "version": self.version,
            "head": self.head.to_mapping(),
            "cases": [dict(one.numbers) for one in self.cases],
            "differences": [
                {"case": self.cases[index].name, "numbers": self._differences(index)}
                for index in range(1, len(self.cases))
            ],
        }

    def to_json(self, *, indent: int | None = 2) -> str:
        """Give everything as one JSON object, in SI units."""
        return dumps(plain(self.to_mapping()), indent)

    def _differences(self, case: int) -> dict[str, dict[str, float | None]]:
        found = {}
        for path in _paths(self.cases[0].numbers, ""):
            absolute, relative = self.difference(path, case)
            if absolute is not None:
                found[path] = {"absolute": absolute, "relative": relative}
        return found


def calculation_report(
    bearings: Sequence[BearingLike],
    head: ReportHead | Mapping[str, str] | None = None,
    changes: Changes = (),
    *,
    names: Sequence[str] = (),
    changed: Sequence[Set[str]] = (),
    progress: Callable[[int, int], None] | None = None,
) -> Report:
    """Analyse cases, and gather what a report of them shows.

    Parameters
    ----------
    bearings
        Cases, their files (``"-"``: on standard input), or designations; 1 to 20.
    head
        Of the title block, over what the ``[report]`` of the first case says.
    changes
        What goes over every case, by dotted name.
    names
        Of the cases; A, B, C … if not given.
    changed
        Of each case the dotted names of what was set in it.
    progress
        Called with how many cases are done, and of how many.

    Raises
    ------
    InputError, FileError
        If there are too many cases, or one is not valid, is missing or cannot be mounted.
    """
    from rolamento import __version__

    if not 1 <= len(bearings) <= MOST_CASES:
        raise InputError(
            said("must be 1 to {most} in one report", most=MOST_CASES),
            field="case",
            value=len(bearings),
        )
    read = [_read(one, changes) for one in bearings]
    given_over = _named(changes)
    shown = frozenset(
        own.field for one in read for own in inputs_of(one.case, one.given, given_over)
    )
    cases = []
    for done, one in enumerate(read):
        if progress is not None:
            progress(done, len(read))
        own = given_over | changed[done] if changed else given_over
        inputs = inputs_of(one.case, one.given, own, shown)
        try:
            name = names[done] if names else chr(ord("A") + done)
            cases.append(_case_report(name, one, inputs))
        except InputError as error:
            raise error if error.source else error.with_details(source=one.source) from None
    if progress is not None:
        progress(len(read), len(read))
    return Report(_head(head, [one.case for one in cases]), tuple(cases), __version__)


def compare_variants(
    case: Case,
    variants: Sequence[Variant],
    *,
    progress: Callable[[int, int], None] | None = None,
) -> Report:
    """Analyse a case and its variants, side by side.

    Parameters
    ----------
    case
        What the variants begin from; the first of the report, unless a variant without changes
        stands elsewhere.
    variants
        At least one.
    progress
        As of `calculation_report`.

    Raises
    ------
    InputError
        If a variant is none of this case, or there are too many.
    """
    found = cases_compared(case, variants)
    return calculation_report(
        list(found.values()),
        names=[setting_name(name) for name in found],
        changed=[frozenset(names_in(one.changes)) for one in with_the_case(variants)],
        progress=progress,
    )


def _difference(first: float | None, own: float | None) -> tuple[float | None, float | None]:
    """By how much a number differs from the first, and that over the first."""
    if first is None or own is None or not (isfinite(first) and isfinite(own)):
        return None, None
    absolute = own - first
    return absolute, absolute / abs(first) if first != 0.0 else None


def _number_of(found: Input | None) -> float | None:
    value = None if found is None else found.value
    return float(value) if isinstance(value, int | float) and not isinstance(value, bool) else None


def analysis_of(case: Case, *, quick: bool = False) -> Analysis:
    """Analyse a case as a report does: with ratings and lives, whether it asks for them or not.

    quick: as of `rolamento.analyse`.
    """
    return analyse(with_life(case), quick=quick)


def with_life(case: Case) -> Case:
    """Return a case that asks for its life; by the defaults of [life] where it does not."""
    return case if has_life(case) else case.replace(life=LifeModel())


def _case_report(name: str, read: _Read, inputs: tuple[Input, ...]) -> CaseReport:
    return CaseReport(name, read.source, read.case, inputs, analysis_of(read.case))


def _head(given: ReportHead | Mapping[str, str] | None, cases: Sequence[Case]) -> ReportHead:
    """What the call says goes over what the first case with a [report] says."""
    own = given.to_mapping() if isinstance(given, ReportHead) else dict(given or {})
    of_case = next((case.report for case in cases if case.report is not None), None)
    fields = {} if of_case is None else of_case.to_mapping()
    fields |= {name: text for name, text in own.items() if text}
    return ReportHead(**{**fields, "date": fields.get("date") or date.today().isoformat()})


def checksum_of(case: Case) -> str:
    """Return the SHA-256 of the inputs that the results depend on, in hexadecimal.

    Values are taken in SI, with all defaults and with what a designation fills in: cases that
    differ only in units, order or comments have one checksum. Title and [report] do not count.
    """
    dumped = case.model_dump(exclude={"title", "report"}, exclude_none=True)
    text = json.dumps(dumped, sort_keys=True, separators=(",", ":"), ensure_ascii=True)
    return hashlib.sha256(text.encode()).hexdigest()


# --- inputs and their origins --------------------------------------------------------------------


class _Read(NamedTuple):
    """A case, what it was read from, and the dotted names of what it gives."""

    case: Case
    source: str
    given: frozenset[str]


def _read(bearing: BearingLike, changes: Changes) -> _Read:
    if not isinstance(bearing, str | os.PathLike):
        case = case_of(bearing, changes)
        return _Read(case, "", frozenset(_fields_set(case, "")))
    if is_designation(bearing):
        case = case_of(bearing, changes)
        return _Read(case, str(bearing), frozenset({"bearing.designation"}))
    text, source = read_text(bearing)
    form = format_of_path(bearing) or format_of_text(text)
    case = parse_case(text, format=form, source=source, overrides=changes)
    return _Read(case, source, frozenset(names_in(parse_mapping(text, form, source), "")))


def _named(changes: Changes) -> frozenset[str]:
    """Dotted names of what goes over a case."""
    names = changes if isinstance(changes, Mapping) else (one.partition("=")[0] for one in changes)
    keys = (SHORT_NAMES.get(name, name).split(".") for name in names)
    return frozenset(".".join(part.strip() for part in key) for key in keys)


def names_in(mapping: Mapping[str, Any], table: str = "") -> Iterator[str]:
    """Give the dotted names of what the tables of a case file say; table: a prefix."""
    for key, value in mapping.items():
        if isinstance(value, Mapping):
            yield from names_in(value, f"{table}{key}.")
        elif isinstance(value, list):
            yield f"{table}{key}"
            for index, item in enumerate(value):
                if isinstance(item, Mapping):
                    yield from names_in(item, f"{table}{key}.{index}.")
        else:
            yield f"{table}{key}"


def _fields_set(record: Any, table: str) -> Iterator[str]:
    """Dotted names of what a record was made with."""
    for name in record.model_fields_set:
        value = getattr(record, name)
        if hasattr(value, "model_fields_set"):
            yield from _fields_set(value, f"{table}{name}.")
        yield f"{table}{name}"


def inputs_of(
    case: Case,
    given: Set[str],
    settings: Set[str] = frozenset(),
    shown: Set[str] = frozenset(),
) -> tuple[Input, ...]:
    """Return every field of a case that has a value and matters, with its origin.

    Parameters
    ----------
    case
        Of which.
    given, settings
        Dotted names of what its file gives, and of what goes over it.
    shown
        Of what is to be shown in any case, beside other cases.
    """
    return tuple(_inputs(case, given, settings, shown))


def _inputs(case: Case, given: Set[str], settings: Set[str], shown: Set[str]) -> Iterator[Input]:
    for name, field in Case.fields().items():
        top = name.partition(".")[0]
        if top in ("title", "report") or name.endswith((".name", ".source")):
            continue
        if field.entries:
            yield from _inputs_of_list(case, field, given)
            continue
        value = _value(case, name)
        if value is None or not _matters(case, name, given | settings | shown):
            continue
        origin, source = _origin(case, name, given, settings)
        yield Input(name, value, _unit(field), origin, source)


def _inputs_of_list(case: Case, field: Field, given: Set[str]) -> Iterator[Input]:
    """The entries of a list of tables: rows one by one, points of a viscosity."""
    for index, entry in enumerate(_walk(case, field.name) or ()):
        for leaf, inner in field.entries.items():
            value = getattr(entry, leaf, None)
            if value is not None and leaf != "element":
                name = f"{field.name}.{index}.{leaf}"
                own = name in given or leaf in entry.model_fields_set
                yield Input(name, value, _unit(inner), "given" if own else "default")


def _walk(case: Case, name: str) -> Any:
    """The value of a field, what a table that is left out supplies by default included."""
    found: Any = case
    for depth, part in enumerate(name.split(".")):
        if depth == 0 and part == "life" and case.life is None:
            found = LifeModel()
        elif depth == 0 and part == "film" and case.film is None:
            found = FilmModel() if has_oil(case) else None
        else:
            found = getattr(found, part, None)  # balls have no length
        if depth == 0 and part == "lubricant" and found is not None and "." in name:
            found = found.oil if found.kind != "dry" else found
        if found is None:
            return None
    return found


def _value(case: Case, name: str) -> float | int | bool | str | None:
    found = _walk(case, name)
    if found is None or isinstance(found, bool | int | float | str):
        return found
    named = getattr(found, "name", None)  # of a material or a lubricant; others have fields
    return str(named) if named is not None else None


def number_of_field(case: Case, name: str) -> float | None:
    """Return the number that a field of a case has, SI; None where it has none."""
    found = _value(case, name)
    known = isinstance(found, int | float) and not isinstance(found, bool)
    return float(found) if known else None  # type: ignore[arg-type]


def _matters(case: Case, name: str, told: Set[str]) -> bool:
    """Whether a value counts; what is given is shown in any case."""
    if name in told:
        return True
    table, _, leaf = name.rpartition(".")
    if not of_elements(name, [place.bearing.element for place in case.bearing.places]):
        return False
    if table == "model" and leaf in _OF_FRICTION_CONTROL:
        return case.model.raceway_control == "friction"
    if name == "bearing.element" or (
        table == "bearing" and leaf in case.bearing.bearing_type.idle_fields
    ):
        return False
    if table == "life" and case.life is None:
        return leaf == "reliability"
    if table.startswith(("bearing.ball_material", "bearing.roller_material")):
        return case.bearing.element_material != case.bearing.ring_material
    if table == "lubricant" and leaf in ("base_oil", "density_temperature"):
        return False
    if table == "film":
        return has_oil(case)
    return not table.startswith("life.")


def _unit(field: Field) -> str:
    if field.dimension is None:
        return ""
    return _UNITS.get(field.shown_unit, "") or _OF_DIMENSION.get(field.dimension, "")


def _origin(case: Case, name: str, given: Set[str], settings: Set[str]) -> tuple[Origin, str]:
    parents = [name[:place] for place, sign in enumerate(name) if sign == "."]
    if name in settings:
        return "set", ""
    table, _, leaf = name.rpartition(".")
    if any(parent in settings for parent in parents):
        # constants of a material that is set by its name come from the file they are on
        source = getattr(_walk(case, table), "source", "")
        return ("data", str(source)) if source else ("set", "")
    if name in given or any(one.startswith(f"{name}.") for one in given):
        return "given", ""
    if table == "bearing.preload" and case.bearing.designation is not None:
        return "designation", ""
    bearing = case.bearing
    if table == "bearing" and leaf in bearing.origins:
        own: Any = bearing.origins[leaf]
        published = bearing.published
        sources = {} if published is None else published.sources
        of_ratings = sources.get("dynamic_rating", "")
        return own, sources.get(leaf, "") or (of_ratings if own == "inferred" else "")
    if leaf in _SIZES and table in ("mounting", "film") and bearing.published is not None:
        return "published", bearing.published.sources.get(leaf, "")
    if table == "bearing" and bearing.rows is not None and leaf in bearing.rows[0].own:
        return "given", ""  # of the first row
    holder = _walk(case, table) if table else None
    if source := getattr(holder, "source", ""):
        return "data", str(source)
    if table == "lubricant" and holder is not None:
        return "data", str(getattr(case.lubricant, "base_oil", "") or "")
    if any(parent in given for parent in parents):  # by a word, such as that of a profile
        return "given", ""
    return "default", ""


# --- checks and extremes -------------------------------------------------------------------------


def _checks(analysis: Analysis) -> Iterator[Check]:
    """Limits that the models set themselves, and where a solved case stands."""
    solved = analysis.solved
    rollers = solved.are_rollers
    for name, chosen, limit in (
        ("pressure", ~rollers, pressure_limit(solved.case)),
        ("line_pressure", rollers, PRESSURE_LIMIT),
    ):
        if chosen.any():
            pressure = [one.max_pressure[0, chosen].max() for one in solved.contacts.values()]
            yield Check(name, 0.0, float(max(pressure)), high=limit)
    tilt = max(abs(float(solved.displacement.ry[0])), abs(float(solved.displacement.rz[0])))
    yield Check("tilt", 0.0, tilt, high=TILT_LIMIT)
    if rollers.any():
        limit = min((one for one, _ in usual_misalignments(solved)), default=inf)
        yield Check("misalignment", 0.0, misalignment(solved), high=limit)
    speed = max(abs(float(solved.field(f"duty.{race}_speed")[0])) for race in RACES)
    pitch = float(solved.rows.pitch_diameter[0].max())
    yield Check("speed", 0.0, speed * pitch, high=SPEED_LIMIT)
    if analysis.life is not None:
        loads, ratings = analysis.life.loads, analysis.life.ratings
        load, rating = float(loads.dynamic[0]), float(ratings.dynamic_of_set[0])
        reference = float(analysis.life.reference_load[0])
        for name, own in (("load", load), ("reference_load", reference)):
            if isfinite(own) and rating > 0.0:
                yield Check(name, 0.0, own / rating, high=MAXIMUM_LOAD)
    if analysis.film is not None:
        films = [analysis.film.of(race) for race in RACES]
        known = np.concatenate([np.isfinite(one.central_thickness[0]) & ~rollers for one in films])
        for symbol, column in (
            ("U", "speed_parameter"),
            ("W", "load_parameter"),
            ("G", "material_parameter"),
            ("k", "ellipticity"),
        ):
            values = np.concatenate([getattr(one, column)[0] for one in films])[known]
            values = values[np.isfinite(values)]
            if values.size:
                low, high = COMPUTED_RANGE[symbol]
                least, greatest = float(values.min()), float(values.max())
                yield Check(f"film_{symbol}", least, greatest, low, high)


def _brief_extremes(analysis: Analysis) -> dict[str, float]:
    """Those of the extremes that a summary shows, which need no stress below the surface."""
    found = {"max_pressure": max(float(one.max_pressure[0].max())
                                 for one in analysis.solved.contacts.values())}  # fmt: skip
    if analysis.film is not None:
        found["film_parameter"] = float(analysis.film.minimum_film_parameter[0])
    if analysis.life is not None and (load := float(analysis.life.loads.dynamic[0])) > 0.0:
        found["load_ratio"] = float(analysis.life.ratings.dynamic_of_set[0]) / load
    return found


def _extremes(analysis: Analysis) -> dict[str, Any]:
    """The heaviest contacts of a solved case, and what a page shows beside the tables."""
    solved = analysis.solved
    loaded = {"balls": ~solved.are_rollers, "rollers": solved.are_rollers}
    found: dict[str, Any] = {
        f"loaded_{name}": int(solved.loaded[0, own].sum())
        for name, own in loaded.items()
        if own.any()
    }
    for race, contacts in solved.contacts.items():
        for name in ("load", "max_pressure", "max_shear", "orthogonal_shear"):
            found[f"{race}_{name}"] = float(getattr(contacts, name)[0].max())
        place = int(np.argmax(contacts.max_pressure[0]))
        found[f"{race}_{'roller' if solved.are_rollers[place] else 'ball'}"] = place
        found[f"{race}_azimuth"] = float(solved.elements.azimuth[0, place])
        for name in (
            "semi_major", "semi_minor", "contact_angle", "max_shear_depth",
            "orthogonal_shear_depth", "deflection",
        ):  # fmt: skip
            found[f"{race}_{name}"] = float(getattr(contacts, name)[0, place])
        bearing = solved.loaded[0] if solved.loaded[0].any() else slice(None)
        found[f"{race}_spin_to_roll"] = float(np.abs(contacts.spin_to_roll[0][bearing]).max())
    found["centrifugal_force"] = float(solved.elements.centrifugal_force[0].max())
    if solved.rollers is not None:
        found["roller_tilt"] = float(np.nanmax(np.abs(solved.rollers.tilt[0])))
        found["rib_force"] = float(np.nanmax(np.abs(solved.rollers.rib_force[0])))
    film = analysis.film
    if film is not None:
        for race in RACES:
            element = film.thinnest(race)
            if element is not None:
                own = film.of(race)
                for name in _OF_FILM:
                    found[f"{race}_{name}"] = float(getattr(own, name)[0, element])
    if analysis.friction is not None:
        for source, loss in analysis.friction.heat.items():
            found[f"heat_{source}"] = float(loss.total[0])
    life = analysis.life
    if life is not None:
        found["reference_load"] = float(life.reference_load[0])
    cleaned: dict[str, Any] = plain({**found, **_brief_extremes(analysis)})
    return cleaned


def _paths(found: Any, path: str) -> Iterator[str]:
    """Dotted paths of the numbers of a case that two cases may be compared by."""
    if isinstance(found, Mapping):
        for key, value in found.items():
            if key in _NOT_COMPARED or (path == "" and key not in _COMPARED):
                continue
            yield from _paths(value, f"{path}{key}.")
    elif isinstance(found, list) and path.startswith(_COMPARED_LISTS):
        for index, value in enumerate(found):
            yield from _paths(value, f"{path}{index}.")
    elif isinstance(found, int | float) and not isinstance(found, bool) and _compares(path):
        yield path[:-1]


def _compares(path: str) -> bool:
    """Whether a number is compared; of balls and rollers only the loads are."""
    return not path.startswith(_OF_ELEMENTS) or path.endswith(".load.")


_BRIEF: Final = ("max_pressure", "film_parameter", "load_ratio")
_OF_FILM: Final = (
    "central_thickness", "minimum_thickness", "film_parameter", "entrainment_speed",
    "thermal_factor", "starvation_factor",
)  # fmt: skip
_COMPARED: Final = ("extremes", "clearance", "analysis")
_COMPARED_LISTS: Final = (
    "analysis.stiffness.", "analysis.rows.", "analysis.balls.", "analysis.rollers.",
    "clearance.steps.",
)  # fmt: skip
_OF_ELEMENTS: Final = ("analysis.balls.", "analysis.rollers.")
_NOT_COMPARED: Final = frozenset(
    {"schema", "residual", "iterations", "row", "ball", "roller", "notes"}
)
