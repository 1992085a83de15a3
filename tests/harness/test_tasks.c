/* Tests of the order of the solves of a run: timed cases come last, one solve at a time, in rounds
 * over all points, until the solves of a point took long enough. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "po_job.h"
#include "run.h"

enum { RUNS = 4 };

typedef struct {
  po_case kase;
  po_plan plan;
} made_parts;

static made_parts parts[RUNS];
static po_case_run runs[RUNS];
static po_point_run run_points[RUNS][3];

/* A run of three points, of which `done` are solved. */
static void make_run(size_t which, unsigned repeats, size_t points_done) {
  parts[which] = (made_parts){.kase = {.repeats = repeats, .series_length = 1, .point_count = 3}};
  parts[which].plan.kase = &parts[which].kase;
  runs[which] = (po_case_run){.plan = &parts[which].plan,
                              .points = run_points[which],
                              .asked_count = 3,
                              .pending = 3 - points_done,
                              .finished = points_done == 3};
  for (size_t i = 0; i < 3; ++i)
    run_points[which][i] = (po_point_run){.done = i < points_done, .asked = true};
}

/* Lists the jobs of the first runs and compares them. */
static void expect_jobs(size_t run_count, const po_job *expected, size_t count,
                        size_t expected_shared) {
  size_t shared = 0, total = 0;
  po_job *jobs = po_jobs_list(runs, run_count, &shared, &total);
  ck_assert_ptr_nonnull(jobs);
  ck_assert_uint_eq(shared, expected_shared);
  ck_assert_uint_eq(total, count);
  for (size_t i = 0; i < count; ++i) {
    ck_assert_uint_eq(jobs[i].run, expected[i].run);
    ck_assert_uint_eq(jobs[i].point, expected[i].point);
    ck_assert_uint_eq(jobs[i].round, expected[i].round);
    ck_assert(jobs[i].work == (runs[jobs[i].run].plan->solver ? po_job_round : po_job_solve));
  }
  free(jobs);
}

/* Two timed cases, with 3 and 2 rounds, one of them partly solved; one that is not timed; one that
 * is finished. */
TEST(timed_solves_go_round) {
  static const po_job EXPECTED[] = {
      {1, 0, 0}, {1, 1, 0}, {1, 2, 0},                       /* in parallel */
      {0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {2, 1, 0}, {2, 2, 0}, /* the first round */
      {0, 0, 1}, {0, 1, 1}, {0, 2, 1}, {2, 1, 1}, {2, 2, 1}, /* the second */
      {0, 0, 2}, {0, 1, 2}, {0, 2, 2}};
  const size_t count = sizeof EXPECTED / sizeof *EXPECTED;
  make_run(0, 3, 0);
  make_run(1, 1, 0);
  make_run(2, 2, 1);
  make_run(3, 2, 3);
  expect_jobs(RUNS, EXPECTED, count, 3);
}

/* A case that this program and an external solver solve: in each round, each point by both of them.
 * The first and the last point differ only in the mesh, and are one question. */
TEST(solvers_alternate) {
  static const po_job EXPECTED[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0},
                                    {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {0, 2, 1}};
  const size_t count = sizeof EXPECTED / sizeof *EXPECTED;
  static po_point points[3];
  static po_solver solver;
  make_run(0, 2, 0);
  make_run(1, 2, 0);
  for (size_t i = 0; i < 3; ++i)
    points[i].request = po_request_default();
  points[1].request.scene.tabor = 2;
  points[2].request.mesh.tolerance = 1e-3;
  parts[0].kase.points = points;
  parts[1].plan.kase = &parts[0].kase;
  parts[1].plan.solver = &solver;
  expect_jobs(2, EXPECTED, count, 0);
}

TEST(points_are_timed_until_enough) {
  static const po_round SHORT[] = {{0.03, 0.03}, {0.03, 0.03}, {0.03, 0.03}, {0.02, 0.02}},
                        LONG[] = {{0.08, 0.08}, {0.06, 0.06}, {NAN, NAN}, {NAN, NAN}},
                        NONE[] = {{NAN, NAN}};
  ck_assert(!po_times_are_enough(SHORT, 0));
  ck_assert(!po_times_are_enough(SHORT, 3));
  ck_assert(po_times_are_enough(SHORT, 4));
  ck_assert(!po_times_are_enough(LONG, 1));
  ck_assert(po_times_are_enough(LONG, 2));
  ck_assert(po_times_are_enough(LONG, 3));
  ck_assert_double_eq_tol(po_times_median(SHORT, 4), 0.03, 1e-15);
  ck_assert_double_eq_tol(po_times_median(SHORT + 2, 2), 0.025, 1e-15);
  ck_assert_double_eq_tol(po_times_median(LONG, 4), 0.07, 1e-15);
  ck_assert(isnan(po_times_median(NONE, 1)));
}
