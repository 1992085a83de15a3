#include "po_companion_jkr.h"

#include "po_guduru.h"
#include "po_guduru_path.h"

/* By how much the adhesive part of Eq 5 is taken to be greater, and, in waves, by how much a
 * contact radius may be smaller than that of the same minimum of Eq 5. Of 1,000 random scenes
 * (tests/estimates/preloads.py) 96 minima in tension lie beyond the usual preload, and the bound
 * held for all of them without the excess: it is a margin. Without waves the JKR theory bounds
 * nothing at small Tabor parameters (2 pi w R of a rigid sphere against 1.5), which the least load
 * of a search covers (po_stopping.c). */
static const double EXCESS = 0.1, WAVES = 0.25;

static double bound(const po_scene *scene, double load) {
  return po_guduru_last_minimum(scene, load, EXCESS) + WAVES * scene->wavelength;
}

const po_companion PO_COMPANION_JKR = {bound, po_guduru_hysteresis, po_guduru_staircases};
