/* The elastic surface: the positions of its nodes, the deflection caused by nodal tractions
 * (Eq 11), and the load weights (Eq 17).
 *
 * Every discretisation provides the same three results: node positions, an influence matrix from
 * nodal tractions to nodal deflections, and load weights. */
#ifndef PO_SURFACE_H
#define PO_SURFACE_H

#include <stddef.h>
#include <stdint.h>

#include "po_hierarchy.h"
#include "po_memory.h"
#include "po_mesh.h"
#include "po_scene.h"
#include "po_status.h"

/* A meshed surface, with a fixed mesh of rings or triangles, or with panels, whose mesh can be
 * changed: the surface stays the same object. Other files read it, and change the draft only. Radii
 * in eps; influence in eps (E* = 1), weights in eps^2. */
typedef struct {
  size_t n, capacity; /* nodes, and those for which there is memory */
  size_t resolved;    /* nodes that carry the law at a point; the others, farther out, represent
                         whole wavelengths and carry the averaged law (po_law_averaged) */
  size_t tail;        /* nodes of the panel to infinity, the last ones; 0 on a bounded surface */
  double tail_begin;  /* radius where that panel begins */
  double core_radius; /* radius at which the elements of the scheme end; of panels, their domain */
  double *node;       /* n, ascending up to the last panel of an unbounded surface */
  double *weight;     /* n: integral of p r dr = sum of weight * p */
  double *length;     /* n: integral of p dr = sum of length * p */
  double *influence;  /* n x n, column-major: deflection at node i per unit traction at node j; NULL
                         for a rigid surface and for panels */
  po_hierarchy *hierarchy; /* of panels: the same for a core of radius 1; NULL for others */
  po_panels *draft;        /* of panels: a mesh for the caller to make, and for po_surface_mesh */
  bool wavy;               /* of panels: whether that to infinity carries the averaged law */
  double *reach; /* n: largest modulus in each column of the influence matrix; NULL for a rigid
                    surface */
  uint64_t kernel_evaluations;
  po_arena arrays; /* all of these, but not the hierarchy */
} po_surface;

/* The deflection by tractions, y = G x, and the transpose, y = G^T x. Given: x, n. Returned: y, n.
 */
void po_surface_apply(const po_surface *surface, const double *x, double *y);
void po_surface_apply_transposed(const po_surface *surface, const double *x, double *y);

/* Fills a dense copy of the influence matrix. Returned: matrix, n x n, column-major. */
void po_surface_fill_matrix(const po_surface *surface, double *matrix);

/* Returned: the radius, eps, of the core, which the elements of the scheme mesh. On an unbounded
 * surface the bodies do not touch beyond the core while the approach is at most `deepest` (eps;
 * NAN: what pull-off needs). On a bounded surface it is outer_radius. */
double po_surface_core(const po_scene *scene, double deepest);

/* Meshes the surface of a scene with rings or triangles. The nodes of the scheme fill [0,
 * core_radius]. A bounded surface ends there. An unbounded one continues with Gauss panels: one for
 * each wavelength as long as single waves change the load by more than 1e-9, then one that reaches
 * to infinity. Without `elastic` there is no influence matrix. Status: PO_BAD_INPUT;
 * PO_OUT_OF_NODES if more than 3300 nodes are needed, or fewer than two elements fall on a
 * wavelength; PO_NO_MEMORY. */
po_status po_surface_create(const po_scene *scene, const po_mesh *mesh, double core_radius,
                            bool elastic, po_surface **surface);
void po_surface_destroy(po_surface *surface);

/* Creates a surface with 2^level equal panels on [0, domain]. If the scene is unbounded, one more
 * panel reaches from there to infinity and carries the law averaged over the waviness; `domain`
 * must then be a radius from po_averaging_phase. Given: domain, eps. Status: PO_NO_MEMORY. */
po_status po_surface_create_panels(const po_scene *scene, double domain, uint32_t level,
                                   po_surface **surface);

/* The panels of the current mesh, without the one to infinity; NULL for a fixed mesh. */
static inline const po_panels *po_surface_panels(const po_surface *surface) {
  return surface->hierarchy ? &surface->hierarchy->panels : NULL;
}

/* Finds the panels to which n nodes belong. Given: node, n radii (eps) inside the domain,
 * ascending. Status: PO_BAD_INPUT if they are not the nodes of panels. */
po_status po_surface_panels_of(const po_surface *surface, size_t n, const double *node,
                               po_panels *panels);

/* Remeshes a surface of panels. Status: PO_OUT_OF_NODES, and the surface is unchanged;
 * PO_NO_MEMORY, and it cannot be used. */
po_status po_surface_mesh(po_surface *surface, const po_panels *panels);

/* Changes the radius of the domain, eps; the panels keep their places relative to it. */
void po_surface_resize(po_surface *surface, double domain);

#endif
