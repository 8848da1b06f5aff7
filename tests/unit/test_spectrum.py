"""A duty of several steps: Miner, races apart, shares, and what a table may not hold."""

from __future__ import annotations

import re
import time
from pathlib import Path

import numpy as np
import pytest

from rolamento import Case, InputError, load_case, override
from rolamento.errors import FileError
from rolamento.life import life
from rolamento.life.l_able import read_factor_table
from rolamento.solution import solve
from rolamento.tasks.life_spectrum import SpectrumLife, life_of_duty_spectrum, read_spectrum

HEADER = "share,duty.load.fz,duty.inner_speed"
THREE = f"{HEADER}\n0.5,1 kN,1000 rpm\n0.3,2 kN,2000 rpm\n0.2,4 kN,3000 rpm\n"


@pytest.fixture(scope="module")
def gearbox(examples: Path) -> Case:
    return load_case(examples / "6305_life.toml")


@pytest.fixture
def table(tmp_path: Path) -> Path:
    return tmp_path / "steps.csv"


def under(case: Case, table: Path, text: str) -> SpectrumLife:
    table.write_text(text, encoding="utf-8")
    return life_of_duty_spectrum(case, read_spectrum(table))


# --- Miner ------------------------------------------------------------------------------------


def test_one_step_is_the_case(gearbox: Case, table: Path) -> None:
    found = under(gearbox, table, f"{HEADER}\n1,2 kN,2000 rpm\n")
    own = life(solve(gearbox))
    assert set(found.theories) == set(own.theories)
    for theory, record in own.theories.items():
        assert found[theory].hours == pytest.approx(record.hours[0], rel=1e-6), theory
        assert found[theory].life == pytest.approx(record.life[0], rel=1e-6), theory
        assert found[theory].damage == pytest.approx([1.0])
    assert found.converged


def test_equal_steps_are_one(gearbox: Case, table: Path) -> None:
    one = under(gearbox, table, f"{HEADER}\n1,2 kN,2000 rpm\n")
    many = under(gearbox, table, f"{HEADER}\n" + "0.25,2 kN,2000 rpm\n" * 4)
    for theory in one.theories:
        assert many[theory].hours == pytest.approx(one[theory].hours)
        assert many[theory].damage == pytest.approx(np.full(4, 0.25))


def test_the_rating_life_is_miners_by_hand(gearbox: Case, table: Path) -> None:
    found = under(gearbox, table, THREE)
    speeds = np.array([1000.0, 2000.0, 3000.0])
    turned = np.array([0.5, 0.3, 0.2]) * speeds
    singles = [
        life(solve(override(gearbox, [f"duty.load.fz={f} kN", f"duty.inner_speed={n} rpm"])))
        for f, n in zip((1, 2, 4), (1000, 2000, 3000), strict=True)
    ]
    for theory in ("iso281", "iso281_modified"):
        lives = np.array([float(single[theory].life[0]) for single in singles])
        used = turned / turned.sum() / lives
        assert found[theory].life == pytest.approx(1.0 / used.sum(), rel=1e-6)
        assert found[theory].damage == pytest.approx(used / used.sum(), rel=1e-5)
    assert found.revolution_shares == pytest.approx(turned / turned.sum())


def test_hours_follow_from_the_mean_speed(gearbox: Case, table: Path) -> None:
    found = under(gearbox, table, THREE)
    mean = 0.5 * 1000.0 + 0.3 * 2000.0 + 0.2 * 3000.0
    assert found.mean_speed == pytest.approx(mean * np.pi / 30.0)
    for theory, own in found.theories.items():
        assert own.hours == pytest.approx(found[theory].life * 1e6 / (60.0 * mean))
        # one step alone: the same life in hours by its own speed
        assert found[theory].steps.hours == pytest.approx(
            found[theory].steps.life * 1e6 / (60.0 * np.array([1000.0, 2000.0, 3000.0]))
        )
        assert found[theory].damage.sum() == pytest.approx(1.0)


def test_rows_loaded_by_turns_gather_their_own_damage(table: Path, examples: Path) -> None:
    """Each of two rows works half of the time: L = [2 (2 L_1)^(-e)]^(-1/e) = 2^(1 - 1/e) L_1."""
    pair = load_case(examples / "6012_pair.toml")
    case = override(
        pair,
        ["bearing.preload.offset=0 um", "duty.inner_speed=100 rpm", "duty.load.fz=0 N"],
    )
    found = under(case, table, "revolutions,duty.load.fx\n0.5,1 kN\n0.5,-1 kN\n")
    alone = found["iso16281"].steps.life
    assert alone[0] == pytest.approx(alone[1], rel=1e-6)
    assert found["iso16281"].life == pytest.approx(2.0**0.1 * alone[0], rel=1e-3)
    assert found["iso281"].life == pytest.approx(found["iso281"].steps.life[0])


def test_a_step_at_rest_takes_time_and_no_life(gearbox: Case, table: Path) -> None:
    running = under(gearbox, table, f"{HEADER}\n1,2 kN,2000 rpm\n")
    resting = under(gearbox, table, f"{HEADER}\n0.5,2 kN,2000 rpm\n0.5,9 kN,0 rpm\n")
    for theory in ("iso281", "iso16281_modified"):
        assert resting[theory].life == pytest.approx(running[theory].life)
        assert resting[theory].hours == pytest.approx(2.0 * running[theory].hours)
        first, second = resting[theory].damage
        assert first == pytest.approx(1.0, rel=1e-15)  # a sum of both races' shares
        assert second == 0.0
    assert resting.taking_part.tolist() == [True, False]


def test_shares_of_revolutions_are_shares_of_time_over_speed(gearbox: Case, table: Path) -> None:
    by_time = under(gearbox, table, THREE)
    shares = ",".join
    text = "revolutions,duty.load.fz,duty.inner_speed\n" + "\n".join(
        shares([f"{q:.15f}", f"{f} kN", f"{n} rpm"])
        for q, f, n in zip(by_time.revolution_shares, (1, 2, 4), (1000, 2000, 3000), strict=True)
    )
    by_turns = under(gearbox, table, text)
    assert by_turns.time_shares == pytest.approx([0.5, 0.3, 0.2])
    for theory, own in by_time.theories.items():
        assert by_turns[theory].hours == pytest.approx(own.hours)


def test_fields_that_need_cases_of_their_own(gearbox: Case, table: Path) -> None:
    text = "share,life.cleanliness,bearing.designation\n.5,-/15/12,6305\n.5,-/19/16,6305/C3\n"
    found = under(gearbox, table, text)
    lives = found["iso16281_modified"].steps.life
    assert lives[0] > lives[1]
    single = life(solve(override(gearbox, ["life.cleanliness=-/19/16"])))
    assert lives[1] == pytest.approx(single["iso16281_modified"].life[0], rel=1e-6)


def test_a_step_without_equilibrium_leaves_no_life(table: Path, examples: Path) -> None:
    case = load_case(examples / "218_combined.toml")
    found = under(case, table, "share,duty.load.fx\n.5,20 kN\n.5,-20 kN\n")
    assert found.status.tolist() == ["converged", "no_equilibrium"]
    assert not found.converged
    assert all(np.isnan(own.hours) for own in found.theories.values())
    assert np.isfinite(found["iso281"].steps.hours[0])


def test_the_wanted_life(gearbox: Case, table: Path) -> None:
    found = under(gearbox, table, THREE)
    reached = found.reliability_of_required("iso281")
    assert found.required_life == 5000.0 * 3600.0
    ratio = (5000.0 / found["iso281"].hours - 0.05) / 0.95
    assert reached == pytest.approx(0.9 ** (ratio**1.5))


# --- the table --------------------------------------------------------------------------------


def test_semicolons_decimal_commas_per_cent_and_remarks(gearbox: Case, table: Path) -> None:
    text = (
        "\ufeff# o ciclo\nshare;duty.load.fz;duty.inner_speed\n\n"
        "12,5 %;1,5 kN;1000 rpm\n87,5%;2 kN;2e3 rpm\n"
    )
    table.write_text(text, encoding="utf-8")
    steps = read_spectrum(table)
    assert steps.shares.tolist() == [0.125, 0.875]
    assert steps.values["duty.load.fz"] == (1500.0, 2000.0)
    assert steps.lines == (4, 5)


def test_shares_that_nearly_sum_to_one_are_scaled(gearbox: Case, table: Path) -> None:
    found = under(gearbox, table, f"{HEADER}\n33 %,1 kN,1000 rpm\n" + "33 %,2 kN,1000 rpm\n" * 2)
    assert found.steps.given_sum == pytest.approx(0.99)
    assert found.time_shares.sum() == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "contains no table"),
        ("share,duty.load.fz\n", "has a header but no rows"),
        ("duty.load.fz\n2 kN\n", "line 1: needs a column named share"),
        ("share,revolutions\n1,1\n", "both a column share and a column revolutions"),
        ("share,duty.load.fq\n1,2 kN\n", "duty.load.fy or duty.load.fz?"),
        ("share,duty.load.fz,duty.load.fz\n1,2 kN,2 kN\n", "repeats a column name"),
        ("share,duty.load.fz\n1\n", "line 2: has 1 cell where the header has 2"),
        ("share,duty.load.fz\n0.5,2 kN\n0.4,3 kN\n", 'share = "0.9": must sum to 1'),
        ("share,duty.load.fz\nx,2 kN\n", 'line 2: share = "x": must be from 0 to 1'),
        ("share,duty.load.fz\n-1,2 kN\n2,2 kN\n", "must be from 0 to 1"),
        ("share,duty.load.fz\nnan,2 kN\n", "must be from 0 to 1"),
        ("share,duty.load.fz\n.5,2 kN\n.5,3\n", 'line 3: duty.load.fz = "3": needs a unit'),
        ("share,duty.load.fz\n1,2 rpm\n", "line 2: duty.load.fz"),
        ("share,duty.load.fz\n1,\n", "line 2: duty.load.fz: is empty"),
        ("share,duty.load.fz\n1,1e99 kN\n", "line 2: duty.load.fz"),
        ("share,life.contamination\n1,2\n", "line 2: life.contamination = 2: must be"),
        (
            "share,life.reliability\n1,0.9\n",
            "applies to the whole duty, not to a step; set it in the case",
        ),
        (
            "share,bearing.arrangement\n1,DB\n",
            "applies to the whole duty, not to a step; set it in the case",
        ),
        (
            "share,life.contamination,life.grease_cleanliness\n1,0.5,high\n",
            "cannot be combined with",
        ),
        ('share,"duty.load.fz\n1,2', "is not a line of a CSV table"),
        (f"share,{'x' * 300}\n1,2\n", "a cell of more than 200 characters"),
        ("share" + ",a" * 2000 + "\n", "has more than 1000 columns"),
        ("share\n" + "0\n" * 10_001, "has more than 10 000 rows"),
        ("share\n" + ("# " + "x" * 4000 + "\n") * 1300, "is larger than 5 MB"),
        ("share,duty.load.fz\n1,\x002 kN\n", "is a binary file"),
    ],
)
def test_a_wrong_table_is_refused(table: Path, text: str, said: str) -> None:
    table.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=re.escape(said)) as caught:
        read_spectrum(table)
    assert caught.value.source == str(table)
    assert len(str(caught.value)) < 600


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            "share,duty.inner_speed\n1,0 rpm\n",
            "is zero in every step: there is no life without rotation",
        ),
        ("revolutions,duty.inner_speed\n.5,0 rpm\n.5,9 rpm\n", "line 2: revolutions: has rev"),
        ("share,bearing.ball_count\n.5,7\n.5,99\n", "line 3: bearing.ball_count = 99: balls of"),
        ("share,bearing.ball_count\n.5,7\n.5,x\n", "line 3: bearing.ball_count"),
        ("share,bearing.diametral_clearance\n1,5 mm\n", "line 2: "),
        ("share,mounting.shaft_interference\n.5,0 um\n.5,1 mm\n", "line 3: mounting: closes"),
    ],
)
def test_a_step_that_is_no_case_is_refused_with_its_line(
    gearbox: Case, table: Path, text: str, said: str
) -> None:
    with pytest.raises(InputError, match=re.escape(said)):
        under(gearbox, table, text)


def test_a_thrust_bearing_is_refused(examples: Path, table: Path) -> None:
    case = load_case(examples / "218_combined.toml")
    with pytest.raises(InputError, match="above 45°"):
        under(case, table, "share,bearing.contact_angle\n1,60 deg\n")


def test_too_many_cases_of_their_own_are_refused(gearbox: Case, table: Path) -> None:
    rows = "".join(f"{1 / 2500},{200 + i / 1e4}\n" for i in range(2500))
    with pytest.raises(InputError, match="needs more than 2000 cases"):
        under(gearbox, table, f"share,life.filter_ratio\n{rows}")


def test_no_file(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="no such file"):
        read_spectrum(tmp_path / "none.csv")


def test_ten_thousand_steps_take_seconds(gearbox: Case, table: Path) -> None:
    rows = "".join(f"{1 / 10_000},{1000 + i % 5000} N,{500 + i % 7} rpm\n" for i in range(10_000))
    started = time.perf_counter()
    found = under(gearbox, table, f"{HEADER}\n{rows}")
    assert time.perf_counter() - started < 60.0
    assert found.converged
    assert "ioannides_harris" not in found.theories
    assert not found.stress_volume


# --- the chart of NSK -------------------------------------------------------------------------


def test_a_chart_is_read(table: Path) -> None:
    table.write_text("kappa,0.01,0.1\n0.5,3,1\n1,10,2\n", encoding="utf-8")
    chart = read_factor_table(table)
    assert chart.viscosity_ratio.tolist() == [0.5, 1.0]
    assert chart.load_parameter.tolist() == [0.01, 0.1]
    assert float(chart.at(1.0, 0.1)) == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("kappa,0.01,0.1\n0.5,3,1\n", "needs at least two rows"),
        ("kappa,0.01\n0.5,3\n1,3\n", "needs at least two rows"),
        ("kappa,0.01,0.1\n0.5,3,x\n1,3,1\n", 'line 2: 0.1 = "x": must be a number'),
        ("kappa,0.01,y\n0.5,3,1\n1,3,1\n", "line 1: y"),
        (
            "kappa,0.01,0.1\n1,3,1\n0.5,3,1\n",
            "κ of the rows: must be at least two increasing numbers",
        ),
        ("kappa,0.1,0.01\n0.5,3,1\n1,3,1\n", "load parameters of the header"),
        ("kappa,0.01,0.1\n0.5,3,-1\n1,3,1\n", "a_NSK = -1.0: must be positive"),
        ("kappa,0.01,0.1\n0.5,3,inf\n1,3,1\n", "must be a number"),
    ],
)
def test_a_wrong_chart_is_refused(table: Path, text: str, said: str) -> None:
    table.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=re.escape(said)):
        read_factor_table(table)
