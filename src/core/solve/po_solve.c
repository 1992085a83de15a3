#include "po_solve.h"

#include <math.h>
#include <stdio.h>

#include "po_deadline.h"
#include "po_diagnose.h"
#include "po_load_unit.h"
#include "po_machine.h"
#include "po_reduced.h"
#include "po_scales.h"
#include "po_solve_internal.h"

/* The preload of the loops of the JKR theory: the approach of the request, otherwise the load at
 * which the solve reversed the loading. */
static po_preload preload_of(const po_request *request, const po_result *result) {
  po_preload preload = request->preload;
  if (isnan(preload.approach) && isnan(preload.load))
    preload.load = result->hysteresis.of[PO_AT_APPROACH].preload.load;
  return preload;
}

static bool ends(po_status status) {
  return status == PO_NO_MEMORY || status == PO_INTERRUPTED || status == PO_OUT_OF_TIME;
}

/* Evaluates the theories for the results that are wanted. Status: PO_NO_MEMORY, PO_INTERRUPTED,
 * PO_OUT_OF_TIME. A scene to which the theory does not apply is not a failure. */
static po_status accompany(const po_request *request, po_result *result) {
  const po_theories *theory = request->theories;
  po_status status = PO_OK;
  if (theory && theory->hysteresis && result->has_hysteresis) {
    status = theory->hysteresis(&request->scene, preload_of(request, result), request->stiffness,
                                &result->theory.hysteresis);
    result->theory.has_hysteresis = !status;
  }
  if (theory && theory->staircases && result->has_staircases && !ends(status)) {
    status = theory->staircases(&request->scene, request->stiffness, &result->theory.staircase);
    result->theory.has_staircases = !status;
  }
  if (theory && theory->theories && request->want & PO_WANT_THEORIES && !ends(status))
    status = theory->theories(request, result);
  if (status == PO_OUT_OF_TIME)
    return po_diagnose_out_of_time(request, "the theories beside it are not evaluated");
  if (ends(status))
    return status;
  po_message_clear();
  return PO_OK;
}

/* Traces a scene, and repeats the trace if necessary: with a larger core, with smaller allowed
 * errors, or from a smaller approach. */

/* If the estimated error of the pull-off force exceeds the tolerance, or a fold is not found on a
 * finer mesh and is therefore probably spurious, the trace is repeated with this part of the
 * tolerance that would suffice. */
static const double SHARPER = 0.3;

/* Ratio of error to tolerance that is assumed if the error could not be estimated. */
static const double UNKNOWN_EXCESS = 3.0;

const double PO_MOST_EXCESS = 10.0;

enum { MOST_TRACES = 3 };

/* A trace that takes more points before the preload than this is long: greater ranges take less,
 * where they apply. Of 175 drawn scenes (tests/estimates/ranges.py) 41 of those to which they apply
 * are traced with the true range; 35 of these take 100 to 1,100 points, the others up to more than
 * 4,000, of which greater ranges need 1 to 10 s of 6 to 20. */
enum { LONG_TRACE = 1000 };

const double PO_FARTHER = 1.5;

const double PO_SAME_LOAD = 10.0, PO_SAME_APPROACH = 1e-2;

enum { MOST_MESHES = 4 };

/* A trace begins at least this far below approach_end and the approach of the preload, eps. */
static const double START_MARGIN = 1.0;

/* A trace for hysteresis begins at most at -BEGIN times the sum of the length in which the law
 * changes and the elastic elongation at pull-off. For a smooth sphere this is -4 (1 + mu) eps; by
 * JKR theory it jumps out at -1.61 mu. */
static const double BEGIN = 4.0;

void po_work_add(const po_work *more, po_work *work) {
  work->points += more->points;
  work->newton_iterations += more->newton_iterations;
  work->factorizations += more->factorizations;
  work->kernel_evaluations += more->kernel_evaluations;
  work->meshes += more->meshes;
  work->nodes = work->nodes > more->nodes ? work->nodes : more->nodes;
  work->factorized_nodes = work->factorized_nodes > more->factorized_nodes ? work->factorized_nodes
                                                                           : more->factorized_nodes;
}

/* Whether the scheme estimates errors and did not find that of the pull-off force, or no force. */
static bool is_unsure(const po_request *request, const po_result *result) {
  return request->mesh.scheme == PO_PANEL && !result->rigid && result->has_pull_off &&
         (isnan(result->pull_off.force_error) || !isfinite(result->pull_off.force));
}

/* The part of the estimated error of the pull-off force that finer panels reduce, relative to the
 * tolerance; 0 if it is within the tolerance. */
static double excess_of_panels(const po_request *request, const po_result *result) {
  if (is_unsure(request, result))
    return UNKNOWN_EXCESS;
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
  const double begin = (isfinite(preload) ? fmin(end, preload) : end) - START_MARGIN;
  if (!(request->want & (PO_WANT_HYSTERESIS | PO_WANT_PRELOAD)))
    return begin;
  const po_scene *scene = &request->scene;
  return fmin(begin,
              -BEGIN * (po_law_size(&scene->law, 0.0) + po_scene_scales(scene).wavy_stretch));
}

/* The least part of the estimate that a solve needs. */
static const double LEAST_PART = 0.125;

/* Fails with PO_OUT_OF_NODES if also an eighth of that memory is more than the machine has. */
static po_status request_size_check(const po_request *request) {
  po_request without_search = *request; /* the bound of a search visits every wave */
  without_search.theories = NULL;
  const po_size size = po_request_size(&without_search);
  const double least = LEAST_PART * size.bytes, memory = po_machine_memory();
  if (!(least > memory))
    return PO_OK;
  return po_fail(PO_OUT_OF_NODES,
                 "the finest mesh needs %.2g nodes or more and %.2g GB of memory, and there are "
                 "%.2g GB: expected longer waves, a smaller outer radius or a smaller preload",
                 LEAST_PART * (double)size.nodes, 1e-9 * least, 1e-9 * memory);
}

/* Given: most_points, as po_attempt. */
static po_status attempt(const po_request *request, size_t most_points, po_kept_points *kept,
                         po_result *result) {
  po_status status = po_request_check(request);
  if (!status)
    status = request_size_check(request);
  if (status)
    return status;
  po_attempt a = {.core = po_solve_core(request),
                  .tolerance = request->mesh.tolerance,
                  .begin = latest_start(request),
                  .most_points = most_points};
  po_work work = {0};
  for (int meshes = 0, traces = 1; meshes < MOST_MESHES; ++traces) {
    po_result_clear(result);
    status = po_trace(request, &a, kept, result);
    po_work_add(&result->work, &work);
    double excess = status ? 0.0 : excess_of_panels(request, result);
    if (!status && a.unmet_folds > 0)
      excess = fmax(excess, UNKNOWN_EXCESS);
    if (status == PO_OUT_OF_DOMAIN || (!status && needs_larger_domain(request, result))) {
      a.core *= PO_FARTHER;
      ++meshes;
    } else if (excess > 0.0 && traces < MOST_TRACES) {
      a.tolerance *= SHARPER / excess;
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

static po_status attempt_exact(const po_request *request, po_kept_points *kept, po_result *result) {
  *result = po_result_none();
  return attempt(request, 0, kept, result);
}

/* Fails if the request asks for greater ranges where they do not apply. */
static po_status range_check(const po_request *request) {
  if (request->range != PO_RANGE_REDUCED || po_request_check(request) ||
      po_reduced_applies(request))
    return PO_OK;
  return po_fail(
      PO_BAD_INPUT,
      "range is reduced: expected auto or exact. It applies to the pull-off, the loops and the "
      "staircases of elastic spheres on panels under an attraction with the exponent 3, without "
      "an approach_start or a want other than hysteresis, preload and theories, with a spring "
      "only for hysteresis or preload, and if contact edges are narrower than %.2g of the shortest wave and of the contact; "
      "here they have %.2g",
      PO_REDUCED_MOST_WIDTH, po_reduced_width(&request->scene));
}

/* Solves with greater ranges. Given: the result of a trace that failed, or an empty one, which is
 * replaced if the solve succeeds or must end; otherwise it takes the work. Returned: whether it is
 * replaced; *status. */
static bool attempt_reduced(const po_request *request, po_result *result, po_status *status) {
  po_result reduced;
  *status = po_reduced_solve(request, attempt_exact, &reduced);
  const bool taken = !*status || ends(*status) || request->range == PO_RANGE_REDUCED;
  po_work_add(taken ? &result->work : &reduced.work, taken ? &reduced.work : &result->work);
  po_result_clear(taken ? result : &reduced);
  if (taken)
    *result = reduced;
  return taken;
}

/* Traces a scene with the true range where greater ones may be taken in its place. Given: whether
 * they are to be asked first if the trace is long. Returned: also whether the result is theirs. */
static po_status attempt_true(const po_request *request, bool may_resort, po_kept_points *kept,
                              po_result *result, bool *is_reduced) {
  *is_reduced = false;
  po_work work = result->work;
  const bool is_long = request->want & PO_WANT_PRELOAD; /* a staircase is, whatever its edges are */
  po_status status = attempt(request, may_resort && !is_long ? LONG_TRACE : 0, kept, result), again;
  po_work_add(&work, &result->work);
  if (!may_resort || !po_reduced_is_resort(request, status))
    return status;
  char message[sizeof result->reason];
  snprintf(message, sizeof message, "%s", po_message());
  *is_reduced = attempt_reduced(request, result, &again);
  if (*is_reduced)
    return again;
  if (status != PO_TOO_MANY_POINTS)
    return po_fail(status, "%s", message); /* the first reason is the one that helps */
  work = result->work;
  status = attempt(request, 0, kept, result);
  po_work_add(&work, &result->work);
  return status;
}

/* Traces a scene, or solves it with greater ranges of the attraction: first if these are chosen,
 * otherwise if the trace is long or fails as it does where contact edges are very narrow. Then no
 * points are kept. */
static po_status attempt_ranges(const po_request *request, po_kept_points *kept,
                                po_result *result) {
  po_status status = range_check(request);
  if (status)
    return status;
  const bool applies = !po_request_check(request) && po_reduced_applies(request);
  const bool chosen = applies && po_reduced_is_chosen(request);
  if (chosen && attempt_reduced(request, result, &status))
    return status;
  bool is_reduced;
  const bool may_resort = applies && !chosen && request->range == PO_RANGE_AUTO;
  status = attempt_true(request, may_resort, kept, result, &is_reduced);
  if (is_reduced && kept)
    po_kept_points_clear(kept);
  return status;
}

double po_solve_deadline(const po_request *request) {
  return isnan(request->time_limit) ? INFINITY : po_clock_thread() + request->time_limit;
}

/* Traces the branch of a scene, repeatedly if its errors exceed the tolerance. Given: kept, NULL:
 * no points are kept. Returned: the result, except its status and reason. */
static po_status trace_attempts(const po_request *request, po_kept_points *kept,
                                po_result *result) {
  *result = po_result_none();
  const double begin = po_clock_wall();
  po_message_clear();
  const po_status status = kept && kept->which == PO_KEEP_FOLDS
                               ? attempt(request, 0, kept, result)
                               : attempt_ranges(request, kept, result);
  result->work.seconds = po_clock_wall() - begin - result->diagnostics.seconds;
  return status;
}

/* Writes the status of a solve and the reason into its result. Returned: the status. */
static po_status finish(const po_request *request, po_status status, po_result *result) {
  result->pull_off.excess = po_request_excess(request, result);
  result->status = po_no_memory_or(status);
  if (result->status)
    snprintf(result->reason, sizeof result->reason, "%s",
             *po_message() ? po_message() : po_status_text(result->status));
  return result->status;
}

po_status po_solve_kept(const po_request *request, po_kept_points *kept, po_result *result) {
  const po_deadline before = po_deadline_begin(request->stop, po_solve_deadline(request));
  const po_status status = trace_attempts(request, kept, result);
  po_deadline_end(before);
  return finish(request, status, result);
}

/* Processor time for the theories beside a failed solve, which may have used all of its own, s.
 * They take some hundredths. */
static const double LONGEST_THEORIES = 0.5;

/* Evaluates the theories if the solve failed: as closed forms they need no solve. */
static void accompany_failed(const po_request *request, po_result *result) {
  if (!request->theories || !(request->want & PO_WANT_THEORIES) || result->status < 0 ||
      result->status == PO_OK || result->status == PO_INTERRUPTED)
    return;
  const po_deadline before = po_deadline_begin(request->stop, po_clock_thread() + LONGEST_THEORIES);
  request->theories->theories(request, result);
  po_deadline_end(before);
  po_message_clear();
}

po_status po_solve(const po_request *asked, po_result *result) {
  const po_request request = po_load_unit_request(asked);
  const po_deadline before = po_deadline_begin(request.stop, po_solve_deadline(&request));
  po_status status = trace_attempts(&request, NULL, result);
  const double begin = po_clock_wall(), diagnosed = result->diagnostics.seconds;
  if (!status)
    status = po_solve_changed(&request, result);
  if (!status)
    status = accompany(&request, result);
  result->seconds_beside = po_clock_wall() - begin - (result->diagnostics.seconds - diagnosed);
  result->work.seconds += result->seconds_beside;
  po_deadline_end(before);
  status = finish(&request, status, result);
  accompany_failed(&request, result);
  po_load_unit_result(&request.scene, result);
  return status;
}
