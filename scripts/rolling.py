"""Infer the balls of all bearings of the built-in catalogue that publish none; after changes of it.

    python scripts/rolling.py

writes src/rolamento/data/rolling.csv, from which a diagnosis knows which bearings share a line.
"""

from __future__ import annotations

import csv
import sys
from pathlib import Path

from rolamento.catalogue import catalogue, inferred_geometry
from rolamento.errors import InputError

TARGET = Path(__file__).parents[1] / "src" / "rolamento" / "data" / "rolling.csv"
HEAD = """\
# Balls of the catalogue's bearings that publish none, inferred from their ratings by
# rolamento.catalogue.inferred_geometry (the best candidate). Written by scripts/rolling.py.
"""


def main() -> int:
    """Write the file, and say how many bearings it has."""
    rows = []
    for bearing in catalogue().bearings:
        if bearing.ball_count is not None and bearing.ball_diameter is not None:
            continue
        try:
            best, *_ = inferred_geometry(bearing, most=1)
        except (InputError, ValueError):  # no ratings, or none that balls reproduce
            continue
        ratio = f"{best.ball_diameter / best.pitch_diameter:.9g}"
        rows.append((bearing.maker, bearing.designation, best.ball_count, ratio))
    with TARGET.open("w", encoding="utf-8", newline="") as file:
        file.write(HEAD)
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("maker", "designation", "ball_count", "diameter_ratio"))
        writer.writerows(rows)
    print(f"{TARGET}: {len(rows)} bearings")
    return 0


if __name__ == "__main__":
    sys.exit(main())
