/* How far a run is: a live line on a terminal, plain lines elsewhere, on standard error. */
#ifndef PO_PROGRESS_H
#define PO_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>

typedef struct {
  bool live;    /* on a terminal */
  size_t total; /* points to solve */
  size_t done;
  double effort, spent; /* of all points and of those done, in solves of a point alone */
  double begin;         /* seconds on the monotonic clock */
  double last;          /* when something was last printed */
  size_t width;         /* of the live line on the screen */
} po_progress;

void po_progress_begin(po_progress *progress, size_t total, double effort);

/* One more point is solved; `what` names it. One thread at a time. */
void po_progress_step(po_progress *progress, const char *what, double effort);

/* Prints a line that stays, e.g. that a case is finished. */
void po_progress_say(po_progress *progress, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Clears the live line. */
void po_progress_end(po_progress *progress);

#endif
