"""Finite rotations about axes across x, and their derivatives."""

from __future__ import annotations

from typing import Final

import numpy as np

from rolamento.numerics import FloatArray

__all__ = ["rotation_of"]

_SMALL: Final = 1e-3
"""rad: below, the functions of the angle are taken by their series."""


def rotation_of(ry: FloatArray, rz: FloatArray) -> tuple[FloatArray, tuple[FloatArray, FloatArray]]:
    """R of the rotation vector (0, ry, rz), and its derivatives by ry and rz; (cases, 3, 3).

    R = 1 + a K + b K², a = sin θ/θ, b = (1 - cos θ)/θ². Rodrigues (1840).
    """
    generators = np.zeros((2, 3, 3))  # of x toward -z about y, of x toward y about z
    generators[0, 0, 2], generators[0, 2, 0] = 1.0, -1.0
    generators[1, 0, 1], generators[1, 1, 0] = -1.0, 1.0
    angles = (ry, rz)
    theta = np.hypot(ry, rz)
    small = theta < _SMALL
    t = np.where(small, 1.0, theta)
    square = theta**2
    a = np.where(small, 1.0 - square / 6.0, np.sin(t) / t)
    b = np.where(small, 0.5 - square / 24.0, (1.0 - np.cos(t)) / t**2)
    # a'(θ)/θ and b'(θ)/θ
    a_slope = np.where(small, -1.0 / 3.0 + square / 30.0, (t * np.cos(t) - np.sin(t)) / t**3)
    b_slope = np.where(
        small, -1.0 / 12.0 + square / 180.0, (t * np.sin(t) - 2.0 * (1.0 - np.cos(t))) / t**4
    )
    k = sum(
        angle[:, np.newaxis, np.newaxis] * g for angle, g in zip(angles, generators, strict=True)
    )
    k = np.asarray(k)
    a, b, a_slope, b_slope = (f[:, np.newaxis, np.newaxis] for f in (a, b, a_slope, b_slope))
    rotation = np.eye(3) + a * k + b * k @ k
    turns = []
    for angle, g in zip(angles, generators, strict=True):
        share = angle[:, np.newaxis, np.newaxis]
        turns.append(a * g + b * (g @ k + k @ g) + share * (a_slope * k + b_slope * k @ k))
    return rotation, (turns[0], turns[1])
