/* Comparison of the jumps and the numbers of a loop with a table. */
#include <check.h>
#include <math.h>
#include <string.h>

#include "made_case.h"
#include "run.h"

/* A table with two jumps for one preload and none for another. */
static const char JUMP_ROWS[] = "tabor,preload,index,phase,approach,load_before,load_after,energy_"
                                "lost,energy_lost_uncertainty\n"
                                "1,0.7,1,loading,-1.6,-0.7,-1.1,0.31,2e-4\n"
                                "1,0.7,2,unloading,-1.7,-1.0,-0.2,0.23,1e-9\n"
                                "1,0.9,1,loading,-1.6,-0.7,-1.1,0.31,1e-9\n";

static po_result loop_of(po_jump *jumps, size_t count) {
  po_result result = {.has_pull_off = true, .has_hysteresis = true};
  result.hysteresis.of[PO_AT_APPROACH] =
      (po_loop){.jumps = jumps, .jump_count = count, .loading_jumps = 1, .energy_lost = 0.5417};
  result.hysteresis.of[PO_AT_APPROACH].pull_off = (po_path_state){.approach = -0.91, .load = -1.67};
  return result;
}

static po_jump JUMPS[] = {
    {true, {.approach = -1.6, .load = -0.7}, {.approach = -1.6, .load = -1.1}, 0.3117},
    {false, {.approach = -1.7, .load = -1.0}, {.approach = -1.7, .load = -0.2}, 0.23}};

TEST(jumps_one_by_one) {
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

TEST(jumps_that_are_others) {
  write_table("", JUMP_ROWS);
  load("jumps", "table.csv", "1e-3", "abs");
  const po_result one = loop_of(JUMPS, 1);
  compare(0, &one); /* no such preload */
  ck_assert_int_eq(check_results.items[0].verdict, PO_MISSING_REFERENCE);
  kase->points[0].request.preload.approach = 0.7;
  compare(0, &one);
  ck_assert_int_eq(check_results.items[1].verdict, PO_OUTSIDE);
  ck_assert_str_eq(check_results.items[1].note, "jumps in loading: 1, in unloading: 0");
  po_jump both[] = {JUMPS[0], JUMPS[0]};
  const po_result loading = loop_of(both, 2);
  compare(0, &loading);
  ck_assert_uint_eq(check_results.count, 3);
  ck_assert_int_eq(check_results.items[2].verdict, PO_OUTSIDE);
  const po_result failed = {.status = PO_STEP_TOO_SMALL};
  compare(0, &failed);
  ck_assert_int_eq(check_results.items[3].verdict, PO_NO_RESULT);
}

/* A table of jumps without the column phase is refused with its line. */
TEST(jumps_of_no_phase) {
  write_table("", "tabor,preload,index,approach,load_before,load_after,energy_lost\n"
                  "1,0.7,1,-1.6,-0.7,-1.1,0.31\n");
  load("jumps", "table.csv", "1e-3", "abs");
  kase->points[0].request.preload.approach = 0.7;
  const po_result result = loop_of(JUMPS, 2);
  ck_assert_int_eq(po_compare(&(po_compare_input){kase, 0, &kase->file->checks[0], &reference,
                                                  &result, NULL, &check_results}),
                   PO_CANNOT_READ);
  ck_assert_ptr_nonnull(strstr(po_message(), "the column phase is missing"));
}

static const struct {
  const char *quantity;
  double obtained, expected;
} LOOPS[] = {{"hysteresis_force", 1.67, 1.6704},
             {"hysteresis_approach", -0.91, -0.9102},
             {"hysteresis_loss", 0.5417, 0.5413}};

TABLE_TEST(numbers_of_a_loop, LOOPS) {
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

TEST(tolerance_tighter_than_a_jump) {
  write_table("", JUMP_ROWS);
  load("jumps", "table.csv", "1e-4", "abs");
  kase->points[0].request.preload.approach = 0.7;
  ck_assert_int_eq(po_compare_check_tolerance(kase, &kase->file->checks[0], 1, &reference),
                   PO_BAD_INPUT);
  ck_assert_ptr_nonnull(strstr(po_message(), "expected at least 0.0002, the uncertainty"));
}

FIXTURE(setup, teardown)
