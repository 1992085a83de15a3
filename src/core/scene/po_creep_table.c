#include "po_creep_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "po_csv.h"
#include "po_file.h"
#include "po_lock.h"
#include "po_memory.h"
#include "po_profile_columns.h"
#include "po_root.h"

/* -- From the modulus to the compliance -- */

/* The transform of the modulus at s = -1/tau, times the distance of tau from the time `near`, where
 * it has a pole:
 *
 *   M(tau) = relaxed + sum_m weight_m time_m/(time_m - tau).
 *
 * With the distance as the variable nothing cancels where the zero is beside the pole. */
typedef struct {
  double relaxed;
  const po_creep_terms *modulus;
  size_t near;
} transform;

static double strength(const po_creep_term *t) {
  return t->weight * t->time;
}

static double transform_at(double distance, const void *data) {
  const transform *t = data;
  const po_creep_term *term = t->modulus->term, *near = &term[t->near];
  double rest = t->relaxed;
  for (size_t m = 0; m < t->modulus->count; ++m)
    if (m != t->near)
      rest += strength(&term[m]) / (term[m].time - near->time - distance);
  return rest * distance - strength(near);
}

/* The compliance of the zero at a distance from the time `near`, relative to the relaxed one. */
static double weight_at(const transform *t, double distance) {
  const po_creep_term *term = t->modulus->term;
  double sum = 0.0;
  for (size_t m = 0; m < t->modulus->count; ++m) {
    const double apart = distance - (m == t->near ? 0.0 : term[m].time - term[t->near].time);
    sum += strength(&term[m]) / (apart * apart);
  }
  return t->relaxed / ((term[t->near].time + distance) * sum);
}

void po_creep_of_modulus(double relaxed, const po_creep_terms *modulus,
                         po_creep_terms *compliance) {
  const po_creep_term *term = modulus->term;
  double all = 0.0, instant = relaxed;
  for (size_t m = 0; m < modulus->count; ++m) {
    all += strength(&term[m]);
    instant += term[m].weight;
  }
  compliance->instant = relaxed / instant;
  compliance->count = modulus->count;
  for (size_t m = 0; m < modulus->count; ++m) {
    const bool last = m + 1 == modulus->count;
    const double length = last ? all / relaxed : term[m + 1].time - term[m].time;
    transform t = {relaxed, modulus, m};
    double low = 0.0, high = last ? length : 0.5 * length;
    if (!last && transform_at(high, &t) < 0.0) { /* nearer to the longer time */
      t.near = m + 1;
      low = -0.5 * length;
      high = 0.0;
    }
    const double distance = po_root(transform_at, &t, low, high);
    compliance->term[m] = (po_creep_term){term[t.near].time + distance, weight_at(&t, distance)};
  }
}

/* -- The table -- */

static const char *const WANTED[] = {"time", NULL};

/* The units of weights whose size is known, of a modulus and, with "per" before, of a compliance.
 * Of others only ratios matter. */
static const po_column_unit WEIGHTS[] = {{"_pa", 1.0}, {"_kpa", 1e3}, {"_mpa", 1e6}, {"_gpa", 1e9}};
enum { WEIGHT_COUNT = sizeof WEIGHTS / sizeof *WEIGHTS };

static const po_column_unit TIMES[] = {{"", 1.0},     {"_s", 1.0},    {"_ms", 1e-3}, {"_us", 1e-6},
                                       {"_ns", 1e-9}, {"_min", 60.0}, {"_h", 3600.0}};
enum { TIME_COUNT = sizeof TIMES / sizeof *TIMES };

static const double SHORTEST = 1e-12, LONGEST = 1e12; /* tau_0 */

typedef struct {
  const po_csv *csv;
  int time, weight;
  double factor; /* of the times */
  bool in_seconds, of_modulus, has_unit;
} columns;

/* Finds the columns of weights of one kind. Returned: their number. */
static int find_weights(columns *c, const char *word, bool of_modulus) {
  const size_t length = strlen(word);
  int found = 0;
  for (size_t k = 0; k < c->csv->column_count; ++k) {
    const char *name = c->csv->columns[k];
    if (strncmp(name, word, length) != 0 || (name[length] && name[length] != '_'))
      continue;
    c->weight = (int)k;
    c->of_modulus = of_modulus;
    c->has_unit = name[length];
    ++found;
  }
  return found;
}

static po_status find_columns(columns *c) {
  int unit = 0;
  const int times = po_columns_find(c->csv, WANTED[0], TIMES, TIME_COUNT, &c->time, &unit);
  const int weights = find_weights(c, "modulus", true) + find_weights(c, "compliance", false);
  if (times != 1 || weights != 1) {
    char names[200];
    po_columns_list(c->csv, sizeof names, names);
    return po_fail(PO_CANNOT_READ,
                   "%s:%zu: the columns are %s: expected one time, with or without a unit (time_s, "
                   "ms, us, ns, min, h), and one of modulus and compliance (modulus_mpa)",
                   c->csv->path, c->csv->column_line, names);
  }
  c->factor = TIMES[unit].size;
  c->in_seconds = unit > 0;
  return PO_OK;
}

static po_status refuse(const columns *c, size_t row, const char *what, double value,
                        const char *expected) {
  return po_fail(PO_CANNOT_READ, "%s:%zu: %s is %g: expected %s", c->csv->path, c->csv->lines[row],
                 what, value, expected);
}

/* A row: its time in tau_0, INFINITY for the word inf; and its weight. */
static po_status read_row(const columns *c, size_t row, po_creep_term *term) {
  po_status status = po_csv_number(c->csv, row, (size_t)c->weight, &term->weight);
  if (!status && strcmp(po_csv_cell(c->csv, row, (size_t)c->time), "inf") == 0)
    term->time = INFINITY;
  else if (!status)
    status = po_csv_number(c->csv, row, (size_t)c->time, &term->time);
  if (status)
    return status;
  if (!(term->weight > 0.0))
    return refuse(c, row, c->of_modulus ? "the modulus" : "the compliance", term->weight,
                  "a number > 0");
  term->time *= c->factor;
  return PO_OK;
}

/* Whether a row is the one without a time constant: the relaxed modulus, which is the last row, or
 * the instantaneous compliance, which is the first one. */
static bool is_constant(const columns *c, size_t row, double time) {
  return c->of_modulus ? isinf(time) && row + 1 == c->csv->row_count : time == 0.0 && row == 0;
}

/* Reads the rows. Returned: the terms, and the weight without a time; NAN: there is no such row. */
static po_status read_rows(const columns *c, po_creep_terms *terms, double *constant) {
  terms->count = 0;
  *constant = NAN;
  for (size_t row = 0; row < c->csv->row_count; ++row) {
    po_creep_term term;
    const po_status status = read_row(c, row, &term);
    if (status)
      return status;
    if (is_constant(c, row, term.time)) {
      *constant = term.weight;
      continue;
    }
    if (!(term.time >= SHORTEST && term.time <= LONGEST))
      return refuse(c, row, "the time", term.time / c->factor,
                    c->of_modulus ? "1e-12 to 1e12 tau_0, or inf, the relaxed modulus, in the last "
                                    "row"
                                  : "1e-12 to 1e12 tau_0, or 0, the instantaneous compliance, in "
                                    "the first row");
    if (terms->count && !(term.time > terms->term[terms->count - 1].time))
      return refuse(c, row, "the time", term.time / c->factor, "more than in the row before");
    if (terms->count == PO_MOST_CREEP_TERMS)
      return refuse(c, row, "the number of times", (double)(terms->count + 1), "at most 160");
    terms->term[terms->count++] = term;
  }
  return terms->count ? PO_OK
                      : po_fail(PO_CANNOT_READ,
                                "%s: the table has no finite time > 0: expected at "
                                "least one",
                                c->csv->path);
}

/* The weight without a time that no row gives: weights without a unit are then relative to the
 * glassy modulus, or to the relaxed compliance. */
static po_status find_constant(const columns *c, const po_creep_terms *terms, double *constant) {
  const char *what = c->of_modulus ? "the relaxed modulus (time inf, in the last row)"
                                   : "the instantaneous compliance (time 0, in the first row)";
  double sum = 0.0;
  for (size_t m = 0; m < terms->count; ++m)
    sum += terms->term[m].weight;
  if (!isfinite(sum))
    return po_fail(PO_CANNOT_READ, "%s: the sum of the weights is not finite", c->csv->path);
  if (!isnan(*constant))
    return PO_OK;
  if (c->has_unit)
    return po_fail(PO_CANNOT_READ, "%s: %s is missing: expected it, as the weights have a unit",
                   c->csv->path, what);
  *constant = 1.0 - sum;
  return *constant > 0.0
             ? PO_OK
             : po_fail(PO_CANNOT_READ,
                       "%s: the sum of the weights is %.15g: expected less than 1, or %s",
                       c->csv->path, sum, what);
}

/* The modulus, Pa, that a relaxed weight is; NAN: its unit is not known. */
static double in_pascal(const columns *c, double relaxed) {
  const char *unit = strchr(c->csv->columns[c->weight], '_');
  if (unit && !c->of_modulus)
    unit = strncasecmp(unit, "_per", strlen("_per")) == 0 ? unit + strlen("_per") : NULL;
  for (int k = 0; unit && k < WEIGHT_COUNT; ++k)
    if (strcasecmp(unit, WEIGHTS[k].name) == 0)
      return c->of_modulus ? relaxed * WEIGHTS[k].size : WEIGHTS[k].size / relaxed;
  return NAN;
}

/* Returned: the terms; in *modulus that of the relaxed body, Pa. */
static po_status read_terms(const columns *c, po_creep_terms *terms, double *modulus) {
  po_creep_terms read;
  double constant;
  po_status status = read_rows(c, &read, &constant);
  if (!status)
    status = find_constant(c, &read, &constant);
  if (status)
    return status;
  if (c->of_modulus) {
    po_creep_of_modulus(constant, &read, terms);
    *modulus = in_pascal(c, constant);
  } else {
    double relaxed = constant;
    for (size_t m = 0; m < read.count; ++m)
      relaxed += read.term[m].weight;
    *terms = read;
    terms->instant = constant / relaxed;
    for (size_t m = 0; m < read.count; ++m)
      terms->term[m].weight /= relaxed;
    *modulus = in_pascal(c, relaxed);
  }
  for (size_t m = 0; m < terms->count; ++m)
    if (!isfinite(terms->term[m].time) || !isnormal(terms->term[m].weight))
      status = PO_CANNOT_READ;
  return status || !isnormal(terms->instant)
             ? po_fail(PO_CANNOT_READ,
                       "%s: the weights differ too much to be converted: expected "
                       "ratios below 1e300",
                       c->csv->path)
             : PO_OK;
}

static void free_table(po_creep_table *t) {
  free(t->path);
  free(t);
}

static po_status make(const char *path, const columns *c, po_creep_table **made) {
  po_creep_table *t = po_allocate(1, sizeof *t);
  if (!t)
    return PO_NO_MEMORY;
  t->path = po_copy_text(path);
  t->in_seconds = c->in_seconds;
  memcpy(t->digest, c->csv->digest, sizeof t->digest);
  const po_status status = t->path ? read_terms(c, &t->terms, &t->relaxed) : PO_NO_MEMORY;
  if (status)
    free_table(t);
  else
    *made = t;
  return status;
}

/* All tables that were read. */
static po_creep_table *tables;

/* The table that was read before from a file with these bytes, or without a file from this pipe. */
static const po_creep_table *find(const char *path, const po_csv *csv, uint64_t pipe) {
  const po_creep_table *t = tables;
  while (t && !(strcmp(t->path, path) == 0 &&
                (csv ? strcmp(t->digest, csv->digest) == 0 : pipe && t->pipe == pipe)))
    t = t->next;
  return t;
}

static po_status read_table(const char *path, uint64_t pipe, const po_creep_table **table) {
  po_csv csv;
  po_status status = po_csv_read_columns(path, path, WANTED, &csv);
  if (status)
    return status;
  columns c = {.csv = &csv};
  status = find_columns(&c);
  *table = status ? NULL : find(path, &csv, pipe);
  if (!status && !*table) {
    po_creep_table *made = NULL;
    status = make(path, &c, &made);
    if (!status) {
      made->pipe = pipe;
      made->next = tables;
      *table = tables = made;
    }
  }
  po_csv_clear(&csv);
  return status;
}

po_status po_creep_table_read(const char *path, const po_creep_table **table) {
  const uint64_t pipe = po_path_pipe(path);
  po_lock_take(PO_LOCK_TABLES);
  *table = find(path, NULL, pipe);
  const po_status status = *table ? PO_OK : read_table(path, pipe, table);
  po_lock_release(PO_LOCK_TABLES);
  return status;
}

void po_creep_table_clear(void) {
  po_lock_take(PO_LOCK_TABLES);
  while (tables) {
    po_creep_table *t = tables;
    tables = t->next;
    free_table(t);
  }
  po_lock_release(PO_LOCK_TABLES);
}
