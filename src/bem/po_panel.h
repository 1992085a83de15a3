/* Gauss-Legendre panels: nodal tractions interpolated by a polynomial on each panel, the kernel
 * integrated against it exactly (product integration). The last panel may reach to infinity: there
 * the variable is t = begin/r in (0, 1) and the traction t^6 times a polynomial in t, the
 * Lennard-Jones decay (1 + H)^-3 with H ~ r^2. */
#ifndef PO_PANEL_H
#define PO_PANEL_H

#include <stddef.h>
#include <stdint.h>

#include "po_near_rule.h"
#include "po_status.h"

enum { PO_PANEL_MAX_ORDER = 32 };

/* The rule of one order; fill with po_panel_rule_fill. */
typedef struct {
  size_t order;
  double node[PO_PANEL_MAX_ORDER], weight[PO_PANEL_MAX_ORDER]; /* Gauss-Legendre on (0, 1) */
  double barycentric[PO_PANEL_MAX_ORDER];
  po_near_tables near;
} po_panel_rule;

po_status po_panel_rule_fill(size_t order, po_panel_rule *rule);

typedef struct {
  double begin, end; /* radii, eps; 0 <= begin < end; end may be INFINITY when begin > 0 */
} po_panel_span;

/* Nodes (ascending in r for a finite panel, descending for an infinite one), load weights
 * (sum of weight * p = integral of p r dr) and lengths (integral of dr), `order` of each. */
void po_panel_nodes(const po_panel_rule *rule, po_panel_span panel, double *node, double *weight,
                    double *length);

/* One row of the influence matrix: deflection at r (E* = 1) per unit nodal traction, row[j *
 * stride]. Returned: the kernel evaluations made. Accuracy: 1e-13 of the deflection
 * (tests/test_bem.c). */
uint64_t po_panel_influence(const po_panel_rule *rule, po_panel_span panel, double r, double *row,
                            size_t stride);

#endif
