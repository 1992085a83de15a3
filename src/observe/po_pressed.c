#include "po_pressed.h"

#include <math.h>

#include "po_estimate.h"
#include "po_observe_parts.h"
#include "po_staircase.h"

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

po_path_error po_pressed_state(const po_request *request, const po_result *o,
                               po_path_state *state) {
  const po_special_point *mark = mark_at(o, state->position);
  if (mark) {
    state->approach = mark->approach;
    state->load = mark->load;
  }
  if (mark && !isnan(mark->load_error))
    return (po_path_error){mark->approach_error, mark->load_error};
  const po_path_error e = greatest_error(o);
  const double miss = po_estimate_miss(request);
  return (po_path_error){e.approach + miss, e.load + miss};
}

static void state_errors(const po_request *request, const po_result *o, const po_estimate *greatest,
                         po_staircase *s) {
  for (size_t k = 0; k < s->count; ++k) {
    po_step *step = &s->step[k];
    step->preload_error = po_pressed_state(request, o, &step->preload);
    step->pull_off_error = po_pressed_state(request, o, &step->pull_off);
    po_pressed_state(request, o, &step->until);
    for (size_t c = 0; c < step->cycle_count; ++c) {
      po_cycle *cycle = &step->cycle[c];
      po_pressed_state(request, o, &cycle->preload);
      cycle->energy_error = po_estimate_loss_error(request, greatest, s->control, &cycle->loss);
    }
  }
}

static po_pressed pressed(const po_path_state *state) {
  return (po_pressed){state->approach, state->load};
}

static void read_pull_off(const po_staircase *s, double position, po_result *o) {
  o->pull_off.pressed = o->pull_off.until = (po_pressed){NAN, NAN};
  for (size_t k = s->count; k-- > 0;)
    if (s->step[k].pull_off.position == position) {
      o->pull_off.pressed = pressed(&s->step[k].preload);
      o->pull_off.until = s->step[k].open ? (po_pressed){NAN, NAN} : pressed(&s->step[k].until);
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
  const po_path_point *deepest = NULL;
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
static bool is_complete(const po_request *request, const po_path *path, const po_stopping *stopping,
                        const po_result *o) {
  const double load = -o->pull_off_any.force;
  if (deepest_stable(path, o) < load - o->pull_off_any.force_error)
    return false;
  if (o->rigid && !po_scene_is_simple(&request->scene))
    return o->ended.approach >= po_observe_rigid_end(&request->scene, 0.0);
  return po_stopping_is_complete(stopping, load);
}

po_status po_pressed_read(const po_request *request, const po_path *path,
                          const po_estimate *greatest, const po_stopping *stopping, po_result *o) {
  po_staircase *s = &o->staircase[0];
  po_status status = po_staircase_read(path, PO_DISPLACEMENT_CONTROL, s);
  if (!status)
    status = po_staircase_read(path, PO_LOAD_CONTROL, &o->staircase[1]);
  if (status)
    return status;
  o->has_staircases = request->want & PO_WANT_PRELOAD;
  state_errors(request, o, greatest, s);
  state_errors(request, o, greatest, &o->staircase[1]);
  read_pull_off(s, pull_off_position(o), o);
  read_any(s, o);
  o->pull_off_any.complete = o->pull_off_any.is_known && is_complete(request, path, stopping, o);
  return PO_OK;
}
