/* Tests of the assignment of points to shards. */
#include <check.h>
#include <stdint.h>

#include "po_shard.h"
#include "run.h"

/* A sweep of 40 rows of 4 values, series of 5 scenes, a timed case. */
enum { RUNS = 3, SWEPT = 160, VALUES = 4, FOLLOWED = 60, LINE = 5, TIMED = 9, MOST = SWEPT };

static po_case cases[RUNS] = {{.repeats = 1, .series_length = 1, .point_count = SWEPT},
                              {.repeats = 1, .series_length = LINE, .point_count = FOLLOWED},
                              {.repeats = 3, .series_length = 1, .point_count = TIMED}};
static po_plan plans[RUNS];
static po_case_run runs[RUNS];
static po_point_run points[RUNS][MOST];

static void setup(void) {
  for (int r = 0; r < RUNS; ++r) {
    plans[r].kase = &cases[r];
    runs[r] = (po_case_run){.plan = &plans[r], .points = points[r]};
  }
}

static void deal(size_t number, size_t count) {
  ck_assert_int_eq(po_shard_deal(runs, RUNS, (po_shard){number, count}), PO_OK);
}

static size_t units(void) {
  return runs[0].asked_count + runs[1].asked_count / LINE + runs[2].asked_count / TIMED;
}

static const size_t COUNTS[] = {1, 2, 3, 4, 7, 200};

TABLE_TEST(each_point_is_in_one_shard, COUNTS) {
  int times[RUNS][MOST] = {{0}};
  size_t least = SIZE_MAX, most = 0;
  for (size_t k = 1; k <= COUNTS[_i]; ++k) {
    deal(k, COUNTS[_i]);
    least = units() < least ? units() : least;
    most = units() > most ? units() : most;
    for (int r = 0; r < RUNS; ++r) {
      size_t count = 0;
      for (size_t i = 0; i < cases[r].point_count; ++i) {
        times[r][i] += points[r][i].asked;
        count += points[r][i].asked;
      }
      ck_assert_uint_eq(count, runs[r].asked_count);
    }
    for (size_t i = 0; i < FOLLOWED; ++i)
      ck_assert_int_eq(points[1][i].asked, points[1][i - i % LINE].asked);
    for (size_t i = 0; i < TIMED; ++i)
      ck_assert_int_eq(points[2][i].asked, points[2][0].asked);
  }
  ck_assert_uint_le(most - least, 1);
  for (int r = 0; r < RUNS; ++r)
    for (size_t i = 0; i < cases[r].point_count; ++i)
      ck_assert_int_eq(times[r][i], 1);
}

/* If points were assigned in the order of the sweep, each of four shards would get one of the four
 * values in all rows. At random it gets 10 of the 40 points of each value, with a standard
 * deviation of 2.6. */
TEST(no_shard_has_the_dear_end_of_a_sweep) {
  for (size_t k = 1; k <= VALUES; ++k) {
    deal(k, VALUES);
    size_t dear = 0;
    for (size_t i = VALUES - 1; i < SWEPT; i += VALUES)
      dear += points[0][i].asked;
    ck_assert_uint_ge(dear, 5);
    ck_assert_uint_le(dear, 15);
  }
}

FIXTURE(setup, NULL)
