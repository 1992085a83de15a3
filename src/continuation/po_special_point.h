/* What lies between two points of a branch: folds, extrema of the load, an approach asked for. */
#ifndef PO_SPECIAL_POINT_H
#define PO_SPECIAL_POINT_H

#include <stddef.h>

#include "po_branch_point.h"
#include "po_status.h"

typedef enum {
  PO_OF_APPROACH,
  PO_OF_LOAD,
  PO_AT_STATION, /* the first of PO_STATIONS */
  PO_AT_END = PO_AT_STATION + PO_STATIONS,
} po_event_kind;

/* A point as a function of a parameter that grows along the branch: approach and load, and their
 * rates per parameter. */
typedef struct {
  double at, value[2], rate[2];
  size_t edges; /* edges of the contact, where they are known */
} po_sample;

typedef struct {
  po_event_kind of;
  po_sample low, high; /* bracket */
  double root;         /* the parameter there */
  po_sample here;      /* the sample there, as far as it is located */
  size_t place;        /* under which its point is kept */
} po_event;

/* Error of the parameter at a special point: where its rate vanishes along the arclength. */
extern const double PO_LOCATED;

/* A step with more is too long. */
enum { PO_MOST_EVENTS = 8 };

typedef struct {
  po_event list[PO_MOST_EVENTS]; /* in order along the branch */
  size_t count;
} po_events;

/* How points between the two are had. */
typedef struct {
  void *data;
  po_status (*solve)(void *data, double at, po_sample *sample); /* the equilibrium there */
  void (*keep)(void *data, size_t place); /* keeps the one last solved, in place of an earlier */
  const double *station;                  /* approaches, PO_STATIONS of them; NAN: none */
  double end;                             /* likewise */
} po_interval;

/* Finds and locates the events between two samples, in the parameter.
 * Status: PO_NOT_CONVERGED when the step is too long for that. */
po_status po_events_find(const po_interval *interval, const po_sample *from, const po_sample *to,
                         po_events *found);

/* The kind of point an event is. */
po_point_kind po_event_point(const po_event *event);

/* How the number of unstable modes at fixed approach changes in passing a point along the branch.
 * Given: its kind and the rate of the load along the branch there. */
int po_change_of_modes(po_point_kind kind, double load_rate);

#endif
