"""Life under a duty of several steps: read from a table, every step solved, damage gathered.

Miner: a step uses up its share of the revolutions over the life that it alone would allow. For the
lives that know the races apart, each race gathers its damage before the races combine, for the
steps may load different races and rows.
"""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import inf, isfinite
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case, case_of
from rolamento.case.life_model import LifeModel
from rolamento.errors import FileError, InputError
from rolamento.io.columns import folded_name, title_parts
from rolamento.io.json import dumps
from rolamento.io.tables import Table, read_table
from rolamento.life import Life
from rolamento.life.duty import DutyLife, lives_of_duty
from rolamento.life.l_able import FactorTable
from rolamento.life.record import slope_of
from rolamento.life.reliability import reliability_factor, reliability_of
from rolamento.life.spectrum import revolution_shares
from rolamento.life.theories import THEORIES
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.solution import solve
from rolamento.studies.fields import Field, Value, read_field, refuse_rivals
from rolamento.studies.solving import CONVERGED, INVALID_INPUT, array_fields, base_case
from rolamento.tasks.life import (
    SCHEMA,
    CaseSource,
    SystemLife,
    TableSource,
    checked_shaft,
    factor_table,
)
from rolamento.tasks.life_over import LifeRows, lives_of_rows
from rolamento.units import HOUR
from rolamento.words import said

__all__ = [
    "DutyLife",
    "DutySteps",
    "ShaftSpectrum",
    "SpectrumLife",
    "life_of_duty_spectrum",
    "lives_under",
    "read_spectrum",
]

MOST_WITH_STRESS_VOLUME: Final = 1000
"""Steps up to which the theory of Ioannides and Harris, which takes milliseconds, is evaluated."""
_MOST_SINGLE: Final = 2000
"""Cases of their own that the steps may need."""
MOST_STEPS: Final = 10_000

Kind = Literal["share", "revolutions"]
"""Shares of time, or of revolutions."""

_EXAMPLE: Final = "share,duty.load.fz,duty.inner_speed"
_ROUNDING: Final = 0.01 + 1e-9
"""By which the shares may miss 1: 33 % three times."""
_FIXED: Final = ("life.reliability", "life.edition", "life.required_life", "bearing.arrangement")
"""Fields of the bearing and its life as a whole, not of a step."""


@frozen(eq=False)
class DutySteps:
    """The steps of a duty.

    Attributes
    ----------
    source
        the file
    kind
        what the shares are of: "share" (time) or "revolutions"
    shares
        (steps,), summing to 1
    given_sum
        what they summed to as given
    fields, values
        what varies, and its checked value in every step, by name
    cells
        the same as written in the file
    lines
        of the steps in the file
    """

    source: str
    kind: Kind
    shares: FloatArray
    given_sum: float
    fields: tuple[Field, ...]
    values: Mapping[str, tuple[Value, ...]]
    cells: Mapping[str, tuple[str, ...]]
    lines: tuple[int, ...]

    def __len__(self) -> int:
        """Count the steps."""
        return len(self.shares)


@frozen(eq=False)
class SpectrumLife:
    """Life under all steps together, and what each of them takes of it.

    Attributes
    ----------
    case
        what does not vary
    steps
        what does
    status
        (steps,), of each solved step
    time_shares, revolution_shares
        (steps,); each sums to 1
    mean_speed
        of the rings against each other, over the time; rad/s
    theories
        lives by name
    headline
        the life that leads
    reliability
        S that the lives are for
    required_life
        the required life in s; None if none is required
    stress_volume
        whether the theory of Ioannides and Harris was evaluated
    """

    case: Case
    steps: DutySteps
    status: NDArray[np.str_]
    time_shares: FloatArray
    revolution_shares: FloatArray
    mean_speed: float
    theories: Mapping[str, DutyLife]
    headline: DutyLife
    reliability: float
    required_life: float | None
    stress_volume: bool

    def __getitem__(self, theory: str) -> DutyLife:
        """Return the life by one theory."""
        return self.theories[theory]

    @property
    def taking_part(self) -> BoolArray:
        """(steps,): whether a step turns at all."""
        return np.asarray(self.revolution_shares > 0.0)

    @property
    def converged(self) -> bool:
        """Whether every step that takes part has a result."""
        return bool(np.all(self.status[self.taking_part] == CONVERGED))

    def reliability_of_required(self, theory: str | None = None) -> float | None:
        """Reliability with which the required life is reached; None if there is none.

        By a theory, or by the life that leads; where that is a bound, so is the reliability.
        """
        own = None if theory is None else THEORIES[theory].edition
        edition = own or (self.case.life or LifeModel()).edition
        reached = self.headline if theory is None else self.theories[theory]
        hours_for_ninety = reached.hours / float(reliability_factor(self.reliability, edition))
        if self.required_life is None or not hours_for_ninety > 0.0:
            return None
        return float(reliability_of(self.required_life / HOUR / hours_for_ninety, edition))

    def to_json(self) -> str:
        """Return all of it as one JSON object: SI units, hours, millions of revolutions."""
        return dumps(self.to_mapping(), indent=2)

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values and arrays: SI units, hours, millions of revolutions."""
        leading = self.headline
        return {
            "schema": SCHEMA,
            "kind": "life_spectrum",
            "title": self.case.title,
            "reliability": self.reliability,
            "mean_speed": self.mean_speed,
            "headline": {
                "theory": leading.theory or None,
                **leading.to_mapping(),
                "step_hours": leading.steps.hours,
                "damage": leading.damage,
            },
            "theories": {name: _of_theory(own) for name, own in self.theories.items()},
            "required_life": None
            if self.required_life is None
            else {
                "life": self.required_life,
                "reliability": self.reliability_of_required(),
                "upper_bound": leading.below,
            },
            "steps": {
                "status": self.status,
                "time_share": self.time_shares,
                "revolution_share": self.revolution_shares,
                "values": self.steps.values,
            },
            "case": self.case.to_mapping(),
        }


@frozen(eq=False)
class ShaftSpectrum:
    """Lives of several bearings under the steps of one duty, and of all together.

    Attributes
    ----------
    bearings
        each under all steps
    together
        of the lives that lead
    """

    bearings: tuple[SpectrumLife, ...]
    together: SystemLife

    @property
    def converged(self) -> bool:
        """Whether every step of every bearing that takes part has a result."""
        return all(own.converged for own in self.bearings)

    def to_json(self, names: Sequence[str]) -> str:
        """Return all of it as one JSON object; names: of the bearings."""
        return dumps(
            {
                "schema": SCHEMA,
                "kind": "shaft_life_spectrum",
                "together": self.together.to_mapping(),
                "bearings": [
                    {"name": name, **own.to_mapping()}
                    for name, own in zip(names, self.bearings, strict=True)
                ],
            },
            indent=2,
        )


def _of_theory(own: DutyLife) -> dict[str, Any]:
    assert isinstance(own.steps, Life)
    return {
        **own.to_mapping(),
        "notes": {key: where for key, where in own.steps.notes.items() if np.any(where)},
        "step_life": own.steps.life,
        "step_hours": own.steps.hours,
        "damage": own.damage,
    }


def life_of_duty_spectrum(
    case: CaseSource,
    steps: DutySteps | str | os.PathLike[str],
    *,
    nsk_table: TableSource = None,
    decimal_mark: str | None = None,
) -> SpectrumLife:
    """Solve every step of a duty, and find the life under all of them.

    Parameters
    ----------
    case
        Supplies what does not vary; or its file.
    steps
        From `read_spectrum`, or their file.
    nsk_table
        a_NSK of L_able, or its file.
    decimal_mark
        ``"point"`` or ``"comma"``, where nothing in these files says which.

    Raises
    ------
    InputError
        If a step is no valid case, or has no life for its geometry, with its line; or if nothing
        turns.
    """
    base = case_of(case)
    table = factor_table(nsk_table, [base], decimal_mark)
    duty = (
        steps if isinstance(steps, DutySteps) else read_spectrum(steps, decimal_mark=decimal_mark)
    )
    rows = _solved_steps(base, duty, table)
    speed = _speeds(base, duty)
    time, turns = _both_shares(duty, speed)
    mean_speed = float(time @ speed)
    headline, theories = lives_of_duty(
        rows.theories, rows.headline, rows.races, rows.slopes, turns, mean_speed
    )
    wishes = base.life or LifeModel()
    return SpectrumLife(
        case=base,
        steps=duty,
        status=rows.status,
        time_shares=time,
        revolution_shares=turns,
        mean_speed=mean_speed,
        theories=theories,
        headline=headline,
        reliability=wishes.reliability,
        required_life=wishes.required_life,
        stress_volume=len(duty) <= MOST_WITH_STRESS_VOLUME,
    )


def lives_under(
    cases: Sequence[CaseSource],
    steps: str | os.PathLike[str],
    *,
    nsk_table: TableSource = None,
    decimal_mark: str | None = None,
) -> ShaftSpectrum:
    """Find the lives of several bearings of a shaft under the steps of one duty.

    Parameters
    ----------
    cases
        Or their files, one a bearing. What the steps vary holds for all of them: of shares of
        revolutions and of forces that is so if all bearings take the same.
    steps, nsk_table, decimal_mark
        As of `life_of_duty_spectrum`.

    Raises
    ------
    InputError
        As `life_of_duty_spectrum`; or if their reliabilities differ.
    """
    read = checked_shaft(cases)
    found = tuple(
        life_of_duty_spectrum(case, steps, nsk_table=nsk_table, decimal_mark=decimal_mark)
        for case in read
    )
    leading = [own.headline for own in found]
    together = SystemLife.combined(
        [own.theory for own in leading],
        np.array([own.hours for own in leading]),
        np.array([slope_of(own.steps.element) for own in leading]),
        valid=all(own.valid for own in leading),
        below=any(own.below for own in leading),
    )
    return ShaftSpectrum(found, together)


def _solved_steps(case: Case, steps: DutySteps, nsk_table: FactorTable | None) -> LifeRows:
    """Solve all steps; the first that is no valid case is an error with its line."""
    single = [values for name, values in steps.values.items() if name not in array_fields()]
    if single and len(set(zip(*single, strict=True))) > _MOST_SINGLE:
        raise InputError(
            said(
                "needs more than {most} cases of their own; let fewer steps differ in {known}",
                most=_MOST_SINGLE,
                known=", ".join(n for n in steps.values if n not in array_fields()),
            ),
            source=steps.source,
        )
    columns: dict[str, Sequence[Value]] = dict(steps.values)
    if not columns:
        columns = {"duty.inner_speed": [case.duty.inner_speed] * len(steps)}
    detailed = len(steps) <= MOST_WITH_STRESS_VOLUME
    try:
        rows = lives_of_rows(case, columns, stress_volume=detailed, nsk_table=nsk_table)
    except InputError as error:
        raise error.with_details(source=steps.source, line=steps.lines[0]) from None
    for index, refusal in rows.refused:
        raise refusal.with_details(source=steps.source, line=steps.lines[index[0]])
    for row in np.flatnonzero(rows.status == INVALID_INPUT).tolist():
        _refuse(case, steps, row)
    return rows


def _refuse(case: Case, steps: DutySteps, row: int) -> None:
    """Return why a step is no valid case, by what it says when it is solved alone."""
    try:
        solve(base_case(case, {name: values[row] for name, values in steps.values.items()}))
    except InputError as found:
        raise found.with_details(source=steps.source, line=steps.lines[row]) from None


def _speeds(case: Case, steps: DutySteps) -> FloatArray:
    """Speed of the rings against each other in every step, unsigned, rad/s."""

    def column(name: str) -> FloatArray:
        given = steps.values.get(f"duty.{name}")
        alike = [getattr(case.duty, name)] * len(steps)
        return np.array(alike if given is None else given, dtype=np.float64)

    return np.asarray(np.abs(column("inner_speed") - column("outer_speed")))


def _both_shares(steps: DutySteps, speed: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Shares of time and of revolutions."""
    if not np.any(speed[steps.shares > 0.0] > 0.0):
        raise InputError(
            said("is zero in every step: there is no life without rotation"),
            field="duty.inner_speed",
            source=steps.source,
            example='duty.inner_speed = "2000 rpm"',
        )
    if steps.kind == "share":
        return steps.shares, revolution_shares(steps.shares, speed)
    standing = np.flatnonzero((speed == 0.0) & (steps.shares > 0.0))
    if standing.size:
        raise InputError(
            said("has revolutions, but nothing rotates; give shares of time instead"),
            field="revolutions",
            source=steps.source,
            line=steps.lines[int(standing[0])],
        )
    time = np.divide(steps.shares, speed, out=np.zeros(len(steps)), where=steps.shares > 0.0)
    return time / time.sum(), steps.shares


# --- the table of steps -------------------------------------------------------------------------


def read_spectrum(path: str | os.PathLike[str], *, decimal_mark: str | None = None) -> DutySteps:
    """Read the steps of a duty.

    Parameters
    ----------
    path
        A table: a column ``share`` (of the time) or ``revolutions`` (shares of them), as numbers
        or per cent, or of the hours of each step; and columns by the dotted names of a case's
        fields, or as people call them: Speed (rpm), Fx (kN), Fr, Fa. Units stand in the heading or
        in the cells, as in a case file.
    decimal_mark
        ``"point"`` or ``"comma"``, where nothing in the table shows whether 12.500 is 12.5.

    Raises
    ------
    InputError
        If it is not such a file, a cell is refused, or the shares do not sum to 1; with line,
        column and an example.
    """
    table = read_table(path, most_rows=MOST_STEPS, example=_EXAMPLE, is_header=_heads_spectrum)
    table = _with_names(table.plain(decimal_mark))
    _check_header(table)
    kind = _kind(table)
    column = table.header.index(kind)
    shares = np.array([_share(table, row, column) for row in range(len(table.rows))])
    total = float(shares.sum())
    if _DURATION in table.said and total > 0.0:
        shares, total = shares / total, 1.0
    if not abs(total - 1.0) <= _ROUNDING:
        raise InputError(
            said("must sum to 1"),
            field=kind,
            value=f"{total:.4g}",
            source=table.source,
            example="0.25",
        )
    fields = _fields(table)
    cells = {
        field.name: tuple(row[table.header.index(field.name)] for row in table.rows)
        for field in fields
    }
    return DutySteps(
        source=table.source,
        kind=kind,
        shares=shares / total,
        given_sum=total,
        fields=fields,
        values={field.name: _checked(table, field, cells[field.name]) for field in fields},
        cells=cells,
        lines=table.lines,
    )


_SHARES: Final = frozenset(
    (
        *("share", "time_share", "share_of_time", "fraction", "time_fraction", "portion", "part"),
        *("percentage", "percent", "duty_share", "proportion", "parcela", "fracao", "proporcao"),
        *("fracao_do_tempo", "parcela_do_tempo", "porcentagem", "percentual", "anteil"),
        *("zeitanteil", "cuota", "porcentaje", "proporcion", "fraccion"),
    )
)
_TURNS: Final = frozenset(("revolutions", "revolucoes", "rotacoes_fracao", "umdrehungen"))
_HOURS: Final = frozenset(
    ("time", "duration", "hours", "tempo", "duracao", "horas", "dauer", "zeit", "tiempo")
)
_FIELD_OF: Final = {
    word: field
    for field, words in {
        "duty.inner_speed": "speed inner_speed shaft_speed rotational_speed n rpm rotacao"
        " velocidade velocidade_de_rotacao rotacao_do_eixo drehzahl wellendrehzahl velocidad"
        " velocidad_de_giro",
        "duty.outer_speed": "outer_speed",
        "duty.load.fx": "fx f_x fa f_a axial_load axial_force axial carga_axial forca_axial"
        " axiallast axialkraft fuerza_axial",
        "duty.load.fy": "fy f_y",
        "duty.load.fz": "fz f_z fr f_r radial_load radial_force radial carga_radial forca_radial"
        " radiallast radialkraft fuerza_radial",
        "duty.load.my": "my m_y moment momento kippmoment",
        "duty.load.mz": "mz m_z",
        "temperature.lubricant": "temperature oil_temperature temperatura temperatura_do_oleo"
        " temperatur oltemperatur oeltemperatur temperatura_del_aceite",
    }.items()
    for word in words.split()
}
"""Headings of spectra as people write them, and the fields that they give."""
_DURATION: Final = "duration of steps"
_DOTTED: Final = re.compile(r"[a-z_]+(?:\.[a-z_]+)+")


def _heads_spectrum(cells: Sequence[str]) -> bool:
    """Whether cells are headings of a spectrum: of shares, or of fields of a case."""
    words = {folded_name(title_parts(cell)[0]) for cell in cells}
    return bool(words & (_SHARES | _TURNS | _HOURS)) or any(map(_DOTTED.fullmatch, cells))


def _with_names(table: Table) -> Table:
    """Return the table under the names of fields, with the units of its headings in its cells."""
    names: list[str] = []
    units: list[str] = []
    said_of_table = dict(table.said)
    for title in table.header:
        name, unit = title_parts(title)
        word = folded_name(name)
        field = _FIELD_OF.get(word, name)
        if word == "rpm":
            unit = unit or "rpm"
        if word in _SHARES:
            field = "share"
        elif word in _TURNS:
            field = "revolutions"
        elif word in _HOURS:
            field, said_of_table[_DURATION] = "share", unit or "h"
            unit = ""
        names.append(field)
        units.append(unit)
    rows = tuple(
        tuple(
            f"{cell} {unit}".strip() if unit and _number(cell) is not None else cell
            for cell, unit in zip(row, units, strict=True)
        )
        for row in table.rows
    )
    rows = tuple(tuple(cell.replace(" %", "%") for cell in row) for row in rows)
    return replace(table, header=tuple(names), rows=rows, said=said_of_table)


def _check_header(table: Table) -> None:
    for name in table.header:
        if name and table.header.count(name) > 1:
            raise FileError(
                said("repeats a column name"),
                field=name,
                source=table.source,
                line=table.header_line,
            )


def _kind(table: Table) -> Kind:
    kinds: tuple[Kind, Kind] = ("share", "revolutions")
    given = [kind for kind in kinds if kind in table.header]
    if len(given) != 1:
        raise FileError(
            (
                said("needs a column named share (of time) or revolutions (shares of them)")
                if not given
                else said("has both a column share and a column revolutions; give one")
            ),
            source=table.source,
            line=table.header_line,
            example=_EXAMPLE,
        )
    return given[0]


def _share(table: Table, row: int, column: int) -> float:
    text = table.rows[row][column]
    try:
        value = float(text.removesuffix("%")) / (100.0 if text.endswith("%") else 1.0)
    except ValueError:
        value = float("nan")
    most = inf if _DURATION in table.said else 1.0 + _ROUNDING
    if not (isfinite(value) and 0.0 <= value <= most):
        raise table.placed(
            InputError(
                said("must be from 0 to 1, or from 0 % to 100 %"),
                field=table.header[column],
                value=text,
                example="0.25",
            ),
            row,
        )
    return value


def _fields(table: Table) -> tuple[Field, ...]:
    """The fields that the columns name."""
    try:
        names = [name for name in table.header if name not in ("share", "revolutions")]
        fields = tuple(read_field(name, at="column") for name in names)
        for name in names:
            if name in _FIXED:
                raise InputError(
                    said("applies to the whole duty, not to a step; set it in the case"),
                    field="column",
                    value=name,
                )
        refuse_rivals(tuple(names), at="column")
    except InputError as error:
        raise error.with_details(
            source=table.source, line=table.header_line, example=_EXAMPLE
        ) from None
    return fields


def _checked(table: Table, field: Field, cells: Sequence[str]) -> tuple[Value, ...]:
    known: dict[str, Value] = {}
    for row, text in enumerate(cells):
        if text not in known:
            try:
                known[text] = _value(field, text)
            except InputError as error:
                raise table.placed(error, row) from None
    return tuple(known[text] for text in cells)


def _value(field: Field, text: str) -> Value:
    """Read a cell: as text, as a file has quantities and names, else as a number or a truth."""
    if not text:
        raise InputError(said("is empty"), field=field.name, example=field.example)
    plain = {"true": True, "false": False}.get(text, _number(text))
    if plain is None or field.dimension is not None:
        return field.checked(text, in_file=True)
    try:
        return field.checked(plain, in_file=True)
    except InputError as error:
        try:
            return field.checked(text, in_file=True)
        except InputError:
            raise error from None


def _number(text: str) -> int | float | None:
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            continue
    return None
