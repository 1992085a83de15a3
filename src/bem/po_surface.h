/* The elastic surface: where its nodes are, how nodal tractions deflect it, and what they weigh.
 *
 * Every discretisation delivers the same: node positions, an influence matrix from nodal tractions
 * to nodal deflections, and load weights. */
#ifndef PO_SURFACE_H
#define PO_SURFACE_H

#include <stddef.h>
#include <stdint.h>

#include "po_scene.h"
#include "po_status.h"

typedef enum {
  PO_RING,     /* rings of constant traction, App. A */
  PO_TRIANGLE, /* overlapping triangles, Sec. 3.1 */
  PO_PANEL,    /* polynomials on panels that follow the contact, to a tolerance */
} po_scheme;

typedef enum {
  PO_UNIFORM, /* equal elements */
  PO_GRADED,  /* elements growing outwards */
} po_grading;

typedef struct {
  po_scheme scheme;
  po_grading grading;
  size_t nodes;     /* of the elastic part inside the outer radius; not for panels */
  double tolerance; /* relative, of the pull-off force; for panels only */
} po_mesh;

/* Triangles, uniform, 501 nodes: the paper's (N = 500 elements). */
po_mesh po_mesh_default(void);

/* The same when the default is panels, for what needs nodes that stay. */
po_mesh po_mesh_fixed(void);

/* PO_BAD_INPUT, naming the key that is wrong, its value and what is expected. */
po_status po_mesh_check(const po_mesh *mesh);

/* "ring", "triangle"; "uniform", "graded". */
const char *po_scheme_name(po_scheme scheme);
const char *po_grading_name(po_grading grading);

/* The scheme or grading of that name, or -1. */
int po_scheme_of_name(const char *name);
int po_grading_of_name(const char *name);

/* A meshed surface. Radii in eps; influence in eps (E* = 1), weights in eps^2. */
typedef struct {
  size_t n;
  size_t resolved;    /* nodes from here on lie so far out that they stand for whole wavelengths and
                         carry the law averaged over one (po_law_averaged); n when there are none */
  double core_radius; /* end of the scheme's own elements */
  double *node;       /* n, ascending up to the last panel of an unbounded surface */
  double *weight;     /* n: integral of p r dr = sum of weight * p */
  double *length;     /* n: integral of dr, each node's share */
  double *influence;  /* n x n, column-major: deflection at node i per unit traction at node j; NULL
                         unless elastic */
  uint64_t kernel_evaluations;
} po_surface;

/* Where the scheme's own elements end on an unbounded surface, in eps: beyond, nothing touches
 * while the approach is at most `deepest` (eps; NAN: whatever pull-off needs). outer_radius when
 * bounded. */
double po_surface_core(const po_scene *scene, double deepest);

/* Meshes the surface of a scene.
 * The scheme's nodes fill [0, core_radius]. A bounded surface ends there; an unbounded one goes on
 * with Gauss panels: one a wavelength while single waves matter to 1e-9 of the load, and one that
 * reaches to infinity. Without `elastic` there is no influence matrix. Status: PO_BAD_INPUT,
 * PO_OUT_OF_NODES when that takes more than 3300 nodes, PO_NO_MEMORY. */
po_status po_surface_create(const po_scene *scene, const po_mesh *mesh, double core_radius,
                            bool elastic, po_surface **surface);
void po_surface_destroy(po_surface *surface);

#endif
