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
  return left < right ? left : right; /* a call of fmin costs ten times as much */
}

/* Rises from 0 to 1; its first two derivatives vanish at both ends. */
static double blend(double x) {
  return x * x * x * (10.0 + x * (6.0 * x - 15.0));
}

static double blend_slope(double x) {
  return 30.0 * x * x * (1.0 - x) * (1.0 - x);
}

/* Returned: the index of the first contact edge at or beyond r. Given: near, an index to try first.
 */
static size_t next_edge(const po_moving_edges *f, double r, size_t near) {
  if (near <= f->count && (near == 0 || f->at[near - 1] < r) &&
      (near == f->count || !(f->at[near] < r)))
    return near;
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

/* Finds the place of a radius between the contact edges. Given: near, as above. */
static void find(const po_moving_edges *f, double r, size_t near, po_edge_place *p) {
  const size_t k = next_edge(f, r, near);
  p->r = r;
  p->outer = k;
  p->weight = p->weight_slope = 0.0;
  if (f->count == 0)
    return;
  const double from = k > 0 ? f->at[k - 1] + PLATEAU * neighbour_distance(f, k - 1) : 0.0;
  if (k > 0 && r <= from)
    return;
  const double begin =
      k == f->count ? OUTER_END * f->at[k - 1] : f->at[k] - PLATEAU * neighbour_distance(f, k);
  if (r < begin) {
    const double x = (r - from) / (begin - from);
    p->weight = blend(x);
    p->weight_slope = blend_slope(x) / (begin - from);
  } else {
    p->weight = 1.0;
  }
}

static double inner_shift(const po_edge_place *p, const double *shift) {
  return p->outer > 0 ? shift[p->outer - 1] : 0.0;
}

static double outer_shift(const po_edge_place *p, const double *shift) {
  return p->outer < p->count ? shift[p->outer] : 0.0;
}

double po_edge_displacement(const po_edge_place *p, const double *shift) {
  const double outer = outer_shift(p, shift);
  if (!(p->weight < 1.0))
    return outer;
  const double inner = inner_shift(p, shift);
  return inner + p->weight * (outer - inner);
}

/* Newton's method; where the curvature of the displacement hinders it, the iteration that contracts
 * because the slope of the displacement is below a half. */
po_edge_place po_edge_origin(const po_moving_edges *f, const double *shift, double r, size_t near) {
  po_edge_place p = {.count = f->count};
  find(f, r, near, &p);
  double missing = -po_edge_displacement(&p, shift);
  for (int k = 0; k < ITERATIONS && fabs(missing) > 1e-15 * r; ++k) {
    const double at = p.r;
    const double slope = p.weight_slope * (outer_shift(&p, shift) - inner_shift(&p, shift));
    find(f, at + missing / (1.0 + slope), p.outer, &p);
    double left = r - (p.r + po_edge_displacement(&p, shift));
    if (fabs(left) > 0.5 * fabs(missing)) {
      find(f, at + missing, p.outer, &p);
      left = r - (p.r + po_edge_displacement(&p, shift));
    }
    missing = left;
  }
  return p;
}

double po_edge_strain(const po_moving_edges *f, const double *shift) {
  double from = 0.0, value = 0.0, worst = 0.0; /* as in find */
  for (size_t k = 0; k <= f->count && f->count > 0; ++k) {
    const bool last = k == f->count;
    const double half = last ? 0.0 : PLATEAU * neighbour_distance(f, k);
    const double begin = last ? OUTER_END * f->at[k - 1] : f->at[k] - half;
    const double next = last ? 0.0 : shift[k];
    worst = fmax(worst, STEEPEST * fabs(next - value) / (begin - from));
    from = last ? begin : f->at[k] + half;
    value = next;
  }
  return worst;
}

bool po_edge_may_move(const po_moving_edges *f, const double *shift) {
  return po_edge_strain(f, shift) < GREATEST_STRAIN;
}

bool po_edge_may_relate(const po_moving_edges *f, const double *shift) {
  return po_edge_strain(f, shift) < GREATEST_STRAIN_BACK;
}
