/* The stopping rule: where the trace of a branch ends. The deepest minimum up to there is the
 * pull-off.
 *
 * The trace of a smooth sphere ends at a stable equilibrium under a compressive load, beyond a
 * minimum of the load.
 *
 * The trace of a wavy sphere ends at a stable equilibrium beyond a minimum of the load, where
 * - the compressive load exceeds the deepest pull so far by pi w R, as in a test that presses a
 *   little harder than it then pulls, or
 * - the minima of two successive waves since the deepest rose by more each time.
 * The load has a minimum each time the outer contact edge passes a wave. These minima follow the
 * lower edge of the Kesari-Lew envelope, which is convex. So the deepest minimum is passed once the
 * minima of several waves rose by more each time. But if the sphere is pressed hard enough, grooves
 * within the contact close, and the branch may have deeper minima, up to Guduru's for full contact:
 * minima beyond the end of the trace are not searched for. */
#ifndef PO_STOPPING_H
#define PO_STOPPING_H

#include <stdbool.h>

#include "po_branch.h"
#include "po_outcome.h"
#include "po_scene.h"

typedef struct {
  const po_scene *scene;
  bool has_minimum;
  double deepest;      /* load of the deepest minimum so far */
  double wave_minimum; /* of the load in the wave that the outer contact edge passed last */
  double wave_radius;  /* contact radius there */
  double rise;         /* of that minimum from the one of the wave before */
  int rises;           /* waves since the deepest whose minima rose by more each time */
  double margin; /* how near the trace has been to its end, relative to pi w R: what it might have
                    been pressed harder yet, or a wave's minimum might have risen more; at most 1 */
} po_stopping;

po_stopping po_stopping_begin(const po_scene *scene);

/* Takes note of a minimum of the load. Given: load, contact radius. Returned: whether it is the
 * deepest so far. */
bool po_stopping_note_minimum(po_stopping *stopping, double load, double contact_radius);

/* Takes note of a point for the margin. */
void po_stopping_note_point(po_stopping *stopping, const po_branch_point *point);

/* Why a trace may end at a point; PO_END_NONE: it may not. */
po_end_cause po_stopping_cause(const po_stopping *stopping, const po_branch_point *point);

#endif
