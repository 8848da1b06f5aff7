"""Slip over both ellipses of a ball that only friction controls: figures 3.1, 3.2, 4.1, 4.2."""

from __future__ import annotations

import numpy as np

from rolamento.friction.slip import rolling_lines, slip_velocity
from rolamento.geometry import Race
from rolamento_reproductions.braga_almeida.inputs import GIVEN, said
from rolamento_reproductions.braga_almeida.speeds import Ball, ball
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
from rolamento_reproductions.text import Text, same

_RACES: dict[Race, Text] = {"outer": said("races.outer"), "inner": said("races.inner")}
_EQUATIONS: dict[Race, tuple[str, str, str]] = {
    "outer": ("32", "34", "3"),
    "inner": ("41", "42", "4"),
}
_ROUNDING = 1e-9
_STILL = 0.01
"""Fraction of the maximum slip in the contact: less counts as pure rolling."""
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
        Series("across", "mm", said("across_rolling_x_0"), across * patch.semi_major[0] / MILLI),
        Series("along", "mm", said("map.along"), along * patch.semi_minor[0] / MILLI),
        Series("rolling_slip", "m/s", said("map.rolling_slip"), rolling),
        Series("transverse_slip", "m/s", said("map.transverse_slip"), transverse),
        Series("slip", "m/s", said("map.slip"), np.hypot(rolling, transverse)),
    )
    maps = (
        Map("rolling_slip", said("map.rolling_slip.slip_along_rolling", first=first)),
        Map("transverse_slip", said("map.transverse_slip.slip_across_rolling", second=second)),
        Map(
            "slip",
            said("map.slip.both_size_and"),
            signed=False,
            arrows=("transverse_slip", "rolling_slip"),
        ),
    )
    return Figure(
        number=f"{chapter}.1",
        caption=said(
            "map.caption",
            inner_speed_rpm=given["inner_speed_rpm"],
            axial_load_kn=given["axial_load_kN"],
            races=_RACES[race],
            friction_coefficient=given["friction_coefficient"],
        ),
        source=GIVEN.source_of("contacts"),
        columns=columns,
        picture=Maps("across", "along", lines, maps),
        claims=(_between_the_lines(one),) if race == "outer" else (),
        notes=(
            said(
                "map.axes_are_not",
                semi_major=float(2.0 * patch.semi_major[0] / MILLI),
                semi_minor=float(2.0 * patch.semi_minor[0] / MILLI),
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
        said("between_the_lines.statement"),
        said(
            "between_the_lines.finding",
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
        Series("across", "mm", said("across_rolling_x_0"), across * patch.semi_major[0] / MILLI),
        Series("as_printed", "m/s", said("profile.as_printed"), printed),
        Series("with_spin", "m/s", said("profile.with_spin"), whole),
    )
    lines = (
        Line("with_spin", 0, said("profile.with_spin_term")),
        Line("as_printed", 1, said("profile.equation_as_printed", first=first)),
    )
    return Figure(
        number=f"{chapter}.2",
        caption=said("profile.caption", races=_RACES[race], first=first),
        source=GIVEN.source_of("contacts"),
        columns=columns,
        picture=Curves((Panel("across", said("profile.y_title"), "m/s", lines),)),
        claims=(_spin_part(race, printed, whole, given["inner_speed_rpm"]),),
    )


def _spin_part(race: Race, printed: Floats, whole: Floats, speed_rpm: float) -> Claim:
    left_out = float(np.abs(whole - printed).max())
    share = left_out / float(np.abs(whole).max())
    return Claim(
        said("spin_part.statement"),
        said("spin_part.finding", speed_rpm=speed_rpm, left_out=left_out, share=100.0 * share),
        share > 0.25,
        of_theory=True,
    )


# --- table ------------------------------------------------------------------


def _table() -> Table:
    given = GIVEN.inputs_of("contacts")
    dry, oiled = given["dry_friction_coefficient"], given["friction_coefficient"]
    balls = (ball("outer"), ball("friction", None, dry), ball("friction"))
    heads = (
        ("outer_control", said("table.outer_control")),
        ("friction_dry", said("table.friction_dry", dry=dry)),
        ("friction", said("table.friction", oiled=oiled)),
    )
    rows: list[tuple[Text, list[str]]] = [
        (same("β (°)"), [f"{np.degrees(one.attitude):.2f}" for one in balls]),
        (same("β′ (°)"), [f"{np.degrees(one.yaw) + 0.0:.2f}" for one in balls]),
    ]
    for race, words in _RACES.items():
        rows += _race_rows(race, words, balls)
    return Table(
        number="4.1",
        caption=said("table.caption"),
        source=GIVEN.source_of("contacts"),
        columns=(
            TableColumn("quantity", said("quantity"), tuple(name for name, _ in rows)),
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
        row(said("race_rows.v_y_in", words=words), [value[0] for value in middle], 3),
        row(said("race_rows.v_t_in", words=words), [value[1] for value in middle], 3),
        row(
            said("race_rows.rotation_rad_s", words=words, rotation=rotation),
            [-float(one.motion(race).spin[0]) for one in balls],
            1,
        ),
        row(
            said("race_rows.ball_over_ring", words=words, ratio=ratio),
            [one.ball_speed / speed for one, speed in zip(balls, ring, strict=True)],
            4,
        ),
        row(
            said("race_rows.rolling_radius_r", words=words),
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
        said("gyroscopic.statement"),
        said("gyroscopic.finding", much, little, before, after, *spins),
        gone,
    )


def _held(controlled: Ball) -> Claim:
    """Under outer control the rotation (36), corrected, is zero."""
    spin = float(controlled.motion("outer").spin[0])
    # as printed, the ring's part has the other sign
    part = (0.0 - controlled.orbit) * np.sin(controlled.patch("outer").contact_angle[0])
    return Claim(
        said("held.statement"),
        said("held.finding", part=abs(2.0 * float(part))),
        abs(spin) < _ROUNDING,
        of_theory=True,
    )
