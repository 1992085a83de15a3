/* How well panels resolve the traction, and the choice of panels that resolve it. See
 * doc/method.md, "The mesh". */
#ifndef PO_RESOLUTION_H
#define PO_RESOLUTION_H

#include "po_equilibrium.h"

/* A gap as a function of the radius, whose traction is to be resolved. */
typedef struct {
  double (*gap_at)(void *data, double r); /* H at r, eps, inside the domain */
  void *data;
} po_gap_field;

/* Allowed errors of one panel, estimated from the last Legendre coefficients of its traction. */
typedef struct {
  double gap;  /* of the gap, eps, times the response of the traction, which is at most 1 */
  double load; /* of the load, pi w R */
} po_allowance;

typedef struct {
  const po_equilibrium *e; /* panels are relative to the core radius of its surface */
  po_allowance allowed;
  double detail; /* po_initial_gap_detail of the scene */
} po_resolution;

po_resolution po_resolution_of(const po_equilibrium *e, po_allowance allowed);

/* The last Legendre coefficients of a panel, whose size shows the error of its polynomial. */
enum { PO_LAST_COEFFICIENTS = 3 };

/* The excess of a panel: its estimated error relative to the allowed one; above 1 the panel is too
 * coarse. Given: gap, H at the nodes of all panels. */
double po_resolution_excess_of(const po_resolution *r, const po_panels *panels, const double *gap,
                               size_t panel);

/* The largest excess of all panels. */
double po_resolution_excess(const po_resolution *r, const po_panels *panels, const double *gap);

/* Largest number of meshes tried for one point. Each resolves the solution on the mesh before. */
enum { PO_MOST_MESHES_A_POINT = 4 };

/* Fails with PO_OUT_OF_NODES. Given: the scene, and panels that cannot be split as required,
 * because of their number or because one of them is of the shortest. */
po_status po_resolution_fail(const po_scene *scene, const po_panels *panels);

/* How often po_resolution_panels splits a panel at most. */
enum { PO_MOST_HALVINGS = 6 };

/* Adapts panels to a field. Panels with an excess above 1 are split, and two panels are joined if
 * the excess of their parent is below 0.1. Given and returned: panels. Status: PO_OUT_OF_NODES. */
po_status po_resolution_panels(const po_resolution *r, const po_gap_field *field,
                               po_panels *panels);

#endif
