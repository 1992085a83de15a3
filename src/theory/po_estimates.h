/* The paper's estimates in closed form: envelope, energy argument, rough asperity, compactness. */
#ifndef PO_ESTIMATES_H
#define PO_ESTIMATES_H

#include "po_jkr.h"

/* All return NaN outside the domain: tabor, wavelength, radius > 0 and amplitude >= 0 as each needs
 * them. Amplitude 0, the smooth sphere, is the limit: an infinite Johnson parameter, the work of
 * adhesion itself, JKR for the edges, no critical radius, an infinite radius of the crest.
 * Accuracy: 1e-14 relative (tests/unit/test_theory.c, tests/theory/test_tables_theory.c). */

/* alpha_KLJ = sqrt(2 lambda w/(pi^2 A^2 E*)), the Johnson parameter (after Eq 4). */
double po_johnson_parameter(const po_scene *scene);

/* Effective work of adhesion in units of w: (1 + 1/(sqrt(pi) alpha_KLJ))^2, Eq 24. The pull-off
 * force is 3/2 of it. */
double po_kesari_lew_work(const po_scene *scene);

/* The two edges between which Eq 5 oscillates at large contact radius (Kesari and Lew 2011): JKR
 * with sqrt(w) changed by the factor 1 + 1/(sqrt(pi) alpha_KLJ) (side < 0, lower: Eq 24 is its
 * minimum) or 1 - the same (side > 0, upper), and the mean plane of the waves A nearer. */
po_contact po_kesari_lew_edge(const po_scene *scene, double contact_radius, int side);

/* A_true/A_app from Eq 27: 1 + pi^2 (A/lambda)^2, and what Eq 28 prints: 1 + pi (A/lambda)^2. */
double po_persson_tosatti_area(const po_scene *scene);
double po_persson_tosatti_area_printed(const po_scene *scene);

/* Effective work of adhesion in units of w: 1 - 1/(2 pi alpha_KLJ^2), Eq 30; may be negative. */
double po_persson_tosatti_work(const po_scene *scene);

/* The same with the area kept: Eq 25 with the area of Eq 27. */
double po_persson_tosatti_work_with_area(const po_scene *scene);

/* Eq 20, in units of Bradley's 2 pi w R: 1 for a smooth sphere. Given: alpha >= 0; radius/eps. */
double po_rumpf_rabinowicz_ratio(double alpha, double radius);

/* The same in units of pi w R, as the axis of Figure 7: twice Eq 20. */
double po_rumpf_rabinowicz_force(double alpha, double radius);

/* 8.5761 of Eq 4: the gap rises everywhere iff lambda^2/(A R) is above; 4 pi^2 times the greatest
 * value of -sin(x)/x. */
double po_compactness_bound(void);

/* r_c = 2 pi A R/lambda, in eps, beyond which the gap always rises. */
double po_compactness_radius(const po_scene *scene);

/* Eqs 18 and 19: radius of the crest lambda^2/(4 pi^2 A), of crest and sphere together
 * R/(1 + 4 pi^2 alpha), in eps; and Bradley's pull-off force of that, 2/(1 + 4 pi^2 alpha). */
double po_crest_radius(const po_scene *scene);
double po_crest_composite_radius(const po_scene *scene);
double po_crest_force(double alpha);

/* Eq 9: the traction -(8/3) (x^3 - x^9), x = 1/(1 + gap), in w/eps, > 0 compressive. Given: gap
 * H = h/eps - 1 > -1. Accuracy: 1e-15 relative for gaps near 0, too. */
double po_lennard_jones_traction(double gap);

/* After Eq 9: the greatest tension 16/(9 sqrt(3)), in w/eps, and its distance 3^(1/6), in eps. */
double po_lennard_jones_peak_tension(void);
double po_lennard_jones_peak_distance(void);

#endif
