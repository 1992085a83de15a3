/* The work to read and plan a case must be proportional to its size, not to the square. It is
 * counted in basic blocks: for this program the sources of the harness are compiled with
 * -fsanitize-coverage=trace-pc, which calls a function in each of them. A sweep of 10,000 values
 * once took 22 s and a mapping of 60,000 keys 35 s, as each was compared with every other. */
#include <check.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "po_case.h"
#include "po_file.h"
#include "po_record.h"
#include "po_run.h"
#include "po_text.h"
#include "run.h"

static uint64_t blocks;

void __sanitizer_cov_trace_pc(void);
void __sanitizer_cov_trace_pc(void) {
  ++blocks;
}

/* "[1, 2, ... n]" */
static void add_numbers(po_text *text, size_t n) {
  for (size_t i = 1; i <= n; ++i)
    po_text_add(text, "%s%zu", i == 1 ? "[" : ", ", i);
  po_text_add(text, "]");
}

static void add_sweep(po_text *text, size_t n) {
  po_text_add(text, "sweep: [{key: radius, values: ");
  add_numbers(text, n);
  po_text_add(text, "}]\n");
}

#define CHECK                                                                                      \
  "  - {quantity: pull_off_force, reference: bradley, tolerance: 1, kind: abs, because: any, "     \
  "when: [{key: radius, values: "

static void values(po_text *text, size_t n) {
  add_sweep(text, n);
}

static void settings(po_text *text, size_t n) {
  po_text_add(text, "sweep:\n  - together:\n");
  for (size_t i = 1; i <= n; ++i)
    po_text_add(text, "      - {radius: %zu}\n", i);
}

static void keys(po_text *text, size_t n) {
  for (size_t i = 1; i <= n; ++i)
    po_text_add(text, "key_%zu: 1\n", i);
}

static void conditions(po_text *text, size_t n) {
  add_sweep(text, n);
  po_text_add(text, "checks:\n" CHECK);
  add_numbers(text, n);
  po_text_add(text, "}]}\n");
}

static void checks(po_text *text, size_t n) {
  add_sweep(text, 3);
  po_text_add(text, "checks:\n");
  for (size_t i = 1; i <= n; ++i)
    po_text_add(text, CHECK "[3]}]}\n");
}

static void shares(po_text *text, size_t n) {
  add_sweep(text, 3);
  po_text_add(text, "checks:\n");
  for (size_t i = 1; i <= n; ++i)
    po_text_add(text,
                "  - {quantity: solved_share, reference: every_scene, tolerance: 0.1, kind: abs, "
                "because: any, when: [{key: radius, values: [2]}]}\n");
}

static void rules(po_text *text, size_t n) {
  add_sweep(text, 3);
  po_text_add(text, "leave_out:\n");
  for (size_t i = 1; i <= n; ++i)
    po_text_add(text, "  - {because: any, when: [{key: radius, values: [1]}]}\n");
}

static void lines(po_text *text, size_t n) {
  add_sweep(text, 3);
  po_text_add(text, "lines:\n");
  for (size_t i = 1; i <= n; ++i)
    po_text_add(text, "  - {name: l%zu, theory: jkr, sweep: [{key: tabor, values: [1]}]}\n", i);
}

static const struct {
  const char *name;
  void (*add)(po_text *text, size_t n);
  po_status expected;
} FAMILIES[] = {
    {"values of a sweep", values, PO_OK},
    {"settings of a sweep", settings, PO_OK},
    {"keys of a mapping", keys, PO_BAD_INPUT},
    {"values of a condition and of a sweep", conditions, PO_OK},
    {"checks", checks, PO_OK},
    {"shares that may fail", shares, PO_OK},
    {"rules of what is left out, which exclude the same", rules, PO_OK},
    {"lines", lines, PO_OK},
};
enum { FAMILY_COUNT = sizeof FAMILIES / sizeof *FAMILIES };

/* The points of a case as its record holds them. */
static void describe(po_plan *plan) {
  po_case_run run;
  ck_assert_int_eq(po_case_run_create(plan, &run), PO_OK);
  for (size_t i = 0; i < plan->kase->point_count; ++i) {
    json_t *point = po_record_point(&run, i);
    ck_assert_ptr_nonnull(point);
    json_decref(point);
  }
  po_case_run_clear(&run);
}

/* Returned: the number of blocks that reading, planning and describing a case of size n takes. */
static uint64_t work(int which, size_t n) {
  char path[] = "/tmp/planning-XXXXXX";
  const int file = mkstemp(path);
  po_text text = {0};
  po_text_add(&text, "name: large\ntitle: Large\nsuites: [smoke]\nwant: [pull_off]\n"
                     "scene: {tabor: 0, outer_radius: inf, scheme: panel}\n");
  FAMILIES[which].add(&text, n);
  ck_assert_int_ge(file, 0);
  ck_assert_int_eq(write(file, text.data, text.length), (ssize_t)text.length);
  close(file);
  po_text_clear(&text);
  blocks = 0;
  po_case *kase = NULL;
  po_plan *plan = NULL;
  const po_status status = po_case_read(path, path, &kase);
  ck_assert_msg(status == FAMILIES[which].expected, "%s: %s", FAMILIES[which].name, po_message());
  if (!status) {
    ck_assert_int_eq(po_plan_create(kase, SOURCE_ROOT, NULL, &plan), PO_OK);
    describe(plan);
  }
  po_case_destroy(kase);
  unlink(path);
  return blocks;
}

/* Twice the size takes twice the work, and slightly more where a list is sorted: measured 1.8 to
 * 2.1. Quadratic work would be four times as much. */
LOOP_TEST(work_grows_with_size, 0, FAMILY_COUNT) {
  enum { SIZE = 1000 };
  const uint64_t once = work(_i, SIZE), twice = work(_i, 2 * SIZE);
  ck_assert_uint_ge(once, SIZE); /* something is counted */
  ck_assert_msg((double)twice < 2.3 * (double)once, "%s: %llu blocks for %d, %llu for %d",
                FAMILIES[_i].name, (unsigned long long)once, SIZE, (unsigned long long)twice,
                2 * SIZE);
  if (getenv("PULLOFF_SHOW_WORK"))
    printf("%-60s %.3f %g\n", FAMILIES[_i].name, (double)twice / (double)once, (double)once);
}
