"""Braga and Almeida, relative motions: what is computed, part by part."""

from __future__ import annotations

from typing import Final

from rolamento_reproductions.braga_almeida.misprints import misprints_section
from rolamento_reproductions.braga_almeida.slip import inner_section, outer_section
from rolamento_reproductions.braga_almeida.speeds import GIVEN, orbit_section, speeds_section
from rolamento_reproductions.record import ERRATA_STEM, Part, Source
from rolamento_reproductions.text import said

SOURCE: Final = Source(
    name="braga-almeida",
    title=GIVEN.title,
    reference=said(
        "Braga and Almeida, conference paper: equations 19 to 50 on a solved bearing, and a page of"
        " misprints",
        "Braga e Almeida, artigo de congresso: equações 19 a 50 em um rolamento resolvido, e uma"
        " página de erros de impressão",
    ),
    remarks=(
        said(
            "The paper derives the motions of a ball between its races and has sketches only, no"
            " numbers. Here its equations, with their misprints put right, are shown on a bearing"
            " that this program solves. The figures are numbered by the sections of the paper.",
            "O artigo deduz os movimentos de uma esfera entre as pistas e só traz esquemas, nenhum"
            " número. Aqui suas equações, corrigidos os erros de impressão, são mostradas em um"
            " rolamento que este programa resolve. As figuras têm os números das seções do artigo.",
        ),
        said(
            "The bearing is the 218 of Radaelli (2013): {} balls of {:.2f} mm on a pitch diameter"
            " of {:.2f} mm, conformities {:.4f}, free contact angle {:.0f}°.",
            "O rolamento é o 218 de Radaelli (2013): {} esferas de {:.2f} mm em um diâmetro"
            " primitivo de {:.2f} mm, conformidades {:.4f}, ângulo de contato livre {:.0f}°.",
            *(
                GIVEN.inputs_of("bearing")[name]
                for name in (
                    "ball_count",
                    "ball_diameter_mm",
                    "pitch_diameter_mm",
                    "conformity",
                    "contact_angle_deg",
                )
            ),
        ),
    ),
    parts=(
        Part(
            said("Speeds of cage and balls", "Rotações da gaiola e das esferas"),
            ("figure-2.01", "figure-2.02", "table-2.1"),
            speeds_section,
        ),
        Part(
            said("Outer contact", "Contato externo"), ("figure-3.01", "figure-3.02"), outer_section
        ),
        Part(
            said("Inner contact", "Contato interno"),
            ("figure-4.01", "figure-4.02", "table-4.1"),
            inner_section,
        ),
        Part(
            said("Orbit", "Movimento orbital"),
            ("figure-5.01", "figure-5.02", "table-5.1"),
            orbit_section,
        ),
        Part(said("Misprints", "Erros de impressão"), (ERRATA_STEM,), misprints_section),
    ),
)
