"""Stiffness and force of bearings as tables, read back as other programs read them."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat

import rolamento
from rolamento.case.duty import AXES
from rolamento.errors import InputError
from rolamento.exchange.tables import (
    COLUMNS,
    identifiers,
    maps_to_csv,
    maps_to_mat,
    maps_to_modelica,
)
from rolamento.machines import shaft
from rolamento.solved.maps import StiffnessMap
from rolamento.tasks.maps import mapped, read_subject

MACHINES = Path(rolamento.__file__).parent / "examples" / "machines"


@pytest.fixture(scope="module")
def over_two() -> StiffnessMap:
    subject = read_subject("6310/C3", ["duty.load.fx=1 kN"])
    over = ["duty.load.fz=4..2kN", "duty.inner_speed=0..3000rpm"]
    (one,) = mapped(subject, over, points=3).maps
    return one


@pytest.fixture(scope="module")
def over_one() -> tuple[StiffnessMap, ...]:
    subject = read_subject(str(MACHINES / "spindle.toml"))
    return mapped(subject, ['loads."cutting force".fz=200..800N'], points=3).maps


def test_a_map_has_what_solving_gives(over_two: StiffnessMap) -> None:
    solved = rolamento.solve("6310/C3", fx=1e3, fz=3e3, inner_speed="3000 rpm")
    assert over_two.shape == (3, 3)
    assert over_two.stiffness[1, 2] == pytest.approx(solved.stiffness.array[0], rel=1e-6, abs=1.0)
    assert over_two.force[1, 2, [0, 2]] == pytest.approx([1e3, 3e3])


def test_stiffness_is_the_derivative_of_the_force() -> None:
    subject = read_subject("7210B", ["duty.load.fx=2 kN", "duty.inner_speed=1000 rpm"])
    (one,) = mapped(subject, ["duty.load.fz=1000..1002N"], points=3).maps
    change = one.force[2] - one.force[0]
    moved = one.displacement[2] - one.displacement[0]
    assert one.stiffness[1] @ moved == pytest.approx(change, rel=1e-4, abs=1e-4 * 2.0)


def test_bearings_of_a_machine_are_in_its_axes(over_one: tuple[StiffnessMap, ...]) -> None:
    machine = rolamento.load_machine(MACHINES / "spindle.toml")
    solved = shaft(machine).bearings["nose"]
    nose = over_one[0]
    assert machine.bearing("nose").turned
    assert nose.force[2] == pytest.approx(solved.force[0], rel=1e-6)
    # turned round, what couples x with others has the other sign
    own = solved.solved.stiffness.array[0]
    assert nose.stiffness[2, 0, 2] == pytest.approx(-own[0, 2], rel=1e-6)
    assert nose.stiffness[2, 1, 2] == pytest.approx(own[1, 2], rel=1e-6)


def test_preload_and_temperature_vary_too() -> None:
    pair = read_subject("7210B", ["bearing.arrangement=DB", "bearing.spacing=40 mm",
                                  "bearing.preload.force=300 N"])  # fmt: skip
    (one,) = mapped(pair, ["bearing.preload.force=100..900N"], points=3).maps
    assert (np.diff(one.stiffness[:, 0, 0]) > 0.0).all()
    warm = read_subject(str(MACHINES / "gear_shaft.toml"))
    assert mapped(warm, ["temperature.lubricant=40..80degC"], points=2).converged


# --- what is written ------------------------------------------------------------------------------


def test_csv_reads_back_to_the_last_digit(over_two: StiffnessMap) -> None:
    text = maps_to_csv([over_two])
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    head, *rows = csv.reader(io.StringIO("\n".join(lines)))
    assert head[1:4] == ["duty.load.fz [N]", "duty.inner_speed [rad/s]", "status"]
    assert head[4:6] == ["stiffness_xx [N/m]", "stiffness_xy [N/m]"]
    found = np.array([[float(cell) for cell in row[4:29]] for row in rows])
    assert (found.reshape(3, 3, 5, 5) == over_two.stiffness).all()
    assert [float(row[1]) for row in rows[::3]] == over_two.axes[0].values.tolist()
    assert "# case: sha256" in text


def test_matlab_reads_back_to_the_last_digit(over_one: tuple[StiffnessMap, ...]) -> None:
    content = maps_to_mat(over_one)
    assert content == maps_to_mat(over_one)
    found = loadmat(io.BytesIO(content), simplify_cells=True)
    nose = found["nose"]
    assert (nose["stiffness"] == over_one[0].stiffness).all()
    assert (nose["force"] == over_one[0].force).all()
    assert (nose["axes"]["values"] == over_one[0].axes[0].values).all()
    assert nose["axes"]["unit"] == "N"
    assert found["about"]["program"].startswith("Rolamento")
    assert nose["units"]["stiffness"][3, 3] == "N*m/rad"


def tables_of(text: str) -> dict[str, np.ndarray]:
    """Tables of a text file of Modelica, as its reader takes them."""
    assert text.startswith("#1\n")
    found: dict[str, np.ndarray] = {}
    parts = re.split(r"^double (\w+)\((\d+),(\d+)\)\n", text, flags=re.MULTILINE)[1:]
    for name, rows, columns, body in zip(*[iter(parts)] * 4, strict=True):
        numbers = [
            w for line in body.splitlines() if not line.startswith("#") for w in line.split()
        ]
        assert name not in found
        found[name] = np.array(numbers, float).reshape(int(rows), int(columns))
    return found


def test_modelica_over_one_field(over_one: tuple[StiffnessMap, ...]) -> None:
    found = tables_of(maps_to_modelica(over_one))
    assert set(found) == {f"{name}_{of}" for name in ("nose", "rear") for of in COLUMNS}
    table = found["nose_stiffness"]
    assert (table[:, 0] == over_one[0].axes[0].values).all()
    assert (table[:, 1:].reshape(3, 5, 5) == over_one[0].stiffness).all()


def test_modelica_over_two_fields_rises_along_both(over_two: StiffnessMap) -> None:
    found = tables_of(maps_to_modelica([over_two]))
    assert len(found) == 35
    table = found["b_6310_C3_stiffness_zz"]
    assert (table[1:, 0] == over_two.axes[0].values[::-1]).all()
    assert (table[0, 1:] == over_two.axes[1].values).all()
    assert (table[1:, 1:] == over_two.stiffness[::-1, :, 2, 2]).all()


def test_a_point_without_equilibrium_is_empty_or_refused() -> None:
    subject = read_subject("NU206", ["duty.load.fz=1 kN"])
    (one,) = mapped(subject, ["duty.load.fx=0..100N"], points=2).maps
    assert one.status.tolist()[1] != "converged"
    assert maps_to_csv([one]).splitlines()[-1].endswith("," * 34)
    assert np.isnan(loadmat(io.BytesIO(maps_to_mat([one])))["NU206"]["force"][0, 0][1]).all()
    with pytest.raises(InputError, match="no gaps"):
        maps_to_modelica([one])


def test_names_are_identifiers_unlike_each_other() -> None:
    assert identifiers(["A b", "a_B", "6310/C3", "é"]) == ("A_b", "a_B_2", "b_6310_C3", "bearing")


def test_columns_are_in_the_order_of_the_degrees_of_freedom() -> None:
    names = [name for name, _ in COLUMNS["stiffness"]]
    assert names == [f"stiffness_{row}{column}" for row in AXES for column in AXES]


@pytest.mark.parametrize(
    ("over", "rule"),
    [
        (["duty.load.fx=1..2kN"] * 2, "is given twice"),
        (["duty.load.fx=1..2kN", "duty.load.fz=1..2kN", "duty.load.fy=1..2kN"], "2 times at most"),
        (["duty.load.fx=1..1kN"], "must have two different ends"),
        (["duty.load.fx"], "must be FIELD=FIRST..LAST"),
        (["duty.lod.fx=1..2kN"], "duty.lod.fx"),
        (["duty.load.fx=1..2rpm"], "rpm"),
        ([], "nothing turns"),
    ],
)
def test_wrong_ranges_are_refused(over: list[str], rule: str) -> None:
    with pytest.raises(InputError, match=re.escape(rule)):
        mapped(read_subject("6310"), over, points=2)


def test_a_bearing_that_is_not_there_is_refused() -> None:
    subject = read_subject(str(MACHINES / "spindle.toml"))
    with pytest.raises(InputError, match="nose"):
        mapped(subject, bearing="noze", points=2)
    with pytest.raises(InputError, match="points = 51: must be 2 to 50"):
        mapped(subject, ["shafts.0.speed=0..9rpm", "loads.0.fx=0..9N"], points=51)
