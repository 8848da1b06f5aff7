"""What a bearing's vibration says: fault frequencies, synthetic signals, analysis and diagnosis.

A `Signal` is what all analyses read. Names are imported when they are first used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from rolamento.vibration.anderon import (
        BANDS,
        BandNoise,
        NoiseSteps,
        accept,
        anderons_of_velocity,
        measure_noise,
        noise_steps,
        velocity_of_anderons,
    )
    from rolamento.vibration.anderon_trend import AnderonRecord, AnderonTrend, trend_of
    from rolamento.vibration.cyclic import (
        CyclicCoherence,
        cyclic_coherence,
        enhanced_envelope_spectrum,
    )
    from rolamento.vibration.demodulation import (
        Kurtogram,
        KurtogramBand,
        analytic_signal,
        envelope,
        envelope_spectrum,
        kurtogram,
        prewhitened,
    )
    from rolamento.vibration.diagnosis import Diagnosis, DiagnosisSettings, FaultOrders, diagnose
    from rolamento.vibration.frequencies import (
        FAULTS,
        FaultFrequencies,
        FaultLine,
        frequencies_of,
        nominal_frequencies,
        turns_of,
    )
    from rolamento.vibration.frequency_band import (
        Alternative,
        Tolerances,
        alternatives_of,
        banded_frequencies,
    )
    from rolamento.vibration.motion import GeneralMotion, general_motion
    from rolamento.vibration.order_tracking import (
        AngularSignal,
        order_spectrum,
        order_tracked,
        revolutions_of,
    )
    from rolamento.vibration.reading import SignalFile, channels_of, open_signal, read_signal
    from rolamento.vibration.separation import Separation, separate
    from rolamento.vibration.severity import (
        AlarmSetting,
        MachineClass,
        Severity,
        alarm_setting,
        classes_of,
        machine_classes,
        measure_severity,
    )
    from rolamento.vibration.shaft_speed import (
        SpeedEstimate,
        estimate_speed,
        pulse_times,
        speed_from_pulses,
    )
    from rolamento.vibration.signal import Signal
    from rolamento.vibration.spectrum import (
        Indicators,
        SpectralIndicators,
        Spectrum,
        amplitude_spectrum,
        averaged_density,
        indicators,
        power_density,
        spectral_indicators,
    )
    from rolamento.vibration.synthesis import (
        Fault,
        GivenSpeed,
        LoadDistribution,
        Mode,
        Noise,
        Recipe,
        SteadySpeed,
        SwingingSpeed,
        Synthesis,
        TransferPath,
        WanderingSpeed,
        Waviness,
        recipe_of,
        synthesise,
    )
    from rolamento.vibration.velocity import Velocity, velocity_of
    from rolamento.vibration.writing import write_signal

__all__ = [
    "BANDS", "FAULTS", "AlarmSetting", "Alternative", "AnderonRecord", "AnderonTrend",
    "AngularSignal", "BandNoise", "CyclicCoherence", "Diagnosis", "DiagnosisSettings", "Fault",
    "FaultFrequencies", "FaultLine", "FaultOrders", "GeneralMotion", "GivenSpeed", "Indicators",
    "Kurtogram", "KurtogramBand", "LoadDistribution", "MachineClass", "Mode", "Noise",
    "NoiseSteps", "Recipe", "Separation", "Severity", "Signal", "SignalFile",
    "SpectralIndicators", "Spectrum", "SpeedEstimate", "SteadySpeed", "SwingingSpeed",
    "Synthesis", "Tolerances", "TransferPath", "Velocity", "WanderingSpeed", "Waviness",
    "accept", "alarm_setting", "alternatives_of", "amplitude_spectrum", "analytic_signal",
    "anderons_of_velocity", "averaged_density", "banded_frequencies", "channels_of",
    "classes_of", "cyclic_coherence", "diagnose", "enhanced_envelope_spectrum", "envelope",
    "envelope_spectrum", "estimate_speed", "frequencies_of", "general_motion", "indicators",
    "kurtogram", "machine_classes", "measure_noise", "measure_severity", "noise_steps",
    "nominal_frequencies", "open_signal", "order_spectrum", "order_tracked", "power_density",
    "prewhitened", "pulse_times", "read_signal", "recipe_of", "revolutions_of", "separate",
    "spectral_indicators", "speed_from_pulses", "synthesise", "trend_of", "turns_of",
    "velocity_of", "velocity_of_anderons", "write_signal",
]  # fmt: skip

_CHAPTERS: Final = (
    "signal", "writing", "spectrum", "frequencies", "frequency_band", "motion", "order_tracking",
    "demodulation", "separation", "cyclic", "synthesis", "velocity", "anderon", "anderon_trend",
    "severity", "shaft_speed", "reading", "diagnosis",
)  # fmt: skip
"""Where a name is looked for, what is quickly imported first."""


def __getattr__(name: str) -> Any:
    for chapter in _CHAPTERS if name in __all__ else ():
        module = importlib.import_module(f"{__name__}.{chapter}")
        if hasattr(module, name):
            return getattr(module, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)
