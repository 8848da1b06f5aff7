"""FMUs of a bearing: what they say of themselves, and what they answer when they are compiled."""

from __future__ import annotations

import ctypes
import io
import shutil
import subprocess
import zipfile
from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from rolamento.errors import InputError
from rolamento.exchange.fmi import between_points, fmu_bytes
from rolamento.solved.maps import MapAxis, StiffnessMap
from rolamento.tasks.maps import mapped, read_subject

COMPILER = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
PLACE, VELOCITY, QUANTITY, FORCE, DAMPING, OUTSIDE = 1, 6, 11, 12, 17, 18


@pytest.fixture(scope="module")
def over_load() -> StiffnessMap:
    subject = read_subject("7210B", ["duty.load.fx=2 kN", "duty.inner_speed=1000 rpm"])
    (one,) = mapped(subject, ["duty.load.fz=0..2kN"], points=5).maps
    return one


# --- what they say --------------------------------------------------------------------------------


@pytest.mark.parametrize("version", [2, 3])
def test_the_same_map_gives_the_same_bytes(over_load: StiffnessMap, version: int) -> None:
    content = fmu_bytes(over_load, version)
    assert content == fmu_bytes(over_load, version)
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        assert {"modelDescription.xml", "sources/element.c", f"sources/fmi{version}.c"} <= {
            *archive.namelist()
        }
        header = archive.read(f"sources/fmi{version}Functions.h").decode()
    assert "2-Clause BSD License" in header


def described(over_load: StiffnessMap, version: int) -> ElementTree.Element:
    with zipfile.ZipFile(io.BytesIO(fmu_bytes(over_load, version, damping=1e-5))) as archive:
        return ElementTree.fromstring(archive.read("modelDescription.xml"))


def test_variables_of_fmi_2_have_their_units(over_load: StiffnessMap) -> None:
    root = described(over_load, 2)
    found = {one.get("name"): one for one in root.iter("ScalarVariable")}
    assert list(found)[:5] == ["x", "y", "z", "ry", "rz"]
    units = {name: one[0].get("unit") for name, one in found.items()}
    assert [units[name] for name in ("x", "rz", "s_fz", "fx", "mz", "damping")] == [
        "m", "rad", "N", "N", "N*m", "s",
    ]  # fmt: skip
    known = {one.get("name") for one in root.iter("Unit")}
    assert set(units.values()) - {None} <= known
    assert found["s_fz"][0].get("start") == "2000.0"
    assert found["damping"][0].get("start") == "1e-05"
    outputs = [int(str(one.get("index"))) for one in root.find("ModelStructure/Outputs") or ()]
    names = list(found)
    assert [names[place - 1] for place in outputs] == ["fx", "fy", "fz", "my", "mz", "outside"]


def test_variables_of_fmi_3_are_those_of_fmi_2_and_time(over_load: StiffnessMap) -> None:
    second = {
        one.get("name"): one.get("valueReference")
        for one in described(over_load, 2).iter("ScalarVariable")
    }
    third = {
        one.get("name"): one.get("valueReference")
        for one in described(over_load, 3).find("ModelVariables") or ()
    }
    assert third == {"time": "0", **second}


def test_names_of_any_kind_stay_xml(over_load: StiffnessMap) -> None:
    one = StiffnessMap(
        'a<b>&"\u0001', over_load.axes, over_load.stiffness, over_load.force,
        over_load.displacement, over_load.status, {"title": "\u0000]]>"},
    )  # fmt: skip
    for version in (2, 3):
        root = described(one, version)
        face = root.find("CoSimulation")
        assert face is not None
        assert face.get("modelIdentifier") == "a_b"


# --- what they answer -----------------------------------------------------------------------------


class Compiled:
    """An FMU as a simulation program drives it."""

    def __init__(self, folder: Path, content: bytes, version: int) -> None:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            archive.extractall(folder)
        root = ElementTree.fromstring((folder / "modelDescription.xml").read_bytes())
        sources = [f"{name}.c" for name in ("element", f"fmi{version}", "table")]
        command = [
            str(COMPILER), "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-shared",
            "-fPIC", "-o", "model.so", *sources, "-lm",
        ]  # fmt: skip
        subprocess.run(command, cwd=folder / "sources", check=True, timeout=120)
        self.library = ctypes.CDLL(str(folder / "sources" / "model.so"))
        self.version = version
        self.token = str(root.get("guid") or root.get("instantiationToken")).encode()
        self.one = ctypes.c_void_p(self.made(self.token))

    def made(self, token: bytes) -> int | None:
        if self.version == 2:
            make = self.library.fmi2Instantiate
            make.restype = ctypes.c_void_p
            found = make(b"one", 0, token, b"", None, 0, 0)
        else:
            make = self.library.fmi3InstantiateModelExchange
            make.restype = ctypes.c_void_p
            found = make(b"one", token, b"", False, False, None, None)
        return found if found is None else int(found)

    def _references(self, references: Sequence[int]) -> ctypes.Array[ctypes.c_uint32]:
        return (ctypes.c_uint32 * len(references))(*references)

    def put(self, values: dict[int, float]) -> int:
        n = len(values)
        numbers = (ctypes.c_double * n)(*values.values())
        given = [self.one, self._references(list(values)), ctypes.c_size_t(n), numbers]
        if self.version == 2:
            return int(self.library.fmi2SetReal(*given))
        return int(self.library.fmi3SetFloat64(*given, ctypes.c_size_t(n)))

    def take(self, references: Sequence[int]) -> tuple[int, np.ndarray]:
        n = len(references)
        numbers = (ctypes.c_double * n)()
        given = [self.one, self._references(references), ctypes.c_size_t(n), numbers]
        if self.version == 2:
            status = self.library.fmi2GetReal(*given)
        else:
            status = self.library.fmi3GetFloat64(*given, ctypes.c_size_t(n))
        return int(status), np.array(numbers)

    def force(self) -> np.ndarray:
        status, values = self.take(range(FORCE, FORCE + 5))
        assert status == 0
        return values

    def outside(self) -> bool:
        if self.version == 2:
            found = (ctypes.c_int * 1)()
            given = [self.one, self._references([OUTSIDE]), ctypes.c_size_t(1), found]
            assert self.library.fmi2GetBoolean(*given) == 0
        else:
            found = (ctypes.c_bool * 1)()
            given = [self.one, self._references([OUTSIDE]), ctypes.c_size_t(1), found]
            assert self.library.fmi3GetBoolean(*given, ctypes.c_size_t(1)) == 0
        return bool(found[0])

    def derivative(self, unknown: int, known: int) -> float:
        seed, answer = (ctypes.c_double * 1)(1.0), (ctypes.c_double * 1)()
        one = ctypes.c_size_t(1)
        given = [self.one, self._references([unknown]), one, self._references([known]), one, seed]
        if self.version == 2:
            status = self.library.fmi2GetDirectionalDerivative(*given, answer)
        else:
            status = self.library.fmi3GetDirectionalDerivative(*given, one, answer, one)
        assert status == 0
        return float(answer[0])


@pytest.fixture(scope="module", params=[2, 3])
def compiled(
    request: pytest.FixtureRequest,
    over_load: StiffnessMap,
    tmp_path_factory: pytest.TempPathFactory,
) -> Compiled:
    if COMPILER is None:
        pytest.skip("there is no compiler")
    content = fmu_bytes(over_load, request.param, damping=1e-5)
    return Compiled(tmp_path_factory.mktemp("fmu"), content, request.param)


def place(values: np.ndarray) -> dict[int, float]:
    return {PLACE + i: float(one) for i, one in enumerate(values)}


def still(compiled: Compiled) -> None:
    compiled.put({VELOCITY + i: 0.0 for i in range(5)})


def test_at_an_operating_point_the_force_is_that_of_the_solver(
    compiled: Compiled, over_load: StiffnessMap
) -> None:
    still(compiled)
    for point, quantity in enumerate(over_load.axes[0].values):
        compiled.put({QUANTITY: quantity, **place(over_load.displacement[point])})
        assert compiled.force() == pytest.approx(over_load.force[point], rel=1e-12, abs=1e-9)
        assert not compiled.outside()


def test_beside_it_the_stiffness_counts(compiled: Compiled, over_load: StiffnessMap) -> None:
    still(compiled)
    moved = np.array([1e-6, -2e-6, 3e-6, 1e-5, -1e-5])
    compiled.put({QUANTITY: 1000.0, **place(over_load.displacement[2] + moved)})
    expected = over_load.force[2] + over_load.stiffness[2] @ moved
    assert compiled.force() == pytest.approx(expected, rel=1e-12)


def test_it_is_the_bearing_for_small_changes(compiled: Compiled, over_load: StiffnessMap) -> None:
    """Between points and beside them: against the nonlinear bearing itself."""
    still(compiled)
    subject = read_subject("7210B", ["duty.load.fx=2 kN", "duty.inner_speed=1000 rpm"])
    (near,) = mapped(subject, ["duty.load.fz=1500..1510N"], points=2).maps
    compiled.put({QUANTITY: 1505.0, **place(near.displacement[1])})
    assert compiled.force() == pytest.approx(near.force[1], rel=5e-3, abs=2e-2)


def test_velocity_is_damped(compiled: Compiled, over_load: StiffnessMap) -> None:
    speed = np.array([1e-3, 2e-3, 0.0, 0.1, 0.0])
    compiled.put({QUANTITY: 500.0, DAMPING: 2e-5, **place(over_load.displacement[1])})
    compiled.put({VELOCITY + i: float(one) for i, one in enumerate(speed)})
    expected = over_load.force[1] + 2e-5 * over_load.stiffness[1] @ speed
    assert compiled.force() == pytest.approx(expected, rel=1e-12)
    compiled.put({DAMPING: 1e-5})


def test_beyond_the_table_its_end_is_held_and_said(
    compiled: Compiled, over_load: StiffnessMap
) -> None:
    still(compiled)
    compiled.put({QUANTITY: 5000.0, **place(over_load.displacement[-1])})
    assert compiled.force() == pytest.approx(over_load.force[-1], rel=1e-12, abs=1e-9)
    assert compiled.outside()
    compiled.put({QUANTITY: float("nan")})
    assert compiled.outside()
    assert np.isnan(compiled.force()).any()


def test_derivatives_are_those_of_its_force(compiled: Compiled, over_load: StiffnessMap) -> None:
    where = {QUANTITY: 740.0, **place(over_load.displacement[1] * 1.1)}
    where |= {VELOCITY + i: 1e-3 * (i + 1) for i in range(5)}
    steps = {QUANTITY: 1.0, **{PLACE + i: 1e-6 for i in range(5)},
             **{VELOCITY + i: 1e-3 for i in range(5)}}  # fmt: skip
    for known, step in steps.items():
        values = []
        for side in (-1.0, 1.0):
            compiled.put(where)
            compiled.put({known: where[known] + side * step})
            values.append(compiled.force())
        compiled.put(where)
        slope = (values[1] - values[0]) / (2.0 * step)
        found = [compiled.derivative(FORCE + i, known) for i in range(5)]
        assert found == pytest.approx(slope, rel=1e-6, abs=1e-6 * np.abs(slope).max())


def test_what_it_does_not_have_is_an_error(compiled: Compiled) -> None:
    assert compiled.made(b"another") is None
    assert compiled.take([99])[0] == 3
    assert compiled.put({FORCE: 1.0}) == 3
    assert compiled.put({DAMPING: -1.0}) == 3


# --- which maps -----------------------------------------------------------------------------------


def test_what_lies_between_points_is_measured(over_load: StiffnessMap) -> None:
    kept, apart = between_points(over_load)
    assert kept.axes[0].values.tolist() == [0.0, 1000.0, 2000.0]
    k = over_load.stiffness
    worst = (
        np.abs(k[1::2] - 0.5 * (k[:-1:2] + k[2::2]))[:, :3, :3].max() / np.abs(k)[:, :3, :3].max()
    )
    assert worst <= apart < 0.2


def test_a_map_over_two_fields_or_with_gaps_is_refused(over_load: StiffnessMap) -> None:
    with pytest.raises(InputError, match="must be one of 2, 3"):
        fmu_bytes(over_load, 1)
    axis = MapAxis("duty.inner_speed", "rad/s", np.array([0.0]))
    two = StiffnessMap(
        "A", (*over_load.axes, axis), over_load.stiffness[:, np.newaxis],
        over_load.force[:, np.newaxis], over_load.displacement[:, np.newaxis],
        over_load.status[:, np.newaxis],
    )  # fmt: skip
    with pytest.raises(InputError, match="over one field"):
        fmu_bytes(two, 3)
    gaps = StiffnessMap(
        "A", over_load.axes, over_load.stiffness, over_load.force, over_load.displacement,
        np.array(["converged"] * 4 + ["overloaded"]),
    )  # fmt: skip
    with pytest.raises(InputError, match="overloaded"):
        fmu_bytes(gaps, 3)
