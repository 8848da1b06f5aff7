"""Build a release and try it, all but the upload: `make release`.

The version and its date stand in the changelog; sdist and wheel are built and checked; with each
Python that this machine has, the wheel is installed in an environment of its own, and the tests of
the unpacked sdist are run against it. Needs `build` and `twine`: the extra `release`.
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path
from typing import Final

ROOT: Final = Path(__file__).resolve().parent.parent
PYTHONS: Final = ("3.11", "3.12", "3.13", "3.14")
DIST: Final = ROOT / "dist"


def main() -> int:
    """Return 0 if everything is ready to be uploaded."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument(
        "--python",
        nargs="*",
        default=PYTHONS,
        metavar="VERSION",
        help="by default all that is here",
    )
    parser.add_argument("--no-tests", action="store_true", help="install, and run the example only")
    options = parser.parse_args()
    version = _version()
    _check_tree(version)
    shutil.rmtree(DIST, ignore_errors=True)
    _run([sys.executable, "-m", "build", "--outdir", DIST, ROOT])
    wheel, sdist = next(DIST.glob("*.whl")), next(DIST.glob("*.tar.gz"))
    _run([sys.executable, "-m", "twine", "check", "--strict", wheel, sdist])
    tried = []
    with tempfile.TemporaryDirectory(prefix="rolamento-release-") as folder:
        with tarfile.open(sdist) as archive:
            archive.extractall(folder, filter="data")
        source = next(Path(folder).glob("rolamento-*"))
        for name in options.python:
            if (python := _interpreter(name)) is not None:
                _try(python, wheel, source, Path(folder) / f"venv-{name}", not options.no_tests)
                tried.append(name)
    if not tried:
        sys.exit(f"release: none of Python {', '.join(options.python)} is on this machine")
    print(f"\nrelease: {version} is built in {DIST} and was tried on Python {', '.join(tried)}.")
    missing = [name for name in PYTHONS if name not in tried]
    if missing:
        print(f"release: not tried on {', '.join(missing)}.")
    print(f"release: what is left is `git tag v{version}` and `twine upload dist/*`.")
    return 0


def _version() -> str:
    text = (ROOT / "src/rolamento/__init__.py").read_text(encoding="utf-8")
    found = re.search(r'^__version__ = "([^"]+)"$', text, re.MULTILINE)
    assert found is not None
    return found[1]


def _check_tree(version: str) -> None:
    """Refuse a tree with changes, and a version that the changelog does not know."""
    changes = subprocess.run(
        ["git", "status", "--porcelain"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout
    if changes:
        sys.exit(f"release: the tree has changes that are in no commit:\n{changes}")
    headings = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    if not re.search(rf"^## \[{re.escape(version)}\] - \d{{4}}-\d\d-\d\d$", headings, re.MULTILINE):
        sys.exit(f"release: CHANGELOG.md has no heading '## [{version}] - DATE'")


def _interpreter(version: str) -> str | None:
    """Path of a Python of that version; None if there is none that works."""
    candidates = [
        f"python{version}",
        *map(str, Path.home().glob(f".pyenv/versions/{version}*/bin/python")),
    ]
    for candidate in candidates:
        found = shutil.which(candidate)
        if found is None:
            continue
        asked = subprocess.run(
            [found, "-c", "import sys, venv, ensurepip; print('%d.%d' % sys.version_info[:2])"],
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        if asked.stdout.strip() == version:
            return found
    return None


def _try(python: str, wheel: Path, source: Path, venv: Path, tests: bool) -> None:
    """Install a wheel with the pinned versions, and run the example and the sdist's tests."""
    print(f"\nrelease: {python}", flush=True)
    _run([python, "-m", "venv", venv])
    pip = [venv / "bin/python", "-m", "pip", "--disable-pip-version-check", "install", "--quiet"]
    constraints = ["--constraint", source / "constraints.txt"]
    _run([*pip, *constraints, f"{wheel}[dev]", source / "reproductions"])
    _run([venv / "bin/rolamento", "warm"], cwd=venv)
    _run([venv / "bin/rolamento", "demo"], cwd=venv)
    if tests:
        command = ["-n", "auto", "--dist", "worksteal", "-m", "not sweep", "-p", "no:cacheprovider"]
        _run([venv / "bin/pytest", *command], cwd=source)


def _run(command: list[object], cwd: Path = ROOT) -> None:
    done = subprocess.run([str(part) for part in command], cwd=cwd, check=False)
    if done.returncode:
        sys.exit(f"release: {' '.join(map(str, command))} ended with {done.returncode}")


if __name__ == "__main__":
    sys.exit(main())
