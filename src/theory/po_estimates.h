/* The estimates of the paper in closed form: Kesari-Lew envelope, Persson-Tosatti energy balance,
 * Rumpf-Rabinowicz asperity, compactness of the contact. */
#ifndef PO_ESTIMATES_H
#define PO_ESTIMATES_H

#include "po_jkr.h"

/* All functions return NaN outside their domain: tabor, wavelength and radius > 0 and amplitude >=
 * 0, as far as they are used. Amplitude 0, the smooth sphere, is the limit: an infinite Johnson
 * parameter, effective work of adhesion 1, both edges of the envelope equal to JKR, critical radius
 * 0, an infinite crest radius. Accuracy: 1e-14 relative (tests/unit/test_theory.c,
 * tests/theory/test_tables_theory.c). */

/* The Johnson parameter alpha_KLJ = sqrt(2 lambda w/(pi^2 A^2 E*)) (text after Eq 4). */
double po_johnson_parameter(const po_scene *scene);

/* The effective work of adhesion of Kesari and Lew in units of w: (1 + 1/(sqrt(pi) alpha_KLJ))^2,
 * Eq 24. The pull-off force is 3/2 of it, in pi w R. */
double po_kesari_lew_work(const po_scene *scene);

/* The two edges of the envelope between which Eq 5 oscillates at large contact radius (Kesari and
 * Lew 2011): the JKR equilibrium with sqrt(w) multiplied by 1 + 1/(sqrt(pi) alpha_KLJ) (side < 0,
 * the lower edge, whose minimum is Eq 24) or by 1 - 1/(sqrt(pi) alpha_KLJ) (side > 0, the upper
 * edge), and the approach increased by A, the mean of the waviness. Given: contact_radius in
 * eps. */
po_contact po_kesari_lew_edge(const po_scene *scene, double contact_radius, int side);

/* The ratio A_true/A_app: 1 + pi^2 (A/lambda)^2, which follows from Eq 26 and Eq 27, and 1 + pi
 * (A/lambda)^2, which Eq 28 prints in error. */
double po_persson_tosatti_area(const po_scene *scene);
double po_persson_tosatti_area_printed(const po_scene *scene);

/* The effective work of adhesion of Persson and Tosatti in units of w: 1 - 1/(2 pi alpha_KLJ^2),
 * Eq 30, from Eq 25 with the elastic energy of Eq 29 and the area term neglected; may be
 * negative. */
double po_persson_tosatti_work(const po_scene *scene);

/* As po_persson_tosatti_work with the area term: Eq 25 with the area of Eq 27 and the elastic
 * energy of Eq 29. */
double po_persson_tosatti_work_with_area(const po_scene *scene);

/* The pull-off force of Rumpf and Rabinowicz, Eq 20, relative to 2 pi w R (Bradley): 1 for a smooth
 * sphere. Given: alpha >= 0; radius/eps. */
double po_rumpf_rabinowicz_ratio(double alpha, double radius);

/* The pull-off force of Rumpf and Rabinowicz in units of pi w R, as on the axis of Figure 7: twice
 * Eq 20. */
double po_rumpf_rabinowicz_force(double alpha, double radius);

/* The bound 8.5761 of Eq 4: the gap increases monotonically (Eq 3) if and only if lambda^2/(A R) is
 * above it. It is 4 pi^2 times the maximum of -sin(x)/x. */
double po_compactness_bound(void);

/* The critical radius r_c = 2 pi A R/lambda, in eps, beyond which the gap increases monotonically
 * (text after Eq 4). */
double po_compactness_radius(const po_scene *scene);

/* The rough asperity at the axis: the radius of the crest lambda^2/(4 pi^2 A), Eq 18; the composite
 * radius of crest and sphere R/(1 + 4 pi^2 alpha), Eq 19, both in eps; and the Bradley pull-off
 * force of the composite radius, 2/(1 + 4 pi^2 alpha) in pi w R. */
double po_crest_radius(const po_scene *scene);
double po_crest_composite_radius(const po_scene *scene);
double po_crest_force(double alpha);

/* The law of Eq 9: the traction -(8/3) (x^3 - x^9), x = 1/(1 + gap), in w/eps, > 0 compressive.
 * Given: gap H = h/eps - 1 > -1. Accuracy: 1e-15 relative, also for gaps near 0. */
double po_lennard_jones_traction(double gap);

/* The greatest tension of the law, 16/(9 sqrt(3)) in w/eps, and its separation 3^(1/6) in eps (text
 * after Eq 9). */
double po_lennard_jones_peak_tension(void);
double po_lennard_jones_peak_distance(void);

#endif
