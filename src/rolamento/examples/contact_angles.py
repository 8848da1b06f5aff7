"""The contact angles of inner and outer race part with speed: a batch of 121 cases.

    python contact_angles.py [FOLDER]

A 218 angular-contact bearing under 20 kN of thrust. Every ball carries the same, so one of them
stands for all; its centrifugal force pulls the outer contact toward the groove's bottom.
"""

from __future__ import annotations

import sys
from math import pi
from pathlib import Path

import numpy as np

from rolamento import Bearing, Case, Duty, Load, solve
from rolamento.charts.style import in_style, new_figure, series
from rolamento.plots.saving import save_figure

BEARING = Bearing(
    ball_count=16,
    ball_diameter="22.23 mm",
    pitch_diameter="125.26 mm",
    contact_angle="40 deg",
    inner_conformity=0.5232,
    outer_conformity=0.5232,
)


@in_style
def main(folder: Path) -> None:
    """Solve, say where the angles are 20° apart, and write contact_angles.png."""
    rpm = np.linspace(0.0, 15_000.0, 121)
    case = Case(bearing=BEARING, duty=Duty(load=Load(fx="20 kN")))
    solved = solve(case, inner_speed=rpm * pi / 30.0)
    inner, outer = (np.degrees(race.contact_angle[:, 0]) for race in (solved.inner, solved.outer))
    apart = np.flatnonzero(inner - outer > 20.0)
    print(f"{solved.converged.sum()} of {len(rpm)} solved; 20° apart from {rpm[apart[0]]:.0f} rpm")
    figure, axes = new_figure(height=75.0)
    axes.plot(rpm, inner, label="inner race", **series(0).keywords())
    axes.plot(rpm, outer, label="outer race", **series(1).keywords())
    axes.set_xlabel("speed of the inner ring [rpm]")
    axes.set_ylabel("contact angle [°]")
    axes.legend()
    save_figure(figure, folder / "contact_angles.png")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
