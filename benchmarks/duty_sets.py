"""The duties that the speed is measured on: seeded, so that every run solves the same cases.

All are for the 218 angular-contact bearing of the shipped example. A set is a dictionary of
arrays over cases, in SI units, as `rolamento.solve_batch` takes them.
"""

from __future__ import annotations

import math
from importlib import resources
from pathlib import Path
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

import rolamento

Floats: TypeAlias = NDArray[np.float64]
Duties: TypeAlias = dict[str, Floats]

CASES = 100_000
SEED = 218
TOP_SPEED = 15_000 * math.pi / 30.0
"""rad/s: 15 000 rpm."""


def example_path() -> Path:
    """Where the shipped case file of the 218 bearing is."""
    return Path(str(resources.files("rolamento") / "examples" / "218_combined.toml"))


def example() -> rolamento.Case:
    """The 218 bearing of the shipped example, outer raceway control."""
    return rolamento.load_case(example_path())


def tilts_held(cases: int = CASES) -> Duties:
    """The duty set with three unknowns: fx, fy, fz and the speed vary, the ring does not tilt."""
    random = np.random.default_rng(SEED)
    fx = random.uniform(2e3, 45e3, cases)
    return {
        "fx": fx,
        "fz": fx * random.uniform(0.0, 0.9, cases),
        "fy": fx * random.uniform(-0.4, 0.4, cases),
        "inner_speed": random.uniform(0.0, TOP_SPEED, cases),
    }


def moments_given(cases: int = CASES) -> Duties:
    """The duty set with five unknowns: the same forces and speeds, and moments."""
    duties = tilts_held(cases)
    random = np.random.default_rng(SEED + 1)
    for moment in ("my", "mz"):
        duties[moment] = duties["fx"] * random.uniform(-0.020, 0.020, cases)
    return duties


def in_a_plane(cases: int = CASES) -> Duties:
    """The first duty set without its fy: load and ring have a plane of symmetry."""
    return tilts_held(cases) | {"fy": np.zeros(cases)}


def hard(cases: int = CASES) -> Duties:
    """Where a solver has a hard time: light and fast, or with little axial load, and tilted.

    A third of the cases have 50 N of axial load between half and full speed; in all of them
    fz/fx goes to 3 and the ring is tilted by up to 0.1°; in half of them the outer ring turns.
    """
    random = np.random.default_rng(SEED + 2)
    light = random.random(cases) < 1.0 / 3.0
    speed = random.uniform(np.where(light, 0.5, 0.0), 1.0) * TOP_SPEED
    outer_turns = random.random(cases) < 0.5
    fx = np.where(light, 50.0, random.uniform(2e3, 45e3, cases))
    tilt = math.radians(0.1)
    return {
        "fx": fx,
        "fz": fx * random.uniform(0.0, 3.0, cases),
        "fy": fx * random.uniform(-0.4, 0.4, cases),
        "ry": random.uniform(-tilt, tilt, cases),
        "rz": random.uniform(-tilt, tilt, cases),
        "inner_speed": np.where(outer_turns, 0.0, speed),
        "outer_speed": np.where(outer_turns, speed, 0.0),
    }


def some(duties: Duties, cases: int) -> Duties:
    """The first cases of a set."""
    return {name: values[:cases] for name, values in duties.items()}
