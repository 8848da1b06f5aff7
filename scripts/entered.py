"""Count the functions of ours that `solve` enters from a case file to the page, each once.

    python scripts/entered.py [CASE] [--list]

The first way compiles and imports; the second is counted. Expressions that are functions to Python
alone (generators, lambdas) are left out.
"""

from __future__ import annotations

import sys
from pathlib import Path
from types import FrameType

import rolamento
from rolamento.analysis import analyse
from rolamento.case import load_case
from rolamento.document import Medium
from rolamento.document.terminal import terminal
from rolamento.pages.state import state_page

HOUSE = str(Path(rolamento.__file__).parent)


def page(path: Path) -> str:
    """Return the page of a case file, as `rolamento solve` has it."""
    analysis = analyse(load_case(path), quick=True)
    return terminal(state_page(analysis.solved, analysis), Medium(100))


def entered(path: Path) -> list[str]:
    """Return the functions that are entered, by module."""
    page(path)
    found = set()

    def see(frame: FrameType, event: str, _: object) -> None:
        code = frame.f_code
        if event == "call" and code.co_filename.startswith(HOUSE) and code.co_name[0] != "<":
            found.add(f"{code.co_filename[len(HOUSE) + 1 :]} {code.co_qualname}")

    sys.setprofile(see)
    page(path)
    sys.setprofile(None)
    return sorted(found)


if __name__ == "__main__":
    given = [one for one in sys.argv[1:] if one != "--list"]
    shipped = Path(HOUSE) / "examples" / "218_combined.toml"
    functions = entered(Path(given[0]) if given else shipped)
    if "--list" in sys.argv:
        print(*functions, sep="\n")
    print(f"{len(functions)} functions in {len({one.split()[0] for one in functions})} modules")
