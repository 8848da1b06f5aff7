"""Ricci and Fleury, friction in ball bearings: what is computed, part by part."""

from __future__ import annotations

from typing import Final

from rolamento_reproductions.record import ERRATA_STEM, Part, Source
from rolamento_reproductions.ricci_fleury.misprints import misprints_section
from rolamento_reproductions.ricci_fleury.spin import GIVEN, spin_section
from rolamento_reproductions.ricci_fleury.torque import torque_section
from rolamento_reproductions.text import said

SOURCE: Final = Source(
    name="ricci-fleury",
    title=GIVEN.title,
    reference=said(
        "Ricci and Fleury, conference paper: figures 8 and 9, and a page of misprints",
        "Ricci e Fleury, artigo de congresso: figuras 8 e 9, e uma página de erros de impressão",
    ),
    remarks=(
        said(
            "Every figure and number here is computed by this program; nothing is read off the"
            " printed figures, of which only captions and text were at hand. What the text says is"
            " checked beside the figure, and so is what theory lets expect of the models.",
            "Todas as figuras e números aqui são calculados por este programa; nada foi lido das"
            " figuras impressas, das quais só se tinham as legendas e o texto. O que o texto diz é"
            " verificado ao lado da figura, assim como o que a teoria permite esperar dos modelos.",
        ),
        said(
            "The bearing: {:.0f} mm bore, {:.0f} mm outside diameter, three balls of {:.2f} mm,"
            " conformities {:.3f}, free contact angle {:.1f}°; steel. Under load the contact angle"
            " rises, and all models here follow it.",
            "O rolamento: furo de {:.0f} mm, diâmetro externo de {:.0f} mm, três esferas de"
            " {:.2f} mm, conformidades {:.3f}, ângulo de contato livre {:.1f}°; aço. Sob carga o"
            " ângulo de contato aumenta, e todos os modelos aqui o acompanham.",
            *(
                GIVEN.inputs_of("bearing")[name]
                for name in (
                    "bore_mm",
                    "outside_mm",
                    "ball_diameter_mm",
                    "conformity",
                    "contact_angle_deg",
                )
            ),
        ),
    ),
    parts=(
        Part(
            said("Torque at low speed", "Torque em baixa velocidade"),
            ("figure-08", "table-8"),
            torque_section,
        ),
        Part(
            said("Spin and roll at speed", "Pivotamento e rolamento em rotação"),
            ("figure-09",),
            spin_section,
        ),
        Part(said("Misprints", "Erros de impressão"), (ERRATA_STEM,), misprints_section),
    ),
)
