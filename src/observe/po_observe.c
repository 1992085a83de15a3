#include "po_observe.h"

#include <math.h>

#include "po_diagnose.h"
#include "po_load_unit.h"
#include "po_observe_parts.h"
#include "po_watch.h"

/* The preload of the loops of the JKR theory: the approach of the request, otherwise the load at
 * which the solve reversed the loading. */
static po_preload preload_of(const po_request *request, const po_result *result) {
  po_preload preload = request->preload;
  if (isnan(preload.approach) && isnan(preload.load))
    preload.load = result->hysteresis.displacement.preload.load;
  return preload;
}

static bool ends(po_status status) {
  return status == PO_NO_MEMORY || status == PO_INTERRUPTED || status == PO_OUT_OF_TIME;
}

/* Evaluates the theory for the results that are wanted. Status: PO_NO_MEMORY, PO_INTERRUPTED,
 * PO_OUT_OF_TIME. A scene to which the theory does not apply is not a failure. */
static po_status accompany(const po_request *request, po_result *result) {
  const po_companion *theory = request->companion;
  po_status status = PO_OK;
  if (theory && theory->hysteresis && result->has_hysteresis) {
    status = theory->hysteresis(&request->scene, preload_of(request, result),
                                &result->theory.hysteresis);
    result->theory.has_hysteresis = !status;
  }
  if (theory && theory->staircases && result->has_staircases && !ends(status)) {
    status = theory->staircases(&request->scene, result->theory.staircase);
    result->theory.has_staircases = !status;
  }
  if (status == PO_OUT_OF_TIME)
    return po_diagnose_out_of_time(request, "the JKR theory beside it is not evaluated");
  if (ends(status))
    return status;
  po_message_clear();
  return PO_OK;
}

po_status po_observe(const po_request *asked, po_result *result) {
  const po_request request = po_load_unit_request(asked);
  const double deadline = po_observe_deadline(&request);
  const po_watch before = po_watch_begin(request.stop, deadline);
  po_status status = po_observe_attempts(&request, NULL, deadline, result);
  if (!status && (request.want & PO_WANT_DIAGNOSTICS))
    status = po_diagnose_moved(&request, deadline, result);
  if (!status)
    status = accompany(&request, result);
  po_watch_end(before);
  po_load_unit_result(&request.scene, result);
  return po_observe_finish(status, result);
}
