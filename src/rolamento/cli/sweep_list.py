"""What `rolamento sweep --list` shows: fields that may vary, outputs that may be asked for."""

from __future__ import annotations

from rolamento.studies.fields import known_fields
from rolamento.studies.outputs import DEFAULT_OUTPUTS, catalogue
from rolamento.studies.solving import array_fields

__all__ = ["fields_text", "outputs_text"]


def fields_text() -> str:
    """Return the fields, one a line: name, SI unit, an example, and whether it can be scattered."""
    rows = [
        (
            field.name,
            field.unit,
            field.example,
            "axes and scatter" if name in array_fields() else "axes",
        )
        for name, field in known_fields().items()
    ]
    return _columns([("field", "unit", "example", "for"), *rows])


def outputs_text() -> str:
    """Return the outputs, one a line: name, SI unit, whether it is per ball, meaning."""
    rows = [
        (
            f"{name}{'*' if name in DEFAULT_OUTPUTS else ''}",
            output.unit,
            "per ball" if output.per_ball else "",
            output.long_name,
        )
        for name, output in catalogue().items()
    ]
    foot = "\n* put out if a study names no outputs\n"
    return _columns([("output", "unit", "", "meaning"), *rows]) + foot


def _columns(rows: list[tuple[str, ...]]) -> str:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = ("  ".join(c.ljust(w) for c, w in zip(row, widths, strict=True)) for row in rows)
    return "".join(f"{line.rstrip()}\n" for line in lines)
