"""A batch that varies any field is the same as the cases with that field, one by one.

Values are drawn beyond the bounds as well: a batch calls a case invalid exactly where the case
itself is refused.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from rolamento import Bearing, Case, Duty, InputError, Load, Model
from rolamento.case.roller_bearing import RollerBearing
from rolamento.case.varied import batch_fields
from rolamento.clearance import MOUNTED_FIELDS
from rolamento.solution import solve
from rolamento.solved import Solved

GEOMETRY = (
    "ball_diameter",
    "pitch_diameter",
    "contact_angle",
    "diametral_clearance",
    "inner_conformity",
    "outer_conformity",
)
PRELOADS = ("force", "offset", "spring")
ANGULAR: dict[str, Any] = {
    "ball_count": 16,
    "ball_diameter": "22.23 mm",
    "pitch_diameter": "125.26 mm",
    "contact_angle": "40 deg",
    "inner_conformity": 0.5232,
    "outer_conformity": 0.5232,
}
DUTY = Duty(inner_speed=300.0, load=Load(fx=4e3, fz=2e3))
CASES = {
    "plain": Case(bearing=Bearing(**ANGULAR), duty=DUTY),
    "shoulders": Case(
        bearing=Bearing(**ANGULAR, inner_shoulder_height="6 mm", ball_material="Si3N4"), duty=DUTY
    ),
    "clearance": Case(
        bearing=Bearing(**{**ANGULAR, "contact_angle": None, "diametral_clearance": "50 um"}),
        duty=DUTY,
    ),
    "pair": Case(
        bearing=Bearing(**ANGULAR, arrangement="DB", spacing="40 mm", preload="2 kN"), duty=DUTY
    ),
    "rows": Case(
        bearing=Bearing(
            **ANGULAR,
            rows=[
                {"position": "-30 mm", "ball_count": 14, "contact_angle": "30 deg"},
                {"position": "30 mm", "orientation": "-", "inner_conformity": 0.53},
            ],
            preload={"offset": "10 um"},
        ),
        duty=DUTY,
    ),
    "rolling": Case(
        bearing=Bearing(**{**ANGULAR, "ball_count": 5}),
        duty=DUTY.replace(load=Load(fx=4e3)),
        model=Model(raceway_control="friction", mesh="coarse"),
        lubricant="BP 135",
    ),
}
CASES["mounted"] = CASES["plain"].replace(
    temperature={"inner_ring": 340.0, "outer_ring": 330.0},
    mounting={
        "bore": 0.09,
        "outside_diameter": 0.16,
        "shaft_interference": 1e-5,
        "housing_interference": -2e-6,
        "housing_outside_diameter": 0.24,
    },
)
CASES["arches"] = Case(
    bearing=Bearing(
        **{**ANGULAR, "ball_count": 6, "contact_angle": "35 deg"},
        kind="four_point",
        shim_angle="28 deg",
    ),
    duty=DUTY,
)
CASES["mounted pair"] = CASES["pair"].replace(
    temperature=CASES["mounted"].temperature, mounting=CASES["mounted"].mounting
)
ROLLERS: dict[str, Any] = {
    "roller_count": 9,
    "roller_diameter": "10 mm",
    "effective_length": "11 mm",
    "roller_length": "12 mm",
    "pitch_diameter": "60 mm",
}
ON_NJ = Duty(inner_speed=150.0, load=Load(fx=300.0, fz=4e3))
CASES["cylindrical"] = Case(
    bearing=RollerBearing(
        **ROLLERS, element="cylindrical", diametral_clearance="20 um", inner_ribs="-",
        axial_play="50 um", roller_material="Si3N4",
    ),
    duty=ON_NJ,
)  # fmt: skip
CASES["tapered"] = Case(
    bearing=RollerBearing(
        **ROLLERS, element="tapered", contact_angle="14 deg", roller_half_angle="2 deg"
    ),
    duty=DUTY,
)
CASES["toroidal"] = Case(
    bearing=RollerBearing(
        **ROLLERS, element="barrel", kind="toroidal", outer_raceway_radius="150 mm",
        roller_profile_radius="140 mm", inner_raceway_radius="160 mm", diametral_clearance="20 um",
    ),
    duty=DUTY.replace(load=Load(fz=4e3), displacement={"x": "0 mm"}),
)  # fmt: skip
OF_ROLLERS = {
    **dict.fromkeys(
        ("roller_diameter", "effective_length", "roller_length", "rib_height"),
        ("cylindrical", "tapered"),
    ),
    **dict.fromkeys(("roller_half_angle", "roller_end_radius"), ("tapered",)),
    **dict.fromkeys(("axial_play", "roller_material"), ("cylindrical",)),
    **dict.fromkeys(
        ("roller_profile_radius", "inner_raceway_radius", "outer_raceway_radius"), ("toroidal",)
    ),
}
"""Which cases the fields of rollers are tried on."""
FOR_ROLLING = (
    "lubricant.friction_coefficient", "model.cage_drag", "temperature.lubricant",
    "duty.inner_speed", "bearing.inner_conformity",
)  # fmt: skip
# within the bounds or not, and near them
VALUES: dict[str, tuple[float, float, tuple[float, ...]]] = {
    "duty.inner_speed": (-1500.0, 1500.0, (0.0, 1e5, 2e5, -1e7)),
    "duty.outer_speed": (-500.0, 500.0, (0.0, 2e5)),
    "duty.first_ball_azimuth": (-7.0, 7.0, (6.2831853, 6.2831854)),
    "duty.load.fx": (1e2, 5e4, (-1e10, 1e9, 1e12)),
    "duty.load.fy": (-4e3, 4e3, (0.0, 2e9)),
    "duty.load.fz": (-4e3, 4e3, (0.0, -2e9)),
    "duty.load.my": (-50.0, 50.0, (0.0, 1e9, 2e9)),
    "duty.load.mz": (-50.0, 50.0, (0.0, -2e9)),
    "duty.displacement.x": (1e-6, 4e-5, (0.02223, 0.0223, -0.5, 2.0)),
    "duty.displacement.y": (-2e-5, 2e-5, (-0.0223,)),
    "duty.displacement.z": (-2e-5, 2e-5, (0.0223,)),
    "duty.displacement.ry": (-5e-4, 5e-4, (0.08, 0.09, -0.09)),
    "duty.displacement.rz": (-5e-4, 5e-4, (0.09,)),
    "bearing.ball_diameter": (0.018, 0.0243, (0.0244, 0.0246, 0.0, -1.0, 0.011, 0.012, 2.0)),
    "bearing.pitch_diameter": (0.115, 0.2, (0.1139, 0.02, 0.0, 25.0)),
    "bearing.roller_diameter": (0.008, 0.012, (0.0, -1.0, 0.0204, 0.0206, 0.06, 2.0)),
    "bearing.effective_length": (0.006, 0.012, (0.0, 0.0121, 2.0)),
    "bearing.roller_length": (0.011, 0.02, (0.0109, 0.0, 2.0)),
    "bearing.roller_half_angle": (0.01, 0.05, (0.0, 0.1221, 0.1223, 0.8)),
    "bearing.axial_play": (0.0, 2e-4, (-1e-6, 2.0)),
    "bearing.rib_height": (2e-4, 2e-3, (0.0, 9e-3, 2.0)),
    "bearing.roller_end_radius": (0.1, 1.0, (0.0, 1e-3, 101.0)),
    "bearing.roller_profile_radius": (0.1, 0.149, (0.0, 0.16, 1e3)),
    "bearing.inner_raceway_radius": (0.141, 0.3, (0.0, 0.13, 1e3)),
    "bearing.outer_raceway_radius": (0.141, 0.3, (0.0, 0.13, 1e3)),
    "bearing.roller_material.youngs_modulus": (1e11, 4e11, (0.0, 1e30)),
    "bearing.roller_material.poisson_ratio": (0.1, 0.45, (0.5, 0.6)),
    "bearing.roller_material.density": (2e3, 9e3, (0.0, -5.0)),
    "bearing.contact_angle": (0.1, 1.2, (0.0, 1.5707, 1.5708, -0.1)),
    "bearing.diametral_clearance": (-5e-5, 4e-4, (0.0, -3e-4, 2.1e-3, 2.0)),
    "bearing.inner_conformity": (0.505, 0.6, (0.501, 0.5, 1.0, 1.01)),
    "bearing.outer_conformity": (0.505, 0.6, (0.5009, 1.001)),
    "bearing.ring_material.youngs_modulus": (1e11, 4e11, (0.0, -1.0, 1e30)),
    "bearing.ring_material.poisson_ratio": (0.1, 0.45, (0.0, 0.5, 0.6, -0.1)),
    "bearing.ring_material.density": (2e3, 9e3, (0.0, -5.0)),
    "bearing.ball_material.youngs_modulus": (1e11, 4e11, (0.0, 1e30)),
    "bearing.ball_material.poisson_ratio": (0.1, 0.45, (0.5, 0.6)),
    "bearing.ball_material.density": (2e3, 9e3, (0.0, -5.0)),
    "bearing.shim_angle": (0.0, 0.6, (0.62, 1.5707, 1.5708, -0.1)),
    "bearing.spacing": (0.01, 0.3, (0.0, -0.1, 10.0, 10.1)),
    "bearing.preload.force": (100.0, 6e3, (0.0, -1.0, 2e9)),
    "bearing.preload.offset": (1e-6, 3e-5, (0.0, -5e-6, 0.02)),
    "bearing.preload.spring": (100.0, 6e3, (0.0, -1.0, 2e9)),
    "lubricant.friction_coefficient": (0.02, 0.3, (0.0, 2.1, -0.1)),
    "model.cage_drag": (0.0, 0.02, (-1.0, 2e6)),
    "temperature.lubricant": (250.0, 450.0, (173.1, 673.2, -1.0)),
    **{f"life.{name}": (1e3, 1e6, (0.0, -1.0, 2e9))
       for name in ("dynamic_rating", "static_rating", "fatigue_load_limit")},
    "life.contamination": (0.0, 1.0, (-0.1, 1.1)),
    "life.viscosity_ratio": (0.1, 4.0, (0.0, -1.0, 2e6)),
    "life.material_factor": (0.1, 2.0, (0.0, 2e3)),
    "life.operation_factor": (0.1, 2.0, (0.0, 2e3)),
    "life.fatigue_limit": (1e8, 1e9, (0.0, -1.0, 2e11)),
    "life.nsk_cleanliness": (0.05, 1.0, (0.04, 1.1)),
    **{f"temperature.{part}": (300.0, 360.0, (173.0, 674.0, -1.0))
       for part in ("inner_ring", "outer_ring", "balls", "shaft", "housing",
                    "inner_spacer", "outer_spacer")},
    "mounting.shaft_interference": (-2e-5, 5e-5, (1.1e-3, -1.1e-3, 9e-4)),
    "mounting.housing_interference": (-2e-5, 5e-5, (1.1e-3, 9e-4)),
    "mounting.shaft_bore": (0.0, 0.085, (-0.01, 0.09, 0.1)),
    "mounting.housing_outside_diameter": (0.17, 1.0, (0.16, 0.1, -1.0)),
    "mounting.shaft_roughness": (0.0, 2e-5, (-1e-6, 2e-3)),
    "mounting.housing_roughness": (0.0, 2e-5, (-1e-6, 2e-3)),
    "mounting.ring_expansion": (5e-6, 2e-5, (-1e-6, 2e-3)),
    "mounting.ball_expansion": (2e-6, 2e-5, (-1e-6, 2e-3)),
    "mounting.assembly_temperature": (280.0, 310.0, (100.0, 700.0)),
    "mounting.wear": (0.0, 5e-5, (-1e-6, 6e-3)),
}  # fmt: skip


@pytest.fixture(scope="module", autouse=True)
def _compiled() -> None:
    """Load the compiled kernels first: few cases alone would run as plain Python, slowly."""
    solve(CASES["plain"], fx=np.full(100, 1e4))


def changed(case: Case, field: str, value: float) -> Case:
    """The case with a field of another value, through the records' own checks."""
    part, *path = field.split(".")
    if part == "lubricant":
        assert case.lubricant is not None
        return case.replace(lubricant=case.lubricant.replace(**{path[0]: value}))
    if part == "model":
        return case.replace(model=case.model.replace(**{path[0]: value}))
    if part in ("temperature", "mounting", "life"):
        table = getattr(case, part)
        own = {} if table is None else table.model_dump(exclude_unset=True)
        return case.replace(**{part: {**own, path[0]: value}})
    if part == "duty":
        duty: dict[str, Any] = {
            "inner_speed": case.duty.inner_speed,
            "outer_speed": case.duty.outer_speed,
            "first_ball_azimuth": case.duty.first_ball_azimuth,
            "load": case.duty.load.model_dump(),
            "displacement": case.duty.displacement.model_dump(),
        }
        if len(path) == 1:
            duty[path[0]] = value
        else:
            rival = {"fx": "x", "fy": "y", "fz": "z", "my": "ry", "mz": "rz"}
            rival |= {axis: load for load, axis in rival.items()}
            other = "displacement" if path[0] == "load" else "load"
            duty[path[0]][path[1]] = value
            duty[other][rival[path[1]]] = None
        return case.replace(duty=Duty(**duty))
    bearing = case.bearing
    if path[0] == "roller_material":
        assert isinstance(bearing, RollerBearing)
        material = bearing.roller_material.replace(**{path[1]: value})
        return case.replace(bearing=bearing.replace(roller_material=material))
    if path[0] in ("ring_material", "ball_material"):
        material = getattr(bearing, path[0]).replace(**{path[1]: value})
        changes = {path[0]: material}
        if path[0] == "ring_material" and "ball_material" not in bearing.model_fields_set:
            changes["ball_material"] = material
        return case.replace(bearing=bearing.replace(**changes))
    if path[0] == "preload":
        return case.replace(bearing=bearing.replace(preload={path[1]: value}))
    changes = {path[0]: value}
    rivals = {
        "contact_angle": "diametral_clearance",
        "diametral_clearance": "contact_angle",
    }
    if path[0] in rivals:
        changes[rivals[path[0]]] = None
    return case.replace(bearing=bearing.replace(**changes))


def applies(case: Case, field: str) -> bool:
    of_rollers = [CASES[name] for name in OF_ROLLERS.get(field.split(".")[1], ())]
    if of_rollers or isinstance(case.bearing, RollerBearing):
        return case in of_rollers
    if case is CASES["rolling"]:
        return field in FOR_ROLLING
    if field == "bearing.shim_angle" or case is CASES["arches"]:
        return field == "bearing.shim_angle" and case is CASES["arches"]
    if field.endswith("_spacer") or case is CASES["mounted pair"]:
        return field.endswith("_spacer") and case is CASES["mounted pair"]
    if field in MOUNTED_FIELDS:
        return case is CASES["mounted"]
    if field.startswith("lubricant"):
        return False
    if field.startswith("bearing.preload"):
        return case.bearing.preload is not None
    return field != "bearing.spacing" or case.bearing.spacing is not None


def same(batch: Solved, index: int, alone: Solved) -> None:
    assert batch.status.code[index] == alone.status.code[0]
    found = [(getattr(batch, name).array[index], getattr(alone, name).array[0])
             for name in ("displacement", "load", "stiffness")]  # fmt: skip
    found.append((batch.inner.load[index], alone.inner.load[0]))
    for one, other in found:
        if not alone.converged[0]:
            assert np.isnan(one).all()
            assert np.isnan(other).all()
        else:
            assert np.allclose(one, other, rtol=1e-6, atol=1e-7 * np.abs(other).max())


def values_of(field: str) -> st.SearchStrategy[list[float]]:
    low, high, edges = VALUES[field]
    one = st.floats(low, high) | st.sampled_from(edges) | st.sampled_from([np.nan, np.inf])
    return st.lists(st.floats(low, high) | one, min_size=1, max_size=5)


def test_all_fields_are_tried() -> None:
    assert set(VALUES) == set(batch_fields())


@pytest.mark.parametrize("field", batch_fields())
@settings(max_examples=3)
@given(data=st.data())
@pytest.mark.thirds
def test_one_field_as_an_array_is_the_cases_one_by_one(field: str, data: st.DataObject) -> None:
    names = [name for name, case in CASES.items() if applies(case, field)]
    case = CASES[data.draw(st.sampled_from(names))]
    values = data.draw(values_of(field))
    batch = solve(case, {field: values})
    assert len(batch) == len(values)
    for i, value in enumerate(values):
        try:
            alone = solve(changed(case, field, value))
        except InputError:
            assert batch.status.code[i] == "invalid_input"
            assert np.isnan(batch.displacement.array[i]).all()
            assert np.isnan(batch.stiffness.array[i]).all()
            assert np.isnan(batch.inner.load[i]).all()
        else:
            same(batch, i, alone)


PAIRED = [name for name in batch_fields() if name.split(".")[1] in (*GEOMETRY, "inner_speed")]


@settings(max_examples=12)
@given(
    name=st.sampled_from(["plain", "pair", "rows"]),
    fields=st.lists(st.sampled_from(PAIRED), min_size=2, max_size=4, unique=True),
    data=st.data(),
)
@example(
    name="plain",
    fields=["bearing.ball_diameter", "bearing.pitch_diameter"],
    data=None,
)
@pytest.mark.sweep
def test_several_fields_together(name: str, fields: list[str], data: Any) -> None:
    """Also where each is within its bounds and together they contradict each other."""
    if "bearing.contact_angle" in fields and "bearing.diametral_clearance" in fields:
        fields = [field for field in fields if field != "bearing.diametral_clearance"]
    case = CASES[name]
    if data is None:
        columns = {fields[0]: [0.022, 0.03, 0.03], fields[1]: [0.12, 0.12, 0.2]}
    else:
        columns = {}
        for field in fields:
            low, high, edges = VALUES[field]
            one = st.floats(low, high) | st.sampled_from(edges)
            columns[field] = data.draw(st.lists(one, min_size=3, max_size=3))
    batch = solve(case, columns)
    for i in range(3):
        try:
            # all at once, so that only the values themselves are judged, not the way to them
            bearing: dict[str, Any] = {}
            one_case = case
            for field, column in columns.items():
                part, key = field.split(".")
                if part == "duty":
                    one_case = changed(one_case, field, column[i])
                else:
                    bearing[key] = column[i]
            if "contact_angle" in bearing:
                bearing["diametral_clearance"] = None
            elif "diametral_clearance" in bearing:
                bearing["contact_angle"] = None
            one_case = one_case.replace(bearing=one_case.bearing.replace(**bearing))
        except InputError:
            assert batch.status.code[i] == "invalid_input"
        else:
            same(batch, i, solve(one_case))


def test_coefficient_and_drag_move_friction_controlled_balls() -> None:
    """Each changes the motion; the lubricant's temperature is for the film alone."""
    case = CASES["rolling"]
    torque = {}
    for field in FOR_ROLLING[:3]:
        low, high, _ = VALUES[field]
        rolling = solve(case, {field: [low, high]}).answer.motion
        assert rolling is not None
        torque[field] = rolling.torque("inner")
    assert torque["lubricant.friction_coefficient"][1] > torque["lubricant.friction_coefficient"][0]
    assert torque["model.cage_drag"][1] > torque["model.cage_drag"][0]
    assert torque["temperature.lubricant"][1] == torque["temperature.lubricant"][0]


def test_a_coefficient_belongs_to_a_lubricant() -> None:
    with pytest.raises(InputError, match="is a property of a lubricant, and this case has none"):
        solve(CASES["plain"], {"lubricant.friction_coefficient": [0.1, 0.2]})


def test_what_no_row_takes_from_the_set_has_to_be_sound_all_the_same() -> None:
    """A clearance too great for the set's conformities, though the row that takes it has room."""
    with pytest.raises(InputError, match=r"less than 2\.063 mm"):
        changed(CASES["rows"], "bearing.diametral_clearance", 2.1e-3)
    batch = solve(CASES["rows"], {"bearing.diametral_clearance": [2.1e-3, 2.0e-3]})
    assert (batch.status.code == "invalid_input").tolist() == [True, False]


@pytest.mark.parametrize("kind", PRELOADS)
def test_a_preload_takes_the_place_of_the_cases_own(kind: str) -> None:
    case = CASES["pair"]
    value = 8e-6 if kind == "offset" else 900.0
    batch = solve(case, {f"bearing.preload.{kind}": [value, value]})
    alone = solve(changed(case, f"bearing.preload.{kind}", value))
    same(batch, 1, alone)
    unloaded = case.replace(bearing=case.bearing.replace(preload=None))
    same(solve(unloaded, {f"bearing.preload.{kind}": [value]}), 0, alone)
