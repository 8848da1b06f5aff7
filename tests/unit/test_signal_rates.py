"""Which of a file's numbers is the sampling rate, which the shaft's speed, and who decides."""

from __future__ import annotations

from math import pi
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
import scipy.io

from rolamento.errors import InputError
from rolamento.vibration.reading import channels_of, open_signal, read_signal

SAMPLES = np.random.default_rng(3).normal(size=4000)


def mfpt(path: Path, **changed: float) -> None:
    """A file of the Machinery Failure Prevention Technology Society: a structure of one element."""
    fields = {"sr": 48828.0, "gs": SAMPLES[:, None], "load": 270.0, "rate": 25.0}
    scipy.io.savemat(path, {"bearing": {**fields, **changed}})


def test_sampling_rate_beside_the_shafts(tmp_path: Path) -> None:
    mfpt(tmp_path / "a.mat")
    with open_signal(tmp_path / "a.mat") as file:
        assert (file.channel.name, file.rate, file.speed) == ("bearing.gs", 48828.0, None)
        assert file.speeds_perhaps == {"bearing.rate": 25.0}
        assert [note.key for note in file.choices] == ["rate_aside"]
        (note,) = file.notes
        assert note.values == {"rate": 48828.0, "name": '"rate"', "value": 25.0}
        assert note.text.startswith('The sampling rate is 48 828 Hz; "rate" = 25 of the file')
    at_speed = read_signal(tmp_path / "a.mat", speed_channel="bearing.rate", speed_unit="Hz")
    assert at_speed.mean_speed == pytest.approx(2 * pi * 25)


def test_the_same_in_hdf5(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "a.h5", "w") as file:
        for name, value in {"sr": 97656.0, "gs": SAMPLES, "rate": 25.0}.items():
            file[f"bearing/{name}"] = value
    (channel,) = channels_of(tmp_path / "a.h5")
    assert (channel.rate, channel.rate_aside) == (97656.0, ('"rate"', 25.0))


@pytest.mark.parametrize(
    ("numbers", "doubt"),
    [
        ({"fs": 48828.0, "rate": 51200.0}, '"fs" says 48 828 Hz and "rate" says 51 200 Hz'),
        ({"fs": 1200.0, "rate": 100.0}, '"fs" says 1200 Hz and "rate" says 100 Hz'),
        ({"fs": 12000.0, "dt": 1e-4}, '"fs" says 12 000 Hz and "dt" = 0.0001 s says 10 000 Hz'),
        ({"fs": 12000.0, "sr": 12100.0}, '"fs" says 12 000 Hz and "sr" says 12 100 Hz'),
        ({"rate": 25.0}, '"rate" says 25 Hz, which may be the speed of the shaft as well'),
    ],
)
def test_rates_that_disagree_are_asked_about(
    tmp_path: Path, numbers: dict[str, float], doubt: str
) -> None:
    np.savez(tmp_path / "a.npz", x=SAMPLES, **numbers)
    with pytest.raises(InputError) as caught:
        read_signal(tmp_path / "a.npz")
    assert f"is ambiguous: in the file {doubt}; give it, in Hz" in str(caught.value)
    with open_signal(tmp_path / "a.npz", rate=12_000.0) as file:
        assert (file.rate, file.choices[0].key) == (12_000.0, "rate_over_doubt")


@pytest.mark.parametrize(
    "numbers", [{"fs": 12000.0, "rate": 12001.0}, {"rate": 12000.0}, {"dt": 1 / 12000.0}]
)
def test_rates_that_agree(tmp_path: Path, numbers: dict[str, float]) -> None:
    np.savez(tmp_path / "a.npz", x=SAMPLES, **numbers)
    with open_signal(tmp_path / "a.npz") as file:
        assert (file.rate, file.notes) == (pytest.approx(12000.0), ())


def test_the_rate_that_is_given_wins(tmp_path: Path) -> None:
    mfpt(tmp_path / "a.mat")
    with open_signal(tmp_path / "a.mat", rate=97656.0) as file:
        assert file.rate == 97656.0
        assert [note.key for note in file.choices] == ["rate_over_file"]
        assert file.choices[0].values == {"rate": 97656.0, "file": 48828.0}
    np.savez(tmp_path / "a.npz", x=SAMPLES, fs=12000.0)
    assert read_signal(tmp_path / "a.npz", rate=48000.0).duration == len(SAMPLES) / 48000.0


@pytest.mark.parametrize(
    ("name", "value", "speed"),
    [
        ("rpm", 1500.0, 50 * pi),
        ("shaft_rpm", 1500.0, 50 * pi),
        ("motor speed (rpm)", 1500.0, 50 * pi),
        ("shaft_speed_Hz", 25.0, 50 * pi),
        ("rotation frequency", 25.0, 50 * pi),
        ("velocidade_rpm", 1500.0, 50 * pi),
        ("shaft_speed", 25.0, None),
        ("load_rpm_max", 25.0, None),
    ],
)
@pytest.mark.thirds
def test_names_that_say_the_shafts_speed(
    tmp_path: Path, name: str, value: float, speed: float | None
) -> None:
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file["one/x"], file["one/fs"] = SAMPLES, 12000.0
        file[f"one/{name}"] = value
    (channel,) = channels_of(tmp_path / "a.h5")
    assert channel.speed == (None if speed is None else pytest.approx(speed))


def table(path: Path, head: str, *, comma: bool = False, times: bool = False) -> None:
    rows = [
        f"{n / 25600:.7f};{x:.4f}" if times else f"{x:.4f};{-x:.4f}" for n, x in enumerate(SAMPLES)
    ]
    text = "\n".join(rows)
    names = "time;acc" if times else "one;two"
    path.write_text(f"{head}\n{names}\n{text.replace('.', ',') if comma else text}\n", "utf-8")


def test_thousands_point_of_a_collector(tmp_path: Path) -> None:
    """`Fs: 25.600 Hz` is 25 600 Hz where times or decimal commas say so; else it is asked about."""
    path = tmp_path / "a.csv"
    table(path, "Fs: 25.600 Hz", times=True)
    assert read_signal(path).rate == pytest.approx(25600.0)
    table(path, "Fs: 25.600 Hz", comma=True)
    assert read_signal(path, channel=1).rate == 25600.0
    table(path, "Fs: 25.600 Hz")
    with pytest.raises(InputError) as caught:
        read_signal(path, channel=1)
    told = str(caught.value)
    assert 'a.csv, line 1: Fs = "25.600": is 25.6 if the point is the decimal mark' in told
    assert "and 25600 if it separates thousands" in told
    assert 'decimal_mark="comma" for 25600' in told
    assert "rate=" not in told
    with open_signal(path, channel=1, rate=25600.0) as opened:
        (over,) = opened.notes
    assert '"Fs: 25.600" says 25.6 Hz or 25 600 Hz, by its point' in over.text
    assert read_signal(path, channel=1, rate=25600.0).rate == 25600.0
    assert read_signal(path, channel=1, decimal_mark="point").rate == 25.6
    table(path, "Fs: 25.6 kHz\nSpeed: 1797 rpm")
    signal = read_signal(path, channel=1)
    assert (signal.rate, signal.mean_speed) == (25600.0, pytest.approx(1797 * pi / 30))


@pytest.mark.parametrize(
    ("cell", "arguments", "value"),
    [
        ("1.234", {"decimal_mark": "point"}, 1.234),
        ("1.234", {"decimal_mark": "comma"}, 1234.0),
        ("1.234,5", {}, 1234.5),
        ("1.234.567", {}, 1234567.0),
        ("0.234", {}, 0.234),
        ("1,5", {}, 1.5),
        ("1,234.5", {"decimal_mark": "point"}, 1234.5),
    ],
)
def test_decimal_marks_of_samples(
    tmp_path: Path, cell: str, arguments: dict[str, Any], value: float
) -> None:
    path = tmp_path / "a.csv"
    path.write_text("load;speed\n" + f"7;{cell}\n" * 9 + "8;9\n", "utf-8")
    read = read_signal(path, channel=2, rate=1000.0, **arguments)
    assert read.samples[0] == pytest.approx(value)


def test_decimal_marks_that_are_asked_about(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    path.write_text("load;speed\n" + "7;1.234\n" * 9 + "8;9\n", "utf-8")
    with pytest.raises(
        InputError, match=r'"1.234": is 1.234 if .* and 1234 if it separates thousands'
    ):
        channels_of(path)
    path.write_text("# decimal mark: comma\nload;speed\n" + "7;1.234\n" * 9 + "8;9\n", "utf-8")
    assert read_signal(path, channel=2, rate=1.0).samples[0] == 1234.0
    with pytest.raises(InputError, match='decimal_mark = "dot": must be one of point, comma'):
        read_signal(path, channel=2, rate=1.0, decimal_mark="dot")
    path.write_text("load;speed\n" + "7;12.5\n" * 9 + "8;9\n", "utf-8")
    with pytest.raises(InputError, match="is not a number"):
        read_signal(path, channel=2, rate=1.0, decimal_mark="comma")
