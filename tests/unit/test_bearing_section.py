"""A bearing in section: what is drawn is to scale, and is what the case says."""

from __future__ import annotations

from math import atan2, degrees
from typing import Any

import pytest

from rolamento import solve
from rolamento.case import Case
from rolamento.plots.bearing_section import SectionDrawing, draw_section, section_drawing
from rolamento.web.section import section_svg

DUTY: dict[str, Any] = {"inner_speed": "1480 rpm", "load": {"fx": "2 kN", "fz": "5 kN"}}
RADIAL: dict[str, Any] = {"inner_speed": "1480 rpm", "load": {"fz": "5 kN"}}


def drawn(designation: str, duty: dict[str, Any] = DUTY, **more: Any) -> SectionDrawing:
    case = Case.from_mapping({"bearing": {"designation": designation}, "duty": duty, **more})
    return section_drawing(case, solve(case))


def of(drawing: SectionDrawing, kind: str) -> list[Any]:
    return [one.points for one in drawing.outlines if one.kind == kind]


def spans(points: Any, axis: int) -> tuple[float, float]:
    values = [point[axis] for point in points]
    return min(values), max(values)


def test_rings_and_balls_have_their_sizes() -> None:
    drawing = drawn("6310")
    rings = of(drawing, "ring")
    assert max(spans(one, 1)[1] for one in rings) == pytest.approx(55e-3)
    assert min(abs(y) for one in rings for _, y in one) == pytest.approx(25e-3)
    assert spans(rings[0], 0) == pytest.approx((-13.5e-3, 13.5e-3))
    balls = of(drawing, "loaded") + of(drawing, "element")
    assert len(balls) == 2
    low, high = spans(balls[0], 0)
    assert high - low == pytest.approx(19.05e-3, rel=1e-2)


def test_a_pair_shows_its_arrangement_by_where_its_lines_meet_the_axis() -> None:
    apart = {}
    for arrangement in ("DB", "DF"):
        bearing = {"designation": "7014 C", "arrangement": arrangement, "spacing": "30 mm"}
        case = Case.from_mapping({"bearing": bearing, "duty": RADIAL})
        lines = of(section_drawing(case), "contact")
        apexes = sorted({round(points[0][0], 9) for points in lines})
        apart[arrangement] = apexes[-1] - apexes[0]
    assert apart["DB"] > 30e-3 > apart["DF"]


def test_the_line_of_contact_has_the_angle_under_load() -> None:
    case = Case.from_mapping({"bearing": {"designation": "7210 B"}, "duty": DUTY})
    solved = solve(case)
    (x, y), (u, v) = next(iter(of(section_drawing(case, solved), "loaded-contact")))[1:]
    top = int(abs(solved.elements.azimuth[0]).argmin())
    assert degrees(atan2(u - x, v - y)) == pytest.approx(
        degrees(solved.outer.contact_angle[0, top])
    )


def test_loads_and_speed_are_drawn() -> None:
    drawing = drawn("6310", mounting={"shaft_tolerance": "k5", "housing_tolerance": "H6"})
    texts = [one.text for one in drawing.labels]
    assert {"Fz 5 kN", "Fx 2 kN", "1480 rpm", "⌀110 H6", "⌀50 k5"} <= set(texts)
    upward = next(one for one in drawing.arrows if one.kind == "load").points
    assert upward[1][1] > upward[0][1]
    downward = drawn("6310", {**RADIAL, "load": {"fz": "-5 kN"}}).arrows[0].points
    assert downward[1][1] < downward[0][1]


def test_only_what_carries_is_filled() -> None:
    above, below = (
        spans(one, 1)[0] > 0.0 for one in (of(drawn("NU 208", RADIAL), kind)[0]
                                            for kind in ("loaded", "element"))
    )  # fmt: skip
    assert above
    assert not below


@pytest.mark.parametrize(
    "designation",
    ["6310", "7210 B", "QJ 210", "3208", "1208", "51210", "NU 208", "NJ 308", "30206", "22216 E"],
)
def test_every_type_is_drawn_inside_its_box(designation: str) -> None:
    duty = {"inner_speed": "100 rpm", "load": {"fx": "10 kN"}} if designation[0] == "5" else RADIAL
    drawing = drawn(designation, duty)
    left, bottom, wide, tall = drawing.box
    for one in drawing.outlines:
        for x, y in one.points:
            assert left <= x <= left + wide
            assert bottom <= y <= bottom + tall
    assert len(of(drawing, "ring")) in (4, 8)


def test_a_profile_that_is_drawn_deeper_says_so() -> None:
    assert "20 times" in drawn("NU 208", RADIAL).remark
    assert "times" not in drawn("6310").remark


def test_a_text_of_the_drawing_is_no_markup() -> None:
    case = Case.from_mapping({"bearing": {"designation": "6310"}, "duty": RADIAL, "title": "<b>"})
    text = section_svg(case, solve(case))
    assert text.count("<svg") == 1
    assert "<b>" not in text
    assert "style=" not in text  # the policy of the page refuses it


def test_it_is_drawn_on_paper() -> None:
    figure = draw_section(drawn("6310"))
    wide, tall = figure.get_size_inches() * 25.4
    assert wide <= 105.001
    assert tall <= 78.001


def test_what_a_drawing_keeps_follows_the_seats() -> None:
    seats = {"shaft_tolerance": "k5", "housing_tolerance": "H6"}
    solid, hollow = (
        drawn("6310", mounting={**seats, **more}) for more in ({}, {"shaft_bore": "20 mm"})
    )
    assert len(of(hollow, "shaft")) == 1 + len(of(solid, "shaft"))
    assert of(hollow, "ring") == of(solid, "ring")
    assert of(drawn("6310", mounting=seats), "shaft") == of(solid, "shaft")
