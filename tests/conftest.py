"""What all tests share: Hypothesis profiles, and a case to start from."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, settings

import rolamento
from rolamento import Bearing, Case, Duty, Load

for name, examples_of_a_property in (("ci", 40), ("verify", 200)):
    settings.register_profile(
        name,
        deadline=None,
        derandomize=True,
        max_examples=examples_of_a_property,
        suppress_health_check=[HealthCheck.too_slow],
    )
settings.register_profile("search", deadline=None, max_examples=2000)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "ci"))

os.environ.setdefault("ROLAMENTO_COMPILE", "here")  # what is tested does not depend on what is kept


def pytest_configure(config: pytest.Config) -> None:
    """Compile the words once, if they have changed; let Ctrl-C through even in the background.

    A shell starts what it puts in the background with SIGINT ignored, and processes inherit that.
    """
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    if hasattr(config, "workerinput"):
        return
    subprocess.run(
        [sys.executable, "scripts/words.py", "--compile"], cwd=config.rootpath, check=True
    )


@pytest.fixture(autouse=True, scope="session")
def _every_picture_concludes() -> Iterator[None]:
    """Fail a test that draws a chart without a line of what it says, with its numbers."""
    from rolamento.charts import Chart

    text = Chart.shows.fget

    def checked(chart: Chart) -> str:
        known = any(np.isfinite(one.y).any() for one in chart.lines)
        assert chart.says, "a chart says nothing"
        assert re.search(r"\d", chart.says) or not known, f"no number in {chart.says!r}"
        return text(chart)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Chart, "shows", property(checked))
        yield


@pytest.fixture(scope="session")
def examples() -> Path:
    """The directory of the shipped case files."""
    return Path(rolamento.__file__).parent / "examples"


@pytest.fixture(scope="session")
def bearing_218() -> Bearing:
    """The 218 angular-contact bearing."""
    return Bearing(
        ball_count=16,
        ball_diameter="22.23 mm",
        pitch_diameter="125.26 mm",
        contact_angle="40 deg",
        inner_conformity=0.5232,
        outer_conformity=0.5232,
    )


@pytest.fixture(scope="session")
def case_218(bearing_218: Bearing) -> Case:
    """The 218 bearing under combined load at 10 000 rpm."""
    load = Load(fx="20 kN", fz="15 kN")
    return Case(bearing=bearing_218, duty=Duty(inner_speed="10000 rpm", load=load))


@pytest.hookimpl(tryfirst=True)  # before cases are chosen by their marks
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Leave two of three cases of a test with many to the sweep."""
    counted: Counter[str] = Counter()
    for item in items:
        if item.get_closest_marker("thirds"):
            name = item.nodeid.partition("[")[0]
            if counted[name] % 3:
                item.add_marker(pytest.mark.sweep)
            counted[name] += 1
