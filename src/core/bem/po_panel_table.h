/* The influence of one panel on the nodes of another panel (or its own nodes), as blocks of the
 * influence matrix.
 *
 * Near its singularity the kernel of Eq 12 is G = a ln|r - s| + b with the smooth functions
 *   a = -4/(pi agm(r + s, 2 sqrt(r s))),  b = G - a ln|r - s|  (at s = r: 2 ln(8 r)/(pi r)),
 * from K(k) = (2/pi) ln(4/k') K(k') - ... for G = 4 K(k)/(pi (r + s)), k' = |r - s|/(r + s). The
 * weights for polynomials times the logarithm depend only on the relative position of the two
 * panels, for which there are eleven possibilities. The panel at the axis, where a and b are not
 * smooth, scales as a whole, with four more positions. All of these are tabulated once. */
#ifndef PO_PANEL_TABLE_H
#define PO_PANEL_TABLE_H

#include "po_panel.h"
#include "po_panels.h"

/* Nodes of a panel. */
enum { PO_TABLE_ORDER = 12 };

typedef double po_panel_block[PO_TABLE_ORDER]
                             [PO_TABLE_ORDER]; /* [node of the target][node of the source] */

enum { PO_LOG_POSITIONS = 11, PO_AXIS_POSITIONS = 4 };

/* The matrix that computes Legendre coefficients from the nodal values of one panel, and the
 * weights of these in the values of their polynomial at its begin and its end. */
typedef struct {
  double coefficient[PO_TABLE_ORDER][PO_TABLE_ORDER]; /* [degree][node] */
  double at_end[2][PO_TABLE_ORDER];
} po_legendre;

/* The nodes of Gauss's rules on the halves of (0, 1), their weights, and those with which the nodal
 * values of a panel are interpolated to each. */
typedef struct {
  double node[2 * PO_TABLE_ORDER], weight[2 * PO_TABLE_ORDER],
      lagrange[2 * PO_TABLE_ORDER][PO_TABLE_ORDER];
} po_panel_halves;

typedef struct {
  po_panel_rule rule;
  po_panel_halves halves;
  po_panel_block logarithm[PO_LOG_POSITIONS]; /* integral of ln|x - x_i| l_j(x) over (0, 1) */
  po_panel_block axis[PO_AXIS_POSITIONS];     /* influence of the panel (0, 1) */
  po_panel_block derivative;                  /* of the polynomials l_j at the nodes; 0 at j = i */
  po_legendre legendre;
  const struct po_skeleton *skeleton; /* basis of the fields on cells, po_skeleton.h */
} po_panel_table;

/* Returned: the table, which the first call of any thread computes; NULL with a message if memory
 * runs out; a later call then tries again. */
const po_panel_table *po_panel_table_get(void);

/* Computes the block of influence coefficients for the nodes of `target` and of `source`, for a
 * domain of radius 1. Accuracy: 3e-12 of the deflection (tests/unit/test_panel_table.c), the error
 * of the Gauss rule at a distance of a quarter of the length of the source. */
void po_panel_table_block(const po_panel_table *table, po_panel target, po_panel source,
                          po_panel_block block);

#endif
