#include "po_pins.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_file.h"
#include "po_memory.h"
#include "po_quote.h"

const char *const PO_WORK_COUNTER_NAMES[PO_WORK_COUNTERS] = {
    "points", "newton_iterations", "factorizations", "kernel_evaluations", "nodes"};

double po_work_count(const po_work *work, int counter) {
  const uint64_t counts[PO_WORK_COUNTERS] = {work->points, work->newton_iterations,
                                             work->factorizations, work->kernel_evaluations,
                                             work->nodes};
  return (double)counts[counter];
}

void po_pins_key_text(const po_request *request, po_key key, char text[PO_KEY_TEXT_LENGTH]) {
  if (po_key_is_idle(request, key) || key == PO_KEY_TIME_LIMIT)
    snprintf(text, PO_KEY_TEXT_LENGTH, "-");
  else if (key == PO_KEY_PROFILE_FILE)
    snprintf(text, PO_KEY_TEXT_LENGTH, "%s", po_profile_digest(&request->scene.profile));
  else if (key == PO_KEY_VISCOELASTIC)
    po_creep_write_identity(&request->creep, text);
  else
    po_key_print(request, key, text);
}

typedef struct {
  char digest[PO_DIGEST_LENGTH];
  size_t point;
} point_scene;

static int by_scene(const void *a, const void *b) {
  const point_scene *x = a, *y = b;
  const int order = strcmp(x->digest, y->digest);
  return order ? order : (x->point > y->point) - (x->point < y->point);
}

static po_status digest_scene(const po_request *request, char digest[PO_DIGEST_LENGTH]) {
  po_text text = {0};
  char value[PO_KEY_TEXT_LENGTH];
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    po_pins_key_text(request, key, value);
    po_text_add(&text, "%s\n", value);
  }
  po_digest_bytes(po_text_string(&text), text.length, digest);
  const po_status status = text.failed ? PO_NO_MEMORY : PO_OK;
  po_text_clear(&text);
  return status;
}

po_status po_pins_scenes(const po_case *kase, size_t *first) {
  const size_t count = kase->point_count;
  point_scene *scenes = po_allocate(count, sizeof *scenes);
  po_status status = scenes ? PO_OK : PO_NO_MEMORY;
  for (size_t i = 0; !status && i < count; ++i) {
    scenes[i].point = i;
    status = digest_scene(&kase->points[i].request, scenes[i].digest);
  }
  if (!status)
    qsort(scenes, count, sizeof *scenes, by_scene);
  for (size_t i = 0; !status && i < count; ++i) {
    const bool again = i > 0 && strcmp(scenes[i].digest, scenes[i - 1].digest) == 0;
    first[scenes[i].point] = again ? first[scenes[i - 1].point] : scenes[i].point;
  }
  free(scenes);
  return status;
}

void po_pins_name_special_point(po_quantity quantity, po_special_kind kind, size_t index, bool load,
                                char name[PO_PIN_NAME_LENGTH]) {
  snprintf(name, PO_PIN_NAME_LENGTH, "%s/%s-%zu/%s", PO_QUANTITIES[quantity].name,
           PO_SPECIAL_KINDS[kind], index + 1, load ? "load" : "approach");
}

/* Returned: FOLDER/pins/NAME + `ending`, or FOLDER/pins/SOLVER/NAME + `ending`, for a case file in
 * FOLDER. */
static po_file_path path_of(const char *case_path, const char *case_name, const char *solver,
                            const char *ending) {
  const char *slash = strrchr(case_path, '/');
  const int length = slash ? (int)(slash - case_path + 1) : 0;
  po_file_path path;
  snprintf(path.text, sizeof path.text, "%.*spins/%s%s%s%s", length, case_path,
           solver ? solver : "", solver ? "/" : "", case_name, ending);
  return path;
}

/* Checks that the columns of a table of pins are keys of the scene, quantity and value. */
static po_status check_columns(const po_csv *table) {
  char shown[PO_QUOTE_LENGTH];
  for (size_t c = 0; c < table->column_count; ++c)
    if (po_key_of_name(table->columns[c]) < 0 && strcmp(table->columns[c], "quantity") != 0 &&
        strcmp(table->columns[c], "value") != 0)
      return po_fail(PO_CANNOT_READ,
                     "%s:%zu: the column %s is unknown: expected keys of the scene, quantity "
                     "and value",
                     table->path, table->column_line, po_quote(table->columns[c], shown));
  const int value = po_csv_find_column(table, "value");
  if (value < 0 || po_csv_find_column(table, "quantity") < 0)
    return po_fail(PO_CANNOT_READ, "%s:%zu: the column %s is missing", table->path,
                   table->column_line, value < 0 ? "value" : "quantity");
  po_status status = PO_OK;
  double number = 0;
  for (size_t r = 0; !status && r < table->row_count; ++r)
    status = po_csv_number(table, r, (size_t)value, &number);
  return status;
}

/* Opens the table beside a case file whose name ends in `ending`, and checks its columns. */
static po_status open_table(const po_case *kase, const char *solver, const char *ending,
                            po_status (*check)(const po_csv *table), po_reference *pins) {
  pins->path = path_of(kase->path, kase->file->name, solver, ending);
  pins->shown = path_of(kase->shown, kase->file->name, solver, ending);
  po_status status = PO_OK;
  po_digest_bytes("", 0, pins->digest);
  if (po_path_exists(pins->path.text)) {
    status = po_reference_read(pins->path.text, pins->shown.text, pins);
    if (!status && pins->ledger != PO_LEDGER_PIN)
      status = po_fail(PO_CANNOT_READ, "%s: kind is %s: expected pin", pins->shown.text,
                       PO_LEDGERS[pins->ledger]);
    if (!status)
      status = check(&pins->table);
  }
  if (status)
    po_reference_close(pins);
  return status;
}

po_status po_pins_open(const po_case *kase, const char *name, const char *solver,
                       po_reference *reference) {
  *reference = (po_reference){.name = name, .ledger = PO_LEDGER_PIN, .type = PO_REFERENCE_PINS};
  return open_table(kase, solver, ".csv", check_columns, reference);
}

bool po_pins_exist(const po_reference *pins) {
  return pins->table.column_count > 0;
}

/* The values of a scene as written in a table of pins, and the column of each key. */
typedef struct {
  char texts[PO_KEY_COUNT][PO_KEY_TEXT_LENGTH];
  int columns[PO_KEY_COUNT]; /* -1: no column */
} scene_words;

/* Fills `scene`. Returned: false if the headers of the table exclude the scene. */
static bool describe(const po_csv *table, const po_request *request, scene_words *scene) {
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    po_pins_key_text(request, key, scene->texts[key]);
    scene->columns[key] = po_csv_find_column(table, PO_KEYS[key].name);
    const po_csv_header *header = po_csv_find_header(table, PO_KEYS[key].name);
    if (scene->columns[key] < 0 && strcmp(header ? header->value : "-", scene->texts[key]) != 0)
      return false;
  }
  return true;
}

static bool row_holds(const po_csv *table, size_t row, const scene_words *scene) {
  for (int key = 0; key < PO_KEY_COUNT; ++key)
    if (scene->columns[key] >= 0 &&
        strcmp(po_csv_cell(table, row, (size_t)scene->columns[key]), scene->texts[key]) != 0)
      return false;
  return true;
}

po_status po_pins_value(const po_reference *pins, const char *name, const po_request *request,
                        double *value) {
  const po_csv *table = &pins->table;
  scene_words scene;
  if (!po_pins_exist(pins) || !describe(table, request, &scene))
    return PO_NOT_FOUND;
  const size_t quantity = (size_t)po_csv_find_column(table, "quantity");
  size_t found = 0, at = 0;
  for (size_t row = 0; row < table->row_count; ++row)
    if (strcmp(po_csv_cell(table, row, quantity), name) == 0 && row_holds(table, row, &scene)) {
      found += 1;
      at = row;
    }
  if (found > 1)
    return po_fail(PO_CANNOT_READ, "%s:%zu: a second %s for the same scene: expected one",
                   table->path, table->lines[at], name);
  return found ? po_csv_number(table, at, (size_t)po_csv_find_column(table, "value"), value)
               : PO_NOT_FOUND;
}

enum { POINT, DIGEST, FORCE, COLUMNS };

static po_status check_digest_columns(const po_csv *table) {
  static const char *const NAMES[COLUMNS] = {"point", "digest", "pull_off_force"};
  for (size_t c = 0; c < COLUMNS; ++c)
    if (table->column_count != COLUMNS || strcmp(table->columns[c], NAMES[c]) != 0)
      return po_fail(PO_CANNOT_READ, "%s:%zu: expected the columns point, digest, pull_off_force",
                     table->path, table->column_line);
  return PO_OK;
}

po_status po_digests_scenes(const po_case *kase, char digest[PO_DIGEST_LENGTH]) {
  po_text text = {0};
  for (size_t i = 0; i < kase->point_count; ++i) {
    po_request request = kase->points[i].request;
    request.time_limit = (double)NAN; /* may be that of one run, and does not change the results */
    po_input_add_identity(&request, &text);
    po_text_add(&text, "\n");
  }
  po_digest_bytes(po_text_string(&text), text.length, digest);
  const po_status status = text.failed ? PO_NO_MEMORY : PO_OK;
  po_text_clear(&text);
  return status;
}

po_status po_digests_open(const po_case *kase, char scenes[PO_DIGEST_LENGTH],
                          po_reference *digests) {
  *digests = (po_reference){.name = "digests", .type = PO_REFERENCE_PINS};
  po_status status = po_digests_scenes(kase, scenes);
  if (!status)
    status = open_table(kase, NULL, ".digests.csv", check_digest_columns, digests);
  const po_csv_header *stored = po_csv_find_header(&digests->table, "scenes");
  if (!stored || strcmp(stored->value, scenes) != 0)
    digests->table.row_count = 0;
  return status;
}

po_status po_digests_find(const po_reference *digests, size_t point, const char *id,
                          const char **digest, double *force) {
  const po_csv *table = &digests->table;
  size_t row = point; /* where it is unless the case has been changed */
  if (row >= table->row_count || strcmp(po_csv_cell(table, row, POINT), id) != 0)
    for (row = 0; row < table->row_count && strcmp(po_csv_cell(table, row, POINT), id) != 0;)
      ++row;
  if (row >= table->row_count)
    return PO_NOT_FOUND;
  *digest = po_csv_cell(table, row, DIGEST);
  *force = (double)NAN;
  return strcmp(po_csv_cell(table, row, FORCE), "-") == 0 ? PO_OK
                                                          : po_csv_number(table, row, FORCE, force);
}
