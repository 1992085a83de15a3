/* Profiles of tables that a test writes. */
#ifndef PROFILE_TABLE_H
#define PROFILE_TABLE_H

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "po_profile_table.h"
#include "run.h"

/* Creates a file of a table. Given: a template of its path. */
static FILE *new_table(char *path) {
  const int file = mkstemp(path);
  ck_assert_int_ge(file, 0);
  FILE *f = fdopen(file, "w");
  ck_assert_ptr_nonnull(f);
  fprintf(f, "r,gap\n");
  return f;
}

/* The profile of a table with rows at equal distances. */
static po_profile table_of(double (*gap)(double r), int rows, double end, double scale) {
  char path[] = "/tmp/po_profile_XXXXXX";
  FILE *f = new_table(path);
  for (int k = 0; k < rows; ++k)
    fprintf(f, "%.17g,%.17g\n", end * k / (rows - 1) / scale, gap(end * k / (rows - 1)) / scale);
  ck_assert_int_eq(fclose(f), 0);
  po_profile profile = po_profile_sphere();
  profile.parameter[PO_TABLE_SCALE] = scale;
  ck_assert_msg(po_profile_set_file(&profile, path) == PO_OK, "%s", po_message());
  ck_assert_int_eq(unlink(path), 0);
  return profile;
}

#endif
