/* What a test measures after every preload: the pull-off against the greatest approach, or the
 * greatest load, that the bodies were pressed to. Along one curve of equilibria this is a
 * staircase.
 *
 * Loading follows stable stretches of the curve and jumps between them (po_loop.h), whatever the
 * preload is; a preload only says where on that path loading is reversed. Unloading from anywhere
 * on one stable stretch goes back to the lower end of the stretch and from there the same way. So
 * the pull-off changes only where loading jumps to another stretch, or where it passes a minimum
 * of the load that is deeper than what unloading would meet: at special points of the curve. While
 * loading is on its way down to such a minimum, the tension is greatest at the reversal itself: one
 * step ends there (`until`) before the next begins. The energy lost changes at jumps alone. */
#ifndef PO_STAIRCASE_H
#define PO_STAIRCASE_H

#include "po_stable.h"

/* One set of jumps: the cycles of all preloads from `preload` up to that of the next. */
typedef struct {
  po_path_state preload; /* the fold at which loading jumps, before the jump */
  double energy_lost;    /* in all jumps of loading and unloading; NAN: boundless, the bodies part
                            under tension, or the curve does not reach far enough out */
  double energy_error;   /* a bound of its error; NAN: not known to the reader of the curve */
  size_t jumps;          /* of loading and unloading */
  double lever;          /* sum over the jumps of 1 + |load before| + |load after| */
} po_cycle;

/* The preloads from `preload` to `until` with one pull-off. */
typedef struct {
  po_path_state preload;  /* where it begins: a special point of the curve */
  po_path_state until;    /* where it ends, or the last state of loading on the curve */
  bool jumped;            /* it begins at a jump of loading; else at a minimum of the load */
  bool open;              /* the curve ends before the step does */
  po_path_state pull_off; /* the greatest tension met in unloading */
  po_path_error preload_error, pull_off_error; /* NAN: not known to the reader of the curve */
  po_cycle *cycle;                             /* in the order of their preloads */
  size_t cycle_count;
} po_step;

typedef struct {
  po_control control;
  po_step *step; /* in the order of their preloads */
  size_t count;
  po_path_state reached; /* the last state of loading on the curve */
} po_staircase;

/* Given: a curve that begins with the bodies far apart. Returned: to be given to
 * po_staircase_clear. In load control the bodies come together without a load, and the first step
 * begins there, at approach -INFINITY. No steps: loading on this curve passes no minimum. Status:
 * PO_NO_MEMORY. Accuracy: that of the points where a step begins at one, of po_path_at elsewhere.
 */
po_status po_staircase_read(const po_path *path, po_control control, po_staircase *staircase);
void po_staircase_clear(po_staircase *staircase);

/* The step with the greatest pull-off force; NULL: none. */
const po_step *po_staircase_greatest(const po_staircase *staircase);

#endif
