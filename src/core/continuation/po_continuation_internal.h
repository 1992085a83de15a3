/* Private to the files po_continuation*.c: the state of a continuation, and the functions that
 * solve a point, make a step, and locate and visit its points. */
#ifndef PO_CONTINUATION_INTERNAL_H
#define PO_CONTINUATION_INTERNAL_H

#include "po_continuation.h"
#include "po_corrector.h"
#include "po_prediction.h"
#include "po_special_point.h"

enum { PO_REFUSALS = 5 };

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
  bool back;  /* on the reverse trace */
  int beyond; /* number of special points of the last step beyond the end of the trace */
  double first_approach, farthest; /* approach and least gap at the first point */
  int unstable_modes;
  double edge_share; /* the weight that suits the outermost contact edge (po_arclength_share) */
  double deepest;    /* deepest minimum of the load so far */
  size_t points;
  int refused[PO_REFUSALS]; /* attempts at short steps that were refused, by their reasons */
};

/* Whether the mesh is of panels, which move with the contact. */
static inline bool on_panels(const po_continuation *t) {
  return po_surface_panels(t->c.e->surface);
}

/* Precision of the tangent at a step. The tangent is used to predict the next point and to detect
 * special points. */
extern const double PO_STEP_TANGENT;

/* One step, from t->current to t->next, with as many attempts as necessary, and its events. Status:
 * PO_STEP_TOO_SMALL; PO_OUT_OF_NODES. */
po_status po_continuation_advance(po_continuation *t);

/* A point of the branch as the visitor sees it; and its visit. */
po_branch_point po_continuation_seen(const po_continuation *t, const po_solution *p,
                                     po_point_kind kind);
void po_continuation_visit(po_continuation *t, const po_solution *p, po_point_kind kind);

/* Visits the events between t->current and t->next, then t->next. */
void po_continuation_visit_step(po_continuation *t);

#endif
