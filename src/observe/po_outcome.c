#include "po_outcome.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_adaptive.h"
#include "po_clock.h"
#include "po_diagnose.h"
#include "po_linear.h"
#include "po_observe_parts.h"
#include "po_reader.h"
#include "po_rigid.h"
#include "po_shape.h"
#include "po_track.h"

/* How far a wanted curve may lie from the straight lines between its points. */
static const double CURVE_SAGITTA = 5e-4;
/* And from the cubics, in parts of the tolerance of panels, and the least of it: the cost goes as
 * the fourth root. */
static const double MISS_OF_TOLERANCE = 0.1, LEAST_MISS = 1e-8;

/* Error of the gap, in eps, that panels may make by their last coefficients, over the root of the
 * relative tolerance of the pull-off force: what these coefficients do to the load goes as their
 * square, by Gauss's rule. Set by the smooth sphere (tests/unit/test_panels.c). */
static const double ERROR_OF_TOLERANCE = 0.3, ERROR_OF_WAVES = 1.0, COARSEST_ERROR = 3e-4;
/* Beyond this Tabor parameter the coarsest error falls as its square: on coarser panels the
 * iteration onto mu = 50 needs steps three times shorter. */
static const double STIFF_TABOR = 14.0;
/* Below it waves may have more, by the fourth power: their minima are sharp, whereas that of a
 * sphere is flat, and its approach would suffer. With 5e-3 at mu = 20 folds appear that are not.
 * Nothing is gained where the surface hardly gives way. */
static const double COARSEST_OF_WAVES = 1e-2, LEAST_PLIANT_TABOR = 1.0;
/* Error of the load that a panel may make, by an estimate that is mostly too large, over the same
 * tolerance. */
static const double LOAD_OF_TOLERANCE = 30.0;

/* When the estimated error of the force is beyond the tolerance, the trace is made anew, with this
 * part of what would do. */
static const double SHARPER = 0.3;
/* What an error counts for that could not be estimated. */
static const double UNKNOWN_EXCESS = 3.0;
/* An estimate so many times the tolerance, after all, is of a contact that no mesh has met. */
static const double MOST_EXCESS = 10.0;
enum { MOST_TRACES = 3 };

/* Where Newton's method may stop, in parts of 1 + H, per relative tolerance; and its limits:
 * rounding below, and what locating folds needs. */
static const double PRECISION_OF_TOLERANCE = 1e-4, FINEST_PRECISION = 2e-13,
                    COARSEST_PRECISION = 1e-9;

/* Where a rigid trace starts: the load there is below 2 % of pull-off. */
static const double RIGID_START = -10.0;

/* When the contact reaches the end of an unbounded surface's core, the trace is made anew on a
 * larger one. */
static const double CORE_GROWTH = 1.5;
enum { MOST_MESHES = 4 };

/* Where a trace for hysteresis begins, in Tabor parameters and in eps: the smooth sphere jumps out
 * at -1.61 mu (JKR), and waves may hold on longer. */
static const double BEGIN_PER_TABOR = 4.0, BEGIN_AT_LEAST = 4.0;
/* When unloading leads farther out than the trace began, it begins anew in units of that. */
static const double FARTHER = 1.5;

static const char *const KINDS[] = {[PO_JUMP_IN] = "jump_in",
                                    [PO_JUMP_OUT] = "jump_out",
                                    [PO_MINIMUM] = "minimum",
                                    [PO_MAXIMUM] = "maximum"};

const char *po_landmark_kind_name(po_landmark_kind kind) {
  return KINDS[kind];
}

/* What a trace is made with, and made anew with. */
typedef struct {
  double core;      /* of the surface, eps */
  double tolerance; /* of panels */
  double begin;     /* approach it begins at, if not farther out; NAN: what the solver takes */
} attempt;

static po_branch_options options_of(const po_request *request, double begin, po_reader *reader) {
  po_branch_options options = po_branch_options_default();
  options.end = request->approach_end;
  if (request->want & PO_WANT_HYSTERESIS)
    options.station = request->preload.approach;
  if (request->want & PO_WANT_PROFILE && !isnan(request->profile_approach))
    options.station = request->profile_approach;
  options.begin = fmin(request->approach_start, begin);
  if (request->want & (PO_WANT_CURVE | PO_WANT_HYSTERESIS))
    options.largest_sagitta = CURVE_SAGITTA;
  if (request->want & (PO_WANT_CURVE | PO_WANT_HYSTERESIS) && request->mesh.scheme == PO_PANEL)
    options.largest_miss = fmax(LEAST_MISS, MISS_OF_TOLERANCE * request->mesh.tolerance);
  options.visit = po_reader_visit;
  options.data = reader;
  return options;
}

static bool is_pliant_and_wavy(const po_scene *scene) {
  return po_scene_is_wavy(scene) && scene->tabor > LEAST_PLIANT_TABOR;
}

/* The error of the gap that panels may make at any tolerance. */
static double coarsest_error(const po_scene *scene) {
  const double stiff = scene->tabor / STIFF_TABOR;
  if (stiff > 1.0)
    return COARSEST_ERROR / (stiff * stiff);
  if (!is_pliant_and_wavy(scene))
    return COARSEST_ERROR;
  return fmin(COARSEST_OF_WAVES, COARSEST_ERROR / pow(stiff, 4.0));
}

po_allowance po_observe_allowance(const po_scene *scene, double tolerance) {
  const double coarsest = coarsest_error(scene);
  const double error = is_pliant_and_wavy(scene) ? ERROR_OF_WAVES : ERROR_OF_TOLERANCE;
  return (po_allowance){fmin(coarsest, error * sqrt(tolerance)),
                        fmin(coarsest, LOAD_OF_TOLERANCE * tolerance)};
}

double po_observe_precision(double tolerance) {
  return fmax(FINEST_PRECISION, fmin(COARSEST_PRECISION, PRECISION_OF_TOLERANCE * tolerance));
}

static void note_work(const po_reader *reader, const po_equilibrium *e, bool panels) {
  po_work *work = &reader->outcome->work;
  work->points = e->work.points;
  work->newton_iterations = e->work.newton_iterations;
  work->factorizations = e->work.factorizations;
  work->factorized_nodes = e->work.factorized_nodes;
  work->meshes = e->work.meshes;
  work->nodes = panels ? reader->most_nodes : reader->surface->n;
  work->kernel_evaluations = reader->surface->kernel_evaluations;
}

/* Follows the branch back, in as much time as it had out. Status: as of the trace where that is
 * none of the way's own. */
static po_status trace_back(po_tracker *tracker, po_reader *reader) {
  po_diagnostics *d = &reader->outcome->diagnostics;
  const double begin = po_clock_wall();
  if (isfinite(reader->deadline))
    reader->deadline = po_clock_thread() + reader->request->time_limit;
  po_status status = po_track_back(tracker, po_reader_visit_back, reader);
  if (reader->status)
    status = reader->status;
  reader->status = PO_OK;
  d->way_back = po_way_back_compare(reader->out, reader->back, status);
  d->seconds += po_clock_wall() - begin;
  if (status == PO_NO_MEMORY || status == PO_INTERRUPTED)
    return status;
  po_message_clear();
  return PO_OK;
}

static po_status trace_panels(const po_request *request, const attempt *a, po_reader *reader,
                              po_equilibrium *e, po_adaptive *panels,
                              const po_branch_options *options) {
  const po_allowance allowed = po_observe_allowance(&request->scene, a->tolerance);
  po_tracker *tracker = NULL;
  e->precision = po_observe_precision(request->mesh.tolerance);
  po_status status = po_track_create(e, panels, allowed, options, &tracker);
  if (!status)
    status = po_track_onwards(tracker);
  note_work(reader, e, true);
  if (!status && !reader->status && reader->back)
    status = trace_back(tracker, reader);
  po_track_destroy(tracker);
  return status;
}

static po_status trace_elastic(const po_request *request, const attempt *a, po_reader *reader,
                               po_adaptive *panels) {
  po_equilibrium *e = NULL;
  const size_t capacity = panels ? po_adaptive_capacity(panels) : reader->surface->n;
  po_status status = po_equilibrium_create(&request->scene, reader->surface, capacity, &e);
  if (!status) {
    const po_branch_options options = options_of(request, a->begin, reader);
    reader->begin = request->approach_start;
    reader->begun = isnan(request->approach_start);
    if (panels) {
      status = trace_panels(request, a, reader, e, panels, &options);
    } else {
      status = po_branch_trace(e, &options);
      note_work(reader, e, false);
    }
    if (reader->kept && po_diagnose_states(reader->kept, e, panels, reader->outcome) && !status)
      status = PO_NO_MEMORY;
  }
  po_equilibrium_destroy(e);
  return status;
}

/* The crest that pushes with this much more than the load, and this, outdoes all that pulls: the
 * attractive term of Eq 23, 8/(3 x^2) where its repulsive term, 2/(3 x^8), is such a push. */
static const double PUSH_PER_LOAD = 1.1, PUSH_BEYOND_LOAD = 8.0;

/* Where a rigid trace has reached the preload for sure; it pulls with no more than 2. */
static double rigid_end(const po_request *request) {
  const po_preload *preload = &request->preload;
  const double load = isnan(preload->load) ? 2.0 : preload->load;
  return fmax(preload->approach,
              po_rigid_approach_of_crest(&request->scene, PUSH_PER_LOAD * load + PUSH_BEYOND_LOAD));
}

static po_status trace_rigid(const po_request *request, po_reader *reader) {
  po_branch_options options = options_of(request, NAN, reader);
  if (isnan(options.end) && request->want & PO_WANT_HYSTERESIS)
    options.end = rigid_end(request);
  reader->outcome->rigid = true;
  reader->begun = true;
  double begin = request->approach_start;
  if (isnan(begin))
    begin = RIGID_START + fmin(0.0, isnan(request->approach_end) ? 0.0 : request->approach_end);
  return po_rigid_trace(&request->scene, begin, &options);
}

double po_observe_root(const po_scene *scene, double core) {
  return isfinite(scene->outer_radius)
             ? core
             : po_averaging_radius(scene, po_averaging_phase(scene, core));
}

/* The surface of a request: a mesh that stays, or panels; nodes only (for a profile) when rigid. */
static po_status make_surface(const po_request *request, bool rigid, double core,
                              po_surface **fixed, po_adaptive **panels) {
  const po_scene *scene = &request->scene;
  if (rigid || request->mesh.scheme != PO_PANEL) {
    po_mesh mesh = request->mesh;
    if (mesh.scheme == PO_PANEL)
      mesh = po_mesh_fixed();
    return po_surface_create(scene, &mesh, core, !rigid, fixed);
  }
  const double root = po_observe_root(scene, core);
  const double waves = po_scene_is_wavy(scene) ? root / scene->wavelength : 0.0;
  return po_adaptive_create(scene, root, (uint32_t)ceil(log2(fmin(fmax(waves, 4.0), 64.0))),
                            panels);
}

/* Loading and unloading along the branch traced; where unloading leads farther out than it began,
 * a->begin is set so that it will do, and nothing read off. */
static po_status read_hysteresis(const po_reader *reader, attempt *a) {
  po_outcome *o = reader->outcome;
  const po_path path = {reader->path, reader->path_count};
  double least = INFINITY;
  for (size_t k = 0; k < path.count; ++k)
    least = fmin(least, path.point[k].approach);
  if (path.count > 0 && least < path.point[0].approach) {
    a->begin = FARTHER * least;
    return PO_OK;
  }
  const po_status status =
      po_hysteresis_follow(&path, reader->request->preload, o->pull_off.force, &o->hysteresis);
  o->has_hysteresis = !status;
  return status;
}

/* One trace. Returned: *a, where it is to be changed for hysteresis. */
static po_status trace(const po_request *request, bool rigid, attempt *a, double deadline,
                       const po_keeper *keeper, po_outcome *outcome) {
  po_surface *fixed = NULL;
  po_adaptive *panels = NULL;
  po_kept kept = {0};
  po_balance balance = {0};
  po_passage out = {0}, back = {0};
  po_reader reader = po_reader_begin(request, outcome, deadline);
  reader.keeper = keeper;
  if (request->want & PO_WANT_DIAGNOSTICS) {
    reader.balance = &balance;
    reader.kept = &kept;
    reader.out = &out;
    reader.back = &back;
  }
  if (keeper)
    keeper->begin(keeper->data, a->tolerance);
  po_status status = PO_OK;
  if (!rigid || (request->want & PO_WANT_PROFILE))
    status = make_surface(request, rigid, a->core, &fixed, &panels);
  if (status)
    goto done;
  reader.surface = panels ? po_adaptive_surface(panels) : fixed;
  status = rigid ? trace_rigid(request, &reader) : trace_elastic(request, a, &reader, panels);
  if (!status)
    status = reader.status;
  if (!status && !outcome->has_pull_off && isnan(request->approach_end))
    status = po_fail(PO_NOT_FOUND, "the load has no minimum up to approach %.6g", outcome->end);
  if (!status && (request->want & PO_WANT_HYSTERESIS))
    status = read_hysteresis(&reader, a);
done:
  po_reader_end(&reader);
  outcome->diagnostics.energy_defect = po_balance_defect(&balance);
  outcome->diagnostics.energy_defect_at = balance.at;
  po_kept_clear(&kept);
  po_passage_clear(&out);
  po_passage_clear(&back);
  po_adaptive_destroy(panels);
  po_surface_destroy(fixed);
  return status;
}

static void clear(po_outcome *outcome) {
  po_outcome_clear(outcome);
  outcome->start = outcome->end = outcome->profile_approach = NAN;
  outcome->diagnostics.residual = outcome->diagnostics.rounding = NAN;
  outcome->diagnostics.energy_defect = outcome->diagnostics.energy_defect_at = NAN;
  outcome->diagnostics.way_back.excess = NAN;
  outcome->diagnostics.moved = (po_moved){.change = NAN, .predicted = NAN};
}

static void add_work(const po_work *more, po_work *work) {
  work->points += more->points;
  work->newton_iterations += more->newton_iterations;
  work->factorizations += more->factorizations;
  work->kernel_evaluations += more->kernel_evaluations;
  work->meshes += more->meshes;
  work->nodes = work->nodes > more->nodes ? work->nodes : more->nodes;
  work->factorized_nodes = work->factorized_nodes > more->factorized_nodes ? work->factorized_nodes
                                                                           : more->factorized_nodes;
}

/* Whether the scheme says how far it errs, and for once cannot. */
static bool is_unsure(const po_request *request, const po_outcome *outcome) {
  return request->mesh.scheme == PO_PANEL && !outcome->rigid && outcome->has_pull_off &&
         isnan(outcome->pull_off.force_error);
}

/* The estimated error of the force in parts of what is asked; 0 when it is no more. */
static double excess_error(const po_request *request, const po_outcome *outcome) {
  const double asked = request->mesh.tolerance * outcome->pull_off.force;
  if (is_unsure(request, outcome))
    return UNKNOWN_EXCESS;
  return outcome->has_pull_off && outcome->pull_off.force_error > asked
             ? outcome->pull_off.force_error / asked
             : 0.0;
}

static po_status observe(const po_request *request, const po_keeper *keeper, po_outcome *outcome) {
  po_status status = po_request_check(request);
  if (status)
    return status;
  const bool rigid = po_rigid_suffices(&request->scene);
  const double deadline =
      isnan(request->time_limit) ? INFINITY : po_clock_thread() + request->time_limit;
  attempt a = {.core = po_surface_core(&request->scene,
                                       fmax(fmax(request->approach_end, request->profile_approach),
                                            request->preload.approach)),
               .tolerance = request->mesh.tolerance,
               .begin = NAN};
  if (request->want & PO_WANT_HYSTERESIS)
    a.begin = -(BEGIN_AT_LEAST + BEGIN_PER_TABOR * request->scene.tabor + request->scene.amplitude);
  po_work work = {0};
  for (int meshes = 0, traces = 1; meshes < MOST_MESHES; ++traces) {
    clear(outcome);
    status = trace(request, rigid, &a, deadline, keeper, outcome);
    add_work(&outcome->work, &work);
    const double excess = status || rigid ? 0.0 : excess_error(request, outcome);
    if (status == PO_OUT_OF_DOMAIN) {
      a.core *= CORE_GROWTH;
      ++meshes;
    } else if (excess > 0.0 && traces < MOST_TRACES) {
      a.tolerance *= SHARPER / excess;
    } else if (!status && request->want & PO_WANT_HYSTERESIS && !outcome->has_hysteresis) {
      ++meshes; /* it begins farther out now */
    } else {
      break;
    }
  }
  outcome->work = work;
  if (!status && is_unsure(request, outcome))
    return po_fail(
        PO_NOT_CONVERGED,
        "the error of the pull-off force %.6g at approach %.6g could not be estimated: no "
        "equilibrium was found there on a finer mesh",
        outcome->pull_off.force, outcome->pull_off.approach);
  if (!status && !rigid && excess_error(request, outcome) > MOST_EXCESS)
    return po_fail(PO_NOT_CONVERGED,
                   "the error of the pull-off force %.6g is estimated at %.2g, far beyond the "
                   "tolerance, and more panels did not help",
                   outcome->pull_off.force, outcome->pull_off.force_error);
  return status;
}

po_status po_observe(const po_request *request, po_outcome *outcome) {
  return po_observe_kept(request, NULL, outcome);
}

po_status po_observe_kept(const po_request *request, const po_keeper *keeper, po_outcome *outcome) {
  *outcome = (po_outcome){.status = PO_OK};
  clear(outcome);
  const double begin = po_clock_wall();
  po_linear_single_thread();
  po_message_clear();
  outcome->status = observe(request, keeper, outcome);
  outcome->work.seconds = po_clock_wall() - begin - outcome->diagnostics.seconds;
  if (!outcome->status && (request->want & PO_WANT_DIAGNOSTICS))
    outcome->status = po_diagnose_moved(request, outcome);
  if (outcome->status)
    snprintf(outcome->reason, sizeof outcome->reason, "%s",
             *po_message() ? po_message() : po_status_text(outcome->status));
  return outcome->status;
}

void po_outcome_clear(po_outcome *outcome) {
  free(outcome->folds);
  free(outcome->extrema);
  free(outcome->curve);
  free(outcome->profile);
  po_hysteresis_clear(&outcome->hysteresis);
  free(outcome->diagnostics.states);
  *outcome = (po_outcome){.status = PO_OK};
}
