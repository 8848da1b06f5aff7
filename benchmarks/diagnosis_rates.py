"""How often a diagnosis is wrong, and how often it finds: `python -m benchmarks.diagnosis_rates`.

Healthy signals (`benchmarks.healthy_signals`) are diagnosed and the verdicts of a fault counted;
synthetic faults are planted over ratios of fault to noise, slip, load, changes of speed and
lengths of the record, and those found counted. Takes some hours on one processor; `--quick` a
minute. `--json FILE` keeps the counts, `--from FILE` starts from them, `--markdown FILE` and
`--figure FILE` write docs/diagnosis-rates.md and docs/gallery/plots/diagnosis-rates.png.
"""

from __future__ import annotations

import argparse
import json
import os
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Final, Literal

import numpy as np
from scipy import stats

from benchmarks.healthy_signals import KINDS, healthy
from rolamento import Bearing
from rolamento.vibration.diagnosis import FaultOrders, diagnose
from rolamento.vibration.frequencies import FaultKind, nominal_frequencies
from rolamento.vibration.synthesis import (
    Fault,
    LoadDistribution,
    Noise,
    Recipe,
    SwingingSpeed,
    synthesise,
)

FALSE_ALARM: Final = 0.01
DURATIONS: Final = (2.0, 5.0, 10.0)
LEVELS: Final = (0.1, 0.05, 0.01)
DESIGNATION: Final = "6205"
SPEED: Final = 188.2
"""rad/s"""
RATIOS: Final = (-30.0, -27.5, -25.0, -22.5, -20.0, -15.0, -10.0, -5.0)
"""Of the fault's RMS to the noise's, over 0 to 25.6 kHz; dB."""


@dataclass(frozen=True, slots=True)
class Setting:
    """How a fault is planted; all but the ratio to noise."""

    title: str
    kind: FaultKind = "outer_race"
    duration: float = 10.0
    jitter: float = 0.01
    slip: Literal["cumulative", "around"] = "cumulative"
    load_zone: float | None = None
    swing: float = 0.0


SETTINGS: Final = (
    Setting("outer race"),
    Setting("inner race", kind="inner_race"),
    Setting("ball", kind="ball"),
    Setting("cage", kind="cage"),
    Setting("inner race, radial load", kind="inner_race", load_zone=0.5),
    Setting("ball, radial load", kind="ball", load_zone=0.5),
    Setting("outer race, slip 0.1 %", jitter=0.001),
    Setting("outer race, slip 0.3 %", jitter=0.003),
    Setting("outer race, slip 2 %", jitter=0.02),
    Setting("outer race, slip 4 %", jitter=0.04),
    Setting("outer race, slip 1 % about even places", slip="around"),
    Setting("outer race, speed swings 5 %", swing=0.05),
    Setting("outer race, speed swings 30 %", swing=0.3),
    Setting("outer race, 1 s", duration=1.0),
    Setting("outer race, 3 s", duration=3.0),
    Setting("outer race, 30 s", duration=30.0),
)


def try_healthy(kind: str, duration: float, seed: int) -> tuple[float, bool, bool]:
    """Probability of the clearest finding in a healthy signal; is damage stated, a part watched."""
    signal, orders = healthy(kind, duration, seed)
    found = diagnose(signal, orders)
    least = float(np.nanmin([part.probability for part in found.components]))
    watched = any(part.verdict == "watch" for part in found.components)
    return least, bool(found.faults), watched


def find(setting: Setting, ratio: float, seed: int) -> tuple[bool, bool, bool]:
    """Whether a planted fault is named, whether as damage, and whether another is stated."""
    frequencies = nominal_frequencies(Bearing.named(DESIGNATION), SPEED)
    zone = setting.load_zone
    swinging = SwingingSpeed(SPEED, setting.swing, 0.2, float(seed))
    recipe = Recipe(
        frequencies=frequencies,
        speed=swinging if setting.swing else None,
        duration=setting.duration,
        faults=(Fault(kind=setting.kind, jitter=setting.jitter, slip=setting.slip),),
        load=LoadDistribution.uniform() if zone is None else LoadDistribution.radial(zone),
        noise=Noise(ratio=ratio, of="faults"),
        seed=seed,
    )
    found = diagnose(synthesise(recipe).signal, FaultOrders.of(frequencies))
    named = found.of(setting.kind).verdict in ("fault", "undecided", "watch")
    stated = setting.kind in found.faults
    return named, stated, any(part != setting.kind for part in found.faults)


def measure_healthy(signals: int, workers: int) -> list[dict[str, Any]]:
    """Probabilities by kind and duration, the signals shared out evenly."""
    tasks = [(kind, duration) for kind in KINDS for duration in DURATIONS]
    rows = []
    with ProcessPoolExecutor(workers) as pool:
        for number, (kind, duration) in enumerate(tasks):
            count = signals * (number + 1) // len(tasks) - signals * number // len(tasks)
            jobs = [pool.submit(try_healthy, kind, duration, seed) for seed in range(count)]
            results = [job.result() for job in jobs]
            rows.append(
                {
                    "kind": kind,
                    "duration": duration,
                    "probabilities": [least for least, _, _ in results],
                    "stated": sum(stated for _, stated, _ in results),
                    "watched": sum(watched for _, _, watched in results),
                }
            )
            print(kind, duration, min(rows[-1]["probabilities"], default=1.0), flush=True)
    return rows


def measure_found(seeds: int, workers: int, settings: Sequence[Setting]) -> list[dict[str, Any]]:
    """Share of faults found, and of other parts blamed, over the ratio to noise."""
    rows = []
    with ProcessPoolExecutor(workers) as pool:
        for setting in settings:
            jobs = [
                [pool.submit(find, setting, ratio, seed) for seed in range(seeds)]
                for ratio in RATIOS
            ]
            results = [[job.result() for job in row] for row in jobs]
            rows.append(
                {
                    "setting": asdict(setting),
                    "found": [sum(found for found, _, _ in row) for row in results],
                    "stated": [sum(stated for _, stated, _ in row) for row in results],
                    "others": [sum(other for _, _, other in row) for row in results],
                    "seeds": seeds,
                }
            )
            print(setting.title, rows[-1]["found"], rows[-1]["others"], flush=True)
    return rows


def measure_time() -> float:
    """Seconds for a signal of 10 s: the least of five."""
    signal, orders = healthy("noise with resonances", 10.0, 0)
    taken = []
    for _ in range(5):
        start = time.perf_counter()
        diagnose(signal, orders)
        taken.append(time.perf_counter() - start)
    return min(taken)


def markdown(results: dict[str, Any]) -> str:
    """The tables as a page."""
    number = sum(len(row["probabilities"]) for row in results["healthy"])
    seeds = results["found"][0]["seeds"]
    lines = [
        "# Rates of the diagnosis",
        "",
        f"Written by `python -m benchmarks.diagnosis_rates --healthy {number} --seeds {seeds}",
        "--recordings FILE --markdown docs/diagnosis-rates.md --figure",
        "docs/gallery/plots/diagnosis-rates.png`, FILE being the tables of",
        "`python -m benchmarks.recordings FOLDER --markdown FILE`. With 1000 healthy signals and",
        "20 seeds it takes some hours on one processor. What is diagnosed and how:",
        "[diagnosis](diagnose.md), [theory](theory/vibration-analysis.md#diagnosis).",
        "",
        "## Real recordings",
        "",
        "Public recordings of three rigs, at the speed that their tables or names give. Figures",
        "alone are kept here; `python -m benchmarks.recordings FOLDER` writes these tables for any",
        "folder of WAV files with a table `recordings.csv` (columns file, rig, bearing,",
        "nominal_rpm, truth; damaged_elsewhere if another part of the machine is). *Named first*",
        "is the part stated as damaged, or to be watched, *plain* what a user would write instead",
        "(cepstrum pre-whitening, squared envelope, three harmonics), its limit set so that it",
        "accuses as many healthy bearings. *Rig left out*: the limit that the other rigs give.",
        "",
        *results["recordings"].splitlines(),
        "",
        "## Healthy synthetic machines",
        "",
        "Drawn anew each: bearing, speed (900 to 3600 rpm), resonances, tooth numbers, levels; 2,",
        "5 and 10 s at 51.2 kHz. Share with any finding, by the probability in noise that was",
        "allowed; with a part watched, and with damage stated, at the default. Lines of a healthy",
        "bearing are of 2 to 27 % of depth: findings, and no damage.",
        "",
        "| signals | number | "
        + " | ".join(f"{level:.0%}" for level in LEVELS)
        + " | watched | damage |",
        "|---|---|" + "---|" * (len(LEVELS) + 2),
    ]
    by_kind: dict[str, list[float]] = {}
    stated: dict[str, list[int]] = {}
    for row in results["healthy"]:
        by_kind.setdefault(row["kind"], []).extend(row["probabilities"])
        counts = stated.setdefault(row["kind"], [0, 0])
        counts[0] += row["watched"]
        counts[1] += row["stated"]
    for kind, values in by_kind.items():
        counted = " | ".join(map(str, stated[kind]))
        cells = " | ".join(_shares(values))
        lines.append(f"| {kind} | {len(values)} | {cells} | {counted} |")
    everything = [value for values in by_kind.values() for value in values]
    wrong = sum(counts[1] for counts in stated.values())
    low, high = _interval(wrong, len(everything))
    lines += [
        "",
        f"Damage stated in {wrong} of {len(everything)}; the true rate lies between {low:.2%} and "
        f"{high:.2%} (95 %).",
        "",
        "## Detection",
        "",
        f"A fault planted in white noise ({DESIGNATION}, {SPEED * 30 / np.pi:.0f} rpm, 51.2 kHz;",
        "10 s, slip 1 % from blow to blow and adding up, even load and steady speed where the row",
        "does not say otherwise; resonances as `rolamento.vibration.synthesis` has them). Share",
        "named, and in brackets stated as damage, by the ratio of the fault's RMS to the noise's",
        "over 0 to 25.6 kHz:",
        "",
        "| | " + " | ".join(f"{ratio:g} dB" for ratio in RATIOS) + " | half named at |",
        "|---|" + "---|" * (len(RATIOS) + 1),
    ]
    for row in results["found"]:
        shares = [found / row["seeds"] for found in row["found"]]
        both = zip(shares, row["stated"], strict=True)
        cells = " | ".join(f"{share:.0%} ({one / row['seeds']:.0%})" for share, one in both)
        lines.append(f"| {row['setting']['title']} | {cells} | {_half(shares)} |")
    planted = sum(row["seeds"] * len(RATIOS) for row in results["found"])
    others = sum(sum(row["others"]) for row in results["found"])
    lines += [
        "",
        f"Of {planted} signals with one fault {others} had another part blamed too.",
        "",
        f"![Share of faults found]({results['figure']})",
        "",
        f"A signal of 10 s at 51.2 kHz took {results['seconds']:.2f} s on the machine that wrote "
        "this page.",
    ]
    return "\n".join(lines) + "\n"


def draw(results: dict[str, Any], path: Path) -> None:
    """Detection curves, and the share of false alarms over what was allowed."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(13.0, 5.6), layout="constrained")
    rows = results["found"]
    for axes, chosen in ((left, rows[:6]), (middle, [rows[0], *rows[6:]])):
        for number, row in enumerate(chosen):
            shares = np.array(row["found"]) / row["seeds"]
            axes.plot(
                RATIOS,
                100.0 * shares,
                marker="o",
                markersize=3,
                linestyle="-" if number < 6 else "--",
                color=f"C{number % 6}",
                label=row["setting"]["title"],
            )
        axes.set(xlabel="fault to noise (dB)", ylabel="found (%)", ylim=(-3, 103))
        axes.set_xticks(RATIOS[::2])
        axes.legend(fontsize=7.5, loc="upper center", bbox_to_anchor=(0.5, -0.13), ncols=2)
    allowed = np.geomspace(1e-3, 1.0, 50)
    values = np.array([value for row in results["healthy"] for value in row["probabilities"]])
    measured = np.array([np.mean(values <= level) for level in allowed])
    right.loglog(allowed, np.where(measured > 0, measured, np.nan), label="measured")
    right.loglog(allowed, allowed, "k--", linewidth=0.8, label="allowed")
    right.set(xlabel="allowed probability of a false alarm", ylabel="share of healthy signals")
    right.legend()
    figure.savefig(path, dpi=120)


def main(arguments: Sequence[str] | None = None) -> None:
    """Measure, or read what was measured, and write."""
    options = _parsed(arguments)
    if options.counts is not None:
        results = json.loads(options.counts.read_text(encoding="utf-8"))
    else:
        workers = options.workers
        results = {
            "healthy": measure_healthy(24 if options.quick else options.healthy, workers),
            "found": measure_found(
                1 if options.quick else options.seeds,
                workers,
                SETTINGS[:1] if options.quick else SETTINGS,
            ),
            "seconds": measure_time(),
        }
    results["recordings"] = (
        "" if options.recordings is None else options.recordings.read_text(encoding="utf-8")
    )
    results["figure"] = _picture(options.figure, options.markdown)
    if options.json is not None:
        options.json.write_text(json.dumps(results), encoding="utf-8")
    if options.figure is not None:
        draw(results, options.figure)
    page = markdown(results)
    if options.markdown is not None:
        options.markdown.write_text(page, encoding="utf-8")
    else:
        print(page)


def _parsed(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.diagnosis_rates")
    parser.add_argument("--quick", action="store_true", help="few signals: a minute")
    parser.add_argument("--healthy", type=int, default=1000, help="number of healthy signals")
    parser.add_argument("--seeds", type=int, default=20, help="signals per point of a curve")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--from", dest="counts", type=Path, help="counts that --json kept")
    parser.add_argument("--recordings", type=Path, help="tables of benchmarks.recordings")
    for name in ("json", "markdown", "figure"):
        parser.add_argument(f"--{name}", type=Path, metavar="FILE")
    return parser.parse_args(arguments)


def _picture(figure: Path | None, page: Path | None) -> str:
    """The picture's place as seen from the page's folder."""
    if figure is None:
        return "diagnosis-rates.png"
    folder = page.parent if page is not None else Path()
    return Path(os.path.relpath(figure, folder)).as_posix()


def _shares(values: Sequence[float]) -> list[str]:
    return [f"{np.mean(np.array(values) <= level):.1%}" for level in LEVELS]


def _interval(count: int, number: int) -> tuple[float, float]:
    """Clopper and Pearson's 95 % interval of a share."""
    low = stats.beta.ppf(0.025, count, number - count + 1) if count else 0.0
    high = stats.beta.ppf(0.975, count + 1, number - count) if count < number else 1.0
    return float(low), float(high)


def _half(shares: Sequence[float]) -> str:
    """Ratio at which half is found, between the points on either side."""
    for place in range(1, len(shares)):
        if shares[place - 1] < 0.5 <= shares[place]:
            low, high = RATIOS[place - 1 : place + 1]
            part = (0.5 - shares[place - 1]) / (shares[place] - shares[place - 1])
            return f"{low + part * (high - low):.1f} dB"
    return f"under {RATIOS[0]:g} dB" if shares[0] >= 0.5 else f"over {RATIOS[-1]:g} dB"


if __name__ == "__main__":
    main()
