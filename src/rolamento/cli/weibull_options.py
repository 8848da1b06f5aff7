"""What the options of `rolamento weibull` ask for, checked before any work."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final, cast

from rolamento.cli.life_units import life_in, named_life
from rolamento.cli.shipped_data import check_one_given, known_example
from rolamento.cli.table_options import told_in_options
from rolamento.errors import InputError

if TYPE_CHECKING:
    from rolamento.weibull import LifeTest, Method, ShapePrior
    from rolamento.weibull.summary import FitMethod, Wanted

__all__ = ["EXAMPLES", "life_test", "only_groups", "wanted"]

EXAMPLES: Final = ("campanha-2008", "lieblein-zelen-1956")
FITS: Final[dict[str, FitMethod]] = {
    "ml": "maximum_likelihood",
    "unbiased": "unbiased",
    "rrx": "rank_regression_x_on_y",
    "rry": "rank_regression_y_on_x",
    "three-parameter": "three_parameter",
}
_MOST_NUMBERS: Final = 50
_MOST_CALCULATED: Final = 8
_PRIOR: Final = re.compile(r"(?:(lognormal|uniform):)?([^:]{1,30})\.\.([^:]{1,30})")


def life_test(
    data: str | None,
    example: str | None,
    *,
    group: str | None,
    unit: str | None,
    time: str | None = None,
    status: str | None = None,
    decimal_mark: str | None = None,
) -> LifeTest:
    """Read the data, or a shipped example.

    Raises
    ------
    InputError, FileError
        If neither or both are given, or they are no life test.
    """
    from rolamento.weibull import parse_life_test, published_text, read_life_test

    check_one_given(data, example, "weibull", EXAMPLES)
    columns = {"group": group, "unit": unit, "time": time, "status": status}
    with told_in_options():
        if example is not None:
            name = known_example(example, EXAMPLES)
            text = published_text(name.replace("-", "_"))
            return parse_life_test(text, f"{name}.csv", decimal_mark=decimal_mark, **columns)
        assert data is not None
        return read_life_test(data, decimal_mark=decimal_mark, **columns)


def only_groups(test: LifeTest, names: Sequence[str]) -> LifeTest:
    """Keep some groups of a test; all if none is named."""
    if not names:
        return test
    import numpy as np

    known = list(dict.fromkeys(str(name) for name in test.group))
    for name in names:
        if name not in known:
            shown = ", ".join(label for label in known[:10] if label) or "none"
            raise InputError(f"is no group of the data; there are: {shown}", source="--only",
                             value=name)  # fmt: skip
    return test.select(np.isin(test.group, list(names)))


def wanted(
    unit: str,
    *,
    methods: Sequence[str],
    three_parameter: bool,
    bounds: str | None,
    shape: float | None,
    bayes: str | None,
    confidence: float,
    sides: str,
    reliabilities: Sequence[float],
    times: Sequence[str],
    calculated: Sequence[str],
    samples: int,
    seed: int,
) -> Wanted:
    """Put together what is wanted of a test whose times have a unit."""
    from rolamento.weibull.summary import Wanted

    for option, many, most in (
        ("--reliability", reliabilities, _MOST_NUMBERS),
        ("--time", times, _MOST_NUMBERS),
        ("--calculated-life", calculated, _MOST_CALCULATED),
    ):
        if len(many) > most:
            raise InputError(f"may be given {most} times at most", source=option)
    keywords: dict[str, Any] = {
        "bounds": _bounds(bounds, shape),
        "shape": shape,
        "prior": None if bayes is None else _prior(bayes),
        "confidence": confidence,
        "sides": sides,
        "times": tuple(life_in(text, unit, "--time") for text in times),
        "calculated": _calculated(calculated, unit),
        "samples": samples,
        "seed": seed,
    }
    if reliabilities:
        keywords["reliabilities"] = tuple(dict.fromkeys(reliabilities))
    asked = Wanted(**keywords)
    chosen = _methods(methods) or asked.methods
    if three_parameter:
        chosen = tuple(dict.fromkeys((*chosen, FITS["three-parameter"])))
    return Wanted(methods=chosen, **keywords)


def _methods(names: Sequence[str]) -> tuple[FitMethod, ...]:
    for name in names:
        if name not in FITS:
            raise InputError(
                f"must be one of {', '.join(FITS)}", source="--method", value=name, example="ml"
            )
    return tuple(dict.fromkeys(FITS[name] for name in names))


def _bounds(name: str | None, shape: float | None) -> Method | None:
    if name is None:
        return None
    from rolamento.weibull import METHODS

    known = [method.replace("_", "-") for method in METHODS if method != "fixed_shape"]
    word = name.replace("_", "-")
    if word not in known:
        raise InputError(
            f"must be one of {', '.join(known)}", source="--bounds", value=name, example=known[0]
        )
    if shape is not None:
        raise InputError("does not go with --shape, which has bounds of its own", source="--bounds",
                         value=name)  # fmt: skip
    return cast("Method", word.replace("-", "_"))


def _prior(text: str) -> ShapePrior:
    from rolamento.weibull import ShapePrior

    match = _PRIOR.fullmatch(text.strip())
    try:
        low, high = (float(match[2]), float(match[3])) if match else (0.0, 0.0)
    except ValueError:
        match = None
    if match is None:
        raise InputError(
            "must be LOW..HIGH, what the shape lies between with 90 %; or uniform:LOW..HIGH",
            source="--bayes",
            value=text,
            example="1..2.5",
        )
    try:
        return ShapePrior(low, high, kind="uniform" if match[1] == "uniform" else "lognormal")
    except InputError as error:
        raise error.with_details(source="--bayes") from None


def _calculated(texts: Sequence[str], unit: str) -> dict[str, float]:
    """Calculated lives by their names; those without one are called by what was written."""
    lives: dict[str, float] = {}
    for text in texts:
        name, life = named_life(text, unit, "--calculated-life")
        name = name or text.strip()
        if name in lives:
            raise InputError("has two lives of one name", source="--calculated-life", value=text)
        lives[name] = life
    return lives
