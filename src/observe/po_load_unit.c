#include "po_load_unit.h"

#include <math.h>

#include "po_elementary.h"
#include "po_scales.h"

po_request po_load_unit_request(const po_request *request) {
  po_request r = *request;
  if (po_profile_is_sphere(&r.scene.profile) || po_scene_check(&r.scene))
    return r;
  const double radius = po_profile_radius_of_sphere(&r.scene.profile);
  const double unit = isnan(radius) ? po_scene_scales(&r.scene).load : radius / r.scene.radius;
  if (!(isfinite(unit) && unit > 0.0))
    return r;
  if (!isnan(radius))
    r.scene.profile = po_profile_sphere();
  r.scene.load_unit = unit;
  r.scene.radius *= unit;
  r.scene.tabor *= po_cbrt(unit);
  r.preload.load /= unit;
  return r;
}

po_preload po_load_unit_preload(const po_request *request) {
  const po_request solved = po_load_unit_request(request);
  po_preload preload = po_request_preload(&solved);
  preload.load *= po_scene_load_unit(&solved.scene);
  return preload;
}

static void convert_points(po_special_point *point, size_t count, double unit) {
  for (size_t k = 0; k < count; ++k) {
    point[k].load *= unit;
    point[k].load_error *= unit;
    point[k].energy *= unit;
    point[k].energy_error *= unit;
  }
}

static void convert_state(po_path_state *state, double unit) {
  state->load *= unit;
  state->energy *= unit;
}

static void convert_loop(po_loop *loop, double unit) {
  convert_state(&loop->preload, unit);
  convert_state(&loop->pull_off, unit);
  loop->pull_off_error.load *= unit;
  loop->energy_lost *= unit;
  loop->work *= unit;
  loop->energy_lost_error *= unit;
  loop->work_error *= unit;
  loop->energy_error *= unit;
  for (size_t k = 0; k < loop->jump_count; ++k) {
    convert_state(&loop->jumps[k].before, unit);
    convert_state(&loop->jumps[k].after, unit);
    loop->jumps[k].energy_lost *= unit;
    loop->jumps[k].energy_lost_error *= unit;
  }
}

static void convert_step(po_step *step, double unit) {
  convert_state(&step->preload, unit);
  convert_state(&step->until, unit);
  convert_state(&step->pull_off, unit);
  step->preload_error.load *= unit;
  step->pull_off_error.load *= unit;
  for (size_t k = 0; k < step->cycle_count; ++k) {
    convert_state(&step->cycle[k].preload, unit);
    step->cycle[k].loss.energy *= unit;
    step->cycle[k].energy_error *= unit;
  }
}

static void convert_staircase(po_staircase *staircase, double unit) {
  convert_state(&staircase->reached, unit);
  for (size_t k = 0; k < staircase->count; ++k)
    convert_step(&staircase->step[k], unit);
}

static void convert_pull_off(po_result *o, double unit) {
  o->pull_off.force *= unit;
  o->pull_off.force_error *= unit;
  o->pull_off.pressed.load *= unit;
  o->pull_off.until.load *= unit;
  o->pull_off_any.force *= unit;
  o->pull_off_any.force_error *= unit;
  o->pull_off_any.pressed.load *= unit;
  o->pull_off_any.searched.load *= unit;
}

static void convert_diagnostics(po_diagnostics *d, double unit) {
  for (size_t k = 0; k < d->state_count; ++k)
    d->states[k].load *= unit;
  d->reverse_trace.fold_load *= unit;
  d->reverse_trace.extremum_load *= unit;
}

void po_load_unit_result(const po_scene *solved, po_result *o) {
  const double unit = po_scene_load_unit(solved);
  if (unit == 1.0)
    return;
  o->ended.load *= unit;
  convert_pull_off(o, unit);
  convert_points(o->folds, o->fold_count, unit);
  convert_points(o->extrema, o->extremum_count, unit);
  for (size_t k = 0; k < o->curve_count; ++k) {
    o->curve[k].load *= unit;
    o->curve[k].load_rate *= unit;
    o->curve[k].energy *= unit;
    o->curve[k].energy_error *= unit;
  }
  for (size_t k = 0; k < o->profile_count; ++k) /* in w/(mu eps), mu^3 as R */
    o->profile[k].traction /= po_cbrt(unit);
  convert_loop(&o->hysteresis.displacement, unit);
  convert_loop(&o->hysteresis.load, unit);
  convert_loop(&o->theory.hysteresis.displacement, unit);
  convert_loop(&o->theory.hysteresis.load, unit);
  for (int k = 0; k < 2; ++k) {
    convert_staircase(&o->staircase[k], unit);
    convert_staircase(&o->theory.staircase[k], unit);
  }
  convert_diagnostics(&o->diagnostics, unit);
}
