"""What is said of a study on the command line, in two languages."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

__all__ = ["STUDY_WORDS", "StudyWords"]


@dataclass(frozen=True, slots=True, kw_only=True)
class StudyWords:
    """All that is said of a study in one language."""

    solving: str
    progress: str
    time_left: str
    failed: str
    cases: str
    rate: str
    kept: str
    all_converged: str
    converged: str
    because: str
    output: str
    least: str
    median: str
    greatest: str
    some: str
    written: str
    stopped: str


STUDY_WORDS: Final[Mapping[str, StudyWords]] = {
    "en": StudyWords(
        solving="solving",
        progress="{done} of {total} cases, {rate}/s, {left} left",
        time_left="left",
        failed="{count} without a result",
        cases="{count} cases in {seconds} s",
        rate=", {rate} cases/s",
        kept=" ({count} of them from an earlier run)",
        all_converged="all of them have a result",
        converged="{count} have a result, {failed} have none",
        because="some cases are not valid",
        output="output",
        least="least",
        median="median",
        greatest="greatest",
        some="The medians are those of every {every}th case.",
        written="Written to {path}.",
        stopped=(
            "stopped; {done} of {total} cases are kept in {folder}."
            " The same command goes on from there"
        ),
    ),
    "pt": StudyWords(
        solving="resolvendo",
        progress="{done} de {total} casos, {rate}/s, faltam {left}",
        time_left="restam",
        failed="{count} sem resultado",
        cases="{count} casos em {seconds} s",
        rate=", {rate} casos/s",
        kept=" ({count} deles de uma execução anterior)",
        all_converged="todos têm resultado",
        converged="{count} têm resultado, {failed} não têm",
        because="alguns casos não são válidos",
        output="grandeza",
        least="menor",
        median="mediana",
        greatest="maior",
        some="As medianas são as de um em cada {every} casos.",
        written="Gravado em {path}.",
        stopped=(
            "interrompido; {done} de {total} casos ficam guardados em {folder}."
            " O mesmo comando continua de lá"
        ),
    ),
}
