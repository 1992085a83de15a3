/* What tracing one scene and following its special points share. */
#ifndef PO_OBSERVE_PARTS_H
#define PO_OBSERVE_PARTS_H

#include "po_reader.h"
#include "po_resolution.h"

/* po_observe, with somebody who keeps minima and folds. */
po_status po_observe_kept(const po_request *request, const po_keeper *keeper, po_result *result);

/* What panels may leave for a request, and where Newton's method may stop, for a relative
 * tolerance. */
po_allowance po_observe_allowance(const po_request *request, double tolerance);
double po_observe_precision(double tolerance);

/* An approach at which, and beyond which, the load of rigid bodies is certainly greater than one.
 */
double po_observe_rigid_end(const po_scene *scene, double load);

/* Radius of the domain of the panels, eps, for a surface whose core reaches so far. */
double po_observe_domain(const po_scene *scene, double core);

/* Whether the surface is unbounded and the contact so near the end of the core (the domain meshed
 * finely) that the scene has to be solved again with a larger core. */
bool po_observe_is_cut_off(const po_scene *scene, double contact_radius, double core);

/* The core that such a contact is well within. */
double po_observe_core_of_contact(double contact_radius);

#endif
