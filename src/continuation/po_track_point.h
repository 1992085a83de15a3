/* A point of a branch on panels: its mesh, its state and tangent, and their values between nodes.
 */
#ifndef PO_TRACK_POINT_H
#define PO_TRACK_POINT_H

#include "po_adaptive.h"
#include "po_arclength.h"
#include "po_moving_edges.h"
#include "po_special_point.h"

typedef struct po_track_point {
  po_panels panels, wanted; /* the mesh it was solved on, and the one that just resolves it */
  size_t n;
  double *state, *tangent;              /* n + 1 */
  double *deflection;                   /* n: gap less undeformed gap, up to the approach */
  double *slope;                        /* n: d deflection / dr */
  double *node;                         /* n: radii */
  double functional[PO_ARCLENGTH_SIZE]; /* where it is on the branch */
  double rate[PO_ARCLENGTH_SIZE]; /* per arclength of the arclength functional: a unit vector */
  double load, load_rate, energy;
  double position;
  po_moving_edges edges;
} po_track_point;

/* Values of a point at one radius. */
typedef struct {
  double gap, slope; /* H and dH/dr */
  double tangent;    /* dH/ds */
} po_track_value;

po_status po_track_point_allocate(po_track_point *p, size_t capacity);
void po_track_point_free(po_track_point *p);
void po_track_point_copy(const po_track_point *from, po_track_point *to);

/* The same point on the reverse trace: all that is a rate along the branch changes its sign. */
void po_track_point_turn(po_track_point *p);

/* Fills what follows from state and tangent (known up to its length) on the mesh in force, the
 * state being the one last evaluated. */
void po_track_point_finish(po_track_point *p, const po_equilibrium *e, const po_adaptive *adaptive);

/* How far one point is from another along the arclength functional, in the direction of the first.
 */
double po_track_progress(const po_track_point *from, const po_track_point *to);

/* The arclength of the arclength functional between two points, as of an arc that turns as their
 * rates do. */
double po_track_way(const po_track_point *from, const po_track_point *to);

/* Values at a radius inside the domain. */
po_track_value po_track_value_at(const po_track_point *p, const po_scene *scene, double domain,
                                 double r);

/* The gap of a point as a function of the radius, for po_gap_field: data is a po_track_field. */
typedef struct {
  const po_track_point *p;
  const po_scene *scene;
  double domain;
} po_track_field;

double po_track_gap(void *data, double r);

/* Approach and load as functions of the distance along the arclength functional from another point.
 */
po_sample po_track_sample(const po_track_point *from, const po_track_point *p);

#endif
