/* Tests of the verdicts, and of tolerances that are too wide. */
#include "made_results.h"

#include "run.h"

static const struct {
  po_verdict verdict;
  const char *name;
  bool passes;
} VERDICTS[] = {
    {PO_WITHIN, "within", true},        {PO_OUTSIDE, "outside", false},
    {PO_NO_RESULT, "no_result", false}, {PO_MISSING_REFERENCE, "missing_reference", false},
    {PO_SLACK, "slack", true},          {PO_NOT_REACHABLE, "not_reachable", true},
};

LOOP_TEST(which_pass, 0, PO_VERDICT_COUNT) {
  ck_assert_str_eq(PO_VERDICTS[VERDICTS[_i].verdict], VERDICTS[_i].name);
  ck_assert_int_eq(po_verdict_passes(VERDICTS[_i].verdict), VERDICTS[_i].passes);
}

/* Errors of one check (tolerance 1e-3) at two points, and the point that is slack (-1: none). */
static const struct {
  const char *name;
  double errors[2], uncertainty;
  int which, slack;
} TOLERANCES[] = {
    {"pull_off_force", {9e-7, 1e-7}, 1e-10, ORACLE, 0},
    {"pull_off_force", {1e-8, -9e-7}, 1e-10, ORACLE, 1},
    {"pull_off_force", {1.1e-6, 1e-7}, 1e-10, ORACLE, -1}, /* the worst point needs it */
    {"pull_off_force", {1e-9, 5e-4}, 1e-10, ORACLE, -1},
    {"pull_off_force", {1e-8, 1e-9}, 2e-6, ORACLE, -1}, /* the reference is no better */
    {"pull_off_force", {0, 0}, 1e-10, ORACLE, 0},
    {"fold_count", {0, 0}, 0, ORACLE, -1},
    {"extremum_count", {0, 0}, 0, ORACLE, -1},
    {"pull_off_force", {9e-7, 1e-7}, 1e-10, PUBLISHED, 0},
    {"pull_off_force", {9e-7, 2e-3}, 1e-10, ORACLE, -1},
};

TABLE_TEST(a_tolerance_is_measured_by_the_worst_error_it_met, TOLERANCES) {
  for (size_t point = 0; point < 2; ++point)
    found(TOLERANCES[_i].which, point, TOLERANCES[_i].name, "", 1.5 + TOLERANCES[_i].errors[point],
          1.5, TOLERANCES[_i].uncertainty);
  po_judge_tolerances(&made_run.check_results);
  for (int point = 0; point < 2; ++point)
    ck_assert_int_eq(verdict_of((size_t)point) == PO_SLACK, point == TOLERANCES[_i].slack);
}

/* The reference is 1.5 with tolerance 1e-3. */
static const struct {
  double obtained;
  po_verdict verdict;
} BESIDE[] = {{1.5009, PO_WITHIN}, {1.4991, PO_WITHIN}, {1.502, PO_OUTSIDE}, {1.498, PO_OUTSIDE}};

TABLE_TEST(an_error_of_either_sign_is_judged, BESIDE) {
  const size_t place = found(ORACLE, 0, "pull_off_force", "", BESIDE[_i].obtained, 1.5, 1e-10);
  po_judge_tolerances(&made_run.check_results);
  ck_assert_str_eq(PO_VERDICTS[verdict_of(place)], PO_VERDICTS[BESIDE[_i].verdict]);
}

/* With tolerance 1e-12 and value 2, rounding alone is more than a thousandth of the tolerance. */
TEST(rounding_is_an_error_too) {
  made_checks[ORACLE].tolerance = 1e-12;
  const size_t exact = found(ORACLE, 0, "pull_off_force", "", 2, 2, 0);
  po_judge_tolerances(&made_run.check_results);
  ck_assert_int_eq(verdict_of(exact), PO_WITHIN);
}

/* An error of exactly 0, e.g. because there is no fold to compare, does not make a tolerance slack.
 */
TEST(no_error_at_all_tells_nothing) {
  const size_t none = found(ORACLE, 0, "reverse_trace", "", 0, 0, 0);
  po_judge_tolerances(&made_run.check_results);
  ck_assert_int_eq(verdict_of(none), PO_WITHIN);
}

/* A share of solved points is a count: if all are solved, the tolerance is not slack. */
TEST(a_share_is_never_slack) {
  const size_t share = found(ORACLE, 0, "solved_share", "", 1, 1, (double)NAN);
  made_run.check_results.items[share].whole = true;
  po_judge_tolerances(&made_run.check_results);
  ck_assert_int_eq(verdict_of(share), PO_WITHIN);
}

FIXTURE(make_run, clear_run)
