"""`rolamento synthesise`: a vibration signal of a bearing with known damage, and its truth."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final

import typer

from rolamento.cli.case_options import CASE_OPTIONS, NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import NO_RESULT, SOLVED, complain_of, plain_endings
from rolamento.cli.grouped_help import Groups
from rolamento.cli.option_names import in_options
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import (
    BearingArgument,
    LagOption,
    LanguageOption,
    OuterSpeedOption,
    SpeedOption,
)
from rolamento.cli.outputs import check_outputs
from rolamento.cli.streams import STANDARD_STREAM, put_json, show
from rolamento.errors import InputError
from rolamento.tasks.quantities import fields_of
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.tasks.quantities import Kind
    from rolamento.tasks.synthesis import SynthesisResult
    from rolamento.vibration.synthesis import (
        Fault,
        Mode,
        Noise,
        SwingingSpeed,
        TransferPath,
        WanderingSpeed,
        Waviness,
    )

KINDS: Final[dict[str, dict[str, Kind]]] = {
    "--fault": {
        "kind": "text",
        "strength": "number",
        "azimuth": "angle",
        "jitter": "number",
        "slip": "text",
        "scatter": "number",
        "modulation": "text",
        "index": "number",
        "inner_gain": "number",
    },
    "--mode": {"frequency": "frequency", "damping": "number", "gain": "acceleration"},
    "--path": {"sensor_azimuth": "angle", "far_gain": "number"},
    "--load": {"kind": "text", "extent": "number", "azimuth": "angle"},
    "--swing": {"depth": "number", "frequency": "frequency", "phase": "angle"},
    "--wander": {"deviation": "number", "memory": "time"},
    "--waviness": {
        "surface": "text",
        "amplitude": "length",
        "first": "whole",
        "last": "whole",
        "slope": "number",
        "direction": "text",
    },
}
"""Keys of the options that give a record by fields. The first may stand alone, but of --path."""
EXAMPLES: Final = {
    "--fault": "--fault inner_race,strength=2,jitter=0.02",
    "--mode": "--mode '3500 Hz,damping=0.03,gain=10'",
    "--path": "--path far_gain=0.3,sensor_azimuth='90 deg'",
    "--load": "--load radial,extent=0.5",
    "--swing": "--swing 0.02,frequency='0.3 Hz'",
    "--wander": "--wander 0.005,memory='2 s'",
    "--waviness": "--waviness outer,amplitude='50 nm',last=60",
    "--snr": "--snr -8",
    "--noise": "--noise '0.5 m/s^2'",
    "--colour": "--colour pink",
    "--slip": "--slip 0.01",
    "--rate": "--rate '51.2 kHz'",
    "--duration": "--duration '10 s'",
    "--load-turns": "--load-turns 1",
    "--shaft-harmonics": "--shaft-harmonics 0.5,0.2",
    "--seed": "--seed 1",
    "--speed": "--speed '1797 rpm'",
}
_OPTIONS: Final = {
    "rate": "--rate",
    "duration": "--duration",
    "seed": "--seed",
    "load_turns": "--load-turns",
    "shaft_harmonics": "--shaft-harmonics",
    "modes": "--mode",
    "modes.frequency": "--mode",
    "faults": "--fault",
    "faults.impacts": "--fault",
    "waviness": "--waviness",
    "waviness.lines": "--waviness",
    "waviness.direction": "--waviness",
    "speed": "--speed",
    "ratio": "--snr",
    "level": "--noise",
    "colour": "--colour",
    "slip": "--slip",
    "extent": "--load",
    "load": "--load",
    "depth": "--swing",
    "frequency": "--swing",
    "deviation": "--wander",
    "memory": "--wander",
}
"""Options of fields that the recipe and the synthesis check, the options that give them."""


_LOADS: Final = ("uniform", "radial", "solved")


class SynthesiseCommand(JsonCommand):
    """`rolamento synthesise`, its help in groups."""

    groups: ClassVar[Groups] = {
        "Bearing": tuple(one for one in CASE_OPTIONS if "speed" not in one),
        "Speed": ("speed", "outer_speed", "slip", "swing", "wander"),
        "Damage": ("faults", "jitter", "load", "load_turns"),
        "Transmission path": ("modes", "path"),
        "Noise and vibration": ("snr", "noise", "colour", "shaft_harmonics", "waviness"),
        "Signal": ("duration", "rate", "seed"),
        "Output": ("output", "truth", "lang", "help"),
    }


app = typer.Typer()


@app.command(
    cls=SynthesiseCommand,
    epilog="Example: synthesise 6205 --speed '1797 rpm' --fault inner_race --load radial --snr -8"
    " --rate '12 kHz' --output inner.npz --truth inner.json.",
)
@with_case
def synthesise(
    bearing: BearingArgument,
    output: Annotated[
        str,
        typer.Option(
            "--output", "-o", metavar="FILE", help="File of the signal: .wav, .csv or .npz."
        ),
    ],
    truth: Annotated[
        str | None,
        typer.Option(
            "--truth",
            metavar="FILE",
            help="Write all that is known of the signal as JSON; - for standard output.",
        ),
    ] = None,
    speed: SpeedOption = None,
    outer_speed: OuterSpeedOption = None,
    faults: Annotated[
        list[str] | None,
        typer.Option(
            "--fault",
            metavar="KIND[,KEY=VALUE…]",
            help="outer_race, inner_race, ball (or roller) or cage; with strength, azimuth, "
            "jitter, slip, scatter, modulation, index, inner_gain. Repeatable.",
        ),
    ] = None,
    jitter: Annotated[
        float | None,
        typer.Option(
            "--jitter",
            metavar="FRACTION",
            help="Standard deviation of the impact intervals over their mean, for "
            "all faults (default 0.01).",
        ),
    ] = None,
    slip: LagOption = 0.0,
    snr: Annotated[
        float | None,
        typer.Option(
            "--snr",
            metavar="DB",
            help="Signal-to-noise ratio: power of the faults, or of everything else "
            "if there are none, over that of the noise.",
        ),
    ] = None,
    noise: Annotated[
        str | None,
        typer.Option(
            "--noise", metavar="LEVEL", help="RMS of the noise instead, such as '0.5 m/s^2'."
        ),
    ] = None,
    colour: Annotated[
        str, typer.Option("--colour", metavar="COLOUR", help="Colour of the noise: white or pink.")
    ] = "white",
    duration: Annotated[
        str, typer.Option("--duration", metavar="TIME", help="Duration, such as '10 s'.")
    ] = "10 s",
    rate: Annotated[
        str, typer.Option("--rate", metavar="RATE", help="Sampling rate, such as '12 kHz'.")
    ] = "51200 Hz",
    load: Annotated[
        str | None,
        typer.Option(
            "--load",
            metavar="KIND[,KEY=VALUE…]",
            help="uniform; radial with extent and azimuth; or solved, the default "
            "for a case with a load.",
        ),
    ] = None,
    load_turns: Annotated[
        float,
        typer.Option(
            "--load-turns",
            metavar="N",
            help="Speed of the load direction over that of the shaft: 1 for unbalance.",
        ),
    ] = 0.0,
    swing: Annotated[
        str | None,
        typer.Option(
            "--swing",
            metavar="DEPTH[,KEY=VALUE…]",
            help="Fraction by which the speed oscillates, with frequency and phase.",
        ),
    ] = None,
    wander: Annotated[
        str | None,
        typer.Option(
            "--wander",
            metavar="DEVIATION[,KEY=VALUE]",
            help="Fraction by which the speed wanders at random instead, with memory.",
        ),
    ] = None,
    modes: Annotated[
        list[str] | None,
        typer.Option(
            "--mode",
            metavar="FREQUENCY[,KEY=VALUE…]",
            help="Resonance excited by an impact, with damping and gain; 3500 Hz by "
            "default. Repeatable.",
        ),
    ] = None,
    path: Annotated[
        str | None,
        typer.Option(
            "--path",
            metavar="KEY=VALUE…",
            help="Path to the sensor: far_gain, of an impact on the far side, and sensor_azimuth.",
        ),
    ] = None,
    shaft_harmonics: Annotated[
        str | None,
        typer.Option(
            "--shaft-harmonics",
            metavar="A,A,…",
            help="Amplitudes at 1, 2, 3 … times the shaft frequency, in m/s².",
        ),
    ] = None,
    waviness: Annotated[
        list[str] | None,
        typer.Option(
            "--waviness",
            metavar="SURFACE,KEY=VALUE…",
            help="Waviness of outer, inner or ball (or roller): amplitude, such as '50 nm', "
            "with first, last, slope, direction. Repeatable.",
        ),
    ] = None,
    seed: Annotated[
        int, typer.Option("--seed", metavar="N", help="Seed of all random numbers, from 0.")
    ] = 0,
    given: CaseOptions = NOTHING_GIVEN,
    lang: LanguageOption = None,
) -> None:
    """Make a vibration signal of a bearing with known damage.

    To test a diagnosis: the full ground truth can be written as well.
    """
    with plain_endings(lang), given.in_force(), _named(_OPTIONS), in_options(synthesise):
        check_outputs({"--output": output, "--truth": truth}, bearing)
        from rolamento import tasks
        from rolamento.cli.waiting import waiting
        from rolamento.tasks.quantities import number_of
        from rolamento.vibration.writing import check_signal_name

        check_signal_name(output, 0, 1.0)
        with waiting(lang, said("making the signal")):
            planted = [_fault(text, jitter) for text in faults or ()]
            waves = [_waviness(text) for text in waviness or ()]
            harmonics = _harmonics(shaft_harmonics)
            found = tasks.synthesise(
                bearing,
                output,
                speed=speed,
                outer_speed=outer_speed,
                slip=slip,
                faults=planted,
                **_load(load),
                load_turns=load_turns,
                speed_profile=_speed_profile(swing, wander),
                transfer=_transfer(path),
                modes=[_mode(text) for text in modes or ()],
                shaft_harmonics=harmonics,
                waviness=waves,
                noise=_noise(snr, noise, colour, bool(planted), bool(waves or harmonics)),
                duration=number_of(duration, "--duration", "time", "--duration '10 s'"),
                rate=number_of(rate, "--rate", "frequency", "--rate '12 kHz'"),
                seed=seed,
                truth_path=None if truth == STANDARD_STREAM else truth,
                changes=given.settings,
            )
            if found.solved is not None and found.status != "made":
                complain_of(found.solved, lang)
                raise typer.Exit(NO_RESULT)
        _show(found, truth)
    raise typer.Exit(SOLVED)


def _show(found: SynthesisResult, truth: str | None) -> None:
    """Show the page, or the truth if that goes to standard output."""
    from rolamento.pages.synthesis import synthesis_page

    if truth == STANDARD_STREAM:
        put_json(found.truth(), truth)
    else:
        show(synthesis_page(found))


# --- parts of a recipe -----------------------------------------------------------------------


def _fault(text: str, jitter: float | None) -> Fault:
    from rolamento.vibration.synthesis import Fault

    fields = _fields_given("--fault", text)
    kind = fields["kind"].replace("-", "_")
    fields["kind"] = "ball" if kind == "roller" else kind
    if jitter is not None:
        fields.setdefault("jitter", jitter)
    with _in_option("--fault"):
        return Fault(**fields)


def _noise(
    snr: float | None, level: str | None, colour: str, has_faults: bool, has_lines: bool
) -> Noise | None:
    from rolamento.tasks.quantities import number_of
    from rolamento.vibration.synthesis import Noise

    if snr is None and level is None:
        return None
    if snr is not None and level is not None:
        raise InputError(said("give --snr or --noise, not both"), source="--snr")
    fields: dict[str, Any] = {"colour": colour, "of": "faults" if has_faults else "signal"}
    if level is not None:
        fields["level"] = number_of(level, "--noise", "acceleration", EXAMPLES["--noise"])
    elif has_faults or has_lines:
        fields["ratio"] = snr
    else:
        raise InputError(
            said(
                "is a ratio to faults, waviness or shaft harmonics, and there are "
                "none; for noise alone give --noise"
            ),
            source="--snr",
            example=EXAMPLES["--noise"],
        )
    return Noise(**fields)


def _speed_profile(
    swing: str | None, wander: str | None
) -> Callable[[float], SwingingSpeed | WanderingSpeed] | None:
    """Return what gives the speed over time from its mean; None where it is steady."""
    from functools import partial

    from rolamento.vibration.synthesis import SwingingSpeed, WanderingSpeed

    if swing is not None and wander is not None:
        raise InputError(said("give --swing or --wander, not both"), source="--swing")
    if swing is not None:
        return partial(SwingingSpeed, **{"frequency": 0.3, **_fields_given("--swing", swing)})
    if wander is not None:
        return partial(WanderingSpeed, **{"memory": 2.0, **_fields_given("--wander", wander)})
    return None


def _load(text: str | None) -> dict[str, Any]:
    """Return the kind of load; of a radial one with its extent and azimuth."""
    if text is None:
        return {}
    fields = _fields_given("--load", text)
    kind = fields.pop("kind")
    if kind not in _LOADS or (fields and kind != "radial"):
        rule = said(
            "must be one of {known}; radial takes extent and azimuth", known=", ".join(_LOADS)
        )
        raise InputError(rule, source="--load", value=text, example=EXAMPLES["--load"])
    azimuth = {"load_azimuth": fields.pop("azimuth")} if "azimuth" in fields else {}
    return {"load": kind, **fields, **azimuth}


def _mode(text: str) -> Mode:
    from rolamento.vibration.synthesis import Mode

    with _in_option("--mode"):
        return Mode(**_fields_given("--mode", text))


def _transfer(text: str | None) -> TransferPath | None:
    from rolamento.vibration.synthesis import TransferPath

    if text is None:
        return None
    with _in_option("--path"):
        return TransferPath(**_fields_given("--path", text))


def _harmonics(text: str | None) -> tuple[float, ...]:
    from rolamento.tasks.quantities import number_of

    if text is None:
        return ()
    example = EXAMPLES["--shaft-harmonics"]
    parts = text.split(",")[:1000]
    return tuple(number_of(part, "--shaft-harmonics", "acceleration", example) for part in parts)


def _waviness(text: str) -> Waviness:
    from rolamento.vibration.synthesis import Waviness

    fields = _fields_given("--waviness", text)
    if "amplitude" not in fields:
        raise InputError(
            said("is missing"),
            source="--waviness",
            field="amplitude",
            example=EXAMPLES["--waviness"],
        )
    if fields.get("surface") == "roller":
        fields["surface"] = "ball"
    with _in_option("--waviness"):
        return Waviness.falling(**fields)


def _fields_given(option: str, text: str) -> dict[str, Any]:
    """Return the fields that an option gives, as plain SI values.

    Raises
    ------
    InputError
        If a key is unknown or given twice, or a value is none.
    """
    known = KINDS[option]
    first = "" if option == "--path" else next(iter(known))
    return fields_of(text, option, known, EXAMPLES[option], first=first)


@contextmanager
def _in_option(option: str) -> Iterator[None]:
    """Say in which option the field is that is refused."""
    try:
        yield
    except InputError as error:
        if error.source:
            raise
        raise error.with_details(source=option, example=EXAMPLES[option]) from None


@contextmanager
def _named(options: Mapping[str, str]) -> Iterator[None]:
    """Say which option gave a field, by a table of both."""
    try:
        yield
    except InputError as error:
        if error.source or error.field not in options:
            raise
        option = options[error.field]
        field = error.field.rpartition(".")[2] if option in KINDS else ""
        raise error.with_details(source=option, field=field, example=EXAMPLES[option]) from None
