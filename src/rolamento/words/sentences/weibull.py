"""What is said of life tests and their plans."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rolamento.words.speaking import marked

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

SENTENCES: Final[dict[str, Sentence]] = {
    # --- what limits a result ---------------------------------------------------------------
    "location_at_zero": marked(
        "The likelihood is greatest without a failure-free time: these are the results of the"
        " two-parameter fit."
    ),
    "likelihood_unbounded": marked(
        "As the location approaches the first failure, the likelihood grows without bound, which"
        " has no meaning; the local maximum before that is taken."
    ),
    "few_failures": marked(
        "Fewer than five failures: shape and life are poorly known; see the bounds."
    ),
    "suspensions_early": marked(
        "Most suspensions come before the first failure. Rank regression uses only their order;"
        " maximum likelihood uses their times."
    ),
    "censoring_modelled": marked(
        "The suspension times that failed bearings would have had are drawn from those observed"
        " (Kaplan-Meier); the bounds are approximate."
    ),
    "inspections_shared": marked(
        "All bearings are assumed to have been inspected at all the times in the data; the bounds"
        " are approximate."
    ),
    "many_without_fit": marked(
        "More than 10 % of the simulated tests have no fit and are left out: the bounds are too"
        " narrow, and hold only for tests that have a fit."
    ),
    "large_sample_method": marked(
        "This method is for large samples: with few failures its bounds are far too narrow."
    ),
    "bounds_approximate": marked(
        "No exact method is known for this case; the bounds are approximate."
    ),
    "group_without_failures": marked(
        "A group has no failures: it has no shape, and is left out where only shapes are compared."
    ),
    "dates_day_first": marked(
        "{date} is read as {day}, the day first: the dates may be read in two ways, and the"
        " language, the heading or the decimal commas of the table are of those who write so."
    ),
    "passed_over_columns": marked("Columns of the table that were not read: {columns}."),
    "machines_not_rigs": marked(
        "Column {column} is not read: its machines are no test rigs, as their bearings ended at"
        " several times."
    ),
    "inspected_without_ranks": marked(
        "Failures were found at inspections: no rank regression, no plotted points."
    ),
    "inspected_groups_not_compared": marked(
        "Failures were found at inspections: the groups are not compared."
    ),
    "too_many_for_ranks": marked(
        "Too many failures to be ranked: no rank regression, no plotted points."
    ),
    # --- failure modes, dates -----------------------------------------------------------------
    "modes_independent": marked(
        "Each mode is fitted with the failures by other modes as suspensions. This holds for modes"
        " that are independent of each other, which the data cannot show."
    ),
    "modes_unknown": marked(
        "The mode is not known of {count} of {failures} failures. They are taken as a mode of their"
        " own: the lives by the known modes are too long."
    ),
    "one_mode": marked(
        "Only failures by the mode {mode} count; the {others} failures by other modes are taken as"
        " suspensions."
    ),
    "modes_at_inspections": marked(
        "A failure by another mode that was found at an inspection counts as suspended at the"
        " inspection before: the lives by single modes are somewhat too short."
    ),
    "modes_pooled": marked(
        "Failures by {count} different modes are taken together as if they were of one kind."
    ),
    "modes_of_suspended": marked(
        "Suspended bearings with a failure mode, which is not used: {count}."
    ),
    "lives_from_dates": marked(
        "Lives are the calendar days between {first} and {last}, not running time."
    ),
    "lives_from_dates_and_use": marked(
        "Lives are the days between {first} and {last}, at a use of {use:.6} {unit} a day."
    ),
    "lives_from_dates_and_column": marked(
        "Lives are the days between {first} and {last}, at the use per day of column {column}."
    ),
    "running_on_day_of_data": marked(
        "Bearings without a second date, taken as running until {day}: {count}."
    ),
    # --- goodness of fit ----------------------------------------------------------------------
    "dog_leg_steeper": marked(
        "The Weibull plot has a dog-leg at about {time:.3r} {unit}: slope {before:.3} before it,"
        " {after:.3} after (p = {p:.2}). A single Weibull distribution does not describe these"
        " failures; early failures and wear-out are probably mixed. Separate failure modes or"
        " populations."
    ),
    "dog_leg_flatter": marked(
        "The Weibull plot has a dog-leg at about {time:.3r} {unit}: slope {before:.3} before it,"
        " {after:.3} after (p = {p:.2}). A single Weibull distribution does not describe these"
        " failures; perhaps only part of the bearings have the defect, there are two populations,"
        " or nothing fails before a certain time."
    ),
    "weibull_contradicted": marked(
        "The data contradict a Weibull distribution (Anderson-Darling test by simulation,"
        " p = {p:.2})."
    ),
    "weibull_contradicted_by_intervals": marked(
        "The data contradict a Weibull distribution (likelihood-ratio test of the intervals by"
        " simulation, p = {p:.2})."
    ),
    # --- why there is no result, and what to do ---------------------------------------------
    "weibull_no_failures": marked(
        "There are no failures: the test bounds the life from below only. With a shape assumed from"
        " experience (such as `shape=1.5`), it gives a lower bound on the life."
    ),
    "weibull_one_failure": marked(
        "One failure does not determine the shape. Assume a shape from experience (such as"
        " `shape=1.5`) or a range (`prior=1..2.5`), or continue the test."
    ),
    "weibull_no_spread": marked(
        "All failures may have occurred at the same time and no bearing ran longer: the fit"
        " improves without limit as the line gets steeper. Inspect more often, continue the test,"
        " or assume a shape from experience (such as `shape=1.5`)."
    ),
    "weibull_no_maximum": marked(
        "The likelihood has no maximum. With three parameters, it grows without bound as the"
        " location approaches the first failure, or there are too few failures: fit two parameters."
        " With two, the inspections show a falling failure rate: look for a mixture of early"
        " failures and others."
    ),
    "weibull_not_converged": marked("The search did not converge; check the data for errors."),
    "weibull_not_modelled": marked(
        "Exact failure times beside inspected ones: such a test cannot be simulated. Use"
        " `bounds=likelihood-ratio` or `bounds=bootstrap-bca`."
    ),
    "weibull_too_large": marked(
        "The test has too many bearings to be simulated repeatedly. Use `bounds=likelihood-ratio`,"
        " which is valid for large samples."
    ),
    "weibull_no_mean": marked(
        "The mean of the shape does not exist for two failures, nor where the end of the test could"
        " have left so few: use the median."
    ),
    "weibull_few_to_test": marked(
        "Fewer than three failures do not show whether a Weibull distribution describes them."
    ),
    "weibull_mode_without_fit": marked(
        "A mode has too few failures for a distribution, and without it the bearing as a whole"
        " would come out too good. Join it with a related mode, or assume a shape from experience"
        " (such as `shape=1.5`)."
    ),
    "weibull_group_without_fit": marked(
        "A group has no fit of its own: it has no failures, or its failures have no spread."
    ),
    # --- decisions ------------------------------------------------------------------------
    "decision_without_draws": marked(
        "The data cannot be simulated repeatedly: the results have no intervals."
    ),
    "decision_groups_pooled": marked(
        "The data have {count} groups, taken together here. Choose some with `only` if they differ."
    ),
    "decision_one_mode": marked(
        "The cost of failures by other modes comes on top, and a planned replacement may bring more"
        " of them, such as mounting damage."
    ),
    "decision_beyond_data": marked(
        "This lies beyond the longest time in the data, {longest:.5} {unit}: it relies on the"
        " Weibull distribution continuing there."
    ),
    "decision_early_failures": marked(
        "The shape is below 1: early failures prevail, and a bearing that has survived is better"
        " than a new one."
    ),
    "fleet_without_uncertainty": marked(
        "The distribution is taken as known: the prediction interval holds chance alone, and is too"
        " narrow if shape and scale are estimates."
    ),
    "fleet_few_draws": marked(
        "The fleet is large: the prediction interval comes from {draws} simulations only."
    ),
    "fleet_failed_left_out": marked(
        "Bearings of the fleet table that have failed, and were left out: {count}."
    ),
    # --- plans -----------------------------------------------------------------------------
    "plan_not_shown": marked(
        "This number of bearings and this test time do not demonstrate the life with the required"
        " confidence. Test more bearings, test longer, or allow fewer failures."
    ),
    "plan_too_many_bearings": marked(
        "An impractical number of bearings would be needed. Test longer, or require less confidence"
        " or a life of lower reliability."
    ),
    "plan_too_long": marked(
        "The test would take too long to be planned. Test more bearings, or require less"
        " confidence."
    ),
    "plan_too_few_failures": marked(
        "One failure does not determine the shape and gives no bounds: plan for two."
    ),
    "plan_too_many_failures": marked(
        "More failures would be needed than can be planned for. Accept a greater ratio of the"
        " bounds, or less confidence."
    ),
    "plan_not_reached": marked(
        "This number of bearings does not bring the bounds that close, even if all fail. Test more,"
        " or accept a greater ratio."
    ),
}
