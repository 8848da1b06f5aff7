"""Study files: what they may hold, what is refused and where, and that nothing gets lost."""

from __future__ import annotations

import json
import math
import re
import time
from pathlib import Path

import numpy as np
import pytest

from rolamento import Case
from rolamento.errors import FileError, InputError, UnitError, UnknownKeyError
from rolamento.studies import (
    Axis,
    Correlation,
    Distribution,
    Scatter,
    Study,
    load_study,
    parse_study,
    study_to_json,
    study_to_toml,
)
from rolamento.studies.fields import known_fields, read_field
from rolamento.studies.outputs import catalogue
from rolamento.studies.solving import array_fields

CASE = 'case = "218_combined.toml"\n'
AXIS = '[[axes]]\nfield = "duty.load.fx"\nvalues = ["1 kN", "2 kN"]\n'
SCATTER = '[scatter]\ncount = 10\n[scatter.fields."duty.load.fx"]\ndistribution = '
FULL = (
    'title = "Full"\nseed = 7\noutputs = ["x", "inner_load"]\n'
    + CASE
    + """
[[axes]]
field = "duty.load.fx"
first = "5 kN"
last = "45 kN"
count = 3
spacing = "log"

[[axes]]
field = "model.raceway_control"
values = ["outer", "jones"]

[[axes]]
name = "load case"
zipped = { "duty.inner_speed" = ["0 rpm", "6000 rpm"], "bearing.ball_count" = [16, 14] }

[scatter]
count = 5

[scatter.fields."bearing.contact_angle"]
distribution = "normal"
mean = "40 deg"
standard_deviation = "0.5 deg"
minimum = "39 deg"

[scatter.fields."bearing.inner_conformity"]
distribution = "uniform"
minimum = 0.52
maximum = 0.53

[[scatter.correlations]]
fields = ["bearing.inner_conformity", "bearing.contact_angle"]
coefficient = 0.6
"""
)


def parsed(text: str, examples: Path) -> Study:
    return parse_study(text, source="study.toml", folder=examples)


def refused(text: str, examples: Path) -> InputError:
    with pytest.raises(InputError) as caught:
        parsed(text, examples)
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < 600
    return caught.value


class TestReading:
    def test_sizes_and_names(self, examples: Path) -> None:
        study = parsed(FULL, examples)
        assert study.sizes == {"fx": 3, "raceway_control": 2, "load case": 2, "sample": 5}
        assert study.cases == 60
        assert study.case.bearing.ball_count == 16

    def test_values_are_si(self, examples: Path) -> None:
        fx, control, both = (axis.columns() for axis in parsed(FULL, examples).axes)
        assert np.allclose(fx["duty.load.fx"], [5e3, 15e3, 45e3], rtol=1e-14)
        assert fx["duty.load.fx"][0] == 5e3
        assert fx["duty.load.fx"][-1] == 45e3
        assert control["model.raceway_control"] == ("outer", "jones")
        assert both["bearing.ball_count"] == (16, 14)
        assert both["duty.inner_speed"][1] == pytest.approx(200.0 * math.pi)

    @pytest.mark.parametrize("write", [study_to_toml, study_to_json])
    def test_what_is_written_reads_back(self, write: object, examples: Path) -> None:
        study = parsed(FULL, examples)
        text = write(study)  # type: ignore[operator]
        again = parse_study(text)
        assert again == study
        assert write(again) == text  # type: ignore[operator]

    def test_balls_that_follow_the_rings_still_do(self, examples: Path) -> None:
        again = parse_study(study_to_json(parsed(FULL, examples)))
        assert "ball_material" not in again.case.bearing.model_fields_set

    def test_every_shipped_study(self, examples: Path) -> None:
        files = sorted((examples / "studies").glob("*.toml"))
        assert len(files) >= 2
        for file in files:
            study = load_study(file)
            assert study.title
            assert parse_study(study_to_toml(study)) == study

    def test_json(self, examples: Path) -> None:
        axis = {"field": "duty.load.fx", "values": ["1 kN"]}
        text = json.dumps({"case": "218_combined.toml", "axes": [axis]})
        assert parsed(text, examples).cases == 1

    def test_the_case_is_beside_the_study(self, examples: Path, tmp_path: Path) -> None:
        (tmp_path / "mine.toml").write_text((examples / "218_combined.toml").read_text("utf-8"))
        (tmp_path / "study.toml").write_text('case = "mine.toml"\n' + AXIS)
        assert load_study(tmp_path / "study.toml").case.bearing.ball_count == 16

    def test_settings_go_over_the_case(self, examples: Path) -> None:
        for text in (CASE + AXIS, study_to_toml(parsed(CASE + AXIS, examples))):
            study = parse_study(text, folder=examples, overrides=["duty.load.fz=10 kN"])
            assert study.case.duty.load.fz == 10e3
        with pytest.raises(InputError, match="--set"):
            parse_study(CASE + AXIS, folder=examples, overrides=["bearing.ball_count=1"])

    def test_in_python_values_may_be_si_and_arrays(self, case_218: Case) -> None:
        speeds = np.linspace(0.0, 1000.0, 5)
        study = Study(case=case_218, axes=[Axis(field="duty.inner_speed", values=speeds)])
        assert (study.axes[0].columns()["duty.inner_speed"] == speeds).all()
        again = parse_study(study_to_toml(study))
        assert (again.axes[0].columns()["duty.inner_speed"] == speeds).all()

    def test_in_python_scatter_may_be_si(self, case_218: Case) -> None:
        law = Distribution(distribution="normal", mean=0.7, standard_deviation=0.01, minimum=0.65)
        angle = "bearing.contact_angle"
        study = Study(case=case_218, scatter=Scatter(count=3, fields={angle: law}))
        again = parse_study(study_to_json(study))
        assert again.scatter is not None
        field = read_field(angle)
        assert again.scatter.fields[angle].law(field, in_file=True) == law.law(field, in_file=False)


class TestNames:
    def test_a_name_that_is_taken_is_written_in_full(self, examples: Path) -> None:
        text = CASE + '[[axes]]\nfield = "duty.displacement.x"\nvalues = ["0 mm", "0.01 mm"]\n'
        assert parsed(text, examples).sizes == {"duty.displacement.x": 2}

    def test_two_fields_of_one_last_name(self, examples: Path) -> None:
        text = CASE + "".join(
            f'[[axes]]\nfield = "bearing.{part}_material.density"\nvalues = ["7810 kg/m^3"]\n'
            for part in ("ring", "ball")
        )
        names = [f"bearing.{part}_material.density" for part in ("ring", "ball")]
        assert list(parsed(text, examples).sizes) == names

    def test_zipped_fields_give_their_names_together(self, examples: Path) -> None:
        text = CASE + '[[axes]]\nzipped = { "duty.load.fx" = ["1 N"], "duty.load.fy" = ["2 N"] }\n'
        assert parsed(text, examples).sizes == {"fx_fy": 1}


@pytest.mark.parametrize(
    ("text", "field", "line", "says"),
    [
        (CASE, "axes", None, "give axes, a scatter, or variants"),
        (AXIS, "case", None, "is missing"),
        ("case = 3\n" + AXIS, "case", 1, "name of a case file"),
        (CASE + "axes = 3\n", "axes", 2, "must be a list"),
        (CASE + "axes = [3]\n", "axes.0", 2, "must be a table"),
        (CASE + 'sed = 1\n' + AXIS, "sed", 2, "did you mean seed"),
        (CASE + "seed = -1\n" + AXIS, "seed", 2, "at least 0"),
        (CASE + 'outputs = ["max_iner_load"]\n' + AXIS, "outputs", 2, "mean max_inner_load"),
        (CASE + 'outputs = ["x", "x"]\n' + AXIS, "outputs", 2, "twice"),
        (CASE + AXIS + AXIS, "axes.1.field", 6, "varied twice"),
        (CASE + AXIS.replace("load.fx", "lod.fx"), "axes.0.field", 3, "mean duty.load.fx"),
        (CASE + AXIS.replace("duty.load.fx", "fx"), "axes.0.field", 3, "mean duty.load.fx"),
        (CASE + AXIS.replace("duty.load.fx", "duty.load"), "axes.0.field", 3, "is a table"),
        (CASE + AXIS + AXIS.replace("load.fx", "displacement.x").replace("kN", "um"),
         "axes.1.field", 6, "cannot be combined with"),
        (CASE + AXIS.replace("2 kN", "2 mm"), "axes.0.values", 4, "not a unit of force"),
        (CASE + AXIS.replace('"2 kN"', "2"), "axes.0.values", 4, "needs a unit"),
        (CASE + AXIS.replace('"2 kN"', "[2]"), "axes.0.values", 4, "must be a single value"),
        (CASE + AXIS.replace('["1 kN", "2 kN"]', "[]"), "axes.0.values", 4, "at least 1"),
        (CASE + AXIS + "count = 2\n", "axes.0.count", 5, "a range has none"),
        (CASE + '[[axes]]\nfield = "duty.load.fx"\nfirst = "1 N"\n', "axes.0.last", 2, "missing"),
        (CASE + "[[axes]]\ncount = 3\n", "axes.0.field", 2, "must be given"),
        (CASE + "[[axes]]\nzipped = {}\n", "axes.0.zipped", 3, "at least 1"),
        (CASE + AXIS + 'name = "a/b"\n', "axes.0.name", 5, "must be letters"),
        (CASE + AXIS + 'name = "status"\n', "axes.0.name", 5, "is already a name in the result"),
        (CASE + SCATTER + '"gamma"\n',
         "scatter.fields.duty.load.fx.distribution", 5, "must be one of"),
        (CASE + SCATTER + '"normal"\nmean = "1 N"\n',
         "scatter.fields.duty.load.fx.standard_deviation", 4, "missing for a normal"),
        (CASE + SCATTER + '"normal"\nmean = "1 N"\nstandard_deviation = "0 N"\n',
         "scatter.fields.duty.load.fx.standard_deviation", 7, "must be positive"),
        (CASE + SCATTER + '"normal"\nmean = "1 N"\nstandard_deviation = 1.0\n',
         "scatter.fields.duty.load.fx.standard_deviation", 7, "needs a unit"),
        (CASE + SCATTER + '"normal"\nmean = "1 N"\nstandard_deviation = "1 N"\nminimum = "1 kN"\n',
         "scatter.fields.duty.load.fx.minimum", 8, "lies more than"),
        (CASE + SCATTER + '"uniform"\nmean = "1 N"\nminimum = "1 N"\nmaximum = "2 N"\n',
         "scatter.fields.duty.load.fx.mean", 6, "does not apply to a uniform distribution"),
        (CASE + SCATTER + '"uniform"\nminimum = "2 N"\nmaximum = "1 N"\n',
         "scatter.fields.duty.load.fx.maximum", 7, "greater than minimum"),
        (CASE + SCATTER + '"triangular"\nlow = "1 N"\nmode = "2 N"\nmaximum = "3 N"\n',
         "scatter.fields.duty.load.fx.low", 6, "known: distribution, mean"),
    ],
)  # fmt: skip
@pytest.mark.thirds
def test_refused(text: str, field: str, line: int | None, says: str, examples: Path) -> None:
    error = refused(text, examples)
    assert (error.field, error.line) == (field, line)
    assert says in str(error)


def ranged(field: str, first: str, last: str, count: int, more: str = "") -> str:
    ends = f"first = {first}\nlast = {last}\ncount = {count}\n"
    return f'{CASE}[[axes]]\nfield = "{field}"\n{ends}{more}'


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (
            ranged("duty.load.fx", '"-1 N"', '"2 N"', 4, 'spacing = "log"\n'),
            "must not be zero or change sign in a range with logarithmic",
        ),
        (ranged("duty.load.fx", '"1 N"', '"2 N"', 1), "at least 2"),
        (ranged("bearing.ball_count", "8", "16", 4), "integers"),
        (ranged("model.raceway_control", '"outer"', '"inner"', 2), "takes no range"),
        (ranged("model.centrifugal_force", "true", "false", 2), "takes no range"),
        (ranged("bearing.inner_conformity", "0.4", "0.6", 2), "at least 0.501"),
        (
            ranged("bearing.inner_shoulder_height", '"1 mm"', '"2 mm"', 20_000),
            "combinations of values that each need a case of their own;",
        ),
    ],
)
def test_ranges_refused(text: str, says: str, examples: Path) -> None:
    assert says in str(refused(text, examples))


def test_whole_numbers_in_a_range(examples: Path) -> None:
    columns = parsed(ranged("bearing.ball_count", "8", "16", 5), examples).axes[0].columns()
    assert columns["bearing.ball_count"] == (8, 10, 12, 14, 16)


def test_a_case_file_that_is_missing_or_wrong_is_named(examples: Path, tmp_path: Path) -> None:
    assert isinstance(refused('case = "none.toml"\n' + AXIS, examples), FileError)
    (tmp_path / "wrong.toml").write_text("title = 3\n")
    with pytest.raises(InputError) as caught:
        parse_study('case = "wrong.toml"\n' + AXIS, folder=tmp_path)
    assert caught.value.source.endswith("wrong.toml")


def test_an_inline_case_names_its_fields(examples: Path) -> None:
    text = study_to_toml(parsed(CASE + AXIS, examples)).replace("40 deg", "140 deg")
    assert refused(text, examples).field == "case.bearing.contact_angle"


def test_too_many_cases(examples: Path) -> None:
    text = ranged("duty.load.fz", '"1 N"', '"2 N"', 1_000_000) + SCATTER.replace("10", "10000")
    error = refused(text + '"uniform"\nminimum = "1 N"\nmaximum = "2 N"\n', examples)
    assert "at most 1e9" in str(error)


def test_what_needs_a_case_of_its_own_cannot_be_scattered(examples: Path) -> None:
    for name in ("bearing.ball_count", "bearing.inner_shoulder_height"):
        text = CASE + SCATTER.replace("duty.load.fx", name)
        error = refused(text + '"uniform"\nminimum = "3 mm"\nmaximum = "4 mm"\n', examples)
        assert "use an axis" in str(error)


class TestCorrelations:
    def scatter(self, *pairs: tuple[str, str, float]) -> Scatter:
        law = Distribution(distribution="uniform", minimum=0.51, maximum=0.52)
        names = ("bearing.inner_conformity", "bearing.outer_conformity")
        more = "bearing.ring_material.poisson_ratio"
        poisson = Distribution(distribution="normal", mean=0.3, standard_deviation=0.01)
        correlations = [Correlation(fields=(a, b), coefficient=c) for a, b, c in pairs]
        fields = {**dict.fromkeys(names, law), more: poisson}
        return Scatter(count=4, fields=fields, correlations=correlations)

    INNER, OUTER, POISSON = (
        "bearing.inner_conformity",
        "bearing.outer_conformity",
        "bearing.ring_material.poisson_ratio",
    )

    def test_a_contradiction_is_named(self) -> None:
        with pytest.raises(
            InputError, match=r"contradict each other: no fields can have them all \(the"
        ):
            self.scatter(
                (self.INNER, self.OUTER, 0.9),
                (self.INNER, self.POISSON, 0.9),
                (self.OUTER, self.POISSON, -0.9),
            )

    def test_the_edge_of_what_is_possible_is_allowed(self) -> None:
        one = self.scatter(
            (self.INNER, self.OUTER, 1.0),
            (self.INNER, self.POISSON, 1.0),
            (self.OUTER, self.POISSON, 1.0),
        )
        assert (one.matrix() == 1.0).all()
        self.scatter((self.INNER, self.OUTER, -1.0))

    @pytest.mark.parametrize(
        ("pairs", "says"),
        [
            ([(INNER, INNER, 0.5)], "two fields"),
            ([(INNER, OUTER, 0.5), (OUTER, INNER, 0.5)], "each pair once"),
            ([(INNER, "duty.load.fx", 0.5)], "must be scattered fields"),
            ([(INNER, OUTER, 1.5)], "at most 1"),
        ],
    )
    def test_refused(self, pairs: list[tuple[str, str, float]], says: str) -> None:
        with pytest.raises(InputError, match=says):
            self.scatter(*pairs)


class TestFields:
    def test_all_that_a_batch_varies_is_known(self) -> None:
        assert array_fields() <= set(known_fields())

    def test_each_example_is_taken(self) -> None:
        for field in known_fields().values():
            assert field.example
            value = json.loads(field.example)
            checked = field.checked(value, in_file=True)
            assert field.checked(field.written(checked), in_file=True) == checked

    def test_units(self) -> None:
        units = {name: read_field(name).unit for name in known_fields()}
        assert units["duty.load.my"] == "N*m"
        assert units["bearing.inner_conformity"] == "1"
        assert units["bearing.ball_count"] == ""

    def test_errors_have_the_project_s_types(self) -> None:
        with pytest.raises(UnknownKeyError):
            read_field("nothing")
        with pytest.raises(UnitError):
            read_field("duty.load.fx").checked(3.0, in_file=True)
        assert read_field("duty.load.fx").checked(3.0, in_file=False) == 3.0


def test_a_page_of_values_is_read_in_bounded_time(examples: Path) -> None:
    values = ", ".join(f'"{i} N"' for i in range(20_000))
    began = time.monotonic()
    text = f'{CASE}[[axes]]\nfield = "duty.load.fx"\nvalues = [{values}]\n'
    assert parsed(text, examples).cases == 20_000
    assert time.monotonic() - began < 20.0


GUIDE = (Path(__file__).resolve().parents[2] / "docs" / "studies.md").read_text("utf-8")


@pytest.mark.parametrize("block", re.findall(r"```toml\n(.*?)```", GUIDE, re.DOTALL))
def test_the_files_of_the_guide(block: str, examples: Path, tmp_path: Path) -> None:
    (tmp_path / "case.toml").write_text((examples / "218_combined.toml").read_text("utf-8"))
    machine = (examples / "machines" / "gear_shaft.toml").read_text("utf-8")
    (tmp_path / "gear_shaft.toml").write_text(machine)
    whole = block if re.search("^(case|machine) =", block, re.M) else 'case = "case.toml"\n' + block
    assert parse_study(whole, folder=tmp_path).cases > 1


def test_the_guide_tells_of_outputs_that_exist() -> None:
    known = set(catalogue()) | {"max_pressure"}  # of a machine
    told = set(re.findall(r"`((?:max_|inner_|outer_|stiffness_)[a-z_]+[a-z])`", GUIDE))
    assert told
    assert told <= known
