/* One equilibrium: the discretised Eq 15 with the traction-separation law of Eq 16, and the load,
 * Eq 17.
 *
 * Lengths are in eps, p = P/mu is the traction of Eq 16 without its factor mu, f the initial gap of
 * Eq 2, and G the influence matrix of the surface:
 *
 *   H_i - f_i + approach - coupling * sum_j G_ij p(H_j) = 0     Eq 15 at node i
 *   coupling = mu^(3/2) / sqrt(R)                               mu/Gamma (Eq 15) times mu (Eq 16)
 *   W/(pi w R) = (2/R) sum_j weight_j p(H_j)                    Eq 17
 *
 * po_equilibrium_residual evaluates Eq 15, po_equilibrium_load Eq 17. See doc/method.md, "One
 * equilibrium".
 *
 * A state is an array of n + 1 values: the gaps H, then the approach. A border is one more linear
 * condition on a state. It makes the Jacobian square, and regular at folds. Where the traction
 * hardly depends on the gap, the columns of the Jacobian are those of the unit matrix. Such nodes
 * are left out of the factorisation, and their gaps follow by iteration; the other nodes are called
 * active. */
#ifndef PO_EQUILIBRIUM_H
#define PO_EQUILIBRIUM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "po_elimination.h"
#include "po_result.h"
#include "po_scene.h"
#include "po_secant.h"
#include "po_surface.h"

/* Smallest precision of Newton's method: the change of a gap, relative to 1 + H, that is due to
 * rounding. */
extern const double PO_FINEST_PRECISION;

/* LU factors of a dense matrix in single or double precision. Single precision takes half the time
 * of double precision; the iteration corrects the effect of its rounding. On smooth spheres up to
 * mu = 50 and wavy spheres up to mu = 10, at tolerances down to 1e-10, no more iterations were
 * needed than with double precision. */
typedef struct {
  size_t n;
  size_t room;      /* allocated size of `matrix`, in elements */
  float *matrix;    /* n x n, column-major; the LU factors when it is factorised */
  float *right;     /* n: the scaled right-hand side */
  bool in_double;   /* the next matrix is in double precision */
  bool is_double;   /* the present one is */
  size_t wide_room; /* as room, of `wide` */
  double *wide;     /* as matrix, in double precision */
  int *pivots;      /* n, row indices from 1 (LAPACK) */
} po_factors;

/* The largest number of directions in which factors are corrected. */
enum { PO_MOST_WEAK = 4 };

/* The largest number of iterations of GMRES (po_krylov.h). */
enum { PO_KRYLOV_DEPTH = 40 };

typedef struct {
  const po_scene *scene;
  po_surface *surface;
  size_t n;
  double radius, amplitude, coupling; /* amplitude: by which the law is averaged */
  bool energy_at_zero; /* the energy beyond the core is relative to that of the initial gap */
  bool energy_apart;   /* the energy on the panel to infinity is integrated by po_far_energy */
  double *initial_gap; /* n: initial gap f, Eq 2 */
  double *traction;    /* n: p at the state last evaluated */
  double *slope;       /* n: dp/dH */
  double *deflection;  /* n + 1: work: a deflection, or the residual of an iteration */
  double *border;      /* n + 1: the current border */
  double *source;      /* n + 1: right-hand side of po_equilibrium_solve */
  size_t active;       /* number of active nodes, which are factorised */
  size_t together;     /* nodes that are active together: those of a panel, or 1 */
  size_t
      *index; /* n: the active nodes first, then the others; or the panels to which they belong */
  po_elimination *elimination; /* of panels: the factors of the bordered Jacobian; NULL of rings and
                                  triangles, which have: */
  po_factors factors;          /* of the bordered Jacobian of the active nodes, active + 1 square */
  double *column;              /* n + 1: one column of that matrix */
  double *row;                 /* active + 1: last row of the factorised matrix, its border */
  bool changed;                /* the current border differs from that of the factors */
  double *change;              /* active + 1: current border less that of the factors */
  double *response; /* active + 1: solution of the factorised system for the last unit vector */
  double pivot;     /* 1 + change . response */
  double *right, *scratch; /* n + 1 */
  double *measure;         /* n: coupling * |slope| * reach, by which active nodes are chosen */
  double neglect;          /* largest sum of the measures of the nodes that are not active */
  double precision;      /* change of a gap, relative to 1 + H, at which an iteration has converged:
                            PO_FINEST_PRECISION unless the owner sets another */
  double last_change;    /* largest change of a gap, relative to 1 + H, in the last iteration of a
                            correction */
  double share;          /* factor of approach and load in the global arclength coordinates */
  double load_weight;    /* factor of the load in them, beside share */
  double approach_scale; /* what the approach is divided by, beside share: along a branch it varies
                            by a few eps and elongations at pull-off, the load by one or two */
  double noise; /* change of a gap, relative to 1 + H, by the rounding of Eq 15, at the state of the
                   last factorisation */
  double reached; /* error of a gap, relative to 1 + H, that the last correction may have left */
  double gain;    /* its ratio to that rounding, relative to 1 + H */
  double *weak, *weak_functional; /* (n + 1) x PO_MOST_WEAK: u and v of correct_weak */
  size_t weak_count;              /* corrections of the present factors by these */
  po_secant secant;               /* Broyden's updates since the factorisation */
  bool factorized;
  int orientation; /* sign of the determinant of the factors, without Broyden's updates */
  po_work work; /* points, iterations, factorisations and meshes; what the surface, a trace and the
                   clock count is 0 */
  bool narrow;  /* the contact edge is so narrow that approach and load have little weight in the
                   arclength functional (po_arclength_share) */
  bool by_krylov; /* linear systems are solved by GMRES, because the factors are too inaccurate for
                     a quasi-Newton iteration */
  double *krylov; /* (n + 1) x (PO_KRYLOV_DEPTH + 1): its basis */
  uint64_t tangent_iterations; /* of solves for a tangent, for tests */
  po_arena arrays;             /* all but the matrices of `factors` */
} po_equilibrium;

/* Given: scene and surface, which must outlive the object. The surface is not changed here; its
 * owner or a continuation may mesh it anew, and then calls po_equilibrium_remesh. Status:
 * PO_NO_MEMORY. */
po_status po_equilibrium_create(const po_scene *scene, po_surface *surface,
                                po_equilibrium **equilibrium);

/* Must be called after the mesh of the surface or the scene changed. The factors are discarded. */
void po_equilibrium_remesh(po_equilibrium *e);

/* Must be called before that if the scene became another one, so that the arclength functional is
 * that of a trace of this scene: the directions of its points belong to these weights. */
void po_equilibrium_rescale(po_equilibrium *e);
void po_equilibrium_destroy(po_equilibrium *equilibrium);

/* Number of nodes of the core, the part of the surface that the elements or panels of the scheme
 * cover. Contact is possible there only. */
size_t po_equilibrium_core(const po_equilibrium *e);

/* Sets traction and slope, Eq 16, from the gaps of a state. Given: state, n + 1, every 1 + H > 0.
 */
void po_equilibrium_evaluate(po_equilibrium *e, const double *state);

/* The integral of Eq 15: deflection_i = coupling * sum_j G_ij traction_j. Given: n values of the
 * traction p, or of a change of it. Returned: deflection, n. */
void po_equilibrium_deflect(const po_equilibrium *e, const double *traction, double *deflection);

/* The residual of Eq 15 at a state, which vanishes for an equilibrium:
 *   residual_i = f_i - approach + coupling * sum_j G_ij p(H_j) - H_i
 *
 * Given: state, n + 1, every 1 + H > 0. Returned: residual, n; traction and slope are those of the
 * state. */
void po_equilibrium_residual(po_equilibrium *e, const double *state, double *residual);

/* W/(pi w R), Eq 17, of the state last evaluated; and its derivative along a change of the state.
 * Given: change, n + 1. */
double po_equilibrium_load(const po_equilibrium *e);
double po_equilibrium_load_rate(const po_equilibrium *e, const double *change);

/* The total potential energy U of the state last evaluated, in pi w R eps, zero when the bodies are
 * infinitely far apart. It is the energy of the interaction plus half the traction times the
 * deflection:
 *
 *   U = (2/R) sum_j weight_j [phi(H_j) + (1/2) p_j u_j],   phi' = -p,   u_j = H_j + approach - f_j
 *
 * On the panel to infinity phi falls more slowly than p. Its integral there is po_far_energy unless
 * the weights of p are exact for it, too.
 *
 * If the energy of the far field is infinite, as for a cone under the law of the paper, that of the
 * initial gap at approach 0 is subtracted beyond the core.
 *
 * Along every branch dU/d(approach) = W/(pi w R), as far as the discretised kernel is symmetric
 * (tests/unit/test_energy.c). Given: the state last evaluated, which is an equilibrium, so that u
 * is its deflection. */
double po_equilibrium_energy(const po_equilibrium *e, const double *state);

/* Factorises the bordered Jacobian of Eq 15 at a state and sets its orientation. The orientation is
 * constant along a branch as long as the border makes an acute angle with the tangent in the
 * direction of the trace. Given: state, and border, n + 1 each; the border is copied. Status:
 * PO_SINGULAR; PO_NO_MEMORY. */
po_status po_equilibrium_factorize(po_equilibrium *e, const double *state, const double *border);

/* Measures noise and gain by solving with the present factors for a residual that consists of
 * rounding. Given: the state of the factorisation. */
void po_equilibrium_measure_noise(po_equilibrium *e, const double *state);

/* Whether the gain asks for factors that are more accurate than the present ones. */
bool po_equilibrium_is_coarse(const po_equilibrium *e);

/* Replaces the border of the present factors, by a rank-one correction of their last row (Sherman
 * and Morrison). Given: border, n + 1 (copied), at the state last evaluated. The factors are
 * discarded if the new border is nearly normal to the tangent at the state of the factorisation. */
void po_equilibrium_change_border(po_equilibrium *e, const double *border);

/* Solves for the change of a state from a residual with the present factors. The factors give the
 * change at the active nodes and of the approach; the other nodes follow from their own equations.
 * Given: residual, n + 1. Returned: change, n + 1. */
void po_equilibrium_precondition(po_equilibrium *e, const double *residual, double *change);

/* The bordered Jacobian of Eq 15 at the state last evaluated times a change. Given: change, n + 1.
 * Returned: product, n + 1, which may be e->deflection. */
void po_equilibrium_multiply(po_equilibrium *e, const double *change, double *product);

/* Solves Eq 15 with the condition border . (state - base) = distance by Newton's method with the
 * present factors. Every 1 + H stays positive. Given: state, n + 1, a prediction. Returned: state;
 * traction and slope are those of the state. Status: PO_NOT_CONVERGED if the iteration does not
 * contract fast enough; the state is then undefined. */
po_status po_equilibrium_correct(po_equilibrium *e, double *state, const double *base,
                                 double distance);

/* A condition value(e, state) = target that selects one equilibrium of a branch. The state has been
 * evaluated when `value` is called. */
typedef struct {
  double (*value)(const po_equilibrium *e, const double *state, const void *data);
  const void *data;
  double target;
  double farthest; /* change of a gap in one iteration, relative to 1 + H, above which the iteration
                      is given up; INFINITY: only if it does not converge */
} po_constraint;

/* The same for any condition. The current border must approximate the gradient of the condition. */
po_status po_equilibrium_correct_to(po_equilibrium *e, double *state,
                                    const po_constraint *constraint);

/* Solves the linearised Eq 15 at the state last evaluated for the right-hand side e->source,
 *
 *   x_i + x_n - coupling * sum_j G_ij dp/dH_j x_j = source_i,   border . x = source_n,
 *
 * by iteration with the present factors. Given: precision, relative to the largest component of x,
 * where those of the gaps are measured in `unit`, n (NULL for 1). Returned: solution x, n + 1.
 * Status: PO_NOT_CONVERGED if the factors are too old. */
po_status po_equilibrium_solve(po_equilibrium *e, const double *unit, double precision,
                               double *solution);

/* The tangent of the branch at the state last evaluated, scaled so that border . tangent = 1, by
 * iteration with the present factors. Given: precision, relative to the largest component of the
 * tangent. Returned: tangent, n + 1. Status: PO_NOT_CONVERGED if the factors are too old. */
po_status po_equilibrium_tangent(po_equilibrium *e, double precision, double *tangent);

#endif
