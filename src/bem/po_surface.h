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

/* A meshed surface. Radii in eps; influence in eps (E* = 1), weights in eps^2. */
typedef struct {
  size_t n;
  size_t resolved;    /* nodes that carry the law at a point; the others, farther out, represent
                         whole wavelengths and carry the averaged law (po_law_averaged) */
  double core_radius; /* radius at which the elements of the scheme end */
  double *node;       /* n, ascending up to the last panel of an unbounded surface */
  double *weight;     /* n: integral of p r dr = sum of weight * p */
  double *length;     /* n: integral of p dr = sum of length * p */
  double *influence;  /* n x n, column-major: deflection at node i per unit traction at node j; NULL
                         for a rigid surface and for panels */
  po_hierarchy *hierarchy; /* of panels: the same for a core of radius 1; NULL for others */
  double *reach; /* n: largest modulus in each column of the influence matrix; NULL for a rigid
                    surface */
  uint64_t kernel_evaluations;
  po_arrays arrays;
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

#endif
