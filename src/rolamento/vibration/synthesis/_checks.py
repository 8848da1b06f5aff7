"""Bounds of what a synthesis is asked for."""

from __future__ import annotations

from rolamento.errors import InputError

__all__ = ["check_count", "check_within"]


def check_within(
    field: str, value: float, least: float, most: float, example: str, unit: str = ""
) -> None:
    """Refuse a number that is not between two bounds, both allowed; NaN never is."""
    if not least <= value <= most:
        span = f"from {least:g} to {most:g}{f' {unit}' if unit else ''}"
        raise InputError(f"must be {span}", field=field, value=value, example=example)


def check_count(field: str, count: int, most: int) -> None:
    """Refuse more of something than there may be."""
    if count > most:
        raise InputError(f"may hold at most {most}", field=field, value=count)
