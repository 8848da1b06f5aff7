"""Reading vibration signals from files: WAV, CSV, NumPy, MATLAB, HDF5, Parquet and UFF 58.

`read_signal` takes a signal into memory, `open_signal` gives one in blocks, `channels_of` tells
what a file holds. `formats` finds the reader of a file; there is one module for each format.
"""

from rolamento.vibration.reading._channel import Channel, ReadingNote
from rolamento.vibration.reading._units import checked_unit
from rolamento.vibration.reading.opened import SignalFile, channels_of, open_signal, read_signal

__all__ = [
    "Channel",
    "ReadingNote",
    "SignalFile",
    "channels_of",
    "checked_unit",
    "open_signal",
    "read_signal",
]
