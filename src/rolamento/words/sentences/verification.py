"""Why a published number and the computed one differ, or what a source does not state."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rolamento.words.speaking import marked

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

SENTENCES: Final[dict[str, Sentence]] = {
    "held_out_states": marked(
        "states of ball bearings under random duties, solved anew with exact Hertzian contacts"
    ),
    "held_out_rollers": marked(
        "loads and displacements of roller bearings by an independent model of slices"
    ),
    "held_out_catalogue": marked("rows of makers' catalogues"),
    "held_out_races": marked(
        "recordings of a damaged race in which that race alone is named; in none a wrong part"
    ),
    "held_out_healthy": marked("recordings of healthy machines, not called damaged"),
    "held_out_synthetic": marked(
        "synthetic records of healthy machines without impacts at multiples of the shaft speed, "
        "not called damaged"
    ),
    "verify_campanha_whole_load": marked(
        "The author puts the whole load on one ball, and the maximum shear at half the minor "
        "semi-axis. The heaviest of 8 balls carries 5/8 of the load, and the exact depth for "
        "this ellipse is nearly one third greater. Both use the catalogue's conformity of 0.52, "
        "at the inner race."
    ),
    "verify_campanha_other_temperature": marked(
        "The ASTM D341 line through the oil's two printed viscosities gives 12.89 mm²/s at 84.8 "
        "°C; at the 83.4 °C of the text it gives 4 % more."
    ),
    "verify_campanha_sum_of_speeds": marked(
        "The printed formula gives the sum of the two surface speeds; the film depends on their "
        "mean, half of it."
    ),
    "verify_campanha_convex_radius": marked(
        "As in the author's text, with the concave groove taken as convex. The film depends on "
        "the radius in the rolling direction, 3.963 mm."
    ),
    "verify_campanha_convex_ellipse": marked(
        "As in the author's text: a convex groove, x and y exchanged, an approximate formula. "
        "The true ratio of the ellipse's axes is 21.6."
    ),
    "verify_campanha_film": marked(
        "The sum of the speeds, the convex groove and the exchanged x and y give the printed "
        "film; the errors nearly cancel. The correct film is 25 % thicker."
    ),
    "verify_campanha_parameter": marked(
        "The film parameter follows the film: the author's choices give the printed value. The "
        "correct value is 25 % higher."
    ),
    "verify_campanha_no_names": marked(
        "The table does not name its bearings: for each range of bores a common bearing that "
        "fits is taken, with a ball on the load line; C2 at both ends of its range, the other "
        "classes in the middle of theirs. Other bearings in the same range differ by up to 2 "
        "µm."
    ),
    "verify_campanha_rounded_groove": marked(
        "The author rounds the inner groove radius to 5.21 mm; the outer conformity is 0.53. "
        "The standard does not raise the rating for closer conformity: this factor is theory."
    ),
    "verify_campanha_four": marked(
        "Not stated in the text: exact median ranks, ln ln 1/(1 - F) regressed on ln t, for the "
        "four failures of procedure II alone."
    ),
    "verify_campanha_five": marked(
        "Printed as the life without test 5, although test 5 is included: the same regression "
        "with procedure II and test 5 as failures and tests 2 to 4 as suspensions, once each."
    ),
    "verify_campanha_as_if": marked(
        "The same regression, as if each of the five tests of condition II had ended with a "
        "failure. There were no failures in them."
    ),
    "verify_campanha_all_bearings": marked(
        "Maximum likelihood for all bearings named in the text, those that did not fail with "
        "the time they ran. The proof: the text's likelihood equations, corrected and written "
        "for tests in which not all bearings fail. The printed life is up to 40 % too high."
    ),
    "verify_campanha_lower_bound": marked(
        "There were no failures: the ten bearings show only that L_10 is not below 78 h, with "
        "95 % confidence and shape 1.5. The proof: (Σt^1.5 ln 0.9/ln 0.05)^(1/1.5)."
    ),
    "verify_harris_abscissa": marked(
        "The tolerance includes what the rounding of the printed F(ρ) leaves uncertain."
    ),
    "verify_harris_misprint": marked(
        "A misprint of three units in the last digit: the printed a* and b* of the same row "
        "give 0.9432, as does the exact solution."
    ),
    "verify_harris_cut": marked("The digits beyond the printed ones are truncated, not rounded."),
    "verify_harris_low_deflection": marked(
        "By hand: δ* is 0.2 to 0.3 % too low, the stiffness 0.4 to 0.8 % too high. Radaelli's "
        "table also gives the value by computer."
    ),
    "verify_harris_integral_by_table": marked(
        "By hand: the continuous load integral, with J_r truncated to 0.218. The equilibrium "
        "uses the balls at their actual positions."
    ),
    "verify_harris_displacement": marked(
        "The continuous load integral, with the digits beyond the printed ones truncated. The "
        "equilibrium uses the balls at their actual positions."
    ),
    "verify_harris_by_hand": marked(
        "By hand, stopped after three iterations (Radaelli's appendix C, whose table also gives "
        "the value by computer)."
    ),
    "verify_harris_from_angle": marked(
        "Follows from the contact angle of the hand calculation: Q = F_a/(Z sin α)."
    ),
    "verify_makers_conformity": marked(
        "The conformity and the elastic constants are not published: 0.52 and 208 GPa, the same "
        "for all, give these bearings within 1 %, which is the tolerance where it exceeds half "
        "a digit."
    ),
    "verify_makers_round": marked(
        "One value for all bearings, in steps of 0.05: the tolerance is half a step, or half a "
        "digit where that is more. It follows from a constant contact angle, as with vanishing "
        "preload. Computed for S 6012 E at light preload, whose contact angle increases under "
        "the load."
    ),
    "verify_makers_constant": marked(
        "2^(3/2), from a constant contact angle, as with vanishing preload. Computed for S 6012 "
        "E at light preload, whose contact angle increases under the load."
    ),
    "verify_makers_pair": marked(
        "SKF rounds 2^0.7 to 1.62 for the rating of a pair. Tolerance: half of the last digit "
        "that is not zero."
    ),
    "verify_radaelli_integral": marked(
        "The table uses the continuous load integral J_r. The equilibrium uses the balls at "
        "their actual positions."
    ),
    "verify_radaelli_frozen": marked(
        "The table keeps the contact stiffness of the free contact angle. That of the loaded "
        "angle gives the same printed value."
    ),
    "verify_radaelli_cut": marked(
        "The digits beyond the printed ones are truncated, not rounded: 41.4949°."
    ),
    "verify_radaelli_held": marked(
        "The ring is held axially, x = 0, which the table does not state; the axial load is "
        "then a reaction of 31.1 kN."
    ),
    "verify_radaelli_tie": marked(
        "A tie: 48.76497° is 48.77° when rounded twice, first to three decimals. The ring is "
        "held axially, as for the other rows."
    ),
    "verify_radaelli_reaction": marked(
        "The tilt is imposed; the moment is the reaction, with the circle of the inner groove's "
        "centres as arm. The gyroscopic moment is signed."
    ),
    "verify_radaelli_as_radial": marked(
        "The static analysis assumes a contact angle of 0 and no clearance. With its actual "
        "40°, held axially, the displacement is nearly 50 % greater, almost as great as at "
        "speed: what the text attributes to centrifugal force comes almost entirely from the "
        "contact angle."
    ),
    "verify_radaelli_without_clearance": marked("The 209 bearing without clearance."),
    "verify_radaelli_proportion": marked(
        "The 209 bearing; both grow with the square of the speed, exactly, at any contact angle."
    ),
    "verify_radaelli_loads_given": marked(
        "F_a from 20 to 80 kN, radial load given, tilt zero. The text says approximately."
    ),
    "verify_rigs_rounded": marked(
        "The tolerance includes what the rounding of the printed diameters leaves uncertain; "
        "the contact angle is zero."
    ),
    "verify_iso_of_the_factors": marked(
        "(1 - X)/Y with the printed factors, whose own rounding leaves the last digit uncertain."
    ),
    "verify_iso_of_two_rows": marked(
        "(1 - X_2)/(Y_2 - Y_1) with the printed factors; the tolerance includes what their own "
        "rounding leaves uncertain."
    ),
    "verify_iso_exact_hertz": marked(
        "The load that gives 4200 MPa, by exact Hertz theory with 207 GPa and 0.3, grooves of "
        "0.52 and 0.53."
    ),
    "verify_iso_not_rounded": marked(
        "By exact Hertz 15.653 with 207 GPa and 0.3: the table's one number that is not the "
        "rounded one. Tolerance: 0.003 more than half a digit."
    ),
    "verify_rollers_exponent": marked(
        "The source takes Q ~ δ^1.11, ISO/TS 16281 10/9: up to 3e-4 of the number, which the "
        "tolerance has beside half a digit. The worse of a roller and a gap under the load."
    ),
    "verify_iso_approximate": marked(
        "The tolerance is 1e-5 of the number where that is more than half a digit: the "
        "reference program approximates the elliptic integrals."
    ),
    "verify_iso_frozen": marked(
        "The standard keeps the contact stiffness of the free contact angle, 0°, while the "
        "angle rises to 13.1°, which makes less than 1e-4 of the number. Tolerance as for "
        "radial load."
    ),
    "verify_iso_approximate_loads": marked(
        "The program balances its ball loads to some 1e-5, of which the life takes the cube: "
        "tolerance 1e-4."
    ),
    "verify_iso_frozen_angle": marked(
        "With the contact stiffness of the free contact angle, as the standard keeps it, the "
        "balls stand 0.0006° steeper and carry less. Tolerance 3e-5: the cube of 1e-5 in the "
        "loads."
    ),
}
