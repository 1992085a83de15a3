/* The initial gap of a scene, in units of epsilon: that of its profile and the sum of its waves.
 * For the paper's scenes it is f(r) = r^2/(2R) + A (1 - cos(2 pi r/lambda)), Eq 2; the second term
 * is the waviness, -y(r) of Eq 1. */
#ifndef PO_INITIAL_GAP_H
#define PO_INITIAL_GAP_H

#include "po_scene.h"

/* f, and df/dr; for the paper's scenes df/dr > 0 everywhere when Eq 3 holds. Given: r in eps. */
double po_initial_gap(const po_scene *scene, double r);
double po_initial_gap_slope(const po_scene *scene, double r);

/* f in twice the precision. */
po_dd po_initial_gap_exact(const po_scene *scene, double r);

/* The initial gap with each wave replaced by its mean: that of the profile, plus the sum of the
 * amplitudes. */
double po_initial_gap_mean(const po_scene *scene, double r);

/* The amplitude of one wave with the mean square of all waves, by which the law is averaged: exact
 * for one wave. With several the error of the averaged traction goes as the fourth power of
 * amplitude over gap, which is small where waves are averaged. */
double po_initial_gap_amplitude(const po_scene *scene);

/* Lower bound of the initial gap at r and beyond: the waves only increase it. */
double po_initial_gap_beyond(const po_scene *scene, double r);

/* The largest radius at which the gap without waves is at most `gap`; 0 for gap <= 0. */
double po_initial_gap_radius(const po_scene *scene, double gap);

/* A length in which the initial gap has at most two extrema: the shortest wavelength, or the
 * smallest interval of a table; INFINITY if the gap rises everywhere. */
double po_initial_gap_detail(const po_scene *scene);

#endif
