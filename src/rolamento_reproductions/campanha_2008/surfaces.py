"""Roughness of the races, the oil's temperature, noise: chapters 2.8, 4.1.1, 4.4.1 and 4.4.2."""

from __future__ import annotations

from functools import cache
from typing import Final

import numpy as np

from rolamento.lubrication.oil_state import reference_viscosity
from rolamento.lubrication.regime import regime_of
from rolamento.lubrication.roughness import rms_of_mean_roughness
from rolamento.units import RPM
from rolamento.vibration.anderon import velocity_of_anderons
from rolamento_reproductions.campanha_2008.clearance import BEARINGS, measured_of
from rolamento_reproductions.campanha_2008.contact import check_of
from rolamento_reproductions.campanha_2008.film import REGIMES
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    MICRO,
    oil_at,
    pitch_diameter,
    speed,
    temperature,
)
from rolamento_reproductions.campanha_2008.life_tests import life_tests
from rolamento_reproductions.given import grid
from rolamento_reproductions.record import (
    Claim,
    Curves,
    Figure,
    Floats,
    Line,
    Panel,
    Section,
    Series,
    Table,
    TableColumn,
)
from rolamento_reproductions.text import Text, said, same

_NEAR_ONE = (0.7, 1.4)
"""λ that reads as close to 1: a root of two on either side."""


def roughness_section(title: Text) -> Section:
    """Compute table 4.4.1 with λ, and figure 4.4.1."""
    return Section(title, (_surfaces(), _temperatures()))


# --- table 4.4.1 ------------------------------------------------------------


def _roughness_rows() -> list[tuple[int, str, float, float, float]]:
    """Bearing, condition, hours, R_a and R_z (µm)."""
    tests = {number: test for test in life_tests() for number in test.bearings}
    return [
        (number, tests[number].condition, tests[number].hours, float(mean), float(height))
        for number, mean, height in GIVEN.inputs_of("roughness")["rows"]
    ]


def _parameter(condition: str, mean: float) -> float:
    """λ of a race with this R_a (µm), the ball as measured on one bearing of its condition."""
    ball = GIVEN.inputs_of("roughness")["balls"][condition]
    rough = np.hypot(rms_of_mean_roughness(mean), rms_of_mean_roughness(ball))
    return float(check_of("h_c", condition).computed / rough)


def _regime(parameter: float) -> Text:
    regime = regime_of(parameter)
    assert regime is not None
    return REGIMES[regime.name]


def _surfaces() -> Table:
    rows = _roughness_rows()
    parameters = [_parameter(condition, mean) for _, condition, _, mean, _ in rows]

    def column(name: str, title: Text, cells: list[str]) -> TableColumn:
        return TableColumn(name, title, tuple(cells))

    return Table(
        number="4.4.1",
        caption=said(
            "Roughness of the inner races after the tests as printed, and what λ follows with the"
            " right film: the balls' roughness is that of bearing 7 (condition I) or 18 (II), the"
            " only ones printed.",
            "Rugosidade das pistas internas após os ensaios como impressa, e o λ que resulta com o"
            " filme correto: a rugosidade das esferas é a do rolamento 7 (condição I) ou 18 (II),"
            " as únicas impressas.",
        ),
        source=GIVEN.source_of("roughness"),
        columns=(
            column("bearing", said("Bearing", "Rolamento"), [str(row[0]) for row in rows]),
            column("condition", said("Condition", "Condição"), [row[1] for row in rows]),
            column("hours", said("Time (h)", "Tempo (h)"), [f"{row[2]:.1f}" for row in rows]),
            column("Ra_um", same("R_a (µm)"), [f"{row[3]:.4f}" for row in rows]),
            column("Rz_um", same("R_z (µm)"), [f"{row[4]:.4f}" for row in rows]),
            column("Rz_over_Ra", same("R_z/R_a"), [f"{row[4] / row[3]:.1f}" for row in rows]),
            column("lambda", same("λ"), [f"{value:.2f}" for value in parameters]),
            TableColumn("regime", same("regime"), tuple(_regime(value) for value in parameters)),
        ),
        claims=(_close_to_one(), _worn_alike()),
        notes=(_shape(rows),),
    )


def _close_to_one() -> Claim:
    values = np.array(
        [
            _parameter("I", mean)
            for _, condition, _, mean, _ in _roughness_rows()
            if condition == "I"
        ]
    )
    near = int(((values > _NEAR_ONE[0]) & (values < _NEAR_ONE[1])).sum())
    new = check_of("λ, bearing new", "I").computed
    return Claim(
        said("Condition I keeps λ close to 1.", "A condição I mantém um padrão de λ próximo de 1."),
        said(
            "After the tests {:.2f} to {:.2f}, {} of {} bearings between 0.7 and 1.4; new {:.2f}. λ"
            " falls as the race grows rough, so that one number is no measure of a test.",
            "Após os ensaios, {:.2f} a {:.2f}, com {} de {} rolamentos entre 0,7 e 1,4; novos,"
            " {:.2f}. λ cai à medida que a pista fica rugosa, de modo que um só número não mede um"
            " ensaio.",
            float(values.min()),
            float(values.max()),
            near,
            values.size,
            new,
        ),
        holds=near == values.size,
        partly=near > 0,
    )


def _worn_alike() -> Claim:
    means = {
        name: np.array(
            [mean for _, condition, _, mean, _ in _roughness_rows()[:20] if condition == name]
        )
        for name in ("I", "II")
    }
    first, second = means["I"], means["II"]
    error = float(np.sqrt(first.var(ddof=1) / first.size + second.var(ddof=1) / second.size))
    difference = float(second.mean() - first.mean())
    return Claim(
        said(
            "λ of conditions I and II leaves no great difference on the races (chapter 4.2.3).",
            "Não há diferenças que denotem grande influência de λ nas pistas das condições I e II"
            " (capítulo 4.2.3).",
        ),
        said(
            "Mean R_a of procedure I {:.3f} and {:.3f} µm; the difference is {:.1f} standard"
            " errors. That is not zero, and not proof of one either.",
            "R_a médio do procedimento I {:.3f} e {:.3f} µm; a diferença é de {:.1f} vez o erro"
            " padrão. Não é zero, mas também não prova diferença.",
            float(first.mean()),
            float(second.mean()),
            difference / error,
        ),
        holds=difference < 2.0 * error,
    )


def _shape(rows: list[tuple[int, str, float, float, float]]) -> Text:
    ratios = [row[4] / row[3] for row in rows]
    return said(
        "R_z/R_a from {:.1f} to {:.1f}: above some 8 single scratches or dents stand out of a finer"
        " surface, and σ = 1.25 R_a, made for a Gaussian one, comes out too small and λ too great.",
        "R_z/R_a de {:.1f} a {:.1f}: acima de cerca de 8 destacam-se riscos ou marcas isoladas de"
        " uma superfície mais fina, e σ = 1,25 R_a, feito para uma gaussiana, resulta pequeno, e λ,"
        " grande.",
        min(ratios),
        max(ratios),
    )


# --- figure 4.4.1 -----------------------------------------------------------


def _temperatures() -> Figure:
    given = GIVEN.inputs_of("temperature")
    celsius = np.unique(
        np.concatenate(
            [
                grid(given["lowest_degC"], given["highest_degC"], given["step_degC"]),
                [temperature("I"), temperature("II")],
            ]
        )
    )
    viscosity = np.asarray(oil_at(celsius).kinematic_viscosity) / MICRO
    means = [temperature("I"), temperature("II")]
    at_means = np.where(np.isin(celsius, means), viscosity, np.nan)
    as_printed = np.full(celsius.size, np.nan)
    for name, value in GIVEN.inputs_of("contact")["viscosities_mm2_s"].items():
        as_printed[np.searchsorted(celsius, temperature(name))] = value
    title = said("Kinematic viscosity ν", "Viscosidade cinemática ν")
    levels = [
        np.full(celsius.size, value) for value in (given["reference_viscosity_mm2_s"], _needed())
    ]
    columns = (
        Series("temperature", "°C", said("Temperature", "Temperatura"), celsius),
        Series("viscosity", "mm²/s", title, viscosity),
        Series("of_conditions", "mm²/s", title, at_means),
        Series("as_printed", "mm²/s", title, as_printed),
        Series("of_1990", "mm²/s", title, levels[0]),
        Series("of_2007", "mm²/s", title, levels[1]),
    )
    lines = (
        Line("viscosity", 0, same("Tonna S 68, ASTM D341")),
        Line("of_1990", 3, same("13 mm²/s, ISO 281:1990")),
        Line("of_2007", 2, same("ν_1, ISO 281:2007")),
        Line("of_conditions", 5, said("conditions I and II", "condições I e II"), points=True),
        Line("as_printed", 1, said("as printed", "como impresso"), points=True),
    )
    return Figure(
        number="4.4.1",
        caption=said(
            "What the temperatures of figures 4.4.1 and 4.4.2 mean: viscosity of the oil at the"
            " mean temperatures of both conditions, {:.1f} and {:.0f} °C, beside the printed"
            " viscosities and what ISO 281 wants.",
            "O que significam as temperaturas das figuras 4.4.1 e 4.4.2: viscosidade do óleo nas"
            " temperaturas médias das duas condições, {:.1f} e {:.0f} °C, ao lado das viscosidades"
            " impressas e do que pede a ISO 281.",
            temperature("I"),
            temperature("II"),
        ),
        source=GIVEN.source_of("temperature"),
        columns=columns,
        picture=Curves(
            (
                Panel(
                    "temperature",
                    title,
                    "mm²/s",
                    lines,
                    tick=5.0,
                    from_zero=False,
                    legend_columns=3,
                ),
            )
        ),
        claims=(_above_reference(), _below_reference(), _enough()),
        notes=(
            said(
                "The measured temperatures of oil and housings are drawn in the printed figures"
                " only, and cannot be computed; the means are in the text.",
                "As temperaturas medidas do óleo e dos mancais só estão desenhadas nas figuras"
                " impressas e não se podem calcular; as médias estão no texto.",
            ),
        ),
    )


def _needed() -> float:
    """ν_1 of the 6305 at the speed of the tests; mm²/s."""
    return float(reference_viscosity(speed(), pitch_diameter())) / MICRO


def _viscosity(condition: str) -> float:
    return float(oil_at(temperature(condition)).kinematic_viscosity) / MICRO


def _above_reference() -> Claim:
    reference = GIVEN.inputs_of("temperature")["reference_viscosity_mm2_s"]
    used = GIVEN.inputs_of("contact")["viscosities_mm2_s"]["I"]
    return Claim(
        said(
            "In condition I the viscosity is above 13 mm²/s.",
            "Na condição I a viscosidade é maior que 13 mm²/s.",
        ),
        said(
            "{:.2f} mm²/s at {:.1f} °C. The printed calculation takes {:.2f} mm²/s, below the"
            " limit.",
            "{:.2f} mm²/s a {:.1f} °C. O cálculo impresso usa {:.2f} mm²/s, abaixo do limite.",
            _viscosity("I"),
            temperature("I"),
            used,
        ),
        _viscosity("I") > reference,
    )


def _below_reference() -> Claim:
    reference = GIVEN.inputs_of("temperature")["reference_viscosity_mm2_s"]
    return Claim(
        said("In condition II it is below.", "Na condição II é menor."),
        same("{:.2f} mm²/s.", _viscosity("II")),
        _viscosity("II") < reference,
    )


def _enough() -> Claim:
    needed = _needed()
    return Claim(
        said(
            "13 mm²/s is the minimum viscosity with which a ball bearing runs without trouble from"
            " its film.",
            "13 mm²/s é a viscosidade mínima para um rolamento de esferas trabalhar sem problemas"
            " na formação do filme.",
        ),
        said(
            "It is the edition of 1990's, for all sizes and speeds. That of 2007 asks this bearing"
            " at 2000 rpm for ν_1 = {:.1f} mm²/s: κ = {:.2f} and {:.2f}, both below 1.",
            "É a da edição de 1990, para todos os tamanhos e rotações. A de 2007 pede deste"
            " rolamento a 2000 rpm ν_1 = {:.1f} mm²/s: κ = {:.2f} e {:.2f}, ambos abaixo de 1.",
            needed,
            *(_viscosity(name) / needed for name in ("I", "II")),
        ),
        needed <= GIVEN.inputs_of("temperature")["reference_viscosity_mm2_s"],
    )


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
    passed = {n: bands for n, bands in _rejected().items() if n not in failed}
    counts = [sum(band in bands for bands in passed.values()) for band in _BANDS]
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
            len(passed),
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
                    same("{} (anderon)", band),
                    tuple(level(r[2], place) for r in rows),
                )
                for place, band in enumerate(_BANDS)
            ),
            *(
                TableColumn(
                    f"{band}_um_per_s",
                    same("{} (µm/s)", band),
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
        notes=(_anderon_unit(),),
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


def _anderon_unit() -> Text:
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
