"""What the page's scripts work out by themselves, run by Node where there is one."""

from __future__ import annotations

import json
import shutil
import subprocess
from typing import Any

import pytest

from rolamento.web.form import form, units
from rolamento.web.server import PAGE

_NODE = shutil.which("node")
pytestmark = pytest.mark.skipif(_NODE is None, reason="Node is not installed")

_PRELUDE = """
import * as units from "PAGE/units.js";
import * as share from "PAGE/share.js";
import { Store, valueAt, withValue } from "PAGE/store.js";
import { readFileSync } from "node:fs";
const given = JSON.parse(readFileSync(0, "utf-8"));
const tell = (found) => process.stdout.write(JSON.stringify(found));
"""


def _run(script: str, given: object = None) -> Any:
    assert _NODE is not None
    text = (_PRELUDE + script).replace("PAGE", PAGE.as_uri())
    done = subprocess.run(
        [_NODE, "--input-type=module", "--eval", text],
        input=json.dumps(given),
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_numbers_are_read_as_the_language_writes_them() -> None:
    script = """
    const found = {};
    for (const mark of [".", ","]) {
      units.useUnits(given, mark);
      found[mark] = ["2,5", "2.5", "1.480", "1.480,5 N", "-3e-4", "abc", "12.5 kN",
        "18 1/GPa", "1 480 rpm"].map(units.typed);
    }
    tell(found);
    """
    found = _run(script, units())
    assert [one["text"] for one in found[","]] == [
        "2.5", "2.5", "1.480", "1480.5 N", "-3e-4", "abc", "12.5 kN", "18 1/GPa",
        "1480 rpm",
    ]  # fmt: skip
    assert [n for n, one in enumerate(found[","]) if "doubt" in one] == [2]
    assert found[","][2]["doubt"] == {"decimal": "1,480", "whole": "1480"}
    assert [one["text"] for one in found["."]][:3] == ["2,5", "2.5", "1.480"]
    assert not any("doubt" in one for one in found["."])


def test_units_convert_to_and_fro() -> None:
    script = """
    units.useUnits(given, ".");
    tell(Object.keys(given).flatMap((dimension) => units.unitsOf(dimension).map((unit) =>
      units.fromSi(units.toSi(37.5, unit), unit))));
    """
    assert _run(script, units()) == pytest.approx([37.5] * sum(map(len, units().values())))


def test_sliders_stay_within_the_bounds_of_their_fields() -> None:
    fields = [field for group in form() for field in group["fields"] if field["kind"] == "number"]
    script = """
    units.useUnits(given.units, ".");
    tell(given.fields.map((field) => {
      const example = units.exampleOf(field);
      return [example, -example, 0].map((value) => ({ value, ...units.reach(field, value) }));
    }));
    """
    found = _run(script, {"fields": fields, "units": units()})
    for field, ranges in zip(fields, found, strict=True):
        limits = field["limits"]
        low = limits.get("at_least", limits.get("above", float("-inf")))
        high = limits.get("at_most", limits.get("below", float("inf")))
        assert ranges[0]["value"] is not None, field["name"]
        for one in ranges:
            if not low <= one["value"] <= high:
                continue
            assert low <= one["low"] <= one["value"] <= one["high"] <= high, field["name"]
            assert one["low"] < one["high"], field["name"]
            assert not one["log"] or one["low"] > 0.0, field["name"]


def test_a_link_gives_the_cases_back_and_refuses_all_else() -> None:
    script = """
    const pack = (cases, more = {}) => share.packed({ cases, active: 0, ...more });
    const part = await share.packed(given);
    const back = await share.unpacked(part);
    const odd = await pack([{}, {}], { names: [7, " x ".repeat(40)], active: 9 });
    const bomb = await pack([{ title: "x".repeat(2_000_000) }]);
    const bad = ["", "%%", "AAAA", part.slice(0, -6), "A".repeat(300_000), bomb,
      await pack("text"), await pack([]), await pack([1]), await pack([{}, {}, {}, {}, {}])];
    const asked = bad.map((one) => share.unpacked(one).then(() => "", () => "refused"));
    const refused = await Promise.all(asked);
    const taken = await share.unpacked(odd);
    tell({ back, odd: taken, refused, letters: part.length, small: bomb.length < 200_000 });
    """
    given = {
        "cases": [{"bearing": {"designation": "6310/C3"}, "duty": {}}, {"title": "é ≠ 球"}, {}],
        "names": ["as drawn", "", "belt too tight"],
        "active": 2,
    }
    found = _run(script, given)
    assert found["back"] == given
    assert found["odd"]["active"] == 0
    assert found["odd"]["names"][0] == ""
    assert len(found["odd"]["names"][1]) == 40
    assert found["refused"] == ["refused"] * 10
    assert found["small"]


def test_what_was_changed_is_undone_step_by_step() -> None:
    script = """
    const store = new Store();
    const told = [];
    const now = () => told.push(store.slots.map((one) => one.case.duty.load));
    const answer = (load, error = null) =>
      ({ case: { duty: { load } }, error, elements: ["ball"], inputs: {} });
    const take = (load, quick, error) => {
      const asked = store.asked;
      store.take(store.slots.map((one, n) =>
        (n === store.active ? answer(load, error) : answer(one.case.duty.load))), asked);
      if (!quick && !error) store.settled();
    };
    store.open([answer(1)]);
    store.change("load", 2); take(2, true);
    store.change("load", 3); take(3, false);  // one drag is one step
    store.change("speed", 9); take(9, true, { field: "speed" });
    now(); told.push(store.canUndo, store.current.error.field, store.current.changes);
    store.undo(); now(); told.push(store.current.error);
    store.compare(); store.change("load", 5); take(5, false); now();
    store.undo(); now(); store.undo(); now(); store.undo(); now();
    told.push(store.canUndo, store.canRedo);
    store.redo(); now();
    tell(told);
    """
    assert _run(script) == [
        [3], True, "speed", {"speed": 9}, [3], None, [3, 5], [3, 3], [3], [1], False, True, [3],
    ]  # fmt: skip


def test_values_are_put_into_tables_by_their_dotted_names() -> None:
    script = """
    const tables = { bearing: { rows: [{ position: "1 mm" }], preload: "500 N" } };
    const forced = withValue(tables, "bearing.preload.force", "1 kN");
    const changed = withValue(forced, "duty.load.fz", "2 N");
    tell([changed, withValue(changed, "duty.load.fz", null).duty, tables.bearing.preload,
      ...["bearing.rows.0.position", "bearing.preload.force", "duty.load"]
        .map((name) => valueAt(tables, name) ?? null)]);
    """
    assert _run(script) == [
        {
            "bearing": {"rows": [{"position": "1 mm"}], "preload": {"force": "1 kN"}},
            "duty": {"load": {"fz": "2 N"}},
        },
        {"load": {}}, "500 N", "1 mm", None, None,
    ]  # fmt: skip
