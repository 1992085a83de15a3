/* The influence matrix of a mesh of panels in hierarchical form, for meshes on which the dense
 * matrix costs too much: doc/method.md, "The tree of cells". The blocks depend on the places of the
 * cells only, and are kept from mesh to mesh.
 *
 * Source: L. Greengard, V. Rokhlin, J. Comput. Phys. 73, 325 (1987); interpolation in place of
 * multipoles: W. Fong, E. Darve, J. Comput. Phys. 228, 8712 (2009). */
#ifndef PO_HIERARCHY_H
#define PO_HIERARCHY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "po_block.h"
#include "po_memory.h"
#include "po_panel_table.h"
#include "po_panels.h"
#include "po_status.h"

typedef struct {
  uint64_t first, second; /* first: not 0 */
} po_block_key;

typedef struct {
  po_block_key key; /* first is 0 for an empty place */
  double *block;
} po_block_place;

/* Blocks of influence coefficients that are kept from mesh to mesh, found by a key. A block stays
 * where it is until the store is cleared. */
typedef struct {
  size_t count, room;    /* keys stored, and places for keys: a power of 2 */
  po_block_place *place; /* room */
  po_arena chunks;       /* memory of the blocks */
  double *chunk;         /* the last one */
  size_t used;           /* values of it that belong to blocks */
} po_block_store;

/* No cell, or no panel. */
#define PO_NO_CELL UINT32_MAX

/* A cell of the tree; its left child follows it. */
typedef struct {
  po_panel place;
  uint32_t right;      /* the right child */
  uint32_t panel, end; /* panels of the cell: panel <= k < end */
} po_cell;

static inline bool po_cell_is_panel(const po_cell *cell) {
  return cell->end - cell->panel == 1;
}

/* Two cells, or panels, that interact: `block` maps the charges of `source` to `target`, its
 * transpose those of `target` to `source`. */
typedef struct {
  uint32_t target, source;
  const double *block;
} po_interaction;

typedef struct {
  size_t count, room;
  po_interaction *pair;
} po_interactions;

/* The matrix of a mesh, on a domain of radius 1. Other files read it, and do not change it; blocks
 * stay valid until the next mesh. */
typedef struct {
  const po_panel_table *table;
  bool unbounded;
  double decay;
  double from_parent[2][PO_BLOCK_SIZE]; /* interpolation to the left and the right child */
  po_block_store store;
  po_panels panels;
  size_t cells;
  po_cell *cell;           /* 2 panels - 1 */
  uint32_t *cell_of_panel; /* panels */
  const double **own;      /* panels: the influence block of a panel on itself */
  const double **to_tail;  /* panels: the block that maps a panel to that to infinity */
  const double **halves;   /* 2 panels - 1: between the skeletons of the halves of a cell */
  double *weight;          /* nodes of the panels: weights on a domain of radius 1 */
  double *charge, *field;  /* cells x 12: work */
  size_t room;             /* panels for which there is memory */
  po_arena mesh;           /* the arrays above, from `cell` on */
  po_interactions kernel;  /* between cells, through the kernel */
  po_interactions product; /* between panels, source to target only, with the traction */
  po_status trouble;
  uint64_t evaluations;
} po_hierarchy;

/* Given: table; unbounded, whether one more panel reaches to infinity; decay, of the traction there
 * (po_panel_decay). Status: PO_NO_MEMORY. */
po_status po_hierarchy_create(const po_panel_table *table, bool unbounded, double decay,
                              po_hierarchy **hierarchy);

void po_hierarchy_destroy(po_hierarchy *hierarchy);

/* Makes the matrix of a mesh. Status: PO_NO_MEMORY; then no other function may be called. */
po_status po_hierarchy_mesh(po_hierarchy *hierarchy, const po_panels *panels);

/* The deflections for a domain of radius 1: y = G x, and y = G^T x. Given: x, one value a node.
 * Returned: y. Accuracy: 1e-12 of the largest deflection (tests/unit/test_hierarchy.c). */
void po_hierarchy_apply(po_hierarchy *hierarchy, const double *x, double *y);
void po_hierarchy_apply_transposed(po_hierarchy *hierarchy, const double *x, double *y);

/* Returned: the number of nodes of the mesh. */
size_t po_hierarchy_nodes(const po_hierarchy *hierarchy);

/* Fills a dense copy of the matrix, computed without the tree. Given: radius of the domain.
 * Returned: matrix, column-major, the square of the number of nodes. */
void po_hierarchy_fill_matrix(const po_hierarchy *hierarchy, double radius, double *matrix);

/* The largest modulus in each column of the matrix, for a domain of radius 1. Returned: reach, one
 * value a node. */
void po_hierarchy_reach(const po_hierarchy *hierarchy, double *reach);

#endif
