"""The pages of a reproduction as documents: the index, and one of the misprints.

The index shows every figure and table with what the source says of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING, Final, Literal

from rolamento.document import (
    Block,
    Column,
    Document,
    Entry,
    KeyValues,
    Link,
    Links,
    Statement,
    Title,
    Tone,
)
from rolamento.document import Figure as Picture
from rolamento.document import Section as Chapter
from rolamento.document import Table as Grid
from rolamento_reproductions.record import (
    Agreement,
    Cell,
    Claim,
    ClaimVerdict,
    Ending,
    Errata,
    Figure,
    Section,
    Source,
    Table,
    TableColumn,
    power_text,
)
from rolamento_reproductions.text import Prose, Text, localised

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Drawing

said: Final = Prose("")
PageEnding = Literal["html", "md"]

_MARKS: Final[dict[ClaimVerdict, tuple[str, Tone]]] = {
    "holds": ("✓", "good"),
    "partly": ("≈", "warning"),
    "fails": ("✗", "bad"),
}
_TONES: Final[dict[Agreement, Tone]] = {
    "printed": "faint",
    "tie": "warning",
    "cut": "warning",
    "differs": "bad",
}
_VERDICTS: Final = tuple(_MARKS)


def kind_of(source: Source) -> str:
    """Return what a page of ours is known by."""
    return f"reproduce {source.name}"


def index_page(
    source: Source,
    sections: Sequence[Section],
    endings: Sequence[Ending],
    page: PageEnding = "html",
) -> Document:
    """Return the page of all figures and tables, in the language that is spoken.

    Parameters
    ----------
    source
        What is reproduced.
    sections
        With everything computed.
    endings
        Of the pictures that lie beside the page.
    page
        Ending of the page of misprints that it points to.
    """
    opening: list[Block] = [Title(str(source.title)), *map(_statement, source.remarks)]
    opening.append(Statement("\n".join(map(str, summary(sections)))))
    chapters = [Chapter(blocks=tuple(opening))]
    for place, section in enumerate(sections, start=1):
        chapters.append(Chapter(str(section.title), key=f"part-{place}"))
        for item in section.items:
            if isinstance(item, Errata):
                pointer = tuple(_pointer_to_misprints(item, page))
                chapters.append(Chapter(blocks=pointer, level=3))
            else:
                chapters.append(_framed(item, endings))
    chapters.append(
        Chapter(blocks=(Statement(str(said("written_by", name=source.name)), "faint"),))
    )
    return Document(str(source.title), tuple(chapters), kind=kind_of(source))


def misprints_page(source: Source, errata: Errata, page: PageEnding = "html") -> Document:
    """Return the page of a publication's misprints, each with its derivation and its proof."""
    title = f"{said('misprints')}: {source.title}"
    opening: tuple[Block, ...] = (
        Title(title),
        *map(_statement, (errata.caption, _misprints_sentence(errata), *errata.remarks)),
        Links((Link(str(said("all")), f"index.{page}"),)),
    )
    return Document(
        title,
        (
            Chapter(blocks=opening),
            Chapter(
                str(said("proof")),
                (_statement(said("residuals")), _proof_grid(errata)),
                key="proof",
            ),
            *(
                Chapter(
                    f"{one.place}: {one.what}",
                    (
                        KeyValues(
                            (
                                Entry(str(said("printed_form")), str(one.printed)),
                                Entry(str(said("corrected_form")), str(one.corrected)),
                                Entry(str(said("derivation")), str(one.derivation)),
                            )
                        ),
                    ),
                    key=f"misprint-{place}",
                )
                for place, one in enumerate(errata.misprints, start=1)
            ),
            Chapter(str(said("valid")), (_grid_of_valid(errata),), key="valid"),
        ),
        kind=kind_of(source),
    )


def _statement(text: Text) -> Statement:
    return Statement(str(text))


def _framed(item: Figure | Table, endings: Sequence[Ending]) -> Chapter:
    """Put a figure or a table together with its inputs, files, statements and notes."""
    links = [Link(str(said("data")), f"{item.stem}.csv")]
    name = said("figure" if isinstance(item, Figure) else "table", number=item.number)
    shown: Block
    if isinstance(item, Figure):
        links = [*(Link(one.upper(), f"{item.stem}.{one}") for one in endings), *links]
        shown = Picture(caption=str(item.caption), draw=partial(_drawn, item), key=item.stem)
    else:
        shown = _grid(item)
    blocks: list[Block] = [shown, Statement(str(said("inputs", source=item.source)), "faint")]
    blocks.append(Links(tuple(links)))
    for heading, of_theory in (("stated", False), ("expected", True)):
        claims = [claim for claim in item.claims if claim.of_theory is of_theory]
        blocks += [Statement(str(said(heading)), "faint")] if claims else []
        blocks += map(_claim, claims)
    blocks += map(_statement, item.notes)
    if isinstance(item, Figure) and item.gaps:
        blocks.append(_statement(_gap_sentence(item)))
    return Chapter(str(name), tuple(blocks), key=item.stem, level=3)


def _drawn(figure: Figure) -> Drawing:
    from rolamento_reproductions.drawing import drawn  # Matplotlib is slow to load

    return drawn(figure)


def _claim(claim: Claim) -> Statement:
    """Set what is stated, and below it what was found."""
    mark, tone = _MARKS[claim.verdict]
    finding = said(f"finding.{claim.verdict}", finding=claim.finding)
    return Statement(f"{claim.statement}\n{finding}", mark=mark, mark_tone=tone)


def _pointer_to_misprints(errata: Errata, page: PageEnding) -> Iterator[Block]:
    """Name the misprints, and point to the page that has them."""
    yield Statement(f"{errata.caption} {_misprints_sentence(errata)}")
    for one in errata.misprints:
        yield Statement(f"{one.place}: {one.what}", mark="•")
    yield Links(
        (
            Link(str(said("misprints")), f"{errata.stem}.{page}"),
            Link(str(said("data")), f"{errata.stem}.csv"),
        )
    )


# --- tables -------------------------------------------------------------------


def _grid(table: Table) -> Grid:
    columns = [column for one in table.columns for column in _columns(one)]
    legends = []
    for way in ("tie", "cut", "differs"):
        numbers = [localised(cell.text) for cell in table.cells if cell.agreement == way]
        if numbers:
            legends.append(str(said(f"agreement.{way}", numbers=", ".join(numbers))))
    return Grid(
        columns=tuple(columns), key=table.stem, caption=str(table.caption), legends=tuple(legends)
    )


def _columns(column: TableColumn) -> Iterator[Column]:
    """Return a column of texts, or of what is printed with one beside it of what is computed."""
    if not column.compared:
        numeric = not column.sentences and column.cells and isinstance(column.cells[0], str)
        yield Column(
            head=str(column.title),
            values=[localised(c) if isinstance(c, str) else str(c) for c in column.cells],
            key=column.name,
            align="right" if numeric else "",
        )
        return
    cells = [cell for cell in column.cells if isinstance(cell, Cell)]
    kinds = column.heads or (said("printed"), said("computed"))
    heads = [str(said("compared", title=column.title, kind=kind)).strip() for kind in kinds]
    yield Column(
        head=heads[0],
        values=[localised(cell.printed) for cell in cells],
        key=f"{column.name}_printed",
        align="right",
    )
    yield Column(
        head=heads[1],
        values=[localised(cell.text) for cell in cells],
        key=f"{column.name}_computed",
        align="right",
        tones=[_TONES[cell.agreement] for cell in cells],
    )


def _proof_grid(errata: Errata) -> Grid:
    """The residuals of every misprint, as printed and as corrected."""
    ones = errata.misprints
    return Grid(
        key="proof",
        columns=(
            Column(head=str(said("equation")), values=[str(one.place) for one in ones]),
            Column(head=str(said("quantity")), values=[str(one.what) for one in ones]),
            *(
                Column(
                    head=str(said(f"columns.{name}")),
                    values=[_few_digits(getattr(one.printed_residual, name)) for one in ones],
                    key=name,
                    align="right",
                )
                for name in ("median", "maximum")
            ),
            Column(
                head=str(said("columns.corrected")),
                values=[_power_above(one.corrected_residual.maximum) for one in ones],
                align="right",
            ),
        ),
    )


def _grid_of_valid(errata: Errata) -> Grid:
    """The equations that are valid as printed, with what rounding leaves of them."""
    ones = errata.valid
    return Grid(
        key="valid",
        columns=(
            Column(
                head=str(said("equation")),
                values=[str(said("numbered", number=one.number)) for one in ones],
            ),
            Column(head=str(said("quantity")), values=[str(one.what) for one in ones]),
            Column(head=str(said("form")), values=[str(one.form) for one in ones]),
            Column(
                head=str(said("columns.residual")),
                values=[_power_above(one.residual.maximum) for one in ones],
                align="right",
            ),
        ),
    )


def _power_above(value: float) -> str:
    """Rounding differs from machine to machine: the power of ten above it."""
    return str(said("below", power=power_text(value)))


def _few_digits(value: float) -> str:
    digits = f"{value:.0f}" if value >= 10.0 else f"{value:.2f}" if value >= 0.1 else f"{value:.2g}"
    return localised(digits)


# --- sentences ----------------------------------------------------------------


def summary(sections: Sequence[Section]) -> tuple[Text, ...]:
    """Count figures, printed numbers, statements and misprints, and how they agree."""
    items = [item for section in sections for item in section.items]
    shown = [item for item in items if not isinstance(item, Errata)]
    cells = [cell for item in shown if isinstance(item, Table) for cell in item.cells]
    claims = [claim for item in shown for claim in item.claims]
    figures = sum(isinstance(item, Figure) for item in shown)
    lines = [said("summary.items", figures=figures, tables=len(shown) - figures)]
    if cells:
        ways = [cell.agreement for cell in cells]
        counts = {way: ways.count(way) for way in _TONES}
        lines.append(said("summary.cells", total=len(ways), **counts))
    for key, of_theory in (("summary.stated", False), ("summary.expected", True)):
        found = [claim.verdict for claim in claims if claim.of_theory is of_theory]
        if found:
            verdicts = {verdict: found.count(verdict) for verdict in _VERDICTS}
            lines.append(said(key, total=len(found), **verdicts))
    lines += [_misprints_sentence(item) for item in items if isinstance(item, Errata)]
    return tuple(lines)


def _misprints_sentence(errata: Errata) -> Text:
    """Count misprints, and what was checked and is right."""
    return said(
        "summary.misprints",
        misprints=len(errata.misprints),
        attitudes=errata.attitudes,
        power=power_text(max(one.corrected_residual.maximum for one in errata.misprints)),
        valid=len(errata.valid),
    )


def _gap_sentence(figure: Figure) -> Text:
    """Name the rows of a figure that have no result, and why."""
    codes = [code for _, code in figure.gaps]
    reasons = [
        str(said("counted_reason", reason=said(f"reason.{code}"), count=codes.count(code)))
        for code in sorted(set(codes))
    ]
    return said(
        "gaps", missing=len(codes), total=len(figure.columns[0].values), reasons=", ".join(reasons)
    )
