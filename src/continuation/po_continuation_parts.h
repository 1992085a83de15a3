/* Private to the files po_continuation*.c: the state of a continuation, and the functions that
 * solve a point, make a step, and locate and visit its points. */
#ifndef PO_CONTINUATION_PARTS_H
#define PO_CONTINUATION_PARTS_H

#include "po_continuation.h"
#include "po_corrector.h"
#include "po_prediction.h"
#include "po_special_point.h"

struct po_continuation {
  po_corrector c;
  po_continuation_options options;
  po_solution previous, current, next, inner, spare, at_event[PO_MOST_EVENTS];
  po_events events;
  double step;
  double error_factor; /* of the last step: error over (step (step + previous step))^2; NAN: none */
  double inner_at; /* value of the arclength functional at `inner`, which is on the current mesh;
                      NAN: none */
  bool has_previous, ended;
  bool back;       /* on the reverse trace */
  int beyond;      /* number of special points of the last step beyond the end of the trace */
  double farthest; /* least gap at the first point */
  int unstable_modes;
  double deepest; /* deepest minimum of the load so far */
  size_t points;
};

/* Precision of the tangent at a step. The tangent is used to predict the next point and to detect
 * special points. */
extern const double PO_STEP_TANGENT;

/* Whether the mesh consists of panels that follow the contact edges. */
bool po_continuation_moves(const po_continuation *t);

/* Solves for the equilibrium at a distance along the arclength functional from the current point,
 * on a mesh that resolves it. Given: the prediction; `keep`, whether the current mesh and factors
 * may be used; precision of the tangent. Returned: out; error, that of the prediction, relative
 * to 1 + H, unless NULL. Status: PO_NOT_CONVERGED, also if no mesh resolves the solution;
 * PO_OUT_OF_NODES. */
po_status po_continuation_solve(po_continuation *t, po_prediction *p, double distance, bool keep,
                                double precision, po_solution *out, double *error);

/* The same from the guess of the corrector; repeated on a new mesh while the solution is not
 * resolved. Given: keep, whether the present factors are tried first. */
po_status po_continuation_solve_guessed(po_continuation *t, double distance, bool keep,
                                        double precision, po_solution *out);

/* Solves the current point again on the present mesh, if its arclength functional differs there
 * from that on its own mesh by more than a step: no shorter step would converge then. The next step
 * is predicted from this solution alone. Returned: whether that was done. */
bool po_continuation_settle(po_continuation *t, double step);

/* Precision of the tangents in a step of this length. */
double po_continuation_tangent_precision(const po_continuation *t, double step);

/* One step, from t->current to t->next, with as many attempts as necessary, and its events. Status:
 * PO_STEP_TOO_SMALL; PO_OUT_OF_NODES. */
po_status po_continuation_advance(po_continuation *t);

void po_continuation_visit(po_continuation *t, const po_solution *p, po_point_kind kind);

/* Visits the events between t->current and t->next, then t->next. */
void po_continuation_visit_step(po_continuation *t);

#endif
