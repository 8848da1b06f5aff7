"""How often a diagnosis is wrong, and how often it finds: `python -m benchmarks.diagnosis_rates`.

Healthy signals (`benchmarks.healthy_signals`) are diagnosed and the verdicts of a fault counted;
synthetic faults are planted over ratios of fault to noise, slip, load, changes of speed and
lengths of the record, and those found counted; real recordings are those of a folder as
`benchmarks.recordings` reads it. With the defaults it takes some hours on one processor; `--quick`
a minute. `--json FILE` keeps all that is counted, `--from FILE` starts from it, `--markdown FILE`
and `--figure FILE` write docs/diagnosis-rates.md and docs/gallery/plots/diagnosis-rates.png.
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

from benchmarks.healthy_signals import KINDS, healthy
from benchmarks.recordings import measured, outcome, tables, wilson
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


SAID: Final = ("stated", "undecided", "watched")
"""Of a healthy machine, the gravest first."""


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


def try_healthy(kind: str, duration: float, seed: int) -> tuple[float, str]:
    """Probability of the clearest finding in a healthy signal, and what is said of it."""
    signal, orders = healthy(kind, duration, seed)
    found = diagnose(signal, orders)
    least = float(np.nanmin([part.probability for part in found.components]))
    said = outcome(found, 0.0, (0.0, ""))
    return least, "stated" if said.stated else "undecided" if said.undecided else (
        "watched" if said.watched else ""
    )


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
                    "probabilities": [least for least, _ in results],
                    **{name: [said for _, said in results].count(name) for name in SAID},
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


PAGE: Final = """\
# Rates of the diagnosis

Written by `python -m benchmarks.diagnosis_rates --recordings FOLDER --healthy {healthy}
--seeds {seeds} --markdown docs/diagnosis-rates.md --figure
docs/gallery/plots/diagnosis-rates.png`, FOLDER holding WAV files and a table `recordings.csv` of
them (columns file, rig, bearing, nominal_rpm, truth; damaged_elsewhere if another part of the
machine is). What is diagnosed and how: [diagnosis](diagnose.md),
[theory](theory/vibration-analysis.md#diagnosis).

**These are artificial faults**: notches cut by sparks, drills and engravers. Natural damage is
harder: it begins small, is not one notch, and comes with wear, in machines with gears and other
bearings.

## Real recordings

Public recordings of the rigs named in the table: Case Western Reserve University (its two
bearings, and the healthy one at the other end of the machine), HIT on a SpectraQuest rig, UESTC,
and two motors of the thesis of M. Recio recorded by microphone, the second of which has an inner
race that is modulated in every state: *health disputed*. They are diagnosed at the speed that their
tables or names give. Figures alone are kept here. *Named first* is the part stated as damaged, or
with peaks to be watched, *plain* what a user would write instead in forty lines (cepstrum
pre-whitening, squared envelope of the whole band, three harmonics), its limit set so that it
accuses as many healthy bearings. *95 %*: Wilson's limits of *all*. *Not decided* counts unexplained
peaks as deep as damage: most are those of the damaged bearing at the other end of the machine. *Rig
left out*: the limits that the other rigs give.

{recordings}
## Healthy synthetic machines

Drawn at random for each: bearing, speed (900 to 3600 rpm), resonances, tooth numbers, blades, jaws,
levels; 2, 5 and 10 s at 51.2 kHz. Share with any finding, by the probability in noise that was
allowed; and at the default the number with peaks watched, undecided, and with damage stated. Lines
of a healthy bearing are of 2 to 27 % of depth: findings, and no damage. *Undecided* are deep lines
that no part explains, or that keep step with the shaft: blades, jaws, twice the supply of a
converter.

{machines}

Damage stated in {wrong} of {healthy}, {share:.2%}; the true rate lies between {low:.2%} and
{high:.2%} (Wilson, 95 %).

## Detection

A fault planted in white noise ({bearing}, {rpm:.0f} rpm, 51.2 kHz; 10 s, slip 1 % from blow to blow
and adding up, even load and steady speed where the row does not say otherwise; resonances as
`rolamento.vibration.synthesis` has them). Share named, and in brackets stated as damage, by the
ratio of the fault's RMS to the noise's over 0 to 25.6 kHz. Between 30 and 65 % of depth a fault in
much noise has no impacts that stand out, and is named as one to be watched.

{faults}

Of {planted} signals with one fault {others} had another part blamed too.

![Share of faults found]({figure})

A signal of 10 s at 51.2 kHz took {seconds:.2f} s on the machine that wrote this page.
"""


def markdown(results: dict[str, Any]) -> str:
    """The page."""
    healthy = sum(len(row["probabilities"]) for row in results["healthy"])
    wrong = sum(row["stated"] for row in results["healthy"])
    low, high = wilson(wrong, healthy)
    return PAGE.format(
        recordings=results["recordings"],
        machines=_machines(results["healthy"]),
        faults=_faults(results["found"]),
        healthy=healthy,
        wrong=wrong,
        share=wrong / healthy,
        low=low,
        high=high,
        bearing=DESIGNATION,
        rpm=SPEED * 30.0 / np.pi,
        seeds=results["found"][0]["seeds"],
        planted=sum(row["seeds"] * len(RATIOS) for row in results["found"]),
        others=sum(sum(row["others"]) for row in results["found"]),
        figure=results["figure"],
        seconds=results["seconds"],
    )


def _machines(healthy: list[dict[str, Any]]) -> str:
    """The table of machines whose bearing is in order."""
    heads = ("signals", "number", *(f"{level:.0%}" for level in LEVELS), *reversed(SAID))
    lines = ["| " + " | ".join(heads) + " |", "|---|" + "---|" * (len(heads) - 1)]
    by_kind: dict[str, list[dict[str, Any]]] = {}
    for row in healthy:
        by_kind.setdefault(row["kind"], []).append(row)
    for kind, rows in by_kind.items():
        values = [value for row in rows for value in row["probabilities"]]
        counts = [sum(row[name] for row in rows) for name in reversed(SAID)]
        lines.append(
            "| " + " | ".join(map(str, (kind, len(values), *_shares(values), *counts))) + " |"
        )
    return "\n".join(lines)


def _faults(found: list[dict[str, Any]]) -> str:
    """The table of faults that are planted."""
    lines = [
        "| | " + " | ".join(f"{ratio:g} dB" for ratio in RATIOS) + " | half named at |",
        "|---|" + "---|" * (len(RATIOS) + 1),
    ]
    for row in found:
        shares = [named / row["seeds"] for named in row["found"]]
        both = zip(shares, row["stated"], strict=True)
        cells = [f"{share:.0%} ({one / row['seeds']:.0%})" for share, one in both]
        lines.append(f"| {row['setting']['title']} | " + " | ".join([*cells, _half(shares)]) + " |")
    return "\n".join(lines)


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
    if options.recordings is not None:
        results["recordings"] = tables(measured(options.recordings))
    results.setdefault("recordings", "")
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
    parser.add_argument("--recordings", type=Path, help="folder as of benchmarks.recordings")
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
