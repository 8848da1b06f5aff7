"""`rolamento rotor`: how shafts on their bearings vibrate."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Final

import typer

from rolamento.cli.common import NO_RESULT, SOLVED, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import (
    CataloguesOption,
    JsonOption,
    LanguageOption,
    MachineArgument,
    MachineSettingsOption,
    PlotOption,
)
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import put
from rolamento.cli.waiting import progress_of
from rolamento.errors import InputError
from rolamento.validate import one_of
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.tasks.rotor import MachineVibration

__all__ = ["app", "rotor"]

app = typer.Typer()

_PICTURES: Final = ("campbell", "modes", "unbalance")


@app.command(
    cls=JsonCommand,
    epilog="Examples: rotor machine.toml; rotor machine.toml --speeds 0..12000rpm --orders 1,2"
    " --plot campbell.png; rotor machine.toml --picture unbalance --plot unbalance.png"
    " --damping 2e-5.",
)
@with_outputs
def rotor(
    machine: MachineArgument,
    settings: MachineSettingsOption = None,
    speeds: Annotated[
        str | None,
        typer.Option(
            "--speeds",
            metavar="FIRST..LAST",
            help="Speeds of the shaft, such as 0..6000rpm; to 1.5 times its own by default.",
        ),
    ] = None,
    shaft: Annotated[
        str | None,
        typer.Option(
            "--shaft", metavar="NAME", help="Whose speeds; by default the first that turns."
        ),
    ] = None,
    points: Annotated[
        int, typer.Option("--points", metavar="N", help="How many speeds, 2 to 500.")
    ] = 40,
    modes: Annotated[
        int, typer.Option("--modes", metavar="N", help="How many modes, 1 to 60.")
    ] = 8,
    orders: Annotated[
        str,
        typer.Option(
            "--orders",
            metavar="LIST",
            help="Orders of the rotation that excite, such as 1,2 or the teeth of a gear.",
        ),
    ] = "1",
    damping: Annotated[
        float | None,
        typer.Option(
            "--damping",
            metavar="S",
            help="Damping over stiffness, in s; of the response 1e-5 by default, with a note.",
        ),
    ] = None,
    catalogues: CataloguesOption = None,
    json: JsonOption = None,
    plot: PlotOption = None,
    picture: Annotated[
        str,
        typer.Option(
            "--picture", metavar="NAME", help="What --plot draws: campbell, modes or unbalance."
        ),
    ] = "campbell",
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show natural frequencies and critical speeds of shafts.

    The bearings are solved anew at each speed: their stiffness changes with load and speed. Where
    masses of the machine are unbalanced, how they shake it.
    """
    with plain_endings(lang):
        outputs.check({"--json": json, "--plot": plot}, machine)
        one_of(picture, "", _PICTURES, source="--picture")
        from rolamento.pages.rotor import vibration_page
        from rolamento.tasks.rotor import machine_vibration

        with progress_of(said("parts of the calculation")) as progress:
            found = machine_vibration(
                machine,
                settings or (),
                catalogues or (),
                speeds=speeds,
                shaft=shaft,
                points=points,
                count=modes,
                orders=_orders(orders),
                damping=damping,
                progress=progress,
            )
        if json is not None:
            put(found.to_json() + "\n", json)
        if plot is not None:
            _draw(found, picture, plot)
        outputs.show(lambda: vibration_page(found), json)
    raise typer.Exit(SOLVED if found.converged else NO_RESULT)


def _orders(text: str) -> tuple[float, ...]:
    try:
        return tuple(float(one) for one in text.split(","))
    except ValueError:
        raise InputError(
            said("must be numbers with commas between them"),
            source="--orders", value=text[:60], example="--orders 1,2",
        ) from None  # fmt: skip


def _draw(found: MachineVibration, picture: str, path: str) -> None:
    from rolamento.plots.machine import campbell_figure, modes_figure, response_figure
    from rolamento.plots.saving import save_figure

    if picture == "unbalance":
        if found.response is None:
            raise InputError(
                said("is missing: nothing on shaft {shaft} is unbalanced",
                     shaft=f'"{found.campbell.shaft}"'),
                field="masses", example='unbalance = "100 g mm"',
            )  # fmt: skip
        save_figure(response_figure(found.response), path)
    elif picture == "modes":
        save_figure(modes_figure(found.modes), path)
    else:
        save_figure(campbell_figure(found.campbell), path)
