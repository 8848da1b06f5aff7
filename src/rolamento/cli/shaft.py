"""`rolamento shaft`: shafts on their bearings, and what follows for each."""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum
from typing import TYPE_CHECKING, Annotated, Any

import typer

from rolamento.cli.common import NO_RESULT, SOLVED, Language, plain_endings
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
from rolamento.cli.streams import STANDARD_STREAM, complain, put
from rolamento.cli.waiting import progress_of, waiting
from rolamento.errors import InputError
from rolamento.words import said
from rolamento.words.reasons import reason

if TYPE_CHECKING:
    from rolamento.analysis.machine import MachineAnalysis

__all__ = ["app", "shaft"]

app = typer.Typer()


class Kind(StrEnum):
    """What is drawn of a machine."""

    machine = "machine"
    drawing = "drawing"
    deflection = "deflection"
    forces = "forces"
    bearings = "bearings"


@app.command(
    cls=JsonCommand,
    epilog="Examples: new --machine, then shaft machine.toml; shaft machine.toml"
    " --set loads.0.fz='-8 kN' --set bearings.A.designation=6310; shaft machine.toml --json"
    " result.json --xlsx result.xlsx; shaft machine.toml --report machine.pdf.",
)
@with_outputs
def shaft(
    machine: MachineArgument,
    settings: MachineSettingsOption = None,
    catalogues: CataloguesOption = None,
    json: JsonOption = None,
    plot: PlotOption = None,
    kind: Annotated[
        Kind,
        typer.Option(
            "--kind",
            metavar="KIND",
            help="With --plot: machine (drawing, deflection, moments, stress), drawing, "
            "deflection (of --step, or of all steps), forces (shear, moment, axial force, torque, "
            "stress), bearings (a load rosette each).",
        ),
    ] = Kind.machine,
    step: Annotated[
        int | None,
        typer.Option("--step", metavar="N", help="Step of the spectrum to draw, from 1."),
    ] = None,
    over: Annotated[
        str | None,
        typer.Option(
            "--over",
            metavar="KEY=FIRST..LAST",
            help="Vary a field of the machine, such as loads.0.fz=-1..-10kN.",
        ),
    ] = None,
    points: Annotated[
        int, typer.Option("--points", metavar="N", help="With --over, values of it, 2 to 500.")
    ] = 15,
    heat: Annotated[
        bool,
        typer.Option(
            "--heat", help="How warm the bearings run, and what becomes of their loads: [heat]."
        ),
    ] = False,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show loads, tilts and lives of the bearings on shafts.

    Every bearing is solved with the shaft, nonlinear and at speed, in each step of the spectrum.
    """
    with plain_endings(lang):
        outputs.check({"--json": json, "--plot": plot}, machine)
        from rolamento.tasks.machines import analysed_machine

        if heat:
            if over is not None:
                rule = said("cannot be combined with {before}", before="--over")
                raise InputError(rule, source="--heat")
            converged = _warm(machine, settings, catalogues, json, plot, outputs, lang)
            raise typer.Exit(SOLVED if converged else NO_RESULT)
        if over is not None:
            converged = _vary(machine, over, settings, catalogues, points, json, plot, outputs)
            raise typer.Exit(SOLVED if converged else NO_RESULT)
        with waiting(lang):
            found = analysed_machine(machine, settings or (), catalogues or ())
        if json is not None:
            put(found.to_json() + "\n", json)
        if plot is not None:
            _draw(found, kind, step, plot)
        from rolamento.pages.machine import machine_page, machine_report

        outputs.show(lambda: machine_page(found), json, report=lambda: machine_report(found))
        if STANDARD_STREAM in (json, outputs.csv):
            for case, code in enumerate(found.solved.status.code):
                if not found.solved.status.converged[case]:
                    name = found.solved.steps[case]
                    why = reason(str(code))
                    complain(f"{name}: {why}" if name else why)
    raise typer.Exit(SOLVED if found.converged else NO_RESULT)


def _draw(found: MachineAnalysis, kind: Kind, step: int | None, path: str) -> None:
    from rolamento.plots import machine
    from rolamento.plots.saving import save_figure

    solved = found.solved
    if step is not None and not 1 <= step <= len(solved):
        raise InputError(
            said("must be at least {at_least} and at most {at_most}", at_least=1,
                 at_most=len(solved)),
            source="--step", value=step,
        )  # fmt: skip
    if kind is Kind.deflection:
        save_figure(machine.draw_deflection(solved, step=None if step is None else step - 1), path)
        return
    draws: dict[Kind, Callable[..., Any]] = {
        Kind.machine: machine.machine_figure,
        Kind.drawing: machine.draw_machine,
        Kind.forces: machine.draw_section_forces,
        Kind.bearings: machine.draw_bearings_in_place,
    }
    save_figure(draws[kind](solved, step=0 if step is None else step - 1), path)


def _warm(
    machine: str,
    settings: list[str] | None,
    catalogues: list[str] | None,
    json: str | None,
    plot: str | None,
    outputs: Outputs,
    lang: Language | None,
) -> bool:
    """Show how warm the bearings of a machine run; return whether there is a state."""
    from rolamento.pages.machine_heat import machine_heat_page
    from rolamento.tasks.machines import heat_of_machine

    with waiting(lang):
        found = heat_of_machine(machine, settings or (), catalogues or ())
    if json is not None:
        put(found.to_json() + "\n", json)
    if plot is not None:
        from rolamento.plots.heat import machine_heat_figure
        from rolamento.plots.saving import save_figure

        save_figure(machine_heat_figure(found), plot)
    outputs.show(lambda: machine_heat_page(found), json)
    if STANDARD_STREAM in (json, outputs.csv) and not found.converged:
        complain(reason(found.status))
    return found.converged


def _vary(
    machine: str,
    over: str,
    settings: list[str] | None,
    catalogues: list[str] | None,
    points: int,
    json: str | None,
    plot: str | None,
    outputs: Outputs,
) -> bool:
    """Show a machine over one of its fields; return whether every point has a result."""
    from rolamento.pages.machine import machine_over_page
    from rolamento.tasks.machines import machine_over

    with progress_of(said("machines solved")) as progress:
        found = machine_over(
            machine, over, settings or (), catalogues or (), points=points, progress=progress
        )
    if json is not None:
        put(found.to_json() + "\n", json)
    if plot is not None:
        from rolamento.plots.machine import machine_over_figure
        from rolamento.plots.saving import save_figure

        save_figure(machine_over_figure(found), plot)
    outputs.show(lambda: machine_over_page(found), json)
    return found.converged
