/* What tracing one scene and following its special points share. */
#ifndef PO_OBSERVE_PARTS_H
#define PO_OBSERVE_PARTS_H

#include "po_reader.h"
#include "po_resolution.h"

/* The processor time, on po_clock_thread, until which a request may be solved; INFINITY: no limit.
 */
double po_observe_deadline(const po_request *request);

/* Traces the branch of a scene until its errors are within the tolerance. Given: who keeps minima
 * and folds, or NULL. Returned: the result but for its status and reason. */
po_status po_observe_attempts(const po_request *request, const po_keeper *keeper, double deadline,
                              po_result *result);

/* Writes the status of a solve and the reason into its result. Returned: the status. */
po_status po_observe_finish(po_status status, po_result *result);

/* Both: what po_observe does but for the theory and the solves with moved inputs. */
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
