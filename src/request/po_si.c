#include "po_si.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct {
  const char *text, *name, *key;
} BASE[PO_DIMENSION_COUNT] = {[PO_DIMENSION_NONE] = {"", "", ""},
                              [PO_DIMENSION_TIME] = {"", "", ""},
                              [PO_DIMENSION_LENGTH] = {"m", "m", "m"},
                              [PO_DIMENSION_GAP] = {"m", "m", "m"},
                              [PO_DIMENSION_LOAD] = {"N", "N", "n"},
                              [PO_DIMENSION_ENERGY] = {"J", "J", "j"},
                              [PO_DIMENSION_TRACTION] = {"Pa", "Pa", "pa"},
                              [PO_DIMENSION_STIFFNESS] = {"N/m", "N_per_m", "n_per_m"}};

/* Every third power of ten, from 1e-24. */
static const struct {
  const char *text, *name;
} PREFIX[] = {{"y", "y"}, {"z", "z"}, {"a", "a"}, {"f", "f"}, {"p", "p"},
              {"n", "n"}, {"µ", "u"}, {"m", "m"}, {"", ""},   {"k", "k"},
              {"M", "M"}, {"G", "G"}, {"T", "T"}, {"P", "P"}, {"E", "E"}};
enum { NO_PREFIX = 8, PREFIX_COUNT = sizeof PREFIX / sizeof *PREFIX };

static bool is_length(po_dimension dimension) {
  return dimension == PO_DIMENSION_LENGTH || dimension == PO_DIMENSION_GAP;
}

/* The value of a dimension in SI units for one length, force and traction. */
static double size_of(po_dimension dimension, double length, double force, double traction) {
  switch (dimension) {
  case PO_DIMENSION_LENGTH:
  case PO_DIMENSION_GAP:
    return length;
  case PO_DIMENSION_LOAD:
    return force;
  case PO_DIMENSION_ENERGY:
    return force * length;
  case PO_DIMENSION_STIFFNESS:
    return force / length;
  case PO_DIMENSION_TRACTION:
    return traction;
  default:
    return 1.0;
  }
}

/* 1000^count, without rounding up to 1e21. */
static double thousands(int count) {
  double power = 1.0;
  for (int k = 0; k < abs(count); ++k)
    power *= 1000.0;
  return count < 0 ? 1.0 / power : power;
}

static po_si_unit unit_with(const po_units *u, po_dimension dimension, int prefix) {
  const double factor = size_of(dimension, u->length, u->force, u->traction);
  const double power = thousands(abs(prefix - NO_PREFIX));
  po_si_unit unit = {.factor = prefix < NO_PREFIX ? factor * power : factor / power,
                     .shift = dimension == PO_DIMENSION_GAP};
  snprintf(unit.text, sizeof unit.text, "%s%s", PREFIX[prefix].text, BASE[dimension].text);
  snprintf(unit.name, sizeof unit.name, "%s%s", PREFIX[prefix].name, BASE[dimension].name);
  return unit;
}

po_si_unit po_si_unit_of(const po_units *units, po_dimension dimension) {
  po_si_unit unit = unit_with(units, dimension, NO_PREFIX);
  snprintf(unit.name, sizeof unit.name, "%s", BASE[dimension].key);
  return unit;
}

po_si_unit po_si_prefixed(const po_units *units, po_dimension dimension) {
  const double tabor = units->tension / units->traction; /* 0 for a rigid scene */
  const double size =
      size_of(dimension, units->length * fmax(1.0, tabor), units->force, units->tension);
  const double least = is_length(dimension) ? 0.1 : 1.0;
  int prefix = *BASE[dimension].text ? 0 : NO_PREFIX;
  while (prefix + 1 < PREFIX_COUNT && *BASE[dimension].text &&
         size >= least * thousands(prefix + 1 - NO_PREFIX))
    ++prefix;
  return unit_with(units, dimension, prefix);
}

double po_si_value(const po_si_unit *unit, double number) {
  return (unit->shift != 0.0 ? number + unit->shift : number) * unit->factor; /* -0 stays -0 */
}

bool po_si_parse(const char *name, size_t *stem, po_dimension *dimension, double *size) {
  const size_t length = strlen(name);
  size_t longest = 0;
  for (int d = PO_DIMENSION_LENGTH; d < PO_DIMENSION_COUNT; ++d)
    for (int prefix = -1; prefix < PREFIX_COUNT;
         ++prefix) { /* -1: as keys have it, in lower case */
      char end[16];
      snprintf(end, sizeof end, "_%s%s", prefix < 0 ? "" : PREFIX[prefix].name,
               prefix < 0 ? BASE[d].key : BASE[d].name);
      const size_t of_end = strlen(end);
      if (of_end <= longest || of_end >= length || strcmp(name + length - of_end, end) != 0)
        continue;
      longest = of_end;
      *stem = length - of_end;
      *dimension = (po_dimension)d;
      *size = prefix < 0 ? 1.0 : thousands(prefix - NO_PREFIX);
    }
  return longest > 0;
}
