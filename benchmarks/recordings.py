"""Rates of the diagnosis on real recordings: `python -m benchmarks.recordings FOLDER`.

FOLDER holds WAV files and `recordings.csv`, a table of them with at least the columns

    file, rig, bearing, nominal_rpm, truth

where `truth` is outer_race, inner_race, ball, cage, healthy or healthy_disputed.
`damaged_elsewhere` says of a healthy bearing that another part of the machine is damaged. Of a
rig's name the part before the
first "-" is the rig that limits are left out for: "CWRU-12k_DE" and "CWRU-normal" are of CWRU.

Beside the diagnosis stands what a user would write instead: cepstrum pre-whitening, squared
envelope, and the mean of three harmonics over the noise; its limit is set on the very recordings
that it is judged by, so that it accuses as many healthy bearings as the diagnosis does, or as few
as it can. `--json FILE` keeps all, `--markdown FILE` writes the tables.
"""

from __future__ import annotations

import argparse
import csv
import json
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass, replace
from math import inf, nan, pi, sqrt
from pathlib import Path
from statistics import median
from typing import Any, Final

import numpy as np

from rolamento import Bearing
from rolamento.vibration.demodulation import prewhitened
from rolamento.vibration.diagnosis import (
    COMPONENTS,
    DAMAGE,
    SMOOTH,
    Component,
    Diagnosis,
    FaultOrders,
    diagnose,
)
from rolamento.vibration.diagnosis.size import SMOOTH_BAND, SMOOTH_RECORD
from rolamento.vibration.frequencies import nominal_frequencies
from rolamento.vibration.reading import read_signal
from rolamento.vibration.signal import Signal

TABLE: Final = "recordings.csv"
LENGTHS: Final = (inf, 5.0, 2.0, 1.0)
"""Of the recordings that are used, from their beginning; s."""
RACES: Final = ("outer_race", "inner_race")
COUNT_ALL: Final = "all"


@dataclass(frozen=True, slots=True)
class Recording:
    """A row of the table."""

    file: str
    rig: str
    bearing: str
    rpm: float
    truth: str
    elsewhere: str

    @property
    def group(self) -> str:
        """The rig, of which `rig` may be one end."""
        return self.rig.split("-", maxsplit=1)[0]

    @property
    def kind(self) -> str:
        """Of which the rates are asked: race, ball, cage, healthy, other end."""
        if self.truth in RACES:
            return "race"
        return "other end" if self.truth == "healthy" and self.elsewhere else self.truth


@dataclass(frozen=True, slots=True)
class Outcome:
    """What was said of a recording.

    stated: as damaged, the first first; undecided: part that something speaks against as strongly;
    watched: part with lines as healthy bearings have; depth: of the first part of any of these;
    plain: score and part of the plain baseline; kurtosis, band_kurtosis: of the record, and of the
    band of the first part that is stated or watched.
    """

    stated: tuple[str, ...]
    undecided: str
    watched: str
    depth: float
    grade: str
    speed_factor: float
    seconds: float
    plain: tuple[float, str]
    kurtosis: float = nan
    band_kurtosis: float = nan

    @property
    def first(self) -> str:
        """Part that is named first, as damaged or to be watched."""
        return self.stated[0] if self.stated else self.watched


Result = tuple[Recording, Outcome]
Picked = Callable[[Result], bool]


def recordings(folder: Path) -> list[Recording]:
    """Rows of a folder's table."""
    with (folder / TABLE).open(encoding="utf-8", newline="") as lines:
        return [
            Recording(
                file=row["file"],
                rig=row["rig"],
                bearing=row["bearing"],
                rpm=float(row["nominal_rpm"]),
                truth=row["truth"],
                elsewhere=row.get("damaged_elsewhere") or "",
            )
            for row in csv.DictReader(lines)
        ]


def tried(folder: Path, recording: Recording, length: float) -> Outcome:
    """Diagnose the beginning of a recording as the command does, at the nominal speed."""
    speed = recording.rpm * pi / 30.0
    whole = read_signal(folder / recording.file)
    count = int(min(len(whole.samples), length * whole.rate))
    signal = Signal(whole.samples[:count], whole.rate, speed=speed)
    orders = FaultOrders.of(nominal_frequencies(Bearing.named(recording.bearing), speed))
    start = time.perf_counter()
    found = diagnose(signal, orders)
    seconds = time.perf_counter() - start
    return outcome(found, seconds, plain(signal, orders))


def outcome(found: Diagnosis, seconds: float, baseline: tuple[float, str]) -> Outcome:
    """What a diagnosis comes to."""
    seen = [part for part in found.components if part.depth > 0.0]
    stated = [part for part in seen if part.verdict in ("fault", "undecided", "watch")]
    watched = sorted((p for p in stated if p.verdict == "watch"), key=lambda part: -part.depth)
    undecided = [part.component for part in stated if part.verdict == "undecided"]
    if not undecided and (found.undecided or found.impacts is not None):
        undecided = ["unexplained"]
    return Outcome(
        stated=found.causes,
        undecided=undecided[0] if undecided else "",
        watched=watched[0].component if watched else "",
        depth=max((part.depth for part in stated or seen), default=0.0),
        grade=found.grade,
        speed_factor=found.speed_factor,
        seconds=seconds,
        plain=baseline,
        kurtosis=found.kurtosis,
        band_kurtosis=max(stated, key=lambda part: part.depth).band_kurtosis if stated else nan,
    )


def plain(signal: Signal, orders: FaultOrders) -> tuple[float, str]:
    """Score and name of the part whose three harmonics stand out most of the squared envelope."""
    white = np.asarray(np.fft.fft(prewhitened(signal).samples))
    white[len(white) // 2 + 1 :] = 0.0
    squared = np.square(np.abs(np.fft.ifft(2.0 * white)))
    power = np.square(np.abs(np.fft.rfft(squared - squared.mean())))
    turns = abs(float(signal.mean_speed)) / (2.0 * pi) * signal.duration
    scores: dict[str, float] = {}
    for part in COMPONENTS:
        scores[part] = _harmonics(power, orders, part, turns)
    best = max(scores, key=lambda part: scores[part])
    return scores[best], best


def _harmonics(power: Any, orders: FaultOrders, part: Component, turns: float) -> float:
    nominal = (orders.fundamental(part) or 0.0) * turns
    grid = np.arange(0.98 * nominal, 1.02 * nominal, 1.0 / 3.0)
    if len(grid) == 0 or 3.0 * grid[-1] + 100.0 > len(power):
        return 0.0
    total = np.zeros(len(grid))
    for multiple in (1, 2, 3):
        places = np.rint(multiple * grid).astype(int)
        about = power[max(1, places[0] - 100) : places[-1] + 100]
        total += power[places] / np.median(about)
    return float(np.max(total)) / 3.0


# --- rates -----------------------------------------------------------------------------------


def is_right(cause: str, truth: str) -> bool:
    """Whether a part that is named is the damaged one; lines of the cage are said of either."""
    return cause == truth or (cause == "ball_or_cage" and truth in ("ball", "cage"))


def rates(results: Sequence[Result]) -> dict[str, tuple[int, int]]:
    """Counts of what happened, and of how many recordings it could have; by name."""
    races = [r for r in results if r[0].kind == "race"]
    balls = [r for r in results if r[0].kind in ("ball", "cage")]
    healthy = [r for r in results if r[0].kind == "healthy"]
    other = [r for r in results if r[0].kind == "other end"]
    disputed = [r for r in results if r[0].kind == "healthy_disputed"]
    return {
        "race: named first": _count(races, lambda r: is_right(r[1].first, r[0].truth)),
        "race: damage stated, it alone": _count(races, _alone),
        "race: another stated first": _count(races, _wrong_first),
        "race: another named first": _count(
            races, lambda r: bool(r[1].first) and not is_right(r[1].first, r[0].truth)
        ),
        "ball: ball, or ball or cage": _count(
            balls, lambda r: bool(r[1].stated) and is_right(r[1].stated[0], r[0].truth)
        ),
        "ball: another part stated": _count(balls, _wrong),
        "healthy: damage stated": _count(healthy, lambda r: bool(r[1].stated)),
        "other end: damage stated": _count(other, lambda r: bool(r[1].stated)),
        "health disputed: damage stated": _count(disputed, lambda r: bool(r[1].stated)),
        "not decided": _count(results, lambda r: bool(r[1].undecided)),
    }


def plain_rates(results: Sequence[Result], allowed: int) -> dict[str, tuple[int, int]]:
    """As `rates`, of the baseline, with as many healthy bearings accused as allowed."""
    sound = sorted((r[1].plain[0] for r in results if r[0].truth == "healthy"), reverse=True)
    limit = sound[allowed] if allowed < len(sound) else 0.0
    said = []
    for row, one in results:
        score, part = one.plain
        stated = (part,) if score > limit else ()
        said.append((row, replace(one, stated=stated, undecided="", watched="")))
    return rates(said)


def _count(results: Sequence[Result], picked: Picked) -> tuple[int, int]:
    return sum(map(picked, results)), len(results)


def _alone(result: Result) -> bool:
    stated = result[1].stated
    return len(stated) == 1 and is_right(stated[0], result[0].truth)


def _wrong_first(result: Result) -> bool:
    stated = result[1].stated
    return bool(stated) and not is_right(stated[0], result[0].truth)


def _wrong(result: Result) -> bool:
    return any(not is_right(part, result[0].truth) for part in result[1].stated)


def limit_of(results: Iterable[Result]) -> float:
    """Depth between healthy bearings and damaged races.

    The geometric mean of the depth that 95 % of the healthy ones with any line stay under, and of
    what 90 % of the races reach of those whose damage is named first.
    """
    kept = list(results)
    sound = [r[1].depth for r in kept if r[0].truth == "healthy" and r[1].depth > 0.0]
    races = [r[1].depth for r in kept if r[0].kind == "race" and is_right(r[1].first, r[0].truth)]
    if not sound or not races:
        return float("nan")
    return sqrt(float(np.quantile(sound, 0.95)) * float(np.quantile(races, 0.10)))


def left_out(results: Sequence[Result]) -> list[dict[str, Any]]:
    """For each rig the limit that all others give, and what that makes of it.

    A limit changes the grade of the part that is named first; what speaks against it stays.
    """
    rows = []
    for group in sorted({r[0].group for r in results}):
        limit = limit_of(r for r in results if r[0].group != group)
        own = [r for r in results if r[0].group == group]
        above = [r for r in own if r[1].depth >= limit and not r[1].undecided]
        sound = [r for r in own if r[0].truth == "healthy"]
        races = [r for r in own if r[0].kind == "race"]
        rows.append(
            {
                "rig": group,
                "limit": limit,
                "healthy": (sum(r[0].truth == "healthy" for r in above), len(sound)),
                "race": (
                    sum(r[0].kind == "race" and is_right(r[1].first, r[0].truth) for r in above),
                    len(races),
                ),
            }
        )
    return rows


# --- tables ----------------------------------------------------------------------------------


def tables(whole: list[Result]) -> str:
    """Of recordings that are used whole: rates, grades, and limits with each rig left out."""
    groups = [COUNT_ALL, *sorted({r[0].rig for r in whole})]
    heads = [groups[0], "95 %", *groups[1:], "plain"]
    lines = [f"{len(whole)} recordings.", "", "| | " + " | ".join(heads) + " |"]
    lines.append("|---|" + "---|" * len(heads))
    allowed = sum(bool(r[1].stated) for r in whole if r[0].truth == "healthy")
    baseline = plain_rates(whole, allowed)
    columns = [rates([r for r in whole if group in (COUNT_ALL, r[0].rig)]) for group in groups]
    for name in columns[0]:
        cells = [_share(column[name]) for column in columns]
        cells.insert(1, _limits(columns[0][name]))
        lines.append(f"| {name} | " + " | ".join(cells) + f" | {_share(baseline[name])} |")
    lines += ["", "| part | recordings | named first | damage stated | wrong part stated |"]
    lines.append("|---|---|---|---|---|")
    for truth in COMPONENTS:
        some = [r for r in whole if r[0].truth == truth]
        if some:
            cells = [
                _share(_count(some, lambda r: is_right(r[1].first, r[0].truth))),
                _share(_count(some, lambda r: any(is_right(s, r[0].truth) for s in r[1].stated))),
                _share(_count(some, _wrong)),
            ]
            lines.append(f"| {truth} | {len(some)} | " + " | ".join(cells) + " |")
    grades = ("nothing", "watch", "undecided", "damage", "severe")
    lines += ["", "| | " + " | ".join(grades) + " |", "|---|" + "---|" * len(grades)]
    for kind in ("race", "ball", "cage", "healthy", "other end", "healthy_disputed"):
        some = [r for r in whole if r[0].kind == kind]
        if some:
            counts = [sum(_grade(r[1]) == grade for r in some) for grade in grades]
            lines.append(f"| {kind} | " + " | ".join(map(str, counts)) + " |")
    lines += ["", f"Limit of damage: {DAMAGE:.0%}; of all rigs together {limit_of(whole):.0%}.", ""]
    lines += ["| rig left out | limit | healthy above | races above |", "|---|---|---|---|"]
    for row in left_out(whole):
        lines.append(
            f"| {row['rig']} | {row['limit']:.0%} | {_share(row['healthy'])} | "
            f"{_share(row['race'])} |"
        )
    lines += [
        "",
        "Smooth modulation: limits of kurtosis and depth that the other rigs give, one step below",
        "those at which none of their right statements is lost, and what they hold back on the rig",
        f"left out; {SMOOTH_RECORD:g}, {SMOOTH_BAND:g} and {SMOOTH:.0%} are taken.",
        "",
        *smooth_left_out(whole),
    ]
    return "\n".join(lines) + "\n"


def by_lengths(results: dict[float, list[Result]]) -> str:
    """The rates over how much of the recordings is used."""
    names = list(rates(results[inf]))
    lines = ["| length | " + " | ".join(names) + " | median time |"]
    lines.append("|---|" + "---|" * (len(names) + 1))
    for length, some in results.items():
        cells = [_share(value) for value in rates(some).values()]
        seconds = median(r[1].seconds for r in some)
        title = "whole" if length == inf else f"{length:g} s"
        lines.append(f"| {title} | " + " | ".join(cells) + f" | {seconds:.2f} s |")
    return "\n".join(lines) + "\n"


def _grade(outcome: Outcome) -> str:
    return "undecided" if outcome.undecided else outcome.grade


def _share(counts: tuple[int, int]) -> str:
    count, number = counts
    return f"{count} of {number}" if number else "–"


def wilson(count: int, number: int, z: float = 1.96) -> tuple[float, float]:
    """Limits of a share at 95 % (Wilson, Journal of the American Statistical Association 22)."""
    share, spread = count / number, z * z / number
    middle = (share + 0.5 * spread) / (1.0 + spread)
    half = z * sqrt(share * (1.0 - share) / number + 0.25 * spread / number) / (1.0 + spread)
    return max(0.0, middle - half), min(1.0, middle + half)


def _limits(counts: tuple[int, int]) -> str:
    if not counts[1]:
        return "–"
    low, high = wilson(*counts)
    return f"{100 * low:.0f} to {100 * high:.0f} %"


_RECORD_LIMITS: Final = (3.0, 3.2, 3.4, 3.6, 3.8, 4.0)
_BAND_LIMITS: Final = (4.0, 4.5, 5.0, 5.5, 6.0)
_DEPTH_LIMITS: Final = (0.35, 0.45, 0.55, 0.65, 0.75, 0.85, 0.95)


def smooth_limits(results: Sequence[Result]) -> tuple[float, float, float]:
    """Highest limits of smoothness, one step back, at which no damage that is stated right is lost.

    Kurtosis of the record first, with any band; then of the band, with the highest of the record's;
    then the depth, with both: (record, band, depth).
    """
    right = [r[1] for r in results if _alone(r)]
    small = [one for one in right if one.depth < SMOOTH]
    record, highest = _one_step_back(
        _RECORD_LIMITS, lambda limit: all(one.kurtosis >= limit for one in small)
    )
    band, _ = _one_step_back(
        _BAND_LIMITS,
        lambda limit: all(one.kurtosis >= highest or one.band_kurtosis >= limit for one in small),
    )
    depth, _ = _one_step_back(
        _DEPTH_LIMITS,
        lambda limit: all(
            one.depth >= limit or one.kurtosis >= record or one.band_kurtosis >= band
            for one in right
        ),
    )
    return record, band, depth


def _one_step_back(limits: Sequence[float], holds: Callable[[float], bool]) -> tuple[float, float]:
    """The last limit but one that holds, and the last."""
    good = [limit for limit in limits if holds(limit)] or [limits[0]]
    return good[-2] if len(good) > 1 else limits[0], good[-1]


def smooth_left_out(results: Sequence[Result]) -> list[str]:
    """For each rig the limits of smooth modulation that the others give, and what they cost it."""
    heads = ("rig left out", "record", "band", "depth", "right and held back",
             "not damaged and held back")  # fmt: skip
    lines = ["| " + " | ".join(heads) + " |", "|---|" + "---|" * (len(heads) - 1)]
    for group in sorted({r[0].group for r in results}):
        record, band, depth = smooth_limits([r for r in results if r[0].group != group])
        deep = [
            r
            for r in results
            if r[0].group == group
            and DAMAGE <= r[1].depth < depth
            and r[1].kurtosis < record
            and r[1].band_kurtosis < band
        ]
        lost = sum(r[0].kind in ("race", "ball") for r in deep)
        races = sum(r[0].group == group and r[0].kind in ("race", "ball") for r in results)
        held = len(deep) - lost
        sound = sum(r[0].group == group for r in results) - races
        lines.append(
            f"| {group} | {record:g} | {band:g} | {depth:.0%} | {_share((lost, races))} | "
            f"{_share((held, sound))} |"
        )
    return lines


def main(arguments: Sequence[str] | None = None) -> None:
    """Diagnose all recordings of a folder, and write."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.recordings", description=__doc__)
    parser.add_argument("folder", type=Path, help=f"of WAV files and {TABLE}")
    parser.add_argument("--quick", action="store_true", help="whole recordings alone")
    for name in ("json", "markdown"):
        parser.add_argument(f"--{name}", type=Path, metavar="FILE")
    options = parser.parse_args(arguments)
    lengths = LENGTHS[:1] if options.quick else LENGTHS
    by_length = {length: measured(options.folder, length) for length in lengths}
    if options.json is not None:
        kept = [
            {"length": None if length == inf else length, **asdict(row), **asdict(said)}
            for length, results in by_length.items()
            for row, said in results
        ]
        options.json.write_text(json.dumps(kept), encoding="utf-8")
    page = f"{tables(by_length[inf])}\n{by_lengths(by_length)}"
    if options.markdown is not None:
        options.markdown.write_text(page, encoding="utf-8")
    print(page)


def measured(folder: Path, length: float = inf) -> list[Result]:
    """What is said of each recording of a folder, or of its beginning; length in s."""
    return [(row, tried(folder, row, length)) for row in recordings(folder)]


if __name__ == "__main__":
    main()
