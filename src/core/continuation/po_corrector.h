/* The corrector: solves for the equilibrium at a given value of the arclength functional, by
 * Newton's method from a guess on the current mesh. The mesh consists of panels that follow the
 * contact edges, or it is fixed. */
#ifndef PO_CORRECTOR_H
#define PO_CORRECTOR_H

#include <stdbool.h>

#include "po_resolution.h"
#include "po_solution.h"
#include "po_special_point.h"

/* If an iteration is slow but its last change, relative to 1 + H, is below PO_NEAR_SOLUTION, the
 * Jacobian is factorised there, at most PO_MOST_RENEWALS times. */
extern const double PO_NEAR_SOLUTION;
enum { PO_MOST_RENEWALS = 2 };

/* A mesh is made for this part of the allowed errors and kept until the allowed errors are
 * exceeded, so that the contact edges can move a little on it. */
extern const double PO_MESH_MARGIN;

typedef struct {
  po_equilibrium *e;
  po_resolution resolution;
  double *border, *guess; /* capacity of the surface + 1 */
  double *coordinate;     /* as many: work, coordinates of the arclength */
  po_arena arrays;        /* these, and the solutions of the owner */
  int direction;          /* of the trace: 1 forward, -1 reverse; 0: any orientation is accepted */
  double farthest;        /* error of a guess, relative to 1 + H, above which a solve is given up;
                             INFINITY: only if it does not converge */
  po_status trouble; /* status of a failure that no shorter step avoids, as of a mesh with too many
                        panels */
} po_corrector;

/* Given: equilibrium, which must outlive the corrector; the errors that the resolution of panels
 * may leave. Returned: c, whose arrays the owner frees whatever the status. Status: PO_NO_MEMORY.
 */
po_status po_corrector_allocate(po_corrector *c, po_equilibrium *e, po_allowance allowed);

/* Adapts panels so that they resolve a field with a margin. Status: PO_OUT_OF_NODES, which is also
 * stored in `trouble`. */
po_status po_corrector_adapt(po_corrector *c, const po_gap_field *field, po_panels *panels);

/* Sets p->wanted to the coarsest mesh that resolves the solution p with that margin. Does nothing
 * on a fixed mesh. Status: as above. */
po_status po_corrector_want_mesh(po_corrector *c, po_solution *p);

/* Whether the mesh resolves a solution on it, or is fixed. */
bool po_corrector_is_resolved(const po_corrector *c, const po_solution *p);

/* Makes a mesh that resolves a solution the current one, and the solution the guess on it.
 * Returned: p->wanted; a copy of the solution, in spare. Status: as above. */
po_status po_corrector_follow_solved(po_corrector *c, po_solution *p, po_solution *spare);

/* Makes `panels` the current mesh. Status: PO_OUT_OF_NODES, which is also stored in `trouble`. */
po_status po_corrector_mesh(po_corrector *c, const po_panels *panels);

/* Number of nodes of the current mesh that follow the contact edges: those of the panels; 0 for a
 * fixed mesh. */
size_t po_corrector_moving_nodes(const po_corrector *c);

/* Sets the guess to the state of a point, interpolated to the current mesh. */
void po_corrector_guess(po_corrector *c, const po_solution *p);

/* Sets the guess near a solution on the current mesh, at a distance along its arclength functional:
 * by the tangent, in coordinates that move with the contact edges. Along a straight tangent the gap
 * at a narrow edge would be wrong as soon as the edge moves by its own width. */
void po_corrector_guess_near(po_corrector *c, const po_solution *p, double distance);

/* Factorises the bordered Jacobian at a state, and corrects the factors of panels in the directions
 * in which they err most. Given: the state, last evaluated, and the border, n + 1 each. Status: as
 * po_equilibrium_factorize. */
po_status po_corrector_factorize(po_equilibrium *e, const double *state, const double *border);

/* Solves for the equilibrium at a distance along the arclength functional of the point `from`,
 * starting at the guess. Given: keep_factors, whether the present factors are tried before new
 * ones; precision of the tangent. Returned: out. Status: PO_NOT_CONVERGED, also if the sign of the
 * determinant shows that the solution is on another branch. */
po_status po_corrector_solve(po_corrector *c, const po_solution *from, double distance,
                             bool keep_factors, double precision, po_solution *out);

/* Returned: the arclength functional of a point at the guess. At the interpolated state of the
 * point it is not 0 if the mesh is another: the coordinates are integrals over the nodes. */
double po_corrector_place_of_guess(po_corrector *c, const po_solution *from);

/* Approach and load at the point p, with their rates with respect to the arclength functional of
 * `from`. */
po_sample po_corrector_sample(const po_solution *from, const po_solution *p);

#endif
