#include "po_reference.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_memory.h"
#include "po_pins.h"
#include "po_reference_bradley.h"

static const char *const LEDGERS[] = {"oracle", "published", "pin"};

const char *po_ledger_name(po_ledger ledger) {
  return LEDGERS[ledger];
}

po_status po_reference_check_headers(po_reference *reference) {
  static const char *const NEEDED[] = {"what",        "source",    "kind",    "method", "units",
                                       "uncertainty", "generator", "command", "date",   "sha256"};
  const po_csv *table = &reference->table;
  for (size_t i = 0; i < sizeof NEEDED / sizeof *NEEDED; ++i) {
    const po_csv_header *header = po_csv_find_header(table, NEEDED[i]);
    if (!header)
      return po_fail(PO_CANNOT_READ, "%s:%zu: the header %s is missing: expected '# %s: ...' above",
                     table->path, table->column_line, NEEDED[i], NEEDED[i]);
    if (!*header->value)
      return po_fail(PO_CANNOT_READ, "%s:%zu: the header %s is empty", table->path, header->line,
                     NEEDED[i]);
  }
  const po_csv_header *digest = po_csv_find_header(table, "sha256");
  if (strcmp(digest->value, table->digest) != 0)
    return po_fail(PO_CANNOT_READ,
                   "%s:%zu: sha256 is %.16s...: expected %.16s..., that of all other lines "
                   "(damaged, or edited by hand)",
                   table->path, digest->line, digest->value, table->digest);
  const po_csv_header *kind = po_csv_find_header(table, "kind");
  for (unsigned i = 0; i < 3; ++i)
    if (strcmp(kind->value, LEDGERS[i]) == 0) {
      reference->ledger = (po_ledger)i;
      return PO_OK;
    }
  return po_fail(PO_CANNOT_READ, "%s:%zu: kind is %s: expected oracle, published or pin",
                 table->path, kind->line, kind->value);
}

static po_status check_selectors(const po_csv *table) {
  po_request request = po_request_default();
  for (size_t c = 0; c < table->column_count; ++c) {
    const int key = po_key_of_name(table->columns[c]);
    for (size_t r = 0; key >= 0 && r < table->row_count; ++r)
      if (!po_key_set(&request, (po_key)key, po_csv_cell(table, r, c)))
        return po_fail(PO_CANNOT_READ, "%s:%zu: %s is %s: expected %s", table->path,
                       table->lines[r], table->columns[c], po_csv_cell(table, r, c),
                       po_key_expected((po_key)key));
  }
  for (size_t i = 0; i < table->header_count; ++i) {
    const po_csv_header *header = &table->headers[i];
    const int key = po_key_of_name(header->key);
    if (key >= 0 && !po_key_set(&request, (po_key)key, header->value))
      return po_fail(PO_CANNOT_READ, "%s:%zu: %s is %s: expected %s", table->path, header->line,
                     header->key, header->value, po_key_expected((po_key)key));
  }
  return PO_OK;
}

po_status po_reference_open(const char *data_folder, const char *name, po_reference *reference) {
  *reference = (po_reference){.name = name};
  reference->is_bradley = strcmp(name, "bradley") == 0;
  reference->is_every_scene = strcmp(name, PO_EVERY_SCENE) == 0;
  reference->is_zero = strcmp(name, PO_ZERO) == 0;
  reference->is_traced = strcmp(name, PO_TRACED) == 0;
  if (reference->is_bradley || reference->is_every_scene || reference->is_zero ||
      reference->is_traced) {
    po_digest_bytes(name, strlen(name), reference->digest);
    return PO_OK;
  }
  char *path = po_path_join(data_folder, name), *bytes = NULL;
  size_t size = 0;
  po_status status = path ? po_file_read(path, &bytes, &size) : PO_NO_MEMORY;
  if (!status) {
    po_digest_bytes(bytes, size, reference->digest);
    status = po_csv_read(path, name, &reference->table);
  }
  free(bytes);
  free(path);
  if (!status)
    status = po_reference_check_headers(reference);
  if (!status)
    status = check_selectors(&reference->table);
  if (status)
    po_reference_close(reference);
  return status;
}

po_status po_reference_open_check(const char *data_folder, const po_check *check,
                                  po_reference *reference) {
  *reference = (po_reference){.name = check->reference};
  char *path = check->stand_in ? po_path_join(data_folder, check->reference) : NULL;
  if (check->stand_in && !path)
    return PO_NO_MEMORY;
  reference->is_absent = path && !po_path_exists(path);
  free(path);
  if (reference->is_absent) {
    po_digest_bytes("absent", strlen("absent"), reference->digest);
    return PO_OK;
  }
  const po_status status = po_reference_open(data_folder, check->reference, reference);
  if (status || !check->stand_in || reference->ledger == PO_LEDGER_PUBLISHED)
    return status;
  const po_csv_header *kind = po_csv_find_header(&reference->table, "kind");
  const po_status refused = po_fail(
      PO_CANNOT_READ, "%s:%zu: kind is %s: expected published, as something stands in for it",
      reference->table.path, kind->line, kind->value);
  po_reference_close(reference);
  return refused;
}

void po_reference_close(po_reference *reference) {
  po_csv_clear(&reference->table);
  free(reference->path);
  free(reference->shown);
  *reference = (po_reference){0};
}

/* Whether the headers, and the cells of a row, that name scene keys hold for a scene. */
static bool headers_hold(const po_csv *table, const po_request *request) {
  for (size_t i = 0; i < table->header_count; ++i) {
    const int key = po_key_of_name(table->headers[i].key);
    if (key >= 0 && !po_key_matches(request, (po_key)key, table->headers[i].value))
      return false;
  }
  return true;
}

static bool row_holds(const po_csv *table, size_t row, const po_request *request) {
  for (size_t c = 0; c < table->column_count; ++c) {
    const int key = po_key_of_name(table->columns[c]);
    if (key >= 0 && !po_key_matches(request, (po_key)key, po_csv_cell(table, row, c)))
      return false;
  }
  return true;
}

static po_status need_column(const po_csv *table, const char *name, size_t *column) {
  const int found = po_csv_find_column(table, name);
  if (found < 0)
    return po_fail(PO_CANNOT_READ, "%s:%zu: the column %s is missing", table->path,
                   table->column_line, name);
  *column = (size_t)found;
  return PO_OK;
}

/* The uncertainty of a cell: column `name`, else column uncertainty, else that header as a number.
 */
static po_status uncertainty_of(const po_csv *table, size_t row, const char *name, double *value) {
  *value = (double)NAN;
  int column = po_csv_find_column(table, name);
  if (column < 0)
    column = po_csv_find_column(table, "uncertainty");
  if (column >= 0) {
    const po_status status = po_csv_number(table, row, (size_t)column, value);
    if (!status && *value < 0)
      return po_fail(PO_CANNOT_READ, "%s:%zu: %s is negative: expected a number >= 0", table->path,
                     table->lines[row], table->columns[column]);
    return status;
  }
  const po_csv_header *header = po_csv_find_header(table, "uncertainty");
  double number = 0;
  if (po_number_parse(header->value, &number))
    *value = number;
  return PO_OK;
}

bool po_reference_row_is_of(const po_reference *reference, size_t row, const po_request *request) {
  return headers_hold(&reference->table, request) && row_holds(&reference->table, row, request);
}

po_status po_reference_cell(const po_reference *reference, size_t row, const char *name,
                            po_reference_number *number) {
  char doubt[64];
  size_t column = 0;
  po_status status = need_column(&reference->table, name, &column);
  if (!status)
    status = po_csv_number(&reference->table, row, column, &number->value);
  snprintf(doubt, sizeof doubt, "%s_uncertainty", name);
  return status ? status : uncertainty_of(&reference->table, row, doubt, &number->uncertainty);
}

/* The column of a number that a scene has one of. */
static const char *column_of(po_quantity quantity) {
  if (quantity == PO_HYSTERESIS_LOSS)
    return "energy_lost";
  if (quantity == PO_PULL_OFF_ANY)
    return "force";
  return quantity == PO_PULL_OFF_FORCE || quantity == PO_HYSTERESIS_FORCE ? "force" : "approach";
}

/* A table without a column contact_radius may have that column instead: smooth spheres on the
 * unbounded half-space differ by the root of their radius alone. */
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
  for (size_t row = 0; row < table->row_count; ++row)
    if (po_reference_row_is_of(reference, row, request)) {
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
             : po_reference_cell(reference, at, column_of(quantity), number);
}

po_status po_reference_find(const po_reference *reference, po_quantity quantity,
                            const po_request *request, po_reference_number *number) {
  if (reference->is_bradley)
    return po_bradley_find(quantity, request, number);
  if (reference->is_zero) {
    *number = (po_reference_number){0};
    return PO_OK;
  }
  if (reference->is_pin)
    return po_pins_find(reference, quantity, request, number);
  return find_single(reference, quantity, request, number);
}

static po_status read_kind(const po_csv *table, size_t row, size_t column, po_special_kind *kind) {
  const char *text = po_csv_cell(table, row, column);
  for (int k = PO_JUMP_IN; k <= PO_MAXIMUM; ++k)
    if (strcmp(text, po_special_kind_name((po_special_kind)k)) == 0) {
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

/* One row as a point; *fits is false when it is a special point of the other sort. */
static po_status read_point(const po_csv *table, size_t row, po_quantity quantity,
                            po_reference_point *point, bool *fits) {
  size_t approach = 0, load = 0, kind = 0;
  po_status status = need_column(table, "approach", &approach);
  if (!status)
    status = need_column(table, "load", &load);
  if (!status && quantity != PO_CURVE)
    status = need_column(table, "kind", &kind);
  if (!status && quantity != PO_CURVE)
    status = read_kind(table, row, kind, &point->kind);
  if (!status)
    status = po_csv_number(table, row, approach, &point->approach);
  if (!status)
    status = po_csv_number(table, row, load, &point->load);
  if (!status)
    status = uncertainty_of(table, row, "approach_uncertainty", &point->approach_uncertainty);
  if (!status)
    status = uncertainty_of(table, row, "load_uncertainty", &point->load_uncertainty);
  *fits = !status && (quantity == PO_CURVE || kind_fits(quantity, point->kind));
  return status;
}

po_status po_reference_points(const po_reference *reference, po_quantity quantity,
                              const po_request *request, const po_result *result,
                              po_reference_point **points, size_t *count) {
  *points = NULL;
  *count = 0;
  if (reference->is_bradley)
    return po_bradley_points(quantity, request, result, points, count);
  if (reference->is_pin)
    return po_pins_points(reference, quantity, request, points, count);
  const po_csv *table = &reference->table;
  if (!headers_hold(table, request))
    return PO_NOT_FOUND;
  po_reference_point *list = po_allocate(table->row_count, sizeof *list);
  po_status status = list ? PO_OK : PO_NO_MEMORY;
  size_t rows = 0, kept = 0;
  for (size_t row = 0; !status && row < table->row_count; ++row) {
    bool fits = false;
    if (!row_holds(table, row, request))
      continue;
    rows += 1;
    status = read_point(table, row, quantity, &list[kept], &fits);
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
  const int column = reference->is_bradley ? -1 : po_csv_find_column(table, "complete_to");
  for (size_t row = 0; column >= 0 && row < table->row_count; ++row)
    if (row_holds(table, row, request))
      return po_csv_number(table, row, (size_t)column, approach);
  return PO_OK;
}
