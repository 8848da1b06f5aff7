"""The index page of a reproduction: one HTML file that needs nothing but the pictures beside it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from typing import Final

from rolamento_reproductions.errata import Errata
from rolamento_reproductions.printed import Cell
from rolamento_reproductions.record import Claim, Figure, Section, Source, Table, TableColumn
from rolamento_reproductions.text import Language, Text, localised, with_indices
from rolamento_reproductions.wording import (
    AGREEMENTS,
    COMPUTED,
    DATA,
    FIGURE,
    INPUTS,
    MISPRINTS,
    PRINTED,
    REGENERATED,
    TABLE,
    VERDICTS,
    claims_by_kind,
    contents_of,
    gap_sentence,
    misprints_sentence,
    summary,
)

__all__ = ["generator_mark", "head_of_page", "html_page", "marked"]

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
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .9rem; }
.wide { overflow-x: auto; }
th, td { padding: .15rem .7rem; border-bottom: 1px solid #e0e0e0; text-align: right; }
th { vertical-align: bottom; }
th:first-child, td:first-child { text-align: left; }
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
_SENTENCES: Final = """
td.sentence { text-align: left; min-width: 16rem; }
"""


def generator_mark(name: str) -> str:
    """Return the line by which a page of ours is known again."""
    return f'<meta name="generator" content="rolamento reproduce {escape(name)}">'


def html_page(
    source: Source, sections: Sequence[Section], endings: Sequence[str], language: Language
) -> str:
    """Write the page.

    Parameters
    ----------
    source
        What is reproduced.
    sections
        With everything computed.
    endings
        Of the pictures that lie beside the page; the first is shown.
    language
        Of the page.
    """
    lines = [
        *head_of_page(source, source.title, language, style=_more_style(sections)),
        *(f"<p>{marked(text, language)}</p>" for text in source.remarks),
        "<p>" + "<br>\n".join(marked(s, language) for s in summary(tuple(sections))) + "</p>",
        *_contents(sections, language),
    ]
    for place, section in enumerate(sections, start=1):
        lines.append(f'<h2 id="part-{place}">{marked(section.title, language)}</h2>')
        for item in section.items:
            lines += _item(item, endings, language)
    command = escape(f"rolamento reproduce {source.name}")
    written = escape(REGENERATED.speak(language))
    lines += [f'<p class="small">{written} <code>{command}</code>.</p>', "</body>", "</html>", ""]
    return "\n".join(lines)


def head_of_page(source: Source, title: Text, language: Language, *, style: str = "") -> list[str]:
    """Return what every page begins with, its title included; style: more of it."""
    return [
        "<!DOCTYPE html>",
        f'<html lang="{"pt-BR" if language == "pt" else "en"}">',
        "<head>",
        '<meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        generator_mark(source.name),
        f"<title>{escape(title.speak(language))}</title>",
        f"<style>{_STYLE}{style}</style>",
        "</head>",
        "<body>",
        f"<h1>{marked(title, language)}</h1>",
    ]


def _more_style(sections: Sequence[Section]) -> str:
    """Return what tables with sentences need beside the common style."""
    tables = [item for s in sections for item in s.items if isinstance(item, Table)]
    return _SENTENCES if any(c.sentences for table in tables for c in table.columns) else ""


def _item(
    item: Figure | Table | Errata, endings: Sequence[str], language: Language
) -> Iterable[str]:
    if isinstance(item, Errata):
        return _errata(item, language)
    return _figure(item, endings, language) if isinstance(item, Figure) else _table(item, language)


def _errata(errata: Errata, language: Language) -> Iterable[str]:
    """Name the misprints, and point to the page that has them."""
    told = (marked(text, language) for text in (errata.caption, misprints_sentence(errata)))
    yield f"<p>{' '.join(told)}</p>"
    yield "<ul>"
    for one in errata.misprints:
        yield f"<li>{marked(one.place, language)}: {marked(one.what, language)}</li>"
    yield "</ul>"
    page = escape(MISPRINTS.speak(language))
    data = escape(DATA.speak(language))
    yield (
        f'<p><a href="{errata.stem}.html">{page}</a>, <a href="{errata.stem}.csv">{data} (CSV)</a>'
        "</p>"
    )


def _contents(sections: Sequence[Section], language: Language) -> Iterable[str]:
    yield "<nav><ul>"
    for place, section in enumerate(sections, start=1):
        numbers = escape(contents_of(section, language))
        title = marked(section.title, language)
        yield f'<li><a href="#part-{place}">{title}</a> <span class="small">{numbers}</span></li>'
    yield "</ul></nav>"


def _figure(figure: Figure, endings: Sequence[str], language: Language) -> list[str]:
    name = f"{FIGURE.speak(language)} {figure.number}"
    caption = figure.caption.speak(language)
    stem = escape(figure.stem, quote=True)
    links = [(ending.upper(), f"{stem}.{ending}") for ending in endings]
    links.append((f"{DATA.speak(language)} (CSV)", f"{stem}.csv"))
    return [
        f'<figure id="{stem}">',
        f'<img src="{stem}.{endings[0]}" alt="{escape(f"{name}. {caption}", quote=True)}"'
        ' loading="lazy">',
        f'<figcaption><span class="number">{escape(name)}.</span>'
        f" {marked(figure.caption, language)}</figcaption>",
        *_small_print(figure, links, language),
        *_remarks(figure, language),
        "</figure>",
    ]


def _small_print(
    item: Figure | Table, links: Sequence[tuple[str, str]], language: Language
) -> list[str]:
    linked = ", ".join(f'<a href="{href}">{escape(text)}</a>' for text, href in links)
    source = f"{INPUTS.speak(language)}: {item.source.speak(language)}."
    return [f'<p class="small">{_indexed(source)} {linked}</p>']


def _remarks(item: Figure | Table, language: Language) -> list[str]:
    lines = []
    for heading, claims in claims_by_kind(item):
        lines.append(f'<p class="small">{escape(heading.speak(language))}:</p>')
        lines.append('<ul class="claims">')
        lines += [_claim(claim, language) for claim in claims]
        lines.append("</ul>")
    lines += [f"<p>{marked(note, language)}</p>" for note in item.notes]
    gaps = gap_sentence(item, language) if isinstance(item, Figure) else ""
    return [*lines, f"<p>{_indexed(gaps)}</p>"] if gaps else lines


def _claim(claim: Claim, language: Language) -> str:
    verdict = escape(VERDICTS[claim.verdict].speak(language))
    return (
        f'<li class="{claim.verdict}">{marked(claim.statement, language)}<br>'
        f"<strong>{verdict}</strong> {marked(claim.finding, language)}</li>"
    )


def _table(table: Table, language: Language) -> list[str]:
    name = f"{TABLE.speak(language)} {table.number}"
    stem = escape(table.stem, quote=True)
    rows = zip(*(_cells(column, language) for column in table.columns), strict=True)
    return [
        f'<section class="table" id="{stem}">',
        f'<p class="caption"><span class="number">{escape(name)}.</span>'
        f" {marked(table.caption, language)}</p>",
        '<div class="wide"><table>',
        *_heads(table, language),
        *("<tr>" + "".join(row) + "</tr>" for row in rows),
        "</table></div>",
        *_small_print(table, [(f"{DATA.speak(language)} (CSV)", f"{stem}.csv")], language),
        *_remarks(table, language),
        "</section>",
    ]


def _heads(table: Table, language: Language) -> Iterable[str]:
    above, below = [], []
    rows = 2 if table.cells else 1
    for column in table.columns:
        title = marked(column.title, language)
        if any(isinstance(cell, Cell) for cell in column.cells):
            above.append(f'<th colspan="2">{title}</th>')
            heads = column.heads or (PRINTED, COMPUTED)
            below += [f"<th>{escape(word.speak(language))}</th>" for word in heads]
        else:
            above.append(f'<th rowspan="{rows}">{title}</th>')
    yield "<tr>" + "".join(above) + "</tr>"
    if below:
        yield "<tr>" + "".join(below) + "</tr>"


def _cells(column: TableColumn, language: Language) -> list[str]:
    cells = []
    for cell in column.cells:
        if isinstance(cell, Cell):
            way = cell.agreement
            told = escape(AGREEMENTS[way].speak(language), quote=True)
            printed, computed = (localised(text, language) for text in (cell.printed, cell.text))
            cells.append(
                f"<td>{escape(printed)}</td>"
                f'<td class="computed {way}" title="{told}">{escape(computed)}</td>'
            )
        else:
            text = cell.speak(language) if isinstance(cell, Text) else localised(cell, language)
            opening = '<td class="sentence">' if column.sentences else "<td>"
            cells.append(f"{opening}{_indexed(text)}</td>")
    return cells


def marked(text: Text, language: Language) -> str:
    """Return a text as HTML, with the indices of its symbols below the line."""
    return _indexed(text.speak(language))


def _indexed(text: str) -> str:
    """Escape a text, and set the indices of its symbols below the line."""
    return with_indices(escape(text), lambda symbol, index: f"<i>{symbol}</i><sub>{index}</sub>")
