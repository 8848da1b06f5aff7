"""The command line: `rolamento`, and a module for each of its commands."""

from rolamento.cli.app import main

__all__ = ["main"]
