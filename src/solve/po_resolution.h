/* How well panels resolve the traction, and which panels would. */
#ifndef PO_RESOLUTION_H
#define PO_RESOLUTION_H

#include "po_adaptive.h"
#include "po_equilibrium.h"

/* Legendre coefficients from nodal values of one panel. */
typedef struct {
  double coefficient[PO_TABLE_ORDER][PO_TABLE_ORDER]; /* [degree][node] */
} po_legendre;

void po_legendre_fill(const po_panel_rule *rule, po_legendre *legendre);

/* What the leaves are to do for the gaps of up to two states at once. */
typedef struct {
  const po_equilibrium *e;
  const po_adaptive *adaptive;
  const po_panel_rule *rule;
  const po_legendre *legendre;
  double allowed;         /* error of the gap that a panel may make, in eps */
  const double *state[2]; /* on the mesh in force; the second may be NULL */
} po_resolution;

/* The error of the gap that the panels in force make, in parts of what is allowed: the largest over
 * the panels, from the last Legendre coefficients of the traction. */
double po_resolution_excess(const po_resolution *r);

/* The leaves that resolve the tractions of the states: panels are split until they do, and joined
 * where their parent would do with a margin. Returned: whether they differ from those in force. */
bool po_resolution_leaves(const po_resolution *r, po_leaves *leaves);

#endif
