/* The undeformed gap of Eq 2, in units of epsilon. */
#ifndef PO_PROFILE_H
#define PO_PROFILE_H

#include "po_scene.h"

/* f(r) = r^2/(2R) + A (1 - cos(2 pi r / lambda)), Eq 2. Given: r in eps. Returned: eps. */
double po_profile(const po_scene *scene, double r);

/* df/dr. */
double po_profile_slope(const po_scene *scene, double r);

/* f(r) with the waviness replaced by its mean over one wavelength: r^2/(2R) + A. */
double po_profile_mean(const po_scene *scene, double r);

/* The first radius >= r (eps) at which averaging over whole waves may begin: a multiple of half the
 * wavelength, where the first harmonic's sine vanishes; r itself when smooth. */
double po_averaging_phase(const po_scene *scene, double r);

/* The radius, a whole number of waves beyond `from`, from which on the waves may be replaced by
 * their mean with a loss of load below 1e-9; `from` itself when smooth. By parts the loss is
 * (lambda/2 pi)^2 times the slope, where averaging begins, of the oscillating part of the integrand
 * of Eq 17; a bound for small and one for large amplitude are taken. */
double po_averaging_radius(const po_scene *scene, double from);

#endif
