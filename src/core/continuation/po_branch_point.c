#include "po_branch_point.h"

#include <math.h>

#include "po_elementary.h"
#include "po_hermite.h"

/* The error of the cubic is proportional to t^2 (1 - t)^2: ratio of the largest to the mean value.
 */
static const double LARGEST_OF_MEAN = 30.0 / 16.0;

static double chord(const po_branch_point *from, const po_branch_point *to) {
  return po_hypot(to->approach - from->approach, to->load - from->load);
}

double po_join_sagitta(const po_branch_point *from, const po_branch_point *to) {
  const double cross = from->approach_rate * to->load_rate - from->load_rate * to->approach_rate;
  const double dot = from->approach_rate * to->approach_rate + from->load_rate * to->load_rate;
  return 0.125 * fabs(po_atan2(cross, dot)) * chord(from, to);
}

double po_join_miss(const po_branch_point *from, const po_branch_point *to) {
  const double way = to->position - from->position;
  const po_cubic_ends approach = {from->approach, way * from->approach_rate, to->approach,
                                  way * to->approach_rate};
  const po_cubic_ends load = {from->load, way * from->load_rate, to->load, way * to->load_rate};
  const double area = to->energy - from->energy - po_hermite_integral(&load, &approach, 0.0, 1.0);
  return LARGEST_OF_MEAN * fabs(area) / chord(from, to);
}
