/* The Abel transform of the initial gap, g(x) = x times the integral of f'(r)/sqrt(x^2 - r^2) over
 * r from 0 to x (Sneddon 1965). A rigid profile f in frictionless contact with an elastic
 * half-space on the disc r < a has the approach g(a) and the load 2 E* [a g(a) - integral of g from
 * 0 to a]. */
#ifndef PO_ABEL_H
#define PO_ABEL_H

#include "po_scene.h"

/* Lengths in eps. */
typedef struct {
  double g;     /* eps */
  double rate;  /* dg/dx; at a kink of the profile the limit from the left */
  double press; /* x g(x) - integral of g from 0 to x = integral of x dg, eps^2 */
} po_abel;

/* The transform at a radius x >= 0 (eps), of the profile alone and with its waves. Source: for the
 * sphere, powers, the cone, flat profiles and waves the integral in closed form (elementary
 * functions, Struve functions); for a table the integral over each cubic of its spline by Gauss
 * rules that are exact to rounding (of more than 256 rows: of those that po_profile_thin.h keeps,
 * whose transform is off by 1.6e-7), and beyond its end the incomplete Beta function of its power.
 * Returned: NaN in all members for a profile whose transform is not known here. Accuracy: 1e-14 of
 * the largest term (tests/theory/test_tables_profiles.c). */
po_abel po_abel_of_profile(const po_scene *scene, double x);
po_abel po_abel_at(const po_scene *scene, double x);

/* By how much dg/dx of a table without waves falls at most from its value at `low` up to any radius
 * in [low, high]; INFINITY for other profiles. */
double po_abel_greatest_drop(const po_scene *scene, double low, double high);

/* Bounds. `fall`: the transform of the profile without waves falls nowhere faster than this; 0 for
 * profiles that are convex. `po_abel_greatest_rate`: no smaller than dg/dx anywhere up to x, waves
 * included; it grows with x. `po_abel_waves_least`: g and press no greater than the part of the
 * waves in them anywhere on [low, high]; its rate is 0. */
double po_abel_fall(const po_scene *scene);
double po_abel_greatest_rate(const po_scene *scene, double x);
po_abel po_abel_waves_least(const po_scene *scene, double low, double high);

/* A length in which dg/dx is close to a parabola: a part of the shortest wavelength, of x, and for
 * a table of the interval between its rows. */
double po_abel_detail(const po_scene *scene, double x);

/* The longest wavelength; 0 without waves. */
double po_abel_longest_wave(const po_scene *scene);

/* The table of the profile, on fewer knots if it has them; NULL: it is none. */
const struct po_profile_table *po_abel_table(const po_scene *scene);

/* The angle arccos(r/x), 0 < r <= x. */
double po_abel_angle(double r, double x);

/* -- Integrals over the transform (po_abel_integral.c) -- */

/* The integrand at x, with the transform there. */
typedef double (*po_abel_integrand)(double x, po_abel t, const void *data);

/* The integral of f(x), or to_edge that of f(x)/sqrt(to^2 - x^2), over x from `from` to `to`, by
 * Gauss rules between the radii at which g is not smooth: joints of the profile, and the axis; each
 * wavelength is divided. Given: 0 <= from <= to. Returned: NaN without memory, with more than 1e6
 * pieces, and when the deadline (po_deadline.h) has passed. Accuracy: 1e-13 of the largest term
 * (tests/theory/test_tables_profiles.c). */
double po_abel_integral(const po_scene *scene, double from, double to, bool to_edge,
                        po_abel_integrand f, const void *data);

/* The integral of (g(x) - approach)/sqrt(c^2 - x^2) over x from a to c. Of a table with joints
 * between a and c it takes as many terms as there are rows, not their square. Accuracy and NaN as
 * above (tests/theory/test_tables_profiles.c). */
double po_abel_opening(const po_scene *scene, double a, double approach, double c);

/* The gap, eps, at a radius r > a outside a contact of radius a in equilibrium without tension
 * beyond it: (2/pi) times the integral of (g(x) - approach)/sqrt(r^2 - x^2) over x from a to r. */
double po_abel_gap(const po_scene *scene, double a, double approach, double r);

#endif
