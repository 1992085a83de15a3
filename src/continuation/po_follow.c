#include "po_follow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_corrector.h"
#include "po_memory.h"
#include "po_parameter_predictor.h"
#include "po_refine.h"
#include "po_watch.h"

enum { ROOT_LEVEL = 3 };

/* Greatest error of the predictor, relative to 1 + H, with which a step is accepted; and the error
 * below which the next step is longer. */
static const double GREATEST_PREDICTOR_ERROR = 0.4, SMALL_PREDICTOR_ERROR = 0.1;
/* Length of the first step, relative to the distance to the parameter asked for. The first step
 * shows how the special point moves. */
static const double FIRST_PART = 0.02;
/* Length of a step, relative to the same distance, below which the special point is given up if the
 * step fails; and the same for the first step. Each attempt at that is a tenth of the one before:
 * the third is the last. */
static const double SHORTEST_PART = 0.1, SHORTEST_FIRST_PART = 0.025 * FIRST_PART;

struct po_follower {
  po_follow_options options;
  po_scene scene; /* at the present value of the parameter */
  po_adaptive *adaptive;
  po_equilibrium *e;
  po_corrector c;
  po_resolution resolution;
  po_event_kind of;
  po_predictor_point
      mark[PO_PREDICTOR_MARKS + 1]; /* ring buffer, with one element for the next mark */
  size_t latest, count;
  po_solution seed, spare;
  double slope; /* derivative of the rate that vanishes, along the arclength functional */
  double value[2];
  double step; /* length of the next attempt; INFINITY: the whole distance */
};

static po_predictor_point *mark_of(po_follower *f, size_t back) {
  return &f->mark[(f->latest + PO_PREDICTOR_MARKS + 1 - back) % (PO_PREDICTOR_MARKS + 1)];
}

static po_predictor_point *next_mark(po_follower *f) {
  return &f->mark[(f->latest + 1) % (PO_PREDICTOR_MARKS + 1)];
}

/* Sets the scene of a parameter, on the current mesh. */
static void set_scene(po_follower *f, double at) {
  f->options.scene_at(f->options.data, at, &f->scene);
  po_adaptive_resize(f->adaptive, f->options.domain_of(&f->scene));
  f->c.domain = f->resolution.domain = po_adaptive_domain(f->adaptive);
  po_equilibrium_rescale(f->e);
  po_equilibrium_remesh(f->e);
}

po_status po_follow_create(const po_follow_options *options, double at, po_follower **follower) {
  po_follower *f = po_allocate(1, sizeof *f);
  *follower = f;
  if (!f)
    return PO_NO_MEMORY;
  f->options = *options;
  options->scene_at(options->data, at, &f->scene);
  po_status status =
      po_adaptive_create(&f->scene, options->domain_of(&f->scene), ROOT_LEVEL, &f->adaptive);
  const size_t capacity = status ? 0 : po_adaptive_capacity(f->adaptive);
  if (!status)
    status = po_equilibrium_create(&f->scene, po_adaptive_surface(f->adaptive), capacity, &f->e);
  if (!status)
    status = po_corrector_allocate(&f->c, f->e, f->adaptive);
  for (size_t k = 0; k <= PO_PREDICTOR_MARKS && !status; ++k)
    status = po_solution_allocate(&f->mark[k].point, capacity);
  if (!status)
    status = po_solution_allocate(&f->seed, capacity);
  if (!status)
    status = po_solution_allocate(&f->spare, capacity);
  if (status) {
    po_follow_destroy(f);
    *follower = NULL;
    return status;
  }
  f->e->precision = options->precision;
  f->resolution = (po_resolution){f->e, f->c.domain, options->allowed};
  return PO_OK;
}

void po_follow_destroy(po_follower *f) {
  if (!f)
    return;
  for (size_t k = 0; k <= PO_PREDICTOR_MARKS; ++k)
    po_solution_free(&f->mark[k].point);
  po_solution_free(&f->seed);
  po_solution_free(&f->spare);
  po_corrector_free(&f->c);
  po_equilibrium_destroy(f->e);
  po_adaptive_destroy(f->adaptive);
  free(f);
}

/* Makes panels that resolve a field the current mesh, adapted from other panels. */
static po_status mesh_for(po_follower *f, const po_panels *from, const po_gap_field *field) {
  const po_resolution margin = po_resolution_for_mesh(&f->resolution);
  po_panels *const panels = po_adaptive_draft(f->adaptive);
  po_panels_copy(from, panels);
  const po_status status = po_resolution_panels(&margin, field, panels);
  return status ? status : po_corrector_mesh(&f->c, panels);
}

/* The special point near the guess, on a mesh that resolves it. Given: seed, whose arclength
 * functional is that of the guess. */
static po_status locate(po_follower *f, double *slope, double value[2], po_solution *out) {
  const po_solution *from = &f->seed;
  for (int mesh = 0; mesh < PO_MOST_MESHES_A_POINT; ++mesh) {
    po_status status = po_refine_locate(&f->c, from, f->of, slope, out, value);
    if (status || po_resolution_excess(&f->resolution, out->panels, out->state) <= 1.0)
      return status;
    po_solution_copy(out, &f->spare);
    from = &f->spare;
    po_solution_field solved = {from, &f->scene, f->c.domain, 0};
    status = mesh_for(f, from->panels, &(po_gap_field){po_solution_gap, &solved});
    if (status)
      return status;
    po_corrector_guess(&f->c, from);
  }
  return PO_NOT_CONVERGED;
}

static void accept(po_follower *f, double at) {
  po_predictor_point *next = next_mark(f);
  next->at = at;
  next->scene = f->scene;
  next->domain = f->c.domain;
  f->latest = (f->latest + 1) % (PO_PREDICTOR_MARKS + 1);
  f->count += f->count < PO_PREDICTOR_MARKS;
}

po_status po_follow_begin(po_follower *f, const po_solution *special, po_event_kind of, double at) {
  f->of = of;
  f->count = 0;
  f->step = INFINITY;
  f->slope = NAN;
  set_scene(f, at);
  po_solution_copy(special, &f->seed);
  po_status status = po_corrector_mesh(&f->c, f->seed.panels);
  if (status)
    return status;
  po_corrector_guess(&f->c, &f->seed);
  status = locate(f, &f->slope, f->value, &next_mark(f)->point);
  if (!status)
    accept(f, at);
  return status;
}

/* Sets the arclength functional by which the special point is located: through the guess, in the
 * direction of the latest mark. */
static void seed_from_guess(po_follower *f) {
  const po_solution *latest = &mark_of(f, 0)->point;
  po_equilibrium_evaluate(f->e, f->c.guess);
  po_arclength_coordinates(f->seed.arclength, f->e, f->c.guess, f->seed.coordinate);
  memcpy(f->seed.rate, latest->rate, f->seed.coordinates * sizeof *f->seed.rate);
}

/* One attempt at a step. Given: last, whether the special point is given up if the attempt fails.
 * Returned: the error of the predictor, if a solution was found. */
static po_status try_step(po_follower *f, double at, bool last, double *error) {
  const po_predictor_point *marks[PO_PREDICTOR_MARKS];
  po_predictor predictor;
  for (size_t k = 0; k < f->count; ++k)
    marks[k] = mark_of(f, k);
  if (!po_predictor_make(marks, f->count, at, &predictor)) {
    if (!last)
      return PO_NOT_CONVERGED;
    po_predictor_still(marks, f->count, at, &predictor);
  }
  set_scene(f, at);
  po_status status =
      mesh_for(f, marks[0]->point.panels, &(po_gap_field){po_predictor_gap, &predictor});
  if (status)
    return status;
  po_predictor_state(&predictor, f->e, po_corrector_moving_nodes(&f->c), f->c.guess);
  seed_from_guess(f);
  double slope = f->slope, value[2];
  po_solution *out = &next_mark(f)->point;
  status = locate(f, &slope, value, out);
  if (status)
    return status;
  *error = po_predictor_error(&predictor, out);
  if (!(*error < GREATEST_PREDICTOR_ERROR) || !(slope * f->slope > 0.0))
    return PO_NOT_CONVERGED;
  f->slope = slope;
  memcpy(f->value, value, sizeof f->value);
  return PO_OK;
}

static po_status follow_to(po_follower *f, double at) {
  const double whole = at - mark_of(f, 0)->at;
  double left = whole;
  while (left != 0.0) {
    const po_status stopped = po_watch_look();
    if (stopped == PO_OUT_OF_TIME)
      return po_fail(
          PO_OUT_OF_TIME,
          "the time limit was reached before the special point was followed to the scene; it is at "
          "approach %.6g, load %.6g",
          f->value[0], f->value[1] * po_scene_load_unit(&f->scene));
    if (stopped)
      return stopped;
    const double most = f->count == 1 ? fmin(f->step, FIRST_PART * fabs(whole)) : f->step;
    const bool last = fabs(left) <= most;
    const double step = last ? left : copysign(most, left);
    const double to = last ? at : mark_of(f, 0)->at + step;
    const bool shortest =
        fabs(step) < (f->count == 1 ? SHORTEST_FIRST_PART : SHORTEST_PART) * fabs(whole);
    double error = INFINITY;
    if (try_step(f, to, shortest, &error)) {
      po_message_clear();
      f->c.trouble = PO_OK;
      if (shortest && !po_watch_look())
        return po_fail(
            PO_NOT_FOUND,
            "the special point at approach %.6g, load %.6g ends before the scene is reached",
            f->value[0], f->value[1] * po_scene_load_unit(&f->scene));
      f->step = (f->count == 1 ? 0.1 : 0.5) * fabs(step);
      continue;
    }
    accept(f, to);
    if (f->count > 2)
      f->step = error < SMALL_PREDICTOR_ERROR ? fmax(2.0 * fabs(step), f->step) : fabs(step);
    left = last ? 0.0 : at - to;
  }
  return PO_OK;
}

po_status po_follow_to(po_follower *f, double at, double deadline) {
  const po_watch before = po_watch_begin(NULL, deadline);
  const po_status status = follow_to(f, at);
  po_watch_end(before);
  return status;
}

po_branch_point po_follow_point(po_follower *f, bool judged) {
  po_refined r = {
      .point = &mark_of(f, 0)->point, .value = {f->value[0], f->value[1]}, .error = {NAN, NAN}};
  const double enough = f->of == PO_OF_LOAD ? f->options.sharpness * fabs(f->value[1]) : INFINITY;
  const po_refinement how = {f->of, f->slope, enough, {&f->spare, &f->seed}};
  if (judged && po_refine(&f->c, &f->resolution, &how, &r)) {
    r.error[0] = r.error[1] = NAN;
    r.finer = NULL;
  }
  f->c.trouble = PO_OK;
  const po_solution *p = r.point;
  const bool rising = f->slope < 0.0;
  return (po_branch_point){.kind = f->of == PO_OF_LOAD
                                       ? (rising ? PO_POINT_LOAD_MAX : PO_POINT_LOAD_MIN)
                                       : (rising ? PO_POINT_APPROACH_MAX : PO_POINT_APPROACH_MIN),
                           .position = NAN,
                           .approach = r.value[0],
                           .load = r.value[1],
                           .approach_error = r.error[0],
                           .load_error = r.error[1],
                           .approach_rate = p->tangent[p->n],
                           .load_rate = p->load_rate,
                           .n = p->core,
                           .node = p->node,
                           .gap = p->state,
                           .solution = p,
                           .best = r.finer ? p : NULL,
                           .finer = r.finer};
}

double po_follow_domain(const po_follower *f) {
  return po_adaptive_domain(f->adaptive);
}

po_work po_follow_work(const po_follower *f) {
  po_work work = f->e->work;
  work.kernel_evaluations = po_adaptive_surface(f->adaptive)->kernel_evaluations;
  return work;
}
