"""Where no torque model is valid this is said by name; curves have all models that a case has."""

from __future__ import annotations

from importlib import resources

import numpy as np
import pytest

from rolamento import Case, load_case, override
from rolamento.analysis import Analysis, analyse
from rolamento.charts.drawing import draw
from rolamento.document.terminal import terminal
from rolamento.pages.friction import friction_page
from rolamento.pages.friction_over import friction_over_page
from rolamento.plots.friction import torque_chart
from rolamento.studies.friction_curves import FrictionCurve, friction_curve, read_range


def shipped(name: str, *settings: str) -> Case:
    """A shipped case, with a coefficient of friction."""
    with resources.as_file(resources.files("rolamento") / "examples" / name) as path:
        case = load_case(path)
    lubricant = {"kind": "dry", "name": "dry", "friction_coefficient": 0.1}
    if case.lubricant is None:
        case = case.replace(lubricant=lubricant)
    else:
        case = case.replace(lubricant=case.lubricant.replace(friction_coefficient=0.1))
    return override(case, list(settings))


def flat(text: str) -> str:
    """The text without line breaks and margins."""
    return " ".join(text.split())


def notes_of(analysis: Analysis) -> list[str]:
    return [note["key"] for note in analysis.to_mapping()["notes"]]


def test_a_pair_without_a_valid_model_says_so_by_name() -> None:
    analysis = analyse(shipped("6012_pair.toml"))
    assert {"no_valid_torque_model", "no_friction_control_of_sets"} <= set(notes_of(analysis))
    page = flat(terminal(friction_page(analysis)))
    assert "No model of the friction torque is valid here: the torque is an estimate." in page
    assert "The inertia of the balls is not negligible: all models." in page
    assert "not available for sets of rows" in page


def test_a_single_row_is_told_of_friction_control() -> None:
    fast = shipped("218_combined.toml")
    assert "friction_control_has_inertia" in notes_of(analyse(fast))
    controlled = override(fast, ['model.raceway_control="friction"'])
    assert "no_valid_torque_model" not in notes_of(analyse(controlled))
    slow = override(fast, ['duty.inner_speed="100 rpm"'])
    assert "no_valid_torque_model" not in notes_of(analyse(slow))


def test_a_curve_says_where_no_model_is_valid() -> None:
    case = shipped("6012_pair.toml")
    curve = friction_curve(case, read_range("duty.inner_speed=100..10000rpm", 3, log=True))
    assert list(curve.without_model) == [False, False, True]
    page = flat(terminal(friction_over_page([curve])))
    assert "No model is valid at 10 000 rpm." in page
    assert "all models except friction control" not in page


@pytest.fixture(scope="module")
def loaded() -> FrictionCurve:
    case = shipped("6305_life.toml")
    return friction_curve(case, read_range("duty.load.fz=1000..3000N", 3))


def test_models_of_lubricated_bearings_stand_in_the_curve(loaded: FrictionCurve) -> None:
    """The middle of the range is the case itself; they have all sources in them."""
    friction = analyse(shipped("6305_life.toml")).friction
    assert friction is not None
    for model in ("palmgren", "skf"):
        assert model in loaded.friction.models
        assert loaded.torque(model)[1] == pytest.approx(friction.models[model].total[0], rel=1e-9)
    assert loaded.torque("jones_full")[1] == pytest.approx(friction.torque[0], rel=1e-9)
    mapping = loaded.to_mapping()["models"]["palmgren"]
    assert np.array_equal(mapping["torque"], mapping["contact_torque"])


def test_page_and_figure_have_every_model(loaded: FrictionCurve) -> None:
    """Friction control stands in the figure of a load too, as in its table."""
    page = terminal(friction_over_page([loaded]))
    names = [text.get_text() for text in draw(torque_chart([loaded])).get_legend().get_texts()]
    for name in ("Palmgren", "SKF"):
        assert name in page
        assert name in names
    assert "fr. control" in page
    assert "friction control" in [name.lower() for name in names]


def test_a_variant_without_a_model_has_no_number_of_it(loaded: FrictionCurve) -> None:
    other = friction_curve(
        shipped("209_radial.toml"), read_range("duty.load.fz=1000..3000N", 3), label="x"
    )
    assert np.isnan(other.torque("skf")).all()
    assert not other.valid("skf").any()
    terminal(friction_over_page([loaded, other]))
