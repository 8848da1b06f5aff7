"""The HTTP API: what it answers is what the commands write, and what it refuses it says."""

from __future__ import annotations

import asyncio
import json
import re
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import httpx
import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st
from typer.testing import CliRunner

import rolamento
from rolamento.case import Case
from rolamento.cli.app import app as commands
from rolamento.tasks.batch import MOST_CASES, batch
from rolamento.units import SI_UNIT
from rolamento.web import api, drops
from rolamento.web.openapi import openapi_document
from rolamento.web.requests import EXAMPLE_MACHINE
from rolamento.web.server import Settings, create_app

HERE = "http://127.0.0.1:8000"
LOAD = {"duty.load.fz": "5 kN", "duty.inner_speed": "1480 rpm"}
OIL = {"lubricant": "ISO VG 68", "temperature.lubricant": "70 degC"}
GEOMETRY = {
    "title": "own",
    "bearing": {
        "ball_count": 16,
        "ball_diameter": "22.23 mm",
        "pitch_diameter": "125.26 mm",
        "contact_angle": "40 deg",
        "inner_conformity": 0.5232,
        "outer_conformity": 0.5232,
    },
    "duty": {"inner_speed": "10000 rpm", "load": {"fx": "20 kN", "fz": "15 kN"}},
}


@pytest.fixture(autouse=True)
def _here(monkeypatch: pytest.MonkeyPatch) -> None:
    """Do the work in this process: that others end it is tested with the limits."""

    async def slow(function: Callable[..., Any], *args: Any, seconds: float = 0.0) -> Any:
        return function(*args)

    monkeypatch.setattr(api, "slow", slow)


@cache
def _app() -> Any:
    return create_app(Settings(warm=False))


def ask(method: str, path: str, **more: Any) -> httpx.Response:
    async def asked() -> httpx.Response:
        transport = httpx.ASGITransport(_app())
        async with httpx.AsyncClient(transport=transport, base_url=HERE) as client:
            return await client.request(method, f"/api/v1{path}", **more)

    return asyncio.run(asked())


def post(path: str, body: Mapping[str, Any], lang: str = "en") -> Any:
    response = ask("POST", path, json=body, params={"lang": lang})
    assert response.status_code == 200, response.text
    return response.json()


def refusal(path: str, body: Mapping[str, Any], status: int = 422) -> dict[str, Any]:
    response = ask("POST", path, json=body)
    assert response.status_code == status, response.text
    error: dict[str, Any] = response.json()["error"]
    return error


def command(*arguments: str) -> Any:
    found = CliRunner().invoke(commands, [*arguments, "--json", "-"])
    assert found.exit_code == 0, found.output
    return json.loads(found.stdout)


def as_set(settings: Mapping[str, object]) -> list[str]:
    return [part for key, value in settings.items() for part in ("--set", f"{key}={value}")]


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
    elif path.endswith((".residual", ".iterations")):
        assert found is not None
    elif isinstance(wanted, float):
        nothing = 1e-3 if ".stiffness" in path else 1e-9  # N/m, beside 1e8
        assert found == pytest.approx(wanted, rel=1e-6, abs=nothing), path
    else:
        assert found == wanted, path


# --- the same as the commands -------------------------------------------------------------------


def test_analyse_is_solve_of_the_command_line(tmp_path: Path) -> None:
    file = tmp_path / "case.json"
    file.write_text(json.dumps(GEOMETRY))
    wanted = command("solve", str(file), *as_set(OIL))
    same(post("/analyse", {"case": GEOMETRY, "settings": OIL}), wanted)
    wanted = command("solve", "6310/C3", *as_set(LOAD))
    same(post("/analyse", {"designation": "6310/C3", "settings": LOAD}), wanted)


def test_solve_is_that_of_python() -> None:
    found = post("/solve", {"case": GEOMETRY})
    wanted = json.loads(rolamento.solve(Case.from_mapping(GEOMETRY)).to_json())
    same(found, wanted)


def test_life_friction_and_frequencies_are_those_of_the_command_line() -> None:
    asked = {"designation": "6310/C3", "settings": {**LOAD, **OIL}}
    same(post("/life", asked), command("life", "6310/C3", *as_set({**LOAD, **OIL})))
    rubbed = {**LOAD, **OIL, "lubricant.friction_coefficient": 0.1}
    found = post("/friction", {"designation": "6310/C3", "settings": rubbed, "hysteresis": 0.02})
    wanted = command("friction", "6310/C3", "--hysteresis", "0.02", *as_set(rubbed))
    same(found, wanted)
    same(post("/frequencies", {"designation": "6205"}), command("frequencies", "6205"))
    found = post(
        "/frequencies",
        {"designation": "6205", "speed": "1797 rpm", "tolerances": {"speed": 0.01}, "slip": 0.01},
    )
    turning = ("--speed", "1797 rpm", "--tolerance", "speed=0.01", "--slip", "0.01")
    same(found, command("frequencies", "6205", *turning))
    same(post("/frequencies", {"designation": "6205", "settings": LOAD}),
         command("frequencies", "6205", *as_set(LOAD)))  # fmt: skip


def test_a_shaft_has_a_life(tmp_path: Path) -> None:
    files = []
    asked = []
    for name, force in (("left", "4 kN"), ("right", "6 kN")):
        duty = {"inner_speed": "1480 rpm", "load": {"fz": force}}
        tables = {"title": name, "bearing": {"designation": "6310"}, "duty": duty}
        files.append(str(tmp_path / f"{name}.json"))
        Path(files[-1]).write_text(json.dumps(tables))
        asked.append({"case": tables})
    same(post("/life", {"bearings": asked}), command("life", *files))
    wrong = [asked[0], {"designation": "6310"}]
    assert "bearings.1" in refusal("/life", {"bearings": wrong})["message"]
    assert refusal("/life", {"bearings": asked[:1]})["field"] == "bearings"
    both = {"bearings": asked, "designation": "6310"}
    assert refusal("/life", both)["field"] == "bearings"


def test_weibull_is_that_of_the_command_line(tmp_path: Path) -> None:
    times = [17.88, 28.92, 33.0, 41.52, 42.12, 45.6]
    file = tmp_path / "test.csv"
    lines = [f"{time},{'failed' if place < 5 else 'suspended'}" for place, time in enumerate(times)]
    file.write_text("\n".join(["time (h),status", *lines]))
    wanted = command("weibull", str(file), "--reliability", "0.9", "--time", "20 h")
    table = {"times": times, "failed": [True] * 5 + [False], "unit": "h"}
    found = post("/weibull", {"test": table, "reliabilities": [0.9], "times": ["20 h"]})
    for own in ("title", "source"):
        found.pop(own), wanted.pop(own)
    same(found, wanted)


def test_names_are_as_they_are_given() -> None:
    """No mark in a name of a list, or of a calculated life, stands between two of them."""
    test = {"times": [17.0, 28.0, 33.0, 45.0, 51.0, 60.0], "group": ["A;B"] * 3 + ["C"] * 3}
    lives = {"a;b": 30, "a=b": "31 h", "": 32.0}
    asked = {"test": test, "samples": 100, "only": ["A;B"], "calculated": lives}
    (group,) = post("/weibull", asked)["groups"]
    found = {name: one["calculated"] for name, one in group["calculated"].items()}
    assert found == {"a;b": 30.0, "a=b": 31.0, "": 32.0}
    asked = {"test": {**test, "unit": ""}, "samples": 100, "calculated": {"x": 30}}
    assert post("/weibull", asked)["groups"][0]["calculated"]["x"]["calculated"] == 30.0


def test_numbers_and_texts_are_told_apart() -> None:
    """A count may be written as JSON has it, 3.0; a name is no number."""
    asked = {"designation": "6205", "speed": "1797 rpm"}
    wanted = post("/frequencies", {**asked, "sidebands": 2, "harmonics": 3})
    assert post("/frequencies", {**asked, "sidebands": 2.0, "harmonics": 3.0}) == wanted
    machine = {"machine": EXAMPLE_MACHINE, "points": 2, "modes": 1}
    for name in ("speeds", "shaft"):
        error = refusal("/rotor", {**machine, name: 1})
        assert (error["field"], error["rule"]) == (name, "must be text")
    lives = {"times": [1.0, 2.0, 3.0], "mode": ["3", "3", "4"]}
    assert refusal("/weibull", {"test": lives, "only_mode": 3})["field"] == "only_mode"
    wanted = post("/rotor", {**machine, "points": 2.0, "modes": 1.0})
    assert wanted == post("/rotor", {**machine, "orders": []})


def test_the_catalogue_is_that_of_the_command_line() -> None:
    found = ask("GET", "/catalogue", params={"text": "620", "most": 5}).json()
    assert found == command("catalogue", "search", "620", "--most", "5")
    found = ask("GET", "/catalogue", params={"designation": "6205/C3"}).json()
    same(found, command("catalogue", "show", "6205/C3"))
    for wrong in ({}, {"text": "62", "designation": "6205"}, {"text": "62", "most": "0"},
                  {"text": "62", "moist": "1"}, {"designation": "../etc"}):  # fmt: skip
        assert ask("GET", "/catalogue", params=wrong).status_code == 422
    assert "most" in ask("GET", "/catalogue?text=62&moist=1").json()["error"]["message"]


@pytest.mark.sweep
def test_diagnose_is_that_of_the_command_line(tmp_path: Path) -> None:
    content: bytes = drops.example_file("signal", "outer_race")["content"]
    file = tmp_path / "record.npz"
    file.write_bytes(content)
    wanted = command("diagnose", str(file), "--bearing", "6205", "--speed", "1797 rpm")
    query = {"bearing": "6205", "speed": "1797 rpm"}
    response = ask("POST", "/diagnose", params=query, content=content,
                   headers={"x-file-name": "record.npz"})  # fmt: skip
    assert response.status_code == 200, response.text
    found = response.json()
    assert "/tmp" not in response.text
    for one in (found, wanted):
        one.pop("title")
    same(found, wanted)


@pytest.mark.parametrize(
    ("query", "field"),
    [
        ({}, "case"),
        ({"bearing": "6205", "sped": "1 rpm"}, "sped"),
        ({"bearing": "6205", "speed": "fast"}, "speed"),
        ({"bearing": "/etc/passwd"}, "bearing.designation"),
        ({"case": "[1]"}, ""),
        ({"bearing": "6205", "settings": '{"duty.load": 3}'}, "duty.load"),
    ],
)
def test_a_wrong_record_or_option_is_told(query: dict[str, str], field: str) -> None:
    response = ask("POST", "/diagnose", params=query, content=b"RIFF....")
    assert response.status_code == 422, response.text
    assert "rolamento-" not in response.text
    error = response.json()["error"]
    if field:
        assert field in error["message"]


@pytest.mark.parametrize(
    ("form", "begins"), [("html", b"<!DOCTYPE"), ("md", b"# "), ("json", b"{")]
)
def test_a_report_is_a_file(form: str, begins: bytes) -> None:
    body = {"cases": [{"case": GEOMETRY}], "format": form, "head": {"project": "P-101"}}
    response = ask("POST", "/report", json=body)
    assert response.status_code == 200, response.text
    assert response.content.startswith(begins)
    assert b"P-101" in response.content
    assert response.headers["content-disposition"].startswith("attachment")


# --- many cases ---------------------------------------------------------------------------------


def test_a_batch_has_columns_and_a_status_for_each_case() -> None:
    forces = ["2 kN", 5000.0, None, "1e12 N"]
    asked = {
        "case": GEOMETRY,
        "fields": {"duty.load.fz": forces},
        "outputs": ["z", "max_inner_load"],
    }
    found = post("/batch", asked)
    assert found["status"] == ["converged", "converged", "invalid_input", "invalid_input"]
    assert found["units"]["max_inner_load"] == "N"
    loads = found["outputs"]["max_inner_load"]
    assert loads[2:] == [None, None]
    one = post("/solve", {"case": GEOMETRY, "settings": {"duty.load.fz": "2 kN"}})
    greatest = max(ball["inner"]["load"] for ball in one["balls"])
    assert loads[0] == pytest.approx(greatest, rel=1e-9)
    assert found["outputs"]["z"][0] == pytest.approx(one["displacement"]["z"], rel=1e-9)


def test_a_batch_of_one_is_a_batch() -> None:
    found = post("/batch", {"case": GEOMETRY, "fields": {"duty.load.fz": ["2 kN"]}})
    assert found["cases"] == len(found["status"]) == 1


@pytest.mark.parametrize(
    ("fields", "told"),
    [
        ({"duty.load.fz": [1.0, 2.0], "duty.load.fx": [1.0]}, "one length"),
        ({"duty.load.f": [1.0]}, "did you mean"),
        ({"duty.load.fz": 1.0}, "must have a list"),
        ({"duty.load.fz": []}, "must have a list"),
        ({"duty.load.fz": [1.0] * (MOST_CASES + 1)}, "must have a list"),
        ({"duty.load.fz": [[1.0]]}, "one-dimensional"),
        ({"duty.load.fz": [True]}, "must be"),
        ({"duty.load.fz": {"a": 1}}, "must be"),
        ({"bearing.designation": ["6310"]}, "not a field that can vary"),
    ],
)
def test_a_wrong_batch_is_told(fields: dict[str, Any], told: str) -> None:
    assert told in refusal("/batch", {"case": GEOMETRY, "fields": fields})["message"]


def test_outputs_of_a_batch_are_known_and_different() -> None:
    case = Case.from_mapping(GEOMETRY)
    for outputs in (["x", "x"], ["nothing"], ["friction_torque_jones_full"]):
        with pytest.raises(rolamento.InputError):
            batch(case, {"duty.load.fz": [1.0, 2.0]}, outputs)


# --- what is refused ----------------------------------------------------------------------------


def test_errors_name_the_field_the_value_and_what_is_near() -> None:
    error = refusal("/solve", {"case": {**GEOMETRY, "bearings": {}}})
    assert error["field"] == "bearings"
    assert "did you mean bearing?" in error["message"]
    error = refusal("/solve", {"desination": "6310"})
    assert "did you mean designation?" in error["message"]
    error = refusal("/solve", {"designation": "6310", "settings": {"duty.load.fz": 5}})
    assert (error["field"], error["value"]) == ("duty.load.fz", "5")
    assert "unit" in error["rule"]
    assert error["example"]
    assert refusal("/solve", {"designation": "6310"})["field"] == "duty.load"
    assert refusal("/friction", {"case": GEOMETRY})["field"] == "lubricant.friction_coefficient"
    assert refusal("/solve", {"case": GEOMETRY, "designation": "6310"})["field"] == "case"


def test_no_path_of_the_client_is_opened(tmp_path: Path) -> None:
    file = tmp_path / "case.toml"
    file.write_text('[bearing]\ndesignation = "6310"\n[duty.load]\nfz = "1 kN"\n')
    for name in (str(file), "-", "case.toml", f"file://{file}"):
        for path in ("/solve", "/life", "/frequencies"):
            error = refusal(path, {"designation": name})
            assert error["field"] == "bearing.designation", (name, error)


def test_a_case_without_a_solution_has_a_status_and_no_number() -> None:
    free = {"duty.load": {"fx": "-20 kN", "fz": "0 N"}}
    found = post("/solve", {"case": GEOMETRY, "settings": free})
    assert found["status"]["converged"] is False
    assert found["status"]["advice"]
    assert set(found["displacement"].values()) == {None}


# --- the document -------------------------------------------------------------------------------


def test_every_example_of_the_document_works() -> None:
    for path, methods in openapi_document()["paths"].items():
        for method, one in methods.items():
            content = one.get("requestBody", {}).get("content", {}).get("application/json")
            if content is not None:
                response = ask(method, path, json=content["example"])
            elif method == "get":
                query = {each["name"]: each["example"] for each in one["parameters"]
                         if "example" in each}  # fmt: skip
                response = ask(method, path, params=query)
            else:
                continue
            assert response.status_code == 200, (path, response.text)
            for kind, told in one["responses"]["200"]["content"].items():
                if kind == "application/json" and path != "/report":
                    assert set(told["schema"]["required"]) <= response.json().keys()


def test_the_document_is_that_of_the_server_and_speaks_both_languages() -> None:
    english, portuguese = (ask("GET", f"/openapi.json?lang={lang}").json() for lang in ("en", "pt"))
    assert english == json.loads(json.dumps(openapi_document()))
    assert english["paths"].keys() == portuguese["paths"].keys()
    assert (
        english["paths"]["/life"]["post"]["summary"]
        != portuguese["paths"]["/life"]["post"]["summary"]
    )
    text = json.dumps(english)
    names = set(re.findall(r'"#/components/schemas/(\w+)"', text))
    assert names <= english["components"]["schemas"].keys()
    force = english["components"]["schemas"]["Load"]["properties"]["fz"]
    assert {"type": "number", "unit": "N"} not in force["anyOf"]
    assert force["anyOf"][0]["format"] == "force"


def test_examples_in_the_document_are_of_their_schema() -> None:
    validator = pytest.importorskip("jsonschema_rs")
    document = openapi_document()

    def look(schema: Any) -> None:
        if isinstance(schema, list):
            for one in schema:
                look(one)
        if not isinstance(schema, dict):
            return
        if isinstance(schema.get("examples"), list):
            own = {key: one for key, one in schema.items() if key != "examples"}
            checker = validator.validator_for({**own, "components": document["components"]})
            for example in schema["examples"]:
                assert checker.is_valid(example), (example, own)
        for one in schema.values():
            look(one)

    look(document["components"]["schemas"])


# --- anything at all ----------------------------------------------------------------------------

_SMALL = ("/weibull", "/frequencies", "/solve", "/batch", "/life", "/friction")


@cache
def _strategy(path: str, mode: str) -> Any:
    """Bodies made from the document; the tables of a case are any tables, they are too many."""
    schemathesis = pytest.importorskip("schemathesis")
    for dimension, unit in SI_UNIT.items():
        numbers = st.floats(-1e3, 1e6, allow_nan=False).map("{:.4g}".format)
        schemathesis.openapi.format(dimension, st.tuples(numbers, st.just(unit)).map(" ".join))
    document = openapi_document()
    document["components"]["schemas"]["Case"] = {"type": "object", "maxProperties": 3}
    operation = schemathesis.openapi.from_dict(document)[path]["POST"]
    return operation.as_strategy(generation_mode=schemathesis.GenerationMode(mode))


def _checked(path: str, body: Any) -> None:
    """Whatever comes: an answer of the document."""
    content = json.dumps(body).encode("utf-8", "replace")
    headers = {"content-type": "application/json"}
    response = ask("POST", path, content=content, headers=headers)
    told = openapi_document()["paths"][path]["post"]["responses"]
    assert str(response.status_code) in told, (response.status_code, response.text)
    assert response.headers["content-type"].startswith("application/json")
    if response.status_code != 200:
        assert response.json()["error"]["message"]


@pytest.mark.sweep
@pytest.mark.parametrize("mode", ["positive", "negative"])
@pytest.mark.parametrize("path", _SMALL)
def test_bodies_made_from_the_document_are_answered_or_refused(path: str, mode: str) -> None:
    @settings(max_examples=20, suppress_health_check=list(HealthCheck), phases=[Phase.generate])
    @given(_strategy(path, mode))
    def run(case: Any) -> None:
        body = case.body if isinstance(case.body, dict | list | str | int | float | None) else {}
        _checked(path, body)

    run()


_EXAMPLES = pytest.mark.parametrize("examples", [6, pytest.param(200, marks=pytest.mark.sweep)])
_NAMES = st.sampled_from(sorted(Case.fields()))
_VALUES = st.one_of(
    st.none(), st.booleans(), st.integers(), st.floats(allow_nan=False, allow_infinity=False),
    st.text(max_size=20), st.sampled_from([one.example for one in Case.fields().values()]),
    st.tuples(st.floats(-1e6, 1e6).map(str), st.sampled_from(["N", "mm", "rpm"])).map(" ".join),
    st.lists(st.integers(), max_size=3),
    st.dictionaries(st.text(max_size=5), st.integers(), max_size=2),
)  # fmt: skip


@_EXAMPLES
def test_any_settings_are_answered_or_refused(examples: int) -> None:
    @settings(max_examples=examples, suppress_health_check=list(HealthCheck))
    @given(
        st.sampled_from(["6310", "7210 C", "NU 208", "x", ""]),
        st.dictionaries(st.one_of(_NAMES, st.text(max_size=30)), _VALUES, max_size=4),
    )
    def run(designation: str, changes: dict[str, Any]) -> None:
        _checked("/solve", {"designation": designation, "settings": {**LOAD, **changes}})
        _checked("/frequencies", {"designation": designation, "settings": changes})

    run()


_JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(max_size=10),
    lambda inner: (
        st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=8), inner, max_size=3)
    ),
    max_leaves=8,
)


_KEYS = st.sampled_from(
    ["case", "designation", "settings", "test", "fields", "bearings", "speed", "times", "outputs",
     "methods", "tolerances", "hysteresis"]
)  # fmt: skip


@_EXAMPLES
def test_any_json_is_answered_or_refused(examples: int) -> None:
    @settings(max_examples=examples, suppress_health_check=list(HealthCheck))
    @given(
        st.sampled_from(_SMALL),
        st.dictionaries(_KEYS | st.text(), _JSON, min_size=1, max_size=4),
    )
    def run(path: str, body: dict[str, Any]) -> None:
        _checked(path, body)

    run()


def test_what_overflows_is_null() -> None:
    """A speed so small that a life in hours is beyond all numbers: no request ends by it."""
    duty = {"inner_speed": "1e-320 rpm", "load": {"fx": "1 kN", "fz": "5 kN"}}
    case = {"bearing": {"designation": "6310/C3"}, "duty": duty}
    found = json.loads(api._done("/analyse", {"case": case}))
    assert found["status"]["converged"]
