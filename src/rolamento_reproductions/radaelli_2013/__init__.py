"""Radaelli (2013), chapter 5 and appendix C: what is computed, part by part."""

from __future__ import annotations

from typing import Final

from rolamento_reproductions.radaelli_2013.at_rest import motion_section, static_section
from rolamento_reproductions.radaelli_2013.at_speed import axial_section, shift_section
from rolamento_reproductions.radaelli_2013.combined import (
    combined_section,
    three_loads_section,
    tilt_section,
)
from rolamento_reproductions.radaelli_2013.inputs import GIVEN, modulus
from rolamento_reproductions.radaelli_2013.tables import examples_section, radial_section
from rolamento_reproductions.record import Part, Source
from rolamento_reproductions.text import said

_FIGURES: Final = tuple(f"figure-5.{number:02d}" for number in range(33))


SOURCE: Final = Source(
    name="radaelli-2013",
    title=GIVEN.title,
    reference=said(
        "Radaelli (2013), master's dissertation: figures 5.1 to 5.32, tables 5.3, 5.4, C.1, C.2",
        "Radaelli (2013), dissertação de mestrado: figuras 5.1 a 5.32, tabelas 5.3, 5.4, C.1, C.2",
    ),
    remarks=(
        said(
            "Every figure and number here is computed by this program; nothing is read off the"
            " printed figures, of which only captions and text were at hand. What the text says"
            " about a figure is checked beside it.",
            "Todas as figuras e números aqui são calculados por este programa; nada foi lido das"
            " figuras impressas, das quais só se tinham as legendas e o texto. O que o texto diz de"
            " uma figura é verificado ao lado dela.",
        ),
        said(
            "Throughout: outer raceway control, contact stiffness at the loaded contact angles,"
            " Young's modulus {:.3f} GPa, which is what the printed stiffness constant 2.15·10⁵"
            " stands for at a Poisson's ratio of 0.3, and a gyroscopic moment that carries its"
            " sign.",
            "Em toda parte: pista externa de controle, rigidez do contato nos ângulos de contato"
            " sob carga, módulo de elasticidade {:.3f} GPa, que é o que a constante de rigidez"
            " impressa 2,15·10⁵ representa com coeficiente de Poisson 0,3, e momento giroscópico"
            " com sinal.",
            modulus() / 1e9,
        ),
        said(
            "Table 5.2 gives the 218 both a contact angle of 40° and a clearance of zero. The two"
            " exclude each other; the angle is what the results rest on. The text calls F_c the"
            " centripetal force; on the ball it acts outward.",
            "A tabela 5.2 dá ao 218 um ângulo de contato de 40° e folga nula. Um exclui o outro; é"
            " no ângulo que os resultados se baseiam. O texto chama F_c de força centrípeta; sobre"
            " a esfera ela atua para fora.",
        ),
    ),
    parts=(
        Part(said("At rest", "Em repouso"), _FIGURES[1:6], static_section),
        Part(
            said("Speeds, and forces from them", "Velocidades e forças delas decorrentes"),
            _FIGURES[6:10],
            motion_section,
        ),
        Part(
            said("Radial load at speed", "Carga radial em rotação"),
            ("figure-5.10", "table-5.3"),
            radial_section,
        ),
        Part(
            said("Axial load at several speeds", "Carga axial em várias rotações"),
            _FIGURES[11:15],
            axial_section,
        ),
        Part(
            said(
                "Combined load, and which effects matter", "Carga combinada e quais efeitos pesam"
            ),
            _FIGURES[15:21],
            combined_section,
        ),
        Part(
            said("Loads along three axes", "Cargas nos três eixos"),
            _FIGURES[21:25],
            three_loads_section,
        ),
        Part(said("Radial displacement", "Deslocamento radial"), _FIGURES[25:27], shift_section),
        Part(
            said("Tilted inner ring", "Anel interno desalinhado"),
            (*_FIGURES[27:33], "table-5.4"),
            tilt_section,
        ),
        Part(
            said("Examples of Harris (1991)", "Exemplos de Harris (1991)"),
            ("table-C.1", "table-C.2"),
            examples_section,
        ),
    ),
)
