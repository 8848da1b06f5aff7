"""Why a case has no result: the rule it violates, the same by every door, per case and in words."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import numpy as np
import openpyxl
import pytest
from typer.testing import CliRunner

from rolamento import Case, InputError, load_case, solve
from rolamento.cli.app import app
from rolamento.document.tables import to_csv
from rolamento.pages.study import study_page
from rolamento.plots.study import first_reason, inputs, outputs
from rolamento.studies import Axis, Study, load_result, run, run_to_file
from rolamento.tasks import studies
from rolamento.words import speaking

RPM = np.pi / 30.0
SIZES = [0.125, 0.01, np.nan, -1.0]
ANGLES = [2.0, 0.7, 0.7, 0.7]


@pytest.fixture
def pair() -> Case:
    """A spindle pair whose rows lose their free contact angle at speed; balls of steel."""
    return Case(
        bearing={"designation": "7014 C DB", "preload": "240 N"},
        duty={"inner_speed": "15000 rpm", "load": {"fx": "400 N", "fz": "800 N"}},
        mounting={"shaft_tolerance": "js4", "housing_tolerance": "JS5"},
        temperature={"inner_ring": "48 degC", "outer_ring": "42 degC"},
    )


def test_a_set_without_free_contact_angle_converges_in_a_batch_too(pair: Case) -> None:
    speeds = np.array([34e3, 15e3, 25e3, 20e3]) * RPM
    many = solve(pair, inner_speed=speeds)
    assert many.converged.all()
    assert (many.rows.free_contact_angle[:, 0] == 0.0).tolist() == [True, False, True, False]
    for index, speed in enumerate(speeds):
        one = solve(pair.with_({"duty.inner_speed": float(speed)}))
        np.testing.assert_allclose(many.inner.load[index], one.inner.load[0], rtol=1e-9)
        np.testing.assert_allclose(many.stiffness.array[index], one.stiffness.array[0], rtol=1e-9,
                                   atol=1e-9 * one.stiffness.array.max())  # fmt: skip
        np.testing.assert_array_equal(many[index].outer.load[0], many.outer.load[index])
    some = many[np.array([3, 0, 3])]
    np.testing.assert_array_equal(some.inner.load, many.inner.load[[3, 0, 3]])
    assert len(many[:0].inner.load) == 0


def test_what_closes_a_set_is_refused_with_the_words_of_a_single_case(pair: Case) -> None:
    many = solve(pair, {"mounting.shaft_interference": [0.0, 300e-6]})
    assert many.status.code.tolist() == ["converged", "invalid_input"]
    note = many.advice[1]
    assert note is not None
    with pytest.raises(InputError, match="closes the bearing") as refused:
        solve(pair.with_({"mounting.shaft_interference": 300e-6}))
    assert note.text == str(refused.value)


@pytest.mark.parametrize("place", range(4))
def test_the_rule_is_that_of_the_case_by_itself(case_218: Case, place: int) -> None:
    names = ("bearing.pitch_diameter", "bearing.contact_angle")
    many = solve(case_218, dict(zip(names, (SIZES, ANGLES), strict=True)))
    note = many.advice[place]
    assert many.status.code[place] == "invalid_input"
    assert note is not None
    assert note.key == "invalid_input"
    field = names[0] if place else names[1]
    assert note.values["field"] == field
    with pytest.raises(InputError) as refused:
        case_218.with_({name: v[place] for name, v in zip(names, (SIZES, ANGLES), strict=True)})
    assert refused.value.field == field
    assert refused.value.rule in note.text
    assert many[place].advice[0] == note
    with speaking("pt"):
        assert "deve ser" in note.text


def test_a_valid_case_has_no_reason(case_218: Case) -> None:
    assert solve(case_218, fx=[20e3, 21e3]).advice == (None, None)


STUDY = {
    "outputs": ("x", "max_inner_max_pressure"),
    "axes": [Axis(field="bearing.pitch_diameter", values=["125.26 mm", "20 mm", "10 mm"])],
}


def test_every_case_of_a_study_has_its_reason(case_218: Case, tmp_path: Path) -> None:
    study = Study(case=case_218, **STUDY)
    kept = run(study)
    assert kept.reason.values.tolist() == [-1, 0, 1]
    texts = kept.reason_text.values[kept.reason.values[1:]]
    assert ["20 mm" in texts[0], "10 mm" in texts[1]] == [True, True]
    assert "20 mm" in first_reason(kept)
    assert "reason_text" not in inputs(kept)
    assert "reason" not in outputs(kept)
    summary = run_to_file(study, tmp_path / "result.nc", chunk=1)
    read = load_result(tmp_path / "result.nc")
    assert read.reason.values.tolist() == [-1, 0, 1]
    assert read.reason_text.values.tolist() == kept.reason_text.values.tolist()
    assert summary.first["invalid_input"].case == 1
    page = to_csv(study_page(summary), "failures")
    assert "2,invalid input" in page
    run_to_file(study, tmp_path / "result.csv")
    lines = list(csv.DictReader(io.StringIO((tmp_path / "result.csv").read_text("utf-8"))))
    assert [line["reason"] for line in lines] == ["", *texts]


def test_a_result_without_failures_has_no_reasons(case_218: Case) -> None:
    whole = run(Study(case=case_218, outputs=("x",), axes=[Axis(field="duty.load.fx", values=["20 kN", "21 kN"])]))  # fmt: skip  # noqa: E501
    assert "reason" not in whole
    assert first_reason(whole) == ""


def test_the_tables_of_a_sweep_hold_its_cases(
    examples: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    case = load_case(examples / "218_combined.toml")
    axes = [
        Axis(field="duty.inner_speed", values=["0 rpm", "9000 rpm"]), *STUDY["axes"]  # type: ignore[misc]
    ]  # fmt: skip
    study = Study(case=case, outputs=STUDY["outputs"], axes=axes)
    swept = studies.sweep(study, "result.xlsx", keep_cases=True)
    heads = ["inner_speed [rpm]", "pitch_diameter [mm]", "status", "reason", "x [µm]",
             "max_inner_max_pressure [MPa]"]  # fmt: skip
    (sheet,) = openpyxl.load_workbook("result.xlsx").worksheets
    rows = [[cell.value for cell in row] for row in sheet.iter_rows()]
    assert rows[0] == heads
    assert [row[0] for row in rows[1:]] == [0, 0, 0, 9000, 9000, 9000]
    assert [row[2] for row in rows[1:4]] == ["converged", "invalid_input", "invalid_input"]
    single = solve(case.with_({"duty.inner_speed": 9000 * RPM}))
    assert rows[4][5] == pytest.approx(1e-6 * single.inner.max_pressure.max(), rel=1e-9)
    text = to_csv(study_page(swept.summary))
    assert text.splitlines()[0] == (
        "inner_speed_rpm,pitch_diameter_mm,status,reason,x_um,max_inner_max_pressure_MPa"
    )
    assert len(text.splitlines()) == 7
    si = to_csv(study_page(swept.summary), si=True).splitlines()
    assert si[0].startswith("inner_speed_rad_per_s,pitch_diameter_m")
    assert float(si[4].split(",")[0]) == pytest.approx(9000 * RPM)


def test_a_preload_that_takes_no_range_names_the_one_that_does(examples: Path) -> None:
    found = CliRunner().invoke(
        app,
        ["friction", str(examples / "6012_pair.toml"), "--over", "bearing.preload=5..100N"],
        env={"LC_ALL": "C.UTF-8"},
    )
    assert found.exit_code == 2
    assert "bearing.preload.force" in found.stderr
