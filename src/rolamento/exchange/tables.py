"""Stiffness and force of bearings as tables: CSV, MATLAB and Modelica.

All in SI, by the names of the five degrees of freedom, x, y, z, ry, rz, x along the shaft.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import Any, Final

import numpy as np

import rolamento
from rolamento.case.duty import AXES, LOADS
from rolamento.errors import InputError, printable
from rolamento.numerics import FloatArray
from rolamento.solved.maps import StiffnessMap
from rolamento.words import said

__all__ = ["COLUMNS", "about", "identifiers", "maps_to_csv", "maps_to_mat", "maps_to_modelica"]

_OF: Final = {"f": "N", "m": "N*m"}
_STIFFNESS_UNITS: Final = {
    ("f", 1): "N/m", ("f", 2): "N/rad", ("m", 1): "N", ("m", 2): "N*m/rad",
}  # fmt: skip
COLUMNS: Final[Mapping[str, tuple[tuple[str, str], ...]]] = {
    "stiffness": tuple(
        (f"stiffness_{AXES[row]}{axis}", _STIFFNESS_UNITS[load[0], len(axis)])
        for row, load in enumerate(LOADS)
        for axis in AXES
    ),
    "force": tuple((load, _OF[load[0]]) for load in LOADS),
    "displacement": tuple((axis, "rad" if len(axis) > 1 else "m") for axis in AXES),
}
"""Names and units of what a map has, in the order in which it has them."""
_MEANING: Final = {
    "stiffness": "derivative of the force by the displacement; a row for each force",
    "force": "that the shaft puts on the inner ring",
    "displacement": "of the inner ring against the outer one",
}
_LONGEST_NAME: Final = 40


def about(one: StiffnessMap) -> dict[str, str]:
    """Return where a map comes from and what it means, by name; English, as all in files."""
    return {
        **one.made_of,
        "program": f"Rolamento {rolamento.__version__}",
        "degrees of freedom": ", ".join(AXES) + "; x along the shaft, z up, y = z x x",
        **_MEANING,
    }


def identifiers(names: Sequence[str]) -> tuple[str, ...]:
    """Return names as programs take them, unlike each other: letters, digits and strokes."""
    found: list[str] = []
    for name in names:
        plain = re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_")[:_LONGEST_NAME] or "bearing"
        plain = plain if plain[0].isalpha() else f"b_{plain}"
        free = plain
        while free.casefold() in {one.casefold() for one in found}:
            free = f"{plain}_{len(found) + 1}"
        found.append(free)
    return tuple(found)


def _flat(one: StiffnessMap) -> dict[str, FloatArray]:
    """Its quantities, (points, columns), the last axis the fastest."""
    return {
        name: np.asarray(getattr(one, name)).reshape(one.status.size, len(columns))
        for name, columns in COLUMNS.items()
    }


def _points(one: StiffnessMap) -> Iterator[tuple[float, ...]]:
    return product(*(axis.values.tolist() for axis in one.axes))


def _titles(one: StiffnessMap) -> list[str]:
    return [f"{axis.field} [{axis.unit}]" if axis.unit else axis.field for axis in one.axes]


# --- CSV ------------------------------------------------------------------------------------------


def maps_to_csv(maps: Sequence[StiffnessMap]) -> str:
    """Return maps over the same fields as one CSV table, a line a bearing and point.

    Lines that begin with # say where it comes from. Where there is no equilibrium cells are empty,
    and the status says why. Numbers are not rounded.
    """
    text = io.StringIO(newline="")
    for name, value in about(maps[0]).items():
        text.write(f"# {name}: {_line(value)}\r\n")
    writer = csv.writer(text)
    columns = [f"{name} [{unit}]" for some in COLUMNS.values() for name, unit in some]
    writer.writerow(["bearing", *_titles(maps[0]), "status", *columns])
    for one in maps:
        parts = np.concatenate(list(_flat(one).values()), axis=1)
        for point, status, values in zip(_points(one), one.status.ravel(), parts, strict=True):
            cells = ["" if np.isnan(value) else repr(float(value)) for value in values]
            writer.writerow([_line(one.name), *map(repr, point), str(status), *cells])
    return text.getvalue()


def _line(text: str) -> str:
    return " ".join(printable(text).split())


# --- MATLAB ---------------------------------------------------------------------------------------


def maps_to_mat(maps: Sequence[StiffnessMap]) -> bytes:
    """Return maps as a MATLAB file of version 5, a structure for each bearing and ``about``.

    Each has name, axes (field, unit, values), stiffness (points × 5 × 5), force and displacement
    (points × 5), units and status; NaN where there is no equilibrium.
    """
    from scipy.io import savemat

    held: dict[str, Any] = {
        "about": {re.sub(r"\W+", "_", name): value for name, value in about(maps[0]).items()}
    }
    for name, one in zip(identifiers([one.name for one in maps]), maps, strict=True):
        held[name if name != "about" else "about_"] = {
            "name": one.name,
            "axes": [
                {"field": axis.field, "unit": axis.unit, "values": axis.values} for axis in one.axes
            ],
            **{quantity: getattr(one, quantity) for quantity in COLUMNS},
            "units": {
                "stiffness": _cells([unit for _, unit in COLUMNS["stiffness"]], 5),
                "force": _cells([unit for _, unit in COLUMNS["force"]], 1),
                "displacement": _cells([unit for _, unit in COLUMNS["displacement"]], 1),
            },
            "status": one.status.astype(object),
        }
    content = io.BytesIO()
    savemat(content, held, long_field_names=True, do_compression=True)
    whole = content.getvalue()
    head = f"MATLAB 5.0 MAT-file, written by Rolamento {rolamento.__version__}"
    return head.encode("ascii").ljust(116) + whole[116:]  # SciPy writes the time there


def _cells(texts: Sequence[str], rows: int) -> Any:
    return np.array(texts, dtype=object).reshape(rows, -1)


# --- Modelica -------------------------------------------------------------------------------------


def maps_to_modelica(maps: Sequence[StiffnessMap]) -> str:
    """Return maps as a text file of tables for ``CombiTable1Ds`` or ``CombiTable2Ds``.

    Over one field each bearing has tables ``NAME_stiffness``, ``NAME_force`` and
    ``NAME_displacement``: the first column is the field, the others are named in a comment. Over
    two fields each number has a table of its own, such as ``NAME_stiffness_xx``: the first column
    is the first field, the first row the second one.

    Raises
    ------
    InputError
        If a point has no equilibrium: tables of Modelica have no gaps.
    """
    lines = ["#1", *(f"# {name}: {_line(value)}" for name, value in about(maps[0]).items())]
    for name, given in zip(identifiers([one.name for one in maps]), maps, strict=True):
        _refuse_gaps(given)
        one = given.rising()
        lines += ["", f"# {_line(one.name)}, over {_line(', '.join(_titles(one)))}"]
        first = one.axes[0].values[:, np.newaxis]
        for quantity, flat in _flat(one).items():
            columns = COLUMNS[quantity]
            if len(one.axes) == 1:
                names = [f"{column} [{unit}]" for column, unit in columns]
                lines.append(f"# columns: {_titles(one)[0]}, {', '.join(names)}")
                lines += _table(f"{name}_{quantity}", np.hstack([first, flat]))
                continue
            head = np.concatenate([[0.0], one.axes[1].values])
            for place, (column, unit) in enumerate(columns):
                values = np.hstack([first, flat[:, place].reshape(one.shape)])
                lines.append(f"# {unit}")
                lines += _table(f"{name}_{column}", np.vstack([head, values]))
    return "\n".join(lines) + "\n"


def _refuse_gaps(one: StiffnessMap) -> None:
    if not one.converged:
        status = str(one.status[one.status != "converged"][0])
        raise InputError(
            said("has points without an equilibrium ({status}), and the format has no gaps; give"
                 " another range, or write CSV or MATLAB", status=status),
            field="over", value=one.name,
        )  # fmt: skip


def _table(name: str, values: FloatArray) -> Iterator[str]:
    yield f"double {name}({values.shape[0]},{values.shape[1]})"
    for row in values.tolist():
        yield " ".join(repr(one) for one in row)
