/* An elastic surface meshed with panels that can be remeshed: the panels are graded where the
 * traction needs it. */
#ifndef PO_ADAPTIVE_H
#define PO_ADAPTIVE_H

#include "po_panel_table.h"
#include "po_panels.h"
#include "po_surface.h"

/* Other files read it, and change the draft only. The surface is on the current mesh: it stays the
 * same object, and its content changes with the mesh. Its core is the domain of the panels. */
typedef struct {
  bool wavy;
  size_t most, capacity; /* panels, and nodes, for which the surface has room */
  po_panels draft;       /* a mesh for the caller to make and to give to po_adaptive_mesh */
  po_surface surface;
} po_adaptive;

/* The panels of the current mesh, without the one to infinity. */
static inline const po_panels *po_adaptive_panels(const po_adaptive *adaptive) {
  return &adaptive->surface.hierarchy->panels;
}

/* Creates a surface with 2^level equal panels on [0, domain]. If the scene is unbounded, one more
 * panel reaches from there to infinity and carries the law averaged over the waviness; `domain`
 * must then be a radius from po_averaging_phase. Given: domain, eps. Status: PO_NO_MEMORY. */
po_status po_adaptive_create(const po_scene *scene, double domain, uint32_t level,
                             po_adaptive **adaptive);
void po_adaptive_destroy(po_adaptive *adaptive);

/* Finds the panels to which n nodes belong. Given: node, n radii (eps) inside the domain,
 * ascending. Status: PO_BAD_INPUT if they are not the nodes of panels. */
po_status po_adaptive_panels_of(const po_adaptive *adaptive, size_t n, const double *node,
                                po_panels *panels);

/* Remeshes the surface. Status: PO_OUT_OF_NODES, and the surface is unchanged; PO_NO_MEMORY, and it
 * cannot be used. */
po_status po_adaptive_mesh(po_adaptive *adaptive, const po_panels *panels);

/* Changes the radius of the domain, eps; the panels keep their places relative to it. */
void po_adaptive_resize(po_adaptive *adaptive, double domain);

#endif
