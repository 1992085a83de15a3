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

#include "po_path.h"

/* Computes the staircases at given approach, at given load, and through a spring of stiffness
 * `spring` unless that is NAN or infinite. Given: a curve that begins far enough out. Under load
 * control loading starts at load 0, and the first step begins there, at approach -INFINITY. A
 * spring that is unstable where the curve begins jumps from there. Returned: staircases, to be
 * cleared with po_staircases_clear; without steps where loading passes no minimum of the load.
 * Status: PO_NO_MEMORY. Accuracy: that of the points where a step begins at a point, otherwise that
 * of po_path_at. */
po_status po_staircases_read(const po_path *path, po_control spring, po_staircases *staircases);

/* Returned: the step with the greatest pull-off force; NULL if there is none. */
const po_step *po_staircase_greatest(const po_staircase *staircase);

#endif
