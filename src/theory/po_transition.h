/* The pull-off force of a smooth sphere between the limits of Bradley and JKR: formulas that were
 * fitted to the theory of Maugis, or that interpolate between the limits. Forces are in pi w R.
 * Accuracy: 4 ulp of the formula (tests/theory/test_tables_theory.c); the formulas themselves are
 * good to 1.6 % (Carpick), 1.3 % (Pietrement) and 11 % (Schwarz) of Maugis-Dugdale. */
#ifndef PO_TRANSITION_H
#define PO_TRANSITION_H

#include "po_scene.h"

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
