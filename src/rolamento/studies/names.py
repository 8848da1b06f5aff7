"""What the variables of studies are called: inputs, outputs, and the models they are by."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Final

from rolamento.case import Case
from rolamento.case.machine_fields import field_of_machine
from rolamento.case.variant import AS_GIVEN, settings_in
from rolamento.studies.outputs import OF
from rolamento.words import manner, marked, said, speaking

__all__ = ["setting_name", "variable_long_name", "variable_name"]

_COORDINATES: Final = {
    "ball": marked("ball"),
    "row": marked("row"),
    "variant": marked("variant"),
    "sample": marked("sample"),
}


def variable_name(variable: str, field: str = "") -> str:
    """Return what a variable of a study is called, or nothing if it is not known.

    Parameters
    ----------
    variable
        Such as ``"fx"``, ``"stiffness_zz"`` or ``"max_inner_load"``.
    field
        Dotted name of the field of the case that it holds, if that is known.
    """
    base, of, part = variable.partition(OF)
    if of and (name := variable_name(base)):
        return said("{quantity}, {part}", quantity=name, part=part)
    name = field if field in Case.fields() else _fields_by_leaf().get(variable, "")
    if name:
        return Case.fields()[name].label
    if (own := field_of_machine(field) if field else None) is not None:
        return own.label
    if variable in _COORDINATES:
        return said(_COORDINATES[variable])
    called = _outputs().get(variable)
    return "" if called is None else called()


def variable_long_name(variable: str, field: str = "") -> str:
    """Return what a variable is called in files: its name in English."""
    with speaking("en"):
        return variable_name(variable, field)


def setting_name(setting: str) -> str:
    """Write what was set, ``"life.contamination=0.8"``, with the label of its field.

    Of a variant, its name as it is, or all that it sets.
    """
    if setting == AS_GIVEN:
        return said("as given")
    return ", ".join(_one_setting(part) for part in settings_in(setting)[1]) or setting


def _one_setting(setting: str) -> str:
    name, equals, value = setting.partition("=")
    field = Case.fields().get(name.strip())
    if not equals or field is None:
        return setting
    return f"{field.label} = {manner().localised(value.strip())}"


@cache
def _outputs() -> Mapping[str, Callable[[], str]]:
    """What says how each output is called, of bearings and of machines, by name."""
    from rolamento.studies.machine_outputs import called_of_machines
    from rolamento.studies.outputs import catalogue

    return called_of_machines() | {name: one.called for name, one in catalogue().items()}


@cache
def _fields_by_leaf() -> dict[str, str]:
    """Names of fields by the last part, where that is of one field and of no output."""
    leaves: dict[str, list[str]] = {}
    fields = Case.fields()
    for name, field in fields.items():
        leaves.setdefault(field.leaf, []).append(name)
    return {
        leaf: names[0]
        for leaf, names in leaves.items()
        if len(names) == 1 and leaf not in _outputs() and fields[names[0]].kind != "switch"
    }
