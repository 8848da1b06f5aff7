"""Golden pages: the numbers that stand on the pages of the commands, in every language.

    python -m tests.regression.pages                write them anew
    python -m tests.regression.pages --check        compare all with what is written

Kept is how often each number of digits stands on a page, whatever stands around it: a page may say
it otherwise, in another order, in another language, but it may not lose a number.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections import Counter
from pathlib import Path
from typing import Final

from tests.regression.golden import RUNS, page

from rolamento.words import languages

KEPT: Final = Path(__file__).parent / "pages.json"
PAGES: Final = (
    "solve_218", "solve_209_interference", "solve_6305_life", "solve_friction_film",
    "solve_pair_back", "solve_quad", "solve_no_equilibrium", "turn_218", "turn_pair",
    "friction_ricci_fleury", "friction_6305", "friction_over_load", "life_6305", "life_6305_nsk",
    "life_shaft", "life_spectrum", "life_over_load", "clearance_samples", "clearance_designation",
    "catalogue_6205", "catalogue_search", "frequencies_6205", "frequencies_triple",
    "synthesise_inner", "diagnose_inner", "diagnose_healthy", "diagnose_swing", "anderon_one",
    "anderon_hours", "weibull_campanha", "weibull_calculated", "weibull_bayes", "weibull_ratio",
    "plan_demonstration", "plan_precision", "trend_clearance", "sweep_axes", "sweep_scatter",
    "tolerance_sobol", "verify_campanha", "verify_iso", "solve_nu205_tilted", "solve_tapered_pair",
    "solve_balls_and_rollers", "life_nu205", "friction_nu210", "frequencies_30206", "speed_nu205",
    "clearance_nu210", "catalogue_30205", "sweep_rollers",
)  # fmt: skip
"""Of the golden runs: at least one of every command that has a page."""

_NUMBER: Final = re.compile(r"\d+(?:[.,]\d+)?")
_PASSING: Final = re.compile(r".*(?:residual|resíduo|cases/s|casos/s).*")
"""Lines of how a solver got there, and how fast."""


def numbers(text: str) -> Counter[str]:
    """Return the numbers of a page with a decimal point, and how often each stands there."""
    text = _PASSING.sub("", text)
    return Counter(found.replace(",", ".") for found in _NUMBER.findall(text))


def missing(name: str, language: str) -> list[str]:
    """Return the numbers that a page has lost, but for the last digit of its rounding."""
    kept = Counter(json.loads(KEPT.read_text(encoding="utf-8"))[name])
    found = numbers(page(name, language))
    lost = kept - found
    spare = list((found - kept).elements())
    return [number for number in lost.elements() if not _taken(number, spare)]


def _taken(number: str, spare: list[str]) -> bool:
    """Take a number away that differs only in how its last digit is rounded, or a noise's zero."""
    decimals = len(number.partition(".")[2])
    for other in spare:
        alike = len(other.partition(".")[2]) == decimals and "." in number
        if not float(number) == float(other) == 0.0 and not alike:
            continue
        if abs(float(other) - float(number)) < 1.5 * 10.0**-decimals:
            spare.remove(other)
            return True
    return False


def main() -> int:
    """Write the numbers anew, or compare."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help="of some pages; by default of all")
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    options = parser.parse_args()
    names = [name for name in PAGES if not options.names or name in options.names]
    if not options.check:
        assert set(PAGES) <= RUNS.keys()
        kept = json.loads(KEPT.read_text(encoding="utf-8")) if KEPT.exists() else {}
        kept |= {name: dict(sorted(numbers(page(name, "en")).items())) for name in names}
        KEPT.write_text(json.dumps(kept, indent=0, sort_keys=True) + "\n", encoding="utf-8")
        return 0
    wrong = 0
    for name in names:
        for language in languages():
            lost = missing(name, language)
            wrong += bool(lost)
            if lost:
                print(f"{name} ({language}) has lost {', '.join(lost)}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
