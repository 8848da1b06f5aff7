"""Noise of the bearings by the anderometer: chapters 2.8 and 4.1.1."""

from __future__ import annotations

from functools import cache
from typing import Final

import numpy as np

from rolamento.vibration.anderon import velocity_of_anderons
from rolamento_reproductions.campanha_2008.inputs import GIVEN
from rolamento_reproductions.campanha_2008.life_tests import life_tests
from rolamento_reproductions.campanha_2008.wear import BEARINGS, measured_of
from rolamento_reproductions.given import RPM
from rolamento_reproductions.record import Claim, Floats, Section, Table, TableColumn
from rolamento_reproductions.text import Text, said, same

__all__ = ["anderon_speed", "noise_section"]

_MICRO: Final = 1e6
_BANDS: Final = ("L", "M", "H")
_CLOSE: Final = 0.9
"""Correlation from which two quantities are said to rise together."""
_TIME: Final = said("Time (h)", "Tempo (h)")


def noise_section(title: Text) -> Section:
    """Show the noise records, and what they tell."""
    return Section(title, (_after_test(), _test_5()))


def anderon_speed(band: str) -> float:
    """Return the vibration of one anderon in a band; rms, µm/s."""
    given = GIVEN.inputs_of("noise")
    low, high = given["bands_Hz"][band]
    return _MICRO * velocity_of_anderons(1.0, (low, high), given["speed_rpm"] * RPM)


# --- table 4.1.3 ------------------------------------------------------------


@cache
def _rejected() -> dict[int, str]:
    """Bands in which each bearing was rejected."""
    return {int(name): bands for name, bands in GIVEN.inputs_of("noise")["rejected"].items()}


def _roughness(bearing: int) -> float:
    """R_a of the inner race after the test; µm."""
    rows = GIVEN.inputs_of("roughness")["rows"]
    return float(next(row[1] for row in rows if row[0] == bearing))


def _after_test() -> Table:
    rejected = _rejected()
    tests = {number: test for test in life_tests() for number in test.bearings}

    def column(name: str, title: Text, cells: list[str]) -> TableColumn:
        return TableColumn(name, title, tuple(cells))

    return Table(
        number="4.1.3",
        caption=said(
            "Bands in which a bearing was rejected (×) after its test, with running time and the"
            " roughness of its inner race.",
            "Faixas em que o rolamento foi reprovado (×) após o ensaio, com o tempo e a rugosidade"
            " da pista interna.",
        ),
        source=GIVEN.source_of("noise"),
        columns=(
            column("bearing", said("Bearing", "Rolamento"), [str(n) for n in rejected]),
            column(
                "condition", said("Condition", "Condição"), [tests[n].condition for n in rejected]
            ),
            column(
                "hours", said("Time (h)", "Tempo (h)"), [f"{tests[n].hours:.1f}" for n in rejected]
            ),
            *(
                column(
                    band, same(band), ["×" if band in bands else "–" for bands in rejected.values()]
                )
                for band in _BANDS
            ),
            column("Ra_um", same("R_a (µm)"), [f"{_roughness(n):.4f}" for n in rejected]),
        ),
        claims=(_high(), _low(), _reliable()),
    )


def _mark(rejected: bool) -> str:
    return "×" if rejected else "–"


def _high() -> Claim:
    new = GIVEN.inputs_of("roughness")["new_inner_um"]
    found = [_roughness(n) for n, bands in _rejected().items() if "H" in bands]
    return Claim(
        said(
            "Rejection in H is due to the roughness having changed from that of manufacture.",
            "A reprovação em H se deve à variação da rugosidade em relação ao padrão de"
            " fabricação.",
        ),
        said(
            "All {} are rejected in H, and all are rougher than the new race with {:.3f} µm: {:.3f}"
            " to {:.3f} µm.",
            "Todos os {} foram reprovados em H e todos são mais rugosos que a pista nova, com"
            " {:.3f} µm: {:.3f} a {:.3f} µm.",
            len(found),
            new,
            min(found),
            max(found),
        ),
        len(found) == len(_rejected()) and min(found) > new,
    )


def _low() -> Claim:
    seen = set(GIVEN.inputs_of("noise")["found_by_eye"])
    rejected = {n for n, bands in _rejected().items() if "L" in bands}
    rejected |= {bearing for hours, bearing, levels in _levels() if not levels}
    recorded = seen & (set(_rejected()) | set(BEARINGS))
    return Claim(
        said(
            "The bearings rejected in L are those whose flaking was caught.",
            "Os reprovados em L são aqueles cujo escamamento foi captado.",
        ),
        said(
            "{}: of those with a noise record, just the ones on which flaking was seen.",
            "{}: dos que têm registro de ruído, exatamente aqueles em que se viu escamamento.",
            said("{} and {}", "{} e {}", *sorted(rejected)),
        ),
        rejected == recorded,
    )


def _reliable() -> Claim:
    failed = {number for test in life_tests() for number in test.failed}
    sound = {n: bands for n, bands in _rejected().items() if n not in failed}
    counts = [sum(band in bands for bands in sound.values()) for band in _BANDS]
    return Claim(
        said(
            "Identifying trouble by noise is very reliable.",
            "A identificação de problemas pelo ruído é de grande confiabilidade.",
        ),
        said(
            "Of {} bearings that had not failed L rejects {}, M {} and H {}. Band L alone tells"
            " failure from wear here.",
            "De {} rolamentos que não haviam falhado, L reprova {}, M {} e H {}. Aqui só a faixa L"
            " distingue falha de desgaste.",
            len(sound),
            *counts,
        ),
        holds=counts[-1] == 0,
        partly=counts[0] == 0,
    )


# --- table 4.1.4 ------------------------------------------------------------


def _levels() -> list[tuple[float, int, list[int]]]:
    """Hours, bearing and the levels of test 5, none where rejected."""
    return [(hours, bearing, levels) for hours, bearing, levels in GIVEN.inputs_of("noise")["rows"]]


def _test_5() -> Table:
    rows = _levels()
    hours = [float(value) for value in GIVEN.inputs_of("clearance")["hours"]]

    def level(levels: list[int], place: int) -> str:
        return str(levels[place]) if levels else "×"

    def speed(levels: list[int], place: int) -> str:
        return f"{levels[place] * anderon_speed(_BANDS[place]):.0f}" if levels else "–"

    return Table(
        number="4.1.4",
        caption=said(
            "Noise of the bearings of test 5 over time in anderon, × where rejected, and what that"
            " is as vibration (rms); clearance from table 4.3.1.",
            "Ruído dos rolamentos do ensaio 5 ao longo do tempo em anderon, × onde reprovado, e o"
            " que isso é em vibração (rms); folga da tabela 4.3.1.",
        ),
        source=GIVEN.source_of("noise"),
        columns=(
            TableColumn("hours", _TIME, tuple(f"{r[0]:.1f}" for r in rows)),
            TableColumn("bearing", said("Bearing", "Rolamento"), tuple(str(r[1]) for r in rows)),
            *(
                TableColumn(
                    f"{band}_anderon",
                    said("{} (anderon)", "{} (anderon)", band),
                    tuple(level(r[2], place) for r in rows),
                )
                for place, band in enumerate(_BANDS)
            ),
            *(
                TableColumn(
                    f"{band}_um_per_s",
                    said("{} (µm/s)", "{} (µm/s)", band),
                    tuple(speed(r[2], place) for r in rows),
                )
                for place, band in enumerate(_BANDS)
            ),
            TableColumn(
                "clearance_um",
                said("clearance (µm)", "folga (µm)"),
                tuple(f"{measured_of(r[1])[hours.index(r[0])]:.0f}" for r in rows),
            ),
        ),
        claims=(_marks_and_clearance(),),
        notes=(_unit(),),
    )


def _together(bearing: int) -> tuple[Floats, Floats]:
    """Level in M and clearance (µm) of a bearing at the times that have both."""
    hours = [float(value) for value in GIVEN.inputs_of("clearance")["hours"]]
    rows = [(time, levels) for time, b, levels in _levels() if b == bearing and levels]
    level = np.array([levels[_BANDS.index("M")] for _, levels in rows], dtype=np.float64)
    clearance = np.array([measured_of(bearing)[hours.index(time)] for time, _ in rows])
    return level, clearance


def _marks_and_clearance() -> Claim:
    correlations = [float(np.corrcoef(*_together(bearing))[0, 1]) for bearing in BEARINGS]
    rises = [np.diff(_together(bearing)[0]) for bearing in BEARINGS]
    return Claim(
        said(
            "The noise in M, of marks and dents on the races, rises as the bearings wear.",
            "O ruído em M, de marcas e endentações nas pistas, aumenta com o desgaste.",
        ),
        said(
            "Through all measurements; correlation with the clearance {:.2f} and {:.2f}, of three"
            " and four points.",
            "Em todas as medições; correlação com a folga de {:.2f} e {:.2f}, de três e quatro"
            " pontos.",
            *correlations,
        ),
        all(bool((rise > 0).all()) for rise in rises) and min(correlations) > _CLOSE,
        of_theory=True,
    )


def _unit() -> Text:
    return said(
        "The dissertation prints the anderon as MIL/rad. It is a micro-inch per radian, rms, over"
        " the root of the band's octaves; at {:.0f} rpm {:.3f} µm/s in L and M, {:.3f} µm/s in H."
        " With thousandths of an inch bearing 9 would have run with {:.0f} mm/s in L after 60 h.",
        "A dissertação imprime o anderon como MIL/rad. É uma micropolegada por radiano, rms, sobre"
        " a raiz do número de oitavas da faixa; a {:.0f} rpm, {:.3f} µm/s em L e M, {:.3f} µm/s em"
        " H. Com milésimos de polegada o rolamento 9 teria girado com {:.0f} mm/s em L após 60 h.",
        GIVEN.inputs_of("noise")["speed_rpm"],
        anderon_speed("L"),
        anderon_speed("H"),
        _levels()[0][2][0] * anderon_speed("L"),
    )
