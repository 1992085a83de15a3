/* Conversion of a scene between SI units and the dimensionless groups of the paper. */
#ifndef PO_PHYSICAL_H
#define PO_PHYSICAL_H

#include "po_scene.h"

typedef struct {
  double modulus;      /* E* = E/(1 - nu^2), Pa, of both bodies together; INFINITY: rigid */
  double work;         /* w, work of adhesion, J/m^2 */
  double distance;     /* epsilon, the equilibrium distance, m */
  double radius;       /* R, m */
  double amplitude;    /* A, m; 0: smooth */
  double wavelength;   /* lambda, m; ignored when smooth */
  double outer_radius; /* r_max, m; INFINITY: an unbounded half-space */
} po_physical;

/* The SI units of dimensionless numbers: a number times its unit is the value in SI. */
typedef struct {
  double length;   /* epsilon, m: unit of approach and radii */
  double force;    /* pi w R, N: unit of load and force */
  double work;     /* w, J/m^2: unit of the work of adhesion */
  double tension;  /* w/epsilon, Pa: unit of the tension of the law */
  double traction; /* w/(mu epsilon), Pa: unit of P = p mu epsilon/w, Eq 14; INFINITY when rigid */
  double usual_length, usual_force; /* of the size of the approaches, m, and loads, N, of the scene,
                                       for the prefix of units; 0: those of a sphere */
} po_units;

/* Computes the dimensionless scene but for its law and its profile, which stay: mu = (R w^2/(E*^2
 * eps^3))^(1/3) (text after Eq 15) and the lengths in units of epsilon. Given: numbers that the
 * keys accept: > 0, the amplitude >= 0, or infinite if the product of a ratio and the wavelength
 * was. Intermediate results cannot overflow. Status: PO_BAD_INPUT for such an amplitude, or naming
 * the group that is outside the range of doubles. Accuracy:
 * 8 ulp (tests/unit/test_physical.c). */
po_status po_physical_scene(const po_physical *physical, po_scene *scene);

/* The units of a scene. Given: a physical scene and its dimensionless form from
 * po_physical_scene. */
po_units po_physical_units(const po_physical *physical, const po_scene *scene);

#endif
