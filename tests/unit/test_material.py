from __future__ import annotations

import pytest

from rolamento import InputError, Material, UnknownKeyError
from rolamento.case.material import DEFAULT_MATERIAL


def test_the_default_is_bearing_steel() -> None:
    steel = Material.named(DEFAULT_MATERIAL)
    assert (steel.youngs_modulus, steel.poisson_ratio, steel.density) == (207e9, 0.3, 7810.0)


@pytest.mark.parametrize("name", ["100Cr6", "100cr6", "52100", "AISI 52100", "aisi52100"])
def test_names_and_aliases_are_found_in_any_case(name: str) -> None:
    assert Material.named(name) is Material.named("100Cr6")


@pytest.mark.parametrize("name", Material.names())
def test_every_record_is_plausible_and_names_its_source(name: str) -> None:
    material = Material.named(name)
    assert material.name == name
    assert len(material.source) > 20
    assert 190e9 <= material.youngs_modulus <= 320e9
    assert 0.25 <= material.poisson_ratio <= 0.3
    assert 3000 <= material.density <= 8000


def test_the_named_materials_of_the_field_are_there() -> None:
    assert {"100Cr6", "440C", "M50", "Si3N4"} <= set(Material.names())


def test_an_unknown_name_is_refused_with_the_nearest_one() -> None:
    with pytest.raises(
        InputError, match=r'"Si3N5": is an unknown name \(material\); did you mean Si3N4'
    ):
        Material.named("Si3N5")
    with pytest.raises(InputError, match="known: 100Cr6, 440C, M50, Si3N4"):
        Material.named("wood of the forest")


def test_free_values_are_taken_in_si_and_as_text() -> None:
    plain = Material(youngs_modulus=310e9, poisson_ratio=0.26, density=3240.0)
    text = Material(youngs_modulus="310 GPa", poisson_ratio=0.26, density="3.24 g/cm^3")
    assert plain == text
    assert hash(plain) == hash(text)
    assert plain.name == "custom"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"youngs_modulus": "310 GPa/s"}, "not a unit of stress"),
        ({"youngs_modulus": 310}, "must be at least 1 GPa"),
        ({"poisson_ratio": 0.5}, "must be at least 0 and at most 0.49"),
        ({"density": -1.0}, "must be at least 100 kg/m"),
        ({"name": "two\nlines"}, "one line"),
    ],
)
def test_values_out_of_range_are_refused(change: dict[str, object], message: str) -> None:
    values = {"youngs_modulus": 310e9, "poisson_ratio": 0.26, "density": 3240.0}
    with pytest.raises(InputError, match=message):
        Material(**{**values, **change})


def test_a_misspelt_field_is_refused() -> None:
    with pytest.raises(UnknownKeyError, match="did you mean density"):
        Material(youngs_modulus=310e9, poisson_ratio=0.26, densty=3240.0)
