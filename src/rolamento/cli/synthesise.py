"""`rolamento synthesise`: a vibration signal of a bearing with known damage, and its truth."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated, ClassVar, Final

import typer

from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    complain_of,
    plain_endings,
    words_of,
)
from rolamento.cli.grouped_help import GroupedCommand, Groups
from rolamento.cli.options import (
    BearingArgument,
    LagOption,
    LanguageOption,
    OuterSpeedOption,
    SettingsOption,
    SpeedOption,
)
from rolamento.cli.outputs import check_outputs
from rolamento.cli.streams import STANDARD_STREAM, print_text, put
from rolamento.errors import InputError

if TYPE_CHECKING:
    from rolamento.cli.synthesise_options import Asked
    from rolamento.cli.synthesise_recipe import Given
    from rolamento.report.language import Words
    from rolamento.report.synthesis_result import SynthesisResult
    from rolamento.vibration.synthesis import Recipe, Synthesis

__all__ = ["SynthesiseCommand", "synthesise"]

_MOST_IMPACTS: Final = 1_000_000
"""In a file of truth."""


class SynthesiseCommand(GroupedCommand):
    """`rolamento synthesise`, its help in groups."""

    groups: ClassVar[Groups] = {
        "Bearing and speed": ("settings", "speed", "outer_speed", "slip", "swing", "wander"),
        "Damage": ("faults", "jitter", "load", "load_turns"),
        "Way to the sensor": ("modes", "path"),
        "Noise and vibration": ("snr", "noise", "colour", "shaft_harmonics", "waviness"),
        "Signal": ("duration", "rate", "seed"),
        "Output": ("output", "truth", "lang", "help"),
    }


def synthesise(
    bearing: BearingArgument,
    output: Annotated[
        str,
        typer.Option(
            "--output", "-o", metavar="FILE", help="Of the signal: a .wav, .csv or .npz file."
        ),
    ],
    truth: Annotated[
        str | None,
        typer.Option(
            "--truth",
            metavar="FILE",
            help="Write all that is known of the signal as JSON; - is standard output.",
        ),
    ] = None,
    speed: SpeedOption = None,
    outer_speed: OuterSpeedOption = None,
    faults: Annotated[
        list[str] | None,
        typer.Option(
            "--fault",
            metavar="KIND[,KEY=VALUE…]",
            help="outer_race, inner_race, ball or cage; with strength, azimuth, jitter, slip,"
            " scatter, modulation, index, inner_gain. Repeats.",
        ),
    ] = None,
    jitter: Annotated[
        float | None,
        typer.Option(
            "--jitter",
            metavar="PART",
            help="Standard deviation of an interval over its mean, of all faults; 0.01.",
        ),
    ] = None,
    slip: LagOption = 0.0,
    snr: Annotated[
        float | None,
        typer.Option(
            "--snr",
            metavar="DB",
            help="Power of the faults, or without any of all the rest, over that of the noise.",
        ),
    ] = None,
    noise: Annotated[
        str | None,
        typer.Option("--noise", metavar="LEVEL", help="RMS instead, such as '0.5 m/s^2'."),
    ] = None,
    colour: Annotated[
        str, typer.Option("--colour", metavar="COLOUR", help="Of the noise: white or pink.")
    ] = "white",
    duration: Annotated[
        str, typer.Option("--duration", metavar="TIME", help="Such as '10 s'.")
    ] = "10 s",
    rate: Annotated[
        str, typer.Option("--rate", metavar="RATE", help="Of sampling, such as '12 kHz'.")
    ] = "51200 Hz",
    load: Annotated[
        str | None,
        typer.Option(
            "--load",
            metavar="KIND[,KEY=VALUE…]",
            help="uniform; radial with extent and azimuth; solved, of a case with a load, and then"
            " the default.",
        ),
    ] = None,
    load_turns: Annotated[
        float,
        typer.Option(
            "--load-turns",
            metavar="N",
            help="Speed of the load's direction over the shaft's: 1 for unbalance.",
        ),
    ] = 0.0,
    swing: Annotated[
        str | None,
        typer.Option(
            "--swing",
            metavar="DEPTH[,KEY=VALUE…]",
            help="Part by which the speed swings, with frequency and phase.",
        ),
    ] = None,
    wander: Annotated[
        str | None,
        typer.Option(
            "--wander",
            metavar="DEVIATION[,KEY=VALUE]",
            help="Part by which the speed wanders instead, with memory.",
        ),
    ] = None,
    modes: Annotated[
        list[str] | None,
        typer.Option(
            "--mode",
            metavar="FREQUENCY[,KEY=VALUE…]",
            help="Resonance that an impact excites, with damping and gain; 3500 Hz by default."
            " Repeats.",
        ),
    ] = None,
    path: Annotated[
        str | None,
        typer.Option(
            "--path",
            metavar="KEY=VALUE…",
            help="To the sensor: far_gain, of an impact on the far side, and sensor_azimuth.",
        ),
    ] = None,
    shaft_harmonics: Annotated[
        str | None,
        typer.Option(
            "--shaft-harmonics",
            metavar="A,A,…",
            help="Amplitudes at 1, 2, 3 … times the shaft's frequency, in m/s².",
        ),
    ] = None,
    waviness: Annotated[
        list[str] | None,
        typer.Option(
            "--waviness",
            metavar="SURFACE,KEY=VALUE…",
            help="Of outer, inner or ball: amplitude, such as '50 nm', with first, last, slope,"
            " direction. Repeats.",
        ),
    ] = None,
    seed: Annotated[
        int, typer.Option("--seed", metavar="N", help="Of all that is random, from 0 on.")
    ] = 0,
    settings: SettingsOption = None,
    lang: LanguageOption = None,
) -> None:
    """Make a vibration signal of a bearing with known damage.

    To try a diagnosis on: all that is known of it can be written as well.
    """
    with plain_endings(lang):
        _check_outputs(bearing, output, truth)
        from rolamento.cli.quantities import number_of, speed_given
        from rolamento.cli.synthesise_options import Asked
        from rolamento.cli.synthesise_recipe import given_of
        from rolamento.cli.waiting import PATIENCE_AT_WORK, waiting
        from rolamento.report.synthesis_words import SYNTHESIS_WORDS

        asked = Asked(
            bearing=bearing,
            settings=tuple(settings or ()),
            inner_speed=speed_given(speed, "--speed"),
            outer_speed=speed_given(outer_speed, "--outer-speed"),
            slip=slip,
            faults=tuple(faults or ()),
            jitter=jitter,
            snr=snr,
            noise=noise,
            colour=colour,
            duration=number_of(duration, "--duration", "time", "--duration '10 s'"),
            rate=number_of(rate, "--rate", "frequency", "--rate '12 kHz'"),
            load=load,
            load_turns=load_turns,
            swing=swing,
            wander=wander,
            modes=tuple(modes or ()),
            path=path,
            shaft_harmonics=shaft_harmonics,
            waviness=tuple(waviness or ()),
            seed=seed,
        )
        words = words_of(lang)
        with waiting(lang, SYNTHESIS_WORDS[words.code].making, PATIENCE_AT_WORK):
            given = given_of(asked)
            if given.state is not None and not given.state.status.converged:
                complain_of(given.state.status, lang)
                raise typer.Exit(NO_RESULT)
            found = _made(asked, given, output, truth)
            _write(found)
        _show(found, words)
    raise typer.Exit(SOLVED)


def _check_outputs(bearing: str, output: str, truth: str | None) -> None:
    """Refuse outputs that would run into each other or over the case file, and unknown kinds."""
    from rolamento.cli.signal_files import check_signal_name

    check_signal_name(output, 0, 1.0)
    check_outputs({"--output": output, "--truth": truth}, bearing)


def _made(asked: Asked, given: Given, output: str, truth: str | None) -> SynthesisResult:
    """Make the signal, after all that the options say was understood."""
    from rolamento.cli.signal_files import check_signal_name
    from rolamento.cli.synthesise_options import options_named
    from rolamento.cli.synthesise_recipe import load_name, recipe_from
    from rolamento.report.synthesis_result import SynthesisResult
    from rolamento.vibration.synthesis import synthesise

    recipe = recipe_from(asked, given)
    check_signal_name(output, recipe.count, recipe.rate)
    with options_named():
        made = synthesise(recipe)
    _refuse_silence(asked, recipe, made)
    if truth is not None and sum(len(one.times) for one in made.truth.faults) > _MOST_IMPACTS:
        raise InputError(
            f"would hold more than {_MOST_IMPACTS} impacts", source="--truth", value=truth
        )
    name, extent = load_name(asked, given)
    return SynthesisResult(
        name=given.name,
        source=asked.bearing,
        bearing=given.case.bearing,
        made=made,
        load=name,
        extent=extent,
        path=output,
        truth_path=truth,
    )


def _refuse_silence(asked: Asked, recipe: Recipe, made: Synthesis) -> None:
    """Refuse a ratio to faults that are never struck, and a signal without anything in it."""
    struck = any((one.strengths > 0.0).any() for one in made.truth.faults)
    if recipe.faults and asked.snr is not None and made.truth.noise_level == 0.0 and not struck:
        raise InputError(
            "is the ratio to faults that make no impact with any force: no ball is pressed where"
            " they lie, or the signal is too short",
            source="--snr",
            value=asked.snr,
            example="--noise '0.5 m/s^2'",
        )
    if not made.signal.samples.any():
        rule = "is silent: no part of it has any strength"
        if recipe.faults:
            rule += "; no ball is pressed where the damage lies, or the signal is too short"
        raise InputError(rule, field="signal", example="--load uniform")


def _write(found: SynthesisResult) -> None:
    from rolamento.cli.signal_files import write_signal
    from rolamento.report.synthesis_result import truth_json

    write_signal(found.made.signal, found.path)
    if found.truth_path is not None:
        put(truth_json(found) + "\n", found.truth_path)


def _show(found: SynthesisResult, words: Words) -> None:
    """Print the report, unless the truth went to standard output."""
    if found.truth_path == STANDARD_STREAM:
        return
    from rolamento.report.medium import Medium
    from rolamento.report.synthesis import synthesis_report

    print_text(synthesis_report(found, words, Medium.of(sys.stdout)))
