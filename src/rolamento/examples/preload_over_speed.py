"""Rigid against spring preload over speed: a spindle pair, back to back, without external load.

    python preload_over_speed.py [FOLDER]

writes preload_over_speed.png and preload_over_speed.csv into the folder. Clamped rings keep their
offset: the balls' centrifugal forces press the rows against each other, the faster the harder,
which keeps the pair stiff and loads the balls. Springs keep their force: the outer rings of one row
give way, the contact angle at the outer races falls, and the pair softens.
"""

from __future__ import annotations

import csv
import sys
from math import pi
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rolamento import Bearing, Case, Duty, solve
from rolamento.charts.style import in_style, new_stacked_figure, series
from rolamento.plots.saving import save_figure
from rolamento.records import frozen

Floats = NDArray[np.float64]

NAME = "preload_over_speed"
FORCE = 515.0  # N, the class medium of this bearing
PAIR = Bearing(
    ball_count=22,
    ball_diameter="9.525 mm",
    pitch_diameter="77.5 mm",
    contact_angle="15 deg",
    inner_conformity=0.52,
    outer_conformity=0.52,
    arrangement="DB",
    spacing="18 mm",
    preload={"force": FORCE},
)
KINDS = {"force": "clamped rings", "spring": "springs"}


@frozen(slots=False)
class Curve:
    """What a kind of preload makes of the pair over speed."""

    axial_stiffness: Floats  # N/m
    radial_stiffness: Floats  # N/m
    force: Floats  # between the rows, N


def curve_of(kind: str, rpm: Floats) -> Curve:
    """Solve the pair at every speed; kind: "force" or "spring", of the same force at rest."""
    case = Case(bearing=PAIR.replace(preload={kind: FORCE}), duty=Duty())
    batch = solve(case, inner_speed=rpm * pi / 30.0)
    assert batch.converged.all()
    return Curve(
        axial_stiffness=batch.stiffness["fx", "x"],
        radial_stiffness=batch.stiffness["fz", "z"],
        force=batch.rows.load[:, 0, 0],
    )


@in_style
def main(folder: Path) -> dict[str, Curve]:
    """Write the figure and its numbers; return the curves by kind."""
    rpm = np.linspace(0.0, 20_000.0, 81)
    curves = {kind: curve_of(kind, rpm) for kind in KINDS}
    figure, axes = new_stacked_figure(3, height=150.0)
    for index, (kind, curve) in enumerate(curves.items()):
        drawn = {**series(index).keywords(), "label": KINDS[kind]}
        axes[0].plot(rpm, 1e-6 * curve.axial_stiffness, **drawn)
        axes[1].plot(rpm, 1e-6 * curve.radial_stiffness, **drawn)
        axes[2].plot(rpm, curve.force, **drawn)
    for part, label in zip(
        axes,
        ("axial stiffness [N/µm]", "radial stiffness [N/µm]", "force between the rows [N]"),
        strict=True,
    ):
        part.set_ylabel(label)
        part.set_ylim(bottom=0.0)
    axes[0].legend()
    axes[-1].set_xlabel("speed of the inner ring [rpm]")
    save_figure(figure, folder / f"{NAME}.png")
    with open(folder / f"{NAME}.csv", "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(
            ["speed [rpm]"]
            + [
                f"{name}, {KINDS[kind]} [{unit}]"
                for kind in curves
                for name, unit in (
                    ("axial stiffness", "N/um"),
                    ("radial stiffness", "N/um"),
                    ("force", "N"),
                )
            ]
        )
        for i, speed in enumerate(rpm):
            row = [f"{speed:g}"]
            for curve in curves.values():
                row += [
                    f"{1e-6 * curve.axial_stiffness[i]:.2f}",
                    f"{1e-6 * curve.radial_stiffness[i]:.2f}",
                    f"{curve.force[i]:.1f}",
                ]
            writer.writerow(row)
    return curves


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
