/* Quadrature over one element when the kernel's logarithmic singularity is on it or beside it. */
#ifndef PO_NEAR_RULE_H
#define PO_NEAR_RULE_H

#include <stddef.h>

#include "po_quadrature.h"

enum { PO_NEAR_GAUSS_POINTS = 16, PO_NEAR_MAX_POINTS = 2 * PO_LOG_RULE_POINTS + 16 * 120 };

/* The rules that near rules are made of; fill once with po_near_tables_fill. */
typedef struct {
  double gauss_node[PO_NEAR_GAUSS_POINTS], gauss_weight[PO_NEAR_GAUSS_POINTS];
  double log_node[PO_LOG_RULE_POINTS], log_weight[PO_LOG_RULE_POINTS];
} po_near_tables;

po_status po_near_tables_fill(po_near_tables *tables);

/* A point of the rule: x in (0, 1) and its distance from the singularity, kept apart so that the
 * kernel's argument does not cancel. */
typedef struct {
  double x;      /* where */
  double offset; /* x - x0, to full relative precision */
  double weight;
} po_near_point;

/* A rule over x in (0, 1) for polynomials (degree <= 20) times a function with a logarithm at x0
 * (inside, at an end or outside) and its other singularity no nearer to x0 than `mirror`: pieces
 * that grow geometrically away from x0, the innermost one by the rule for logarithms. Given: x0;
 * mirror > 0. Returned: the number of points, at most PO_NEAR_MAX_POINTS. Accuracy: 1e-14 relative
 * (tests/test_quadrature.c). */
size_t po_near_rule(const po_near_tables *tables, double x0, double mirror,
                    po_near_point point[PO_NEAR_MAX_POINTS]);

/* Whether a Gauss rule of n points over (0, 1) is exact to rounding with the singularity at x0. */
int po_near_is_far(double x0, size_t n);

#endif
