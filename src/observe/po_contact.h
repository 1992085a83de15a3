/* Where one equilibrium is in contact: its outermost contact edge, with an error, and its contact
 * annuli.
 *
 * A contact edge is a radius at which the gap passes that of the greatest tension, H = 3^(1/6) - 1
 * (after Eq 9). Between nodes the gap is the undeformed one, exactly, plus the deflection: the
 * polynomial of each panel, or linear between the nodes of rings and triangles. */
#ifndef PO_CONTACT_H
#define PO_CONTACT_H

#include <stddef.h>

#include "po_branch_point.h"
#include "po_scene.h"
#include "po_status.h"

/* The gap of one equilibrium as a function of the radius. */
typedef struct {
  const po_scene *scene;
  double approach;                    /* eps */
  double end;                         /* the gap is known up to this radius, eps */
  const struct po_solution *solution; /* panels, whose domain ends at `end`; else NULL */
  size_t n;                           /* nodes of rings or triangles; 0 on panels, and when rigid */
  const double *node, *gap;           /* n radii ascending (eps), n gaps */
} po_contact_gap;

/* Given: a point of a branch of any scheme, or of rigid surfaces; the radius of the domain of the
 * panels, for panels only. Scene and point must outlive the result. */
po_contact_gap po_contact_gap_of(const po_scene *scene, double domain,
                                 const po_branch_point *point);

/* The same for a state on panels. */
po_contact_gap po_contact_gap_on_panels(const po_scene *scene, double domain,
                                        const struct po_solution *solution);

/* The outermost contact edge, eps: 0 when the bodies are farther apart everywhere, `end` when they
 * are in contact as far as the surface goes. */
double po_contact_radius(const po_contact_gap *gap);

/* The radius of the disc about the axis that is in contact without a groove, eps: 0 when the bodies
 * are apart on the axis. */
double po_contact_disc(const po_contact_gap *gap);

/* The contact radius with a bound of its error, estimated from the error of the gap.
 * If a crest is so near the threshold that the error of the gap does not decide whether it is in
 * contact, `radius` and its `error` belong to one case and `other` is the contact radius of the
 * other case; otherwise `other` is NaN. */
typedef struct {
  double radius, error, other; /* eps */
} po_contact_edge;

/* A bound of the error of the gap: `constant`, plus what the difference from a finer mesh at the
 * same radius gives (po_refine_error). */
typedef struct {
  const po_contact_gap *finer; /* solved on a finer mesh; NULL: none */
  double precision;            /* of Newton's iteration, see po_equilibrium; used with finer */
  double constant;             /* the part that no finer mesh shows, eps */
} po_contact_doubt;

po_contact_edge po_contact_estimate(const po_contact_gap *gap, const po_contact_doubt *doubt);

/* An annulus in which the gap is below a level; the first may begin on the axis, at 0. */
typedef struct {
  double inner, outer; /* eps */
} po_contact_annulus;

/* Annuli of one equilibrium. Compressed: the traction is compressive there (H < 0). Held: the gap
 * is below that of the greatest tension; what lies between two of those is a groove, an internal
 * crack. */
typedef struct {
  po_contact_annulus *compressed, *held; /* from the axis outwards; owned */
  size_t compressed_count, held_count;
} po_contact_annuli;

/* Given: annuli, zeroed or filled before. Status: PO_NO_MEMORY; PO_OUT_OF_NODES when they are too
 * many to list. */
po_status po_contact_annuli_fill(const po_contact_gap *gap, po_contact_annuli *annuli);
void po_contact_annuli_clear(po_contact_annuli *annuli);

#endif
