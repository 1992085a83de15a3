/* A reference table, whose rows are compared with computed values. */
#ifndef TABLE_H
#define TABLE_H

#include <check.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "../unit/run.h"
#include "po_csv.h"

typedef struct {
  po_csv csv;
  size_t compared; /* how many numbers have been compared */
  size_t left_out; /* rows that are of another kind */
  double worst;    /* greatest difference, in units of its tolerance */
  char where[80];  /* line and column of the greatest difference */
} table;

/* Opens reference/NAME. Its rows must have the checksum that its header states. */
static inline table table_open(const char *name) {
  table t = {0};
  char path[1024];
  snprintf(path, sizeof path, SOURCE_ROOT "/reference/%s", name);
  ck_assert_msg(po_csv_read(path, name, &t.csv) == PO_OK, "%s", po_message());
  const po_csv_header *digest = po_csv_find_header(&t.csv, "sha256");
  ck_assert_msg(digest && strcmp(digest->value, t.csv.digest) == 0, "%s: not its sha256", name);
  return t;
}

static inline size_t table_column(const table *t, const char *column) {
  const int found = po_csv_find_column(&t->csv, column);
  ck_assert_msg(found >= 0, "%s: no column %s", t->csv.path, column);
  return (size_t)found;
}

static inline const char *table_word(const table *t, size_t row, const char *column) {
  return po_csv_cell(&t->csv, row, table_column(t, column));
}

static inline double table_number(const table *t, size_t row, const char *column) {
  double value = NAN;
  ck_assert_msg(po_csv_number(&t->csv, row, table_column(t, column), &value) == PO_OK, "%s",
                po_message());
  return value;
}

/* Whether a row is of another kind than is asked for, and left out. */
static inline bool table_leaves_out(table *t, size_t row, const char *kind) {
  const bool other = strcmp(table_word(t, row, "kind"), kind) != 0;
  t->left_out += other;
  return other;
}

/* Tests the error of a number of a row. */
static inline void table_judge(table *t, size_t row, const char *column, double error,
                               double tolerance) {
  t->compared += 1;
  if (error > t->worst * tolerance) {
    t->worst = error / tolerance;
    snprintf(t->where, sizeof t->where, "line %zu, %s", t->csv.lines[row], column);
  }
  ck_assert_msg(error <= tolerance, "%s:%zu: %s is off by %.2e, expected %.2e", t->csv.path,
                t->csv.lines[row], column, error, tolerance);
}

/* Compares `obtained` with the cell. The tolerance is absolute. */
static inline void table_compare(table *t, size_t row, const char *column, double obtained,
                                 double tolerance) {
  table_judge(t, row, column, fabs(obtained - table_number(t, row, column)), tolerance);
}

/* Closes the table. It must have `rows` rows but for those left out, and each must have been
 * compared `each` times. Prints the greatest difference for the log of the test. */
static inline void table_close(table *t, const char *what, size_t rows, size_t each) {
  ck_assert_uint_eq(t->csv.row_count - t->left_out, rows);
  ck_assert_uint_eq(t->compared, rows * each);
  printf("%s: %s: %zu numbers, at most %.3f of the tolerance (%s)\n", t->csv.path, what,
         t->compared, t->worst, t->where);
  po_csv_clear(&t->csv);
}

/* A test of every row of a table. The block that follows is that of one row, `row` of the table
 * `t`. */
#define ROWS_TEST(NAME, FILE, WHAT, ROWS, EACH)                                                    \
  static void NAME##_in(table *t, size_t row);                                                     \
  TEST(NAME) {                                                                                     \
    table opened = table_open(FILE);                                                               \
    for (size_t row = 0; row < opened.csv.row_count; ++row)                                        \
      NAME##_in(&opened, row);                                                                     \
    table_close(&opened, WHAT, ROWS, EACH);                                                        \
  }                                                                                                \
  static void NAME##_in(table *t, size_t row)

#endif
