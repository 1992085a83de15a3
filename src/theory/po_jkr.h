/* The theories of JKR and DMT of the smooth sphere: short-range adhesion (Johnson, Kendall and
 * Roberts 1971), and attraction that does not deform (Derjaguin, Muller and Toporov 1975). */
#ifndef PO_JKR_H
#define PO_JKR_H

#include "po_scene.h"

/* One equilibrium of an adhesive contact. */
typedef struct {
  double load;           /* W/(pi w R), > 0 compressive */
  double approach;       /* Delta/eps, > 0 when pressed together */
  double contact_radius; /* a/eps */
} po_contact;

/* The equilibrium of Eq 7 and Eq 8 at a contact radius. Given: tabor > 0 and radius of the scene;
 * contact_radius/eps >= 0. Returned: NaN in all members outside the domain. Accuracy: 4 ulp of the
 * larger term (tests/unit/test_theory.c). */
po_contact po_jkr_at(const po_scene *scene, double contact_radius);

/* The same of DMT: the contact of Hertz under the load, and 2 pi w R of attraction. */
po_contact po_dmt_at(const po_scene *scene, double contact_radius);

/* The pull-off under load control: the minimum of the load, -3/2, at approach -0.77341693157
 * tabor. */
po_contact po_jkr_pull_off(const po_scene *scene);

/* The pull-off under displacement control: the minimum of the approach, -1.60877204783 tabor, where
 * the load is -5/6. */
po_contact po_jkr_last(const po_scene *scene);

#endif
