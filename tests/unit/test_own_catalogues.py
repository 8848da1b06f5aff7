"""A user's catalogue beside the built-in one: in force within a block, kept by what it found."""

from __future__ import annotations

import pickle
from importlib import resources
from pathlib import Path

import numpy as np
import pytest

from rolamento import Bearing, Case, Duty, InputError, Load, studies
from rolamento.case import case_to_toml, override, parse_case
from rolamento.catalogue import catalogue, catalogues, geometry_of
from rolamento.catalogue.designation import each_folded, folded
from rolamento.catalogue.records import OwnRecords, records_of_csv
from rolamento.studies.plan import Plan, solve_task

OWN = """\
# maker: ACME
# source: drawing 7
designation,bore_mm,outside_diameter_mm,width_mm,dynamic_rating_kN,static_rating_kN
Q-17,25,52,15,14,7.85
MY 1,25,62,17,20.6,11.2
6205,25,52,15,15.9,8.3
"""


@pytest.fixture
def own(tmp_path: Path) -> str:
    path = tmp_path / "own.csv"
    path.write_text(OWN, encoding="utf-8")
    return str(path)


def _case(designation: str) -> Case:
    return Case(bearing=Bearing.named(designation), duty=Duty(load=Load(fz=3000.0)))


def test_the_block_ends(own: str) -> None:
    with catalogues([own]):
        assert geometry_of("6205").bearing.maker == "ACME"
        assert catalogue().search("Q-17")
    assert geometry_of("6205").bearing.maker == "NSK"
    with pytest.raises(InputError, match="in no catalogue"):
        Bearing.named("Q-17")
    with catalogues(), pytest.raises(InputError, match="in no catalogue"):
        Bearing.named("Q-17")


@pytest.mark.parametrize("designation", ["Q-17", "Q-17/C3", "my1 C4", "MY 1/C3", "Q-17-2RS/C3"])
def test_what_was_found_stays_with_the_bearing(own: str, designation: str) -> None:
    with catalogues([own]):
        case = parse_case(f'[bearing]\ndesignation = "{designation}"\n[duty.load]\nfz = "3 kN"')
        bearing = case.bearing
    assert bearing.published is not None
    assert bearing.published.maker == "ACME"
    assert bearing.origins["ball_count"] == "inferred"
    assert bearing.replace(inner_conformity=0.515).published == bearing.published
    assert case.with_({"duty.load.fz": "1 kN"}).bearing == bearing
    assert override(case, ["duty.load.fz=1 kN"]).bearing == bearing
    again = pickle.loads(pickle.dumps(case))
    assert again == case
    assert again.bearing.resolved == bearing.resolved
    with pytest.raises(InputError, match="in no catalogue"):
        parse_case(case_to_toml(case), format="toml")


def test_the_same_name_in_two_catalogues_is_two_bearings(own: str) -> None:
    built_in = Bearing.named("6205")
    with catalogues([own]):
        users = Bearing.named("6205")
    assert users != built_in
    assert built_in.published is not None
    assert built_in.published.maker == "NSK"


def test_a_study_over_designations_of_both(own: str) -> None:
    with catalogues([own]):
        case = _case("Q-17")
        axis = studies.Axis(field="bearing.designation", values=["Q-17/C3", "MY 1", "6305"])
        study = studies.Study(case=case, axes=[axis], outputs=("max_inner_load",))
        plan = Plan(study)
        loads = studies.run(study, threads=2).max_inner_load.to_numpy()
    assert np.isfinite(loads).all()
    task = pickle.loads(pickle.dumps(plan.task(0)))  # as it travels to another process
    assert solve_task(task).arrays["max_inner_load"] == pytest.approx(loads, rel=1e-12)


def test_the_files_of_the_package_are_read_alike_by_both_readers() -> None:
    folder = resources.files("rolamento") / "data" / "catalogue"
    files = [file for file in folder.iterdir() if file.name.endswith(".csv")]
    assert len(files) > 10
    for file in files:
        text = file.read_text(encoding="utf-8")
        own = OwnRecords({file.name: text})
        assert tuple(own) == records_of_csv(text, file.name)
        assert own[-1] is own[len(own) - 1]
        assert each_folded(own.designations) == [folded(name) for name in own.designations]
