"""The pages of a reproduction: made once, of blocks in both languages; as HTML and as Markdown.

The index shows every figure and table with what the source says of them; a page of its own has the
misprints. An HTML page is one file that needs nothing but the pictures beside it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Final, NamedTuple

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
from rolamento_reproductions.text import (
    Language,
    Text,
    in_both,
    localised,
    said,
    same,
    with_indices,
)

PRINTED: Final = said("printed", "impresso")
REASONS: Final[Mapping[str, Text]] = {
    "no_equilibrium": said("there is no equilibrium", "não há equilíbrio"),
    "not_converged": said("not converged", "não convergiu"),
    "overloaded": said("overloaded", "sobrecarga"),
    "unheld_ball": said("a ball is not held", "uma esfera sem apoio"),
    "over_shoulder": said("a ball rides over the shoulder", "uma esfera passa do rebordo da pista"),
    "invalid_input": said("invalid input", "entrada inválida"),
}
"""Why a point of a figure has no result, by its status."""

_FIGURE: Final = said("Figure", "Figura")
_TABLE: Final = said("Table", "Tabela")
_STATED: Final = said("What the text says, and what is found", "O que o texto diz e o que se obtém")
_EXPECTED: Final = said(
    "What theory lets expect, and what is found", "O que a teoria permite esperar e o que se obtém"
)
_MISPRINTS: Final = said("Misprints", "Erros de impressão")
_EQUATION: Final = said("Equation", "Equação")
_QUANTITY: Final = said("Quantity", "Grandeza")
_MAX_RESIDUAL: Final = said("maximum residual", "resíduo máximo")
_DATA: Final = said("data (CSV)", "dados (CSV)")
_COMPUTED: Final = said("computed", "calculado")
_VALID_AS_PRINTED: Final = said("Valid as printed", "Vale como impresso")
_PROOF: Final = said(
    "Proof: residual of each form against vectors, over the largest term, attitude by attitude.",
    "Prova: resíduo de cada forma em relação aos vetores, dividido pelo maior termo, posição a"
    " posição.",
)
_VERDICTS: Final[Mapping[ClaimVerdict, Text]] = {
    "holds": said("Holds.", "Confirma-se."),
    "partly": said("Holds in part.", "Confirma-se em parte."),
    "fails": said("Does not hold.", "Não se confirma."),
}
_AGREEMENTS: Final[Mapping[Agreement, Text]] = {
    "printed": said("as printed", "como impresso"),
    "tie": said(
        "as printed but for a tie: the last digit rounds either way",
        "como impresso, salvo empate no arredondamento do último dígito",
    ),
    "cut": said(
        "as printed, with the digits cut, not rounded",
        "como impresso, com os dígitos cortados, não arredondados",
    ),
    "differs": said("differs", "difere"),
}


# --- blocks -------------------------------------------------------------------


class Heading(NamedTuple):
    """Of a part, with the place that the contents point to."""

    text: Text
    anchor: str = ""


class Paragraph(NamedTuple):
    """A text, and links behind it: what they are called, and where they lead."""

    text: Text
    links: tuple[tuple[Text, str], ...] = ()
    small: bool = False


class Lines(NamedTuple):
    """Short texts below each other, as points or as one paragraph."""

    texts: tuple[Text, ...]
    points: bool = True


class Formula(NamedTuple):
    """What a formula is, and the formula."""

    name: Text
    text: Text


class Contents(NamedTuple):
    """The parts of a page: title, what is in it, anchor."""

    entries: tuple[tuple[Text, Text, str], ...]


class Claims(NamedTuple):
    """Statements under their heading, each with what is found."""

    heading: Text
    claims: tuple[Claim, ...]


class Picture(NamedTuple):
    """A picture with its number and caption."""

    file: str
    name: Text
    caption: Text


class Grid(NamedTuple):
    """A table, column by column; number and caption if it has its own."""

    columns: tuple[TableColumn, ...]
    name: Text | None = None
    caption: Text | None = None


class Frame(NamedTuple):
    """A figure or a table with all that belongs to it."""

    stem: str
    figure: bool
    blocks: tuple[Block, ...]


class Command(NamedTuple):
    """What writes the page."""

    name: str


Block = Heading | Paragraph | Lines | Formula | Contents | Claims | Picture | Grid | Frame | Command


@dataclass(frozen=True, slots=True)
class Page:
    """A page of a source."""

    source: str
    title: Text
    blocks: tuple[Block, ...]


def index_page(source: Source, sections: Sequence[Section], endings: Sequence[Ending]) -> Page:
    """Return the page of all figures and tables.

    Parameters
    ----------
    source
        What is reproduced.
    sections
        With everything computed.
    endings
        Of the pictures that lie beside the page; the first is shown.
    """
    blocks: list[Block] = [Paragraph(text) for text in source.remarks]
    blocks.append(Lines(summary(sections), points=False))
    anchors = [f"part-{place}" for place in range(1, len(sections) + 1)]
    named = zip(sections, anchors, strict=True)
    blocks.append(Contents(tuple((s.title, _contents_of(s), anchor) for s, anchor in named)))
    for section, anchor in zip(sections, anchors, strict=True):
        blocks.append(Heading(section.title, anchor))
        for item in section.items:
            if isinstance(item, Errata):
                blocks += _pointer_to_misprints(item)
            else:
                blocks.append(_framed(item, endings))
    return Page(source.name, source.title, (*blocks, Command(source.name)))


def misprints_page(source: Source, errata: Errata) -> Page:
    """Return the page of a publication's misprints, each with its derivation and its proof."""
    blocks: list[Block] = [
        *map(Paragraph, (errata.caption, _misprints_sentence(errata), *errata.remarks)),
        Paragraph(
            _EMPTY, ((said("All figures and tables", "Todas as figuras e tabelas"), "index"),)
        ),
        Heading(said("Proof by numbers", "Prova numérica")),
        Paragraph(_PROOF),
        _proof_grid(errata),
    ]
    for one in errata.misprints:
        blocks += [
            Heading(same("{}: {}", one.place, one.what)),
            Formula(said("Printed", "Impresso"), one.printed),
            Formula(said("Should be", "O correto"), one.corrected),
            Paragraph(said("Derivation:", "Dedução:"), small=True),
            Paragraph(one.derivation),
        ]
    blocks += [Heading(_VALID_AS_PRINTED), _grid_of_valid(errata)]
    return Page(source.name, same("{}: {}", _MISPRINTS, source.title), tuple(blocks))


_EMPTY: Final = same("")


def _framed(item: Figure | Table, endings: Sequence[Ending]) -> Frame:
    """Put a figure or a table together with its inputs, files, statements and notes."""
    figure = isinstance(item, Figure)
    pictures = [(same(ending.upper()), f"{item.stem}.{ending}") for ending in endings]
    links = (*(pictures if figure else ()), (_DATA, f"{item.stem}.csv"))
    name = same("{} {}", _FIGURE if figure else _TABLE, same(item.number))
    shown: Block
    if isinstance(item, Figure):
        shown = Picture(f"{item.stem}.{endings[0]}", name, item.caption)
    else:
        shown = Grid(item.columns, name, item.caption)
    blocks: list[Block] = [
        shown,
        Paragraph(said("Inputs: {}.", "Dados: {}.", item.source), links, small=True),
    ]
    for heading, of_theory in ((_STATED, False), (_EXPECTED, True)):
        claims = tuple(claim for claim in item.claims if claim.of_theory is of_theory)
        blocks += [Claims(heading, claims)] if claims else []
    blocks += map(Paragraph, item.notes)
    if isinstance(item, Figure) and item.gaps:
        blocks.append(Paragraph(_gap_sentence(item)))
    return Frame(item.stem, figure, tuple(blocks))


def _pointer_to_misprints(errata: Errata) -> Iterator[Block]:
    """Name the misprints, and point to the page that has them."""
    yield Paragraph(same("{} {}", errata.caption, _misprints_sentence(errata)))
    yield Lines(tuple(same("{}: {}", m.place, m.what) for m in errata.misprints))
    yield Paragraph(_EMPTY, ((_MISPRINTS, errata.stem), (_DATA, f"{errata.stem}.csv")))


def _proof_grid(errata: Errata) -> Grid:
    """The residuals of every misprint, as printed and as corrected."""
    ones = errata.misprints
    return Grid(
        (
            TableColumn("equation", _EQUATION, tuple(one.place for one in ones)),
            TableColumn("quantity", _QUANTITY, tuple(one.what for one in ones)),
            TableColumn(
                "median",
                said("As printed: median residual", "Como impresso: resíduo mediano"),
                tuple(_few_digits(one.printed_residual.median) for one in ones),
            ),
            TableColumn(
                "maximum",
                said("As printed: {}", "Como impresso: {}", _MAX_RESIDUAL),
                tuple(_few_digits(one.printed_residual.maximum) for one in ones),
            ),
            TableColumn(
                "corrected",
                said("Corrected: {}", "Corrigida: {}", _MAX_RESIDUAL),
                tuple(_power_above(one.corrected_residual.maximum) for one in ones),
            ),
        )
    )


def _grid_of_valid(errata: Errata) -> Grid:
    """The equations that are valid as printed, with what rounding leaves of them."""
    ones = errata.valid
    return Grid(
        (
            TableColumn("equation", _EQUATION, tuple(same(f"({one.number})") for one in ones)),
            TableColumn("quantity", _QUANTITY, tuple(one.what for one in ones)),
            TableColumn("form", said("Form", "Forma"), tuple(one.form for one in ones)),
            TableColumn(
                "residual", _MAX_RESIDUAL, tuple(_power_above(one.residual.maximum) for one in ones)
            ),
        )
    )


def _power_above(value: float) -> Text:
    """Rounding differs from machine to machine: the power of ten above it."""
    return same(f"< {power_text(value)}")


def _few_digits(value: float) -> Text:
    template = "{:.0f}" if value >= 10.0 else "{:.2f}" if value >= 0.1 else "{:.2g}"
    return said(template, template, value)


# --- sentences ----------------------------------------------------------------


def summary(sections: Sequence[Section]) -> tuple[Text, ...]:
    """Count figures, printed numbers, statements and misprints, and how they agree."""
    items = [item for section in sections for item in section.items]
    shown = [item for item in items if not isinstance(item, Errata)]
    cells = [cell for item in shown if isinstance(item, Table) for cell in item.cells]
    claims = [claim for item in shown for claim in item.claims]
    figures = sum(isinstance(item, Figure) for item in shown)
    counted = figures, len(shown) - figures
    lines = [said("{} figures, {} tables.", "{} figuras, {} tabelas.", *counted)]
    if cells:
        ways = [cell.agreement for cell in cells]
        lines.append(
            said(
                "Of {} printed numbers {} are what the computed ones round to, {} a tie of"
                " rounding, {} cut instead of rounded; {} differ.",
                "De {} números impressos, {} são o arredondamento dos calculados, {} um empate de"
                " arredondamento, {} cortado em vez de arredondado; {} diferem.",
                len(ways),
                *(ways.count(way) for way in _AGREEMENTS),
            )
        )
    for of_theory, *templates in (
        (
            False,
            "Of {} statements in the text {} hold, {} in part; {} not.",
            "De {} afirmações do texto, {} se confirmam, {} em parte; {} não.",
        ),
        (
            True,
            "Of {} expectations of theory {} hold, {} in part; {} not.",
            "De {} expectativas da teoria, {} se confirmam, {} em parte; {} não.",
        ),
    ):
        verdicts = [claim.verdict for claim in claims if claim.of_theory is of_theory]
        if verdicts:
            counts = (verdicts.count(verdict) for verdict in _VERDICTS)
            lines.append(said(templates[0], templates[1], len(verdicts), *counts))
    lines += [_misprints_sentence(item) for item in items if isinstance(item, Errata)]
    return tuple(lines)


def _misprints_sentence(errata: Errata) -> Text:
    """Count misprints, and what was checked and is right."""
    return said(
        "{} misprints, each with its derivation and a proof at {} random attitudes; corrected,"
        " what is left is below {}. {} other equations are valid as printed.",
        "{} erros de impressão, cada um com dedução e prova em {} posições aleatórias; corrigidos,"
        " o que resta é menor que {}. {} outras equações valem como impressas.",
        len(errata.misprints),
        errata.attitudes,
        power_text(max(one.corrected_residual.maximum for one in errata.misprints)),
        len(errata.valid),
    )


def _contents_of(section: Section) -> Text:
    """Return the numbers of a section's figures and tables, such as "5.27–5.32, table 5.4"."""
    figures = [item.number for item in section.items if isinstance(item, Figure)]
    tables = ", ".join(item.number for item in section.items if isinstance(item, Table))
    parts = [same("–".join(dict.fromkeys((figures[0], figures[-1]))))] if figures else []
    if "," in tables:
        parts.append(said("tables {}", "tabelas {}", same(tables)))
    elif tables:
        parts.append(said("table {}", "tabela {}", same(tables)))
    if any(isinstance(item, Errata) for item in section.items):
        parts.append(in_both(lambda code: _MISPRINTS.speak(code).lower()))
    return in_both(lambda code: ", ".join(part.speak(code) for part in parts))


def _gap_sentence(figure: Figure) -> Text:
    """Tell of the rows of a figure that have no result, and why."""
    codes = [code for _, code in figure.gaps]
    reasons = in_both(
        lambda language: ", ".join(
            f"{REASONS[code].speak(language)} ({codes.count(code)})" for code in sorted(set(codes))
        )
    )
    return said(
        "Gaps: {} of {} points have no result: {}.",
        "Lacunas: {} de {} pontos não têm resultado: {}.",
        len(codes),
        len(figure.columns[0].values),
        reasons,
    )


# --- HTML ---------------------------------------------------------------------

_STYLE: Final = """
:root { color-scheme: light; }
body { margin: 0 auto; max-width: 60rem; padding: 1.5rem; color: #202020; background: #fff;
  font: 1rem/1.5 system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif; }
h1 { font-size: 1.6rem; line-height: 1.25; }
h2 { margin-top: 3rem; border-bottom: 1px solid #d0d0d0; font-size: 1.25rem; }
nav ul { columns: 2; padding-left: 1.2rem; }
a { color: #005a91; }
figure, section.table { margin: 2rem 0; }
figure img { display: block; max-width: 100%; height: auto; }
figcaption, .caption { margin: .6rem 0; }
.number { font-weight: 600; }
.small { color: #505050; font-size: .875rem; }
.formula { margin: .2rem 0 .2rem 1.2rem; font-family: Cambria, "STIX Two Text", Georgia, serif; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .9rem; }
.wide { overflow-x: auto; }
th, td { padding: .15rem .7rem; border-bottom: 1px solid #e0e0e0; text-align: right; }
th { vertical-align: bottom; }
th:first-child, td:first-child { text-align: left; }
td.sentence { text-align: left; min-width: 16rem; }
td.computed { color: #505050; }
td.tie, td.cut { background: #fdf3d8; }
td.differs { background: #f8d7c8; }
.claims { margin: .3rem 0; padding: 0; list-style: none; }
.claims li { margin: .35rem 0; padding-left: .8rem; border-left: 4px solid #009e73; }
.claims li.partly { border-color: #e69f00; }
.claims li.fails { border-color: #d55e00; }
@media print { body { max-width: none; padding: 0; font-size: 10pt; }
  figure, section.table, li { break-inside: avoid; } nav { display: none; } }
"""


def generator_mark(name: str) -> str:
    """Return the line by which a page of ours is known again."""
    return f'<meta name="generator" content="rolamento reproduce {escape(name)}">'


def html(page: Page, language: Language) -> str:
    """Write a page as one HTML file."""
    lines = [
        "<!DOCTYPE html>",
        f'<html lang="{"pt-BR" if language == "pt" else "en"}">',
        "<head>",
        '<meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        generator_mark(page.source),
        f"<title>{escape(page.title.speak(language))}</title>",
        f"<style>{_STYLE}</style>",
        "</head>",
        "<body>",
        f"<h1>{_indexed_html(page.title.speak(language))}</h1>",
    ]
    for block in page.blocks:
        lines += _html_lines(block, language)
    return "\n".join([*lines, "</body>", "</html>", ""])


def _html_lines(block: Block, language: Language) -> Iterable[str]:
    """Write a block as HTML."""

    def shown(text: Text) -> str:
        return _indexed_html(text.speak(language))

    def link(text: Text, target: str) -> str:
        file = escape(target if "." in target else f"{target}.html", quote=True)
        return f'<a href="{file}">{escape(text.speak(language))}</a>'

    match block:
        case Heading(text, anchor):
            yield f'<h2 id="{anchor}">{shown(text)}</h2>' if anchor else f"<h2>{shown(text)}</h2>"
        case Paragraph(text, links, small):
            linked = ", ".join(link(*one) for one in links)
            kind = ' class="small"' if small else ""
            yield f"<p{kind}>{' '.join(filter(None, (shown(text), linked)))}</p>"
        case Lines(texts, points) if points:
            yield "<ul>\n" + "\n".join(f"<li>{shown(text)}</li>" for text in texts) + "\n</ul>"
        case Lines(texts):
            yield "<p>" + "<br>\n".join(map(shown, texts)) + "</p>"
        case Formula(name, text):
            yield f'<p class="small">{escape(name.speak(language))}:</p>'
            yield f'<p class="formula">{shown(text)}</p>'
        case Contents(entries):
            yield "<nav><ul>"
            for title, numbers, anchor in entries:
                yield (
                    f'<li><a href="#{anchor}">{shown(title)}</a>'
                    f' <span class="small">{escape(numbers.speak(language))}</span></li>'
                )
            yield "</ul></nav>"
        case Claims(heading, claims):
            yield f'<p class="small">{escape(heading.speak(language))}:</p>'
            yield '<ul class="claims">'
            for claim in claims:
                verdict = escape(_VERDICTS[claim.verdict].speak(language))
                yield (
                    f'<li class="{claim.verdict}">{shown(claim.statement)}<br>'
                    f"<strong>{verdict}</strong> {shown(claim.finding)}</li>"
                )
            yield "</ul>"
        case Picture(file, name, caption):
            told = escape(f"{name.speak(language)}. {caption.speak(language)}", quote=True)
            yield f'<img src="{escape(file, quote=True)}" alt="{told}" loading="lazy">'
            number = f'<span class="number">{shown(name)}.</span>'
            yield f"<figcaption>{number} {shown(caption)}</figcaption>"
        case Grid(columns, name, caption):
            if name is not None and caption is not None:
                number = f'<span class="number">{shown(name)}.</span>'
                yield f'<p class="caption">{number} {shown(caption)}</p>'
            yield '<div class="wide"><table>'
            yield from _html_heads(columns, language)
            rows = zip(*(_html_cells(column, language) for column in columns), strict=True)
            yield from ("<tr>" + "".join(row) + "</tr>" for row in rows)
            yield "</table></div>"
        case Frame(stem, figure, blocks):
            kind = "figure" if figure else 'section class="table"'
            yield f'<{kind} id="{escape(stem, quote=True)}">'
            for inner in blocks:
                yield from _html_lines(inner, language)
            yield "</figure>" if figure else "</section>"
        case Command(name):
            command = escape(f"rolamento reproduce {name}")
            by = escape(_REGENERATED.speak(language))
            yield f'<p class="small">{by} <code>{command}</code>.</p>'


def _html_heads(columns: Sequence[TableColumn], language: Language) -> Iterable[str]:
    """Write the heads: one row, or a second one for what is printed and computed."""
    above, below = [], []
    rows = 2 if any(column.compared for column in columns) else 1
    for column in columns:
        title = _indexed_html(column.title.speak(language))
        if column.compared:
            above.append(f'<th colspan="2">{title}</th>')
            below += [f"<th>{escape(word.speak(language))}</th>" for word in _pair_heads(column)]
        else:
            above.append(f'<th rowspan="{rows}">{title}</th>')
    yield "<tr>" + "".join(above) + "</tr>"
    if below:
        yield "<tr>" + "".join(below) + "</tr>"


def _html_cells(column: TableColumn, language: Language) -> list[str]:
    cells = []
    for cell in column.cells:
        if isinstance(cell, Cell):
            way = cell.agreement
            told = escape(_AGREEMENTS[way].speak(language), quote=True)
            printed, computed = (localised(text, language) for text in (cell.printed, cell.text))
            cells.append(
                f"<td>{escape(printed)}</td>"
                f'<td class="computed {way}" title="{told}">{escape(computed)}</td>'
            )
        else:
            text = cell.speak(language) if isinstance(cell, Text) else localised(cell, language)
            opening = '<td class="sentence">' if column.sentences else "<td>"
            cells.append(f"{opening}{_indexed_html(text)}</td>")
    return cells


def _pair_heads(column: TableColumn) -> tuple[Text, Text]:
    return column.heads or (PRINTED, _COMPUTED)


def _indexed_html(text: str) -> str:
    """Escape a text, and set the indices of its symbols below the line."""
    return with_indices(escape(text), lambda symbol, index: f"<i>{symbol}</i><sub>{index}</sub>")


_REGENERATED: Final = said("Written by", "Escrito por")


# --- Markdown -----------------------------------------------------------------

_SPECIAL: Final = re.compile(r"([\\`*\[\]|])")


def markdown(page: Page, language: Language) -> str:
    """Write a page as Markdown, for places that show files of a repository."""
    parts = [f"# {_indexed_markdown(page.title.speak(language))}"]
    for block in page.blocks:
        parts += _markdown_parts(block, language)
    return "\n\n".join(parts) + "\n"


def _markdown_parts(block: Block, language: Language) -> Iterable[str]:
    """Write a block as Markdown; what only a page to read on a screen needs is left out."""

    def shown(text: Text) -> str:
        return _indexed_markdown(text.speak(language))

    def link(text: Text, target: str) -> str:
        return f"[{text.speak(language)}]({target if '.' in target else f'{target}.md'})"

    match block:
        case Heading(text):
            yield f"## {shown(text)}"
        case Paragraph(text, links):
            linked = ", ".join(link(*one) for one in links)
            yield " ".join(filter(None, (shown(text), linked)))
        case Lines(texts):
            yield "\n".join(f"- {shown(text)}" for text in texts)
        case Formula(name, text):
            yield f"{name.speak(language)}: {shown(text)}"
        case Claims(heading, claims):
            yield f"{shown(heading)}:"
            yield "\n".join(
                f"- {shown(claim.statement)} **{_VERDICTS[claim.verdict].speak(language)}**"
                f" {shown(claim.finding)}"
                for claim in claims
            )
        case Picture(file, name, caption):
            yield f"![{name.speak(language)}]({file})"
            yield f"**{name.speak(language)}.** {shown(caption)}"
        case Grid(columns, name, caption):
            if name is not None and caption is not None:
                yield f"**{name.speak(language)}.** {shown(caption)}"
            entries = [_markdown_cells(column, language) for column in columns]
            rows = [
                "| " + " | ".join(cell for cells in row for cell in cells) + " |"
                for row in zip(*entries, strict=True)
            ]
            width = sum(len(column[0]) for column in entries)
            yield "\n".join([rows[0], "|" + "---|" * width, *rows[1:]])
        case Frame(blocks=blocks):
            for inner in blocks:
                yield from _markdown_parts(inner, language)
        case Command(name):
            yield f"{_REGENERATED.speak(language)} `rolamento reproduce {name}`."


def _markdown_cells(column: TableColumn, language: Language) -> list[list[str]]:
    """Return a column of a table, head first, each entry as one cell or two; bold what differs."""
    title = _indexed_markdown(column.title.speak(language))
    entries = [[title]]
    if column.compared:
        entries = [[f"{title} {word.speak(language)}".strip() for word in _pair_heads(column)]]
    for cell in column.cells:
        if isinstance(cell, Cell):
            printed, computed = (localised(text, language) for text in (cell.printed, cell.text))
            differs = cell.agreement == "differs"
            entries.append([printed, f"**{computed}**" if differs else computed])
        else:
            text = cell.speak(language) if isinstance(cell, Text) else localised(cell, language)
            entries.append([_indexed_markdown(text)])
    return entries


def _indexed_markdown(text: str) -> str:
    """Escape what Markdown would read as marks, and set indices below the line."""
    plain = _SPECIAL.sub(r"\\\1", escape(text, quote=False))
    return with_indices(plain, lambda symbol, index: f"*{symbol}*<sub>{index}</sub>")
