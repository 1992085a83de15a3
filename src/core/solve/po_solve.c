#include "po_solve.h"

#include <math.h>
#include <stdio.h>

#include "po_deadline.h"
#include "po_diagnose.h"
#include "po_load_unit.h"
#include "po_reduced.h"
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

/* A trace that takes more points before the preload than this is long: greater ranges take less,
 * where they apply. Of 175 drawn scenes (tests/estimates/ranges.py) 41 of those to which they apply
 * are traced with the true range; 35 of these take 100 to 1,100 points, the others up to more than
 * 4,000, of which greater ranges need 1 to 10 s of 6 to 20. */
enum { LONG_TRACE = 1000 };

/* As po_reduced_solver. */
static po_status trace_exact(const po_request *request, po_kept_points *kept, po_result *result) {
  *result = po_result_none();
  return po_trace(request, 0, kept, result);
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
      "only for hysteresis or preload, and if contact edges are narrower than %.2g of the shortest "
      "wave and of the contact; "
      "here they have %.2g",
      PO_REDUCED_MOST_WIDTH, po_reduced_width(&request->scene));
}

/* Solves with greater ranges. Given: the result of a trace that failed, or an empty one, which is
 * replaced if the solve succeeds or must end; otherwise it takes the work. Returned: whether it is
 * replaced; *status. */
static bool attempt_reduced(const po_request *request, po_result *result, po_status *status) {
  po_result reduced;
  *status = po_reduced_solve(request, trace_exact, &reduced);
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
  po_status status = po_trace(request, may_resort && !is_long ? LONG_TRACE : 0, kept, result),
            again;
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
  status = po_trace(request, 0, kept, result);
  po_work_add(&work, &result->work);
  return status;
}

/* If greater ranges of the attraction would solve a scene but are excluded, the message says so.
 * Returned: the status. */
static po_status with_auto(const po_request *request, bool applies, po_status status) {
  if (request->range != PO_RANGE_EXACT || !applies ||
      (status != PO_STEP_TOO_SMALL && status != PO_OUT_OF_NODES && status != PO_OUT_OF_TIME))
    return status;
  return po_fail(status, "%s; greater ranges of the attraction apply: expected the range auto",
                 *po_message() ? po_message() : po_status_text(status));
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
  return with_auto(request, applies, status);
}

/* Traces the branch of a scene, repeatedly if its errors exceed the tolerance. Given: kept, NULL:
 * no points are kept. Returned: the result, except its status and reason. */
static po_status trace_attempts(const po_request *request, po_kept_points *kept,
                                po_result *result) {
  *result = po_result_none();
  const double begin = po_clock_wall();
  po_message_clear();
  const po_status status = kept && kept->which == PO_KEEP_FOLDS
                               ? po_trace(request, 0, kept, result)
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
  const po_deadline before = po_deadline_begin(request->stop, po_trace_deadline(request));
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

po_size po_request_size(const po_request *request) {
  const po_request narrowest = po_reduced_narrowest(request);
  return po_trace_size(po_reduced_is_chosen(request) ? &narrowest : request);
}

po_status po_solve(const po_request *asked, po_result *result) {
  const po_request request = po_load_unit_request(asked);
  const po_deadline before = po_deadline_begin(request.stop, po_trace_deadline(&request));
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
