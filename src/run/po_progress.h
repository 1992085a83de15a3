/* Shows the progress of a run on standard error: one line that is updated on a terminal, separate
 * lines elsewhere. */
#ifndef PO_PROGRESS_H
#define PO_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>

typedef struct {
  bool live;    /* standard error is a terminal */
  size_t total; /* points to solve */
  size_t done;
  double effort, spent; /* of all points and of the solved ones; 1 is the full trace of a point */
  double begin;         /* seconds of the monotonic clock */
  double last;          /* time of the last output, by the same clock */
  size_t width;         /* of the line that is now on the terminal */
} po_progress;

/* Starts a run of `total` points with the given total effort. */
void po_progress_begin(po_progress *progress, size_t total, double effort);

/* Counts a solved point. Given: `what`, its name; `effort`, its share of the total. Only one thread
 * at a time may call this. */
void po_progress_step(po_progress *progress, const char *what, double effort);

/* Prints a line that remains on the terminal, e.g. when a case is finished. */
void po_progress_say(po_progress *progress, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Erases the updated line. */
void po_progress_end(po_progress *progress);

#endif
