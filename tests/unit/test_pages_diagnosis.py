"""The page of a diagnosis: every sentence in both languages, numbers as the engine found them."""

from __future__ import annotations

import csv
import json
import re
from dataclasses import replace
from functools import cache
from io import StringIO
from math import pi
from typing import Any

import numpy as np
import pytest

from rolamento import Bearing, Case, Duty, Load
from rolamento.document.medium import Medium
from rolamento.document.tables import to_csv
from rolamento.document.terminal import terminal
from rolamento.io.json import dumps
from rolamento.pages.diagnosis import diagnosis_page
from rolamento.solution import solve
from rolamento.status import NOT_CONVERGED
from rolamento.tasks.diagnosis import DiagnosisResult
from rolamento.tasks.shaft_speed import ShaftSpeed, Tracking
from rolamento.vibration.diagnosis import (
    DiagnosisSettings,
    FaultOrders,
    UnexplainedLine,
    diagnose,
)
from rolamento.vibration.frequencies import frequencies_of, nominal_frequencies
from rolamento.vibration.signal import Signal
from rolamento.vibration.synthesis import Fault, LoadDistribution, Noise, Recipe, synthesise
from rolamento.words import Note, languages, speaking

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
        found=diagnose(signal, FaultOrders.of(FREQUENCIES), settings),
        settings=settings,
        record=signal,
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
def healthy() -> DiagnosisResult:
    noise = np.random.default_rng(5).normal(size=60_000)
    return result(Signal(noise, 12_000.0, "acceleration", "m/s^2", np.asarray(SPEED)))


@cache
def still() -> DiagnosisResult:
    return result(Signal(np.ones(60_000), 12_000.0, "acceleration", "m/s^2", np.asarray(SPEED)))


def page(found: DiagnosisResult, language: str, width: int = 80, encoding: str = "utf-8") -> str:
    with speaking(language):
        return terminal(diagnosis_page(found), Medium(width=width, encoding=encoding))


def said(note: Note, language: str = "en") -> str:
    with speaking(language):
        return note.text


def data_of(found: DiagnosisResult) -> dict[str, Any]:
    def refuse(constant: str) -> None:
        raise AssertionError(constant)

    data: dict[str, Any] = json.loads(dumps(found.to_mapping()), parse_constant=refuse)
    return data


def squeezed(text: str) -> str:
    return " ".join(text.split())


class TestWords:
    @pytest.mark.parametrize(
        ("evidence", "text"),
        [
            (8.5229, "at most 3e-9,"),
            (8.0, "at most 1e-8,"),
            (2.001, "at most 1e-2,"),
            (0.0, "at most 1,"),
            (0.301, "at most 0.5,"),
            (151.0, "below 1e-15,"),
        ],
    )
    def test_probabilities(self, evidence: float, text: str) -> None:
        note = Note("improbable_in_noise", {"evidence": evidence, "trials": 51_000})
        assert text in note.text
        assert "all 51 000 trials counted" in note.text

    def test_reasons_are_the_same_in_json_and_on_the_page(self) -> None:
        text = squeezed(page(damaged(), "en"))
        for part in data_of(damaged())["components"]:
            for note in (*part["reasons"], *part["doubts"]):
                assert note.keys() == {"key", "text", "values"}
                assert note["text"] in text


class TestStatement:
    def test_faults_come_first_the_clearest_before_the_other(self) -> None:
        found = damaged()
        assert set(found.diagnosis.faults) == {"outer_race", "inner_race"}
        statements = [note.text for note in found.statement]
        depth = {part.component: part.depth for part in found.diagnosis.components}
        first = "outer" if depth["outer_race"] > depth["inner_race"] else "inner"
        assert found.diagnosis.faults[0] == f"{first}_race"
        assert statements[0].startswith(f"The {first} race is ")
        assert f"modulation depth {100 * depth[f'{first}_race']:.0f} %." in statements[0]
        assert page(found, "en").startswith(f"The {first} race is ")

    def test_frequency_is_the_one_that_was_found(self) -> None:
        found = damaged().diagnosis
        text = " ".join(note.text for note in found.statement())
        assert f"at {found.of('outer_race').frequency:.1f} Hz" in text

    def test_nothing_found_names_what_was_looked_for(self) -> None:
        text = squeezed(page(healthy(), "en"))
        assert text.startswith("Nothing found: no peaks of outer race, inner race, ball and cage")
        assert "damage too weak for its noise remains undetected" in text
        assert healthy().verdict == "nothing_found"

    def test_a_signal_that_does_not_change_has_no_verdict(self) -> None:
        assert still().verdict == "no_verdict"
        assert page(still(), "pt").startswith("Sem veredito: o sinal não varia.")

    def test_untested_parts_are_named(self) -> None:
        found = healthy().diagnosis
        parts = tuple(
            replace(part, verdict="not_tested") if part.component == "cage" else part
            for part in found.components
        )
        statement = replace(found, components=parts).statement()
        assert statement[-1] == Note("parts_untested", {"parts": ["cage"]})
        assert statement[-1].text == "Not tested: cage."
        nothing = tuple(replace(part, verdict="not_tested") for part in parts)
        assert replace(found, components=nothing).statement() == (Note("no_part_tested"),)


class TestPage:
    @pytest.mark.parametrize("language", languages())
    @pytest.mark.parametrize("width", [80, 120])
    def test_lines_fit(self, language: str, width: int) -> None:
        for found in (damaged(), healthy(), still()):
            lines = page(found, language, width).splitlines()
            assert max(map(len, lines)) <= width

    @pytest.mark.parametrize("language", languages())
    def test_plain_terminals(self, language: str) -> None:
        text = page(damaged(), language, encoding="ascii")
        assert text.isascii()
        assert "?" not in text

    def test_table_has_the_engine_s_numbers(self) -> None:
        found = damaged()
        part = found.diagnosis.of("outer_race")
        row = next(
            line for line in page(found, "en").splitlines() if line.startswith("  outer race BPFO")
        )
        cells = row.split()
        expected = part.nominal_order * found.diagnosis.shaft_frequency
        assert cells[3] == f"{expected:.2f}"
        assert expected == pytest.approx(FREQUENCIES.ball_pass_outer.frequency, rel=2e-3)
        assert cells[4] == f"{part.frequency:.2f}"
        assert cells[6] == f"{100 * part.depth:.0f}"
        assert cells[7] == f"{part.evidence:.1f}"
        assert cells[8] == "damaged"

    def test_reasons_of_faults(self) -> None:
        text = squeezed(page(damaged(), "en"))
        assert re.search(r"Sidebands at ±(1|0\.99\d*|1\.\d+) × shaft speed:", text)
        assert "Modulation depth " in text
        assert "mais do que em rolamentos sem defeito" in squeezed(page(damaged(), "pt"))

    def test_lines_that_hardly_stand_out_are_warned_of(self) -> None:
        found = damaged()
        assert "weak_peaks" not in [note.key for note in found.notes]
        parts = tuple(
            replace(part, lines=tuple(replace(line, above_noise=4.0) for line in part.lines))
            for part in found.diagnosis.components
        )
        weak = replace(found, found=replace(found.diagnosis, components=parts))
        assert "weak_peaks" in [note.key for note in weak.notes]
        assert "Check the speed, the bearing and the figure." in squeezed(page(weak, "en"))


class TestData:
    def test_json_is_strict_and_holds_the_verdicts(self) -> None:
        data = data_of(damaged())
        assert (data["schema"], data["kind"]) == (3, "diagnosis")
        assert data["verdict"] == "fault"
        assert set(data["faults"]) == {"outer_race", "inner_race"}
        by_name = {part["component"]: part for part in data["components"]}
        assert by_name["cage"]["frequency"] is None
        assert by_name["outer_race"]["lines"][0]["multiple"] == 1
        assert by_name["outer_race"]["reasons"][0]["key"] == "modulation_depth"
        assert by_name["outer_race"]["grade"] == damaged().diagnosis.of("outer_race").grade
        assert by_name["outer_race"]["depth"] == damaged().diagnosis.of("outer_race").depth
        assert data["grade"] in ("damage", "severe")
        assert (data["watched"], data["undecided"]) == ([], [])
        assert data["speed_factor"] == damaged().diagnosis.speed_factor
        assert data["signal"]["indicators"]["rms"] == pytest.approx(damaged().indicators.rms)

    def test_csv_is_the_spectrum_that_was_searched(self) -> None:
        rows = list(csv.reader(StringIO(to_csv(diagnosis_page(damaged())), newline="")))
        header = ["band_low_Hz", "band_high_Hz", "order", "frequency_Hz", "over_noise_dB"]
        assert rows[0] == header
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
        rows = to_csv(diagnosis_page(healthy())).splitlines()
        assert len(rows) - 1 == len(healthy().diagnosis.spectra.order)


class TestGrammar:
    @pytest.mark.parametrize(
        ("spacing", "english", "portuguese"),
        [
            (1.0, "±1 × shaft speed", "±1 × a rotação do eixo"),
            (0.3975, "±0.3975 × shaft speed", "±0,3975 × a rotação do eixo"),
        ],
    )
    def test_sidebands(self, spacing: float, english: str, portuguese: str) -> None:
        note = Note("sidebands", {"spacing": spacing, "strongest": 12.3, "carrier": "ring"})
        assert english in said(note)
        assert said(note).endswith("as the ring turns. The strongest is 12 dB above the noise.")
        assert portuguese in said(note, "pt")

    def test_one_multiple_is_not_counted(self) -> None:
        values = {"order": 3.5777, "frequency": 107.2, "multiples": [1.0], "levels": [12.0]}
        note = Note("harmonics_above_noise", values)
        assert said(note).startswith("The squared envelope has a peak at order 3.5777 (107.2 Hz)")
        assert said(note, "pt").startswith("O envelope ao quadrado tem um pico na ordem 3,5777")

    @pytest.mark.parametrize(
        ("deviation", "text"),
        [
            (0.0, "At the expected order."),
            (-4e-5, "At the expected order."),
            (6e-5, "0.01 % above the expected order."),
            (-0.02, "2.00 % below the expected order."),
        ],
    )
    def test_no_deviation_has_no_side(self, deviation: float, text: str) -> None:
        assert Note("off_nominal", {"deviation": deviation}).text == text


def unchanging() -> DiagnosisResult:
    """What the engine says of a signal that does not change; the first part of it does."""
    reason = Note("no_change")
    found = healthy()
    parts = tuple(
        replace(part, verdict="not_tested", reasons=(reason,))
        for part in found.diagnosis.components
    )
    return replace(found, found=replace(found.diagnosis, components=parts))


class TestNoChange:
    def test_it_is_no_verdict(self) -> None:
        found = unchanging()
        assert (found.verdict, found.still) == ("no_verdict", True)
        assert [note.text for note in found.statement] == [
            "No verdict: the signal does not change."
        ]
        assert "Not tested" not in page(found, "en")

    def test_a_still_beginning_is_not_a_still_signal(self) -> None:
        found = still()
        longer = replace(found, duration=2.0 * found.duration, found=healthy().diagnosis)
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
    peaks = sorted(lines, key=lambda one: -one.depth)
    note = Note("unexplained_peaks", {"peaks": [one.to_mapping() for one in peaks]})
    found = healthy()
    return replace(found, found=replace(found.diagnosis, unexplained=lines, notes=(note,)))


class TestUnexplainedLines:
    def test_one(self) -> None:
        text = squeezed(page(with_lines(line()), "en"))
        assert "by no multiple of the shaft speed: 53.20 Hz (order" in text
        assert (
            "(order 1.776), depth 31 %, 14 dB above the noise between 3000 and 4500 Hz. Check the"
            in text
        )
        assert text.startswith("Nothing found")
        assert "Other peaks are there, the deepest at 53.20 Hz, modulation depth 31 %:" in text

    def test_several_the_clearest_first_and_the_rest_counted(self) -> None:
        lines = [line(frequency=60.0 + i, depth=0.1 + 0.01 * i) for i in range(7)]
        note = said(with_lines(*lines).diagnosis.notes[0], "pt")
        assert note.startswith("Nenhuma parte deste rolamento e nenhum múltiplo da rotação do eixo")
        assert note.index("66,00 Hz") < note.index("65,00 Hz") < note.index("62,00 Hz")
        assert "61,00 Hz" not in note
        assert note.endswith("; mais 2. Confira a rotação e o rolamento.")

    def test_at_which_speed_it_would_be_whose(self) -> None:
        speeds: Any = (("outer_race", 28.0), ("inner_race", 25.0))
        (note,) = with_lines(line(shaft_frequencies=speeds)).diagnosis.notes
        assert note.text.endswith(
            "It would be the lowest peak of: outer race at 1680 rpm and inner race at 1500 rpm."
        )

    def test_json_has_them(self) -> None:
        data = data_of(with_lines(line(above_noise=float("nan"))))
        (own,) = data["unexplained"]
        assert own["order"] == 1.776
        assert own["band"] == [3000.0, 4500.0]
        assert own["above_noise"] is None
        assert data["notes"][0]["key"] == "unexplained_peaks"


class TestGrades:
    """What a reader sees in ten seconds: verdict, what to do, what speaks against it."""

    def one(self, verdict: str, grade: str, *doubts: Note, **changed: Any) -> DiagnosisResult:
        found = healthy()
        known = damaged().diagnosis.of("outer_race")
        part: Any = replace(known, verdict=verdict, grade=grade, depth=0.4, doubts=doubts)
        others = found.diagnosis.components[1:]
        told = replace(found.diagnosis, components=(part, *others), **changed)
        return replace(found, found=told)

    def test_damage(self) -> None:
        text = squeezed(page(self.one("fault", "damage"), "en"))
        assert text.startswith("The outer race is damaged: ")
        assert "modulation depth 40 %. Recommendation: measure again soon and plan to" in text
        assert "Evidence against: none in this record." in text
        doubts = Note("on_mains", {"frequency": 100.0}), Note("close_call", {"limit": 0.3})
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
        # of 40 %: as deep as damage, without impacts
        assert text.startswith("No damage stated. Watch the outer race: ")
        assert "a smooth modulation without impacts. Recommendation: compare with records" in text
        data = data_of(found)
        assert (data["verdict"], data["faults"]) == ("watch", [])
        assert data["watched"] == ["outer_race"]

    def test_undecided(self) -> None:
        doubt = Note("stronger_peak", {"frequency": 53.2, "order": 1.776, "depth": 0.55})
        found = self.one("undecided", "damage", doubt, unexplained=(line(depth=0.55),))
        assert found.verdict == "undecided"
        text = squeezed(page(found, "en"))
        assert text.startswith("Undecided: ")
        assert "A peak at 53.20 Hz (order 1.776) that this part does not explain is as deep" in text
        assert data_of(found)["verdict"] == "undecided"

    def test_another_speed_is_the_headline(self) -> None:
        told = replace(healthy().diagnosis, undecided=(("inner_race", 980.0 / 60.0),))
        found = replace(healthy(), found=told)
        assert found.verdict == "undecided"
        text = squeezed(page(found, "en"))
        assert text.startswith(
            "Undecided: damage to the inner race if the shaft ran at 980 rpm. Recommendation:"
        )
        data = data_of(found)
        assert data["undecided"][0]["component"] == "inner_race"

    def test_a_ball_or_the_cage(self) -> None:
        cage: Any = replace(
            damaged().diagnosis.of("outer_race"), component="cage", verdict="fault", depth=0.4
        )
        told = replace(healthy().diagnosis, components=(*healthy().diagnosis.components[:3], cage))
        found = replace(healthy(), found=told)
        assert page(found, "en").startswith("A ball or the cage is ")
        assert data_of(found)["faults"] == ["ball_or_cage"]


@cache
def pressed() -> Any:
    """A state with the balls at an angle."""
    load = Load(fx="2 kN", fz="2 kN")
    return solve(Case(bearing=BEARING, duty=Duty(inner_speed="1797 rpm", load=load)))


class TestFrequencies:
    def test_of_the_geometry(self) -> None:
        text = squeezed(page(healthy(), "en"))
        assert "frequencies by the geometry, contact angle 0° shaft" in text
        assert "cage within 2 % of its nominal speed noise alone gives" in text

    @pytest.mark.parametrize("language", languages())
    def test_of_the_loaded_bearing(self, language: str) -> None:
        state = pressed()
        loaded = frequencies_of(state)
        found = replace(
            healthy(),
            frequencies=loaded,
            solved=state,
            slip=0.001,
            settings=replace(healthy().settings, tolerance=0.0123),
        )
        text = squeezed(page(found, language))
        order = f"{loaded.cage.order:.4f}"
        if language == "en":
            assert "frequencies under load, mean contact angle " in text
            assert f"cage order {order}, " in text
            assert f"{loaded.cage.minimum:.4f} to {loaded.cage.maximum:.4f} over the balls" in text
            assert "cage within 1.23 % of its speed under load wider than slip, to cover" in text
        else:
            assert "frequências sob carga, ângulo de contato médio" in text
            assert f"ordem da gaiola {order.replace('.', ',')}, de " in text
            assert "gaiola a até 1,23 % da sua rotação sob carga mais do que slip" in text
        data = data_of(found)
        assert data["frequencies"]["source"] == "loaded"
        assert (data["slip"], data["state"]["converged"]) == (0.001, True)

    @pytest.mark.parametrize(
        ("language", "said"),
        [
            ("en", "The case has no solution: not converged"),
            ("pt", "O caso não tem solução: não convergiu"),
        ],
    )
    def test_no_solution(self, language: str, said: str) -> None:
        status = replace(pressed().status, number=np.array([NOT_CONVERGED]))
        failed = replace(pressed(), status=status, written_advice=(None,))
        found = replace(healthy(), solved=failed)
        text = squeezed(page(found, language))
        assert said in text
        names = [note["key"] for note in data_of(found)["notes"]]
        assert "no_loaded_frequencies" in names

    def test_no_ball_pressed(self) -> None:
        text = squeezed(page(replace(healthy(), solved=pressed()), "en"))
        assert "those of the geometry. The inner ring is in contact with no ball" in text

    def test_what_was_not_looked_for(self) -> None:
        found = replace(healthy(), covers_balls=False, other_rows=(1, 2))
        text = squeezed(page(found, "en"))
        assert "the orders of some balls deviate by more than 2 %" in text
        assert "The orders of row 1 and row 2 differ and were not searched" in text


class TestSpeed:
    def test_given(self) -> None:
        found = replace(healthy(), speed=ShaftSpeed.steady("given", SPEED))
        text = squeezed(page(found, "en"))
        assert "shaft 1797 rpm (29.95 Hz) as given not confirmed by the shaft's own peaks" in text
        told = replace(found.diagnosis, speed_factor=1.02, shaft_frequency=30.549)
        text = squeezed(page(replace(found, found=told), "en"))
        assert "by the shaft's own peaks, +2.0 % from 1797 rpm as given signal" in text
        assert data_of(found)["speed"]["mean"] == pytest.approx(SPEED)

    @pytest.mark.parametrize(
        ("speed", "english", "portuguese"),
        [
            (
                ShaftSpeed("channel", SPEED, 0.9 * SPEED, 1.1 * SPEED, channel="n"),
                "mean 1797 rpm (29.95 Hz), from 1617.3 to 1976.7 rpm from the channel n",
                "em média 1797 rpm (29,95 Hz), de 1617,3 a 1976,7 rpm do canal n",
            ),
            (
                ShaftSpeed("pulses", SPEED, 0.9 * SPEED, 1.1 * SPEED, channel="k", pulses=1),
                "from the pulses of the channel k, 1 per revolution",
                "dos pulsos do canal k, 1 por volta",
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
        found = replace(healthy(), speed=speed)
        assert english in squeezed(page(found, "en", 120))
        assert portuguese in squeezed(page(found, "pt", 120))
        assert not speed.is_steady

    def test_lost_means_no_verdict_unless_there_is_a_fault(self) -> None:
        tracking = Tracking(1800 * pi / 30, 0.1, False, 0.2, lost=(10.0, 63.5))
        speed = replace(ShaftSpeed.steady("given", SPEED), tracking=tracking)
        found = replace(healthy(), speed=speed)
        assert found.verdict == "no_verdict"
        text = squeezed(page(found, "en"))
        assert text.startswith("No verdict: the speed was not found in the vibration")
        assert "taken as constant: it was not found in the vibration" in text
        assert "From 10 to 63.5 s the shaft does not stand out" in text
        assert data_of(found)["speed"]["tracking"]["lost"] == [10.0, 63.5]
        faulty = replace(damaged(), speed=speed)
        assert faulty.verdict == "fault"
        assert "race is damaged" in faulty.statement[0].text
