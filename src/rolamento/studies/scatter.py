"""Scatter of a study: fields drawn at random, each from its distribution, some of them together.

Draws can be made in any order: they are counted, not consumed. Draw i of a field follows from the
seed, the field's name and i alone, by the counter-based generator Philox (Salmon et al., 2011). So
neither the order of the work nor its division among threads and machines changes a sample, and
another field beside it changes none of its draws.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from hashlib import blake2b
from typing import Annotated, Any, Final, Literal, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import (
    Field,
    SerializationInfo,
    SerializerFunctionWrapHandler,
    ValidationInfo,
    model_serializer,
    model_validator,
)

from rolamento.case.quantity import Count, Ratio, at_the_border
from rolamento.case.record import Record
from rolamento.errors import InputError
from rolamento.studies import fields
from rolamento.studies.axes import FieldName
from rolamento.units import Dimension, from_si, to_si
from rolamento.words import said

Floats = NDArray[np.float64]

MOST_CASES: Final = 1_000_000_000
FARTHEST: Final = 30.0
"""Standard deviations from the mean within which a truncated distribution has to reach."""
_LEAST_PIVOT: Final = 1e-12
_LEAST_REST: Final = 1e-6


class Law(NamedTuple):
    """A distribution in numbers: normal of a mean, or uniform without one, between two bounds."""

    mean: float | None
    spread: float
    low: float
    high: float

    def quantile(self, probability: Floats) -> Floats:
        """Return the values below which the given shares of the draws lie; shares in (0, 1)."""
        from scipy.special import ndtri

        if self.mean is None:
            drawn = self.low + (self.high - self.low) * probability
        elif math.isinf(self.low) and math.isinf(self.high):
            drawn = self.mean + self.spread * ndtri(probability)
        else:
            low, high = (self.low - self.mean) / self.spread, (self.high - self.mean) / self.spread
            drawn = self.mean + self.spread * truncated_normal(probability, low, high)
        return np.clip(drawn, self.low, self.high)


def truncated_normal(probability: Floats, low: float, high: float) -> Floats:
    """Quantile of the standard normal distribution cut off at two bounds.

    In logarithms, and in the left tail whichever side it is: exact however far out the bounds.
    """
    from scipy.special import log_ndtr, ndtri_exp

    if low > 0.0:
        return -truncated_normal(1.0 - probability, -high, -low)
    below = np.log1p(-probability) + log_ndtr(low)
    return np.asarray(ndtri_exp(np.logaddexp(below, np.log(probability) + log_ndtr(high))))


def factor_of(matrix: Floats) -> Floats:
    """Cholesky factor of a correlation matrix, which may be singular.

    In plain loops rather than by LAPACK: the same bits on every machine.

    Raises
    ------
    InputError
        If the matrix is not positive semi-definite.
    """
    size = len(matrix)
    rest, factor = matrix.copy(), np.zeros((size, size))
    for j in range(size):
        pivot = float(rest[j, j])
        column = rest[j:, j].copy()
        if pivot > _LEAST_PIVOT:
            factor[j:, j] = column / math.sqrt(pivot)
        elif pivot < -_LEAST_PIVOT or np.abs(column).max() > _LEAST_REST:
            least = float(np.linalg.eigvalsh(matrix).min())
            raise InputError(
                said(
                    "contradict each other: no fields can have them all (the matrix is not "
                    "positive semi-definite: its least eigenvalue is {least:.3g})",
                    least=least,
                ),
                field="correlations",
            )
        rest[j:, j:] -= np.outer(factor[j:, j], factor[j:, j])
    return factor


class Sampler:
    """Draws of a scatter, from any one to any other."""

    def __init__(self, scatter: Scatter, seed: int) -> None:
        self._names = tuple(scatter.fields)
        self._laws = [
            distribution.law(fields.read_field(name), in_file=False)
            for name, distribution in scatter.fields.items()
        ]
        self._factor = factor_of(scatter.matrix())
        self._seed = seed

    def draw(self, first: int, last: int) -> dict[str, Floats]:
        """Return draws `first` to `last` - 1 of every field, SI units."""
        shares = [uniform(self._seed, name, first, last) for name in self._names]
        return {
            name: law.quantile(share)
            for name, law, share in zip(
                self._names, self._laws, self._correlated(shares), strict=True
            )
        }

    def _correlated(self, shares: Sequence[Floats]) -> list[Floats]:
        """Turn independent shares into correlated ones, by way of normal scores."""
        from scipy.special import ndtr, ndtri

        if (self._factor == np.eye(len(shares))).all():
            return list(shares)
        mixed = []
        scores: Mapping[int, Floats] = {i: ndtri(share) for i, share in enumerate(shares)}
        for i, row in enumerate(self._factor):
            weights = np.flatnonzero(row)
            if list(weights) == [i]:
                mixed.append(shares[i])
                continue
            score = np.zeros_like(shares[i])
            for j in weights:
                score += row[j] * scores[int(j)]
            # A share of exactly 0 or 1 would be infinitely far out.
            mixed.append(np.clip(ndtr(score), 2.0**-53, 1.0 - 2.0**-53))
        return mixed


def uniform(seed: int, name: str, first: int, last: int) -> Floats:
    """Draws `first` to `last` - 1 of a stream, uniform in the open interval (0, 1).

    Philox gives four numbers for each value of its counter; 52 bits of each make a share in the
    middle of its cell, so that neither 0 nor 1 occurs.
    """
    key = int.from_bytes(blake2b(f"{seed} {name}".encode(), digest_size=16).digest(), "little")
    counter = first // 4
    generator = np.random.Philox(counter=counter, key=key)
    bits = generator.random_raw(last - 4 * counter)[first - 4 * counter :]
    return ((bits >> np.uint64(12)).astype(np.float64) + 0.5) * 2.0**-52


class Distribution(Record):
    """How a field is scattered.

    Parameters
    ----------
    distribution
        ``"normal"`` with `mean` and `standard_deviation`, cut off at `least` and `greatest` where
        given; ``"uniform"`` from `least` to `greatest`.
    mean, standard_deviation, least, greatest
        As the field takes them: a quantity with its unit, in Python also an SI float.

    Raises
    ------
    InputError
        If a value is missing or stands beside one that excludes it.
    """

    distribution: Literal["normal", "uniform"] = Field(examples=["normal"])
    mean: Any = Field(None, examples=["40 deg"])
    standard_deviation: Any = Field(None, examples=["0.5 deg"])
    least: Any = Field(None, examples=["38 deg"])
    greatest: Any = Field(None, examples=["42 deg"])

    @model_validator(mode="after")
    def _complete(self) -> Self:
        normal = self.distribution == "normal"
        needed = ("mean", "standard_deviation") if normal else ("least", "greatest")
        for name in needed:
            if getattr(self, name) is None:
                raise InputError(
                    said(
                        "is missing for a {distribution} distribution",
                        distribution=self.distribution,
                    ),
                    field=name,
                )
        if not normal:
            for name in ("mean", "standard_deviation"):
                if getattr(self, name) is not None:
                    raise InputError(said("does not apply to a uniform distribution"), field=name)
        return self

    def law(self, field: fields.Field, *, in_file: bool) -> Law:
        """Return the distribution in numbers, SI.

        Raises
        ------
        InputError
            If the field does not take a value, or the values contradict each other.
        """
        low, high = (
            self._bound(field, name, in_file, default)
            for name, default in (("least", -math.inf), ("greatest", math.inf))
        )
        if not low < high:
            raise InputError(
                said("must be greater than least"),
                field="greatest",
                value=self.greatest,
            )
        if self.distribution == "uniform":
            return Law(None, 0.0, low, high)
        mean = self._bound(field, "mean", in_file, 0.0)
        spread = _spread(field, self.standard_deviation, in_file)
        if not (low - mean) / spread < FARTHEST or not (high - mean) / spread > -FARTHEST:
            raise InputError(
                said(
                    "lies more than {most:.6g} standard deviations from the mean: nothing "
                    "would be left",
                    most=FARTHEST,
                ),
                field="least" if low > mean else "greatest",
                value=self.least if low > mean else self.greatest,
            )
        return Law(mean, spread, low, high)

    def written(self, field: fields.Field) -> Distribution:
        """Return the distribution with its quantities as text, as a file has it."""
        given = {name: getattr(self, name) for name in ("mean", "least", "greatest")}
        texts = {
            name: value if isinstance(value, str) else field.written(float(value))
            for name, value in given.items()
            if value is not None
        }
        spread = self.standard_deviation
        if spread is not None and not isinstance(spread, str) and field.dimension is not None:
            spread = from_si(float(spread), field.dimension)
        if spread is not None:
            texts["standard_deviation"] = spread
        return Distribution(distribution=self.distribution, **texts)

    def _bound(self, field: fields.Field, name: str, in_file: bool, default: float) -> float:
        value = getattr(self, name)
        if value is None:
            return default
        try:
            return float(field.checked(value, in_file=in_file))
        except InputError as error:
            raise error.with_details(field=name) from None


def _spread(field: fields.Field, value: object, in_file: bool) -> float:
    """Return a standard deviation: of the field's dimension, but not within its limits."""
    if field.dimension is not None and (in_file or isinstance(value, str)):
        if not isinstance(value, str):
            raise InputError(
                said("needs a unit"),
                field="standard_deviation",
                value=value,
                example=field.example,
            )
        try:
            spread = difference_in_si(value, field.dimension)
        except InputError as error:
            raise error.with_details(field="standard_deviation") from None
    else:
        spread = _number(value)
    if not (spread > 0.0 and math.isfinite(spread)):
        raise InputError(said("must be positive"), field="standard_deviation", value=value)
    return spread


def difference_in_si(text: str, dimension: Dimension) -> float:
    """Read a difference of two quantities of a dimension."""
    if dimension == "temperature" and not text.rstrip().endswith("K"):
        raise InputError(said("must be in K: it is a difference"), value=text, example='"2 K"')
    return to_si(text, dimension)


def _number(value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(said("must be a number"), field="standard_deviation", value=value)
    return float(value)


class Correlation(Record):
    """Correlation of two fields.

    Parameters
    ----------
    fields
        Two of the scattered fields.
    coefficient
        Of the normal scores of the fields (a Gaussian copula), -1 to 1: for two normal
        distributions that are not truncated, the usual correlation coefficient.

    Raises
    ------
    InputError
        If there are not two fields, or the coefficient is out of range.
    """

    fields: tuple[FieldName, FieldName] = Field(
        examples=['["bearing.inner_conformity", "bearing.outer_conformity"]']
    )
    coefficient: Annotated[float, Ratio(at_least=-1.0, at_most=1.0)] = Field(examples=[0.6])


class Scatter(Record):
    """Random draws of several fields.

    Parameters
    ----------
    count
        Draws, of all fields at once.
    fields
        `Distribution` by dotted field.
    correlations
        `Correlation` of pairs; the others are independent.

    Raises
    ------
    InputError
        If a field cannot be scattered or does not take a value, or the correlations contradict
        each other: no fields can have them all.
    """

    count: Annotated[int, Count] = Field(strict=True, ge=1, le=MOST_CASES, examples=[100_000])
    fields: dict[FieldName, Distribution] = Field(min_length=1, max_length=50)
    correlations: tuple[Correlation, ...] = Field((), max_length=2000)

    @model_validator(mode="after")
    def _consistent(self, info: ValidationInfo) -> Self:
        in_file = at_the_border(info.context)
        fields.refuse_rivals(tuple(self.fields), at="fields")
        for name, distribution in self.fields.items():
            field = fields.read_field(name, at="fields")
            if not field.continuous:
                raise InputError(said("cannot be scattered; use an axis"), field=f"fields.{name}")
            try:
                distribution.law(field, in_file=in_file)
            except InputError as error:
                place = f"fields.{name}.{error.field}"
                raise error.with_details(field=place) from None
        factor_of(self.matrix())
        return self

    def matrix(self) -> Floats:
        """Return the correlation matrix of the fields in their order.

        Raises
        ------
        InputError
            If a pair is not one of scattered fields, or stands there twice.
        """
        order = {name: i for i, name in enumerate(self.fields)}
        matrix = np.eye(len(order))
        for number, correlation in enumerate(self.correlations):
            at = f"correlations.{number}.fields"
            for name in correlation.fields:
                if name not in order:
                    raise InputError(
                        said("must be scattered fields: {order}", order=", ".join(order)),
                        field=at,
                        value=name,
                    )
            i, j = (order[name] for name in correlation.fields)
            if i == j or matrix[i, j] != 0.0:
                raise InputError(said("must be two fields, each pair once"), field=at)
            matrix[i, j] = matrix[j, i] = correlation.coefficient
        return matrix

    @model_serializer(mode="wrap")
    def _written(self, handler: SerializerFunctionWrapHandler, info: SerializationInfo) -> Any:
        """Write quantities with units where a person reads."""
        table: dict[str, Any] = handler(self)
        if not at_the_border(info.context):
            return table
        table["fields"] = {
            name: distribution.written(fields.read_field(name)).model_dump(exclude_none=True)
            for name, distribution in self.fields.items()
        }
        if not self.correlations:
            del table["correlations"]
        return table
