"""Use cases of a case: where it comes from, what goes over it, and what is found of it."""

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final, Self

from pydantic import model_validator

from rolamento.case import Case, case_of, is_designation, load_case
from rolamento.case.fields import OVERRIDE_SOURCE
from rolamento.errors import ABSENT, InputError, arguments, phrase
from rolamento.io.json import dumps
from rolamento.records import frozen
from rolamento.tasks.bearing import has_load
from rolamento.tasks.request import Input, Product, Request
from rolamento.words import marked, said
from rolamento.words.reasons import reason

if TYPE_CHECKING:
    from rolamento.document import Document
    from rolamento.studies.ranges import Range

__all__ = [
    "VARIANTS",
    "CaseRequest",
    "Finding",
    "FindingRequest",
    "OverRequest",
    "RangeRequest",
    "drawn",
    "in_json",
    "needs_over",
    "over_a_field",
    "why_not_all",
]

SOLVING: Final = marked("Solving …")
_DUTY: Final = marked("Bearing and duty")
VARIANTS: Final = Input(
    "", "list", separator="", option="--variant", metavar="NAME:FIELD=VALUE", at_computer=True
)
_NOTHING: Final[Mapping[str, str]] = {}
_MOST_VARIANTS: Final = 5
"""Lines that one figure over a field can distinguish."""


@frozen(eq=False)
class Finding:
    """What is found, with its page, its data and its picture.

    Attributes
    ----------
    found
        the record
    page, to_json, picture
        return what people read, everything as JSON, and a figure
    report
        returns the page of a report, where that is more
    text
        plain text behind the page, or in its place
    complaint
        why there is no result, for who reads the data alone; "" if there is one
    is_result
        whether it is what was asked for
    """

    found: Any
    page: "Callable[[], Document] | None" = None
    to_json: Callable[[], str] = str
    picture: Callable[[], Any] | None = None
    complaint: str = ""
    is_result: bool = True
    report: "Callable[[], Document] | None" = None
    text: str = ""


class FindingRequest(Request):
    """A use case that returns a `Finding`."""

    counts: ClassVar = False
    waiting: ClassVar = SOLVING

    def has_result(self, found: Any) -> bool:
        """Return whether what was asked for is found."""
        return bool(found.is_result)

    def json_text(self, found: Any) -> str:
        """Return all that is found as JSON."""
        return str(found.to_json())

    def report(self, found: Any) -> "Callable[[], Document] | None":
        """Return what makes the page of a report, where that is more than the page."""
        return found.report  # type: ignore[no-any-return]

    def has_page(self, found: Any) -> bool:
        """Return whether there is a page."""
        return found.page is not None

    def closing(self, found: Any) -> str:
        """Return what people read behind the page, or in its place."""
        return str(found.text)


class CaseRequest(FindingRequest):
    """A use case of a case.

    Parameters
    ----------
    case
        Case file (TOML or JSON), or a designation such as 6310/C3; - for standard input.
    changes
        What goes over it, by dotted name, such as ``{"duty.load.fz": "5 kN"}``.
    """

    case: Annotated[Any, Input("Case", "file", essential=True, metavar="CASE")]
    changes: Any = ()

    headings: ClassVar[tuple[str, ...]] = (_DUTY,)
    takes_case: ClassVar = True

    def loaded(
        self,
        source: Any = None,
        *,
        under: Mapping[str, str] = _NOTHING,
        otherwise: Sequence[str] = (),
        needs_load: bool = True,
    ) -> Case:
        """Return the case, with what goes over it.

        Parameters
        ----------
        source
            Of which case, where there are several.
        under
            What holds unless it is given, whatever the file has; by dotted name.
        otherwise
            Settings of tables that the case may lack, as `rolamento.load_case` has it.
        needs_load
            Refuse a designation without a load; what a file has is its own affair.

        Raises
        ------
        InputError, FileError
            As `rolamento.load_case`; a value that a field of the request gives is called by that.
        """
        source = self.case if source is None else source
        given = {
            one.of_case: (name, getattr(self, name))
            for name, one in self.inputs().items()
            if one.of_case and getattr(self, name) is not None
        }
        own = {dotted: value for dotted, (_, value) in given.items()}
        changes: Any = {**under, **self.changes, **own} if isinstance(self.changes, Mapping) else (
            *_settings(under), *self.changes, *_settings(own)
        )  # fmt: skip
        try:
            if isinstance(source, str | os.PathLike):
                case = load_case(source, changes, otherwise=otherwise)
            else:
                case = case_of(source, changes)
        except InputError as error:
            name, value = given.get(error.field, ("", None))
            if not name or error.source not in ("", OVERRIDE_SOURCE):
                raise
            example = arguments(**{name: self.inputs()[name].example})
            raise error.with_details(source="", field=name, value=value, example=example) from None
        if needs_load and is_designation(source) and not has_load(case):
            raise InputError(
                said("is missing: nothing loads the bearing"),
                source=source,
                field="duty.load",
                example=arguments(changes={"duty.load.fz": "5 kN", "duty.inner_speed": "1480 rpm"}),
            )
        return case


def _settings(values: Mapping[str, Any]) -> Iterator[str]:
    return (f"{name}={value}" for name, value in values.items())


class RangeRequest(CaseRequest):
    """A use case of a case, or of it over one of its fields.

    Parameters
    ----------
    points
        Number of values of that field, 2 to 1000.
    log
        Logarithmic spacing of the values.
    """

    over: Annotated[str | None, Input(metavar="FIELD=FIRST..LAST")] = None
    points: Annotated[int, Input("", "count", default="40")] = 40
    log: Annotated[bool, Input("", "switch")] = False

    def range(self) -> "Range":
        """Return the field and its values.

        Raises
        ------
        InputError
            As `rolamento.studies.ranges.read_range`.
        """
        from rolamento.studies.ranges import read_range

        assert self.over is not None
        return read_range(self.over, self.points, log=self.log)


class OverRequest(RangeRequest):
    """A use case of a case, or of it and its variants over one of its fields.

    Parameters
    ----------
    variants
        Also the case with this changed, under this name; further FIELD=VALUE after commas, such as
        'spring:bearing.preload={ spring = "500 N" }'.
    """

    variants: Annotated[tuple[str, ...], VARIANTS] = ()

    @model_validator(mode="after")
    def _few_variants_over_a_field(self) -> Self:
        if self.variants:
            needs_over(self, "variants", self.variants[0])
        if len(self.variants) > _MOST_VARIANTS:
            rule = said("may be given at most {most} times", most=_MOST_VARIANTS)
            raise InputError(rule, field="variants", value=len(self.variants))
        return self

    def cases(self) -> list[tuple[str, Case]]:
        """Return the case, without a label unless a variant names it, and its variants by names.

        Raises
        ------
        InputError
            If a text is no variant, or one of another case.
        """
        from rolamento.case.variant import AS_GIVEN, cases_compared, read_variants

        case = self.loaded(needs_load=False)
        found = cases_compared(case, read_variants(self.variants)) or {AS_GIVEN: case}
        return [("" if name == AS_GIVEN else name, own) for name, own in found.items()]


def needs_over(asked: RangeRequest, field: str, value: object = ABSENT) -> None:
    """Refuse what is of a range where there is none."""
    if asked.over is None:
        needed = phrase(marked("needs {option}"), option=arguments(over=...))
        example = arguments(over=asked.inputs()["over"].example)
        raise InputError(needed, field=field, value=value, example=example)


def over_a_field(
    curves: Sequence[Any],
    page: "Callable[[Sequence[Any]], Document]",
    json: Callable[[Sequence[Any]], str],
    figure: Callable[[Sequence[Any]], Any],
) -> Finding:
    """Return curves, the case's own first, with what shows them all."""
    failed = next((one.status for one in curves if not one.converged), None)
    why = "" if failed is None else why_not_all(failed)
    return Finding(
        tuple(curves), partial(page, curves), partial(json, curves), partial(figure, curves),
        why, failed is None,
    )  # fmt: skip


def why_not_all(status: Any, among: Any = ...) -> str:
    """Return of how many points there is no result, and why of the first; among: which count."""
    codes = [str(code) for code in status[among] if code != "converged"]
    why = reason(codes[0])
    return said("{count} / {total}: {reason}", count=len(codes), total=len(status), reason=why)


def in_json(found: Any, **head: Any) -> Callable[[], str]:
    """Return what writes a record as JSON; head: what stands before it."""
    return lambda: dumps({**head, **found.to_mapping()}, indent=2)


def drawn(meaning: str, check: Callable[[Any], None] | None = None) -> dict[str, Product]:
    """Return the option that draws what is found; meaning: marked."""
    return {"plot": Product(meaning, lambda asked, found: found.picture(), check=check)}
