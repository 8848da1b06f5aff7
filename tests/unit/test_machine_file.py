"""The records of a machine: read from files and Python, refused in words, written and read back."""

from __future__ import annotations

import copy
import json
import math
import os
import pickle
import random
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rolamento.case import Bearing, Case, Duty, LifeModel, Mounting, Temperature, load_case
from rolamento.case.machine import (
    SHAFT_STEEL,
    Gear,
    Housing,
    Machine,
    MachineBearing,
    Section,
    Shaft,
    ShaftLoad,
    Spring,
    Step,
    load_machine,
    parse_machine,
    save_machine,
)
from rolamento.errors import FileError, InputError, UnitError, UnknownKeyError
from rolamento.machines import shaft
from rolamento.words import speaking

SHAFT = '[[shafts]]\nname = "s"\nspeed = "1000 rpm"\n'
SECTIONS = 'sections = [{ length = "300 mm", diameter = "40 mm" }]\n'
BEARING = '[[bearings]]\nname = "A"\nshaft = "s"\nposition = "20 mm"\ndesignation = "6308"\n'
OTHER = '[[bearings]]\nname = "B"\nshaft = "s"\nposition = "280 mm"\ndesignation = "NU308"\n'
PLAIN = SHAFT + SECTIONS + BEARING + OTHER
SECOND = '[[shafts]]\nname = "t"\nsections = [{ length = "300 mm", diameter = "40 mm" }]\n'
GEAR = (
    '[[gears]]\nname = "g"\nshaft = "s"\nposition = "150 mm"\npitch_diameter = "100 mm"\n'
    'torque = "50 N m"\nmesh_azimuth = "0 deg"\ndrives = true\n'
)


def machine(**fields: Any) -> Machine:
    plain = {
        "shafts": [Shaft(name="s", sections=[Section(length=0.3, diameter=0.04)], speed=100.0)],
        "bearings": [
            MachineBearing(name="A", shaft="s", position=0.02, designation="6308"),
            MachineBearing(name="B", shaft="s", position=0.28, designation="NU308"),
        ],
    }
    return Machine(**{**plain, **fields})


def refused(text: str, folder: Path | None = None) -> InputError:
    with pytest.raises(InputError) as error:
        parse_machine(text, folder=folder)
    assert str(error.value)
    with speaking("pt"):
        assert str(error.value)
    return error.value


@pytest.fixture
def machines(examples: Path) -> Path:
    return examples / "machines"


NAMES = ("motor", "gear_shaft", "pinion", "pinion_x", "spindle", "three_supports", "coaxial")


class TestExamples:
    @pytest.mark.parametrize("name", NAMES)
    def test_they_load_and_come_back_from_both_formats(
        self, machines: Path, name: str, tmp_path: Path
    ) -> None:
        found = Machine.from_file(machines / f"{name}.toml")
        assert found.title
        assert not found.notes
        assert Machine.from_toml(found.to_toml()) == found
        assert parse_machine(found.to_json()) == found
        for ending in ("toml", "json"):
            path = tmp_path / f"machine.{ending}"
            save_machine(found, path)
            again = load_machine(path)
            assert again == found
            assert [one.case for one in again.bearings] == [one.case for one in found.bearings]
        assert copy.deepcopy(found) == found == pickle.loads(pickle.dumps(found))
        assert hash(found) == hash(Machine.from_toml(found.to_toml()))
        assert "Machine" in repr(found)

    def test_all_are_tested(self, machines: Path) -> None:
        assert {path.stem for path in machines.glob("*.toml")} == set(NAMES)

    def test_a_motor(self, machines: Path) -> None:
        motor = Machine.from_file(machines / "motor.toml")
        assert motor.gravity is not None
        assert motor.gravity.vector == (0.0, 0.0, -9.81)
        nde, de = (motor.bearing(name).case for name in ("non-drive end", "drive end"))
        assert nde.lubricant == de.lubricant == motor.lubricant
        assert nde.temperature.inner_ring == pytest.approx(353.15)
        assert de.temperature.inner_ring == pytest.approx(358.15)
        assert de.temperature.lubricant == nde.temperature.lubricant
        assert de.mounting.bore == 0.05
        assert de.duty == Duty()
        assert motor.bearing("non-drive end").located == "floating"

    def test_two_coaxial_shafts(self, machines: Path) -> None:
        coaxial = Machine.from_file(machines / "coaxial.toml")
        assert coaxial.speed("inner shaft") == pytest.approx(-1.5 * coaxial.speed("hollow shaft"))
        assert coaxial.outer_position("between") == pytest.approx(0.27)
        with pytest.raises(InputError, match="not between two shafts"):
            coaxial.outer_position("inner, left")

    def test_back_to_back_faces_outward_from_the_middle(self, machines: Path) -> None:
        back, face = (Machine.from_file(machines / f"{one}.toml") for one in ("pinion", "pinion_x"))
        assert [one.side for one in back.bearings] == [1, -1]
        assert [one.side for one in face.bearings] == [-1, 1]
        assert back.housing_of("pinion side").holds_tilt


class TestPython:
    def test_a_machine_built_in_python_is_that_of_its_file(self) -> None:
        built = machine(
            gears=[
                Gear(name="g", shaft="s", position=0.15, pitch_diameter=0.1, torque=50.0,
                     mesh_azimuth=0.0, drives=True)
            ],
        )  # fmt: skip
        read = Machine.from_toml(PLAIN.replace("1000 rpm", "100 rad/s") + GEAR)
        assert built == read
        assert parse_machine(built.to_json()) == built

    def test_a_bearing_takes_a_case_or_records(self) -> None:
        case = Case(
            bearing="6308/C3",
            duty=Duty(inner_speed=10.0),
            life=LifeModel(grease_cleanliness="normal"),
            mounting={"shaft_tolerance": "k5"},
        )
        common = {"shaft": "s", "position": 0.1}
        by_case = MachineBearing(name="A", **common, case=case)
        by_parts = MachineBearing(
            name="A",
            **common,
            bearing={"designation": "6308/C3"},
            life=case.life,
            mounting=Mounting(bore=0.04, outside_diameter=0.09, shaft_tolerance="k5"),
        )
        assert by_case.case == by_parts.case
        assert by_case.case == case.replace(title="A", duty=Duty())
        built = machine(bearings=[by_case])
        assert parse_machine(built.to_json()) == built

    def test_tables_in_python_are_in_si(self) -> None:
        own = {
            "ball_count": 8,
            "ball_diameter": 0.015,
            "pitch_diameter": 0.065,
            "diametral_clearance": 1e-5,
            "inner_conformity": 0.52,
            "outer_conformity": 0.53,
            "arrangement": "DB",
            "spacing": 0.02,
            "preload": {"offset": 5e-6},
        }
        found = MachineBearing(
            name="A", shaft="s", position=0.1, bearing=own, temperature={"lubricant": 343.15}
        )
        assert found.case.bearing == Bearing(**own)
        assert found.case.temperature == Temperature(lubricant=343.15)

    def test_what_is_a_bearings_own_goes_before_the_machines(self) -> None:
        found = machine(
            lubricant="ISO VG 100",
            life={"cleanliness": "-/17/14", "oil_supply": "bath", "reliability": 0.95},
            temperature={"lubricant": 343.15, "shaft": 343.15},
            bearings=[
                MachineBearing(name="A", shaft="s", position=0.02, designation="6308"),
                MachineBearing(
                    name="B",
                    shaft="s",
                    position=0.28,
                    designation="NU308",
                    lubricant="ISO VG 220",
                    temperature={"inner_ring": 350.0},
                    life={"reliability": 0.99},
                    mounting={"shaft_tolerance": "k5"},
                ),
            ],
        )
        first, second = found.bearing("A").case, found.bearing("B").case
        assert first.lubricant.name == "ISO VG 100"
        assert second.lubricant.name == "ISO VG 220"
        assert first.temperature == Temperature(lubricant=343.15)  # no seats: no shaft's
        assert second.temperature == Temperature(lubricant=343.15, inner_ring=350.0, shaft=343.15)
        assert (first.life.reliability, second.life.reliability) == (0.95, 0.99)
        assert second.life.cleanliness == "-/17/14"
        assert parse_machine(found.to_json()) == found
        changed = found.replace(lubricant="ISO VG 68")
        assert changed.bearing("A").case.lubricant.name == "ISO VG 68"
        assert changed.bearing("B").case.lubricant.name == "ISO VG 220"

    def test_a_rival_takes_the_place_of_the_machines(self) -> None:
        own = MachineBearing(
            name="A", shaft="s", position=0.02, designation="6308", life={"contamination": 0.5}
        )
        found = machine(life={"cleanliness": "-/17/14", "oil_supply": "bath"}, bearings=[own])
        assert found.bearing("A").case.life == LifeModel(contamination=0.5)
        assert parse_machine(found.to_json()) == found

    def test_it_is_frozen_and_by_name(self) -> None:
        found = machine(housings=[Housing(name="H", stiffness=(1e8, 1e8, 1e8))])
        with pytest.raises(AttributeError):
            found.title = "other"
        assert found.shaft("s").length == 0.3
        assert found.housing("H").name == "H"
        assert found.housing_of("A") is None
        for lookup in (found.shaft, found.bearing, found.housing, found.gear, found.speed):
            with pytest.raises(InputError, match="unknown name"):
                lookup("nobody")

    def test_a_bearing_of_one_machine_may_be_of_another(self) -> None:
        own = MachineBearing(name="A", shaft="s", position=0.02, designation="6308")
        oiled = machine(bearings=[own], lubricant="ISO VG 68")
        assert own.case.lubricant is None
        assert oiled.bearings[0].case.lubricant.name == "ISO VG 68"
        assert machine(bearings=oiled.bearings).bearings[0].case.lubricant is None


class TestShafts:
    def test_the_default_is_steel(self) -> None:
        shaft = machine().shaft("s")
        assert (shaft.youngs_modulus, shaft.poisson_ratio, shaft.density) == (206e9, 0.3, 7850.0)
        assert shaft.shear_modulus == pytest.approx(206e9 / 2.6)
        for value in ("steel", "Steel"):
            assert shaft.replace(material=value).material == SHAFT_STEEL
        assert shaft.replace(material="440C").youngs_modulus == 200e9
        text = PLAIN.replace(
            SECTIONS,
            SECTIONS + 'material = { youngs_modulus = "70 GPa", poisson_ratio = 0.33,'
            ' density = "2700 kg/m^3" }\n',
        )
        found = Machine.from_toml(text)
        assert found.shaft("s").density == 2700.0
        assert Machine.from_toml(found.to_toml()) == found

    def test_diameters_along_it(self) -> None:
        shaft = Shaft(
            name="s",
            sections=[
                Section(length=0.1, diameter=0.04, end_diameter=0.06),
                Section(length=0.1, diameter=0.05),
            ],
        )
        assert shaft.edges == (0.0, 0.1, 0.2)
        assert shaft.sections[0].tapers
        assert not shaft.sections[1].tapers
        assert shaft.diameters_at(0.05) == pytest.approx((0.05,))
        assert shaft.diameters_at(0.1) == pytest.approx((0.06, 0.05))
        assert shaft.diameters_at(0.2) == (0.05,)

    def test_speeds_by_ratios(self) -> None:
        text = (
            PLAIN + SECOND + 'ratio = -0.5\nof = "s"\n'
            + SECOND.replace('"t"', '"u"') + 'ratio = 2.0\nof = "t"\n'
        )  # fmt: skip
        found = Machine.from_toml(text)
        assert found.speed("u") == pytest.approx(-found.speed("s"))
        assert found.speed("t", 2.0) == pytest.approx(-found.speed("s"))

    @pytest.mark.parametrize(
        ("more", "field", "rule"),
        [
            ('ratio = 2.0\nof = "x"\n', "shafts.1.of", "unknown name"),
            ('ratio = 2.0\nof = "t"\n', "shafts.1.of", "loop"),
            ("ratio = 2.0\n", "shafts.1.of", "is missing"),
            ('of = "s"\n', "shafts.1.ratio", "is missing"),
            ('ratio = 2.0\nof = "s"\nspeed = "5 rpm"\n', "shafts.1.speed", "cannot be combined"),
            ("speed = 5.0\n", "shafts.1.speed", "needs a unit"),
            ('material = "butter"\n', "shafts.1.material", "unknown name"),
            ('lenght = "5 mm"\n', "shafts.1.lenght", "unknown key"),
        ],
    )
    def test_refusals(self, more: str, field: str, rule: str) -> None:
        error = refused(PLAIN + SECOND + more)
        assert error.field == field
        assert rule in str(error)

    def test_a_circle_of_two(self) -> None:
        text = SECOND + 'ratio = 1.0\nof = "s"\n' + SHAFT.replace(
            'speed = "1000 rpm"', 'ratio = 1.0\nof = "t"'
        ) + SECTIONS + BEARING  # fmt: skip
        assert "loop" in str(refused(text))

    @pytest.mark.parametrize(
        ("section", "field", "rule"),
        [
            ('length = "0 mm", diameter = "40 mm"', "length", "greater than 0 mm"),
            ('length = "10 mm", diameter = 40', "diameter", "needs a unit"),
            ('length = "10 mm"', "diameter", "is missing"),
            ('length = "10 mm", diameter = "40 mm", bore = "40 mm"', "bore", "less than diameter"),
            ('length = "10 mm", diameter = "40 mm", bore = "30 mm", end_diameter = "20 mm"',
             "bore", "less than end_diameter"),
            ('length = "10 mm", diameter = "40 mm", end_bore = "41 mm"', "end_bore", "less than"),
            ('length = "10 N", diameter = "40 mm"', "length", "unit of length"),
            ('length = "10 mm", diamter = "40 mm"', "diamter", "did you mean diameter"),
        ],
    )  # fmt: skip
    def test_sections(self, section: str, field: str, rule: str) -> None:
        error = refused(SHAFT + f"sections = [{{ {section} }}]\n" + BEARING)
        assert error.field == f"shafts.0.sections.0.{field}"
        assert rule in str(error)

    def test_counts_are_bounded(self) -> None:
        piece = '{ length = "1 mm", diameter = "40 mm" }'
        assert refused(SHAFT + f"sections = [{', '.join([piece] * 201)}]\n" + BEARING)
        assert refused(SHAFT + "sections = []\n" + BEARING).field == "shafts.0.sections"
        shafts = "".join(SECOND.replace('"t"', f'"{one}"') for one in range(21))
        assert "at most 20" in str(refused(shafts + BEARING.replace('"s"', '"0"')))
        many = "".join(BEARING.replace('"A"', f'"{one}"') for one in range(101))
        assert "at most 100" in str(refused(SHAFT + SECTIONS + many))


class TestFilesBeside:
    def test_a_table_of_sections(self, tmp_path: Path) -> None:
        table = "length [mm],diameter [mm],bore [mm],end_diameter [mm]\n100,40,10,\n50,40,10,60\n"
        (tmp_path / "shaft.csv").write_text(table)
        (tmp_path / "m.toml").write_text(SHAFT + 'sections = "shaft.csv"\n' + BEARING)
        found = Machine.from_file(tmp_path / "m.toml")
        assert found.shaft("s").sections == (
            Section(length=0.1, diameter=0.04, bore=0.01),
            Section(length=0.05, diameter=0.04, bore=0.01, end_diameter=0.06),
        )
        assert Machine.from_toml(found.to_toml()) == found

    def test_a_table_with_decimal_commas_and_a_line_of_units(self, tmp_path: Path) -> None:
        (tmp_path / "e.csv").write_text("comprimento;diâmetro\nmm;mm\n100,5;40\n50,25;35,5\n")
        found = parse_machine(SHAFT + 'sections = "e.csv"\n' + BEARING, folder=tmp_path)
        assert found.shaft("s").sections[1] == Section(length=0.05025, diameter=0.0355)

    @pytest.mark.parametrize(
        ("table", "rule"),
        [
            ("length,diameter\n100,40\n", "needs a unit"),
            ("length [mm],bore [mm]\n100,4\n", "is missing"),
            ("length [mm],diameter [mm],colour [mm]\n100,4,5\n", "unknown column"),
            ("length [mm],length [mm],diameter [mm]\n100,4,5\n", "twice"),
            ("length [mm],diameter [mm]\n100,thick\n", "must be a number"),
            ("length [mm],diameter [mm]\n100,\n", "must be a number"),
            ("length [mm],diameter [mm]\n", "no rows"),
            ("", "no table"),
            ("length [mm],diameter [mm]\n" + "1,4\n" * 201, "more than 200 rows"),
            ("length [mm],diameter [K]\n100,40\n", "unit of length"),
            ("length [mm],diameter [mm]\n100,-40\n", "greater than 0 mm"),
        ],
    )
    def test_tables_that_are_none(self, tmp_path: Path, table: str, rule: str) -> None:
        (tmp_path / "shaft.csv").write_text(table)
        assert rule in str(refused(SHAFT + 'sections = "shaft.csv"\n' + BEARING, tmp_path))

    @pytest.mark.parametrize(
        "name",
        ["../shaft.csv", "/etc/passwd", "a/../../shaft.csv", "..\\\\shaft.csv", "C:x.csv", "-",
         "link.csv", "a\\u0000b"],
    )  # fmt: skip
    def test_no_file_elsewhere(self, tmp_path: Path, name: str) -> None:
        inside = tmp_path / "inside"
        inside.mkdir()
        (tmp_path / "shaft.csv").write_text("length [mm],diameter [mm]\n100,40\n")
        os.symlink(tmp_path / "shaft.csv", inside / "link.csv")
        error = refused(SHAFT + f'sections = "{name}"\n' + BEARING, inside)
        assert error.field == "shafts.0.sections"
        assert "in the folder of the machine file" in str(error)
        assert error.line == 4

    def test_no_file_of_a_text_alone(self) -> None:
        assert "only a machine file" in str(refused(SHAFT + 'sections = "shaft.csv"\n' + BEARING))

    def test_no_such_file(self, tmp_path: Path) -> None:
        assert isinstance(
            refused(SHAFT + 'sections = "shaft.csv"\n' + BEARING, tmp_path), FileError
        )

    def test_a_case_file(self, tmp_path: Path) -> None:
        (tmp_path / "c.toml").write_text(
            'title = "x"\nlubricant = "ISO VG 68"\n[bearing]\ndesignation = "6308"\n'
            '[duty]\ninner_speed = "10 rpm"\n[duty.load]\nfz = "1 kN"\n[temperature]\n'
            'lubricant = "70 degC"\n'
        )
        own = BEARING.replace('designation = "6308"', 'case = "c.toml"')
        text = SHAFT + SECTIONS + own + '[bearings.bearing]\ndesignation = "6208"\n'
        found = parse_machine(SHAFT + SECTIONS + own, folder=tmp_path)
        expected = load_case(str(tmp_path / "c.toml")).replace(title="A", duty=Duty())
        assert found.bearing("A").case == expected
        assert Machine.from_toml(found.to_toml()) == found
        over = parse_machine(text + '[bearings.temperature]\ninner_ring = "80 degC"\n',
                             folder=tmp_path)  # fmt: skip
        assert over.bearing("A").case.bearing.designation == "6208"
        assert over.bearing("A").case.temperature == Temperature(
            lubricant=343.15, inner_ring=353.15
        )

    @pytest.mark.parametrize(
        ("text", "rule"),
        [
            ("", "is empty"),
            ('[duty]\ninner_speed = "10 rpm"\n', "is missing"),
            ('[bearing]\ndesignation = "6308"\n[bearings]\nx = 1\n', "unknown key"),
            ('[bearing]\ndesignation = "63x08"\n', "63x08"),
        ],
    )
    def test_case_files_that_are_none(self, tmp_path: Path, text: str, rule: str) -> None:
        (tmp_path / "c.toml").write_text(text)
        own = BEARING.replace('designation = "6308"', 'case = "c.toml"')
        assert rule in str(refused(SHAFT + SECTIONS + own, tmp_path))


def spd(size: int) -> np.ndarray:
    half = np.random.default_rng(size).normal(size=(size, size))
    return half @ half.T * 1e5


class TestHousings:
    def read(self, lines: str, tmp_path: Path | None = None) -> Housing:
        text = PLAIN + '[[housings]]\nname = "H"\n' + lines + "\n"
        return parse_machine(text, folder=tmp_path).housing("H")

    def test_three_five_or_a_matrix(self) -> None:
        three = self.read('stiffness = ["100 N/um", "2e5 N/mm", "3e8 N/m"]')
        assert three.stiffness == (1e8, 2e8, 3e8)
        assert three.holds_tilt
        five = self.read('stiffness = [1.0, 2.0, 3.0, 4.0, 5.0]\nunits = "N/mm"')
        assert five.stiffness == pytest.approx((1e3, 2e3, 3e3, 4e-3, 5e-3))
        assert not five.holds_tilt
        np.testing.assert_allclose(five.stiffness_matrix, np.diag(five.stiffness))
        matrix = spd(5)
        full = self.read(f'stiffness = {matrix.tolist()}\nunits = "N/mm"')
        scale = np.outer([1, 1, 1, 1e-3, 1e-3], [1, 1, 1, 1e-3, 1e-3]) * 1e3
        np.testing.assert_allclose(full.stiffness_matrix, matrix * scale)
        assert Housing(name="H", stiffness=matrix).stiffness_matrix.tolist() == matrix.tolist()

    @pytest.mark.parametrize("ending", ["csv", "txt", "mtx", "coordinate.mtx"])
    def test_one_matrix_over_several_bearings(self, tmp_path: Path, ending: str) -> None:
        matrix = spd(10)
        path = tmp_path / f"k.{ending}"
        if ending == "mtx":
            from scipy.io import mmwrite

            mmwrite(path, matrix)
        elif ending == "coordinate.mtx":
            lower = [(i, j) for i in range(10) for j in range(i + 1)]
            path.write_text(
                f"%%MatrixMarket matrix coordinate real symmetric\n% c\n10 10 {len(lower)}\n"
                + "".join(f"{i + 1} {j + 1} {matrix[i, j]!r}\n".replace("np.float64(", "")
                          .replace(")", "") for i, j in lower)
            )  # fmt: skip
        else:
            mark = "," if ending == "csv" else " "
            rows = [mark.join(repr(value) for value in row) for row in matrix.tolist()]
            path.write_text("# N, m\n" + "\n".join(rows) + "\n")
        lines = f'bearings = ["A", "B"]\nmatrix = "k.{ending}"\nunits = "N/m"'
        found = self.read(lines, tmp_path)
        np.testing.assert_allclose(found.stiffness_matrix, matrix, rtol=1e-12)
        built = machine(housings=[found])
        assert built.housing_of("A") == built.housing_of("B") == found
        assert parse_machine(built.to_json()) == built

    def test_decimal_commas(self, tmp_path: Path) -> None:
        (tmp_path / "k.csv").write_text(
            "\n".join(";".join("1,5" if i == j else "0" for j in range(5)) for i in range(5))
        )
        lines = 'bearings = ["A"]\nmatrix = "k.csv"\nunits = "N/m"'
        assert self.read(lines, tmp_path).stiffness_matrix.tolist() == (1.5 * np.eye(5)).tolist()

    @pytest.mark.parametrize(
        ("content", "rule"),
        [
            ("1,2\n3", "has 1 number where the first row"),
            ("1,2\n", "square"),
            ("", "square"),
            ("1,x\n2,3", "must be a number"),
            ("nan", "finite"),
            ("inf", "finite"),
            ("1", "5 rows"),
            ("1," * 601, "more than 600"),
            ("1\n" * 601, "more than 600"),
            ("%%MatrixMarket matrix array real general\n5 5\n1\n", "Matrix Market"),
            (
                "%%MatrixMarket matrix coordinate real general\n900000 900000 1\n1 1 1\n",
                "more than",
            ),
            ("%%MatrixMarket matrix coordinate real general\n5 5 99999999\n1 1 1\n", "Matrix"),
            ("%%MatrixMarket matrix coordinate complex general\n5 5 1\n1 1 1 0\n", "real"),
            ("%%MatrixMarket matrix array real general\n2 3\n1\n2\n3\n4\n5\n6\n", "square"),
            ("%%MatrixMarket rubbish\n", "Matrix Market"),
            ("a\0b", "binary"),
        ],
    )
    def test_files_that_hold_no_matrix(self, tmp_path: Path, content: str, rule: str) -> None:
        (tmp_path / "k.mtx").write_text(content)
        lines = '[[housings]]\nname = "H"\nbearings = ["A"]\nmatrix = "k.mtx"\nunits = "N/m"\n'
        assert rule in str(refused(PLAIN + lines, tmp_path))

    @pytest.mark.parametrize(
        ("lines", "field", "rule"),
        [
            ("stiffness = [1.0, 2.0, 3.0]", "stiffness", "needs units"),
            ("stiffness = [1.0, 2.0]", "stiffness", "3 numbers"),
            ("stiffness = 5", "stiffness", "3 numbers"),
            ('stiffness = ["1 N", "1 N/m", "1 N/m"]', "stiffness", "unit of stiffness"),
            ('stiffness = [true, 1, 1]\nunits = "N/m"', "stiffness", "must be a number"),
            ('stiffness = [-1.0, 1, 1]\nunits = "N/m"', "stiffness", "at least 0"),
            ('stiffness = [nan, 1, 1]\nunits = "N/m"', "stiffness", "finite"),
            ("stiffness = [1, 1, 1]\nunits = []", "units", "must be one of N/m, N/mm"),
            ('stiffness = [1, 1, 1]\nunits = "lbf/in"', "units", "must be one of N/m, N/mm"),
            ("units = \"N/m\"", "stiffness", "is missing"),
            ('bearings = ["A"]', "matrix", "is missing"),
            ("matrix = [[1.0]]", "bearings", "is missing"),
            ('stiffness = [[1.0, 2], [3], [1], [1], [1]]\nunits = "N/m"', "stiffness", "5 rows"),
            ('bearings = ["A"]\nmatrix = [[1.0]]\nunits = "N/m"', "matrix", "5 rows"),
        ],
    )  # fmt: skip
    def test_refusals(self, lines: str, field: str, rule: str) -> None:
        error = refused(PLAIN + '[[housings]]\nname = "H"\n' + lines + "\n")
        assert error.field == f"housings.0.{field}"
        assert rule in str(error)

    def test_a_matrix_that_no_structure_has(self) -> None:
        skew = np.eye(5)
        skew[0, 1] = 1e-3
        with pytest.raises(InputError, match="symmetric: row 1, column 2"):
            Housing(name="H", stiffness=skew)
        skew[0, 1] = 1e-7
        made = Housing(name="H", stiffness=skew).stiffness_matrix
        np.testing.assert_array_equal(made, made.T)
        negative = np.diag([1.0, 1.0, 1.0, 1.0, -1e-6])
        with pytest.raises(InputError, match="positive semi-definite"):
            Housing(name="H", stiffness=negative)
        Housing(name="H", stiffness=np.diag([1.0, 1.0, 1.0, 1.0, -1e-12]))

    @pytest.mark.parametrize(
        ("more", "field", "rule"),
        [
            ('bearings = ["A", "X"]', "housings.0.bearings.1", "unknown name"),
            ('bearings = ["A", "A"]', "housings.0.bearings.1", "twice"),
        ],
    )
    def test_names_of_bearings(self, more: str, field: str, rule: str) -> None:
        lines = f'[[housings]]\nname = "H"\n{more}\nmatrix = {np.eye(10).tolist()}\nunits = "N/m"\n'
        error = refused(PLAIN + lines)
        assert error.field == field
        assert rule in str(error)

    def test_one_housing_a_bearing(self) -> None:
        over_a = Housing(name="H", bearings=("A",), matrix=np.eye(5))
        with pytest.raises(InputError, match="another housing too"):
            machine(housings=[over_a, Housing(name="G", bearings=("A",), matrix=np.eye(5))])
        own = MachineBearing(name="B", shaft="s", position=0.1, designation="6308", housing="H")
        first = machine().bearings[0]
        with pytest.raises(InputError, match="is of other bearings"):
            machine(housings=[over_a], bearings=[first, own])
        with pytest.raises(InputError, match="did you mean Hx"):
            machine(housings=[Housing(name="Hx", stiffness=(1, 1, 1))], bearings=[first, own])


class TestSprings:
    def test_to_the_ground_or_another_shaft(self) -> None:
        text = (
            PLAIN + SECOND + '[[springs]]\nshaft = "s"\nposition = "10 mm"\n'
            'stiffness = ["1 N/mm", "1 N/mm", "1 N/mm"]\n'
        )
        found = Machine.from_toml(text + 'to_shaft = "t"\nto_position = "20 mm"\n')
        (spring,) = found.springs
        assert np.diag(spring.stiffness_matrix).tolist() == [1e3, 1e3, 1e3, 0.0, 0.0]
        assert parse_machine(found.to_json()) == found
        assert refused(text + 'to_shaft = "t"\n').field == "springs.0.to_position"
        assert refused(text + 'to_position = "1 mm"\n').field == "springs.0.to_shaft"
        far = refused(text + 'to_shaft = "t"\nto_position = "400 mm"\n')
        assert far.field == "springs.0.to_position"
        unknown = refused(text + 'to_shaft = "x"\nto_position = "4 mm"\n')
        assert unknown.field == "springs.0.to_shaft"

    def test_python(self) -> None:
        assert Spring(shaft="s", position=0.1, stiffness=(1, 2, 3, 4, 5)).stiffness == (
            1.0, 2.0, 3.0, 4.0, 5.0,
        )  # fmt: skip


class TestBearings:
    @pytest.mark.parametrize(
        ("lines", "field", "rule"),
        [
            ("", "designation", "is missing"),
            ('designation = "630x8"', "designation", "630x8"),
            ('designaton = "6308"', "designaton", "did you mean designation"),
            ('designation = "6308"\n[bearings.bearing]\ndesignation = "6308"',
             "bearing.designation", "twice"),
            ("[bearings.bearing]\nball_cout = 8\n", "bearing.ball_cout", "did you mean ball_count"),
            ('designation = "6308"\n[bearings.life]\nreliabilty = 0.9', "life.reliabilty",
             "reliability"),
            ('designation = "6308"\n[bearings.temperature]\nlubricant = 70',
             "temperature.lubricant", "needs a unit"),
            ('designation = "6308"\nlife = 5', "life", "must be a table"),
            ('designation = "6308"\nlubricant = "wine"', "lubricant", "unknown name"),
            ('designation = "6308"\ncase = 5', "case", "name of a case file"),
            ('designation = "6308"\nfaces = "left"', "faces", "must be one of"),
            ('designation = "6308"\nlocated = "loose"', "located", "must be one of"),
            ('designation = "6308"\nspring_force = "5 N"', "spring_force", "floating"),
            ('designation = "6308"\noffset = "5 um"\npreload = "5 N"', "preload", "combined"),
            ('designation = "NU308"\npreload = "5 N"', "preload", "no axial load"),
            ('preload = "5 N"\n[bearings.bearing]\ndesignation = "7010C"\narrangement = "DB"\n'
             'spacing = "16 mm"', "preload", "single rows"),
            ('designation = "6308"\nouter_shaft = "s"', "outer_shaft", "another shaft"),
            ('designation = "6308"\nouter_shaft = "x"', "outer_shaft", "unknown name"),
            ('designation = "6308"\nouter_shaft = "t"\nhousing = "H"', "housing", "combined"),
            ('designation = "6308"\nouter_shaft = "t"', "position", "is not on shaft"),
            ('designation = "6308"\nhousing = "H"', "housing", "none of this kind"),
        ],
    )  # fmt: skip
    def test_refusals(self, lines: str, field: str, rule: str) -> None:
        second = SECOND + 'position = "1 m"\n'
        text = second + SHAFT + SECTIONS + BEARING.replace('designation = "6308"\n', lines + "\n")
        error = refused(text)
        assert error.field == f"bearings.0.{field}"
        assert rule in str(error)
        assert error.line is not None
        assert error.line >= text.split("[[bearings]]")[0].count("\n") + 1

    def test_the_line_of_a_key_in_the_second_table(self) -> None:
        error = refused(PLAIN.replace('"280 mm"', '"380 mm"'))
        assert error.field == "bearings.1.position"
        assert error.line == PLAIN.split("\n").index('position = "280 mm"') + 1
        assert "is not on shaft" in str(error)
        assert "300 mm" in str(error)

    def test_a_bore_far_from_the_shaft_is_a_note(self) -> None:
        found = Machine.from_toml(PLAIN.replace("6308", "6310"))
        (note,) = found.notes
        assert note.key == "bore_beside_shaft"
        assert note.values["bearing"] == "A"
        assert "50 mm" in note.text
        with speaking("pt"):
            assert note.text != "bore_beside_shaft"


class TestTogether:
    @pytest.mark.parametrize(
        ("text", "field", "rule"),
        [
            (SHAFT + SECTIONS, "bearings", "at least one bearing"),
            (BEARING, "shafts", "is missing"),
            (PLAIN + SHAFT + SECTIONS, "shafts.1.name", "twice"),
            (PLAIN + BEARING, "bearings.2.name", "twice"),
            (PLAIN.replace('shaft = "s"', 'shaft = "S1"', 1), "bearings.0.shaft", "unknown name"),
            (PLAIN.replace('name = "A"', 'name = ""'), "bearings.0.name", "must not be empty"),
            (PLAIN.replace('name = "A"', 'name = "a\\u0007"'), "bearings.0.name", "one line"),
            ("speed = 1\n" + PLAIN, "speed", "unknown key"),
            (PLAIN + '[[loads]]\nshaft = "s"\nposition = "301 mm"\n', "loads.0.position", "not on"),
            (PLAIN + '[[loads]]\nshaft = "s"\nposition = "1 mm"\nfz = 5\n', "loads.0.fz", "unit"),
            (PLAIN + '[[loads]]\nshaft = "s"\nposition = "1 mm"\nfz = "nan N"\n', "loads.0.fz",
             "finite"),
            (PLAIN + "[[spectrum]]\nshare = 0.4\n[[spectrum]]\nshare = 0.5\n", "spectrum", "sum"),
            (PLAIN + "[[spectrum]]\nshare = 1.4\n", "spectrum.0.share", "at most 1"),
            (PLAIN + '[gravity]\ndirection = "down"\n', "gravity.direction", "must be one of"),
            (PLAIN + '[gravity]\nacceleration = 9.81\n', "gravity.acceleration", "needs a unit"),
            ("shafts = 5\n" + BEARING, "shafts", "must be a list"),
            (PLAIN.replace('speed = "1000 rpm"\n', "")
             + GEAR.replace('torque = "50 N m"', 'power = "5 kW"'), "gears.0.power", "at rest"),
        ],
    )  # fmt: skip
    def test_refusals(self, text: str, field: str, rule: str) -> None:
        error = refused(text)
        assert error.field == field
        assert rule in str(error)

    def test_texts_that_are_no_machine(self, tmp_path: Path) -> None:
        for text in ("", "[[", "[1]", "{", '{"shafts": [1]}', '{"shafts": null}', "a" * 100):
            refused(text)
        with pytest.raises(FileError):
            load_machine(tmp_path / "none.toml")
        with pytest.raises(FileError, match=r"\.toml or \.json"):
            save_machine(machine(), tmp_path / "machine.txt")

    def test_kinds_of_errors(self) -> None:
        assert isinstance(refused(PLAIN.replace('"1000 rpm"', "1000")), UnitError)
        assert isinstance(refused(PLAIN + "[springs2]\n"), UnknownKeyError)

    def test_json_is_read_alike(self) -> None:
        found = Machine.from_toml(PLAIN)
        mapping = json.loads(found.to_json())
        mapping["bearings"][1]["position"] = "2 m"
        error = refused(json.dumps(mapping, indent=1))
        assert error.field == "bearings.1.position"


class TestForces:
    def mates(self, **own: Any) -> dict[str, Any]:
        first = Gear(
            name="pinion", shaft="s", position=0.15, kind="helical", pitch_diameter=0.1,
            helix_angle=0.2, hand="right", torque=50.0, mesh_azimuth=0.5, drives=True, mate="wheel",
        )  # fmt: skip
        second = {
            "name": "wheel", "shaft": "t", "position": 0.1, "kind": "helical",
            "pitch_diameter": 0.2, "helix_angle": 0.2, "hand": "left", "mate": "pinion",
        }  # fmt: skip
        shafts = (
            machine().shafts[0],
            Shaft(name="t", sections=[Section(length=0.3, diameter=0.04)], ratio=-0.5, of="s"),
        )
        return {"shafts": shafts, "gears": [first, Gear(**{**second, **own})]}

    def test_mates_press_on_each_other(self) -> None:
        found = machine(**self.mates())
        first, second = found.forces()
        assert first.source == "gears.0"
        assert second.shaft == "t"
        np.testing.assert_allclose(first.force[:3], -np.array(second.force[:3]), atol=1e-9)
        assert first.force[3] == pytest.approx(-50.0)
        assert second.force[3] == pytest.approx(-100.0)
        gain = sum(one.force[3] * found.speed(one.shaft) for one in (first, second))
        assert gain == pytest.approx(0.0, abs=1e-9)
        assert parse_machine(found.to_json()) == found

    @pytest.mark.parametrize(
        ("own", "field", "rule"),
        [
            ({"hand": "right"}, "hand", "opposite hands"),
            ({"helix_angle": 0.3}, "helix_angle", "of its mate"),
            ({"pressure_angle": 0.3}, "pressure_angle", "of its mate"),
            ({"kind": "spur", "helix_angle": 0.0, "hand": "right"}, "kind", "of its mate"),
            ({"shaft": "s"}, "mate", "another shaft"),
            ({"mate": "x", "torque": 5.0, "mesh_azimuth": 0.0, "drives": True}, "mate", "in mesh"),
            ({"torque": 5.0, "mesh_azimuth": 0.0, "drives": True}, "torque", "its mate too"),
            ({"drives": False}, "drives", "follows from its mate"),
            ({"mesh_azimuth": 1.0}, "mesh_azimuth", "follows from its mate"),
            ({"pitch_diameter": 0.3}, "shaft", "pitch-line speed"),
            ({"name": "other"}, "mate", "unknown name"),
        ],
    )
    def test_mates_that_do_not_fit(self, own: dict[str, Any], field: str, rule: str) -> None:
        with pytest.raises(InputError, match=rule) as error:
            machine(**self.mates(**own))
        assert error.value.field.endswith(f".{field}")

    def test_steps_change_loads_and_speeds(self) -> None:
        found = machine(
            loads=[ShaftLoad(shaft="s", position=0.1, fz=-1000.0)],
            gears=[Gear(shaft="s", position=0.1, pitch_diameter=0.1, power=5e3, mesh_azimuth=0.0,
                        drives=True)],
            belts=[{"shaft": "s", "position": 0.2, "diameter": 0.1, "tension": 900.0,
                    "torque": 50.0, "azimuth": 0.0, "drives": False}],
            spectrum=[Step(share=0.5), Step(share=0.5, load_factor=0.5, speed_factor=2.0)],
        )  # fmt: skip
        full, part = (found.forces(step) for step in found.spectrum)
        assert found.forces() == full
        np.testing.assert_allclose(part[0].force, 0.5 * np.array(full[0].force))
        np.testing.assert_allclose(part[1].force, 0.5 * np.array(full[1].force))
        assert part[2].force[3] == pytest.approx(25.0)
        assert part[2].force[2] == pytest.approx(full[2].force[2])  # the tension stays
        back = found.forces(Step(share=1.0, load_factor=-1.0))
        assert back[1].force[3] == pytest.approx(-full[1].force[3])

    def test_a_step_that_a_belt_cannot_bear(self) -> None:
        with pytest.raises(InputError, match="no tension left") as error:
            machine(
                belts=[{"shaft": "s", "position": 0.2, "diameter": 0.1, "tension": 900.0,
                        "torque": 50.0, "azimuth": 0.0, "drives": False}],
                spectrum=[Step(share=0.5), Step(share=0.5, load_factor=2.0)],
            )  # fmt: skip
        assert error.value.field == "belts.0.tension"


JUNK = (
    None, 0, -1, 1e308, math.nan, math.inf, 10**400, True, "", "x", "-1 mm", "1e400 mm", "5 mm",
    "1 N", "30 deg", [], [1], {}, {"a": 1}, [[1, 2], [3]], "\0", "../x", "NU308", ["A", "A"], [{}],
    [None], "1 N/m", {"designation": "6308"}, [{"length": "1 mm", "diameter": "1 mm"}],
)  # fmt: skip
KINDS = (Machine, Shaft, Section, MachineBearing, Housing, Spring, ShaftLoad, Gear, Step)
KEYS = sorted({name for kind in KINDS for name in kind.model_fields} | {"case"})


def places(value: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    inner = value.items() if isinstance(value, dict) else ()
    inner = enumerate(value) if isinstance(value, list) else inner
    return [path, *(place for key, one in inner for place in places(one, (*path, key)))]


@pytest.mark.parametrize("seed", range(8))
def test_whatever_a_file_holds_it_is_read_or_refused(machines: Path, seed: int) -> None:
    chance = random.Random(seed)
    bases = [tomllib.loads((machines / f"{name}.toml").read_text("utf-8")) for name in NAMES]
    read = 0
    for _ in range(200):
        mapping = copy.deepcopy(chance.choice(bases))
        for _ in range(chance.randint(1, 2)):
            *path, last = chance.choice(places(mapping)[1:])
            holder: Any = mapping
            for part in path:
                holder = holder[part]
            junk = copy.deepcopy(chance.choice(JUNK))
            if chance.random() < 0.7 or isinstance(holder, list):
                holder[last] = junk
            elif chance.random() < 0.5:
                del holder[last]
            else:
                holder[chance.choice(KEYS)] = junk
        try:
            found = Machine.from_mapping(mapping)
        except InputError as error:
            assert str(error)
            continue
        read += 1
        assert Machine.from_toml(found.to_toml()) == found == parse_machine(found.to_json())
    assert read


def test_numbers_come_back_bit_for_bit() -> None:
    odd = math.pi / 7
    found = machine(
        shafts=[Shaft(name="s", sections=[Section(length=odd, diameter=odd / 9)], speed=odd * 1e3)],
        housings=[Housing(name="H", stiffness=(odd * 1e8, odd * 1e7, odd * 1e6, 1 / 3, 0.1))],
        masses=[{"shaft": "s", "position": odd / 3, "mass": odd, "unbalance": odd * 1e-6}],
        gravity={"acceleration": odd},
    )
    assert Machine.from_toml(found.to_toml()) == found
    assert parse_machine(found.to_json()) == found


class TestHousingNodes:
    """A matrix over nodes in the order and the units of a program."""

    AXES = ("x", "y", "z", "rx", "ry", "rz")

    def made(self, tmp_path: Path, seed: int = 0, *, shuffled: bool, lines: str = "") -> Machine:
        """Two rings with all six directions, and two nodes more that are stiff or soft."""
        random = np.random.default_rng(seed)
        half = random.normal(size=(14, 14))
        arm = np.array([*(1.0, 1.0, 1.0, 0.05, 0.05, 0.05) * 2, 1.0, 1.0])
        stiffness = 1e8 * (half @ half.T + np.eye(14)) * np.outer(arm, arm)
        rows = [(n, axis) for n in ("A", "B") for axis in self.AXES] + [("", "x"), ("", "y")]
        order = random.permutation(14) if shuffled else np.arange(14)
        cells, factors = [], []
        for place in order:
            bearing, axis = rows[place]
            tilts, metric = axis[0] == "r", shuffled and place % 2 == 0
            sign = -1.0 if metric else 1.0
            shift, unit = (180.0 / np.pi, "deg") if tilts and metric else (1.0, "rad")
            if not tilts:
                shift, unit = (1e3, "mm") if metric else (1.0, "m")
            force, name = (1e-3, "kN m" if tilts else "kN") if metric else (1.0, "N m")
            name = name if tilts or metric else "N"
            factors.append((sign * force, sign * shift))
            dof = f"-{axis}" if metric else axis
            cells.append(f"{place},{dof},{unit},{name},{bearing}")
        given = stiffness[np.ix_(order, order)]
        given = given * np.array([f for f, _ in factors])[:, np.newaxis]
        given = given / np.array([s for _, s in factors])
        (tmp_path / "k.csv").write_text(
            "\n".join(",".join(repr(float(v)) for v in row) for row in given)
        )
        (tmp_path / "n.csv").write_text(
            "node,dof,displacement,force,bearing\n" + "\n".join(cells) + "\n"
        )
        lines = lines or 'others = "free"'
        text = f'[[housings]]\nname = "H"\nmatrix = "k.csv"\nnodes = "n.csv"\n{lines}\n'
        load = '[[loads]]\nshaft = "s"\nposition = "100 mm"\nfx = "1 kN"\nfz = "4 kN"\n'
        return parse_machine(PLAIN + load + text, folder=tmp_path)

    @pytest.mark.parametrize("others", ["free", "held"])
    def test_order_and_units_change_nothing(self, tmp_path: Path, others: str) -> None:
        lines = f'bearings = ["A", "B"]\nothers = "{others}"'
        plain, mixed = (
            self.made(tmp_path, shuffled=shuffled, lines=lines) for shuffled in (False, True)
        )
        one, other = (found.housing("H") for found in (plain, mixed))
        assert one.bearings == other.bearings == ("A", "B")
        scale = np.abs(one.stiffness_matrix).max()
        np.testing.assert_allclose(
            one.stiffness_matrix, other.stiffness_matrix, rtol=0, atol=1e-13 * scale
        )
        solved = [shaft(found) for found in (plain, mixed)]
        places = [np.concatenate([b.outer[0] for b in s.bearings.values()]) for s in solved]
        assert np.abs(places[0]).max() > 1e-7
        np.testing.assert_allclose(*places, rtol=0, atol=1e-12 * np.abs(places[0]).max())

    def test_condensed_is_what_nothing_acts_on(self, tmp_path: Path) -> None:
        """Forces on the rings alone move them as the inverse of the whole says."""
        found = self.made(tmp_path, shuffled=False).housing("H").stiffness_matrix
        whole = np.loadtxt(tmp_path / "k.csv", delimiter=",")
        rings = [0, 1, 2, 4, 5, 6, 7, 8, 10, 11]
        np.testing.assert_allclose(
            np.linalg.inv(found), np.linalg.inv(whole)[np.ix_(rings, rings)], rtol=1e-6
        )
        held = self.made(tmp_path, shuffled=False, lines='others = "held"').housing("H")
        np.testing.assert_allclose(held.stiffness_matrix, whole[np.ix_(rings, rings)])

    def test_units_for_all_and_in_python(self) -> None:
        matrix = np.diag(np.arange(1.0, 6.0))
        nodes = [{"dof": axis, "bearing": "A"} for axis in ("ux", "UY", "3", "rotY", "6")]
        found = Housing.of_nodes("H", matrix, nodes, units="N/mm")
        expected = np.diag([1e3, 2e3, 3e3, 4e-3, 5e-3])
        np.testing.assert_allclose(found.stiffness_matrix, expected)
        assert found.bearings == ("A",)

    def test_what_holds_nothing_may_be_free(self) -> None:
        """A node that no stiffness holds, as of a ring that turns."""
        matrix = np.diag([1.0, 2.0, 3.0, 0.0, 4.0, 5.0])
        nodes = [{"dof": axis, "bearing": "A"} for axis in self.AXES]
        found = Housing.of_nodes("H", matrix, nodes, units="N/m", others="free")
        np.testing.assert_allclose(np.diag(found.stiffness_matrix), [1, 2, 3, 4, 5])

    @pytest.mark.parametrize(
        ("old", "new", "field", "rule"),
        [
            ("x,m,N,A", "x,mmm,N,A", "displacement", "did you mean mm"),
            ("x,m,N,A", "x,rad,N,A", "displacement", "unit of length"),
            ("x,m,N,A", "q,m,N,A", "dof", "must be one of x, y, z"),
            ("x,m,N,A", "x,m,,A", "force", "needs a unit"),
            ("x,m,N,A", "x,m,kN,A", "housings.0.matrix", "must be symmetric"),
            ("x,m,N,A", "y,m,N,A", "dof", "is given twice"),
            ("x,m,N,A", "x,m,N,", "housings.0.nodes", 'has no row for x of "A"'),
            ("x,m,N,A", "x,m,N,C", "bearing", "is an unknown name"),
            ("dof", "axis", "axis", "unknown column"),
            ("bearing\n0,x,m,N,A\n", "bearing\n", "housings.0.nodes", "a row for each of the 14"),
        ],
    )
    def test_lists_that_fit_no_matrix(
        self, tmp_path: Path, old: str, new: str, field: str, rule: str
    ) -> None:
        self.made(tmp_path, shuffled=False)
        path = tmp_path / "n.csv"
        path.write_text(path.read_text().replace(old, new, 1))
        text = '[[housings]]\nname = "H"\nmatrix = "k.csv"\nnodes = "n.csv"\nothers = "free"\n'
        text += 'bearings = ["A", "B"]\n'
        with pytest.raises(InputError, match=rule) as caught:
            parse_machine(PLAIN + text, folder=tmp_path)
        assert caught.value.field == field

    @pytest.mark.parametrize(
        ("lines", "field", "rule"),
        [
            ("units = 'N/m'", "housings.0.others", "4 rows are of no ring"),
            ("others = 'loose'", "housings.0.others", "must be one of free, held"),
        ],
    )
    def test_what_becomes_of_the_rest(
        self, tmp_path: Path, lines: str, field: str, rule: str
    ) -> None:
        with pytest.raises(InputError, match=rule) as caught:
            self.made(tmp_path, shuffled=False, lines=lines)
        assert caught.value.field == field

    @pytest.mark.parametrize(
        ("lines", "field"),
        [("others = 'free'\nmatrix = [[1.0]]", "nodes"), ("nodes = 'n.csv'", "matrix")],
    )
    def test_matrix_and_nodes_go_together(self, tmp_path: Path, lines: str, field: str) -> None:
        with pytest.raises(InputError, match="is missing") as caught:
            parse_machine(PLAIN + f'[[housings]]\nname = "H"\n{lines}\n', folder=tmp_path)
        assert caught.value.field == f"housings.0.{field}"

    def test_no_structure_is_soft_below_nothing(self) -> None:
        nodes = [{"dof": axis, "bearing": "A"} for axis in ("x", "y", "z", "ry", "rz")]
        with pytest.raises(InputError, match="positive semi-definite") as caught:
            Housing.of_nodes("H", np.diag([1.0, 1.0, 1.0, -1.0, 1.0]), nodes, units="N/m")
        assert caught.value.field == "matrix"
