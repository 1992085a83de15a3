/* The scene in SI units: what a laboratory knows, the dimensionless groups it makes, and back. */
#ifndef PO_PHYSICAL_H
#define PO_PHYSICAL_H

#include "po_scene.h"

typedef struct {
  double modulus;      /* E* = E/(1 - nu^2) of the pair, Pa; INFINITY: rigid */
  double work;         /* w, of adhesion, J/m^2 */
  double distance;     /* epsilon, the equilibrium distance, m */
  double radius;       /* R, m */
  double amplitude;    /* A, m; 0: smooth */
  double wavelength;   /* lambda, m; ignored when smooth */
  double outer_radius; /* m; INFINITY: not cut */
} po_physical;

/* What a dimensionless number is multiplied with. */
typedef struct {
  double length;   /* epsilon, m: approach, radii */
  double force;    /* pi w R, N: load, force */
  double work;     /* w, J/m^2: work of adhesion */
  double tension;  /* w/epsilon, Pa: tension of the law */
  double traction; /* w/(mu epsilon), Pa: P = p mu epsilon/w, Eq 14; INFINITY when rigid */
} po_units;

/* The groups of Eqs 14 and 17: mu = (R w^2/(E*^2 eps^3))^(1/3) and the lengths over epsilon, formed
 * so that nothing overflows on the way. Accuracy: 8 ulp (tests/unit/test_physical.c).
 * Status: PO_BAD_INPUT, naming what is not positive and finite, or a group that no double holds. */
po_status po_physical_scene(const po_physical *physical, po_scene *scene);

/* The inverse, given what a scene does not know: E* (INFINITY for tabor 0) and epsilon. The work of
 * adhesion follows, w = E* eps (mu^3/R)^(1/2), R in epsilon; for a rigid scene, which has none of
 * its own, it is `work`. */
po_physical po_physical_of_scene(const po_scene *scene, double modulus, double distance,
                                 double work);

/* Given: what po_physical_scene made of it. */
po_units po_physical_units(const po_physical *physical, const po_scene *scene);

#endif
