/* What the files of the continuation share: its state, and how a point is solved, a step is made,
 * and what lies on it is visited. */
#ifndef PO_CONTINUATION_PARTS_H
#define PO_CONTINUATION_PARTS_H

#include "po_continuation.h"
#include "po_corrector.h"
#include "po_prediction.h"
#include "po_resolution.h"
#include "po_special_point.h"

struct po_continuation {
  po_corrector c;
  po_continuation_options options;
  po_resolution resolution;
  po_legendre legendre;
  po_solution previous, current, next, inner, spare, at_event[PO_MOST_EVENTS];
  po_events events;
  double step;
  double inner_at; /* of the point in inner, solved on the mesh in force; NAN: none */
  bool has_previous, ended;
  bool back;       /* on the reverse trace */
  int beyond;      /* special points of the last step that lie beyond the end */
  double farthest; /* least gap where the branch began */
  int unstable_modes;
  double deepest; /* minimum of the load so far */
  size_t points;
};

/* Precision of the tangent at a step: it serves to predict the next, and to see what lies between.
 */
extern const double PO_STEP_TANGENT;

/* Whether the mesh consists of panels that follow the contact edges. */
bool po_continuation_moves(const po_continuation *t);

/* The mesh that just resolves a point just solved, into p->wanted; none where the mesh stays. */
po_status po_continuation_want_mesh(po_continuation *t, po_solution *p);

/* The equilibrium at a distance along the arclength functional from the current point, as
 * predicted, on a mesh that resolves it. Given: whether the mesh in force and its factors may
 * serve; precision of the tangent. Returned: out; the error of the prediction, in parts of 1 + H.
 * Status: PO_NOT_CONVERGED also when no mesh resolves it; of a mesh that could not be had. */
po_status po_continuation_solve(po_continuation *t, po_prediction *p, double distance, bool keep,
                                double precision, po_solution *out, double *error);

/* The same from the guess of the corrector, with the factors in hand. */
po_status po_continuation_solve_guessed(po_continuation *t, double distance, po_solution *out);

/* From current to next, by as many attempts as it takes, with the events between. Status:
 * PO_STEP_TOO_SMALL, of a mesh that could not be had. */
po_status po_continuation_advance(po_continuation *t);

/* What lies between current and next. */
po_status po_continuation_find_events(po_continuation *t);

po_branch_point po_continuation_seen(const po_continuation *t, const po_solution *p,
                                     po_point_kind kind);
void po_continuation_visit(po_continuation *t, const po_solution *p, po_point_kind kind);

/* Tells the visitor of the events between current and next, and of next. */
void po_continuation_visit_step(po_continuation *t);

#endif
