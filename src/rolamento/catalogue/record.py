"""What a catalogue holds of one bearing, with the source of each figure."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import Final, Literal

__all__ = ["FIGURES", "CatalogueBearing", "Kind"]

Kind = Literal["deep_groove", "angular_contact"]


@dataclass(frozen=True, slots=True, kw_only=True)
class CatalogueBearing:
    """One bearing of a catalogue; what its maker does not publish is None.

    Attributes
    ----------
    designation
        As the maker writes it.
    maker
        Its name; may be empty.
    kind
        ``"deep_groove"`` or ``"angular_contact"``.
    bore, outside_diameter, width
        d, D and B, in m.
    contact_angle
        α, nominal, in rad.
    dynamic_rating, static_rating
        C and C_0, radial, in N.
    f0
        Factor of the static rating and of the axial load factors, in N/mm².
    ball_count, ball_diameter, pitch_diameter
        Z, D and d_m (m), where published.
    inner_conformity, outer_conformity
        f_i and f_o, where published.
    sources
        Where each figure comes from, by its name.
    """

    designation: str
    maker: str = ""
    kind: Kind = "deep_groove"
    bore: float
    outside_diameter: float
    width: float | None = None
    contact_angle: float | None = None
    dynamic_rating: float | None = None
    static_rating: float | None = None
    f0: float | None = None
    ball_count: int | None = None
    ball_diameter: float | None = None
    pitch_diameter: float | None = None
    inner_conformity: float | None = None
    outer_conformity: float | None = None
    sources: Mapping[str, str] = field(default_factory=dict, hash=False)

    @property
    def mean_diameter(self) -> float:
        """(d + D)/2, in m: near the pitch diameter."""
        return 0.5 * (self.bore + self.outside_diameter)

    @property
    def section_height(self) -> float:
        """(D − d)/2, in m."""
        return 0.5 * (self.outside_diameter - self.bore)

    @property
    def figures(self) -> dict[str, float]:
        """The figures that are published, by their name, in SI."""
        found = {name: getattr(self, name) for name in FIGURES}
        return {name: value for name, value in found.items() if value is not None}

    @property
    def source(self) -> str:
        """The source of the boundary dimensions."""
        return self.sources.get("bore", "")


FIGURES: Final = tuple(
    part.name
    for part in fields(CatalogueBearing)
    if part.name not in ("designation", "maker", "kind", "sources")
)
"""Names of the figures of a `CatalogueBearing`."""
