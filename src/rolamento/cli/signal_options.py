"""The options of commands that read a signal, in the words of `SignalRequest`."""

from __future__ import annotations

from typing import Annotated, Final

import typer

from rolamento.tasks.signals import SignalRequest

__all__ = ["ChannelOption", "DurationOption", "RateOption", "ScaleOption", "StartOption"]

_ASKED: Final = SignalRequest.meanings()

ChannelOption = Annotated[
    str | None,
    typer.Option("--channel", metavar="CHANNEL", help=_ASKED["channel"]),
]
RateOption = Annotated[
    str | None,
    typer.Option(
        "--rate",
        metavar="RATE",
        help=_ASKED["rate"],
    ),
]
ScaleOption = Annotated[
    str | None,
    typer.Option("--scale", metavar="SCALE", help=_ASKED["scale"]),
]
StartOption = Annotated[
    str | None,
    typer.Option("--start", metavar="TIME", help=_ASKED["start"]),
]
DurationOption = Annotated[
    str | None,
    typer.Option("--duration", metavar="TIME", help=_ASKED["duration"]),
]
