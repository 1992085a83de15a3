/* Tests of a run that is stopped: its status is PO_INTERRUPTED if and only if a result is missing.
 */
#include <check.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "po_ask_folder.h"
#include "po_case.h"
#include "po_file.h"
#include "po_run.h"
#include "run.h"

static const char CASE[] =
    "name: stopped\ntitle: Stopped\nsuites: [smoke]\nwant: [pull_off]\n"
    "scene: {tabor: 0, radius: 93, outer_radius: inf, scheme: ring}\n"
    "sweep: [{key: nodes, values: [11, 12, 13]}]\n"
    "lines: [{name: any, theory: jkr, sweep: [{key: tabor, values: [%s]}]}]\n";

static char folder[] = "stopped-XXXXXX";
static const char *const FILES[] = {"case.yaml", "stopped/record.json", "stopped/points.jsonl",
                                    "stopped/line-any.csv", "stopped"};

static bool is_there(const char *name) {
  return po_path_exists(po_path_join(folder, name).text);
}

static void setup(void) {
  ck_assert_ptr_nonnull(mkdtemp(folder));
}

static void teardown(void) {
  for (size_t i = 0; i < sizeof FILES / sizeof *FILES; ++i)
    remove(po_path_join(folder, FILES[i]).text);
  remove(folder);
}

/* Runs the first points of the case, with a value of its line, and optionally stops the run. */
static po_status run_case_file(const char *value, size_t points, volatile sig_atomic_t stop) {
  char text[sizeof CASE + 16];
  const po_file_path path = po_path_join(folder, "case.yaml");
  snprintf(text, sizeof text, CASE, value);
  ck_assert_int_eq(po_file_write(path.text, text, strlen(text)), PO_OK);
  po_case *kase = NULL;
  po_plan *plan = NULL;
  po_case_run run;
  ck_assert_int_eq(po_case_read(path.text, path.text, &kase), PO_OK);
  ck_assert_int_eq(po_plan_create(kase, SOURCE_ROOT, NULL, &plan), PO_OK);
  ck_assert_int_eq(po_case_run_create(plan, &run), PO_OK);
  po_case_run_ask(&run, &(po_point_range){0, points - 1}, 1);
  const po_run_options options = {.output = folder, .jobs = 1, .stop = &stop};
  const po_status status = po_run(&run, 1, &options);
  ck_assert_int_eq(run.finished, status == PO_OK);
  po_case_run_clear(&run);
  po_case_destroy(kase);
  return status;
}

TEST(nothing_is_solved_after_a_stop) {
  ck_assert_int_eq(run_case_file("1", 3, 1), PO_INTERRUPTED);
  ck_assert(!is_there("stopped/record.json"));
}

/* Regression: Ctrl-C after the last point, or without points to solve, gave "interrupted" and exit
 * code 130. */
TEST(nothing_is_missing_of_what_is_kept) {
  ck_assert_int_eq(run_case_file("1", 3, 0), PO_OK);
  ck_assert(is_there("stopped/record.json"));
  ck_assert_int_eq(run_case_file("1", 3, 1), PO_OK);
  ck_assert_int_eq(run_case_file("1", 2, 1), PO_OK);
}

/* The points are solved, the closed form for another value is not evaluated yet. */
TEST(a_line_that_is_missing_is_not_made_after_a_stop) {
  ck_assert_int_eq(run_case_file("1", 3, 0), PO_OK);
  ck_assert_int_eq(run_case_file("2", 3, 1), PO_INTERRUPTED);
  ck_assert_int_eq(run_case_file("1", 3, 1), PO_OK); /* as its record still is */
  ck_assert_int_eq(run_case_file("2", 3, 0), PO_OK);
  ck_assert_int_eq(run_case_file("2", 3, 1), PO_OK);
}

/* The same for a part of the points. */
TEST(points_in_the_store_are_not_missing) {
  ck_assert_int_eq(run_case_file("1", 2, 0), PO_OK);
  ck_assert(is_there("stopped/points.jsonl"));
  for (size_t points = 1; points <= 3; ++points)
    ck_assert_int_eq(run_case_file("1", points, 1), points <= 2 ? PO_OK : PO_INTERRUPTED);
}

/* The options of AddressSanitizer: an allocation that is too large returns NULL, as without it.
 */
const char *__asan_default_options(void);
const char *__asan_default_options(void) {
  return "allocator_may_return_null=1";
}

/* More points than the address space can hold: the status is PO_NO_MEMORY. */
TEST(a_run_too_large_is_refused) {
  const po_case large = {.point_count = SIZE_MAX / 2, .repeats = 1};
  po_plan plan = {.kase = &large};
  po_case_run run;
  ck_assert_int_eq(po_case_run_create(&plan, &run), PO_NO_MEMORY);
  ck_assert_ptr_null(run.points);
}

static po_status take_none(void *context, size_t question, po_answer *answer, bool final) {
  (void)context, (void)question, (void)answer, (void) final;
  return PO_OK;
}

/* The folder of a process is removed by the run that recovers its answers, but not while its own
 * run lives, nor by a run with another key. */
TEST(the_folder_of_a_living_run_stays) {
  po_ask_folder made;
  ck_assert_int_eq(po_ask_folder_make(folder, "0123456789abcdef0", &made), PO_OK);
  ck_assert_int_eq(po_file_write(made.response.text, "{}\n", 3), PO_OK);
  ck_assert_int_eq(po_recover(NULL, 0, folder, "0123456789abcdef0", take_none, NULL), PO_OK);
  ck_assert(po_path_exists(made.response.text));
  po_ask_folder_unlock(&made); /* as the end of the process does */
  ck_assert_int_eq(po_recover(NULL, 0, folder, "1123456789abcdef0", take_none, NULL), PO_OK);
  ck_assert(po_path_exists(made.response.text));
  ck_assert_int_eq(po_recover(NULL, 0, folder, "0123456789abcdef0", take_none, NULL), PO_OK);
  ck_assert(!po_path_exists(made.path.text));
}

FIXTURE(setup, teardown)
