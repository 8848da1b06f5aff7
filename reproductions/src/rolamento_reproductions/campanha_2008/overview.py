"""What changes when it is computed as it should be, in one table; and slips of the text."""

from __future__ import annotations

from dataclasses import dataclass

from rolamento.life.ioannides_harris import fatigue_limit_of_pressure
from rolamento.life.iso281_modified import FATIGUE_PRESSURE
from rolamento.verification.campanha_2008 import as_plotted, four_failures
from rolamento_reproductions.campanha_2008.contact import contact_numbers, shear_numbers
from rolamento_reproductions.campanha_2008.film import film_numbers
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    Number,
    by_key,
    contact_at,
    printed,
    said,
    said_like,
)
from rolamento_reproductions.campanha_2008.load_zone import load_zone_numbers
from rolamento_reproductions.campanha_2008.rating import nsk_numbers, rating_numbers
from rolamento_reproductions.campanha_2008.weibull import (
    Tested,
    life_by_all,
    lives_of_tests,
    six_failures,
)
from rolamento_reproductions.record import Section, Table, TableColumn
from rolamento_reproductions.text import Text, formula, same


def overview_section(title: Text) -> Section:
    """Gather the numbers that matter from the tables below."""
    numbers = by_key(
        (
            *rating_numbers(),
            *nsk_numbers(),
            *load_zone_numbers(),
            *lives_of_tests(),
            *shear_numbers(),
            *contact_numbers(),
            *film_numbers(),
        )
    )
    rows = [(numbers[key], told) for key, told in _MEANING.items()]
    return Section(title, (_overview_table(rows),))


_MEANING = {
    "basic_life": said("meaning.basic_life"),
    "measured_rating": said("meaning.measured_rating"),
    "catalogue_I": said("meaning.catalogue_I"),
    "measured_I": said("meaning.measured_I"),
    "reduction": said("meaning.reduction"),
    "life_I": said("meaning.life_I"),
    "life_II": said("meaning.life_II"),
    "depth": said("meaning.depth"),
    "viscosity_I": said("meaning.viscosity_I"),
    "speed": said("meaning.speed"),
    "film_I": said("meaning.film_I"),
    "film_II": said("meaning.film_II"),
    "lambda_I_new": said("meaning.lambda_I_new"),
    "lambda_I_7": said("meaning.lambda_I_7"),
    "lambda_II_18": said("meaning.lambda_II_18"),
}


def _overview_table(rows: list[tuple[Number, Text]]) -> Table:
    """Words and numbers only: the numbers are compared below, each in its place."""
    return Table(
        number="A",
        caption=said("overview_table.caption"),
        source=GIVEN.source_of("overview"),
        columns=(
            TableColumn("quantity", said("quantity"), tuple(row.quantity for row, _ in rows)),
            TableColumn(
                "printed",
                said("printed"),
                tuple(said_like(row.printed, float(row.printed)) for row, _ in rows),
            ),
            TableColumn("right", said("right"), tuple(r.right_text for r, _ in rows)),
            TableColumn(
                "meaning",
                said("overview_table.meaning"),
                tuple(told for _, told in rows),
                sentences=True,
            ),
        ),
    )


@dataclass(frozen=True, slots=True)
class _Slip:
    """One slip: where it stands, as printed, as it should be, and why."""

    place: Text
    printed: Text
    right: Text
    reason: Text


def slips_section(title: Text) -> Section:
    """List the slips."""
    slips = (*_EQUATIONS, _fatigue_limit(), *_of_weibull(), *_WORDS)

    def column(name: str, head: Text, cells: tuple[Text, ...]) -> TableColumn:
        return TableColumn(name, head, cells, sentences=name != "place")

    table = Table(
        number="K",
        caption=said("slips_section.caption"),
        source=GIVEN.source_of("slips"),
        columns=(
            column("place", said("slips_section.place"), tuple(slip.place for slip in slips)),
            column("printed", said("printed"), tuple(slip.printed for slip in slips)),
            column("right", said("right"), tuple(slip.right for slip in slips)),
            column("reason", said("why"), tuple(slip.reason for slip in slips)),
        ),
    )
    return Section(title, (table,))


_EQUATIONS = (
    _Slip(
        same("2.4.6, (2.4.5), (2.4.6)"),
        said("slip.r_in_groups_and.printed"),
        said("slip.r_in_groups_and.right"),
        said("slip.r_in_groups_and.reason"),
    ),
    _Slip(
        same("2.4.6, (2.4.9)"),
        said("slip.if_r_x_r.printed"),
        said("slip.if_r_x_r.right"),
        said("slip.if_r_x_r.reason"),
    ),
    _Slip(
        same("4.4.3, (4.4.3)"),
        formula("U = D_pw/2 [(1 − γ)(ω_i − ω_m) + φ ω_esf]"),
        formula("U = D_pw/4 [(1 − φ)(ω_i − ω_m) + φ ω_esf]"),
        said("slip.u_d_pw_2.reason"),
    ),
    _Slip(
        same("2.6, (2.6.9)"),
        said("slip.risk_dv_1_f.printed"),
        said("slip.risk_dv_1_f.right"),
        said("slip.risk_dv_1_f.reason"),
    ),
)


def _fatigue_limit() -> _Slip:
    """1500 MPa is a pressure."""
    measured = printed("life")["measured_conformity"]
    shape = float(contact_at(1.0, measured, "inner").ellipticity)
    shear = float(fatigue_limit_of_pressure(FATIGUE_PRESSURE, shape))
    return _Slip(
        same("2.6, (2.6.5)"),
        said("slip.fatigue_limit_u_is.printed"),
        same("{:.0f} MPa", shear / 1e6),
        said("slip.fatigue_limit_u_is.reason"),
    )


def _of_weibull() -> tuple[_Slip, ...]:
    """Likelihood equations, and the name of η."""
    four, six, whole = Tested.of(four_failures()).fit, Tested.of(six_failures()), life_by_all()
    printed = as_plotted(four_failures())
    return (
        _Slip(
            same("2.7, (2.7.5)"),
            formula("1/β + (Σ ln t/Σ t^β ln t)/n − Σ ln t/Σ t^β = 0"),
            formula("1/β + (Σ ln t)/n − Σ t^β ln t/Σ t^β = 0"),
            said("slip.1_beta_ln_t.reason", shape=four.shape, l10=four.l10),
        ),
        _Slip(
            same("2.7, (2.7.5), (2.7.6)"),
            said("slip.n_bearings_all_failed.printed"),
            said("slip.n_bearings_all_failed.right"),
            said(
                "slip.n_bearings_all_failed.reason",
                failures=whole.test.failures,
                size=whole.test.size,
                l10_1=whole.fit.l10,
                l10_2=six.fit.l10,
            ),
        ),
        _Slip(
            same("2.7"),
            said("slip.eta_is_called_mean.printed"),
            said("slip.eta_is_called_mean.right"),
            said(
                "slip.eta_is_called_mean.reason",
                fit_scale=whole.fit.scale,
                fit_mean=whole.fit.mean,
                printed_scale=printed.scale,
                printed_mean=printed.mean,
            ),
        ),
    )


_WORDS = (
    _Slip(
        same("2.2"),
        said("slip.r_z_from_highest.printed"),
        said("slip.r_z_from_highest.right"),
        said("slip.r_z_from_highest.reason"),
    ),
    _Slip(
        same("2.8"),
        same("anderon: MIL/rad"),
        said("slip.anderon_mil_rad.right"),
        said("slip.anderon_mil_rad.reason"),
    ),
    _Slip(
        same("3.4.4"),
        said("slip.clearance_measured_by_iso.printed"),
        same("ISO 5753-1"),
        said("slip.clearance_measured_by_iso.reason"),
    ),
    _Slip(
        same("4.1.2"),
        said("slip.with_failure_bearing_5.printed"),
        said("slip.with_failure_bearing_5.right"),
        said("slip.with_failure_bearing_5.reason"),
    ),
    _Slip(
        same("4.1.2"),
        said("slip.l_able_117_4.printed"),
        same("L_10h"),
        said("slip.l_able_117_4.reason"),
    ),
    _Slip(
        said("slip.second_column_test.place"),
        said("slip.second_column_test.printed"),
        said("slip.second_column_test.right"),
        said("slip.second_column_test.reason"),
    ),
    _Slip(
        same("4.4.3"),
        said("slip.7_03_cst_see.printed"),
        said("slip.7_03_cst_see.right"),
        said("slip.7_03_cst_see.reason"),
    ),
)
