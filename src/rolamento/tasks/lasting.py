"""How long a bearing and its lubricant last: use cases of one case, each a request."""

from __future__ import annotations

import os
from collections.abc import Sequence
from functools import partial
from typing import Annotated, Any, ClassVar, Self

from pydantic import model_validator

from rolamento.case import Case, override
from rolamento.errors import InputError, arguments, phrase
from rolamento.tasks.case_request import (
    CaseRequest,
    Finding,
    OverRequest,
    drawn,
    in_json,
    needs_over,
    over_a_field,
    why_not_all,
)
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import DECIMAL_MARK, Input
from rolamento.words import marked, said
from rolamento.words.reasons import why_not

__all__ = [
    "GreaseRequest",
    "LifeRequest",
    "OilRequest",
    "OscillationRequest",
    "ServiceLifeRequest",
]


class ServiceLifeRequest(CaseRequest):
    """Show what ends a bearing first: fatigue, grease or another.

    Everything that is known on one time line, with its spread, beside the required life.
    """

    examples: ClassVar = (
        "Examples: service-life 6205-2RS1 --fr '500 N' --speed '3000 rpm' --temperature"
        " '80 degC'; service-life motor.toml --plot ends.png."
    )
    products: ClassVar = drawn(marked("Draw the time line: a .png, .svg or .pdf file."))

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, a `ServiceLife`."""
        from rolamento.pages.service_life import service_life_page
        from rolamento.plots.service_life import service_life_figure
        from rolamento.tasks.time_line import service_life

        found = service_life(self.loaded())
        return Finding(
            found, partial(service_life_page, found), found.to_json,
            partial(service_life_figure, found), why_not(found.solved), found.first is not None,
        )  # fmt: skip


class OscillationRequest(CaseRequest):
    """Show the life of a bearing that swings instead of turning.

    Race by race, beside Harris's form; critical angles, fretting, and a histogram of angles.

    Parameters
    ----------
    angle
        Between the end points of the swing, such as 30deg.
    frequency
        Oscillations, there and back, such as 2Hz or '30 1/min'.
    spectrum
        Histogram: a column share (of the time) or revolutions (of the oscillations), and fields
        such as `duty.oscillation.angle`.
    decimal_mark
        Decimal mark, point or comma, for a table in which 12.500 may be 12.5 or 12500.
    """

    angle: Annotated[
        str | float | None, Input(example="30deg", of_case="duty.oscillation.angle")
    ] = None
    frequency: Annotated[
        str | float | None,
        Input(example="2Hz", of_case="duty.oscillation.frequency", metavar="FREQUENCY"),
    ] = None
    spectrum: Annotated[Any, Input("", "path", metavar="FILE.csv")] = None
    decimal_mark: Annotated[str | None, DECIMAL_MARK] = None

    examples: ClassVar = (
        "Examples: oscillation 6310 --fr '5 kN' --angle 90deg --frequency 2Hz; oscillation"
        " pitch.toml --plot life.png; oscillation pitch.toml --spectrum angles.csv."
    )
    products: ClassVar = drawn(marked("Draw the life over the angle: a .png, .svg or .pdf file."))

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, an `OscillationCase`, or of a histogram an `OscillationSpectrum`."""
        from rolamento.pages.oscillation import oscillation_page, oscillation_spectrum_page
        from rolamento.plots.oscillation import oscillation_figure
        from rolamento.tasks.oscillation import life_in_oscillation, life_under_oscillations

        stills: dict[str, str] = {}
        if self.angle is not None or self.frequency is not None:
            # a swing takes the place of a speed that the file has
            stills = {f"duty.{ring}_speed": "0 rpm" for ring in ("inner", "outer")}
        case = self.loaded(under=stills, needs_load=self.spectrum is None)
        if self.spectrum is not None:
            under = life_under_oscillations(case, self.spectrum, decimal_mark=self.decimal_mark)
            page = partial(oscillation_spectrum_page, under)
            return Finding(under, page, under.to_json, None, "", under.converged)
        found = life_in_oscillation(case)
        fretting = found.life is None or found.life.fretting
        return Finding(
            found, partial(oscillation_page, found), found.to_json,
            partial(oscillation_figure, found), why_not(found.solved), not fretting,
        )  # fmt: skip


class GreaseRequest(CaseRequest):
    """Show how long a grease lives, and which one to take.

    Several makers' formulas side by side, amounts, limits of temperature and speed, base oil.

    Parameters
    ----------
    kappa
        Viscosity ratio κ that the oil is to give.
    """

    kappa: Annotated[float, Input("", "number", example="1.5", default="1.5")] = 1.5

    examples: ClassVar = (
        "Examples: grease 6205-2RS1 --fr '500 N' --speed '3000 rpm' --temperature '70 degC';"
        " grease motor.toml --plot grease.png."
    )
    products: ClassVar = drawn(
        marked("Draw the life of the grease over the temperature: a .png, .svg or .pdf file.")
    )

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, a `GreaseCase`."""
        from rolamento.pages.grease import grease_page
        from rolamento.plots.grease import grease_figure
        from rolamento.tasks.grease import grease_of_case

        found = grease_of_case(self.loaded(), kappa=self.kappa)
        known = bool(found.intervals) or any(one.valid for one in found.lives)
        picture = partial(grease_figure, found)
        return Finding(found, partial(grease_page, found), found.to_json, picture, "", known)


class OilRequest(CaseRequest):
    """Show which ISO viscosity grade gives the required κ.

    The highest temperature decides; what the grade gives at the lowest stands beside it.

    Parameters
    ----------
    kappa
        Viscosity ratio κ that the oil is to give.
    temperatures
        Lowest and highest temperature of the lubricant, such as 40..80degC; by default that of
        the case.
    """

    kappa: Annotated[float, Input("", "number", example="1.5", default="1.5")] = 1.5
    temperatures: Annotated[str | None, Input(example="40..80degC", metavar="FIRST..LAST")] = None

    examples: ClassVar = (
        "Examples: oil 6310 --speed '1480 rpm' --kappa 1.5 --temperatures 40..80degC; oil"
        " case.toml."
    )

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, an `OilChoice`."""
        from rolamento.pages.given import title_of
        from rolamento.pages.grease import oil_page
        from rolamento.tasks.grease import choose_oil_of_case

        case = self.loaded(needs_load=False)
        found = choose_oil_of_case(case, self.kappa, *self._ends())
        title = case.title or case.bearing.designation or title_of(case)
        chosen = found.chosen is not None
        page = partial(oil_page, found, title)
        return Finding(found, page, in_json(found, schema=1, kind="oil"), None, "", chosen)

    def _ends(self) -> tuple[float, float] | tuple[None, None]:
        """Return coldest and hottest; the unit of the last stands for both."""
        from rolamento.studies.ranges import ends_of
        from rolamento.units import to_si

        if self.temperatures is None:
            return None, None
        ends = ends_of(self.temperatures)
        try:
            if ends is None:
                raise InputError(said("must be two temperatures"))
            return to_si(ends[0], "temperature"), to_si(ends[1], "temperature")
        except InputError as error:
            example = arguments(temperatures="40..80degC")
            raise error.with_details(
                field="temperatures", value=self.temperatures, example=example
            ) from None


class LifeRequest(OverRequest):
    """Show the life by every theory, and what would help.

    For a bearing, several on one shaft, or a duty of several steps: where each theory applies,
    and what limits the life.

    Parameters
    ----------
    case
        Case file (TOML or JSON), or a designation such as 6310/C3; several are the bearings of one
        shaft.
    over
        Vary a field, such as duty.load.fz=1..8kN or life.contamination=0.1..1.
    spectrum
        Steps of the duty: a column share (of the time), and fields of the case.
    nsk_table
        a_NSK from the maker's chart: rows of kappa, columns of (P-P_u)/(C a_c).
    reliability
        Reliability of the life, such as 0.95.
    cleanliness
        Cleanliness of the oil or grease in words: extreme, high, normal, slight, typical, severe or
        very_severe (contamination).
    decimal_mark
        Decimal mark, point or comma, for a table in which 12.500 may be 12.5 or 12500.
    """

    case: Annotated[Any, Input("Case", "files", essential=True, metavar="CASE")]
    over: Annotated[
        str | None, Input(example="duty.load.fz=1..8kN", metavar="FIELD=FIRST..LAST")
    ] = None
    spectrum: Annotated[Any, Input("", "path", metavar="FILE.csv")] = None
    nsk_table: Annotated[Any, Input("", "path", metavar="FILE.csv")] = None
    reliability: Annotated[
        float | None,
        Input("", "number", example="0.95", of_case="life.reliability", metavar="S"),
    ] = None
    cleanliness: Annotated[str | None, Input(example="normal", metavar="LEVEL")] = None
    decimal_mark: Annotated[str | None, DECIMAL_MARK] = None

    json_meaning: ClassVar = "Write everything as JSON"
    examples: ClassVar = (
        "Examples: life 6310/C3 --fr '5 kN' --speed '1480 rpm'; life case.toml"
        " --reliability 0.95; life left.toml right.toml;"
        " life case.toml --spectrum steps.csv; life case.toml --over duty.load.fz=1..8kN."
    )
    products: ClassVar = drawn(
        marked("With `over`, draw it: a .png, .svg or .pdf file."),
        lambda asked: needs_over(asked, "plot"),
    )

    @property
    def _sources(self) -> list[Any]:
        return list(self.case) if isinstance(self.case, list | tuple) else [self.case]

    @model_validator(mode="after")
    def _goes_together(self) -> Self:
        if self.over is not None and self.spectrum is not None:
            rule = phrase(marked("cannot be combined with {before}"), before=arguments(over=...))
            raise InputError(rule, field="spectrum", value=self.spectrum)
        if self.over is not None and len(self._sources) > 1:
            alone = said("is for a single case; several are given")
            raise InputError(alone, field="over", value=self.over)
        return self

    def loaded(self, source: Any = None, **more: Any) -> Case:
        """Return a case, by default the first."""
        return super().loaded(self._sources[0] if source is None else source, **more)

    def cases(self) -> list[tuple[str, Case]]:
        """Return the case and its variants."""
        return [(name, self._clean(one)) for name, one in super().cases()]

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it: a `CaseLife`, `ShaftLife` or `SpectrumLife`, or over a field `LifeCurve`."""
        tables = {"nsk_table": self.nsk_table, "decimal_mark": self.decimal_mark}
        if self.over is not None:
            return self._curves(tables)
        from rolamento.tasks.life import names_of

        cases = [self._clean(self.loaded(source)) for source in self._sources]
        names = names_of(cases, _called(self._sources))
        if self.spectrum is not None:
            return self._under_steps(cases, names, tables)
        return _of_shaft(cases, names, tables) if len(cases) > 1 else _of_case(cases[0], tables)

    def _clean(self, case: Case) -> Case:
        """Return the case with a level of cleanliness in words, of its oil or grease."""
        if self.cleanliness is None:
            return case
        grease = case.lubricant is not None and case.lubricant.kind == "grease"
        name = "grease_cleanliness" if grease else "cleanliness"
        try:
            return override(case, [f"life.{name}={self.cleanliness}"])
        except InputError as error:
            if not error.field.startswith("life."):
                raise
            example = arguments(cleanliness="normal")
            raise error.with_details(field="cleanliness", source="", example=example) from None

    def _under_steps(
        self, cases: Sequence[Case], names: Sequence[str], tables: dict[str, Any]
    ) -> Finding:
        from rolamento.pages.life_spectrum import life_spectrum_page, shaft_spectrum_page
        from rolamento.tasks.life_spectrum import life_of_duty_spectrum, lives_under

        found: Any
        if len(cases) > 1:
            found = lives_under(cases, self.spectrum, **tables)
            bearings, text = found.bearings, partial(found.to_json, names)
            page = partial(shaft_spectrum_page, found, names)
        else:
            found = life_of_duty_spectrum(cases[0], self.spectrum, **tables)
            bearings, text, page = (found,), found.to_json, partial(life_spectrum_page, found)
        failed = next((own for own in bearings if not own.converged), None)
        why = "" if failed is None else why_not_all(failed.status, failed.taking_part)
        return Finding(found, page, text, None, why, failed is None)

    def _curves(self, tables: dict[str, Any]) -> Finding:
        from rolamento.pages.life_over import life_over_page
        from rolamento.plots.life import life_figure
        from rolamento.tasks.life_over import curves_json, life_curves

        found = life_curves(self.cases(), self.range(), **tables)
        return over_a_field(found, life_over_page, curves_json, life_figure)


def _called(sources: Sequence[Any]) -> list[Any]:
    """Return files and designations; of a case the place that it has."""
    return [
        one if isinstance(one, str | os.PathLike) else place
        for place, one in enumerate(sources, start=1)
    ]


def _of_case(case: Case, tables: dict[str, Any]) -> Finding:
    from rolamento.pages.life import life_page
    from rolamento.tasks.life import life_of_case

    found = life_of_case(case, **tables)
    page = partial(life_page, found.solved, found.life, found.changes, friction=found.friction)
    why = why_not(found.solved, advised=True)
    return Finding(found, page, found.to_json, None, why, found.converged)


def _of_shaft(cases: Sequence[Case], names: Sequence[str], tables: dict[str, Any]) -> Finding:
    from rolamento.pages.shaft import shaft_page
    from rolamento.tasks.life import life_of_shaft

    found = life_of_shaft(cases, **tables)
    page, text = partial(shaft_page, found, names), partial(found.to_json, names)
    failed = next((solved for solved in found.bearings if not solved.converged[0]), None)
    why = "" if failed is None else f"{failed.title}: {why_not(failed)}"
    return Finding(found, page, text, None, why, found.converged)
