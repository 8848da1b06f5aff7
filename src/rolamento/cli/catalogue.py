"""`rolamento catalogue`: search bearings, show one with what is inside."""

from __future__ import annotations

import dataclasses
import itertools
from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    plain_endings,
)
from rolamento.cli.grouped_help import GroupedCommands
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import CataloguesOption, JsonOption, LanguageOption
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import print_text, put
from rolamento.errors import InputError
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.catalogue import Catalogue, CatalogueBearing, InternalGeometry

__all__ = ["app"]

_MOST: Final = 40
_MOST_OF_ALL: Final = 1000


class _Commands(GroupedCommands):
    """A designation where a command is expected is shown, also one of several words."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Take the first words for a designation if they are no command and have a figure.

        Letters before the figure, as of ``QJ 210``, are then capitals; other words are misspelt
        commands.
        """
        first = args[0] if args else ""
        if first not in self.commands and not first.startswith("-"):
            has_figure = any(sign.isdigit() for sign in first)
            if has_figure or (first.isupper() and any(s.isdigit() for s in "".join(args[1:2]))):
                args = ["show", *args]
        if args and args[0] == "show":
            args = ["show", *_with_one_designation(args[1:])]
        return super().resolve_command(ctx, args)


def _with_one_designation(args: list[str]) -> list[str]:
    """Arguments with the words before the first option as one."""
    words = list(itertools.takewhile(lambda word: not word.startswith("-"), args))
    return [" ".join(words), *args[len(words) :]] if words else args


app = typer.Typer(
    cls=_Commands,
    no_args_is_help=True,
    rich_markup_mode=None,
)


@app.callback()
def catalogue(lang: LanguageOption = None) -> None:
    """Search bearings, and show the internal geometry of one.

    By designation: published data, and what is estimated from them.
    """


@app.command(cls=JsonCommand, epilog="Examples: search 62; search 'EX 70'; search 25x52x15.")
@with_outputs
def search(
    text: Annotated[
        str,
        typer.Argument(
            metavar="TEXT", help="Part of a designation, or boundary dimensions such as 25x52."
        ),
    ],
    most: Annotated[
        int, typer.Option("--most", metavar="N", help="Maximum number of results.")
    ] = _MOST,
    files: CataloguesOption = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """List the bearings whose designation contains a text."""
    with plain_endings(lang):
        outputs.check({"--json": json}, *(files or ()))
        if not 1 <= most <= _MOST_OF_ALL:
            raise InputError(
                said("must be between 1 and {most}", most=_MOST_OF_ALL), value=most, source="--most"
            )
        found = _catalogue(files).search(text, most + 1)
        _show_list(found[:most], len(found) <= most, json, outputs)
    raise typer.Exit(SOLVED if found else NO_RESULT)


@app.command(cls=JsonCommand, epilog="Examples: show 6205/C3; show 7205B --dynamic '14.8 kN'.")
@with_outputs
def show(
    designation: Annotated[
        str,
        typer.Argument(
            metavar="DESIGNATION", help="Designation, such as 6205/C3 or 'EX 70 25deg'."
        ),
    ],
    dynamic: Annotated[
        str | None,
        typer.Option(
            "--dynamic", metavar="FORCE", help="Dynamic load rating, instead of that in the list."
        ),
    ] = None,
    static: Annotated[
        str | None,
        typer.Option(
            "--static", metavar="FORCE", help="Static load rating, instead of that in the list."
        ),
    ] = None,
    axis: Annotated[
        bool,
        typer.Option("--axis", help="Print the candidates as an axis of a study file instead."),
    ] = False,
    files: CataloguesOption = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show a bearing by its designation.

    Published data with their sources, and the internal geometry, marked where estimated.
    """
    with plain_endings(lang):
        outputs.check({"--json": json}, *(files or ()))
        known = _catalogue(files)
        if dynamic or static:
            known = _with_ratings(known, designation, dynamic, static)
        from rolamento.tasks.catalogue import inside_of

        geometry = inside_of(known, designation)
        has_balls = geometry.has_elements
        if axis and has_balls:
            from rolamento.tasks.catalogue import axis_toml

            print_text(axis_toml(geometry))
        else:
            _show_one(geometry, json, outputs)
    raise typer.Exit(SOLVED if has_balls else NO_RESULT)


def _catalogue(files: list[str] | None) -> Catalogue:
    from rolamento.catalogue import catalogue

    return catalogue().beside(files or ())


def _with_ratings(
    known: Catalogue, designation: str, dynamic: str | None, static: str | None
) -> Catalogue:
    """Put ratings in the place of the list's; what the list infers from beside them goes."""
    from rolamento.catalogue import Catalogue
    from rolamento.units import to_si

    bearing = known.find(designation).bearing
    given: dict[str, Any] = {}
    for name, option, text in (
        ("dynamic_rating", "--dynamic", dynamic),
        ("static_rating", "--static", static),
    ):
        if text is None:
            continue
        try:
            value = to_si(text, "force")
        except InputError as error:
            raise error.with_details(source=option) from None
        if not 1.0 <= value <= 1e9:
            raise InputError(said("must be between 1 N and 1 GN"), value=text, source=option)
        given[name] = value
    sources = {**bearing.sources, **dict.fromkeys(given, "given")}
    own = dataclasses.replace(bearing, f0=None, **given, sources=sources)
    return Catalogue((*known.bearings, own))


def _show_list(
    found: tuple[CatalogueBearing, ...], is_all: bool, json: str | None, outputs: Outputs
) -> None:
    from rolamento.pages.catalogue import search_page
    from rolamento.tasks.catalogue import search_mapping

    if json is not None:
        from rolamento.io.json import dumps

        put(dumps(search_mapping(found)) + "\n", json)
    outputs.show(lambda: search_page(found, is_all=is_all), json)


def _show_one(geometry: InternalGeometry, json: str | None, outputs: Outputs) -> None:
    from rolamento.pages.catalogue import bearing_page
    from rolamento.tasks.catalogue import bearing_mapping

    if json is not None:
        from rolamento.io.json import dumps

        put(dumps(bearing_mapping(geometry)) + "\n", json)
    outputs.show(lambda: bearing_page(geometry), json)
