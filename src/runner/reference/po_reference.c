#include "po_reference.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_law.h"
#include "po_memory.h"
#include "po_number.h"
#include "po_si.h"
#include "po_wavy_rigid.h"

/* The closed form of the rigid smooth sphere as a reference. It applies to smooth scenes with the
 * law of the paper and an unbounded surface, whatever their Tabor parameter; the tolerance of the
 * check must include the effect of elasticity. */

/* Distance between points of the sampled curve near contact, in the plane of approach and load. The
 * least radius of curvature is 1/32, at the minimum, so that a cubic through the points is accurate
 * to 1e-8. Far from contact the curvature decreases as x^-4, and the distance grows by x^2 / FAR.
 */
static const double SPACING = 0.002;
static const double FAR = 2;

/* The curve ends at this approach; beyond it the load is far larger than in any contact test. */
static const double LARGEST_APPROACH = 0.45;

static bool applies_to(const po_request *request) {
  return po_law_index(&request->scene.law) == 0 && po_scene_is_of_paper(&request->scene) &&
         request->scene.amplitude == 0 && isinf(request->scene.outer_radius);
}

static po_status find_bradley(po_quantity quantity, const po_request *request,
                              po_reference_number *number) {
  if (!applies_to(request))
    return PO_NOT_FOUND;
  /* The minimum of the load is -2, at approach 0. The load is a function of the approach, so there
   * is no fold. At the contact edge the parabola r^2/(2 R) equals the gap of the greatest tension.
   */
  *number = (po_reference_number){.uncertainty = 0};
  if (quantity == PO_PULL_OFF_FORCE)
    number->value = 2;
  if (quantity == PO_CONTACT_RADIUS)
    number->value =
        sqrt(2 * request->scene.radius * po_law_numbers_of(&request->scene.law)->peak_gap);
  return PO_OK;
}

static po_special_point point_at(double approach) {
  const double x = 1 - approach, x4 = x * x * (x * x);
  const double larger_term = fmax(8 / (3 * x * x), 2 / (3 * x4 * x4));
  return (po_special_point){.approach = approach,
                            .load = po_bradley_load(approach),
                            .load_error = 4 * DBL_EPSILON * larger_term};
}

/* Returned: the approach of the next point, at the distance described at SPACING. */
static double step_from(double approach) {
  const double h = 1e-6;
  const double slope = (po_bradley_load(approach + h) - po_bradley_load(approach - h)) / (2 * h);
  const double x = 1 - approach;
  return approach + SPACING * fmax(1, x * x / FAR) / sqrt(1 + slope * slope);
}

static po_status sample(double start, double end, po_special_point **points, size_t *count) {
  size_t room = 0;
  for (double approach = start;; approach = fmin(step_from(approach), end)) {
    po_special_point *larger = po_grow(*points, *count, &room, sizeof *larger);
    if (!larger)
      return PO_NO_MEMORY;
    *points = larger;
    larger[(*count)++] = point_at(approach);
    if (approach >= end)
      return PO_OK;
  }
}

static po_status bradley_points(po_quantity quantity, const po_request *request,
                                const po_result *result, po_special_point **points, size_t *count) {
  if (!applies_to(request))
    return PO_NOT_FOUND;
  if (quantity == PO_CURVE && result && result->curve_count)
    return sample(fmin(result->curve[0].approach, LARGEST_APPROACH),
                  fmin(result->curve[result->curve_count - 1].approach, LARGEST_APPROACH), points,
                  count);
  *points = po_allocate(1, sizeof **points);
  if (!*points)
    return PO_NO_MEMORY;
  if (quantity == PO_EXTREMA) {
    **points = (po_special_point){.approach = 0, .load = -2, .kind = PO_MINIMUM};
    *count = 1;
  }
  return PO_OK;
}

/* The cell of a row whose scene does not have the key: the row applies to no scene of the program.
 */
static const char NO_VALUE[] = "-";

/* Checks the values of the columns and headers that have the name of a scene key. */
static po_status check_selectors(const po_csv *table) {
  po_request request = po_request_default();
  for (size_t c = 0; c < table->column_count; ++c) {
    const int key = po_key_of_name(table->columns[c]);
    for (size_t r = 0; key >= 0 && r < table->row_count; ++r)
      if (strcmp(po_csv_cell(table, r, c), NO_VALUE) != 0 &&
          !po_key_is_identity(key, po_csv_cell(table, r, c)) &&
          !po_key_set(&request, key, po_csv_cell(table, r, c)))
        return po_fail(PO_CANNOT_READ, "%s:%zu: %s is %s: expected %s", table->path,
                       table->lines[r], table->columns[c], po_csv_cell(table, r, c),
                       PO_KEYS[key].expected);
  }
  for (size_t i = 0; i < table->header_count; ++i) {
    const po_csv_header *header = &table->headers[i];
    const int key = po_key_of_name(header->key);
    if (key >= 0 && !po_key_is_identity(key, header->value) &&
        !po_key_set(&request, key, header->value))
      return po_fail(PO_CANNOT_READ, "%s:%zu: %s is %s: expected %s", table->path, header->line,
                     header->key, header->value, PO_KEYS[key].expected);
  }
  return PO_OK;
}

static bool ends_with(const char *name, size_t length, const char *end) {
  return length >= strlen(end) && strncmp(name + length - strlen(end), end, strlen(end)) == 0;
}

/* Reports whether checks read numbers from a column, in SI units or without a unit. */
static bool is_read(const char *name) {
  size_t length = strlen(name), stem = 0;
  po_dimension dimension;
  double size = 0;
  if (po_si_parse(name, &stem, &dimension, &size))
    length = stem;
  static const char *const LOADS[] = {"load", "load_before", "load_after"};
  enum { LOAD_COUNT = sizeof LOADS / sizeof *LOADS };
  bool known = ends_with(name, length, "uncertainty");
  for (int k = 0; k < PO_QUANTITY_COUNT + LOAD_COUNT; ++k) {
    const char *of = k < LOAD_COUNT ? LOADS[k] : PO_QUANTITIES[k - LOAD_COUNT].column;
    known = known || (strlen(of) == length && strncmp(name, of, length) == 0);
  }
  return known;
}

/* Checks the cells of a column that is no key of a scene. */
static po_status check_column(const po_csv *table, size_t column) {
  const bool read = is_read(table->columns[column]);
  bool numbers = read;
  double value = 0;
  for (size_t row = 0; row < table->row_count; ++row)
    numbers = numbers || po_number_parse(po_csv_cell(table, row, column), &value);
  for (size_t row = 0; numbers && row < table->row_count; ++row) {
    const char *cell = po_csv_cell(table, row, column);
    const bool none =
        strcmp(cell, "inf") == 0 || strcmp(cell, "-inf") == 0 || strcmp(cell, NO_VALUE) == 0;
    const po_status status = !read && none ? PO_OK : po_csv_number(table, row, column, &value);
    if (status)
      return status;
  }
  return PO_OK;
}

po_status po_reference_check_cells(const po_reference *reference) {
  const po_csv *table = &reference->table;
  po_status status = check_selectors(table);
  for (size_t c = 0; !status && c < table->column_count; ++c)
    if (po_key_of_name(table->columns[c]) < 0)
      status = check_column(table, c);
  return status;
}

/* Between the path of a table and the name of a row. */
static const char MARK = '#';

po_file_path po_reference_file(const char *name) {
  po_file_path path = po_path_join("", name);
  char *mark = strchr(path.text, MARK);
  if (mark)
    *mark = '\0';
  return path;
}

static po_status check_row(const po_reference *reference) {
  const po_request any = po_request_default();
  size_t row = 0;
  if (po_reference_next_row(reference, &any, &row))
    return PO_OK;
  return po_fail(PO_CANNOT_READ,
                 "%s:%zu: no row %s: expected PROBLEM:QUANTITY of the columns problem and quantity",
                 reference->table.path, reference->table.column_line, reference->row);
}

po_status po_reference_open(const char *data_folder, const char *name, po_reference *reference) {
  *reference = (po_reference){.name = name, .type = po_reference_type_of(name)};
  const char *mark = strchr(name, MARK);
  if (reference->type != PO_REFERENCE_TABLE) {
    po_digest_bytes(name, strlen(name), reference->digest);
    return PO_OK;
  }
  const po_file_path file = po_reference_file(name);
  reference->row = mark ? mark + 1 : NULL;
  po_status status =
      po_reference_read(po_path_join(data_folder, file.text).text, file.text, reference);
  if (!status)
    status = reference->row ? check_row(reference) : check_selectors(&reference->table);
  if (status)
    po_reference_close(reference);
  return status;
}

/* A table without a column contact_radius may have this column instead. The contact radius of a
 * smooth sphere on the unbounded half-space is proportional to the square root of the radius of the
 * sphere. */
static const char PER_ROOT_RADIUS[] = "contact_radius_over_root_radius";

static po_status contact_radius_of(const po_reference *reference, size_t row,
                                   const po_request *request, po_reference_number *number) {
  const char *name = "contact_radius";
  double unit = 1;
  if (po_csv_find_column(&reference->table, name) < 0 &&
      po_csv_find_column(&reference->table, PER_ROOT_RADIUS) >= 0) {
    name = PER_ROOT_RADIUS;
    unit = sqrt(request->scene.radius);
  }
  const po_status status = po_reference_cell(reference, row, name, number);
  number->value *= unit;
  number->uncertainty *= unit;
  return status;
}

static po_status find_single(const po_reference *reference, po_quantity quantity,
                             const po_request *request, po_reference_number *number) {
  const po_csv *table = &reference->table;
  size_t found = 0, at = 0;
  for (size_t row = 0; po_reference_next_row(reference, request, &row); ++row) {
    at = row;
    found += 1;
  }
  if (found > 1)
    return po_fail(PO_CANNOT_READ, "%s:%zu: a second row for the same scene: expected one",
                   table->path, table->lines[at]);
  if (!found)
    return PO_NOT_FOUND;
  return quantity == PO_CONTACT_RADIUS
             ? contact_radius_of(reference, at, request, number)
             : po_reference_cell(reference, at, PO_QUANTITIES[quantity].column, number);
}

po_status po_reference_find(const po_reference *reference, po_quantity quantity,
                            const po_request *request, po_reference_number *number) {
  switch (reference->type) {
  case PO_REFERENCE_BRADLEY:
    return find_bradley(quantity, request, number);
  case PO_REFERENCE_ZERO:
    *number = (po_reference_number){0};
    return PO_OK;
  default:
    return find_single(reference, quantity, request, number);
  }
}

static po_status read_kind(const po_csv *table, size_t row, po_special_kind *kind) {
  const int column = po_csv_find_column(table, "kind");
  if (column < 0)
    return po_fail(PO_CANNOT_READ, "%s:%zu: the column kind is missing", table->path,
                   table->column_line);
  const char *text = po_csv_cell(table, row, (size_t)column);
  for (int k = PO_JUMP_IN; k <= PO_MAXIMUM; ++k)
    if (strcmp(text, PO_SPECIAL_KINDS[k]) == 0) {
      *kind = (po_special_kind)k;
      return PO_OK;
    }
  return po_fail(PO_CANNOT_READ,
                 "%s:%zu: kind is %s: expected jump_in, jump_out, minimum or maximum", table->path,
                 table->lines[row], text);
}

static bool kind_fits(po_quantity quantity, po_special_kind kind) {
  const bool is_fold = kind == PO_JUMP_IN || kind == PO_JUMP_OUT;
  return quantity == PO_FOLDS ? is_fold : !is_fold;
}

/* Reads a row as a point of the curve or as a special point. Returned: in *fits, whether the point
 * belongs to `quantity`; a table of special points may hold both folds and extrema. Status:
 * PO_CANNOT_READ (a column is missing or does not hold a number). */
static po_status row_point(const po_reference *reference, size_t row, po_quantity quantity,
                           po_special_point *point, bool *fits) {
  po_reference_number approach, load;
  po_status status = po_reference_cell(reference, row, "approach", &approach);
  if (!status)
    status = po_reference_cell(reference, row, "load", &load);
  if (status)
    return status;
  *point = (po_special_point){.approach = approach.value,
                              .load = load.value,
                              .approach_error = approach.uncertainty,
                              .load_error = load.uncertainty};
  if (quantity != PO_CURVE)
    status = read_kind(&reference->table, row, &point->kind);
  *fits = !status && (quantity == PO_CURVE || kind_fits(quantity, point->kind));
  return status;
}

po_status po_reference_points(const po_reference *reference, po_quantity quantity,
                              const po_request *request, const po_result *result,
                              po_special_point **points, size_t *count) {
  *points = NULL;
  *count = 0;
  if (reference->type == PO_REFERENCE_BRADLEY)
    return bradley_points(quantity, request, result, points, count);
  po_special_point *list = po_allocate(reference->table.row_count, sizeof *list);
  po_status status = list ? PO_OK : PO_NO_MEMORY;
  size_t rows = 0, kept = 0;
  for (size_t row = 0; !status && po_reference_next_row(reference, request, &row); ++row) {
    bool fits = false;
    rows += 1;
    status = row_point(reference, row, quantity, &list[kept], &fits);
    kept += fits;
  }
  if (!status && rows == 0)
    status = PO_NOT_FOUND;
  if (status) {
    free(list);
    return status;
  }
  *points = list;
  *count = kept;
  return PO_OK;
}

po_status po_reference_complete_to(const po_reference *reference, const po_request *request,
                                   double *approach) {
  *approach = (double)INFINITY;
  const po_csv *table = &reference->table;
  const int column = po_csv_find_column(table, "complete_to");
  size_t row = 0;
  return column >= 0 && po_reference_next_row(reference, request, &row)
             ? po_csv_number(table, row, (size_t)column, approach)
             : PO_OK;
}
