/* Gauss-Legendre panels. On each panel the traction is a polynomial that interpolates the nodal
 * values, and the product with the kernel of Eq 12 is integrated exactly (product integration). The
 * last panel may reach to infinity: there the variable is t = begin/r in (0, 1) and the traction is
 * t^decay times a polynomial in t. The decay of the Lennard-Jones traction, (1 + H)^-3 with H ~
 * r^2, is 6. */
#ifndef PO_PANEL_H
#define PO_PANEL_H

#include <stddef.h>
#include <stdint.h>

#include "po_quadrature.h"
#include "po_scene.h"
#include "po_status.h"

/* Nodes of a panel, at most. */
enum { PO_PANEL_MAX_ORDER = 32 };

/* The interpolation and quadrature rule of one order, filled by po_panel_rule_fill. */
typedef struct {
  size_t order;
  double node[PO_PANEL_MAX_ORDER], weight[PO_PANEL_MAX_ORDER]; /* Gauss-Legendre on (0, 1) */
  double barycentric[PO_PANEL_MAX_ORDER];
  po_near_tables near;
} po_panel_rule;

/* Fills the rule. Given: order, nodes of a panel, 1 to PO_PANEL_MAX_ORDER. Status: PO_NO_MEMORY. */
po_status po_panel_rule_fill(size_t order, po_panel_rule *rule);

typedef struct {
  double begin, end; /* radii, eps; 0 <= begin < end; end may be INFINITY when begin > 0 */
  double decay;      /* of an infinite one: the traction falls as r^-decay */
} po_panel_span;

/* The decay of the traction of a scene far out: the exponent of the far field of its
 * law times the power by which its profile grows (po_scene_decay). Where nothing acts there, any
 * decay serves. */
double po_panel_decay(const po_scene *scene);

/* The decay of the energy of the interaction, one exponent of the law less; of its difference from
 * that of the initial gap, which falls as the traction does, if the energy itself is infinite
 * (po_scene_has_infinite_energy). */
double po_panel_energy_decay(const po_scene *scene);

/* Computes the nodes of a panel (ascending in r for a finite panel, descending for an infinite
 * one), the load weights (sum of weight * p = integral of p r dr) and the lengths (sum of length *
 * p = integral of p dr). Returned: `order` values of each. */
void po_panel_nodes(const po_panel_rule *rule, po_panel_span panel, double *node, double *weight,
                    double *length);

/* Computes one row of the influence matrix. Given: r, eps. Returned: row[j * stride], the
 * deflection at r (E* = 1) per unit traction at node j; the number of evaluations of the kernel.
 * Accuracy: 1e-13 of the deflection (tests/unit/test_bem.c). */
uint64_t po_panel_influence(const po_panel_rule *rule, po_panel_span panel, double r, double *row,
                            size_t stride);

#endif
