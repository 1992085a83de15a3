/* The pull-off of a viscoelastic body whose contact edge needs the work of adhesion of Persson and
 * Brener (Phys. Rev. E 71, 036123, 2005), and JKR theory otherwise.
 *
 * An edge that recedes at the speed v needs Gamma > w, because the half-space near it has no time
 * to relax. With nu = v tau_0/l, J(0) = k and the creep of po_creep.h,
 *
 *   Gamma/w = 1/[1 - sum_m c_m S(x/tau_m)],   S(y) = sqrt(1 + y^2) - y,   c_m = (1 - k) w_m,
 *   x = (Gamma/w)/(2 pi nu),
 *
 * which goes from 1 at rest to 1/k. The sum is the integral over the frequencies up to that of the
 * edge, for each retardation time in closed form. l is the length in which the stress of the
 * relaxed crack reaches the greatest tension of the law; the theory gives it up to a factor, which
 * po_persson_brener.c states.
 *
 * The body far from the edge is relaxed, with Gamma in place of w: at the contact radius a
 *
 *   D = g(a) - sqrt(2 pi a c Gamma/w),   W = W_1(a) + [1 - sqrt(Gamma/w)] 2 a sqrt(2 pi a c)/(pi c
 * R)
 *
 * (po_jkr_profile.h; W_1 its load with Gamma = w). The base moves back at the speed V, so that
 * dD/da = V/v(Gamma), from the relaxed contact at the preload. At the speed INFINITY Gamma is w/k
 * from the begin on: this is also the limit of short range of the whole body unloaded at once,
 * whose profile has flattened in the contact, and whose modulus is the glassy one. */
#ifndef PO_PERSSON_BRENER_H
#define PO_PERSSON_BRENER_H

#include <math.h>

#include "po_creep.h"
#include "po_loops.h"
#include "po_scene.h"

/* Gamma/w and the speed of the edge nu at a given x > 0. */
typedef struct {
  double work, speed;
} po_edge_law;
po_edge_law po_persson_brener_at(const po_creep_terms *terms, double x);

/* The state of greatest tension. */
typedef struct {
  double force, approach, contact_radius; /* pi w R, eps, eps */
  double work;                            /* Gamma/w */
  double edge_speed;                      /* of the contact edge, eps/tau_0 */
  double preload_radius;                  /* of the relaxed contact at the preload, eps */
} po_rate_theory;
#define PO_NO_RATE_THEORY                                                                          \
  { NAN, NAN, NAN, NAN, NAN, NAN }

/* Given: a scene with tabor > 0; the terms of the material; the speed of the base, eps/tau_0, >= 0
 * or INFINITY; the preload. Returned: *found. Status: PO_BAD_INPUT, PO_NOT_FOUND, PO_NO_MEMORY as
 * po_jkr_after_preload. Accuracy: 4e-4 of the force; 2e-3 where the tension is greatest within the
 * first steps, each 1/2000 of the contact radius (tests/cli/test_theory_rate.py). Contact radius
 * and approach are those of a step. */
po_status po_persson_brener_pull_off(const po_scene *scene, const po_creep_terms *terms,
                                     double speed, po_preload preload, po_rate_theory *found);

/* The same of a material that is not PO_CREEP_NONE; and at the speeds 0 and INFINITY, where the
 * work of adhesion is constant, at the root of the derivative of the load. Accuracy of the latter:
 * 1e-12 of the force where the tension has a smooth maximum, or is greatest at the preload. */
po_status po_persson_brener_of(const po_scene *scene, const po_creep *creep, double speed,
                               po_preload preload, po_rate_theory *found);
po_status po_persson_brener_limit(const po_scene *scene, const po_creep *creep, double speed,
                                  po_preload preload, po_rate_theory *found);

#endif
