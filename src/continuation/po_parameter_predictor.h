/* A special point expected at another parameter of the scene: the polynomial in the parameter
 * through special points solved before, in coordinates that move with their contact edges. */
#ifndef PO_PARAMETER_PREDICTOR_H
#define PO_PARAMETER_PREDICTOR_H

#include <stdbool.h>

#include "po_solution.h"

enum { PO_PREDICTOR_MARKS = 4 };

/* A special point at one parameter, with the scene there. */
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
  po_moving_edges edges;              /* of the latest mark: what moves */
  double shift[PO_MOST_MOVING_EDGES]; /* of the latest's contact edges to where they are expected */
  double back[PO_PREDICTOR_MARKS]
             [PO_MOST_MOVING_EDGES]; /* of the latest's contact edges to those of a mark */
} po_predictor;

/* Given: marks, the latest first. Where two contact edges meet or part, as when a groove closes,
 * only the outermost moves the coordinates: the gap is flat at the others. Returned: whether it is
 * any use: no contact edge moves far towards another. */
bool po_predictor_make(const po_predictor_point *const *mark, size_t count, double at,
                       po_predictor *f);

/* The same in coordinates that stay: where the innermost contact edge closes at the axis, or is
 * born there, it moves ever faster, and the gap is flat. For short ways. */
void po_predictor_still(const po_predictor_point *const *mark, size_t count, double at,
                        po_predictor *f);

/* The gap expected at a radius; above -1. `predictor` is a po_predictor. */
double po_predictor_gap(void *predictor, double r);

/* The state expected at the nodes of an equilibrium, the first `core` of them inside the domain.
 * Returned: state, n + 1. */
void po_predictor_state(po_predictor *f, const po_equilibrium *e, size_t core, double *state);

/* Largest error of the gap expected, in parts of 1 + H, against the special point then solved. */
double po_predictor_error(po_predictor *f, const po_solution *solved);

#endif
