"""A case, solved, and all that follows from it: film, friction, life, frequencies."""

from __future__ import annotations

import os
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Final, Unpack

import numpy as np

from rolamento.analysis.needs import has_friction, has_life, has_oil, machines_known
from rolamento.case import Case
from rolamento.io.json import dumps
from rolamento.numerics.blocks import in_blocks
from rolamento.records import frozen, span
from rolamento.solved import Solved
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.case.bearing import Bearing
    from rolamento.case.roller_bearing import RollerBearing
    from rolamento.case.varied import DutyFields
    from rolamento.friction import Friction
    from rolamento.friction.seals import SealsAndBath
    from rolamento.life import LifeConditions, LifeSummary
    from rolamento.lubrication import Film
    from rolamento.vibration.frequencies import FaultFrequencies

_FOLLOWING: Final = ("film", "friction", "life", "frequencies")
DEFAULT_HYSTERESIS: Final = 0.01
"""Part α_h of the elastic work that the material loses."""


@frozen(eq=False, slots=False)
class Analysis:
    """Solved cases and what follows from them.

    Attributes
    ----------
    solved
        of `rolamento.solve`
    film
        of the lubricant; None without oil or grease, its temperature, or a result
    friction
        torque, power and heat; None without a result, or without either a coefficient of friction
        or an oil or a grease at its temperature
    life
        by every theory that the case allows; None if the case has neither a designation nor a
        [life] table, or no result
    notes
        why a part is missing that the case seems to ask for
    left_out
        what a quick analysis left out that the full one has: "friction_models", "stress_volume",
        "preload_loss"; the notes say so too
    """

    solved: Solved
    film: Film | None = None
    friction: Friction | None = None
    life: LifeSummary | None = None
    notes: tuple[Note, ...] = ()
    left_out: tuple[str, ...] = ()

    def _shown(self) -> dict[str, str]:
        shown = {"": self.solved.title or "a case without a title"}
        lines = repr(self.solved).splitlines()[1:]
        named = dict(line.strip().split(": ", 1) for line in lines)
        kept = ("cases", "varied", "load", "maximum at the inner race", "maximum at the outer race")
        shown |= {name: named[name] for name in kept if name in named}
        if self.film is not None:
            shown["film parameter"] = span(self.film.minimum_film_parameter)
        if self.friction is not None:
            torque = span(1e3 * self.friction.torque, "N mm")
            shown["friction"] = f"{torque}, {span(self.friction.power, 'W')}"
        if self.life is not None:
            lead = self.life.headline._shown()
            shown["life"] = f"{lead['life']} ({lead['']})"
        return shown

    @cached_property
    def frequencies(self) -> FaultFrequencies | None:
        """Fault frequencies of a single case under load; None without a result, or at rest."""
        inner, outer = (self.solved.field(f"duty.{ring}_speed")[0] for ring in ("inner", "outer"))
        if not self.solved.converged[0] or inner == outer:
            return None
        from rolamento.vibration.frequencies import frequencies_of

        return frequencies_of(self.solved)

    @cached_property
    def seals_and_bath(self) -> SealsAndBath | None:
        """Torque of contact seals and of an oil bath, beside the friction of the contacts.

        None where the bearing has neither, or without a result.
        """
        if not self.solved.converged.any():
            return None
        from rolamento.friction.seals import seals_and_bath

        return seals_and_bath(self.solved, self.film)

    def part(self, name: str) -> Any:
        """Give one part of the mapping by its key, such as ``"life"``, without the others.

        Of those that need no tables of the elements.
        """
        if name not in _FOLLOWING:
            return self.solved.part(name)
        found = getattr(self, name)
        return None if found is None else found.to_mapping()

    def to_mapping(self) -> dict[str, Any]:
        """Give the mapping of a single case with "film", "friction", "life", "frequencies"."""
        mapping = self.solved.to_mapping()
        of_friction = () if self.friction is None else self.friction.qualifications(self.solved)
        own = (note.to_mapping() for note in (*self.notes, *of_friction))
        notes = [*mapping.pop("notes"), *own]
        case = mapping.pop("case")
        parts = {name: self.part(name) for name in _FOLLOWING}
        beside = self.seals_and_bath
        if beside is not None:
            parts["seals_and_bath"] = beside.to_mapping()
            notes += [note.to_mapping() for note in beside.notes]
        return {**mapping, **parts, "notes": notes, "case": case}

    def to_json(self, *, indent: int | None = 2) -> str:
        """Give a single case as one JSON object, in SI units."""
        return dumps(self.to_mapping(), indent)


def analyse(
    case: Case | Bearing | RollerBearing | Solved | str | os.PathLike[str],
    values: Any = None,
    *,
    lubricant: Any = None,
    temperature: str | float | None = None,
    model: str | None = None,
    hysteresis: float = DEFAULT_HYSTERESIS,
    compare: bool | None = None,
    quick: bool = False,
    threads: int | None = None,
    **fields: Unpack[DutyFields],
) -> Analysis:
    """Solve a case, and find what follows: film, friction, life; of solved cases likewise.

    The film needs `case.lubricant` (an oil or a grease) and `case.temperature`, and
    `case.surface` for its film parameter; friction needs either the friction coefficient of the
    lubricant or what the film needs. With a film, the oil's rolling resistance counts as friction,
    and the film parameter decides which friction models are valid; Palmgren's and SKF's need a
    designation too, or one of each bearing of a set.
    Life needs a designation or `case.life`; of many cases it is without Ioannides and
    Harris.

    Parameters
    ----------
    case
        What to solve, its file or a designation, or what `rolamento.solve` returned.
    values, fields, lubricant, temperature
        What varies, and the oil or the grease: as of `rolamento.solution.solved_of`, such as
        ``fz=5e3, inner_speed=155.0, lubricant="ISO VG 68", temperature="70 degC"``.
    model
        Of the friction in the contacts; by default "jones_full", and of many cases
        "jones_simplified", a closed form; of roller bearings "roller_sliding".
    hysteresis
        Part α_h of the elastic work that the material loses, 0 to 1.
    compare
        Whether to evaluate all models, those of whole bearings too of many cases; by default of a
        single case only, and those of the contacts not where it is to be quick.
    quick
        Whether to leave out of a single case what takes longest, for a page that follows a slider:
        the other models of the contacts, life by stress volume, and the load at which a set loses
        its preload. What is left is, number for number, what the full analysis says; of its notes
        those are missing that rest on what was left out.
    threads
        As many as there are processors by default.

    Returns
    -------
    Analysis
        Never raises for a duty without a solution: the status says so.

    Raises
    ------
    InputError
        If the mounting closes the bearing, the oil is dirtier than all classes of ISO 281, or a
        number is out of range; of many cases also if they ask for a life and have no rating.

    >>> analysis = analyse("6310/C3", fz=5e3, inner_speed="1480 rpm", lubricant="ISO VG 68",
    ...                    temperature="70 degC")
    >>> f"{analysis.life['iso281'].life[0]:.0f}"  # (62 kN / 5 kN)^3 million revolutions
    '1907'
    >>> analysis.film is not None and analysis.friction is not None
    True
    """
    from rolamento.solution import solved_of

    solved = solved_of(
        case,
        values,
        lubricant=lubricant,
        temperature=temperature,
        threads=threads,
        preload_loss=not quick,
        **fields,
    )
    if len(solved) == 1 and not solved.converged[0]:
        return Analysis(solved)
    single = len(solved) == 1
    compare = single and not quick if compare is None else compare
    life, why_not = life_of(solved, stress_volume=single and not quick)
    film, friction = film_and_friction(
        solved, life, model=model, hysteresis=hysteresis, compare=compare, threads=threads
    )
    if film is None and has_oil(solved.case):
        key = "no_temperature_no_friction" if friction is None else "no_temperature"
        why_not = (Note(key), *why_not)
    left_out = {
        "friction_models": quick and single and not compare and friction is not None,
        "stress_volume": quick and single and life is not None,
        "preload_loss": solved.preload is not None and solved.preload.loss_factor is None,
    }
    without = tuple(name for name, gone in left_out.items() if gone)
    notes = (*why_not, *(Note(f"without_{name}") for name in without))
    return Analysis(solved, film, friction, life, notes, without)


def film_and_friction(
    solved: Solved,
    life: LifeSummary | None = None,
    *,
    model: str | None = None,
    hysteresis: float = DEFAULT_HYSTERESIS,
    compare: bool = False,
    threads: int | None = None,
) -> tuple[Film | None, Friction | None]:
    """Return film and friction of solved cases; None where the case does not say enough for one.

    Parameters as of `analyse`; life: that of a single case, if it is known.
    """
    if solved.case.lubricant is None:
        return None, None
    from rolamento.friction import friction
    from rolamento.friction.summary import default_model
    from rolamento.lubrication.films import film, has_film

    single = len(solved) == 1

    def of_block(some: Solved) -> tuple[Film | None, Friction | None]:
        found = film(some, threads=1) if has_film(some) else None
        if not has_friction(some):
            return found, None
        whole = single or compare
        machine = machines_known(some, found, life if single else None) if whole else ()
        return found, friction(
            some,
            model=model or default_model(some, quick=not single),
            hysteresis=hysteresis,
            film_parameter=np.nan if found is None else found.minimum_film_parameter,
            machine=machine,
            compare=compare,
            threads=1,
        )

    return in_blocks(of_block, solved, threads)


def life_of(solved: Solved, *, stress_volume: bool) -> tuple[LifeSummary | None, tuple[Note, ...]]:
    """Return the life of the cases, if they ask for one that the standards rate; or why not.

    Parameters
    ----------
    solved
        Cases.
    stress_volume
        As of `rolamento.life.life`.
    """
    if not has_life(solved.case):
        return None, ()
    from rolamento.life import conditions_of, life
    from rolamento.life.row_ratings import UnratedError

    conditions = conditions_of(solved)
    why_not: tuple[Note, ...] = ()
    if conditions.nsk_cleanliness is not None and not _viscosity_known(conditions):
        conditions = replace(conditions, nsk_cleanliness=None)
        why_not = (Note("l_able_without_viscosity"),)
    try:
        return life(solved, conditions, stress_volume=stress_volume), why_not
    except UnratedError as error:
        if error.field == "bearing.contact_angle":
            return None, (Note("life_of_thrust_bearing"),)
        rollers = all(place.bearing.element != "ball" for place in solved.case.bearing.places)
        return None, (Note("life_without_rating", {"element": "roller"} if rollers else {}),)


def _viscosity_known(conditions: LifeConditions) -> bool:
    return conditions.viscosity is not None or conditions.viscosity_ratio is not None
