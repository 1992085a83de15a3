/* The events between two points of a branch: special points (folds and extrema of the load),
 * stations, and the end of the trace. See doc/method.md, "Special points". */
#ifndef PO_SPECIAL_POINT_H
#define PO_SPECIAL_POINT_H

#include <stdbool.h>
#include <stddef.h>

#include "po_branch_point.h"
#include "po_status.h"

typedef enum {
  PO_OF_APPROACH,
  PO_OF_LOAD,
  PO_AT_STATION, /* the first of PO_STATIONS stations */
  PO_AT_STATION_LOAD = PO_AT_STATION + PO_STATIONS,
  PO_AT_END,
} po_event_kind;

/* Approach and load of a point, and their rates, as functions of a parameter that grows along the
 * branch: the arclength functional of the point at which the step begins. The index is
 * PO_OF_APPROACH or PO_OF_LOAD. */
typedef struct {
  double at, value[2], rate[2];
  size_t edges; /* number of contact edges, on panels */
} po_sample;

typedef struct {
  po_event_kind of;
  po_sample low, high; /* bracket */
  double root;         /* the parameter at the event */
  po_sample here;      /* the sample at `root` */
  double left;         /* estimated distance of `root` from the event */
  size_t place;        /* index under which its solution is kept */
} po_event;

/* Accuracy to which the parameter at a special point is found. */
extern const double PO_LOCATED;

/* Whether the quantity that is extremal at a special point has its value there to the precision of
 * the solution. That is the best that can be had where rounding limits its rate. Given: the sample,
 * and its estimated distance from the special point. */
bool po_special_point_is_close(const po_sample *sample, po_event_kind of, double distance,
                               double precision);

/* Largest number of events of a step. A step with more is repeated with a smaller length. */
enum { PO_MOST_EVENTS = 8 };

typedef struct {
  po_event list[PO_MOST_EVENTS]; /* in order along the branch */
  size_t count;
} po_events;

/* Access to the points between two points of a branch. */
typedef struct {
  void *data;
  /* solves for the equilibrium at a parameter; roughly: the tangent need not be more precise
   * than at the ends of a step */
  po_status (*solve)(void *data, double at, bool roughly, po_sample *sample);
  void (*keep)(void *data,
               size_t place); /* keeps the last solution under an index, replacing an earlier one */
  const double *station;      /* PO_STATIONS approaches, eps; NAN: none */
  double station_load;        /* pi w R; NAN: none */
  double precision; /* error of approach and load of a solution, relative to 1 + their modulus */
  double end;       /* approach at which the trace ends, eps; NAN: none */
} po_interval;

/* Finds the events between two samples and locates them. Status: PO_NOT_CONVERGED if the step is
 * too long: an equilibrium between the samples is not found, or there are too many events. */
po_status po_events_find(const po_interval *interval, const po_sample *from, const po_sample *to,
                         po_events *found);

#endif
