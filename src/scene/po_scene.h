/* What is pressed: the dimensionless scene, and the groups of the paper (Eqs 6, 14, 17).
 *
 * Lengths of a scene are in units of the equilibrium distance (epsilon); inside the solver radii
 * are u = r / Gamma with Gamma = (R^2 w / E*)^(1/3), Eq 14, and Gamma / epsilon = sqrt(R mu). */
#ifndef PO_SCENE_H
#define PO_SCENE_H

#include <stdbool.h>

#include "po_status.h"

typedef struct {
  double tabor;        /* mu = (R w^2 / (E*^2 eps^3))^(1/3); 0: rigid */
  double amplitude;    /* A / eps; 0: smooth */
  double wavelength;   /* lambda / eps; ignored when smooth */
  double radius;       /* R / eps */
  double outer_radius; /* where the surface is cut, r_max / eps; INFINITY: not cut */
} po_scene;

/* A smooth sphere of Tabor parameter 1, R = 100 eps, on the unbounded half-space. */
po_scene po_scene_default(void);

/* PO_BAD_INPUT, naming the first key that is not finite or out of range, its value and what is
 * expected. */
po_status po_scene_check(const po_scene *scene);

/* Whether there is a waviness. */
bool po_scene_is_wavy(const po_scene *scene);

/* Gamma / epsilon = sqrt(R mu), Eq 14. */
double po_scene_gamma(const po_scene *scene);

/* E* eps / w = sqrt(R/mu^3), R in eps: what Eqs 4 to 8 make of the Tabor parameter. */
double po_scene_stiffness(const po_scene *scene);

/* alpha = A R / lambda^2, Eq 6; 0 when smooth. */
double po_scene_alpha(const po_scene *scene);

#endif
