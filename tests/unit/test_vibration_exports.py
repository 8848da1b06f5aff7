"""The names of `rolamento.vibration`, and what its functions refuse."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pandas as pd
import pytest

from rolamento import Bearing, InputError, vibration
from rolamento.vibration import Signal

SAMPLES = [0.1, -0.2, 0.05, 0.4]
GOOD = Signal(np.random.default_rng(1).normal(size=4096), 12_000.0, "velocity", "m/s", 188.0)


def test_every_name_is_there_and_its_own() -> None:
    for name in vibration.__all__:
        assert getattr(vibration, name) is not None
        assert name in dir(vibration)
    assert callable(vibration.kurtogram)
    assert callable(vibration.diagnose)
    with pytest.raises(AttributeError, match="no attribute 'spectrogram'"):
        vibration.spectrogram  # noqa: B018


def test_names_are_imported_when_they_are_used() -> None:
    code = (
        "import sys, rolamento.vibration as v; assert 'scipy' not in sys.modules; v.Signal;"
        " assert 'rolamento.vibration.diagnosis' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize(
    "samples", [SAMPLES, tuple(SAMPLES), np.array(SAMPLES), np.array(SAMPLES, "f4"),
                pd.Series(SAMPLES, index=[4, 3, 2, 1])],
)  # fmt: skip
def test_samples_are_what_is_like_an_array(samples: Any) -> None:
    signal = Signal(samples, 4.0, speed=samples)
    assert signal.samples == pytest.approx(SAMPLES)
    assert signal.speed == pytest.approx(SAMPLES)
    load = vibration.LoadDistribution.radial()
    assert load.at(samples, "inner") == pytest.approx(load.at(np.array(SAMPLES), "inner"))


REFUSED: list[Any] = [
    pd.DataFrame({"x": SAMPLES}), "0.1, 0.2", ["0.1", "0.2"], [[0.1, 0.2], [0.3]], [0.1, np.nan],
    [0.1, None], [1j], {"x": 1.0}, np.array(["2026"], "M8[Y]"), [],
]  # fmt: skip


@pytest.mark.parametrize("samples", REFUSED, ids=range(len(REFUSED)))
def test_samples_that_are_none_are_refused(samples: Any) -> None:
    with pytest.raises(InputError, match="must be") as refused:
        Signal(samples, 4.0)
    assert refused.value.field == "samples"
    assert refused.value.example == "samples = [0.1, -0.2, 0.05]"


@pytest.mark.parametrize("speed", REFUSED, ids=range(len(REFUSED)))
def test_speeds_that_are_none_are_refused(speed: Any) -> None:
    with pytest.raises(InputError, match="must be") as refused:
        Signal(SAMPLES, 4.0, speed=speed)
    assert (refused.value.field, refused.value.example) == ("speed", "speed = 188.5")


TAKE_A_SIGNAL: dict[str, Callable[[Any], Any]] = {
    "amplitude_spectrum": vibration.amplitude_spectrum,
    "analytic_signal": vibration.analytic_signal,
    "averaged_density": lambda given: vibration.averaged_density(given, 10.0),
    "cyclic_coherence": lambda given: vibration.cyclic_coherence(given, 100.0),
    "diagnose": lambda given: vibration.diagnose(given, vibration.FaultOrders(outer_race=3.585)),
    "envelope": vibration.envelope,
    "envelope_spectrum": vibration.envelope_spectrum,
    "estimate_speed": lambda given: vibration.estimate_speed(given, 188.0),
    "indicators": vibration.indicators,
    "kurtogram": vibration.kurtogram,
    "measure_noise": vibration.measure_noise,
    "order_tracked": vibration.order_tracked,
    "power_density": vibration.power_density,
    "prewhitened": vibration.prewhitened,
    "pulse_times": vibration.pulse_times,
    "revolutions_of": vibration.revolutions_of,
    "separate": vibration.separate,
    "spectral_indicators": vibration.spectral_indicators,
    "speed_from_pulses": vibration.speed_from_pulses,
    "velocity_of": lambda given: vibration.velocity_of(given, 10.0),
    "write_signal": lambda given: vibration.write_signal(given, "a.npz"),
}


@pytest.mark.parametrize("name", TAKE_A_SIGNAL)
@pytest.mark.parametrize("given", [np.array(SAMPLES), SAMPLES, "x.wav", None, 3.0, REFUSED[0]],
                         ids=str)  # fmt: skip
@pytest.mark.thirds
def test_what_is_no_signal_is_refused(name: str, given: Any) -> None:
    with pytest.raises(InputError, match="must be a Signal, samples with their rate") as refused:
        TAKE_A_SIGNAL[name](given)
    assert (refused.value.field, refused.value.example) == (
        "signal", "Signal(samples, rate=51200.0)"
    )  # fmt: skip


def test_arrays_of_other_records_are_refused_in_the_same_words() -> None:
    for wrong in ("abc", [[1.0], [1.0, 2.0]], pd.DataFrame({"x": ["a"]})):
        with pytest.raises(InputError, match="must be real numbers") as refused:
            vibration.LoadDistribution(wrong, [1.0], [1.0])  # type: ignore[arg-type]
        assert refused.value.field == "azimuth"
        with pytest.raises(InputError, match="must be real numbers"):
            vibration.general_motion(wrong, (0.01, 0.01), (0.0, 0.0), 0.0, 0.0, 100.0)
        with pytest.raises(InputError, match="must be real numbers"):
            vibration.TransferPath().at(wrong)
    frequencies = vibration.nominal_frequencies(Bearing.named("6205"), 188.0)
    ragged = vibration.GivenSpeed([0.0, [1.0, 2.0]], [100.0, 110.0])  # type: ignore[arg-type]
    with pytest.raises(InputError, match="must be real numbers"):
        vibration.synthesise(vibration.Recipe(frequencies=frequencies, speed=ragged))
    series = vibration.GivenSpeed(pd.Series([0.0, 1.0]), pd.Series([100.0, 110.0]))
    made = vibration.synthesise(
        vibration.Recipe(frequencies=frequencies, speed=series, duration=0.1, rate=10_000.0)
    )
    assert made.signal.mean_speed == pytest.approx(100.5, abs=0.01)
    with pytest.raises(InputError, match="must be from"):
        vibration.Fault(kind="ball", strength="strong")  # type: ignore[arg-type]
