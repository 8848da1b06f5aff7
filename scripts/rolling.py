"""Infer what rolls in the built-in catalogue's bearings that do not say; after changes of it.

    python scripts/rolling.py

writes src/rolamento/data/rolling.csv, from which a diagnosis knows which bearings share a line.
"""

from __future__ import annotations

import csv
import sys
from pathlib import Path

from rolamento.catalogue import (
    CatalogueBearing,
    catalogue,
    inferred_geometry,
    inferred_rollers,
)
from rolamento.errors import InputError

TARGET = Path(__file__).parents[1] / "src" / "rolamento" / "data" / "rolling.csv"
HEAD = """\
# Balls or rollers of the catalogue's bearings that publish none, inferred from their ratings by
# rolamento.catalogue.inferred_geometry or inferred_rollers (the best candidate), one of those that
# differ by their ribs only. Written by scripts/rolling.py.
"""


def main() -> int:
    """Write the file, and say how many bearings it has."""
    rows, insides = [], set()
    for bearing in catalogue().bearings:
        if bearing.knows_elements:
            continue
        try:
            count, size, pitch = _inside(bearing)
        except (InputError, ValueError):  # no ratings, or none that balls or rollers reproduce
            continue
        same = (bearing.maker, bearing.rated, bearing.outside_diameter, bearing.width)
        if bearing.has_rollers:
            if same in insides:
                continue
            insides.add(same)
        rows.append((bearing.maker, bearing.designation, count, f"{size / pitch:.9g}"))
    with TARGET.open("w", encoding="utf-8", newline="") as file:
        file.write(HEAD)
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("maker", "designation", "ball_count", "diameter_ratio"))
        writer.writerows(rows)
    print(f"{TARGET}: {len(rows)} bearings")
    return 0


def _inside(bearing: CatalogueBearing) -> tuple[int, float, float]:
    if bearing.has_rollers:
        one, *_ = inferred_rollers(bearing, most=1)
        return one.roller_count, one.roller_diameter, one.pitch_diameter
    best, *_ = inferred_geometry(bearing, most=1)
    return best.ball_count, best.ball_diameter, best.pitch_diameter


if __name__ == "__main__":
    sys.exit(main())
