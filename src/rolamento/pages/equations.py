"""The equations that a result rests on: what each gives, its symbols, its source, where it holds.

They stand in `data/equations.toml`. A report shows those whose model was used, numbered in its own
order, each symbol where it first occurs; and the works that they come from.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Final, Literal

from rolamento.case.film_model import FilmModel
from rolamento.case.roller_bearing import RollerBearing
from rolamento.document import Equation, Symbol
from rolamento.io.data import toml_of
from rolamento.records import frozen
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.tasks.report import CaseReport

__all__ = ["CONDITIONS", "EQUATIONS", "REFERENCES", "Law", "equations_of", "references_of"]


@frozen(kw_only=True)
class Law:
    """An equation as the program computes it.

    Attributes
    ----------
    key
        stable, for programs
    name
        what it gives; English
    latex, plain
        in mathematics, which Matplotlib sets too, and in plain characters
    symbols
        keys of `SYMBOLS`
    source
        place in the works of `references`
    references
        keys of `REFERENCES`
    used
        what all holds for a case that rests on it: each a key of `CONDITIONS`, and what it asks for
    valid
        where it holds; English
    rolls
        of which elements: "ball", "roller"; empty for both
    """

    key: str
    name: str
    latex: str
    plain: str
    symbols: tuple[str, ...] = ()
    source: str = ""
    references: tuple[str, ...] = ()
    used: tuple[str, ...] = ()
    valid: str = ""
    rolls: Literal["", "ball", "roller"] = ""

    def of(self, case: CaseReport) -> bool:
        """Whether a case rests on it."""
        asked = (condition.split() for condition in self.used)
        return (not self.rolls or self.rolls in _rolls(case)) and all(
            CONDITIONS[name](case, *names) for name, *names in asked
        )


# --- when an equation is used ---------------------------------------------------------------------


def _rolls(case: CaseReport) -> set[str]:
    elements = {place.bearing.element for place in case.case.bearing.places}
    return {"ball" if element == "ball" else "roller" for element in elements}


def _element(case: CaseReport, name: str) -> bool:
    return any(place.bearing.element == name for place in case.case.bearing.places)


def _iso_profile(case: CaseReport) -> bool:
    bearings = [place.bearing for place in case.case.bearing.places]
    return any(
        isinstance(one, RollerBearing) and one.roller_profile.kind == "iso" for one in bearings
    )


def _model(case: CaseReport, field: str, value: str) -> bool:
    return bool(getattr(case.case.model, field) == value)


def _turns(case: CaseReport) -> bool:
    return case.case.duty.turns


def _friction_control(case: CaseReport) -> bool:
    return case.analysis.solved.rolling is not None


def _no_friction_control(case: CaseReport) -> bool:
    return not _friction_control(case)


def _raceway_control(case: CaseReport) -> bool:
    return _turns(case) and not _friction_control(case)


def _cage(case: CaseReport) -> bool:
    return _raceway_control(case) and case.case.model.cage != "none"


def _centrifugal_force(case: CaseReport) -> bool:
    return _turns(case) and case.case.model.centrifugal_force


def _gyroscopic_moment(case: CaseReport) -> bool:
    return _turns(case) and case.case.model.gyroscopic_moment


def _step(case: CaseReport, *names: str) -> bool:
    found = case.clearance
    return found is not None and any(step.name in names for step in found.steps)


def _film(case: CaseReport) -> bool:
    found = case.analysis.film
    return found is not None and found.thinnest("inner") is not None


def _film_model(case: CaseReport, field: str, name: str) -> bool:
    own = case.case.film or FilmModel()
    return _film(case) and (getattr(own, field) or "pan_hamrock") == name


def _pressure_viscosity(case: CaseReport, name: str) -> bool:
    lubricant = case.case.lubricant
    if not _film(case) or lubricant is None:
        return False
    oil = lubricant.oil
    return oil.pressure_viscosity is None and (oil.pressure_viscosity_method or "wooster") == name


def _surface(case: CaseReport) -> bool:
    return case.case.surface is not None


def _theory(case: CaseReport, *names: str) -> bool:
    life = case.analysis.life
    return life is not None and any(name in life.theories for name in names)


def _rated(case: CaseReport) -> bool:
    return case.analysis.life is not None


def _rating(case: CaseReport, name: str, source: str) -> bool:
    life = case.analysis.life
    return life is not None and life.rating_sources[name] == source


def _radial(case: CaseReport) -> bool:
    return not _axial(case)


def _axial(case: CaseReport) -> bool:
    life = case.analysis.life
    return life is not None and life.ratings.is_axial


def _edition(case: CaseReport, year: str) -> bool:
    life = case.analysis.life
    return life is not None and life.conditions.edition == year


def _viscosity_ratio(case: CaseReport) -> bool:
    life = case.analysis.life
    return (life is not None and life.conditions.viscosity is not None) or _film(case)


def _contamination_classes(case: CaseReport) -> bool:
    life = case.analysis.life
    return (
        life is not None
        and hasattr(life.conditions.contamination, "c1")
        and life.viscosity_ratio is not None
    )


def _loss(case: CaseReport, name: str) -> bool:
    friction = case.analysis.friction
    return friction is not None and name in friction.torque_by_source


def _regime(case: CaseReport) -> bool:
    friction = case.analysis.friction
    return friction is not None and friction.by_regime


def _torque_model(case: CaseReport, *names: str) -> bool:
    friction = case.analysis.friction
    return friction is not None and any(own.model in names for own in friction.judged)


def _frequencies(case: CaseReport) -> bool:
    return case.analysis.frequencies is not None


CONDITIONS: Final[Mapping[str, Callable[..., bool]]] = {
    one.__name__[1:]: one
    for one in (
        _element,
        _iso_profile,
        _model,
        _turns,
        _friction_control,
        _no_friction_control,
        _raceway_control,
        _cage,
        _centrifugal_force,
        _gyroscopic_moment,
        _step,
        _film,
        _film_model,
        _pressure_viscosity,
        _surface,
        _theory,
        _rated,
        _rating,
        _radial,
        _axial,
        _edition,
        _viscosity_ratio,
        _contamination_classes,
        _loss,
        _regime,
        _torque_model,
        _frequencies,
    )
}
"""What may hold for a case, by name; some ask for names (one will do), or field and value."""


# --- the register ---------------------------------------------------------------------------------

_DATA: Final = toml_of("equations")


def _law(row: Mapping[str, Any]) -> Law:
    lists = {name: tuple(one) for name, one in row.items() if isinstance(one, list)}
    return Law(**{**row, **lists})


EQUATIONS: Final = tuple(_law(row) for row in _DATA["equation"])
"""In the order in which an engineer calculates."""

SYMBOLS: Final[Mapping[str, Sequence[str]]] = _DATA["symbols"]
"""Each as it is written, what it means, its unit."""

ROLLER_SYMBOLS: Final[Mapping[str, Sequence[str]]] = _DATA["roller_symbols"]
"""What means something else where nothing but rollers rolls."""

REFERENCES: Final[Mapping[str, str]] = _DATA["references"]


def equations_of(cases: Iterable[CaseReport]) -> tuple[Equation, ...]:
    """Return the equations that cases with a result rest on, numbered; a symbol stands once."""
    solved = [case for case in cases if case.converged]
    found: list[Equation] = []
    known: set[str] = set()
    rollers = not any("ball" in _rolls(case) for case in solved)
    for law in EQUATIONS:
        if not any(law.of(case) for case in solved):
            continue
        new = [key for key in law.symbols if key not in known]
        known.update(new)
        found.append(
            Equation(
                name=said(law.name),
                latex=law.latex,
                plain=law.plain,
                symbols=tuple(_symbol(key, rollers=rollers) for key in new),
                source=said(law.source),
                valid=said(law.valid) if law.valid else "",
                number=len(found) + 1,
            )
        )
    return tuple(found)


def references_of(cases: Iterable[CaseReport]) -> tuple[str, ...]:
    """Return the works that the equations of cases come from, in the order of the alphabet."""
    solved = [case for case in cases if case.converged]
    keys = {
        key for law in EQUATIONS if any(law.of(case) for case in solved) for key in law.references
    }
    return tuple(REFERENCES[key] for key in sorted(keys))


def _symbol(key: str, *, rollers: bool) -> Symbol:
    """What a symbol means; rollers: where nothing else rolls."""
    symbol, meaning, unit = {**SYMBOLS, **ROLLER_SYMBOLS}[key] if rollers else SYMBOLS[key]
    return Symbol(symbol, said(meaning), unit)
