/* The solution at one point of a branch: mesh, state, tangent, and what follows from them. On
 * panels it has values between the nodes. */
#ifndef PO_SOLUTION_H
#define PO_SOLUTION_H

#include "po_arclength.h"
#include "po_moving_edges.h"

typedef struct po_solution {
  size_t n, core;          /* numbers of nodes: all, and in the core */
  double *state, *tangent; /* n + 1 */
  double *deflection;      /* n: H - f, the deflection less the approach */
  double *slope;           /* n: d(deflection)/dr */
  double *node;            /* n: radii, eps */
  double domain;           /* radius of the core of its surface, on panels of their domain, eps */
  po_arclength arclength;
  size_t coordinates; /* number of coordinates of the arclength */
  double share;       /* po_equilibrium.share, with which the coordinates are */
  double *coordinate; /* its coordinates (po_arclength.h) */
  double *rate; /* their derivatives by the arclength: a unit vector, the direction of the branch */
  double load, load_rate, energy;
  double position;
  po_moving_edges edges; /* contact edges, on panels only */
  /* the mesh of this solution, and the coarsest that resolves it; empty on a fixed mesh */
  po_panels *panels, *wanted;
} po_solution;

/* Values of a solution at one radius. */
typedef struct {
  double gap, slope; /* H and dH/dr */
  double tangent;    /* dH/ds */
} po_solution_value;

/* Allocates a solution of at most `capacity` nodes in `arrays`. Status: PO_NO_MEMORY. */
po_status po_solution_allocate(po_solution *p, size_t capacity, po_arena *arrays);
void po_solution_copy(const po_solution *from, po_solution *to);
void po_solution_exchange(po_solution *a, po_solution *b);

/* Multiplies the weight of approach and load in the global coordinates by a factor. */
void po_solution_reweigh(po_solution *solution, double factor);

/* Reverses the direction of the branch: every derivative along the branch changes its sign. */
void po_solution_turn(po_solution *p);

/* Fills all members that do not depend on the tangent from the state on the current mesh. Given:
 * the state must be the one last evaluated. */
void po_solution_take_state(po_solution *p, const po_equilibrium *e);

/* Fills the derivatives along the branch from the tangent, and scales them to unit arclength.
 * Given: p has taken its state, the one last evaluated. */
void po_solution_take_tangent(po_solution *p, const po_equilibrium *e);

/* Scales all derivatives along the branch to unit arclength. Given: `rate` is filled. */
void po_solution_scale_tangent(po_solution *p);

/* po_solution_take_state, then po_solution_take_tangent. */
void po_solution_finish(po_solution *p, const po_equilibrium *e);

double po_solution_approach(const po_solution *p);

/* The cosine of the angle between the directions of the branch at two points. */
double po_solution_cosine(const po_solution *a, const po_solution *b);

/* The arclength functional of the first point, evaluated at the second: direction . (difference of
 * the coordinates). */
double po_solution_progress(const po_solution *from, const po_solution *to);

/* The length of the tangent in the arclength with share 1, the unit of po_branch_point.position. */
double po_solution_length(const po_solution *solution);

/* The arclength between two points, with share 1 and as that of a circular arc with the directions
 * at both. The coordinates of both have the same share. */
double po_solution_way(const po_solution *from, const po_solution *to);

/* A solution on panels as a function of the radius. */
typedef struct {
  const po_solution *p;
  const po_scene *scene;
  size_t panel; /* of the last radius, which is likely to be near */
} po_solution_field;

/* Values of a solution at a radius inside the domain, eps. */
po_solution_value po_solution_value_at(po_solution_field *field, double r);

/* The gap alone, as po_gap_field needs it: `data` is a po_solution_field. */
double po_solution_gap(void *data, double r);

#endif
