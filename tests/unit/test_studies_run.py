"""Running a study: the right numbers, whatever the chunks and threads, and nothing lost."""

from __future__ import annotations

import json
import os
import pickle
import threading
import tracemalloc
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import numpy as np
import pytest
from tests.one_case import solve_one

from rolamento import Bearing, Case, Duty, Load, override
from rolamento.errors import FileError, InputError
from rolamento.solution import solve
from rolamento.studies import (
    Axis,
    Distribution,
    Interrupted,
    Scatter,
    Study,
    load_result,
    run,
    run_to_file,
    runner,
)
from rolamento.studies.plan import Part, Plan, solve_task
from rolamento.studies.runner import local_threads
from rolamento.studies.store import Store

SPEEDS = ("0 rpm", "5000 rpm", "10000 rpm")


@pytest.fixture(scope="module")
def study(case_218: Case) -> Study:
    """60 cases; those with an axial load of -20 kN have no equilibrium."""
    angle = Distribution(distribution="normal", mean="40 deg", standard_deviation="0.5 deg")
    return Study(
        title="Small",
        case=case_218,
        seed=3,
        outputs=("x", "stiffness_zz", "max_inner_max_pressure", "inner_load", "iterations"),
        axes=[
            Axis(field="duty.load.fx", values=["20 kN", "30 kN", "-20 kN", "40 kN"]),
            Axis(field="duty.inner_speed", values=SPEEDS),
        ],
        scatter=Scatter(count=5, fields={"bearing.contact_angle": angle}),
    )


def same(one: Plan, parts: Sequence[Part], other: Sequence[Part]) -> bool:
    return all(
        np.array_equal(a.arrays[name], b.arrays[name], equal_nan=True)
        for a, b in zip(parts, other, strict=True)
        for name in a.arrays
    )


class TestInMemory:
    def test_each_case_is_that_of_solve(self, study: Study, case_218: Case) -> None:
        result = run(study)
        sizes = {"fx": 4, "inner_speed": 3, "sample": 5, "ball": 16}
        assert dict(result.sizes) == {**sizes, "reason_text": 1}
        for k in range(2):
            angle = float(result.contact_angle[k])
            bearing = case_218.bearing.replace(contact_angle=angle)
            duty = Duty(inner_speed="5000 rpm", load=Load(fx="30 kN", fz="15 kN"))
            state = solve_one(Case(bearing=bearing, duty=duty))
            cell = result.isel(fx=1, inner_speed=1, sample=k)
            assert float(cell.x) == pytest.approx(state.displacement.x, abs=1e-12)
            loads = [ball.inner.load for ball in state.balls]
            assert np.allclose(cell.inner_load, loads, rtol=1e-7)
            assert float(cell.max_inner_max_pressure) == pytest.approx(
                max(ball.inner.max_pressure for ball in state.balls), rel=1e-8
            )

    def test_status_and_absent_numbers(self, study: Study) -> None:
        result = run(study)
        failed = result.status.isel(fx=2)
        assert (failed == 1).all()
        assert result.status.attrs["flag_meanings"].split()[1] == "no_equilibrium"
        assert list(result.status.attrs["flag_values"]) == sorted(
            result.status.attrs["flag_values"]
        )
        for name in ("x", "stiffness_zz", "max_inner_max_pressure", "inner_load"):
            assert np.isnan(result[name].isel(fx=2)).all()
            assert np.isfinite(result[name].isel(fx=[0, 1, 3])).all()
        assert (result.attrs["cases_converged"], result.attrs["cases_no_equilibrium"]) == (45, 15)

    def test_units_and_coordinates(self, study: Study) -> None:
        result = run(study)
        assert result.x.attrs["units"] == "m"
        assert result.inner_load.attrs["units"] == "N"
        assert result.inner_speed.attrs["units"] == "rad/s"
        assert result.inner_speed.attrs["given_in"] == "rpm"
        assert result.contact_angle.dims == ("sample",)
        assert result.contact_angle.attrs["field"] == "bearing.contact_angle"
        assert result.attrs["title"] == "Small"
        assert result.attrs["seed"] == 3
        assert "ball_count = 16" in result.attrs["case"]

    def test_fields_of_every_kind(self, case_218: Case) -> None:
        """Whole numbers, names, switches, and quantities that a batch does not vary."""
        study = Study(
            case=case_218,
            outputs=("x", "inner_load"),
            axes=[
                Axis(field="bearing.ball_count", first=10, last=16, count=3),
                Axis(field="bearing.ring_material", values=["100Cr6", "M50"]),
                Axis(field="model.gyroscopic_moment", values=[True, False]),
                Axis(field="bearing.inner_shoulder_height", values=["9 mm", "9.5 mm"]),
                Axis(name="pair", zipped={
                    "model.raceway_control": ["outer", "inner"],
                    "duty.load.fx": ["20 kN", "30 kN"],
                }),
            ],
        )  # fmt: skip
        result = run(study)
        assert result.attrs["cases_converged"] == 48
        cell = result.isel(ball_count=1, ring_material=1, gyroscopic_moment=1, pair=1)
        settings = [
            "bearing.ball_count=13",
            "bearing.ring_material=M50",
            "model.gyroscopic_moment=false",
            "model.raceway_control=inner",
            "duty.load.fx=30 kN",
        ]
        bearing = {name: getattr(case_218.bearing, name) for name in (
            "ball_diameter", "pitch_diameter", "contact_angle", "inner_conformity",
            "outer_conformity",
        )}  # fmt: skip
        alone = Case(bearing=Bearing(ball_count=13, ring_material="M50", **bearing),
                     duty=case_218.duty)  # fmt: skip
        state = solve_one(override(alone, settings[2:]))
        assert np.allclose(cell.x, state.displacement.x, rtol=0.0, atol=1e-11)
        assert np.isnan(cell.inner_load[:, 13:]).all()
        assert np.allclose(cell.inner_load[0, :13], [b.inner.load for b in state.balls], rtol=1e-7)

    def test_a_base_case_that_does_not_exist(self, case_218: Case) -> None:
        axis = Axis(field="bearing.ball_count", values=[16, 17, 18, 19])
        result = run(Study(case=case_218, outputs=("x", "iterations"), axes=[axis]))
        assert result.status.values.tolist() == [0, 0, 4, 4]
        assert np.isnan(result.x[2:]).all()
        assert result.reason.values.tolist()[:2] == [-1, -1]
        assert all("do not fit" in text for text in result.reason_text.values[result.reason[2:]])

    def test_values_out_of_range_of_a_scattered_field(self, case_218: Case) -> None:
        wide = Distribution(distribution="normal", mean=0.5232, standard_deviation=0.05)
        scatter = Scatter(count=200, fields={"bearing.inner_conformity": wide})
        result = run(Study(case=case_218, outputs=("x",), scatter=scatter))
        out = (result.inner_conformity < 0.501) | (result.inner_conformity > 1.0)
        assert out.any()
        assert ((result.status == 4) == out).all()
        assert (np.isnan(result.x) == (result.status != 0)).all()

    def test_fields_that_do_not_go_with_the_case(self, case_218: Case) -> None:
        axis = Axis(field="bearing.spacing", values=["20 mm", "30 mm"])
        result = run(Study(case=case_218, outputs=("x",), axes=[axis]))
        assert (result.status == 4).all()
        assert "spacing" in result.reason_text.values[result.reason.values[0]]

    def test_a_rival_takes_the_place_of_the_case_s(self, case_218: Case) -> None:
        axis = Axis(field="duty.displacement.x", values=["0.01 mm", "0.02 mm"])
        result = run(Study(case=case_218, outputs=("x", "fx"), axes=[axis]))
        assert np.allclose(result.x, [1e-5, 2e-5])
        assert (result.fx > 0.0).all()

    def test_nothing_but_cases_of_their_own(self, case_218: Case) -> None:
        axis = Axis(field="model.raceway_control", values=["outer", "inner", "jones", "none"])
        result = run(Study(case=case_218, outputs=("x",), axes=[axis]))
        assert len(set(result.x.values.tolist())) >= 3

    def test_cases_of_their_own_come_in_runs(self, case_218: Case) -> None:
        """Whatever the order in the study, cases that share a bearing are neighbours."""
        axes = [
            Axis(field="duty.load.fx", first="20 kN", last="40 kN", count=3),
            Axis(field="bearing.ball_count", values=[16, 14]),
        ]
        study = Study(case=case_218, outputs=("x", "inner_load"), axes=axes)
        result = run(study)
        assert result.x.dims == ("ball_count", "fx")
        alone = Study(case=override(case_218, ["bearing.ball_count=14"]), axes=axes[:1])
        assert np.allclose(result.x.sel(ball_count=14), run(alone).x, rtol=0.0, atol=1e-12)
        turned = study.replace(axes=axes[::-1])
        assert run(turned).equals(result)

    def test_sets_of_rows(self, case_218: Case) -> None:
        bearing = case_218.bearing.replace(arrangement="DT", spacing="24 mm")
        study = Study(
            case=case_218.replace(bearing=bearing),
            outputs=("x", "inner_load"),
            axes=[
                Axis(field="bearing.arrangement", values=["DT", "TT"]),
                Axis(field="duty.load.fx", values=["20 kN", "40 kN"]),
            ],
        )
        result = run(study)
        assert result.sizes["ball"] == 48
        assert (result.status == 0).all()
        assert np.isnan(result.inner_load.sel(arrangement="DT")[:, 32:]).all()
        assert np.isfinite(result.inner_load.sel(arrangement="TT")).all()

    def test_too_much_for_memory(self, case_218: Case) -> None:
        axes = [Axis(field=f"duty.load.{load}", first=1.0, last=2.0, count=20_000)
                for load in ("fx", "fz")]  # fmt: skip
        with pytest.raises(InputError, match="run_to_file"):
            run(Study(case=case_218, axes=axes))


class TestChunks:
    def test_threads_and_processes_change_nothing(self, study: Study) -> None:
        plan = Plan(study, 7)
        parts = [plan.solve(index) for index in range(plan.chunks)]
        indices = range(plan.chunks)
        for threads in (1, 2, 3):
            assert same(plan, parts, list(local_threads(threads)(plan, indices)))
        tasks = [pickle.loads(pickle.dumps(plan.task(index))) for index in indices]
        assert same(plan, parts, [pickle.loads(pickle.dumps(solve_task(task))) for task in tasks])

    @pytest.mark.parametrize("chunk", [1, 7, 60])
    def test_chunks_change_no_more_than_rounding(self, study: Study, chunk: int) -> None:
        whole, plan = Plan(study, 60).solve(0), Plan(study, chunk)
        parts = [plan.solve(index) for index in range(plan.chunks)]
        for name, array in whole.arrays.items():
            cut = np.concatenate([part.arrays[name] for part in parts])
            assert np.allclose(cut, array, rtol=1e-9, atol=1e-14, equal_nan=True), name

    def test_a_chunk_is_smaller_with_many_balls(self, study: Study, case_218: Case) -> None:
        bearing = case_218.bearing.replace(ball_count=400, pitch_diameter="5 m")
        many = Plan(study.replace(case=case_218.replace(bearing=bearing)))
        assert many.chunk < Plan(study).chunk == 512

    def test_a_chunk_is_small_where_cases_are_slow(self, study: Study) -> None:
        control = Axis(field="model.raceway_control", values=["outer", "friction"])
        assert Plan(study.replace(axes=[control], scatter=None)).chunk == 32
        case = override(study.case, ["lubricant=ISO VG 68", "lubricant.friction_coefficient=0.1"])
        for output, chunk in (("friction_torque_jones_full", 32), ("friction_torque_todd", 512)):
            assert Plan(study.replace(case=case, outputs=("x", output))).chunk == chunk

    def test_the_executor_may_answer_in_any_order(self, study: Study) -> None:
        def backwards(plan: Plan, indices: Sequence[int]) -> Iterator[Part]:
            return (plan.solve(index) for index in reversed(indices))

        assert run(study, executor=backwards).equals(run(study))


class TestToFile:
    def file(self, folder: Path) -> Path:
        return folder / "result.nc"

    def stop_after(self, parts: int) -> Callable[[int, int, int], None]:
        calls = iter(range(10_000))

        def progress(done: int, total: int, failed: int) -> None:
            if next(calls) == parts:
                raise KeyboardInterrupt

        return progress

    def test_the_file_is_the_result(self, study: Study, tmp_path: Path) -> None:
        told: list[tuple[int, int, int]] = []
        summary = run_to_file(
            study, self.file(tmp_path), chunk=60, progress=lambda *n: told.append(n)
        )
        assert load_result(self.file(tmp_path)).equals(run(study))
        assert told == [(0, 60, 0), (60, 60, 15)]
        assert (summary.cases, summary.solved, summary.converged) == (60, 60, 45)
        assert [p.name for p in tmp_path.iterdir()] == ["result.nc"]

    def test_ranges(self, study: Study, tmp_path: Path) -> None:
        summary = run_to_file(study, self.file(tmp_path), chunk=7)
        result = load_result(self.file(tmp_path))
        for found in summary.ranges:
            values = result[found.output.name].where(result.status == 0).values
            assert found.minimum == np.nanmin(values)
            assert found.maximum == np.nanmax(values)
            if not found.output.along:
                assert found.median == pytest.approx(np.nanmedian(values), rel=1e-6)

    def test_a_stopped_run_goes_on(self, study: Study, tmp_path: Path) -> None:
        path = self.file(tmp_path)
        run_to_file(study, path, chunk=7)
        straight = path.read_bytes()
        path.unlink()
        with pytest.raises(Interrupted) as stop:
            run_to_file(study, path, chunk=7, progress=self.stop_after(3))
        assert (stop.value.done, stop.value.total) == (21, 60)
        assert not path.exists()
        solved: list[int] = []

        def watched(plan: Plan, indices: Sequence[int]) -> Iterator[Part]:
            solved.extend(indices)
            return (plan.solve(index) for index in indices)

        summary = run_to_file(study, path, chunk=7, executor=watched)
        assert len(solved) == 6
        assert summary.solved == 60 - 21
        assert path.read_bytes() == straight
        assert not stop.value.folder.exists()

    def test_interrupted_threads_end(self, study: Study, tmp_path: Path) -> None:
        with pytest.raises(Interrupted):
            run_to_file(study, self.file(tmp_path), chunk=2, threads=2, progress=self.stop_after(4))
        summary = run_to_file(study, self.file(tmp_path), chunk=2, threads=2)
        assert summary.solved == 60 - 4 * 2

    def test_another_study_does_not_mix(self, study: Study, tmp_path: Path) -> None:
        path = self.file(tmp_path)
        with pytest.raises(Interrupted):
            run_to_file(study, path, chunk=7, progress=self.stop_after(2))
        other = study.replace(seed=4)
        with pytest.raises(FileError, match="restart"):
            run_to_file(other, path, chunk=7)
        with pytest.raises(FileError, match="restart"):
            run_to_file(study, path, chunk=8)
        run_to_file(other, path, chunk=7, restart=True)
        assert load_result(path).attrs["seed"] == 4

    def test_a_damaged_part_is_solved_again(
        self, study: Study, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(runner, "_LONGEST_UNWRITTEN", -1.0)  # each chunk in a file of its own
        path = self.file(tmp_path)
        with pytest.raises(Interrupted):
            run_to_file(study, path, chunk=7, progress=self.stop_after(3))
        parts = sorted(Path(f"{path}.parts").glob("*.npz"))
        parts[0].write_bytes(b"")
        parts[1].write_bytes(parts[1].read_bytes()[:200])
        assert run_to_file(study, path, chunk=7).solved == 60 - 7

    def test_a_part_damaged_within_is_named(self, study: Study, tmp_path: Path) -> None:
        plan = Plan(study, 60)
        store = Store(self.file(tmp_path), plan)
        store.folder.mkdir()
        store.open()
        store.put(plan.solve(0))
        part = next(store.folder.glob("*.npz"))
        content = bytearray(part.read_bytes())
        content[len(content) // 2] ^= 0xFF
        part.write_bytes(bytes(content))
        with pytest.raises(FileError, match="is damaged"):
            run_to_file(study, self.file(tmp_path), chunk=60)

    def test_a_part_never_runs_code(self, study: Study, tmp_path: Path) -> None:
        plan = Plan(study, 60)
        store = Store(self.file(tmp_path), plan)
        store.folder.mkdir()
        store.open()
        hostile = np.array([print], dtype=object)
        with (store.folder / "part-0000000.npz").open("wb") as file:
            np.savez(file, status=hostile, _reasons=np.array([], dtype=np.str_))
        assert store.open() == {}

    @pytest.mark.skipif(os.name != "posix", reason="locks are POSIX ones")
    def test_two_runs_do_not_mix(self, study: Study, tmp_path: Path) -> None:
        other = Store(self.file(tmp_path), Plan(study))
        with other.held(), pytest.raises(FileError, match="in use"):
            run_to_file(study, self.file(tmp_path))
        assert run_to_file(study, self.file(tmp_path)).cases == 60

    def test_foreign_files_stay(self, study: Study, tmp_path: Path) -> None:
        store = Store(self.file(tmp_path), Plan(study))
        store.folder.mkdir()
        store.open()
        (store.folder / "diary.txt").write_text("dear diary")
        with pytest.raises(FileError):
            store.remove()
        assert (store.folder / "diary.txt").exists()

    @pytest.mark.parametrize("restart", [False, True])
    def test_a_foreign_file_is_named_with_what_to_do(
        self, study: Study, tmp_path: Path, restart: bool
    ) -> None:
        folder = tmp_path / "result.nc.parts"
        folder.mkdir()
        (folder / "diary.txt").write_text("dear diary")
        said = (
            'contains "diary.txt", which Rolamento did not write and does not remove; move it away'
        )
        with pytest.raises(FileError, match=said):
            run_to_file(study, self.file(tmp_path), restart=restart)
        assert (folder / "diary.txt").read_text() == "dear diary"
        (folder / "diary.txt").unlink()
        assert run_to_file(study, self.file(tmp_path), restart=restart).cases == 60

    def test_a_file_in_the_place_of_the_folder(self, study: Study, tmp_path: Path) -> None:
        (tmp_path / "result.nc.parts").write_text("mine")
        with pytest.raises(
            FileError, match="is where parts of the result are kept, and is not a folder;"
        ):
            run_to_file(study, self.file(tmp_path), restart=True)
        assert (tmp_path / "result.nc.parts").read_text() == "mine"

    def test_a_manifest_that_is_nonsense(self, study: Study, tmp_path: Path) -> None:
        folder = tmp_path / "result.nc.parts"
        folder.mkdir()
        for text in ("", "[" * 5000, json.dumps({"format": 9})):
            (folder / "manifest.json").write_text(text)
            with pytest.raises(FileError, match="restart"):
                run_to_file(study, self.file(tmp_path))

    @pytest.mark.parametrize("name", ["result", "result.txt", "no/result.nc"])
    def test_places_that_cannot_be(self, study: Study, tmp_path: Path, name: str) -> None:
        with pytest.raises(FileError):
            run_to_file(study, tmp_path / name)
        assert list(tmp_path.iterdir()) == []

    def test_a_directory_in_the_way(self, study: Study, tmp_path: Path) -> None:
        self.file(tmp_path).mkdir()
        with pytest.raises(FileError, match="is a directory"):
            run_to_file(study, self.file(tmp_path))


def test_memory_does_not_grow_with_the_number_of_cases(
    case_218: Case, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The solver stands aside: parts of 1000 cases come, are kept, assembled, summarised."""

    def peak(cases: int) -> int:
        law = Distribution(distribution="uniform", minimum="20 kN", maximum="40 kN")
        scatter = Scatter(count=cases, fields={"duty.load.fx": law})
        study = Study(case=case_218, outputs=("x", "inner_load"), scatter=scatter)

        def invented(plan: Plan, indices: Sequence[int]) -> Iterator[Part]:
            for index in indices:
                arrays = plan.empty(plan.size(index))
                arrays["status"][:] = 0
                arrays["x"][:] = 1.0
                yield Part(index, arrays)

        tracemalloc.start()
        run_to_file(study, tmp_path / f"{cases}.nc", chunk=1000, executor=invented)
        _, most = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        return most

    monkeypatch.setattr("rolamento.studies.runner._MOST_KEPT", 1000)
    peak(2000)  # what is imported and made once
    # 16 parts are written together; all of them: 160 000 × 18 × 8 B = 23 MB
    assert peak(160_000) < peak(48_000) + 600_000


def test_a_stop_waits_for_no_chunk(
    study: Study, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One thread is in a chunk that never ends; what was solved before is kept all the same."""
    monkeypatch.setattr(runner, "_PATIENCE", 0.1)
    held, original = threading.Event(), Plan.solve

    def solved(plan: Plan, index: int, threads: int | None = 1) -> Part:
        if index == 3:
            held.wait()
        return original(plan, index, threads)

    def stop(done: int, total: int, failed: int) -> None:
        if done == 21:
            raise KeyboardInterrupt

    monkeypatch.setattr(Plan, "solve", solved)
    try:
        with pytest.raises(Interrupted) as stopped:
            run_to_file(study, tmp_path / "r.nc", chunk=7, threads=1, progress=stop)
    finally:
        held.set()
    assert stopped.value.done == 21
    assert len(Store(tmp_path / "r.nc", Plan(study, 7)).open()) == 3


@pytest.mark.parametrize("threads", [0, -1, 1.5, True])
def test_threads_that_are_none(study: Study, threads: int) -> None:
    with pytest.raises(InputError, match="threads"):
        run(study, threads=threads)
    with pytest.raises(InputError, match="threads"):
        solve(study.case, fx=[1e4, 2e4], threads=threads)


def test_few_parts_are_solved_ahead(study: Study) -> None:
    plan = Plan(study, 1)
    begun: list[int] = []
    original = plan.solve

    def counted(index: int, threads: int | None = 1) -> Part:
        begun.append(index)
        return original(index, threads)

    plan.solve = counted  # type: ignore[method-assign]
    parts = runner.local_threads(2)(plan, range(plan.chunks))
    for number in range(1, 6):
        next(parts)
        assert len(begun) <= number + 4
    parts.close()  # type: ignore[attr-defined]
    assert len(begun) < plan.chunks
