"""Run what the tutorials show, and write or compare their outputs and pictures.

    python scripts/guides.py [PAGE…]            run the pages, write outputs and pictures anew
    python scripts/guides.py --check [PAGE…]    name what differs from what is written

A page runs from top to bottom in an empty folder, as a reader copies it. Of its fenced blocks

    toml    whose first line is `# NAME.toml` is written to that file,
    sh      is a list of `rolamento` commands; `# exit 1` before one says how it ends,
    python  runs in one namespace a page,
    text    behind one of these two is what it prints: whole, or runs of lines between `…`. Empty
            it is filled in; `> TITLE` lines are, with the paragraphs that begin so.

A picture `pictures/NAME` is one that a block wrote as NAME. A number with a unit in the prose has
to stand in an output or a block of the page, rounded or not, or in its comment `<!-- known: … -->`,
which lists what is general knowledge.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import os
import re
import shlex
import sys
import tempfile
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final
from unittest import mock

import numpy as np
from PIL import Image

from rolamento.cli.app import run as rolamento

ROOT: Final = Path(__file__).parents[1]
DOCS: Final = ROOT / "docs"
PAGES: Final = (
    DOCS / "start.md",
    *(
        DOCS / "tutorials" / f"{name}.md"
        for name in (
            "spindle",
            "spindle-heat",
            "gearbox",
            "maintenance",
            "test-engineer",
            "researcher",
            "motor-bearing",
        )
    ),
    DOCS / "faq.md",
    DOCS / "shafts.md",
    DOCS / "exchange.md",
    DOCS / "exchange-simulation.md",
    DOCS / "heat.md",
    DOCS / "static-safety.md",
    DOCS / "electrical.md",
    DOCS / "oscillation.md",
    DOCS / "grease.md",
    DOCS / "service-life.md",
    DOCS / "start.pt-BR.md",
    DOCS / "tutorials" / "maintenance.pt-BR.md",
)
_LOCALES: Final = {".pt-BR": "pt_BR.UTF-8"}
"""Of a page in another language, by the end of its name."""
DIFFERENT: Final = 8.0
"""Root mean square of the difference of two pictures, in shades of 256, that is one in content."""

_BLOCK: Final = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_PICTURE: Final = re.compile(r"!\[[^\]]*\]\(([^)\s]*pictures/([^)\s]+))\)")
_NUMBER: Final = re.compile(r"\d+(?:\.\d+)?(?:e[+-]?\d+)?")
_BARS: Final = re.compile(r"[█▉▊▋▌▍▎▏─⠀-⣿]+")
_WAY: Final = re.compile(r"residual \S+|resíduo \S+|in \d+ iterations|em \d+ iterações")
"""How a solver got there, which plain Python and compiled kernels do differently."""
_GAP: Final = "…"
_UNITS: Final = (
    r"N/µm|N·m|N·mm|µm|mm|nm|kN|N|MPa|GPa|rpm|h|W|Hz|kHz|%|°C|K|°|mrad|mm²/s|µs|ms|times|dB|"
    r"bearings?|failures?|cases"
)
_QUANTITY: Final = re.compile(rf"(?<![\w.])(\d[\d ]*(?:\.\d+)?) ?(?:{_UNITS})(?![\w/²])")
_KNOWN: Final = re.compile(r"<!-- known: (.*?) -->", re.DOTALL)


class DriftError(Exception):
    """A page shows what the program does not print, or a block does not run."""


@dataclass
class Page:
    """A page that is being run.

    Attributes
    ----------
    path
        Of the Markdown.
    text
        With the outputs as they are, once it has run.
    printed
        By all blocks, in full.
    """

    path: Path
    text: str
    printed: list[str] = field(default_factory=list)


def run(path: Path, *, outputs: int | None = None, strict: bool = True) -> Page:
    """Run a page in the current folder.

    Parameters
    ----------
    outputs
        How many of them to come to; all by default.
    strict
        Compare the outputs with those that are written; otherwise replace them.

    Raises
    ------
    DriftError
        If a block fails, or prints something else.
    """
    source = path.read_text(encoding="utf-8")
    page = Page(path, source)
    names: dict[str, Any] = {"__name__": "__main__"}
    printed: str | None = None
    pieces, end, seen = [], 0, 0
    for found in _BLOCK.finditer(source):
        if outputs is not None and seen >= outputs:
            break
        kind, body = found.groups()
        where = f"{path.name}:{source.count(chr(10), 0, found.start()) + 1}"
        if kind == "text" and printed is not None:
            shown = compared(body, printed, where) if strict else renewed(body, printed, where)
            pieces += [source[end : found.start(2)], shown]
            end = found.end(2)
            seen += 1
            printed = None
        elif kind in ("sh", "python"):
            try:
                printed = (
                    "".join(commands(body, locale_of(path)))
                    if kind == "sh"
                    else script(body, names)
                )
            except Exception as error:
                raise DriftError(f"{where}: {type(error).__name__}: {error}") from error
            page.printed.append(printed)
        elif kind == "toml" and (file := re.match(r"# ([\w-]+\.toml)\n", body)):
            Path(file[1]).write_text(body, encoding="utf-8")
    page.text = "".join([*pieces, source[end:]])
    return page


def locale_of(path: Path) -> str:
    """Return the locale that the commands of a page run in."""
    return _LOCALES.get(Path(path.stem).suffix, "C.UTF-8")


def commands(block: str, locale: str = "C.UTF-8") -> Iterator[str]:
    """Run the commands of a block, and return what each prints."""
    expected = 0
    for line in block.replace("\\\n", " ").splitlines():
        if ending := re.fullmatch(r"# exit (\d)", line.strip()):
            expected = int(ending[1])
        words = shlex.split(line, comments=True)
        if not words:
            continue
        if words[0] != "rolamento":
            raise ValueError(f"a command that is none of rolamento: {line}")
        code, printed = command(words[1:], locale)
        if code != expected:
            raise ValueError(f"exit code {code}, not {expected}: {line}\n{printed}")
        expected = 0
        yield printed


def command(words: Sequence[str], locale: str = "C.UTF-8") -> tuple[int, str]:
    """Run a command, and return its exit code and what it prints at 80 columns."""
    output = io.TextIOWrapper(io.BytesIO(), encoding="utf-8", newline="\n")
    code = 0
    with (
        mock.patch.dict(os.environ, {"LC_ALL": locale, "COLUMNS": "80"}),
        mock.patch.object(sys, "argv", ["rolamento", *words]),
        contextlib.redirect_stdout(output),
        contextlib.redirect_stderr(output),
    ):
        try:
            rolamento()
        except SystemExit as end:
            code = end.code if isinstance(end.code, int) else 1
    output.flush()
    return code, output.buffer.getvalue().decode("utf-8")  # type: ignore[attr-defined]


def script(block: str, names: dict[str, Any]) -> str:
    """Run a block of Python, and return what it prints."""
    output = io.StringIO()
    with contextlib.redirect_stdout(output), warnings.catch_warnings():
        exec(compile(block, "block", "exec"), names)
    return output.getvalue()


# --- outputs ------------------------------------------------------------------------------------


def compared(shown: str, printed: str, where: str) -> str:
    """Return what is shown, if it is what is printed.

    Raises
    ------
    DriftError
        If a line is missing, or a number is off by more than one in its last digit.
    """
    for one, other in zip(_runs(shown), _found(shown, printed, where), strict=True):
        for written, new in zip(one, other, strict=True):
            if not _same_numbers(written, new):
                raise DriftError(f"{where}:\n  shown   {written}\n  printed {new}")
    return shown


def renewed(shown: str, printed: str, where: str) -> str:
    """Return what is shown, with the lines as they are printed; all of them if it is empty."""
    if not shown.strip():
        return "\n".join(line.rstrip() for line in printed.strip("\n").splitlines()) + "\n"
    if shown.startswith("> "):
        return _excerpt(shown, printed, where)
    fresh = iter([line for run in _found(shown, printed, where) for line in run])
    lines = [line if line.strip() == _GAP else next(fresh).rstrip() for line in shown.splitlines()]
    return "\n".join(lines) + "\n"


def _excerpt(wishes: str, printed: str, where: str) -> str:
    """Return the paragraphs that begin as the wishes say, `> TITLE` or `> TITLE | LINES`."""
    lines = [line.rstrip() for line in printed.strip("\n").splitlines()]
    pieces, end = [], 0
    for wish in wishes.splitlines():
        title, _, most = wish.removeprefix("> ").partition(" | ")
        places = [at for at in range(end, len(lines)) if lines[at].lstrip().startswith(title)]
        if not places:
            titles = ", ".join(line for line in lines if line and not line.startswith(" "))
            raise DriftError(f"{where}: no line begins with {title!r}, but: {titles}")
        first = places[0]
        last = next((at for at in range(first, len(lines)) if not lines[at]), len(lines))
        last = min(last, first + int(most or last))
        pieces += ([_GAP] if any(lines[end:first]) else [""]) if end else []
        pieces += lines[first:last]
        end = last
    return "\n".join([*pieces, *([_GAP] if any(lines[end:]) else [])]) + "\n"


def _runs(shown: str) -> list[list[str]]:
    runs: list[list[str]] = [[]]
    for line in shown.splitlines():
        if line.strip() == _GAP:
            runs.append([])
        else:
            runs[-1].append(line)
    return [run for run in runs if run]


def _found(shown: str, printed: str, where: str) -> list[list[str]]:
    """Return, for each run of lines shown, those printed that are alike, one run after another."""
    lines = printed.splitlines()
    shapes = [_shape(line) for line in lines]
    start, found = 0, []
    for wanted in _runs(shown):
        alike = [_shape(line) for line in wanted]
        places = range(start, len(lines) - len(alike) + 1)
        fits = [at for at in places if shapes[at : at + len(alike)] == alike]
        if not fits:
            told = "\n".join(wanted)
            raise DriftError(
                f"{where}: is not printed, or not in this order:\n{told}\n---\n{printed}"
            )
        # where several runs look alike, the one with the numbers shown, else the first
        same = [at for at in fits if all(map(_same_numbers, wanted, lines[at:]))]
        at = (same or fits)[0]
        found.append(lines[at : at + len(alike)])
        start = at + len(alike)
    return found


def _shape(line: str) -> str:
    """Return a line without its numbers, bars and spaces."""
    return re.sub(r"[\s#−-]+", "#", _NUMBER.sub("#", _BARS.sub("", line))).strip("#")


def _same_numbers(shown: str, printed: str) -> bool:
    numbers = (_NUMBER.findall(_WAY.sub("", line)) for line in (shown, printed))
    pairs = zip(*numbers, strict=False)
    return all(abs(float(one) - float(other)) <= 1.01 * _step(one) for one, other in pairs)


def _step(number: str) -> float:
    mantissa, _, exponent = number.partition("e")
    return 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


# --- prose and pictures -------------------------------------------------------------------------


def unfounded(page: Page) -> list[str]:
    """Return the quantities in the prose of a page that nothing on it prints or gives."""
    known = {_joined(text) for text in " ".join(_KNOWN.findall(page.text)).split(", ")}
    prose = _KNOWN.sub("", _BLOCK.sub("", page.text))
    prose = re.sub(r"`[^`]*`|\]\([^)]*\)|^#.*$", "", prose, flags=re.MULTILINE)
    given = "\n".join([*page.printed, *(body for _, body in _BLOCK.findall(page.text))])
    if locale_of(page.path) != "C.UTF-8":  # decimal commas
        prose, given = (re.sub(r"(?<=\d),(?=\d)", ".", text) for text in (prose, given))
    numbers = {
        float(_joined(text)) for text in re.findall(r"\d{1,3}(?: \d{3})+|\d+(?:\.\d+)?", given)
    } | {float(text) for text in re.findall(r"\d+(?:\.\d+)?", given)}
    return [
        found[0]
        for found in _QUANTITY.finditer(prose.replace("\n", " "))
        if _joined(found[0]) not in known and not _among(found, numbers)
    ]


def _joined(text: str) -> str:
    return "".join(text.split())


def _among(quantity: re.Match[str], numbers: set[float]) -> bool:
    """Whether a quantity is one of the numbers, rounded to its figures; GPa and kN of MPa and N."""
    digits = _joined(quantity[1])
    value, half = float(digits), 0.5001 * _step(digits)
    factors = (1.0, 1e-3) if re.search(r"GPa|kN|kHz$", quantity[0]) else (1.0,)
    return any(abs(factor * one - value) <= half for one in numbers for factor in factors)


def pictures(page: Page) -> Iterator[tuple[Path, Path]]:
    """Return the pictures of a page: where they stand, and where they were written just now."""
    for link, name in _PICTURE.findall(page.text):
        if not Path(name).is_file():
            raise DriftError(f"{page.path.name}: no block writes {name}")
        yield page.path.parent / link, Path(name)


def other_picture(committed: Path, fresh: Path) -> bool:
    """Whether two pictures differ in content, not in the edges of their letters."""
    if not committed.is_file():
        return True
    one, other = (np.asarray(Image.open(path).convert("RGB"), float) for path in (committed, fresh))
    return one.shape != other.shape or bool(np.sqrt(np.mean((one - other) ** 2)) > DIFFERENT)


def keep_picture(fresh: Path, committed: Path) -> None:
    """Write a picture in few colours, which makes a third of the file."""
    committed.parent.mkdir(exist_ok=True)
    few = Image.open(fresh).convert("RGB").quantize(96, dither=Image.Dither.NONE)
    few.save(committed, optimize=True)


# --- the command --------------------------------------------------------------------------------


def main() -> int:
    """Run the pages that are named; 1 if one has drifted."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pages", nargs="*", type=Path, default=PAGES)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    drifted = 0
    for path in options.pages:
        path = path.resolve()
        with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
            try:
                page = run(path, strict=options.check)
                told = [f"{path.name}: nothing prints {text}" for text in unfounded(page)]
                for committed, fresh in pictures(page):
                    differs = other_picture(committed, fresh)
                    if differs and options.check:
                        told.append(f"{path.name}: another picture: {committed.name}")
                    elif differs:
                        keep_picture(fresh, committed)
            except DriftError as drift:
                told = [str(drift)]
            else:
                if not options.check:
                    path.write_text(page.text, encoding="utf-8")
        print("\n".join(told) or f"{path.name}: as it runs")
        drifted += bool(told)
    return min(drifted, 1)


if __name__ == "__main__":
    sys.exit(main())
