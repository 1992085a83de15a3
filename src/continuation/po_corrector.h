/* Equilibria at a given place of a branch: the mesh in force, a guess on it, and Newton's iteration
 * from there. The mesh consists of panels that follow the contact edges, or it stays. */
#ifndef PO_CORRECTOR_H
#define PO_CORRECTOR_H

#include <stdbool.h>

#include "po_solution.h"
#include "po_special_point.h"

typedef struct {
  po_equilibrium *e;
  po_adaptive *adaptive;  /* NULL: the mesh stays */
  double domain;          /* radius of the domain that the mesh covers, eps */
  size_t capacity;        /* nodes that the mesh may have */
  double *border, *guess; /* capacity + 1 */
  double *coordinate;     /* of the arclength, likewise */
  int direction;          /* of the branch: 1 as it comes from far out, -1 back */
  po_status trouble;      /* of a mesh that could not be had: no shorter step helps */
} po_corrector;

/* Given: adaptive, NULL for a mesh that stays. Status: PO_NO_MEMORY. Both objects must outlive the
 * corrector. */
po_status po_corrector_allocate(po_corrector *c, po_equilibrium *e, po_adaptive *adaptive);
void po_corrector_free(po_corrector *c);

/* Puts panels in force. Status: PO_OUT_OF_NODES, kept in trouble. */
po_status po_corrector_mesh(po_corrector *c, const po_panels *panels);

/* Nodes of the mesh in force that follow the contact edges: those of the panels. */
size_t po_corrector_moving_nodes(const po_corrector *c);

/* The state of a point as a guess on the mesh in force. */
void po_corrector_guess(po_corrector *c, const po_solution *p);

/* Gives factors in hand the border of another point, if there are any. */
void po_corrector_aim(po_corrector *c, const po_solution *from);

/* The equilibrium at a distance along the arclength functional from a point, starting at the guess;
 * with the factors in hand first where they may serve. Given: precision of the tangent. Returned:
 * out. Status: PO_NOT_CONVERGED, also when the branch there runs the other way. */
po_status po_corrector_solve(po_corrector *c, const po_solution *from, double distance,
                             bool keep_factors, double precision, po_solution *out);

/* Approach and load, with their rates, as functions of the distance along the arclength functional
 * of `from`, at the point p. */
po_sample po_corrector_sample(const po_solution *from, const po_solution *p);

#endif
