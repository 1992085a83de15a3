#include "po_physical.h"

#include <float.h>
#include <math.h>

#include "po_elementary.h"

/* Refuses a group that has underflowed to a subnormal number or 0, or has overflowed. */
static po_status check_group(const char *name, double value) {
  return isfinite(value) && value >= DBL_MIN
             ? PO_OK
             : po_fail(PO_BAD_INPUT,
                       "%s is %g: expected a number within the range of doubles; the given sizes "
                       "differ by too many orders of magnitude",
                       name, value);
}

po_status po_physical_scene(const po_physical *physical, po_scene *scene) {
  const po_physical *p = physical;
  if (!isfinite(p->amplitude)) /* a multiple of the wavelength may overflow */
    return po_fail(PO_BAD_INPUT, "the amplitude is %g: expected a finite number >= 0",
                   p->amplitude);
  const bool rigid = isinf(p->modulus), wavy = p->amplitude > 0.0;
  const double length = po_cbrt(p->distance),
               root = po_cbrt(p->work) / length / po_cbrt(p->modulus);
  const po_scene s = {.tabor = rigid ? 0.0 : po_cbrt(p->radius) / length * root * root,
                      .amplitude = p->amplitude / p->distance,
                      .wavelength = wavy ? p->wavelength / p->distance : 0.0,
                      .radius = p->radius / p->distance,
                      .outer_radius = p->outer_radius / p->distance,
                      .law = scene->law,
                      .profile = scene->profile};
  po_status bad = rigid ? PO_OK : check_group("the Tabor parameter", s.tabor);
  if (!bad)
    bad = check_group("the radius over the equilibrium distance", s.radius);
  if (!bad && wavy)
    bad = check_group("the amplitude over the equilibrium distance", s.amplitude);
  if (!bad && wavy)
    bad = check_group("the wavelength over the equilibrium distance", s.wavelength);
  if (!bad && isfinite(p->outer_radius))
    bad = check_group("the outer radius over the equilibrium distance", s.outer_radius);
  if (!bad)
    *scene = s;
  return bad;
}

po_units po_physical_units(const po_physical *physical, const po_scene *scene) {
  const double tension = physical->work / physical->distance;
  return (po_units){.length = physical->distance,
                    .force = M_PI * physical->work * physical->radius,
                    .work = physical->work,
                    .tension = tension,
                    .traction = tension / scene->tabor};
}
