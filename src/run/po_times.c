#include "po_times.h"

#include <math.h>
#include <stdlib.h>

/* Seconds. The time of a long solve is already a mean over disturbances of the machine: in the case
 * precision, beside other work on the same cores, the processor times of a point that takes between
 * a tenth and a quarter of a second differ by 1.6 % (median), those of shorter ones by 3 to 6 %. */
static const double ENOUGH = 0.1;

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

double po_times_median(const double *seconds, unsigned count) {
  double sorted[1000]; /* the greatest value of `repeats` */
  unsigned known = 0;
  for (unsigned i = 0; i < count; ++i)
    if (!isnan(seconds[i]))
      sorted[known++] = seconds[i];
  if (known == 0)
    return (double)NAN;
  qsort(sorted, known, sizeof *sorted, ascending);
  return known % 2 ? sorted[known / 2] : (sorted[known / 2 - 1] + sorted[known / 2]) / 2;
}

bool po_times_are_enough(const double *seconds, unsigned round) {
  double spent = 0.0;
  for (unsigned i = 0; i < round; ++i)
    spent += isnan(seconds[i]) ? 0.0 : seconds[i];
  return spent >= ENOUGH;
}
