"""The input of a diagnosis: the orders of the bearing's faults, and how sure to be of a finding."""

from __future__ import annotations

from math import isfinite
from typing import TYPE_CHECKING, Final, Literal

from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.validate import number
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.vibration.frequencies import FaultFrequencies, RollingElement


Component = Literal["outer_race", "inner_race", "ball", "cage"]
COMPONENTS: Final[tuple[Component, ...]] = ("outer_race", "inner_race", "ball", "cage")
_HIGHEST: Final = 1000.0
_MULTIPLES_ELSEWHERE: Final = 3
_MOST_KNOWN: Final = 20
_LEAST_KNOWN: Final = 0.01
"""Multiples of a lower order would leave nothing to look at."""


@frozen
class FaultOrders:
    """Orders of a bearing's faults: multiples of the shaft's frequency.

    A component without an order is not looked for.

    Attributes
    ----------
    outer_race, inner_race
        balls that pass a point of the race, per revolution of the shaft
    ball
        turns of a ball about its own axis; its damage strikes twice in each
    cage
        turns of the cage
    outer_spacing, inner_spacing
        turns of the rings against the load: damage to a ring that turns goes in and out of the
        load, which gives sidebands at these spacings; 0 for a ring that stands still. Damage to a
        ball has sidebands at the spacing of the cage.
    known
        orders of other things that turn and are known to be there, such as the other shafts of a
        gearbox, or a half order; they and their multiples are left out, as those of the shaft are
    elsewhere
        orders of the faults of other bearings of the machine: peaks there, and at their multiples
        up to the third, are not unexplained
    element
        what rolls, "ball" or "roller": the component "ball" is called so

    Raises
    ------
    InputError
        If a number is out of range, or no component has an order.
    """

    outer_race: float | None = None
    inner_race: float | None = None
    ball: float | None = None
    cage: float | None = None
    outer_spacing: float = 0.0
    inner_spacing: float = 1.0
    known: tuple[float, ...] = ()
    element: RollingElement = "ball"
    elsewhere: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        present = [name for name in COMPONENTS if getattr(self, name) is not None]
        if not present:
            raise InputError(
                said("must give at least one of {components}", components=", ".join(COMPONENTS)),
                field="orders",
                example="outer_race = 3.585",
            )
        for part in present:
            self._check(part, above=0.0)
        for spacing in ("outer_spacing", "inner_spacing"):
            self._check(spacing, least=0.0)
        if len(self.known) > _MOST_KNOWN:
            raise InputError(
                said("must be at most {most} orders", most=_MOST_KNOWN),
                field="known",
                example="(0.5,)",
            )
        for order in self.known:
            number(order, "known", least=_LEAST_KNOWN, most=_HIGHEST, example="(0.5,)")

    @classmethod
    def from_frequencies(
        cls,
        shaft: float,
        *,
        outer_race: float | None = None,
        inner_race: float | None = None,
        ball: float | None = None,
        cage: float | None = None,
    ) -> FaultOrders:
        """Return the orders of frequencies of a bearing whose outer ring stands still; all in Hz.

        Raises
        ------
        InputError
            If a number is out of range, or no component has a frequency.
        """
        number(shaft, "shaft", above=0.0, example="shaft = 29.95")
        return cls(
            outer_race=None if outer_race is None else outer_race / shaft,
            inner_race=None if inner_race is None else inner_race / shaft,
            ball=None if ball is None else ball / shaft,
            cage=None if cage is None else cage / shaft,
        )

    @classmethod
    def of(cls, frequencies: FaultFrequencies, known: tuple[float, ...] = ()) -> FaultOrders:
        """Return the orders of the fault frequencies of a bearing; what has none is left out."""
        lines = {
            "outer_race": frequencies.ball_pass_outer.order,
            "inner_race": frequencies.ball_pass_inner.order,
            "ball": frequencies.ball_spin.order,
            "cage": frequencies.cage.order,
        }
        present = {name: line for name, line in lines.items() if isfinite(line) and line > 0.0}
        return cls(
            outer_race=present.get("outer_race"),
            inner_race=present.get("inner_race"),
            ball=present.get("ball"),
            cage=present.get("cage"),
            outer_spacing=frequencies.spacing("outer_race"),
            inner_spacing=frequencies.spacing("inner_race"),
            known=known,
            element=frequencies.rolling_element,
        )

    def fundamental(self, component: Component) -> float | None:
        """Return how often a component's damage strikes per revolution, if it is looked for."""
        order: float | None = getattr(self, component)
        return None if order is None else (2.0 * order if component == "ball" else order)

    def spacing(self, component: Component) -> float:
        """Return the spacing of a component's sidebands; 0 for none."""
        spacings: dict[Component, float] = {
            "outer_race": self.outer_spacing,
            "inner_race": self.inner_spacing,
            "ball": self.cage or 0.0,
            "cage": 0.0,
        }
        return spacings[component]

    def is_elsewhere(self, order: float, slip: float) -> bool:
        """Whether a line may be of another bearing of the machine, whose cage slips by a part."""
        return any(
            abs(order / (number * other) - 1.0) <= slip
            for other in self.elsewhere
            for number in range(1, _MULTIPLES_ELSEWHERE + 1)
        )

    def tolerance(self, component: Component, of_cage: float) -> float:
        """Part by which a component's order may be off when the cage's is off by a part.

        What one race gains by slip or by another contact angle the other loses: their orders add
        up to the number of balls. A ball's spin is as uncertain as the cage.
        """
        if component == "inner_race" and self.outer_race and self.inner_race:
            return of_cage * min(1.0, self.outer_race / self.inner_race)
        return of_cage

    def _check(self, name: str, *, above: float | None = None, least: float | None = None) -> None:
        value = getattr(self, name)
        number(value, name, above=above, least=least, most=_HIGHEST, example=f"{name} = 3.585")


# --- settings ------------------------------------------------------------------------------------


@frozen
class DiagnosisSettings:
    """Settings of a diagnosis.

    Attributes
    ----------
    false_alarm
        probability that noise without lines of the bearing gives any finding; what a finding is
        worth is decided by its size
    tolerance
        part by which the cage may turn faster or slower than its nominal order: slip, and a
        contact angle that is not quite known
    speed_tolerance
        part by which a speed that was given as one number may be wrong: all lines move alike, and
        the shaft's own lines show by how much; 0 if it is certain
    speed_uncertainty
        part by which a speed that is known may still be off or wander
    block_revolutions
        revolutions of the shaft of which one spectrum is made; longer records are averaged
    remove_tones
        whether to take out discrete lines first, as of gears and electric fields; a bearing's own
        impacts slip, and make none

    Raises
    ------
    InputError
        If a number is out of range.
    """

    false_alarm: float = 0.01
    tolerance: float = 0.02
    speed_tolerance: float = 0.03
    speed_uncertainty: float = 0.001
    block_revolutions: float = 400.0
    remove_tones: bool = True

    def __post_init__(self) -> None:
        number(self.false_alarm, "false_alarm", above=0.0, most=0.5, example="false_alarm = 0.01")
        number(self.tolerance, "tolerance", least=0.0, most=0.1, example="tolerance = 0.02")
        number(
            self.speed_tolerance,
            "speed_tolerance",
            least=0.0,
            most=0.1,
            example="speed_tolerance = 0.03",
        )
        number(
            self.speed_uncertainty,
            "speed_uncertainty",
            least=0.0,
            most=0.02,
            example="speed_uncertainty = 0.001",
        )
        number(
            self.block_revolutions,
            "block_revolutions",
            least=2.0,
            most=5000.0,
            example="block_revolutions = 400",
        )
        if not isinstance(self.remove_tones, bool):
            raise InputError(
                said("must be true or false"), field="remove_tones", value=self.remove_tones
            )
