"""Columns of tables by their names, in English, Portuguese, German or Spanish; their units.

What a table of lives, of bearings in service or of measurements calls its columns, in any order and
case, with or without accents and with the unit in brackets or behind the name; and what recorders
call times.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Final

from rolamento.errors import InputError
from rolamento.words import said

__all__ = [
    "COLUMN_OF",
    "NAMES",
    "UNIT_OF",
    "check_names",
    "column_by_name",
    "folded_name",
    "heads_table",
    "is_unit_word",
    "place_of",
    "seconds_of_heading",
    "title_parts",
    "word_and_unit",
]


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


NAMES: Final = {
    "time": (
        "time times t life lives lifetime duration end time_to_failure age tempo tempos vida vidas"
        " duracao idade fim to ate ttf tbf run_time running_time runtime operating_time"
        " service_life time_in_service hours_in_service hours_in_operation"
        " hours_run run_hours running_hours operating_hours hours_to_failure time_on_test"
        " failure_time failure_times times_to_failure time_of_failure cycles_to_failure"
        " revolutions_to_failure age_at_failure ages_at_failure life_at_failure time_at_failure"
        " hours_at_failure lifetime_to_failure total_hours cumulative_hours elapsed_time"
        " tempo_de_operacao tempo_operacao tempo_ate_falha tempo_ate_a_falha tempo_de_vida"
        " tempo_de_funcionamento tempo_de_teste tempo_de_ensaio tempo_de_uso tempo_em_servico"
        " tempo_em_operacao vida_util horimetro horas_de_operacao horas_operacao horas_de_trabalho"
        " horas_trabalhadas horas_ate_falha horas_ate_a_falha horas_de_funcionamento horas_rodadas"
        " horas_de_uso horas_de_servico horas_em_servico horas_em_operacao horas_acumuladas"
        " ciclos_ate_falha ciclos_ate_a_falha idade_na_falha tempo_da_falha tempo_de_falha"
        " zeit laufzeit betriebsstunden betriebszeit lebensdauer standzeit ausfallzeit"
        " laufzeit_bis_ausfall zeit_bis_ausfall zyklen_bis_ausfall alter_bei_ausfall"
        " tiempo tiempos tiempo_hasta_fallo tiempo_hasta_la_falla tiempo_de_operacion edad"
        " tiempo_de_funcionamiento tiempo_en_servicio horas_hasta_fallo horas_de_operacion"
        " ciclos_hasta_fallo"
    ),
    "date": (
        "date day_of_measurement measured_on date_of_measurement measurement_date timestamp"
        " time_stamp datetime date_time date_and_time data data_da_medicao data_medicao"
        " data_da_leitura data_leitura medido_em data_hora data_e_hora datum messdatum zeitstempel"
        " datum_uhrzeit datum_und_uhrzeit fecha fecha_de_medicion fecha_hora fecha_y_hora"
    ),
    "clock": "time_of_day clock hora_do_dia horario hora_da_medicao uhrzeit hora_del_dia",
    "status": (
        "status state event outcome f_s f_c failed_suspended failure_suspension estado situacao"
        " evento resultado falha_suspenso falha_suspensao falha_censura falha_censurado"
        " e event_observed event_occurred is_event observed delta dead death died"
        " evento_observado observado zustand ergebnis ausfall_zensiert ereignis situacion"
    ),
    "failed": (
        "failed failure fail is_failed broken falhou falha falhado avaria avariado quebrou"
        " ausgefallen ausfall fallo fallado fallo_observado"
    ),
    "suspended": (
        "suspended suspension censored censoring right_censored runout survived unfailed suspenso"
        " suspensao censurado censura sobreviveu zensiert suspendido"
    ),
    "lower": (
        "lower lower_bound last_inspection inspection from start previous left inferior"
        " limite_inferior ultima_inspecao inspecao inspecao_anterior de inicio"
        " letzte_inspektion untere_grenze ultima_inspeccion"
    ),
    "upper": (
        "upper upper_bound right next_inspection superior limite_superior obere_grenze"
        " proxima_inspecao"
    ),
    "count": (
        "count counts quantity qty number n freq frequency how_many quantidade contagem qtd qtde"
        " qde quant numero numero_de_rolamentos anzahl menge stueckzahl stuckzahl cantidad"
        " cantidad_de_rodamientos"
    ),
    "group": (
        "group groups lot batch condition series population grupo lote condicao serie populacao"
        " gruppe los charge bedingung condicion poblacion"
    ),
    "mode": (
        "mode failure_mode failure_cause cause_of_failure cause mechanism failure_mechanism modo"
        " modo_de_falha modo_falha causa causa_da_falha causa_de_falha mecanismo"
        " mecanismo_de_falha ausfallart ausfallursache fehlerart schadensart schadensbild"
        " modo_de_fallo modo_de_falla causa_de_fallo causa_del_fallo"
    ),
    "rig": "rig test test_rig bancada ensaio dispositivo pruefstand prufstand banco ensayo",
    "machine": (
        "machine position station stand equipment maquina posicao equipamento maschine"
        " equipo posicion"
    ),
    "size": (
        "size rig_size group_size bearings_per_rig m tamanho tamanho_do_grupo"
        " rolamentos_por_bancada"
    ),
    "bearing": (
        "bearing bearings id name item specimen sample serial rolamento rolamentos"
        " identificacao nome peca amostra lager prufling pruefling rodamiento rodamientos nombre"
        " muestra"
    ),
    "tag": (
        "tag tag_number tag_do_equipamento asset ativo point measuring_point ponto ponto_de_medicao"
        " mancal messstelle messpunkt punto punto_de_medicion"
    ),
    "value": (
        "value values reading readings measurement measured level velocity vibration acceleration"
        " severity clearance temperature noise rms overall valor valores leitura leituras medicao"
        " medida medido nivel velocidade vibracao aceleracao severidade folga temperatura ruido"
        " valor_global global valor_medido wert werte messwert messwerte schwinggeschwindigkeit"
        " schwingung beschleunigung geschwindigkeit lagerluft lagerspiel temperatur gerausch"
        " geraeusch lectura lecturas medicion velocidad vibracion aceleracion severidad juego"
    ),
    "remark": (
        "note notes remark remarks comment comments procedure nota observacao observacoes obs"
        " comentario procedimento bemerkung kommentar anmerkung observacion"
    ),
}
"""What columns hold, and the names by which it is known; folded."""
_UNITS: Final = {
    "h": "h hr hrs hour hours hora horas stunde stunden std",
    "Mrev": (
        "mrev mrevs million_revolutions millions_of_revolutions 10_6_rev 10_6_revolutions 1e6_rev"
        " milhoes_de_rotacoes milhoes_de_revolucoes milhoes_de_voltas 10_6_rot mio_umdrehungen"
        " millionen_umdrehungen millones_de_revoluciones"
    ),
    "rev": "rev revs revolutions rotacoes revolucoes voltas umdrehungen revoluciones",
    "cycles": "cycles ciclos zyklen lastwechsel",
    "d": "d day days dia dias tage",
    "km": "km kms quilometro quilometros quilometragem kilometre kilometres kilometer kilometers",
}
COLUMN_OF: Final = {word: column for column, words in NAMES.items() for word in words.split()}
UNIT_OF: Final = {word: unit for unit, words in _UNITS.items() for word in words.split()}
_IN_BRACKETS: Final = r"(.*?)\s*[\[(]\s*([^\[\]()]{1,40}?)\s*[\])]\s*"
_MICRO: Final = str.maketrans({"\u03bc": "\u00b5"})
"""Greek mu for the sign of micro, which the units are written with."""
_UNIT_WORDS: Final = _words(
    "s sec ms us µs ns min h d hz khz rpm 1/min min-1 min^-1 min⁻¹ r/min u/min rad/s mm µm um nm m"
    " in mil mils mm/s m/s in/s ips µm/s um/s m/s² m/s^2 m/s2 mm/s² mm/s^2 mm/s2 m/s/s g ge mg gn"
    " v mv µv uv volt volts dbv counts n kn lbf kgf n·m n-m pa kpa bar mpa db °c ºc degc °f k a ma"
    " kw w % - – mrev rev cycles horas hours"
)
"""What stands in a line of units below the names of columns; without case."""


@lru_cache(maxsize=4096)
def folded_name(word: str) -> str:
    """Return a name without accents and case, its words joined by underscores."""
    plain = unicodedata.normalize("NFKD", word[:200])
    plain = "".join(c for c in plain if not unicodedata.combining(c)).casefold()
    return re.sub(r"[^a-z0-9]+", "_", plain).strip("_")


def title_parts(title: str) -> tuple[str, str]:
    """Return the name of a column, and its unit as written in brackets; empty without."""
    match = re.fullmatch(_IN_BRACKETS, title)
    return (match[1], match[2].translate(_MICRO)) if match else (title, "")


def is_unit_word(text: str) -> bool:
    """Return whether a cell can be a unit in a line of units below names."""
    return text.strip().translate(_MICRO).casefold() in _UNIT_WORDS


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


def heads_table(*more: str) -> Callable[[Sequence[str]], bool]:
    """Return a predicate that recognises a line of column names: at least one is known.

    more: further names that are known, as they are written, such as those that the user chose.
    """
    known = {folded_name(name) for name in more if name}

    def is_header(cells: Sequence[str]) -> bool:
        words = [word_and_unit(cell)[0] for cell in cells]
        return any(
            word
            and (word in known or column_by_name(word) is not None or folded_name(cell) in known)
            for word, cell in zip(words, cells, strict=True)
        )

    return is_header


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


_BARE_NUMBER: Final = r"[+-]?\d[\d.,]*"


def check_names(header: Sequence[str], example: str) -> None:
    """Refuse a table whose first line holds numbers: it has no names of columns.

    Raises
    ------
    InputError
        With what to put above the table.
    """
    for cell in header:
        if re.fullmatch(_BARE_NUMBER, cell):
            raise InputError(
                said("stands where the names of the columns must be; put a line with them above"),
                field="header",
                value=cell,
                example=example,
            )


# --- times of records ---------------------------------------------------------------------------

_SECONDS: Final = {
    "s": 1.0, "sec": 1.0, "secs": 1.0, "second": 1.0, "seconds": 1.0, "seg": 1.0, "segundo": 1.0,
    "segundos": 1.0, "sek": 1.0, "sekunde": 1.0, "sekunden": 1.0,
    "ms": 1e-3, "msec": 1e-3, "millisecond": 1e-3, "milliseconds": 1e-3, "milissegundo": 1e-3,
    "milissegundos": 1e-3, "millisekunden": 1e-3, "milisegundos": 1e-3,
    "us": 1e-6, "usec": 1e-6, "microsecond": 1e-6, "microseconds": 1e-6, "microssegundos": 1e-6,
    "mikrosekunden": 1e-6, "microsegundos": 1e-6,
    "ns": 1e-9, "nsec": 1e-9, "nanosecond": 1e-9, "nanoseconds": 1e-9, "nanossegundos": 1e-9,
    "nanosekunden": 1e-9, "nanosegundos": 1e-9,
    "min": 60.0, "minute": 60.0, "minutes": 60.0, "minuto": 60.0, "minutos": 60.0, "minuten": 60.0,
    "h": 3600.0, "hr": 3600.0, "hour": 3600.0, "hours": 3600.0, "hora": 3600.0, "horas": 3600.0,
    "stunden": 3600.0, "d": 86400.0, "day": 86400.0, "days": 86400.0,
}  # fmt: skip
"""Seconds in a unit of time, by its names; folded, micro as u."""
_TIME_ALONE: Final = _words("t time times timestamp seconds elapsed xtime zeit tempo temps tiempo")
"""Names that are of times whatever the numbers are."""
_TIME_WORDS: Final = _words(
    "t time times timestamp elapsed zeit tempo tempos temps tiempo messzeit abtastzeit zeitachse"
    " x_axis x_value xaxis xvalue x abscissa eixo_x eixo_do_tempo eje_x x_achse tempo_decorrido"
    " tempo_relativo tiempo_relativo relativzeit"
)


@lru_cache(maxsize=4096)
def seconds_of_heading(name: str, unit: str) -> tuple[float | None, bool]:
    """Return the seconds in the unit of a column of times, and whether its name is sure.

    Parameters
    ----------
    name, unit
        Of the heading, ``"Time"`` and ``"µs"``; the unit may stand behind the name instead:
        time_ms, Time in ms.

    Returns
    -------
    tuple
        None of a column that is none, or whose unit is not one of time; and whether the name is
        that of times and nothing else. Of one that is not sure the numbers have to rise evenly.
    """
    if not unit:
        name, unit = title_parts(name)
    word = _folded_time(name)
    scale = _SECONDS.get(_folded_time(unit))
    if unit and scale is None:
        return None, False
    if unit:
        return scale, word.replace("_", "") in _TIME_ALONE
    if word in _SECONDS and len(word) > 1:
        return _SECONDS[word], word == "seconds"
    head, _, tail = word.rpartition("_")
    if tail in _SECONDS and head:
        head = head.removesuffix("_in").removesuffix("_em")
        if set(head.split("_")) & _TIME_WORDS or head in _TIME_WORDS:
            plain = len(head) > 1 or tail in ("s", "ms", "us", "ns")  # t_min may be a temperature
            return _SECONDS[tail], plain and head in _TIME_ALONE
        return None, False
    if word.replace("_", "") in _TIME_ALONE:
        return 1.0, True
    if word in _TIME_WORDS or {"time", "zeit", "tempo", "tiempo", "temps"} & set(word.split("_")):
        return 1.0, False
    return None, False


def _folded_time(text: str) -> str:
    return folded_name(text.replace("\u00b5", "u").replace("\u03bc", "u"))
