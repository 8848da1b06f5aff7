"""Compiled code is run as soon as it is read: nobody else may have put it there."""

from __future__ import annotations

import os
import stat
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest
from tests.children import python
from tests.unit.test_compiled import KERNEL

import rolamento
from rolamento.numerics import trust
from rolamento.numerics.trust import is_trusted

pytestmark = pytest.mark.skipif(os.name != "posix", reason="needs owners and modes of POSIX")

STRANGER = 54_321
"""A user that no machine knows."""
as_administrator = pytest.mark.skipif(
    os.name == "posix" and os.geteuid() != 0, reason="only an administrator gives files away"
)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder of one's own, in one that others may not write to."""
    tmp_path.chmod(0o755)
    path = tmp_path / "kept"
    path.mkdir(0o755)
    return path


@pytest.mark.parametrize("mode", [0o700, 0o755, 0o555, 0o1755])
def test_ones_own(folder: Path, mode: int) -> None:
    folder.chmod(mode)
    assert is_trusted(folder)


@pytest.mark.parametrize("mode", [0o777, 0o757, 0o1777])
def test_others_may_write(folder: Path, mode: int) -> None:
    folder.chmod(mode)
    assert not is_trusted(folder)
    folder.chmod(0o755)
    assert is_trusted(folder)


def test_others_may_write_above(folder: Path) -> None:
    above = folder / "numerics" / "deep"
    above.mkdir(parents=True)
    (folder / "numerics").chmod(0o777)
    assert not is_trusted(above)
    (folder / "numerics").chmod(0o1777)  # as /tmp: they may add to it, but replace nothing
    assert is_trusted(above)


def test_a_link_is_where_it_leads(folder: Path) -> None:
    open_to_all = folder / "open"
    open_to_all.mkdir()
    open_to_all.chmod(0o777)
    link = folder / "link"
    link.symlink_to(open_to_all, target_is_directory=True)
    assert not is_trusted(link)
    link.unlink()
    link.symlink_to(link)
    assert not is_trusted(link)
    assert not is_trusted(folder / "nowhere")


def test_a_group(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder.chmod(0o775)
    for of_one in (True, False):
        monkeypatch.setattr(trust, "_is_of_one", lambda group, owner, so=of_one: so)
        assert is_trusted(folder) == of_one


def test_whose_group_it_is() -> None:
    import grp
    import pwd

    for user in pwd.getpwall():
        try:
            own = grp.getgrgid(user.pw_gid)
        except KeyError:
            continue
        alone = own.gr_name == user.pw_name and not set(own.gr_mem) - {user.pw_name}
        assert trust._is_of_one(user.pw_gid, user.pw_uid) == alone
    assert not trust._is_of_one(STRANGER, os.geteuid())
    assert not trust._is_of_one(0, STRANGER)


@as_administrator
def test_whose_it_is(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    os.chown(folder, STRANGER, STRANGER)
    assert not is_trusted(folder)
    program = folder.parent / "program.py"
    program.touch()
    os.chown(program, STRANGER, STRANGER)
    monkeypatch.setattr(trust, "__file__", str(program))  # who owns the program may change it
    assert is_trusted(folder)


@pytest.mark.slow
def test_code_that_others_may_have_left_is_not_run(tmp_path: Path) -> None:
    tmp_path.chmod(0o755)
    script, kept = tmp_path / "program.py", tmp_path / "kept"
    script.write_text(KERNEL, "utf-8")
    environment = {
        **os.environ,
        "NUMBA_CACHE_DIR": str(kept),
        "PYTHONPATH": str(Path(rolamento.__file__).parents[1]),
    }

    def ran() -> tuple[str, str]:
        done = subprocess.run(
            [sys.executable, str(script)], capture_output=True, text=True, env=environment
        )
        assert done.returncode == 0, done.stderr
        return done.stdout, done.stderr

    assert ran() == ("42.0 0\n", "")
    assert ran() == ("42.0 1\n", "")
    (folder,) = (path.parent for path in kept.rglob("*.nbi"))
    folder.chmod(0o777)
    output, said = ran()
    assert output == "42.0 0\n"
    assert said.count("\n") == 1
    assert f"others may write to {folder}" in said
    folder.chmod(0o755)
    assert ran() == ("42.0 1\n", "")
    if os.geteuid() == 0:  # what somebody has left there before
        (file,) = kept.rglob("*.nbc")
        os.chown(file, STRANGER, STRANGER)
        assert ran()[0] == "42.0 0\n"
        assert file.stat().st_uid == os.geteuid()


@as_administrator
@pytest.mark.slow
def test_an_installation_of_the_administrators() -> None:
    """Somebody else, who can write to none of it, keeps what is compiled at home."""
    program = f"""
import os, sys
from rolamento.cli import main
from rolamento.numerics.compiled import _numba
from rolamento.rows.ball.batch import solve_safely

sys.argv = ["rolamento", "solve", "6310", "--fr", "5 kN", "--speed", "1480 rpm"]
def solved():
    try:
        main()
    except SystemExit as end:
        assert not end.code
_numba()
solved()  # where only the administrator may read Python itself, it has been read by now
os.setgroups([])
os.setgid({STRANGER})
os.setuid({STRANGER})
solved()
sys.stdout.flush()
print(solve_safely.is_kept, solve_safely._folder)
"""
    for place in (here := Path(rolamento.__file__).parent, *here.parents):
        if not place.stat().st_mode & stat.S_IXOTH:
            pytest.skip("the package lies where nobody else may look")
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with tempfile.TemporaryDirectory() as home:  # pytest's own is for the administrator alone
        os.chown(home, STRANGER, STRANGER)
        environment = {"XDG_CACHE_HOME": home, "HOME": home}
        with python("-c", program, cwd=home, env=environment, **pipes) as process:
            output, said = process.communicate(timeout=120)
    assert process.returncode == 0, said
    assert output.count("✓ converged") == 2
    assert f"\nTrue {home}/" in output
    assert said == ""
