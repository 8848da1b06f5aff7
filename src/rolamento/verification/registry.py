"""The sources that the program is checked against, and the run over them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, Final

from rolamento.errors import InputError, guess
from rolamento.io.json import dumps
from rolamento.records import frozen
from rolamento.verification.campanha_2008 import checks as campanha_2008_checks
from rolamento.verification.check import VERDICTS, Check, CheckVerdict, published
from rolamento.verification.harris_1991 import checks as harris_1991_checks
from rolamento.verification.makers import checks as makers_checks
from rolamento.verification.makers import life_checks as makers_life_checks
from rolamento.verification.radaelli_2013 import checks as radaelli_2013_checks
from rolamento.verification.rigs import case_western_checks, rig_checks
from rolamento.verification.rollers import checks as rollers_checks
from rolamento.verification.standards import iso_76_checks, iso_281_checks, iso_16281_checks
from rolamento.words import said

SCHEMA: Final = 2


@frozen
class Source:
    """A publication: its name on the command line, its reference, and its numbers."""

    name: str
    title: str
    checks: Callable[[], Iterable[Check]]


Progress = Callable[[Source, int, int], None]
"""Called before each source, with how many are done and how many there are."""


@frozen
class SourceResult:
    """All checks of one source."""

    name: str
    title: str
    checks: tuple[Check, ...]


@frozen
class Verification:
    """All checks of all sources that were asked for."""

    results: tuple[SourceResult, ...]

    @property
    def checks(self) -> tuple[Check, ...]:
        """The checks of all sources, in their order."""
        return tuple(check for result in self.results for check in result.checks)

    @property
    def passed(self) -> bool:
        """Whether no number fails, and there is at least one."""
        return bool(self.checks) and not self.count("fails")

    def count(self, verdict: CheckVerdict) -> int:
        """Return how many numbers have a verdict."""
        return sum(check.verdict == verdict for check in self.checks)

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain mappings and lists; a number that does not exist as None."""
        return {
            "schema": SCHEMA,
            "passed": self.passed,
            "numbers": len(self.checks),
            "verdicts": {verdict: self.count(verdict) for verdict in VERDICTS},
            "sources": [
                {
                    "name": result.name,
                    "title": result.title,
                    "checks": [check.to_mapping() for check in result.checks],
                }
                for result in self.results
            ],
        }

    def to_json(self, *, indent: int | None = 2) -> str:
        """Give everything as one JSON object."""
        return dumps(self.to_mapping(), indent)


def sources() -> tuple[Source, ...]:
    """Return all sources, the older first, those without a year last."""
    checks: Mapping[str, Callable[[], Iterable[Check]]] = {
        "harris_1991": harris_1991_checks,
        "iso_281": iso_281_checks,
        "iso_16281": iso_16281_checks,
        "iso_76": iso_76_checks,
        "campanha_2008": campanha_2008_checks,
        "rollers": rollers_checks,
        "radaelli_2013": radaelli_2013_checks,
        "case_western": case_western_checks,
        "rigs": rig_checks,
        "makers": makers_checks,
        "makers_life": makers_life_checks,
    }
    return tuple(Source(name, published(name)["title"], found) for name, found in checks.items())


def run(names: Iterable[str] = (), *, progress: Progress | None = None) -> Verification:
    """Compute every published number, and compare.

    Parameters
    ----------
    names
        Of the sources; all if none is given.
    progress
        Called before each source.

    Raises
    ------
    InputError
        If no source has such a name.
    """
    chosen = _chosen(tuple(names))
    results = []
    for done, source in enumerate(chosen):
        if progress is not None:
            progress(source, done, len(chosen))
        results.append(SourceResult(source.name, source.title, tuple(source.checks())))
    return Verification(tuple(results))


def _chosen(names: tuple[str, ...]) -> tuple[Source, ...]:
    """Return the sources of these names, in the order of all."""
    everything = sources()
    known = [source.name for source in everything]
    names = tuple(name.replace("-", "_") for name in names)  # as `reproduce` writes them
    for name in names:
        if name not in known:
            raise InputError(
                said("is an unknown source; {guess}", guess=guess(name, known)),
                field="source",
                value=name,
                example=known[0],
            )
    return tuple(source for source in everything if not names or source.name in names)
