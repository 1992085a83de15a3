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
  bool metric;    /* in the metric of the solver, which has no SI unit: not in tables in SI units */
  bool of_spring; /* only in tables of a scene with a spring */
  bool of_rate;   /* only in tables of a viscoelastic body */
} column;
#define LENGTH(list) (sizeof(list) / sizeof *(list))

static const column CURVE[] = {
    {"position", "position", .metric = true},
    {"approach", "approach"},
    {"load", "load"},
    {"energy", "energy"},
    {"contact_radius", "contact_radius"},
    {"approach_rate", "approach_rate", .metric = true},
    {"load_rate", "load_rate", .metric = true},
    {"unstable_modes", "unstable_modes"},
    {"energy_error", "energy_error_estimate"},
    {"unstable_modes_at_base", "unstable_modes_at_base", .of_spring = true}};

static const column PROFILE[] = {{"radius", "radius"}, {"gap", "gap"}, {"traction", "traction"}};

static const column HISTORY[] = {{"time", "time"},
                                 {"moved", "moved"},
                                 {"base", "base"},
                                 {"approach", "approach"},
                                 {"load", "load"},
                                 {"contact_radius", "contact_radius"},
                                 {"stored", "energies.stored"},
                                 {"adhesive", "energies.adhesive"},
                                 {"spring", "energies.spring"},
                                 {"work", "energies.work"},
                                 {"dissipated", "energies.dissipated"},
                                 {"jumps", "energies.jumps"}};

/* If the step is open, `until` is the last state of loading on the curve; separated bodies have the
 * approach -inf. */
static const column STEP[] = {{"from_approach", "preload.approach"},
                              {"from_load", "preload.load"},
                              {"until_approach", "until.approach"},
                              {"until_load", "until.load"},
                              {"open", "open"},
                              {"force", "force"},
                              {"force_error", "error_estimate"},
                              {"approach", "approach"},
                              {"approach_error", "approach_error_estimate"},
                              {"energy_lost", "cycles.0.energy_lost"},
                              {"energy_lost_error", "cycles.0.energy_lost_error_estimate"}};

static const column LOOP[] = {{"phase", "phase"},
                              {"jump", "jump"},
                              {"base", "base"},
                              {"approach", "approach"},
                              {"indentation", "indentation"},
                              {"load", "load"},
                              {"contact_radius", "contact_radius"},
                              {"stiffness", "stiffness"},
                              {"energy_lost", "energy_lost"}};

static const column SERIES[] = {
    {"force", "pull_off.force"},
    {"force_error", "pull_off.error_estimate"},
    {"approach", "pull_off.approach"},
    {"approach_error", "pull_off.approach_error_estimate"},
    {"contact_radius", "pull_off.contact_radius"},
    {"contact_radius_error", "pull_off.contact_radius_error_estimate"},
    {"followed", "followed"},
    {"time", "unloading.time", .of_rate = true},
    {"dissipated", "unloading.end.energies.dissipated", .of_rate = true},
    {"dissipated_error", "unloading.error_estimate.dissipated", .of_rate = true},
    {"lost_in_jumps", "unloading.end.energies.jumps", .of_rate = true},
    {"lost_in_jumps_error", "unloading.error_estimate.jumps", .of_rate = true}};

enum { MOST_COLUMNS = LENGTH(HISTORY) };
_Static_assert(LENGTH(HISTORY) >= LENGTH(STEP) && LENGTH(HISTORY) >= LENGTH(SERIES), "");

/* A table of lists of a result: its columns, the lists with the text before each row, and what its
 * headers say. */
static const struct {
  const column *column;
  size_t count;
  struct {
    const char *path, *before;
  } list[PO_TESTS];
  const char *what, *units, *units_in_si;
} TABLES[] = {
    [PO_PROFILE_TABLE] =
        {.column = PROFILE,
         .count = LENGTH(PROFILE),
         .list = {{"profile", ""}},
         .what = "gap and traction over the radius at approach ",
         .units = "radius and approach in epsilon; gap H = h/epsilon - 1; traction P = p mu "
                  "epsilon/w, compressive > 0",
         .units_in_si = "SI, at the end of the name of each column; gap: distance of the surfaces; "
                        "traction compressive > 0"},
    [PO_CURVE_TABLE] =
        {.column = CURVE,
         .count = LENGTH(CURVE),
         .list = {{"curve", ""}},
         .what = "load against approach along the branch",
         .units = "approach and contact_radius in epsilon; load in pi w R, compressive > 0; energy "
                  "in pi w R epsilon, its derivative by the approach is the load; energy_error: "
                  "bound of its error at this approach, nan: not estimated; position: arclength "
                  "along the branch in the metric of the solver; approach_rate and load_rate: "
                  "derivatives by the position",
         .units_in_si = "SI, at the end of the name of each column; load compressive > 0; the "
                        "derivative of the energy by the approach is the load; energy_error: "
                        "bound of its error at this approach, nan: not estimated"},
    [PO_HISTORY_TABLE] =
        {.column = HISTORY,
         .count = LENGTH(HISTORY),
         .list = {{"unloading.history", ""}},
         .what = "unloading of a viscoelastic body, and before it loading at a speed and the "
                 "dwell: the steps of the finest march",
         .units = "time since unloading began, in tau_0, nan at its speeds 0 and inf; lengths in "
                  "epsilon; load in pi w R, compressive > 0; energies, and work and losses since "
                  "unloading began, in pi w R epsilon: work = change of (stored + adhesive + "
                  "spring) + dissipated + jumps",
         .units_in_si =
             "SI, at the end of the name of each column, but for the time in tau_0; load "
             "compressive > 0; work = change of (stored + adhesive + spring) + "
             "dissipated + jumps"},
    [PO_STAIRCASE_TABLE] =
        {.column = STEP,
         .count = LENGTH(STEP),
         .list = {{"staircase.displacement_control.steps", "displacement,"},
                  {"staircase.load_control.steps", "load,"},
                  {"staircase.spring.steps", "spring,"}},
         .what = "pull-off force and dissipated energy as functions of the preload: each row is a "
                 "step, the range of greatest approaches (control displacement), loads (control "
                 "load) or positions of the base approach + load/stiffness (control spring) with "
                 "the same pull-off; open: the curve ends before the step",
         .units = "approaches in epsilon, -inf for separated bodies; loads and force in pi w R; "
                  "energy in pi w R epsilon, nan: unbounded",
         .units_in_si = "SI, at the end of the name of each column; approaches -inf for separated "
                        "bodies; energy nan: unbounded"},
    [PO_LOOP_TABLE] = {
        .column = LOOP,
        .count = LENGTH(LOOP),
        .list = {{"hysteresis.spring.path.rows", ""},
                 {"hysteresis.displacement_control.path.rows", ""}},
        .what = "loading and unloading ",
        .units =
            "lengths in epsilon; load in pi w R, compressive > 0; stiffness (of the contact, "
            "nan: infinite) in pi w R/epsilon; energy_lost in pi w R epsilon, in the jump that "
            "ends at the row; base: approach + load/stiffness of the spring; indentation: "
            "approach from the first contact on",
        .units_in_si = "SI, at the end of the name of each column; load compressive > 0; stiffness "
                       "of the contact, nan: infinite; energy_lost in the jump that ends at the "
                       "row; base: approach + load/stiffness of the spring; indentation: approach "
                       "from the first contact on"}};

/* The columns of a table of a request, and their block. */
typedef struct {
  const column *column;
  size_t count;
  const po_block *block;
  const po_request *request;
} layout;

/* Whether a table has a column. In SI units, *unit is that of its numbers. Given: `own`, the units
 * of an item of another scene, which has the prefixes of the request; NULL: of that of the request.
 */
static bool has_column(const layout *l, size_t c, const po_units *own, po_si_unit *unit) {
  const po_request *request = l->request;
  const po_row *row = po_block_find(l->block, NULL, l->column[c].path).row;
  *unit = (po_si_unit){.factor = 1};
  if (request->in_si && row->type == PO_ROW_NUMBER) {
    *unit = po_si_prefixed(&request->units, row->dimension);
    if (own)
      unit->factor = po_si_unit_of(own, row->dimension).factor *
                     (unit->factor / po_si_unit_of(&request->units, row->dimension).factor);
  }
  return !(request->in_si && l->column[c].metric) &&
         !(l->column[c].of_spring && isnan(request->stiffness)) &&
         !(l->column[c].of_rate && request->creep.kind == PO_CREEP_NONE);
}

static void add_names(po_text *rows, const char *before, const layout *l) {
  po_si_unit unit;
  po_text_add(rows, "%s", before);
  for (size_t c = 0, named = 0; c < l->count; ++c)
    if (has_column(l, c, NULL, &unit))
      po_text_add(rows, "%s%s%s%s", named++ ? "," : "", l->column[c].name, *unit.name ? "_" : "",
                  unit.name);
  po_text_add(rows, "\n");
}

/* The word of a column, before its numbers; NULL: it has numbers. */
static const char *word_of(const layout *l, size_t c, const void *item) {
  const po_field field = po_block_find(l->block, item, l->column[c].path);
  return field.row->type == PO_ROW_WORD ? field.row->names[po_row_bits(field.row, field.owner)]
                                        : NULL;
}

/* Adds a row with the numbers of an item, which begins with a text. */
static void add_item(po_text *rows, const char *before, const layout *l, const void *item,
                     const po_units *own) {
  double row[MOST_COLUMNS];
  size_t used = 0;
  po_si_unit unit;
  po_text_add(rows, "%s", before);
  for (size_t c = 0; c < l->count; ++c) {
    const char *word = word_of(l, c, item);
    if (word)
      po_text_add(rows, "%s,", word);
    else if (has_column(l, c, own, &unit))
      row[used++] = po_si_value(&unit, po_block_number(l->block, item, l->column[c].path));
  }
  po_csv_add_row(rows, row, used);
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

po_status po_tables_write_rows(const char *path, const po_text *header, const po_text *rows) {
  char digest[PO_DIGEST_LENGTH];
  po_text text = {0};
  po_csv_seal(header, rows, &text, digest);
  const po_status status = text.failed ? PO_NO_MEMORY : write_text(path, &text);
  po_text_clear(&text);
  return status;
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

/* Says which loop a table has, and what it encloses. */
static void add_loop(po_text *what, const po_request *request, const po_hysteresis *h) {
  const po_loop *loop = &h->of[h->has_spring ? PO_THROUGH_SPRING : PO_AT_APPROACH];
  po_si_unit energy = {.factor = 1, .text = ""};
  if (request->in_si)
    energy = po_si_prefixed(&request->units, PO_DIMENSION_ENERGY);
  po_text_add(what,
              "%s, as a test records it; jumps, two rows each, lose %.10g %s, with an error of "
              "at most %.2g; the area of the rows over the base, by the trapezoidal rule, "
              "differs from that by at most %.2g",
              h->has_spring ? "through a spring" : "at given approach",
              loop->energy_lost * energy.factor,
              request->in_si                   ? energy.text
              : po_input_has_coupling(request) ? "pi w epsilon^2"
                                               : "pi w R epsilon",
              loop->energy_lost_error * energy.factor, loop->row_area_error * energy.factor);
}

po_status po_tables_write(po_table table, const char *path, const po_request *request,
                          const po_result *result, char *digest) {
  po_text rows = {0};
  char approach[PO_NUMBER_LENGTH] = "";
  if (table == PO_PROFILE_TABLE && !result->profile_count)
    return po_fail(PO_BAD_INPUT,
                   "%s is not written: %s does not pass the approach or load of the profile%s",
                   path, request->creep.kind == PO_CREEP_NONE ? "the trace" : "unloading",
                   request->creep.kind == PO_CREEP_NONE ? ", see --approach-end" : "");
  po_si_unit length = {.factor = 1};
  if (request->in_si)
    length = po_si_prefixed(&request->units, PO_DIMENSION_LENGTH);
  if (table == PO_PROFILE_TABLE)
    po_number_print(result->profile_approach * length.factor, approach);
  po_text what = {0};
  po_text_add(&what, "%s%s%s%s", TABLES[table].what, approach, *approach && *length.text ? " " : "",
              *approach ? length.text : "");
  if (table == PO_LOOP_TABLE)
    add_loop(&what, request, &result->hysteresis);
  const size_t tests = table != PO_LOOP_TABLE ? PO_TESTS : result->hysteresis.has_spring ? 1 : 2;
  for (size_t k = 0; k < tests && TABLES[table].list[k].path; ++k) {
    const po_field list = po_block_find(&PO_ALL_ROWS, result, TABLES[table].list[k].path);
    const layout l = {TABLES[table].column, TABLES[table].count, list.row->block, request};
    if (k == 0)
      add_names(&rows, table == PO_STAIRCASE_TABLE ? "control," : "", &l);
    for (size_t i = 0; list.owner && i < po_row_items(list.row, list.owner); ++i)
      add_item(&rows, TABLES[table].list[k].before, &l, po_row_item(list.row, list.owner, i), NULL);
  }
  const po_status status =
      write_table(path, request, po_text_string(&what),
                  request->in_si ? TABLES[table].units_in_si : TABLES[table].units, &rows, digest);
  po_text_clear(&what);
  return status;
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

po_status po_tables_write_series(const char *path, const char *key, const double *values,
                                 const po_request *requests, const po_result *results,
                                 size_t count) {
  const layout l = {SERIES, LENGTH(SERIES), &PO_ALL_ROWS, requests};
  const bool creeps = requests->creep.kind != PO_CREEP_NONE;
  po_text rows = {0};
  char units[240];
  snprintf(units, sizeof units, "%s%s%s; errors are estimated bounds%s",
           requests->in_si ? "SI, at the end of the name of each column"
                           : "approach and contact_radius in epsilon; force in ",
           requests->in_si ? "" : po_input_load_unit(requests),
           !creeps           ? ""
           : requests->in_si ? ", but for the time in tau_0"
                             : ", energies in that times epsilon; time in tau_0",
           creeps ? "; time: from the preload to the pull-off, nan at the speeds 0 and inf" : "");
  for (const char *c = key; *c; ++c)
    po_text_add(&rows, "%c", *c == '-' ? '_' : *c);
  add_names(&rows, ",", &l);
  for (size_t k = 0; k < count; ++k) {
    char number[PO_NUMBER_LENGTH + 1];
    po_number_print(values[k], number);
    add_item(&rows, strcat(number, ","), &l, &results[k], &requests[k].units);
  }
  return write_table(
      path, requests,
      "pull-off of scenes in which one parameter varies; the command solves the first", units,
      &rows, NULL);
}
