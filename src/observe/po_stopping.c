#include "po_stopping.h"

#include <math.h>

/* The trace of a wavy sphere ends at a load that exceeds the largest tensile load so far by this,
 * in pi w R. */
static const double PRELOAD = 1.0;

/* Successive waves whose minima rise by more each time. */
enum { ENOUGH_RISES = 2 };

/* The least distance of the contact radii at the minima of two successive waves, in wavelengths (it
 * is about 1, and a little less at first). A minimum nearer than this is a ripple. */
static const double NEXT_WAVE = 0.8;

po_stopping po_stopping_begin(const po_scene *scene) {
  return (po_stopping){.scene = scene, .margin = 1.0};
}

/* Follows the minima from wave to wave. If one more rise would have ended the trace, the margin is
 * the amount by which the minimum of the next wave was too low for that. */
static void note_wave(po_stopping *s, double load, double contact_radius) {
  const double apart = contact_radius - s->wave_radius, rise = load - s->wave_minimum;
  const bool next = apart > NEXT_WAVE * s->scene->wavelength;
  if (next && s->rises == ENOUGH_RISES - 1 && rise < s->rise)
    s->margin = fmin(s->margin, (s->rise - rise) / PRELOAD);
  if (load <= s->deepest) {
    s->rises = 0;
    s->rise = 0.0;
  } else if (next) {
    s->rises = rise > s->rise ? s->rises + 1 : 0;
    s->rise = rise;
  } else if (load >= s->wave_minimum) {
    return; /* a ripple, less deep than the minimum of its wave */
  }
  s->wave_minimum = load;
  s->wave_radius = contact_radius;
}

bool po_stopping_note_minimum(po_stopping *s, double load, double contact_radius) {
  const bool deepest = !s->has_minimum || load < s->deepest;
  s->has_minimum = true;
  if (deepest)
    s->deepest = load;
  note_wave(s, load, contact_radius);
  return deepest;
}

/* The trace of a slightly different scene might have ended at a point where this one just goes on.
 */
void po_stopping_note_point(po_stopping *s, const po_branch_point *p) {
  if (!s->has_minimum || !po_scene_is_wavy(s->scene))
    return;
  if (s->rises >= ENOUGH_RISES) /* the trace ends at the next stable equilibrium */
    s->margin = 0.0;
  else if (p->unstable_modes == 0)
    s->margin = fmin(s->margin, (PRELOAD + fabs(s->deepest) - p->load) / PRELOAD);
}

po_end_cause po_stopping_cause(const po_stopping *s, const po_branch_point *p) {
  if (!s->has_minimum || p->unstable_modes > 0)
    return PO_END_NONE;
  if (!po_scene_is_wavy(s->scene))
    return p->load > 0.0 ? PO_END_COMPRESSED : PO_END_NONE;
  if (s->rises >= ENOUGH_RISES)
    return PO_END_WAVES;
  return p->load > PRELOAD + fabs(s->deepest) ? PO_END_PRELOAD : PO_END_NONE;
}
