"""A housing's stiffness as a finite-element program reduces it: over nodes in its order and units.

A list of nodes says, row by row of the matrix, which direction of which bearing's ring it is, and
in which units. What belongs to no ring is left to itself (condensed) or held.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Final, Literal

from rolamento.errors import ABSENT, InputError, guess
from rolamento.io.tables import Table, read_columns
from rolamento.records import frozen
from rolamento.units import Dimension, to_si
from rolamento.words import counted, said

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["MOST_ROWS", "Others", "elastic", "nodes_in_file", "reduced_to_rings"]

MOST_ROWS: Final = 600
"""Rows of a matrix over nodes."""
Others = Literal["free", "held"]
_AXES: Final = ("x", "y", "z", "ry", "rz")
"""Directions of a ring; a ring does not feel the turning about the shaft, rx."""
_EXAMPLE: Final = "node,dof,displacement,force,bearing"
_ROW_EXAMPLE: Final = "1041,x,mm,N,A"
_COLUMNS: Final = {
    "node": "node nodes nó no knoten",
    "dof": "dof direction degree_of_freedom gdl direção richtung",
    "displacement": "displacement displacement_unit deslocamento",
    "force": "force force_unit força",
    "bearing": "bearing rolamento lager",
}
_DIRECTIONS: Final = {
    word: axis
    for axis, words in {
        "x": "x ux 1",
        "y": "y uy 2",
        "z": "z uz 3",
        "rx": "rx rotx urx 4",
        "ry": "ry roty ury 5",
        "rz": "rz rotz urz 6",
    }.items()
    for word in words.split()
}
"""Directions as programs call them."""
_UNITS: Final[dict[str, tuple[str, str, str, str]]] = {
    "N/m": ("m", "rad", "N", "N m"),
    "N/mm": ("mm", "rad", "N", "N mm"),
}
"""Units of shifts, tilts, forces and moments where the list gives none."""
_SYMMETRY: Final = 1e-6
_ROUNDING: Final = 1e-9
_SOFTEST: Final = 1e-12
"""What is softer, beside the stiffest of what is condensed, holds nothing."""


@frozen
class _Row:
    """What a row of the matrix is: its node, direction and sign, the bearing; factors into SI."""

    node: str
    axis: str
    sign: float
    displacement: float
    force: float
    bearing: str


def elastic(matrix: NDArray[np.float64], names: Sequence[str] | None = None) -> NDArray[np.float64]:
    """Return the symmetric part of a stiffness matrix in SI.

    Parameters
    ----------
    matrix
        Square.
    names
        Of its rows, for messages; their numbers from 1 if not given.

    Raises
    ------
    InputError
        If no elastic structure has it: it is not finite, not symmetric to 10⁻⁶ of its largest
        number, or not positive semi-definite.
    """
    import numpy as np

    largest = float(np.abs(matrix).max())
    if not np.isfinite(largest):
        raise InputError(said("must contain finite numbers only"))
    skew = np.abs(matrix - matrix.T)
    if float(skew.max()) > _SYMMETRY * largest:
        row, column = (int(place) for place in np.unravel_index(skew.argmax(), skew.shape))
        raise InputError(
            said(
                "must be symmetric: row {row}, column {column} is {one:.6g}, and the other way"
                " round {other:.6g} (SI)",
                row=row + 1 if names is None else names[row],
                column=column + 1 if names is None else names[column],
                one=float(matrix[row, column]),
                other=float(matrix[column, row]),
            )
        )
    matrix = 0.5 * (matrix + matrix.T)
    values = np.linalg.eigvalsh(matrix)
    if float(values[0]) < -_ROUNDING * float(np.abs(values).max()):
        raise InputError(
            said(
                "must be positive semi-definite, as that of any elastic structure: an eigenvalue"
                " is {least:.6g} (SI), the largest {most:.6g}",
                least=float(values[0]),
                most=float(values[-1]),
            )
        )
    return matrix


def nodes_in_file(path: str) -> tuple[list[dict[str, str]], Table]:
    """Read a list of nodes: a table with the columns node, dof, displacement, force, bearing.

    The rows, and the table for the place of each of them.

    Raises
    ------
    FileError
        If it is no such table.
    """
    table, places = read_columns(
        path, _COLUMNS, ("node", "dof", "bearing"), most_rows=MOST_ROWS, example=_EXAMPLE
    )
    rows = [
        {column: cell for column, (place, _) in places.items() if (cell := row[place].strip())}
        for row in table.rows
    ]
    return rows, table


def reduced_to_rings(
    matrix: Sequence[Sequence[float]],
    nodes: Sequence[Mapping[str, Any]],
    *,
    bearings: Sequence[str] = (),
    units: str | None = None,
    others: Others | None = None,
) -> tuple[tuple[str, ...], NDArray[np.float64]]:
    """Return names of bearings, and the stiffness between their outer rings in SI.

    Parameters
    ----------
    matrix
        Over all nodes, in the order and the units of the list.
    nodes
        What each row is: ``{"node": 1041, "dof": "-y", "displacement": "mm", "force": "N",
        "bearing": "A"}``. A minus of one whose direction is the other way in the machine. Rows
        without a bearing, and those about the shaft (rx), are the others.
    bearings
        Those that stand in the structure, in the order that is wanted; as the list has them if not
        given.
    units
        ``"N/mm"`` or ``"N/m"``, of rows without units of their own.
    others
        What becomes of the rows of no ring: ``"free"``, condensed, or ``"held"``.

    Raises
    ------
    InputError
        If list and matrix do not fit, a unit, a direction or a bearing is unknown or missing, or no
        structure has the matrix.
    """
    import numpy as np

    stiffness = np.asarray(matrix, dtype=float)
    if stiffness.ndim != 2 or stiffness.shape[0] != stiffness.shape[1]:
        raise InputError(
            said("must be a matrix of {size} rows and columns", size=len(nodes)), field="matrix"
        )
    if len(nodes) != len(stiffness):
        raise InputError(
            said(
                "must have a row for each of the {size} rows of the matrix, in their order",
                size=len(stiffness),
            ),
            field="nodes",
            value=len(nodes),
            example=_ROW_EXAMPLE,
        )
    rows = [_row(one, index, units, bearings) for index, one in enumerate(nodes)]
    force = np.array([row.sign * row.force for row in rows])
    shift = np.array([row.sign * row.displacement for row in rows])
    stiffness = stiffness * force[:, np.newaxis] / shift
    try:
        whole = elastic(stiffness, [f"{row.node} {row.axis}" for row in rows])
    except InputError as error:
        raise error.with_details(
            field="matrix", example=said("rows in the order and the units of the list of nodes")
        ) from None
    names = tuple(bearings) or tuple(dict.fromkeys(row.bearing for row in rows if row.bearing))
    kept = _kept(rows, names)
    rest = np.setdiff1d(np.arange(len(rows)), kept)
    if len(rest) and others is None:
        raise InputError(
            counted(
                "is missing: {n} row is of no ring, {first}; it is free or held",
                "is missing: {n} rows are of no ring, such as {first}; they are free or held",
                len(rest),
                first=f"{rows[rest[0]].node} {rows[rest[0]].axis}",
            ),
            field="others",
            value=ABSENT,
            example='others = "free"',
        )
    if len(rest) and others == "free":
        whole = _condensed(whole, kept, rest)
    else:
        whole = whole[np.ix_(kept, kept)]
    return names, whole


def _condensed(
    whole: NDArray[np.float64], kept: NDArray[np.int64], rest: NDArray[np.int64]
) -> NDArray[np.float64]:
    """The stiffness between some rows, nothing acting on the others."""
    import numpy as np

    within = whole[np.ix_(rest, rest)]
    size = np.sqrt(np.where(np.diag(within) > 0.0, np.diag(within), 1.0))  # shifts and tilts alike
    inverse = np.linalg.pinv(within / np.outer(size, size), rcond=_SOFTEST, hermitian=True)
    across = whole[np.ix_(kept, rest)] / size
    found = whole[np.ix_(kept, kept)] - across @ inverse @ across.T
    return np.asarray(0.5 * (found + found.T))


def _kept(rows: Sequence[_Row], names: Sequence[str]) -> NDArray[np.int64]:
    """The rows of the rings, bearing by bearing and x, y, z, ry, rz."""
    import numpy as np

    places: dict[tuple[str, str], int] = {}
    for index, row in enumerate(rows):
        key = (row.bearing, row.axis)
        if row.bearing and row.axis in _AXES and places.setdefault(key, index) != index:
            raise InputError(
                said(
                    "is given twice: {axis} of {bearing} is row {row} too",
                    axis=row.axis,
                    bearing=f'"{row.bearing}"',
                    row=places[key] + 1,
                ),
                field=f"nodes.{index}.dof",
                value=row.axis,
            )
    if not names:
        raise InputError(
            said("is missing: no row is of a bearing"), field="nodes", example=_ROW_EXAMPLE
        )
    for name in names:
        for axis in _AXES:
            if (name, axis) not in places:
                raise InputError(
                    said("has no row for {axis} of {bearing}", axis=axis, bearing=f'"{name}"'),
                    field="nodes",
                    example=f"1041,{axis},{'rad,N mm' if axis[0] == 'r' else 'mm,N'},{name}",
                )
    return np.array([places[name, axis] for name in names for axis in _AXES])


def _row(given: Mapping[str, Any], index: int, units: str | None, bearings: Sequence[str]) -> _Row:
    field = f"nodes.{index}"
    if not isinstance(given, Mapping):
        raise InputError(said("must be a table"), field=field, value=given)
    for name in given:
        if name not in _COLUMNS:
            rule = said("is an unknown key; {guess}", guess=guess(str(name), _COLUMNS))
            raise InputError(rule, field=f"{field}.{name}")
    word = str(given.get("dof", "")).strip().casefold()
    axis = _DIRECTIONS.get(word.lstrip("+-"))
    if axis is None:
        raise InputError(
            said("must be one of {expected}", expected="x, y, z, rx, ry, rz"),
            field=f"{field}.dof",
            value=given.get("dof", ABSENT),
            example="dof = x",
        )
    bearing = str(given.get("bearing") or "")
    if bearing and bearings and bearing not in bearings:
        raise InputError(
            said("is an unknown name; {guess}", guess=guess(bearing, bearings)),
            field=f"{field}.bearing",
            value=bearing,
        )
    tilts = axis.startswith("r")
    kinds: tuple[tuple[str, Dimension, int], ...] = (
        ("displacement", "angle" if tilts else "length", 1 if tilts else 0),
        ("force", "moment" if tilts else "force", 3 if tilts else 2),
    )
    factors = []
    for name, dimension, place in kinds:
        unit = given.get(name) or ("" if units not in _UNITS else _UNITS[units][place])
        if not unit:
            raise InputError(
                said("needs a unit"), field=f"{field}.{name}", value=ABSENT, example=_ROW_EXAMPLE
            )
        try:
            factors.append(to_si(f"1 {unit}", dimension))
        except InputError as error:
            raise error.with_details(field=f"{field}.{name}", value=str(unit)) from None
    sign = -1.0 if word.startswith("-") else 1.0
    return _Row(str(given.get("node", index + 1)), axis, sign, factors[0], factors[1], bearing)
