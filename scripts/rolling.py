"""Infer what rolls in all bearings of the built-in catalogue that do not tell; after changes of it.

    python scripts/rolling.py

writes src/rolamento/data/rolling.csv, from which a diagnosis knows which bearings share a line.
"""

from __future__ import annotations

import csv
import sys
from pathlib import Path

from rolamento.catalogue import catalogue, inferred_geometry, inferred_rollers
from rolamento.catalogue.records import CatalogueBearing
from rolamento.errors import InputError

TARGET = Path(__file__).parents[1] / "src" / "rolamento" / "data" / "rolling.csv"
HEAD = """\
# Balls and rollers of the catalogue's bearings that publish none, inferred from their ratings by
# rolamento.catalogue.inferred_geometry and .inferred_rollers (the best candidate). Written by
# scripts/rolling.py.
"""


def main() -> int:
    """Write the file, and say how many bearings it has."""
    rows = []
    for bearing in catalogue().bearings:
        if bearing.knows_elements:
            continue
        try:
            count, diameter, pitch = _inside(bearing)
        except (InputError, ValueError):  # no ratings, or none that balls or rollers reproduce
            continue
        rows.append((bearing.maker, bearing.designation, count, f"{diameter / pitch:.9g}"))
    with TARGET.open("w", encoding="utf-8", newline="") as file:
        file.write(HEAD)
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("maker", "designation", "element_count", "diameter_ratio"))
        writer.writerows(rows)
    print(f"{TARGET}: {len(rows)} bearings")
    return 0


def _inside(bearing: CatalogueBearing) -> tuple[int, float, float]:
    """Count, diameter and pitch diameter (m) of what most likely rolls in a bearing."""
    if bearing.has_rollers:
        rollers, *_ = inferred_rollers(bearing, most=1)
        return rollers.roller_count, rollers.roller_diameter, rollers.pitch_diameter
    balls, *_ = inferred_geometry(bearing, most=1)
    return balls.ball_count, balls.ball_diameter, balls.pitch_diameter


if __name__ == "__main__":
    sys.exit(main())
