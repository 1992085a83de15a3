#include "po_print_series.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_input.h"
#include "po_json.h"
#include "po_json_digest.h"
#include "po_print.h"
#include "po_si.h"
#include "po_tables.h"
#include "po_text.h"

static bool is_physical(const po_printed_series *series) {
  return series->requests[0].in_si;
}

/* The factors from epsilon and the unit of the load to the units of a table. */
static po_units shown_units(const po_request *request) {
  return request->in_si ? request->units : (po_units){.length = 1, .force = 1};
}

/* The units in which the numbers of all scenes are printed. */
typedef struct {
  po_si_unit approach, load, radius;
} printed;

static void take_greatest(double greatest[3], const po_units *unit, double approach, double load,
                          double radius) {
  po_si_take(&greatest[0], approach * unit->length);
  po_si_take(&greatest[1], load * unit->force);
  po_si_take(&greatest[2], radius * unit->length);
}

static printed units_of(const po_printed_series *series, bool folds) {
  double greatest[3] = {0}; /* in SI units */
  const po_units *first = &series->requests[0].units;
  if (!is_physical(series))
    return (printed){0};
  for (size_t k = 0; k < series->count; ++k) {
    const po_result *result = &series->results[k];
    const po_units unit = shown_units(&series->requests[k]);
    if (!folds && result->has_pull_off)
      take_greatest(greatest, &unit, result->pull_off.approach, result->pull_off.force,
                    result->pull_off.contact_radius);
    for (size_t i = 0; folds && i < result->fold_count; ++i)
      take_greatest(greatest, &unit, result->folds[i].approach, result->folds[i].load,
                    result->folds[i].contact_radius);
  }
  return (printed){po_si_readable_approach(first, greatest[0] / first->length),
                   po_si_readable(first, PO_DIMENSION_LOAD, greatest[1] / first->force),
                   po_si_readable(first, PO_DIMENSION_LENGTH, greatest[2] / first->length)};
}

/* The factors of the numbers of a scene. */
typedef struct {
  double approach, load, radius;
} factors;

static factors factors_of(const po_printed_series *series, const printed *p, size_t k) {
  const po_units u = shown_units(&series->requests[k]), *first = &series->requests[0].units;
  if (!is_physical(series))
    return (factors){1.0, 1.0, 1.0};
  return (factors){u.length * (p->approach.factor / first->length),
                   u.force * (p->load.factor / first->force),
                   u.length * (p->radius.factor / first->length)};
}

static void print_units(const po_printed_series *series, const printed *p) {
  if (is_physical(series) && strcmp(p->approach.text, p->radius.text) != 0)
    printf("units    approaches in %s, contact radii in %s, loads and forces in %s\n",
           p->approach.text, p->radius.text, p->load.text);
  else if (is_physical(series))
    printf("units    lengths in %s, loads and forces in %s\n", p->approach.text, p->load.text);
  else
    printf("units    lengths in epsilon, loads and forces in %s\n",
           po_input_load_unit(&series->requests[0]));
}

static void print_row(const po_printed_series *series, const printed *p, size_t k) {
  const po_result *result = &series->results[k];
  const factors unit = factors_of(series, p, k);
  const char *numbers = is_physical(series) ? "%14.10g %8.1e %16.10g %8.1e %14.6g "
                                            : "%14.9f %8.1e %16.9f %8.1e %14.6g ";
  printf("%15g ", series->values[k]);
  if (result->has_pull_off)
    printf(numbers, result->pull_off.force * unit.load, result->pull_off.force_error * unit.load,
           result->pull_off.approach * unit.approach,
           result->pull_off.approach_error * unit.approach,
           result->pull_off.contact_radius * unit.radius);
  printf("%-9s %14llu\n",
         result->status     ? po_status_name(result->status)
         : result->followed ? "followed"
                            : "traced",
         (unsigned long long)result->work.factorizations);
}

static unsigned long long factorizations(const po_printed_series *series) {
  unsigned long long all = 0;
  for (size_t k = 0; k < series->count; ++k)
    all += series->results[k].work.factorizations;
  return all;
}

/* The document of schema "pulloff-line/1". Returned: NULL if memory runs out. */
static json_t *document_of(const po_printed_series *series) {
  json_t *points = po_json_empty_array();
  for (size_t k = 0; k < series->count; ++k) {
    const po_request *request = &series->requests[k];
    const po_result *result = &series->results[k];
    json_t *point = po_json_result(request, result);
    if (is_physical(series))
      po_json_set(&point, "physical", po_json_physical(&series->scenes[k].given, request, result));
    po_json_append(&points, point);
  }
  json_t *document = PO_JSON_OBJECT({"schema", po_json_text("pulloff-line/1")}, {"points", points});
  po_json_seal(&document);
  return document;
}

static po_status print_rows(const po_printed_series *series) {
  const printed p = units_of(series, false);
  print_units(series, &p);
  printf("%15s %14s %8s %16s %8s %14s %-9s %14s\n", series->name, "force", "error", "approach",
         "error", "contact radius", "obtained", "factorisations");
  size_t followed = 0, exceeded = 0;
  for (size_t k = 0; k < series->count; ++k) {
    print_row(series, &p, k);
    followed += series->results[k].followed;
    exceeded += series->results[k].pull_off.excess > 1.0;
  }
  if (exceeded)
    printf("warning  the error of the force is more than the tolerance in %zu of these scenes\n",
           exceeded);
  printf("work     %llu %s for %zu %s, %zu of them followed\n", factorizations(series),
         po_one_or_more((size_t)factorizations(series), "factorisation", "factorisations"),
         series->count, po_one_or_more(series->count, "scene", "scenes"), followed);
  return po_print_digest(document_of(series));
}

/* Prints the rows of one fold, up to that in which it has ended. */
static void print_fold(const po_printed_series *series, const printed *p, size_t index) {
  const char *numbers = is_physical(series) ? "%16.10g %8.1e %14.10g %8.1e %14.6g\n"
                                            : "%16.10f %8.1e %14.10f %8.1e %14.6g\n";
  bool there = true;
  for (size_t k = 0; k < series->count && there; ++k) {
    const po_special_point *fold = &series->results[k].folds[index];
    const factors unit = factors_of(series, p, k);
    there = !isnan(fold->approach);
    printf("%-9s %15g ", PO_SPECIAL_KINDS[fold->kind], series->values[k]);
    if (there)
      printf(numbers, fold->approach * unit.approach, fold->approach_error * unit.approach,
             fold->load * unit.load, fold->load_error * unit.load,
             fold->contact_radius * unit.radius);
    else
      printf("%16s\n", "ended");
  }
}

static po_status print_folds(const po_printed_series *series) {
  const size_t folds = series->results[0].fold_count;
  const printed p = units_of(series, true);
  print_units(series, &p);
  printf("%-9s %15s %16s %8s %14s %8s %14s\n", "fold", series->name, "approach", "error", "load",
         "error", "contact radius");
  for (size_t index = 0; index < folds; ++index)
    print_fold(series, &p, index);
  printf("work     %llu %s for %zu %s of %zu %s\n", factorizations(series),
         po_one_or_more((size_t)factorizations(series), "factorisation", "factorisations"), folds,
         po_one_or_more(folds, "fold", "folds"), series->count,
         po_one_or_more(series->count, "scene", "scenes"));
  return po_print_digest(document_of(series));
}

po_status po_print_series(const po_printed_series *series, bool folds, bool json,
                          const char *curve) {
  po_status status = PO_OK;
  if (json)
    status = po_print_document(document_of(series));
  else if (folds && !series->results[0].status)
    status = print_folds(series);
  else if (!folds && !(curve && strcmp(curve, "-") == 0))
    status = print_rows(series);
  fflush(stdout);
  return status || !curve
             ? status
             : po_tables_write_series(curve, series->name, series->values, series->requests,
                                      series->results, series->count);
}
