/* The values of a sweep: as written, or made from their ends and their number. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_case_parse.h"
#include "po_memory.h"
#include "po_schema.h"

/* Values made from the ends are rounded to so many significant digits, as drawn ones are: the line
 * that solves one point again is exact, and libraries whose pow differs in the last bit agree. */
enum { MADE_DIGITS = 6 };

static const size_t MOST_VALUES = 10000;

typedef struct {
  double from, to;
  size_t count;
  bool log;
} range;

static po_status parse_range(const po_axis *axis, const char *where, const po_yaml *yaml,
                             range *r) {
  if (!axis->from_text || !po_number_parse(axis->from_text, &r->from))
    return po_schema_refuse(yaml, NULL, "%s.from", where);
  if (!axis->to_text || !po_number_parse(axis->to_text, &r->to) || !(r->to > r->from))
    return po_schema_refuse(yaml, NULL, "%s.to", where);
  if (!axis->count_text || !po_number_parse_count(axis->count_text, &r->count) || r->count < 2 ||
      r->count > MOST_VALUES)
    return po_schema_refuse(yaml, NULL, "%s.count", where);
  r->log = axis->scale && strcmp(axis->scale, "log") == 0;
  if (axis->scale && !r->log && strcmp(axis->scale, "linear") != 0)
    return po_schema_refuse(yaml, NULL, "%s.scale", where);
  if (r->log && r->from <= 0)
    return po_schema_refuse(yaml, "a finite number > 0, as the scale is log", "%s.from", where);
  return PO_OK;
}

static double value_at(const range *r, size_t index) {
  const double part = (double)index / (double)(r->count - 1);
  return r->log ? r->from * pow(r->to / r->from, part) : r->from + part * (r->to - r->from);
}

po_status po_axis_fill(po_axis *axis, const char *where, const po_yaml *yaml) {
  range r = {0};
  const bool ranged = axis->from_text || axis->to_text || axis->count_text || axis->scale;
  if (axis->values)
    return ranged ? po_schema_refuse(yaml, "nothing beside from, to and count", "%s.values", where)
                  : PO_OK;
  if (!ranged)
    return po_schema_refuse(yaml, "a list of values, or from, to and count", "%s.values", where);
  const po_status status = parse_range(axis, where, yaml, &r);
  if (status)
    return status;
  axis->values = po_allocate(r.count, sizeof *axis->values);
  if (!axis->values)
    return PO_NO_MEMORY;
  for (; axis->values_count < r.count; ++axis->values_count) {
    char text[PO_NUMBER_LENGTH];
    snprintf(text, sizeof text, "%.*g", MADE_DIGITS, value_at(&r, axis->values_count));
    char *copy = po_copy_text(text);
    if (!copy)
      return PO_NO_MEMORY;
    axis->values[axis->values_count] = copy;
  }
  return PO_OK;
}
