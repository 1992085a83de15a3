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

/* The points of a piece on one side of x0, with the nodes and weights of a rule over (0, 1). */
static void fill_piece(const po_near_rule *r, double length, size_t count, const double *node,
                       const double *weight, po_near_point *point) {
  for (size_t q = 0; q < count; ++q) {
    const double offset = r->sign * (r->near + length * node[q]);
    point[q] = (po_near_point){.x = r->x0 + offset, .offset = offset, .weight = length * weight[q]};
  }
}

po_near_rule po_near_rule_begin(const po_near_tables *tables, double x0, double mirror) {
  return (po_near_rule){.tables = tables,
                        .x0 = x0,
                        .mirror = fmax(mirror, LEAST_PIECE),
                        .sign = -1.0,
                        .near = x0 > 1.0 ? x0 - 1.0 : 0.0,
                        .to = x0};
}

size_t po_near_rule_next(po_near_rule *r, po_near_point point[PO_NEAR_PIECE_POINTS]) {
  const po_near_tables *t = r->tables;
  if (!(r->near < r->to) && r->sign < 0.0) {
    r->sign = 1.0;
    r->near = r->x0 < 0.0 ? -r->x0 : 0.0;
    r->to = 1.0 - r->x0;
  }
  if (!(r->near < r->to))
    return 0;
  if (r->near == 0.0) {
    const double length = r->mirror < r->to ? r->mirror : r->to;
    fill_piece(r, length, PO_LOG_RULE_POINTS, t->log_node, t->log_weight, point);
    r->near = length;
    return PO_LOG_RULE_POINTS;
  }
  double length = r->near; /* the length of each piece equals its distance from the singularity */
  if (r->near + 1.5 * length > r->to)
    length = r->to - r->near;
  fill_piece(r, length, PO_NEAR_GAUSS_POINTS, t->gauss_node, t->gauss_weight, point);
  r->near = length == r->to - r->near ? r->to : r->near + length;
  return PO_NEAR_GAUSS_POINTS;
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
