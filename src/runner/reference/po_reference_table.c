#include "po_reference.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_number.h"
#include "po_si.h"
#include "po_text.h"

const char *const PO_LEDGERS[] = {"oracle", "published"};

/* Checks that headers are there; the message names all that are not. */
static po_status check_needed(const po_csv *table, const char *const *needed, size_t count) {
  po_text missing = {0};
  size_t lacking = 0;
  const char *one = "";
  for (size_t i = 0; i < count; ++i) {
    const po_csv_header *header = po_csv_find_header(table, needed[i]);
    if (header && !*header->value) {
      po_text_clear(&missing);
      return po_fail(PO_CANNOT_READ, "%s:%zu: the header %s is empty", table->path, header->line,
                     needed[i]);
    }
    if (header)
      continue;
    po_text_add(&missing, "%s%s", lacking++ ? ", " : "", needed[i]);
    one = needed[i];
  }
  po_status status = PO_OK;
  if (lacking == 1)
    status = po_fail(PO_CANNOT_READ, "%s:%zu: the header %s is missing: expected '# %s: ...' above",
                     table->path, table->column_line, one, one);
  else if (lacking)
    status = po_fail(PO_CANNOT_READ,
                     "%s:%zu: %zu headers are missing: expected lines '# KEY: ...' above for %s; "
                     "pulloff seal adds them",
                     table->path, table->column_line, lacking, po_text_string(&missing));
  po_text_clear(&missing);
  return status;
}

static po_status check_headers(po_reference *reference) {
  static const char *const NEEDED[] = {"what",        "source",    "kind",    "method", "units",
                                       "uncertainty", "generator", "command", "date",   "sha256"};
  const po_csv *table = &reference->table;
  po_status status = check_needed(table, NEEDED, sizeof NEEDED / sizeof *NEEDED);
  if (!status)
    status = po_csv_check_seal(table);
  if (status)
    return status;
  const po_csv_header *kind = po_csv_find_header(table, "kind");
  for (unsigned i = 0; i < 2; ++i)
    if (strcmp(kind->value, PO_LEDGERS[i]) == 0) {
      reference->ledger = (po_ledger)i;
      return PO_OK;
    }
  return po_fail(PO_CANNOT_READ, "%s:%zu: kind is %s: expected oracle or published", table->path,
                 kind->line, kind->value);
}

po_status po_reference_read(const char *path, const char *shown, po_reference *reference) {
  char *bytes = NULL;
  size_t size = 0;
  po_status status = po_file_read(path, &bytes, &size);
  if (!status) {
    po_digest_bytes(bytes, size, reference->digest);
    status = po_csv_read(path, shown, &reference->table);
  }
  free(bytes);
  return status ? status : check_headers(reference);
}

void po_reference_close(po_reference *reference) {
  po_csv_clear(&reference->table);
  free(reference->converted);
  *reference = (po_reference){0};
}

static bool names(const po_csv *table, po_key key) {
  return po_csv_find_column(table, PO_KEYS[key].name) >= 0 ||
         po_csv_find_header(table, PO_KEYS[key].name);
}

/* A table without a key law is valid for the law of the paper only, one without a profile for the
 * sphere only, one without waves for at most one wave, one without a material for elastic bodies,
 * and one without a speed of loading for slow loading. */
static bool is_possible(const po_csv *table, const po_request *request) {
  const po_scene *scene = &request->scene;
  return (names(table, PO_KEY_LAW) || po_key_matches(request, PO_KEY_LAW, "lennard-jones")) &&
         (names(table, PO_KEY_PROFILE) || names(table, PO_KEY_PROFILE_FILE) ||
          po_profile_is_sphere(&scene->profile)) &&
         (names(table, PO_KEY_WAVES) || po_scene_waves(scene) < 2) &&
         (names(table, PO_KEY_VISCOELASTIC) || request->creep.kind == PO_CREEP_NONE) &&
         (names(table, PO_KEY_LOAD_SPEED) || !(request->load_speed > 0.0));
}

/* Reports whether all headers that are keys of the scene have the values of a scene. */
static bool headers_hold(const po_csv *table, const po_request *request) {
  if (!is_possible(table, request))
    return false;
  for (size_t i = 0; i < table->header_count; ++i) {
    const int key = po_key_of_name(table->headers[i].key);
    if (key >= 0 && !po_key_matches(request, key, table->headers[i].value))
      return false;
  }
  return true;
}

/* Whether a cell that is a key of the scene has the value of a scene. Rows for other profiles than
 * the sphere do not name a radius, if their loads are in pi w epsilon. A row whose elasticity is
 * given by its coupling may leave the Tabor parameter open. */
static bool cell_holds(const po_csv *table, const po_request *request, po_key key,
                       const char *text) {
  const bool is_named = strcmp(text, "-") != 0;
  if (!is_named && key == PO_KEY_RADIUS)
    return !po_profile_is_sphere(&request->scene.profile) && request->scene.radius == 1.0;
  if (!is_named && key == PO_KEY_TABOR)
    return po_csv_find_column(table, PO_KEYS[PO_KEY_COUPLING].name) >= 0;
  return po_key_matches(request, key, text);
}

/* Reports whether all columns that are keys of the scene have the values of a scene. */
static bool row_holds(const po_csv *table, size_t row, const po_request *request) {
  for (size_t c = 0; c < table->column_count; ++c) {
    const int key = po_key_of_name(table->columns[c]);
    if (key >= 0 && !cell_holds(table, request, key, po_csv_cell(table, row, c)))
      return false;
  }
  return true;
}

static po_status need_column(const po_csv *table, const char *name, size_t *column) {
  const int found = po_csv_find_column(table, name);
  for (size_t c = 0; found < 0 && c < table->column_count; ++c) {
    size_t stem = 0;
    po_dimension dimension;
    double size = 0;
    if (po_si_parse(table->columns[c], &stem, &dimension, &size) && strlen(name) == stem &&
        strncmp(name, table->columns[c], stem) == 0)
      return po_fail(PO_CANNOT_READ,
                     "%s:%zu: the column %s is in SI units: expected %s, or a case whose scene is "
                     "in SI units (scene.physical)",
                     table->path, table->column_line, table->columns[c], name);
  }
  if (found < 0)
    return po_fail(PO_CANNOT_READ, "%s:%zu: the column %s is missing", table->path,
                   table->column_line, name);
  *column = (size_t)found;
  return PO_OK;
}

/* Reads the uncertainty of a cell from the column `name`, else from the column `uncertainty`, else
 * from the header `uncertainty` if that is a number. */
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

/* Whether the columns problem and quantity of a row have the words PROBLEM:QUANTITY. */
static bool is_named(const po_csv *table, size_t row, const char *words) {
  const int problem = po_csv_find_column(table, "problem"),
            quantity = po_csv_find_column(table, "quantity");
  const char *colon = strchr(words, ':');
  if (problem < 0 || quantity < 0 || !colon)
    return false;
  const char *name = po_csv_cell(table, row, (size_t)problem);
  const size_t length = (size_t)(colon - words);
  return strlen(name) == length && strncmp(name, words, length) == 0 &&
         strcmp(po_csv_cell(table, row, (size_t)quantity), colon + 1) == 0;
}

bool po_reference_next_row(const po_reference *reference, const po_request *request, size_t *row) {
  const po_csv *table = &reference->table;
  if (reference->row) {
    while (*row < table->row_count && !is_named(table, *row, reference->row))
      ++*row;
    return *row < table->row_count;
  }
  while (*row < table->row_count && !row_holds(table, *row, request))
    ++*row;
  if (*row < table->row_count && !headers_hold(table, request))
    *row = table->row_count;
  return *row < table->row_count;
}

/* Adds by how much a cell or a header that is a key of the scene differs from a scene, 1 to 2, and
 * names it in `words` if that is not NULL. */
static void add_difference(const po_csv *table, const po_request *request, const char *name,
                           const char *text, double *difference, po_text *words) {
  const int key = po_key_of_name(name);
  if (key < 0 || cell_holds(table, request, key, text))
    return;
  const double own = po_key_number(request, key);
  double there = 0;
  const bool is_number =
      po_key_is_number(key) && po_number_parse(text, &there) && isfinite(own) && own != there;
  *difference += 1 + (is_number ? fabs(own - there) / (fabs(own) + fabs(there)) : 1);
  char asked[PO_KEY_TEXT_LENGTH];
  po_key_print(request, key, asked);
  if (words)
    po_text_add(words, "%s %s %s instead of %s", *difference > 2 ? "," : "", name, text, asked);
}

static double difference_of(const po_csv *table, size_t row, const po_request *request,
                            po_text *words) {
  double difference = 0;
  for (size_t c = 0; c < table->column_count; ++c)
    add_difference(table, request, table->columns[c], po_csv_cell(table, row, c), &difference,
                   words);
  for (size_t i = 0; i < table->header_count; ++i)
    add_difference(table, request, table->headers[i].key, table->headers[i].value, &difference,
                   words);
  return difference;
}

bool po_reference_nearest(const po_reference *reference, const po_request *request,
                          po_text *words) {
  const po_csv *table = &reference->table;
  size_t nearest = 0;
  double least = (double)INFINITY;
  for (size_t row = 0; row < table->row_count; ++row) {
    const double difference = difference_of(table, row, request, NULL);
    if (difference < least) {
      nearest = row;
      least = difference;
    }
  }
  if (!table->row_count)
    return false;
  po_text_add(words, "nearest is line %zu:", table->lines[nearest]);
  difference_of(table, nearest, request, words);
  if (least == 0)
    po_text_add(words, " the table names no law, profile or waves");
  return true;
}

po_status po_reference_cell(const po_reference *reference, size_t row, const char *name,
                            po_reference_number *number) {
  char uncertainty[64] = "half_width";
  size_t column = 0;
  po_status status = need_column(&reference->table, reference->row ? "value" : name, &column);
  if (!status)
    status = po_csv_number(&reference->table, row, column, &number->value);
  if (!reference->row)
    snprintf(uncertainty, sizeof uncertainty, "%s_uncertainty", name);
  return status ? status
                : uncertainty_of(&reference->table, row, uncertainty, &number->uncertainty);
}
