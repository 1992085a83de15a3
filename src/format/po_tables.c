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

enum { CURVE_COLUMNS = 9 };

static const char *const CURVE_NAMES[CURVE_COLUMNS] = {
    "position",      "approach",  "load",           "energy",      "contact_radius",
    "approach_rate", "load_rate", "unstable_modes", "energy_error"};

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
  for (size_t c = 0; c < CURVE_COLUMNS; ++c)
    po_text_add(&rows, "%s%s", c ? "," : "", CURVE_NAMES[c]);
  po_text_add(&rows, "\n");
  for (size_t i = 0; i < result->curve_count; ++i) {
    const po_curve_point *p = &result->curve[i];
    const double row[CURVE_COLUMNS] = {
        p->position,       p->approach,      p->load,      p->energy,
        p->contact_radius, p->approach_rate, p->load_rate, (double)p->unstable_modes,
        p->energy_error};
    po_csv_add_row(&rows, row, CURVE_COLUMNS);
  }
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
  po_text_add(&rows, "radius,gap,traction\n");
  for (size_t i = 0; i < result->profile_count; ++i) {
    const po_profile_point *p = &result->profile[i];
    po_csv_add_row(&rows, (const double[]){p->radius, p->gap, p->traction}, 3);
  }
  return write_table(path, request, what,
                     "radius and approach in epsilon; gap H = h/epsilon - 1; traction P = p mu "
                     "epsilon/w, compressive > 0",
                     &rows, digest);
}

static void add_steps(po_text *rows, const char *control, const po_staircase *s) {
  for (size_t k = 0; k < s->count; ++k) {
    const po_step *step = &s->step[k];
    const po_cycle *cycle = &step->cycle[0];
    const bool lost = isfinite(cycle->loss.energy);
    /* if the step is open, `until` is the last state of loading on the curve; separated bodies have
     * the approach -inf */
    const double row[] = {step->preload.approach,
                          step->preload.load,
                          step->until.approach,
                          step->until.load,
                          (double)step->open,
                          -step->pull_off.load,
                          step->pull_off_error.load,
                          step->pull_off.approach,
                          step->pull_off_error.approach,
                          lost ? cycle->loss.energy : (double)NAN,
                          lost ? cycle->energy_error : (double)NAN};
    po_text_add(rows, "%s,", control);
    po_csv_add_row(rows, row, sizeof row / sizeof *row);
  }
}

po_status po_tables_write_staircase(const char *path, const po_request *request,
                                    const po_result *result, char *digest) {
  po_text rows = {0};
  po_text_add(&rows, "control,from_approach,from_load,until_approach,until_load,open,force,"
                     "force_error,approach,approach_error,energy_lost,energy_lost_error\n");
  add_steps(&rows, "displacement", &result->staircase[0]);
  add_steps(&rows, "load", &result->staircase[1]);
  return write_table(
      path, request,
      "pull-off force and dissipated energy as functions of the preload: each row is "
      "a step, the range of greatest approaches (control displacement) or loads "
      "(control load) with the same pull-off; open: the curve ends before the step",
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

/* Reads a table with the columns `names`, in any order. Returned: *values, *rows x count, stored
 * row by row in the order of `names`, to be freed. */
/* Reports whether a cell says that a number is unknown: the curve of an external solver has neither
 * energies nor contact radii nor rates. */
static bool is_unknown(const char *column, const char *cell) {
  return strcmp(cell, "nan") == 0 &&
         (strcmp(column, "energy") == 0 || strcmp(column, "energy_error") == 0 ||
          strcmp(column, "contact_radius") == 0 || strcmp(column, "approach_rate") == 0 ||
          strcmp(column, "load_rate") == 0);
}

static po_status read_numbers(const char *path, const char *digest, const char *const *names,
                              size_t count, double **values, size_t *rows) {
  po_csv csv;
  po_status status = po_csv_read(path, path, &csv);
  if (status)
    return status;
  *rows = csv.row_count;
  *values = po_allocate(csv.row_count * count, sizeof **values);
  if (!*values)
    status = PO_NO_MEMORY;
  else if (strcmp(digest, csv.digest) != 0)
    status =
        po_fail(PO_CANNOT_READ, "%s is not the table of this record: its checksum differs", path);
  for (size_t c = 0; !status && c < count; ++c) {
    const int column = po_csv_find_column(&csv, names[c]);
    if (column < 0)
      status = po_fail(PO_CANNOT_READ, "%s:%zu: the column %s is missing", path, csv.column_line,
                       names[c]);
    for (size_t r = 0; !status && r < csv.row_count; ++r) {
      double *value = &(*values)[r * count + c];
      if (is_unknown(names[c], po_csv_cell(&csv, r, (size_t)column)))
        *value = (double)NAN;
      else
        status = po_csv_number(&csv, r, (size_t)column, value);
    }
  }
  po_csv_clear(&csv);
  if (status) {
    free(*values);
    *values = NULL;
  }
  return status;
}

po_status po_tables_read_curve(const char *path, const char *digest, po_result *result) {
  double *values = NULL;
  size_t rows = 0;
  po_status status = read_numbers(path, digest, CURVE_NAMES, CURVE_COLUMNS, &values, &rows);
  if (!status && !(result->curve = po_allocate(rows, sizeof *result->curve)))
    status = PO_NO_MEMORY;
  for (size_t i = 0; !status && i < rows; ++i) {
    const double *v = values + CURVE_COLUMNS * i;
    if (!(v[7] >= 0 && v[7] <= INT_MAX && v[7] == floor(v[7]))) {
      status =
          po_fail(PO_CANNOT_READ, "%s: unstable_modes is %g: expected a whole number", path, v[7]);
      break;
    }
    result->curve[i] = (po_curve_point){.position = v[0],
                                        .approach = v[1],
                                        .load = v[2],
                                        .energy = v[3],
                                        .contact_radius = v[4],
                                        .approach_rate = v[5],
                                        .load_rate = v[6],
                                        .unstable_modes = (int)v[7],
                                        .energy_error = v[8]};
    result->curve_count = rows;
  }
  free(values);
  return status;
}

po_status po_tables_read_profile(const char *path, const char *digest, po_result *result) {
  static const char *const NAMES[] = {"radius", "gap", "traction"};
  double *values = NULL;
  size_t rows = 0;
  po_status status = read_numbers(path, digest, NAMES, 3, &values, &rows);
  if (!status && !(result->profile = po_allocate(rows, sizeof *result->profile)))
    status = PO_NO_MEMORY;
  for (size_t i = 0; !status && i < rows; ++i) {
    result->profile[i] = (po_profile_point){values[3 * i], values[3 * i + 1], values[3 * i + 2]};
    result->profile_count = rows;
  }
  free(values);
  return status;
}
