/* The scene: the dimensionless description of what is pressed together, and the groups of the paper
 * (Eq 6, Eq 14, Eq 17).
 *
 * All lengths of a scene, and all radii in the solver, are in units of the equilibrium distance
 * epsilon. The radial unit of the paper is Gamma = (R^2 w/E*)^(1/3), Eq 14, with Gamma/epsilon =
 * sqrt(R mu). */
#ifndef PO_SCENE_H
#define PO_SCENE_H

#include <stdbool.h>

#include "po_law.h"
#include "po_status.h"

typedef struct {
  double tabor;        /* mu = (R w^2/(E*^2 eps^3))^(1/3), text after Eq 15; 0: rigid */
  double amplitude;    /* A/eps; 0: smooth */
  double wavelength;   /* lambda/eps; ignored when smooth */
  double radius;       /* R / eps */
  double outer_radius; /* r_max/eps, where the half-space ends; INFINITY: unbounded */
  po_law law;          /* Lennard-Jones unless it is set */
} po_scene;

/* The default scene: a smooth sphere with Tabor parameter 1 and R = 100 eps on the unbounded
 * half-space. */
po_scene po_scene_default(void);

/* Checks a scene. Status: PO_BAD_INPUT, naming the first key that is not finite or out of range,
 * its value and the expected range. */
po_status po_scene_check(const po_scene *scene);

/* Returned: whether the amplitude is above 0. */
bool po_scene_is_wavy(const po_scene *scene);

/* Gamma / epsilon = sqrt(R mu), Eq 14. */
double po_scene_gamma(const po_scene *scene);

/* Returned: E* eps/w = sqrt(R/mu^3), R in eps, the form in which the Tabor parameter enters the JKR
 * theory (beta of Eq 6 and the Johnson parameter after Eq 4). */
double po_scene_stiffness(const po_scene *scene);

/* Returned: alpha = A R/lambda^2, Eq 6; 0 for a smooth sphere. */
double po_scene_alpha(const po_scene *scene);

#endif
