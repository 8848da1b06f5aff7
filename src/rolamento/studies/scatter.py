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
from typing import Annotated, Any, Final, Literal, Self

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

from rolamento.case.former import with_current_names
from rolamento.case.quantity import AT_THE_BORDER, Count, Quantity
from rolamento.case.record import Record
from rolamento.errors import InputError
from rolamento.studies import fields
from rolamento.studies.axes import FieldName
from rolamento.studies.laws import Law, Lognormal, Normal, Triangular, Uniform, Weibull
from rolamento.units import Dimension, from_si, to_si
from rolamento.words import said

Floats = NDArray[np.float64]

MOST_CASES: Final = 1_000_000_000
FARTHEST: Final = 30.0
"""Standard deviations from the mean within which a truncated distribution has to reach."""
_LEAST_PIVOT: Final = 1e-12
_LEAST_REST: Final = 1e-6
_GREATEST_HAZARD: Final = 0.5 * FARTHEST**2
"""−ln of the share above the bound at which a Weibull distribution is cut off: as far out."""


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
            distribution.law(fields.read_varied(name), in_file=False)
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


_LEAST_FACTOR: Final = 1.0
_MOST_SHAPE: Final = 1000.0

_VALUES: Final = ("mean", "median", "mode", "minimum", "maximum")
"""Parameters that are values of the field, within its limits."""
_BEGIN_SOMEWHERE: Final = ("lognormal", "weibull")
"""Distributions of what exceeds a threshold."""
_DIFFERENCES: Final = ("standard_deviation", "scale")
"""Parameters that are differences of two values."""
_KINDS: Final[Mapping[str, tuple[tuple[tuple[str, ...], ...], tuple[str, ...]]]] = {
    "normal": ((("mean", "standard_deviation"),), ("minimum", "maximum")),
    "uniform": ((("minimum", "maximum"),), ()),
    "triangular": ((("minimum", "mode", "maximum"),), ()),
    "lognormal": (
        (("median", "factor"), ("mean", "standard_deviation")),
        ("threshold", "minimum", "maximum"),
    ),
    "weibull": ((("shape", "scale"),), ("threshold", "minimum", "maximum")),
}
"""Parameters of each distribution the parameters that it needs, in one of these sets, and what it
may have."""


class Distribution(Record):
    """How a field is scattered.

    Parameters
    ----------
    distribution
        ``"normal"`` with `mean` and `standard_deviation`; ``"lognormal"`` with `median` and
        `factor`, or `mean` and `standard_deviation`; ``"weibull"`` with `shape` and `scale`; these
        are cut off at `minimum` and `maximum` where given. ``"uniform"`` from `minimum` to
        `maximum`; ``"triangular"`` from `minimum` by its `mode`, the most likely value, to
        `maximum`.
    mean, median, mode, minimum, maximum
        As the field takes them: a quantity with its unit, in Python also an SI float. Mean and
        median are those before it is cut off.
    standard_deviation
        Likewise, a difference; temperatures in K.
    factor
        Of a lognormal distribution: 68.3 % of the draws lie between median / factor and median ×
        factor. Greater than 1.
    shape
        β of a Weibull distribution, F = 1 − exp(−((x − threshold) / scale)^β).
    scale
        η of a Weibull distribution, a difference: 63.2 % of the draws lie below threshold + scale.
    threshold
        Of a lognormal or Weibull distribution: what it exceeds, x_0; zero if not given. With one,
        median / factor and median × factor are those of what exceeds it.

    Raises
    ------
    InputError
        If a value is missing or stands beside one that excludes it.
    """

    distribution: Literal["normal", "uniform", "triangular", "lognormal", "weibull"] = Field(
        examples=["normal"]
    )
    mean: Any = Field(None, examples=["40 deg"])
    standard_deviation: Any = Field(None, examples=["0.5 deg"])
    median: Any = Field(None, examples=["40 deg"])
    factor: Any = Field(None, examples=[1.5])
    mode: Any = Field(None, examples=["40 deg"])
    shape: Any = Field(None, examples=[1.5])
    scale: Any = Field(None, examples=["2 deg"])
    threshold: Any = Field(None, examples=["38 deg"])
    minimum: Any = Field(None, examples=["38 deg"])
    maximum: Any = Field(None, examples=["42 deg"])

    @model_validator(mode="before")
    @classmethod
    def _current_names(cls, given: Any) -> Any:
        """Read tables of release 0.1, where a cut-off had other names, and minimum was x_0."""
        former = {"least": "minimum", "greatest": "maximum"}
        if isinstance(given, Mapping) and given.get("distribution") in _BEGIN_SOMEWHERE:
            if any(name in given for name in former):
                former["minimum"] = "threshold"
            elif "minimum" in given and "threshold" not in given:
                raise InputError(
                    said(
                        "is where the draws are cut off; what they exceed, which was minimum until"
                        " release 0.1, is threshold: give both"
                    ),
                    field="minimum",
                    value=given["minimum"],
                    example='threshold = "…"',
                )
        return with_current_names(given, former)

    @model_validator(mode="after")
    def _complete(self) -> Self:
        sets, further = _KINDS[self.distribution]
        given = [name for name in _PARAMETERS if getattr(self, name) is not None]
        needed = max(sets, key=lambda names: sum(name in given for name in names))
        for name in given:
            if name not in (*needed, *further):
                raise InputError(
                    said(
                        "does not apply to a {distribution} distribution, which takes {known}",
                        distribution=self.distribution,
                        known=", ".join((*needed, *further)),
                    ),
                    field=name,
                    value=getattr(self, name),
                )
        for name in needed:
            if name not in given:
                raise InputError(
                    said(
                        "is missing for a {distribution} distribution",
                        distribution=self.distribution,
                    ),
                    field=name,
                )
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
            for name, default in (("minimum", -math.inf), ("maximum", math.inf))
        )
        if not low < high:
            raise InputError(
                said("must be greater than minimum"),
                field="maximum",
                value=self.maximum,
            )
        match self.distribution:
            case "uniform":
                return Uniform(low, high)
            case "triangular":
                return self._triangular(field, in_file, low, high)
            case "normal":
                return self._normal(field, in_file, low, high)
            case "lognormal":
                law: Law = self._lognormal(field, in_file, low, high)
            case "weibull":
                law = self._weibull(field, in_file, low, high)
        self._check_middle(field, law)
        return law

    def _triangular(
        self, field: fields.Field, in_file: bool, low: float, high: float
    ) -> Triangular:
        mode = self._bound(field, "mode", in_file, low)
        if not low <= mode <= high:
            raise InputError(said("must be from minimum to maximum"), field="mode", value=self.mode)
        return Triangular(low, mode, high)

    def _normal(self, field: fields.Field, in_file: bool, low: float, high: float) -> Normal:
        mean = self._bound(field, "mean", in_file, 0.0)
        spread = _difference(field, "standard_deviation", self.standard_deviation, in_file)
        self._check_reach((low - mean) / spread, (high - mean) / spread)
        return Normal(mean, spread, low, high)

    def _lognormal(self, field: fields.Field, in_file: bool, low: float, high: float) -> Lognormal:
        threshold = self._begins_at(field, in_file)
        name = "mean" if self.median is None else "median"
        middle = self._bound(field, name, in_file, 0.0) - threshold
        if not middle > 0.0:
            raise InputError(
                said("must be greater than threshold, which is zero if it is not given"),
                field=name,
                value=getattr(self, name),
            )
        if name == "median":
            factor = _number("factor", self.factor)
            if not (factor > _LEAST_FACTOR and math.isfinite(factor)):
                raise InputError(
                    said("must be greater than 1"), field="factor", value=self.factor,
                    example="factor = 1.5",
                )  # fmt: skip
            median, deviation = middle, math.log(factor)
        else:
            spread = _difference(field, "standard_deviation", self.standard_deviation, in_file)
            # Johnson, Kotz and Balakrishnan (1994), eqs. 14.8a and b: of mean and variance
            variance = math.log1p((spread / middle) ** 2)
            median, deviation = middle * math.exp(-0.5 * variance), math.sqrt(variance)
        law = Lognormal(threshold, median, deviation, low, high)
        self._check_above_threshold(high, threshold)
        ends = (
            (math.log((bound - threshold) / median) if bound > threshold else -math.inf) / deviation
            for bound in (low, high)
        )
        self._check_reach(*ends)
        return law

    def _weibull(self, field: fields.Field, in_file: bool, low: float, high: float) -> Weibull:
        threshold = self._begins_at(field, in_file)
        shape = _number("shape", self.shape)
        if not 0.0 < shape <= _MOST_SHAPE:
            raise InputError(
                said("must be greater than 0 and at most {most:.6g}", most=_MOST_SHAPE),
                field="shape", value=self.shape, example="shape = 1.5",
            )  # fmt: skip
        law = Weibull(threshold, _difference(field, "scale", self.scale, in_file), shape, low, high)
        self._check_above_threshold(high, threshold)
        if law.hazard(low) > _GREATEST_HAZARD:
            raise InputError(
                said("lies so far above the scale that nothing would be left"),
                field="minimum",
                value=self.minimum,
            )
        return law

    def _check_above_threshold(self, high: float, threshold: float) -> None:
        if not high > threshold:
            raise InputError(
                said("must be greater than threshold, which is zero if it is not given"),
                field="maximum",
                value=self.maximum,
            )

    def _check_reach(self, low: float, high: float) -> None:
        """Refuse bounds, in standard deviations from the mean, that leave nothing between them."""
        if low < FARTHEST and high > -FARTHEST:
            return
        name = "minimum" if low >= FARTHEST else "maximum"
        raise InputError(
            said(
                "lies more than {most:.6g} standard deviations from the mean: nothing "
                "would be left",
                most=FARTHEST,
            ),
            field=name,
            value=getattr(self, name),
        )

    def _check_middle(self, field: fields.Field, law: Law) -> None:
        """Refuse a distribution of which the field does not even take the median."""
        middle = law.quantile(np.array([0.5]))
        if field.bounds is None or bool(field.bounds.allows(middle)[0]):
            return
        raise InputError(
            said(
                "have a median of {median}, but the field must be {limits}",
                median=str(field.written(float(middle[0]))),
                limits=field.limits,
            ),
            field="scale" if self.distribution == "weibull" else "threshold",
            example='threshold = "…", minimum = "…", maximum = "…"',
        )

    def written(self, field: fields.Field) -> Distribution:
        """Return the distribution with its quantities as text, as a file has it."""
        texts: dict[str, Any] = {}
        for name in _PARAMETERS:
            value = getattr(self, name)
            if value is None:
                continue
            if not isinstance(value, str):
                if name in (*_VALUES, "threshold"):
                    value = field.written(float(value))
                elif name in _DIFFERENCES and field.dimension is not None:
                    value = _written_difference(float(value), field.dimension)
            texts[name] = value
        return Distribution(distribution=self.distribution, **texts)

    def _bound(self, field: fields.Field, name: str, in_file: bool, default: float) -> float:
        value = getattr(self, name)
        if value is None:
            return default
        try:
            return float(field.checked(value, in_file=in_file))
        except InputError as error:
            raise error.with_details(field=name) from None

    def _begins_at(self, field: fields.Field, in_file: bool) -> float:
        """Return what the draws exceed: the field need not take it, but all that lies above."""
        if self.threshold is None:
            if field.dimension == "temperature":
                raise InputError(
                    said(
                        "is missing: temperatures have no natural zero that a distribution of this"
                        " kind could begin at"
                    ),
                    field="threshold",
                    example='threshold = "20 degC"',
                )
            return 0.0
        in_units = field.dimension is not None and (in_file or isinstance(self.threshold, str))
        if in_units and not isinstance(self.threshold, str):
            raise InputError(
                said("needs a unit"), field="threshold", value=self.threshold, example=field.example
            )
        if not in_units:
            return _number("threshold", self.threshold)
        assert field.dimension is not None
        try:
            return to_si(self.threshold, field.dimension)
        except InputError as error:
            raise error.with_details(field="threshold") from None


_PARAMETERS: Final = tuple(name for name in Distribution.model_fields if name != "distribution")


def _difference(field: fields.Field, name: str, value: object, in_file: bool) -> float:
    """Return a positive difference: of the field's dimension, but not within its limits."""
    if field.dimension is not None and (in_file or isinstance(value, str)):
        if not isinstance(value, str):
            raise InputError(
                said("needs a unit"),
                field=name,
                value=value,
                example=field.example,
            )
        try:
            spread = difference_in_si(value, field.dimension)
        except InputError as error:
            raise error.with_details(field=name) from None
    else:
        spread = _number(name, value)
    if not (spread > 0.0 and math.isfinite(spread)):
        raise InputError(said("must be positive"), field=name, value=value)
    return spread


def difference_in_si(text: str, dimension: Dimension) -> float:
    """Read a difference of two quantities of a dimension."""
    if dimension == "temperature" and not text.rstrip().endswith("K"):
        raise InputError(said("must be in K: it is a difference"), value=text, example='"2 K"')
    return to_si(text, dimension)


def _written_difference(value: float, dimension: Dimension) -> str:
    """Write a difference of two quantities: of temperatures in K, which is no temperature."""
    return f"{value!r} K" if dimension == "temperature" else from_si(value, dimension)


def _number(name: str, value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(said("must be a number"), field=name, value=value)
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
    coefficient: Annotated[float, Quantity(at_least=-1.0, at_most=1.0)] = Field(examples=[0.6])


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
        in_file = info.context == AT_THE_BORDER
        fields.refuse_rivals(tuple(self.fields), at="fields")
        for name, distribution in self.fields.items():
            field = fields.read_varied(name, at="fields")
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
        if info.context != AT_THE_BORDER:
            return table
        table["fields"] = {
            name: distribution.written(fields.read_varied(name)).model_dump(exclude_none=True)
            for name, distribution in self.fields.items()
        }
        if not self.correlations:
            del table["correlations"]
        return table
