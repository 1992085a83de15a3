#include "po_times.h"

#include <math.h>
#include <stdlib.h>

/* The time of a long solve is already a mean over disturbances of the machine. Of the 168 points of
 * the case precision, 36 take longer; to solve them two times more would take three fifths of the
 * time of the case. */
static const double ENOUGH = 1.0;

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
