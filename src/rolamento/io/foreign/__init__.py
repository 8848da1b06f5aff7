"""Files that come from elsewhere: how much of this machine they may take, and who reads them.

`bounds` says how much, in one place for all formats. `isolated` runs the libraries that a damaged
file can bring down in a process of their own, and `readers` is what runs there. See
docs/adr/0011-foreign-files.md and docs/adr/0013-formats-by-libraries.md.
"""
