"""Documents as HTML: one file that needs no script and asks for nothing."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache, lru_cache
from html import escape
from itertools import count
from pathlib import Path
from typing import Final

from rolamento.document.cells import (
    PEAK,
    address,
    broken,
    cell,
    cells,
    characters,
    figure_spaced,
    has_unit_line,
    indexed,
    peaks,
    shares,
    shares_of_bars,
    stands_left,
    table_of_bars,
)
from rolamento.document.model import (
    Bars,
    Beside,
    Block,
    Column,
    Document,
    Equation,
    Figure,
    KeyValues,
    Links,
    Notes,
    Section,
    Statement,
    Symbol,
    Table,
    Title,
    Tone,
)
from rolamento.document.picture import (
    alternative_of,
    conclusion_of,
    formula,
    picture_address,
    picture_bytes,
)
from rolamento.errors import printable
from rolamento.words import ABSENT, language, languages, said, speaking

__all__ = ["STYLE", "PictureName", "body", "fragment", "html", "style"]

PictureName = Callable[[Figure], str | None]
"""Returns the name of the file that shows a figure; None where it is to be shown as usual."""

STYLE: Final = Path(__file__).with_name("page.css")
_WIDEST: Final = 110
"""Characters of a table that stands in one piece."""
_MOST_WITHOUT_CONTENTS: Final = 6
_LONG_TEXT: Final = 24
_FILES_TOO: Final = " 'self' file:"


def html(
    document: Document, *, picture: PictureName | None = None, stylesheet: str | None = None
) -> str:
    """Return a document as one HTML file: styles and pictures stand in it.

    Parameters
    ----------
    document
        What to show.
    picture
        For pictures that are files beside the page: the name of each.
    stylesheet
        Name of a file beside the page that holds `style`, which then does not stand in it.
    """
    with speaking(document.language):
        content = _Setter(document, picture).body()
        tag = languages()[language()].replace("_", "-")
    made = " ".join(("rolamento", document.kind)).strip()
    about = " · ".join(part for part in (document.program, document.date) if part)
    footer = f"<footer>{_text(about)}</footer>\n" if about else ""
    title = escape(_plain(document.title))
    styles = f"<style>\n{style()}</style>"
    if stylesheet is not None:
        styles = f'<link rel="stylesheet" href="{escape(stylesheet)}">'
    policy = _policy(_FILES_TOO if picture else "", _FILES_TOO if stylesheet else "")
    return (
        f'<!DOCTYPE html>\n<html lang="{tag}">\n<head>\n<meta charset="utf-8">\n'
        f'<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<meta name="color-scheme" content="light dark">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        f'<meta name="generator" content="{escape(made)}">\n'
        f"<title>{title}</title>\n{styles}\n</head>\n"
        f'<body class="rolamento">\n<main>\n{content}{footer}</main>\n'
        f"</body>\n</html>\n"
    )


def body(document: Document, *, images: bool = False) -> str:
    """Return a document as HTML without a style and without names, for a page that has its own.

    images: whether pictures are images that hold them, which may not ask for anything.
    """
    with speaking(document.language):
        return _Setter(document, None, named=False, images=images).body()


def fragment(document: Document) -> str:
    """Return a document as a piece of HTML with its style, for a notebook."""
    with speaking(document.language):
        tag = languages()[language()].replace("_", "-")
    return (
        f'<div class="rolamento notebook" lang="{tag}">\n<style>\n{style()}</style>\n'
        f"{body(document)}</div>\n"
    )


def _policy(of_pictures: str, of_styles: str) -> str:
    return f"default-src 'none'; style-src 'unsafe-inline'{of_styles}; img-src data:{of_pictures}"


@cache
def style() -> str:
    """Return the style sheet of all documents."""
    return STYLE.read_text(encoding="utf-8")


class _Setter:
    """Sets the parts of one document."""

    def __init__(
        self,
        document: Document,
        picture: PictureName | None,
        *,
        named: bool = True,
        images: bool = False,
    ) -> None:
        self._document, self._picture, self._named, self._images = document, picture, named, images
        headed = [section for section in document.parts() if section.heading]
        self._highest = min((section.level for section in headed), default=2)
        self._depths = document.depths
        self._headings: list[tuple[str, Section]] = []
        self._top = ""
        self._taken: set[str] = set()
        self._drawn = count(1)
        self._by_block: dict[type, Callable[..., str]] = {
            Title: self._title,
            Statement: _statement,
            KeyValues: _key_values,
            Table: _table,
            Bars: _bars,
            Figure: self._figure,
            Notes: _notes,
            Equation: _equation,
            Links: _links,
        }

    def body(self) -> str:
        """Return title and sections, the contents before the first section with a heading."""
        before: list[str] = []
        behind: list[str] = []
        for part in self._document.sections:
            text = self._part(part)
            (behind if self._headings else before).append(text)
        contents = self._contents() if self._named else ""
        return "".join([self._top, *before, contents, *behind])

    def _contents(self) -> str:
        """Return links to the sections, where there are many."""
        if len(self._headings) <= _MOST_WITHOUT_CONTENTS:
            return ""
        items = "".join(
            _element(
                "li",
                f'<a href="#{name}">{_text(section.heading)}</a>',
                classes="deeper" if section.level > self._highest else "",
            )
            for name, section in self._headings
            if section.level <= self._highest + 1
        )
        label = escape(said("Contents"))
        return f'<nav aria-label="{label}"><strong>{label}</strong><ol>{items}</ol></nav>\n'

    def _part(self, part: Section | Beside) -> str:
        if isinstance(part, Section):
            return self._section(part)
        halves = (
            _element("div", "".join(map(self._section, sections)))
            for sections in (part.left, part.right)
        )
        return _element("div", "".join(halves), classes="beside") + "\n"

    def _section(self, section: Section) -> str:
        name, heading = self._name(section), ""
        if section.heading:
            self._headings.append((name, section))
            level = min(2 + self._depths[section.level], 6)
            heading = _element(f"h{level}", _text(section.heading)) + "\n"
        blocks = "\n".join(filter(None, map(self._block, section.blocks)))
        if not heading and not blocks:
            return ""
        attributes = {"id": name} if self._named else {}
        return _element("section", f"\n{heading}{blocks}\n", **attributes) + "\n"

    def _name(self, section: Section) -> str:
        """Return an identifier that no other section has."""
        wanted = section.key or section.heading
        base = re.sub(r"[^a-z0-9]+", "-", wanted.lower()).strip("-") or "section"
        name = next(
            n for i in count(1) if (n := base if i == 1 else f"{base}-{i}") not in self._taken
        )
        self._taken.add(name)
        return name

    def _block(self, block: Block) -> str:
        return self._by_block[type(block)](block)

    def _title(self, block: Title) -> str:
        if self._top:
            return _element("h2", _text(block.text), classes="title")
        self._top = _element("h1", _text(block.text)) + "\n"
        return ""

    def _figure(self, block: Figure) -> str:
        name = self._picture(block) if self._picture else None
        figure = block.draw() if name is None and block.draw is not None else None
        alternative = escape(_plain(alternative_of(block, figure)))
        if figure is not None and self._images:
            name = picture_address(figure)
        if name is not None:
            shown = f'<img src="{escape(name)}" alt="{alternative}">'
        elif figure is not None:
            drawn = picture_bytes(figure, "svg", transparent=True).decode("utf-8")
            shown = _inline(drawn, f"p{next(self._drawn)}", alternative)
        elif block.sketch is not None:
            lines = ("".join(_toned(*piece) for piece in line) for line in block.sketch(80, True))
            shown = f'<pre role="img" aria-label="{alternative}">{chr(10).join(lines)}</pre>'
        else:
            shown = ""
        conclusion = conclusion_of(block, figure)
        below = [_text(block.caption)] if block.caption else []
        below += [_element("span", _text(conclusion), classes="says")] if conclusion else []
        caption = _element("figcaption", "<br>\n".join(below)) if below else ""
        return f"<figure>\n{shown}\n{caption}</figure>" if shown or caption else ""


# --- texts -------------------------------------------------------------------------------------


def _plain(text: str) -> str:
    return " ".join(printable(text).split())


@lru_cache(maxsize=1024)
def _text(text: str) -> str:
    """Return a text that cannot act, its lines broken, its symbols with an index.

    The labels of a page that follows a slider are the same each time.
    """
    pieces = (
        escape(printable(piece)) + (f"<sub>{escape(index)}</sub>" if index else "")
        for piece, index in indexed(text)
    )
    return "".join(pieces).replace("\n", "<br>\n")


def _element(
    tag: str, content: str, *, classes: str = "", style: str = "", **attributes: str
) -> str:
    known = {"class": classes, "style": style, **attributes}
    written = "".join(f' {name}="{value}"' for name, value in known.items() if value)
    return f"<{tag}{written}>{content}</{tag}>"


def _toned(text: str, tone: Tone) -> str:
    return _element("span", escape(printable(text)), classes=tone) if tone else escape(text)


def _statement(block: Statement) -> str:
    style = f"margin-left:{block.indent}ch" if block.indent else ""
    if block.verbatim:
        return _element("pre", escape(printable(block.text)), classes="code", style=style)
    text = _text(block.text)
    if block.mark:
        sign = _element("span", _text(block.mark), classes=f"sign {block.mark_tone}".strip())
        text = f"{sign}<span>{text}</span>"
    return _element("p", text, classes=block.tone, style=style)


def _key_values(block: KeyValues) -> str:
    items = "".join(
        _element("dt", _text(entry.label), classes=block.label_tone, style=_indent(entry.label))
        + _element("dd", _text(_content(entry.content)), classes=entry.tone)
        for entry in block.entries
    )
    style = f"margin-left:{block.indent}ch" if block.indent else ""
    return _element("dl", items, style=style)


def _content(content: object) -> str:
    return content if isinstance(content, str) else cell(content)  # type: ignore[arg-type]


def _indent(label: str) -> str:
    """Return the room for the spaces that a label begins with."""
    spaces = len(label) - len(label.lstrip(" "))
    return f"padding-left:{0.6 * spaces:.1f}em" if spaces else ""


def _notes(block: Notes) -> str:
    items = "".join(
        _element("li", _text(remark.text), classes=remark.tone) for remark in block.remarks
    )
    return _element("ul", items, classes="notes")


def _links(block: Links) -> str:
    items = []
    for link in block.links:
        target = address(link.target)
        items.append(
            f'<a href="{escape(target)}">{_text(link.text)}</a>'
            if target
            else _text(f"{link.text}: {link.target}")
        )
    return _element("p", " · ".join(items), classes="links")


# --- tables ------------------------------------------------------------------------------------


def _table(block: Table) -> str:
    if block.only_in_files:
        return ""
    parts: list[str] = []
    for heading, part in broken(block, lambda table: characters(table) <= _WIDEST):
        caption = block.caption if not parts else ""
        title = _element("caption", _text(heading or caption), classes="part" * bool(heading))
        parts.append(_one_table(part, title if heading or caption else ""))
    return "\n".join(parts)


def _one_table(block: Table, caption: str) -> str:
    columns = [_Cells(column) for column in block.columns]
    rows = max((len(one.texts) for one in columns), default=0)
    names = dict(block.groups)
    lines = [caption] if caption else []
    if not block.headless:
        heads = "".join(_head(column, block) for column in block.columns)
        lines.append(f"<thead><tr>{heads}</tr></thead>")
    lines.append("<tbody>")
    for row in range(rows):
        if row in names:
            lines += ["</tbody>\n<tbody>"] * (row > 0)
            head = _element("th", _text(names[row]), classes="group", colspan=str(len(columns)),
                            scope="rowgroup")  # fmt: skip
            lines.append(f"<tr>{head}</tr>")
        cells_ = "".join(one.cell(row, first=place == 0) for place, one in enumerate(columns))
        lines.append(f"<tr>{cells_}</tr>")
    lines.append("</tbody>")
    legends = "".join(
        _element("p", _text(text), classes="legend") for text in block.legends if text
    )
    # what can be scrolled has to be reached by the keyboard
    table = _element("table", "\n" + "\n".join(lines) + "\n")
    return f'<div class="scroll" tabindex="0">{table}</div>{legends}'


def _head(column: Column, block: Table) -> str:
    classes = "left" if stands_left(column) or column.bar else ""
    room = '<span class="sign-of-peak"></span>' if column.peak else ""
    unit = "" if column.bar else column.unit
    if has_unit_line(block):
        written = f'<span class="unit below">{escape(unit)}{room}</span>'
    else:
        written = f' <span class="unit">{escape(unit)}</span>' if unit else ""
    if not column.head and not unit:
        return _element("td", "", classes=classes)
    return _element("th", _text(column.head) + room + written, classes=classes, scope="col")


class _Cells:
    """The cells of one column."""

    def __init__(self, column: Column) -> None:
        self._column = column
        self.texts = cells(column)
        self._tops = peaks(column)
        self._tones = column.tones or [column.tone] * len(self.texts)
        self._left = stands_left(column)
        self._shares = shares(column) if column.bar else []

    def cell(self, row: int, *, first: bool) -> str:
        """Return one cell; the first of a line is its head."""
        if self._column.bar:
            return _bar(self._shares[row])
        text, top, tone = self.texts[row], self._tops[row], self._tones[row]
        classes: list[str] = ["peak" if top else tone]
        if text.strip() == ABSENT:
            classes = ["faint"]
        classes += ["left"] * self._left
        classes += ["words"] * (len(text) > _LONG_TEXT)
        shown = _text(text.strip() if self._left else figure_spaced(text).lstrip(" "))
        if self._column.peak:
            label = said("minimum") if self._column.peak == "minimum" else said("maximum")
            sign = f'<span role="img" aria-label="{escape(label)}">{PEAK}</span>' if top else ""
            shown += f'<span class="sign-of-peak">{sign}</span>'
        style = _indent(text) if self._left else ""
        if first and text.strip():
            return _element("th", shown, classes=" ".join(filter(None, classes)), style=style,
                            scope="row")  # fmt: skip
        return _element("td", shown, classes=" ".join(filter(None, classes)), style=style)


def _bar(share: float) -> str:
    """Return a cell with a bar; screen readers have its number in another."""
    width = f"{100.0 * share:.1f}%" if share > 0.0 else "0"
    return f'<td class="bar" aria-hidden="true"><span style="width:{width}"></span></td>'


def _bars(block: Bars) -> str:
    labels, numbers = (_Cells(column) for column in table_of_bars(block).columns)
    table = table_of_bars(block)
    lines = []
    if not table.headless:
        heads = "".join(_head(column, table) for column in table.columns)
        lines.append(f"<thead><tr>{heads}<td></td></tr></thead>")
    lines.append("<tbody>")
    for row, share in enumerate(shares_of_bars(block)):
        bar = _bar(share)
        lines.append(
            f"<tr>{labels.cell(row, first=True)}{numbers.cell(row, first=False)}{bar}</tr>"
        )
    lines.append("</tbody>")
    legends = "".join(
        _element("p", _text(text), classes="legend") for text in block.legends if text
    )
    drawn = _element("table", "\n" + "\n".join(lines) + "\n", classes="bars")
    return f'<div class="scroll" tabindex="0">{drawn}</div>{legends}'


# --- equations and pictures --------------------------------------------------------------------


def _equation(block: Equation) -> str:
    drawn = formula(block.latex) if block.latex else None
    if drawn is None:
        shown = _element("div", _text(block.plain), classes="formula plain")
    else:
        label = escape(_plain(block.plain))
        drawing = drawn.svg(f' role="img" aria-label="{label}"')
        shown = _element("div", drawing, classes="formula", tabindex="0")  # it may scroll
    number = f'<div class="number">({block.number})</div>' if block.number else ""
    parts = [_element("p", _text(block.name), classes="name")] if block.name else []
    parts.append(_element("div", shown + number, classes="set"))
    if block.symbols:
        parts.append(_element("dl", "".join(map(_symbol, block.symbols))))
    for text in (block.valid, block.source):
        if text:
            parts.append(_element("p", _text(text), classes="source"))
    attributes = {"id": f"equation-{block.number}"} if block.number else {}
    return _element("div", "".join(parts), classes="equation", **attributes)


def _symbol(symbol: Symbol) -> str:
    unit = f' <span class="unit">[{escape(symbol.unit)}]</span>' if symbol.unit else ""
    return f"<dt>{_text(symbol.symbol)}</dt><dd>{_text(symbol.meaning)}{unit}</dd>"


_NOT_SHOWN: Final = re.compile(r"<!--.*?-->|<metadata>.*?</metadata>|<style.*?</style>", re.S)
_IDENTIFIER: Final = re.compile(r'(\bid="|\bxlink:href="#|\burl\(#)')
_STROKES: Final = "stroke-linejoin:round;stroke-linecap:butt"
"""What the style that is left out says of all its lines."""
_OPENING: Final = re.compile(r"<svg\b([^>]*)>")


def _inline(drawing: str, prefix: str, alternative: str) -> str:
    """Return an SVG file as an element, its identifiers unlike those of other pictures."""
    element = _NOT_SHOWN.sub("", drawing[drawing.index("<svg") :])
    element = _IDENTIFIER.sub(rf"\g<1>{prefix}-", element)
    more = f' role="img" aria-label="{alternative}" style="{_STROKES}">'
    return _OPENING.sub(lambda found: f"<svg{found[1]}{more}", element, count=1).strip()
