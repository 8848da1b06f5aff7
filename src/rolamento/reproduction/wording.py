"""What the index pages and the command say around the figures, in both languages."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rolamento.reproduction.printed import Agreement
from rolamento.reproduction.record import Figure, Section, Table, Verdict
from rolamento.reproduction.text import Language, Text, said

__all__ = [
    "AGREEMENTS",
    "COMPUTED",
    "DATA",
    "FIGURE",
    "INPUTS",
    "PRINTED",
    "REASONS",
    "REGENERATED",
    "STATED",
    "TABLE",
    "VERDICTS",
    "contents_of",
    "gap_sentence",
    "summary",
]

FIGURE: Final = said("Figure", "Figura")
TABLE: Final = said("Table", "Tabela")
TABLES: Final = said("tables", "tabelas")
INPUTS: Final = said("Inputs", "Dados")
STATED: Final = said("What the text says, and what is found", "O que o texto diz e o que se obtém")
DATA: Final = said("data", "dados")
PRINTED: Final = said("printed", "impresso")
COMPUTED: Final = said("computed", "calculado")
REGENERATED: Final = said("Written by", "Escrito por")

VERDICTS: Final[Mapping[Verdict, Text]] = {
    "holds": said("Holds.", "Confirma-se."),
    "partly": said("Holds in part.", "Confirma-se em parte."),
    "fails": said("Does not hold.", "Não se confirma."),
}
AGREEMENTS: Final[Mapping[Agreement, Text]] = {
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
REASONS: Final[Mapping[str, Text]] = {
    "no_equilibrium": said("there is no equilibrium", "não há equilíbrio"),
    "not_converged": said("not converged", "não convergiu"),
    "overloaded": said("overloaded", "sobrecarga"),
    "unheld_ball": said("a ball is not held", "uma esfera sem apoio"),
    "invalid_input": said("invalid input", "entrada inválida"),
}


def summary(sections: tuple[Section, ...]) -> tuple[Text, ...]:
    """Count figures, printed numbers and statements, and how they agree."""
    items = [item for section in sections for item in section.items]
    cells = [cell for item in items if isinstance(item, Table) for cell in item.cells]
    claims = [claim for item in items for claim in item.claims]
    ways = [cell.agreement for cell in cells]
    verdicts = [claim.verdict for claim in claims]
    return (
        said(
            "{} figures, {} tables.",
            "{} figuras, {} tabelas.",
            sum(isinstance(item, Figure) for item in items),
            sum(isinstance(item, Table) for item in items),
        ),
        said(
            "Of {} printed numbers {} are what the computed ones round to, {} a tie of rounding,"
            " {} cut instead of rounded; {} differ.",
            "De {} números impressos, {} são o arredondamento dos calculados, {} um empate de"
            " arredondamento, {} cortado em vez de arredondado; {} diferem.",
            len(ways),
            *(ways.count(way) for way in AGREEMENTS),
        ),
        said(
            "Of {} statements in the text {} hold, {} in part; {} not.",
            "De {} afirmações do texto, {} se confirmam, {} em parte; {} não.",
            len(verdicts),
            *(verdicts.count(verdict) for verdict in VERDICTS),
        ),
    )


def contents_of(section: Section, language: Language) -> str:
    """Return the numbers of a section's figures and tables, such as "5.27–5.32, table 5.4"."""
    figures = [item.number for item in section.items if isinstance(item, Figure)]
    tables = [item.number for item in section.items if isinstance(item, Table)]
    parts = ["–".join(dict.fromkeys((figures[0], figures[-1])))] if figures else []
    if tables:
        word = (TABLE if len(tables) == 1 else TABLES).speak(language).lower()
        parts.append(f"{word} {', '.join(tables)}")
    return ", ".join(parts)


def gap_sentence(figure: Figure, language: Language) -> str:
    """Tell of the rows of a figure that have no result, and why; nothing if there are none."""
    codes = [code for _, code in figure.gaps]
    if not codes:
        return ""
    reasons = ", ".join(
        f"{REASONS[code].speak(language)} ({codes.count(code)})" for code in sorted(set(codes))
    )
    return said(
        "Gaps: {} of {} points have no result: {}.",
        "Lacunas: {} de {} pontos não têm resultado: {}.",
        len(codes),
        len(figure.columns[0].values),
        reasons,
    ).speak(language)
