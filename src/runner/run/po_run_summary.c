#include "po_run_summary.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_csv.h"
#include "po_input.h"
#include "po_json_value.h"
#include "po_record.h"
#include "po_result_rows.h"
#include "po_si.h"
#include "po_tables.h"

/* What a summary may have: uncertain numbers, a viscoelastic body. */
enum { OF_ALL = 0, OF_UNCERTAIN = 1, OF_RATE = 2 };

/* The numbers of a point: their column and path; those of a loop begin with its path; what the
 * summary has if they are in it. */
static const struct {
  const char *name, *path;
  bool of_loop;
  unsigned of;
} COLUMNS[] = {{"force", "pull_off.force", false, OF_ALL},
               {"force_error", "pull_off.error_estimate", false, OF_ALL},
               {"force_uncertainty", "uncertainty.force", false, OF_UNCERTAIN},
               {"approach", "pull_off.approach", false, OF_ALL},
               {"approach_error", "pull_off.approach_error_estimate", false, OF_ALL},
               {"contact_radius", "pull_off.contact_radius", false, OF_ALL},
               {"contact_radius_error", "pull_off.contact_radius_error_estimate", false, OF_ALL},
               {"energy_lost", "energy_lost", true, OF_ALL},
               {"energy_lost_error", "energy_lost_error_estimate", true, OF_ALL},
               {"work", "work", true, OF_ALL},
               {"work_error", "work_error_estimate", true, OF_ALL},
               {"unloading_work", "unloading.end.energies.work", false, OF_RATE},
               {"unloading_work_error", "unloading.error_estimate.work", false, OF_RATE},
               {"dissipated", "unloading.end.energies.dissipated", false, OF_RATE},
               {"dissipated_error", "unloading.error_estimate.dissipated", false, OF_RATE},
               {"lost_in_jumps", "unloading.end.energies.jumps", false, OF_RATE},
               {"lost_in_jumps_error", "unloading.error_estimate.jumps", false, OF_RATE}};
enum { COLUMN_COUNT = sizeof COLUMNS / sizeof *COLUMNS };

typedef struct {
  const po_case_run *runs;
  size_t count;
  unsigned has; /* OF_UNCERTAIN, OF_RATE */
  json_t *keys; /* those that vary in any case, as members of an object */
  po_text rows;
} summary;

static void path_of(size_t column, const po_result *result, char path[80]) {
  const char *loop =
      result->hysteresis.has_spring ? "hysteresis.spring." : "hysteresis.displacement_control.";
  snprintf(path, 80, "%s%s", COLUMNS[column].of_loop ? loop : "", COLUMNS[column].path);
}

/* The unit of a column for a point of a case: that of the first point of all. */
static po_si_unit unit_of(const summary *s, const po_case *kase, size_t point, size_t column) {
  static const po_result none = {0};
  char path[80];
  path_of(column, &none, path);
  const po_dimension dimension = po_block_find(&PO_ALL_ROWS, NULL, path).row->dimension;
  const po_case *first = s->runs->plan->kase;
  po_si_unit unit = {.factor = 1};
  if (kase->is_physical) {
    unit = po_si_prefixed(&first->units, dimension);
    unit.factor = po_si_unit_of(&kase->points[point].request.units, dimension).factor *
                  (unit.factor / po_si_unit_of(&first->units, dimension).factor);
  }
  return unit;
}

static bool is_in(const summary *s, size_t column) {
  return (COLUMNS[column].of & ~s->has) == 0;
}

static void add_names(summary *s) {
  const char *key;
  json_t *value;
  po_text_add(&s->rows, "case,point");
  json_object_foreach(s->keys, key, value) po_text_add(&s->rows, ",%s", key);
  po_text_add(&s->rows, ",status");
  for (size_t c = 0; c < COLUMN_COUNT; ++c) {
    const po_si_unit unit = unit_of(s, s->runs->plan->kase, 0, c);
    if (is_in(s, c))
      po_text_add(&s->rows, ",%s%s%s", COLUMNS[c].name, *unit.name ? "_" : "", unit.name);
  }
  po_text_add(&s->rows, "\n");
}

/* The value of a key: names and waves as texts, whose commas are semicolons, as in tables. */
static void add_value(po_text *rows, const json_t *value) {
  char number[PO_NUMBER_LENGTH];
  if (json_is_number(value)) {
    po_number_print(json_number_value(value), number);
    po_text_add(rows, ",%s", number);
    return;
  }
  po_text_add(rows, ",");
  const char *text = json_is_string(value) ? json_string_value(value) : "nan";
  for (const char *c = text; *c; ++c)
    po_text_add(rows, "%c", *c == ',' ? ';' : *c);
}

static void add_point(summary *s, const po_case_run *run, size_t index) {
  const po_case *kase = run->plan->kase;
  const po_result *result = &run->points[index].result;
  const char *key;
  json_t *varies, *entry = po_record_point(run, index);
  po_text_add(&s->rows, "%s,%s", kase->file->name, kase->points[index].id);
  json_object_foreach(s->keys, key, varies)
      add_value(&s->rows, json_object_get(json_object_get(entry, "sweep"), key));
  json_decref(entry);
  po_text_add(&s->rows, ",%s,", po_status_name(result->status));
  double row[COLUMN_COUNT];
  size_t columns = 0;
  for (size_t c = 0; c < COLUMN_COUNT; ++c) {
    char path[80];
    path_of(c, result, path);
    const po_si_unit unit = unit_of(s, kase, index, c);
    if (is_in(s, c))
      row[columns++] = po_si_value(&unit, po_block_number(&PO_ALL_ROWS, result, path));
  }
  po_csv_add_row(&s->rows, row, columns);
}

static unsigned find_parts(const po_case_run *runs, size_t count) {
  unsigned has = OF_ALL;
  for (size_t r = 0; r < count; ++r)
    for (size_t k = 0; k < runs[r].plan->kase->point_count; ++k)
      has |= (runs[r].plan->kase->points[k].request.creep.kind != PO_CREEP_NONE ? OF_RATE : 0U) |
             (runs[r].points[k].result.uncertain_count ? OF_UNCERTAIN : 0U);
  return has;
}

/* Finds the keys that vary, and checks that all cases have the same kind of units. */
static po_status find_keys(summary *s) {
  s->keys = po_json_empty_object();
  for (size_t r = 0; r < s->count; ++r) {
    const po_case *kase = s->runs[r].plan->kase, *first = s->runs->plan->kase;
    if (kase->is_physical != first->is_physical)
      return po_fail(PO_BAD_INPUT,
                     "no summary is written: the case %s is in SI units and %s is not; expected "
                     "all cases or none",
                     kase->is_physical ? kase->file->name : first->file->name,
                     kase->is_physical ? first->file->name : kase->file->name);
    json_t *entry = kase->point_count ? po_record_point(&s->runs[r], 0) : NULL;
    const char *key;
    json_t *value;
    json_object_foreach(json_object_get(entry, "sweep"), key, value)
        po_json_set(&s->keys, key, json_true());
    json_decref(entry);
  }
  return s->keys ? PO_OK : PO_NO_MEMORY;
}

po_status po_run_summary_write(const char *path, const po_case_run *runs, size_t count) {
  summary s = {.runs = runs, .count = count, .has = find_parts(runs, count)};
  po_status status = find_keys(&s);
  if (!status && count) {
    po_text header = {0};
    add_names(&s);
    for (size_t r = 0; r < count; ++r)
      for (size_t k = 0; k < runs[r].plan->kase->point_count; ++k)
        if (runs[r].points[k].asked)
          add_point(&s, &runs[r], k);
    po_text_add(
        &header,
        "# what: pull-offs of the points of a run, with the energy lost in loading "
        "and unloading\n# units: %s; errors are estimated bounds; nan: not known%s%s\n",
        runs->plan->kase->is_physical
            ? "SI, at the end of the name of each column"
            : "lengths in epsilon; force in pi w R, of a profile without a radius in pi w "
              "epsilon; energies in these times epsilon",
        s.has & OF_UNCERTAIN ? "; force_uncertainty: standard uncertainty by those of the inputs"
                             : "",
        s.has & OF_RATE ? "; unloading_work: by the base that unloads a viscoelastic body" : "");
    status = po_tables_write_rows(path, &header, &s.rows);
    po_text_clear(&header);
  }
  po_text_clear(&s.rows);
  json_decref(s.keys);
  return status;
}
