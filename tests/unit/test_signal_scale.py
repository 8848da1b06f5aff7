"""Units and sensitivities: what the samples of a file are worth."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.io.wavfile

from rolamento.errors import InputError
from rolamento.vibration.reading import checked_unit, open_signal, read_signal
from rolamento.words import Note

RATE = 1000.0
SAMPLES = np.random.default_rng(5).normal(size=200)
GRAVITY = 9.80665
METRE = "m/s^2"


@pytest.fixture
def plain(tmp_path: Path) -> Path:
    """Samples of which nobody says the unit."""
    np.save(tmp_path / "plain.npy", SAMPLES)
    return tmp_path / "plain.npy"


@pytest.fixture
def millivolts(tmp_path: Path) -> Path:
    """Samples that the file says are in mV."""
    rows = "\n".join(f"{x:.9f}" for x in SAMPLES)
    (tmp_path / "a.csv").write_text(f"fs: 1000\nsensor (mV)\n{rows}\n", "utf-8")
    return tmp_path / "a.csv"


@pytest.mark.parametrize(
    ("unit", "scale", "factor", "quantity", "si"),
    [
        # a sensitivity of 100 mV/g is 0.1 V per 9.80665 m/s²
        ("V", "100 mV/g", GRAVITY / 0.1, "acceleration", METRE),
        ("mV", "100 mV/g", GRAVITY / 100, "acceleration", METRE),
        ("uV", "0.1 V/g", GRAVITY / 1e5, "acceleration", METRE),
        ("volts", "10.2 mV/(m/s^2)", 1 / 0.0102, "acceleration", METRE),
        ("V", "10.2 mV/m/s²", 1 / 0.0102, "acceleration", METRE),
        ("V", "0.5g/V", GRAVITY / 2, "acceleration", METRE),
        ("mV", "98 (m/s²)/V", 0.098, "acceleration", METRE),
        ("V", "4 mV/mm/s", 0.25, "velocity", "m/s"),
        ("V", "1 in/s/V", 0.0254, "velocity", "m/s"),
        ("V", "-200 mV/mil", -25.4e-6 / 0.2, "displacement", "m"),
        ("counts", "3276.8 counts/g", GRAVITY / 3276.8, "acceleration", METRE),
        (None, "3276.8 counts/g", GRAVITY / 3276.8, "acceleration", METRE),
        (None, "10 g", 10 * GRAVITY, "acceleration", METRE),
        ("1", "5 g/1", 5 * GRAVITY, "acceleration", METRE),
        ("V", "2.5e1 mm/s", 0.025, "velocity", "m/s"),
        (None, 9.81 / 0.1, 98.1, "acceleration", METRE),
        ("V", np.float32(0.5), 0.5, "acceleration", METRE),
        ("counts", -2, -2.0, "acceleration", METRE),
    ],
)
def test_scale(plain: Path, unit: Any, scale: Any, factor: float, quantity: str, si: str) -> None:
    with open_signal(plain, rate=RATE, unit=unit, scale=scale) as file:
        assert (file.quantity, file.unit, file.calibrated) == (quantity, si, True)
        signal = file.read()
        (note,) = file.notes
    assert (signal.quantity, signal.unit) == (quantity, si)
    np.testing.assert_allclose(signal.samples, SAMPLES * factor, rtol=1e-12)
    assert note.key == "samples_multiplied"
    assert (note.values["scale"], note.values["unit"]) == (pytest.approx(factor), si)


def test_scale_of_another_quantity(plain: Path) -> None:
    signal = read_signal(plain, rate=RATE, unit="V", scale=0.02, quantity="velocity")
    assert (signal.quantity, signal.unit) == ("velocity", "m/s")
    np.testing.assert_allclose(signal.samples, SAMPLES * 0.02)


def test_scale_and_the_unit_of_the_file(millivolts: Path) -> None:
    with open_signal(millivolts) as file:
        assert (file.quantity, file.unit, file.calibrated) == ("unknown", "mV", False)
        assert file.notes == (Note("samples_not_calibrated", {"unit": "mV"}),)
        np.testing.assert_allclose(file.read().samples, SAMPLES, atol=1e-8)
    signal = read_signal(millivolts, scale="50 mV/g")
    np.testing.assert_allclose(signal.samples, SAMPLES * GRAVITY / 50, atol=1e-8)
    with pytest.raises(InputError, match=r'unit = "g": contradicts .*"mV"; .*scale="100 mV/g"'):
        read_signal(millivolts, unit="g")


def test_wav_of_16_bits_in_acceleration(tmp_path: Path) -> None:
    """The guide's example: a recorder of ±10 V and a sensor of 100 mV/g reach ±100 g."""
    volts = np.clip(SAMPLES, -9, 9)
    stored = np.round(volts / 10 * 2**15).astype(np.int16)
    scipy.io.wavfile.write(tmp_path / "a.wav", 8000, stored)
    expected = stored / 2**15 * 100 * GRAVITY
    np.testing.assert_allclose(read_signal(tmp_path / "a.wav", scale="100 g").samples, expected)
    by_volts = read_signal(tmp_path / "a.wav", unit="V", scale="10 mV/g")
    np.testing.assert_allclose(by_volts.samples, expected)
    with pytest.raises(InputError, match="; give the unit of the samples"):
        read_signal(tmp_path / "a.wav", scale="100 mV/g")
    with open_signal(tmp_path / "a.wav") as file:
        assert not file.calibrated


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"scale": 0.0}, "scale = 0.0: must be a number of magnitude from 1e-15 to 1e15 SI units"),
        ({"scale": float("nan")}, "scale = nan: must be a number"),
        ({"scale": float("inf")}, "scale = inf: must be a number"),
        ({"scale": 1e308}, "scale = 1e.308: must be a number"),
        ({"scale": 10**400}, "scale = a very long integer: must be a number"),
        ({"scale": True}, "scale = true: must be a number"),
        ({"scale": [1.0]}, "scale = a list: must be a number"),
        ({"scale": "98.1"}, 'scale = "98.1": is not a sensitivity'),
        ({"scale": ""}, "is not a sensitivity: a number with units of the signal and"),
        ({"scale": "mV/g"}, 'scale = "mV/g": is not a sensitivity'),
        ({"scale": "100 mV/furlong"}, 'scale = "100 mV/furlong": is not a sensitivity'),
        ({"scale": "100 g/mm"}, "is not a sensitivity: a number with units of the signal and"),
        ({"scale": "1,5 g"}, "is not a sensitivity: a number with units of the signal and"),
        ({"scale": "1e999 g"}, "must be a number of magnitude from"),
        ({"scale": "0 mV/g", "unit": "V"}, 'scale = "0 mV/g": must be a number of magnitude'),
        (
            {"scale": "1" * 500 + " g"},
            "is not a sensitivity: a number with units of the signal and",
        ),
        ({"scale": "9" + "/" * 50}, "is not a sensitivity: a number with units of the signal and"),
        ({"scale": "100 mV/g"}, 'unit: of the samples is not in the file.*unit="V"'),
        ({"scale": "100 mV/g", "unit": "counts"}, "is per mV, but the samples are in counts"),
        ({"scale": 2.0, "unit": "g"}, r'these are in g already; .* scale="10 g"'),
        ({"scale": "10 g", "quantity": "velocity"}, "gives acceleration, but .* as velocity"),
        ({"scale": 10.0, "quantity": "unknown"}, "needs the quantity that it gives"),
        ({"scale": 10.0, "quantity": "loudness"}, "quantity = .loudness.: must be one of"),
    ],
)
def test_scale_that_is_refused(plain: Path, arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        read_signal(plain, rate=RATE, **arguments)
    assert str(caught.value).startswith(str(plain))


@pytest.mark.parametrize(
    ("given", "unit"),
    [
        *[("m/s²", METRE), ("G", "g"), ("µm", "um"), ("ips", "in/s"), (" mm / s", "mm/s")],
        *[("V", "V"), ("volts", "V"), ("mV", "mV"), ("Counts", "counts"), ("FS", "1"), ("1", "1")],
    ],
)
def test_units_that_can_be_given(plain: Path, given: str, unit: str) -> None:
    assert checked_unit(given) == unit
    with open_signal(plain, rate=RATE, unit=given) as file:
        assert file.calibrated == (unit not in ("V", "mV", "counts", "1"))


@pytest.mark.parametrize(
    "given", ["furlong", "", "MV", "rpm", "Pa", "g/s", "\0", "x" * 10_000, None, 5]
)
def test_units_that_are_refused(plain: Path, given: Any) -> None:
    with pytest.raises(InputError, match=r"is not a unit of a signal; .*V, mV|must be text"):
        checked_unit(given)
    if given is not None:  # which means that the file is asked
        with pytest.raises(InputError, match=r"unit = .*(is not a unit of a signal|must be text)"):
            open_signal(plain, rate=RATE, unit=given)


def test_unit_of_the_file_that_nobody_knows(tmp_path: Path) -> None:
    """A heading such as [ai0] is no unit, and does not keep the user from giving one."""
    rows = "\n".join(f"{x:.9f}" for x in SAMPLES)
    (tmp_path / "a.csv").write_text(f"fs: 1000\nsensor [ai0]\n{rows}\n", "utf-8")
    assert read_signal(tmp_path / "a.csv").unit == "ai0"
    assert read_signal(tmp_path / "a.csv", unit="g").unit == METRE
