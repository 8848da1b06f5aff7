"""Golden numbers: what the commands answered, to full precision, and whether they still do.

    python -m tests.regression.golden                write all answers anew
    python -m tests.regression.golden --check        compare all with what is written
    python -m tests.regression.golden NAME… [--check]    some of them
    … --check --elsewhere                            on another processor than wrote them

A run is one line of `runs.toml`, or several that hand files to each other. Each runs in an empty
folder that holds the shipped examples and `cases`; what it writes to files named `out` is read.
Kept are numbers, truths and words; prose, versions and inputs are not, nor how a solver got there.
"""

from __future__ import annotations

import argparse
import contextlib
import csv
import io
import json
import math
import re
import shlex
import shutil
import sys
import tempfile
import time
import tomllib
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, Final
from unittest import mock

import numpy as np
import xarray as xr

import rolamento
from rolamento.cli.app import run

__all__ = [
    "RUNS",
    "answer",
    "differences",
    "kept",
    "load_kernels",
    "main_golden",
    "page",
    "spread",
]

HERE: Final = Path(__file__).parent
GOLDEN: Final = HERE / "golden"
TOLERANCE: Final = 1e-12
"""Of the scale of a number: the greatest of its family (`_family`)."""
ELSEWHERE: Final = 1e-9
"""The same on whatever processor: compilers and libraries choose other instructions there."""

_LEFT_OUT: Final = frozenset(  # what was given and said, how it was solved, `computed - printed`
    {"case", "title", "schema", "version", "residual", "imbalance", "iterations", "difference",
     "notes", "reading_notes", "advice", "statement", "reasons", "doubts", "explanation"}
)  # fmt: skip
_KEYED: Final = frozenset({"reason", "reasons", "warnings"})
"""Whose notes are kept, by their keys."""
_OF_CONTACT: Final = frozenset({"contact_angle", "spin", "roll", "spin_to_roll"})
_LONGEST_SERIES: Final = 48
_LONGEST_TABLE: Final = 24
_NAMES: Final = frozenset({"name", "quantity", "unit", "method", "change"})
_OUTPUT: Final = re.compile(r"out\w*\.\w+")
_PROSE: Final = re.compile(r"[\s/\\]")

RUNS: Final[dict[str, tuple[str, ...]]] = {
    name: (lines,) if isinstance(lines, str) else tuple(lines)
    for name, lines in tomllib.loads((HERE / "runs.toml").read_text(encoding="utf-8")).items()
}
"""The command lines by the name of the run. One without an output of its own writes `out.json`."""


def spread(every: int) -> list[str]:
    """Return the first run of each command and each n-th after it."""
    by_command: dict[str, list[str]] = {}
    for name, lines in RUNS.items():
        by_command.setdefault(lines[-1].split()[0], []).append(name)
    return [name for names in by_command.values() for name in names[::every]]


# --- running ------------------------------------------------------------------------------------


_LOADS: Final = ("study_axes", "study_set", "study_friction", "study_rollers")


def load_kernels() -> None:
    """Load the compiled kernels: few cases alone run as plain Python, whose last digits differ."""
    for study in _LOADS:
        _outputs((f"sweep {study}.toml -o out.nc",))


def answer(name: str) -> dict[str, Any]:
    """Run one of `RUNS` and return what is kept: exit codes, and the content of its files."""
    return _outputs(RUNS[name])


def page(name: str, language: str) -> str:
    """Run one of `RUNS` for a person and return what it shows."""
    with _folder():
        return "".join(_run([*_for_a_person(line), "--lang", language])[1] for line in RUNS[name])


def _for_a_person(line: str) -> list[str]:
    """Return the words of a command line without the data that it writes."""
    words = shlex.split(line)
    if "--json" in words:
        place = words.index("--json")
        del words[place : place + 2]
    return words


def _outputs(lines: Sequence[str]) -> dict[str, Any]:
    with _folder():
        codes = [_exit_code(line) for line in lines]
        files = {path.name: _read(path) for path in sorted(Path().glob("out*.*"))}
    return {"exit": codes, **files}


@contextlib.contextmanager
def _folder() -> Iterator[None]:
    """Work in a folder that holds the shipped examples and `cases`."""
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        for source in (Path(rolamento.__file__).parent / "examples", HERE / "cases"):
            shutil.copytree(source, folder, dirs_exist_ok=True)
        yield


def _exit_code(line: str) -> int:
    """Run a command line for its data."""
    words = shlex.split(line)
    if not any(map(_OUTPUT.fullmatch, words)):
        words += ["--json", "out.json"]
    return _run(words)[0]


def _run(words: Sequence[str]) -> tuple[int, str]:
    """Run a command line in this process, through the entry point of the program."""
    said = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
    with (
        mock.patch.object(sys, "argv", ["rolamento", *words]),
        mock.patch.dict("os.environ", {"LC_ALL": "C.UTF-8", "ROLAMENTO_COMPILE": "here"}),
        contextlib.redirect_stdout(said),
        contextlib.redirect_stderr(said),
    ):
        try:
            run()
        except SystemExit as end:
            code = int(end.code or 0)
    said.flush()
    text = said.buffer.getvalue().decode()  # type: ignore[attr-defined]
    if code > 1:  # wrong input: the run itself is wrong
        raise RuntimeError(f"{shlex.join(words)}: exit code {code}\n{text}")
    return code, text


def _read(path: Path) -> Any:
    if path.suffix == ".json":
        return kept(json.loads(path.read_text(encoding="utf-8")))
    if path.suffix == ".csv":
        lines = path.read_text(encoding="utf-8").splitlines()
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        return kept({head: [_cell(row[head]) for row in rows] for head in (rows or [{}])[0]})
    if path.suffix == ".nc":
        with xr.open_dataset(path) as data:
            return kept({str(name): data[name].values.tolist() for name in data.variables})
    if path.suffix == ".npz":
        with np.load(path) as arrays:
            return kept({name: arrays[name].tolist() for name in arrays.files})
    raise ValueError(f"{path.name}: no reader")


def _cell(text: str) -> float | str | None:
    try:
        return float(text) if text else None
    except ValueError:
        return text


# --- what is kept -------------------------------------------------------------------------------


def kept(value: Any) -> Any:
    """Return numbers, truths and words; long lists thinned, with mean and root mean square."""
    if isinstance(value, dict):
        if _is_note(value):
            return value["key"]
        return {
            name: kept(part)
            for name, part in _with_parts(value).items()
            if name not in _LEFT_OUT and not _is_prose(part)
            if name in _KEYED or not _is_note(part)
        }
    if isinstance(value, list):
        parts = [kept(part) for part in value if not _is_prose(part)]
        longest = _LONGEST_TABLE if parts and isinstance(parts[0], dict) else _LONGEST_SERIES
        return parts if len(parts) <= longest else _thinned(parts, longest)
    return None if isinstance(value, float) and math.isnan(value) else value


def _with_parts(value: dict[str, Any]) -> dict[str, Any]:
    """Leave rounding out: phases of an amplitude of nothing, motion where nothing bears."""
    if value.get("load") == 0.0 and "contact_angle" in value:
        return {name: part for name, part in value.items() if name not in _OF_CONTACT}
    if not {"amplitude", "phase"} <= value.keys():
        return value
    others = {name: part for name, part in value.items() if name != "phase"}
    amplitude, phase = (np.array(value[name], float) for name in ("amplitude", "phase"))
    waves = {"cosine": amplitude * np.cos(phase), "sine": amplitude * np.sin(phase)}
    return others | {name: part.tolist() for name, part in waves.items()}


def _is_note(value: Any) -> bool:
    return isinstance(value, dict) and value.keys() == {"key", "text", "values"}


def _is_prose(value: Any) -> bool:
    return isinstance(value, str) and bool(_PROSE.search(value))


def _thinned(parts: list[Any], longest: int) -> dict[str, Any]:
    step = -(-len(parts) // longest)
    thin: dict[str, Any] = {"#count": len(parts), "#every": step, "#items": parts[::step]}
    numbers = [part for part in parts if type(part) in (int, float) and math.isfinite(part)]
    if numbers:
        thin["#mean"] = math.fsum(numbers) / len(numbers)
        thin["#rms"] = math.hypot(*numbers) / math.sqrt(len(numbers))
    return thin


# --- comparing ----------------------------------------------------------------------------------


def differences(golden: Any, now: Any, tolerance: float = TOLERANCE) -> list[str]:
    """Return what differs, by its path: numbers by more than the tolerance of their scale."""
    expected, found = dict(_leaves(golden)), dict(_leaves(now))
    scales = _scales(expected)
    told = [f"{path}: is gone" for path in expected if path not in found]
    told += [f"{path}: is new" for path in found if path not in expected]
    for path, value in expected.items():
        if path not in found or found[path] == value:
            continue
        other, family = found[path], _family(path)
        if not (_is_finite(value) and _is_finite(other)):
            told.append(f"{path}: {value!r} is now {other!r}")
        elif abs(other - value) > max(_tolerance(family), tolerance) * scales[family]:
            off = f"{abs(other - value):.1e} of {scales[family]:.6g}"
            told.append(f"{path}: {value!r} is now {other!r}, off by {off}")
    return told


def _scales(leaves: dict[str, Any]) -> dict[str, float]:
    """Return the greatest magnitude of each family, or its floor."""
    scales: dict[str, float] = {}
    for path, value in leaves.items():
        if _is_finite(value):
            family = _family(path)
            scales[family] = max(scales.get(family) or _floor(family), abs(value))
    return scales


def _floor(family: str) -> float:
    return next((floor for pattern, floor in _FLOORS if pattern.search(family)), 0.0)


def _tolerance(family: str) -> float:
    return next((loose for pattern, loose in _LOOSE if pattern.search(family)), TOLERANCE)


def _leaves(value: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    if isinstance(value, dict) and value:
        for name, part in value.items():
            yield from _leaves(part, f"{path}.{name}" if path else name)
    elif isinstance(value, list) and value:
        for index, part in enumerate(value):
            named = isinstance(part, dict) and not _NAMES.isdisjoint(part)
            yield from _leaves(part, f"{path}<{index}>" if named else f"{path}[{index}]")
    else:
        yield path, "[]" if value == [] else "{}" if value == {} else value


def _is_finite(value: Any) -> bool:
    number = isinstance(value, int | float) and not isinstance(value, bool)
    return number and math.isfinite(value)


_FLOORS: Final = (  # the least scale, in SI units, of what is nothing but rounding in some cases
    (re.compile(r"displacement\.[tr]$"), 1e-6),
    (re.compile(r"contact_angle|attitude|yaw|spin_to_roll|rollers\.tilt"), 1e-3),
    (re.compile(r"stiffness_[tr]r"), 1.0),
    (re.compile(r"load\.m$|force_across$"), 1.0),
    (re.compile(r"gyroscopic_moment|race\.spin$"), 1e-3),
    (re.compile(r"(parts|heat|torque_by_source)\.spin"), 1e-6),
)
_LOOSE: Final = (  # where a maximum lies is known to the square root of the last digit
    (re.compile(r"value_shear_depth"), 3e-7),
    (re.compile(r"wear\."), 1e-7),  # so is where a sum of squares is least
    # a line between two multiples of the load, 1e-6 apart
    (re.compile(r"lift_factor|loss_factor|evidence"), 1e-8),
)
_KIN: Final = (  # what is of one kind and size, so that rounding near zero is not told
    (re.compile(r"stiffness\[([0-2])\]\[([0-2])\]"), "stiffness_tt"),
    (re.compile(r"stiffness\[([0-2])\]\[([34])\]|stiffness\[([34])\]\[([0-2])\]"), "stiffness_tr"),
    (re.compile(r"stiffness\[([34])\]\[([34])\]"), "stiffness_rr"),
    (re.compile(r"\[\d+\]"), ""),
    (re.compile(r"\.#\w+"), ""),
    (re.compile(r"\.(amplitude|cosine|sine|peak_to_peak|mean)(?![a-z_])"), ".wave"),
    (re.compile(r"(?<![a-z])(min|mean|max|minimum|maximum)(?![a-z])"), "value"),
    (re.compile(r"(?<![a-z])(inner|outer)(?![a-z])"), "race"),
    (re.compile(r"(?<![a-z])[xyz](?![a-z])"), "t"),
    (re.compile(r"(?<![a-z])r[yz](?![a-z])"), "r"),
    (re.compile(r"(?<![a-z])f[xyz](?![a-z])"), "f"),
    (re.compile(r"(?<![a-z])m[yz](?![a-z])"), "m"),
    (re.compile(r"(?<=stiffness_)[xyz]{2}(?![a-z])"), "tt"),
    (re.compile(r"(?<=stiffness_)([xyz]r[yz]|r[yz][xyz])(?![a-z])"), "tr"),
    (re.compile(r"(?<=stiffness_)r[yz]r[yz](?![a-z])"), "rr"),
)


def _family(path: str) -> str:
    """Return what numbers of one scale have in common: the path without index, axis and race.

    Items that carry a name, such as the checks of a source, are of many units: `<i>` stays.
    """
    for pattern, name in _KIN:
        path = pattern.sub(name, path)
    return path


# --- the command --------------------------------------------------------------------------------


def main_golden(arguments: Sequence[str] | None = None) -> int:
    """Write or check golden numbers; the exit code is 1 if any differ."""
    parser = argparse.ArgumentParser(prog="python -m tests.regression.golden")
    parser.add_argument("names", nargs="*", metavar="NAME", help="of runs.toml; all by default")
    parser.add_argument("--check", action="store_true", help="compare instead of writing")
    parser.add_argument("--elsewhere", action="store_true", help="the processor is another one")
    parser.add_argument("--times", action="store_true", help="tell how long each run takes")
    options = parser.parse_args(arguments)
    if unknown := [name for name in options.names if name not in RUNS]:
        parser.error(f"no such run: {', '.join(unknown)}")
    names = options.names or list(RUNS)
    load_kernels()
    wrong = 0
    for name in names:
        began = time.perf_counter()
        now = answer(name)
        if options.check:
            told = differences(_load(name), now, ELSEWHERE if options.elsewhere else TOLERANCE)
            wrong += bool(told)
            for line in told[:8]:
                print(f"{name}: {line}")
            if len(told) > 8:
                print(f"{name}: and {len(told) - 8} more")
        else:
            _save(name, now)
        if options.times:
            print(f"{name}: {time.perf_counter() - began:.2f} s")
    if options.check:
        print(f"{len(names) - wrong} of {len(names)} runs as they were")
    elif not options.names:
        for path in GOLDEN.glob("*.json"):
            if path.stem not in RUNS:
                path.unlink()
    return int(wrong > 0)


def _path(name: str) -> Path:
    return GOLDEN / f"{name}.json"


def _load(name: str) -> Any:
    return kept(json.loads(_path(name).read_text(encoding="utf-8")))


def _save(name: str, value: Any) -> None:
    GOLDEN.mkdir(exist_ok=True)
    text = json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    _path(name).write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main_golden())
