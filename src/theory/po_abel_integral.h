/* Integrals over the Abel transform g (po_abel.h). */
#ifndef PO_ABEL_INTEGRAL_H
#define PO_ABEL_INTEGRAL_H

#include "po_abel.h"

/* The integrand at x, with the transform there. */
typedef double (*po_abel_integrand)(double x, po_abel t, const void *data);

/* The integral of f(x), or of f(x)/sqrt(to^2 - x^2), over x from `from` to `to`, by Gauss rules
 * between the radii at which g is not smooth: joints of the profile, and the axis; each wavelength
 * is divided. Given: 0 <= from <= to. Returned: NaN without memory, with more than 1e6 pieces, and
 * when the watch (po_watch.h) stops it. Accuracy: 1e-13 of the largest term
 * (tests/theory/test_tables_profiles.c). */
double po_abel_integral(const po_scene *scene, double from, double to, po_abel_integrand f,
                        const void *data);
double po_abel_integral_to_edge(const po_scene *scene, double from, double to, po_abel_integrand f,
                                const void *data);

/* The gap, eps, at a radius r > a outside a contact of radius a in equilibrium without tension
 * beyond it: (2/pi) times the integral of (g(x) - approach)/sqrt(r^2 - x^2) over x from a to r. */
double po_abel_gap(const po_scene *scene, double a, double approach, double r);

#endif
