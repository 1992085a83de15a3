#include "po_print_uncertain.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_profile_table.h"

/* Uncertainty of a table, eps, from which on it may move a force by a percent. */
static const double NOISY = 0.02;

void po_print_smoothing(const po_profile *profile) {
  const po_smoothing *s = &profile->table->smoothing;
  if (!s->knots && profile->table->uncertainty > NOISY)
    printf("         rows with noise are smoothed with its standard deviation, --smooth SIGMA or "
           "auto\n");
  if (!s->knots)
    return;
  const double unit = profile->table->scale;
  printf("smoothed noise %.4g of the rows %s, residuals %.4g; removed: rms %.4g, greatest %.4g, in "
         "the unit of the file; %.1f of %zu parameters are left\n",
         s->deviation / unit, isinf(profile->table->smooth) ? "estimated" : "stated",
         s->residual / unit, s->rms / unit, s->greatest / unit, s->parameters, s->points);
}

/* A number with two significant digits, "1500". */
static double rounded(double value) {
  char text[32];
  snprintf(text, sizeof text, "%.2g", value);
  return strtod(text, NULL);
}

static void print_source(const po_uncertain *u, double unit, const char *name) {
  if (strcmp(u->source, "noise") == 0)
    printf("uncertain noise of the profile: ");
  else
    printf("uncertain %s %.6g+-%.6g: ", u->source, u->value, u->deviation);
  if (!isnan(u->force))
    printf("force +-%g %s\n", rounded(u->force * unit), name);
  else if (isnan(u->below) || isnan(u->above))
    printf("unknown, because the solve with the input %s by twice its uncertainty failed\n",
           isnan(u->below) ? "less" : "more");
  else
    printf("no number, because the force is not linear there: it changes by %g %s with the input "
           "less by twice its uncertainty, by %g with the input more\n",
           rounded(u->below * unit), name, rounded(u->above * unit));
}

void po_print_uncertain(const po_result *result, double unit, const char *name) {
  for (size_t k = 0; k < result->uncertain_count; ++k)
    print_source(&result->uncertain[k], unit, name);
  if (result->uncertain_count > 1 && !isnan(result->uncertainty))
    printf("uncertain all together: force +-%g %s, the root of the sum of squares\n",
           rounded(result->uncertainty * unit), name);
}
