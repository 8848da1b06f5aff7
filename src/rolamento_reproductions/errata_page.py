"""The page of a publication's misprints, as HTML and as Markdown."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from typing import Final

from rolamento_reproductions import markdown
from rolamento_reproductions.errata import Errata, Misprint, Sound, power_text
from rolamento_reproductions.page import head_of_page, marked
from rolamento_reproductions.record import Source
from rolamento_reproductions.text import Language, Text, said, same
from rolamento_reproductions.wording import (
    DERIVATION,
    EQUATION,
    LEFT_AT_MOST,
    LEFT_TYPICALLY,
    MISPRINTS,
    PRINTED,
    QUANTITY,
    SHOULD_BE,
    SOUND,
    misprints_sentence,
)

__all__ = ["errata_html", "errata_markdown"]

_FORMULA: Final = """
.formula { margin: .2rem 0 .2rem 1.2rem; font-family: Cambria, "STIX Two Text", Georgia, serif; }
"""
_PROOF: Final = said(
    "Proof: residual of each form against vectors, over the greatest term, attitude by attitude.",
    "Prova: resíduo de cada forma em relação aos vetores, dividido pelo maior termo, posição a"
    " posição.",
)
_FORM: Final = said("Form", "Forma")
_BACK: Final = said("All figures and tables", "Todas as figuras e tabelas")


def errata_html(source: Source, errata: Errata, language: Language) -> str:
    """Write the page as one HTML file.

    Parameters
    ----------
    source
        What is reproduced.
    errata
        Its misprints.
    language
        Of the page.
    """
    lines = [
        *head_of_page(source, _title(source), language, style=_FORMULA),
        *(f"<p>{marked(text, language)}</p>" for text in _opening(errata)),
        f'<p><a href="index.html">{escape(_BACK.speak(language))}</a></p>',
        f"<h2>{marked(_PROOF_TITLE, language)}</h2>",
        f"<p>{marked(_PROOF, language)}</p>",
        *_html_table(_proof_rows(errata), language),
    ]
    for one in errata.misprints:
        lines += _html_misprint(one, language)
    lines += [
        f"<h2>{marked(SOUND, language)}</h2>",
        *_html_table(_sound_rows(errata.sound), language),
        "</body>",
        "</html>",
        "",
    ]
    return "\n".join(lines)


def errata_markdown(source: Source, errata: Errata, language: Language) -> str:
    """Write the same as Markdown; parameters as of `errata_html`."""

    def shown(text: Text) -> str:
        return markdown.marked(text, language)

    parts = [f"# {shown(_title(source))}", *(shown(text) for text in _opening(errata))]
    parts.append(f"[{_BACK.speak(language)}](index.md)")
    parts += [f"## {shown(_PROOF_TITLE)}", shown(_PROOF)]
    parts.append(_markdown_table(_proof_rows(errata), language))
    for one in errata.misprints:
        parts.append(f"## {shown(one.place)}: {shown(one.what)}")
        parts.append(f"{_capital(PRINTED, language)}: {shown(one.printed)}")
        parts.append(f"{SHOULD_BE.speak(language)}: {shown(one.corrected)}")
        parts.append(f"{DERIVATION.speak(language)}: {shown(one.derivation)}")
    parts += [f"## {shown(SOUND)}", _markdown_table(_sound_rows(errata.sound), language)]
    return "\n\n".join(parts) + "\n"


_PROOF_TITLE: Final = said("Proof by numbers", "Prova numérica")


def _title(source: Source) -> Text:
    return said("{}: {}", "{}: {}", MISPRINTS, source.title)


def _opening(errata: Errata) -> tuple[Text, ...]:
    return (errata.caption, misprints_sentence(errata), *errata.remarks)


def _capital(text: Text, language: Language) -> str:
    return text.speak(language).capitalize()


def _html_misprint(one: Misprint, language: Language) -> Iterable[str]:
    yield f"<h2>{marked(one.place, language)}: {marked(one.what, language)}</h2>"
    for head, form in ((PRINTED, one.printed), (SHOULD_BE, one.corrected)):
        yield f'<p class="small">{escape(_capital(head, language))}:</p>'
        yield f'<p class="formula">{marked(form, language)}</p>'
    yield f'<p class="small">{escape(DERIVATION.speak(language))}:</p>'
    yield f"<p>{marked(one.derivation, language)}</p>"


def _proof_rows(errata: Errata) -> list[list[Text]]:
    """The table of residuals, head first."""
    head = [
        EQUATION,
        QUANTITY,
        said("As printed: {}", "Como impresso: {}", LEFT_TYPICALLY),
        said("As printed: {}", "Como impresso: {}", LEFT_AT_MOST),
        said("Corrected: {}", "Corrigida: {}", LEFT_AT_MOST),
    ]
    return [
        head,
        *(
            [
                one.place,
                one.what,
                _written(one.printed_residual.median),
                _written(one.printed_residual.greatest),
                _below(one.corrected_residual.greatest),
            ]
            for one in errata.misprints
        ),
    ]


def _sound_rows(sound: tuple[Sound, ...]) -> list[list[Text]]:
    head = [EQUATION, QUANTITY, _FORM, LEFT_AT_MOST]
    return [
        head,
        *([same(f"({o.number})"), o.what, o.form, _below(o.residual.greatest)] for o in sound),
    ]


def _below(value: float) -> Text:
    """Rounding differs from machine to machine: the power of ten above it."""
    return same(f"< {power_text(value)}")


def _written(value: float) -> Text:
    template = "{:.0f}" if value >= 10.0 else "{:.2f}" if value >= 0.1 else "{:.2g}"
    return said(template, template, value)


def _html_table(rows: list[list[Text]], language: Language) -> Iterable[str]:
    yield '<div class="wide"><table>'
    for place, row in enumerate(rows):
        kind = "td" if place else "th"
        cells = "".join(f"<{kind}>{marked(cell, language)}</{kind}>" for cell in row)
        yield f"<tr>{cells}</tr>"
    yield "</table></div>"


def _markdown_table(rows: list[list[Text]], language: Language) -> str:
    lines = [
        "| " + " | ".join(markdown.marked(cell, language) for cell in row) + " |" for row in rows
    ]
    return "\n".join([lines[0], "|" + "---|" * len(rows[0]), *lines[1:]])
