/* A made-up case with one check, and the made-up table of its reference. */
#ifndef MADE_CASE_H
#define MADE_CASE_H

#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "po_case.h"
#include "po_compare.h"
#include "po_csv.h"
#include "po_file.h"

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

/* Given: `more`, header lines in addition to those that every table has. */
static inline void write_table(const char *more, const char *rows_text) {
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

static inline void setup(void) {
  strcpy(folder, "/tmp/pulloff-test-XXXXXX");
  ck_assert_ptr_nonnull(mkdtemp(folder));
  snprintf(case_path, sizeof case_path, "%s/made.yaml", folder);
  snprintf(table_path, sizeof table_path, "%s/table.csv", folder);
  write_table("", ROWS);
}

static inline void teardown(void) {
  po_check_results_clear(&check_results);
  po_reference_close(&reference);
  po_case_destroy(kase);
  unlink(case_path);
  unlink(table_path);
  rmdir(folder);
}

static inline void load(const char *quantity, const char *name, const char *tolerance,
                        const char *kind) {
  po_text text = {0};
  po_text_add(&text, CASE, quantity, name, tolerance, kind);
  ck_assert_int_eq(po_file_write(case_path, text.data, text.length), PO_OK);
  po_text_clear(&text);
  ck_assert_msg(po_case_read(case_path, "made.yaml", &kase) == PO_OK, "%s", po_message());
  ck_assert_msg(po_reference_open(folder, kase->file->checks[0].reference, &reference) == PO_OK,
                "%s", po_message());
}

static inline void compare(size_t point, const po_result *result) {
  ck_assert_int_eq(po_compare(&(po_compare_input){kase, point, &kase->file->checks[0], &reference,
                                                  result, NULL, &check_results}),
                   PO_OK);
}

#endif
