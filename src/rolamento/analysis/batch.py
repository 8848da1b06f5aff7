"""Many solved cases, analysed block by block."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import fields, replace
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.analysis.joining import BatchAnalysis, joined
from rolamento.analysis.needs import coefficient, has_friction, has_life, has_oil
from rolamento.analysis.one import DEFAULT_HYSTERESIS
from rolamento.case import Case
from rolamento.errors import InputError
from rolamento.numerics.masked import filled
from rolamento.numerics.threads import thread_count

if TYPE_CHECKING:
    from rolamento.life import LifeSummary
    from rolamento.lubrication import FilmTable
    from rolamento.rows.ball import BatchState

_BLOCK: Final = 4096
"""Cases at a time, so that their arrays stay near the processor."""


def analyse_batch(
    case: Case,
    batch: BatchState,
    *,
    model: str = "jones_simplified",
    friction_coefficient: ArrayLike | None = None,
    lubricant_temperature: ArrayLike | None = None,
    hysteresis: float = DEFAULT_HYSTERESIS,
    compare: bool = False,
    threads: int | None = None,
) -> BatchAnalysis:
    """Find film, friction and life of solved cases; life without Ioannides and Harris.

    Parameters
    ----------
    case
        The one that was solved; supplies lubricant, temperature, surface and film model.
    batch
        From `solve_batch`.
    model
        Of the friction in the contacts; the default is a closed form.
    friction_coefficient, lubricant_temperature
        A number or an array (cases,) in the place of the case's; the latter in K.
    hysteresis
        As in `analyse`.
    compare
        Whether to evaluate all models of the contacts.
    threads
        As many as there are processors by default.

    Returns
    -------
    BatchAnalysis
        Without a film, or without friction, where the case does not have what they need.

    Raises
    ------
    InputError
        For a number out of range, an array of another length, or a bearing that asks for its
        life and has no rating.
    """
    cases = len(batch)
    mu = _over_cases(friction_coefficient, "friction_coefficient", cases)
    if mu is None and has_friction(case):
        mu = np.full(cases, coefficient(case))
    warm = _over_cases(lubricant_temperature, "lubricant_temperature", cases)
    if warm is not None and not np.all(warm > 0.0):
        raise InputError("must be above absolute zero, in K", field="lubricant_temperature")
    if warm is None and case.lubricant_temperature is not None:
        warm = np.full(cases, case.lubricant_temperature)
    if not has_oil(case):
        warm = None

    def part(first: int) -> BatchAnalysis:
        from rolamento.lubrication.running import part as some_of

        some = slice(first, first + _BLOCK)
        return _part(
            case,
            remembering(some_of(batch, some)),
            None if mu is None else mu[some],
            None if warm is None else warm[some],
            (model, hysteresis, compare),
        )

    blocks = range(0, max(cases, 1), _BLOCK)
    workers = min(thread_count(threads), len(blocks))
    if workers == 1:
        parts = [part(first) for first in blocks]
    else:
        with ThreadPoolExecutor(workers) as pool:
            parts = list(pool.map(part, blocks))
    return replace(joined(parts), life=_lives(case, batch, warm))


def _lives(case: Case, batch: BatchState, warm: NDArray[np.float64] | None) -> LifeSummary | None:
    if not has_life(case):
        return None
    from rolamento.life import conditions_of, life_of_batch

    varied = {} if warm is None else {"temperature.lubricant": warm}
    return life_of_batch(case, batch, conditions_of(case, varied))


def remembering(batch: BatchState) -> BatchState:
    """Return a batch that reckons its balls and ellipses once, for film and friction alike."""
    from rolamento.rows.ball.remembering import RememberingBatch

    return RememberingBatch(*(getattr(batch, field.name) for field in fields(batch)))


def _part(
    case: Case,
    batch: BatchState,
    mu: NDArray[np.float64] | None,
    warm: NDArray[np.float64] | None,
    choices: tuple[str, float, bool],
) -> BatchAnalysis:
    """Film and friction of some cases."""
    from rolamento.friction import friction
    from rolamento.lubrication.running import balls_of_batch
    from rolamento.lubrication.table import film_table, lubricant_of

    model, hysteresis, compare = choices
    film = None
    if warm is not None:
        film = film_table(case, lubricant_of(case), balls_of_batch(batch), warm)
    if mu is None:
        return BatchAnalysis(film, None)
    found = friction(
        batch,
        friction_coefficient=mu,
        model=model,
        hysteresis=hysteresis,
        dynamic_viscosity=None if film is None else film.oil.dynamic_viscosity,
        film_parameter=None if film is None else least_film_parameter(film),
        compare=compare,
    )
    return BatchAnalysis(film, found)


def least_film_parameter(film: FilmTable) -> NDArray[np.float64]:
    """Least film parameter λ of all contacts; (cases,), NaN where there is none."""
    parameters = np.concatenate([film.inner.film_parameter, film.outer.film_parameter], axis=1)
    return np.asarray(np.fmin.reduce(parameters, axis=1))


def _over_cases(given: ArrayLike | None, name: str, cases: int) -> NDArray[np.float64] | None:
    if given is None:
        return None
    array = filled(given)
    if array.shape not in ((), (cases,)):
        raise InputError(f"must be one number, or one for each of the {cases} cases", field=name)
    return np.broadcast_to(array, (cases,)).copy()
