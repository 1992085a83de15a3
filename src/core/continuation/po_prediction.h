/* The predictor along the branch: the cubic through two points, with the tangents at both, in
 * coordinates that move with the contact edges of the first point. On a fixed mesh the cubic is
 * that of each node. See doc/method.md, "Prediction and correction". */
#ifndef PO_PREDICTION_H
#define PO_PREDICTION_H

#include <stdbool.h>

#include "po_hermite.h"
#include "po_resolution.h"
#include "po_solution.h"

typedef struct {
  const po_solution *a, *b;
  po_solution_field of_a, of_b; /* the same as functions of the radius, on panels */
  bool paired;                  /* a and b have the same contact edges */
  bool cubic;                   /* otherwise the prediction is the tangent at a */
  double rate_b;                /* d(arclength functional of a)/ds at b */
  double kink, slope_jump; /* where the slope of the profile jumps, eps; by how much. INFINITY and
                              0: nowhere */
  po_hermite w;
  po_moving_edges edges;                  /* contact edges of a that move the coordinates */
  double shift[PO_MOST_MOVING_EDGES];     /* from these to the predicted edges */
  double back[PO_MOST_MOVING_EDGES];      /* from these to the edges of b */
  double rate_back[PO_MOST_MOVING_EDGES]; /* rates of the edges of b */
  /* where values were last needed: the contact edge beyond, and the panel of a->wanted */
  size_t edge, panel_wanted;
} po_prediction;

/* A step along the arclength functional that is so short that not its length is why it fails, but
 * contact edges that are about to meet, or the factors. */
extern const double PO_SHORT_STEP;

/* Predicts at a distance along the arclength functional of a. Given: e, for its scene; b, another
 * point ahead or behind, or NULL. All contact edges move the coordinates, except pairs whose strain
 * would be too large. Returned: false if no prediction is possible. */
bool po_prediction_make(const po_equilibrium *e, const po_solution *a, const po_solution *b,
                        double distance, po_prediction *p);

/* Predicts at the given distance or a shorter one. Contact edges that are about to meet, or have
 * just formed, move ever faster, so that no step is short enough to move with them. The gap between
 * such edges is flat and can be predicted in coordinates in which they do not move. The function
 * therefore finds the greatest distance at which all contact edges can move; it returns a longer
 * one if leaving some edges out changes the prediction by less than `error`, relative to 1 + H,
 * extrapolated from the shorter distance. Returned: the distance; 0 if no prediction is possible.
 */
double po_prediction_reach(const po_equilibrium *e, const po_solution *a, const po_solution *b,
                           double distance, double error, po_prediction *p);

/* The predicted gap H at a radius inside the domain, eps; above -1. `prediction` is a
 * po_prediction. */
double po_prediction_gap(void *prediction, double r);

/* The predicted state at the n nodes of a surface. Given: moving, the number of nodes on panels,
 * which are predicted in the moving coordinates. Returned: state, n + 1. */
void po_prediction_state(po_prediction *p, const po_surface *surface, size_t moving, double *state);

/* Whether a panel is more than `times` as large as a panel of a->wanted at the radii that the
 * displacement moves into it. */
bool po_prediction_too_large(po_prediction *p, po_panel panel, double times);

/* The largest error of a predicted gap in the core, relative to 1 + H. Given: the law; the
 * solution; guess, the predicted state at the nodes of the solution, or NULL if the nodes have
 * changed. */
double po_prediction_error(const po_gap_field *predicted, const po_law *law, const double *guess,
                           const po_solution *solved);

#endif
