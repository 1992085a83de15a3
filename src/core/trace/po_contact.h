/* The contact of one equilibrium: its outermost contact edge, with an error, its contact annuli,
 * and gap and traction over the radius.
 *
 * A contact edge is a radius at which the gap passes that of the greatest tension, H = 3^(1/6) - 1
 * (after Eq 9; other laws: peak_gap of po_law_numbers). Between nodes the gap is the sum of the
 * exact initial gap and the interpolated deflection: the polynomial of each panel, or linear
 * between the nodes of rings and triangles. */
#ifndef PO_CONTACT_H
#define PO_CONTACT_H

#include <stddef.h>

#include "po_branch_point.h"
#include "po_result.h"
#include "po_scene.h"
#include "po_status.h"
#include "po_surface.h"

/* The gap of one equilibrium as a function of the radius. */
typedef struct {
  const po_scene *scene;
  double approach;                    /* eps */
  double end;                         /* the gap is known up to this radius, eps */
  const struct po_solution *solution; /* on panels, whose domain ends at `end`; otherwise NULL */
  size_t n;                 /* nodes of rings or triangles; 0 on panels and for rigid scenes */
  const double *node, *gap; /* n radii ascending (eps), n gaps */
} po_contact_gap;

/* Given: a point of a branch of any scheme, or of a rigid scene. Scene and point must outlive the
 * result. */
po_contact_gap po_contact_gap_of(const po_scene *scene, const po_branch_point *point);

/* The same for a solution on panels. */
po_contact_gap po_contact_gap_on_panels(const po_scene *scene, const struct po_solution *solution);

/* The radius of the outermost contact edge, eps; 0 if there is no contact, `end` if the surface is
 * in contact at its end. */
double po_contact_radius(const po_contact_gap *gap);

/* The radius of the disc about the axis that is in contact without a groove, eps; 0 if there is no
 * contact on the axis. */
double po_contact_disc(const po_contact_gap *gap);

/* The contact radius with a bound of its error, estimated from the error of the gap.
 * If a crest is so near the threshold that the error of the gap does not decide whether it is in
 * contact, `radius` and its `error` belong to one case and `other` is the contact radius of the
 * other case; otherwise `other` is NaN. */
typedef struct {
  double radius, error, other; /* eps */
} po_contact_edge;

/* A bound of the error of the gap: `constant` plus the error estimated from the difference to a
 * solution on a finer mesh at the same radius (po_refine_error). */
typedef struct {
  const po_contact_gap *finer; /* the gap on a finer mesh; NULL: none */
  double precision; /* of Newton's method, see po_equilibrium.h; used with `finer` only */
  double constant;  /* the part that a finer mesh does not show, eps */
} po_contact_doubt;

po_contact_edge po_contact_estimate(const po_contact_gap *gap, const po_contact_doubt *doubt);

/* Fills the list of annuli. Given: annuli, zeroed or filled before. Status: PO_NO_MEMORY;
 * PO_OUT_OF_NODES if there are too many annuli. */
po_status po_contact_annuli_fill(const po_contact_gap *gap, po_contact_annuli *annuli);

/* Computes gap and traction P = mu p at the nodes of the core, for a rigid scene from the initial
 * gap at the nodes of the surface (if mu is 0, the traction is P/mu). Returned: *count points in
 * *profile, which is resized. Status: PO_NO_MEMORY. */
po_status po_contact_profile_fill(const po_scene *scene, const po_surface *surface,
                                  const po_branch_point *point, po_profile_point **profile,
                                  size_t *count);

/* The same, and the contact annuli. Returned: in the result, replacing an earlier profile. Status:
 * PO_NO_MEMORY. */
po_status po_contact_profile_take(const po_scene *scene, const po_surface *surface,
                                  const po_branch_point *point, po_result *result);

#endif
