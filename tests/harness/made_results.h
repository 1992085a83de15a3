/* A made-up run of two points with a check against each kind of reference, for tests of verdicts.
 */
#ifndef MADE_RESULTS_H
#define MADE_RESULTS_H

#include <check.h>
#include <math.h>
#include <string.h>

#include "po_compare.h"
#include "po_run.h"

enum { ORACLE, OTHER_ORACLE, PUBLISHED, CHECKS };

static po_check made_checks[CHECKS];
static po_reference made_references[CHECKS];
static po_point made_points[2];
static po_case_file made_file;
static po_case made_case;
static po_plan made_plan;
static po_point_run made_results[2];
static po_case_run made_run;

static inline void make_check(int which, const char *reference, po_ledger ledger,
                              double tolerance) {
  made_checks[which] = (po_check){.quantity_text = (char *)"pull_off_force",
                                  .reference = (char *)reference,
                                  .tolerance_text = (char *)"made",
                                  .kind_text = (char *)"abs",
                                  .because = (char *)"it is made up",
                                  .type = po_reference_type_of(reference),
                                  .quantity = PO_PULL_OFF_FORCE,
                                  .tolerance = tolerance,
                                  .kind = PO_TOLERANCE_ABS};
  made_references[which] = (po_reference){.name = made_checks[which].reference, .ledger = ledger};
}

static inline void make_run(void) {
  make_check(ORACLE, "reference/sage.csv", PO_LEDGER_ORACLE, 1e-3);
  make_check(OTHER_ORACLE, "reference/seer.csv", PO_LEDGER_ORACLE, 1e-3);
  make_check(PUBLISHED, "reference/paper.csv", PO_LEDGER_PUBLISHED, 1e-2);
  made_points[0] = (po_point){.id = "0", .label = (char *)"tabor=1"};
  made_points[1] = (po_point){.id = "1", .label = (char *)"tabor=2.385"};
  made_file = (po_case_file){.name = (char *)"made", .checks = made_checks, .checks_count = CHECKS};
  made_case = (po_case){.shown = (char *)"cases/made.yaml",
                        .file = &made_file,
                        .points = made_points,
                        .point_count = 2};
  made_plan = (po_plan){.kase = &made_case, .name = made_file.name, .references = made_references};
  made_run = (po_case_run){.plan = &made_plan, .points = made_results};
}

static inline void clear_run(void) {
  po_check_results_clear(&made_run.check_results);
}

/* Adds the result of one check. Returned: its index among the results. */
static inline size_t found(int which, size_t point, const char *name, const char *suffix,
                           double obtained, double expected, double uncertainty) {
  const po_compare_input c = {.kase = &made_case,
                              .point = point,
                              .check = &made_checks[which],
                              .reference = &made_references[which],
                              .check_results = &made_run.check_results};
  ck_assert_ptr_nonnull(
      po_compare_add(&c, name, suffix, obtained, (po_reference_number){expected, uncertainty}));
  return made_run.check_results.count - 1;
}

static inline po_verdict verdict_of(size_t place) {
  return made_run.check_results.items[place].verdict;
}

#endif
