/* A basis for the deflection of a cell of panels by tractions outside of it, and for the action of
 * tractions of the cell outside of it: 16 skeleton nodes of the cell, and functions L with
 *
 *   g(x) = sum_k g(x_k) L_k(x) + error,   g = G(., s), s outside of the cell
 *
 * (doc/method.md, "Factors on panels"). They are found once, by pivoted factorisation of samples of
 * the kernel (interpolative decomposition). The error is 1e-5 of the interaction of two
 * neighbouring cells; a test requires that the deflection by a constant traction is right to 1e-4
 * (tests/unit/test_hierarchy.c): enough for the factors of a quasi-Newton iteration.
 *
 * Source: P.G. Martinsson, V. Rokhlin, J. Comput. Phys. 205, 1 (2005); H. Cheng, Z. Gimbutas, P.G.
 * Martinsson, V. Rokhlin, SIAM J. Sci. Comput. 26, 1389 (2005). */
#ifndef PO_SKELETON_H
#define PO_SKELETON_H

#include "po_block.h"

enum { PO_SKELETON_NODES = 16, PO_SKELETON_SIZE = PO_SKELETON_NODES * PO_SKELETON_NODES };

typedef struct po_skeleton {
  double node[PO_SKELETON_NODES]; /* the skeleton nodes on (0, 1) */
  /* L_k at the Gauss nodes of a panel: [i + 12 k] */
  double value[PO_TABLE_ORDER * PO_SKELETON_NODES];
  /* integral of L_k l_j over (0, 1), l_j the polynomials of a panel: [k + 16 j] */
  double moment[PO_SKELETON_NODES * PO_TABLE_ORDER];
  /* L_k of a cell at the skeleton nodes of its left and its right half: [i + 16 k]; and the
   * transposes */
  double from_parent[2][PO_SKELETON_SIZE], to_parent[2][PO_SKELETON_SIZE];
} po_skeleton;

/* Computes the basis. It is called by po_panel_table_get only, under its lock; others read
 * `skeleton` of the table. Given: the rule of a panel. Returned: the basis, always the same; NULL
 * with a message if memory runs out. */
const po_skeleton *po_skeleton_make(const po_panel_rule *rule);

#endif
