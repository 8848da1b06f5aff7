"""One case, one answer: whatever the door, the same case has the same numbers.

The doors: a file; the case written and read again; a designation with all that it fills in written
out; a batch of one over the duty, the geometry, the mounting; a point of a study, here and on a
cluster; the analysis; a report; the app. And what a page names is what the kernel took: the
inertia of the elements is that of the material which the page names.
"""

from __future__ import annotations

import asyncio
import json
import re
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

import httpx
import pytest

import rolamento
from rolamento import studies
from rolamento.case import Case, case_to_json, case_to_toml, parse_case
from rolamento.errors import InputError
from rolamento.kinematics import ball_mass
from rolamento.studies import Axis, Study
from rolamento.tasks.report import calculation_report
from rolamento.web import live
from rolamento.web.server import Settings, create_app

PRECISION = 1e-9
"""Of the greatest number of its name."""
OF_DEPTH = 1e-7
"""Where a maximum lies is known to the root of what its height is known to."""
DUTY = {
    "inner_speed": "3000 rpm",
    "load": {"fx": "400 N", "fz": "800 N", "my": "0 N m", "mz": "0 N m"},
}
AXIAL = {"inner_speed": "300 rpm", "load": {"fx": "2 kN"}}
OIL: dict[str, Any] = {
    "lubricant": "ISO VG 68",
    "temperature": {"lubricant": "70 degC"},
    "surface": {
        "inner_roughness": "0.1 um", "outer_roughness": "0.1 um", "ball_roughness": "0.02 um"
    },
}  # fmt: skip
SEATS: dict[str, Any] = {
    "mounting": {"shaft_tolerance": "k5", "housing_tolerance": "H6"},
    "temperature": {"inner_ring": "48 degC", "outer_ring": "42 degC", "lubricant": "60 degC"},
}
SPINDLE: dict[str, Any] = {
    "mounting": {"shaft_tolerance": "js4", "housing_tolerance": "JS5", "tolerance_class": "P5"},
    "temperature": {"inner_ring": "48 degC", "outer_ring": "42 degC"},
    "duty": {**DUTY, "inner_speed": "15000 rpm"},
}
FILM = {**SEATS, "lubricant": "ISO VG 68", "surface": OIL["surface"]}
FRICTION = {"lubricant": {"base_oil": "ISO VG 68", "friction_coefficient": 0.05}}


def _of(bearing: str | Mapping[str, Any], *tables: Mapping[str, Any]) -> dict[str, Any]:
    """The tables of a case file."""
    own = {"designation": bearing} if isinstance(bearing, str) else bearing
    found: dict[str, Any] = {"bearing": dict(own), "duty": DUTY}
    for table in tables:
        found.update(table)
    return found


def _pair(designation: str, **more: str) -> dict[str, str]:
    return {"designation": designation, "preload": "240 N", **more}


CERAMIC_ROW = {
    "rows": [
        {"designation": "7014 C/HC", "orientation": "-", "position": "-12 mm"},
        {"designation": "7014 C", "orientation": "+", "position": "12 mm"},
    ],
    "preload": "240 N",
}
SIZES = {"bore": "70 mm", "outside_diameter": "110 mm"}
OF_ROWS = {**SPINDLE, "mounting": {**SPINDLE["mounting"], **SIZES}}

DESIGNATIONS: dict[str, dict[str, Any]] = {
    "hybrid": _of("6205/HC5C3"),
    "hybrid in its seats": _of("6205/HC5C3", SEATS),
    "hybrid with oil": _of("6205/HC5C3", OIL),
    "hybrid in its seats with oil": _of("6205/HC5", FILM),
    "hybrid by its prefix": _of("HCB 7014-C-T-P4S", SEATS),
    "rings of nitrogen steel": _of("XC 7014 C", SEATS),
    "angular contact": _of("7014 C", SEATS),
    "hybrid angular contact": _of("7014 C/HCP4A", SEATS),
    "hybrid pair": _of(_pair("7014 C/HCP4A DB")),
    "hybrid pair in its seats": _of(_pair("7014 C/HCP4A DB"), SPINDLE),
    "hybrid pair in its seats, face to face": _of(_pair("7014 C/HCP4A DF"), SPINDLE),
    "hybrid pair by its letters": _of(_pair("7014CDGA/HCP4A", spacing="20 mm", arrangement="DB")),
    "hybrid pair by its material": _of(_pair("7014 C DB", ball_material="Si3N4"), SPINDLE),
    "steel pair in its seats": _of(_pair("7014 C DB"), SPINDLE),
    "rings of 440C": _of(_pair("7014 C DB", ring_material="440C"), SPINDLE),
    "springs": _of({"designation": "7014 C/HCP4A DB", "preload": {"spring": "240 N"}}, SPINDLE),
    "offset": _of({"designation": "7014 C/HCP4A DB", "preload": {"offset": "5 um"}}, SPINDLE),
    "one ceramic row": _of(CERAMIC_ROW),
    "one ceramic row in its seats": _of(CERAMIC_ROW, OF_ROWS),
    "tandem": _of("7014 C/HCP4A DT"),
    "clearance C3": _of("6205/C3", FILM),
    "clearance C4": _of("6305/C4", SEATS, FRICTION),
    "angle of 40 degrees": _of("7210 BEP", SEATS),
    "double row": _of("3206 A", SEATS),
    "four-point": _of("QJ 210"),
    "self-aligning": _of("2208"),
    "thrust": _of("51210", {"duty": AXIAL}),
    "cylindrical": _of("NU 205", FILM, {"duty": {**DUTY, "load": {"fz": "2 kN"}}}),
    "cylindrical, C3": _of("NU 205/C3", SEATS, {"duty": {**DUTY, "load": {"fz": "2 kN"}}}),
    "tapered": _of("30206", OIL),
    "tapered pair": _of(_pair("30206 DB"), OIL),
    "tapered pair in its seats": _of(_pair("30206 DF"), SEATS),
    "tapered in its seats with oil": _of("30206", FILM),
    "tapered pair in its seats with oil": _of(_pair("30210 DB"), FILM),
    "needle": _of("NA 4904", {"duty": {**DUTY, "load": {"fz": "2 kN"}}}),
}
EXAMPLES = {
    path.name: path for path in sorted(Path(str(files("rolamento") / "examples")).glob("*.toml"))
}


@cache
def case_of(name: str) -> Case:
    """The case of a name, as its file has it."""
    if name in EXAMPLES:
        return rolamento.load_case(EXAMPLES[name])
    return Case.from_mapping(DESIGNATIONS[name])


# --- what is compared --------------------------------------------------------------------------


def numbers(state: Mapping[str, Any]) -> dict[str, dict[str, float]]:
    """The numbers of a state's JSON by their name, and each by its place; a null is NaN."""
    found: dict[str, dict[str, float]] = {}
    for path, value in _leaves({name: state[name] for name in state if name not in _BESIDE}):
        if isinstance(value, str) or path.startswith(("status.iterations", "status.residual")):
            continue
        name = re.sub(r"\.\d+", "", path)  # and axes that share a unit
        name = re.sub(r"\.(f|m|r)[xyz]$", r".\1", re.sub(r"\.[xyz]$", ".", name))
        found.setdefault(name, {})[path] = float("nan") if value is None else float(value)
    return found


_BESIDE = {"case", "notes", "title", "schema", "preload"}
"""What a single case has beside its state: of a preload the app leaves out what takes long."""


def scales(found: Mapping[str, Mapping[str, float]], size: float) -> dict[str, float]:
    """The greatest number of each name; a moment or a tilt that symmetry makes zero has a lever."""
    scale = {
        name: max((abs(v) for v in places.values() if v == v), default=0.0)
        for name, places in found.items()
    }
    for name in scale:
        if name.endswith(".m"):
            scale[name] = max(scale[name], scale[f"{name[:-1]}f"] * size)
        elif name.endswith(".r"):
            scale[name] = max(scale[name], scale[name[:-1]] / size)
        elif name.endswith(".tilt"):
            scale[name] = max(scale[name], scale["displacement."] / size)
        elif name.endswith(".spin"):
            scale[name] = max(scale[name], scale.get(name[:-4] + "roll", 0.0))
        elif name.endswith((".spin_to_roll", "angle", ".attitude")):
            scale[name] = max(scale[name], 1.0)
    return scale


def _leaves(value: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    if isinstance(value, Mapping):
        for name, item in value.items():
            yield from _leaves(item, f"{path}.{name}" if path else name)
    elif isinstance(value, list | tuple):
        for index, item in enumerate(value):
            yield from _leaves(item, f"{path}.{index}")
    else:
        yield path, value


def differing(
    one: Mapping[str, Any], other: Mapping[str, Any], size: float
) -> dict[str, tuple[float, float]]:
    """The numbers of two states' JSON that differ by more than the precision."""
    first, second = numbers(one), numbers(other)
    assert first.keys() == second.keys()
    assert one["status"]["code"] == other["status"]["code"]
    found, scale = {}, scales(first, size)
    for name, places in first.items():
        for path, value in places.items():
            own = second[name][path]
            both_missing = value != value and own != own
            precision = OF_DEPTH if name.endswith("max_shear_depth") else PRECISION
            if not both_missing and not abs(value - own) <= precision * scale[name]:
                found[path] = (value, own)
    return found


# --- the doors ---------------------------------------------------------------------------------


def _state(case: Case) -> dict[str, Any]:
    return rolamento.solve(case).to_mapping()


def _batch(case: Case, name: str) -> dict[str, Any] | None:
    """A batch of one over a field, at the value that it has."""
    value: Any = case
    for part in name.split("."):
        value = getattr(value, part, None)
    if value is None:
        return None
    if name.startswith("bearing.") and case.bearing.is_of_rows(name.split(".")[1]):
        return None
    return rolamento.solve(case, {name: [value]}).to_mapping()


def through_toml(case: Case) -> dict[str, Any]:
    return _state(parse_case(case_to_toml(case)))


def through_json(case: Case) -> dict[str, Any]:
    return _state(parse_case(case_to_json(case)))


def written_in_full(case: Case) -> dict[str, Any]:
    """All that a designation fills in as the user's own."""
    bearing = case.bearing
    derived = {"outer_conformity"} if bearing.kind == "self_aligning" else set()
    full = {name: getattr(bearing, name) for name in bearing.FILLED_IN if name not in derived}
    full = {name: value for name, value in full.items() if value is not None}
    return _state(case.replace(bearing=bearing.replace(**full)))


def through_analysis(case: Case) -> dict[str, Any]:
    return rolamento.analyse(case).solved.to_mapping()


def through_a_report(case: Case) -> dict[str, Any]:
    return calculation_report([case]).cases[0].analysis.solved.to_mapping()


def through_the_app(case: Case) -> dict[str, Any]:
    """What the service answers."""

    async def asked() -> httpx.Response:
        transport = httpx.ASGITransport(create_app(Settings(warm=False)))
        async with httpx.AsyncClient(transport=transport, base_url=HERE) as client:
            body = {"case": json.loads(case_to_json(case))}
            return await client.post("/api/v1/solve", json=body)

    response = asyncio.run(asked())
    assert response.status_code == 200, response.text
    return response.json()


def _batched(name: str) -> Callable[[Case], dict[str, Any] | None]:
    return lambda case: _batch(case, name)


DOORS: dict[str, Callable[[Case], dict[str, Any] | None]] = {
    "toml": through_toml,
    "json": through_json,
    "in full": written_in_full,
    "analysis": through_analysis,
    "report": through_a_report,
    "app": through_the_app,
    **{
        f"a batch of one over {name}": _batched(name)
        for name in (
            "duty.inner_speed", "duty.load.fz", "bearing.pitch_diameter", "bearing.ball_diameter",
            "bearing.roller_diameter", "bearing.contact_angle", "bearing.diametral_clearance",
            "bearing.inner_conformity", "bearing.spacing", "bearing.ring_material.youngs_modulus",
            "bearing.ball_material.density", "bearing.roller_material.density",
            "bearing.rib_height", "temperature.inner_ring", "mounting.shaft_bore",
        )
    },
}  # fmt: skip
HERE = "http://127.0.0.1:8000"


@pytest.mark.thirds
@pytest.mark.parametrize("name", [*EXAMPLES, *DESIGNATIONS])
def test_the_state_is_the_same_by_every_door(name: str) -> None:
    case = case_of(name)
    state = rolamento.solve(case).to_mapping()
    assert state["status"]["converged"]
    for door, through in DOORS.items():
        found = through(case)
        if found is not None:
            assert not differing(state, found, case.bearing.pitch_diameter), door


@pytest.mark.thirds
@pytest.mark.parametrize("name", [*EXAMPLES, *DESIGNATIONS])
def test_what_follows_is_the_same_of_a_case_and_of_a_batch(name: str) -> None:
    """Film, friction by one model, life: of a case, and of the same case in a batch."""
    case = case_of(name)
    alone = rolamento.solve(case)
    batch = rolamento.solve(case, inner_speed=[case.duty.inner_speed])
    model = None if any(row.bearing.element != "ball" for row in case.bearing.places) else SIMPLE
    first, second = (
        rolamento.analyse(one, model=model, compare=False).to_mapping() for one in (alone, batch)
    )
    for part in ("film", "friction", "life", "frequencies"):
        assert (first[part] is None) == (second[part] is None), part
        if first[part] is not None:
            both = ({"status": one["status"], part: one[part]} for one in (first, second))
            assert not differing(*both, case.bearing.pitch_diameter)


SIMPLE = "jones_simplified"


@pytest.mark.parametrize("name", ["tapered", "tapered in its seats with oil", "tapered pair"])
@pytest.mark.parametrize("field", ["contact_angle", "pitch_diameter", "roller_diameter"])
def test_what_varies_is_the_case_rebuilt_with_it(name: str, field: str) -> None:
    """The cones and the ends of the rollers follow, whichever door changes their sizes."""
    case, where = case_of(name), f"bearing.{field}"
    value = 1.02 * getattr(case.bearing, field)
    rebuilt = rolamento.solve(case.with_({where: value}))
    varied = rolamento.solve(case, {where: [value]})
    assert rebuilt.converged.all()
    size = case.bearing.pitch_diameter
    assert not differing(rebuilt.to_mapping(), varied.to_mapping(), size)
    both = (rolamento.analyse(one, compare=False) for one in (rebuilt, varied))
    first, second = (
        {"status": a.solved.part("status"), "friction": a.part("friction")} for a in both
    )
    assert not differing(first, second, size)


# --- studies -----------------------------------------------------------------------------------

AXES = ("x", "y", "z", "ry", "rz")
BY_ELEMENT = ("load", "contact_angle", "max_pressure", "deflection")
STUDIED = (*AXES, "fx", "fy", "fz", "my", "mz", "orbital_speed", "centrifugal_force",
           *(f"stiffness_{one}{other}" for one in AXES for other in AXES),
           *(f"{race}_{name}" for race in ("inner", "outer") for name in BY_ELEMENT))  # fmt: skip


def _study(case: Case) -> Study:
    """Two speeds, of which the first is the case's own."""
    speed = case.duty.inner_speed
    return Study(
        case=case,
        outputs=STUDIED,
        axes=[Axis(field="duty.inner_speed", values=[speed, speed - 1.0])],
    )


def _first(result: Any) -> dict[str, Any]:
    """The first case of a study, as its state has it."""
    one = result.isel(inner_speed=0)
    status = dict(zip(one.status.flag_values, one.status.flag_meanings.split(), strict=True))
    races = [
        {name: one[f"{race}_{name}"].values.tolist() for name in BY_ELEMENT}
        for race in ("inner", "outer")
    ]
    return {
        "status": {"code": status[int(one.status)]},
        "displacement": {name: float(one[name]) for name in AXES},
        "load": {name: float(one[name]) for name in ("fx", "fy", "fz", "my", "mz")},
        "stiffness": [[float(one[f"stiffness_{a}{b}"]) for b in AXES] for a in AXES],
        "inner": races[0],
        "outer": races[1],
        "orbital_speed": one.orbital_speed.values.tolist(),
        "centrifugal_force": one.centrifugal_force.values.tolist(),
    }


def _in_columns(state: Mapping[str, Any]) -> dict[str, Any]:
    """The state of a single case as a study writes it."""
    elements = [*state["balls"], *state.get("rollers", ())]
    races = {
        race: {name: [element[race][name] for element in elements] for name in BY_ELEMENT}
        for race in ("inner", "outer")
    }
    own = {name: [e[name] for e in elements] for name in ("orbital_speed", "centrifugal_force")}
    shared = {name: state[name] for name in ("displacement", "load", "stiffness")}
    return {"status": {"code": state["status"]["code"]}, **shared, **races, **own}


@pytest.mark.thirds
@pytest.mark.parametrize("name", [*EXAMPLES, *DESIGNATIONS])
def test_a_point_of_a_study_is_the_case(name: str) -> None:
    case = case_of(name)
    study = _study(case)
    state = _in_columns(rolamento.solve(case).to_mapping())
    for one in (study, studies.parse_study(studies.study_to_toml(study))):
        found = _first(studies.run(one))
        assert not differing(state, found, case.bearing.pitch_diameter)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::ResourceWarning")
def test_a_point_of_a_study_on_a_cluster_is_the_case() -> None:
    distributed = pytest.importorskip("distributed")
    from rolamento.studies.cluster import dask_cluster

    quiet = {"dashboard_address": None, "silence_logs": 50}
    with distributed.LocalCluster(n_workers=1, threads_per_worker=1, **quiet) as cluster:
        executor = dask_cluster(cluster.scheduler_address)
        for name in ("hybrid pair in its seats", "one ceramic row in its seats", "tapered"):
            case = case_of(name)
            state = _in_columns(rolamento.solve(case).to_mapping())
            found = _first(studies.run(_study(case), executor=executor))
            assert not differing(state, found, case.bearing.pitch_diameter), name


# --- what a page names is what the kernel took ---------------------------------------------------


@pytest.mark.thirds
@pytest.mark.parametrize("name", [*EXAMPLES, *DESIGNATIONS])
def test_the_material_that_a_page_names_is_the_one_that_was_solved(name: str) -> None:
    """F_c = ½ m d_m ω_m² of every element, m from the density of the row's material."""
    case = case_of(name)
    batch = rolamento.solve(case, inner_speed=[case.duty.inner_speed])
    for solved in (rolamento.solve(case), batch):
        elements = solved.elements
        for row, place in enumerate(solved.case.bearing.element_rows):
            named = place.bearing
            if named.element != "ball":
                continue
            own = elements.row == row
            diameter, pitch = solved.rows.ball_diameter[0, row], solved.rows.pitch_diameter[0, row]
            mass = ball_mass(diameter, named.element_material.density)
            force = 0.5 * mass * pitch * elements.orbital_speed[0, own] ** 2
            assert elements.centrifugal_force[0, own] == pytest.approx(force, rel=1e-9)


def test_the_app_shows_what_the_engine_answers() -> None:
    """The page's own answer: what stands in the state that its pictures are drawn from."""
    case = case_of("hybrid pair in its seats")
    asked = {"case": json.loads(case_to_json(case)), "changes": {}}
    (one,) = live.live({"cases": [asked]})["cases"]
    named = Case.from_mapping(one["case"])
    assert named == case
    assert not differing(_state(case), _state(named), case.bearing.pitch_diameter)


# --- what follows what ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("bearing", "field"),
    [
        ({"designation": "6205"}, "ball_material"),
        ({"designation": "NU 205"}, "roller_material"),
        ({"rows": [{"designation": "7014 C", "position": "0 mm"}]}, "ball_material"),
    ],
)
def test_elements_follow_the_material_of_the_rings_until_they_have_their_own(
    bearing: dict[str, Any], field: str
) -> None:
    case = Case.from_mapping(_of(bearing))
    assert case.bearing.elements_follow_rings
    assert field not in case.to_mapping()["bearing"]
    stiffer = case.with_({"bearing.ring_material": "M50"})
    assert stiffer.bearing.element_material.name == "M50"
    part = case.with_({f"bearing.{field}.density": 5000.0})
    assert part.bearing.element_material.density == 5000.0
    assert part.bearing.ring_material == case.bearing.ring_material
    assert not part.bearing.elements_follow_rings


def test_balls_that_a_designation_names_do_not_follow_the_rings() -> None:
    case = case_of("hybrid")
    assert not case.bearing.elements_follow_rings
    other = case.with_({"bearing.ring_material": "M50"})
    assert other.bearing.ball_material == case.bearing.ball_material
    lighter = case.with_({"bearing.ball_material.density": 3000.0})
    assert lighter.bearing.ball_material.youngs_modulus == case.bearing.ball_material.youngs_modulus
    assert lighter.bearing.ball_material.density == 3000.0


@pytest.mark.parametrize("field", ["bearing.ball_diameter", "bearing.ball_material.density"])
def test_what_no_row_takes_of_the_set_is_refused(field: str) -> None:
    """Rows with designations have all their geometry of their own."""
    case = case_of("one ceramic row in its seats")
    with pytest.raises(InputError, match="every row has its own"):
        rolamento.solve(case, {field: [0.012]})


@pytest.mark.parametrize("designation", ["7014 C DB", "QJ 210", "2208"])
def test_equal_bearings_differ_in_what_follows(designation: str) -> None:
    """Balls given in the rings' material do not follow it, whichever bearing was asked first."""
    follows = Case.from_mapping(_of(designation))
    own = follows.replace(bearing=follows.bearing.replace(ball_material="100Cr6"))
    assert follows == own
    for case in (follows, own):
        places = case.bearing.places
        assert {place.bearing.elements_follow_rings for place in places} == {case is follows}
