"""Figures 5.15 to 5.24: the 218 under combined load, effects left out, and the balls turned."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from rolamento.case.duty import Duty, Load
from rolamento.case.model import Model
from rolamento_reproductions.radaelli_2013.balls import Round, figure_pair, solved_round
from rolamento_reproductions.radaelli_2013.inputs import KILO, RPM, case, inputs_of, source_of
from rolamento_reproductions.record import Claim, Figure, Section
from rolamento_reproductions.text import Text, said

__all__ = ["combined_section", "three_loads_section"]

_ALIKE_LOAD, _ALIKE_ANGLE = 0.10, 5.0
"""Differences that still read as alike: a part of the greatest load, and degrees."""
_NEAR_ZERO = 5.0  # degrees
_NEARLY_EQUAL = 0.05  # of the greatest load
_NEAR_DIRECTION = 3.0  # degrees


# --- figures 5.15 to 5.20 ---------------------------------------------------


def combined_section(title: Text) -> Section:
    """Compute figures 5.15 to 5.20."""
    given = inputs_of("combined")
    whole = _solved(given)
    still = _solved(given, model=Model(gyroscopic_moment=False))
    light = _solved(given, model=Model(centrifugal_force=False))
    source = source_of("combined")
    figures = (
        *figure_pair(("5.15", "5.16"), _named(given), source, whole),
        *figure_pair(
            ("5.17", "5.18"),
            _named(given, said("; no gyroscopic moment", "; sem momento giroscópico")),
            source,
            still,
        ),
        *figure_pair(
            ("5.19", "5.20"),
            _named(given, said("; no centrifugal force", "; sem força centrífuga")),
            source,
            light,
        ),
    )
    claims = (
        (_who_carries(whole),),
        (_opposite_angles(whole),),
        (_alike_loads(whole, still),),
        (_alike_angles(whole, still),),
        (_equal_inside_and_outside(whole, light),),
        (_greater_effect(whole, still, light),),
    )
    notes: dict[str, Text] = {"5.17": _displacements(whole, still), "5.19": _lightest(light)}
    return Section(title, _completed(figures, claims, notes))


def _solved(given: dict[str, Any], *, model: Model | None = None, first_ball: float = 0.0) -> Round:
    load = Load(
        fx=given["axial_load_kN"] * KILO,
        fz=given["radial_load_kN"] * KILO,
        fy=given.get("lateral_load_kN", 0.0) * KILO,
    )
    duty = Duty(
        inner_speed=given["inner_speed_rpm"] * RPM,
        first_ball_azimuth=np.radians(first_ball),
        load=load,
    )
    return solved_round(case(duty, model))


def _named(given: dict[str, Any], extra: Text | None = None) -> Text:
    return said(
        "The 218 at {:,.0f} rpm: F_a = {:.0f} kN, F_z = {:.0f} kN{}.",
        "218 a {:,.0f} rpm: F_a = {:.0f} kN, F_z = {:.0f} kN{}.",
        given["inner_speed_rpm"],
        given["axial_load_kN"],
        given["radial_load_kN"],
        extra or said("", ""),
    )


def _completed(
    figures: tuple[Figure, ...],
    claims: tuple[tuple[Claim, ...], ...],
    notes: dict[str, Text],
) -> tuple[Figure, ...]:
    """Put the statements beside their figures."""
    return tuple(
        replace(
            figure,
            claims=stated,
            notes=(notes[figure.number],) if figure.number in notes else (),
        )
        for figure, stated in zip(figures, claims, strict=True)
    )


def _who_carries(whole: Round) -> Claim:
    """Tell what part of the radial load the balls within ±45° carry."""
    balls = whole.placed
    force = whole.inner_load * np.cos(np.radians(whole.inner_angle))
    radial = (force * np.cos(np.radians(whole.azimuth)))[balls]
    near = np.abs(whole.azimuth[balls]) <= 45.0 + 1e-6
    share = float(radial[near].sum() / radial.sum())
    opposite = _at_azimuth(whole, 180.0)
    return Claim(
        said(
            "The balls near ψ = 0 carry the radial load; those opposite bear little more than"
            " their own centrifugal force and gyroscopic moment.",
            "As esferas próximas de ψ = 0 suportam a carga radial; as opostas, pouco mais que a"
            " própria força centrífuga e o momento giroscópico.",
        ),
        said(
            "The five balls within ±45° carry {:.0f} % of it. At 180° Q_i is {:,.0f} N and Q_o"
            " {:,.0f} N.",
            "As cinco esferas dentro de ±45° suportam {:.0f} % dela. Em 180°, Q_i é {:,.0f} N e"
            " Q_o {:,.0f} N.",
            100.0 * share,
            whole.inner_load[opposite],
            whole.outer_load[opposite],
        ),
        share > 0.8 and float(whole.inner_load[opposite] / whole.inner_load.max()) < 0.05,
    )


def _opposite_angles(whole: Round) -> Claim:
    opposite = _at_azimuth(whole, 180.0)
    inner, outer = whole.inner_angle[opposite], whole.outer_angle[opposite]
    return Claim(
        said(
            "On the balls opposite the load the inner angle becomes large and the outer angle"
            " nearly zero.",
            "Nas esferas opostas à carga o ângulo interno torna-se grande e o externo quase nulo.",
        ),
        said(
            "At 180°: α_i = {:.1f}°, α_o = {:.1f}°.",
            "Em 180°: α_i = {:.1f}°, α_o = {:.1f}°.",
            inner,
            outer,
        ),
        bool(outer < _NEAR_ZERO < 60.0 < inner),
    )


def _alike_loads(whole: Round, still: Round) -> Claim:
    difference, greatest = _load_difference(whole, still), float(whole.outer_load.max())
    return Claim(
        said(
            "Without the gyroscopic moment the loads are much as with it.",
            "Sem o momento giroscópico as cargas são muito parecidas.",
        ),
        said(
            "They differ from figure 5.15 by at most {:,.0f} N, {:.1f} % of the greatest load.",
            "Diferem da figura 5.15 em no máximo {:,.0f} N, {:.1f} % da maior carga.",
            difference,
            100.0 * difference / greatest,
        ),
        difference < _ALIKE_LOAD * greatest,
    )


def _alike_angles(whole: Round, still: Round) -> Claim:
    difference = _angle_difference(whole, still)
    return Claim(
        said(
            "Without the gyroscopic moment the angles are much as with it.",
            "Sem o momento giroscópico os ângulos são muito parecidos.",
        ),
        said(
            "They differ from figure 5.16 by at most {:.1f}°.",
            "Diferem da figura 5.16 em no máximo {:.1f}°.",
            difference,
        ),
        difference < _ALIKE_ANGLE,
    )


def _equal_inside_and_outside(whole: Round, light: Round) -> Claim:
    def apart(found: Round) -> float:
        return float(np.abs(found.outer_load - found.inner_load)[found.placed].max())

    greatest = float(light.outer_load.max())
    return Claim(
        said(
            "Without the centrifugal force the loads at the inner and outer race are nearly equal.",
            "Sem a força centrífuga as cargas nas pistas interna e externa são praticamente"
            " iguais.",
        ),
        said(
            "They are at most {:,.0f} N apart, {:.1f} % of the greatest load; with it, up to"
            " {:,.0f} N.",
            "A diferença é de no máximo {:,.0f} N, {:.1f} % da maior carga; com ela, até"
            " {:,.0f} N.",
            apart(light),
            100.0 * apart(light) / greatest,
            apart(whole),
        ),
        apart(light) < _NEARLY_EQUAL * greatest < apart(whole),
    )


def _greater_effect(whole: Round, still: Round, light: Round) -> Claim:
    moment, force = _angle_difference(whole, still), _angle_difference(whole, light)
    return Claim(
        said(
            "The centrifugal force, not the gyroscopic moment, makes most of the difference.",
            "É a força centrífuga, e não o momento giroscópico, que faz a maior diferença.",
        ),
        said(
            "Leaving out the force changes the angles by up to {:.1f}°, leaving out the moment by"
            " up to {:.1f}°; the loads by up to {:,.0f} N and {:,.0f} N.",
            "Desprezar a força muda os ângulos em até {:.1f}°; desprezar o momento, em até"
            " {:.1f}°; as cargas, em até {:,.0f} N e {:,.0f} N.",
            force,
            moment,
            _load_difference(whole, light),
            _load_difference(whole, still),
        ),
        force > 2.0 * moment,
    )


def _displacements(whole: Round, still: Round) -> Text:
    return said(
        "The ring feels the moment more than the loads show: δ_a is {:.4f} mm with it and {:.4f} mm"
        " without, δ_z {:.4f} and {:.4f} mm.",
        "O anel sente o momento mais do que as cargas mostram: δ_a é {:.4f} mm com ele e {:.4f} mm"
        " sem ele; δ_z, {:.4f} e {:.4f} mm.",
        whole.shift[0],
        still.shift[0],
        whole.shift[2],
        still.shift[2],
    )


def _lightest(light: Round) -> Text:
    opposite = _at_azimuth(light, 180.0)
    return said(
        "On the lightly loaded balls the gyroscopic moment still keeps them apart: at 180° Q_i ="
        " {:.0f} N, Q_o = {:.0f} N.",
        "Nas esferas pouco carregadas o momento giroscópico ainda as separa: em 180°, Q_i ="
        " {:.0f} N, Q_o = {:.0f} N.",
        light.inner_load[opposite],
        light.outer_load[opposite],
    )


def _at_azimuth(found: Round, azimuth: float) -> int:
    """Return the row of the ball at an azimuth."""
    off = np.where(found.placed, np.abs(found.azimuth - azimuth), np.inf)
    return int(np.argmin(off))


def _load_difference(one: Round, other: Round) -> float:
    inner = np.abs(one.inner_load - other.inner_load)
    return float(np.maximum(inner, np.abs(one.outer_load - other.outer_load))[one.placed].max())


def _angle_difference(one: Round, other: Round) -> float:
    inner = np.abs(one.inner_angle - other.inner_angle)
    return float(np.maximum(inner, np.abs(one.outer_angle - other.outer_angle))[one.placed].max())


# --- figures 5.21 to 5.24 ---------------------------------------------------


def three_loads_section(title: Text) -> Section:
    """Compute figures 5.21 to 5.24."""
    given = inputs_of("three_loads")
    found = [_solved(given, first_ball=value) for value in given["first_ball_deg"]]
    figures: list[Figure] = []
    for numbers, one, first in zip(
        (("5.21", "5.22"), ("5.23", "5.24")), found, given["first_ball_deg"], strict=True
    ):
        extra = said(
            ", F_y = {:.0f} kN; first ball at {:.0f}°",
            ", F_y = {:.0f} kN; primeira esfera em {:.0f}°",
            given["lateral_load_kN"],
            first,
        )
        figures.extend(figure_pair(numbers, _named(given, extra), source_of("three_loads"), one))
    direction = float(np.degrees(np.arctan2(given["lateral_load_kN"], given["radial_load_kN"])))
    claims = (
        (_turned_loads(found[0], direction),),
        (_turned_angles(found[0], direction),),
        (_moved_loads(found[0], found[1]),),
        (_moved_angles(found[0], found[1]),),
    )
    return Section(title, _completed(tuple(figures), claims, {"5.23": _moved_ring(*found)}))


def _turned_loads(found: Round, direction: float) -> Claim:
    peak = float(found.azimuth[np.argmax(found.inner_load)])
    return Claim(
        said(
            "The trends are those of figure 5.15, turned to the direction of the radial load,"
            " {:.1f}°.",
            "As tendências são as da figura 5.15, giradas para a direção da carga radial, {:.1f}°.",
            direction,
        ),
        said("Q_i is greatest at {:.1f}°.", "Q_i é máxima em {:.1f}°.", peak),
        abs(peak - direction) < _NEAR_DIRECTION,
    )


def _turned_angles(found: Round, direction: float) -> Claim:
    peak = float(found.azimuth[np.argmax(found.inner_angle)])
    opposite = direction - 180.0
    return Claim(
        said(
            "The trends are those of figure 5.16, turned likewise.",
            "As tendências são as da figura 5.16, giradas do mesmo modo.",
        ),
        said(
            "α_i is greatest at {:.1f}°, opposite the load at {:.1f}°.",
            "α_i é máximo em {:.1f}°, oposto à carga em {:.1f}°.",
            peak,
            opposite,
        ),
        abs(peak - opposite) < _NEAR_DIRECTION,
    )


def _moved_loads(still: Round, moved: Round) -> Claim:
    balls = [found.inner_load[found.placed] for found in (still, moved)]
    heaviest = [float(loads.max()) for loads in balls]
    change = _by_ball(still, moved, still.inner_load, moved.inner_load)
    return Claim(
        said(
            "The place of the first ball changes the load of every ball, so that the balance has"
            " to be found anew at every instant.",
            "A posição da primeira esfera muda a carga de cada esfera, de modo que o equilíbrio"
            " precisa ser recalculado a cada instante.",
        ),
        said(
            "Ball by ball Q_i changes by up to {:,.0f} N; the heaviest ball carries {:,.0f} N"
            " instead of {:,.0f} N.",
            "Esfera por esfera, Q_i muda em até {:,.0f} N; a esfera mais carregada suporta"
            " {:,.0f} N em vez de {:,.0f} N.",
            change,
            heaviest[1],
            heaviest[0],
        ),
        change > 0.01 * heaviest[0],
    )


def _moved_angles(still: Round, moved: Round) -> Claim:
    change = _by_ball(still, moved, still.inner_angle, moved.inner_angle)
    return Claim(
        said(
            "So does the contact angle of every ball.",
            "O mesmo vale para o ângulo de contato de cada esfera.",
        ),
        said(
            "Ball by ball α_i changes by up to {:.1f}°.",
            "Esfera por esfera, α_i muda em até {:.1f}°.",
            change,
        ),
        change > 1.0,
    )


def _moved_ring(still: Round, moved: Round) -> Text:
    """Tell how little the ring itself notices."""
    return said(
        "The ring itself hardly moves as the balls pass: δ_z is {:.5f} mm and {:.5f} mm, δ_y"
        " {:.5f} mm and {:.5f} mm. What changes is where on the same curve the balls stand.",
        "O próprio anel quase não se move com a passagem das esferas: δ_z é {:.5f} mm e {:.5f} mm;"
        " δ_y, {:.5f} mm e {:.5f} mm. O que muda é a posição das esferas sobre a mesma curva.",
        still.shift[2],
        moved.shift[2],
        still.shift[1],
        moved.shift[1],
    )


def _by_ball(one: Round, other: Round, values: np.ndarray, others: np.ndarray) -> float:
    """Greatest difference between balls of one number."""
    first = values[one.placed][np.argsort(one.ball[one.placed])]
    second = others[other.placed][np.argsort(other.ball[other.placed])]
    return float(np.abs(first - second).max())
