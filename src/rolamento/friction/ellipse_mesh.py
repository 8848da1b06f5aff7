"""Points and weights on a contact ellipse, made for integrals with Hertz's pressure.

In unit coordinates u = x0/a and v = y0/b, with v = s √(1 - u²),

    ∫ p g dA = (3Q/2π) ∫∫ (1 - u²) √(1 - s²) g du ds

so Gauss-Legendre in u and Gauss-Chebyshev of the second kind in s carry the pressure in their
weights: the load itself, and any polynomial g of moderate degree, come out exact, and the same
points serve every contact.

DLMF 3.5(v).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray

MOST_POINTS = 2000


@dataclass(frozen=True, slots=True)
class EllipseMesh:
    """Points (points,) in u = x0/a and v = y0/b; the weights add up to one.

    The load times the weighted sum of g is ∫ p g dA.
    """

    across: FloatArray
    along: FloatArray
    weight: FloatArray

    def folded(self) -> EllipseMesh:
        """The half with y0 ≥ 0, for integrands that are even along rolling."""
        kept = self.along > -_MIDDLE
        share = np.where(np.abs(self.along[kept]) < _MIDDLE, 1.0, 2.0)
        return EllipseMesh(self.across[kept], self.along[kept], self.weight[kept] * share)


_MIDDLE = 1e-9


@lru_cache(maxsize=32)
def ellipse_mesh(across: int = 80, along: int = 5) -> EllipseMesh:
    """Return the points of a mesh.

    Parameters
    ----------
    across, along : number of points across rolling and along it, at least 2 and 1.

    Returns
    -------
    EllipseMesh of across × along points; its arrays do not change.

    Raises
    ------
    InputError
        If a number is out of range.
    """
    for name, count, least in (("across", across, 2), ("along", along, 1)):
        if not least <= count <= MOST_POINTS:
            raise InputError(
                f"must be from {least} to {MOST_POINTS}", field=f"mesh.{name}", value=count
            )
    u, legendre = np.polynomial.legendre.leggauss(across)
    angle = np.arange(1, along + 1) * np.pi / (along + 1)
    s, chebyshev = np.cos(angle), np.pi / (along + 1) * np.sin(angle) ** 2
    weight = 1.5 / np.pi * ((1.0 - u**2) * legendre)[:, np.newaxis] * chebyshev
    v = np.sqrt(1.0 - u**2)[:, np.newaxis] * s
    mesh = EllipseMesh(np.repeat(u, along), v.ravel(), weight.ravel())
    for array in (mesh.across, mesh.along, mesh.weight):
        array.setflags(write=False)
    return mesh
