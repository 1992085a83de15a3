/* The mesh that the user chooses: scheme, grading, number of nodes, tolerance. */
#ifndef PO_MESH_H
#define PO_MESH_H

#include <stddef.h>

#include "po_status.h"

typedef enum {
  PO_RING,     /* rings of constant traction, App. A */
  PO_TRIANGLE, /* overlapping triangles, Sec. 3.1 */
  PO_PANEL,    /* polynomials on panels, remeshed to meet a tolerance */
} po_scheme;
extern const char *const PO_SCHEMES[]; /* their names; ends with NULL */

typedef enum {
  PO_UNIFORM, /* elements of equal length */
  PO_GRADED,  /* elements whose length grows with the radius */
} po_grading;
extern const char *const PO_GRADINGS[]; /* their names; ends with NULL */

typedef struct {
  po_scheme scheme;
  po_grading grading;
  size_t nodes;     /* rings and triangles only: nodes inside the core */
  double tolerance; /* panels only: relative tolerance on the pull-off force */
} po_mesh;

/* The default: panels with a tolerance of 1e-6. The number of nodes, 501, is that of the paper (N =
 * 500 elements); it applies if another scheme is chosen. */
po_mesh po_mesh_default(void);

/* The least tolerance. */
extern const double PO_LEAST_TOLERANCE;

/* Checks a mesh. Status: PO_BAD_INPUT, naming the key that is wrong, its value and the expected
 * range. */
po_status po_mesh_check(const po_mesh *mesh);

#endif
