"""What goes on inside a bearing: use cases of one case, each a request."""

from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final, Self

from pydantic import model_validator

from rolamento.errors import InputError, arguments, phrase
from rolamento.io.json import dumps
from rolamento.tasks.case_request import (
    VARIANTS,
    CaseRequest,
    Finding,
    OverRequest,
    RangeRequest,
    drawn,
    in_json,
    needs_over,
    over_a_field,
    why_not_all,
)
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import Input
from rolamento.words import marked, said
from rolamento.words.reasons import why_not

if TYPE_CHECKING:
    from rolamento.case import Case

__all__ = [
    "ElectricalRequest",
    "FrictionRequest",
    "HeatRequest",
    "ReportRequest",
    "SolveRequest",
    "StaticRequest",
    "TurnRequest",
]


class SolveRequest(CaseRequest):
    """Show the internal state of a bearing under its duty.

    With variants, all cases side by side, and their differences from the first.

    Parameters
    ----------
    variants
        Also the case with this changed, under this name; further FIELD=VALUE after commas, such as
        'spring:bearing.preload={ spring = "500 N" }'.

    >>> found = SolveRequest(case="6310/C3", changes={"duty.load.fz": "5 kN"}).run().found
    >>> bool(found.solved.converged[0])
    True
    """

    variants: Annotated[tuple[str, ...], VARIANTS] = ()

    json_meaning: ClassVar = "Write the state as JSON, in SI units"
    examples: ClassVar = (
        "Examples: solve 6310/C3 --fr '5 kN' --speed '1480 rpm'; solve case.toml --json;"
        " solve case.toml --set duty.load.fz='10 kN'; solve case.toml --report state.pdf"
        " --csv stiffness.csv --table stiffness; solve case.toml --variant"
        " 'spring:bearing.preload={ spring = \"500 N\" }'."
    )

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, an `Analysis`; of variants a `Comparison`."""
        case = self.loaded()
        if self.variants:
            return self._compared(case, progress)
        from rolamento.analysis import analyse
        from rolamento.pages.state import state_page

        found = analyse(case)
        page, why = partial(state_page, found.solved, found), why_not(found.solved, advised=True)
        return Finding(found, page, found.to_json, None, why, not why)

    def _compared(self, case: "Case", progress: Progress) -> Finding:
        from rolamento.case.variant import read_variants
        from rolamento.pages.report import comparison_page
        from rolamento.tasks.report import compare_variants

        found = compare_variants(case, read_variants(self.variants), progress=progress)
        whys = {one.name: why_not(one.analysis.solved) for one in found.cases}
        why = "\n".join(f"{name}: {why}" for name, why in whys.items() if why)
        page = partial(comparison_page, found, case.title)
        return Finding(found, page, found.to_json, None, why, found.converged)


class TurnRequest(CaseRequest):
    """Show what varies while the cage turns by one pitch.

    Displacement, stiffness and ball loads over that period.

    Parameters
    ----------
    points
        Instants in one period, 4 to 4096.
    """

    points: Annotated[int, Input("", "count", example="256", default="256")] = 256

    examples: ClassVar = "Example: turn case.toml --plot turn.png."
    products: ClassVar = drawn(marked("Draw the result: a .png, .svg or .pdf file."))

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, a `CageTurn`."""
        from rolamento.pages.turn import turn_page
        from rolamento.plots.cage_turn import cage_turn_figure
        from rolamento.studies.cage_turn import cage_turn
        from rolamento.studies.torque_turn import torque_over_turn

        found = cage_turn(self.loaded(), points=self.points)
        torque = torque_over_turn(found)
        own = {} if torque is None else {"torque": torque.to_mapping()}
        why = "" if found.converged else why_not_all(found.status)
        return Finding(
            found, partial(turn_page, found, torque),
            lambda: dumps({**found.to_mapping(), **own}, indent=2),
            partial(cage_turn_figure, found), why, found.converged,
        )  # fmt: skip


class FrictionRequest(OverRequest):
    """Show the friction torque by every model.

    For a case, or over one of its fields, with the validity of each model.

    Parameters
    ----------
    over
        Vary a field, such as duty.load.fx=10..200N or duty.inner_speed=0.5..30000rpm.
    coefficient
        Coefficient of friction, up to 1; by the regime of lubrication if not given.
    hysteresis
        Hysteresis loss: fraction of the elastic work, 0 to 1.
    """

    over: Annotated[
        str | None, Input(example="duty.load.fx=10..200N", metavar="FIELD=FIRST..LAST")
    ] = None
    coefficient: Annotated[
        float | None,
        Input("", "number", example="0.1", of_case="lubricant.friction_coefficient", metavar="MU"),
    ] = None
    hysteresis: Annotated[
        float, Input("", "number", example="0.1", default="0.01", metavar="LOSS")
    ] = 0.01

    examples: ClassVar = (
        "Examples: friction 6310 --fr '5 kN' --speed '1480 rpm' --lubricant 'ISO VG 68'"
        " --temperature '70 degC'; friction case.toml --over duty.load.fx=10..200N"
        " --plot friction.png."
    )
    products: ClassVar = drawn(
        marked("With `over`, draw it: a .png, .svg or .pdf file."),
        lambda asked: needs_over(asked, "plot"),
    )

    @model_validator(mode="after")
    def _parts_of_one(self) -> Self:
        for name in ("hysteresis", "coefficient"):
            value = getattr(self, name)
            if value is not None and not 0.0 <= value <= 1.0:
                raise InputError(said("must be from 0 to 1"), field=name, value=value)
        return self

    def loaded(self, source: Any = None, **more: Any) -> "Case":
        """Return the case; one without a lubricant is dry if the coefficient is given."""
        dry = ("lubricant.kind=dry", "lubricant.name=dry")
        return super().loaded(source, otherwise=() if self.coefficient is None else dry, **more)

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, an `Analysis` with friction, or over a field a `FrictionCurve` each."""
        if self.over is not None:
            return self._curves()
        from rolamento.pages.friction import friction_page
        from rolamento.tasks.friction import friction_mapping, friction_of_case

        found = friction_of_case(self.loaded(), hysteresis=self.hysteresis)
        why = why_not(found.solved, advised=True)
        return Finding(
            found, partial(friction_page, found), lambda: dumps(friction_mapping(found), indent=2),
            None, why, not why,
        )  # fmt: skip

    def _curves(self) -> Finding:
        from rolamento.pages.friction_over import friction_over_page
        from rolamento.plots.friction import friction_figure
        from rolamento.studies.friction_curves import curves_mapping, friction_curve

        curves = [
            friction_curve(case, self.range(), hysteresis=self.hysteresis, label=label)
            for label, case in self.cases()
        ]
        return over_a_field(
            curves, friction_over_page, lambda all_: dumps(curves_mapping(all_), indent=2),
            friction_figure,
        )  # fmt: skip


class HeatRequest(RangeRequest):
    """Show how warm a bearing runs, and what becomes of its preload.

    Friction balanced by the heat that [heat] lets out; cold beside warm, or in time.

    Parameters
    ----------
    over
        Vary a field, such as duty.inner_speed=1000..6000rpm or bearing.preload.force=100..500N.
    time
        Start up from ambient temperature, such as '1 h'; steps runs those of [heat].
    limit
        Plan steps of speed that keep the preload or every part below a limit, such as '1500 N' or
        '60 degC'.
    compare
        Springs beside rigid preload, ceramic beside steel, the distance of rows that keeps the
        preload, the highest speed.
    oil_for
        With `compare`, the oil flow that keeps every part below it, such as '60 degC'.
    """

    over: Annotated[
        str | None,
        Input(example="duty.inner_speed=1000..6000rpm", metavar="FIELD=FIRST..LAST"),
    ] = None
    points: Annotated[int, Input("", "count", default="13")] = 13
    time: Annotated[str | float | None, Input(example="1 h", metavar="DURATION")] = None
    limit: Annotated[str | None, Input(example="1500 N", option="--warm-up", metavar="LIMIT")] = (
        None
    )
    compare: Annotated[bool, Input("", "switch")] = False
    oil_for: Annotated[
        float | None,
        Input("", "quantity", example="60 degC", dimension="temperature", metavar="TEMPERATURE"),
    ] = None

    examples: ClassVar = (
        "Examples: heat 6220 --fr '10 kN' --speed '3000 rpm' --lubricant 'ISO VG 68'; heat"
        " spindle.toml --over duty.inner_speed=2000..12000rpm --plot heat.png; heat spindle.toml"
        " --time '1 h'; heat spindle.toml --compare --oil-for '60 degC'."
    )
    products: ClassVar = drawn(
        marked("Draw the balance, the field or the time: a .png, .svg or .pdf file.")
    )

    @model_validator(mode="after")
    def _one_of_them(self) -> Self:
        named = [name for name in ("over", "time", "limit", "compare") if getattr(self, name)]
        if len(named) > 1:
            before = arguments(**{named[0]: ...})
            rule = phrase(marked("cannot be combined with {before}"), before=before)
            raise InputError(rule, field=named[1])
        if self.oil_for is not None and not self.compare:
            needed = phrase(marked("needs {option}"), option=arguments(compare=True))
            example = arguments(compare=True, oil_for="60 degC")
            raise InputError(needed, field="oil_for", example=example)
        return self

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it: a `HeatBalance`, `HeatTime`, `WarmUp`, `HeatAnswers`, or a `HeatOver`."""
        case = self.loaded(needs_load=self.over is None)
        if self.time is not None:
            return _in_time(case, self.time)
        if self.limit is not None:
            return self._planned(case)
        if self.compare:
            return self._compared(case)
        return _balanced(case) if self.over is None else self._over(case)

    def _planned(self, case: "Case") -> Finding:
        from rolamento.pages.heat_time import warm_up_figure, warm_up_page
        from rolamento.tasks.heat import limit_of_text, warm_up

        assert self.limit is not None
        try:
            limit = limit_of_text(self.limit)
        except InputError as error:
            raise error.with_details(field="limit", example=arguments(limit="1500 N")) from None
        found = warm_up(case, **limit)
        return Finding(
            found, partial(warm_up_page, found), in_json(found, schema=1, kind="warm_up"),
            partial(warm_up_figure, found), "", found.transient is not None,
        )  # fmt: skip

    def _compared(self, case: "Case") -> Finding:
        from rolamento.pages.heat_answers import heat_answers_page
        from rolamento.plots.heat import heat_variants_figure
        from rolamento.tasks.heat import heat_answers

        found = heat_answers(case, self.oil_for)
        return Finding(
            found, partial(heat_answers_page, found),
            in_json(found, schema=1, kind="heat_answers"),
            partial(heat_variants_figure, found.variants),
            _said(found.balance.status), found.balance.converged,
        )  # fmt: skip

    def _over(self, case: "Case") -> Finding:
        from rolamento.pages.heat import heat_over_page
        from rolamento.plots.heat import heat_over_figure
        from rolamento.studies.heat_curves import heat_over

        return over_a_field(
            [heat_over(case, self.range())],
            lambda curves: heat_over_page(curves[0]),
            lambda curves: dumps(curves[0].to_mapping(), indent=2),
            lambda curves: heat_over_figure(curves[0]),
        )


def _balanced(case: "Case") -> Finding:
    from rolamento.heat import heat_balance
    from rolamento.pages.heat import heat_page
    from rolamento.plots.heat import heat_figure

    found = heat_balance(case)
    return Finding(
        found, partial(heat_page, found), in_json(found, schema=1, kind="heat"),
        partial(heat_figure, found), _said(found.status), found.converged,
    )  # fmt: skip


def _in_time(case: "Case", time: str | float) -> Finding:
    from rolamento.heat import heat_transient
    from rolamento.pages.heat_time import heat_time_page
    from rolamento.plots.heat import heat_time_figure
    from rolamento.units import to_si

    try:
        duration = (
            None if time == "steps" else to_si(time, "time") if isinstance(time, str) else time
        )
        found = heat_transient(case, duration)
    except InputError as error:
        if error.field not in ("", "duration"):
            raise
        raise error.with_details(field="time", example=arguments(time="1 h")) from None
    return Finding(
        found, partial(heat_time_page, found), in_json(found, schema=1, kind="heat_time"),
        partial(heat_time_figure, [("", found)]), _said(found.status), found.converged,
    )  # fmt: skip


def _said(status: str) -> str:
    from rolamento.words.reasons import reason

    return "" if status == "converged" else reason(status)


class StaticRequest(CaseRequest):
    """Show static safety, launch loads, gaps and hardness.

    By stress and by load at every contact, beside what makers recommend; margins to allowable
    pressures, and at which load a preloaded pair opens.

    >>> found = StaticRequest(case="6310", changes={"duty.load.fz": "19 kN"}).run().found
    >>> f"{found.safety[0, 0]:.2f}"  # 38.5 kN / 19 kN
    '2.03'
    """

    examples: ClassVar = (
        "Examples: static 6310 --fr '20 kN' --set static.operation=shock; static pair.toml --set"
        " static.load_factor=1.4 --set static.allowable_pressure='3200 MPa'."
    )
    products: ClassVar = drawn(
        marked("Draw safety and gaps over the load: a .png, .svg or .pdf file.")
    )

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, a `StaticSafety`."""
        from rolamento.pages.static import static_page
        from rolamento.plots.static import static_figure
        from rolamento.safety import static_over_load, static_safety_of

        case = self.loaded(needs_load=False)
        found = static_safety_of(case)
        why = why_not(found.solved)
        return Finding(
            found, partial(static_page, found), in_json(found, schema=1, kind="static"),
            lambda: static_figure(static_over_load(case)), why, not why,
        )  # fmt: skip


class ElectricalRequest(CaseRequest):
    """Show a bearing as a capacitor: current, field, breakdown.

    Capacitance of its films; the apparent current density of [electrical] beside published
    bands; the field in the films and the voltage at which they break down; steel beside ceramic.
    """

    examples: ClassVar = (
        "Examples: electrical 6310 --fr '1 kN' --speed '1500 rpm' --lubricant 'ISO VG 100'"
        " --temperature '70 degC' --set electrical.current='0.5 A'; electrical motor.toml --set"
        " electrical.voltage='10 V'."
    )

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, a `BearingElectrics`."""
        from rolamento.electrical import electrics_of
        from rolamento.pages.electrical import electrical_page

        found = electrics_of(self.loaded(needs_load=False))
        why = why_not(found.solved)
        text = in_json(found, schema=1, kind="electrical")
        return Finding(found, partial(electrical_page, found), text, None, why, not why)


_HEAD: Final = ("project", "author", "revision", "date", "checked_by")


class ReportRequest(CaseRequest):
    """Write a calculation report to sign, of one case or several.

    Several cases stand side by side, with their differences from the first.

    Parameters
    ----------
    case
        Case files, or designations such as 6305; up to 20, side by side. - is standard input.
    output
        Write the report: a .html, .pdf, .md or .txt file. By default it is printed.
    project
        Project, in the title block.
    author
        Author, in the title block.
    revision
        Revision, in the title block.
    date
        Date of the report; today by default.
    checked_by
        Checker, in the title block.
    names
        Of several cases; A, B, C … by default.
    """

    case: Annotated[Any, Input("", "files", essential=True, metavar="CASE")]
    output: Annotated[Any, Input("", "target", metavar="FILE")] = None
    project: Annotated[str, Input(example="Spindle unit 4711", metavar="TEXT")] = ""
    author: Annotated[str, Input(example="A. Souza", metavar="TEXT")] = ""
    revision: Annotated[str, Input(example="B", metavar="TEXT")] = ""
    date: Annotated[str, Input(example="2026-11-30")] = ""
    checked_by: Annotated[str, Input(example="M. Okafor", metavar="TEXT")] = ""
    names: tuple[str, ...] = ()

    counts: ClassVar = True
    waiting: ClassVar = marked("cases analysed")
    shows_page: ClassVar = False
    examples: ClassVar = (
        "Examples: report case.toml -o report.pdf --author 'A. Souza';"
        " report old.toml new.toml -o comparison.html; report 6305 --fr '2 kN'."
    )

    @property
    def target(self) -> str | None:
        """Name of the file of the report, if there is one."""
        return self.output  # type: ignore[no-any-return]

    def check_target(self, path: str) -> None:
        """Refuse a name that ends as no report."""
        from rolamento.document.writing import REPORTS, check_ending

        check_ending(path, REPORTS)

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, a `Report`."""
        from rolamento.pages.report import report_page
        from rolamento.tasks.report import calculation_report

        head = {name: getattr(self, name) for name in _HEAD}
        found = calculation_report(
            self.case, head, self.changes, names=self.names, progress=progress
        )
        page = None if self.output else partial(report_page, found)
        return Finding(found, page, found.to_json, is_result=found.converged)

    def write(self, found: Any, path: str) -> None:
        """Write its page."""
        from rolamento.document.writing import write
        from rolamento.pages.report import report_page

        write(report_page(found.found), path)
