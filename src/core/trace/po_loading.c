/* What a test along the traced branch gives: the preload that belongs to the pull-off, the greatest
 * pull-off force of all preloads, staircases, and loops of loading and unloading. */

#include <math.h>

#include "po_collector.h"
#include "po_loop.h"
#include "po_margins.h"
#include "po_refine.h"
#include "po_staircase.h"
#include "po_trace.h"

/* Where the trace begins at the farthest for a soft spring, eps. A sphere under Lennard-Jones
 * forces is attracted by 2e-10 pi w R there; what other laws and profiles leave is in the stated
 * error. */
static const double FARTHEST = -1e5;

/* The special point at a position on the branch; NULL if there is none. */
static const po_special_point *mark_at(const po_result *o, double position) {
  for (size_t k = 0; k < o->fold_count; ++k)
    if (o->folds[k].position == position)
      return &o->folds[k];
  for (size_t k = 0; k < o->extremum_count; ++k)
    if (o->extrema[k].position == position)
      return &o->extrema[k];
  return NULL;
}

/* The greatest errors of the special points; NAN if none was estimated. */
static po_path_error greatest_error(const po_result *o) {
  po_path_error e = {NAN, NAN};
  for (size_t k = 0; k < o->fold_count + o->extremum_count; ++k) {
    const po_special_point *mark =
        k < o->fold_count ? &o->folds[k] : &o->extrema[k - o->fold_count];
    e.approach = fmax(e.approach, mark->approach_error); /* ignores NAN */
    e.load = fmax(e.load, mark->load_error);
  }
  return e;
}

/* Gives a state at the position of a special point what is stated of that point: a state has one
 * load, approach and energy. Returned: the special point; NULL: the state is at none. */
static const po_special_point *take_special_point(const po_result *o, po_path_state *state) {
  const po_special_point *mark = mark_at(o, state->position);
  if (!mark)
    return NULL;
  state->approach = mark->approach;
  state->load = mark->load;
  state->contact_radius = mark->contact_radius;
  if (!isnan(mark->energy_error))
    state->energy = mark->energy;
  return mark;
}

/* The same. Returned: the stated errors of the special point. The error of any other state, and of
 * a special point without an error, is the greatest error of the special points plus the distance
 * of the curve from its interpolation. Given: a result with special points. */
static po_path_error state_of_special_point(const po_request *request, const po_result *o,
                                            po_path_state *state) {
  const po_special_point *mark = take_special_point(o, state);
  if (mark && !isnan(mark->load_error))
    return (po_path_error){mark->approach_error, mark->load_error};
  const po_path_error e = greatest_error(o);
  const double miss = po_estimate_miss(request);
  return (po_path_error){e.approach + miss, e.load + miss};
}

/* Where jumps begin: the errors of approach and load, and of the energy. */
typedef struct {
  po_path_error place;
  double energy;
} beginning;

/* That of jumps from any special points of the trace, as they were traced. */
static beginning from_any(const po_estimate *greatest) {
  return (beginning){{greatest->traced_approach_error, greatest->traced_load_error},
                     greatest->traced_energy_error};
}

/* Bound of the error of the energy lost in jumps. */
static double loss_error(const po_request *request, const beginning *from, po_control control,
                         const po_loss *loss) {
  const double place = po_held(control, from->place.approach, from->place.load);
  const double precision = po_trace_precision(request->mesh.tolerance);
  if (isnan(loss->energy)) /* unbounded */
    return NAN;
  return loss->moved * place + loss->of_held + PO_SAFETY * loss->doubt.interpolated +
         loss->doubt.of_points + precision * loss->size + (double)loss->jumps * from->energy;
}

/* A jump loses no energy below 0: what is computed below it, within the error, is 0. */
static double at_least_zero(double lost, double error) {
  return lost < 0.0 && -lost <= error ? 0.0 : lost;
}

static void state_errors(const po_request *request, const po_result *o, const po_estimate *greatest,
                         po_staircase *s) {
  for (size_t k = 0; k < s->count; ++k) {
    po_step *step = &s->step[k];
    step->preload_error = state_of_special_point(request, o, &step->preload);
    if (po_is_spring(s->control) && !mark_at(o, step->preload.position))
      step->preload_error = (po_path_error){NAN, NAN};
    step->pull_off_error = state_of_special_point(request, o, &step->pull_off);
    state_of_special_point(request, o, &step->until);
    for (size_t c = 0; c < step->cycle_count; ++c) {
      po_cycle *cycle = &step->cycle[c];
      state_of_special_point(request, o, &cycle->preload);
      const beginning from = from_any(greatest);
      cycle->energy_error = loss_error(request, &from, s->control, &cycle->loss);
      cycle->loss.energy = at_least_zero(cycle->loss.energy, cycle->energy_error);
    }
  }
}

static po_preload pressed(const po_path_state *state) {
  return (po_preload){state->approach, state->load};
}

static void read_pull_off(const po_staircase *s, double position, po_result *o) {
  o->pull_off.pressed = o->pull_off.until = (po_preload){NAN, NAN};
  for (size_t k = s->count; k-- > 0;)
    if (s->step[k].pull_off.position == position) {
      o->pull_off.pressed = pressed(&s->step[k].preload);
      o->pull_off.until = s->step[k].open ? (po_preload){NAN, NAN} : pressed(&s->step[k].until);
    }
}

static void read_any(const po_staircase *s, po_result *o) {
  const po_step *step = po_staircase_greatest(s);
  o->pull_off_any.searched = pressed(&s->reached);
  if (!step)
    return;
  o->pull_off_any.is_known = true;
  o->pull_off_any.force = fabs(step->pull_off.load);
  o->pull_off_any.approach = step->pull_off.approach;
  o->pull_off_any.force_error = step->pull_off_error.load;
  o->pull_off_any.approach_error = step->pull_off_error.approach;
  o->pull_off_any.pressed = pressed(&step->preload);
}

/* The position of the pull-off on the branch. */
static double pull_off_position(const po_result *o) {
  for (size_t k = 0; k < o->extremum_count && o->has_pull_off; ++k)
    if (o->extrema[k].load == -o->pull_off.force && o->extrema[k].approach == o->pull_off.approach)
      return o->extrema[k].position;
  return NAN;
}

/* The load at the stable equilibrium of the branch with the greatest tension, including equilibria
 * to which only a harder preload may lead. At a special point it is the stated load: that of the
 * points of the branch has the error of the mesh of the trace, which may exceed the stated one. */
static double deepest_stable(const po_path *path, const po_result *o) {
  const po_curve_point *deepest = NULL;
  for (size_t k = 0; k < path->count; ++k)
    if (po_stable_is(path, PO_DISPLACEMENT_CONTROL, k) &&
        (!deepest || path->point[k].load < deepest->load))
      deepest = &path->point[k];
  const po_special_point *mark = deepest ? mark_at(o, deepest->position) : NULL;
  return mark ? mark->load : deepest ? deepest->load : INFINITY;
}

/* Whether no harder preload gives a greater pull-off force. The trace of a rigid wavy sphere is
 * complete from the approach at which the repulsion of the central crest exceeds all attraction.
 * The load of a smooth sphere, rigid or not, has no minimum under compression. */
static bool is_complete(const po_collector *collector, const po_path *path) {
  const po_scene *scene = &collector->request->scene;
  const po_result *o = collector->result;
  const double load = -o->pull_off_any.force;
  if (deepest_stable(path, o) < load - o->pull_off_any.force_error)
    return false;
  if (o->rigid && !po_scene_is_simple(scene))
    return o->ended.approach >= po_trace_rigid_end(scene, 0.0);
  return po_stopping_is_complete(&collector->stopping, load);
}

/* The preload of the pull-off, the greatest pull-off of all preloads, and the staircases with their
 * errors if they are wanted. Status: PO_NO_MEMORY. */
static po_status read_pressed(const po_collector *collector, const po_path *path) {
  const po_request *request = collector->request;
  po_result *o = collector->result;
  const po_staircase *s = &o->staircase.of[0];
  o->has_staircases = request->want & PO_WANT_PRELOAD;
  const po_status status =
      po_staircases_read(path, o->has_staircases ? request->stiffness : (double)NAN, &o->staircase);
  if (status)
    return status;
  for (int k = 0; k < PO_TESTS; ++k)
    state_errors(request, o, &collector->special.greatest, &o->staircase.of[k]);
  read_pull_off(s, pull_off_position(o), o);
  read_any(s, o);
  o->pull_off_any.complete = o->pull_off_any.is_known && is_complete(collector, path);
  return PO_OK;
}

/* The greatest error of the energies of the points of the path beside a state. */
static double energy_error_at(const po_path *path, const po_path_state *state) {
  size_t k = 0;
  if (!isfinite(state->position))
    return 0.0; /* separated */
  while (k + 2 < path->count && path->point[k + 1].position <= state->position)
    ++k;
  return fmax(path->point[k].energy_error, path->point[k + 1].energy_error);
}

/* Where a jump begins: apart, which is exact, at a special point as it is stated, or between those.
 */
static beginning beginning_of(const po_collector *collector, const po_jump *jump,
                              const po_special_point *mark) {
  if (!isfinite(jump->before.position))
    return (beginning){{0.0, 0.0}, 0.0};
  if (mark && !isnan(mark->load_error) && !isnan(mark->energy_error))
    return (beginning){{mark->approach_error, mark->load_error}, mark->energy_error};
  return from_any(&collector->special.greatest);
}

/* A jump from where it is stated to begin to where it then ends, and its error. */
static void read_jump(const po_collector *collector, const po_path *path, po_control control,
                      po_jump *jump) {
  const po_request *request = collector->request;
  po_path_state *before = &jump->before, *after = &jump->after;
  const double held = po_held(control, before->approach, before->load);
  const po_special_point *mark = take_special_point(collector->result, before);
  const double now = po_held(control, before->approach, before->load);
  if (mark && isfinite(after->position))
    *after = po_path_moved(path, control, *after, now - held);
  else if (mark)
    *after = po_stable_apart(control, now);
  po_loss loss = po_loss_of_jump(control, before, after, jump->doubt);
  const bool apart = !isfinite(before->position) || !isfinite(after->position);
  if (apart && po_scene_has_infinite_energy(&request->scene))
    loss.energy = NAN; /* energies are not relative to the bodies apart */
  const beginning from = beginning_of(collector, jump, mark);
  jump->energy_lost_error = loss_error(request, &from, control, &loss);
  jump->energy_lost = at_least_zero(loss.energy, jump->energy_lost_error);
}

/* The error of the energy of a state of a loop. */
static double state_energy_error(const po_result *o, const po_path *path,
                                 const po_path_state *state) {
  const po_special_point *mark = mark_at(o, state->position);
  return mark && !isnan(mark->energy_error) ? mark->energy_error : energy_error_at(path, state);
}

/* The rows of a loop whose jumps were read. */
static void read_rows(const po_result *o, po_loop *loop) {
  for (size_t k = 0; k < loop->row_count; ++k)
    take_special_point(o, &loop->row[k].state);
  po_loop_rows_end(loop);
}

/* A loop whose states at special points are as these are stated, and its errors. The work of a
 * closed loop is the energy that its jumps lose, computed by another way. */
static void read_loop(const po_collector *collector, const po_path *path, po_loop *loop) {
  const po_request *request = collector->request;
  const po_result *o = collector->result;
  take_special_point(o, &loop->preload);
  double energy = state_energy_error(o, path, &loop->preload);
  loop->energy_lost = loop->energy_lost_error = 0.0;
  for (size_t k = 0; k < loop->jump_count; ++k) {
    po_jump *jump = &loop->jumps[k];
    read_jump(collector, path, loop->control, jump);
    loop->energy_lost += jump->energy_lost;
    loop->energy_lost_error += jump->energy_lost_error;
    energy = fmax(energy, state_energy_error(o, path, &jump->before));
    energy = fmax(energy, state_energy_error(o, path, &jump->after));
  }
  read_rows(o, loop);
  loop->work_error = loop->energy_lost_error + fabs(loop->work - loop->energy_lost);
  loop->row_area_error = fabs(loop->row_area_error) + loop->work_error;
  loop->energy_error = energy + PO_SAFETY * loop->interpolated;
  loop->pull_off_error = state_of_special_point(request, collector->result, &loop->pull_off);
}

/* The least approach that loading and unloading along the branch may reach: that of the branch, and
 * through a spring the least position of the base, at which the bodies are apart, unless it is
 * beyond FARTHEST. A spring that is unstable where the branch begins jumps farther out. */
static double least_approach(const po_path *path, double stiffness) {
  const po_curve_point *p = path->point;
  double least = INFINITY, base = INFINITY; /* NAN without a spring, which fmin ignores */
  for (size_t k = 0; k < path->count; ++k) {
    least = fmin(least, p[k].approach);
    base = fmin(base, po_held(stiffness, p[k].approach, p[k].load));
  }
  if (path->count < 2 || isnan(stiffness))
    return least;
  if (po_stable_controlled(path, stiffness, 1) <= po_stable_controlled(path, stiffness, 0))
    base = fmin(base, 2.0 * least);
  return base < po_stable_controlled(path, stiffness, 0) ? fmin(least, fmax(base, FARTHEST))
                                                         : least;
}

/* Whether unloading leads to a smaller approach than the trace began with. Then *begin is set,
 * and the trace must be repeated. */
static bool begins_late(const po_request *request, const po_path *path, double *begin) {
  const unsigned paths = PO_WANT_HYSTERESIS | (isnan(request->stiffness) ? 0 : PO_WANT_PRELOAD);
  const double least = least_approach(path, request->stiffness);
  if (!(request->want & paths) || path->count == 0 || least >= path->point[0].approach)
    return false;
  *begin = PO_FARTHER * least;
  return true;
}

/* Computes loading and unloading along the traced branch. */
static po_status read_hysteresis(const po_collector *collector, const po_path *path) {
  po_result *o = collector->result;
  const po_status status = po_hysteresis_follow(
      path, po_request_preload(collector->request), collector->request->stiffness,
      collector->request->want & PO_WANT_LOOP, &o->hysteresis);
  o->has_hysteresis = !status;
  for (int k = 0; k < 2 + o->hysteresis.has_spring && !status; ++k)
    if (k != PO_AT_LOAD || o->hysteresis.has_load)
      read_loop(collector, path, &o->hysteresis.of[k]);
  return status;
}

/* Largest distance of a curve from its interpolation, over the one for which its points are chosen.
 * It is greatest where a soft spring jumps into contact from far away, on a segment along which the
 * attraction grows manifold. */
static const double MOST_OF_MISS = 32.0;

po_status po_loading_compute(const po_collector *collector, double *begin) {
  const po_request *request = collector->request;
  const po_path path = {collector->points.path, collector->points.count,
                        MOST_OF_MISS * po_estimate_miss(request)};
  po_status status = read_pressed(collector, &path);
  if (!status && !begins_late(request, &path, begin) && (request->want & PO_WANT_HYSTERESIS))
    status = read_hysteresis(collector, &path);
  return status;
}
