"""What is said of the heat balance."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

from rolamento.words.naming import listed
from rolamento.words.speaking import marked, said

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["CONDUCTANCE_NAMES", "PLACE_NAMES", "SENTENCES", "VARIANT_NAMES"]

PLACE_NAMES: Final = {
    "inner_ring": marked("inner ring"),
    "elements": marked("rolling elements"),
    "outer_ring": marked("outer ring"),
    "shaft": marked("shaft"),
    "housing": marked("housing"),
    "ambient": marked("ambient"),
    "oil": marked("oil flow"),
    "friction": marked("friction"),
    "outside": marked("outside"),
}
"""Names of the nodes and of the other ends of `rolamento.heat.HeatFlow`."""
CONDUCTANCE_NAMES: Final = {
    "inner_ring_elements": marked("inner ring – elements"),
    "elements_outer_ring": marked("elements – outer ring"),
    "inner_ring_shaft": marked("inner ring – shaft"),
    "outer_ring_housing": marked("outer ring – housing"),
    "shaft_ambient": marked("shaft – ambient"),
    "housing_ambient": marked("housing – ambient"),
}
"""Names of the conductances of `rolamento.case.Heat`."""
VARIANT_NAMES: Final = {
    "as_given": marked("as given"),
    "rigid": marked("rigid preload"),
    "spring": marked("springs"),
    "ceramic": marked("ceramic elements"),
    "steel": marked("steel elements"),
}
"""Names of `rolamento.heat.answers.HeatVariant`."""
_TABLE: Final = {
    "balls": marked("balls"),
    "inner_spacer": marked("inner spacers"),
    "outer_spacer": marked("outer spacers"),
}


def _estimated(values: Mapping[str, Any]) -> str:
    names = listed([said(CONDUCTANCE_NAMES[name]) for name in values["names"]])
    return said(
        "Conductances are estimated, within ± 50 % at best: {names}; give them in [heat].",
        names=names,
    )


def _capacities(values: Mapping[str, Any]) -> str:
    nodes = [name.removesuffix("_capacity") for name in values["names"]]
    return said(
        "Heat capacities are estimated, within ± 50 % at best: {names}; times of warming are in"
        " proportion to them.",
        names=listed([said(PLACE_NAMES[node]) for node in nodes]),
    )


def _bare(values: Mapping[str, Any]) -> str:
    return said(
        "Without [mounting] clearance and preload stay as they are, and nothing grows along the"
        " shaft: {names}.",
        names=listed(values["names"]),
    )


def _replaced(values: Mapping[str, Any]) -> str:
    names = listed([said({**PLACE_NAMES, **_TABLE}[name]) for name in values["names"]])
    return said("The balance replaces the temperatures that the case gives: {names}.", names=names)


def _runaway(values: Mapping[str, Any]) -> str:
    texts = [
        said(
            "The temperature runs away: below {limit:.4 °C} no state is stable.",
            limit=values["limit"],
        )
        if values["merges"]
        else said(
            "Below {limit:.4 °C} no state is stable: the bearing gets warmer than that.",
            limit=values["limit"],
        )
    ]
    speed = values.get("speed")
    if speed:
        text = (
            said("Up to {speed:.4 rpm} ({factor:.3} of the speed) there is one; there the stable"
                 " and the unstable state merge.", speed=speed, factor=values["factor"])
            if values["merges"]
            else said("Up to {speed:.4 rpm} ({factor:.3} of the speed) there is one; there it comes"
                      " to the temperature limit.", speed=speed, factor=values["factor"])
        )  # fmt: skip
        texts.append(text)
    if values.get("lost_at") is not None:
        texts.append(
            said(
                "From {temperature:.4 °C} on the bearing has no equilibrium, or its clearance is"
                " closed past all sense.",
                temperature=values["lost_at"],
            )
        )
    texts.append(said("Remove more heat, reduce the preload or the speed, or take a thinner oil."))
    return " ".join(texts)


SENTENCES: Final[dict[str, Sentence]] = {
    "thermal_runaway": _runaway,
    "heated_past_limit": marked(
        "The heat from outside alone makes a part warmer than {limit:.4 °C}: remove more heat."
    ),
    "conductances_estimated": _estimated,
    "capacities_estimated": _capacities,
    "machine_runaway": marked(
        "The temperature runs away: {bearing} gets warmer than {limit:.4 °C}. Remove more heat,"
        " reduce preloads or the speed, or let a ring slide in its seat."
    ),
    "machine_heat_without_mounting": _bare,
    "machine_lubricant_keeps_temperature": marked(
        "The lubricant keeps the temperature that is given; without `temperature.lubricant` it has"
        " the mean of the rings of each bearing."
    ),
    "limit_passed_at": marked(
        "After {time:.3 min} a part is warmer than {limit:.4 °C}: remove more heat, reduce the"
        " preload, or run up in steps."
    ),
    "heat_without_mounting": marked(
        "Without [mounting] clearance and preload stay as they are: only the lubricant gets warm."
    ),
    "lubricant_keeps_temperature": marked(
        "The lubricant keeps the {temperature:.4 °C} that the case gives; without"
        " `temperature.lubricant` it has the mean of the rings."
    ),
    "temperatures_of_balance": _replaced,
    "hotter_unstable_state": marked(
        "A second, unstable state: a bearing that once has a part warmer than {temperature:.4 °C}"
        " runs away."
    ),
}
"""By key."""
