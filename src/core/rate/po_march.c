#include "po_march.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_law.h"
#include "po_march_internal.h"
#include "po_margins.h"

/* The length of the first step, and of the first after a jump, eps; and the shortest step of the
 * glassy body, below which the contact jumps. */
static const double FIRST_LENGTH = 1e-3, SHORTEST = 1e-6;

/* Where the effective coupling exceeds that of the glassy body by less than this part, a step is
 * one of the glassy body. */
static const double GLASSY = 1e-3;

/* Distance from the end, relative to it, that is rounding. */
static const double AT_END = 1e-13;

enum { MOST_RECORDS = 200000 };

/* Least number of steps in which an edge moves by its own width. */
static const double STEPS_A_WIDTH = 0.25;

po_status po_march_check(double coupling, const po_creep_terms *terms, double radius) {
  const double width = 1.0 / (coupling * terms->instant), steps = STEPS_A_WIDTH * radius / width;
  return steps <= MOST_RECORDS
             ? PO_OK
             : po_fail(PO_TOO_MANY_POINTS,
                       "the contact edge, about %.2g epsilon wide, passes %.3g epsilon: that is "
                       "more than %d steps in time; pulloff compare has the theory of Persson and "
                       "Brener, which needs none",
                       width, radius, MOST_RECORDS);
}

static po_status allocate(po_march *m) {
  const size_t capacity = m->e->surface->capacity, size = capacity + 1;
  po_march_state *const states[] = {&m->before, &m->held, &m->here, &m->next, &m->after};
  for (size_t k = 0; k < sizeof states / sizeof *states; ++k) {
    states[k]->panels = po_arena_reserve(&m->arrays, 1, sizeof *states[k]->panels);
    states[k]->field = po_arena_reserve(&m->arrays, m->fields * capacity, sizeof(double));
  }
  double **const vectors[] = {&m->bare,     &m->creep, &m->guess, &m->solved, &m->border,
                              &m->traction, &m->other, &m->shape, &m->forces, &m->forces_before};
  for (size_t k = 0; k < sizeof vectors / sizeof *vectors; ++k)
    *vectors[k] = po_arena_reserve(&m->arrays, size, sizeof(double));
  m->shape_panels = po_arena_reserve(&m->arrays, 1, sizeof *m->shape_panels);
  return m->arrays.ran_out ? PO_NO_MEMORY : PO_OK;
}

static po_status record(po_march *m, const po_rate_point *point, bool jumped) {
  po_march_record *grown = po_grow(m->records, m->count, &m->room, sizeof *grown);
  if (!grown)
    return PO_NO_MEMORY;
  m->records = grown;
  grown[m->count++] = (po_march_record){*point, jumped, m->held.length};
  if (m->count > MOST_RECORDS)
    return po_fail(PO_TOO_MANY_POINTS, "more than %d steps, the last at approach %.6g, load %.6g",
                   MOST_RECORDS, point->approach, point->load * po_scene_load_unit(m->e->scene));
  return PO_OK;
}

/* Makes the step `next` the last state. */
static void accept(po_march *m) {
  po_march_exchange(&m->before, &m->held);
  po_march_exchange(&m->held, &m->next);
  m->is_here = false;
}

/* The equilibrium at the base of `start`, on a mesh for the errors of this march, and its fields:
 * that of the relaxed body, U_m = (1 - k) w_m Q; of a body that will be loaded, that before any
 * creep, U_m = 0. */
static po_status begin(po_march *m, const po_solution *start) {
  po_equilibrium *e = m->e;
  po_status status = po_surface_mesh(e->surface, start->panels);
  if (status)
    return status;
  po_equilibrium_remesh(e);
  memcpy(m->bare, e->initial_gap, e->n * sizeof *m->bare);
  m->held.n = e->n;
  po_panels_copy(start->panels, m->held.panels);
  memset(m->held.field, 0, m->fields * e->n * sizeof *m->held.field);
  memcpy(po_march_field(&m->held, PO_OF_DEFLECTION), start->deflection, e->n * sizeof(double));
  m->held.point = (po_rate_point){.time = 0.0,
                                  .base = m->options.base,
                                  .approach = po_solution_approach(start),
                                  .load = start->load};
  po_march_bring(m);
  memcpy(m->shape, start->deflection, e->n * sizeof(double));
  po_panels_copy(start->panels, m->shape_panels);
  status = po_march_remesh(m);
  if (status)
    return status;
  po_march_bring(m);
  po_march_state *s = &m->next;
  const po_creep_terms *t = m->options.terms;
  const bool loads = !isnan(m->options.load_speed);
  /* the motion of a jump with part 1 is the equilibrium: at speed 0, the relaxed one */
  m->speed = loads ? INFINITY : 0.0;
  const po_march_scene scene = {.factor = loads ? t->instant : 1.0, .relaxing = true, .part = 1.0};
  status = po_march_solve(m, &scene);
  if (status == PO_NOT_CONVERGED)
    return po_fail(status, "no equilibrium was found at the start, approach %.6g",
                   po_solution_approach(start));
  if (status)
    return status;
  const double crept = loads ? 0.0 : 1.0;
  double sum = 0.0;
  for (size_t j = 0; j < s->n; ++j) {
    for (size_t k = PO_OF_RATE; k < PO_OF_INSTANT; ++k)
      po_march_field(s, k)[j] = 0.0;
    const double instant =
        (po_march_field(s, PO_OF_DEFLECTION)[j] + m->solved[s->n]) / scene.factor;
    po_march_field(s, PO_OF_INSTANT)[j] = instant;
    for (size_t k = 0; k < t->count; ++k)
      po_march_field(s, PO_OF_CREEP + k)[j] = crept * t->term[k].weight * instant;
    sum += crept * e->surface->weight[j] * m->traction[j] * instant;
  }
  for (size_t k = 0; k < t->count; ++k)
    s->square[k] = t->term[k].weight * t->term[k].weight * 2.0 / e->radius * sum;
  s->length = 0.0;
  s->point.time = 0.0;
  po_march_measure(m);
  accept(m);
  e->factorized = false; /* a stable state decides on the sign of the determinant */
  return PO_OK;
}

po_status po_march_create(po_equilibrium *e, po_allowance allowed, const po_solution *start,
                          const po_march_options *options, po_march **march) {
  po_march *m = *march = po_allocate(1, sizeof *m);
  if (!m)
    return PO_NO_MEMORY;
  m->e = e;
  m->resolution = po_resolution_of(e, allowed);
  m->options = *options;
  m->coupling = po_scene_coupling(e->scene);
  m->fields = PO_OF_CREEP + options->terms->count;
  po_status status = allocate(m);
  if (!status)
    status = begin(m, start);
  if (!status)
    return PO_OK;
  po_march_destroy(m);
  *march = NULL;
  return status;
}

void po_march_destroy(po_march *m) {
  if (!m)
    return;
  po_arena_free(&m->arrays);
  free(m->records);
  free(m);
}

/* Positions that differ by less, relative to them, are one place of the record of another march:
 * just before a jump its steps may be shorter than the rounding of the position. */
static const double ONE_PLACE = 1e-12;

/* The length of the step of another march that contains a position of the base in a phase. */
static double length_like(const po_march *like, po_march_phase phase, double moved) {
  size_t low = like->first[phase]; /* the first record beyond is in (low, high] */
  size_t high = (phase < PO_UNLOADING ? like->first[phase + 1] : like->count) - 1;
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    if (like->records[middle].point.moved > moved * (1.0 + ONE_PLACE))
      high = middle;
    else
      low = middle;
  }
  const double length = like->records[high].length;
  return length > 0.0 ? fmax(length, ONE_PLACE * moved) : (double)INFINITY; /* 0: a jump */
}

static double next_length(const po_march *m) {
  const po_march *like = m->options.like;
  const double moved = m->held.point.moved;
  double length = m->cap;
  if (like)
    length = fmin(length, length_like(like, m->phase, moved) / m->options.halving);
  return isnan(m->end) ? length : fmin(length, m->end - moved);
}

/* -- The march -- */

/* Whether a step is one of the glassy body, for which the creep is frozen. */
static bool is_glassy(const po_march *m, const po_march_scene *scene) {
  const double least = m->speed > 0.0 ? m->options.terms->instant : 1.0;
  return scene->factor < (1.0 + GLASSY) * least;
}

/* One step, as long as its misfit allows. Status: PO_STEP_TOO_SMALL if the glassy body has no
 * equilibrium near: the contact jumps. */
static po_status advance(po_march *m, double *length) {
  double h = next_length(m);
  for (;;) {
    if (!m->is_here)
      po_march_bring(m);
    const po_march_scene scene = po_march_scene_of(m, h);
    const po_status status = po_march_solve(m, &scene);
    if (status && status != PO_NOT_CONVERGED)
      return status;
    const double aim = m->options.misfit / (m->options.halving * m->options.halving);
    const double misfit = status ? INFINITY : po_march_misfit(m);
    *length = h;
    if (misfit <= PO_REFUSED * aim) {
      po_march_finish(m, &scene);
      const double wish = PO_AIM * sqrt(aim / fmax(misfit, 1e-300));
      m->longest = fmax(m->longest, h);
      m->cap = h * (m->options.like && misfit <= aim ? PO_STEP_GROWTH : fmin(PO_STEP_GROWTH, wish));
      return PO_OK;
    }
    if (h < SHORTEST && is_glassy(m, &scene))
      return PO_STEP_TOO_SMALL;
    m->e->factorized = m->e->factorized && !status;
    h *= isfinite(misfit) ? fmax(PO_STEP_CUT, PO_AIM * sqrt(aim / misfit)) : PO_STEP_CUT;
  }
}

/* A jump changes the load, relative to 1 + its modulus, or the contact radius, relative to 1 + the
 * radius, by more than this; at a held load the approach, eps. Where all change less, the fold was
 * not passed yet, and the base is moved by more: at most by the length of a first step or, if that
 * is more, by the longest step of this phase, as long as it is within the tolerance of the
 * approach.
 */
static const double LEAST_JUMP = 0.01;

static bool is_jump(const po_march *m, const po_rate_point *before, const po_rate_point *after) {
  return (m->holds == PO_HOLD_LOAD && fabs(after->approach - before->approach) > LEAST_JUMP) ||
         fabs(after->load - before->load) > LEAST_JUMP * (1.0 + fabs(before->load)) ||
         fabs(after->contact_radius - before->contact_radius) >
             LEAST_JUMP * (1.0 + before->contact_radius);
}

/* A step, or a jump where there is none. */
static po_status step(po_march *m, bool *jumped) {
  double length;
  *jumped = false;
  po_status status = advance(m, &length);
  if (status != PO_STEP_TOO_SMALL)
    return status;
  const po_rate_point before = m->held.point;
  const double tolerance = m->options.misfit * m->options.misfit;
  const double longest =
      fmax(FIRST_LENGTH, fmin(m->longest, tolerance * (1.0 + fabs(before.approach))));
  for (;; length /= PO_STEP_CUT) {
    status = po_march_jump(m, length);
    *jumped = !status && is_jump(m, &before, &m->next.point);
    if (status || *jumped || length > longest)
      break;
    po_march_exchange(&m->held, &m->next);
    m->is_here = false;
  }
  m->cap = FIRST_LENGTH;
  if (*jumped)
    ++m->jumps;
  return status;
}

/* By how much a state is beyond the preload: >= 0 if its approach or its load is reached. */
static double beyond_preload(const po_march *m, const po_rate_point *p) {
  return fmax(p->approach - m->options.approach, p->load - m->options.load);
}

/* Distance from the preload, relative to 1 + the preload, at which loading ends; where the mesh
 * changes in the search, the load is discontinuous by as much as its error, and a limited number of
 * steps leaves that. A preload within NEAR_PRELOAD is held at its given value. */
static const double AT_PRELOAD = 1e-9, NEAR_PRELOAD = 1e-3;
enum { PRELOAD_STEPS = 12 };

/* Ends the step from `held` to m->next, which leads beyond the preload, at the preload, by the
 * Illinois method on its length. */
static po_status end_at_preload(po_march *m) {
  double low = 0.0, high = m->next.length;
  double below = beyond_preload(m, &m->held.point), beyond = beyond_preload(m, &m->next.point);
  const double scale = 1.0 + fmin(fabs(m->options.approach), fabs(m->options.load));
  int side = 0; /* of the last length that was tried */
  for (int k = 0; k < PRELOAD_STEPS && beyond > AT_PRELOAD * scale; ++k) {
    const double h = low + (high - low) * below / (below - beyond);
    po_march_bring(m);
    const po_march_scene scene = po_march_scene_of(m, h);
    const po_status status = po_march_solve(m, &scene);
    if (status)
      return status == PO_NOT_CONVERGED
                 ? po_fail(status, "the preload was not found: loading ended at approach %.6g",
                           m->held.point.approach)
                 : status;
    po_march_misfit(m);
    po_march_finish(m, &scene);
    const double now = beyond_preload(m, &m->next.point);
    if (fabs(now) <= AT_PRELOAD * scale)
      break;
    if (now > 0.0) {
      high = h, beyond = now;
      below *= side > 0 ? 0.5 : 1.0;
    } else {
      low = h, below = now;
      beyond *= side < 0 ? 0.5 : 1.0;
    }
    side = now > 0.0 ? 1 : -1;
  }
  return PO_OK;
}

/* Steps until the phase ends: at its end, at the preload, or by the visitor. */
static po_status run_phase(po_march *m) {
  const bool loads = m->phase == PO_LOADING;
  bool ended = loads && beyond_preload(m, &m->held.point) >= 0.0;
  while (!ended) {
    bool jumped;
    po_status status = step(m, &jumped);
    const bool reached = !status && loads && beyond_preload(m, &m->next.point) >= 0.0;
    if (reached && !jumped) /* a jump cannot be ended */
      status = end_at_preload(m);
    if (!status)
      status = po_march_watch_peak(m, jumped);
    if (!status)
      status = po_march_look(m, jumped);
    if (status)
      return status;
    accept(m);
    status = record(m, &m->held.point, jumped);
    if (status)
      return status;
    ended = m->options.visit(&m->held.point, m->phase, m->options.data) || reached ||
            m->held.point.moved >= m->end * (1.0 - AT_END);
  }
  return PO_OK;
}

/* Starts a phase at the state `held`. */
static po_status start_phase(po_march *m, po_march_phase phase, double direction, double speed,
                             double end) {
  po_march_state *s = &m->held;
  m->phase = phase;
  m->direction = direction;
  m->speed = speed;
  m->end = end;
  m->cap = FIRST_LENGTH;
  m->longest = 0.0;
  m->first[phase] = m->count;
  m->is_here = false;
  s->point.moved = s->length = 0.0;
  memset(po_march_field(s, PO_OF_RATE), 0, (PO_OF_INSTANT - PO_OF_RATE) * s->n * sizeof(double));
  return record(m, &s->point, false);
}

/* What dwells holds what was reached of the preload. Steps are in the shortest time. */
static po_status dwell(po_march *m) {
  const double speed = 1.0 / m->options.terms->term[0].time;
  po_status status = start_phase(m, PO_DWELLING, 0.0, speed, m->options.dwell * speed);
  if (status || m->options.dwell == 0.0)
    return status;
  const po_march_options *o = &m->options;
  const po_rate_point *p = &m->held.point;
  const bool by_load = p->load - o->load >= p->approach - o->approach;
  const double now = by_load ? p->load : p->approach, given = by_load ? o->load : o->approach;
  m->holds = by_load ? PO_HOLD_LOAD : PO_HOLD_APPROACH;
  m->held_value = fabs(now - given) < NEAR_PRELOAD * (1.0 + fabs(given)) ? given : now;
  m->orientation = 0;
  m->e->factorized = false;
  status = run_phase(m);
  m->holds = PO_HOLD_BASE;
  m->orientation = 0;
  m->e->factorized = false;
  return status;
}

static po_status load_and_dwell(po_march *m) {
  po_status status = start_phase(m, PO_LOADING, -1.0, m->options.load_speed, NAN);
  if (!status)
    m->options.visit(&m->held.point, PO_LOADING, m->options.data);
  if (!status)
    status = run_phase(m);
  if (!status)
    status = dwell(m);
  m->loading_jumps = m->jumps;
  return status;
}

po_status po_march_run(po_march *m) {
  po_status status = isnan(m->options.load_speed) ? PO_OK : load_and_dwell(m);
  if (status)
    return status;
  const double speed = m->options.speed;
  po_rate_point *p = &m->held.point;
  p->time = speed > 0.0 && isfinite(speed) ? 0.0 : (double)NAN;
  p->energy.work = p->energy.dissipated = p->energy.jumps = 0.0;
  status = start_phase(m, PO_UNLOADING, 1.0, speed, m->options.end);
  if (!status)
    m->options.visit(p, PO_UNLOADING, m->options.data);
  return status ? status : run_phase(m);
}

size_t po_march_steps(const po_march *m) {
  /* the states at which dwell and unloading begin have two records */
  return isnan(m->options.load_speed) ? m->count : m->count - 2;
}

size_t po_march_jumps(const po_march *m, bool unloading) {
  return unloading ? m->jumps - m->loading_jumps : m->loading_jumps;
}
