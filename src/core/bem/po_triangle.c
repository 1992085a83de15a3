#include <stdlib.h>

#include "po_element.h"
#include "po_kernel.h"
#include "po_memory.h"
#include "po_quadrature.h"

/* FAR_POINTS: points of the Gauss rule on an element whose distance from the radius is at least
 * FAR_DISTANCE of its lengths; the parameter of the Bernstein ellipse is then above 80, the error
 * 80^-8. MIDDLE_POINTS: points on an element for which po_near_is_far holds. */
enum { FAR_POINTS = 4, MIDDLE_POINTS = 12 };

static const double FAR_DISTANCE = 20.0;

struct po_triangle {
  size_t n;
  const double *node;
  double far_node[FAR_POINTS], far_weight[FAR_POINTS];
  double middle_node[MIDDLE_POINTS], middle_weight[MIDDLE_POINTS];
  po_near_tables near;
  double *point; /* (n - 1) x FAR_POINTS radii, those of each element */
};

po_status po_triangle_create(size_t n, const double *node, po_triangle **triangle) {
  po_status status = PO_NO_MEMORY;
  po_triangle *t = po_allocate(1, sizeof *t);
  if (!t)
    goto done;
  t->n = n;
  t->node = node;
  t->point = po_allocate(n * FAR_POINTS, sizeof *t->point);
  if (!t->point)
    goto done;
  status = po_gauss_rule(FAR_POINTS, t->far_node, t->far_weight);
  if (!status)
    status = po_gauss_rule(MIDDLE_POINTS, t->middle_node, t->middle_weight);
  if (!status)
    status = po_near_tables_fill(&t->near);
  for (size_t e = 0; e + 1 < n; ++e)
    for (size_t q = 0; q < FAR_POINTS; ++q)
      t->point[e * FAR_POINTS + q] = node[e] + (node[e + 1] - node[e]) * t->far_node[q];
done:
  if (status) {
    po_triangle_destroy(t);
    t = NULL;
  }
  *triangle = t;
  return status;
}

void po_triangle_destroy(po_triangle *triangle) {
  if (!triangle)
    return;
  free(triangle->point);
  free(triangle);
}

/* Adds the integrals of G s (1 - x) and of G s x over an element to the coefficients of its two
 * nodes. */
static void add_element(double falling, double rising, double *row, size_t stride, size_t element) {
  row[element * stride] += falling;
  row[(element + 1) * stride] += rising;
}

/* Adds the elements first to last - 1, which are all far from r, with one vectorised evaluation of
 * the kernel. Returned: the number of evaluations. */
static uint64_t add_far(const po_triangle *t, double r, size_t first, size_t last, double *row,
                        size_t stride) {
  enum { SWEEP = 16 };
  double kernel[SWEEP * FAR_POINTS];
  for (size_t begin = first; begin < last; begin += SWEEP) {
    const size_t count = last - begin < SWEEP ? last - begin : SWEEP;
    po_kernel_row(r, t->point + begin * FAR_POINTS, NULL, count * FAR_POINTS, kernel);
    for (size_t e = begin; e < begin + count; ++e) {
      const double length = t->node[e + 1] - t->node[e];
      double rising = 0.0, all = 0.0;
      for (size_t q = 0; q < FAR_POINTS; ++q) {
        const double share = length * t->far_weight[q] * kernel[(e - begin) * FAR_POINTS + q] *
                             t->point[e * FAR_POINTS + q];
        all += share;
        rising += share * t->far_node[q];
      }
      add_element(all - rising, rising, row, stride, e);
    }
  }
  return (last - first) * FAR_POINTS;
}

static uint64_t add_middle(const po_triangle *t, double r, size_t e, double *row, size_t stride) {
  const double begin = t->node[e], length = t->node[e + 1] - begin;
  double s[MIDDLE_POINTS], kernel[MIDDLE_POINTS], rising = 0.0, falling = 0.0;
  for (size_t q = 0; q < MIDDLE_POINTS; ++q)
    s[q] = begin + length * t->middle_node[q];
  po_kernel_row(r, s, NULL, MIDDLE_POINTS, kernel);
  for (size_t q = 0; q < MIDDLE_POINTS; ++q) {
    const double share = length * t->middle_weight[q] * kernel[q] * s[q];
    rising += share * t->middle_node[q];
    falling += share * (1.0 - t->middle_node[q]);
  }
  add_element(falling, rising, row, stride, e);
  return MIDDLE_POINTS;
}

static uint64_t add_near(const po_triangle *t, double r, size_t e, double *row, size_t stride) {
  const double begin = t->node[e], length = t->node[e + 1] - begin;
  const double x0 = r == t->node[e + 1] ? 1.0 : (r - begin) / length; /* exact at both ends */
  po_near_rule near = po_near_rule_begin(&t->near, x0, 2.0 * r / length);
  po_near_point point[PO_NEAR_PIECE_POINTS];
  double rising = 0.0, falling = 0.0;
  uint64_t evaluations = 0;
  for (size_t count; (count = po_near_rule_next(&near, point)) > 0; evaluations += count)
    for (size_t q = 0; q < count; ++q) {
      const double s = begin + length * point[q].x;
      const double share =
          length * point[q].weight * po_kernel(r + s, length * point[q].offset) * s;
      rising += share * point[q].x;
      falling += share * (1.0 - point[q].x);
    }
  add_element(falling, rising, row, stride, e);
  return evaluations;
}

uint64_t po_triangle_influence(const po_triangle *triangle, double r, double *row, size_t stride) {
  const size_t n = triangle->n;
  uint64_t evaluations = 0;
  for (size_t j = 0; j < n; ++j)
    row[j * stride] = 0.0;
  if (r == 0.0) { /* on the axis G s = 2 for all s */
    for (size_t e = 0; e + 1 < n; ++e) {
      const double length = triangle->node[e + 1] - triangle->node[e];
      add_element(length, length, row, stride, e);
    }
    return 0;
  }
  size_t e = 0, run = 0; /* elements run to e - 1 are far from r and are added together */
  for (; e + 1 < n; ++e) {
    const double begin = triangle->node[e], length = triangle->node[e + 1] - begin;
    const double x0 = (r - begin) / length;
    if (x0 <= -FAR_DISTANCE || x0 >= 1.0 + FAR_DISTANCE)
      continue;
    evaluations += add_far(triangle, r, run, e, row, stride);
    run = e + 1;
    evaluations += po_near_is_far(x0, MIDDLE_POINTS) ? add_middle(triangle, r, e, row, stride)
                                                     : add_near(triangle, r, e, row, stride);
  }
  return evaluations + add_far(triangle, r, run, e, row, stride);
}
