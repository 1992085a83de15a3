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

typedef struct {
  const char *text, *name;
  int thousands; /* 1000 to this power */
} prefix;
static const prefix PREFIXES[] = {{"y", "y", -8}, {"z", "z", -7}, {"a", "a", -6}, {"f", "f", -5},
                                  {"p", "p", -4}, {"n", "n", -3}, {"µ", "u", -2}, {"m", "m", -1},
                                  {"", "", 0},    {"k", "k", 1},  {"M", "M", 2},  {"G", "G", 3},
                                  {"T", "T", 4},  {"P", "P", 5},  {"E", "E", 6}},
                    NONE = {"", "", 0};
enum { PREFIX_COUNT = sizeof PREFIXES / sizeof *PREFIXES };

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

static po_si_unit unit_with(const po_units *u, po_dimension dimension, const prefix *with) {
  const double factor = size_of(dimension, u->length, u->force, u->traction);
  const double power = thousands(abs(with->thousands));
  po_si_unit unit = {.factor = with->thousands < 0 ? factor * power : factor / power,
                     .shift = dimension == PO_DIMENSION_GAP};
  snprintf(unit.text, sizeof unit.text, "%s%s", with->text, BASE[dimension].text);
  snprintf(unit.name, sizeof unit.name, "%s%s", with->name, BASE[dimension].name);
  return unit;
}

po_si_unit po_si_unit_of(const po_units *units, po_dimension dimension) {
  po_si_unit unit = unit_with(units, dimension, &NONE);
  snprintf(unit.name, sizeof unit.name, "%s", BASE[dimension].key);
  return unit;
}

/* The greatest prefix with which a size is at least `least`; the smallest one of smaller sizes. */
static const prefix *prefix_of(po_dimension dimension, double size, double least) {
  const prefix *with = *BASE[dimension].text ? PREFIXES : &NONE;
  for (int k = 0; k < PREFIX_COUNT && with != &NONE; ++k)
    if (size >= least * thousands(PREFIXES[k].thousands))
      with = &PREFIXES[k];
  return with;
}

po_si_unit po_si_prefixed(const po_units *units, po_dimension dimension) {
  const double tabor = units->tension / units->traction; /* 0 for a rigid scene */
  const double length =
      units->usual_length > 0 ? units->usual_length : units->length * fmax(1.0, tabor);
  const double force = units->usual_force > 0 ? units->usual_force : units->force;
  const double size = size_of(dimension, length, force, units->tension);
  return unit_with(units, dimension, prefix_of(dimension, size, is_length(dimension) ? 0.1 : 1.0));
}

po_si_unit po_si_readable(const po_units *units, po_dimension dimension, double greatest) {
  const po_si_unit usual = po_si_prefixed(units, dimension);
  const double shown = fabs(greatest) * usual.factor,
               size = fabs(greatest) *
                      size_of(dimension, units->length, units->force, units->traction);
  const bool is_readable = shown >= 0.1 && shown < 1000.0;
  return is_readable || !(shown > 0.0 && isfinite(size))
             ? usual
             : unit_with(units, dimension, prefix_of(dimension, size, 1.0));
}

/* An approach of this part of epsilon is 0 but for rounding, as that of the pull-off of a rigid
 * sphere. */
static const double ROUNDING = 1e-12;

po_si_unit po_si_readable_approach(const po_units *units, double greatest) {
  return po_si_readable(units, PO_DIMENSION_LENGTH, greatest < ROUNDING ? 0.0 : greatest);
}

void po_si_take(double *greatest, double number) {
  if (isfinite(number))
    *greatest = fmax(*greatest, fabs(number));
}

double po_si_value(const po_si_unit *unit, double number) {
  return (unit->shift != 0.0 ? number + unit->shift : number) * unit->factor; /* -0 stays -0 */
}

bool po_si_parse(const char *name, size_t *stem, po_dimension *dimension, double *size) {
  const size_t length = strlen(name);
  size_t longest = 0;
  for (int d = PO_DIMENSION_LENGTH; d < PO_DIMENSION_COUNT; ++d)
    for (int k = -1; k < PREFIX_COUNT; ++k) { /* -1: as keys have it, in lower case */
      const prefix *with = k < 0 ? &NONE : &PREFIXES[k];
      char end[16];
      snprintf(end, sizeof end, "_%s%s", with->name, k < 0 ? BASE[d].key : BASE[d].name);
      const size_t of_end = strlen(end);
      if (of_end <= longest || of_end >= length || strcmp(name + length - of_end, end) != 0)
        continue;
      longest = of_end;
      *stem = length - of_end;
      *dimension = (po_dimension)d;
      *size = thousands(with->thousands);
    }
  return longest > 0;
}
