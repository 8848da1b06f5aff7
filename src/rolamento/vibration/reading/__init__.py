"""Reading vibration signals from files: WAV, CSV, NumPy, MATLAB, HDF5, Parquet and UFF 58.

`read_signal` takes a signal into memory, `open_signal` gives one in blocks, `channels_of` lists
what a file holds. `formats` finds the reader of a file: `arrays` for NumPy, MATLAB and HDF5, and
`wav`, `csv_file`, `parquet` and `uff`. `channels`, `metadata` and `units` say what a channel is,
what files call its rate, times and speed, and what its samples are worth.
"""

from rolamento.vibration.reading.channels import Channel
from rolamento.vibration.reading.signal_file import (
    SignalFile,
    channels_of,
    open_signal,
    read_signal,
)
from rolamento.vibration.reading.units import checked_unit

__all__ = [
    "Channel",
    "SignalFile",
    "channels_of",
    "checked_unit",
    "open_signal",
    "read_signal",
]
