/* The influence matrix of a mesh of panels in hierarchical form, for meshes on which the dense
 * matrix costs too much.
 *
 * The panels are the leaves of a binary tree of cells. Like a panel, a cell has 12 Gauss-Legendre
 * nodes. Two cells interact through the kernel between their nodes if the gap between them is at
 * least twice the length of each that is not a panel: the kernel is then a polynomial of degree 11
 * on the cell to 1e-12. The charges of a panel, weight times traction, are carried from the nodes
 * of a cell to those of its parent by the transpose of the interpolation, and the deflections back
 * by the interpolation. Two panels interact directly, with the blocks of po_panel_table. So the
 * number of blocks is proportional to that of the panels. The blocks depend on the places of the
 * cells only, and are kept from mesh to mesh.
 *
 * Source: L. Greengard, V. Rokhlin, J. Comput. Phys. 73, 325 (1987); interpolation in place of
 * multipoles: W. Fong, E. Darve, J. Comput. Phys. 228, 8712 (2009). */
#ifndef PO_HIERARCHY_H
#define PO_HIERARCHY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "po_block_store.h"
#include "po_panel_table.h"
#include "po_panels.h"
#include "po_status.h"

/* No cell, or no panel. */
#define PO_NO_CELL UINT32_MAX

/* A cell of the tree; its parent precedes it, and its left child follows it. */
typedef struct {
  po_panel place;
  uint32_t parent, right; /* the right child */
  uint32_t panel, end;    /* panels of the cell: panel <= k < end */
} po_cell;

typedef struct po_hierarchy po_hierarchy;

/* Given: table; unbounded, whether one more panel reaches to infinity; decay, of the traction there
 * (po_panel_decay). Status: PO_NO_MEMORY. */
po_status po_hierarchy_create(const po_panel_table *table, bool unbounded, double decay,
                              po_hierarchy **hierarchy);
void po_hierarchy_destroy(po_hierarchy *hierarchy);

/* Makes the matrix of a mesh. Status: PO_NO_MEMORY; then no other function may be called. */
po_status po_hierarchy_mesh(po_hierarchy *hierarchy, const po_panels *panels);

/* Returned: the cells of the tree, and their number; cell 0 is the domain. */
const po_cell *po_hierarchy_cells(const po_hierarchy *hierarchy, size_t *count);

/* The deflections for a domain of radius 1: y = G x, and y = G^T x. Given: x, one value a node.
 * Returned: y. Accuracy: 1e-12 of the largest deflection (tests/unit/test_hierarchy.c). */
void po_hierarchy_apply(po_hierarchy *hierarchy, const double *x, double *y);
void po_hierarchy_apply_transposed(po_hierarchy *hierarchy, const double *x, double *y);

/* Returned: the block of coefficients of the tractions of a panel at its own nodes, and the kernel
 * between the skeleton nodes of the left half (rows) and the right half (columns) of a cell, for a
 * domain of radius 1. Given: cell, a panel in the first case, none in the second. They stay valid
 * until the next mesh. */
const double *po_hierarchy_own_block(const po_hierarchy *hierarchy, size_t panel);
const double *po_hierarchy_halves(const po_hierarchy *hierarchy, size_t cell);

/* Returned: the numbers of pairs of cells that interact through the kernel, both ways at once, and
 * of panels that interact one way through their influence block. */
void po_hierarchy_pairs(const po_hierarchy *hierarchy, size_t *kernel, size_t *product);

/* Returned: the number of nodes of the mesh. */
size_t po_hierarchy_nodes(const po_hierarchy *hierarchy);

/* Returned: the load weights of the nodes of the panels for a domain of radius 1. */
const double *po_hierarchy_weight(const po_hierarchy *hierarchy);

/* Returned: the coefficients of the tractions of a panel at the nodes of the panel to infinity, for
 * a domain of radius 1; NULL if there is no such panel. */
const double *po_hierarchy_to_tail(const po_hierarchy *hierarchy, size_t panel);

/* Fills a dense copy of the matrix, computed without the tree. Given: radius of the domain.
 * Returned: matrix, column-major, the square of the number of nodes. */
void po_hierarchy_fill_matrix(const po_hierarchy *hierarchy, double radius, double *matrix);

/* The largest modulus in each column of the matrix, for a domain of radius 1. Returned: reach, one
 * value a node. */
void po_hierarchy_reach(const po_hierarchy *hierarchy, double *reach);

/* Evaluations of the kernel so far. */
uint64_t po_hierarchy_evaluations(const po_hierarchy *hierarchy);

#endif
