"""Severity of a machine's vibration: broadband RMS velocity on its bearing housings, and its zone.

The velocity is that between 10 and 1000 Hz, from 2 Hz below 600 rpm, of acceleration, velocity or
displacement (`rolamento.vibration.velocity`). Zones, by three boundaries of a class of machines:

    A  as of new machines                    B  fit for unrestricted long-term operation
    C  not fit for it: until it is mended    D  severe enough to cause damage

A value on a boundary belongs to the better zone. Classes, boundaries and the source of each figure
are in ``data/severity.toml``: groups 1 and 2 of ISO 20816-3:2022 (industrial machines above 15 kW,
120 to 30 000 rpm), on rigid or flexible supports, as ISO 10816-3:2009 had them; and classes I to IV
of ISO 10816-1:1995, which were those of ISO 2372. A support is rigid if the lowest natural
frequency of machine and support in the direction of measurement is at least 25 % above the main
excitation, in most cases the frequency of rotation.

An alarm is set over the baseline of the machine, its usual value,

    alarm = baseline + 0.25 v_BC ≤ 1.25 v_BC,    trip ≤ 1.25 v_CD.

A line of the spectrum on an edge of the band counts whole: the band is wider by two lines on either
side, as far as Hann's window smears a line. What the record's length, and a machine that is not
steady, leave uncertain is seen from the mean squares of its segments: their mean lies within
± t s √(1.056/n), with Student's t and the correlation of Hann's segments that overlap by half.

It says nothing of early damage of a bearing, whose impacts are short and lie above 1 kHz: they
hardly change the velocity. That is what `rolamento.vibration.diagnosis` looks for.

Sources: ISO 20816-3:2022; ISO 10816-3:2009, 5.4; ISO 10816-1:1995; Welch, IEEE Transactions on
Audio and Electroacoustics 15 (1967), for segments that overlap.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import field
from functools import cache
from math import isfinite, nan, pi, sqrt
from typing import Any, Final, Literal, get_args

import numpy as np

from rolamento.errors import InputError, arguments
from rolamento.io.data import toml_of
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import number, one_of
from rolamento.vibration.signal import Band, Quantity, Signal
from rolamento.vibration.spectrum import Spectrum
from rolamento.vibration.velocity import rms_in, velocity_of
from rolamento.words import Note, said

__all__ = [
    "ZONES",
    "AlarmSetting",
    "MachineClass",
    "Severity",
    "Support",
    "Zone",
    "alarm_setting",
    "band_at",
    "classes_of",
    "machine_classes",
    "measure_severity",
    "resolution_for",
]

Zone = Literal["A", "B", "C", "D"]
Support = Literal["rigid", "flexible"]
ZONES: Final = get_args(Zone)
CLASSES: Final = ("I", "II", "III", "IV")
CONFIDENCE: Final = 0.95
_KILO, _MILLI, _MICRO = 1e3, 1e-3, 1e-6
_RPM: Final = pi / 30.0
_LINES, _FEWEST_LINES = 20.0, 5.0
"""Lines from 0 to the lower edge of the band: of a long record, and of one that is just enough."""
_SEGMENTS: Final = 4.0
"""That a record is parted into, without overlap, as long as there are lines enough."""
_SMEARED: Final = 2.0
"""Lines on either side that Hann's window smears one to."""
_OVERLAP: Final = 1.056
"""1 + 2 ρ, ρ = 1/36 the correlation of the powers of two such segments that overlap by half."""
_CLEAR_OF_FILTER: Final = 2.56
"""Sampling rate over the highest frequency that recorders usually keep whole."""
_MOST_POWER: Final = 1e12


# --- classes of machines ---------------------------------------------------------------------


@frozen
class MachineClass:
    """Machines that are judged alike.

    Attributes
    ----------
    name
        "group 1, rigid" … or "class I" …
    standard
        "ISO 20816-3" or "ISO 10816-1"
    velocity
        boundaries A/B, B/C and C/D of the RMS velocity; m/s
    displacement
        of the RMS displacement; m, empty where the standard has none
    power
        from above which to which; W
    group, support
        of ISO 20816-3; 0 and "" of the other
    source, quoted, displacement_source
        of the figures; and the public place where those of the velocity were seen
    """

    name: str
    standard: str
    velocity: tuple[float, float, float]
    displacement: tuple[float, ...]
    power: tuple[float, float]
    group: int
    support: str
    source: str
    quoted: str
    displacement_source: str

    def zone_of(self, velocity: float) -> Zone:
        """Zone of an RMS velocity, m/s."""
        return _zone(velocity, self.velocity)

    def zone_of_displacement(self, displacement: float) -> Zone | None:
        """Zone of an RMS displacement, m; None where the standard has none."""
        return _zone(displacement, self.displacement) if self.displacement else None


def _zone(value: float, boundaries: tuple[float, ...]) -> Zone:
    zone: Zone = ZONES[sum(value > boundary for boundary in boundaries)]
    return zone


@cache
def machine_classes() -> tuple[MachineClass, ...]:
    """Return all classes, those of ISO 20816-3 first."""
    return tuple(
        MachineClass(
            row["name"],
            row["standard"],
            _three(row["velocity"]),
            tuple(_MICRO * value for value in row.get("displacement", ())),
            (_KILO * row["power"][0], _KILO * row["power"][1]),
            row.get("group", 0),
            row.get("support", ""),
            row["source"],
            row["quoted"],
            row.get("displacement_source", ""),
        )
        for row in toml_of("severity", "rolamento.vibration")["class"]
    )


def _three(values: list[float]) -> tuple[float, float, float]:
    first, second, third = (_MILLI * value for value in values)
    return first, second, third


def classes_of(
    *,
    group: int | None = None,
    support: str | None = None,
    power: float | None = None,
    machine_class: str | None = None,
) -> tuple[MachineClass, ...]:
    """Return the classes that a machine may be of, by what is known of it.

    Parameters
    ----------
    group
        Of ISO 20816-3: 1 above 300 kW, 2 from 15 kW.
    support
        "rigid" or "flexible".
    power
        Rated, which gives the group; W. Up to 15 kW a machine is of class I of ISO 10816-1.
    machine_class
        Instead: "I" to "IV" of ISO 10816-1.

    Returns
    -------
    One class where that is enough; all of ISO 20816-3 that remain otherwise.

    Raises
    ------
    InputError
        If a value is none of those, or two contradict each other.
    """
    known = machine_classes()
    if machine_class is not None:
        return (_old_class(machine_class, group, support, power, known),)
    if group is not None and group not in (1, 2):
        raise InputError(
            said("must be 1 or 2"), field="group", value=group, example=arguments(group=2)
        )
    if support is not None:
        one_of(support, "support", get_args(Support), arguments(support="rigid"))
    if power is not None:
        number(power, "power", above=0.0, most=_MOST_POWER, example=arguments(power="45 kW"))
        by_power = _group_of(power)
        if by_power and group not in (None, by_power):
            raise InputError(
                said(
                    "is that of machines above 300 kW; this one has {power:.6g} kW",
                    power=power / _KILO,
                )
                if group == 1
                else said(
                    "is that of machines from 15 to 300 kW; this one has {power:.6g} kW",
                    power=power / _KILO,
                ),
                field="group",
                value=group,
            )
        if not by_power:
            if group is not None:
                raise InputError(
                    said(
                        "is of machines above 15 kW; this one has {power:.6g} kW",
                        power=power / _KILO,
                    ),
                    field="group",
                    value=group,
                    example=arguments(machine_class="I"),
                )
            return (next(one for one in known if one.name == "class I"),)
        group = by_power
    return tuple(
        one
        for one in known
        if one.group and group in (None, one.group) and support in (None, one.support)
    )


def _group_of(power: float) -> int:
    """Group of ISO 20816-3 by the rated power; 0 for a machine that is too small."""
    groups = [one for one in machine_classes() if one.group]
    return next((one.group for one in groups if one.power[0] < power <= one.power[1]), 0) or (
        1 if power > max(one.power[1] for one in groups) else 0
    )


def _old_class(
    name: str,
    group: int | None,
    support: str | None,
    power: float | None,
    known: tuple[MachineClass, ...],
) -> MachineClass:
    one_of(name, "machine_class", CLASSES, arguments(machine_class="II"))
    for field_, value in (("group", group), ("support", support), ("power", power)):
        if value is not None:
            raise InputError(
                said("cannot be combined with a class of ISO 10816-1"), field=field_, value=value
            )
    return next(one for one in known if one.name == f"class {name}")


# --- alarms ----------------------------------------------------------------------------------


@frozen
class AlarmSetting:
    """Where to set alarm and trip; m/s.

    Attributes
    ----------
    baseline
        usual value of the machine; NaN if it is not known, and then the alarm is the boundary B/C
    alarm, trip
        of the RMS velocity; the trip is at most so high
    """

    baseline: float
    alarm: float
    trip: float


def alarm_setting(machine: MachineClass, baseline: float | None = None) -> AlarmSetting:
    """Return where to set the alarm of a machine: ISO 10816-3:2009, 5.4.

    Parameters
    ----------
    machine
        Its class.
    baseline
        Its usual RMS velocity, m/s.

    Raises
    ------
    InputError
        If the baseline is not positive.
    """
    rule = toml_of("severity", "rolamento.vibration")["alarm"]
    b_c, c_d = machine.velocity[1:]
    trip = rule["trip"] * c_d
    if baseline is None:
        return AlarmSetting(nan, b_c, trip)
    number(baseline, "baseline", above=0.0, most=1e3, example=arguments(baseline="1.2 mm/s"))
    alarm = min(baseline + rule["over_baseline"] * b_c, rule["greatest"] * b_c)
    return AlarmSetting(baseline, alarm, trip)


# --- measurement -----------------------------------------------------------------------------


@frozen(eq=False)
class Severity:
    """Vibration of a machine at one place.

    Attributes
    ----------
    band
        Hz
    velocity
        broadband RMS in the band; m/s, NaN if the sampling rate does not hold the band
    lower, upper
        between which it lies with the confidence, by the length of the record; m/s
    displacement
        broadband RMS in the band; m
    confidence
        of the limits
    speed
        of the shaft; rad/s, NaN if it is not known
    rate, duration
        Hz, s
    quantity
        that was measured
    density
        of the velocity, (m/s)²/Hz over Hz
    notes
        what a reader should know
    """

    band: Band
    velocity: float
    lower: float
    upper: float
    displacement: float
    confidence: float
    speed: float
    rate: float
    duration: float
    quantity: Quantity
    density: Spectrum
    notes: tuple[Note, ...] = field(default=())

    @property
    def measured(self) -> bool:
        """Whether the signal holds the band."""
        return isfinite(self.velocity)

    def certain_zones(self, machine: MachineClass) -> tuple[Zone, ...]:
        """Zones that the velocity may lie in, by the length of the record."""
        if not self.measured:
            return ()
        low, high = (ZONES.index(machine.zone_of(v)) for v in (self.lower, self.upper))
        return ZONES[low : high + 1]

    def to_mapping(self) -> dict[str, Any]:
        """Return the numbers as plain data, in SI units."""
        return {
            "band": list(self.band),
            "velocity": self.velocity,
            "velocity_lower": self.lower,
            "velocity_upper": self.upper,
            "confidence": self.confidence,
            "displacement": self.displacement,
            "speed": self.speed,
            "rate": self.rate,
            "duration": self.duration,
            "quantity": self.quantity,
            "notes": [note.to_mapping() for note in self.notes],
        }


def band_at(speed: float) -> Band:
    """Return the band at a speed, rad/s; that of fast machines if it is NaN. Hz."""
    rule = toml_of("severity", "rolamento.vibration")["band"]
    slow = abs(speed) < rule["slow_speed"] * _RPM * (1.0 - 1e-9)
    return (rule["slow_low"] if slow else rule["low"]), rule["high"]


def resolution_for(band: Band, duration: float) -> float:
    """Return the distance of lines that a record of a duration (s) allows for a band; Hz.

    Raises
    ------
    InputError
        If the record is too short for the lowest frequency.
    """
    coarsest = band[0] / _FEWEST_LINES
    least = 1.5 / coarsest  # two segments that overlap by half
    if duration < least * (1.0 - 1e-9):
        raise InputError(
            said(
                "must be at least {least:.6g} s for frequencies from {low:.6g} Hz on",
                least=least,
                low=band[0],
            ),
            field="duration",
            value=duration,
        )
    return min(max(band[0] / _LINES, _SEGMENTS / duration), coarsest)


def measure_severity(
    signal: Signal | Iterable[Signal],
    *,
    duration: float | None = None,
    speed: float | None = None,
    confidence: float = CONFIDENCE,
) -> Severity:
    """Broadband velocity of a signal.

    Parameters
    ----------
    signal
        Acceleration, velocity or displacement, in one piece, or as consecutive pieces that need not
        fit into memory together.
    duration
        Of all pieces together, s; that of a signal in one piece by default.
    speed
        Of the shaft, rad/s; by default that of the signal. It decides the lower end of the band.
    confidence
        Of the limits that the length of the record leaves.

    Raises
    ------
    InputError
        If the quantity is unknown, the signal too short, or does not change.
    """
    if duration is None:
        if not isinstance(signal, Signal):
            rule = said("must be given for a signal in pieces")
            raise InputError(rule, field="duration", example=arguments(duration=10.0))
        duration = signal.duration
    if speed is None:
        speed = signal.mean_speed if isinstance(signal, Signal) else nan
    speed = abs(speed)
    band = band_at(speed)
    resolution = resolution_for(band, duration)
    smeared = _SMEARED * resolution
    wide = (max(band[0] - smeared, 0.0), band[1] + smeared)
    velocity = velocity_of(signal, resolution, wide)
    notes = _notes(speed, velocity.rate, band, velocity.quantity)
    rms = low = high = moved = nan
    if band[1] <= 0.5 * velocity.rate:
        rms = rms_in(velocity.density, wide)
        low, high = _limits(rms**2, velocity.mean_squares, confidence)
        moved = rms_in(_displaced(velocity.density), wide)
    return Severity(
        band, rms, low, high, moved, confidence, speed, velocity.rate, velocity.duration,
        velocity.quantity, velocity.density, notes,
    )  # fmt: skip


def _notes(speed: float, rate: float, band: Band, quantity: Quantity) -> tuple[Note, ...]:
    scope = toml_of("severity", "rolamento.vibration")["scope"]
    notes = []
    if not isfinite(speed):
        notes.append(Note("severity_speed_unknown"))
    elif not scope["least_speed"] <= speed / _RPM <= scope["greatest_speed"]:
        notes.append(Note("severity_speed_outside", {"speed": speed}))
    if band[1] > 0.5 * rate:
        notes.append(Note("severity_band_missing", {"rate": rate, "high": band[1]}))
    elif rate < _CLEAR_OF_FILTER * band[1]:
        notes.append(Note("severity_near_half_rate", {"rate": rate}))
    if quantity != "velocity":
        notes.append(Note(f"velocity_from_{quantity}"))
    return tuple(notes)


def _displaced(density: Spectrum) -> Spectrum:
    """Density of the displacement, m²/Hz."""
    values = np.zeros(len(density.axis))
    values[1:] = density.values[1:] / (2.0 * np.pi * density.axis[1:]) ** 2
    return Spectrum(density.axis, values, "Hz", "m^2/Hz", density.resolution, density.averages)


def _limits(mean: float, squares: FloatArray, confidence: float) -> tuple[float, float]:
    """Limits of an RMS by its mean square and those of its segments."""
    from scipy.special import stdtrit

    count = len(squares)
    quantile = float(stdtrit(count - 1, 0.5 + 0.5 * confidence))
    half = quantile * float(np.std(squares, ddof=1)) * sqrt(_OVERLAP / count)
    return sqrt(max(mean - half, 0.0)), sqrt(mean + half)
