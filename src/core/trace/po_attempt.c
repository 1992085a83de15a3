/* Traces a scene, and repeats the trace if necessary: with a larger core, with smaller allowed
 * errors, or from a smaller approach. */
#include <math.h>

#include "po_deadline.h"
#include "po_load_unit.h"
#include "po_machine.h"
#include "po_margins.h"
#include "po_scales.h"
#include "po_size.h"
#include "po_trace.h"

const double PO_MOST_EXCESS = 10.0;

enum { MOST_TRACES = 3 };

const double PO_SAME_LOAD = 10.0, PO_SAME_APPROACH = 1e-2;

enum { MOST_MESHES = 4 };

/* A trace for hysteresis begins at most at -BEGIN times the sum of the length in which the law
 * changes and the elastic elongation at pull-off. For a smooth sphere this is -4 (1 + mu) eps; by
 * JKR theory it jumps out at -1.61 mu. */
static const double BEGIN = 4.0;

/* Whether the scheme estimates errors and did not find that of the pull-off force, or no force. */
static bool is_unsure(const po_request *request, const po_result *result) {
  return request->mesh.scheme == PO_PANEL && !result->rigid && result->has_pull_off &&
         (isnan(result->pull_off.force_error) || !isfinite(result->pull_off.force));
}

/* The part of the estimated error of the pull-off force that finer panels reduce, relative to the
 * tolerance; 0 if it is within the tolerance. */
static double excess_of_panels(const po_request *request, const po_result *result) {
  if (is_unsure(request, result))
    return PO_SAFETY;
  if (result->rigid || !result->has_pull_off)
    return 0.0;
  const double force = result->pull_off.force;
  const double seen = result->pull_off.force_error - result->pull_off.far_force_error;
  const double excess = seen / (po_request_tolerance(request) * force);
  return excess > 1.0 ? excess : 0.0;
}

/* Whether the part by the far field, which a larger domain reduces, makes the solve fail alone. */
static bool needs_larger_domain(const po_request *request, const po_result *result) {
  return result->has_pull_off && !result->rigid &&
         result->pull_off.far_force_error >
             PO_MOST_EXCESS * po_request_tolerance(request) * result->pull_off.force;
}

/* The greatest approach at which the trace may begin; NAN: any. */
static double latest_start(const po_request *request) {
  const double preload = request->preload.approach;
  const double end = fmin(request->approach_end, request->profile_approach);
  const double length = po_law_size(&request->scene.law, 0.0); /* in which the law changes */
  const double begin = (isfinite(preload) ? fmin(end, preload) : end) - length;
  if (!(request->want & (PO_WANT_HYSTERESIS | PO_WANT_PRELOAD)))
    return begin;
  const po_scene *scene = &request->scene;
  return fmin(begin, -BEGIN * (length + po_scene_scales(scene).wavy_stretch));
}

/* The least part of the estimate that a solve needs. */
static const double LEAST_PART = 0.125;

/* Fails with PO_OUT_OF_NODES if also an eighth of that memory is more than the machine has. */
static po_status request_size_check(const po_request *request) {
  po_request without_search = *request; /* the bound of a search visits every wave */
  without_search.theories = NULL;
  const po_size size = po_trace_size(&without_search);
  const double least = LEAST_PART * size.bytes, memory = po_machine_memory();
  if (!(least > memory))
    return PO_OK;
  return po_fail(PO_OUT_OF_NODES,
                 "the finest mesh needs %.2g nodes or more and %.2g GB of memory, and there are "
                 "%.2g GB: expected longer waves, a smaller outer radius or a smaller preload",
                 LEAST_PART * (double)size.nodes, 1e-9 * least, 1e-9 * memory);
}

po_status po_trace(const po_request *request, size_t most_points, po_kept_points *kept,
                   po_result *result) {
  po_status status = po_request_check(request);
  if (!status)
    status = request_size_check(request);
  if (status)
    return status;
  po_attempt a = {.core = po_trace_core(request),
                  .tolerance = request->mesh.tolerance,
                  .begin = latest_start(request),
                  .most_points = most_points};
  po_work work = {0};
  for (int meshes = 0, traces = 1; meshes < MOST_MESHES; ++traces) {
    po_result_clear(result);
    status = po_trace_once(request, &a, kept, result);
    po_work_add(&result->work, &work);
    double excess = status ? 0.0 : excess_of_panels(request, result);
    if (!status && a.unmet_folds > 0)
      excess = fmax(excess, PO_SAFETY);
    if (status == PO_OUT_OF_DOMAIN || (!status && needs_larger_domain(request, result))) {
      a.core *= PO_FARTHER;
      ++meshes;
    } else if (excess > 0.0 && traces < MOST_TRACES) {
      a.tolerance /= PO_SAFETY * excess;
    } else if (!status && request->want & PO_WANT_HYSTERESIS && !result->has_hysteresis) {
      ++meshes; /* the next trace begins at a smaller approach */
    } else {
      break;
    }
  }
  result->work = work;
  if (!status && is_unsure(request, result))
    return po_fail(
        PO_NOT_CONVERGED,
        "the error of the pull-off force %.6g at approach %.6g could not be estimated: no "
        "equilibrium was found there on a finer mesh",
        result->pull_off.force * po_scene_load_unit(&request->scene),
        result->pull_off.approach * po_scene_length_unit(&request->scene));
  if (!status && po_request_excess(request, result) > PO_MOST_EXCESS)
    return po_fail(PO_NOT_CONVERGED,
                   "the error of the pull-off force %.6g is estimated at %.2g, %.2g times the "
                   "tolerance, also on finer panels%s",
                   result->pull_off.force * po_scene_load_unit(&request->scene),
                   result->pull_off.force_error * po_scene_load_unit(&request->scene),
                   po_request_excess(request, result),
                   needs_larger_domain(request, result)
                       ? " and a larger domain: expected a larger tolerance or an outer radius"
                       : ": expected a larger tolerance");
  return status;
}

double po_trace_deadline(const po_request *request) {
  return isnan(request->time_limit) ? INFINITY : po_clock_thread() + request->time_limit;
}
