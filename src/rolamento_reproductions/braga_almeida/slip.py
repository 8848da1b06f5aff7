"""Slip over both ellipses of a ball that only friction controls: figures 3.1, 3.2, 4.1, 4.2."""

from __future__ import annotations

import numpy as np

from rolamento.friction.slip import rolling_lines, slip_velocity
from rolamento.geometry import Race
from rolamento_reproductions.braga_almeida.speeds import GIVEN, Ball, ball
from rolamento_reproductions.given import MILLI
from rolamento_reproductions.record import (
    Claim,
    Curves,
    Figure,
    Floats,
    Line,
    Map,
    Maps,
    Panel,
    Section,
    Series,
    Table,
    TableColumn,
)
from rolamento_reproductions.text import Text, said, same

_RACES: dict[Race, Text] = {
    "outer": said("outer contact", "contato externo"),
    "inner": said("inner contact", "contato interno"),
}
_EQUATIONS: dict[Race, tuple[str, str, str]] = {
    "outer": ("32", "34", "3"),
    "inner": ("41", "42", "4"),
}
_ROUNDING = 1e-9
_STILL = 0.01
"""Of the maximum slip in the contact: less counts as pure rolling."""
_LITTLE_LEFT = 0.1
"""A part of a motion that counts as practically gone."""


def outer_section(title: Text) -> Section:
    """Compute figures 3.1 and 3.2."""
    return Section(title, (_map("outer"), _profile("outer")))


def inner_section(title: Text) -> Section:
    """Compute figures 4.1 and 4.2 and table 4.1."""
    return Section(title, (_map("inner"), _profile("inner"), _table()))


def _slip(one: Ball, race: Race, across: Floats, along: Floats) -> tuple[Floats, Floats]:
    """v_y and v_t at points x0/a, y0/b; m/s."""
    found = slip_velocity(one.patch(race), one.motion(race), across, along)
    return found.rolling[0], found.transverse[0]


def _map(race: Race) -> Figure:
    given = GIVEN.inputs_of("contacts")
    one, patch = ball("friction"), ball("friction").patch(race)
    lines, points = given["points_across"], given["points_along"]
    # closer together toward the ends, where the edge of the ellipse turns
    across = np.repeat(np.sin(np.linspace(-0.5 * np.pi, 0.5 * np.pi, lines)), points)
    along = np.tile(np.linspace(-1.0, 1.0, points), lines) * np.sqrt(
        np.maximum(1.0 - across**2, 0.0)
    )
    rolling, transverse = _slip(one, race, across, along)
    first, second, chapter = _EQUATIONS[race]
    columns = (
        Series(
            "across",
            "mm",
            said("Across rolling x_0", "Transversal ao rolamento x_0"),
            across * patch.semi_major[0] / MILLI,
        ),
        Series(
            "along",
            "mm",
            said("Along rolling y_0", "No rolamento y_0"),
            along * patch.semi_minor[0] / MILLI,
        ),
        Series("rolling_slip", "m/s", said("rolling slip", "no rolamento"), rolling),
        Series("transverse_slip", "m/s", said("transverse slip", "transversal"), transverse),
        Series("slip", "m/s", said("slip", "deslizamento"), np.hypot(rolling, transverse)),
    )
    maps = (
        Map(
            "rolling_slip",
            said(
                "Slip along rolling, equation {} corrected; dashed: none",
                "Deslizamento no rolamento, equação {} corrigida; tracejado: nulo",
                first,
            ),
        ),
        Map(
            "transverse_slip",
            said(
                "Slip across rolling, equation {} corrected",
                "Deslizamento transversal, equação {} corrigida",
                second,
            ),
        ),
        Map(
            "slip",
            said("Both: size, and direction", "Ambos: módulo e direção"),
            signed=False,
            arrows=("transverse_slip", "rolling_slip"),
        ),
    )
    return Figure(
        number=f"{chapter}.1",
        caption=said(
            "The 218 at {:,.0f} rpm under {:.0f} kN of thrust: how the race slips over the ball in"
            " the {}, friction alone deciding the ball's motion (μ = {:.2f}).",
            "218 a {:,.0f} rpm sob {:.0f} kN de carga axial: como a pista desliza sobre a esfera no"
            " {}, com o movimento da esfera decidido só pelo atrito (μ = {:.2f}).",
            given["inner_speed_rpm"],
            given["axial_load_kN"],
            _RACES[race],
            given["friction_coefficient"],
        ),
        source=GIVEN.source_of("contacts"),
        columns=columns,
        picture=Maps("across", "along", lines, maps),
        claims=(_between_the_lines(one),) if race == "outer" else (),
        notes=(
            said(
                "The axes are not to one scale: the ellipse is {:.2f} mm by {:.2f} mm.",
                "Os eixos não estão na mesma escala: a elipse mede {:.2f} mm por {:.2f} mm.",
                float(2.0 * patch.semi_major[0] / MILLI),
                float(2.0 * patch.semi_minor[0] / MILLI),
            ),
        ),
    )


def _between_the_lines(one: Ball) -> Claim:
    """Look at the slip along rolling between and on the two lines of the outer contact."""
    lines = rolling_lines(one.patch("outer"), one.motion("outer"))[0]
    between = np.linspace(lines[0], lines[1], 101)
    on = np.abs(_slip(one, "outer", lines, 0.0 * lines)[0]).max()
    inside = np.abs(_slip(one, "outer", between, 0.0 * between)[0]).max()
    everywhere = np.linspace(-1.0, 1.0, 201)
    most = np.abs(_slip(one, "outer", everywhere, 0.0 * everywhere)[0]).max()
    return Claim(
        said(
            "The point of the contact lies in a region of pure rolling between two lines.",
            "O ponto do contato encontra-se na região de puro rolamento entre duas linhas.",
        ),
        said(
            "Only on the two lines, at {:+.2f} a and {:+.2f} a, is there no slip along rolling"
            " (below {:.0e} m/s); between them it reaches {:.3f} m/s, {:.0f} % of the maximum.",
            "Só sobre as duas linhas, em {:+.2f} a e {:+.2f} a, não há deslizamento no sentido do"
            " rolamento (menos de {:.0e} m/s); entre elas chega a {:.3f} m/s, {:.0f} % do maior.",
            *(float(line) for line in lines),
            1e-9 if on < 1e-9 else float(on),
            float(inside),
            100.0 * float(inside / most),
        ),
        holds=bool(inside < _STILL * most),
        partly=bool(on < _ROUNDING),
    )


def _profile(race: Race) -> Figure:
    given = GIVEN.inputs_of("contacts")
    one = ball("friction")
    patch, motion = one.patch(race), one.motion(race)
    across = np.linspace(-1.0, 1.0, 201)
    whole = _slip(one, race, across, 0.0 * across)[0]
    printed = motion.drift[0] + motion.side * patch.rolling_radius(across) * motion.roll[0]
    first, _, chapter = _EQUATIONS[race]
    columns = (
        Series(
            "across",
            "mm",
            said("Across rolling x_0", "Transversal ao rolamento x_0"),
            across * patch.semi_major[0] / MILLI,
        ),
        Series("as_printed", "m/s", said("as printed", "como impressa"), printed),
        Series("with_spin", "m/s", said("with spin", "com rotação"), whole),
    )
    lines = (
        Line("with_spin", 0, said("with the spin term", "com o termo da rotação")),
        Line("as_printed", 1, said("equation {} as printed", "equação {} como impressa", first)),
    )
    return Figure(
        number=f"{chapter}.2",
        caption=said(
            "The same {}: slip along rolling on the major axis, with the spin term that equation {}"
            " leaves out, and without.",
            "O mesmo {}: deslizamento no sentido do rolamento sobre o eixo maior, com o termo da"
            " rotação que a equação {} omite, e sem ele.",
            _RACES[race],
            first,
        ),
        source=GIVEN.source_of("contacts"),
        columns=columns,
        picture=Curves(
            (
                Panel(
                    "across",
                    said("Slip along rolling v_y", "Deslizamento no rolamento v_y"),
                    "m/s",
                    lines,
                ),
            )
        ),
        claims=(_spin_part(race, printed, whole, given["inner_speed_rpm"]),),
    )


def _spin_part(race: Race, printed: Floats, whole: Floats, speed_rpm: float) -> Claim:
    left_out = float(np.abs(whole - printed).max())
    share = left_out / float(np.abs(whole).max())
    return Claim(
        said(
            "Away from the middle of the ellipse, spin is a large part of the slip along rolling.",
            "Fora do centro da elipse, a rotação é grande parte do deslizamento no rolamento.",
        ),
        said(
            "At {:,.0f} rpm what is left out reaches {:.2f} m/s, {:.0f} % of the maximum slip.",
            "A {:,.0f} rpm o que se omite chega a {:.2f} m/s, {:.0f} % do maior deslizamento.",
            speed_rpm,
            left_out,
            100.0 * share,
        ),
        share > 0.25,
        of_theory=True,
    )


# --- table ------------------------------------------------------------------


def _table() -> Table:
    given = GIVEN.inputs_of("contacts")
    dry, oiled = given["dry_friction_coefficient"], given["friction_coefficient"]
    balls = (ball("outer"), ball("friction", None, dry), ball("friction"))
    heads = (
        ("outer_control", said("outer control", "controle externo")),
        ("friction_dry", said("friction, μ = {:.2f}", "atrito, μ = {:.2f}", dry)),
        ("friction", said("friction, μ = {:.2f}", "atrito, μ = {:.2f}", oiled)),
    )
    rows: list[tuple[Text, list[str]]] = [
        (same("β (°)"), [f"{np.degrees(one.attitude):.2f}" for one in balls]),
        (same("β′ (°)"), [f"{np.degrees(one.yaw) + 0.0:.2f}" for one in balls]),
    ]
    for race, words in _RACES.items():
        rows += _race_rows(race, words, balls)
    return Table(
        number="4.1",
        caption=said(
            "The 218 as in figures 3.1 and 4.1: motions at both contacts. Rotation about the normal"
            " out of the ball.",
            "218 como nas figuras 3.1 e 4.1: movimentos nos dois contatos. Rotação em torno da"
            " normal para fora da esfera.",
        ),
        source=GIVEN.source_of("contacts"),
        columns=(
            TableColumn("quantity", said("Quantity", "Grandeza"), tuple(name for name, _ in rows)),
            *(
                TableColumn(name, title, tuple(values[place] for _, values in rows))
                for place, (name, title) in enumerate(heads)
            ),
        ),
        claims=(_gyroscopic(balls[1], balls[2], dry, oiled), _held(balls[0])),
    )


def _race_rows(race: Race, words: Text, balls: tuple[Ball, ...]) -> list[tuple[Text, list[str]]]:
    rotation, ratio = ("36", "38") if race == "outer" else ("44", "45")

    def row(title: Text, values: list[float], digits: int) -> tuple[Text, list[str]]:
        zero = 0.5 * 10.0**-digits
        return title, [f"{0.0 if abs(v) < zero else v:.{digits}f}" for v in values]

    middle = [[float(v[0]) for v in _slip(one, race, np.zeros(1), np.zeros(1))] for one in balls]
    ring = [(one.speed if race == "inner" else 0.0) - one.orbit for one in balls]
    return [
        row(
            said("{}: v_y in the middle (m/s)", "{}: v_y no centro (m/s)", words),
            [value[0] for value in middle],
            3,
        ),
        row(
            said("{}: v_t in the middle (m/s)", "{}: v_t no centro (m/s)", words),
            [value[1] for value in middle],
            3,
        ),
        row(
            said("{}: rotation ({}) (rad/s)", "{}: rotação ({}) (rad/s)", words, rotation),
            [-float(one.motion(race).spin[0]) for one in balls],
            1,
        ),
        row(
            said("{}: ball over ring speed ({})", "{}: esfera sobre anel ({})", words, ratio),
            [one.ball_speed / speed for one, speed in zip(balls, ring, strict=True)],
            4,
        ),
        row(
            said("{}: rolling radius r′ (mm)", "{}: raio de rolamento r′ (mm)", words),
            [one.rolling_radius(race) / MILLI for one in balls],
            4,
        ),
    ]


def _gyroscopic(dry: Ball, oiled: Ball, much: float, little: float) -> Claim:
    """Compare transverse and rotational motion at two coefficients of friction."""
    before, after = (abs(float(np.degrees(one.yaw))) for one in (dry, oiled))
    spins = [abs(float(one.motion("inner").spin[0])) for one in (dry, oiled)]
    gone = after < _LITTLE_LEFT * before and spins[1] < _LITTLE_LEFT * spins[0]
    return Claim(
        said(
            "With efficient lubrication the gyroscopic effects, transverse and rotational,"
            " practically disappear.",
            "Com lubrificação eficiente os efeitos giroscópicos, transversal e rotacional,"
            " praticamente desaparecem.",
        ),
        said(
            "With Coulomb's law and μ from {:.2f} to {:.2f} the ball's axis swings further out of"
            " the axial plane, |β′| from {:.2f}° to {:.2f}°: the gyroscopic moment is one of"
            " inertia, and friction is what holds it. The rotation at the inner contact changes"
            " from {:,.0f} to {:,.0f} rad/s only: the contact angles ask for it.",
            "Com a lei de Coulomb e μ de {:.2f} para {:.2f} o eixo da esfera sai mais do plano"
            " axial, |β′| de {:.2f}° para {:.2f}°: o momento giroscópico é de inércia, e é o atrito"
            " que o equilibra. A rotação no contato interno só muda de {:,.0f} para {:,.0f} rad/s:"
            " os ângulos de contato a exigem.",
            much,
            little,
            before,
            after,
            *spins,
        ),
        gone,
    )


def _held(controlled: Ball) -> Claim:
    """Under outer control the rotation (36), corrected, is zero."""
    spin = float(controlled.motion("outer").spin[0])
    # as printed, the ring's part has the other sign
    part = (0.0 - controlled.orbit) * np.sin(controlled.patch("outer").contact_angle[0])
    return Claim(
        said(
            "Under outer raceway control the rotation at the outer contact is zero.",
            "Com controle pela pista externa a rotação no contato externo é nula.",
        ),
        said(
            "By (36) corrected it is (below 10⁻⁹ rad/s); as printed it would be {:.0f} rad/s.",
            "Por (36) corrigida é (menos de 10⁻⁹ rad/s); como impressa seria {:.0f} rad/s.",
            abs(2.0 * float(part)),
        ),
        abs(spin) < _ROUNDING,
        of_theory=True,
    )
