"""Files are written whole or not at all."""

from __future__ import annotations

import os
import stat
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from rolamento.errors import FileError
from rolamento.io import writing
from rolamento.io.writing import check_space, write_bytes, write_text, written_whole


@pytest.fixture
def old(tmp_path: Path) -> Iterator[Path]:
    """A file that is there already; nothing may lie beside it in the end."""
    path = tmp_path / "result.json"
    path.write_text("old", "utf-8")
    yield path
    assert [p.name for p in tmp_path.iterdir() if p.name.startswith(".")] == []


def test_a_new_text_takes_the_place_of_the_old_one(old: Path) -> None:
    old.chmod(0o640)
    write_text("λ\n", old)
    assert old.read_bytes() == "λ\n".encode()
    assert stat.S_IMODE(old.stat().st_mode) == 0o640


@pytest.mark.parametrize("error", [OSError(28, "No space left on device"), KeyboardInterrupt()])
def test_half_a_file_is_none(old: Path, error: BaseException) -> None:
    def half() -> None:
        with written_whole(old) as place, place.open("wb") as file:
            file.write(b"half of")
            raise error

    with pytest.raises((FileError, KeyboardInterrupt)) as told:
        half()
    if isinstance(error, OSError):
        assert str(told.value) == f"{old}: cannot be written: no space left on device"
    assert old.read_text("utf-8") == "old"


def test_only_a_new_file(old: Path) -> None:
    with pytest.raises(FileError, match="already exists; choose another name"):
        write_bytes(b"new", old, new=True)
    assert old.read_text("utf-8") == "old"
    write_bytes(b"new", old.with_name("other"), new=True)
    assert old.with_name("other").read_bytes() == b"new"


@pytest.mark.parametrize("links", [True, False])
def test_a_file_that_has_come_meanwhile(
    old: Path, monkeypatch: pytest.MonkeyPatch, links: bool
) -> None:
    if not links:

        def refused(*_: object) -> None:
            raise PermissionError

        monkeypatch.setattr(os, "link", refused)
    path = old.with_name("new.json")

    def written() -> None:
        with written_whole(path, new=True) as place:
            place.write_bytes(b"mine")
            path.write_bytes(b"theirs")

    with pytest.raises(FileError, match="already exists; choose another name"):
        written()
    assert path.read_bytes() == b"theirs"


def test_links_are_followed_or_replaced(old: Path) -> None:
    link = old.with_name("link")
    link.symlink_to(old)
    write_bytes(b"by the link", link)
    assert (link.is_symlink(), old.read_bytes()) == (True, b"by the link")
    write_bytes(b"instead of it", link, through_links=False)
    assert (link.is_symlink(), old.read_bytes()) == (False, b"by the link")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs named pipes")
def test_pipes_and_devices_are_written_to(old: Path) -> None:
    pipe, read = old.with_name("pipe"), []
    os.mkfifo(pipe)
    reader = threading.Thread(target=lambda: read.append(pipe.read_bytes()))
    reader.start()
    write_bytes(b"through", pipe)
    reader.join()
    assert read == [b"through"]
    assert stat.S_ISFIFO(pipe.stat().st_mode)
    write_bytes(b"gone", os.devnull)
    assert not Path(os.devnull).is_file()


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("no/such", "no such file or directory"),
        ("result.json/below", "not a directory"),
        (".", "is a directory; give a file"),
        ("a\0b", "is not a valid file name"),
        ("x" * 300, "name too long"),
    ],
)
def test_places_that_cannot_be(old: Path, name: str, said: str) -> None:
    with pytest.raises(FileError, match=said):
        write_bytes(b"", old.parent / name)


def test_no_name() -> None:
    with pytest.raises(FileError, match="no name is given"):
        write_bytes(b"", "")


def test_a_file_that_may_not_be_written(old: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "access", lambda path, mode: False)  # root may write anything
    with pytest.raises(FileError, match="permission denied"):
        write_bytes(b"new", old)
    assert old.read_text("utf-8") == "old"


def test_room_on_the_disk(old: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    check_space(1, old)
    with pytest.raises(FileError, match=r"needs 1 000 000 000 000 MB, and [0-9. ]+ MB are free"):
        check_space(10**18, old)

    def silent(path: Path) -> None:
        raise OSError

    monkeypatch.setattr(writing.shutil, "disk_usage", silent)
    check_space(10**18, old)
