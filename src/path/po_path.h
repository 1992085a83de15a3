/* A curve of equilibria, point by point from far apart to pressed together, and what lies between
 * its points. It may come from a traced branch or from a closed form. */
#ifndef PO_PATH_H
#define PO_PATH_H

#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"

/* Folds and extrema of the load must be among the points, so that approach and load each run one
 * way between neighbours. */
typedef struct {
  double approach, load;           /* Delta/eps, W/(pi w R) */
  double energy;                   /* U/(pi w R eps), d energy = load d approach */
  double contact_radius;           /* eps */
  double position;                 /* ascending along the curve: arclength, or another parameter */
  double approach_rate, load_rate; /* per position */
  int unstable_modes;              /* of the equilibria just after it, at fixed approach */
  bool minimum;                    /* the load has a local minimum here */
} po_path_point;

typedef struct {
  const po_path_point *point;
  size_t count;
} po_path;

/* A place on a curve: a part (0 to 1) of the way from point `index` to the next. */
typedef struct {
  size_t index;
  double part;
} po_path_place;

/* An equilibrium anywhere on it. */
typedef struct {
  double approach, load, energy, contact_radius, position;
} po_path_state;

/* Bounds of the errors of a state. */
typedef struct {
  double approach, load;
} po_path_error;

/* Whether an approach is one that was asked for, which a trace meets to 1e-12. */
bool po_path_is_at(double approach, double asked);

/* Whether an approach is at least one that was asked for, likewise. */
bool po_path_reaches(double approach, double asked);

/* Between points: the cubic of the position with the rates at both, the energy by its own; the
 * contact radius linearly. The error goes as the fourth power of the way. */
po_path_state po_path_at(const po_path *path, po_path_place place);

/* The place between point `index` and the next at which a quantity has a value that lies between
 * theirs. */
typedef enum { PO_PATH_APPROACH, PO_PATH_LOAD } po_path_axis;
po_path_place po_path_where(const po_path *path, size_t index, po_path_axis axis, double value);

/* Integral of the load d approach between two parts of the way from point `index` to the next,
 * exactly on that cubic (which the energies have no part in). */
double po_path_work(const po_path *path, size_t index, double from, double to);

#endif
