"""ROSS, the open rotordynamics package: bearing elements over speed, and whole rotors as a script.

Its axes: z runs along the shaft, so that our y, z, x are its x, y, z: both are right-handed, and
turning about +x here is turning about +z there. Its bearing elements resist shifts alone, and do
not couple what is along the shaft with what is across it: `left_out` says how much that is.

https://github.com/petrobras/ross; the keys of its files are those of its versions 2 and 3.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby
from typing import Any, Final

import numpy as np

import rolamento
from rolamento.case.machine import Machine, Spring
from rolamento.errors import InputError, arguments, printable
from rolamento.io.text import text_of_mapping
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solved.maps import StiffnessMap
from rolamento.system.shafts import beams_of
from rolamento.words import Note, said

__all__ = [
    "FEWEST_SPEEDS",
    "VERSIONS",
    "RossBearing",
    "bearing_file",
    "ross_bearings",
    "ross_script",
]

VERSIONS: Final[Mapping[int, str]] = {2: "frequency", 3: "speed"}
"""What the axis of speeds is called in the files of each version."""
FEWEST_SPEEDS: Final = 7
"""ROSS 3 wants five, and puts cubic polynomials through them."""
_FROM_OURS: Final = {"x": 1, "y": 2, "z": 0}
"""Our degree of freedom of each of its axes."""
_KEPT: Final = ("xx", "xy", "yx", "yy", "zz")
_ZERO: Final = ("xx", "xy", "yx", "yy", "zz")


@frozen(eq=False)
class RossBearing:
    """A bearing as one element of ROSS, or as two with a lever.

    Attributes
    ----------
    name
        what the element is called
    of
        the bearing that it stands for
    shaft, position
        where it is, from the shaft's left end, m; of a bearing without a shaft from its middle
    speed
        (speeds,), rad/s
    stiffness
        (speeds, 3, 3) along ROSS's x, y, z, N/m
    left_out
        of the whole bearing, over all speeds: the greatest stiffness between shifts along and
        across the shaft, N/m; between shifts and tilts, N/rad; of tilts, N·m/rad
    notes
        what else it leaves out
    """

    name: str
    of: str
    shaft: str
    position: float
    speed: FloatArray
    stiffness: FloatArray
    left_out: tuple[float, float, float]
    notes: tuple[Note, ...] = ()

    def keywords(self, damping: float) -> dict[str, Any]:
        """Return what ROSS takes, but the node and the name; C = damping · K."""
        found: dict[str, Any] = {}
        for letter, factor in (("k", 1.0), ("c", damping)):
            for pair in _KEPT:
                row, column = ("xyz".index(axis) for axis in pair)
                values = factor * self.stiffness[:, row, column]
                found[letter + pair] = [float(one) + 0.0 for one in values]
        return found


def ross_bearings(
    maps: Sequence[StiffnessMap], machine: Machine | None = None, *, levers: bool = False
) -> tuple[RossBearing, ...]:
    """Return the bearings of a machine, or one alone, as elements of ROSS.

    Parameters
    ----------
    maps
        Over speed alone, as of `rolamento.rotors.supports`.
    machine
        Where they are; None of a bearing alone.
    levers
        Two elements for each, apart from each other so that they resist tilt as the bearing does:
        at ξ ± a from its middle,

            ξ = (K_y,rz - K_z,ry)/(K_yy + K_zz),   a² = (K_ry,ry + K_rz,rz)/(K_yy + K_zz) - ξ²,

        at the speed nearest to the machine's, each with half of the stiffness. Of a bearing that
        resists no tilt about any place of its shaft, and where they would stand beyond its ends,
        one element with a note.

    Raises
    ------
    InputError
        If a map is not over speed, has fewer speeds than 7, or a speed without equilibrium.
    """
    found: list[RossBearing] = []
    for given in maps:
        _check(given)
        one = given.rising()
        shaft, position = "", 0.0
        own = float(given.axes[0].values[-1])
        if machine is not None:
            seat = machine.bearing(one.name)
            shaft, position = seat.shaft, seat.position
            factor = machine.spectrum[0].speed_factor if machine.spectrum else 1.0
            own = abs(machine.speed(shaft, factor))
        ours = [_FROM_OURS[axis] for axis in "xyz"]
        kept = one.stiffness[:, ours][:, :, ours].copy()
        kept[:, :2, 2] = kept[:, 2, :2] = 0.0
        speed = one.axes[0].values
        places: tuple[float, ...] = (0.0,)
        notes = list(one.notes)
        if levers:
            at = one.stiffness[int(np.argmin(np.abs(speed - own)))]
            apart = _levers(at)
            length = math.inf if machine is None else machine.shaft(shaft).length
            if apart is None:
                notes.append(Note("ross_no_lever", {"bearing": one.name}))
            elif machine is not None and not all(0.0 <= position + p <= length for p in apart):
                values = {"bearing": one.name, "lever": 0.5 * (apart[1] - apart[0])}
                notes.append(Note("ross_lever_off_shaft", values))
            else:
                places = apart
        out = _left_out(one.stiffness, places)
        for number, place in enumerate(places):
            name = one.name if len(places) == 1 else f"{one.name} {number + 1}"
            found.append(
                RossBearing(
                    name, one.name, shaft, position + place, speed, kept / len(places), out,
                    tuple(notes) if number == 0 else (),
                )
            )  # fmt: skip
    return tuple(found)


def _check(one: StiffnessMap) -> None:
    axis = one.axes[0]
    if len(one.axes) > 1 or axis.unit != "rad/s":
        raise InputError(
            said("must be a speed: elements of ROSS are given over speed alone"),
            field="over", value=axis.field if len(one.axes) == 1 else one.axes[1].field,
            example=arguments(over="duty.inner_speed=0..6000rpm"),
        )  # fmt: skip
    if len(axis.values) < FEWEST_SPEEDS:
        raise InputError(
            said("must be at least {at_least}", at_least=FEWEST_SPEEDS),
            field="points", value=len(axis.values),
        )  # fmt: skip
    if axis.values.min() < 0.0 or not np.diff(np.sort(axis.values)).all():
        raise InputError(
            said("must rise from 0 or more"),
            field="over",
            value=axis.field,
            example=arguments(over="duty.inner_speed=0..6000rpm"),
        )
    lost = np.flatnonzero(one.status != "converged")
    if len(lost):
        raise InputError(
            said("has no equilibrium at {speed:.6g rpm}: ROSS would put a curve through what is"
                 " missing; give another range", speed=float(axis.values[lost[0]])),
            field="over", value=one.name,
        )  # fmt: skip


def _levers(k: FloatArray) -> tuple[float, float] | None:
    """Where two elements resist shift and tilt as a bearing does, from its middle; m."""
    across = k[1, 1] + k[2, 2]
    if not across > 0.0:
        return None
    middle = (k[1, 4] + k[4, 1] - k[2, 3] - k[3, 2]) / (2.0 * across)
    square = (k[3, 3] + k[4, 4]) / across - middle**2
    if not square > 1e-12:
        return None
    return float(middle - math.sqrt(square)), float(middle + math.sqrt(square))


def _left_out(k: FloatArray, places: Sequence[float]) -> tuple[float, float, float]:
    """What elements at some places do not have of a bearing's stiffness; as of `RossBearing`."""
    had = np.zeros_like(k)
    had[:, 0, 0] = k[:, 0, 0]
    for place in places:
        seen = np.zeros((2, 5))  # shifts y and z at the element
        seen[0, [1, 4]] = 1.0, place
        seen[1, [2, 3]] = 1.0, -place
        had += seen.T @ (k[:, 1:3, 1:3] / len(places)) @ seen
    rest = np.abs(k - had)
    return (
        float(np.maximum(rest[:, 0, 1:3], rest[:, 1:3, 0]).max()),
        float(np.maximum(rest[:, :3, 3:], np.swapaxes(rest[:, 3:, :3], 1, 2)).max()),
        float(rest[:, 3:, 3:].max()),
    )


# --- files of elements ----------------------------------------------------------------------------


def bearing_file(
    bearings: Sequence[RossBearing],
    version: int,
    machine: Machine | None = None,
    *,
    damping: float = 0.0,
) -> str:
    """Return the TOML text that ``ross.BearingElement.load`` reads, a table for each element.

    Parameters
    ----------
    bearings
        Of `ross_bearings`.
    version
        Of ROSS: 2 or 3.
    machine
        Whose nodes are numbered as in `ross_script`; without one each element has node 0, 1, …
    damping
        s: the damping matrix is so many times the stiffness.
    """
    axis = _axis(version)
    nodes = range(len(bearings)) if machine is None else _Nodes(machine, bearings).of(bearings)
    tables: dict[str, Any] = {}
    for one, node in zip(bearings, nodes, strict=True):
        zero = [0.0] * len(one.speed)
        tables[f"BearingElement_{one.name}"] = {
            "n": int(node),
            **one.keywords(damping),
            **{f"m{pair}": zero for pair in _ZERO},
            axis: one.speed.tolist(),
            "tag": one.name,
            "scale_factor": 1.0,
            "color": "#355d7a",
        }
    return _said_of(bearings, "#") + text_of_mapping(tables, "toml")


def _axis(version: int) -> str:
    if version not in VERSIONS:
        raise InputError(
            said("must be one of {known}", known="2, 3"), field="ross", value=version,
            example=arguments(ross=3),
        )  # fmt: skip
    return VERSIONS[version]


def _said_of(bearings: Sequence[RossBearing], mark: str) -> str:
    """What was written and what it leaves out, as comments; English, as all in files."""
    lines = [
        f"Bearings over speed, written by Rolamento {rolamento.__version__}.",
        "z is along the shaft: x, y, z here are y, z, x there. SI: N/m, N s/m, rad/s.",
        "Left out, at most: stiffness between shifts along and across the shaft, between shifts"
        " and tilts, of tilts:",
    ]
    for name, parts in groupby(bearings, key=lambda one: one.of):
        own = list(parts)
        cross, mixed, tilt = own[0].left_out
        lines.append(f"  {name}: {cross:.4g} N/m, {mixed:.4g} N/rad, {tilt:.4g} N m/rad")
        for one in own if len(own) > 1 or own[0].shaft else ():
            where = f"shaft {one.shaft}" if one.shaft else "from its middle"
            lines.append(f"    {one.name}: {where}, {one.position:.6g} m")
    return "".join(f"{mark} {_plain(line)}\n" for line in lines) + "\n"


def _plain(text: str) -> str:
    """A text that ends no comment and no string of Python."""
    return " ".join(printable(text).splitlines()).replace("\\", " ").replace('"', "'")


# --- rotors ---------------------------------------------------------------------------------------


class _Nodes:
    """The nodes of a machine's shafts as ROSS numbers them: on, from shaft to shaft of a rotor."""

    def __init__(self, machine: Machine, bearings: Sequence[RossBearing]) -> None:
        more: dict[str, list[float]] = {}
        for one in bearings:
            places = more.setdefault(one.shaft, [])
            places.append(one.position)
            if (outer := machine.bearing(one.of).outer_shaft) is not None:
                more.setdefault(outer, []).append(_on_outer(machine, one))
        self.machine = machine
        self.beams = {beam.shaft.name: beam for beam in beams_of(machine, more)}
        self.rotors = list(_joined(machine))
        self._first: dict[str, int] = {}
        for rotor in self.rotors:
            count = 0
            for name in rotor:
                self._first[name] = count
                count += len(self.beams[name].place)

    def at(self, shaft: str, position: float) -> int:
        """The node at a place of a shaft."""
        beam = self.beams[shaft]
        return self._first[shaft] + beam.node_at(position) - beam.first

    def of(self, bearings: Sequence[RossBearing]) -> list[int]:
        """The nodes of some bearings."""
        return [self.at(one.shaft, one.position) for one in bearings]

    def link(self, one: RossBearing) -> int | None:
        """The node of the shaft around a bearing; None of one on the ground."""
        outer = self.machine.bearing(one.of).outer_shaft
        return None if outer is None else self.at(outer, _on_outer(self.machine, one))


def _on_outer(machine: Machine, one: RossBearing) -> float:
    """Where an element is on the shaft around it, from its left end; m."""
    seat = machine.bearing(one.of)
    return machine.outer_position(one.of) + one.position - seat.position


def _joined(machine: Machine) -> Iterator[tuple[str, ...]]:
    """Shafts that bearings or springs join, together; each other one alone."""
    group = {shaft.name: index for index, shaft in enumerate(machine.shafts)}
    pairs = [(one.shaft, one.outer_shaft) for one in machine.bearings if one.outer_shaft]
    pairs += [(one.shaft, one.to_shaft) for one in machine.springs if one.to_shaft]
    for one, other in pairs:
        old, new = group[other], group[one]
        group = {name: new if place == old else place for name, place in group.items()}
    for place in dict.fromkeys(group.values()):
        yield tuple(name for name, own in group.items() if own == place)


def ross_script(
    machine: Machine,
    bearings: Sequence[RossBearing],
    *,
    frequencies: FloatArray | None = None,
    damping: float = 0.0,
) -> str:
    """Return a Python script that makes the rotors of a machine with ROSS 2 or 3, and runs there.

    Parameters
    ----------
    machine
        Shafts become elements of taper between nodes, masses disks, springs bearing elements;
        housings are in the stiffness of the bearings.
    bearings
        Of `ross_bearings`.
    frequencies
        Natural frequencies by `rolamento.rotors.natural_modes`, which the script prints beside
        those of ROSS; rad/s.
    damping
        s: the damping matrix is so many times the stiffness.
    """
    nodes = _Nodes(machine, bearings)
    title = _plain(machine.title) or "A machine"
    parts = [
        f'"""{title}: rotors for ROSS, written by Rolamento {rolamento.__version__}.\n\n'
        "z is along the shaft: x, y, z here are y, z, x there, so that turning about +z here is\n"
        "turning about +x there. SI units. `python FILE` prints natural frequencies.\n"
        '"""\n\n',
        _said_of(bearings, "#"),
        "import ross as rs\n\n",
        'axis = "speed" if int(rs.__version__.partition(".")[0]) > 2 else "frequency"\n',
        f"speed = {_first_speed(machine, nodes.rotors)!r}  # rad/s\n",
    ]
    materials = list(dict.fromkeys(shaft.material for shaft in machine.shafts))
    for number, one in enumerate(materials):
        parts.append(
            f'material_{number} = rs.Material("material_{number}", rho={one.density!r}, '
            f"E={one.youngs_modulus!r}, Poisson={one.poisson_ratio!r}){_comment(one.name)}\n"
        )
    parts.append("\nrotors = []\n")
    for rotor in nodes.rotors:
        parts += _rotor(rotor, nodes, bearings, materials, damping)
    parts.append(_ENDING.format(frequencies=_list(() if frequencies is None else frequencies)))
    return "".join(parts)


_ENDING: Final = """
# By Rolamento, of the whole machine at this speed, with what is left out above; rad/s.
natural_frequencies = {frequencies}

if __name__ == "__main__":
    for rotor in rotors:
        modes = rotor.run_modal(speed=speed, num_modes=24)
        found = sorted(one for one in modes.wd if one > 1.0)
        print("ROSS      ", " ".join(f"{{one:.6g}}" for one in found[:8]), "rad/s")
    print("Rolamento ", " ".join(f"{{one:.6g}}" for one in natural_frequencies), "rad/s")
"""


def _first_speed(machine: Machine, rotors: Sequence[Sequence[str]]) -> float:
    factor = machine.spectrum[0].speed_factor if machine.spectrum else 1.0
    speeds = [abs(machine.speed(name, factor)) for rotor in rotors for name in rotor]
    return next((one for one in speeds if one), 0.0)


def _rotor(
    rotor: Sequence[str],
    nodes: _Nodes,
    bearings: Sequence[RossBearing],
    materials: Sequence[Any],
    damping: float,
) -> Iterator[str]:
    machine = nodes.machine
    yield f"\n# --- {_plain(', '.join(rotor))} ---\n\nshafts = []\n"
    for name in rotor:
        beam = nodes.beams[name]
        e = beam.elements
        columns = (e.length, e.left_bore, e.left_diameter, e.right_bore, e.right_diameter)
        yield f"elements = [  # {_plain(name)}: L, then bore and diameter left and right; m\n"
        for row in zip(*(column.tolist() for column in columns), strict=True):
            yield f"    ({', '.join(repr(one) for one in row)}),\n"
        number = materials.index(beam.shaft.material)
        yield (
            "]\nshafts.append([\n"
            "    rs.ShaftElement(L=L, idl=idl, odl=odl, idr=idr, odr=odr, material=material_"
            f"{number})\n    for L, idl, odl, idr, odr in elements\n])\n"
        )
    yield "disks = [\n"
    for mass in machine.masses:
        if mass.shaft in rotor:
            own = mass.inertia
            node = nodes.at(mass.shaft, mass.position)
            yield (
                f"    rs.DiskElement(n={node}, m={own.mass!r}, Id={own.transverse!r}, "
                f"Ip={own.polar!r}),{_comment(mass.name)}\n"
            )
    yield "]\nbearings = [\n"
    for one in bearings:
        if one.shaft in rotor:
            link = nodes.link(one)
            yield from _element(nodes.at(one.shaft, one.position), link, one, damping)
    for index, spring in enumerate(machine.springs):
        if spring.shaft in rotor:
            yield from _spring(spring, index, nodes, damping)
    yield "]\n"
    yield "unbalances = [  # node, kg m, phase from x toward y in rad\n"
    for mass in machine.masses:
        if mass.shaft in rotor and mass.unbalance:
            phase = 0.5 * math.pi - mass.unbalance_azimuth
            yield f"    ({nodes.at(mass.shaft, mass.position)}, {mass.unbalance!r}, {phase!r}),\n"
    yield "]\n"
    made = "Rotor(shafts[0], disks, bearings)"
    if len(rotor) > 1:  # ROSS turns all of them at one speed
        made = "CoAxialRotor(shafts, disks, bearings)"
    yield f"rotors.append(rs.{made})\n"


def _element(node: int, link: int | None, one: RossBearing, damping: float) -> Iterator[str]:
    linked = "" if link is None else f", n_link={link}"
    yield f"    rs.BearingElement(\n        n={node}{linked}, tag={one.name!r},\n"
    for key, values in one.keywords(damping).items():
        if key[1:] in ("xx", "yy") or any(values):
            yield f"        {key}={_list(values)},\n"
    yield f"        **{{axis: {_list(one.speed)}}},\n    ),\n"


def _spring(spring: Spring, index: int, nodes: _Nodes, damping: float) -> Iterator[str]:
    k = spring.stiffness_matrix
    ours = [_FROM_OURS[axis] for axis in "xyz"]
    own = k[np.ix_(ours, ours)]
    table = {
        letter + pair: [float(factor * own["xyz".index(pair[0]), "xyz".index(pair[1])])]
        for letter, factor in (("k", 1.0), ("c", damping))
        for pair in _KEPT
    }
    link = None
    if spring.to_shaft is not None and spring.to_position is not None:
        link = nodes.at(spring.to_shaft, spring.to_position)
    node = nodes.at(spring.shaft, spring.position)
    linked = "" if link is None else f", n_link={link}"
    values = ", ".join(f"{key}={one[0]!r}" for key, one in table.items())
    yield f"    rs.BearingElement(n={node}{linked}, tag={spring.name or f'spring {index + 1}'!r}, "
    yield f"{values}),\n"


def _comment(text: str) -> str:
    return f"  # {_plain(text)}" if text else ""


def _list(values: Any) -> str:
    return "[" + ", ".join(repr(float(one)) for one in values) + "]"
