"""Outputs of life: by every theory in hours and in revolutions, loads, ratings, what limits."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from operator import attrgetter
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.analysis import life_of
from rolamento.errors import InputError
from rolamento.life import LifeSummary
from rolamento.life.theories import THEORIES
from rolamento.life.theory import CLEANLINESS, REQUIRED_LIFE, VISCOSITY_RATIO
from rolamento.studies.outputs import Evaluation, Floats, Output
from rolamento.words import marked, said
from rolamento.words.quantities import CALLED
from rolamento.words.theories import theory_name

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from rolamento.case import Bearing, Case
    from rolamento.case.roller_bearing import RollerBearing
    from rolamento.life import Headline, Life

__all__ = ["life_outputs", "refuse_lifeless"]

Get = Callable[["LifeSummary"], "Floats | None"]

_LIFE: Final = ("life",)
_MODIFIED: Final = (*_LIFE, VISCOSITY_RATIO.name, CLEANLINESS.name)
_LEADING: Final = ""
"""In the place of a theory's name: the life that leads."""
_FACTORS: Final = {
    "iso281": marked("life modification factor a_ISO (ISO 281)"),
    "iso16281": marked("life modification factor a_ISO (ISO/TS 16281)"),
}
"""What the factors of the modified lives are called, by standard."""
_HOURS: Final = "h"
_REVOLUTIONS: Final = "Mrev"
"""As the whole field counts lives; the only outputs that are not in SI units."""


def life_outputs() -> tuple[Output, ...]:
    """Return the outputs of life."""
    return (*_of_theories(), _bound(), *_of_loads(), *_of_factors(), *_of_limit())


def refuse_lifeless(case: Case, varied: frozenset[str]) -> None:
    """Refuse a case that has no life whatever varies; others are found out one by one.

    Raises
    ------
    InputError
        For a thrust bearing, geometry without a rating, or oil dirtier than all classes.
    """
    from rolamento.life import conditions_of
    from rolamento.life.equivalent_load import MAXIMUM_ANGLE
    from rolamento.ratings import dynamic_factor

    rows = [place.bearing for place in case.bearing.places]
    if "model.slices" in varied and any(row.element != "ball" for row in rows):
        raise InputError(
            said(
                "cannot vary where lives of rollers are compared: the edge factor of ISO/TS 16281"
                " acts on the outermost slice however narrow it is"
            ),
            field="model.slices",
            example='outputs = ["outer_max_pressure"]',
        )
    if any(name.startswith(("bearing.", "life.")) for name in varied):
        return
    angle = np.array([row.contact_angle or 0.0 if row.element == "ball" else 0.0 for row in rows])
    if case.bearing.bearing_type.washers:
        return
    if np.any(angle > MAXIMUM_ANGLE * (1.0 + 1e-9)):
        raise InputError(
            said('is above 45°: such a bearing is rated for axial load; give it kind = "thrust"'),
            field="case.bearing.contact_angle",
            value=f"{float(np.degrees(angle.max())):.4g} deg",
            example='kind = "thrust"',
        )
    if conditions_of(case).dynamic_rating is not None:
        return
    if any(row.element != "ball" for row in rows):
        _refuse_unrated_rollers(rows)
        return
    diameter = np.array([row.element_diameter for row in rows])
    pitch = np.array([row.pitch_diameter for row in rows])
    if np.any(np.isnan(dynamic_factor(diameter * np.cos(angle) / pitch))):
        raise InputError(
            said(
                "is missing: the geometry is outside the table of the standard (D cos "
                "α/d_m from 0.01 to 0.40)"
            ),
            field="case.life.dynamic_rating",
            example='[life] dynamic_rating = "20.6 kN"',
        )


def _refuse_unrated_rollers(rows: Sequence[Bearing | RollerBearing]) -> None:
    """Refuse rollers outside the table of the standard that no designation rates."""
    from rolamento.ratings import roller_dynamic_factor

    for row in rows:
        rated = row.published is not None and row.published.dynamic_rating is not None
        gamma = row.element_diameter * np.cos(row.row_angle) / row.pitch_diameter
        if row.element != "ball" and not rated and np.isnan(roller_dynamic_factor(gamma)):
            raise InputError(
                said(
                    "is missing: the geometry is outside the table of the standard (D cos "
                    "α/d_pw from 0.01 to 0.30)"
                ),
                field="case.life.dynamic_rating",
                example='[life] dynamic_rating = "29.3 kN"',
            )


def _of_theories() -> Iterator[Output]:
    leading = (_LEADING, _LIFE, False)
    own = (
        (one.name, (*_LIFE, *(need.name for need in one.needs)), one.slow)
        for one in THEORIES.values()
    )
    for theory, needs, slow in (leading, *own):
        end = f"_{theory}" if theory else ""
        for name, unit, attribute in (
            ("hours", _HOURS, "hours"),
            ("revolutions", _REVOLUTIONS, "life"),
        ):
            compute, called = _number(_life(theory, attribute), slow), partial(_of, name, theory)
            yield Output(f"life_{name}{end}", unit, called, compute, needs=needs, slow=slow)
        yield Output(
            f"life_valid{end}",
            "1",
            partial(_of, "valid", theory),
            _validity(theory, slow),
            kind="whole",
            needs=needs,
            slow=slow,
        )


def _of(what: str, theory: str) -> str:
    if theory == _LEADING:
        return {
            "hours": said("life"),
            "revolutions": said("life in revolutions"),
            "valid": said("life valid (1) or not (0)"),
        }[what]
    name = theory_name(theory)
    return {
        "hours": said("life, {theory}", theory=name),
        "revolutions": said("life in revolutions, {theory}", theory=name),
        "valid": said("life valid (1) or not (0), {theory}", theory=name),
    }[what]


def _bound() -> Output:
    def compute(found: Evaluation) -> NDArray[np.int32]:
        summary, _ = found.of(life_of, stress_volume=False)
        if summary is None:
            return np.zeros(len(found.solved), np.int32)
        return np.asarray(summary.headline.below & found.solved.converged, np.int32)

    return Output(
        "life_upper_bound",
        "1",
        lambda: said("life an upper bound (1) or not (0)"),
        compute,
        kind="whole",
        needs=_LIFE,
    )


def _of_loads() -> Iterator[Output]:
    for name, unit, called, path in (
        ("dynamic_rating", "N", CALLED["dynamic_rating"], "ratings.dynamic_of_set"),
        ("static_rating", "N", CALLED["static_rating"], "ratings.static_of_set"),
        ("fatigue_load_limit", "N", CALLED["fatigue_load_limit"], "ratings.fatigue_of_set"),
        ("equivalent_load", "N", CALLED["equivalent_load"], "loads.dynamic"),
        ("reference_load", "N", CALLED["reference_load"],
         "reference_load"),
        ("static_equivalent_load", "N", CALLED["static_equivalent_load"], "loads.static"),
        ("static_safety", "1", CALLED["static_safety"], "loads.safety"),
    ):  # fmt: skip
        yield Output(name, unit, partial(said, called), _number(attrgetter(path)), needs=_LIFE)
    ratio = _number(_rating_over_load)
    yield Output("rating_over_load", "1", partial(said, CALLED["load_ratio"]), ratio, needs=_LIFE)


def _of_factors() -> Iterator[Output]:
    factors = (
        (f"modification_factor_{standard}", _FACTORS[standard], _factor(one.name), _MODIFIED)
        for one in THEORIES.values()
        if CLEANLINESS in one.needs
        for standard in [one.name.removesuffix("_modified")]
    )
    for name, called, get, needs in (
        ("contamination_factor", CALLED["contamination_factor"], _contamination, _MODIFIED),
        *factors,
        (
            "required_life_reliability",
            CALLED["required_life_reliability"],
            _reliability_of_required,
            (*_LIFE, REQUIRED_LIFE.name),
        ),
    ):
        yield Output(name, "1", partial(said, called), _number(get), needs=needs)


def _of_limit() -> Iterator[Output]:
    """What ends the life: numbers, so that they can be drawn over anything."""
    for name, called, get in (
        (
            "inner_risk_share",
            marked("share of the inner races in the failure probability"),
            _inner_share,
        ),
        (
            "weakest_race_share",
            marked("share of the weakest race in the failure probability"),
            lambda s: s.limit.share,
        ),
        ("weakest_row", marked("row of the weakest race, counted from 0"), _weakest_row),
        (
            "weakest_ball",
            marked("heaviest ball on the weakest race, counted from 0"),
            _weakest_ball,
        ),
    ):
        yield Output(name, "1", partial(said, called), _number(get), needs=_LIFE)


def _number(get: Get, stress_volume: bool = False) -> Callable[[Evaluation], Floats]:
    """Take a number of every case; NaN where there is none."""

    def compute(found: Evaluation) -> Floats:
        summary, _ = found.of(life_of, stress_volume=stress_volume)
        own = None if summary is None else get(summary)
        return np.where(found.solved.converged, np.nan if own is None else own, np.nan)

    return compute


def _validity(theory: str, stress_volume: bool) -> Callable[[Evaluation], NDArray[np.int32]]:
    def compute(found: Evaluation) -> NDArray[np.int32]:
        summary, _ = found.of(life_of, stress_volume=stress_volume)
        own = None if summary is None else _record(summary, theory)
        if own is None:
            return np.zeros(len(found.solved), np.int32)
        return np.asarray(own.valid & found.solved.converged, np.int32)

    return compute


def _record(summary: LifeSummary, theory: str) -> Life | Headline | None:
    return summary.headline if theory == _LEADING else summary.theories.get(theory)


def _life(theory: str, attribute: str) -> Get:
    def get(summary: LifeSummary) -> Floats | None:
        found = _record(summary, theory)
        return None if found is None else getattr(found, attribute)

    return get


def _factor(theory: str) -> Get:
    def get(summary: LifeSummary) -> Floats | None:
        found = summary.theories.get(theory)
        return None if found is None else found.factors["a_iso"]

    return get


def _rating_over_load(summary: LifeSummary) -> Floats:
    with np.errstate(divide="ignore"):
        return np.asarray(summary.ratings.dynamic_of_set / summary.loads.dynamic)


def _contamination(summary: LifeSummary) -> Floats | None:
    return summary.contamination_factor


def _reliability_of_required(summary: LifeSummary) -> Floats | None:
    required = summary.conditions.required_life
    return None if required is None else summary.reliability_after(required)


def _inner_share(summary: LifeSummary) -> Floats:
    """Part of the inner races in Σ (t/L)^e over all races, t their life; NaN without an end."""
    reference = summary.reference
    with np.errstate(divide="ignore", invalid="ignore"):
        risk = (reference.life[:, np.newaxis] / reference.inner) ** reference.slope
        return np.asarray(risk.sum(axis=1))


def _weakest_row(summary: LifeSummary) -> Floats:
    limit = summary.limit
    return np.where(limit.race == "", np.nan, limit.row)


def _weakest_ball(summary: LifeSummary) -> Floats:
    ball = summary.limit.ball
    return np.where(ball < 0, np.nan, ball)
