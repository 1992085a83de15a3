/* How well panels resolve the traction, and which panels would. */
#ifndef PO_RESOLUTION_H
#define PO_RESOLUTION_H

#include "po_adaptive.h"
#include "po_equilibrium.h"

/* Legendre coefficients from nodal values of one panel. */
typedef struct {
  double coefficient[PO_TABLE_ORDER][PO_TABLE_ORDER]; /* [degree][node] */
} po_legendre;

void po_legendre_fill(const po_panel_rule *rule, po_legendre *legendre);

/* A field of gaps, of what is to be resolved. */
typedef struct {
  double (*gap_at)(void *data, double r); /* r in eps, inside the domain */
  void *data;
} po_gap_field;

/* Errors that the last Legendre coefficients of a panel's traction may make. */
typedef struct {
  double gap;  /* of the gap, in eps, as far as the tractions respond to it */
  double load; /* of the load, in pi w R, by the square of their decay */
} po_allowance;

typedef struct {
  const po_equilibrium *e;
  const po_panel_rule *rule;
  const po_legendre *legendre;
  double domain; /* eps */
  po_allowance allowed;
} po_resolution;

/* The error that each panel makes, in parts of what is allowed, from the last Legendre coefficients
 * of the traction at the nodes; and the largest of these. */
void po_resolution_excesses(const po_resolution *r, const po_panels *panels, const double *gap,
                            double *excess);
double po_resolution_excess(const po_resolution *r, const po_panels *panels, const double *gap);

/* The same, with a margin: what a mesh is made with. */
po_resolution po_resolution_for_mesh(const po_resolution *r);

/* Meshes that are tried for one point, each to resolve the solution on the one before. */
enum { PO_MOST_MESHES_A_POINT = 4 };

/* The panels that resolve a field: those given are split until they do, and joined where their
 * parent would do with a margin. Status: PO_OUT_OF_NODES. */
po_status po_resolution_panels(const po_resolution *r, const po_gap_field *field,
                               po_panels *panels);

#endif
