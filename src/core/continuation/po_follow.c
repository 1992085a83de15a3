#include "po_follow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_corrector.h"
#include "po_deadline.h"
#include "po_initial_gap.h"
#include "po_law.h"
#include "po_margins.h"
#include "po_memory.h"
#include "po_prediction.h"
#include "po_refine.h"

/* Solutions through which the predictor goes. */
enum { MARKS = 4 };

/* Length of the first step, relative to the distance to the parameter asked for. The first step
 * shows how the special point moves. */
static const double FIRST_PART = 0.02;
/* Length of a step, relative to the same distance, below which the special point is given up if the
 * step fails; and the same for the first step. Each attempt at that is a tenth of the one before:
 * the third is the last. */
static const double SHORTEST_PART = 0.1, SHORTEST_FIRST_PART = 0.025 * FIRST_PART;
/* The same of a fold, and of scenes of several units of length, at any step: nothing replaces the
 * special point if it is given up, and the scenes may be far apart. */
static const double SHORTEST_PART_OF_FOLD = 1e-6;
/* What a step of half the rest leaves by rounding, relative to it. A step of it would give two
 * marks of one parameter, and the predictor no sense. */
static const double ROUNDING = 1e-9;

/* A mark: the solution of the special point at one value of the parameter, and its scene. */
typedef struct {
  double at;
  double unit; /* of length */
  po_scene scene;
  po_solution point;
} mark;

struct po_follower {
  po_follow_options options;
  po_scene scene; /* at the present value of the parameter */
  double unit;    /* of its lengths */
  po_surface *surface;
  po_equilibrium *e;
  po_corrector c;
  po_event_kind of;
  mark marks[MARKS + 1]; /* ring buffer, with one element for the next mark */
  size_t latest, count;
  po_solution seed, spare;
  double slope; /* derivative of the rate that vanishes, along the arclength functional */
  double value[2];
  double step; /* length of the next attempt; INFINITY: the whole distance */
};

static mark *mark_of(po_follower *f, size_t back) {
  return &f->marks[(f->latest + MARKS + 1 - back) % (MARKS + 1)];
}

static mark *next_mark(po_follower *f) {
  return &f->marks[(f->latest + 1) % (MARKS + 1)];
}

/* The predictor in the parameter: the polynomial through the marks, in coordinates that move with
 * their contact edges. See doc/method.md, "Parameter continuation". */
typedef struct {
  size_t count;
  double at[MARKS];            /* the parameters of the marks, the latest first */
  po_solution_field of[MARKS]; /* their solutions */
  double unit[MARKS];          /* their units of length, in the present one */
  double weight[MARKS];
  po_moving_edges edges; /* contact edges of the latest mark that move the coordinates */
  double shift[PO_MOST_MOVING_EDGES];       /* from these to the predicted edges */
  double back[MARKS][PO_MOST_MOVING_EDGES]; /* from these to the edges of each mark */
  size_t edge; /* the contact edge beyond the radius where the gap was last needed */
} predictor;

static void add_mark(predictor *f, const mark *m, double unit) {
  f->at[f->count] = m->at;
  f->unit[f->count] = m->unit / unit;
  f->of[f->count++] = (po_solution_field){&m->point, &m->scene, 0};
}

/* The weights of the marks in Lagrange's polynomial at a parameter. */
static void weigh(predictor *f, double at) {
  for (size_t i = 0; i < f->count; ++i) {
    f->weight[i] = 1.0;
    for (size_t k = 0; k < f->count; ++k)
      if (k != i)
        f->weight[i] *= (at - f->at[k]) / (f->at[i] - f->at[k]);
  }
}

/* Predicts the shifts of the contact edges of the latest mark: of all, or of the outermost only.
 * Returned: whether the coordinates can move by them. */
static bool move(po_follower *of, bool all, double at, predictor *f) {
  const po_moving_edges *latest = &mark_of(of, 0)->point.edges;
  *f = (predictor){.edges = *latest};
  if (!all && latest->count > 0) {
    f->edges.count = 1;
    f->edges.at[0] = latest->at[latest->count - 1];
  }
  for (size_t k = 0; k < f->edges.count; ++k)
    f->edges.at[k] *= mark_of(of, 0)->unit / of->unit;
  for (size_t i = 0; i < of->count; ++i) {
    const mark *m = mark_of(of, i);
    const po_moving_edges *edges = &m->point.edges;
    if (all ? edges->all != latest->all : (edges->count == 0) != (latest->count == 0))
      break;
    double *back = f->back[f->count];
    for (size_t k = 0; k < f->edges.count; ++k)
      back[k] =
          edges->at[edges->count - f->edges.count + k] * (m->unit / of->unit) - f->edges.at[k];
    if (!po_edge_may_relate(&f->edges, back))
      break;
    add_mark(f, m, of->unit);
  }
  weigh(f, at);
  for (size_t i = 0; i < f->count; ++i)
    for (size_t k = 0; k < f->edges.count; ++k)
      f->shift[k] += f->weight[i] * f->back[i][k];
  return f->count == of->count && po_edge_may_move(&f->edges, f->shift);
}

/* Predicts at the parameter `at`. If the number of contact edges differs or the strain is too
 * large, as where a groove closes, only the outermost edge moves the coordinates; the gap is flat
 * at the others. Returned: false if the strain is too large even then. */
static bool predict(po_follower *of, double at, predictor *f) {
  return move(of, true, at, f) || move(of, false, at, f);
}

/* The same in coordinates that do not move, for short steps. Where a contact edge closes or forms
 * at the axis it moves ever faster, and the gap is flat there. */
static void predict_still(po_follower *of, double at, predictor *f) {
  *f = (predictor){.count = 0};
  for (size_t i = 0; i < of->count; ++i)
    add_mark(f, mark_of(of, i), of->unit);
  weigh(f, at);
}

/* The gap of a mark; outside its domain the undeformed gap. */
static double gap_of(po_solution_field *of, double r) {
  return r < of->p->domain ? po_solution_gap(of, r)
                           : po_initial_gap(of->scene, r) - po_solution_approach(of->p);
}

/* The predicted gap H at a radius, eps; above -1. Given: data, a predictor. */
static double predicted_gap(void *data, double r) {
  predictor *f = data;
  const po_edge_place origin = po_edge_origin(&f->edges, f->shift, r, f->edge);
  f->edge = origin.outer;
  double gap = 0.0;
  for (size_t i = 0; i < f->count; ++i)
    gap += f->weight[i] * f->unit[i] *
           gap_of(&f->of[i], (origin.r + po_edge_displacement(&origin, f->back[i])) / f->unit[i]);
  return po_law_expected_gap(&f->of[0].scene->law, gap);
}

/* The predicted state at the nodes of an equilibrium. Given: core, the number of nodes inside the
 * domain. Returned: state, n + 1. */
static void predicted_state(predictor *f, const po_equilibrium *e, size_t core, double *state) {
  const size_t n = e->n;
  for (size_t j = 0; j < core; ++j)
    state[j] = predicted_gap(f, e->surface->node[j]);
  for (size_t back = 0; back <= n - core; ++back) { /* from the approach inwards */
    double value = back > 0 ? e->initial_gap[n - back] : 0.0;
    for (size_t i = 0; i < f->count; ++i) {
      const po_solution *p = f->of[i].p;
      value += f->weight[i] * f->unit[i] * (back > 0 ? p->deflection[p->n - back] : p->state[p->n]);
    }
    state[n - back] = value;
  }
}

/* Sets the unit of length of a parameter. */
static void set_unit(po_follower *f, double at) {
  f->unit = f->options.unit_at ? f->options.unit_at(f->options.data, at) : 1.0;
}

/* Sets the scene of a parameter, on the current mesh. */
static void set_scene(po_follower *f, double at) {
  f->options.scene_at(f->options.data, at, &f->scene);
  po_surface_resize(f->surface, f->options.domain_of(f->options.data, &f->scene));
  po_equilibrium_rescale(f->e);
  po_equilibrium_remesh(f->e);
}

/* Adapts the weight of approach and load in the arclength functional to the outermost contact edge
 * of a solution, given in its unit of length. */
static void weigh_edge(po_follower *f, const po_solution *p, double unit) {
  if (!f->options.unit_at)
    return;
  const size_t edges = p->edges.count;
  const double suits =
      edges > 0 ? po_arclength_share(f->e, p->edges.at[edges - 1] * unit / f->unit) : 1.0;
  f->e->narrow = suits < PO_ARCLENGTH_NARROW;
  f->e->share = f->e->by_krylov && edges > 1 ? 1.0 : suits;
}

po_status po_follow_create(const po_follow_options *options, double at, po_follower **follower) {
  po_follower *f = po_allocate(1, sizeof *f);
  *follower = f;
  if (!f)
    return PO_NO_MEMORY;
  f->options = *options;
  options->scene_at(options->data, at, &f->scene);
  po_status status = po_surface_create_panels(
      &f->scene, options->domain_of(options->data, &f->scene), 1 /* the coarsest */, &f->surface);
  const size_t capacity = status ? 0 : f->surface->capacity;
  if (!status)
    status = po_equilibrium_create(&f->scene, f->surface, &f->e);
  if (!status)
    status = po_corrector_allocate(&f->c, f->e, options->allowed);
  for (size_t k = 0; k <= MARKS && !status; ++k)
    status = po_solution_allocate(&f->marks[k].point, capacity, &f->c.arrays);
  if (!status)
    status = po_solution_allocate(&f->seed, capacity, &f->c.arrays);
  if (!status)
    status = po_solution_allocate(&f->spare, capacity, &f->c.arrays);
  if (status) {
    po_follow_destroy(f);
    *follower = NULL;
    return status;
  }
  f->e->precision = options->precision;
  return PO_OK;
}

void po_follow_destroy(po_follower *f) {
  if (!f)
    return;
  po_arena_free(&f->c.arrays);
  po_equilibrium_destroy(f->e);
  po_surface_destroy(f->surface);
  free(f);
}

/* The special point near the guess, on a mesh that resolves it. Given: seed, whose arclength
 * functional is that of the guess. */
static po_status locate(po_follower *f, double *slope, double value[2], po_solution *out) {
  const po_solution *from = &f->seed;
  for (int mesh = 0; mesh < PO_MOST_MESHES_A_POINT; ++mesh, from = &f->spare) {
    po_status status = po_refine_locate(&f->c, from, 0.0, f->of, slope, out, value);
    if (status || po_corrector_is_resolved(&f->c, out))
      return status;
    status = po_corrector_follow_solved(&f->c, out, &f->spare);
    if (status)
      return status;
  }
  return PO_NOT_CONVERGED;
}

static void accept(po_follower *f, double at) {
  mark *next = next_mark(f);
  next->at = at;
  next->unit = f->unit;
  next->scene = f->scene;
  f->latest = (f->latest + 1) % (MARKS + 1);
  f->count += f->count < MARKS;
}

po_status po_follow_begin(po_follower *f, const po_solution *special, po_event_kind of, double at) {
  f->of = of;
  f->count = 0;
  f->step = INFINITY;
  f->slope = NAN;
  set_unit(f, at);
  set_scene(f, at);
  po_solution_copy(special, &f->seed);
  weigh_edge(f, &f->seed, f->unit);
  if (f->options.unit_at && f->seed.share != f->e->share)
    po_solution_reweigh(&f->seed, f->e->share / f->seed.share);
  po_status status = po_corrector_mesh(&f->c, f->seed.panels);
  if (status)
    return status;
  f->seed.domain = f->surface->core_radius; /* that of the trace may differ: it is scaled */
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
  f->seed.domain = f->surface->core_radius;
  po_equilibrium_evaluate(f->e, f->c.guess);
  po_arclength_coordinates(f->seed.arclength, f->e, f->c.guess, f->seed.coordinate);
  memcpy(f->seed.rate, latest->rate, f->seed.coordinates * sizeof *f->seed.rate);
  if (latest->share == f->e->share)
    return;
  for (size_t i = 0; i < 2; ++i)
    f->seed.rate[i] *= f->e->share / latest->share;
  const double length = sqrt(po_arclength_along(f->seed.coordinates, f->seed.rate, f->seed.rate));
  for (size_t i = 0; i < f->seed.coordinates; ++i)
    f->seed.rate[i] /= length;
}

/* One attempt at a step. Given: last, whether the special point is given up if the attempt fails.
 * Returned: the error of the predictor, if a solution was found. */
static po_status try_step(po_follower *f, double at, bool last, double *error) {
  predictor p;
  set_unit(f, at);
  if (!predict(f, at, &p)) {
    if (!last)
      return PO_NOT_CONVERGED;
    predict_still(f, at, &p);
  }
  set_scene(f, at);
  weigh_edge(f, &mark_of(f, 0)->point, mark_of(f, 0)->unit);
  po_panels *const panels = f->surface->draft;
  po_panels_copy(mark_of(f, 0)->point.panels, panels);
  const po_gap_field predicted = {predicted_gap, &p};
  po_status status = po_corrector_adapt(&f->c, &predicted, panels);
  if (!status)
    status = po_corrector_mesh(&f->c, panels);
  if (status)
    return status;
  predicted_state(&p, f->e, po_corrector_moving_nodes(&f->c), f->c.guess);
  seed_from_guess(f);
  double slope = f->slope, value[2];
  po_solution *out = &next_mark(f)->point;
  status = locate(f, &slope, value, out);
  if (status)
    return status;
  *error = po_prediction_error(&predicted, &p.of[0].scene->law, NULL, out);
  if (!(*error < PO_REFUSED * PO_NEAR_SOLUTION) || !(slope * f->slope > 0.0))
    return PO_NOT_CONVERGED;
  f->slope = slope;
  memcpy(f->value, value, sizeof f->value);
  return PO_OK;
}

po_status po_follow_to(po_follower *f, double at) {
  const double whole = at - mark_of(f, 0)->at;
  double left = whole;
  while (left != 0.0) {
    const po_status stopped = po_deadline_check();
    if (stopped == PO_OUT_OF_TIME)
      return po_fail(
          PO_OUT_OF_TIME,
          "the time limit was reached before the special point was followed to the scene; it is at "
          "approach %.6g, load %.6g",
          f->value[0] * po_scene_length_unit(&f->scene),
          f->value[1] * po_scene_load_unit(&f->scene));
    if (stopped)
      return stopped;
    const double most = f->count == 1 ? fmin(f->step, FIRST_PART * fabs(whole)) : f->step;
    const bool last = fabs(left) <= (1.0 + ROUNDING) * most;
    const double step = last ? left : copysign(most, left);
    const double to = last ? at : mark_of(f, 0)->at + step;
    const double part = f->of == PO_OF_APPROACH || f->options.unit_at ? SHORTEST_PART_OF_FOLD
                        : f->count == 1                               ? SHORTEST_FIRST_PART
                                                                      : SHORTEST_PART;
    const bool shortest = fabs(step) < part * fabs(whole);
    double error = INFINITY;
    const po_status tried = try_step(f, to, shortest, &error);
    if (tried == PO_NO_MEMORY)
      return tried;
    if (tried) {
      po_message_clear();
      f->c.trouble = PO_OK;
      if (shortest && !po_deadline_check())
        return po_fail(
            PO_NOT_FOUND,
            "the special point at approach %.6g, load %.6g ends before the scene is reached",
            f->value[0] * po_scene_length_unit(&f->scene),
            f->value[1] * po_scene_load_unit(&f->scene));
      f->step = (f->count == 1 ? 0.1 : 0.5) * fabs(step);
      continue;
    }
    accept(f, to);
    if (f->count > 2)
      f->step = error < PO_NEAR_SOLUTION ? fmax(2.0 * fabs(step), f->step) : fabs(step);
    left = last ? 0.0 : at - to;
  }
  return PO_OK;
}

po_branch_point po_follow_point(po_follower *f, bool judged) {
  po_refined r = {
      .point = &mark_of(f, 0)->point, .value = {f->value[0], f->value[1]}, .error = {NAN, NAN}};
  const double enough = f->of == PO_OF_LOAD ? f->options.sharpness * fabs(f->value[1]) : INFINITY;
  const po_refinement how = {f->of, f->slope, enough, {&f->spare, &f->seed}};
  if (judged && po_refine(&f->c, &how, &r)) {
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
                           .turn = f->slope,
                           .solution = p,
                           .best = r.finer ? p : NULL,
                           .finer = r.finer};
}

const po_surface *po_follow_surface(const po_follower *f) {
  return f->surface;
}

po_work po_follow_work(const po_follower *f) {
  po_work work = f->e->work;
  work.kernel_evaluations = f->surface->kernel_evaluations;
  return work;
}
