"""The languages of report and command line: English and Brazilian Portuguese."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from rolamento.words import Note, speaking

if TYPE_CHECKING:
    from rolamento.solved import Solved

__all__ = ["ENGLISH", "LANGUAGES", "PORTUGUESE", "Words", "words_for"]

_VARIABLES: Final = ("LC_ALL", "LC_MESSAGES", "LANG")


@dataclass(frozen=True, slots=True, kw_only=True)
class Words:
    """All that is said in one language; `{…}` are filled in by the one who says it."""

    code: str
    decimal_mark: str

    # head
    untitled: str
    bearing: str
    geometry: str
    given_contact_angle: str
    given_clearance: str
    conformities: str
    one_material: str
    materials: str
    arrangement: str
    arrangement_kinds: Mapping[str, str]
    one_row: str
    row_list: str
    row_place: str
    row_balls: str
    row_phase: str
    preload_force: str
    preload_offset: str
    preload_spring: str
    preload_level: str
    preload_levels: Mapping[str, str]
    duty: str
    inner_speed: str
    outer_speed: str
    at_rest: str
    model: str
    raceway_control: Mapping[str, str]
    cage: Mapping[str, str]
    without_centrifugal_force: str
    without_gyroscopic_moment: str
    status: str
    converged: str
    reasons: Mapping[str, str]
    advice_label: str
    notes: str

    # rows of a set
    row: str
    rows: str
    row_heading: str
    faces: str
    loaded: str
    rows_legend: str
    both_ways: str
    preload: str
    preload_at_rest: str
    preload_at_speed: str
    preload_lift: str
    ball_lifts_off: str
    ball_has_lifted_off: str
    preload_loss: str
    lifts_off: str
    has_lifted_off: str
    nothing_left: str
    no_loss: str

    # ring
    inner_ring: str
    given: str
    free: str
    held: str
    stiffness: str

    # balls
    rosette: str
    rosettes: str
    rim: str
    seen_from: str
    heaviest: str
    heaviest_in_row: str
    inner: str
    outer: str
    contact_load: str
    contact_angle: str
    approach: str
    max_pressure: str
    semi_major: str
    semi_minor: str
    max_shear: str
    orthogonal_shear: str
    at_depth: str
    balls: str
    motion: str
    load_legend: str
    motion_legend: str

    # command line
    waiting: str
    interrupted: str
    demo_source: str
    demo_next: str
    demo_copy: str
    demo_vary: str
    demo_data: str
    demo_written: str

    def reason(self, solved: Solved, case: int = 0) -> str:
        """Say why a case has no result."""
        code = str(solved.status.code[case])
        return self.reasons.get(code, code)

    def advice(self, solved: Solved, case: int = 0) -> str:
        """Say what to do about it, or nothing."""
        advice = solved.advice[case]
        return self.note(advice) if advice else ""

    def note(self, note: Note) -> str:
        """Say a note."""
        with speaking(self.code):
            return note.text


ENGLISH: Final = Words(
    code="en",
    decimal_mark=".",
    untitled="Ball bearing",
    bearing="bearing",
    geometry="{count} balls of {ball}, pitch diameter {pitch}",
    given_contact_angle="contact angle {angle}",
    given_clearance="diametral clearance {clearance}",
    conformities="{play}, conformity {inner} inner, {outer} outer",
    one_material="rings and balls of {rings}",
    materials="rings of {rings}, balls of {balls}",
    arrangement="{name}, {kind} ({faces}), {spacing} between rows",
    arrangement_kinds={"B": "back to back", "F": "face to face", "T": "in tandem"},
    one_row="1 row: {rows}",
    row_list="{count} rows: {rows}",
    row_place="{face} at {position}",
    row_balls="{count} balls",
    row_phase="phase {angle}",
    preload_force="preload {force}, clamped",
    preload_offset="clamped, each row pressed in by {offset}",
    preload_spring="preload by springs of {force}",
    preload_level="preload class {level} of {name} ({force} in a pair), clamped",
    preload_levels={"light": "light", "medium": "medium", "heavy": "heavy"},
    duty="duty",
    inner_speed="inner ring {speed}",
    outer_speed="outer ring {speed}",
    at_rest="at rest",
    model="model",
    raceway_control={
        "outer": "outer raceway control",
        "inner": "inner raceway control",
        "jones": "raceway control by Jones's criterion",
        "none": "no raceway control: the races share the gyroscopic moment",
        "friction": "balls controlled by friction alone",
    },
    cage={
        "loose": "cage with play: it drives the balls that are not held",
        "rigid": "rigid cage: all balls orbit with it",
        "none": "no cage: raceway control alone moves the balls",
    },
    without_centrifugal_force="no centrifugal force",
    without_gyroscopic_moment="no gyroscopic moment",
    status="status",
    converged="converged in {iterations} iterations, residual {residual}",
    reasons={
        "no_equilibrium": "there is no equilibrium",
        "not_converged": "not converged",
        "overloaded": "overloaded",
        "unheld_ball": "a ball is not held",
        "over_shoulder": "a ball rides over the shoulder",
        "invalid_input": "invalid input",
    },
    advice_label="advice",
    notes="Notes",
    row="row {number}",
    rows="Rows",
    row_heading="row",
    faces="faces",
    loaded="loaded",
    rows_legend=(
        "faces + carries thrust toward +x, − toward −x{both}; moments about x = 0; loaded: balls "
        "that the inner ring presses on; Q_i, p_i maximum"
    ),
    both_ways=", ± both ways",
    preload="Preload",
    preload_at_rest="at rest",
    preload_at_speed="at speed",
    preload_lift="first ball",
    ball_lifts_off="lifts off in row {row} at {factor} × the load: {load}",
    ball_has_lifted_off="has lifted off in row {row}: it did at {factor} × the load, {load}",
    preload_loss="loss",
    lifts_off="row {row} lifts off at {factor} × the load: {load}",
    has_lifted_off="row {row} has lifted off: it did at {factor} × the load, {load}",
    nothing_left="no ball of row {rows} presses on the inner ring",
    no_loss="no row is found to lose all contact as this load grows",
    inner_ring="Inner ring",
    given="{name} given",
    free="free",
    held="held",
    stiffness="Stiffness",
    rosette="Load rosette",
    rosettes="Load rosettes",
    rim="rim: Q_i = {load} N",
    seen_from="seen from +x",
    heaviest="Heaviest ball: #{number} at {azimuth}°",
    heaviest_in_row="Heaviest ball: #{number} of row {row} at {azimuth}°",
    inner="inner",
    outer="outer",
    contact_load="load",
    contact_angle="contact angle",
    approach="approach",
    max_pressure="maximum pressure",
    semi_major="ellipse, semi-major",
    semi_minor="ellipse, semi-minor",
    max_shear="maximum shear",
    orthogonal_shear="orthogonal shear",
    at_depth="  at a depth of",
    balls="Balls",
    motion="Motion of the balls",
    load_legend="Q load, α contact angle, p maximum pressure; i inner, o outer; ◂ maximum",
    motion_legend="F_c centrifugal force, M_g gyroscopic moment, n_m orbit, n_R ball, s spin/roll",
    waiting="Solving; if it compiles its kernels for this machine, once, that takes about 20 s …",
    interrupted="interrupted",
    demo_source="This was {path}",
    demo_next="What to try next",
    demo_copy="a copy to work on",
    demo_vary="the same with ceramic balls",
    demo_data="the balls as a table, and everything as JSON",
    demo_written="Wrote {path}; now try: {command} solve {path}",
)

PORTUGUESE: Final = Words(
    code="pt",
    decimal_mark=",",
    untitled="Rolamento de esferas",
    bearing="rolamento",
    geometry="{count} esferas de {ball}, diâmetro primitivo {pitch}",
    given_contact_angle="ângulo de contato {angle}",
    given_clearance="folga diametral {clearance}",
    conformities="{play}, conformidade {inner} interna, {outer} externa",
    one_material="anéis e esferas de {rings}",
    materials="anéis de {rings}, esferas de {balls}",
    arrangement="{name}, {kind} ({faces}), {spacing} entre carreiras",
    arrangement_kinds={"B": "costas a costas", "F": "face a face", "T": "em tandem"},
    one_row="1 carreira: {rows}",
    row_list="{count} carreiras: {rows}",
    row_place="{face} em {position}",
    row_balls="{count} esferas",
    row_phase="fase {angle}",
    preload_force="pré-carga de {force}, anéis travados",
    preload_offset="anéis travados, cada carreira pressionada {offset}",
    preload_spring="pré-carga por molas de {force}",
    preload_level="classe de pré-carga {level} de {name} ({force} num par), anéis travados",
    preload_levels={"light": "leve", "medium": "média", "heavy": "pesada"},
    duty="serviço",
    inner_speed="anel interno a {speed}",
    outer_speed="anel externo a {speed}",
    at_rest="em repouso",
    model="modelo",
    raceway_control={
        "outer": "controle pela pista externa",
        "inner": "controle pela pista interna",
        "jones": "controle de pista pelo critério de Jones",
        "none": "sem controle de pista: as pistas dividem o momento giroscópico",
        "friction": "esferas controladas só pelo atrito",
    },
    cage={
        "loose": "gaiola com folga: ela arrasta as esferas que não são seguradas",
        "rigid": "gaiola rígida: todas as esferas orbitam com ela",
        "none": "sem gaiola: só o controle de pista move as esferas",
    },
    without_centrifugal_force="sem força centrífuga",
    without_gyroscopic_moment="sem momento giroscópico",
    status="situação",
    converged="convergiu em {iterations} iterações, resíduo {residual}",
    reasons={
        "no_equilibrium": "não há equilíbrio",
        "not_converged": "não convergiu",
        "overloaded": "sobrecarga",
        "unheld_ball": "uma esfera não é segurada",
        "over_shoulder": "uma esfera passa do rebordo da pista",
        "invalid_input": "entrada inválida",
    },
    advice_label="conselho",
    notes="Observações",
    row="carreira {number}",
    rows="Carreiras",
    row_heading="carreira",
    faces="lado",
    loaded="ativas",
    rows_legend=(
        "lado + suporta empuxo no sentido +x, − no sentido −x{both}; momentos em torno de x = 0; "
        "ativas: esferas que o anel interno pressiona; Q_i, p_i máximos"
    ),
    both_ways=", ± nos dois sentidos",
    preload="Pré-carga",
    preload_at_rest="em repouso",
    preload_at_speed="em rotação",
    preload_lift="primeira esfera",
    ball_lifts_off="solta-se na carreira {row} com {factor} × a carga: {load}",
    ball_has_lifted_off="soltou-se na carreira {row}: foi com {factor} × a carga, {load}",
    preload_loss="perda",
    lifts_off="a carreira {row} se solta com {factor} × a carga: {load}",
    has_lifted_off="a carreira {row} se soltou: foi com {factor} × a carga, {load}",
    nothing_left="nenhuma esfera da carreira {rows} pressiona o anel interno",
    no_loss="não se achou carreira que perca todo o contato quando esta carga cresce",
    inner_ring="Anel interno",
    given="{name} dado",
    free="livre",
    held="fixo",
    stiffness="Rigidez",
    rosette="Distribuição de carga",
    rosettes="Distribuição de carga por carreira",
    rim="borda: Q_i = {load} N",
    seen_from="visto de +x",
    heaviest="Esfera mais carregada: nº {number}, a {azimuth}°",
    heaviest_in_row="Esfera mais carregada: nº {number}, carreira {row}, a {azimuth}°",
    inner="interno",
    outer="externo",
    contact_load="carga",
    contact_angle="ângulo de contato",
    approach="aproximação",
    max_pressure="pressão máxima",
    semi_major="semieixo maior",
    semi_minor="semieixo menor",
    max_shear="cisalhamento máximo",
    orthogonal_shear="cisalhamento ortogonal",
    at_depth="  à profundidade de",
    balls="Esferas",
    motion="Movimento das esferas",
    load_legend="Q carga, α ângulo de contato, p pressão máxima; i interno, o externo; ◂ maior",
    motion_legend=(
        "F_c força centrífuga, M_g momento giroscópico, n_m órbita, n_R esfera, s spin/rolamento"
    ),
    waiting="Resolvendo; se compila o código para esta máquina, uma só vez, leva cerca de 20 s …",
    interrupted="interrompido",
    demo_source="Este foi o caso {path}",
    demo_next="O que experimentar a seguir",
    demo_copy="uma cópia para modificar",
    demo_vary="o mesmo com esferas cerâmicas",
    demo_data="as esferas em tabela, e tudo em JSON",
    demo_written="{path} gravado; agora experimente: {command} solve {path}",
)

LANGUAGES: Final[Mapping[str, Words]] = {words.code: words for words in (ENGLISH, PORTUGUESE)}


def words_for(code: str | None = None, environment: Mapping[str, str] | None = None) -> Words:
    """Return a language by its code, or by the locale of the environment; else English."""
    if code is None:
        variables = os.environ if environment is None else environment
        code = next((variables[name] for name in _VARIABLES if variables.get(name)), "")
    return LANGUAGES.get(code[:2].lower(), ENGLISH)
