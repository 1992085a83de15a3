/* A surface of panels that can be meshed anew: graded where the traction needs it, blocks of the
 * influence matrix kept where panels stay. */
#ifndef PO_ADAPTIVE_H
#define PO_ADAPTIVE_H

#include "po_panel_table.h"
#include "po_panels.h"
#include "po_surface.h"

typedef struct po_adaptive po_adaptive;

/* Panels on [0, domain] (eps), 2^level of them to begin with; on an unbounded scene a last one from
 * there to infinity with the waves averaged (po_averaging_phase of the domain is the domain).
 * Status: PO_NO_MEMORY. */
po_status po_adaptive_create(const po_scene *scene, double domain, uint32_t level,
                             po_adaptive **adaptive);
void po_adaptive_destroy(po_adaptive *adaptive);

/* The surface on the mesh in force: one object, whose content changes with the mesh. */
const po_surface *po_adaptive_surface(const po_adaptive *adaptive);
const po_panels *po_adaptive_panels(const po_adaptive *adaptive);
double po_adaptive_domain(const po_adaptive *adaptive);

/* Nodes a surface may have at most: what arrays over the nodes need. */
size_t po_adaptive_capacity(const po_adaptive *adaptive);

/* The panels whose nodes are the n radii (eps) inside the domain. Status: PO_BAD_INPUT when there
 * are none such. */
po_status po_adaptive_panels_of(const po_adaptive *adaptive, size_t n, const double *node,
                                po_panels *panels);

/* Puts new panels in force. Status: PO_NO_MEMORY; nothing is changed then. */
po_status po_adaptive_mesh(po_adaptive *adaptive, const po_panels *panels);

/* Gives the domain another radius; the panels in force stay. */
void po_adaptive_resize(po_adaptive *adaptive, double domain);

#endif
