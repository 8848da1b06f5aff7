"""Files that somebody else wrote: how much of this machine they may take.

`bounds` says how much, in one place for all formats; `child` is the process in which the HDF5
library reads them, `hdf5_worker` what runs in it. See docs/adr/0011-foreign-files.md.
"""
