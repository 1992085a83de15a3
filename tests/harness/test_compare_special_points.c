/* Comparison of special points with a reference: which are compared, missing or spurious. */
#include <check.h>
#include <math.h>
#include <string.h>

#include "made_case.h"
#include "run.h"

/* A list that is complete up to 0.4; special points of a longer trace beyond it are not compared.
 * The last fold lies below 0.4, but after the first point above it; the reference contains it
 * because its own trace continued to the next wave. */
static const char COMPLETE_ROWS[] = "tabor,complete_to,index,kind,approach,load,uncertainty\n"
                                    "1,0.4,1,jump_in,-1.6,-0.7,1e-9\n"
                                    "1,0.4,2,jump_out,-1.7,-1.0,1e-9\n"
                                    "1,0.4,3,minimum,-0.9,-1.67,1e-9\n"
                                    "1,0.4,4,maximum,0.31,-0.2,1e-9\n"
                                    "2,-1.65,1,jump_in,-1.6,-0.7,1e-9\n";

static po_special_point FOLDS[] = {{.kind = PO_JUMP_IN, .approach = -1.6001, .load = -0.7},
                                   {.kind = PO_JUMP_OUT, .approach = -1.7, .load = -1.0}};

TEST(folds_one_by_one) {
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

TEST(missing_and_spurious_special_points_are_named) {
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

TEST(special_points_beyond_the_trace_are_not_asked_for) {
  load("extrema", "table.csv", "1e-3", "abs");
  po_special_point minimum = {.kind = PO_MINIMUM, .approach = -0.9, .load = -1.67};
  const po_result result = {
      .start = -10, .ended.approach = 2, .extrema = &minimum, .extremum_count = 1};
  compare(0, &result);
  ck_assert_uint_eq(check_results.count, 3);
  for (size_t i = 0; i < 3; ++i)
    ck_assert_int_eq(check_results.items[i].verdict, PO_WITHIN);
}

static po_special_point LATER_FOLDS[] = {
    {.kind = PO_JUMP_IN, .approach = -1.6, .load = -0.7},
    {.kind = PO_JUMP_OUT, .approach = -1.7, .load = -1.0},
    {.kind = PO_JUMP_IN, .approach = 0.52, .load = 0.4}, /* beyond the end of the list ... */
    {.kind = PO_JUMP_OUT,
     .approach = -0.1,
     .load = 0.3} /* ... and all later ones, at any approach */
};

/* Folds a longer trace finds beyond the end of the reference's list are not compared; one before it
 * is spurious. */
TEST(folds_beyond_the_end_of_the_list) {
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

/* At least as many special points are compared as the reference has, even if they lie beyond the
 * end: the list may end with its last special point. */
TEST(the_last_of_the_list_lies_beyond_its_end) {
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

TEST(extrema_beyond_the_end_of_the_list) {
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

  /* our branch ends before the maximum of the reference, which is not compared */
  const po_result shorter = {
      .start = -10, .ended.approach = 0.3, .extrema = extrema, .extremum_count = 1};
  compare(0, &shorter);
  ck_assert_uint_eq(check_results.count, 8);
  ck_assert_double_eq(check_results.items[5].expected, 1);
  for (size_t i = 5; i < 8; ++i)
    ck_assert_int_eq(check_results.items[i].verdict, PO_WITHIN);

  /* our branch passed it without finding it */
  const po_result blind = {
      .start = -10, .ended.approach = 2, .extrema = extrema, .extremum_count = 1};
  compare(0, &blind);
  ck_assert_int_eq(check_results.items[8].verdict, PO_OUTSIDE);
  ck_assert_str_eq(check_results.items[8].note,
                   "missing maximum near approach 0.31, load -0.2 (1 found, reference 2)");
}

TEST(fold_count_up_to_the_end_of_the_list) {
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

TEST(a_scene_the_reference_does_not_know) {
  load("folds", "table.csv", "1e-3", "abs");
  const po_result result = {.start = -10, .ended.approach = 2, .folds = FOLDS, .fold_count = 2};
  compare(1, &result);
  ck_assert_uint_eq(check_results.count, 1);
  ck_assert_int_eq(check_results.items[0].verdict, PO_MISSING_REFERENCE);
}

/* A header with the name of a scene key applies to all rows: the table has no values for other
 * scenes. */
TEST(a_scene_the_headers_exclude) {
  write_table("# outer_radius: 100\n", ROWS);
  load("folds", "table.csv", "1e-3", "abs");
  const po_result result = {.start = -10, .ended.approach = 2, .folds = FOLDS, .fold_count = 2};
  compare(0, &result);
  ck_assert_uint_eq(check_results.count, 1);
  ck_assert_int_eq(check_results.items[0].verdict, PO_MISSING_REFERENCE);
}

FIXTURE(setup, teardown)
