#include "po_tables.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_csv.h"
#include "po_file.h"
#include "po_input.h"
#include "po_memory.h"
#include "po_profile_table.h"
#include "po_result_rows.h"

/* A column of a table, and the path of its number in the items of a list. */
typedef struct {
  const char *name, *path;
  bool optional; /* the curve of an external solver does not have it: nan */
} column;
#define LENGTH(list) (sizeof(list) / sizeof *(list))

static const column CURVE[] = {{"position", "position", false},
                               {"approach", "approach", false},
                               {"load", "load", false},
                               {"energy", "energy", true},
                               {"contact_radius", "contact_radius", true},
                               {"approach_rate", "approach_rate", true},
                               {"load_rate", "load_rate", true},
                               {"unstable_modes", "unstable_modes", false},
                               {"energy_error", "energy_error_estimate", true}};

static const column PROFILE[] = {
    {"radius", "radius", false}, {"gap", "gap", false}, {"traction", "traction", false}};

/* If the step is open, `until` is the last state of loading on the curve; separated bodies have the
 * approach -inf. */
static const column STEP[] = {{"from_approach", "preload.approach", false},
                              {"from_load", "preload.load", false},
                              {"until_approach", "until.approach", false},
                              {"until_load", "until.load", false},
                              {"open", "open", false},
                              {"force", "force", false},
                              {"force_error", "error_estimate", false},
                              {"approach", "approach", false},
                              {"approach_error", "approach_error_estimate", false},
                              {"energy_lost", "cycles.0.energy_lost", false},
                              {"energy_lost_error", "cycles.0.energy_lost_error_estimate", false}};

enum { MOST_COLUMNS = LENGTH(STEP) };

static void add_names(po_text *rows, const char *before, const column *columns, size_t count) {
  for (size_t c = 0; c < count; ++c)
    po_text_add(rows, "%s%s", c ? "," : before, columns[c].name);
  po_text_add(rows, "\n");
}

/* Adds a row for each item of a list, which begins with a text. */
static void add_items(po_text *rows, const char *before, const column *columns, size_t count,
                      const po_block *block, const void *list, size_t items) {
  double row[MOST_COLUMNS];
  for (size_t i = 0; i < items; ++i) {
    for (size_t c = 0; c < count; ++c)
      row[c] = po_block_number(block, (const char *)list + i * block->size, columns[c].path);
    po_text_add(rows, "%s", before);
    po_csv_add_row(rows, row, count);
  }
}

/* Writes to a file, or to standard output for "-". */
static po_status write_text(const char *path, const po_text *text) {
  if (strcmp(path, "-") != 0)
    return po_file_write(path, text->data, text->length);
  errno = 0;
  if (fwrite(text->data, 1, text->length, stdout) == text->length && fflush(stdout) == 0)
    return PO_OK;
  return po_fail(PO_CANNOT_WRITE, "standard output cannot be written: %s", strerror(errno));
}

/* Writes a table. Given: rows, which begin with the line of column names and are cleared. */
static po_status write_table(const char *path, const po_request *request, const char *what,
                             const char *units, po_text *rows, char *digest) {
  char own[PO_DIGEST_LENGTH];
  char *command = po_input_command(request);
  po_text header = {0}, text = {0};
  po_text_add(&header, "# what: %s\n# units: %s\n# command: %s\n", what, units,
              command ? command : "");
  po_csv_seal(&header, rows, &text, own);
  const bool failed = text.failed || !command;
  const po_status status = failed ? PO_NO_MEMORY : write_text(path, &text);
  if (digest)
    memcpy(digest, own, sizeof own);
  free(command);
  po_text_clear(rows);
  po_text_clear(&header);
  po_text_clear(&text);
  return status;
}

po_status po_tables_write_curve(const char *path, const po_request *request,
                                const po_result *result, char *digest) {
  po_text rows = {0};
  add_names(&rows, "", CURVE, LENGTH(CURVE));
  add_items(&rows, "", CURVE, LENGTH(CURVE), &PO_CURVE_ROWS, result->curve, result->curve_count);
  return write_table(path, request, "load against approach along the branch",
                     "approach and contact_radius in epsilon; load in pi w R, compressive > 0; "
                     "energy in pi w R epsilon, its derivative by the approach is the load; "
                     "energy_error: bound of its error at this approach, nan: not estimated; "
                     "position: arclength along the branch in the metric of the solver; "
                     "approach_rate and load_rate: derivatives by the position",
                     &rows, digest);
}

po_status po_tables_write_profile(const char *path, const po_request *request,
                                  const po_result *result, char *digest) {
  po_text rows = {0};
  char approach[PO_NUMBER_LENGTH], what[100];
  po_number_print(result->profile_approach, approach);
  snprintf(what, sizeof what, "gap and traction over the radius at approach %s", approach);
  add_names(&rows, "", PROFILE, LENGTH(PROFILE));
  add_items(&rows, "", PROFILE, LENGTH(PROFILE), &PO_PROFILE_ROWS, result->profile,
            result->profile_count);
  return write_table(path, request, what,
                     "radius and approach in epsilon; gap H = h/epsilon - 1; traction P = p mu "
                     "epsilon/w, compressive > 0",
                     &rows, digest);
}

po_status po_tables_write_smoothed(const char *path, const po_request *request) {
  const po_profile *profile = &request->scene.profile;
  const po_profile_table *t = profile->table;
  po_text rows = {0};
  po_text_add(&rows, "r,gap,removed\n");
  for (size_t k = 0; k < t->smoothing.points; ++k) {
    const double r = t->measured[k];
    const double row[] = {r / t->scale, po_profile_gap(profile, NAN, r) / t->scale,
                          t->smoothing.removed[k] / t->scale};
    po_csv_add_row(&rows, row, LENGTH(row));
  }
  return write_table(path, request, "smoothed profile, and what was removed from each row",
                     "those of the measured table", &rows, NULL);
}

po_status po_tables_write_staircase(const char *path, const po_request *request,
                                    const po_result *result, char *digest) {
  po_text rows = {0};
  const po_staircase *s = result->staircase.of;
  po_text_add(&rows, "control");
  add_names(&rows, ",", STEP, LENGTH(STEP));
  add_items(&rows, "displacement,", STEP, LENGTH(STEP), &PO_STEP_ROWS, s[0].step, s[0].count);
  add_items(&rows, "load,", STEP, LENGTH(STEP), &PO_STEP_ROWS, s[1].step, s[1].count);
  add_items(&rows, "spring,", STEP, LENGTH(STEP), &PO_STEP_ROWS, s[2].step, s[2].count);
  return write_table(
      path, request,
      "pull-off force and dissipated energy as functions of the preload: each row is "
      "a step, the range of greatest approaches (control displacement), loads "
      "(control load) or positions of the base approach + load/stiffness (control spring) "
      "with the same pull-off; open: the curve ends before the step",
      "approaches in epsilon, -inf for separated bodies; loads and force in pi w R; "
      "energy in pi w R epsilon, nan: unbounded",
      &rows, digest);
}

po_status po_tables_write_series(const char *path, const char *key, bool si,
                                 const po_request *first, const po_series_row *row, size_t count) {
  po_text rows = {0};
  char units[120] = "SI units: lengths in m, force in N; errors are estimated bounds";
  if (!si)
    snprintf(units, sizeof units,
             "approach and contact_radius in epsilon; force in %s; errors are estimated bounds",
             po_input_load_unit(first));
  for (const char *c = key; *c; ++c)
    po_text_add(&rows, "%c", *c == '-' ? '_' : *c);
  po_text_add(&rows, si ? ",force_n,force_error_n,approach_m,approach_error_m,contact_radius_m,"
                          "contact_radius_error_m,followed\n"
                        : ",force,force_error,approach,approach_error,contact_radius,"
                          "contact_radius_error,followed\n");
  for (size_t k = 0; k < count; ++k) {
    const po_result *o = row[k].result;
    const double force = o->has_pull_off ? row[k].unit.force : (double)NAN;
    const double length = o->has_pull_off ? row[k].unit.length : (double)NAN;
    const double values[] = {row[k].value,
                             o->pull_off.force * force,
                             o->pull_off.force_error * force,
                             o->pull_off.approach * length,
                             o->pull_off.approach_error * length,
                             o->pull_off.contact_radius * length,
                             o->pull_off.contact_radius_error * length,
                             o->followed};
    po_csv_add_row(&rows, values, sizeof values / sizeof *values);
  }
  return write_table(
      path, first, "pull-off of scenes in which one parameter varies; the command solves the first",
      units, &rows, NULL);
}

static po_status read_cell(const po_csv *csv, size_t r, size_t at, const column *c,
                           const po_row *row, char *item) {
  double value = (double)NAN;
  po_status status = PO_OK;
  if (!c->optional || strcmp(po_csv_cell(csv, r, at), "nan") != 0)
    status = po_csv_number(csv, r, at, &value);
  if (status)
    return status;
  if (row->type != PO_ROW_INTEGER)
    po_row_put(row, item, value);
  else if (value >= 0 && value <= INT_MAX && value == floor(value))
    *(int *)(void *)(item + row->offset) = (int)value;
  else
    return po_fail(PO_CANNOT_READ, "%s: %s is %g: expected a whole number", csv->path, c->name,
                   value);
  return PO_OK;
}

/* Reads a table with some columns, in any order. Returned: items, to be freed; NULL if it fails. */
static po_status read_list(const char *path, const char *digest, const column *columns,
                           size_t column_count, const po_block *block, void *items, size_t *count) {
  po_csv csv;
  po_status status = po_csv_read(path, path, &csv);
  if (status)
    return status;
  char *list = po_allocate(csv.row_count, block->size);
  if (!list)
    status = PO_NO_MEMORY;
  else if (strcmp(digest, csv.digest) != 0)
    status =
        po_fail(PO_CANNOT_READ, "%s is not the table of this record: its checksum differs", path);
  for (size_t c = 0; !status && c < column_count; ++c) {
    const int found = po_csv_find_column(&csv, columns[c].name);
    const po_row *row = po_block_find(block, NULL, columns[c].path).row;
    if (found < 0)
      status = po_fail(PO_CANNOT_READ, "%s:%zu: the column %s is missing", path, csv.column_line,
                       columns[c].name);
    for (size_t r = 0; !status && r < csv.row_count; ++r)
      status = read_cell(&csv, r, (size_t)found, &columns[c], row, list + r * block->size);
  }
  *count = status ? 0 : csv.row_count;
  po_csv_clear(&csv);
  if (status) {
    free(list);
    list = NULL;
  }
  memcpy(items, &list, sizeof list);
  return status;
}

po_status po_tables_read_curve(const char *path, const char *digest, po_result *result) {
  return read_list(path, digest, CURVE, LENGTH(CURVE), &PO_CURVE_ROWS, &result->curve,
                   &result->curve_count);
}

po_status po_tables_read_profile(const char *path, const char *digest, po_result *result) {
  return read_list(path, digest, PROFILE, LENGTH(PROFILE), &PO_PROFILE_ROWS, &result->profile,
                   &result->profile_count);
}
