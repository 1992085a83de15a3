/* The pull-off as a function of the preload: the greatest approach, or the greatest load, to which
 * the bodies are pressed. Along one curve of equilibria this function is a staircase.
 *
 * Loading follows stable stretches of the curve (consecutive stable segments) and jumps between
 * them (po_loop.h), independently of the preload; the preload only determines where loading is
 * reversed. Unloading from any state of one stable stretch returns to the lower end of that stretch
 * and is the same from there on. Therefore the pull-off changes only where loading jumps to another
 * stretch, or where it passes a minimum of the load that is lower than every load of the unloading
 * path: at special points of the curve. While the load decreases towards such a minimum, the
 * tension is greatest at the reversal itself: one step ends there (`until`) before the next one
 * begins. The dissipated energy changes only at jumps. */
#ifndef PO_STAIRCASE_H
#define PO_STAIRCASE_H

#include "po_stable.h"

/* All preloads from `preload` up to that of the next cycle: they have the same jumps. */
typedef struct {
  po_path_state preload; /* the fold at which loading jumps, before the jump */
  po_loss loss; /* in all jumps of loading and unloading; its energy is NAN: unbounded, because the
                   bodies separate under tension, or the curve does not begin far enough out */
  double energy_error; /* bound of the error of that energy; NAN: unknown */
} po_cycle;

/* A step: all preloads from `preload` to `until`, which have the same pull-off. */
typedef struct {
  po_path_state preload; /* the state at which the step begins: a special point of the curve */
  po_path_state until;   /* the state at which it ends, or the last state of loading on the curve */
  bool jumped; /* whether it begins at a jump of loading; otherwise it begins at a minimum of the
                  load */
  bool open;   /* whether the curve ends before the step does */
  po_path_state pull_off; /* the state with the greatest tension in unloading */
  po_path_error preload_error, pull_off_error; /* NAN: unknown */
  po_cycle *cycle;                             /* in the order of their preloads */
  size_t cycle_count;
} po_step;

typedef struct {
  po_control control;
  po_step *step; /* in the order of their preloads */
  size_t count;
  po_path_state reached; /* the last state of loading on the curve */
} po_staircase;

/* Computes the staircase. Given: a curve that begins far enough out. Under load control loading
 * starts at load 0, and the first step begins there, at approach -INFINITY. Returned: staircase, to
 * be cleared with po_staircase_clear; without steps if loading passes no minimum of the load.
 * Status: PO_NO_MEMORY. Accuracy: that of the points where a step begins at a point, otherwise that
 * of po_path_at. */
po_status po_staircase_read(const po_path *path, po_control control, po_staircase *staircase);
void po_staircase_clear(po_staircase *staircase);

/* Returned: the step with the greatest pull-off force; NULL if there is none. */
const po_step *po_staircase_greatest(const po_staircase *staircase);

#endif
