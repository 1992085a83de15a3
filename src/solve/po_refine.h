/* A landmark solved again on a finer mesh: the difference is what the mesh of the trace costs. */
#ifndef PO_REFINE_H
#define PO_REFINE_H

#include "po_corrector.h"
#include "po_landmark.h"
#include "po_resolution.h"

/* Given: a fold or an extremum of the load, its mesh resolved by `resolution`; the event, with the
 * samples along the gauge of a point before it, at a cosine to its own gauge. `spare` is room.
 * Returned: the changes of approach and load of the landmark when every panel that contributes to
 * the error is halved, and none spans more than a few waves. The mesh in force is another then.
 * Status: PO_NOT_CONVERGED, PO_OUT_OF_NODES. */
po_status po_refine(po_corrector *c, const po_resolution *resolution, const po_track_point *p,
                    const po_event *event, double cosine, po_track_point *spare, double change[2]);

/* The same when the slope is known, of the rate whose root the landmark is per distance along the
 * gauge of p. */
po_status po_refine_finer(po_corrector *c, const po_resolution *resolution, const po_track_point *p,
                          po_event_kind of, double slope, po_track_point *spare, double change[2]);

/* The fold or extremum near the guess, on the mesh in force: Newton's method for the equilibria, a
 * secant along the gauge of `from` for the rate to vanish. Given: slope of that rate, roughly; NAN:
 * unknown. Returned: the slope met, the landmark in out, its approach and load in value. Status:
 * PO_NOT_CONVERGED. */
po_status po_refine_locate(po_corrector *c, const po_track_point *from, po_event_kind of,
                           double *slope, po_track_point *out, double value[2]);

/* A bound of the error of a landmark's value that a finer mesh changed so much. */
double po_refine_error(const po_corrector *c, double change, double value);

#endif
