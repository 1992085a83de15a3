/* What the files of the tracer share. */
#ifndef PO_BRANCH_INTERNAL_H
#define PO_BRANCH_INTERNAL_H

#include "po_branch.h"
#include "po_resolution.h"

/* A point of the branch: state and unit tangent, n + 1 each. */
typedef struct {
  double *state, *tangent;
  double position, load, load_rate;
} branch_point;

typedef enum { OF_APPROACH, OF_LOAD, AT_STATION, AT_END } event_kind;

/* Something to be told of inside a step. */
typedef struct {
  event_kind of;
  double low, high;     /* bracket, as a distance from current along the border */
  double f_low, f_high; /* the function whose root is the event, at either end */
  double root;
  size_t place; /* in at_event */
} branch_event;

/* A step with more is too long. */
enum { MOST_EVENTS = 8 };

typedef struct {
  branch_event list[MOST_EVENTS];
  size_t count;
} branch_events;

typedef struct {
  po_equilibrium *e;
  const po_branch_options *options;
  branch_point previous, current, next; /* current and next are the ends of the last step */
  branch_point inner;                   /* a point between them */
  branch_events events;                 /* between them, in order */
  branch_point at_event[MOST_EVENTS];   /* their points, in the order they were found */
  double *border, *metric, *predicted;  /* n + 1 */
  double *old_shape;                    /* n: of the mesh before */
  po_legendre legendre;
  po_status trouble; /* what ends the trace at once */
  double step;       /* arclength to try */
  bool has_previous;
  bool station_met;
  int unstable_modes;
  size_t points;
  bool ended;
} tracer;

/* Approach of a point, and its rate along the branch. */
double point_approach(const tracer *t, const branch_point *p);
double point_approach_rate(const tracer *t, const branch_point *p);

/* Scales a tangent, known up to length, to the metric at its state and sets the load and its rate.
 */
void finish_point(tracer *t, branch_point *p);

/* Meshes for the current point and, unless NULL, a state ahead of it; both points are then on the
 * new mesh. Status: PO_OUT_OF_NODES, PO_NOT_CONVERGED with a message. */
po_status remesh(tracer *t, const double *ahead, bool *changed);

/* Error of the gap by the resolution of a point, in parts of what is allowed. */
double excess_of(const tracer *t, const branch_point *p);

/* Sets the border from a point's tangent and factorises at a state. */
po_status refactorize(tracer *t, const branch_point *at, const double *state);

/* border . tangent and border . (to - from) of the border in force. */
double along_border(const tracer *t, const double *vector);
double border_distance(const tracer *t, const double *to, const double *from);

/* Finds and orders what lies between current and next: folds, extrema, the station, the end.
 * Status: PO_NOT_CONVERGED when the step is too long for that. */
po_status find_events(tracer *t);

/* Visits the events found and then next. Sets t->ended when the trace is to end. */
void visit_step(tracer *t);

/* A point as the visitor sees it, but for the tractions. */
po_branch_point seen_point(const tracer *t, const branch_point *p, po_point_kind kind);

/* Copies a point; `to` has its own arrays. */
void copy_point(const tracer *t, const branch_point *from, branch_point *to);

/* Tells the visitor of a point. */
void visit_point(tracer *t, const branch_point *p, po_point_kind kind);

#endif
