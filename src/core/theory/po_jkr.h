/* The theories of JKR and DMT of the smooth sphere: short-range adhesion (Johnson, Kendall and
 * Roberts 1971), and attraction that does not deform (Derjaguin, Muller and Toporov 1975). And the
 * pull-off force of that sphere between these limits. */
#ifndef PO_JKR_H
#define PO_JKR_H

#include "po_scene.h"

/* One equilibrium of an adhesive contact. */
typedef struct {
  double load;           /* W/(pi w R), > 0 compressive */
  double approach;       /* Delta/eps, > 0 when pressed together */
  double contact_radius; /* a/eps */
} po_contact;

/* What is held fixed in a test: the load or the approach. */
typedef enum { PO_FIXED_LOAD, PO_FIXED_APPROACH } po_fixed;

/* The equilibrium of Eq 7 and Eq 8 at a contact radius. Given: tabor > 0 and radius of the scene;
 * contact_radius/eps >= 0. Returned: NaN in all members outside the domain. Accuracy: 4 ulp of the
 * larger term (tests/unit/test_theory.c). */
po_contact po_jkr_at(const po_scene *scene, double contact_radius);

/* The same of DMT: the contact of Hertz under the load, and 2 pi w R of attraction. */
po_contact po_dmt_at(const po_scene *scene, double contact_radius);

/* The contact radius, eps, of DMT at a load >= -2, or at an approach >= 0. */
double po_dmt_radius(const po_scene *scene, po_fixed fixed, double value);

/* The pull-off under load control: the minimum of the load, -3/2, at approach -0.77341693157
 * tabor. */
po_contact po_jkr_pull_off(const po_scene *scene);

/* The pull-off under displacement control: the minimum of the approach, -1.60877204783 tabor, where
 * the load is -5/6. */
po_contact po_jkr_last(const po_scene *scene);

/* -- Between the limits: formulas that were fitted to the theory of Maugis, or that interpolate.
 * Forces are in pi w R. Accuracy: 4 ulp of the formula (tests/theory/test_tables_theory.c); the
 * formulas themselves are good to 1.6 % (Carpick), 1.3 % (Pietrement) and 11 % (Schwarz) of
 * Maugis-Dugdale. -- */

/* The parameter of Maugis, lambda = q (9/(2 pi))^(1/3) mu with the tension q, w/eps: 1.1570 mu for
 * the greatest tension of Lennard-Jones. */
double po_maugis_parameter(double tabor, double tension);

/* The transition parameter alpha of Carpick, Ogletree and Salmeron 1999, from their fit lambda =
 * -0.924 ln(1 - 1.02 alpha): 0 for lambda 0; 1/1.02, not 1, for infinite lambda. */
double po_transition_alpha(double lambda);

/* Carpick, Ogletree and Salmeron 1999: 7/4 - (4.04 lambda^1.4 - 1)/(4 (4.04 lambda^1.4 + 1)), from
 * 2 to 3/2. */
double po_carpick_force(double lambda);

/* Pietrement and Troyon 2000: 0.267 alpha^2 - 0.767 alpha + 2, from 2 to 3/2 at alpha = 1; 1.5047
 * for infinite lambda. */
double po_pietrement_force(double lambda);

/* Schwarz 2003: a part t of the work of adhesion acts at short range, as in JKR, the rest at long
 * range, as in DMT: force 2 - t/2, and the contact radius has the form of Carpick with alpha^2 = 3
 * t/(4 - t). So the force is 6/(3 + alpha^2), from 2 to 3/2 at alpha = 1. Schwarz relates t to no
 * Tabor parameter; here alpha is that of po_transition_alpha. */
double po_schwarz_force(double lambda);

#endif
