/* The pull-off of a viscoelastic body: relaxed loading to the preload, and marches of unloading, or
 * of loading, dwell and unloading, from whose differences the errors follow. See doc/method.md,
 * "Viscoelastic bodies". */
#include <math.h>
#include <stdlib.h>

#include "po_contact.h"
#include "po_deadline.h"
#include "po_estimate.h"
#include "po_far_field.h"
#include "po_law.h"
#include "po_march.h"
#include "po_margins.h"
#include "po_memory.h"
#include "po_rate_loading.h"
#include "po_rate_solve.h"
#include "po_trace.h"

/* -- Marches -- */

/* Unloading ends when the bodies are nowhere in contact, the tension is below this part of its
 * greatest value, and the base has moved farther by a part of its way and the length in which the
 * law changes since the contact ended: all marches end at the same position, and with other steps
 * it ends a little later.
 */
static const double END_OF_TENSION = 0.01, PART_BEYOND = 0.01;

typedef struct {
  const po_request *request;
  const po_surface *surface;
  size_t most_nodes;
  double start;   /* energy less work and losses at the begin, and when unloading began */
  double tension; /* greatest so far */
  double parted;  /* how far the base had moved when the contact ended, eps */
  double imbalance;
  bool begun, unloads;
  po_rate_point first, begin, last; /* the first state, that at which unloading begins, the last */
  po_rate_point *history;
  size_t count, room;
  bool keeps;
  bool fixed; /* the end of the march is given */
  po_status status;
} unloading;

static double balance(const po_rate_energy *e) {
  return e->stored + e->adhesive + e->spring + e->dissipated + e->jumps - e->work;
}

/* Counts time, motion, work and losses of a state before unloading from where it begins. */
static void count_from(const po_rate_point *begin, double time, po_rate_point *p) {
  p->moved = begin->base - p->base;
  p->time -= time;
  p->energy.work -= begin->energy.work;
  p->energy.dissipated -= begin->energy.dissipated;
  p->energy.jumps -= begin->energy.jumps;
}

/* Unloading begins at the last state. */
static void begin_unloading(unloading *u, const po_rate_point *point) {
  const po_rate_point before = u->last;
  if (u->begun) {
    count_from(&before, before.time, &u->first);
    for (size_t k = 0; k < u->count; ++k)
      count_from(&before, before.time, &u->history[k]);
    u->count -= u->count > 0 ? 1 : 0; /* the last one comes again */
  }
  u->start = balance(&point->energy);
  u->begin = *point;
  u->begun = u->unloads = true;
}

static bool visit_march(const po_rate_point *point, po_march_phase phase, void *data) {
  unloading *u = data;
  if (!u->status) /* that of an earlier phase stays */
    u->status = po_deadline_check();
  if (u->request->watch)
    u->request->watch(u->request->watcher, point->approach, point->load);
  if (phase == PO_UNLOADING && !u->unloads)
    begin_unloading(u, point);
  if (!u->begun) {
    u->first = *point;
    u->start = balance(&point->energy);
  }
  u->begun = true;
  u->imbalance = fmax(u->imbalance, fabs(balance(&point->energy) - u->start));
  u->last = *point;
  if (phase == PO_UNLOADING)
    u->tension = fmax(u->tension, -point->load);
  u->most_nodes = u->surface->n > u->most_nodes ? u->surface->n : u->most_nodes;
  if (phase == PO_UNLOADING && point->contact_radius > 0.0)
    u->parted = point->moved;
  if (u->keeps && !u->status) {
    po_rate_point *grown = po_grow(u->history, u->count, &u->room, sizeof *grown);
    if (!grown)
      u->status = PO_NO_MEMORY;
    else {
      u->history = grown;
      grown[u->count++] = *point;
    }
  }
  const double farther = po_law_size(&u->request->scene.law, 0.0);
  return u->status || (phase == PO_UNLOADING && !u->fixed &&
                       point->moved > (1.0 + PART_BEYOND) * u->parted + farther &&
                       -point->load < END_OF_TENSION * u->tension);
}

/* A march, and what was read from it. */
typedef struct {
  po_march *march;
  po_march_peak peak;
  unloading read;
} run;

static void end_run(run *r) {
  po_march_destroy(r->march);
  free(r->read.history);
  *r = (run){0};
}

static po_status march(const po_request *request, po_equilibrium *e, const po_solution *start,
                       double tolerance, po_march_options options, bool keeps, run *r) {
  *r = (run){
      .read = {
          .request = request, .surface = e->surface, .keeps = keeps, .fixed = !isnan(options.end)}};
  options.visit = visit_march;
  options.data = &r->read;
  po_status status = po_march_create(e, po_trace_allowance(tolerance), start, &options, &r->march);
  if (!status)
    status = po_march_run(r->march);
  if (!status)
    status = r->read.status;
  if (status)
    return status;
  r->peak = po_march_greatest_tension(r->march);
  return r->peak.found ? PO_OK
                       : po_fail(PO_NOT_FOUND,
                                 "the tension has no maximum while unloading from approach %.6g",
                                 r->read.begin.approach);
}

/* The tolerance of the panels whose result shows the error of the panels, over the tolerance. */
static const double COARSER = 30.0;

/* The error of a value by the steps and by the panels. Given: coarse steps, half as long ones, and
 * coarse panels; whether the steps of both lead along the same path, so that the error falls as the
 * square of their length. Returned: the value, extrapolated. */
typedef struct {
  double value, time, mesh;
} estimate;

static estimate estimate_of(double coarse, double fine, double panels, bool smooth) {
  const double change = fine - coarse;
  return (estimate){smooth ? fine + change / 3.0 : fine, smooth ? fabs(change) / 3.0 : fabs(change),
                    fabs(panels - coarse)};
}

/* Least estimated error of the force by the steps, relative, over their misfit; that by the panels
 * is PO_PART_OF_TOLERANCE over the tolerance. Where the results of two marches agree by chance,
 * their difference says nothing. Of 40 random scenes the force was off by 4e-3 of the misfit at
 * most; PO_SAFETY is a factor of both. */
static const double LEAST_OF_STEPS = 0.003;

static double error_of(const estimate *e, double rounding) {
  return PO_SAFETY * (e->time + e->mesh) + rounding;
}

/* Newton's method and rounding, relative. */
static const double ROUNDING = 1e-9;

static bool any_jumps(const run r[3], bool while_unloading) {
  size_t count = 0;
  for (int k = 0; k < 3; ++k)
    count += po_march_jumps(r[k].march, while_unloading);
  return count > 0;
}

enum { ENERGIES = sizeof(po_rate_energy) / sizeof(double) };

/* The energies of a state, extrapolated from those of three marches, and their errors. */
static void take_energies(const po_rate_energy *const of[3], bool smooth, po_rate_energy *energy,
                          po_rate_energy *error) {
  const double *coarse = &of[0]->stored, *fine = &of[1]->stored, *panels = &of[2]->stored;
  for (int i = 0; i < ENERGIES; ++i) {
    const estimate e = estimate_of(coarse[i], fine[i], panels[i], smooth);
    (&energy->stored)[i] = e.value;
    (&error->stored)[i] = error_of(&e, ROUNDING * (1.0 + fabs(e.value)));
  }
}

/* Each energy is extrapolated by itself: what the balance of the values misses is an error of the
 * work or of a loss, while the other energies belong to a state. */
static void add_miss(double miss, bool jumps, po_rate_energy *error) {
  error->work += miss;
  error->dissipated += miss;
  if (jumps)
    error->jumps += miss;
}

/* Bounds of errors of the state at the preload that all marches have in common: panels that the
 * coarse ones have, too, and the far field. */
typedef struct {
  po_far_field far;
  double load, energy;
} common_errors;

static common_errors common_errors_of(const po_request *request, const po_attempt *a,
                                      const po_solution *reached) {
  const po_far_field far = po_far_field_of(&request->scene, reached);
  const po_branch_point point = {.approach = po_solution_approach(reached),
                                 .load = reached->load,
                                 .n = reached->core,
                                 .node = reached->node,
                                 .gap = reached->state,
                                 .solution = reached};
  const double energy = po_energy_error(request, &point);
  return (common_errors){far, far.load + PO_PART_OF_TOLERANCE * a->tolerance * fabs(point.load),
                         fmax(energy, far.load * (1.0 + fabs(point.approach)))};
}

/* Adds these to the error of the work until the bodies are far apart: that of the energy; and where
 * the base begins, if the approach of the preload or the deflection of a spring is wrong. */
static void add_common(const common_errors *e, const po_request *request, double load,
                       po_rate_energy *error) {
  const double pliant = isnan(request->stiffness) ? 0.0 : 1.0 / request->stiffness;
  error->work += e->energy + fabs(load) * (e->far.approach + e->load * pliant);
}

static void take_loading(const run r[3], bool smooth, po_rate *rate) {
  po_rate_loading *l = &rate->loading;
  const po_rate_energy *of[3];
  for (int k = 0; k < 3; ++k)
    of[k] = &r[k].read.first.energy;
  const bool jumps = any_jumps(r, false);
  l->is_known = true;
  l->jumps = po_march_jumps(r[1].march, false);
  l->start = r[1].read.first;
  take_energies(of, smooth && !jumps, &l->start.energy, &l->error);
  add_miss(fabs(balance(&l->start.energy) - balance(&rate->begin.energy)), jumps, &l->error);
}

static void take_unloading(const run r[3], bool smooth, po_rate *rate) {
  const po_rate_energy *end[3];
  const double *begin[3];
  for (int k = 0; k < 3; ++k) {
    end[k] = &r[k].read.last.energy;
    begin[k] = &r[k].read.begin.energy.stored;
  }
  take_energies(end, smooth, &rate->end.energy, &rate->end_error);
  double *error = &rate->end_error.stored;
  rate->begin.energy = r[1].read.begin.energy;
  for (int i = 0; i < ENERGIES; ++i) {
    double start = fabs(begin[2][i] - begin[0][i]);
    if (rate->loading.is_known)
      start += fabs(begin[1][i] - begin[0][i]);
    error[i] += PO_SAFETY * start;
  }
  add_miss(fabs(balance(&rate->end.energy) - balance(&rate->begin.energy)), any_jumps(r, true),
           &rate->end_error);
}

/* Whether a test has steps in time: at the limits of the speeds the body is elastic. */
static bool takes_time(const po_request *request) {
  const double speed = request->unload_speed;
  const bool loads = po_rate_is_loaded(request) && speed > 0.0;
  return (speed > 0.0 && isfinite(speed)) ||
         (loads && (isfinite(request->load_speed) || request->dwell != 0.0));
}

/* The shorter of two durations, of which 0 is none. */
static double least_duration(double a, double b) {
  return a == 0.0 ? b : b == 0.0 ? a : fmin(a, b);
}

/* Fills the result from three marches: coarse, with half the steps, on coarse panels. */
static void take(const po_attempt *a, const run r[3], const common_errors *common, po_result *o) {
  po_rate *rate = &o->rate;
  const po_far_field *far = &common->far;
  const bool path = isnan(r[1].read.begin.time);
  const bool steps = takes_time(r[1].read.request); /* the limits have no error in time */
  const bool smooth = steps && r[0].peak.jumps == 0 && r[1].peak.jumps == 0 && r[2].peak.jumps == 0;
  const po_rate_point *p[3] = {&r[0].peak.at, &r[1].peak.at, &r[2].peak.at};
  estimate force = estimate_of(-p[0]->load, -p[1]->load, -p[2]->load, smooth);
  force.mesh = fmax(force.mesh, PO_PART_OF_TOLERANCE * a->tolerance * force.value);
  if (steps)
    force.time = fmax(force.time, LEAST_OF_STEPS * sqrt(a->tolerance) * force.value);
  /* the place of the maximum is no smooth function of the steps */
  const double spread = fmax(r[0].peak.spread, r[1].peak.spread);
  const double radius_spread = fmax(r[0].peak.radius_spread, r[1].peak.radius_spread);
  const estimate approach = estimate_of(p[0]->approach, p[1]->approach, p[2]->approach, false);
  const estimate radius =
      estimate_of(p[0]->contact_radius, p[1]->contact_radius, p[2]->contact_radius, false);
  const estimate moved = estimate_of(p[0]->moved, p[1]->moved, p[2]->moved, false);
  o->has_pull_off = true;
  o->pull_off.force = force.value;
  o->pull_off.far_force_error = far->load;
  o->pull_off.force_error = error_of(&force, ROUNDING * (1.0 + force.value) + far->load);
  o->pull_off.approach = approach.value;
  o->pull_off.approach_error =
      error_of(&approach, ROUNDING * (1.0 + fabs(approach.value)) + spread + far->approach);
  o->pull_off.contact_radius = radius.value;
  o->pull_off.contact_radius_error =
      error_of(&radius, ROUNDING * (1.0 + radius.value) + radius_spread);
  o->pull_off.contact_radius_other = NAN;
  rate->is_known = true;
  rate->time = path ? (double)NAN : moved.value / rate->speed;
  rate->time_error =
      path ? (double)NAN
           : error_of(&moved, ROUNDING * (1.0 + fabs(moved.value)) + spread) / rate->speed;
  rate->time_part = PO_SAFETY * force.time;
  rate->mesh_part = PO_SAFETY * force.mesh;
  rate->begin = r[1].read.begin;
  rate->end = r[1].read.last;
  rate->jumps = po_march_jumps(r[1].march, true);
  rate->steps = po_march_steps(r[1].march);
  rate->imbalance = r[1].read.imbalance;
  if (po_rate_is_loaded(r[1].read.request))
    take_loading(r, steps, rate);
  take_unloading(r, steps && !any_jumps(r, true) && !any_jumps(r, false), rate);
  add_common(common, r[1].read.request, rate->begin.load, &rate->end_error);
  if (rate->loading.is_known)
    add_common(common, r[1].read.request, rate->begin.load, &rate->loading.error);
}

/* The duration of the dwell in which a body relaxes to exp(-40), over its longest time. */
static const double RELAXED = 40.0;

/* Fills the terms of the material, and of the options what depends on the speeds. */
static void fill_terms(const po_request *request, po_creep_terms *terms,
                       po_march_options *options) {
  const double speed = request->unload_speed, load_speed = request->load_speed;
  double shortest = speed > 0.0 ? 1.0 / speed : 0.0;
  options->load_speed = options->dwell = NAN;
  if (po_rate_is_loaded(request)) {
    const double dwell = speed > 0.0 ? request->dwell : (double)NAN;
    shortest = least_duration(shortest, 1.0 / load_speed);
    shortest = least_duration(shortest, isfinite(dwell) ? dwell : 0.0);
    options->load_speed = load_speed;
    options->dwell = dwell;
  }
  po_creep_terms_fill(&request->creep, shortest > 0.0 ? shortest : 1.0, terms);
  if (shortest == 0.0) /* the spectrum does not matter */
    *terms = (po_creep_terms){terms->instant, 1, {{1.0, 1.0 - terms->instant}}};
  if (!isfinite(options->dwell)) /* of a body that is loaded at a speed */
    options->dwell = RELAXED * terms->term[terms->count - 1].time;
}

/* What the profile is wanted of; by default, the greatest tension of a march that has run. */
static po_march_wanted wanted_of(const po_request *request, const run *ran, po_solution *solution) {
  po_march_wanted w = {PO_WANTED_BASE, ran->peak.at.moved, solution};
  if (!isnan(request->profile_approach))
    w = (po_march_wanted){PO_WANTED_APPROACH, request->profile_approach, solution};
  if (!isnan(request->profile_load))
    w = (po_march_wanted){PO_WANTED_LOAD, request->profile_load, solution};
  return w;
}

static po_status take_profile(const po_request *request, const po_surface *surface,
                              const po_solution *found, po_result *o) {
  const po_branch_point point = {.approach = po_solution_approach(found),
                                 .n = found->core,
                                 .node = found->node,
                                 .gap = found->state,
                                 .solution = found};
  return po_contact_profile_take(&request->scene, surface, &point, o);
}

static po_status march_all(const po_request *request, const po_attempt *a, po_equilibrium *e,
                           const po_solution *start, double radius, const common_errors *common,
                           po_result *o) {
  po_creep_terms terms;
  run r[3] = {{0}};
  const po_preload preload = po_request_preload(request);
  po_march_options options = {.terms = &terms,
                              .speed = request->unload_speed,
                              .approach = isnan(preload.approach) ? INFINITY : preload.approach,
                              .load = isnan(preload.load) ? INFINITY : preload.load,
                              .stiffness = request->stiffness,
                              .base = po_solution_approach(start),
                              .misfit = sqrt(a->tolerance),
                              .halving = 1.0,
                              .end = NAN};
  fill_terms(request, &terms, &options);
  o->rate.instant = terms.instant;
  o->rate.speed = request->unload_speed;
  o->rate.terms = terms.count;
  if (!isnan(request->stiffness))
    options.base += start->load / request->stiffness;
  const double tolerance = a->tolerance;
  po_status status = po_march_check(po_scene_coupling(&request->scene), &terms, radius);
  if (!status)
    status = march(request, e, start, tolerance, options, false, &r[0]);
  options.like = r[0].march;
  options.end = r[0].read.last.moved; /* the same for all, so that energies can be compared */
  if (!status)
    status = march(request, e, start, COARSER * tolerance, options, false, &r[2]);
  options.halving = 2.0;
  po_arena arrays = {0};
  po_solution at = {0};
  if (!status && request->want & PO_WANT_PROFILE) {
    status = po_solution_allocate(&at, e->surface->capacity, &arrays);
    options.wanted = wanted_of(request, &r[0], &at);
  }
  if (!status)
    status = march(request, e, start, tolerance, options, request->want & PO_WANT_HISTORY, &r[1]);
  if (!status && options.wanted.solution && po_march_has_wanted(r[1].march))
    status = take_profile(request, e->surface, &at, o);
  po_arena_free(&arrays);
  if (!status)
    take(a, r, common, o);
  for (int k = 0; k < 3; ++k)
    o->work.nodes = r[k].read.most_nodes > o->work.nodes ? r[k].read.most_nodes : o->work.nodes;
  o->rate.history = r[1].read.history;
  o->rate.history_count = r[1].read.count;
  r[1].read.history = NULL;
  for (int k = 0; k < 3; ++k)
    end_run(&r[k]);
  return status;
}

po_status po_rate_solve(const po_request *request, const po_attempt *a, po_surface *surface,
                        po_result *o) {
  po_arena arrays = {0};
  po_solution reached = {0}, first = {0};
  po_equilibrium *e = NULL;
  po_relaxed_loading l = {.request = request,
                          .surface = surface,
                          .preload = po_request_preload(request),
                          .reached = &reached,
                          .first = &first,
                          .load = po_request_preload(request).load};
  po_status status = po_solution_allocate(&reached, surface->capacity, &arrays);
  if (!status)
    status = po_solution_allocate(&first, surface->capacity, &arrays);
  if (!status)
    status = po_rate_load_relaxed(request, &e, &l);
  if (!status) {
    const common_errors common = common_errors_of(request, a, &reached);
    po_contact_gap gap = po_contact_gap_on_panels(&request->scene, &reached);
    const double radius = po_contact_radius(&gap);
    status = po_trace_is_cut_off(&request->scene, radius, a->core)
                 ? PO_OUT_OF_DOMAIN
                 : march_all(request, a, e, po_rate_is_loaded(request) ? &first : &reached, radius,
                             &common, o);
  }
  if (e) {
    const size_t most = o->work.nodes > l.most_nodes ? o->work.nodes : l.most_nodes;
    o->work = e->work;
    o->work.nodes = most;
    o->work.kernel_evaluations = surface->kernel_evaluations;
  }
  o->ended.approach = o->rate.is_known ? o->rate.end.approach : l.greatest;
  o->ended.load = o->rate.is_known ? o->rate.end.load : (double)NAN;
  o->ended.cause = o->rate.is_known ? PO_END_PRELOAD : PO_END_NONE;
  po_equilibrium_destroy(e);
  po_arena_free(&arrays);
  return status;
}
