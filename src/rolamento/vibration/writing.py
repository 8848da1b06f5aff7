"""Writing a signal as a file that the readers of signals take back with all that it can hold.

A WAV file holds the rate, as a whole number, and 32-bit floats: seven digits of each sample, and
neither unit nor speed. NumPy's archive holds samples to the last bit, rate, unit and mean speed, a
CSV table nine digits of each sample and the same.
"""

from __future__ import annotations

import os
import struct
from math import isfinite
from typing import BinaryIO, Final

import numpy as np

from rolamento.errors import FileError, InputError
from rolamento.io.writing import written_whole
from rolamento.units import rpm_of
from rolamento.vibration.signal import Signal, require_signal
from rolamento.words import marked, said

ENDINGS: Final = (".wav", ".csv", ".npz")
_MOST_ROWS: Final = 5_000_000
_PIECE: Final = 2**16
_FLOAT: Final = 3
_HIGHEST_WAV_RATE: Final = 2**32 - 1


def check_signal_name(path: str | os.PathLike[str], count: int, rate: float) -> str:
    """Return the ending of a file for so many samples at a rate (Hz).

    Raises
    ------
    FileError, InputError
        If there is no such kind of file, or it cannot hold them.
    """
    path = os.fspath(path)
    ending = os.path.splitext(path)[1].lower()
    if ending not in ENDINGS:
        raise FileError(
            said("must end in one of {endings}", endings=", ".join(ENDINGS)),
            source=path,
            example="signal.npz",
        )
    if ending == ".wav" and not (rate == round(rate) and rate <= _HIGHEST_WAV_RATE):
        raise InputError(
            said("must be an integer number of Hz in a WAV file; other formats hold any"),
            field="rate",
            value=rate,
            source=path,
            example="signal.npz",
        )
    if ending == ".csv" and count > _MOST_ROWS:
        raise InputError(
            said(
                "must be at most {most} in a table; a .wav or .npz file holds more", most=_MOST_ROWS
            ),
            field=marked("number of samples"),
            value=count,
            source=path,
            example="signal.npz",
        )
    return ending


def write_signal(signal: Signal, path: str | os.PathLike[str]) -> None:
    """Write a signal as a file of the kind that its name ends in; an old one is overwritten.

    Raises
    ------
    FileError, InputError
        As `check_signal_name`, or if it cannot be written.
    """
    require_signal(signal)
    ending = check_signal_name(path, len(signal.samples), signal.rate)
    write = {".wav": _write_wav, ".csv": _write_csv, ".npz": _write_npz}[ending]
    with written_whole(path) as place, place.open("wb") as file:
        write(signal, file)


def _write_wav(signal: Signal, file: BinaryIO) -> None:
    samples = signal.samples.astype("<f4")
    rate, size = round(signal.rate), samples.nbytes
    about = struct.pack("<HHIIHHH", _FLOAT, 1, rate, min(4 * rate, 2**32 - 1), 4, 32, 0)
    fact = struct.pack("<4sII", b"fact", 4, len(samples))
    head = b"WAVE" + struct.pack("<4sI", b"fmt ", len(about)) + about + fact
    file.write(struct.pack("<4sI", b"RIFF", len(head) + 8 + size) + head)
    file.write(struct.pack("<4sI", b"data", size))
    file.write(samples.tobytes())


def _write_npz(signal: Signal, file: BinaryIO) -> None:
    arrays = {
        signal.quantity: signal.samples,
        "fs": np.array(signal.rate),
        "unit": np.array(signal.unit),
    }
    if isfinite(signal.mean_speed):
        arrays["rpm"] = np.array(rpm_of(signal.mean_speed))
    np.savez(file, **arrays)  # type: ignore[arg-type]  # a name of an array is no option


def _write_csv(signal: Signal, file: BinaryIO) -> None:
    head = [f"# fs = {signal.rate:.12g}"]
    if isfinite(signal.mean_speed):
        head.append(f"# rpm = {rpm_of(signal.mean_speed):.12g}")
    head.append(f"time (s),{signal.quantity} ({signal.unit})\n")
    file.write("\n".join(head).encode())
    for first in range(0, len(signal.samples), _PIECE):
        samples = signal.samples[first : first + _PIECE].tolist()
        times = ((first + np.arange(len(samples))) / signal.rate).tolist()
        lines = (f"{time:.12g},{value:.9g}\n" for time, value in zip(times, samples, strict=True))
        file.write("".join(lines).encode())
