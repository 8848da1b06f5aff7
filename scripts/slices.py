"""Compare coupled with independent slices of rollers, for the table of the documentation.

python scripts/slices.py            write the table of docs/theory/line-contact.md anew
python scripts/slices.py --check    say whether it is what the program gives
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from rolamento import Case, Solved, solve
from rolamento.life import life

PAGE: Final = Path(__file__).parents[1] / "docs" / "theory" / "line-contact.md"
BEGIN: Final = "<!-- slices: begin -->\n"
END: Final = "<!-- slices: end -->\n"
HEAD: Final = """\
| bearing, load | given | tilt, mrad | moment, N·m | greatest pressure, MPa | L_10r, 10⁶ rev |
|---|---|---|---|---|---|
"""
SPEED: Final = "1500 rpm"


@dataclass(frozen=True, slots=True)
class Comparison:
    """One bearing under one load, and what its rings are held by.

    Attributes
    ----------
    designation, profile
        Of the bearing, and of its rollers; empty as the catalogue's bearings have it.
    radial, axial
        The load (N).
    moment
        About y (N·m), the ring being free to tilt; None where the tilt is held.
    tilt
        That is held (mrad).
    """

    designation: str
    profile: str
    radial: float
    axial: float = 0.0
    moment: float | None = None
    tilt: float = 0.0

    def case(self, contact: str) -> Case:
        """Return the case with slices that are independent ("slices") or "coupled"."""
        bearing: dict[str, Any] = {"designation": self.designation}
        if self.profile:
            bearing["roller_profile"] = self.profile
        load = {"fz": self.radial}
        if self.axial:
            load["fx"] = self.axial
        duty: dict[str, Any] = {"inner_speed": SPEED, "load": load}
        if self.moment is None:
            duty["displacement"] = {"ry": 1e-3 * self.tilt}
        else:
            load |= {"my": self.moment, "mz": 0.0}
        return Case(bearing=bearing, duty=duty, model={"roller_contact": contact})


def comparisons() -> Iterator[Comparison]:
    """Yield what is compared: a light and a heavy load each, in line, tilted, under a moment."""
    for designation, profile, loads in (
        ("NU 205", "", (3e3, 6e3)),
        ("NU 205", "none", (3e3, 6e3)),
        ("NU 2210", "", (9e3, 18e3)),
        ("NA 4905", "", (2.5e3, 5e3)),
    ):
        for radial in loads:
            yield Comparison(designation, profile, radial)
            yield Comparison(designation, profile, radial, tilt=2.0)
            yield Comparison(designation, profile, radial, moment=1e-3 * radial)
    for designation, radial in (("30206", 5e3), ("32210", 10e3)):
        for tilt in (0.0, 2.0):
            yield Comparison(designation, "", radial, 0.5 * radial, tilt=tilt)


def line(one: Comparison) -> str:
    """Solve a case both ways, and return its line of the table."""
    both = [solve(one.case(contact)) for contact in ("slices", "coupled")]
    where = one.designation + (", straight" if one.profile == "none" else "")
    load = f"{1e-3 * one.radial:g} kN" + (f" and {1e-3 * one.axial:g} kN axial" * bool(one.axial))
    given = f"tilt {one.tilt:g} mrad" if one.moment is None else f"moment {one.moment:g} N·m"
    cells = [
        f"{where}, {load}",
        given,
        *(", ".join(written(number(solved)) for solved in both) for number, written in _NUMBERS),
    ]
    return f"| {' | '.join(cells)} |\n"


def _pressure(solved: Solved) -> float:
    races = (solved.inner, solved.outer)
    return 1e-6 * max(float(race.max_pressure[0].max()) for race in races)


def _life(solved: Solved) -> float:
    return float(life(solved, stress_volume=False)["iso16281"].life[0])


_NUMBERS: Final = (
    (lambda solved: abs(1e3 * float(solved.displacement.ry[0])), lambda value: f"{value:.2f}"),
    (lambda solved: abs(float(solved.load.my[0])), lambda value: f"{value:.2f}"),
    (_pressure, lambda value: f"{value:.0f}"),
    (_life, lambda value: f"{float(f'{value:.3g}'):g}"),
)


def table() -> str:
    """Return the table, in Markdown."""
    return HEAD + "".join(map(line, comparisons()))


def main(words: list[str]) -> int:
    """Write the table, or compare it with what is written."""
    text = PAGE.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    written, after = rest.split(END)
    found = table()
    if "--check" in words:
        return int(found != written)
    PAGE.write_text(before + BEGIN + found + END + after, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
