/* Comparison of numbers and curves with a reference: made-up results with known verdicts. */
#include <check.h>
#include <math.h>
#include <string.h>

#include "made_case.h"
#include "po_run.h"
#include "po_wavy_rigid.h"
#include "run.h"

static const struct {
  const char *tolerance, *kind;
  double force;
  po_verdict verdict;
} FORCES[] = {
    {"1e-3", "abs", 2.0009, PO_WITHIN},    {"1e-3", "abs", 2.0011, PO_OUTSIDE},
    {"1e-3", "rel", 2.0019, PO_WITHIN},    {"1e-3", "rel", 1.9979, PO_OUTSIDE},
    {"4", "ulp", 2.0, PO_WITHIN},          {"4", "ulp", 2.0 + 8e-16, PO_WITHIN},
    {"4", "ulp", 2.0 + 4e-15, PO_OUTSIDE},
};

TABLE_TEST(force_within_and_outside, FORCES) {
  load("pull_off_force", "bradley", FORCES[_i].tolerance, FORCES[_i].kind);
  const po_result result = {.has_pull_off = true, .pull_off = {.force = FORCES[_i].force}};
  compare(0, &result);
  ck_assert_uint_eq(check_results.count, 1);
  ck_assert_int_eq(check_results.items[0].verdict, FORCES[_i].verdict);
  ck_assert_double_eq(check_results.items[0].expected, 2);
  ck_assert_str_eq(check_results.items[0].id, "pull_off_force/bradley/tabor=1");
}

/* The contact radius by the closed form of the rigid sphere, from its own column, and from a column
 * in units of sqrt(R eps). */
static const struct {
  const char *reference, *rows;
  double expected, uncertainty;
} RADII[] = {
    {"bradley", NULL, 6.33935257224273, 0}, /* sqrt(2 * 100 * (3^(1/6) - 1)), by bc */
    {"table.csv", "tabor,contact_radius,contact_radius_uncertainty\n1,13.5,1e-6\n", 13.5, 1e-6},
    {"table.csv",
     "tabor,contact_radius_over_root_radius,contact_radius_over_root_radius_uncertainty\n"
     "1,1.35,1e-7\n",
     13.5, 1e-6},
};

TABLE_TEST(contact_radius_of_the_pull_off, RADII) {
  if (RADII[_i].rows)
    write_table("", RADII[_i].rows);
  load("contact_radius", RADII[_i].reference, "1e-3", "abs");
  const po_result result = {.has_pull_off = true,
                            .pull_off = {.contact_radius = RADII[_i].expected + 2e-3}};
  compare(0, &result);
  ck_assert_uint_eq(check_results.count, 1);
  ck_assert_double_eq_tol(check_results.items[0].expected, RADII[_i].expected, 1e-12);
  ck_assert_double_eq_tol(check_results.items[0].uncertainty, RADII[_i].uncertainty, 1e-15);
  ck_assert_double_eq_tol(check_results.items[0].error, 2e-3, 1e-12);
  ck_assert_int_eq(check_results.items[0].verdict, PO_OUTSIDE);
}

/* A row by its name, whatever the scene; its note has the correct digits. */
static const struct {
  double force;
  po_verdict verdict;
  const char *note;
} ROW_FORCES[] = {{2.0, PO_WITHIN, "9.0 of 9 digits"},
                  {2.0 + 2e-7, PO_WITHIN, "7.0 of 9 digits"},
                  {1.0, PO_OUTSIDE, "0.3 of 9 digits"},
                  {5.0, PO_OUTSIDE, "0.0 of 9 digits"}};

TABLE_TEST(row_by_its_name, ROW_FORCES) {
  write_table("", "problem,quantity,value,digits,half_width\n"
                  "hard-0.1,force,3,9,1e-9\neasy,force,2,9,1e-9\neasy,radius,4,9,1e-9\n");
  load("pull_off_force", "\"table.csv#easy:force\"", "1e-3", "abs");
  const po_result result = {.has_pull_off = true, .pull_off = {.force = ROW_FORCES[_i].force}};
  compare(0, &result);
  ck_assert_uint_eq(check_results.count, 1);
  ck_assert_double_eq(check_results.items[0].expected, 2);
  ck_assert_double_eq(check_results.items[0].uncertainty, 1e-9);
  ck_assert_int_eq(check_results.items[0].verdict, ROW_FORCES[_i].verdict);
  ck_assert_str_eq(check_results.items[0].note, ROW_FORCES[_i].note);
  ck_assert_str_eq(check_results.items[0].id, "pull_off_force/easy:force/tabor=1");
}

TEST(failed_solve_has_no_result) {
  load("pull_off_force", "bradley", "1", "abs");
  const po_result result = {.status = PO_STEP_TOO_SMALL,
                            .reason = "stuck",
                            .has_pull_off = true,
                            .pull_off = {.force = 2}};
  compare(0, &result);
  ck_assert_int_eq(check_results.items[0].verdict, PO_NO_RESULT);
  ck_assert_str_eq(check_results.items[0].note, "stuck");
}

/* The first number that is compared is -1.6, with an uncertainty of 1e-9. */
static const struct {
  const char *tolerance, *kind, *words;
} TIGHT[] = {
    {"1e-10", "abs", "1e-10"},
    {"1e-10", "rel", "1e-10 rel, which allows 1.6e-10"},
    {"100", "ulp", "100 ulp, which allows 2.22044604925031e-14"},
};

TABLE_TEST(tolerance_tighter_than_the_reference, TIGHT) {
  load("folds", "table.csv", TIGHT[_i].tolerance, TIGHT[_i].kind);
  char message[200];
  snprintf(message, sizeof message,
           "made.yaml:8: checks[1].tolerance is %s: expected at least 1e-09, the uncertainty of "
           "table.csv",
           TIGHT[_i].words);
  ck_assert_int_eq(po_compare_check_tolerance(kase, &kase->file->checks[0], 1, &reference),
                   PO_BAD_INPUT);
  ck_assert_str_eq(po_message(), message);
  const size_t count = kase->point_count;
  kase->point_count = 0; /* the memory after the last point belongs to no case */
  ck_assert_int_eq(po_compare_check_tolerance(kase, &kase->file->checks[0], 1, &reference), PO_OK);
  kase->point_count = count;
}

/* The note states why the reverse trace has no result: it was not made, it failed, or it found
 * other folds. */
TEST(reverse_trace_without_a_number) {
  load("reverse_trace", "zero", "1e-3", "abs");
  po_result result = {.has_pull_off = true, .fold_count = 2, .extremum_count = 3};
  po_reverse_trace *w = &result.diagnostics.reverse_trace;
  *w = (po_reverse_trace){.excess = (double)NAN};
  compare(0, &result);
  ck_assert_str_eq(check_results.items[0].note,
                   "only elastic scenes on panels have a reverse trace");
  w->made = true;
  w->status = PO_STEP_TOO_SMALL;
  snprintf(w->reason, sizeof w->reason, "%s", "the step is too small at 100 %");
  compare(0, &result);
  ck_assert_str_eq(check_results.items[1].note,
                   "on the reverse trace: the step is too small at 100 %");
  w->status = PO_OK;
  w->folds = 4;
  w->extrema = 5;
  compare(0, &result);
  ck_assert_str_eq(check_results.items[2].note,
                   "2 folds on the trace, 4 on the reverse trace; extrema 3 and 5");
  for (size_t i = 0; i < 3; ++i)
    ck_assert_int_eq(check_results.items[i].verdict, PO_NO_RESULT);
}

/* The note of a number that the solve does not have states why; only curves have a range. */
static const struct {
  const char *quantity;
  double force_error;
  const char *note;
} WITHOUT[] = {
    {"moved_force", (double)NAN,
     "only scenes on panels have the error estimates to which moved_force is relative"},
    {"moved_force", 1e-9, "the solve has no value of this quantity"},
    {"residual", 1e-9, "the solve has no value of this quantity"},
};

TABLE_TEST(diagnostics_without_a_number, WITHOUT) {
  load(WITHOUT[_i].quantity, "zero", "1e-3", "abs");
  po_result result = {.has_pull_off = true, .pull_off.force_error = WITHOUT[_i].force_error};
  result.diagnostics.moved.excess = result.diagnostics.residual = (double)NAN;
  compare(0, &result);
  ck_assert_int_eq(check_results.items[0].verdict, PO_NO_RESULT);
  ck_assert_str_eq(check_results.items[0].note, WITHOUT[_i].note);
}

/* The load of the closed form has a rounding error: 3.5e-15 at approach 0.2, 2e-17 at large
 * separation. */
LOOP_TEST(tolerance_tighter_than_rounding, 0, 3) {
  static const struct {
    const char *tolerance;
    po_status status;
  } KNOWN[] = {{"1e-14", PO_OK}, {"1e-15", PO_BAD_INPUT}, {"1e-18", PO_BAD_INPUT}};
  load("curve", "bradley", KNOWN[_i].tolerance, "abs");
  ck_assert_int_eq(po_compare_check_tolerance(kase, &kase->file->checks[0], 1, &reference),
                   KNOWN[_i].status);
}

TEST(curve_of_the_closed_form) {
  load("curve", "bradley", "1e-5", "abs");
  enum { N = 500 };
  po_curve_point curve[N];
  for (int i = 0; i < N; ++i) {
    const double approach = -6 + 6.2 * (1 - pow(1 - i / (N - 1.0), 2));
    const double x = 1 - approach; /* of Eq 23 */
    curve[i] = (po_curve_point){.position = approach,
                                .approach = approach,
                                .load = po_bradley_load(approach),
                                .approach_rate = 1,
                                .load_rate = 16 / 3.0 * (pow(x, -9) - pow(x, -3))};
  }
  po_result result = {.start = -6, .ended.approach = 0.2, .curve = curve, .curve_count = N};
  compare(0, &result);
  ck_assert_int_eq(check_results.items[0].verdict, PO_WITHIN);
  for (int i = 0; i < N; ++i)
    curve[i].load += 1e-4;
  compare(0, &result);
  ck_assert_int_eq(check_results.items[1].verdict, PO_OUTSIDE);
  ck_assert_double_eq_tol(check_results.items[1].error, 1e-4, 3e-6);
}

static const struct {
  const char *tolerance;
  po_status first, second;
  const char *reason;
  double share;
  po_verdict verdict;
  const char *note;
} SHARES[] = {
    {"0.4", PO_OK, PO_OK, "", 1, PO_WITHIN, ""},
    {"0.6", PO_OK, PO_OUT_OF_TIME, "late", 0.5, PO_WITHIN,
     "1 of 2 points failed, first point 1: late"},
    {"0.4", PO_OUT_OF_TIME, PO_OK, "", 0.5, PO_OUTSIDE,
     "1 of 2 points failed, first point 0: late"},
    {"0.6", PO_OK, PO_OUT_OF_TIME, "", 0.5, PO_OUTSIDE, "1 of 1 failure has no reason"},
};

TABLE_TEST(share_of_the_scenes_solved, SHARES) {
  load("solved_share", "every_scene", SHARES[_i].tolerance, "abs");
  po_point_run points[2] = {
      {.result = {.status = SHARES[_i].first, .reason = "late"}, .asked = true},
      {.result.status = SHARES[_i].second, .asked = true}};
  strcpy(points[1].result.reason, SHARES[_i].reason);
  po_plan plan = {.kase = kase, .references = &reference};
  po_case_run run = {.plan = &plan, .points = points};
  ck_assert_int_eq(po_run_check(&run, NULL), PO_OK);
  check_results = run.check_results;
  ck_assert_uint_eq(check_results.count, 1);
  ck_assert_double_eq(check_results.items[0].obtained, SHARES[_i].share);
  ck_assert_int_eq(check_results.items[0].verdict, SHARES[_i].verdict);
  ck_assert_str_eq(check_results.items[0].note, SHARES[_i].note);
  ck_assert_str_eq(check_results.items[0].id, "solved_share/every_scene");
  ck_assert(check_results.items[0].whole);
}

FIXTURE(setup, teardown)
