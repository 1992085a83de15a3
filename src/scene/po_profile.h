/* The initial gap of Eq 2 (the profile), in units of epsilon. */
#ifndef PO_PROFILE_H
#define PO_PROFILE_H

#include "po_scene.h"

/* The initial gap f(r) = r^2/(2R) + A (1 - cos(2 pi r/lambda)), Eq 2; its second term is the
 * waviness, -y(r) of Eq 1. Given: r in eps. Returned: f in eps. */
double po_profile(const po_scene *scene, double r);

/* Returned: df/dr of Eq 2; it is > 0 everywhere when Eq 3 holds. Given: r in eps. */
double po_profile_slope(const po_scene *scene, double r);

/* The initial gap with the waviness replaced by its mean over one wavelength: r^2/(2R) + A, in
 * eps. */
double po_profile_mean(const po_scene *scene, double r);

/* Returned: the smallest radius >= r (eps) at which averaging over whole wavelengths may begin: a
 * multiple of half the wavelength, where the sine of the first harmonic vanishes; r itself for a
 * smooth sphere. */
double po_averaging_phase(const po_scene *scene, double r);

/* Returned: the radius (eps), a whole number of wavelengths beyond `from`, beyond which the
 * waviness may be replaced by its mean with an error of the load below 1e-9; `from` itself for a
 * smooth sphere. Integration by parts gives the error as (lambda/2 pi)^2 times the slope, at that
 * radius, of the oscillating part of the integrand of Eq 17. The function uses the smaller of a
 * bound for small and a bound for large amplitudes. */
double po_averaging_radius(const po_scene *scene, double from);

#endif
