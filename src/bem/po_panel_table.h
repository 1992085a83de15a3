/* Influence of one panel of a tree on the nodes of another (or itself), row by row of blocks.
 *
 * Near its own singularity the kernel is G = a ln|r - s| + b with smooth
 *   a = -4 / (pi agm(r + s, 2 sqrt(r s))),  b = G - a ln|r - s|  (at s = r: 2 ln(8 r)/(pi r)),
 * (K(k) = (2/pi) ln(4/k') K(k') - ..., applied to G = 4 K(k)/(pi (r + s)), k' = |r - s|/(r + s)).
 * Polynomials times the logarithm have weights that depend only on how the two panels lie to each
 * other: eleven shapes. The panel at the axis, where a and b are not smooth, scales as a whole:
 * four more. All are tabulated once. */
#ifndef PO_PANEL_TABLE_H
#define PO_PANEL_TABLE_H

#include "po_panel.h"
#include "po_panels.h"

enum { PO_TABLE_ORDER = 12 };

typedef double po_panel_block[PO_TABLE_ORDER]
                             [PO_TABLE_ORDER]; /* [node of the target][of the source] */

enum { PO_LOG_SHAPES = 11, PO_AXIS_SHAPES = 4 };

typedef struct {
  po_panel_rule rule;
  po_panel_block logarithm[PO_LOG_SHAPES]; /* integral of ln|x - x_i| l_j(x) over (0, 1) */
  po_panel_block axis[PO_AXIS_SHAPES];     /* influence of the panel (0, 1) */
} po_panel_table;

/* The table, made at the first call (any thread); NULL with a message when there is no memory. */
const po_panel_table *po_panel_table_get(void);

/* The block of influence coefficients, in units of the domain: target's nodes, source's nodes.
 * Accuracy: 3e-12 of the deflection (tests/unit/test_panel_table.c): Gauss's rule at a quarter of
 * the source's size from it. */
void po_panel_table_block(const po_panel_table *table, po_panel target, po_panel source,
                          po_panel_block block);

#endif
