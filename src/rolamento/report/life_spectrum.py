"""Life under a duty of several steps for a reader: the life, and what each step takes of it."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from dataclasses import dataclass
from io import StringIO
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray
from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.life import Life
from rolamento.life.iso16281 import THEORY as REFERENCE
from rolamento.report.language import ENGLISH, Words
from rolamento.report.life_statement import (
    given_percent,
    lives_column,
    percent,
    reached,
    remarks,
    required_sentence,
    said_of,
    verdict,
)
from rolamento.report.page import Lines, Page, rendered
from rolamento.report.plain_data import csv_number, json_text

if TYPE_CHECKING:
    from rolamento.tasks.life_spectrum import DutyLife, SpectrumLife

__all__ = ["spectrum_csv", "spectrum_json", "spectrum_report"]

SCHEMA: Final = 1
_MOST_SHOWN: Final = 40
_BAR: Final = 20
_CONVERGED: Final = "converged"


@dataclass(frozen=True, slots=True)
class _Words:
    heading: str
    what: str
    most: str
    no_life: str
    bounded: str
    scaled: str
    theories: str
    steps: str
    step: str
    time: str
    turns: str
    damage: str
    legend: str
    left_out: str
    in_steps: str
    in_all: str
    failed: str
    no_stress_volume: str


_WORDS: Final[Mapping[str, _Words]] = {
    "en": _Words(
        heading="Life under {count} steps of duty",
        what="this duty",
        most="Step {step} takes most of it: {damage} of the damage in {time} of the time.",
        no_life="Without a result of every step there is no life.",
        bounded="It is a bound: the standard only bounds the life in some of the steps.",
        scaled="The shares sum to {total} and were scaled to 1.",
        theories="Life by theory, damage summed by Miner",
        steps="The steps",
        step="step",
        time="time",
        turns="revs",
        damage="damage",
        legend=(
            "time, revs: shares of time and of revolutions; h: life if the step were all of the"
            " duty, and damage: its share in what ends the life, by the {theory}"
        ),
        left_out="the {shown} steps that take most; {count} more take {damage} together",
        in_steps="in {some} of {count} steps",
        in_all="in all steps",
        failed="step {step} (line {line}): {reason}",
        no_stress_volume=(
            "Ioannides and Harris is left out: it is evaluated for at most 1000 steps."
        ),
    ),
    "pt": _Words(
        heading="Vida sob {count} passos de serviço",
        what="este serviço",
        most="O passo {step} tira a maior parte: {damage} do dano em {time} do tempo.",
        no_life="Sem resultado de todos os passos não há vida.",
        bounded="É um limite superior: em alguns dos passos a norma apenas limita a vida.",
        scaled="As partes somam {total} e foram ajustadas a 1.",
        theories="Vida por teoria, dano somado por Miner",
        steps="Os passos",
        step="passo",
        time="tempo",
        turns="rot.",
        damage="dano",
        legend=(
            "tempo, rot.: partes do tempo e das rotações; h: vida se o passo fosse todo o serviço,"
            " e dano: a sua parte no que acaba com a vida, pela {theory}"
        ),
        left_out="os {shown} passos que mais tiram; outros {count} tiram {damage} juntos",
        in_steps="em {some} de {count} passos",
        in_all="em todos os passos",
        failed="passo {step} (linha {line}): {reason}",
        no_stress_volume=(
            "Ioannides e Harris fica de fora: é avaliada para no máximo 1000 passos."
        ),
    ),
}


def spectrum_report(
    found: SpectrumLife, words: Words = ENGLISH, medium: Medium | None = None
) -> str:
    """Return the life under a spectrum as text that ends in a newline.

    Parameters
    ----------
    found
        Of `rolamento.tasks.life_spectrum.life_under`.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    page = Page(words, medium or Medium())
    own = _WORDS.get(words.code, _WORDS["en"])
    head = page.hanging(Text(), found.case.title or words.untitled, "bold")
    parts: list[Lines] = [[*head, page.rule(page.medium.width)], _statement(page, own, found)]
    if found.converged:
        parts.append(_theories(page, own, found))
    parts.append(_steps(page, own, found))
    return rendered(page.medium, parts)


def _statement(page: Page, own: _Words, found: SpectrumLife) -> Lines:
    said, leading = said_of(page), found.headline
    lines = [page.heading(own.heading.format(count=len(found.steps)))]
    sentences: list[tuple[str, str]] = []
    if not found.converged:
        sentences.append((own.no_life, "bold red"))
    elif not (leading.valid or leading.below):
        sentences += [(said.none_holds, "bold red"), (said.not_to_be_used, "bold")]
    else:
        text = reached(
            page,
            leading.theory,
            leading.life,
            leading.hours,
            found.reliability,
            own.what,
            below=leading.below,
        )
        sentences.append((text, "bold"))
        if leading.below:
            sentences.append((own.bounded, "yellow"))
        sentences += _worst(page, own, found)
        reliability = found.reliability_of_required()
        if found.required_life is not None and reliability is not None:
            text = required_sentence(page, found.required_life, reliability, below=leading.below)
            sentences.append((text, ""))
    if abs(found.steps.given_sum - 1.0) > 1e-9:
        total = page.digits.short(found.steps.given_sum, 5)
        sentences.append((own.scaled.format(total=total), "yellow"))
    for text, style in sentences:
        lines += page.hanging(Text("  "), text, style)
    return lines


def _worst(page: Page, own: _Words, found: SpectrumLife) -> list[tuple[str, str]]:
    damage = found.headline.damage
    if len(damage) < 2 or not np.all(np.isfinite(damage)):
        return []
    worst = int(np.argmax(damage))
    text = own.most.format(
        step=worst + 1,
        damage=percent(page, float(damage[worst])),
        time=percent(page, float(found.time_shares[worst])),
    )
    return [(text, "")]


def _theories(page: Page, own: _Words, found: SpectrumLife) -> Lines:
    said = said_of(page)
    names = list(found.theories)
    revolutions = lives_column(page, [own.life for own in found.theories.values()])
    hours = lives_column(page, [own.hours for own in found.theories.values()])
    rows = [
        [page.text(head, "dim") for head in ("", said.million, said.hour, said.holds_here)],
        *(
            [
                page.text(said.names[name]),
                page.text(revolutions[index]),
                page.text(hours[index]),
                verdict(page, found[name].valid, found[name].below),
            ]
            for index, name in enumerate(names)
        ),
    ]
    lines = [page.heading(own.theories), *page.columns(rows, "lrrl")]
    legend = said.legend.partition(";")[0].format(
        reliability=given_percent(page, found.reliability)
    )
    lines += page.hanging(Text("  "), legend, "dim")
    if not found.stress_volume:
        lines += page.hanging(Text("  "), own.no_stress_volume, "dim")
    return lines + _remarks(page, own, found)


def _remarks(page: Page, own: _Words, found: SpectrumLife) -> Lines:
    part = found.taking_part
    count = int(part.sum())
    notes = []
    for theory, life in found.theories.items():
        assert isinstance(life.steps, Life)
        for name, where in life.steps.notes.items():
            some = int((where & part).sum())
            if some:
                place = own.in_all if some == count else own.in_steps
                notes.append((theory, name, place.format(some=some, count=count)))
    return remarks(page, notes, len(found.theories))


def _steps(page: Page, own: _Words, found: SpectrumLife) -> Lines:
    """Set the steps in a table; of many, those that take most."""
    leading = found.headline
    shown = _shown(found)
    columns = [
        _step_column(page, own.step, "", [str(step + 1) for step in shown]),
        _step_column(page, own.time, "%", _shares(page, found.time_shares, shown)),
        _step_column(page, own.turns, "%", _shares(page, found.revolution_shares, shown)),
    ]
    lives = lives_column(page, leading.steps.hours[shown].tolist())
    ends = [
        _step_column(page, said_of(page).hour, "", lives),
        _step_column(page, own.damage, "%", _shares(page, leading.damage, shown)),
    ]
    for name, cells in found.steps.cells.items():
        column = _step_column(page, name.rpartition(".")[2], "", [cells[step] for step in shown])
        if page.width_of([*columns, column, *ends]) <= page.medium.width - _BAR // 2:
            columns.append(column)
    columns += ends
    table = page.columns(list(zip(*columns, strict=True)), "r" * len(columns))
    lines = [page.heading(own.steps), *_with_bars(page, table, leading.damage[shown])]
    if len(shown) < len(found.steps):
        rest = 1.0 - float(leading.damage[shown].sum())
        text = own.left_out.format(
            shown=len(shown),
            count=len(found.steps) - len(shown),
            damage=percent(page, max(rest, 0.0)),
        )
        lines += page.hanging(Text("  "), text, "dim")
    legend = own.legend.format(theory=said_of(page).long[leading.theory or REFERENCE.name])
    return [*lines, *page.hanging(Text("  "), legend, "dim"), *_failures(page, own, found)]


def _shown(found: SpectrumLife) -> NDArray[np.int64]:
    """Steps of the table: all, or of many those with the greatest damage, in their order."""
    count = len(found.steps)
    if count <= _MOST_SHOWN:
        return np.arange(count, dtype=np.int64)
    damage = np.nan_to_num(found.headline.damage, nan=0.0)
    return np.sort(np.argsort(-damage, kind="stable")[:_MOST_SHOWN]).astype(np.int64)


def _step_column(page: Page, head: str, unit: str, cells: list[str]) -> Lines:
    return [page.text(head, "dim"), page.text(unit, "dim"), *map(page.text, cells)]


def _shares(page: Page, shares: NDArray[np.float64], shown: NDArray[np.int64]) -> list[str]:
    return page.digits.column([100.0 * float(share) for share in shares[shown]], 3, 2)


def _with_bars(page: Page, table: Lines, damage: NDArray[np.float64]) -> Lines:
    """Put a bar beside each step, as long as its damage."""
    room = min(page.medium.width - max(map(len, table)) - 2, _BAR)
    greatest = float(np.nanmax(damage)) if np.any(np.isfinite(damage)) else 0.0
    if room < 1 or greatest <= 0.0:
        return table
    sign = "█" if page.medium.draws else "#"
    bars = [
        "",
        "",
        *(sign * round(room * float(part) / greatest) for part in np.nan_to_num(damage)),
    ]
    return [
        Text.assemble(line, "  ", page.text(bar, "green"))
        for line, bar in zip(table, bars, strict=True)
    ]


def _failures(page: Page, own: _Words, found: SpectrumLife) -> Lines:
    lines: Lines = []
    failed = np.flatnonzero((found.status != _CONVERGED) & found.taking_part)
    for step in failed[:_MOST_SHOWN].tolist():
        code = str(found.status[step])
        text = own.failed.format(
            step=step + 1, line=found.steps.lines[step], reason=page.words.reasons.get(code, code)
        )
        lines += page.hanging(page.text("  ✗ ", "bold red"), text, "red")
    return lines


# --- data -------------------------------------------------------------------------------------


def spectrum_csv(found: SpectrumLife) -> str:
    """Return the steps, one a line below a header that names the units (RFC 4180)."""
    text = StringIO(newline="")
    writer = csv.writer(text)
    theories = list(found.theories)
    writer.writerow(
        [
            "step",
            "status",
            "time_share",
            "revolution_share",
            *found.steps.cells,
            *(f"{name}_h" for name in theories),
            *(f"{name}_damage" for name in theories),
        ]
    )
    for step in range(len(found.steps)):
        writer.writerow(
            [
                step + 1,
                str(found.status[step]),
                csv_number(found.time_shares[step]),
                csv_number(found.revolution_shares[step]),
                *(cells[step] for cells in found.steps.cells.values()),
                *(csv_number(own.steps.hours[step]) for own in found.theories.values()),
                *(csv_number(own.damage[step]) for own in found.theories.values()),
            ]
        )
    return text.getvalue()


def spectrum_json(found: SpectrumLife) -> str:
    """Return everything as one JSON object in SI units, hours and millions of revolutions."""
    return json_text(
        {
            "schema": SCHEMA,
            "kind": "life_spectrum",
            "title": found.case.title,
            "reliability": found.reliability,
            "mean_speed": found.mean_speed,
            "headline": _headline_mapping(found),
            "theories": {name: _theory_mapping(own) for name, own in found.theories.items()},
            "wanted_life": _required_life_mapping(found),
            "steps": {
                "status": found.status.tolist(),
                "time_share": found.time_shares,
                "revolution_share": found.revolution_shares,
                "values": {name: list(values) for name, values in found.steps.values.items()},
            },
            "case": found.case.to_mapping(),
        }
    )


def _headline_mapping(found: SpectrumLife) -> dict[str, Any]:
    leading = found.headline
    return {
        "theory": leading.theory or None,
        **_life_mapping(leading),
        "step_hours": leading.steps.hours,
        "damage": leading.damage,
    }


def _theory_mapping(own: DutyLife) -> dict[str, Any]:
    assert isinstance(own.steps, Life)
    notes = {note: where.tolist() for note, where in own.steps.notes.items() if np.any(where)}
    return {
        **_life_mapping(own),
        "notes": notes,
        "step_life": own.steps.life,
        "step_hours": own.steps.hours,
        "damage": own.damage,
    }


def _life_mapping(own: DutyLife) -> dict[str, Any]:
    return {
        "life": own.life,
        "hours": own.hours,
        "endless": bool(np.isposinf(own.life)),
        "holds": own.valid,
        "below": own.below,
    }


def _required_life_mapping(found: SpectrumLife) -> dict[str, float | bool | None] | None:
    if found.required_life is None:
        return None
    return {
        "life": found.required_life,
        "reliability": found.reliability_of_required(),
        "below": found.headline.below,
    }
