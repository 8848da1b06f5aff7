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
from rolamento.report.diagnosis import (
    CSV_COLUMNS,
    diagnosis_csv,
    diagnosis_json,
    diagnosis_report,
)
from rolamento.report.diagnosis_sentences import (
    said_chance,
    said_note,
    said_reasons,
    said_result,
    said_statements,
)
from rolamento.report.diagnosis_words import DIAGNOSIS_WORDS

from rolamento import Bearing, Case, Duty, Load
from rolamento.document.medium import Medium
from rolamento.report.language import LANGUAGES, words_for
from rolamento.solution import solve
from rolamento.status import NOT_CONVERGED
from rolamento.tasks.diagnosis import DiagnosisResult
from rolamento.tasks.shaft_speed import ShaftSpeed, Tracking
from rolamento.vibration import diagnosis as engine
from rolamento.vibration.diagnosis import (
    Diagnosis,
    DiagnosisSettings,
    FaultOrders,
    Reason,
    UnexplainedLine,
    diagnose,
)
from rolamento.vibration.frequencies import frequencies_of, nominal_frequencies
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
        assert {"harmonics_above_noise", "hidden", "of_first", "speed_open"} <= reasons
        assert {"few_revolutions", "one_band"} <= notes
        said = DIAGNOSIS_WORDS[language]
        assert reasons - set(said.reason) - set(said.note) == set()
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
        depth = {part.component: part.depth for part in found.diagnosis.components}
        first = "outer" if depth["outer_race"] > depth["inner_race"] else "inner"
        assert found.diagnosis.faults[0] == f"{first}_race"
        assert statements[0].startswith(f"The {first} race is ")
        assert f"modulation depth {100 * depth[f'{first}_race']:.0f} %." in statements[0]
        assert page(found, "en").startswith(f"The {first} race is ")

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
        expected = part.nominal_order * found.diagnosis.shaft_frequency
        assert cells[2] == f"{expected:.2f}"
        assert expected == pytest.approx(FREQUENCIES.ball_pass_outer.frequency, rel=2e-3)
        assert cells[3] == f"{part.frequency:.2f}"
        assert cells[5] == f"{100 * part.depth:.0f}"
        assert cells[6] == f"{part.evidence:.1f}"
        assert cells[7] == "damaged"

    def test_reasons_of_faults(self) -> None:
        text = squeezed(page(damaged(), "en"))
        assert re.search(
            r"Sidebands at a spacing of (1 order|0\.99\d* orders|1\.\d+ orders),", text
        )
        assert "Modulation depth " in text
        assert "mais do que rolamentos sadios têm" in squeezed(page(damaged(), "pt"))

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
        for name in ("band", "depth"):
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
        assert by_name["outer_race"]["reasons"][0]["name"] == "depth"
        assert by_name["outer_race"]["grade"] == damaged().diagnosis.of("outer_race").grade
        assert by_name["outer_race"]["depth"] == damaged().diagnosis.of("outer_race").depth
        assert data["grade"] in ("damage", "severe")
        assert (data["watched"], data["undecided"]) == ([], [])
        assert data["speed_factor"] == damaged().diagnosis.speed_factor
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


def with_spacing(order: float) -> Diagnosis:
    """A diagnosis whose inner race has its nearest sideband so many orders away."""
    found = damaged().diagnosis
    part = found.of("inner_race")
    line = replace(part.lines[0], multiple=1.0, sideband=1, order=part.order + order)
    changed = replace(
        part, sidebands=(line,), reasons=(Reason("sidebands", "as the engine has it"),)
    )
    return replace(found, components=(changed,))


class TestGrammar:
    @pytest.mark.parametrize(
        ("spacing", "english", "portuguese"),
        [
            (1.0, "a spacing of 1 order,", "um espaçamento de 1 ordem,"),
            (0.3975, "a spacing of 0.3975 orders,", "um espaçamento de 0,3975 ordem,"),
            (1.25, "a spacing of 1.25 orders,", "um espaçamento de 1,25 ordem,"),
            (2.0, "a spacing of 2 orders,", "um espaçamento de 2 ordens,"),
        ],
    )
    def test_orders_are_counted(self, spacing: float, english: str, portuguese: str) -> None:
        found = with_spacing(spacing)
        assert english in said_reasons(found.components[0], found, "en")[0]
        assert portuguese in said_reasons(found.components[0], found, "pt")[0]

    def test_one_multiple_is_not_counted(self) -> None:
        found = damaged().diagnosis
        part = found.of("outer_race")
        line = replace(part.lines[0], multiple=1.0, sideband=0, above_noise=12.0)
        reason = Reason("harmonics_above_noise", "as the engine has it")
        one = replace(part, lines=(line,), reasons=(reason,))
        assert said_reasons(one, found, "en")[0].startswith("At order 3.5")
        assert said_reasons(one, found, "pt")[0].startswith("Na ordem 3,5")

    @pytest.mark.parametrize(
        ("deviation", "said"),
        [
            (0.0, "At the expected order."),
            (-4e-5, "At the expected order."),
            (6e-5, "0.01 % above the expected order."),
            (-0.02, "2.00 % below the expected order."),
        ],
    )
    def test_no_deviation_has_no_side(self, deviation: float, said: str) -> None:
        found = damaged().diagnosis
        reasons = (Reason("off_nominal", "as the engine has it"),)
        part = replace(found.of("outer_race"), deviation=deviation, reasons=reasons)
        assert said_reasons(part, found, "en") == [said]


def unchanging() -> DiagnosisResult:
    """What the engine says of a signal that does not change; the first part of it does."""
    reason = Reason("no_change", "The signal does not change.")
    found = sound()
    parts = tuple(
        replace(part, verdict="not_tested", reasons=(reason,))
        for part in found.diagnosis.components
    )
    return replace(found, diagnosis=replace(found.diagnosis, components=parts))


class TestNoChange:
    def test_it_is_no_verdict(self) -> None:
        found = unchanging()
        assert (found.verdict, found.still) == ("no_verdict", True)
        assert said_result(found, "en") == ["No verdict: the signal does not change."]
        assert "Not tested" not in page(found, "en")

    @pytest.mark.parametrize(
        ("language", "said"),
        [
            ("en", "The signal does not change: most samples only repeat the one before."),
            ("pt", "O sinal não varia: a maioria das amostras só repete a anterior."),
        ],
    )
    def test_reason_is_said(self, language: str, said: str) -> None:
        found = unchanging().diagnosis
        assert said_reasons(found.components[0], found, language) == [said]

    def test_a_still_beginning_is_not_a_still_signal(self) -> None:
        found = still()
        longer = replace(found, duration=2.0 * found.duration, diagnosis=sound().diagnosis)
        assert found.still
        assert not longer.still
        assert longer.verdict == "nothing_found"


def line(**changed: Any) -> UnexplainedLine:
    """A line that nothing explains."""
    plain = UnexplainedLine(
        order=1.776,
        frequency=53.2,
        above_noise=14.2,
        depth=0.31,
        band=(3000.0, 4500.0),
        probability=1e-6,
        shaft_frequencies=(),
    )
    return replace(plain, **changed)


def with_lines(*lines: UnexplainedLine) -> DiagnosisResult:
    note = Reason("unexplained_lines", "The engine's words.")
    found = sound()
    return replace(found, diagnosis=replace(found.diagnosis, unexplained=lines, notes=(note,)))


class TestNotesWithNumbers:
    @pytest.mark.parametrize(
        ("language", "said"),
        [("en", "were left out; used: 7."), ("pt", "ficaram de fora; usados: 7.")],
    )
    def test_stretches_that_were_left_out(self, language: str, said: str) -> None:
        found = replace(sound().diagnosis, blocks=7)
        assert said_note(Reason("still_blocks", "?"), found, language).endswith(said)


class TestUnexplainedLines:
    def test_one(self) -> None:
        text = squeezed(page(with_lines(line()), "en"))
        assert "explains a line that stands out of the envelope's spectrum: 53.20 Hz (order" in text
        assert (
            "(order 1.776), depth 31 %, 14 dB above the noise between 3000 and 4500 Hz. Check the"
            in text
        )
        assert "The engine's words." not in text
        assert text.startswith("Nothing found")
        assert "Other lines do: see the notes." in text

    def test_several_the_clearest_first_and_the_rest_counted(self) -> None:
        lines = [line(frequency=60.0 + i, depth=0.1 + 0.01 * i) for i in range(7)]
        note = said_note(Reason("unexplained_lines", ""), with_lines(*lines).diagnosis, "pt")
        assert note.startswith("Nenhuma parte deste rolamento e nenhum múltiplo do eixo explicam")
        assert note.index("66,00 Hz") < note.index("65,00 Hz") < note.index("62,00 Hz")
        assert "61,00 Hz" not in note
        assert note.endswith("; mais 2. Confira a rotação e o rolamento.")

    def test_at_which_speed_it_would_be_whose(self) -> None:
        speeds: Any = (("outer_race", 28.0), ("inner_race", 25.0))
        (note,) = with_lines(line(shaft_frequencies=speeds)).diagnosis.notes
        english = said_note(note, with_lines(line(shaft_frequencies=speeds)).diagnosis, "en")
        assert english.endswith(
            "It would be the lowest line of: outer race at 1680 rpm and inner race at 1500 rpm."
        )

    @pytest.mark.parametrize("language", LANGUAGES)
    def test_without_lines_the_note_is_said_all_the_same(self, language: str) -> None:
        note = said_note(Reason("unexplained_lines", "?"), with_lines().diagnosis, language)
        assert note == DIAGNOSIS_WORDS[language].note["unexplained_lines"]

    def test_json_has_them(self) -> None:
        data = json.loads(diagnosis_json(with_lines(line(above_noise=float("nan")))))
        (own,) = data["unexplained"]
        assert own["order"] == 1.776
        assert own["band"] == [3000.0, 4500.0]
        assert own["above_noise"] is None
        assert data["notes"][0]["name"] == "unexplained_lines"


class TestGrades:
    """What a reader sees in ten seconds: verdict, what to do, what speaks against it."""

    def one(self, verdict: str, grade: str, *doubts: Reason, **changed: Any) -> DiagnosisResult:
        found = sound()
        known = damaged().diagnosis.of("outer_race")
        part: Any = replace(known, verdict=verdict, grade=grade, depth=0.4, doubts=doubts)
        others = found.diagnosis.components[1:]
        told = replace(found.diagnosis, components=(part, *others), **changed)
        return replace(found, diagnosis=told)

    def test_damage(self) -> None:
        text = squeezed(page(self.one("fault", "damage"), "en"))
        assert text.startswith("The outer race is damaged: ")
        assert "modulation depth 40 %. Do: measure again soon, and plan to replace" in text
        assert "Against it: nothing in this record." in text
        doubts = Reason("on_mains", ""), Reason("close_call", "")
        text = squeezed(page(self.one("fault", "damage", *doubts), "pt"))
        assert "é múltiplo de 50 ou 60 Hz" in text
        assert "perto do limite de 30 %" in text
        assert squeezed(page(self.one("fault", "severe"), "en")).startswith(
            "The outer race is severely damaged: "
        )

    def test_watch(self) -> None:
        found = self.one("watch", "watch")
        assert found.verdict == "watch"
        text = squeezed(page(found, "en"))
        assert text.startswith("No damage stated. Watch the outer race: ")
        assert "as many healthy bearings have. Do: nothing now" in text
        data = json.loads(diagnosis_json(found))
        assert (data["verdict"], data["faults"]) == ("watch", [])
        assert data["watched"] == ["outer_race"]

    def test_undecided(self) -> None:
        doubt = Reason("stronger_line", "")
        found = self.one("undecided", "damage", doubt, unexplained=(line(depth=0.55),))
        assert found.verdict == "undecided"
        text = squeezed(page(found, "en"))
        assert text.startswith("Not decided: ")
        assert "A line at 53.20 Hz (order 1.776) that the part does not explain is as deep" in text
        assert json.loads(diagnosis_json(found))["verdict"] == "undecided"

    def test_another_speed_is_the_headline(self) -> None:
        told = replace(sound().diagnosis, undecided=(("inner_race", 980.0 / 60.0),))
        found = replace(sound(), diagnosis=told)
        assert found.verdict == "undecided"
        text = squeezed(page(found, "en"))
        assert text.startswith(
            "Not decided: damage to the inner race if the shaft ran at 980 rpm. Do: find out the"
        )
        data = json.loads(diagnosis_json(found))
        assert data["undecided"][0]["component"] == "inner_race"

    def test_a_ball_or_the_cage(self) -> None:
        cage: Any = replace(
            damaged().diagnosis.of("outer_race"), component="cage", verdict="fault", depth=0.4
        )
        told = replace(sound().diagnosis, components=(*sound().diagnosis.components[:3], cage))
        found = replace(sound(), diagnosis=told)
        assert page(found, "en").startswith("A ball or the cage is ")
        assert json.loads(diagnosis_json(found))["faults"] == ["ball_or_cage"]


@cache
def pressed() -> Any:
    """A state with the balls at an angle."""
    load = Load(fx="2 kN", fz="2 kN")
    return solve(Case(bearing=BEARING, duty=Duty(inner_speed="1797 rpm", load=load)))


class TestFrequencies:
    def test_of_the_geometry(self) -> None:
        text = squeezed(page(sound(), "en"))
        assert "frequencies of the geometry, contact angle 0° shaft" in text
        assert "cage within 2 % of its nominal speed; noise alone gives" in text

    @pytest.mark.parametrize("language", LANGUAGES)
    def test_of_the_loaded_bearing(self, language: str) -> None:
        state = pressed()
        loaded = frequencies_of(state)
        found = replace(
            sound(),
            frequencies=loaded,
            solved=state,
            slip=0.001,
            settings=replace(sound().settings, tolerance=0.0123),
        )
        text = squeezed(page(found, language))
        order = f"{loaded.cage.order:.4f}"
        if language == "en":
            assert "frequencies of the loaded bearing, mean contact angle " in text
            assert f"cage order {order}, " in text
            assert f"{loaded.cage.minimum:.4f} to {loaded.cage.maximum:.4f} over the balls" in text
            assert "cage within 1.23 % of its speed under load, wider than --slip to cover" in text
        else:
            assert "frequências do rolamento sob carga, ângulo de contato médio" in text
            assert f"ordem da gaiola {order.replace('.', ',')}, de " in text
            assert "gaiola a até 1,23 % da sua rotação sob carga, mais do que --slip" in text
        data = json.loads(diagnosis_json(found))
        assert data["frequencies"]["source"] == "loaded"
        assert (data["slip"], data["state"]["converged"]) == (0.001, True)

    @pytest.mark.parametrize(
        ("language", "said"),
        [
            ("en", "those of the geometry. The case has no solution: "),
            ("pt", "são as da geometria. O caso não tem solução: "),
        ],
    )
    def test_no_solution(self, language: str, said: str) -> None:
        status = replace(pressed().status, number=np.array([NOT_CONVERGED]))
        failed = replace(pressed(), status=status, written_advice=(None,))
        found = replace(sound(), solved=failed)
        text = squeezed(page(found, language))
        assert said + words_for(language).reasons["not_converged"] in text
        names = [note["name"] for note in json.loads(diagnosis_json(found))["notes"]]
        assert "no_loaded_frequencies" in names

    def test_no_ball_pressed(self) -> None:
        text = squeezed(page(replace(sound(), solved=pressed()), "en"))
        assert "those of the geometry. The inner ring presses on no ball" in text

    def test_what_was_not_looked_for(self) -> None:
        found = replace(sound(), covers_balls=False, other_rows=(1, 2))
        text = squeezed(page(found, "en"))
        assert "the orders of some balls are more than 2 % off" in text
        assert "The orders of row 1 and row 2 are others, and were not looked for" in text


class TestSpeed:
    def test_given(self) -> None:
        found = replace(sound(), speed=ShaftSpeed.steady("given", SPEED))
        text = squeezed(page(found, "en"))
        assert "shaft 1797 rpm (29.95 Hz), as given; the shaft's own lines do not tell it" in text
        told = replace(found.diagnosis, speed_factor=1.02, shaft_frequency=30.549)
        text = squeezed(page(replace(found, diagnosis=told), "en"))
        assert "by the shaft's own lines; 1797 rpm as given, −2.0 % signal" in text
        assert json.loads(diagnosis_json(found))["speed"]["mean"] == pytest.approx(SPEED)

    @pytest.mark.parametrize(
        ("speed", "english", "portuguese"),
        [
            (
                ShaftSpeed("channel", SPEED, 0.9 * SPEED, 1.1 * SPEED, channel="n"),
                "mean 1797 rpm (29.95 Hz), from 1617.3 to 1976.7 rpm, of the channel n",
                "em média 1797 rpm (29,95 Hz), de 1617,3 a 1976,7 rpm, do canal n",
            ),
            (
                ShaftSpeed("pulses", SPEED, 0.9 * SPEED, 1.1 * SPEED, channel="k", pulses=1),
                "by the pulses of the channel k, 1 a revolution",
                "pelos pulsos do canal k, 1 por volta",
            ),
            (
                ShaftSpeed(
                    *("vibration", SPEED, 0.9 * SPEED, 1.1 * SPEED),
                    tracking=Tracking(1800 * pi / 30, 0.1, True, 8.0),
                ),
                "found in the vibration within 10 % of 1800 rpm",
                "encontrada na vibração a até 10 % de 1800 rpm",
            ),
        ],
    )
    def test_along(self, speed: ShaftSpeed, english: str, portuguese: str) -> None:
        found = replace(sound(), speed=speed)
        assert english in squeezed(page(found, "en", 120))
        assert portuguese in squeezed(page(found, "pt", 120))
        assert not speed.is_steady

    def test_lost_means_no_verdict_unless_there_is_a_fault(self) -> None:
        tracking = Tracking(1800 * pi / 30, 0.1, False, 0.2, lost=(10.0, 63.5))
        speed = replace(ShaftSpeed.steady("given", SPEED), tracking=tracking)
        found = replace(sound(), speed=speed)
        assert found.verdict == "no_verdict"
        text = squeezed(page(found, "en"))
        assert text.startswith("No verdict: the speed was not found in the vibration")
        assert "taken as steady: it was not found in the vibration" in text
        assert "From 10 to 63.5 s the shaft does not stand out" in text
        assert json.loads(diagnosis_json(found))["speed"]["tracking"]["lost"] == [10.0, 63.5]
        faulty = replace(damaged(), speed=speed)
        assert faulty.verdict == "fault"
        assert "race is damaged" in said_result(faulty, "en")[0]
