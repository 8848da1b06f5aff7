"""The life tests, the lives drawn from them, and how these compare with calculated lives."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from itertools import groupby
from typing import Any

import numpy as np

from rolamento.life.iso281 import MILLION
from rolamento.weibull import published_text
from rolamento_reproductions.campanha_2008.against_calculated import against_table
from rolamento_reproductions.campanha_2008.fits import fits_table
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    HOUR,
    basic_life_hours,
    printed,
    speed,
)
from rolamento_reproductions.campanha_2008.nsk import nsk_numbers
from rolamento_reproductions.campanha_2008.numbers import NONE, Number, numbers_table
from rolamento_reproductions.campanha_2008.weibull import lives_of_tests
from rolamento_reproductions.campanha_2008.weibull_figures import (
    figure_of_condition_one,
    figure_without_test_5,
)
from rolamento_reproductions.record import Claim, Section, Table, TableColumn
from rolamento_reproductions.text import Text, said

__all__ = ["LifeTest", "comparison_numbers", "life_tests", "life_tests_section"]

_DOUBLE = 100.0
"""% above the calculated life."""


@dataclass(frozen=True, slots=True)
class LifeTest:
    """One test: what ran how long (h), and what failed at its end."""

    number: int
    procedure: str
    condition: str
    hours: float
    bearings: tuple[int, ...]
    failed: tuple[int, ...]


@cache
def life_tests() -> tuple[LifeTest, ...]:
    """Return the tests of tables 4.1.1 and 4.1.2."""
    lines = published_text("campanha_2008").splitlines()
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return tuple(_test(list(own)) for _, own in groupby(rows, key=lambda row: row["test"]))


def _test(rows: list[dict[str, str]]) -> LifeTest:
    """Put the bearings of a test together."""
    first = rows[0]
    return LifeTest(
        number=int(first["test"]),
        procedure=first["procedure"],
        condition=first["condition"],
        hours=float(first["time"]),
        bearings=tuple(int(row["bearing"]) for row in rows),
        failed=tuple(int(row["bearing"]) for row in rows if row["status"] == "failed"),
    )


def life_tests_section(title: Text) -> Section:
    """Show the tests, the lives drawn from them, and compute the comparisons."""
    return Section(
        title,
        (
            _record(),
            figure_of_condition_one(),
            figure_without_test_5(),
            _comparison(),
            fits_table(),
            against_table(),
        ),
    )


# --- tables 4.1.1 and 4.1.2 -------------------------------------------------


def _record() -> Table:
    tests = life_tests()
    rating = printed("life")["dynamic_rating_N"]
    turns = [test.hours * HOUR * speed() / (2.0 * np.pi * MILLION) for test in tests]

    def column(name: str, title: Text, cells: list[Any]) -> TableColumn:
        return TableColumn(name, title, tuple(str(cell) for cell in cells))

    return Table(
        number="4.1.1",
        caption=said(
            "The life tests of tables 4.1.1 and 4.1.2: running time, revolutions, and time over the"
            " rating life (C/P)³ = {:.1f} h. In procedure I two bearings run together, and the test"
            " ends with the first failure; in procedure II one is reinforced and does not count.",
            "Os ensaios de vida das tabelas 4.1.1 e 4.1.2: tempo, revoluções e tempo sobre a vida"
            " nominal (C/P)³ = {:.1f} h. No procedimento I dois rolamentos giram juntos e o ensaio"
            " termina com a primeira falha; no II um é reforçado e não conta.",
            basic_life_hours(rating),
        ),
        source=GIVEN.source_of("life_tests"),
        columns=(
            column("test", said("Test", "Ensaio"), [test.number for test in tests]),
            column("procedure", said("Procedure", "Procedimento"), [t.procedure for t in tests]),
            column("condition", said("Condition", "Condição"), [t.condition for t in tests]),
            column("bearings", said("Bearings", "Rolamentos"), [_list(t.bearings) for t in tests]),
            column("hours", said("Time (h)", "Tempo (h)"), [f"{t.hours:.1f}" for t in tests]),
            column(
                "revolutions_1e6",
                said("10⁶ revolutions", "10⁶ revoluções"),
                [f"{n:.2f}" for n in turns],
            ),
            column(
                "over_rating_life",
                said("over (C/P)³", "sobre (C/P)³"),
                [f"{t.hours / basic_life_hours(rating):.2f}" for t in tests],
            ),
            column("failed", said("Failed", "Falhou"), [_list(t.failed) for t in tests]),
        ),
        claims=(_six(), _third(), _sides()),
    )


def _list(numbers: tuple[int, ...]) -> str:
    return " + ".join(str(number) for number in numbers) or "–"


def _six() -> Claim:
    failed = [number for test in life_tests() for number in test.failed]
    count = sum(len(test.bearings) for test in life_tests())
    return Claim(
        said("Only 6 of the 24 bearings failed.", "Apenas 6 dos 24 rolamentos falharam."),
        said(
            "{} of {}; the other {} were still running when their test ended. Their times are not"
            " lives, but lower bounds of lives.",
            "{} de {}; os outros {} ainda giravam ao fim de seu ensaio. Seus tempos não são vidas,"
            " mas limites inferiores de vidas.",
            len(failed),
            count,
            count - len(failed),
        ),
        (len(failed), count) == (6, 24),
    )


def _third() -> Claim:
    first = life_tests()[0]
    return Claim(
        said("In test 1 bearing 3 failed.", "No ensaio 1 falhou o rolamento 3."),
        said(
            "Bearings {} ran in it, and the text names bearing {} everywhere else.",
            "Nele giraram os rolamentos {}, e no resto do texto é o rolamento {}.",
            _list(first.bearings),
            first.failed[0],
        ),
        3 in first.bearings,
    )


def _sides() -> Claim:
    drive = GIVEN.inputs_of("life_tests")["drive_side"]
    single = [test.bearings[0] for test in life_tests() if test.procedure == "II"]
    against = [number for number in single if (number % 2 == 1) != (number in drive)]
    return Claim(
        said(
            "Bearings of odd numbers sit at the drive side, of even numbers at the other.",
            "Rolamentos de numeração ímpar ficam do lado do acionamento; os pares, do lado oposto.",
        ),
        said(
            "Not in procedure II: tests 11 and 12 failed at the drive side, 13 and 14 at the other;"
            " bearings {} contradict the rule.",
            "Não no procedimento II: os ensaios 11 e 12 falharam do lado do acionamento, 13 e 14 do"
            " lado oposto; os rolamentos {} contradizem a regra.",
            said("{} and {}", "{} e {}", *against),
        ),
        holds=not against,
    )


# --- comparisons ------------------------------------------------------------


@cache
def comparison_numbers() -> tuple[Number, ...]:
    """Return the printed deviations of tested from calculated lives."""
    given = GIVEN.inputs_of("comparison")
    calculated = {number.key: float(number.printed) for number in nsk_numbers()}
    reduced = float(GIVEN.inputs_of("load_zone")["reduced_life_h"])
    lives = {number.key: float(number.printed) for number in lives_of_tests()}
    without, hot = lives["life_without_5"], lives["life_II"]
    measured = calculated["measured_I"]
    return (
        Number(
            "measured",
            said("242.3 h over L_able = 189 h (%)", "242,3 h sobre L_able = 189 h (%)"),
            given["measured_percent"],
            _above(without, measured),
            NONE,
            said(
                "Of the tested over the calculated life, less one. The text does not say that it is"
                " the life printed as that without test 5; with the other it is {:.0f} %.",
                "Da vida ensaiada sobre a calculada, menos um. O texto não diz que é a impressa"
                " como sem o ensaio 5; com a outra são {:.0f} %.",
                _above(lives["life_I"], measured),
            ),
        ),
        Number(
            "catalogue",
            said("242.3 h over L_able = 41 h (%)", "242,3 h sobre L_able = 41 h (%)"),
            given["catalogue_percent"],
            _above(without, calculated["catalogue_I"]),
            NONE,
            said("“Near”; likewise.", "“Próximo de”; da mesma forma."),
        ),
        Number(
            "condition_II",
            said(
                "117.4 h over L_able = 69 h, condition II (%)",
                "117,4 h sobre L_able = 69 h, condição II (%)",
            ),
            given["condition_II_percent"],
            _above(hot, calculated["measured_II"]),
            NONE,
            said(
                "Likewise, with running times taken for failures.",
                "Da mesma forma, com os tempos de ensaio tomados por falhas.",
            ),
        ),
        Number(
            "reduced",
            said(
                "242.3 h over 151.2 h, corrected for ε (%)",
                "242,3 h sobre 151,2 h, corrigida por ε (%)",
            ),
            given["reduced_percent"],
            _above(without, reduced),
            NONE,
            said(
                "Likewise; the correction is in table D.",
                "Da mesma forma; a correção está na tabela D.",
            ),
        ),
    )


def _above(tested: float, calculated: float) -> float:
    """How far a tested life is above the calculated one; %."""
    return 100.0 * (tested / calculated - 1.0)


def _comparison() -> Table:
    return numbers_table(
        "E",
        said(
            "The lives L_10h drawn from the tests, with limits of 90 %, and how far the printed"
            " ones are above the calculated.",
            "As vidas L_10h tiradas dos ensaios, com limites de 90 %, e quanto as impressas superam"
            " as calculadas.",
        ),
        GIVEN.source_of("comparison"),
        (*lives_of_tests(), *comparison_numbers()),
        claims=(_more_than_double(),),
        notes=(
            said(
                "There is no right number beside the percentages, because none of the calculated"
                " lives holds (tables C and D), and with limits so wide they say nothing. Table"
                " E.2 sets all calculated lives against the tests.",
                "Não há número correto ao lado das porcentagens, pois nenhuma das vidas calculadas"
                " vale (tabelas C e D) e, com limites tão largos, elas nada dizem. A tabela E.2"
                " põe todas as vidas calculadas contra os ensaios.",
            ),
        ),
    )


def _more_than_double() -> Claim:
    calculated = {number.key: float(number.printed) for number in nsk_numbers()}["measured_II"]
    tested = next(float(n.printed) for n in lives_of_tests() if n.key == "life_II")
    times = [test.hours for test in life_tests() if test.condition == "II"]
    above = [_above(time, calculated) for time in times]
    most = sum(value > _DOUBLE for value in above)
    return Claim(
        said(
            "In condition II the tests went more than 100 % beyond the predicted life without a"
            " failure.",
            "Na condição II os ensaios excederam a vida prevista em mais de 100 % sem falha.",
        ),
        said(
            "{} of {} tests did, the other by {:.0f} %; against 117.4 h, with which the text says"
            " it compares, it is {:.0f} %.",
            "{} de {} ensaios, o outro em {:.0f} %; contra as 117,4 h com que o texto diz comparar,"
            " são {:.0f} %.",
            most,
            len(times),
            min(above),
            _above(tested, calculated),
        ),
        holds=most == len(times),
        partly=most > 0,
    )
