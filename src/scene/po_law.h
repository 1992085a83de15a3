/* The traction-separation law: Lennard-Jones between half-spaces, Eq 9, in the variables of Eq 14
 * and Eq 16. */
#ifndef PO_LAW_H
#define PO_LAW_H

typedef struct {
  double traction; /* P/mu = -(8/3) [x^3 - x^9], x = 1/(1 + H): Eq 16 */
  double slope;    /* (dP/dH)/mu = 8 [x^4 - 3 x^10] */
} po_law;

/* The law at a gap, Eq 16. Given: gap H = h/eps - 1 > -1. */
po_law po_law_at(double gap);

/* The law averaged over one period of a waviness about the mean gap: the mean over phi of the law
 * at H - A cos(phi). Given: H > -1; amplitude A/eps < 1 + H. Source: the mean of (a - A cos phi)^-n
 * is (a^2 - A^2)^(-n/2) P_{n-1}(a/sqrt(a^2 - A^2)), Laplace's integral for Legendre polynomials.
 * Accuracy: 1e-13 relative (tests/unit/test_scene.c). */
po_law po_law_averaged(double gap, double amplitude);

/* The interaction energy per area, phi/w = -(4/3) x^2 + (1/3) x^8, x = 1/(1 + H), from phi' =
 * -sigma and Eq 9. Given: gap H > -1. */
double po_law_energy(double gap);

/* The interaction energy averaged over one period of a waviness, as po_law_averaged. Accuracy:
 * 1e-13 relative (tests/unit/test_scene.c). */
double po_law_energy_averaged(double gap, double amplitude);

/* The gap H at which the tension is greatest: h = 3^(1/6) eps (text after Eq 9), H = 3^(1/6) -
 * 1. */
extern const double PO_LAW_PEAK_GAP;

#endif
