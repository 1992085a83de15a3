/* The solution at a point of a branch: its mesh, state and tangent, and on panels their values
 * between nodes. */
#ifndef PO_SOLUTION_H
#define PO_SOLUTION_H

#include "po_adaptive.h"
#include "po_arclength.h"
#include "po_moving_edges.h"

typedef struct po_solution {
  po_panels panels, wanted; /* the mesh it was solved on, and the one that just resolves it; none
                               where the mesh stays */
  size_t n, core;           /* nodes: all, and of the core */
  double *state, *tangent;  /* n + 1 */
  double *deflection;       /* n: gap less undeformed gap, up to the approach */
  double *slope;            /* n: d deflection / dr */
  double *node;             /* n: radii */
  po_arclength arclength;
  size_t coordinates; /* of the arclength */
  double *coordinate; /* where it is on the branch */
  double *rate;       /* of them, per arclength: a unit vector */
  double load, load_rate, energy;
  double position;
  po_moving_edges edges; /* of the contact, on panels */
} po_solution;

/* Values of a point at one radius. */
typedef struct {
  double gap, slope; /* H and dH/dr */
  double tangent;    /* dH/ds */
} po_solution_value;

po_status po_solution_allocate(po_solution *p, size_t capacity);
void po_solution_free(po_solution *p);
void po_solution_copy(const po_solution *from, po_solution *to);

/* The same point on the reverse trace: all that is a rate along the branch changes its sign. */
void po_solution_turn(po_solution *p);

/* Fills what follows from state and tangent (known up to its length) on the mesh in force, the
 * state being the one last evaluated. Given: adaptive, NULL where the mesh stays. */
void po_solution_finish(po_solution *p, const po_equilibrium *e, const po_adaptive *adaptive);

double po_solution_approach(const po_solution *p);

/* The cosine of the directions of two points. */
double po_solution_cosine(const po_solution *a, const po_solution *b);

/* How far one point is from another along the arclength functional, in the direction of the first.
 */
double po_solution_progress(const po_solution *from, const po_solution *to);

/* The arclength of the arclength functional between two points, as of an arc that turns as their
 * rates do. */
double po_solution_way(const po_solution *from, const po_solution *to);

/* Values at a radius inside the domain, of a solution on panels. */
po_solution_value po_solution_value_at(const po_solution *p, const po_scene *scene, double domain,
                                       double r);

/* The gap of a point as a function of the radius, for po_gap_field: data is a po_solution_field. */
typedef struct {
  const po_solution *p;
  const po_scene *scene;
  double domain;
} po_solution_field;

double po_solution_gap(void *data, double r);

#endif
