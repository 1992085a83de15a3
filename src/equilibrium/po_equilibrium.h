/* Equilibria of the discretised boundary value problem, Eqs 15-16.
 *
 * In units of eps, with p = P/mu the law of Eq 16 and G the influence matrix of the surface:
 *   H_i + approach - shape_i - coupling * sum_j G_ij p(H_j) = 0,   coupling = mu^(3/2) / sqrt(R),
 * (the mu Gamma^-1 of Eq 15 times the mu of Eq 16), and W/(pi w R) = (2/R) sum_j weight_j p(H_j),
 * Eq 17.
 *
 * A state is an array of n + 1: the gaps H, then the approach. A border is a linear condition on a
 * state: it makes the Jacobian square and regular at folds. Where tractions hardly respond to the
 * gap the columns of the Jacobian are those of the unit matrix to within `neglect`: these nodes are
 * left out of the factorisation and follow by iteration. */
#ifndef PO_EQUILIBRIUM_H
#define PO_EQUILIBRIUM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "po_factors.h"
#include "po_scene.h"
#include "po_secant.h"
#include "po_surface.h"

/* Change of a gap, relative to 1 + H, at which a correction is as good as rounding lets it be. */
extern const double PO_FINEST_PRECISION;

typedef struct {
  uint64_t points, newton_iterations, tangent_iterations, factorizations;
  uint64_t factorized_nodes; /* largest order */
  uint64_t meshes;           /* changes of the mesh */
} po_solve_work;

typedef struct {
  const po_scene *scene;
  const po_surface *surface;
  size_t n;
  double radius, amplitude, coupling;
  double *shape;           /* n: undeformed gap */
  double *reach;           /* n: largest coefficient of each column of the influence matrix */
  double *traction;        /* n: p, at the state last evaluated */
  double *slope;           /* n: dp/dH */
  double *deflection;      /* n: coupling * G p, or the same of a change of state */
  double *border;          /* n + 1: the condition in force */
  size_t active;           /* nodes in the factorisation */
  size_t *index;           /* n: the active nodes first, then the others */
  po_factors factors;      /* of the bordered Jacobian of the active nodes; active + 1 square */
  double *column;          /* of it, n + 1 */
  double *row;             /* active + 1: its last row, the border */
  bool changed;            /* the border in force is not that of the factors; then */
  double *change;          /* active + 1: what it has more, and */
  double *response;        /* active + 1: the factors' solution for a unit of the last equation */
  double pivot;            /* 1 + change . response */
  double *right, *scratch; /* n + 1 */
  double *measure;         /* n: coupling * |slope| * reach, when choosing nodes */
  double neglect;          /* sum of the measures left out */
  size_t most_active;      /* nodes that a factorisation may have; SIZE_MAX: any */
  double precision;   /* largest change of a gap, in parts of 1 + H, when converged: rounding's, or
                       what the owner sets */
  double last_change; /* of a gap, in parts of 1 + H, by the last iteration of a correction */
  po_secant secant;   /* what iterations tell about the Jacobian since it was factorised */
  bool factorized;
  int orientation; /* sign of the determinant of the factorised matrix */
  po_solve_work work;
} po_equilibrium;

/* Given: room for `capacity` nodes, at least the surface's. Status: PO_NO_MEMORY. Scene and surface
 * must outlive the object. */
po_status po_equilibrium_create(const po_scene *scene, const po_surface *surface, size_t capacity,
                                po_equilibrium **equilibrium);

/* Takes note that the surface was meshed anew, or that the scene changed: nothing of the mesh
 * before is kept. */
void po_equilibrium_remesh(po_equilibrium *e);
void po_equilibrium_destroy(po_equilibrium *equilibrium);

/* Nodes of the core, where contact can be: those up to the end of the scheme's own elements. */
size_t po_equilibrium_core(const po_equilibrium *e);

/* Sets traction and slope from the gaps of a state, every 1 + H > 0. */
void po_equilibrium_evaluate(po_equilibrium *e, const double *state);

/* The integral of Eq 15: deflection_i = coupling * sum_j G_ij traction_j. Given: n values of the
 * traction p, or of a change of it. Returned: deflection, n. */
void po_equilibrium_deflect(const po_equilibrium *e, const double *traction, double *deflection);

/* The residual of Eq 15 at a state, which vanishes for an equilibrium:
 *   residual_i = f_i - approach + coupling * sum_j G_ij p(H_j) - H_i.
 * Given: state, n + 1, every 1 + H > 0. Returned: residual, n; traction and slope are those of the
 * state. */
void po_equilibrium_residual(po_equilibrium *e, const double *state, double *residual);

/* W/(pi w R), Eq 17, of the state last evaluated; and its change per change of state. */
double po_equilibrium_load(const po_equilibrium *e);
double po_equilibrium_load_rate(const po_equilibrium *e, const double *change);

/* The potential energy of the state last evaluated, in pi w R eps, zero when infinitely apart: half
 * the traction times the deflection, and the interaction, by the surface's own quadrature,
 *   U = (2/R) sum_j weight_j [e(H_j) + (1/2) p_j coupling sum_k G_jk p_k],   e' = -p,
 * so that dU/d approach = W/(pi w R) along every branch: up to the symmetry that the discretised
 * kernel has (tests/unit/test_energy.c). An equilibrium's deflection is its gap less the undeformed
 * one: no sum over the influence matrix is made. Given: the same state, an equilibrium. */
double po_equilibrium_energy(const po_equilibrium *e, const double *state);

/* A bound of how much the tractions' response to the gap could feed on itself: the largest row sum
 * of coupling |G| |dp/dH| at the state last evaluated. Below 1 the equilibrium near it is unique.
 */
double po_equilibrium_feedback(const po_equilibrium *e);

/* Factorises the bordered Jacobian at a state and sets its orientation: along one branch it does
 * not change as long as the border makes an acute angle with the tangent that leads ahead. Given:
 * border, n + 1 (copied). Status: PO_SINGULAR; PO_OUT_OF_NODES beyond
 * most_active; PO_NO_MEMORY. */
po_status po_equilibrium_factorize(po_equilibrium *e, const double *state, const double *border);

/* Gives the factors in hand another border, by a rank-one correction of their last row (Sherman and
 * Morrison). Given: border, n + 1 (copied), at the state last evaluated. The factors are given up
 * where the new border is nearly normal to the tangent that they know. */
void po_equilibrium_change_border(po_equilibrium *e, const double *border);

/* Moves a state onto the equilibrium with border . (state - base) = distance, by Newton's method
 * with the factors in hand. Every 1 + H stays positive. Afterwards traction and slope are those of
 * the state. Given: state, a prediction. Status: PO_NOT_CONVERGED when it does not contract fast
 * enough: the state is then of no use. */
po_status po_equilibrium_correct(po_equilibrium *e, double *state, const double *base,
                                 double distance);

/* A condition on a state that picks one equilibrium of a branch: value(e, state) = target. The
 * state was just evaluated when value is asked. */
typedef struct {
  double (*value)(const po_equilibrium *e, const double *state, const void *data);
  const void *data;
  double target;
} po_constraint;

/* The same for any condition whose gradient the border in force is, nearly. */
po_status po_equilibrium_correct_to(po_equilibrium *e, double *state,
                                    const po_constraint *constraint);

/* The tangent of the branch at a state last evaluated, with border . tangent = 1, by the factors in
 * hand and iteration, to a precision in parts of its largest component. Status: PO_NOT_CONVERGED
 * when the factors are too old for that. */
po_status po_equilibrium_tangent(po_equilibrium *e, double precision, double *tangent);

#endif
