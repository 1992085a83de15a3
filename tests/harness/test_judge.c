/* Tests of the verdicts that combine several references. */
#include "made_results.h"

#include "run.h"

static const struct {
  po_verdict verdict;
  const char *name;
  bool passes;
} VERDICTS[] = {
    {PO_IDENTICAL, "identical", true},
    {PO_WITHIN, "within", true},
    {PO_OUTSIDE, "outside", false},
    {PO_NO_RESULT, "no_result", false},
    {PO_MISSING_REFERENCE, "missing_reference", false},
    {PO_IMPROVED, "improved", true},
    {PO_REGRESSED, "regressed", false},
    {PO_MOVED, "moved", false},
    {PO_WRONG_AND_FROZEN, "wrong_and_frozen", false},
    {PO_SLACK, "slack", true},
    {PO_NOT_REACHABLE, "not_reachable", true},
};

LOOP_TEST(which_pass, 0, PO_VERDICT_COUNT) {
  ck_assert_str_eq(PO_VERDICTS[VERDICTS[_i].verdict], VERDICTS[_i].name);
  ck_assert_int_eq(po_verdict_passes(VERDICTS[_i].verdict), VERDICTS[_i].passes);
}

/* The oracle is 1.5 with tolerance 1e-3; the tolerance of the pin is 1e-9. NAN: there is no such
 * value; an uncertainty of NAN: there is no oracle. */
static const struct {
  double pinned, obtained, uncertainty;
  po_verdict pin, oracle;
} TOGETHER[] = {
    {1.5002, 1.5002, 1e-10, PO_IDENTICAL, PO_WITHIN},
    {1.5002, 1.5002 + 9e-10, 1e-10, PO_WITHIN, PO_WITHIN},
    {1.502, 1.502, 1e-10, PO_IDENTICAL, PO_WRONG_AND_FROZEN},
    {1.5002, 1.5001, 1e-10, PO_IMPROVED, PO_WITHIN},
    {1.5002, 1.4999, 1e-10, PO_IMPROVED, PO_WITHIN},
    {1.502, 1.5001, 1e-10, PO_IMPROVED, PO_WITHIN},
    {1.5002, 1.5003, 1e-10, PO_REGRESSED, PO_WITHIN},
    {1.5002, 1.4997, 1e-10, PO_REGRESSED, PO_WITHIN},
    {1.5002, 1.502, 1e-10, PO_REGRESSED, PO_OUTSIDE},
    {1.503, 1.502, 1e-10, PO_MOVED, PO_OUTSIDE},        /* better, and still outside */
    {1.5002, 1.4998, 1e-10, PO_MOVED, PO_WITHIN},       /* as far off, on the other side */
    {1.5002, 1.5001, 5e-4, PO_MOVED, PO_WITHIN},        /* the oracle cannot distinguish them */
    {1.5002, 1.5001, (double)NAN, PO_MOVED, PO_WITHIN}, /* there is no oracle */
    {1.5002, (double)NAN, 1e-10, PO_NO_RESULT, PO_NO_RESULT},
    {(double)NAN, 1.5001, 1e-10, PO_MISSING_REFERENCE, PO_WITHIN},
    {(double)NAN, 1.502, 1e-10, PO_MISSING_REFERENCE, PO_OUTSIDE},
};

TABLE_TEST(pin_and_oracle, TOGETHER) {
  const bool alone = isnan(TOGETHER[_i].uncertainty);
  const double obtained = TOGETHER[_i].obtained;
  const size_t oracle =
      alone ? 0 : found(ORACLE, 0, "pull_off_force", "", obtained, 1.5, TOGETHER[_i].uncertainty);
  const size_t pin = found(PIN, 0, "pull_off_force", "", obtained, TOGETHER[_i].pinned, 0);
  po_judge(&made_run.check_results);
  ck_assert_str_eq(PO_VERDICTS[verdict_of(pin)], PO_VERDICTS[TOGETHER[_i].pin]);
  if (!alone)
    ck_assert_str_eq(PO_VERDICTS[verdict_of(oracle)], PO_VERDICTS[TOGETHER[_i].oracle]);
}

TEST(the_note_of_a_moved_pin_says_by_how_much) {
  found(ORACLE, 0, "pull_off_force", "", 1.50025, 1.5, 1e-10);
  const size_t pin = found(PIN, 0, "pull_off_force", "", 1.50025, 1.5005, 0);
  po_judge(&made_run.check_results);
  ck_assert_str_eq(made_run.check_results.items[pin].note,
                   "the error against sage decreased from 0.0005 to 0.00025: bless it");
}

TEST(an_error_that_rose_against_one_oracle_rose) {
  found(ORACLE, 0, "pull_off_force", "", 1.5001, 1.5, 1e-10);
  found(OTHER_ORACLE, 0, "pull_off_force", "", 1.5001, 1.5003, 1e-10);
  const size_t pin = found(PIN, 0, "pull_off_force", "", 1.5001, 1.5002, 0);
  po_judge(&made_run.check_results);
  ck_assert_int_eq(verdict_of(pin), PO_REGRESSED);
  ck_assert_ptr_nonnull(strstr(made_run.check_results.items[pin].note, "seer increased"));
}

TEST(other_points_special_points_and_papers_have_no_say) {
  found(ORACLE, 1, "fold_load", "jump_in-1/load", 1.5001, 1.5, 1e-10);
  found(ORACLE, 0, "fold_load", "jump_out-2/load", 1.5001, 1.5, 1e-10);
  found(ORACLE, 0, "fold_approach", "jump_in-1/approach", 1.5001, 1.5, 1e-10);
  found(PUBLISHED, 0, "fold_load", "jump_in-1/load", 1.5001, 1.5, 1e-3);
  const size_t pin = found(PIN, 0, "fold_load", "jump_in-1/load", 1.5001, 1.5002, 0);
  po_judge(&made_run.check_results);
  ck_assert_int_eq(verdict_of(pin), PO_MOVED);
  found(ORACLE, 0, "fold_load", "jump_in-1/load", 1.5001, 1.5, 1e-10);
  const size_t again = found(PIN, 0, "fold_load", "jump_in-1/load", 1.5001, 1.5002, 0);
  po_judge(&made_run.check_results);
  ck_assert_int_eq(verdict_of(again), PO_IMPROVED);
}

/* A published value that fails while the pin passes is not wrong_and_frozen: the publication may be
 * wrong. */
TEST(published_values_judge_by_themselves) {
  const size_t paper = found(PUBLISHED, 0, "pull_off_force", "", 1.55, 1.5, 1e-3);
  found(PIN, 0, "pull_off_force", "", 1.55, 1.55, 0);
  po_judge(&made_run.check_results);
  ck_assert_int_eq(verdict_of(paper), PO_OUTSIDE);
}

static const struct {
  double pinned, done;
  po_verdict verdict;
} COUNTS[] = {
    {1000, 1000, PO_IDENTICAL}, {1000, 1030, PO_WITHIN},  {1000, 970, PO_WITHIN},
    {1000, 1031, PO_REGRESSED}, {1000, 969, PO_IMPROVED}, {0, 0, PO_IDENTICAL},
    {0, 1, PO_REGRESSED},       {1000, 0, PO_IMPROVED},
};

TABLE_TEST(more_work_is_worse_and_less_is_better, COUNTS) {
  const size_t place =
      found(WORK, 0, "work_points", "points", COUNTS[_i].done, COUNTS[_i].pinned, 0);
  po_judge(&made_run.check_results);
  ck_assert_str_eq(PO_VERDICTS[verdict_of(place)], PO_VERDICTS[COUNTS[_i].verdict]);
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
    {"pull_off_force", {0, 0}, 0, PIN, -1}, /* a program that did not change meets it to the bit */
    {"pull_off_force", {9e-7, 2e-3}, 1e-10, ORACLE, -1},
};

TABLE_TEST(a_tolerance_is_measured_by_the_worst_error_it_met, TOLERANCES) {
  for (size_t point = 0; point < 2; ++point)
    found(TOLERANCES[_i].which, point, TOLERANCES[_i].name, "", 1.5 + TOLERANCES[_i].errors[point],
          1.5, TOLERANCES[_i].uncertainty);
  po_judge(&made_run.check_results);
  for (int point = 0; point < 2; ++point)
    ck_assert_int_eq(verdict_of((size_t)point) == PO_SLACK, point == TOLERANCES[_i].slack);
}

/* With tolerance 1e-12 and value 2, rounding alone is more than a thousandth of the tolerance. */
TEST(rounding_is_an_error_too) {
  made_checks[ORACLE].tolerance = 1e-12;
  const size_t exact = found(ORACLE, 0, "pull_off_force", "", 2, 2, 0);
  po_judge(&made_run.check_results);
  ck_assert_int_eq(verdict_of(exact), PO_WITHIN);
}

/* An error of exactly 0, e.g. because there is no fold to compare, does not make a tolerance slack.
 */
TEST(no_error_at_all_tells_nothing) {
  const size_t none = found(ORACLE, 0, "reverse_trace", "", 0, 0, 0);
  po_judge(&made_run.check_results);
  ck_assert_int_eq(verdict_of(none), PO_WITHIN);
}

/* A share of solved points is a count: if all are solved, the tolerance is not slack. */
TEST(a_share_is_never_slack) {
  const size_t share = found(ORACLE, 0, "solved_share", "", 1, 1, (double)NAN);
  made_run.check_results.items[share].whole = true;
  po_judge(&made_run.check_results);
  ck_assert_int_eq(verdict_of(share), PO_WITHIN);
}

FIXTURE(make_run, clear_run)
