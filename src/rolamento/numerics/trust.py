"""Whose folder may hold compiled code: what is read from it is run."""

from __future__ import annotations

import os
import stat
from pathlib import Path

__all__ = ["is_trusted"]


def is_trusted(place: Path) -> bool:
    """Whether nobody could have put a file where it lies who could not change the program itself.

    That is whoever runs it, whoever owns it, and the administrator. Others may write neither to a
    file or folder nor to one above it, unless what lies there is its owner's to replace (as in
    /tmp); a group may that is one user's own, which is what makes a new user's folders writable to
    a group on many systems. Systems without such owners are trusted. The same rule as that for keys
    of OpenSSH (`StrictModes`), but for the program's owner.
    """
    if os.name != "posix":
        return True
    try:
        place = place.resolve()
        whose = {0, os.geteuid(), Path(__file__).stat().st_uid}
        return all(
            _is_kept_to(whose, above.stat(), sticky=above != place)
            for above in (place, *place.parents)
        )
    except (OSError, RuntimeError):  # links that lead nowhere, or in a circle
        return False


def _is_kept_to(whose: set[int], found: os.stat_result, *, sticky: bool) -> bool:
    if found.st_uid not in whose:
        return False
    if sticky and found.st_mode & stat.S_ISVTX:
        return True
    by_group = found.st_mode & stat.S_IWGRP and not _is_of_one(found.st_gid, found.st_uid)
    return not (found.st_mode & stat.S_IWOTH or by_group)


def _is_of_one(group: int, owner: int) -> bool:
    """Whether a group is one user's own: of his name, and nobody else in it."""
    import grp
    import pwd

    try:
        name, members = pwd.getpwuid(owner).pw_name, grp.getgrgid(group)
    except KeyError:
        return False
    return members.gr_name == name and set(members.gr_mem) <= {name}
