/* The smooth sphere in the limit of short-range adhesion (Johnson, Kendall, Roberts). */
#ifndef PO_JKR_H
#define PO_JKR_H

#include "po_scene.h"

/* One equilibrium of an adhesive contact. */
typedef struct {
  double load;           /* W / (pi w R), > 0 compressive */
  double approach;       /* Delta / eps, > 0 pressed together */
  double contact_radius; /* a / eps */
} po_contact;

/* Eqs 7 and 8. Given: tabor > 0 and radius of the scene; contact_radius / eps >= 0. Returned: NaN
 * in all members outside the domain. Accuracy: 4 ulp of the larger term (tests/unit/test_theory.c).
 */
po_contact po_jkr_at(const po_scene *scene, double contact_radius);

/* Least load: -3/2 at approach -0.77341693157 tabor; where a test under load control pulls off. */
po_contact po_jkr_pull_off(const po_scene *scene);

/* Least approach: load -5/6 at -1.60877204783 tabor; where one under displacement control does. */
po_contact po_jkr_last(const po_scene *scene);

#endif
