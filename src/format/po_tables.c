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
#include "po_si.h"

/* A column of a table, and the path of its number in the items of a list. */
typedef struct {
  const char *name, *path;
  bool optional; /* the curve of an external solver does not have it: nan */
  bool metric;   /* in the metric of the solver, which has no SI unit: not in tables in SI units */
} column;
#define LENGTH(list) (sizeof(list) / sizeof *(list))

static const column CURVE[] = {{"position", "position", false, true},
                               {"approach", "approach", false},
                               {"load", "load", false},
                               {"energy", "energy", true},
                               {"contact_radius", "contact_radius", true},
                               {"approach_rate", "approach_rate", true, true},
                               {"load_rate", "load_rate", true, true},
                               {"unstable_modes", "unstable_modes", false},
                               {"energy_error", "energy_error_estimate", true},
                               {"unstable_modes_at_base", "unstable_modes_at_base", true}};

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

/* The columns of a table of a request, and their block. */
typedef struct {
  const column *column;
  size_t count;
  const po_block *block;
  const po_request *request;
} layout;
#define LAYOUT(columns, block, request) ((layout){columns, LENGTH(columns), &(block), request})

/* Whether a table has a column. In SI units, *unit is that of its numbers. */
static bool has_column(const layout *l, size_t c, po_si_unit *unit) {
  const po_row *row = po_block_find(l->block, NULL, l->column[c].path).row;
  *unit = (po_si_unit){.factor = 1};
  if (!l->request->in_si)
    return true;
  if (row->type == PO_ROW_NUMBER)
    *unit = po_si_prefixed(&l->request->units, row->dimension);
  return !l->column[c].metric;
}

static void add_names(po_text *rows, const char *before, const layout *l) {
  po_si_unit unit;
  for (size_t c = 0; c < l->count; ++c)
    if (has_column(l, c, &unit)) {
      po_text_add(rows, "%s%s%s%s", before, l->column[c].name, *unit.name ? "_" : "", unit.name);
      before = ",";
    }
  po_text_add(rows, "\n");
}

/* Adds a row for each item of a list, which begins with a text. */
static void add_items(po_text *rows, const char *before, const layout *l, const void *list,
                      size_t items) {
  double row[MOST_COLUMNS];
  for (size_t i = 0; i < items; ++i) {
    size_t used = 0;
    po_si_unit unit;
    for (size_t c = 0; c < l->count; ++c)
      if (has_column(l, c, &unit))
        row[used++] =
            po_si_value(&unit, po_block_number(l->block, (const char *)list + i * l->block->size,
                                               l->column[c].path));
    po_text_add(rows, "%s", before);
    po_csv_add_row(rows, row, used);
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
  po_text header = {0}, text = {0};
  po_text_add(&header, "# what: %s\n# units: %s\n# command: ", what, units);
  po_input_add_command(request, &header);
  po_text_add(&header, "\n");
  po_csv_seal(&header, rows, &text, own);
  const po_status status = text.failed ? PO_NO_MEMORY : write_text(path, &text);
  if (digest)
    memcpy(digest, own, sizeof own);
  po_text_clear(rows);
  po_text_clear(&header);
  po_text_clear(&text);
  return status;
}

po_status po_tables_write_curve(const char *path, const po_request *request,
                                const po_result *result, char *digest) {
  po_text rows = {0};
  layout l = LAYOUT(CURVE, PO_CURVE_ROWS, request);
  l.count -= isnan(request->stiffness) ? 1 : 0; /* the last column is of a spring */
  add_names(&rows, "", &l);
  add_items(&rows, "", &l, result->curve, result->curve_count);
  return write_table(
      path, request, "load against approach along the branch",
      request->in_si ? "SI, at the end of the name of each column; load compressive > 0; the "
                       "derivative of the energy by the approach is the load; energy_error: "
                       "bound of its error at this approach, nan: not estimated"
                     : "approach and contact_radius in epsilon; load in pi w R, compressive > 0; "
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
  const layout l = LAYOUT(PROFILE, PO_PROFILE_ROWS, request);
  const po_si_unit length = request->in_si ? po_si_prefixed(&request->units, PO_DIMENSION_LENGTH)
                                           : (po_si_unit){.factor = 1};
  po_number_print(result->profile_approach * length.factor, approach);
  snprintf(what, sizeof what, "gap and traction over the radius at approach %s%s%s", approach,
           request->in_si ? " " : "", length.text);
  add_names(&rows, "", &l);
  add_items(&rows, "", &l, result->profile, result->profile_count);
  return write_table(
      path, request, what,
      request->in_si ? "SI, at the end of the name of each column; gap: distance of the "
                       "surfaces; traction compressive > 0"
                     : "radius and approach in epsilon; gap H = h/epsilon - 1; traction P = p mu "
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
  const layout l = LAYOUT(STEP, PO_STEP_ROWS, request);
  po_text_add(&rows, "control");
  add_names(&rows, ",", &l);
  add_items(&rows, "displacement,", &l, s[0].step, s[0].count);
  add_items(&rows, "load,", &l, s[1].step, s[1].count);
  add_items(&rows, "spring,", &l, s[2].step, s[2].count);
  return write_table(
      path, request,
      "pull-off force and dissipated energy as functions of the preload: each row is "
      "a step, the range of greatest approaches (control displacement), loads "
      "(control load) or positions of the base approach + load/stiffness (control spring) "
      "with the same pull-off; open: the curve ends before the step",
      request->in_si
          ? "SI, at the end of the name of each column; approaches -inf for separated bodies; "
            "energy "
            "nan: unbounded"
          : "approaches in epsilon, -inf for separated bodies; loads and force in pi w R; "
            "energy in pi w R epsilon, nan: unbounded",
      &rows, digest);
}

po_status po_tables_write_series(const char *path, const char *key, const double *values,
                                 const po_request *requests, const po_result *results,
                                 size_t count) {
  const po_request *first = &requests[0];
  static const char *const COLUMNS[] = {"force", "approach", "contact_radius"};
  static const po_dimension DIMENSIONS[] = {PO_DIMENSION_LOAD, PO_DIMENSION_LENGTH,
                                            PO_DIMENSION_LENGTH};
  po_text rows = {0};
  char units[120] = "SI, at the end of the name of each column; errors are estimated bounds";
  double factor[LENGTH(COLUMNS)] = {1, 1, 1}; /* from SI units to those of the columns */
  if (!first->in_si)
    snprintf(units, sizeof units,
             "approach and contact_radius in epsilon; force in %s; errors are estimated bounds",
             po_input_load_unit(first));
  for (const char *c = key; *c; ++c)
    po_text_add(&rows, "%c", *c == '-' ? '_' : *c);
  for (size_t c = 0; c < LENGTH(COLUMNS); ++c) {
    po_si_unit unit = {.factor = 1};
    if (first->in_si) {
      unit = po_si_prefixed(&first->units, DIMENSIONS[c]);
      factor[c] = unit.factor / po_si_unit_of(&first->units, DIMENSIONS[c]).factor;
    }
    const char *between = first->in_si ? "_" : "";
    po_text_add(&rows, ",%s%s%s,%s_error%s%s", COLUMNS[c], between, unit.name, COLUMNS[c], between,
                unit.name);
  }
  po_text_add(&rows, ",followed\n");
  for (size_t k = 0; k < count; ++k) {
    const po_result *o = &results[k];
    const po_units unit = first->in_si ? requests[k].units : (po_units){.length = 1, .force = 1};
    const double none = o->has_pull_off ? 1.0 : (double)NAN;
    const double force = unit.force * factor[0] * none;
    const double approach = unit.length * factor[1] * none;
    const double radius = unit.length * factor[2] * none;
    const double row[] = {values[k],
                          o->pull_off.force * force,
                          o->pull_off.force_error * force,
                          o->pull_off.approach * approach,
                          o->pull_off.approach_error * approach,
                          o->pull_off.contact_radius * radius,
                          o->pull_off.contact_radius_error * radius,
                          o->followed};
    po_csv_add_row(&rows, row, LENGTH(row));
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
  return read_list(path, digest, CURVE, LENGTH(CURVE) - 1, &PO_CURVE_ROWS, &result->curve,
                   &result->curve_count);
}

po_status po_tables_read_profile(const char *path, const char *digest, po_result *result) {
  return read_list(path, digest, PROFILE, LENGTH(PROFILE), &PO_PROFILE_ROWS, &result->profile,
                   &result->profile_count);
}
