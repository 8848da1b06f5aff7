"""The page of a diagnosis: every sentence in both languages, numbers as the engine found them."""

from __future__ import annotations

import ast
import csv
import json
import re
from dataclasses import fields, replace
from functools import cache
from io import StringIO
from math import pi
from pathlib import Path
from string import Formatter
from typing import Any

import numpy as np
import pytest

from rolamento import Bearing
from rolamento.report.diagnosis import (
    CSV_COLUMNS,
    DiagnosisResult,
    diagnosis_csv,
    diagnosis_json,
    diagnosis_report,
)
from rolamento.report.diagnosis_sentences import (
    said_chance,
    said_note,
    said_reasons,
    said_statements,
)
from rolamento.report.diagnosis_words import DIAGNOSIS_WORDS
from rolamento.report.language import LANGUAGES, words_for
from rolamento.report.medium import Medium
from rolamento.vibration import diagnosis as engine
from rolamento.vibration.diagnosis import DiagnosisSettings, FaultOrders, Reason, diagnose
from rolamento.vibration.frequencies import nominal_frequencies
from rolamento.vibration.signal import Signal
from rolamento.vibration.synthesis import Fault, LoadDistribution, Noise, Recipe, synthesise

BEARING = Bearing.named("6205")
SPEED = 1797.0 * pi / 30.0
FREQUENCIES = nominal_frequencies(BEARING, SPEED)


def result(signal: Signal) -> DiagnosisResult:
    settings = DiagnosisSettings()
    return DiagnosisResult(
        title="drive end",
        bearing_name="6205",
        bearing=BEARING,
        frequencies=FREQUENCIES,
        diagnosis=diagnose(signal, FaultOrders.of(FREQUENCIES), settings),
        settings=settings,
        signal=signal,
        duration=signal.duration,
    )


@cache
def damaged() -> DiagnosisResult:
    """Both races."""
    recipe = Recipe(
        frequencies=FREQUENCIES,
        faults=(Fault(kind="outer_race"), Fault(kind="inner_race", strength=1.5)),
        load=LoadDistribution.radial(), noise=Noise(ratio=0.0), duration=8.0, rate=12_000.0,
    )  # fmt: skip
    return result(synthesise(recipe).signal)


@cache
def sound() -> DiagnosisResult:
    noise = np.random.default_rng(5).normal(size=60_000)
    return result(Signal(noise, 12_000.0, "acceleration", "m/s^2", np.asarray(SPEED)))


@cache
def still() -> DiagnosisResult:
    return result(Signal(np.ones(60_000), 12_000.0, "acceleration", "m/s^2", np.asarray(SPEED)))


def page(found: DiagnosisResult, language: str, width: int = 80) -> str:
    return diagnosis_report(found, words_for(language), Medium(width=width))


def squeezed(text: str) -> str:
    return " ".join(text.split())


def names_in_engine(*calls: str) -> set[str]:
    """Names of reasons and notes as the engine's source has them."""
    found: set[str] = set()
    for path in Path(engine.__file__).parent.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            match node:
                case ast.Call(func=ast.Name(id=name), args=[ast.Constant(value=value), *_]):
                    found |= {str(value)} if name in calls else set()
            if isinstance(node, ast.AnnAssign) and getattr(node.target, "id", "") == "_UNTESTED":
                assert isinstance(node.value, ast.Dict)
                if "Reason" in calls:
                    found |= {str(ast.literal_eval(key)) for key in node.value.keys if key}
    return found


class TestWords:
    @pytest.mark.parametrize("language", LANGUAGES)
    def test_every_reason_and_note_of_the_engine_is_said(self, language: str) -> None:
        reasons, notes = names_in_engine("Reason"), names_in_engine("Note")
        assert {"harmonics_above_noise", "hidden", "cage_agrees"} <= reasons
        assert {"few_revolutions", "one_band"} <= notes
        said = DIAGNOSIS_WORDS[language]
        assert reasons - set(said.reason) == set()
        assert notes - set(said.note) == set()

    def test_both_languages_say_the_same_things(self) -> None:
        english, portuguese = DIAGNOSIS_WORDS["en"], DIAGNOSIS_WORDS["pt"]
        for field in fields(english):
            one, other = getattr(english, field.name), getattr(portuguese, field.name)
            if isinstance(one, str):
                assert holes(one) == holes(other), field.name
            elif isinstance(one, dict):
                assert set(one) == set(other), field.name
                for key in one:
                    assert holes(one[key]) == holes(other[key]), (field.name, key)
            elif isinstance(one, tuple):
                assert len(one) == len(other), field.name
                assert list(map(holes, one)) == list(map(holes, other)), field.name
            else:
                assert field.name == "one_below"

    def test_unknown_reason_is_said_in_the_engine_s_words(self) -> None:
        found = damaged().diagnosis
        odd = replace(found.components[0], reasons=(Reason("odd", "Odd."),))
        assert said_reasons(odd, found, "pt") == ["Odd."]
        assert said_note(Reason("odd", "Odd."), found, "pt") == "Odd."

    @pytest.mark.parametrize(
        ("evidence", "said"),
        [
            (8.5229, "at most 3e-9"),
            (8.0, "at most 1e-8"),
            (2.001, "at most 1e-2"),
            (0.0, "at most 1"),
            (0.301, "at most 0.5"),
            (151.0, "below 1e-15"),
        ],
    )
    def test_probabilities(self, evidence: float, said: str) -> None:
        assert said_chance(evidence, DIAGNOSIS_WORDS["en"]) == said


def holes(text: str) -> set[str | None]:
    return {name for _, name, _, _ in Formatter().parse(text) if name}


class TestStatement:
    def test_faults_come_first_the_clearest_before_the_other(self) -> None:
        found = damaged()
        assert set(found.diagnosis.faults) == {"outer_race", "inner_race"}
        statements = said_statements(found.diagnosis, "en")
        evidence = {part.component: part.evidence for part in found.diagnosis.components}
        first = "outer" if evidence["outer_race"] > evidence["inner_race"] else "inner"
        assert statements[0].startswith(f"The {first} race is damaged: ")
        assert page(found, "en").startswith(f"The {first} race is damaged")

    def test_frequency_is_the_one_that_was_found(self) -> None:
        found = damaged().diagnosis
        text = " ".join(said_statements(found, "en"))
        assert f"at {found.of('outer_race').frequency:.1f} Hz" in text

    def test_nothing_found_names_what_was_looked_for(self) -> None:
        text = squeezed(page(sound(), "en"))
        assert text.startswith("Nothing found: no lines of outer race, inner race, ball and cage")
        assert "damage too weak for its noise stays unseen" in text
        assert sound().verdict == "nothing_found"

    def test_a_signal_that_does_not_change_has_no_verdict(self) -> None:
        assert still().verdict == "no_verdict"
        assert page(still(), "pt").startswith("Sem veredito: o sinal não varia.")

    def test_untested_parts_are_named(self) -> None:
        found = sound().diagnosis
        parts = tuple(
            replace(part, verdict="not_tested") if part.component == "cage" else part
            for part in found.components
        )
        statements = said_statements(replace(found, components=parts), "en")
        assert statements[-1] == "Not tested: cage."
        nothing = tuple(replace(part, verdict="not_tested") for part in parts)
        assert said_statements(replace(found, components=nothing), "en") == [
            DIAGNOSIS_WORDS["en"].no_verdict
        ]


class TestPage:
    @pytest.mark.parametrize("language", LANGUAGES)
    @pytest.mark.parametrize("width", [80, 120])
    def test_lines_fit(self, language: str, width: int) -> None:
        for found in (damaged(), sound(), still()):
            lines = page(found, language, width).splitlines()
            assert max(map(len, lines)) <= width

    @pytest.mark.parametrize("language", LANGUAGES)
    def test_plain_terminals(self, language: str) -> None:
        text = diagnosis_report(damaged(), words_for(language), Medium(encoding="ascii"))
        assert text.isascii()
        assert "?" not in text

    def test_table_has_the_engine_s_numbers(self) -> None:
        found = damaged()
        part = found.diagnosis.of("outer_race")
        row = next(
            line for line in page(found, "en").splitlines() if line.startswith("  outer race  ")
        )
        cells = row.split()
        assert cells[2] == f"{FREQUENCIES.ball_pass_outer.frequency:.2f}"
        assert cells[3] == f"{part.frequency:.2f}"
        assert cells[5] == f"{part.evidence:.1f}"
        assert cells[6] == "damaged"

    def test_reasons_of_faults(self) -> None:
        text = squeezed(page(damaged(), "en"))
        assert re.search(r"Sidebands at a spacing of (1 order|0\.99\d* orders|1\.\d+ orders),", text)
        assert "It tells of the same cage speed as the inner race." in text
        assert "Indica a mesma rotação da gaiola que a pista externa." in squeezed(
            page(damaged(), "pt")
        )

    def test_lines_that_hardly_stand_out_are_warned_of(self) -> None:
        found = damaged()
        assert "weak_lines" not in found.own_notes
        parts = tuple(
            replace(part, lines=tuple(replace(line, above_noise=4.0) for line in part.lines))
            for part in found.diagnosis.components
        )
        weak = replace(found, diagnosis=replace(found.diagnosis, components=parts))
        assert "weak_lines" in weak.own_notes
        assert "Check the speed, the bearing, and the picture." in squeezed(page(weak, "en"))

    def test_english_reasons_agree_with_the_engine(self) -> None:
        found = damaged().diagnosis
        part = found.of("outer_race")
        ours = dict(
            zip((r.name for r in part.reasons), said_reasons(part, found, "en"), strict=True)
        )
        engine_s = {reason.name: reason.text for reason in part.reasons}
        for name in ("band", "cage_agrees"):
            assert ours[name] == engine_s[name]


class TestData:
    def test_json_is_strict_and_holds_the_verdicts(self) -> None:
        def refuse(constant: str) -> None:
            raise AssertionError(constant)

        data: dict[str, Any] = json.loads(diagnosis_json(damaged()), parse_constant=refuse)
        assert data["kind"] == "diagnosis"
        assert data["verdict"] == "fault"
        assert set(data["faults"]) == {"outer_race", "inner_race"}
        by_name = {part["component"]: part for part in data["components"]}
        assert by_name["cage"]["frequency"] is None
        assert by_name["outer_race"]["lines"][0]["multiple"] == 1
        assert by_name["outer_race"]["reasons"][0]["name"] == "harmonics_above_noise"
        assert data["signal"]["indicators"]["rms"] == pytest.approx(damaged().indicators.rms)

    def test_csv_is_the_spectrum_that_was_searched(self) -> None:
        rows = list(csv.reader(StringIO(diagnosis_csv(damaged()), newline="")))
        assert tuple(rows[0]) == CSV_COLUMNS
        found = damaged().diagnosis
        bands = {part.band for part in found.components if part.band}
        assert len(rows) - 1 == len(bands) * len(found.spectra.order)
        part = found.of("outer_race")
        assert part.band is not None
        own = [row for row in rows[1:] if float(row[0]) == part.band[0] and row[4]
               and float(row[1]) == part.band[1]]  # fmt: skip
        strongest = max(
            (row for row in own if abs(float(row[3]) - part.frequency) < 1.0),
            key=lambda row: float(row[4]),
        )
        assert float(strongest[4]) > 15.0

    def test_csv_of_nothing_found_is_of_one_band(self) -> None:
        rows = diagnosis_csv(sound()).splitlines()
        assert len(rows) - 1 == len(sound().diagnosis.spectra.order)
