/* Sizes of a scene before it is solved, by the theories of the two limits: where a trace begins,
 * how large the meshed surface is, which load is a usual one. They are good to some percent, and no
 * result depends on them. */
#ifndef PO_SCALES_H
#define PO_SCALES_H

#include "po_scene.h"

/* For a smooth sphere: load 1, load_factor 1, stretch mu, contact_gap 2.93 mu. With waves on it
 * load_factor is that of Eq 24 alone, at any mu. */
typedef struct {
  double load;         /* half the pull-off force of the rigid bodies or two thirds of that of JKR,
                          whichever is less, without waves; pi w R */
  double load_factor;  /* the greatest usual load over this one: of JKR where the elongation exceeds
                          eps, otherwise of the rigid bodies, times what the waves may make of it by
                          Eq 24 */
  double stretch;      /* the elastic elongation at pull-off without waves, as the Tabor parameter
                          of a sphere whose initial gap at the contact radius of JKR at zero load is
                          the same, eps */
  double wavy_stretch; /* the same with the work of adhesion of Eq 24 */
  double contact_gap;  /* the initial gap at that contact radius, without the waves but with this
                          work of adhesion, eps */
} po_scales;

po_scales po_scene_scales(const po_scene *scene);

/* Returned: the smallest radius >= r (eps) at which averaging over whole wavelengths may begin: a
 * multiple of half the wavelength of the wave of greatest amplitude times wavelength, where the
 * sine of its first harmonic vanishes; r itself without waves. */
double po_averaging_phase(const po_scene *scene, double r);

/* Returned: the radius (eps), a whole number of wavelengths beyond `from`, beyond which the waves
 * may be replaced by their mean with an error of the load below 1e-9; `from` itself without waves.
 * Integration by parts gives the error as (lambda/2 pi)^2 times the slope, at that radius, of the
 * oscillating part of the integrand of Eq 17, for a wave whose phase is that of
 * po_averaging_phase; for other waves it is lambda/2 pi times the oscillating part. For one wave on
 * the sphere the function uses the smaller of a bound for small and a bound for large amplitudes.
 */
double po_averaging_radius(const po_scene *scene, double from);

#endif
