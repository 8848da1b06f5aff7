"""What qualifies a verdict on vibration, or lives and torques over a field, stands with it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.io import wavfile
from tests.properties.test_headlines import FEET, keys_below

from rolamento import Case, tasks
from rolamento.document import Document
from rolamento.pages.anderon import anderon_page
from rolamento.pages.diagnosis import diagnosis_page
from rolamento.pages.frequencies import frequencies_page
from rolamento.pages.friction_over import friction_over_page
from rolamento.pages.life_over import life_over_page
from rolamento.pages.notes import about
from rolamento.pages.severity import severity_page
from rolamento.pages.study import study_page
from rolamento.studies import Axis, Study, run_to_file
from rolamento.studies.friction_curves import friction_curve
from rolamento.studies.ranges import read_range
from rolamento.tasks import DiagnosisResult
from rolamento.words import Note
from rolamento.words.headlines import over_cases, qualifies

RATE = 20_000
OIL = {
    "bearing": {"designation": "6310"},
    "duty": {"inner_speed": "1500 rpm", "load": {"fz": "5 kN"}},
    "lubricant": "ISO VG 68",
    "temperature": {"lubricant": "70 degC"},
}


@pytest.fixture(scope="module")
def record(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Half a second of whole numbers that nobody calibrated."""
    path = tmp_path_factory.mktemp("signals") / "record.wav"
    random = np.random.default_rng(7)
    wavfile.write(path, RATE, (3e3 * random.standard_normal(RATE // 2)).astype(np.int16))
    return path


def check(page: Document, notes: tuple[Note, ...], heads: set[str], *, besides: str = "") -> None:
    """Whatever qualifies stands below the verdict, and the rest at the end."""
    leading = {note.key for note in notes if qualifies(note)} - {besides}
    assert leading, "nothing to be tested"
    assert leading <= keys_below(page, heads)
    assert not leading & keys_below(page, FEET)
    assert {note.key for note in notes} <= keys_below(page, heads | FEET)


@pytest.fixture(scope="module")
def calibrated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same as numbers with a unit, sampled too slowly for all bands."""
    path = tmp_path_factory.mktemp("signals") / "calibrated.csv"
    random = np.random.default_rng(7)
    np.savetxt(path, 1e-3 * random.standard_normal(1000), fmt="%.9f")
    return path


def test_severity(calibrated: Path) -> None:
    found = tasks.VibrationSeverity(signals=calibrated, unit="m/s^2", rate=1000.0).run()
    check(severity_page(found), (*found.notes, *found.measured[0].notes), {"verdict"})


def test_noise(calibrated: Path) -> None:
    found = tasks.NoiseLevel(signals=calibrated, unit="um/s", rate=1000.0).run()
    (one,) = found.measured
    page = anderon_page(found)
    check(page, (*one.notes, *one.choices), {page.sections[0].key})


def test_diagnosis(record: Path) -> None:
    found = tasks.diagnose(record, "6205", speed="600 rpm")
    assert isinstance(found, DiagnosisResult)
    page = diagnosis_page(found)
    said_already = {note.key for note in found.statement}
    notes = tuple(note for note in found.notes if note.key not in said_already)
    scale = {"bits_to_full_scale", "full_scale_unknown", "samples_not_calibrated"}
    check(page, tuple(note for note in notes if note.key not in scale), {"verdict"})
    # which the scale of the samples does not change
    assert not scale & keys_below(page, {"verdict"})


def test_frequencies() -> None:
    found = tasks.fault_frequencies("NU 205", speed="1500 rpm")
    check(frequencies_page(found), found.notes, {"given"})


def test_lives_over_a_field_say_what_they_leave_out_and_where() -> None:
    dry = Case.model_validate({**OIL, "lubricant": None, "temperature": {}})
    curve = tasks.life_curve(dry, "duty.load.fz=1..80kN")
    by_key = {note.key: where for note, where in curve.cautions}
    assert by_key["lubrication_left_out"].any()
    high = by_key["contact_pressure_high"]
    assert high[-1]
    assert not high[0]
    page = life_over_page([curve])
    assert set(by_key) <= keys_below(page, {"life"})


def test_torques_over_a_field_say_what_qualifies_them_and_where() -> None:
    curve = friction_curve(Case.model_validate(OIL), read_range("duty.load.fz=1..80kN"))
    by_key = {note.key: where for note, where in curve.cautions}
    assert by_key["contact_pressure_high"][-1]
    assert not by_key["contact_pressure_high"][0]
    said_otherwise = {"coefficient_by_regime", "no_valid_torque_model", "inertia", "full_film"}
    page = friction_over_page([curve])
    assert set(by_key) - said_otherwise <= keys_below(page, {"torque_0"})


def test_a_study_says_what_qualifies_the_ends_of_its_ranges(tmp_path: Path) -> None:
    study = Study(
        case=Case.model_validate(OIL),
        outputs=("inner_load", "life_hours"),
        axes=(Axis(field="duty.load.fz", values=(1e3, 5e3, 90e3)),),
    )
    found = run_to_file(study, tmp_path / "study.nc")
    by_key = {note.key: count for note, count in found.cautions}
    assert found.ends == 2
    assert by_key["contact_pressure_high"] == 1  # of the heaviest load, at both races
    assert by_key["cleanliness_missing"] >= 1
    assert "coefficient_by_regime" not in by_key  # no output is of friction
    assert set(by_key) <= keys_below(study_page(found), {"ranges"})


def test_a_note_on_some_of_several_signals_names_them() -> None:
    doubt, remark = Note("speed_unknown"), Note("scaled_by_sensitivity", {"sensitivity": 1.0})
    leading, rest = about([("one", [doubt, remark]), ("other", [remark])])
    (block,) = leading
    assert [(one.key, one.tone) for one in block.remarks] == [("speed_unknown", "warning")]
    assert block.remarks[0].text.endswith("(one)")
    assert [section.key for section in rest] == ["notes"]


def test_notes_of_many_cases_are_gathered_by_key() -> None:
    known, remark = Note("of_a_later_release", {"a": 1}), Note("balls_unloaded")
    ((note, where),) = over_cases([(), (known, remark), (Note(known.key, {"a": 2}),)])
    assert note == known
    assert where.tolist() == [False, True, True]
