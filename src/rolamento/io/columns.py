"""Columns of tables by their names, in English or Portuguese; their units, and dates in them.

What a table of lives, of bearings in service or of measurements calls its columns, in any order and
case, with or without accents and with the unit in brackets or behind the name.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import date
from functools import lru_cache
from typing import Any, Final, Literal, get_args

from rolamento.errors import ABSENT, InputError
from rolamento.words import said

__all__ = [
    "COLUMN_OF",
    "NAMES",
    "UNIT_OF",
    "DateOrder",
    "Dates",
    "check_names",
    "checked_order",
    "column_by_name",
    "dates_of",
    "folded_name",
    "place_of",
    "title_parts",
    "word_and_unit",
]

NAMES: Final = {
    "time": (
        "time times t life lives lifetime duration end time_to_failure age tempo tempos vida vidas"
        " duracao idade fim to ate ttf tbf run_time running_time runtime operating_time"
        " service_life time_in_service hours_in_service hours_in_operation"
        " hours_run run_hours running_hours operating_hours hours_to_failure time_on_test"
        " tempo_de_operacao tempo_operacao tempo_ate_falha tempo_ate_a_falha tempo_de_vida"
        " tempo_de_funcionamento tempo_de_teste tempo_de_ensaio tempo_de_uso tempo_em_servico"
        " tempo_em_operacao vida_util horimetro horas_de_operacao horas_operacao horas_de_trabalho"
        " horas_trabalhadas horas_ate_falha horas_ate_a_falha horas_de_funcionamento horas_rodadas"
        " horas_de_uso horas_de_servico horas_em_servico horas_em_operacao horas_acumuladas"
    ),
    "date": (
        "date day_of_measurement measured_on date_of_measurement measurement_date timestamp"
        " datetime data data_da_medicao data_medicao data_da_leitura data_leitura medido_em"
        " data_hora data_e_hora"
    ),
    "status": (
        "status state event outcome f_s f_c failed_suspended failure_suspension estado situacao"
        " evento resultado falha_suspenso falha_suspensao falha_censura falha_censurado"
    ),
    "failed": "failed failure fail is_failed broken falhou falha falhado avaria avariado quebrou",
    "suspended": (
        "suspended suspension censored censoring right_censored runout survived unfailed suspenso"
        " suspensao censurado censura sobreviveu"
    ),
    "lower": (
        "lower lower_bound last_inspection inspection from start previous inferior"
        " limite_inferior ultima_inspecao inspecao inspecao_anterior de"
    ),
    "count": (
        "count counts quantity qty number n freq frequency how_many quantidade contagem qtd qtde"
        " qde quant numero numero_de_rolamentos"
    ),
    "group": (
        "group groups lot batch condition series population grupo lote condicao serie populacao"
    ),
    "rig": "rig test test_rig bancada ensaio dispositivo",
    "machine": "machine position station stand equipment maquina posicao equipamento",
    "size": (
        "size rig_size group_size bearings_per_rig m tamanho tamanho_do_grupo"
        " rolamentos_por_bancada"
    ),
    "bearing": (
        "bearing bearings id name item specimen sample serial rolamento rolamentos"
        " identificacao nome peca amostra"
    ),
    "tag": (
        "tag tag_number tag_do_equipamento asset ativo point measuring_point ponto ponto_de_medicao"
        " mancal"
    ),
    "value": (
        "value values reading readings measurement measured level velocity vibration acceleration"
        " severity clearance temperature noise rms overall valor valores leitura leituras medicao"
        " medida medido nivel velocidade vibracao aceleracao severidade folga temperatura ruido"
        " valor_global global valor_medido"
    ),
    "remark": (
        "note notes remark remarks comment comments procedure mode nota observacao observacoes obs"
        " comentario procedimento modo"
    ),
}
"""What columns hold, and the names by which it is known; folded."""
_UNITS: Final = {
    "h": "h hr hrs hour hours hora horas",
    "Mrev": (
        "mrev mrevs million_revolutions millions_of_revolutions 10_6_rev 10_6_revolutions 1e6_rev"
        " milhoes_de_rotacoes milhoes_de_revolucoes milhoes_de_voltas 10_6_rot"
    ),
    "rev": "rev revs revolutions rotacoes revolucoes voltas",
    "cycles": "cycles ciclos",
    "d": "d day days dia dias",
    "km": "km kms quilometro quilometros quilometragem kilometre kilometres kilometer kilometers",
}
COLUMN_OF: Final = {word: column for column, words in NAMES.items() for word in words.split()}
UNIT_OF: Final = {word: unit for unit, words in _UNITS.items() for word in words.split()}
_IN_BRACKETS: Final = re.compile(r"(.*?)\s*[\[(]([^\[\]()]{1,40})[\])]\s*")


@lru_cache(maxsize=4096)
def folded_name(word: str) -> str:
    """Return a name without accents and case, its words joined by underscores."""
    plain = unicodedata.normalize("NFKD", word[:200])
    plain = "".join(c for c in plain if not unicodedata.combining(c)).casefold()
    return re.sub(r"[^a-z0-9]+", "_", plain).strip("_")


def title_parts(title: str) -> tuple[str, str]:
    """Return the name of a column, and its unit as written in brackets; empty without."""
    match = _IN_BRACKETS.fullmatch(title)
    return (match[1], match[2].strip()) if match else (title, "")


def word_and_unit(title: str) -> tuple[str, str]:
    """Return the folded name of a column of times, and its unit."""
    name, unit = title_parts(title)
    word = folded_name(name)
    if unit:
        return word, UNIT_OF.get(folded_name(unit), unit)
    if word in UNIT_OF:
        return word, UNIT_OF[word]
    head, _, tail = word.rpartition("_")
    if head in COLUMN_OF and tail in UNIT_OF:
        return word, UNIT_OF[tail]
    return word, "h" if set(word.split("_")) & {"hours", "horas", "horimetro"} else ""


def column_by_name(word: str) -> str | None:
    """Return what a column holds by its folded name, as in `NAMES`; None if it is not known."""
    if word in COLUMN_OF:
        return COLUMN_OF[word]
    if word in UNIT_OF or (
        word.rpartition("_")[2] in UNIT_OF and COLUMN_OF.get(word.rpartition("_")[0]) == "time"
    ):
        return "time"
    return None if word else "remark"


def place_of(cells: Sequence[str], title: str) -> int:
    """Return the place of a column by its name as written, or else without accents, case and unit.

    Raises
    ------
    InputError
        If there is none.
    """
    wanted = folded_name(title)
    for names in (
        [cell.casefold() == title.strip().casefold() for cell in cells],
        [wanted == folded_name(cell) for cell in cells],
        [wanted == word_and_unit(cell)[0] for cell in cells],
    ):
        if True in names:
            return names.index(True)
    rule = said(
        "is not a column of the file; the columns are {known}", known=", ".join(filter(None, cells))
    )
    raise InputError(rule, field=title)


_BARE_NUMBER: Final = re.compile(r"[+-]?\d[\d.,]*")


def check_names(header: Sequence[str], example: str) -> None:
    """Refuse a table whose first line holds numbers: it has no names of columns.

    Raises
    ------
    InputError
        With what to put above the table.
    """
    for cell in header:
        if _BARE_NUMBER.fullmatch(cell):
            raise InputError(
                said("stands where the names of the columns must be; put a line with them above"),
                field="header",
                value=cell,
                example=example,
            )


# --- dates ----------------------------------------------------------------------------------------

DateOrder = Literal["day_first", "month_first"]
_ISO: Final = re.compile(r"(\d{4})[-/.](\d{1,2})[-/.](\d{1,2})(?:[T ].{0,30})?")
_DAY_AND_MONTH: Final = re.compile(
    r"(\d{1,2})([-/.])(\d{1,2})\2(\d{4}|\d{2})(?:,?[T ]\s*\d{1,2}[:h].{0,20})?"
)
_WITH_NAME: Final = re.compile(
    r"(\d{1,2})[-/. ](?:de )?([^\W\d]{3,10})\.?[-/. ](?:de )?(\d{4}|\d{2})", re.I
)
_MONTHS: Final = {
    name: number
    for number, names in enumerate(
        ("jan", "feb fev", "mar", "apr abr", "may mai", "jun", "jul", "aug ago", "sep set",
         "oct out", "nov", "dec dez"), 1)
    for name in names.split()
}  # fmt: skip
_ORDER: Final = "dates"


@dataclass(frozen=True, slots=True)
class Dates:
    """How the dates of a table are written.

    Attributes
    ----------
    order
        of day and month in 03/04/2024; None if no such date decides it, and none needs it
    doubt
        a date that may be read in two ways; empty if there is none
    """

    order: DateOrder | None = None
    doubt: str = ""

    def day(self, cell: str) -> date | None:
        """Return the day of a cell; None if it is no date."""
        return _day(cell, self.order)

    def check(self, field: str) -> None:
        """Refuse dates that may be read in two ways.

        Raises
        ------
        InputError
            With both readings, and how to say which it is.
        """
        if not self.doubt:
            return
        first, second = (str(_day(self.doubt, order)) for order in get_args(DateOrder))
        raise InputError(
            said(
                "is {first} if the day comes first and {second} if the month does; the table does"
                " not tell which",
                first=first,
                second=second,
            ),
            field=field,
            value=self.doubt,
            example=said(
                'date_order="day_first" for {first}, date_order="month_first" for {second}; or a'
                ' line "# dates: day first" above the table',
                first=first,
                second=second,
            ),
        )


def dates_of(cells: Iterable[str], order: object = None) -> Dates:
    """Tell how the dates of a column are written, by all of them together.

    2024-03-04 and 4 Mar 2024 are clear, and 04.03.2024 has the day first. Of 04/03/2024 and
    04-03-2024 a number above 12 in one of the cells tells.

    Parameters
    ----------
    cells
        Those of the column.
    order
        What the user says, which holds: ``"day_first"`` or ``"month_first"``.
    """
    if order is not None:
        return Dates(checked_order(order))
    doubt = ""
    for cell in cells:
        match = _DAY_AND_MONTH.fullmatch(cell)
        if match is None or match[2] == ".":
            continue
        first, second = int(match[1]), int(match[3])
        if first > 12 >= second:
            return Dates("day_first")
        if second > 12 >= first:
            return Dates("month_first")
        if first != second:
            doubt = doubt or cell
    return Dates(None, doubt)


def checked_order(order: object, source: str = "") -> DateOrder:
    """Return an order of day and month by its name.

    Raises
    ------
    InputError
        If it is none.
    """
    known: dict[Any, DateOrder] = {
        "day_first": "day_first", "dmy": "day_first", "dd_mm_yyyy": "day_first",
        "dia_primeiro": "day_first", "dma": "day_first",
        "month_first": "month_first", "mdy": "month_first", "mm_dd_yyyy": "month_first",
        "mes_primeiro": "month_first", "mda": "month_first",
    }  # fmt: skip
    word = folded_name(order) if isinstance(order, str) else None
    if word not in known:
        raise InputError(
            said("must be one of {known}", known=", ".join(get_args(DateOrder))),
            field="date_order",
            value=ABSENT if order is None else order,
            example='date_order="day_first"',
            source=source,
        )
    return known[word]


def _day(cell: str, order: DateOrder | None) -> date | None:
    if len(cell) > 60:
        return None
    try:
        if match := _ISO.fullmatch(cell):
            return date(int(match[1]), int(match[2]), int(match[3]))
        if match := _WITH_NAME.fullmatch(cell):
            return date(_year(match[3]), _MONTHS[folded_name(match[2])[:3]], int(match[1]))
        if match := _DAY_AND_MONTH.fullmatch(cell):
            day, month = int(match[1]), int(match[3])
            if order == "month_first" and match[2] != ".":
                day, month = month, day
            return date(_year(match[4]), month, day)
    except (KeyError, ValueError):
        return None
    return None


def _year(text: str) -> int:
    """Two figures are of this century."""
    return int(text) + (2000 if len(text) == 2 else 0)
