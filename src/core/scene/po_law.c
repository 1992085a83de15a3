#include "po_law.h"

#include <math.h>

#include "po_law_kind.h"
#include "po_parameters.h"
#include "po_root.h"

#define KIND(law, text) &PO_##law,
static const po_law_kind *const KINDS[] = {PO_LAW_ROWS(KIND)};
enum { KIND_COUNT = sizeof KINDS / sizeof *KINDS };

#define NAME(parameter, name) name,
static const char *const PARAMETERS[] = {PO_LAW_PARAMETER_ROWS(NAME)};

static const po_law_kind *kind_of(const po_law *law) {
  return law->kind ? law->kind : &PO_LENNARD_JONES;
}

static void derive(po_law *law) {
  law->numbers = kind_of(law)->numbers;
  if (kind_of(law)->derive)
    kind_of(law)->derive(law);
}

po_law po_law_lennard_jones(void) {
  po_law law = {.kind = &PO_LENNARD_JONES};
  for (size_t k = 0; k < PO_LAW_PARAMETER_COUNT; ++k)
    law.parameter[k] = NAN;
  derive(&law);
  return law;
}

bool po_law_set(po_law *law, const char *text) {
  const char *rest;
  for (size_t k = 0; k < KIND_COUNT; ++k) {
    if (!po_parameters_follow(text, KINDS[k]->name, &rest))
      continue;
    po_law read = *law;
    read.kind = KINDS[k];
    if (rest && (!KINDS[k]->parameters ||
                 !po_parameters_read(rest, KINDS[k]->parameters, read.parameter + KINDS[k]->first)))
      return false;
    derive(&read);
    *law = read;
    return true;
  }
  return false;
}

void po_law_set_parameter(po_law *law, po_law_parameter parameter, double value) {
  law->parameter[parameter] = value;
  derive(law);
}

const char *po_law_name(const po_law *law) {
  return kind_of(law)->name;
}

size_t po_law_index(const po_law *law) {
  size_t index = 0;
  while (KINDS[index] != kind_of(law))
    ++index;
  return index;
}

bool po_law_has(const po_law *law, po_law_parameter parameter) {
  const po_law_kind *kind = kind_of(law);
  return parameter >= kind->first && parameter < kind->first + kind->parameters;
}

po_status po_law_require(const po_law *law, po_law_parameter parameter) {
  return isnan(law->parameter[parameter])
             ? po_fail(PO_BAD_INPUT, "%s is not given: expected it with the law %s",
                       PARAMETERS[parameter], po_law_name(law))
             : PO_OK;
}

po_status po_law_check(const po_law *law) {
  return kind_of(law)->check ? kind_of(law)->check(law) : PO_OK;
}

po_law_value po_law_at(const po_law *law, double gap) {
  return kind_of(law)->at(law, gap);
}

po_dd po_law_traction(const po_law *law, double gap) {
  return kind_of(law)->traction(law, gap);
}

po_law_value po_law_averaged(const po_law *law, double gap, double amplitude) {
  return kind_of(law)->averaged(law, gap, amplitude);
}

double po_law_energy(const po_law *law, double gap) {
  return kind_of(law)->energy(law, gap);
}

double po_law_energy_averaged(const po_law *law, double gap, double amplitude) {
  return kind_of(law)->energy_averaged(law, gap, amplitude);
}

po_law_scale po_law_scale_at(const po_law *law, double gap) {
  return kind_of(law)->scale ? kind_of(law)->scale(law, gap) : (po_law_scale){1.0 + gap, 1.0};
}

double po_law_size(const po_law *law, double gap) {
  return po_law_scale_at(law, gap).size;
}

po_law_closeness po_law_closeness_at(const po_law *law, double gap) {
  return gap > 0.0 ? kind_of(law)->closeness(law, gap) : (po_law_closeness){1.0, 0.0};
}

const po_law_numbers *po_law_numbers_of(const po_law *law) {
  return law->kind ? &law->numbers : &PO_LENNARD_JONES.numbers;
}

double po_law_expected_gap(const po_law *law, double gap) {
  return fmax(gap, po_law_numbers_of(law)->least);
}

typedef struct {
  const po_law *law;
  double energy;
} sought;

static double excess_energy(double approach, const void *data) {
  const sought *s = data;
  return po_law_energy(s->law, -approach) - s->energy;
}

/* The longest rigid trace ends at this part of the greatest overlap: even the sharpest crests repel
 * before they are so near to the singularity. */
static const double TRACED_PART = 0.999;

/* The load of a rigid paraboloid is 2 phi. */
double po_law_approach_of_push(const po_law *law, double share, double load) {
  const po_law_kind *kind = kind_of(law);
  const sought s = {law, 0.5 * load / share};
  const double most = -TRACED_PART * po_law_numbers_of(law)->closest;
  if (kind->approach_of_push)
    return fmin(kind->approach_of_push(share, load), most);
  return excess_energy(most, &s) > 0.0 ? po_root(excess_energy, &s, 0.0, most) : most;
}
