"""The page of Braga and Almeida's misprints."""

from __future__ import annotations

from rolamento_reproductions.braga_almeida.attitudes import COUNT
from rolamento_reproductions.braga_almeida.contacts import contact_misprints, contact_sound
from rolamento_reproductions.braga_almeida.orbit import (
    modulation_misprint,
    orbit_misprint,
    orbit_sound,
    radaelli_misprint,
)
from rolamento_reproductions.record import Errata, Section
from rolamento_reproductions.text import Text, said

__all__ = ["misprints_section"]


def misprints_section(title: Text) -> Section:
    """Derive the misprints and prove them."""
    found = (*contact_misprints(), orbit_misprint(), modulation_misprint(), radaelli_misprint())
    sound = sorted((*orbit_sound(), *contact_sound()), key=lambda one: int(one.number))
    errata = Errata(
        caption=said(
            "Equations of Braga and Almeida that do not hold as printed, each with what it should"
            " be and why, with one of Radaelli (2013) on the same attitude; and those that were"
            " checked and hold.",
            "Equações de Braga e Almeida que não valem como impressas, cada uma com a forma correta"
            " e o motivo, com uma de Radaelli (2013) sobre a mesma posição; e as que foram"
            " verificadas e valem.",
        ),
        source=said("equations 19 to 50 of the paper", "equações 19 a 50 do artigo"),
        remarks=_REMARKS,
        misprints=found,
        valid=tuple(sound),
        attitudes=COUNT,
    )
    return Section(title, (errata,))


_REMARKS = (
    said(
        "Axes as in the paper: x along the shaft, z radial, y = z × x; the outer contact lies on"
        " the −x side of the ball. The common tangent at a contact is t = (cos θ, 0, sin θ), the"
        " normals out of the ball n_e = (−sin θ_e, 0, cos θ_e) and n_i = (sin θ_i, 0, −cos θ_i)."
        " Speeds are seen from the cage.",
        "Eixos como no artigo: x ao longo do eixo, z radial, y = z × x; o contato externo fica do"
        " lado −x da esfera. A tangente comum em um contato é t = (cos θ, 0, sen θ); as normais"
        " para fora da esfera, n_e = (−sen θ_e, 0, cos θ_e) e n_i = (sen θ_i, 0, −cos θ_i)."
        " Velocidades vistas da gaiola.",
    ),
    said(
        "A point of a contact lies at p = x_0 t + y_0 y + ρ n from the ball's centre, with the"
        " braces of (28), ρ = (R² − x_0²)^½ − (R² − a²)^½ + (D²/4 − a²)^½. The race moves at"
        " ω_r x × (d_m/2 z + p), the ball at ω × p; slip is the first less the second.",
        "Um ponto do contato fica em p = x_0 t + y_0 y + ρ n a partir do centro da esfera, com as"
        " chaves de (28), ρ = (R² − x_0²)^½ − (R² − a²)^½ + (D²/4 − a²)^½. A pista move-se a"
        " ω_r x × (d_m/2 z + p), a esfera a ω × p; o deslizamento é a primeira menos a segunda.",
    ),
    said(
        "The attitudes: balls of 3 to 40 mm, pitch diameters of 3 to 12 of these, contact angles"
        " from 6° to 80° of either race, any direction of the ball's axis, ring speeds of 50 to"
        " 800 rad/s, points anywhere in ellipses of up to 0.3 D.",
        "As posições: esferas de 3 a 40 mm, diâmetros primitivos de 3 a 12 vezes isso, ângulos de"
        " contato de 6° a 80° em cada pista, eixo da esfera em qualquer direção, rotações dos anéis"
        " de 50 a 800 rad/s, pontos em qualquer lugar de elipses de até 0,3 D.",
    ),
    said(
        "Before (36) and (44) the paper says it puts in relations (24) and (26); it does (25) and"
        " (27), and likewise before (32).",
        "Antes de (36) e (44) o artigo diz substituir as relações (24) e (26); substitui (25) e"
        " (27), e o mesmo antes de (32).",
    ),
)
