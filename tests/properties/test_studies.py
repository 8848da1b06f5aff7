"""Laws of studies: every case once, and the same whatever the division into chunks."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rolamento import Bearing, Case, Duty
from rolamento.errors import InputError
from rolamento.studies import (
    Axis,
    Distribution,
    Scatter,
    Study,
    parse_study,
    study_to_json,
    study_to_toml,
)
from rolamento.studies.plan import Plan, slabs
from rolamento.studies.scatter import factor_of

BEARING = Bearing(
    ball_count=16,
    ball_diameter="22.23 mm",
    pitch_diameter="125.26 mm",
    contact_angle="40 deg",
    inner_conformity=0.5232,
    outer_conformity=0.5232,
)
CASE = Case(bearing=BEARING, duty=Duty())

shapes = st.lists(st.integers(1, 5), min_size=1, max_size=4).map(tuple)
speeds = st.lists(st.floats(-1e4, 1e4), min_size=1, max_size=5)
counts = st.lists(st.integers(3, 16), min_size=1, max_size=3)


@given(shapes, st.data())
def test_slabs_cover_a_run_of_cases_once_and_in_order(
    shape: tuple[int, ...], data: st.DataObject
) -> None:
    size = math.prod(shape)
    first = data.draw(st.integers(0, size))
    last = data.draw(st.integers(first, size))
    grid = np.full(shape, -1)
    run = np.arange(last - first)
    pieces = list(slabs(first, last, shape))
    for place, part in pieces:
        box = tuple(s.stop - s.start for s in place)
        assert (grid[place] == -1).all()
        grid[place] = run[part].reshape(box)
    assert len(pieces) <= 2 * len(shape) - 1
    flat = grid.ravel()
    assert (flat[first:last] == run).all()
    assert (flat[:first] == -1).all()
    assert (flat[last:] == -1).all()


@st.composite
def studies(draw: st.DrawFn) -> Study:
    """Axes of several kinds, with scatter or without."""
    axes = [Axis(field="duty.inner_speed", values=draw(speeds))]
    if draw(st.booleans()):
        axes.append(Axis(field="bearing.ball_count", values=draw(counts)))
    if draw(st.booleans()):
        first, last = (draw(st.floats(1.0, 1e5)) for _ in range(2))
        spacing = draw(st.sampled_from(["linear", "log"]))
        size = draw(st.integers(2, 6))
        axes.append(Axis(field="duty.load.fx", first=first, last=last, count=size, spacing=spacing))
    scatter = None
    if draw(st.booleans()):
        mean, deviation = draw(st.floats(0.1, 1.0)), draw(st.floats(1e-6, 0.1))
        minimum = draw(st.none() | st.just(max(mean - deviation, 0.0)))
        law = Distribution(
            distribution="normal", mean=mean, standard_deviation=deviation, minimum=minimum
        )
        scatter = Scatter(count=draw(st.integers(1, 20)), fields={"bearing.contact_angle": law})
    return Study(case=CASE, axes=axes, scatter=scatter, seed=draw(st.integers(0, 2**63 - 1)))


@given(studies(), st.integers(1, 50))
def test_inputs_do_not_depend_on_the_chunks(study: Study, chunk: int) -> None:
    whole, plan = Plan(study).inputs(0, study.cases), Plan(study, chunk)
    parts = [plan.inputs(*plan.bounds(index)) for index in range(plan.chunks)]
    assert sum(plan.size(index) for index in range(plan.chunks)) == study.cases
    for name, values in whole.items():
        assert np.array_equal(np.concatenate([part[name] for part in parts]), values)


@given(studies())
def test_a_study_survives_its_file(study: Study) -> None:
    for write in (study_to_toml, study_to_json):
        again = parse_study(write(study))
        assert write(again) == write(study)
        one, other = (Plan(s).inputs(0, s.cases) for s in (study, again))
        assert all(np.array_equal(one[name], other[name]) for name in one)


@given(st.lists(st.floats(-1.0, 1.0), min_size=3, max_size=3))
def test_a_factor_gives_its_matrix_back_or_there_is_none(coefficients: list[float]) -> None:
    a, b, c = coefficients
    matrix = np.array([[1.0, a, b], [a, 1.0, c], [b, c, 1.0]])
    minimum = np.linalg.eigvalsh(matrix).min()
    try:
        factor = factor_of(matrix)
    except InputError:
        assert minimum < 1e-9
    else:
        assert minimum > -1e-5
        assert factor @ factor.T == pytest.approx(matrix, abs=1e-5)
