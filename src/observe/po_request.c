/* What is asked: defaults and checks. */
#include <math.h>

#include "po_outcome.h"

po_request po_request_default(void) {
  return (po_request){.scene = po_scene_default(),
                      .mesh = po_mesh_default(),
                      .approach_start = NAN,
                      .approach_end = NAN,
                      .profile_approach = NAN,
                      .time_limit = NAN};
}

po_status po_request_check(const po_request *request) {
  po_status status = po_scene_check(&request->scene);
  if (!status)
    status = po_mesh_check(&request->mesh);
  if (status)
    return status;
  if (isinf(request->approach_start))
    return po_fail(PO_BAD_INPUT, "approach_start is %g: expected a finite number",
                   request->approach_start);
  if (isinf(request->approach_end))
    return po_fail(PO_BAD_INPUT, "approach_end is %g: expected a finite number",
                   request->approach_end);
  if (request->approach_start >= request->approach_end)
    return po_fail(PO_BAD_INPUT, "approach_end is %g: expected more than approach_start, %g",
                   request->approach_end, request->approach_start);
  if (isinf(request->profile_approach))
    return po_fail(PO_BAD_INPUT, "profile_approach is %g: expected a finite number",
                   request->profile_approach);
  if (request->time_limit <= 0.0 || isinf(request->time_limit))
    return po_fail(PO_BAD_INPUT, "time_limit is %g: expected a finite number > 0",
                   request->time_limit);
  return PO_OK;
}
