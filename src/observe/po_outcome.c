#include "po_outcome.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "po_law.h"
#include "po_linear.h"
#include "po_memory.h"
#include "po_reader.h"
#include "po_rigid.h"
#include "po_shape.h"

/* How far a wanted curve may lie from the straight lines between its points. */
static const double CURVE_SAGITTA = 5e-4;

/* Where a rigid trace starts: the load there is below 2 % of pull-off. */
static const double RIGID_START = -10.0;

/* When the contact reaches the end of an unbounded surface's core, the trace is made anew on a
 * larger one. */
static const double CORE_GROWTH = 1.5;
enum { MOST_MESHES = 4 };

static const char *const KINDS[] = {[PO_JUMP_IN] = "jump_in",
                                    [PO_JUMP_OUT] = "jump_out",
                                    [PO_MINIMUM] = "minimum",
                                    [PO_MAXIMUM] = "maximum"};

const char *po_landmark_kind_name(po_landmark_kind kind) {
  return KINDS[kind];
}

static double seconds_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static po_branch_options options_of(const po_request *request, po_reader *reader) {
  po_branch_options options = po_branch_options_default();
  options.end = request->approach_end;
  if (request->want & PO_WANT_PROFILE)
    options.station = request->profile_approach;
  options.begin = request->approach_start;
  if (request->want & PO_WANT_CURVE)
    options.largest_sagitta = CURVE_SAGITTA;
  options.visit = po_reader_visit;
  options.data = reader;
  return options;
}

static po_status trace_elastic(const po_request *request, po_reader *reader) {
  po_outcome *o = reader->outcome;
  po_equilibrium *e = NULL;
  po_status status = po_equilibrium_create(&request->scene, reader->surface, &e);
  if (!status) {
    const po_branch_options options = options_of(request, reader);
    reader->begin = request->approach_start;
    reader->begun = isnan(request->approach_start);
    status = po_branch_trace(e, &options);
    o->work.points = e->work.points;
    o->work.newton_iterations = e->work.newton_iterations;
    o->work.factorizations = e->work.factorizations;
    o->work.factorized_nodes = e->work.factorized_nodes;
    o->work.kernel_evaluations = reader->surface->kernel_evaluations;
  }
  po_equilibrium_destroy(e);
  return status;
}

static po_status trace_rigid(const po_request *request, po_reader *reader) {
  const po_branch_options options = options_of(request, reader);
  reader->outcome->rigid = true;
  reader->begun = true;
  double begin = request->approach_start;
  if (isnan(begin))
    begin = RIGID_START + fmin(0.0, isnan(request->approach_end) ? 0.0 : request->approach_end);
  return po_rigid_trace(&request->scene, begin, &options);
}

/* The profile at the resolved nodes, P = mu p; a rigid one from the undeformed gap, with P / mu
 * when mu is 0. */
static po_status fill_profile(const po_request *request, const po_reader *reader) {
  po_outcome *o = reader->outcome;
  const po_surface *s = reader->surface;
  if (!reader->has_profile)
    return PO_OK;
  o->profile = po_allocate(s->resolved, sizeof *o->profile);
  if (!o->profile)
    return PO_NO_MEMORY;
  o->profile_count = s->resolved;
  o->profile_approach = reader->profile_approach;
  const double tabor = request->scene.tabor > 0.0 ? request->scene.tabor : 1.0;
  for (size_t j = 0; j < s->resolved; ++j) {
    const double gap =
        o->rigid ? po_shape(&request->scene, s->node[j]) - o->profile_approach : reader->gap[j];
    o->profile[j] = (po_profile_point){
        .radius = s->node[j], .gap = gap, .traction = tabor * po_law_at(gap).traction};
  }
  return PO_OK;
}

/* One trace on a surface with the given core. */
static po_status trace(const po_request *request, bool rigid, double core, po_outcome *outcome) {
  po_surface *surface = NULL;
  po_reader reader = {.request = request, .outcome = outcome};
  po_status status = PO_OK;
  if (!rigid || (request->want & PO_WANT_PROFILE))
    status = po_surface_create(&request->scene, &request->mesh, core, !rigid, &surface);
  if (status)
    goto done;
  reader.surface = surface;
  if (surface) {
    outcome->work.nodes = rigid ? 0 : surface->n;
    reader.gap = po_allocate(surface->n, sizeof *reader.gap);
    if (!reader.gap) {
      status = PO_NO_MEMORY;
      goto done;
    }
  }
  status = rigid ? trace_rigid(request, &reader) : trace_elastic(request, &reader);
  if (!status)
    status = reader.status;
  if (!status && !outcome->has_pull_off && isnan(request->approach_end))
    status = po_fail(PO_NOT_FOUND, "the load has no minimum up to approach %.6g", outcome->end);
  if (status >= 0) {
    const po_status filled = fill_profile(request, &reader);
    status = filled ? filled : status;
  }
done:
  free(reader.gap);
  po_surface_destroy(surface);
  return status;
}

static void clear(po_outcome *outcome) {
  po_outcome_clear(outcome);
  outcome->start = outcome->end = outcome->profile_approach = NAN;
}

static po_status observe(const po_request *request, po_outcome *outcome) {
  po_status status = po_request_check(request);
  if (status)
    return status;
  const bool rigid = po_rigid_suffices(&request->scene);
  double core =
      po_surface_core(&request->scene, fmax(request->approach_end, request->profile_approach));
  for (int meshes = 0; meshes < MOST_MESHES; ++meshes, core *= CORE_GROWTH) {
    clear(outcome);
    status = trace(request, rigid, core, outcome);
    if (status != PO_OUT_OF_DOMAIN)
      break;
  }
  return status;
}

po_status po_observe(const po_request *request, po_outcome *outcome) {
  *outcome = (po_outcome){.status = PO_OK};
  clear(outcome);
  const double begin = seconds_now();
  po_linear_single_thread();
  po_message_clear();
  outcome->status = observe(request, outcome);
  if (outcome->status)
    snprintf(outcome->reason, sizeof outcome->reason, "%s",
             *po_message() ? po_message() : po_status_text(outcome->status));
  outcome->work.seconds = seconds_now() - begin;
  return outcome->status;
}

void po_outcome_clear(po_outcome *outcome) {
  free(outcome->folds);
  free(outcome->extrema);
  free(outcome->curve);
  free(outcome->profile);
  *outcome = (po_outcome){.status = PO_OK};
}
