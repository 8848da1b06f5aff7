"""The pictures of the documentation that no tutorial draws, drawn anew by the commands named here.

    python scripts/pictures.py            all
    python scripts/pictures.py life sn    those of these names

writes into docs/gallery. Pictures of tutorials and guides are those of `scripts/guides.py`, the
gallery of examples is that of `scripts/gallery.py`, figures of the reproductions are written by
`rolamento reproduce`.
"""

from __future__ import annotations

import contextlib
import re
import shlex
import sys
import tempfile
from collections.abc import Sequence
from io import BytesIO
from pathlib import Path
from typing import Any, Final

sys.path.insert(0, str(Path(__file__).parent))
from guides import command, keep_picture, script
from PIL import Image

from rolamento.document.pdf import set_by_typst
from rolamento.tasks.examples import copy_examples
from rolamento.tasks.inside import ReportRequest

DOCS: Final = Path(__file__).parents[1] / "docs"
TARGET: Final = DOCS / "gallery"

_CASE: Final = "6305.toml"
"""The case of `docs/plots.md`."""
_STATE: Final = "rolamento solve {} --json state.json"
_PLOT: Final = "rolamento plot state.json --kind"
_STUDY: Final = "rolamento sweep studies/{0}.toml -o {0}.nc"
_PROFILES: Final = "rolamento plot nu205_misalignment.nc --variable"
_SIGNAL: Final = (
    "rolamento synthesise 6305/C3 --speed '1800 rpm' --duration '4 s' --noise 0.6"
    " --waviness 'outer,amplitude=150 nm,last=120' --waviness 'inner,amplitude=150 nm,last=120'"
    " --waviness 'ball,amplitude=150 nm,last=60' --output t628.csv"
)
_CALCULATED: Final = (
    " --calculated-life 'ISO 281=58 h' --calculated-life 'L_able, catalogue=41 h'"
    " --calculated-life 'L_able, measured=189 h'"
)
_SHAFT: Final = "rolamento shaft machines/{}.toml --kind {} --plot"

PICTURES: Final[dict[str, tuple[str, ...]]] = {
    "plots/life": (
        f"rolamento life {_CASE} --over bearing.diametral_clearance=-40..60um"
        " --variant 'lubricant=ISO VG 150' --plot",
    ),
    **{
        f"plots/{kind}": (_STATE.format(_CASE), f"{_PLOT} {kind} -o")
        for kind in ("sn", "aiso", "zone", "helps")
    },
    "plots/ellipses": (_STATE.format("218_combined.toml"), f"{_PLOT} ellipses -o"),
    "plots/lines": (_STUDY.format("218_speed"), "rolamento plot 218_speed.nc -o"),
    "plots/rollers-along": (_STATE.format("nu205_gear.toml"), f"{_PLOT} along -o"),
    "plots/rollers-between": (_STATE.format("nu205_gear.toml"), f"{_PLOT} between -o"),
    "plots/rollers-models": (
        _STATE.format("nu205_gear.toml"),
        f"{_PLOT} along --variant 'as given:' --variant coupled:model.roller_contact=coupled"
        " --variant"
        " 'straight, coupled:model.roller_contact=coupled, bearing.roller_profile=none' -o",
    ),
    "plots/rollers-life": (_STUDY.format("nu205_misalignment"), f"{_PROFILES} life_hours -o"),
    "plots/rollers-profiles": (
        _STUDY.format("nu205_misalignment"),
        f"{_PROFILES} max_inner_max_pressure -o",
    ),
    "plots/weibull-paper": ("rolamento weibull --example campanha-2008 --plot",),
    "plots/weibull-contour": (
        f"rolamento weibull --example campanha-2008 --only I{_CALCULATED} --contour",
    ),
    "plots/weibull-methods": (
        "rolamento weibull --example lieblein-zelen-1956 --three-parameter --plot",
    ),
    "plots/weibull-chance": (
        "rolamento weibull-plan demonstration --life '1000 h' --bearings 10 --plot",
    ),
    "plots/weibull-cost": ("rolamento weibull-plan precision --ratio 5 --life '1000 h' --plot",),
    "plots/clearance-growth": ("rolamento trend --example campanha-2008-clearance --plot",),
    "plots/anderon-trend": ("rolamento trend --example campanha-2008-anderon --plot",),
    "plots/anderon": (
        _SIGNAL,
        "rolamento anderon t628.csv --full-scale low=30,medium=60,high=60 --plot",
    ),
    "plots/modulation": ("python synthesis.md modulation.png",),
    "plots/diagnosis": (
        "python diagnose.md",
        "rolamento diagnose inner.npz --bearing 6205 --speed '1797 rpm' --unit m/s^2 --plot",
    ),
    "plots/diagnosis-envelope": ("python diagnose.md envelope.png",),
    "machines/coaxial-machine": (_SHAFT.format("coaxial", "machine"),),
    "machines/gear_shaft-deflection": (_SHAFT.format("gear_shaft", "deflection"),),
    "machines/gear_shaft-forces": (_SHAFT.format("gear_shaft", "forces"),),
    "machines/spindle-drawing": (_SHAFT.format("spindle", "drawing"),),
    "machines/three_supports-bearings": (_SHAFT.format("three_supports", "bearings"),),
}
"""The commands that draw a picture; the last one is given its name, unless it has one."""
REPORT: Final = "6305_life.toml"
"""The case of the report of which two pages are shown."""
_PAGES: Final = (0, 3)
_GAP: Final = 12


def main(names: Sequence[str]) -> int:
    """Draw the pictures whose names end so, or all; 1 if one fails."""
    failed = 0
    for name, lines in {**PICTURES, "report": ()}.items():
        if names and not any(name.rpartition("/")[2] == one for one in names):
            continue
        with tempfile.TemporaryDirectory() as place, contextlib.chdir(place):
            try:
                drawn = run(lines) if lines else report()
                keep_picture(drawn, TARGET / f"{name}.png")
            except Exception as error:  # the others are drawn all the same
                print(f"{name}: {type(error).__name__}: {error}", flush=True)
                failed += 1
            else:
                print(name, flush=True)
    return min(failed, 1)


def run(lines: Sequence[str]) -> Path:
    """Run commands in the current folder, beside all examples; return what the last one drew."""
    copy_examples("all")
    (block,) = re.findall(
        r'```toml\n(title = "6305/C3 at 2000 rpm".*?)```', _page("plots.md"), re.S
    )
    Path(_CASE).write_text(block, encoding="utf-8")
    drawn, printed = Path("picture.png"), ""
    for line in lines:
        if line.startswith("python "):
            _, page, *written = line.split()
            names: dict[str, Any] = {"__name__": "__main__"}
            for code in re.findall(r"^```python\n(.*?)^```$", _page(page), re.M | re.S):
                script(code, names)
            drawn = Path(written[0]) if written else drawn
        else:
            words = shlex.split(f"{line} {drawn}" if line is lines[-1] else line)[1:]
            printed = command(words)[1]  # it may end with 1, and draw what it refuses
    if not drawn.is_file():
        raise RuntimeError(f"nothing is drawn: {lines[-1]}\n{printed}")
    return drawn


def report() -> Path:
    """Return two pages of a report, beside each other."""
    copy_examples("all")
    asked = ReportRequest(case=[REPORT], project="Gearbox 4711", author="A. Souza", revision="B")
    made = set_by_typst(asked.page(asked.run()), format="png", ppi=72)
    pages = [Image.open(BytesIO(made[place])).convert("RGB") for place in _PAGES]
    width, height = pages[0].size
    both = Image.new("RGB", (2 * width + _GAP, height), "#a0a0a0")
    for place, page in enumerate(pages):
        both.paste(page, (place * (width + _GAP), 0))
    both.save("picture.png")
    return Path("picture.png")


def _page(name: str) -> str:
    return (DOCS / name).read_text(encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
