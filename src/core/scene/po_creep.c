#include "po_creep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_creep_table.h"
#include "po_elementary.h"
#include "po_number.h"
#include "po_parameters.h"

/* Exponents of the Gamma spectrum, at least and at most. With a smaller one, most of the spectrum
 * is at times shorter than those of any test. */
static const double LEAST_EXPONENT = 0.05, GREATEST_EXPONENT = 10.0;

const char *po_creep_file_of(const char *text) {
  static const char PRONY[] = "prony:";
  const size_t length = strlen(PRONY);
  return strncmp(text, PRONY, length) == 0 && text[length] ? text + length : NULL;
}

static po_status read_file(const char *path, po_creep *creep) {
  if (strlen(path) > PO_CREEP_PATH_LENGTH)
    return po_fail(PO_CANNOT_READ, "the path of a material has %zu bytes: expected at most %d",
                   strlen(path), PO_CREEP_PATH_LENGTH);
  const po_creep_table *table;
  const po_status status = po_creep_table_read(path, &table);
  if (!status)
    *creep = (po_creep){.kind = PO_CREEP_PRONY, .ratio = table->terms.instant, .table = table};
  return status;
}

po_status po_creep_read(const char *text, po_creep *creep) {
  static const char SLS[] = "sls:", GAMMA[] = "gamma:";
  double value[2] = {NAN, 1.0};
  po_creep_kind kind = PO_CREEP_NONE;
  if (po_creep_file_of(text))
    return read_file(po_creep_file_of(text), creep);
  if (strncmp(text, SLS, strlen(SLS)) == 0 && po_parameters_read(text + strlen(SLS), 1, value))
    kind = PO_CREEP_SLS;
  else if (strncmp(text, GAMMA, strlen(GAMMA)) == 0 &&
           po_parameters_read(text + strlen(GAMMA), 2, value))
    kind = PO_CREEP_GAMMA;
  if (kind == PO_CREEP_NONE || !(value[0] > 0.0 && value[0] <= 1.0) ||
      !(value[1] >= LEAST_EXPONENT && value[1] <= GREATEST_EXPONENT))
    return PO_BAD_INPUT;
  *creep = (po_creep){.kind = kind, .ratio = value[0], .exponent = value[1]};
  return PO_OK;
}

void po_creep_write(const po_creep *creep, char text[PO_CREEP_TEXT]) {
  char ratio[PO_NUMBER_LENGTH], exponent[PO_NUMBER_LENGTH];
  po_number_print(creep->ratio, ratio);
  po_number_print(creep->exponent, exponent);
  if (creep->kind == PO_CREEP_SLS)
    snprintf(text, PO_CREEP_TEXT, "sls:%s", ratio);
  else if (creep->kind == PO_CREEP_GAMMA)
    snprintf(text, PO_CREEP_TEXT, "gamma:%s,%s", ratio, exponent);
  else
    snprintf(text, PO_CREEP_TEXT, "prony:%s", creep->shown ? creep->shown : creep->table->path);
}

void po_creep_write_identity(const po_creep *creep, char text[PO_CREEP_TEXT]) {
  po_creep identity = *creep;
  identity.shown = creep->table ? creep->table->digest : NULL;
  po_creep_write(&identity, text);
}

const char *po_creep_file(const po_creep *creep) {
  return creep->table ? creep->table->path : NULL;
}

bool po_creep_is_in_seconds(const po_creep *creep) {
  return creep->table && creep->table->in_seconds;
}

double po_creep_relaxed(const po_creep *creep) {
  return creep->table ? creep->table->relaxed : (double)NAN;
}

/* Spacing of the trapezoidal rule in u = ln(tau): its error goes as exp(-pi^2/SPACING), 2e-11, as
 * the integrand exp(n u - e^u - t e^-u) is analytic for |Im u| < pi/2. The spectrum ends where
 * tau^n exp(-tau) is 1e-12 of its integral, and at times shorter than SHORTEST of the duration. */
static const double SPACING = 0.4, SHORTEST = 1e-6, LONGEST = 40.0;

/* Terms of the Gamma spectrum; those that are shorter than `least` are one term. The sum of the
 * weights is made 1, which takes the place of Gamma(n). */
static void fill_gamma(const po_creep *creep, double least, po_creep_terms *terms) {
  const double n = creep->exponent, from = po_log(least);
  const double to = po_log(LONGEST + 4.0 * n);
  const size_t count = (size_t)fmin(ceil((to - from) / SPACING) + 1.0, (double)PO_MOST_CREEP_TERMS);
  double sum = 0.0;
  for (size_t m = 0; m < count; ++m) {
    const double u = to - SPACING * (double)(count - 1 - m);
    const double weight = po_exp(n * u - po_exp(u));
    /* the rest of the rule is a geometric series as long as exp(-tau) is 1 */
    const double rest = m == 0 ? 1.0 / -po_expm1(-n * SPACING) : 1.0;
    terms->term[m] = (po_creep_term){po_exp(u), weight * rest};
    sum += weight * rest;
  }
  for (size_t m = 0; m < count; ++m)
    terms->term[m].weight *= (1.0 - creep->ratio) / sum;
  terms->count = count;
}

void po_creep_terms_fill(const po_creep *creep, double duration, po_creep_terms *terms) {
  if (creep->kind == PO_CREEP_PRONY) {
    *terms = creep->table->terms;
    return;
  }
  terms->instant = creep->ratio;
  if (creep->kind == PO_CREEP_GAMMA) {
    fill_gamma(creep, fmin(SHORTEST, SHORTEST * duration), terms);
    return;
  }
  terms->count = 1;
  terms->term[0] = (po_creep_term){1.0, 1.0 - creep->ratio};
}

double po_creep_mean_time(const po_creep *creep) {
  if (creep->kind != PO_CREEP_PRONY)
    return creep->kind == PO_CREEP_GAMMA ? creep->exponent : 1.0;
  const po_creep_terms *terms = &creep->table->terms;
  double sum = 0.0;
  for (size_t m = 0; m < terms->count; ++m)
    sum += terms->term[m].weight * terms->term[m].time;
  return sum / (1.0 - terms->instant);
}

double po_creep_compliance(const po_creep_terms *terms, double t) {
  double sum = terms->instant;
  for (size_t m = 0; m < terms->count; ++m)
    sum -= terms->term[m].weight * po_expm1(-t / terms->term[m].time);
  return sum;
}
