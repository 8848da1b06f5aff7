"""The cleanliness code of ISO 4406: how many particles an oil carries, by size.

Three scale numbers for particles from 4, 6 and 14 µm, such as 18/15/12; each step doubles the
number of particles. The first is often left open: -/15/12.
"""

from __future__ import annotations

import re
from typing import Final

from rolamento.errors import InputError
from rolamento.words import said

__all__ = ["cleanliness_numbers"]

_CODE: Final = r"(?a)(-|\*|\d{1,2})/(\d{1,2})/(\d{1,2})"
_LONGEST: Final = 40
_GREATEST_NUMBER: Final = 28
_EXAMPLE: Final = 'cleanliness = "-/17/14"'


def cleanliness_numbers(code: str) -> tuple[int | None, int, int]:
    """Return the three scale numbers of an ISO 4406 code; the first may be left open.

    Raises
    ------
    InputError
        If the code is malformed, a number beyond 28, or the numbers rise.

    >>> cleanliness_numbers("-/17/14")
    (None, 17, 14)
    """
    found = re.fullmatch(_CODE, str(code)[:_LONGEST].strip())
    if found is None:
        raise InputError(
            said(
                "is not an ISO 4406 code: three numbers for particles from 4, 6 and 14 "
                "µm; the first may be -"
            ),
            field="cleanliness",
            value=code,
            example=_EXAMPLE,
        )
    first = None if found[1] in "-*" else int(found[1])
    numbers = (first, int(found[2]), int(found[3]))
    given = [number for number in numbers if number is not None]
    if max(given) > _GREATEST_NUMBER:
        raise InputError(
            said("has a number above {most}, the end of the scale", most=_GREATEST_NUMBER),
            field="cleanliness",
            value=code,
            example=_EXAMPLE,
        )
    if given != sorted(given, reverse=True):
        raise InputError(
            said("has increasing numbers: there cannot be more large particles than small ones"),
            field="cleanliness",
            value=code,
            example=_EXAMPLE,
        )
    return numbers
