"""The page of a machine and its addresses: what they answer is what `rolamento shaft` says."""

from __future__ import annotations

import base64
import json
import re
import time
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import anyio
import httpx
import pytest
from typer.testing import CliRunner

from rolamento.case.machine import machine_of_tables, parse_machine, with_changes
from rolamento.cli.app import app as commands
from rolamento.errors import InputError
from rolamento.plots.machine_sketch import sketch_machine
from rolamento.web import limits, machine
from rolamento.web.limits import MOST_OVER_STEPS, size_of_machine
from rolamento.web.machine import machine_live, machine_opened, machine_saved
from rolamento.web.page_api import start
from rolamento.web.requests import EXAMPLE_MACHINE
from rolamento.web.server import Settings, create_app
from rolamento.words import speaking

AT_ONCE = 20.0
"""Seconds, on a machine that is busy."""
NAMES = [one["name"] for one in machine.machine_described()["examples"]]


@pytest.fixture(autouse=True)
def _here(monkeypatch: pytest.MonkeyPatch) -> None:
    """Do slow work in this process: that others end it is tested with the limits."""

    async def slow(function: Callable[..., Any], *args: Any, seconds: float = 0.0) -> Any:
        return function(*args)

    monkeypatch.setattr(limits, "slow", slow)
    monkeypatch.setattr(machine, "slow", slow)


@cache
def _app() -> Any:
    return create_app(Settings(warm=False))


def ask(path: str, body: object, lang: str = "en") -> httpx.Response:
    async def asked() -> httpx.Response:
        transport = httpx.ASGITransport(_app())
        async with httpx.AsyncClient(transport=transport, base_url="http://127.0.0.1:8000") as one:
            text = body if isinstance(body, str) else json.dumps(body)
            kind = {"content-type": "application/json"}
            return await one.post(path, content=text, headers=kind, params={"lang": lang})

    began = time.perf_counter()
    response = anyio.run(asked)
    assert time.perf_counter() - began < AT_ONCE
    assert "Traceback" not in response.text
    assert "/home/" not in response.text
    return response


def live(changes: dict[str, Any] | None = None, **more: Any) -> dict[str, Any]:
    asked = {"machine": EXAMPLE_MACHINE, "changes": changes or {}, **more}
    response = ask("/page/machine/live", asked)
    assert response.status_code == 200, response.text
    found: dict[str, Any] = response.json()
    return found


def command(*arguments: str) -> Any:
    result = CliRunner().invoke(commands, [*arguments, "--json", "-"])
    assert result.exit_code == 0, result.output
    return json.loads(result.stdout)


def same(found: Any, wanted: Any, path: str = "") -> None:
    """Equal but for the last digits: one case may be solved by plain Python or compiled code."""
    if isinstance(wanted, dict):
        assert found.keys() == wanted.keys(), path
        for key, one in wanted.items():
            same(found[key], one, f"{path}.{key}")
    elif isinstance(wanted, list):
        assert len(found) == len(wanted), path
        for place, one in enumerate(wanted):
            same(found[place], one, f"{path}.{place}")
    elif isinstance(wanted, float) and not path.endswith((".residual", ".iterations")):
        assert found == pytest.approx(wanted, rel=1e-5, abs=1e-7), path


# --- the HTTP API ---------------------------------------------------------------------------------


def test_shaft_is_the_command(tmp_path: Path) -> None:
    file = tmp_path / "machine.json"
    file.write_text(json.dumps(EXAMPLE_MACHINE))
    asked = {"machine": EXAMPLE_MACHINE, "settings": {"loads.0.fz": "-3 kN"}}
    response = ask("/api/v1/shaft", asked)
    assert response.status_code == 200, response.text
    found, wanted = response.json(), command("shaft", str(file), "--set", "loads.0.fz=-3 kN")
    assert found["machine"] == wanted["machine"]
    for name in ("shafts", "life", "steps"):
        same(found[name], wanted[name], name)
    forces = [[one["force"] for one in each["bearings"]] for each in (found, wanted)]
    same(forces[0], forces[1])


def test_rotor_is_the_command(tmp_path: Path) -> None:
    file = tmp_path / "machine.json"
    file.write_text(json.dumps(EXAMPLE_MACHINE))
    asked = {"machine": EXAMPLE_MACHINE, "speeds": "0..3000rpm", "points": 2, "modes": 3}
    found = ask("/api/v1/rotor", asked).json()
    options = ("--speeds", "0..3000rpm", "--points", "2", "--modes", "3")
    wanted = command("rotor", str(file), *options)
    same(found["modes"]["frequency"], wanted["modes"]["frequency"])
    error = ask("/api/v1/rotor", {**asked, "speeds": "fast"}).json()["error"]
    assert (error["field"], error["rule"]) == ("speeds", "must be FIRST..LAST, with a unit")


def test_what_is_wrong_is_said_as_the_command_says_it(tmp_path: Path) -> None:
    wrong = with_changes(EXAMPLE_MACHINE, {"bearings.B.position": "2 m"})
    error = ask("/api/v1/shaft", {"machine": wrong}).json()["error"]
    file = tmp_path / "machine.json"
    file.write_text(json.dumps(wrong))
    said = CliRunner().invoke(commands, ["shaft", str(file)])
    assert error["field"] == "bearings.1.position"
    assert error["message"].partition(" (")[0] in " ".join(said.output.split())


# --- opening, saving, reports ---------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_every_example_is_opened_drawn_and_followed(name: str) -> None:
    opened = machine_opened({"example": name})["machine"]
    found = machine_live({"machine": opened})
    assert found["error"] is None
    assert found["status"]["converged"]
    assert {"life", "bearings", "shafts"} <= {one["key"] for one in found["sections"]}
    count = sum(len(opened.get(kind, ())) for kind in machine._FIELDS)
    assert len(found["parts"]) == count
    assert len(found["drawing"]["lines"]) == 2 * len(opened["shafts"])


def test_examples_have_titles_in_the_language_that_is_spoken() -> None:
    assert len(NAMES) == 7
    with speaking("pt"):
        assert machine_opened({"example": "motor"})["machine"]["title"].startswith("Motor elétrico")
        titles = [one["title"] for one in start()["machine"]["examples"]]
    assert all(titles)
    assert titles != [one["title"] for one in start()["machine"]["examples"]]


def test_a_file_is_opened_and_what_is_wrong_has_its_line() -> None:
    text = machine_saved({"machine": EXAMPLE_MACHINE})["text"]
    opened = machine_opened({"text": text, "name": "own.toml"})["machine"]
    assert machine_of_tables(opened) == machine_of_tables(EXAMPLE_MACHINE)
    with pytest.raises(InputError) as caught:
        machine_opened({"text": text.replace('"6308"', '"none"', 1), "name": "own.toml"})
    error = caught.value
    assert error.field == "bearings.0.designation"
    assert error.source == "own.toml"
    assert error.line is not None
    assert '"none"' in text.replace('"6308"', '"none"', 1).splitlines()[error.line - 1]


@pytest.mark.parametrize("form", ["toml", "json"])
def test_what_is_saved_is_the_machine(form: str) -> None:
    saved = machine_saved({"machine": EXAMPLE_MACHINE, "format": form})
    assert saved["name"] == f"machine.{form}"
    assert parse_machine(saved["text"]) == machine_of_tables(EXAMPLE_MACHINE)


@pytest.mark.parametrize(("form", "begins"), [("html", b"<!DOCTYPE html>"), ("pdf", b"%PDF")])
def test_the_report_is_that_of_the_command(form: str, begins: bytes) -> None:
    response = ask("/page/machine/report", {"machine": EXAMPLE_MACHINE, "format": form})
    assert response.status_code == 200
    assert response.content.startswith(begins)
    assert response.headers["content-disposition"].endswith(f'.{form}"')
    if form == "html":
        assert "Life of all bearings together" in response.text
        assert "Bearing A" in response.text


# --- what follows a change ------------------------------------------------------------------------


def test_a_change_is_followed_by_what_the_command_says(tmp_path: Path) -> None:
    found = live({"loads.0.position": "200 mm", "bearings.A.designation": "6208"})
    file = tmp_path / "machine.json"
    file.write_text(json.dumps(found["machine"]))
    wanted = command("shaft", str(file))
    hours = wanted["life"]["headline"]["hours"] if wanted["life"]["headline"] else None
    life = next(one["html"] for one in found["sections"] if one["key"] == "life")
    assert hours is None or f"{hours:.3g}"[:3].replace(".", "") in re.sub(r"\D", "", life)
    table = next(one["html"] for one in found["sections"] if one["key"] == "bearings")
    for one in wanted["bearings"]:
        radial = (one["force"][0][1] ** 2 + one["force"][0][2] ** 2) ** 0.5
        assert f"{radial:.0f}" in re.sub(r"[\s\u202f\u00a0\u2009]", "", table)


def test_moving_a_load_moves_its_grip_and_no_other() -> None:
    before, after = live(), live({"loads.0.position": "280 mm"})
    assert before["drawing"]["scale"] == after["drawing"]["scale"]
    old, new = ({one["key"]: one for one in each["parts"]} for each in (before, after))
    moved = 0.01 * after["drawing"]["scale"]
    assert old["loads.0"]["x"] - new["loads.0"]["x"] == pytest.approx(moved)
    assert new["loads.0"]["position"] == pytest.approx(0.28)
    assert [old[key]["x"] for key in ("bearings.0", "bearings.1")] == [
        new[key]["x"] for key in ("bearings.0", "bearings.1")
    ]
    assert after["machine"]["loads"][0]["position"] == "280 mm"
    assert EXAMPLE_MACHINE["loads"][0]["position"] == "290 mm"


def test_grips_are_where_the_drawing_has_its_parts() -> None:
    found = machine_of_tables(EXAMPLE_MACHINE)
    sketch = sketch_machine(found, width=150.0)
    axes = sketch.figure.axes[0]
    sketch.figure.draw_without_rendering()
    for grip in sketch.grips:
        kind, index = grip.part.split(".")
        x = 1e3 * getattr(found, kind)[int(index)].position
        at, up = axes.transData.transform((x, 0.0)) * 72.0 / sketch.figure.dpi
        assert grip.x == pytest.approx(at, abs=0.05)
        assert sketch.height - grip.axis == pytest.approx(up, abs=0.05)


def test_a_part_has_the_fields_that_may_be_changed() -> None:
    parts = {one["key"]: one for one in live()["parts"]}
    names = [one["name"] for one in parts["loads.0"]["fields"]]
    assert names == [f"loads.0.{name}" for name in ("position", *machine._FORCES)]
    names = [one["name"] for one in parts["bearings.0"]["fields"]]
    assert names == ["bearings.0.position", "bearings.0.designation"]
    spindle = machine_live(machine_opened({"example": "spindle"}))["parts"]
    assert spindle[0]["fields"][-1]["name"] == "bearings.0.bearing.designation"


def test_a_step_is_chosen_and_pictures_are_of_it() -> None:
    opened = machine_opened({"example": "gear_shaft"})["machine"]
    first, last = (machine_live({"machine": opened, "step": step, "pictures": ["deflection"]})
                   for step in (0, 99))  # fmt: skip
    assert first["steps"] == ["full load", "usual load", "light load, fast"]
    assert (first["step"], last["step"]) == (0, 2)
    assert first["drawing"]["image"] != last["drawing"]["image"]
    assert first["pictures"]["deflection"] != last["pictures"]["deflection"]
    assert list(first["pictures"]) == ["deflection"]


def test_a_machine_without_equilibrium_says_why_and_is_drawn() -> None:
    found = live({"bearings.A.located": "floating"}, pictures=["deflection", "forces", "bearings"])
    assert found["error"] is None
    assert not found["status"]["converged"]
    assert found["status"]["advice"]
    assert found["drawing"]["lines"] == []
    assert base64.b64decode(found["drawing"]["image"].partition(",")[2]).startswith(b"<?xml")


def test_null_takes_a_value_away() -> None:
    assert "fz" not in live({"loads.0.fz": None, "loads.0.fx": "1 kN"})["machine"]["loads"][0]
    assert live({"gravity.acceleration": None})["machine"] == EXAMPLE_MACHINE


# --- those who mean harm --------------------------------------------------------------------------

PATHS = ("/page/machine/live", "/page/machine/open", "/page/machine/save", "/page/machine/report",
         "/api/v1/shaft", "/api/v1/rotor")  # fmt: skip


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize(
    "body",
    ["[" * 100_000, '{"machine": ' + '{"a":' * 450 + "1" + "}" * 451, '{"machine": NaN}',
     '{"machine": 1e999}', '{"machine": "\\ud800"}', '{"machine": {"shafts": [1, null, "x"]}}',
     '{"machine": {"shafts": {}, "bearings": {}, "loads": 3, "spectrum": "x"}}', "{}",
     '{"machine": {"bearings": [{"bearing": {"ball_count": 1e400}}]}}'],
    ids=["open", "deep", "NaN", "infinite", "half a letter", "list", "kinds", "nothing", "count"],
)  # fmt: skip
def test_a_body_that_is_made_to_break_is_refused(path: str, body: str) -> None:
    response = ask(path, body)
    assert response.status_code in (200, 400, 413, 422)
    assert response.json()["error"]["message"]


FILES = ("/etc/passwd", "machine.toml", "../case.toml", "C:\\case.toml", "-", "")


@pytest.mark.parametrize("name", FILES, ids=lambda name: name or "none")
@pytest.mark.parametrize(
    "changes",
    [
        lambda name: {"shafts.0.sections": name},
        lambda name: {"bearings.0.case": name, "bearings.0.designation": None},
        lambda name: {"housings": [{"name": "h", "bearings": ["A"], "matrix": name}]},
    ],
    ids=["sections", "case", "matrix"],
)
def test_no_file_is_read_by_a_request(name: str, changes: Any, tmp_path: Path) -> None:
    changed = changes(name)
    error = live(changed)["error"]
    assert error["field"] in ("shafts.0.sections", "bearings.0.case", "housings.0.matrix")
    assert error["rule"].startswith("names a file")
    asked = {"machine": EXAMPLE_MACHINE, "settings": changed}
    assert ask("/api/v1/shaft", asked).json()["error"]["field"] == error["field"]
    tables = with_changes(EXAMPLE_MACHINE, changed)
    for path in ("/page/machine/open", "/page/machine/save", "/page/machine/report"):
        assert ask(path, {"machine": tables}).json()["error"]["field"] == error["field"]
    assert ask("/page/machine/open", {"text": json.dumps(tables)}).status_code == 422


@pytest.mark.parametrize(
    "name", ["../motor", "/etc/passwd", "motor.toml\0", "machines/motor", "motor.toml"]
)
def test_an_example_is_a_name_and_no_path(name: str) -> None:
    assert ask("/page/machine/open", {"example": name}).status_code == 422


@pytest.mark.parametrize(
    "value",
    [1e308, "1e308 kN", "NaN N", "inf N", "9" * 4000, "\0", [[]], {"a": 1}, True, "../../x"],
    ids=lambda value: str(value)[:20].replace("\0", "nul"),
)
def test_a_value_that_is_no_load_is_told_at_its_field(value: Any) -> None:
    assert live({"loads.0.fz": value})["error"]["field"].startswith("loads.0.fz")


@pytest.mark.parametrize(
    "name",
    ["__class__", "loads.0.__dict__", "loads.9.fz", "loads.-1.fz", "loads.C.fz", "", ".", "loads",
     "loads..fz", "loads.0.fz.x.y", "loads.0.fz=1", "shafts.0.sections.99.length", "x" * 10_000,
     "a." * 5_000],
    ids=lambda name: name[:24] or "none",
)  # fmt: skip
def test_a_field_that_is_none_is_told(name: str) -> None:
    error = live({name: "5 kN"})["error"]
    assert error["message"]
    assert len(error["field"]) < 200


@pytest.mark.parametrize(
    ("more", "field"),
    [
        ({"spectrum": [{"share": 1e-4}] * 10_000}, "spectrum"),
        ({"shafts": [{"name": f"s{n}", "sections": [{"length": "1 mm", "diameter": "9 mm"}] * 200}
                     for n in range(20)]}, "shafts"),
        ({"loads": [{"shaft": "shaft", "position": "1 mm"}] * 100_000}, "loads"),
        ({"bearings": [{"name": f"B{n}", "shaft": "shaft", "position": "1 mm",
                        "designation": "6308"} for n in range(5_000)]}, "bearings"),
    ],
    ids=["steps", "sections", "loads", "bearings"],
)  # fmt: skip
def test_a_machine_that_is_too_large_is_refused_before_it_runs(
    more: dict[str, Any], field: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def never(*_: object) -> None:
        raise AssertionError("it was solved")

    monkeypatch.setattr(machine, "analyse_machine", never)
    shaft = EXAMPLE_MACHINE["shafts"] if field == "shafts" else []
    changed = {name: [*(shaft if name == "shafts" else ()), *many] for name, many in more.items()}
    if field == "shafts":
        changed["shafts"] = changed["shafts"][:20]
    response = ask("/page/machine/live", {"machine": {**EXAMPLE_MACHINE, **changed}})
    if response.status_code != 413:  # the body itself
        assert response.json()["error"]["field"].startswith(field)


def test_what_a_machine_costs_is_estimated_of_anything() -> None:
    assert size_of_machine(EXAMPLE_MACHINE).is_fast
    many = {**EXAMPLE_MACHINE, "spectrum": [{"share": 0.01}] * 100}
    size = size_of_machine(many)
    assert not size.is_fast
    assert size.steps * size.elements < MOST_OVER_STEPS
    heavy = with_changes(EXAMPLE_MACHINE, {"bearings.0.bearing": {"ball_count": 10**30}})
    assert not size_of_machine(heavy).is_fast
    for nothing in (None, [], {}, {"shafts": 3}, {"shafts": [None], "bearings": ["x"]}):
        assert size_of_machine(nothing).is_fast


@pytest.mark.parametrize(
    "more",
    [{"step": "x"}, {"step": True}, {"width": 1e9}, {"width": None}, {"pictures": "x"},
     {"changes": []}, {"changes": "x"}],
    ids=str,
)  # fmt: skip
def test_a_request_of_another_kind_is_refused(more: dict[str, Any]) -> None:
    response = ask("/page/machine/live", {"machine": EXAMPLE_MACHINE, **more})
    assert response.status_code == (200 if more == {"changes": []} else 422)


def test_numbers_of_a_request_are_bounded() -> None:
    many = ["x", "__class__", "deflection", {}, None] * 100
    found = live(step=10**30, width=-(10**30), pictures=many)
    assert found["step"] == 0
    assert list(found["pictures"]) == ["deflection"]
    assert found["drawing"]["width"] == pytest.approx(80.0 * 72.0 / 25.4)


def test_a_title_that_acts_is_text() -> None:
    changes = {"title": "<script>alert(1)</script>", "bearings.0.name": "<img src=x onerror=y>"}
    found = live(changes, pictures=["bearings"])
    shown = [one["html"] for one in found["sections"]] + list(found["pictures"].values())
    assert found["error"] is None
    assert not any("<script" in text or "<img src=x" in text for text in shown)


def test_refusals_are_said_in_portuguese() -> None:
    asked = {"machine": EXAMPLE_MACHINE, "changes": {"loads.0.position": "9 m"}}
    told = ask("/page/machine/live", asked, "pt").json()["error"]["message"]
    assert "não está no eixo" in told or "eixo" in told
