/* The predictor in a parameter of the scene: the polynomial in the parameter through the last
 * solutions of a special point, called marks, in coordinates that move with their contact edges.
 * See doc/method.md, "Parameter continuation". */
#ifndef PO_PARAMETER_PREDICTOR_H
#define PO_PARAMETER_PREDICTOR_H

#include <stdbool.h>

#include "po_solution.h"

enum { PO_PREDICTOR_MARKS = 4 };

/* A mark: the solution of the special point at one value of the parameter, and its scene. */
typedef struct {
  double at;
  po_scene scene;
  double domain; /* radius of the domain of the panels, eps */
  po_solution point;
} po_predictor_point;

typedef struct {
  size_t count;
  const po_predictor_point *mark[PO_PREDICTOR_MARKS]; /* the latest first */
  double weight[PO_PREDICTOR_MARKS];
  po_moving_edges edges; /* contact edges of the latest mark that move the coordinates */
  double shift[PO_MOST_MOVING_EDGES];                    /* from these to the predicted edges */
  double back[PO_PREDICTOR_MARKS][PO_MOST_MOVING_EDGES]; /* from these to the edges of each mark */
  /* where values were last needed: the contact edge beyond, and panels of the marks */
  size_t edge, panel[PO_PREDICTOR_MARKS];
} po_predictor;

/* Predicts at the parameter `at`. Given: marks, the latest first. If the number of contact edges
 * differs or the strain is too large, as where a groove closes, only the outermost edge moves the
 * coordinates; the gap is flat at the others. Returned: false if the strain is too large even then.
 */
bool po_predictor_make(const po_predictor_point *const *mark, size_t count, double at,
                       po_predictor *f);

/* The same in coordinates that do not move, for short steps. Where a contact edge closes or forms
 * at the axis it moves ever faster, and the gap is flat there. */
void po_predictor_still(const po_predictor_point *const *mark, size_t count, double at,
                        po_predictor *f);

/* The predicted gap H at a radius, eps; above -1. `predictor` is a po_predictor. */
double po_predictor_gap(void *predictor, double r);

/* The predicted state at the nodes of an equilibrium. Given: core, the number of nodes inside the
 * domain. Returned: state, n + 1. */
void po_predictor_state(po_predictor *f, const po_equilibrium *e, size_t core, double *state);

/* The largest error of the predicted gap in the core, relative to 1 + H. Given: the special point
 * solved. */
double po_predictor_error(po_predictor *f, const po_solution *solved);

#endif
