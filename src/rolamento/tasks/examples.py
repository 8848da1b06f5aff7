"""The examples that are shipped: what each shows, and a command to try on it."""

from __future__ import annotations

import os
from dataclasses import replace
from importlib import resources
from importlib.resources.abc import Traversable
from typing import Final

from rolamento.errors import FileError, InputError, cause, guess
from rolamento.io.writing import write_text
from rolamento.records import frozen
from rolamento.words import marked, said

__all__ = ["EXAMPLES", "TITLES", "Example", "copy_examples"]

_PACKAGE: Final = resources.files("rolamento")
_FOLDER: Final = "examples/"
_ALL: Final = "all"


@frozen
class Example:
    """An example.

    Attributes
    ----------
    shows
        What it shows, marked.
    command
        What to try on it; files are written as they are named in `files`.
    files
        Its files, below the folder that it is copied to; a study lies in a folder of its own,
        beside that of its case.
    sources
        Of files that lie elsewhere in the package, where.
    """

    shows: str
    command: str
    files: tuple[str, ...]
    sources: tuple[tuple[str, str], ...] = ()

    def source(self, file: str) -> Traversable:
        """Return where the package has a file."""
        return _PACKAGE / dict(self.sources).get(file, _FOLDER + file)


def _case(name: str, shows: str, command: str, *more: str) -> Example:
    return Example(shows, f"rolamento {command}", (f"{name}.toml", *more))


def _script(name: str, shows: str) -> Example:
    return Example(shows, f"python {name}.py", (f"{name}.py",))


def _machine(name: str, shows: str) -> Example:
    return Example(shows, f"rolamento shaft machines/{name}.toml", (f"machines/{name}.toml",))


EXAMPLES: Final = {
    "6310_motor": _case(
        "6310_motor",
        marked("electric motor, greased 6310/C3: fits, temperatures, life"),
        "life 6310_motor.toml",
    ),
    "gear_shaft": Example(
        marked("gear shaft: life of two bearings and of both together"),
        "rolamento life gear_left.toml gear_right.toml",
        ("gear_left.toml", "gear_right.toml"),
    ),
    "6305_life": _case(
        "6305_life",
        marked("gearbox bearing 6305/C3: life by every theory, and under a duty of three steps"),
        "life 6305_life.toml --spectrum 6305_steps.csv",
        "6305_steps.csv",
    ),
    "6305_film": _case(
        "6305_film",
        marked("deep-groove bearing with oil: film thickness and friction"),
        "friction 6305_film.toml --over duty.inner_speed=100..6000rpm --log",
    ),
    "209_radial": _case(
        "209_radial",
        marked("deep-groove bearing with clearance at rest: how many balls carry"),
        "turn 209_radial.toml",
    ),
    "218_combined": _case(
        "218_combined",
        marked("spindle bearing at 10 000 rpm under axial and radial load"),
        "solve 218_combined.toml",
    ),
    "218_hybrid": _case(
        "218_hybrid",
        marked("the same with balls of silicon nitride, given by their properties"),
        "report 218_combined.toml 218_hybrid.toml",
        "218_combined.toml",
    ),
    "218_tilted": _case(
        "218_tilted",
        marked("the same on a misaligned shaft: an imposed tilt"),
        "solve 218_tilted.toml",
    ),
    "6012_pair": _case(
        "6012_pair",
        marked("spindle pair back to back, with the preload of a maker's class"),
        "solve 6012_pair.toml --set 'bearing.preload={ spring = \"500 N\" }'",
    ),
    "6012_triple": _case(
        "6012_triple",
        marked("fixed side of a spindle, row by row: two in tandem against one"),
        "solve 6012_triple.toml",
    ),
    "qj210_both_ways": _case(
        "qj210_both_ways",
        marked("four-point-contact bearing that locates a shaft in both directions"),
        "solve qj210_both_ways.toml",
    ),
    "51210_turntable": _case(
        "51210_turntable",
        marked("thrust ball bearing below a turntable"),
        "solve 51210_turntable.toml --set 'duty.displacement.ry=0.02 deg'",
    ),
    "nu205_gear": _case(
        "nu205_gear",
        marked("cylindrical roller bearing of a gear shaft that bends: pressure along the rollers"),
        "solve nu205_gear.toml --report nu205_gear.html",
    ),
    "30206_pinion": _case(
        "30206_pinion",
        marked("tapered roller bearings of a pinion shaft: preload, forces of the ribs"),
        "solve 30206_pinion.toml",
    ),
    "ricci_fleury": _case(
        "ricci_fleury",
        marked("space mechanism: three balls, boundary lubrication, friction torque"),
        "friction ricci_fleury.toml --over duty.load.fx=10..200N",
    ),
    "motor": _machine("motor", marked("machine: electric motor, fixed and floating bearing")),
    "gear_unit": _machine(
        "gear_shaft", marked("machine: gear shaft on NU 308 and 6308 under a spectrum")
    ),
    "pinion": _machine(
        "pinion", marked("machine: overhung bevel pinion on tapered bearings back to back")
    ),
    "pinion_x": _machine("pinion_x", marked("machine: the same face to face")),
    "spindle": _machine(
        "spindle", marked("machine: spindle on a spring-preloaded pair and a floating bearing")
    ),
    "three_supports": _machine(
        "three_supports", marked("machine: shaft on three bearings with clearance")
    ),
    "coaxial": _machine(
        "coaxial", marked("machine: two coaxial shafts with a bearing between them")
    ),
    "6310_clearance": Example(
        marked("study: a motor bearing over temperature and clearance class"),
        "rolamento sweep studies/6310_clearance.toml",
        ("studies/6310_clearance.toml", "6310_motor.toml"),
    ),
    "218_speed": Example(
        marked("study: displacement and stiffness over axial load and speed"),
        "rolamento sweep studies/218_speed.toml",
        ("studies/218_speed.toml", "218_combined.toml"),
    ),
    "218_scatter": Example(
        marked("study: how far manufacture scatters stiffness and pressure"),
        "rolamento tolerance studies/218_scatter.toml",
        ("studies/218_scatter.toml", "218_combined.toml"),
    ),
    "nu205_misalignment": Example(
        marked("study: tilt of a cylindrical roller bearing, with several profiles of its rollers"),
        "rolamento sweep studies/nu205_misalignment.toml",
        ("studies/nu205_misalignment.toml", "nu205_gear.toml"),
    ),
    "life_test": Example(
        marked("life test of deep-groove bearings: Weibull evaluation"),
        "rolamento weibull life_test_campanha_2008.csv",
        ("life_test_campanha_2008.csv",),
        (("life_test_campanha_2008.csv", "weibull/data/campanha_2008.csv"),),
    ),
    "clearance_trend": Example(
        marked("clearance measured over a life test: law of wear"),
        "rolamento trend campanha_2008_clearance.csv",
        ("campanha_2008_clearance.csv",),
    ),
    "noise_trend": Example(
        marked("noise in anderons measured over a life test"),
        "rolamento trend campanha_2008_anderon.csv",
        ("campanha_2008_anderon.csv",),
    ),
    "preload_over_speed": _script(
        "preload_over_speed", marked("script: rigid against spring preload over speed, in Python")
    ),
    "contact_angles": _script(
        "contact_angles", marked("script: contact angles of both races over speed")
    ),
    "frequencies_under_thrust": _script(
        "frequencies_under_thrust", marked("script: how thrust moves the fault frequencies")
    ),
    "film_over_temperature": _script(
        "film_over_temperature", marked("script: κ and λ over the temperature of the oil")
    ),
    "small_samples": _script(
        "small_samples", marked("script: what six lives tell of the Weibull shape")
    ),
}
"""By name, in the order in which they are listed."""


TITLES: Final = {
    "209_radial": marked("209 deep-groove ball bearing, radial load"),
    "218_combined": marked("218 angular-contact ball bearing, combined load"),
    "218_hybrid": marked("218 hybrid bearing with silicon nitride balls, combined load"),
    "218_tilted": marked("218 angular-contact ball bearing on a misaligned shaft"),
    "30206_pinion": marked("Pinion shaft: 30206, a pair back to back"),
    "51210_turntable": marked("51210 thrust ball bearing of a turntable"),
    "6012_pair": marked("Spindle bearings S 6012 C, a pair back to back"),
    "6012_triple": marked("Spindle bearings S 6012, two in tandem against one"),
    "6305_film": marked("6305 deep-groove ball bearing with oil, radial load"),
    "6305_life": marked("6305/C3 in a gearbox, oil bath"),
    "6310_motor": marked("6310/C3 at the drive end of an electric motor"),
    "gear_left": marked("Gear shaft, left: 6308, fixed"),
    "gear_right": marked("Gear shaft, right: 6307, floating"),
    "nu205_gear": marked("Gear shaft, right: NU 205, free, tilted by 3 mrad"),
    "qj210_both_ways": marked("QJ 210 four-point-contact bearing, axial load"),
    "ricci_fleury": marked("30 × 55 mm angular-contact bearing of a space mechanism, thrust"),
    "machines/coaxial": marked("Two coaxial shafts with a bearing between them"),
    "machines/gear_shaft": marked("Gear shaft: NU 308 and 6308"),
    "machines/motor": marked("Electric motor: 6308/C3 floating, 6310/C3 at the drive end"),
    "machines/pinion": marked("Bevel pinion on 30207 and 30206, back to back (O)"),
    "machines/pinion_x": marked("Bevel pinion on 30207 and 30206, face to face (X)"),
    "machines/spindle": marked("Spindle: 7014C DB at the nose, NU 1010 at the rear"),
    "machines/three_supports": marked("Three supports, clearance in the middle"),
}
"""Titles of cases and machines, as their files have them: a page says them in its own language."""


def copy_examples(
    name: str, folder: str | os.PathLike[str] = ".", *, force: bool = False
) -> dict[str, Example]:
    """Copy an example into a folder, or all of them.

    Parameters
    ----------
    name
        Of `EXAMPLES`, with or without the ending of its file; ``"all"`` for every one.
    folder
        Is made where it is not there.
    force
        Overwrite files that are there; those that are as shipped need it not.

    Returns
    -------
    dict
        What was copied by its name; files and command say where they are now.

    Raises
    ------
    InputError, FileError
        If there is no such example, or a file is there already or cannot be written.
    """
    known = name.removesuffix(".toml").removesuffix(".csv").removesuffix(".py")
    if known not in EXAMPLES and known != _ALL:
        rule = said("is not an example; {guess}", guess=guess(known, (*EXAMPLES, _ALL)))
        raise InputError(rule, value=name, example="rolamento examples 6310_motor")
    chosen = EXAMPLES if known == _ALL else {known: EXAMPLES[known]}
    base = os.fspath(folder)
    placed = {name: _placed(example, base) for name, example in chosen.items()}
    for name, example in chosen.items():
        for file, path in zip(example.files, placed[name].files, strict=True):
            if not force and os.path.lexists(path) and not _is_as_shipped(example, file, path):
                raise FileError(said("already exists; --force overwrites it"), source=path)
    for name, example in chosen.items():
        for file, path in zip(example.files, placed[name].files, strict=True):
            _make_folder(os.path.dirname(path))
            write_text(example.source(file).read_text(encoding="utf-8"), path)
    return placed


def _placed(example: Example, folder: str) -> Example:
    """Return an example with its files in a folder."""
    paths = {file: os.path.normpath(os.path.join(folder, file)) for file in example.files}
    command = " ".join(paths.get(word, word) for word in example.command.split(" "))
    return replace(example, files=tuple(paths.values()), command=command)


def _is_as_shipped(example: Example, file: str, path: str) -> bool:
    try:
        with open(path, encoding="utf-8") as there:
            return there.read() == example.source(file).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return False


def _make_folder(path: str) -> None:
    if not path:
        return
    try:
        os.makedirs(path, exist_ok=True)
    except OSError as error:
        rule = said("cannot be made: {reason}", reason=cause(error))
        raise FileError(rule, source=path) from None
