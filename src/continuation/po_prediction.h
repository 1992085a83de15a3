/* A state expected further along a branch: by the cubic through two points, in coordinates that
 * move with the contact edges of the first. Where the mesh stays no edges are known, and each node
 * has a cubic of its own. */
#ifndef PO_PREDICTION_H
#define PO_PREDICTION_H

#include <stdbool.h>

#include "po_hermite.h"
#include "po_solution.h"

typedef struct {
  const po_scene *scene;
  double domain; /* radius of the domain of the panels, eps */
  const po_solution *a, *b;
  bool paired;   /* contact edges of a and b are the same */
  bool cubic;    /* else by the tangent of a alone */
  double rate_b; /* of the arclength functional along a's direction, at b */
  po_hermite w;
  po_moving_edges edges;                  /* of a, those that move the coordinates */
  double shift[PO_MOST_MOVING_EDGES];     /* to where they are expected */
  double back[PO_MOST_MOVING_EDGES];      /* to those of b */
  double rate_back[PO_MOST_MOVING_EDGES]; /* of those of b */
} po_prediction;

/* Predicts at a distance along the arclength functional from a, b being another point (ahead,
 * behind or NULL), in the coordinates of all contact edges but those that would move far towards
 * another. Returned: whether it is any use. */
bool po_prediction_make(const po_scene *scene, double domain, const po_solution *a,
                        const po_solution *b, double distance, po_prediction *p);

/* Predicts at a distance, or less far. Contact edges that are about to meet, or have just been
 * born, move ever faster: the shorter the step the nearer it goes with them, and none is short
 * enough up to where they meet. But the gap between them is flat then, and is met by coordinates in
 * which they stay. So the way is as long as all contact edges can be moved, or longer where it
 * makes no more than the error to leave some, in parts of 1 + H, as what it makes on the shorter
 * way grows with the distance. Returned: the distance; 0 when there is none. */
double po_prediction_reach(const po_scene *scene, double domain, const po_solution *a,
                           const po_solution *b, double distance, double error, po_prediction *p);

/* The gap expected at a radius inside the domain; above -1. `prediction` is a po_prediction. */
double po_prediction_gap(void *prediction, double r);

/* The state expected at the nodes of a surface with n nodes, the first `moving` of them on panels
 * that move with the coordinates. Returned: state, n + 1. */
void po_prediction_state(po_prediction *p, const po_surface *surface, size_t moving, double *state);

/* Whether a panel is more than `times` larger than those that a wants at the places its nodes are
 * expected to come from. */
bool po_prediction_too_large(const po_prediction *p, po_panel panel, double times);

/* Largest error of the gap expected in the core, in parts of 1 + H, against the point that was then
 * solved.
 * Given: guess, what po_prediction_state gave at the nodes of the point; NULL when these are
 * others. */
double po_prediction_error(po_prediction *p, const double *guess, const po_solution *solved);

#endif
