/* A landmark expected at another parameter of the scene: the polynomial in the parameter through
 * landmarks solved before, in coordinates that move with their fronts. */
#ifndef PO_FORECAST_H
#define PO_FORECAST_H

#include <stdbool.h>

#include "po_track_point.h"

enum { PO_FORECAST_MARKS = 4 };

/* A landmark at one parameter, with the scene there. */
typedef struct {
  double at;
  po_scene scene;
  double root; /* radius of the panels' root, eps */
  po_track_point point;
} po_waymark;

typedef struct {
  size_t count;
  const po_waymark *mark[PO_FORECAST_MARKS]; /* the latest first */
  double weight[PO_FORECAST_MARKS];
  po_fronts fronts;             /* of the latest mark: what moves */
  double shift[PO_MOST_FRONTS]; /* of the latest's fronts to where they are expected */
  double back[PO_FORECAST_MARKS][PO_MOST_FRONTS]; /* of the latest's fronts to those of a mark */
} po_forecast;

/* Given: marks, the latest first. Where two fronts meet or part, as when a groove closes, only the
 * outermost moves the coordinates: the gap is flat at the others. Returned: whether it is any use:
 * no front moves far towards another. */
bool po_forecast_make(const po_waymark *const *mark, size_t count, double at, po_forecast *f);

/* The same in coordinates that stay: where the innermost front closes at the axis, or is born
 * there, it moves ever faster, and the gap is flat. For short ways. */
void po_forecast_still(const po_waymark *const *mark, size_t count, double at, po_forecast *f);

/* The gap expected at a radius; above -1. `forecast` is a po_forecast. */
double po_forecast_gap(void *forecast, double r);

/* The state expected at the nodes of an equilibrium, the first `core` of them inside the root.
 * Returned: state, n + 1. */
void po_forecast_state(po_forecast *f, const po_equilibrium *e, size_t core, double *state);

/* Largest error of the gap expected, in parts of 1 + H, against the landmark then solved. */
double po_forecast_error(po_forecast *f, const po_track_point *solved);

#endif
