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

/* The theory of Persson and Tosatti. */
typedef struct {
  /* The ratio A_true/A_app: 1 + pi^2 (A/lambda)^2, which follows from Eq 26 and Eq 27, and 1 + pi
   * (A/lambda)^2, which Eq 28 prints in error. */
  double area, area_printed;
  /* The effective work of adhesion in w: 1 - 1/(2 pi alpha_KLJ^2), Eq 30, from Eq 25 with the
   * elastic energy of Eq 29 and the area term neglected; and with this term, Eq 25 with the area of
   * Eq 27. May be negative. */
  double work, work_with_area;
} po_persson_tosatti;
po_persson_tosatti po_persson_tosatti_of(const po_scene *scene);

/* The pull-off force of Rumpf and Rabinowicz, Eq 20, relative to 2 pi w R (Bradley): 1 for a smooth
 * sphere. Figure 7 shows twice this ratio, the force in pi w R. Given: alpha >= 0; radius/eps. */
double po_rumpf_rabinowicz_ratio(double alpha, double radius);

typedef struct {
  /* The bound 8.5761 of Eq 4: the gap increases monotonically (Eq 3) if and only if lambda^2/(A R)
   * is above it. It is 4 pi^2 times the maximum of -sin(x)/x. */
  double bound;
  /* r_c = 2 pi A R/lambda, in eps, beyond which the gap increases monotonically (text after Eq 4).
   */
  double critical_radius;
} po_compactness;
po_compactness po_compactness_of(const po_scene *scene);

/* The rough asperity at the axis. */
typedef struct {
  double radius;           /* of the crest, lambda^2/(4 pi^2 A), Eq 18, eps */
  double composite_radius; /* of crest and sphere, R/(1 + 4 pi^2 alpha), Eq 19, eps */
  double force; /* the Bradley pull-off force of the composite radius, 2/(1 + 4 pi^2 alpha), pi w R
                 */
} po_crest;
po_crest po_crest_of(const po_scene *scene);

/* The law of Eq 9: the traction -(8/3) (x^3 - x^9), x = 1/(1 + gap), in w/eps, > 0 compressive.
 * Given: gap H = h/eps - 1 > -1. Accuracy: 1e-15 relative, also for gaps near 0. */
double po_lennard_jones_traction(double gap);

/* The greatest tension of the law, 16/(9 sqrt(3)) in w/eps, and its separation 3^(1/6) in eps (text
 * after Eq 9). */
typedef struct {
  double tension, distance;
} po_lennard_jones_peak;
po_lennard_jones_peak po_lennard_jones_greatest(void);

#endif
