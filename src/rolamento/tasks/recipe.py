"""A vibration signal to be made, a request: its parts are read from texts."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final

from rolamento.errors import InputError, arguments, phrase
from rolamento.io.json import dumps
from rolamento.tasks.case_request import CaseRequest, Finding
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.quantities import fields_of, number_of
from rolamento.tasks.request import Input
from rolamento.words import marked, said
from rolamento.words.reasons import why_not

if TYPE_CHECKING:
    from rolamento.tasks.quantities import Kind
    from rolamento.vibration.synthesis import Noise, SpeedProfile

__all__ = ["SynthesisRequest"]

_BEARING: Final = marked("Bearing")
_SPEED: Final = marked("Speed")
_DAMAGE: Final = marked("Damage")
_PATH: Final = marked("Transmission path")
_NOISE: Final = marked("Noise and vibration")
_SIGNAL: Final = marked("Signal")
_LOADS: Final = ("uniform", "radial", "solved")
_MOST_HARMONICS: Final = 1000

_KEYS: Final[Mapping[str, Mapping[str, Kind]]] = {
    "faults": {
        "kind": "text", "strength": "number", "azimuth": "angle", "jitter": "number",
        "slip": "text", "scatter": "number", "modulation": "text", "index": "number",
        "inner_gain": "number",
    },
    "modes": {"frequency": "frequency", "damping": "number", "gain": "acceleration"},
    "path": {"sensor_azimuth": "angle", "far_gain": "number"},
    "load": {"kind": "text", "extent": "number", "azimuth": "angle"},
    "swing": {"depth": "number", "frequency": "frequency", "phase": "angle"},
    "wander": {"deviation": "number", "memory": "time"},
    "waviness": {
        "surface": "text", "amplitude": "length", "first": "whole", "last": "whole",
        "slope": "number", "direction": "text",
    },
}  # fmt: skip
"""Keys of the fields that give a record. The first may stand alone, but of a path."""
_GIVEN_BY: Final = {
    "ratio": "snr", "level": "noise", "extent": "load", "depth": "swing", "frequency": "swing",
    "deviation": "wander", "memory": "wander",
}  # fmt: skip
"""Fields of the request by what the recipe and the synthesis call a part of them."""


def _record(option: str, example: str, metavar: str, *, many: bool = False) -> Input:
    """Return an input that gives a record, or several."""
    return Input(
        "", "list" if many else "text", example=example, option=option, metavar=metavar,
        separator="", at_computer=True,
    )  # fmt: skip


class SynthesisRequest(CaseRequest):
    """Make a vibration signal of a bearing with known damage.

    To test a diagnosis: the full ground truth can be written as well.

    Parameters
    ----------
    case
        Designation such as 6205, or a case file; - for a case on standard input.
    output
        File of the signal: .wav, .csv or .npz.
    truth
        Write all that is known of the signal as JSON; - for standard output.
    speed
        Speed of the inner ring, such as '1797 rpm'.
    outer_speed
        Speed of the outer ring, with its sign.
    slip
        Fraction by which the cage lags, such as 0.01; from -1 to 1.
    swing
        Fraction by which the speed oscillates, with frequency and phase.
    wander
        Fraction by which the speed wanders at random instead, with memory.
    faults
        outer_race, inner_race, ball (or roller) or cage; with strength, azimuth, jitter, slip,
        scatter, modulation, index, inner_gain.
    jitter
        Standard deviation of the impact intervals over their mean, for all faults (default 0.01).
    load
        uniform; radial with extent and azimuth; or solved, the default for a case with a load.
    load_turns
        Speed of the load direction over that of the shaft: 1 for unbalance.
    modes
        Resonance excited by an impact, with damping and gain; 3500 Hz by default.
    path
        Path to the sensor: far_gain, of an impact on the far side, and sensor_azimuth.
    snr
        Signal-to-noise ratio: power of the faults, or of everything else if there are none, over
        that of the noise.
    noise
        RMS of the noise instead, such as '0.5 m/s^2'.
    colour
        Colour of the noise: white or pink.
    shaft_harmonics
        Amplitudes at 1, 2, 3 … times the shaft frequency, in m/s².
    waviness
        Waviness of outer, inner or ball (or roller): amplitude, such as '50 nm', with first, last,
        slope, direction.
    duration
        Duration, such as '10 s'.
    rate
        Sampling rate, such as '12 kHz'.
    seed
        Seed of all random numbers, from 0.
    """

    case: Annotated[Any, Input("Bearing", "file", essential=True, metavar="BEARING")]
    output: Annotated[Any, Input("", "target", essential=True, metavar="FILE")]
    truth: Annotated[Any, Input("", "target", metavar="FILE")] = None
    speed: Annotated[str | float | None, Input("", "text", _SPEED, "1797 rpm")] = None
    outer_speed: Annotated[
        str | float | None, Input("", "text", _SPEED, "-300 rpm", metavar="SPEED")
    ] = None
    slip: Annotated[
        float, Input("", "number", _SPEED, "0.01", default="0.0", metavar="FRACTION")
    ] = 0.0
    swing: Annotated[
        str | None,
        _record("", "0.02,frequency=0.3 Hz", "DEPTH[,KEY=VALUE…]").below(_SPEED),
    ] = None
    wander: Annotated[
        str | None, _record("", "0.005,memory=2 s", "DEVIATION[,KEY=VALUE]").below(_SPEED)
    ] = None
    faults: Annotated[
        tuple[str, ...],
        _record(
            "--fault", "inner_race,strength=2,jitter=0.02", "KIND[,KEY=VALUE…]", many=True
        ).below(_DAMAGE),
    ] = ()
    jitter: Annotated[float | None, Input("", "number", _DAMAGE, "0.02", metavar="FRACTION")] = None
    load: Annotated[
        str | None, _record("", "radial,extent=0.5", "KIND[,KEY=VALUE…]").below(_DAMAGE)
    ] = None
    load_turns: Annotated[float, Input("", "number", _DAMAGE, "1", default="0.0", metavar="N")] = (
        0.0
    )
    modes: Annotated[
        tuple[str, ...],
        _record(
            "--mode", "3500 Hz,damping=0.03,gain=10", "FREQUENCY[,KEY=VALUE…]", many=True
        ).below(_PATH),
    ] = ()
    path: Annotated[
        str | None, _record("", "far_gain=0.3,sensor_azimuth=90 deg", "KEY=VALUE…").below(_PATH)
    ] = None
    snr: Annotated[float | None, Input("", "number", _NOISE, "-8", metavar="DB")] = None
    noise: Annotated[
        str | float | None, Input("", "text", _NOISE, "0.5 m/s^2", metavar="LEVEL")
    ] = None
    colour: Annotated[str, Input("", "text", _NOISE, "pink", default="white")] = "white"
    shaft_harmonics: Annotated[
        str | None, Input("", "text", _NOISE, "0.5,0.2", metavar="A,A,…")
    ] = None
    waviness: Annotated[
        tuple[str, ...],
        _record("", "outer,amplitude=50 nm,last=60", "SURFACE,KEY=VALUE…", many=True).below(_NOISE),
    ] = ()
    duration: Annotated[
        str | float, Input("", "text", _SIGNAL, "10 s", default="10 s", metavar="TIME")
    ] = "10 s"
    rate: Annotated[str | float, Input("", "text", _SIGNAL, "12 kHz", default="51200 Hz")] = (
        "51200 Hz"
    )
    seed: Annotated[int, Input("", "count", _SIGNAL, "1", default="0", metavar="N")] = 0

    headings: ClassVar = (_BEARING, _SPEED, _DAMAGE, _PATH, _NOISE, _SIGNAL)
    json_meaning: ClassVar = ""
    shows_page: ClassVar = False
    waiting: ClassVar = marked("making the signal")
    says_written: ClassVar = True
    examples: ClassVar = (
        "Example: synthesise 6205 --speed '1797 rpm' --fault inner_race --load radial --snr -8"
        " --rate '12 kHz' --output inner.npz --truth inner.json."
    )

    @property
    def target(self) -> str | None:
        """Name of the file of the signal."""
        return str(self.output)

    def check_target(self, path: str) -> None:
        """Refuse a name that ends as no signal."""
        from rolamento.vibration.writing import check_signal_name

        check_signal_name(path, 0, 1.0)

    def run(self, progress: Progress = quietly) -> Finding:
        """Make it, a `SynthesisResult`, and write it."""
        from rolamento.pages.synthesis import synthesis_page
        from rolamento.tasks.synthesis import synthesise

        own = ("speed", "outer_speed", "slip", "load_turns", "seed", "changes")
        with self._named():
            faults = [self._fault(text) for text in self.faults]
            waves = [self._waviness(text) for text in self.waviness]
            harmonics = self._harmonics()
            found = synthesise(
                self.case, self.output, **{name: getattr(self, name) for name in own},
                **self._load(), faults=faults, speed_profile=self._speed_profile(),
                transfer=self._transfer(), modes=[self._mode(text) for text in self.modes],
                shaft_harmonics=harmonics, waviness=waves,
                noise=self._noise(bool(faults), bool(waves or harmonics)),
                duration=self._number("duration", "time"), rate=self._number("rate", "frequency"),
                truth_path=None if self.truth == "-" else self.truth,
            )  # fmt: skip
        if found.status != "made" and found.solved is not None:
            why = why_not(found.solved, advised=True)
            return Finding(found, complaint=why, is_result=False)
        return Finding(
            found, partial(synthesis_page, found), lambda: dumps(found.truth(), indent=2)
        )

    def write(self, found: Any, path: str) -> None:
        """Leave the file as it was written when the signal was made."""

    # --- parts of a recipe -----------------------------------------------------------------------

    def _fault(self, text: str) -> Any:
        from rolamento.vibration.synthesis import Fault

        fields = self._parts("faults", text)
        kind = fields["kind"].replace("-", "_")
        fields["kind"] = "ball" if kind == "roller" else kind
        if self.jitter is not None:
            fields.setdefault("jitter", self.jitter)
        return self._made("faults", Fault, fields)

    def _waviness(self, text: str) -> Any:
        from rolamento.vibration.synthesis import Waviness

        fields = self._parts("waviness", text)
        if "amplitude" not in fields:
            example = self._example("waviness")
            raise InputError(
                said("is missing"), source="waviness", field="amplitude", example=example
            )
        if fields.get("surface") == "roller":
            fields["surface"] = "ball"
        return self._made("waviness", Waviness.falling, fields)

    def _mode(self, text: str) -> Any:
        from rolamento.vibration.synthesis import Mode

        return self._made("modes", Mode, self._parts("modes", text))

    def _transfer(self) -> Any:
        from rolamento.vibration.synthesis import TransferPath

        if self.path is None:
            return None
        return self._made("path", TransferPath, self._parts("path", self.path))

    def _noise(self, has_faults: bool, has_lines: bool) -> Noise | None:
        from rolamento.vibration.synthesis import Noise

        if self.snr is None and self.noise is None:
            return None
        self._refuse_both("snr", "noise")
        fields: dict[str, Any] = {"colour": self.colour, "of": "faults" if has_faults else "signal"}
        if self.noise is not None:
            fields["level"] = self._number("noise", "acceleration")
        elif has_faults or has_lines:
            fields["ratio"] = self.snr
        else:
            rule = marked(
                "is a ratio to faults, waviness or shaft harmonics, and there are none; for noise"
                " alone give {option}"
            )
            option = arguments(noise=...)
            raise InputError(
                phrase(rule, option=option), source="snr", example=self._example("noise")
            )
        return Noise(**fields)

    def _speed_profile(self) -> Callable[[float], SpeedProfile] | None:
        """Return what gives the speed over time from its mean; None where it is steady."""
        from rolamento.vibration.synthesis import SwingingSpeed, WanderingSpeed

        self._refuse_both("swing", "wander")
        if self.swing is not None:
            return partial(SwingingSpeed, **{"frequency": 0.3, **self._parts("swing", self.swing)})
        if self.wander is not None:
            return partial(WanderingSpeed, **{"memory": 2.0, **self._parts("wander", self.wander)})
        return None

    def _load(self) -> dict[str, Any]:
        """Return the kind of load; of a radial one with its extent and azimuth."""
        if self.load is None:
            return {}
        fields = self._parts("load", self.load)
        kind = fields.pop("kind")
        if kind not in _LOADS or (fields and kind != "radial"):
            known = ", ".join(_LOADS)
            rule = said("must be one of {known}; radial takes extent and azimuth", known=known)
            raise InputError(rule, field="load", value=self.load, example=self._example("load"))
        azimuth = {"load_azimuth": fields.pop("azimuth")} if "azimuth" in fields else {}
        return {"load": kind, **fields, **azimuth}

    def _harmonics(self) -> tuple[float, ...]:
        parts = (self.shaft_harmonics or "").split(",")[:_MOST_HARMONICS]
        if self.shaft_harmonics is None:
            return ()
        example = self._example("shaft_harmonics")
        return tuple(number_of(one, "shaft_harmonics", "acceleration", example) for one in parts)

    def _number(self, name: str, kind: Kind) -> float:
        given = getattr(self, name)
        if not isinstance(given, str):
            return float(given)
        return number_of(given, name, kind, self._example(name))

    def _refuse_both(self, one: str, other: str) -> None:
        if getattr(self, one) is not None and getattr(self, other) is not None:
            before = arguments(**{other: ...})
            rule = phrase(marked("cannot be combined with {before}"), before=before)
            raise InputError(rule, source=one)

    def _parts(self, name: str, text: str) -> dict[str, Any]:
        """Return what a field gives, as plain SI values.

        Raises
        ------
        InputError
            If a key is unknown or given twice, or a value is none.
        """
        known = _KEYS[name]
        first = "" if name == "path" else next(iter(known))
        return fields_of(text, name, known, self._example(name), first=first)

    def _made(self, name: str, make: Callable[..., Any], fields: Mapping[str, Any]) -> Any:
        """Return a record, or say which field of the request gave what is refused."""
        try:
            return make(**fields)
        except InputError as error:
            raise error.with_details(source=name, example=self._example(name)) from None

    @contextmanager
    def _named(self) -> Iterator[None]:
        """Say which field gave what the recipe or the synthesis refuses."""
        try:
            yield
        except InputError as error:
            whole, _, part = error.field.rpartition(".")
            name = whole or _GIVEN_BY.get(part, part)
            if error.source or name not in self.inputs():
                raise
            field = part if name in _KEYS and part != name else ""
            example = self._example(name)
            raise error.with_details(source=name, field=field, example=example) from None

    def _example(self, name: str) -> str:
        return arguments(**{name: self.inputs()[name].example})
