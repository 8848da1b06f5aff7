"""What the index pages and the command say around the figures, in both languages."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rolamento_reproductions.errata import Errata, power_text
from rolamento_reproductions.printed import Agreement
from rolamento_reproductions.record import Claim, Figure, Section, Table, Verdict
from rolamento_reproductions.text import Language, Text, said

__all__ = [
    "AGREEMENTS",
    "COMPUTED",
    "DATA",
    "DERIVATION",
    "EQUATION",
    "EXPECTED",
    "FIGURE",
    "INPUTS",
    "LEFT_AT_MOST",
    "LEFT_TYPICALLY",
    "MISPRINTS",
    "PRINTED",
    "QUANTITY",
    "REASONS",
    "REGENERATED",
    "SHOULD_BE",
    "SOUND",
    "STATED",
    "TABLE",
    "VERDICTS",
    "claims_by_kind",
    "contents_of",
    "gap_sentence",
    "misprints_sentence",
    "summary",
]

FIGURE: Final = said("Figure", "Figura")
TABLE: Final = said("Table", "Tabela")
TABLES: Final = said("tables", "tabelas")
INPUTS: Final = said("Inputs", "Dados")
STATED: Final = said("What the text says, and what is found", "O que o texto diz e o que se obtém")
EXPECTED: Final = said(
    "What theory lets expect, and what is found", "O que a teoria permite esperar e o que se obtém"
)
MISPRINTS: Final = said("Misprints", "Erros de impressão")
SOUND: Final = said("Holds as printed", "Vale como impresso")
EQUATION: Final = said("Equation", "Equação")
QUANTITY: Final = said("Quantity", "Grandeza")
SHOULD_BE: Final = said("Should be", "O correto")
DERIVATION: Final = said("Derivation", "Dedução")
LEFT_TYPICALLY: Final = said("median residual", "resíduo mediano")
LEFT_AT_MOST: Final = said("greatest residual", "resíduo máximo")
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
    "over_shoulder": said("a ball rides over the shoulder", "uma esfera passa do rebordo da pista"),
    "invalid_input": said("invalid input", "entrada inválida"),
}


def summary(sections: tuple[Section, ...]) -> tuple[Text, ...]:
    """Count figures, printed numbers, statements and misprints, and how they agree."""
    items = [item for section in sections for item in section.items]
    shown = [item for item in items if not isinstance(item, Errata)]
    cells = [cell for item in shown if isinstance(item, Table) for cell in item.cells]
    claims = [claim for item in shown for claim in item.claims]
    lines = [
        said(
            "{} figures, {} tables.",
            "{} figuras, {} tabelas.",
            sum(isinstance(item, Figure) for item in shown),
            sum(isinstance(item, Table) for item in shown),
        )
    ]
    if cells:
        ways = [cell.agreement for cell in cells]
        lines.append(
            said(
                "Of {} printed numbers {} are what the computed ones round to, {} a tie of"
                " rounding, {} cut instead of rounded; {} differ.",
                "De {} números impressos, {} são o arredondamento dos calculados, {} um empate de"
                " arredondamento, {} cortado em vez de arredondado; {} diferem.",
                len(ways),
                *(ways.count(way) for way in AGREEMENTS),
            )
        )
    lines += _verdicts([claim for claim in claims if not claim.of_theory], _IN_THE_TEXT)
    lines += _verdicts([claim for claim in claims if claim.of_theory], _OF_THEORY)
    lines += [misprints_sentence(item) for item in items if isinstance(item, Errata)]
    return tuple(lines)


_IN_THE_TEXT: Final = (
    "Of {} statements in the text {} hold, {} in part; {} not.",
    "De {} afirmações do texto, {} se confirmam, {} em parte; {} não.",
)
_OF_THEORY: Final = (
    "Of {} expectations of theory {} hold, {} in part; {} not.",
    "De {} expectativas da teoria, {} se confirmam, {} em parte; {} não.",
)


def _verdicts(claims: list[Claim], templates: tuple[str, str]) -> list[Text]:
    """Count how statements of one kind end; nothing where there are none."""
    if not claims:
        return []
    verdicts = [claim.verdict for claim in claims]
    counts = [verdicts.count(verdict) for verdict in VERDICTS]
    return [said(*templates, len(claims), *counts)]


def claims_by_kind(item: Figure | Table) -> list[tuple[Text, tuple[Claim, ...]]]:
    """Return the statements of the text and those of theory, each under its heading."""
    kinds = ((STATED, False), (EXPECTED, True))
    parted = [
        (heading, tuple(c for c in item.claims if c.of_theory is kind)) for heading, kind in kinds
    ]
    return [(heading, claims) for heading, claims in parted if claims]


def misprints_sentence(errata: Errata) -> Text:
    """Count misprints, and what was checked and is right."""
    worst = max(one.corrected_residual.greatest for one in errata.misprints)
    return said(
        "{} misprints, each with its derivation and a proof at {} random attitudes; corrected,"
        " what is left is below {}. {} other equations hold as printed.",
        "{} erros de impressão, cada um com dedução e prova em {} posições aleatórias; corrigidos,"
        " o que resta é menor que {}. {} outras equações valem como impressas.",
        len(errata.misprints),
        errata.attitudes,
        power_text(worst),
        len(errata.sound),
    )


def contents_of(section: Section, language: Language) -> str:
    """Return the numbers of a section's figures and tables, such as "5.27–5.32, table 5.4"."""
    figures = [item.number for item in section.items if isinstance(item, Figure)]
    tables = [item.number for item in section.items if isinstance(item, Table)]
    parts = ["–".join(dict.fromkeys((figures[0], figures[-1])))] if figures else []
    if tables:
        word = (TABLE if len(tables) == 1 else TABLES).speak(language).lower()
        parts.append(f"{word} {', '.join(tables)}")
    if any(isinstance(item, Errata) for item in section.items):
        parts.append(MISPRINTS.speak(language).lower())
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
