"""Machines to and from the files of other programs: readers and writers, without physics."""
