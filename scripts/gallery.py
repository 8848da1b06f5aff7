"""The gallery: every shipped example executed, a page each with its source, output and figures.

    python scripts/gallery.py [FOLDER]      by default docs/_build/gallery

writes index.md, NAME.md and the figures as PNG into the folder. Nothing in it is typed by hand:
what an example shows and the command to try on it are those of `rolamento examples`; `FIGURES`
says what is drawn of it besides.
"""

from __future__ import annotations

import contextlib
import io
import runpy
import shlex
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Final

from PIL import Image

sys.path.insert(0, str(Path(__file__).parent))
from guides import command, keep_picture

from rolamento.tasks.examples import EXAMPLES, Example, copy_examples

ROOT: Final = Path(__file__).parents[1]
TARGET: Final = ROOT / "docs" / "_build" / "gallery"

_STATE: Final = "rolamento solve {file} --json state.json"
FIGURES: Final[dict[str, tuple[str, ...]]] = {
    "6310_motor": (
        _STATE,
        "rolamento plot state.json --kind helps -o helps.png",
        "rolamento plot state.json --kind aiso -o aiso.png",
    ),
    "gear_shaft": (_STATE, "rolamento plot state.json --kind zone -o zone.png"),
    "6305_life": (_STATE, "rolamento plot state.json --kind sn -o sn.png"),
    "6305_film": (
        "rolamento friction 6305_film.toml --over duty.inner_speed=100..6000rpm --log "
        "--plot friction.png",
    ),
    "209_radial": (_STATE, "rolamento plot state.json -o rosette.png"),
    "218_combined": (
        _STATE,
        "rolamento plot state.json --kind angles -o angles.png",
        "rolamento plot state.json --kind ellipses -o ellipses.png",
    ),
    "218_hybrid": (
        _STATE,
        "rolamento plot state.json --kind pressures -o pressures.png "
        "--variant ceramic: --variant steel:bearing.ball_material=100Cr6",
    ),
    "218_tilted": (
        _STATE,
        'rolamento plot state.json --kind balls -o balls.png --variant "0.05 deg:" '
        '--variant "upright:duty.displacement.ry=0 deg"',
    ),
    "6012_pair": (
        _STATE,
        "rolamento plot state.json --kind balls -o balls.png --variant clamped: "
        "--variant 'spring:bearing.preload={ spring = \"500 N\" }'",
    ),
    "6012_triple": (_STATE, "rolamento plot state.json --kind balls -o balls.png"),
    **dict.fromkeys(
        ("motor", "gear_unit", "pinion_x", "spindle", "three_supports", "coaxial"),
        ("rolamento shaft {file} --plot machine.png",),
    ),
    "pinion": (
        "rolamento shaft {file} --plot machine.png",
        "rolamento shaft {file} --over 'bearings.pinion side.preload=0..3kN' --plot preload.png",
    ),
    "qj210_both_ways": (_STATE, "rolamento plot state.json --kind angles -o angles.png"),
    "51210_turntable": (
        _STATE,
        'rolamento plot state.json --kind balls -o balls.png --variant "level:" '
        '--variant "tilted:duty.displacement.ry=0.02 deg"',
    ),
    "nu205_gear": (
        _STATE,
        "rolamento plot state.json --kind along -o along.png",
        "rolamento plot state.json --kind between -o between.png",
    ),
    "30206_pinion": (_STATE, "rolamento plot state.json --kind balls -o balls.png"),
    "ricci_fleury": (
        "rolamento friction ricci_fleury.toml --over duty.load.fx=10..200N --plot torque.png",
    ),
    "6310_clearance": (
        "rolamento plot 6310_clearance.nc --variable max_inner_max_pressure -o pressure.png",
    ),
    "218_speed": ("rolamento plot 218_speed.nc --variable stiffness_zz -o stiffness.png",),
    "218_scatter": (
        "rolamento sweep studies/218_scatter.toml -o scatter.nc",
        "rolamento plot scatter.nc -o histogram.png",
    ),
    "nu205_misalignment": (
        "rolamento plot nu205_misalignment.nc --variable life_hours -o life.png",
    ),
    "life_test": ("rolamento weibull life_test_campanha_2008.csv --plot paper.png",),
    "clearance_trend": ("rolamento trend campanha_2008_clearance.csv --plot trend.png",),
    "noise_trend": ("rolamento trend campanha_2008_anderon.csv --plot trend.png",),
}
"""Commands that draw an example; `{file}` is the first of its files."""

_LANGUAGES: Final = {".toml": "toml", ".py": "python", ".csv": "text"}
_ACROSS: Final = 3
_THUMBNAIL: Final = 320
"""Its longer side, in pixels."""
_LONGEST: Final = 120
"""Lines of a source or an output that a page shows."""


def main(words: Sequence[str]) -> int:
    """Write the gallery; 1 if a command fails."""
    folder = Path(words[0] if words else TARGET).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    cards = []
    for name, example in EXAMPLES.items():
        with tempfile.TemporaryDirectory() as place, contextlib.chdir(place):
            page, pictures = executed(name, example)
            for picture in pictures:
                keep_picture(picture, folder / f"{name}-{picture.name}")
            if pictures:
                make_thumbnail(folder / f"{name}-{pictures[0].name}")
        (folder / f"{name}.md").write_text(page, encoding="utf-8")
        cards.append(card(name, example, [f"{name}-{picture.name}" for picture in pictures]))
        print(f"{name}: {len(pictures)} figures", flush=True)
    index = "\n".join(["# Executed examples", "", *_INTRODUCTION, "", *rows(cards), ""])
    (folder / "index.md").write_text(index, encoding="utf-8")
    return 0


_INTRODUCTION: Final = (
    "Every example that is shipped, run when this site was made: its source, what the program",
    "printed, and figures. `rolamento examples NAME` copies one into your folder.",
)


def executed(name: str, example: Example) -> tuple[str, list[Path]]:
    """Run an example in the current folder; return its page, and the pictures that it wrote.

    Raises
    ------
    RuntimeError
        If a command fails.
    """
    copy_examples(name)
    lines = [f"# {_capital(example.shows)}", "", f"    rolamento examples {name}", ""]
    for file in example.files:
        text = Path(file).read_text(encoding="utf-8")
        lines += [f"## {file}", "", _block(text, _LANGUAGES[Path(file).suffix]), ""]
    lines += ["## What it gives", "", f"    {example.command}", ""]
    lines += [_block(done(example.command), "text"), ""]
    drawing = [line.replace("{file}", example.files[0]) for line in FIGURES.get(name, ())]
    for line in drawing:
        done(line)
    pictures = sorted(Path().rglob("*.png"), key=lambda path: path.stat().st_mtime_ns)
    if pictures:
        lines += ["## Figures", ""]
        lines += [f"    {line}" for line in drawing] + [""] * bool(drawing)
        lines += [f"![{example.shows}]({name}-{path.name})\n" for path in pictures]
    return "\n".join(lines).rstrip() + "\n", pictures


def done(line: str) -> str:
    """Run a command line of `rolamento`, or a script, and return what it prints.

    Raises
    ------
    RuntimeError
        If it fails.
    """
    program, *words = shlex.split(line)
    if program == "python":
        output = io.StringIO()
        with contextlib.redirect_stdout(output):
            runpy.run_path(words[0], run_name="example")["main"](Path())
        return output.getvalue()
    code, printed = command(words)
    if code:
        raise RuntimeError(f"exit code {code}: {line}\n{printed}")
    return printed


def card(name: str, example: Example, pictures: Sequence[str]) -> str:
    """Return the cell of an example in the table of the index: a thumbnail and a link."""
    title = _capital(example.shows)
    shown = f"[![{title}]({thumbnail_of(pictures[0])})]({name}.md) " if pictures else ""
    return f"{shown}[{title}]({name}.md)"


def rows(cards: Sequence[str]) -> list[str]:
    """Return a table of cards, three in a row."""
    filled = [*cards, *[""] * (-len(cards) % _ACROSS)]
    lines = [filled[at : at + _ACROSS] for at in range(0, len(filled), _ACROSS)]
    return [f"| {' | '.join(line)} |" for line in ([""] * _ACROSS, ["---"] * _ACROSS, *lines)]


def thumbnail_of(picture: str) -> str:
    """Return the name of the small form of a picture."""
    return picture.replace(".png", "-small.png")


def make_thumbnail(picture: Path) -> None:
    """Write the small form of a picture beside it."""
    with Image.open(picture) as image:
        small = image.convert("RGB")
    small.thumbnail((_THUMBNAIL, _THUMBNAIL))
    small.quantize(64).save(picture.with_name(thumbnail_of(picture.name)), optimize=True)


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _block(text: str, language: str) -> str:
    lines = [line.rstrip() for line in text.strip("\n").splitlines()]
    if not lines:
        return ""
    if len(lines) > _LONGEST:
        lines = [*lines[:_LONGEST], "…"]
    return "\n".join([f"```{language}", *lines, "```"])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
