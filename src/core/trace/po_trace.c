/* One trace of the branch of a request, with its results. */
#include <math.h>
#include <stdio.h>

#include "po_collector.h"
#include "po_continuation.h"
#include "po_deadline.h"
#include "po_diagnose.h"
#include "po_far_field.h"
#include "po_initial_gap.h"
#include "po_margins.h"
#include "po_rate_solve.h"
#include "po_rigid.h"
#include "po_rigid_trace.h"
#include "po_trace.h"

/* Greatest allowed distance of a wanted curve from the straight lines between its points, in eps
 * and pi w R. */
static const double CURVE_SAGITTA = 5e-4;

/* A rigid trace starts at the gap PO_APART, or at a gap larger by a power of PO_FARTHER at which
 * the load is below a given part of the pull-off force. By Derjaguin's approximation the load is 2
 * phi/w, in pi w R. */
static const double RIGID_START_LOAD = 0.02;

static po_continuation_options options_of(const po_request *request, double begin,
                                          po_collector *collector) {
  po_continuation_options options = po_continuation_options_default();
  options.minima_only = collector->for_series && collector->for_series->which != PO_KEEP_FOLDS;
  options.end = request->approach_end;
  if (isfinite(request->preload.approach))
    options.station[0] = request->preload.approach;
  if (request->want & PO_WANT_PROFILE && !isnan(request->profile_approach))
    options.station[1] = request->profile_approach;
  if (request->want & PO_WANT_PROFILE)
    options.station_load = request->profile_load;
  options.begin = fmin(request->approach_start, begin);
  if (request->want & (PO_WANT_CURVE | PO_WANT_HYSTERESIS))
    options.largest_sagitta = CURVE_SAGITTA;
  if (request->want & (PO_WANT_CURVE | PO_WANT_HYSTERESIS | PO_WANT_PRELOAD) &&
      request->mesh.scheme == PO_PANEL)
    options.largest_miss = po_estimate_miss(request);
  options.sharpness = request->mesh.tolerance;
  options.visit = po_collector_visit;
  options.data = collector;
  return options;
}

static void note_work(const po_collector *collector, const po_equilibrium *e, bool panels) {
  po_work *work = &collector->result->work;
  *work = e->work;
  work->nodes = panels ? collector->most_nodes : collector->surface->n;
  work->kernel_evaluations = collector->surface->kernel_evaluations;
}

/* Makes the reverse trace. Status: PO_NO_MEMORY, PO_INTERRUPTED; any other status of the
 * reverse trace is kept with its results. */
static po_status trace_back(po_continuation *continuation, po_collector *collector) {
  po_diagnostics *d = &collector->result->diagnostics;
  const double begin = po_clock_wall();
  po_status status = po_continuation_reverse(continuation, po_collector_visit_back, collector);
  if (collector->status)
    status = collector->status;
  collector->status = PO_OK;
  d->reverse_trace = po_reverse_trace_compare(&collector->kept, status);
  d->seconds += po_clock_wall() - begin;
  if (status == PO_NO_MEMORY || status == PO_INTERRUPTED)
    return status;
  po_message_clear();
  return PO_OK;
}

/* The status of a trace that may have been stopped between two points. */
static po_status unless_stopped(po_collector *collector, po_status status) {
  const po_result *o = collector->result;
  return status == PO_INTERRUPTED || status == PO_OUT_OF_TIME
             ? po_collector_stop(collector, status, o->ended.approach, o->ended.load)
             : status;
}

static po_status trace_elastic(const po_request *request, const po_attempt *a,
                               po_collector *collector, po_surface *surface) {
  const bool panels = po_surface_panels(surface);
  const po_continuation_options options = options_of(request, a->begin, collector);
  po_equilibrium *e = NULL;
  po_continuation *continuation = NULL;
  collector->begin = request->approach_start;
  collector->begun = isnan(request->approach_start);
  po_status status = po_equilibrium_create(&request->scene, surface, &e);
  if (!status && panels)
    e->precision = po_trace_precision(request->mesh.tolerance);
  if (!status)
    status = po_continuation_create(e, po_trace_allowance(a->tolerance), &options, &continuation);
  if (!status) {
    status = unless_stopped(collector, po_continuation_run(continuation));
    note_work(collector, e, panels);
  }
  if (!status && !collector->status && collector->diagnoses && panels)
    status = trace_back(continuation, collector);
  po_continuation_destroy(continuation);
  if (collector->diagnoses && !status)
    status = po_diagnose_states(request, &collector->kept, e, collector->result);
  po_equilibrium_destroy(e);
  return status;
}

static double rigid_start(const po_law *law) {
  double gap = PO_APART;
  while (-po_law_energy(law, gap) > RIGID_START_LOAD)
    gap *= PO_FARTHER;
  return gap;
}

static po_status trace_rigid(const po_request *request, double farthest, po_collector *collector) {
  po_continuation_options options = options_of(request, NAN, collector);
  const bool searches = po_request_search(request) != PO_SEARCH_NONE;
  if (isnan(options.end))
    options.end =
        isnan(request->preload.load) && isfinite(request->preload.approach) && !searches
            ? request->preload.approach
            : po_trace_rigid_end(&request->scene, fmax(0.0, po_request_preload(request).load));
  collector->result->rigid = true;
  if (isfinite(request->preload.approach) &&
      !(request->preload.approach < -po_law_numbers_of(&request->scene.law)->closest))
    return po_fail(PO_BAD_INPUT,
                   "preload is %g: expected less than %g, the greatest approach of rigid bodies",
                   request->preload.approach, -po_law_numbers_of(&request->scene.law)->closest);
  collector->begun = true;
  double begin = request->approach_start;
  if (isnan(begin))
    begin = fmin(0.0, options.end) - rigid_start(&request->scene.law);
  if (!isnan(request->stiffness))
    begin = fmin(begin, farthest);
  return unless_stopped(collector, po_rigid_trace(&request->scene, begin, &options));
}

/* Creates the surface of a request: a fixed mesh or panels; for a rigid scene only the nodes, which
 * a profile needs. */
static po_status make_surface(const po_request *request, bool rigid, double core,
                              po_surface **surface) {
  const po_scene *scene = &request->scene;
  const double far_enough = rigid ? core : po_far_field_core(scene, core, request->mesh.tolerance);
  if (rigid || request->mesh.scheme != PO_PANEL) {
    po_mesh mesh = request->mesh;
    if (mesh.scheme == PO_PANEL) {
      mesh = po_mesh_default();
      mesh.scheme = PO_TRIANGLE;
    }
    return po_surface_create(scene, &mesh, far_enough, !rigid, surface);
  }
  const double domain = po_trace_domain(scene, far_enough);
  const double waves = domain / po_initial_gap_detail(scene);
  uint32_t level = 2; /* 2^level panels have at most the length of a wave, if 64 are enough */
  while (level < 6 && (double)(1 << level) < waves)
    ++level;
  return po_surface_create_panels(scene, domain, level, surface);
}

/* Fails because the points that are read have no minimum of the load: they begin beyond it, or the
 * preload is so small that the trace passed none. */
static po_status lacks_minimum(const po_request *request, const po_collector *collector) {
  const po_curve_point *first = collector->points.path + collector->points.before;
  const double length = po_scene_length_unit(&request->scene);
  if (!isnan(request->approach_start) && collector->points.count > collector->points.before &&
      first->load_rate > 0.0)
    return po_fail(
        PO_NOT_FOUND,
        "the load has no minimum between approach_start and approach %.6g: the trace is "
        "read from approach %.6g, load %.6g on, where the load already rises; expected a "
        "smaller approach_start, or none",
        collector->result->ended.approach * length, first->approach * length,
        first->load * po_scene_load_unit(&request->scene));
  const po_preload preload = po_request_preload(request);
  if (isnan(preload.approach))
    return po_fail(PO_NOT_FOUND, "the load has no minimum up to approach %.6g",
                   collector->result->ended.approach * length);
  return po_fail(
      PO_NOT_FOUND,
      "the load has no minimum up to the preload, approach %.6g: the tension is greatest "
      "where loading is reversed; expected a harder preload",
      preload.approach * length);
}

/* Whether the continuation cannot go on. */
static bool is_stuck(po_status status) {
  return status == PO_STEP_TOO_SMALL || status == PO_NOT_CONVERGED || status == PO_OUT_OF_NODES ||
         status == PO_TOO_MANY_POINTS;
}

/* If the continuation fails in a search beyond the preload, the search ends there. */
static po_status end_search(po_status status, po_collector *collector) {
  if (!is_stuck(status) || !po_stopping_is_searching(&collector->stopping))
    return status;
  po_message_clear();
  collector->result->ended.cause = PO_END_SEARCHED;
  return PO_OK;
}

/* A trace that fails before it reaches the approach from which it is to be read says so. Returned:
 * the status. */
static po_status before_start(po_status status, const po_collector *collector) {
  const double start = collector->request->approach_start;
  if (!is_stuck(status) || collector->begun || isnan(start) || collector->points.count == 0)
    return status;
  return po_fail(
      status, "%s; the trace did not reach approach_start, %.6g: expected a smaller one, or none",
      *po_message() ? po_message() : po_status_text(status),
      start * po_scene_length_unit(&collector->request->scene));
}

/* A trace that fails before it meets the preload has no pull-off: a deeper minimum may follow. The
 * message then has the deepest minimum so far. Returned: the status. */
static po_status without_pull_off(po_status status, const po_collector *collector) {
  po_result *o = collector->result;
  if (!status || collector->stopping.met || !o->has_pull_off)
    return status;
  o->has_pull_off = false;
  return po_fail(
      status,
      "%s; the deepest minimum of the load so far, %.6g at approach %.6g, need not be the "
      "pull-off",
      *po_message() ? po_message() : po_status_text(status),
      -o->pull_off.force * po_scene_load_unit(&collector->request->scene),
      o->pull_off.approach * po_scene_length_unit(&collector->request->scene));
}

/* The width of a contact edge over the shortest wavelength that is advised: by four scenes with
 * Tabor parameters from 60 to 200 the range of the attraction then changes the pull-off force by
 * 3e-4 to 6e-4 of it, in proportion to this number. */
static const double ADVISED_WIDTH = 1e-3;

/* If a trace fails, or takes too long, because contact edges are much narrower than the waves, the
 * message says so, and how to solve the same bodies with a greater range of the attraction. Epsilon
 * enters every length, the Tabor parameter as its inverse, and the width of an edge over the
 * wavelength, eps / (coupling * wavelength), as its square. Returned: the status. */
static po_status with_range(po_status status, const po_collector *collector) {
  const po_scene *scene = &collector->request->scene;
  const double shortest = po_initial_gap_detail(scene);
  const double width = 1.0 / (po_scene_coupling(scene) * shortest);
  if (status != PO_STEP_TOO_SMALL && status != PO_OUT_OF_NODES && status != PO_OUT_OF_TIME)
    return status;
  if (collector->points.count == 0 || !po_scene_is_wavy(scene) || !(width < ADVISED_WIDTH) ||
      collector->request->mesh.scheme != PO_PANEL)
    return status;
  const double larger = sqrt(ADVISED_WIDTH / width);
  char command[200] = "";
  if (po_scene_is_of_paper(scene))
    snprintf(command, sizeof command,
             " (--tabor %.6g --radius %.6g --amplitude %.6g --wavelength %.6g)",
             scene->tabor / larger, scene->radius / larger, scene->amplitude / larger,
             scene->wavelength / larger);
  return po_fail(
      status,
      "%s; a contact edge is %.2g wavelengths wide, with %.3g waves in contact: expected "
      "--distance-m %.4g times as great, or Tabor parameter, coupling and all lengths so many "
      "times smaller%s, changing loads by %.0e where tried",
      *po_message() ? po_message() : po_status_text(status), width,
      collector->points.path[collector->points.count - 1].contact_radius / shortest, larger,
      command, 0.5 * ADVISED_WIDTH);
}

/* Fixed meshes that do not resolve the contact edges make the branch so wild that no step succeeds.
 * Returned: the status. */
static po_status with_panels(po_status status, const po_collector *collector) {
  return status == PO_STEP_TOO_SMALL && collector->request->mesh.scheme != PO_PANEL
             ? po_fail(status, "%s; expected scheme panel", po_message())
             : status;
}

po_status po_trace_once(const po_request *request, po_attempt *a, po_kept_points *kept,
                        po_result *result) {
  const bool rigid = po_rigid_suffices(&request->scene);
  po_surface *surface = NULL;
  po_collector collector = {.request = request,
                            .result = result,
                            .for_series = kept,
                            .most_points = a->most_points,
                            .diagnoses = request->want & PO_WANT_DIAGNOSTICS,
                            .special = {.greatest = {.traced_approach_error = NAN,
                                                     .traced_load_error = NAN,
                                                     .traced_energy_error = NAN}},
                            .stopping = po_stopping_begin(request)};
  if (kept) {
    const po_keep which = kept->which;
    po_kept_points_clear(kept);
    *kept = (po_kept_points){.which = which, .tolerance = a->tolerance};
  }
  po_status status = PO_OK;
  if (!rigid || (request->want & PO_WANT_PROFILE) || request->show)
    status = make_surface(request, rigid, a->core, &surface);
  if (status)
    goto done;
  if (request->creep.kind != PO_CREEP_NONE) {
    status = po_rate_solve(request, a, surface, result);
    po_surface_destroy(surface);
    return status;
  }
  collector.surface = surface;
  status = rigid ? trace_rigid(request, a->begin, &collector)
                 : trace_elastic(request, a, &collector, surface);
  if (!status)
    status = collector.status;
  status = end_search(status, &collector);
  if (!status && result->ended.cause == PO_END_NONE)
    result->ended.cause = isnan(request->approach_end) ? PO_END_COMPLETE : PO_END_ASKED;
  if (!status && !collector.stopping.met && !isnan(request->approach_end) &&
      !isnan(request->preload.load))
    status = po_fail(PO_NOT_FOUND,
                     "the trace ended at approach %.6g, load %.6g, before the load %g was reached; "
                     "expected a greater approach_end%s",
                     result->ended.approach * po_scene_length_unit(&request->scene),
                     result->ended.load * po_scene_load_unit(&request->scene),
                     request->preload.load * po_scene_load_unit(&request->scene),
                     result->ended.load > 0.0 ? ", or a smaller load" : "");
  if (!status && !result->has_pull_off && isnan(request->approach_end))
    status = lacks_minimum(request, &collector);
  if (!status)
    status = po_loading_compute(&collector, &a->begin);
  status = with_panels(without_pull_off(status, &collector), &collector);
  status = before_start(with_range(status, &collector), &collector);
done:
  a->unmet_folds = collector.special.unmet_folds;
  po_collector_end(&collector);
  po_surface_destroy(surface);
  return status;
}
