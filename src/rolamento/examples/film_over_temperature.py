"""Viscosity ratio κ and film parameter λ of a 6305 over the temperature of its oil.

    python film_over_temperature.py [FOLDER]

Both ask whether the surfaces touch, and they do not say the same: κ compares viscosities, λ the
film with the roughness.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from rolamento import Case, solve
from rolamento.charts.style import in_style, new_figure, series
from rolamento.lubrication import film
from rolamento.plots.saving import save_figure


@in_style
def main(folder: Path) -> None:
    """Solve 61 temperatures, say where κ falls below 1, and write film_over_temperature.png."""
    celsius = np.linspace(40.0, 100.0, 61)
    case = Case(
        bearing={"designation": "6305"},
        duty={"inner_speed": "2000 rpm", "load": {"fz": "4 kN"}},
        lubricant="ISO VG 68",
        temperature={"lubricant": "60 degC"},
        surface={
            "inner_roughness": "0.08 um",
            "outer_roughness": "0.08 um",
            "ball_roughness": "0.03 um",
        },
    )
    found = film(solve(case, {"temperature.lubricant": celsius + 273.15}))
    kappa, lam = found.viscosity_ratio, found.minimum_film_parameter
    first = np.flatnonzero(kappa < 1.0)[0]
    print(f"κ is below 1 from {celsius[first]:.0f} °C on, λ is {lam[first]:.2f} there")
    figure, axes = new_figure(height=75.0)
    axes.plot(celsius, kappa, label="κ", **series(0).keywords())
    axes.plot(celsius, lam, label="λ", **series(1).keywords())
    axes.axhline(1.0, color="0.4", linewidth=0.8)
    axes.set_xlabel("temperature of the oil [°C]")
    axes.set_ylabel("κ, λ [–]")
    axes.legend()
    save_figure(figure, folder / "film_over_temperature.png")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
