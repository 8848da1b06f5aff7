"""The commands by their names. One is read when it is called: `--version` waits for nothing."""

from __future__ import annotations

import atexit
import gc
import sys
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from importlib import import_module
from itertools import chain
from typing import Annotated, Any, Final

import typer
from typer.main import get_group_from_info
from typer.models import TyperInfo

import rolamento
from rolamento.cli.common import SOLVED, WRONG_INPUT, plain_endings
from rolamento.cli.grouped_help import GroupedCommands, Groups
from rolamento.cli.options import LanguageOption
from rolamento.cli.streams import end_of_output, print_text

COMMANDS: Final[Groups] = {
    "To start with": ("demo", "app", "new", "examples", "warm"),
    "Inside the bearing": ("solve", "turn", "friction", "heat", "static", "electrical", "report"),
    "The machine around it": ("shaft", "rotor", "import", "export"),
    "Life and life tests": ("life", "weibull", "weibull-plan", "replace", "trend"),
    "Vibration": ("frequencies", "diagnose", "severity", "synthesise", "anderon"),
    "Catalogue and clearance": ("catalogue", "clearance", "speed"),
    "Studies and figures": ("sweep", "tolerance", "seek", "plot"),
    "Verification": ("verify", "reproduce"),
}
"""What a person wants, and the commands for it: in the help, the front pages and the guide."""


_MODULES: Final = {
    "app": "browser", "demo": "solve", "examples": "new", "import": "exchange",
    "export": "exchange",
}  # fmt: skip
"""Modules of commands that have none of their own name."""

_REQUESTS: Final = {
    "anderon": "noise:NoiseLevel",
    "diagnose": "vibration_diagnosis:VibrationDiagnosis",
    "seek": "seek:GoalSeek",
    "severity": "severity:VibrationSeverity",
    "weibull": "weibull:LifeTestEvaluation",
}
"""Commands that are made of a request."""

_SOLVING: Final = {
    "demo", "app", "solve", "turn", "friction", "heat", "static", "electrical", "report", "life",
    "sweep", "shaft", "rotor", "export",
