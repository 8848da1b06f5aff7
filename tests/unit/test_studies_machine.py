"""Studies of machines: the numbers of `shaft`, whatever varies, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import rolamento as ro
from rolamento.case.machine import load_machine
from rolamento.case.machine_fields import field_of_machine, fields_of_machine
from rolamento.errors import InputError
from rolamento.machines import acts_alone, shaft, solve_machines
from rolamento.pages.study import fields_text, outputs_text
from rolamento.studies import Axis, Distribution, Scatter, Study, load_result, run, run_to_file
from rolamento.studies.of_machine import MOST_MACHINES
from rolamento.studies.plan import Plan, solve_task
from rolamento.studies.sensitivity import sobol
from rolamento.studies.study import parse_study, study_to_json, study_to_toml
from rolamento.tasks.studies import tolerance

MACHINES = Path(ro.__file__).parent / "examples" / "machines"
MOTOR, GEAR = MACHINES / "motor.toml", MACHINES / "gear_shaft.toml"
DRIVE = 'bearings."drive end".position'


def scattered(count: int = 12, **more: object) -> Study:
    tension = Distribution(distribution="normal", mean="1100 N", standard_deviation="30 N")
    place = Distribution(distribution="uniform", minimum="300 mm", maximum="303 mm")
    fields = {"belts.0.tension": tension, DRIVE: place}
    given = {"machine": load_machine(MOTOR), "seed": 4, **more}
    return Study(scatter=Scatter(count=count, fields=fields), **given)


@pytest.fixture(scope="module")
def gear() -> ro.Machine:
    return load_machine(GEAR)


class TestNumbers:
    def test_each_point_is_that_of_shaft(self, gear: ro.Machine) -> None:
        """Forces together with a bearing of its own, under a spectrum of three steps."""
        powers = [15e3, 25e3]
        study = Study(
            machine=gear,
            axes=[
                Axis(field="gears.wheel.power", values=powers),
                Axis(field="bearings.locating.designation", values=["6308", "6309"]),
            ],
        )
        result = run(study)
        assert dict(result.sizes) == {"power": 2, "designation": 2}
        for i, power in enumerate(powers):
            for j, name in enumerate(("6308", "6309")):
                settings = [f"gears.0.power={power} W", f"bearings.locating.designation={name}"]
                alone = ro.analyse_machine(load_machine(GEAR, settings))
                cell = result.isel(power=i, designation=j)
                seat = alone.solved.bearings["locating"]
                own = alone.lives["locating"]
                assert alone.together is not None
                assert own is not None
                expected = {
                    "life_hours": alone.together.hours,
                    "radial_force of locating": seat.radial_force.max(),
                    "ring_tilt of locating": seat.tilt.max(),
                    "max_pressure of locating": seat.max_pressure.max(),
                    "bearing_life_hours of locating": own.headline.hours,
                    "shaft_deflection of output shaft": (
                        alone.solved.shafts["output shaft"].deflection.max()
                    ),
                    "shaft_stress of output shaft": (
                        alone.solved.shafts["output shaft"].stress.max()
                    ),
                }
                for output, value in expected.items():
                    assert float(cell[output]) == pytest.approx(value, rel=1e-8), output

    def test_together_or_alone(self, gear: ro.Machine) -> None:
        """Machines that are solved at once are those that are solved one by one."""
        machines = [
            gear.replace(gears=[gear.gears[0].replace(power=power)]) for power in (1e4, 2e4, 3e4)
        ]
        together = solve_machines(machines)
        assert (len(together.machines), len(together)) == (3, 9)
        for index, machine in enumerate(machines):
            alone = shaft(machine)
            part = together.of_machine(index)
            assert part.machine == machine
            assert part.steps == alone.steps
            one, other = (found.shafts["output shaft"] for found in (part, alone))
            np.testing.assert_allclose(one.displacement, other.displacement, rtol=0, atol=1e-13)
            np.testing.assert_allclose(one.torque, other.torque)
            for name, seat in alone.bearings.items():
                np.testing.assert_allclose(part.bearings[name].force, seat.force, atol=1e-6)

    def test_what_leaves_the_structure(self, gear: ro.Machine) -> None:
        assert acts_alone(gear, ("gears", "0", "power"))
        assert acts_alone(gear, ("shafts", "0", "speed"))
        assert not acts_alone(gear, ("gears", "0", "position"))
        assert not acts_alone(gear, ("bearings", "0", "bearing", "diametral_clearance"))

    def test_a_field_of_the_structure(self) -> None:
        study = Study(
            machine=load_machine(MOTOR),
            outputs=("shaft_deflection of rotor shaft", "bearing_status"),
            axes=[Axis(field="shafts.rotor shaft.material.youngs_modulus", values=[1e11, 2e11])],
        )
        result = run(study)
        soft, stiff = result["shaft_deflection of rotor shaft"].values
        assert 1.2 < soft / stiff < 2.0  # bearings yield too
        assert result["bearing_status of drive end"].values.tolist() == [0, 0]

    def test_draws_do_not_depend_on_chunks(self) -> None:
        study = scattered()
        whole, parts = Plan(study, 12), Plan(study, 5)
        one = whole.solve(0).arrays["life_hours"]
        two = np.concatenate(
            [solve_task(parts.task(index)).arrays["life_hours"] for index in range(parts.chunks)]
        )
        np.testing.assert_allclose(one, two, rtol=1e-10)
        assert len(set(one.tolist())) == 12

    def test_a_point_without_a_result(self) -> None:
        study = Study(
            machine=load_machine(MOTOR),
            outputs=("life_hours", "life_valid", "weakest_bearing", "friction_power"),
            axes=[
                Axis(field="bearings.drive end.located", values=["both", "floating"]),
                Axis(field="belts.0.tension", values=["1 kN", "100 N"]),
            ],
        )
        result = run(study)
        codes = result.status.attrs["flag_meanings"].split()
        values = result.status.attrs["flag_values"].tolist()
        named = [codes[values.index(code)] for code in result.status.values.ravel().tolist()]
        assert named == ["converged", "invalid_input", "no_equilibrium", "invalid_input"]
        assert np.isfinite(result.life_hours.values).ravel().tolist() == [True, False, False, False]
        reasons = [str(text) for text in result.reason_text.values]
        assert any("must be at least" in text for text in reasons)
        assert any("Nothing holds" in text for text in reasons)
        assert result.weakest_bearing.values[0, 0] == 1.0


class TestFilesAndFaces:
    @pytest.mark.parametrize("ending", ["nc", "csv", "parquet", "xlsx"])
    def test_every_kind_of_file(self, tmp_path: Path, ending: str) -> None:
        from rolamento.tasks.studies import sweep

        target = tmp_path / f"found.{ending}"
        found = sweep(scattered(4), target, keep_cases=True)
        assert found.summary.converged == 4
        assert target.stat().st_size > 0
        names = [column.name for column in found.summary.columns]
        assert names[:5] == ["sample", "tension", "position", "status", "reason"]
        if ending == "nc":
            result = load_result(target)
            assert result.position.attrs["field"] == DRIVE
            assert result.attrs["title"].startswith("Electric motor")
            assert ro.Machine.from_toml(result.attrs["machine"]) == load_machine(MOTOR)

    def test_lives_in_the_units_that_people_read(self, tmp_path: Path) -> None:
        """Hours of a table are those of the result; so are millions of revolutions of a case."""
        from rolamento.document.tables import to_csv
        from rolamento.pages.study import study_page
        from rolamento.tasks.studies import sweep

        case = Study(
            case=ro.load_case("6310").with_(fz=5e3, inner_speed="1000 rpm"),
            outputs=("life_hours", "life_revolutions"),
            axes=[Axis(field="duty.load.fx", values=[0.0])],
        )
        for study in (scattered(1), case):
            summary = sweep(study, tmp_path / "x.nc", keep_cases=True).summary
            hours = {one.name: one.values[0] for one in summary.columns}["life_hours"]
            head, line = to_csv(study_page(summary), "cases").splitlines()[:2]
            row = dict(zip(head.split(","), line.split(","), strict=True))
            assert float(row["life_hours_h"]) == pytest.approx(hours, rel=1e-12)
            if study.case is not None:
                assert float(row["life_revolutions_Mrev"]) == pytest.approx(
                    hours * 60e3 / 1e6, rel=1e-9
                )

    def test_a_study_is_written_and_read(self, tmp_path: Path) -> None:
        study = scattered(3)
        assert parse_study(study_to_toml(study)) == study
        assert parse_study(study_to_json(study), format="json") == study
        summary = run_to_file(study, tmp_path / "x.nc")
        again = parse_study(load_result(tmp_path / "x.nc").attrs["study"])
        assert again == study
        assert summary.cases == 3

    def test_a_file_that_names_a_machine(self, tmp_path: Path) -> None:
        (tmp_path / "m.toml").write_text(MOTOR.read_text())
        text = 'machine = "m.toml"\n[[axes]]\nfield = "belts.0.tension"\nvalues = ["1 kN"]\n'
        settings = ["bearings.drive end.designation=6311"]
        study = parse_study(text, folder=tmp_path, overrides=settings)
        assert study.machine is not None
        assert study.machine.bearing("drive end").designation == "6311"
        other = parse_study(
            text, folder=tmp_path, overrides={"bearings.drive end.designation": "6311"}
        )
        assert other == study
        table = study_to_toml(study)
        assert parse_study(table) == study

    def test_python(self, gear: ro.Machine) -> None:
        found = ro.sweep(gear, {"gears.wheel.power": ["10 kW", "20 kW"]}, outputs=["life_hours"])
        assert found.life_hours.values[0] > 5.0 * found.life_hours.values[1] > 0.0

    def test_tolerance_and_sobol(self) -> None:
        study = scattered(30, outputs=("life_hours", "radial_force"))
        found = tolerance(study, percentiles=(10.0, 50.0, 90.0))
        assert [band.name for band in found.bands.bands] == [
            "life_hours", "radial_force of non-drive end", "radial_force of drive end",
        ]  # fmt: skip
        assert found.ranks is not None
        assert found.ranks.ranking("radial_force of drive end")[0] == 0  # the tension
        shares = sobol(study.replace(outputs=("radial_force of drive end",)), samples=32)
        assert shares.total[0, 0] > 5.0 * abs(shares.total[0, 1])

    def test_lists(self, gear: ro.Machine) -> None:
        study = Study(machine=gear, axes=[Axis(field="gears.0.power", values=[1e4])])
        listed = fields_text(study.subject)
        assert "bearings.locating.bearing.diametral_clearance" in listed
        assert "shafts.output shaft.sections.0.diameter" in listed
        outputs = outputs_text(study.subject)
        assert "per bearing" in outputs
        assert "life_hours*" in outputs
        for name in fields_of_machine(gear):
            study.subject.check_field(name, "field")


@pytest.mark.parametrize(
    ("key", "unit", "leaf"),
    [
        ("loads.0.fz", "N", "fz"),
        ("shafts.0.sections.1.diameter", "m", "diameter"),
        ("bearings.x.bearing.diametral_clearance", "m", "diametral_clearance"),
        ('bearings."a.b".position', "m", "position"),
        ("housings.0.stiffness.1", "N/m", "stiffness"),
        ("housings.0.stiffness.4", "N*m/rad", "angular_stiffness"),
        ("gravity.acceleration", "m/s^2", "acceleration"),
    ],
)
def test_fields_of_parts(key: str, unit: str, leaf: str) -> None:
    found = field_of_machine(key)
    assert found is not None
    assert (found.unit, found.leaf, found.name) == (unit, leaf, key)


@pytest.mark.parametrize(
    "key", ["loads.0", "loads.0.name", "loads.0.fq", "duty.load.fx", "housings.0.stiffness", "="]
)
def test_no_fields_of_parts(key: str) -> None:
    assert field_of_machine(key) is None


TENSION = Axis(field="belts.0.tension", values=["1 kN"])


@pytest.mark.parametrize(
    ("changes", "field", "rule"),
    [
        ({"axes": [Axis(field="duty.load.fx", values=[1.0])]}, "axes.0.field", "of a machine"),
        ({"axes": [Axis(field="loads.0.fz", values=[1.0])]}, "axes.0.field", "none of this kind"),
        (
            {"axes": [Axis(field="bearings.drive.offset", values=[0.0])]},
            "axes.0.field",
            "drive end",
        ),
        ({"axes": [TENSION, TENSION]}, "axes.1.field", "varied twice"),
        (
            {"axes": [TENSION, Axis(field="belts.pulley.tension", values=["1 kN"])]},
            "axes.1.field",
            "varied twice",
        ),
        ({"axes": [TENSION], "outputs": ("x",)}, "outputs", "unknown output"),
        ({"axes": [TENSION], "case": "6305"}, "machine", "combined"),
        ({"axes": [TENSION], "variants": [{"name": "a"}]}, "variants", "axis"),
        (
            {
                "axes": [
                    Axis(
                        field="belts.0.tension", first="1 kN", last="2 kN", count=MOST_MACHINES + 1
                    )
                ]
            },
            "axes",
            "at most 10.000",
        ),
    ],
)
def test_what_is_no_study_of_a_machine(changes: dict[str, object], field: str, rule: str) -> None:
    if "case" in changes:
        changes = {**changes, "case": ro.load_case("6305")}
    with pytest.raises(InputError, match=rule) as caught:
        Study(machine=load_machine(MOTOR), **changes)
    assert caught.value.field == field


def test_a_field_of_a_machine_in_a_study_of_a_case() -> None:
    with pytest.raises(InputError, match="of a machine, and the study is of a case"):
        Study(case=ro.load_case("6305"), axes=[TENSION])


def test_fields_of_which_a_bearing_takes_one() -> None:
    both = {
        "bearings.0.preload": ["100 N"],
        "bearings.0.offset": ["1 um"],
    }
    with pytest.raises(InputError, match="cannot be combined with"):
        Axis(name="both", zipped=both)


def test_steel_and_oil_by_name_field_by_field() -> None:
    machine = load_machine(
        GEAR, ["shafts.0.material.youngs_modulus=100 GPa", "lubricant.viscosity_40=100 mm^2/s"]
    )
    assert machine.shafts[0].youngs_modulus == 100e9
    assert machine.shafts[0].density == 7850.0
    assert machine.lubricant is not None
    with pytest.raises(InputError, match="none of this kind"):
        load_machine(GEAR, ["loads.0.fz=1 N"])


def test_a_machine_is_no_study() -> None:
    with pytest.raises(InputError, match="a study names one") as caught:
        parse_study(MOTOR.read_text("utf-8"))
    assert caught.value.field == "shafts"
