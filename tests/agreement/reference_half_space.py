"""Two bodies pressed together, solved over the whole area of contact: nothing is assumed of the
pressure's shape.

The surface is cut into rectangles of even pressure, whose displacements are Love's (1929; Johnson
1985, eq. 3.25); sums over rectangles go by FFT, and the conditions of contact (pressure where they
touch, a gap elsewhere) by the conjugate gradients of Polonsky and Keer, Wear 231 (1999) 206, for a
given approach. Nothing is shared with the program.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Pressed:
    """x across, y along: places (m) and pressure (Pa) of the rectangles, (x, y)."""

    x: Floats
    y: Floats
    pressure: Floats
    gap_error: float

    @property
    def area(self) -> float:
        return float((self.x[1] - self.x[0]) * (self.y[1] - self.y[0]))

    @property
    def load(self) -> float:
        return float(self.pressure.sum() * self.area)

    @property
    def moment(self) -> float:
        return float((self.pressure * self.y).sum() * self.area)

    @property
    def load_per_length(self) -> Floats:
        return np.asarray(self.pressure.sum(axis=0) * (self.x[1] - self.x[0]))


def love(x: Floats, y: Floats, a: float, b: float) -> Floats:
    """Displacement times π E* of a rectangle 2a by 2b under a pressure of 1."""
    total = np.zeros(np.broadcast(x, y).shape)
    for sign_x in (1.0, -1.0):
        for sign_y in (1.0, -1.0):
            u, v = x + sign_x * a, y + sign_y * b
            r = np.hypot(u, v)
            total += (
                sign_x * sign_y * (u * np.arcsinh(v / np.abs(u)) + v * np.arcsinh(u / np.abs(v)))
            )
            del r
    return total


def press(
    interference: Floats, x: Floats, y: Floats, modulus: float, tolerance: float = 1e-10
) -> Pressed:
    """Solve for the pressure; interference (x, y) of the undeformed bodies, m."""
    dx, dy = x[1] - x[0], y[1] - y[0]
    nx, ny = interference.shape
    i = np.concatenate([np.arange(nx), [0], np.arange(-nx + 1, 0)])
    j = np.concatenate([np.arange(ny), [0], np.arange(-ny + 1, 0)])
    kernel = love(i[:, None] * dx, j[None, :] * dy, 0.5 * dx, 0.5 * dy) * 2.0 / (np.pi * modulus)
    spectrum = np.fft.rfft2(kernel)

    def displacement(p: Floats) -> Floats:
        return np.asarray(
            np.fft.irfft2(np.fft.rfft2(p, s=kernel.shape) * spectrum, s=kernel.shape)
        )[:nx, :ny]

    depth = float(interference.max())
    pressure = np.where(interference > 0.0, modulus * depth / (dx * nx), 0.0)
    direction, before, restart = np.zeros_like(pressure), 1.0, True
    error = np.inf
    for _ in range(2000):
        gap = displacement(pressure) - interference  # r: zero in contact, positive outside
        touching = pressure > 0.0
        size = float((gap[touching] ** 2).sum())
        direction = np.where(touching, gap + (0.0 if restart else size / before) * direction, 0.0)
        before = size
        pull = displacement(direction)
        step = float((gap * direction)[touching].sum() / (pull * direction)[touching].sum())
        pressure = np.where(touching, pressure - step * direction, 0.0)
        pressure = np.maximum(pressure, 0.0)
        overlapping = (pressure == 0.0) & (gap < 0.0)
        restart = bool(overlapping.any())
        pressure = np.where(overlapping, pressure - step * gap, pressure)
        error = float(np.abs(gap[touching]).max() / depth)
        if error < tolerance and not restart:
            break
    return Pressed(x, y, pressure, error)
