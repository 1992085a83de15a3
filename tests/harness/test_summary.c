/* Tests of the summary that `pulloff run` prints for a case with many scenes: numbers by status,
 * costs, the slowest solves and the failures of a made-up run. */
#include <stdio.h>

#include "made_results.h"
#include "po_verdicts.h"
#include "run.h"

/* Seven points, and after them an element that belongs to no point: code that reads it counts it as
 * a failure, and as the slowest and most expensive solve. */
enum { COUNT = 7 };

static po_point points[COUNT + 1];
static po_point_run solved[COUNT + 1];

static void make_seven(void) {
  static const double SECONDS[] = {0.25, 4, 0.5, 2, 0.125, 2, 1, 1e6};
  static const size_t STEPS[] = {40, 70, 20, 60, 10, 50, 30, 1000000};
  make_run();
  for (size_t i = 0; i <= COUNT; ++i) {
    points[i] = (po_point){.label = (char *)"made", .request = po_request_default()};
    snprintf(points[i].id, sizeof points[i].id, "%zu", i);
    points[i].request.scene.tabor = 2.385 + (double)i;
    solved[i] = (po_point_run){
        .result.work = {.seconds = SECONDS[i], .points = STEPS[i], .nodes = 9 * i}, .asked = true};
  }
  solved[2].result.status = PO_OUT_OF_TIME;
  solved[5].result.status = PO_NOT_CONVERGED;
  solved[COUNT].result.status = PO_CHECK_FAILED;
  snprintf(solved[2].result.reason, sizeof solved[2].result.reason, "time is up");
  snprintf(solved[5].result.reason, sizeof solved[5].result.reason, "no solution");
  made_case.points = points;
  made_case.point_count = COUNT;
  made_run.points = solved;
  made_run.asked_count = COUNT;
}

static void summary_is(const char *expected) {
  po_text text = {0};
  po_summary_add(&made_run, &text);
  ck_assert(!text.failed);
  ck_assert_str_eq(po_text_string(&text), expected);
  po_text_clear(&text);
}

#define COMMAND(tabor)                                                                             \
  "  pulloff solve --tabor " tabor " --radius 100 --outer-radius inf"                              \
  " --scheme panel --tolerance 1e-06\n"

/* By nearest rank the median of seven values is the fourth, and the 95 % quantile the last. The
 * five slowest of the seven have a line each; equal ones are in the order of the case. */
TEST(a_whole_run) {
  make_seven();
  summary_is(
      "made: 7 of 7 points\n"
      "status                  points\n"
      "ok                           5\n"
      "not_converged                1\n"
      "out_of_time                  1\n"
      "of each solve           median      95 %  greatest\n"
      "seconds                      1         4         4\n"
      "points                      40        70        70\n"
      "nodes                       27        54        54\n"
      "slowest\n"
      "point 1, ok, 4 s\n" COMMAND("3.385") "point 3, ok, 2 s\n" COMMAND(
          "5.385") "point 5, "
                   "not_converged, "
                   "2 s\n" COMMAND("7.385") "point 6, ok, 1 s\n" COMMAND(
                       "8.385") "point 2, out_of_time, 0.5 s\n" COMMAND("4.385") "fai"
                                                                                 "led"
                                                                                 "\n"
                                                                                 "poi"
                                                                                 "nt "
                                                                                 "2, "
                                                                                 "out"
                                                                                 "_of"
                                                                                 "_ti"
                                                                                 "me:"
                                                                                 " ti"
                                                                                 "me "
                                                                                 "is "
                                                                                 "up"
                                                                                 "\n" COMMAND(
                                                                                     "4.385") "poin"
                                                                                              "t "
                                                                                              "5, "
                                                                                              "not_"
                                                                                              "conv"
                                                                                              "erge"
                                                                                              "d: "
                                                                                              "no "
                                                                                              "solu"
                                                                                              "tion"
                                                                                              "\n" COMMAND(
                                                                                                  "7.385"));
}

/* Points that were not requested do not appear; fewer than five solves are all listed. The median
 * of two values is the first. */
TEST(a_part_of_a_run) {
  make_seven();
  for (size_t i = 0; i < COUNT; ++i)
    solved[i].asked = i == 0 || i == 4;
  made_run.asked_count = 2;
  summary_is("made: 2 of 7 points\n"
             "status                  points\n"
             "ok                           2\n"
             "of each solve           median      95 %  greatest\n"
             "seconds                  0.125      0.25      0.25\n"
             "points                      10        40        40\n"
             "nodes                        0        36        36\n"
             "slowest\n"
             "point 0, ok, 0.25 s\n" COMMAND("2.385") "point 4, ok, 0.125 s\n" COMMAND(
                 "6.385") "none failed\n");
}

/* Regression: the time of a point that an external solver did not solve is unknown, and made the
 * quantiles nan; a point that its manifest excludes was listed as failed; and the command solved
 * with this program. */
TEST(an_external_solver) {
  po_solver solver = {.name = (char *)"other"};
  make_seven();
  made_plan.solver = &solver;
  snprintf(solver.path.text, sizeof solver.path.text, "other.yaml");
  for (size_t i = 0; i < COUNT; ++i)
    solved[i].asked = i == 0 || i == 2 || i == 5;
  made_run.asked_count = 3;
  solved[2].result.work.seconds = NAN;
  solved[5].result.work = (po_work){.seconds = NAN}; /* it was not solved */
  solved[5].beyond = true;
  summary_is("made: 3 of 7 points\n"
             "status                  points\n"
             "ok                           1\n"
             "not_converged                1\n"
             "out_of_time                  1\n"
             "of each solve           median      95 %  greatest\n"
             "seconds                   0.25      0.25      0.25\n"
             "points                      20        40        40\n"
             "nodes                        0        18        18\n"
             "slowest\n"
             "point 0, ok, 0.25 s\n"
             "  pulloff verify made --points 0 --solver other.yaml --fresh --verbose\n"
             "failed\n"
             "point 2, out_of_time: time is up\n"
             "  pulloff verify made --points 2 --solver other.yaml --fresh --verbose\n");
  solved[0].result.work.seconds = NAN;
  po_text text = {0};
  po_summary_add(&made_run, &text);
  ck_assert_ptr_nonnull(strstr(po_text_string(&text), "seconds                      -         -"));
  po_text_clear(&text);
}

TEST(nothing_was_asked_for) {
  make_seven();
  made_run.asked_count = 0;
  summary_is("");
}

/* Of six solves with equal times five are listed, not six. */
TEST(slowest_of_equals) {
  make_seven();
  for (size_t i = 0; i < COUNT; ++i)
    solved[i].result.work.seconds = 0.5;
  po_text text = {0};
  po_summary_add(&made_run, &text);
  int lines = 0;
  for (const char *at = po_text_string(&text); (at = strstr(at, ", 0.5 s\n")); ++at)
    ++lines;
  ck_assert_int_eq(lines, 5);
  po_text_clear(&text);
}

/* A series solves all its points. One that was not requested, and failed, had a line in the TAP
 * that its plan did not count. */
TEST(only_requested_solves_fail) {
  po_text text = {0};
  make_seven();
  solved[5].asked = false;
  made_run.asked_count = COUNT - 1;
  ck_assert_uint_eq(po_case_run_failures(&made_run), 1);
  po_verdicts_tap(&made_run, &(po_identity){0}, 1, &text);
  ck_assert_str_eq(po_text_string(&text),
                   "TAP version 13\n1..1\nnot ok 1 - made solve/made\n# time is up\n");
  po_text_clear(&text);
}
