"""Why a torque model is not valid, or only with a remark."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from rolamento.words.sentences import Sentence
from rolamento.words.speaking import marked, said

__all__ = ["SENTENCES"]

_WHY: Final = {
    "inertia": marked("The inertia of the balls is not negligible: {models}."),
    "full_film": marked("A full film leaves no Coulomb friction: {models}."),
    "no_film": marked("There is no lubricant film: {models}."),
    "other_angle": marked("The constants are for another contact angle: {models}."),
    "for_balls": marked("For ball bearings only: {models}."),
    "axial_share": marked("The axial load on the ribs is too high: {models}."),
    "torque_at_rest": marked("Nothing rotates: {models}."),
    "torque_unknown": marked("No result: {models}."),
}


def _no_model(values: Mapping[str, Any]) -> str:
    given = values["reasons"]
    every = len({title for titles in given.values() for title in titles})
    reasons = []
    for key, titles in given.items():
        all_of_them = len(titles) == every > 1
        names = said("all models") if all_of_them else "; ".join(said(title) for title in titles)
        reasons.append(said(_WHY[key], models=names))
    first = said("No model of the friction torque is valid here: the torque is an estimate.")
    return " ".join([first, *reasons])


def _above_models(values: Mapping[str, Any]) -> str:
    return said(
        "The models of whole bearings give less, {torque}: what raises the torque here is the"
        " assumption of full inlets, or the coefficient of friction.",
        torque=_torques(values),
    )


def _below_models(values: Mapping[str, Any]) -> str:
    return said(
        "The models of whole bearings give more, {torque}: their constants include the cage, the"
        " skew of rollers and the oil that is moved, which are not resolved here.",
        torque=_torques(values),
    )


def _torques(values: Mapping[str, Any]) -> str:
    """The range of torques; one where there is one model."""
    low, high = values["low"], values["high"]
    if low == high:
        return said("{torque:.3 N·m}", torque=low)
    return said("{low:.3 N·m} to {high:.3 N·m}", low=low, high=high)


SENTENCES: Final[dict[str, Sentence]] = {
    "inertia": marked(
        "The gyroscopic moment or the centrifugal force on a ball exceeds {share:.0f %} of what"
        " friction or its load can hold."
    ),
    "full_film": marked("A lubricant film separates the surfaces: friction is not Coulomb's."),
    "film_by_regime": marked(
        "A lubricant film separates the surfaces: the coefficient of friction stands for its shear."
    ),
    "rating_of_steel": marked(
        "C_0 is taken as that of the bearing with steel balls, for which the constants of the model"
        " hold."
    ),
    "coefficient_by_regime": marked(
        "No coefficient of friction is given (`lubricant.friction_coefficient`): it is taken by the"
        " regime of lubrication as in SKF's model, {coefficient:.2}; with its values from {low:.2}"
        " to {high:.2} the torque is {low_torque:.3 N·m} to {high_torque:.3 N·m}."
    ),
    "inlets_flooded": marked(
        "Torque and power are an upper bound: the inlets of the contacts are assumed to be full of"
        " oil, which at this speed and viscosity is not certain (`film.starvation` ="
        ' "replenishment" counts what is lacking).'
    ),
    "inlets_starved_as_film": marked(
        "Torque and power are an upper bound: lack of oil in the inlets takes more off the rolling"
        " resistance of the oil than off the film, by which it is counted."
    ),
    "inlets_isothermal": marked(
        "Torque and power are an upper bound: the heat of shear in the inlets is left out"
        ' (`film.thermal` = "none").'
    ),
    "rib_without_film": marked(
        "Torque and power are an upper bound: the film between roller end and rib is not known and"
        " is assumed to be absent (`bearing.roller_end_radius`)."
    ),
    "torque_above_models": _above_models,
    "torque_below_models": _below_models,
    "partial_film": marked(
        "A lubricant film carries part of the load: the coefficient of friction is an effective"
        " one."
    ),
    "no_film": marked("The asperities carry the load, and the model is for lubricated bearings."),
    "more_contacts": marked(
        "Balls bear on both arcs of a ring and have to slide on them; this model lets each pair of"
        " contacts move the ball for itself, so that its torque is too low."
    ),
    "other_angle": marked(
        "The manufacturer's constants are for bearings of another contact angle."
    ),
    "for_balls": marked("The model is of balls, and there are none."),
    "axial_share": marked(
        "The axial load on the ribs is more than {share:.0f %} of the radial load: the constant of"
        " the model does not hold."
    ),
    "rib_film_unknown": marked(
        "The film between roller end and rib is not known (`bearing.roller_end_radius`, lubricant,"
        " roughness): the rib slides with the coefficient of friction of the lubricant, an upper"
        " bound."
    ),
    "torque_at_rest": marked("Nothing rotates: the torque is that of the first motion."),
    "torque_unknown": marked("The state, or the model, has no result."),
    "no_valid_torque_model": _no_model,
    "no_friction_control_of_sets": marked(
        "Friction control, which includes the inertia of the balls, is not available for sets of"
        " rows: solve one bearing alone with its share of the load."
    ),
    "friction_control_has_inertia": marked(
        "Friction control includes the inertia of the balls: solve with `model.raceway_control` ="
        ' "friction".'
    ),
}
