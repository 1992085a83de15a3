#include "po_moving_edges.h"

#include <math.h>

/* Half width of the interval of constant displacement about a contact edge, relative to the
 * distance to the nearest edge. */
static const double PLATEAU = 0.2;
/* The displacement is zero beyond this multiple of the radius of the outermost contact edge. */
static const double OUTER_END = 2.0;
enum { ITERATIONS = 60 };

/* Largest strain of the displacement to predicted contact edges, and to those of a known solution.
 */
static const double GREATEST_STRAIN = 0.5, GREATEST_STRAIN_BACK = 0.9;

/* The largest slope of blend(). */
static const double STEEPEST = 1.875;

static double neighbour_distance(const po_moving_edges *f, size_t k) {
  const double left = k > 0 ? f->at[k] - f->at[k - 1] : f->at[k];
  const double right = k + 1 < f->count ? f->at[k + 1] - f->at[k] : (OUTER_END - 1.0) * f->at[k];
  return fmin(left, right);
}

/* Rises from 0 to 1; its first two derivatives vanish at both ends. */
static double blend(double x) {
  return x * x * x * (10.0 + x * (6.0 * x - 15.0));
}

/* Returned: the index of the first contact edge at or beyond r. */
static size_t next_edge(const po_moving_edges *f, double r) {
  size_t low = 0, high = f->count;
  while (low < high) {
    const size_t middle = (low + high) / 2;
    if (f->at[middle] < r)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

double po_edge_displacement(const po_moving_edges *f, const double *shift, double r) {
  if (f->count == 0)
    return 0.0;
  const size_t k = next_edge(f, r);
  double from = 0.0,
         value = 0.0; /* end of the last constant interval, and the displacement there */
  if (k > 0) {
    from = f->at[k - 1] + PLATEAU * neighbour_distance(f, k - 1);
    value = shift[k - 1];
    if (r <= from)
      return value;
  }
  const bool last = k == f->count;
  const double begin =
      last ? OUTER_END * f->at[k - 1] : f->at[k] - PLATEAU * neighbour_distance(f, k);
  const double next = last ? 0.0 : shift[k];
  return r < begin ? value + (next - value) * blend((r - from) / (begin - from)) : next;
}

double po_edge_origin(const po_moving_edges *f, const double *shift, double r) {
  double origin = r;
  for (int k = 0; k < ITERATIONS; ++k) { /* contracts: the displacement's slope is below a half */
    const double next = r - po_edge_displacement(f, shift, origin);
    const double change = fabs(next - origin);
    origin = next;
    if (change <= 1e-15 * r)
      break;
  }
  return origin;
}

static double strain(const po_moving_edges *f, const double *shift, size_t *where) {
  double from = 0.0, value = 0.0, worst = 0.0; /* as in po_edge_displacement */
  *where = 0;
  for (size_t k = 0; k <= f->count && f->count > 0; ++k) {
    const bool last = k == f->count;
    const double half = last ? 0.0 : PLATEAU * neighbour_distance(f, k);
    const double begin = last ? OUTER_END * f->at[k - 1] : f->at[k] - half;
    const double next = last ? 0.0 : shift[k];
    const double here = STEEPEST * fabs(next - value) / (begin - from);
    if (here > worst) {
      worst = here;
      *where = k;
    }
    from = last ? begin : f->at[k] + half;
    value = next;
  }
  return worst;
}

double po_edge_strain(const po_moving_edges *f, const double *shift) {
  size_t where;
  return strain(f, shift, &where);
}

bool po_edge_may_move(const po_moving_edges *f, const double *shift) {
  return po_edge_strain(f, shift) < GREATEST_STRAIN;
}

bool po_edge_may_relate(const po_moving_edges *f, const double *shift) {
  return po_edge_strain(f, shift) < GREATEST_STRAIN_BACK;
}

size_t po_edge_tightest(const po_moving_edges *f, const double *shift) {
  size_t where;
  strain(f, shift, &where);
  return where;
}
