"""Keep or replace: remaining life, age replacement, fleets; records, tables and commands."""

import json
from datetime import date
from pathlib import Path

import numpy as np
import pytest
from scipy import integrate, stats
from typer.testing import CliRunner

from rolamento import tasks
from rolamento.cli.app import app
from rolamento.errors import InputError
from rolamento.weibull import (
    Fleet,
    LifeDistribution,
    LifeTest,
    age_replacement,
    bounds,
    fleet_forecast,
    read_fleet,
    remaining_life,
)
from rolamento.weibull.fleet import poisson_binomial, renewals
from rolamento.weibull.life_units import life_with_unit
from rolamento.weibull.replacement import cost_rate, optimum_age
from rolamento.weibull.residual import (
    conditional_reliability,
    mean_residual_life,
    residual_life,
)
from rolamento.words import speaking

TIMES = [17.88, 28.92, 33.0, 41.52, 42.12, 45.6, 48.48, 51.84, 51.96, 54.12, 55.56, 67.8]


@pytest.fixture(scope="module")
def fitted() -> LifeDistribution:
    return LifeDistribution.of_test(LifeTest(TIMES, [True] * 12), samples=4000)


class TestRemainingLife:
    def test_without_age_it_is_the_reliability(self) -> None:
        law = LifeDistribution.given(1.7, scale=900.0)
        found = remaining_life(law, 0.0, 400.0)
        assert found.reliability.value == pytest.approx(np.exp(-((400.0 / 900.0) ** 1.7)))
        assert found.reliability.value == found.new

    def test_exponential_lives_do_not_age(self) -> None:
        for age in (0.0, 10.0, 1e5):
            assert conditional_reliability(1.0, 100.0, age, 30.0) == pytest.approx(np.exp(-0.3))
            assert mean_residual_life(1.0, 100.0, age) == pytest.approx(100.0)

    @pytest.mark.parametrize("shape", [0.7, 1.5, 4.0])
    @pytest.mark.parametrize("age", [0.0, 0.2, 1.0, 6.0])
    def test_mean_is_the_integral_of_the_chance(self, shape: float, age: float) -> None:
        scale = residual_life(shape, 1.0, age, 0.01)
        known, _ = integrate.quad(
            lambda x: float(conditional_reliability(shape, 1.0, age, x * float(scale))), 0, np.inf
        )
        found = float(mean_residual_life(shape, 1.0, age))
        assert found == pytest.approx(known * float(scale), rel=1e-6)

    def test_mean_is_smooth_where_the_series_begins(self) -> None:
        for shape in (0.6, 1.5, 3.0):
            ages = (600.0 * np.array([1.0 - 1e-9, 1.0 + 1e-9])) ** (1.0 / shape)
            low, high = (float(mean_residual_life(shape, 1.0, float(age))) for age in ages)
            assert high == pytest.approx(low, rel=1e-7)

    def test_residual_life_is_reached_with_its_probability(self) -> None:
        left = float(residual_life(2.2, 1000.0, 700.0, 0.9))
        assert conditional_reliability(2.2, 1000.0, 700.0, left) == pytest.approx(0.9)

    def test_interval_of_a_new_bearing_is_the_pivotal_bound(self, fitted: LifeDistribution) -> None:
        test = LifeTest(TIMES, [True] * 12)
        known = bounds(test, "R40", samples=4000)
        found = remaining_life(fitted, 0.0, 40.0).reliability
        assert found.value == pytest.approx(known.estimate)
        assert found.lower == pytest.approx(known.lower, abs=2e-3)
        assert found.upper == pytest.approx(known.upper, abs=2e-3)

    @pytest.mark.sweep
    def test_interval_holds_as_often_as_it_says(self) -> None:
        random, held = np.random.default_rng(7), 0
        true = float(conditional_reliability(2.0, 100.0, 60.0, 30.0))
        for run in range(150):
            test = LifeTest(100.0 * random.weibull(2.0, 10), [True] * 10)
            law = LifeDistribution.of_test(test, samples=500, seed=run)
            found = remaining_life(law, 60.0, 30.0, confidence=0.9).reliability
            held += found.lower <= true <= found.upper
        assert held / 150 == pytest.approx(0.9, abs=0.06)

    def test_given_distribution_has_no_interval(self) -> None:
        law = LifeDistribution.given(1.5, l10=20_000.0)
        assert law.scale == pytest.approx(20_000.0 / (-np.log(0.9)) ** (1 / 1.5))
        assert np.isnan(remaining_life(law, 8000.0, 2000.0).reliability.lower)

    def test_known_shape_draws_follow_chi_square(self) -> None:
        test = LifeTest(TIMES, [True] * 12)
        law = LifeDistribution.of_test(test, shape=2.0, samples=20_000)
        low, high = np.quantile(law.scales, [0.05, 0.95])
        known = bounds(test, "scale", shape=2.0)
        assert low == pytest.approx(known.lower, rel=0.01)
        assert high == pytest.approx(known.upper, rel=0.01)


class TestAgeReplacement:
    def test_optimum_is_the_least_of_the_cost(self) -> None:
        for shape, planned, failure in ((1.3, 1.0, 4.0), (2.5, 1.0, 5.0), (6.0, 3.0, 3.5)):
            best = float(optimum_age(shape, 1000.0, planned, failure)[0])
            ages = best * np.linspace(0.9, 1.1, 201)
            costs = cost_rate(ages, shape, 1000.0, planned, failure)
            assert abs(int(np.argmin(costs)) - 100) <= 1

    def test_condition_of_barlow_and_proschan(self) -> None:
        best = float(optimum_age(2.2, 500.0, 2.0, 9.0)[0])
        running, _ = integrate.quad(lambda t: np.exp(-((t / 500.0) ** 2.2)), 0.0, best)
        hazard = 2.2 / 500.0 * (best / 500.0) ** 1.2
        failed = 1.0 - np.exp(-((best / 500.0) ** 2.2))
        assert hazard * running - failed == pytest.approx(2.0 / 7.0, rel=1e-9)

    def test_never_costs_a_failure_a_mean_life(self) -> None:
        law = LifeDistribution.given(1.8, scale=700.0)
        mean = stats.weibull_min(1.8, scale=700.0).mean()
        found = age_replacement(law, 1.0, 6.0)
        assert found.cost_on_failure == pytest.approx(6.0 / mean)
        assert found.cost < found.cost_on_failure
        low, high = found.near
        rates = cost_rate(np.array([low, high]), 1.8, 700.0, 1.0, 6.0)
        assert rates == pytest.approx(1.05 * found.cost)

    def test_optimum_is_in_proportion_to_the_scale(self) -> None:
        small, great = (float(optimum_age(2.0, eta, 1.0, 5.0)[0]) for eta in (1.0, 1e4))
        assert great == pytest.approx(1e4 * small)

    @pytest.mark.parametrize(
        ("shape", "failure", "code"),
        [(1.0, 5.0, "not_worn"), (0.8, 5.0, "not_worn"), (2.0, 1.0, "not_dearer"),
         (2.0, 0.5, "not_dearer"), (1.05, 1.2, "no_saving"), (2.0, 5.0, "optimum")],
    )  # fmt: skip
    def test_when_nothing_is_won_it_says_why(self, shape: float, failure: float, code: str) -> None:
        found = age_replacement(LifeDistribution.given(shape, scale=100.0), 1.0, failure)
        assert found.code == code
        assert found.worthwhile == np.isfinite(found.age.value) == (code == "optimum")

    def test_simulated_costs_agree(self) -> None:
        random = np.random.default_rng(4)
        lives = 100.0 * random.weibull(2.5, 400_000)
        age = float(optimum_age(2.5, 100.0, 1.0, 8.0)[0])
        cost = np.where(lives < age, 8.0, 1.0).sum() / np.minimum(lives, age).sum()
        assert cost == pytest.approx(float(cost_rate(age, 2.5, 100.0, 1.0, 8.0)), rel=0.01)

    def test_uncertainty_is_told(self, fitted: LifeDistribution) -> None:
        found = age_replacement(fitted, 1.0, 10.0)
        assert found.age.lower < found.age.value < found.age.upper
        assert found.saving.lower < found.saving.value
        assert found.no_optimum < 0.01


class TestFleet:
    def test_poisson_binomial_is_the_convolution(self) -> None:
        p, counts = np.array([0.02, 0.3, 0.9]), np.array([5, 2, 3])
        known = np.array([1.0])
        for one, count in zip(p, counts, strict=True):
            known = np.convolve(known, stats.binom.pmf(np.arange(count + 1), count, one))
        assert poisson_binomial(p, counts)[: len(known)] == pytest.approx(known, abs=1e-14)

    def test_poisson_binomial_of_many_is_binomial(self) -> None:
        found = poisson_binomial(np.array([0.001]), np.array([100_000]))
        known = stats.binom.pmf(np.arange(len(found)), 100_000, 0.001)
        assert found == pytest.approx(known, abs=1e-12)
        assert found.sum() == pytest.approx(1.0)

    def test_renewals_of_exponential_lives(self) -> None:
        found = renewals(1.0, 50.0, np.array([0.0, 30.0]), np.array([200.0, 70.0]))
        assert found == pytest.approx([4.0, 1.4], rel=1e-6)

    def test_renewals_come_to_their_asymptote(self) -> None:
        life = stats.weibull_min(2.0)
        known = 25.0 / life.mean() + 0.5 * (life.var() / life.mean() ** 2 - 1.0)
        assert renewals(2.0, 1.0, np.array([0.0]), np.array([25.0])) == pytest.approx(known, 1e-5)

    def test_renewals_of_short_times_are_failures(self) -> None:
        chance = 1.0 - conditional_reliability(3.0, 100.0, 80.0, 5.0)
        found = renewals(3.0, 100.0, np.array([80.0]), np.array([5.0]))
        assert found == pytest.approx(chance, rel=2e-4)

    @pytest.mark.parametrize("renewed", [False, True])
    def test_expected_number_is_the_mean_of_the_draws(self, renewed: bool) -> None:
        law = LifeDistribution.given(2.0, scale=1000.0)
        fleet = Fleet.of([100.0, 800.0, 0.0, 1500.0], [2500.0, 900.0, 1800.0, 10.0], [3, 1, 2, 4])
        found = fleet_forecast(law, fleet, renewed=renewed)
        random = np.random.default_rng(9)
        counts = np.zeros(4000)
        for age, ahead, count in zip(fleet.ages, fleet.ahead, fleet.counts, strict=True):
            for _ in range(count):
                risk = (age / 1000.0) ** 2 + random.exponential(size=4000)
                at = 1000.0 * np.sqrt(risk) - age
                for _ in range(30):
                    counts += at < ahead
                    if not renewed:
                        break
                    at = at + 1000.0 * np.sqrt(random.exponential(size=4000))
        assert found.end.expected == pytest.approx(counts.mean(), rel=0.02)
        low, high = np.quantile(counts, [0.05, 0.95], method="inverted_cdf")
        assert abs(found.end.lower - low) <= 1
        assert abs(found.end.upper - high) <= 1

    def test_certain_distribution_has_the_exact_limits(self) -> None:
        law = LifeDistribution.given(2.0, scale=1000.0)
        found = fleet_forecast(law, Fleet.of([500.0], 300.0, [20]))
        p = 1.0 - float(conditional_reliability(2.0, 1000.0, 500.0, 300.0))
        assert (found.end.lower, found.end.upper) == stats.binom(20, p).interval(0.9)
        assert found.none == pytest.approx((1.0 - p) ** 20)

    def test_uncertainty_widens_the_prediction(self, fitted: LifeDistribution) -> None:
        fleet = Fleet.of([10.0, 30.0], 20.0, [30, 30])
        found = fleet_forecast(fitted, fleet)
        assert found.end.upper - found.end.lower > found.exact[1] - found.exact[0]
        assert [step.expected for step in found.steps] == sorted(s.expected for s in found.steps)

    def test_what_cannot_be_is_refused(self) -> None:
        law = LifeDistribution.given(2.0, scale=1.0)
        with pytest.raises(InputError, match="failures at each place"):
            fleet_forecast(law, Fleet.of([0.0], 1e6), renewed=True)
        for ages, ahead, counts in (([-1.0], 1.0, [1]), ([1.0], np.nan, [1]), ([1.0], 1.0, [0])):
            with pytest.raises(InputError):
                Fleet.of(ages, ahead, counts)


FLEET = """máquina;horímetro (h);situação;horas por dia;local
B-101;12.500,5;em operação;16;torre
B-102;8.200;em operação;24;torre
B-103;0;em operação;8,5;pátio
B-104;9.000;falha;8;pátio
"""
FIELD = """# title: Bombas
horas de operação;situação;quantidade
12.500,5;falha;1
8.200;falha;1
15.320;falha;1
9.870,25;falha;1
21.040;falha;1
6.100;em operação;4
14.000;em operação;6
"""


@pytest.fixture
def tables(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("fleet.csv").write_text(FLEET, encoding="utf-8")
    Path("field.csv").write_text(FIELD, encoding="utf-8")


def run(*arguments: str) -> tuple[int, str]:
    result = CliRunner().invoke(app, ["replace", *arguments])
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result.exit_code, result.output


GIVEN = ("--shape", "2.5", "--scale", "1000 h")


@pytest.mark.usefixtures("tables")
class TestTablesAndCommands:
    def test_fleet_of_a_brazilian_spreadsheet(self) -> None:
        fleet = read_fleet("fleet.csv")
        assert fleet.ages.tolist() == [12500.5, 8200.0, 0.0]
        assert fleet.usage.tolist() == [16.0, 24.0, 8.5]
        assert fleet.names == ("B-101", "B-102", "B-103")
        assert fleet.left_out == 1
        assert [note.values["columns"] for note in fleet.notes] == [["local"]]

    def test_fleet_by_a_date(self) -> None:
        study = tasks.FleetRequest(
            data="field.csv", fleet="fleet.csv", begin="2026-01-01", until=date(2026, 1, 31),
            samples=500,
        ).run()  # fmt: skip
        assert study.found is not None
        assert study.found.fleet.ahead.tolist() == [480.0, 720.0, 255.0]
        assert "fleet_failed_left_out" in [note.key for note in study.notes]

    def test_fleet_of_the_data_itself(self) -> None:
        code, text = run("fleet", "field.csv", "--within", "2000 h", "--samples", "500", "--json")
        found = json.loads(text)
        assert code == 0
        assert found["bearings"] == 10
        assert 0.0 < found["expected"] < 10.0

    def test_remaining(self) -> None:
        code, text = run("remaining", "field.csv", "--age", "8000 h", "--mission", "1 d",
                         "--samples", "500", "--json")  # fmt: skip
        found = json.loads(text)
        assert code == 0
        assert found["mission"] == 24.0
        chance = found["reliability"]
        assert chance["lower"] < chance["value"] < chance["upper"]

    def test_age_with_reasons(self) -> None:
        code, text = run("age", *GIVEN, "--planned-cost", "1", "--failure-cost", "5")
        assert code == 0
        assert text.startswith("Replace at 493.0 h")
        code, text = run("age", "--shape", "1", "--scale", "9 h", "--planned-cost", "1",
                         "--failure-cost", "5")  # fmt: skip
        assert code == 0
        assert text.startswith("Replace on failure")

    def test_one_failure_is_no_distribution(self) -> None:
        Path("one.csv").write_text("time,status\n100,failed\n200,running\n", encoding="utf-8")
        code, text = run("remaining", "one.csv", "--age", "50 h", "--mission", "10 h")
        assert code == 1
        assert "--shape 1.5" in text
        code, _ = run("remaining", "one.csv", "--age", "50 h", "--shape", "1.5")
        assert code == 0

    @pytest.mark.parametrize(
        ("arguments", "words"),
        [
            (("remaining", *GIVEN), "--age"),
            (("remaining", *GIVEN, "--age", "8000"), "--age"),
            (("remaining", "--shape", "2", "--age", "1 h"), "--l10"),
            (("remaining", "field.csv", "--l10", "9 h", "--age", "1 h"), "--l10"),
            (("age", *GIVEN, "--planned-cost", "1"), "--failure-cost"),
            (("age", *GIVEN, "--planned-cost", "-1", "--failure-cost", "5"), "--planned-cost"),
            (("fleet", *GIVEN, "--within", "9 h"), "--fleet"),
            (("fleet", "field.csv"), "--within"),
            (("fleet", "field.csv", "--until", "31/02/2026"), "--until"),
            (("fleet", "field.csv", "--until", "2099-01-01"), "--usage"),
        ],
    )
    def test_wrong_options_are_named(self, arguments: tuple[str, ...], words: str) -> None:
        code, text = run(*arguments)
        assert code == 2
        assert words in text

    def test_pictures(self) -> None:
        for command in (("remaining", "--age", "9 h"),
                        ("age", "--planned-cost", "1", "--failure-cost", "9")):  # fmt: skip
            code, _ = run(*command, *GIVEN, "--plot", f"{command[0]}.png")
            assert code == 0
            assert Path(f"{command[0]}.png").stat().st_size > 5000
        code, _ = run("fleet", "field.csv", "--within", "900 h", "--samples", "200", "--plot",
                      "fleet.svg")  # fmt: skip
        assert code == 0


def test_point_in_thousands_is_asked_for_where_commas_are_decimal() -> None:
    assert life_with_unit("8.000 h", "age") == (8.0, "h")
    with speaking("pt"), pytest.raises(InputError, match="8000"):
        life_with_unit("8.000 h", "age")
    with speaking("pt"):
        assert life_with_unit("8000 h", "age") == (8000.0, "h")


def test_costs_as_the_language_writes_them() -> None:
    costs = ("--planned-cost", "1.250,50", "--failure-cost", "12.000,00")
    code, text = run("age", *GIVEN, *costs, "--lang", "pt")
    assert code == 0
    assert "1250,5\n" in text
    assert "12 000\n" in text
    for cost in ("12.000", "R$ 12", "12.000,0,0", ""):
        costs = ("--planned-cost", "800", "--failure-cost", cost)
        code, text = run("age", *GIVEN, *costs, "--lang", "pt")
        assert code == 2
        assert "--failure-cost" in text
    assert run("age", *GIVEN, "--planned-cost", "1", "--failure-cost", "12.000")[0] == 0
