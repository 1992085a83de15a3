/* A surface of panels that can be meshed anew: graded where the traction needs it, blocks of the
 * influence matrix kept where panels stay. */
#ifndef PO_ADAPTIVE_H
#define PO_ADAPTIVE_H

#include "po_leaves.h"
#include "po_panel_table.h"
#include "po_surface.h"

typedef struct po_adaptive po_adaptive;

/* Panels on [0, root] (eps), 2^level of them to begin with; on an unbounded scene a last one from
 * there to infinity with the waves averaged (po_averaging_phase of the root is the root). Status:
 * PO_NO_MEMORY. */
po_status po_adaptive_create(const po_scene *scene, double root, uint32_t level,
                             po_adaptive **adaptive);
void po_adaptive_destroy(po_adaptive *adaptive);

/* The surface on the mesh in force: one object, whose content changes with the mesh. */
const po_surface *po_adaptive_surface(const po_adaptive *adaptive);
const po_leaves *po_adaptive_leaves(const po_adaptive *adaptive);
double po_adaptive_root(const po_adaptive *adaptive);

/* Nodes a surface may have at most: what arrays over the nodes need. */
size_t po_adaptive_capacity(const po_adaptive *adaptive);

/* The leaves whose nodes are the n radii (eps) inside the root. Status: PO_BAD_INPUT when there are
 * none such. */
po_status po_adaptive_leaves_of(const po_adaptive *adaptive, size_t n, const double *node,
                                po_leaves *leaves);

/* Puts new leaves in force. Status: PO_OUT_OF_NODES when they are too many; nothing is changed
 * then. */
po_status po_adaptive_mesh(po_adaptive *adaptive, const po_leaves *leaves);

/* Gives the root another radius; the leaves in force stay. */
void po_adaptive_resize(po_adaptive *adaptive, double root);

#endif
