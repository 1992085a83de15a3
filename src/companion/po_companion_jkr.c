#include "po_companion_jkr.h"

#include "po_abel.h"
#include "po_guduru.h"
#include "po_jkr_path.h"
#include "po_jkr_profile.h"

/* Margins of the bound. EXCESS: the adhesive part of Eq 5 is multiplied by 1 + EXCESS. WAVES: the
 * contact radius of a minimum may exceed that of the same minimum of Eq 5 by this fraction of the
 * longest wavelength. Of 1,000 random scenes (tests/estimates/preloads.py) 96 have a tensile
 * minimum beyond the default preload, and the bound held for all of them with EXCESS = 0. Of 40
 * wavy scenes of other profiles and laws none has such a minimum. For smooth spheres of small Tabor
 * parameter the JKR theory is no bound (its pull-off force is 1.5 pi w R, that of a rigid sphere 2
 * pi w R); there the smallest load of a search applies (po_stopping.c). */
static const double EXCESS = 0.1, WAVES = 0.25;

static double bound(const po_scene *scene, double load) {
  if (!po_scene_is_of_paper(scene))
    return po_jkr_profile_last_minimum(scene, load, EXCESS) + WAVES * po_abel_longest_wave(scene);
  return po_guduru_last_minimum(scene, load, EXCESS) + WAVES * scene->wavelength;
}

const po_companion PO_COMPANION_JKR = {bound, po_jkr_hysteresis, po_jkr_staircases,
                                       po_beside_theories};
