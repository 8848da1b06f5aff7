"""The command line: `rolamento solve`, `rolamento demo`."""

from rolamento.cli.app import main

__all__ = ["main"]
