"""A thrust moves the fault frequencies of a deep-groove bearing: 6310 at 1480 rpm.

    python frequencies_under_thrust.py [FOLDER]

Under radial load its contact angle is near zero. Thrust tilts the contacts, the balls run on
another circle of the races, and BPFO rises while BPFI falls; a search of ±2 % has to know it.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from rolamento import Case, solve
from rolamento.charts.style import in_style, new_figure, series
from rolamento.plots.saving import save_figure
from rolamento.vibration import frequencies_of


@in_style
def main(folder: Path) -> None:
    """Solve 25 thrusts, print the ends, and write frequencies_under_thrust.png."""
    thrust = np.linspace(0.0, 12e3, 25)
    case = Case(
        bearing={"designation": "6310/C3"},
        duty={"inner_speed": "1480 rpm", "load": {"fz": "3 kN"}},
    )
    solved = solve(case, fx=thrust)
    found = [frequencies_of(solved[index]) for index in range(len(thrust))]
    outer = np.array([one.ball_pass_outer.frequency for one in found])
    inner = np.array([one.ball_pass_inner.frequency for one in found])
    for name, values in (("BPFO", outer), ("BPFI", inner)):
        print(f"{name}: {values[0]:.2f} Hz without thrust, {values[-1]:.2f} Hz with 12 kN")
    figure, axes = new_figure(height=75.0)
    for index, (name, values) in enumerate((("BPFO", outer), ("BPFI", inner))):
        shift = 100.0 * (values / values[0] - 1.0)
        axes.plot(thrust / 1e3, shift, label=name, **series(index).keywords())
    axes.set_xlabel("axial load [kN]")
    axes.set_ylabel("shift of the frequency [%]")
    axes.legend()
    save_figure(figure, folder / "frequencies_under_thrust.png")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
