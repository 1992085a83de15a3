#include "po_near_rule.h"

#include <math.h>

#include "po_elementary.h"

po_status po_near_tables_fill(po_near_tables *tables) {
  po_log_rule(tables->log_node, tables->log_weight);
  return po_gauss_rule(PO_NEAR_GAUSS_POINTS, tables->gauss_node, tables->gauss_weight);
}

/* The integral of the logarithm over a piece shorter than this is below the rounding of the
 * result. */
static const double LEAST_PIECE = 1e-20;

/* Adds the points on one side of x0. Given: sign, the direction; from and to, the range of
 * distances from x0 (0 <= from < to). Returned: the number of points. */
static size_t add_side(const po_near_tables *tables, double x0, double sign, double from, double to,
                       double mirror, po_near_point *point) {
  size_t count = 0;
  double near = from;
  if (near == 0.0) {
    near = mirror < to ? mirror : to;
    for (size_t q = 0; q < PO_LOG_RULE_POINTS; ++q) {
      const double offset = sign * near * tables->log_node[q];
      point[count++] = (po_near_point){
          .x = x0 + offset, .offset = offset, .weight = near * tables->log_weight[q]};
    }
  }
  while (near < to) { /* the length of each piece equals its distance from the singularity */
    double length = near;
    if (near + 1.5 * length > to)
      length = to - near;
    for (size_t q = 0; q < PO_NEAR_GAUSS_POINTS; ++q) {
      const double offset = sign * (near + length * tables->gauss_node[q]);
      point[count++] = (po_near_point){
          .x = x0 + offset, .offset = offset, .weight = length * tables->gauss_weight[q]};
    }
    near = length == to - near ? to : near + length;
  }
  return count;
}

size_t po_near_rule(const po_near_tables *tables, double x0, double mirror,
                    po_near_point point[PO_NEAR_MAX_POINTS]) {
  size_t count = 0;
  mirror = fmax(mirror, LEAST_PIECE);
  if (x0 > 0.0)
    count += add_side(tables, x0, -1.0, x0 > 1.0 ? x0 - 1.0 : 0.0, x0, mirror, point);
  if (x0 < 1.0)
    count += add_side(tables, x0, 1.0, x0 < 0.0 ? -x0 : 0.0, 1.0 - x0, mirror, point + count);
  return count;
}

int po_near_is_far(double x0, size_t n) {
  /* The relative error of a Gauss rule with n points is rho^(-2n), where rho is the parameter of
   * the Bernstein ellipse through the singularity. Requiring rho^n = 10^10.5, i.e. an error of
   * 1e-21 for the kernel alone, leaves half of the digits for the polynomial that multiplies the
   * kernel. */
  const double rho = po_pow(10.0, 10.5 / (double)n);
  const double reach = 0.25 * (rho + 1.0 / rho) - 0.5; /* distance beyond the ends of (0, 1) */
  return x0 <= -reach || x0 >= 1.0 + reach;
}
