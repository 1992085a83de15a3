/* Our numbers beside a reference: verdicts of made-up results, known before. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "po_bradley.h"
#include "po_compare.h"
#include "po_csv.h"
#include "po_file.h"
#include "run.h"

static char folder[] = "/tmp/pulloff-test-XXXXXX";
static char case_path[64], table_path[64];
static po_case *kase;
static po_reference reference;
static po_check_results check_results;

static const char CASE[] = "name: made\n"
                           "title: Made up\n"
                           "suites: [smoke]\n"
                           "scene: {radius: 100, outer_radius: inf, scheme: ring, nodes: 50}\n"
                           "sweep: [{key: tabor, values: [1, 2]}]\n"
                           "want: [pull_off]\n"
                           "checks:\n"
                           "  - {quantity: %s, reference: %s, tolerance: %s, kind: %s,\n"
                           "     because: it is made up}\n";

static const char ROWS[] = "tabor,index,kind,approach,load,uncertainty\n"
                           "1,1,jump_in,-1.6,-0.7,1e-9\n"
                           "1,2,jump_out,-1.7,-1.0,1e-9\n"
                           "1,3,minimum,-0.9,-1.67,1e-9\n"
                           "1,4,maximum,5,3,1e-9\n";

/* A list that ends at 0.4: what a longer trace finds beyond was not looked for. The last fold lies
 * below that end, but behind the first passage of it; the reference has it since its own trace went
 * on to the next wave. */
static const char COMPLETE_ROWS[] = "tabor,complete_to,index,kind,approach,load,uncertainty\n"
                                    "1,0.4,1,jump_in,-1.6,-0.7,1e-9\n"
                                    "1,0.4,2,jump_out,-1.7,-1.0,1e-9\n"
                                    "1,0.4,3,minimum,-0.9,-1.67,1e-9\n"
                                    "1,0.4,4,maximum,0.31,-0.2,1e-9\n"
                                    "2,-1.65,1,jump_in,-1.6,-0.7,1e-9\n";

/* `more` is header lines beside those every table has. */
static void write_table(const char *more, const char *rows_text) {
  po_text header = {0}, rows = {0}, text = {0};
  char digest[PO_DIGEST_LENGTH];
  po_text_add(&header, "# what: w\n# source: s\n# kind: published\n# method: m\n# units: u\n"
                       "# uncertainty: 1e-9\n# generator: g\n# command: c\n# date: d\n");
  po_text_add(&header, "%s", more);
  po_text_add(&rows, "%s", rows_text);
  po_csv_seal(&header, &rows, &text, digest);
  ck_assert_int_eq(po_file_write(table_path, text.data, text.length), PO_OK);
  po_text_clear(&header);
  po_text_clear(&rows);
  po_text_clear(&text);
}

static void setup(void) {
  strcpy(folder, "/tmp/pulloff-test-XXXXXX");
  ck_assert_ptr_nonnull(mkdtemp(folder));
  snprintf(case_path, sizeof case_path, "%s/made.yaml", folder);
  snprintf(table_path, sizeof table_path, "%s/table.csv", folder);
  write_table("", ROWS);
}

static void teardown(void) {
  po_check_results_clear(&check_results);
  po_reference_close(&reference);
  po_case_destroy(kase);
  unlink(case_path);
  unlink(table_path);
  rmdir(folder);
}

static void load(const char *quantity, const char *name, const char *tolerance, const char *kind) {
  po_text text = {0};
  po_text_add(&text, CASE, quantity, name, tolerance, kind);
  ck_assert_int_eq(po_file_write(case_path, text.data, text.length), PO_OK);
  po_text_clear(&text);
  ck_assert_msg(po_case_read(case_path, "made.yaml", &kase) == PO_OK, "%s", po_message());
  ck_assert_msg(po_reference_open(folder, kase->file->checks[0].reference, &reference) == PO_OK,
                "%s", po_message());
}

static void compare(size_t point, const po_result *result) {
  ck_assert_int_eq(
      po_compare(kase, point, &kase->file->checks[0], &reference, result, &check_results), PO_OK);
}

static po_special_point FOLDS[] = {{.kind = PO_JUMP_IN, .approach = -1.6001, .load = -0.7},
                                   {.kind = PO_JUMP_OUT, .approach = -1.7, .load = -1.0}};

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

START_TEST(force_within_and_outside) {
  load("pull_off_force", "bradley", FORCES[_i].tolerance, FORCES[_i].kind);
  const po_result result = {.has_pull_off = true, .pull_off = {.force = FORCES[_i].force}};
  compare(0, &result);
  ck_assert_uint_eq(check_results.count, 1);
  ck_assert_int_eq(check_results.items[0].verdict, FORCES[_i].verdict);
  ck_assert_double_eq(check_results.items[0].expected, 2);
  ck_assert_str_eq(check_results.items[0].id, "pull_off_force/bradley/tabor=1");
}
END_TEST

/* The closed form of the rigid sphere, a column of its own, and one in units of sqrt(R eps). */
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

START_TEST(contact_radius_of_the_pull_off) {
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
END_TEST

START_TEST(failed_solve_has_no_result) {
  load("pull_off_force", "bradley", "1", "abs");
  const po_result result = {.status = PO_STEP_TOO_SMALL,
                            .reason = "stuck",
                            .has_pull_off = true,
                            .pull_off = {.force = 2}};
  compare(0, &result);
  ck_assert_int_eq(check_results.items[0].verdict, PO_NO_RESULT);
  ck_assert_str_eq(check_results.items[0].note, "stuck");
}
END_TEST

START_TEST(folds_one_by_one) {
  load("folds", "table.csv", "1e-3", "abs");
  const po_result result = {.start = -10, .ended.approach = 2, .folds = FOLDS, .fold_count = 2};
  compare(0, &result);
  ck_assert_uint_eq(check_results.count, 5); /* the number, then approach and load of each */
  for (size_t i = 0; i < 5; ++i)
    ck_assert_int_eq(check_results.items[i].verdict, PO_WITHIN);
  ck_assert_str_eq(check_results.items[1].quantity, "fold_approach");
  ck_assert_double_eq_tol(check_results.items[1].ratio, 0.1, 1e-9);
  ck_assert_double_eq(check_results.items[1].uncertainty, 1e-9);
  ck_assert_str_eq(check_results.items[4].id, "folds/table/tabor=1/jump_out-2/load");
  ck_assert_int_eq(check_results.items[4].ledger, PO_LEDGER_PUBLISHED);
}
END_TEST

START_TEST(missing_and_spurious_special_points_are_named) {
  load("folds", "table.csv", "1e-3", "abs");
  const po_result none = {.start = -10, .ended.approach = 2};
  compare(0, &none);
  ck_assert_int_eq(check_results.items[0].verdict, PO_OUTSIDE);
  ck_assert_ptr_nonnull(strstr(check_results.items[0].note, "missing jump_"));
  po_special_point three[] = {FOLDS[0], FOLDS[1], {.kind = PO_JUMP_IN, .approach = 0.5, .load = 1}};
  const po_result more = {.start = -10, .ended.approach = 2, .folds = three, .fold_count = 3};
  compare(0, &more);
  ck_assert_int_eq(check_results.items[1].verdict, PO_OUTSIDE);
  ck_assert_str_eq(check_results.items[1].note,
                   "spurious jump_in near approach 0.5, load 1 (3 found, reference 2)");
}
END_TEST

START_TEST(special_points_beyond_the_trace_are_not_asked_for) {
  load("extrema", "table.csv", "1e-3", "abs");
  po_special_point minimum = {.kind = PO_MINIMUM, .approach = -0.9, .load = -1.67};
  const po_result result = {
      .start = -10, .ended.approach = 2, .extrema = &minimum, .extremum_count = 1};
  compare(0, &result);
  ck_assert_uint_eq(check_results.count, 3);
  for (size_t i = 0; i < 3; ++i)
    ck_assert_int_eq(check_results.items[i].verdict, PO_WITHIN);
}
END_TEST

static po_special_point LATER_FOLDS[] = {
    {.kind = PO_JUMP_IN, .approach = -1.6, .load = -0.7},
    {.kind = PO_JUMP_OUT, .approach = -1.7, .load = -1.0},
    {.kind = PO_JUMP_IN, .approach = 0.52, .load = 0.4}, /* beyond the end of the list ... */
    {.kind = PO_JUMP_OUT,
     .approach = -0.1,
     .load = 0.3} /* ... and what follows, at whatever approach */
};

/* Folds a longer trace finds beyond the end of the reference's list are not compared; one before it
 * is spurious. */
START_TEST(folds_beyond_the_end_of_the_list) {
  write_table("", COMPLETE_ROWS);
  load("folds", "table.csv", "1e-3", "abs");
  po_result result = {.start = -10, .ended.approach = 2, .folds = LATER_FOLDS, .fold_count = 4};
  compare(0, &result);
  ck_assert_uint_eq(check_results.count, 5);
  for (size_t i = 0; i < 5; ++i)
    ck_assert_int_eq(check_results.items[i].verdict, PO_WITHIN);
  ck_assert_double_eq(check_results.items[0].obtained, 2);

  po_special_point before_the_end[4];
  memcpy(before_the_end, LATER_FOLDS, sizeof before_the_end);
  before_the_end[2].approach = 0.39;
  result.folds = before_the_end;
  compare(0, &result);
  ck_assert_uint_eq(check_results.count, 6);
  ck_assert_int_eq(check_results.items[5].verdict, PO_OUTSIDE);
  ck_assert_double_eq(check_results.items[5].obtained, 4);
  ck_assert_ptr_nonnull(strstr(check_results.items[5].note, "spurious jump_"));
}
END_TEST

/* As many of ours as the reference has are compared, even if they lie beyond: the list may end with
 * its last one. */
START_TEST(the_last_of_the_list_lies_beyond_its_end) {
  write_table("", COMPLETE_ROWS);
  load("folds", "table.csv", "1e-3", "abs");
  const po_result result = {
      .start = -10, .ended.approach = 2, .folds = LATER_FOLDS, .fold_count = 3};
  compare(1, &result); /* tabor 2: complete to -1.65, one fold, at -1.6 */
  ck_assert_uint_eq(check_results.count, 1);
  ck_assert_double_eq(check_results.items[0].expected, 1);
  ck_assert_double_eq(check_results.items[0].obtained, 2); /* -1.7 is not beyond -1.65; 0.52 is */
  ck_assert_int_eq(check_results.items[0].verdict, PO_OUTSIDE);
}
END_TEST

START_TEST(extrema_beyond_the_end_of_the_list) {
  write_table("", COMPLETE_ROWS);
  load("extrema", "table.csv", "1e-3", "abs");
  po_special_point extrema[] = {{.kind = PO_MINIMUM, .approach = -0.9, .load = -1.67},
                                {.kind = PO_MAXIMUM, .approach = 0.31, .load = -0.2},
                                {.kind = PO_MINIMUM, .approach = 0.43, .load = -0.3},
                                {.kind = PO_MAXIMUM, .approach = 0.1, .load = -0.1}};
  const po_result longer = {
      .start = -10, .ended.approach = 2, .extrema = extrema, .extremum_count = 4};
  compare(0, &longer);
  ck_assert_uint_eq(check_results.count, 5);
  for (size_t i = 0; i < 5; ++i)
    ck_assert_int_eq(check_results.items[i].verdict, PO_WITHIN);

  /* ours ends before the reference's maximum: that is not asked for */
  const po_result shorter = {
      .start = -10, .ended.approach = 0.3, .extrema = extrema, .extremum_count = 1};
  compare(0, &shorter);
  ck_assert_uint_eq(check_results.count, 8);
  ck_assert_double_eq(check_results.items[5].expected, 1);
  for (size_t i = 5; i < 8; ++i)
    ck_assert_int_eq(check_results.items[i].verdict, PO_WITHIN);

  /* ours went past it without finding it */
  const po_result blind = {
      .start = -10, .ended.approach = 2, .extrema = extrema, .extremum_count = 1};
  compare(0, &blind);
  ck_assert_int_eq(check_results.items[8].verdict, PO_OUTSIDE);
  ck_assert_str_eq(check_results.items[8].note,
                   "missing maximum near approach 0.31, load -0.2 (1 found, reference 2)");
}
END_TEST

START_TEST(fold_count_up_to_the_end_of_the_list) {
  write_table("", COMPLETE_ROWS);
  load("fold_count", "table.csv", "0.5", "abs");
  po_result result = {.start = -10, .ended.approach = 2, .folds = LATER_FOLDS, .fold_count = 4};
  compare(0, &result);
  ck_assert_uint_eq(check_results.count, 1);
  ck_assert_double_eq(check_results.items[0].obtained, 2);
  ck_assert_double_eq(check_results.items[0].expected, 2);
  ck_assert_int_eq(check_results.items[0].verdict, PO_WITHIN);
  result.fold_count = 1;
  compare(0, &result);
  ck_assert_int_eq(check_results.items[1].verdict, PO_OUTSIDE);
}
END_TEST

START_TEST(a_scene_the_reference_does_not_know) {
  load("folds", "table.csv", "1e-3", "abs");
  const po_result result = {.start = -10, .ended.approach = 2, .folds = FOLDS, .fold_count = 2};
  compare(1, &result);
  ck_assert_uint_eq(check_results.count, 1);
  ck_assert_int_eq(check_results.items[0].verdict, PO_MISSING_REFERENCE);
}
END_TEST

/* A header named as a key of the scene holds for all rows: the table is silent of other scenes. */
START_TEST(a_scene_the_headers_exclude) {
  write_table("# outer_radius: 100\n", ROWS);
  load("folds", "table.csv", "1e-3", "abs");
  const po_result result = {.start = -10, .ended.approach = 2, .folds = FOLDS, .fold_count = 2};
  compare(0, &result);
  ck_assert_uint_eq(check_results.count, 1);
  ck_assert_int_eq(check_results.items[0].verdict, PO_MISSING_REFERENCE);
}
END_TEST

START_TEST(tolerance_tighter_than_the_reference) {
  load("folds", "table.csv", "1e-10", "abs");
  ck_assert_int_eq(po_compare_check_tolerance(kase, &kase->file->checks[0], 1, &reference),
                   PO_BAD_INPUT);
  ck_assert_str_eq(po_message(), "made.yaml:8: checks[1].tolerance is 1e-10: expected at least "
                                 "1e-09, the uncertainty of table.csv itself");
  const size_t count = kase->point_count;
  kase->point_count = 0; /* what lies behind the last point is of no case */
  ck_assert_int_eq(po_compare_check_tolerance(kase, &kase->file->checks[0], 1, &reference), PO_OK);
  kase->point_count = count;
}
END_TEST

/* Why the reverse trace has no number is in the note: it was not gone, it failed, or met other
 * folds. */
START_TEST(reverse_trace_without_a_number) {
  load("reverse_trace", "zero", "1e-3", "abs");
  po_result result = {.has_pull_off = true, .fold_count = 2, .extremum_count = 3};
  po_reverse_trace *w = &result.diagnostics.reverse_trace;
  *w = (po_reverse_trace){.excess = (double)NAN};
  compare(0, &result);
  ck_assert_str_eq(check_results.items[0].note,
                   "the branch is followed back on panels alone, and not when rigid");
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
                   "2 folds on the way out, 4 on the reverse trace; extrema 3 and 5");
  for (size_t i = 0; i < 3; ++i)
    ck_assert_int_eq(check_results.items[i].verdict, PO_NO_RESULT);
}
END_TEST

/* A closed form has its rounding errors: of the load 3.5e-15 at the contact of 0.2, 2e-17 far out.
 */
START_TEST(tolerance_tighter_than_rounding) {
  static const struct {
    const char *tolerance;
    po_status status;
  } KNOWN[] = {{"1e-14", PO_OK}, {"1e-15", PO_BAD_INPUT}, {"1e-18", PO_BAD_INPUT}};
  load("curve", "bradley", KNOWN[_i].tolerance, "abs");
  ck_assert_int_eq(po_compare_check_tolerance(kase, &kase->file->checks[0], 1, &reference),
                   KNOWN[_i].status);
}
END_TEST

START_TEST(curve_of_the_closed_form) {
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
END_TEST

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
     "1 of 2 failed, the first point 1: late"},
    {"0.4", PO_OUT_OF_TIME, PO_OK, "", 0.5, PO_OUTSIDE, "1 of 2 failed, the first point 0: late"},
    {"0.6", PO_OK, PO_OUT_OF_TIME, "", 0.5, PO_OUTSIDE, "1 of 1 failures give no reason"},
};

START_TEST(share_of_the_scenes_solved) {
  load("solved_share", "every_scene", SHARES[_i].tolerance, "abs");
  po_result results[2] = {{.status = SHARES[_i].first, .reason = "late"},
                          {.status = SHARES[_i].second}};
  strcpy(results[1].reason, SHARES[_i].reason);
  const bool asked[2] = {true, true};
  ck_assert_int_eq(
      po_compare_share(kase, asked, &kase->file->checks[0], &reference, results, &check_results),
      PO_OK);
  ck_assert_uint_eq(check_results.count, 1);
  ck_assert_double_eq(check_results.items[0].obtained, SHARES[_i].share);
  ck_assert_int_eq(check_results.items[0].verdict, SHARES[_i].verdict);
  ck_assert_str_eq(check_results.items[0].note, SHARES[_i].note);
  ck_assert_str_eq(check_results.items[0].id, "solved_share/every_scene");
  ck_assert(check_results.items[0].whole);
}
END_TEST

/* Two jumps, at another preload nothing. */
static const char JUMP_ROWS[] = "tabor,preload,index,phase,approach,load_before,load_after,energy_"
                                "lost,energy_lost_uncertainty\n"
                                "1,0.7,1,loading,-1.6,-0.7,-1.1,0.31,2e-4\n"
                                "1,0.7,2,unloading,-1.7,-1.0,-0.2,0.23,1e-9\n"
                                "1,0.9,1,loading,-1.6,-0.7,-1.1,0.31,1e-9\n";

static po_result loop_of(po_jump *jumps, size_t count) {
  po_result result = {.has_pull_off = true, .has_hysteresis = true};
  result.hysteresis.displacement =
      (po_loop){.jumps = jumps, .jump_count = count, .loading_jumps = 1, .energy_lost = 0.5417};
  result.hysteresis.displacement.pull_off = (po_path_state){.approach = -0.91, .load = -1.67};
  return result;
}

static po_jump JUMPS[] = {
    {true, {.approach = -1.6, .load = -0.7}, {.approach = -1.6, .load = -1.1}, 0.3117},
    {false, {.approach = -1.7, .load = -1.0}, {.approach = -1.7, .load = -0.2}, 0.23}};

START_TEST(jumps_one_by_one) {
  write_table("", JUMP_ROWS);
  load("jumps", "table.csv", "1e-3", "abs");
  kase->points[0].request.preload.approach = 0.7;
  const po_result result = loop_of(JUMPS, 2);
  compare(0, &result);
  ck_assert_uint_eq(check_results.count, 9); /* the number, then four of each */
  for (size_t i = 0; i < 9; ++i)
    ck_assert_int_eq(check_results.items[i].verdict, i == 4 ? PO_OUTSIDE : PO_WITHIN);
  ck_assert_str_eq(check_results.items[4].id, "jumps/table/tabor=1/loading-1/energy_lost");
  ck_assert_str_eq(check_results.items[4].subject, "jump_energy_lost/loading-1");
  ck_assert_double_eq_tol(check_results.items[4].ratio, 1.7, 1e-9);
  ck_assert_double_eq(check_results.items[4].uncertainty, 2e-4);
  ck_assert_str_eq(check_results.items[7].id, "jumps/table/tabor=1/unloading-1/load_after");
  ck_assert_double_eq(check_results.items[7].obtained, -0.2);
}
END_TEST

START_TEST(jumps_that_are_others) {
  write_table("", JUMP_ROWS);
  load("jumps", "table.csv", "1e-3", "abs");
  const po_result one = loop_of(JUMPS, 1);
  compare(0, &one); /* no such preload */
  ck_assert_int_eq(check_results.items[0].verdict, PO_MISSING_REFERENCE);
  kase->points[0].request.preload.approach = 0.7;
  compare(0, &one);
  ck_assert_int_eq(check_results.items[1].verdict, PO_OUTSIDE);
  ck_assert_str_eq(check_results.items[1].note, "1 in loading, 0 in unloading");
  po_jump both[] = {JUMPS[0], JUMPS[0]};
  const po_result loading = loop_of(both, 2);
  compare(0, &loading);
  ck_assert_uint_eq(check_results.count, 3);
  ck_assert_int_eq(check_results.items[2].verdict, PO_OUTSIDE);
  const po_result failed = {.status = PO_STEP_TOO_SMALL};
  compare(0, &failed);
  ck_assert_int_eq(check_results.items[3].verdict, PO_NO_RESULT);
}
END_TEST

/* A table of jumps that does not say which of them are of loading has an error, and its line. */
START_TEST(jumps_of_no_phase) {
  write_table("", "tabor,preload,index,approach,load_before,load_after,energy_lost\n"
                  "1,0.7,1,-1.6,-0.7,-1.1,0.31\n");
  load("jumps", "table.csv", "1e-3", "abs");
  kase->points[0].request.preload.approach = 0.7;
  const po_result result = loop_of(JUMPS, 2);
  ck_assert_int_eq(po_compare(kase, 0, &kase->file->checks[0], &reference, &result, &check_results),
                   PO_CANNOT_READ);
  ck_assert_ptr_nonnull(strstr(po_message(), "the column phase is missing"));
}
END_TEST

static const struct {
  const char *quantity;
  double obtained, expected;
} LOOPS[] = {{"hysteresis_force", 1.67, 1.6704},
             {"hysteresis_approach", -0.91, -0.9102},
             {"hysteresis_loss", 0.5417, 0.5413}};

START_TEST(numbers_of_a_loop) {
  write_table("", "tabor,preload,force,approach,energy_lost\n1,0.7,1.6704,-0.9102,0.5413\n");
  load(LOOPS[_i].quantity, "table.csv", "1e-3", "abs");
  kase->points[0].request.preload.approach = 0.7;
  const po_result result = loop_of(JUMPS, 2), none = {.has_pull_off = true};
  compare(0, &result);
  ck_assert_double_eq(check_results.items[0].obtained, LOOPS[_i].obtained);
  ck_assert_double_eq(check_results.items[0].expected, LOOPS[_i].expected);
  ck_assert_int_eq(check_results.items[0].verdict, PO_WITHIN);
  compare(0, &none);
  ck_assert_int_eq(check_results.items[1].verdict, PO_NO_RESULT);
}
END_TEST

START_TEST(tolerance_tighter_than_a_jump) {
  write_table("", JUMP_ROWS);
  load("jumps", "table.csv", "1e-4", "abs");
  kase->points[0].request.preload.approach = 0.7;
  ck_assert_int_eq(po_compare_check_tolerance(kase, &kase->file->checks[0], 1, &reference),
                   PO_BAD_INPUT);
  ck_assert_ptr_nonnull(strstr(po_message(), "expected at least 0.0002, the uncertainty"));
}
END_TEST

static void add(TCase *tests) {
  tcase_add_checked_fixture(tests, setup, teardown);
  tcase_add_loop_test(tests, force_within_and_outside, 0, (int)(sizeof FORCES / sizeof *FORCES));
  tcase_add_loop_test(tests, contact_radius_of_the_pull_off, 0,
                      (int)(sizeof RADII / sizeof *RADII));
  tcase_add_test(tests, failed_solve_has_no_result);
  tcase_add_test(tests, folds_one_by_one);
  tcase_add_test(tests, missing_and_spurious_special_points_are_named);
  tcase_add_test(tests, special_points_beyond_the_trace_are_not_asked_for);
  tcase_add_test(tests, folds_beyond_the_end_of_the_list);
  tcase_add_test(tests, the_last_of_the_list_lies_beyond_its_end);
  tcase_add_test(tests, extrema_beyond_the_end_of_the_list);
  tcase_add_test(tests, fold_count_up_to_the_end_of_the_list);
  tcase_add_test(tests, a_scene_the_reference_does_not_know);
  tcase_add_test(tests, a_scene_the_headers_exclude);
  tcase_add_test(tests, tolerance_tighter_than_the_reference);
  tcase_add_test(tests, reverse_trace_without_a_number);
  tcase_add_loop_test(tests, tolerance_tighter_than_rounding, 0, 3);
  tcase_add_test(tests, curve_of_the_closed_form);
  tcase_add_test(tests, jumps_one_by_one);
  tcase_add_test(tests, jumps_that_are_others);
  tcase_add_test(tests, jumps_of_no_phase);
  tcase_add_loop_test(tests, numbers_of_a_loop, 0, (int)(sizeof LOOPS / sizeof *LOOPS));
  tcase_add_test(tests, tolerance_tighter_than_a_jump);
  tcase_add_loop_test(tests, share_of_the_scenes_solved, 0, (int)(sizeof SHARES / sizeof *SHARES));
}

int main(void) {
  return run_case("compare", add);
}
