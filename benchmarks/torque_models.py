"""Every model of the friction torque side by side: ten bearings, six speeds, three oils.

    python -m benchmarks.torque_models

`--markdown FILE` writes docs/torque-models.md (a minute). No coefficient of friction is given: it
is that of the regime of lubrication, as for anybody who names a bearing and an oil.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from math import pi
from pathlib import Path
from typing import Any, Final

import numpy as np

from rolamento import Case, analyse
from rolamento.catalogue import geometry_of
from rolamento.friction import TORQUE_MODELS, Friction
from rolamento.friction.summary import MODELS_AGREE
from rolamento.words import speaking

RPM: Final = pi / 30.0


@dataclass(frozen=True)
class Loaded:
    """A bearing of the catalogue, and its load as shares of the dynamic load rating."""

    designation: str
    radial: float
    axial: float = 0.0
    preload: str = ""

    @property
    def load(self) -> str:
        """In words of the table."""
        shares = {"F_r": self.radial, "F_a": self.axial}
        return " and ".join(
            f"{name} = C/{1 / share:.0f}" for name, share in shares.items() if share
        )


BEARINGS: Final = (
    Loaded("6205", 0.1),
    Loaded("6310", 0.1),
    Loaded("7210 B", 0.1, 0.1),
    Loaded("7014 C DB", 0.05, 0.05, preload="200 N"),
    Loaded("3206", 0.1, 0.05),
    Loaded("1208", 0.1),
    Loaded("51110", 0.0, 0.1),
    Loaded("NU 210", 0.1),
    Loaded("30206", 0.1, 0.05),
    Loaded("NA 4910", 0.1),
)
OILS: Final = ("ISO VG 32", "ISO VG 100", "ISO VG 320")
SPEEDS: Final = (1e3, 1e4, 5e4, 1.5e5, 3e5, 5e5)
"""n d_m, r/min times mm."""
TEMPERATURE: Final = 343.15
MODELS: Final = tuple(TORQUE_MODELS)


@dataclass(frozen=True)
class Row:
    """A bearing in an oil at a speed, rpm: the torque by every model, N·m, or None."""

    oil: str
    speed: float
    torque: float
    bound: bool
    models: dict[str, tuple[float, bool] | None]
    notes: tuple[str, ...]

    def spread(self, *, whole: bool = False) -> tuple[float, float]:
        """Minimum and maximum by the other models that are valid; NaN where there is none.

        whole: by the models of whole bearings alone, which share nothing with the one in use.
        """
        found = [
            one[0]
            for name, one in self.models.items()
            if one is not None and one[1] and not (whole and TORQUE_MODELS[name].of_contacts)
        ]
        return (min(found), max(found)) if found else (np.nan, np.nan)

    def outside(self, *, whole: bool = False) -> float:
        """By which factor the model in use lies outside the spread: 1 within, above 1 or below."""
        low, high = self.spread(whole=whole)
        if np.isnan(low) or low * (1.0 - 1e-9) <= self.torque <= high * (1.0 + 1e-9):
            return 1.0 if np.isfinite(low) else np.nan
        return self.torque / (low if self.torque < low else high)

    @property
    def verdict(self) -> str:
        """Where the model in use lies among the others."""
        found = self.outside()
        if np.isnan(found):
            return "no other is valid"
        note = " (note)" if self.noted else ""
        if found == 1.0:
            return f"within{note}"
        return f"×{found:.2f}{note}"

    @property
    def noted(self) -> bool:
        """Whether the page of the case says that the models of whole bearings lie elsewhere."""
        return any(key.startswith("torque_") for key in self.notes)


def case_of(loaded: Loaded, oil: str, speed: float, **film: Any) -> Case:
    """The case of a bearing in an oil at a speed, rad/s."""
    published = geometry_of(loaded.designation).bearing
    bearing: dict[str, Any] = {"designation": loaded.designation}
    if loaded.preload:
        bearing |= {"spacing": published.width, "preload": loaded.preload}
    rating = published.dynamic_rating
    assert rating is not None
    return Case(
        bearing=bearing,
        duty={
            "inner_speed": speed,
            "load": {"fx": loaded.axial * rating, "fz": loaded.radial * rating},
        },
        lubricant=oil,
        temperature={"lubricant": TEMPERATURE},
        **({"film": film} if film else {}),
    )


def row_of(loaded: Loaded, oil: str, speed: float, **film: Any) -> Row:
    """Evaluate every model of a bearing in an oil; n d_m in r/min times mm."""
    published = geometry_of(loaded.designation).bearing
    mean = 0.5e3 * (published.bore + published.outside_diameter)
    rpm = float(f"{speed / mean:.3g}")
    analysis = analyse(case_of(loaded, oil, rpm * RPM, **film))
    friction = analysis.friction
    assert friction is not None, (loaded, oil, rpm)
    return Row(
        oil,
        rpm,
        float(friction.torque[0]),
        bool(friction.upper_bound[0]),
        {name: _by(friction, name) for name in MODELS if name != friction.model},
        tuple(note.key for note in friction.qualifications(analysis.solved)),
    )


def _by(friction: Friction, name: str) -> tuple[float, bool] | None:
    """Running torque of all sources by a model, and whether it is valid."""
    found = {one.model: bool(one.valid[0]) for one in friction.judged}
    if name not in found:
        return None
    torque = float(friction.models[name].total[0])
    if TORQUE_MODELS[name].of_contacts:
        torque += float(friction.torque[0] - friction.models[friction.model].total[0])
    return torque, found[name]


def table(loaded: Loaded) -> list[Row]:
    """All oils and speeds of a bearing."""
    return [row_of(loaded, oil, speed) for oil in OILS for speed in SPEEDS]


def line(row: Row) -> str:
    """A row of the page."""
    cells = [row.oil, f"{row.speed:.6g}", f"**{'≤ ' * row.bound}{row.torque:.3g}**"]
    for name in _COLUMNS:
        found = row.models.get(name)
        if found is None or np.isnan(found[0]):
            cells.append("")
        else:
            cells.append(f"{found[0]:.3g}" if found[1] else f"({found[0]:.3g})")
    return f"| {' | '.join([*cells, row.verdict])} |"


_COLUMNS: Final = (
    "jones_control", "jones_simplified", "harris_1971", "todd", "palmgren", "skf",
)  # fmt: skip
_PAIR: Final = Loaded("7014 C DB", 0.02, 0.01, preload="240 N")
_HEAD: Final = """# Torque models compared

Written by `python -m benchmarks.torque_models --markdown docs/torque-models.md`. What the models
are: [theory](theory/friction.md); how a case chooses among them: [film and
friction](friction.md).

Running torque in N·m of ten bearings of the catalogue in three oils at 70 °C and six speeds, n
d_m from 10³ to 5·10⁵ mm/min. No coefficient of friction is given, so that it is that of the
regime of lubrication. **In use** is what a page shows first, ≤ where it says that this is an
upper bound; in brackets a model that is not valid there. The last column compares it with all
other valid models: within their spread, or its ratio to the nearest of them; *(note)* where it
is more than a factor {agree:g} outside what Palmgren and SKF give, which the page of the case
then says. "Outside by less" is by a factor up to {agree:g}.
"""
_WHY: Final = """
## Where the model in use lies outside, and why

- **Rollers at low speed** lie below Palmgren and SKF: a roller of a cylindrical or needle
  bearing rolls without slip in this model, and what is left at low speed is hysteresis and oil.
  The others' constants were measured on whole bearings, whose cage slides and whose rollers
  skew; Palmgren's M_0 does not fall with the speed at all below ν n = 2000. SKF has no constants
  of needle roller bearings, and Palmgren's f_0 = 12 makes four times as much of them as of
  cylindrical ones.
- **Angular contact of 15°** (7014 C) lies below: SKF has constants for 40° only and is shown in
  brackets. Palmgren's f_0 = 3.3 of an oil bath counts the oil that balls and cage churn, which
  is not in the contacts; with oil-air (1.7) the two meet, see below.
- **Thick oil at high speed** lies above: with inlets full of oil the rolling resistance is an
  upper bound, as the page says. `film.starvation = "replenishment"` takes off what SKF's model
  takes off.
- **Slow ball bearings** lie above Palmgren, whose load part does not grow where the film is
  lost; SKF's does.

## A spindle pair at speed

7014 C DB, preload 240 N, ISO VG 32 at 70 °C: the torque of the pair in N·m.
"""
_MOUNTED: Final = """
7014 C/HCP4A DB, preload 240 N before mounting, js4 and JS5, inner ring 48 °C, outer ring 42 °C,
F_a 400 N, F_r 800 N, ISO VG 32 at 45 °C: torque (N·m) and power loss of the pair.
"""
_SUPPLIES: Final[dict[str, dict[str, Any]]] = {
    "flooded inlets": {},
    "oil-air, replenishment": {"starvation": "replenishment", "supply": "oil_air"},
}


def mounted_pair(rpm: float, film: dict[str, Any]) -> tuple[float, float, bool, float]:
    """Torque (N·m) and power loss (W) of a mounted hybrid pair, whether a bound, and Palmgren's."""
    case = Case(
        bearing={"designation": "7014 C/HCP4A DB", "preload": "240 N"},
        duty={"inner_speed": f"{rpm} rpm", "load": {"fx": "400 N", "fz": "800 N"}},
        mounting={"shaft_tolerance": "js4", "housing_tolerance": "JS5"},
        temperature={"inner_ring": "48 degC", "outer_ring": "42 degC", "lubricant": "45 degC"},
        lubricant="ISO VG 32",
        film=film or None,
    )
    friction = analyse(case).friction
    assert friction is not None
    torque, power = float(friction.torque[0]), float(friction.power[0])
    palmgren = float(friction.models["palmgren"].total[0])
    return torque, power, bool(friction.upper_bound[0]), palmgren


def page() -> str:
    """The page of the documentation."""
    with speaking("en"):
        tables = {loaded: table(loaded) for loaded in BEARINGS}
        pair = [
            (name, rpm, row_of(_PAIR, "ISO VG 32", rpm * 90.0, **film))
            for name, film in _SUPPLIES.items()
            for rpm in (5000.0, 15000.0, 24000.0)
        ]
    rows = [row for found in tables.values() for row in found]
    lines = [
        _HEAD.format(agree=MODELS_AGREE),
        "| compared with | cells | within | outside by less | further |",
        "|---|---|---|---|---|",
        _counted("all other valid models", [row.outside() for row in rows]),
        _counted("Palmgren and SKF alone", [row.outside(whole=True) for row in rows]),
    ]
    names = [TORQUE_MODELS[name].title for name in _COLUMNS]
    head = ["oil", "r/min", "in use", *names, "among the others"]
    for loaded, found in tables.items():
        lines += ["", f"## {loaded.designation}", "", f"{loaded.load}.", ""]
        lines += [f"| {' | '.join(head)} |", "|" + "---|" * len(head), *map(line, found)]
    lines += [_WHY, "| inlets | r/min | in use | Palmgren |", "|---|---|---|---|"]
    for name, rpm, row in pair:
        palmgren = row.models["palmgren"]
        assert palmgren is not None
        mark = "≤ " * row.bound
        lines.append(f"| {name} | {rpm:.6g} | {mark}{row.torque:.3g} | {palmgren[0]:.3g} |")
    lines += [_MOUNTED, "| inlets | r/min | in use | W | Palmgren |", "|---|---|---|---|---|"]
    for name, film in _SUPPLIES.items():
        for rpm in (15000.0, 24000.0):
            torque, power, bound, palmgren_torque = mounted_pair(rpm, film)
            mark = "≤ " * bound
            lines.append(
                f"| {name} | {rpm:.6g} | {mark}{torque:.3g} | {mark}{power:.4g} |"
                f" {palmgren_torque:.3g} |"
            )
    return "\n".join(lines) + "\n"


def _counted(name: str, outside: list[float]) -> str:
    """How many cells lie how far outside the spread."""
    known = [max(one, 1.0 / one) for one in outside if np.isfinite(one)]
    within = sum(one == 1.0 for one in known)
    near = sum(1.0 < one <= MODELS_AGREE for one in known)
    return f"| {name} | {len(known)} | {within} | {near} | {len(known) - within - near} |"


def main(arguments: list[str] | None = None) -> int:
    """Print the page, or write it."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--markdown", type=Path, help="write the tables of the documentation here")
    options = parser.parse_args(arguments)
    text = page()
    if options.markdown is None:
        print(text)
    else:
        options.markdown.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
