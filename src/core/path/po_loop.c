#include "po_loop.h"

#include <math.h>
#include <stdlib.h>

#include "po_loop_record.h"
#include "po_memory.h"

typedef struct {
  const po_path *path;
  po_control control;
  po_preload preload;
  po_loop *loop;
  po_loop_record record;
  po_path_place at;
} loop_state;

static po_path_state state_of(const loop_state *f) {
  return po_path_at(f->path, f->at);
}

/* Notes the error by interpolation of a state of the loop. */
static void note_doubt(loop_state *f, po_path_doubt doubt) {
  f->loop->interpolated = fmax(f->loop->interpolated, doubt.interpolated);
}

/* Adds a jump from a point that ends at the present place, or, if the bodies separate, at none. */
static po_status add_jump(loop_state *f, bool loading, po_path_state before, size_t from,
                          po_path_state after) {
  po_loop *loop = f->loop;
  po_jump *jumps = po_resize(loop->jumps, loop->jump_count + 1, sizeof *jumps);
  if (!jumps)
    return PO_NO_MEMORY;
  loop->jumps = jumps;
  const po_path_doubt error =
      po_doubt_of_jump(f->path, f->control, from, isfinite(after.position) ? &f->at : NULL);
  note_doubt(f, error);
  const double lost = po_loss_of_jump(f->control, &before, &after, error).energy;
  jumps[loop->jump_count++] = (po_jump){loading, before, after, lost, error, NAN};
  loop->loading_jumps += loading;
  loop->energy_lost += lost;
  return po_loop_record_jump(&f->record, isfinite(after.position) ? &f->at : NULL, after);
}

/* Moves to a fraction of the current segment and adds the work. Status: PO_NO_MEMORY. */
static po_status move(loop_state *f, double fraction) {
  const double before = state_of(f).load;
  f->loop->work += po_path_work(f->path, f->at.index, f->at.fraction, fraction);
  const po_status status = po_loop_record_way(&f->record, f->at.index, f->at.fraction, fraction);
  f->at.fraction = fraction;
  if (f->control != PO_LOAD_CONTROL) { /* what the spring takes up */
    const double after = state_of(f).load;
    f->loop->work += 0.5 * (after - before) * (after + before) / f->control;
  }
  return status;
}

/* Returned: whether the preload is reached on the current segment ahead of the place; then
 * *fraction is where. */
static bool meets_preload(const loop_state *f, double *fraction) {
  const po_path_state here = state_of(f);
  const po_curve_point *end = &f->path->point[f->at.index + 1];
  const po_preload p = f->preload;
  bool met = false;
  *fraction = 1.0;
  if (f->control != PO_LOAD_CONTROL && po_path_reaches(end->approach, p.approach)) {
    met = true;
    *fraction = po_path_where(f->path, f->at.index, PO_DISPLACEMENT_CONTROL, p.approach).fraction;
  }
  if (here.load >= p.load || end->load >= p.load) {
    const double by_load =
        here.load >= p.load ? f->at.fraction
                            : po_path_where(f->path, f->at.index, PO_LOAD_CONTROL, p.load).fraction;
    *fraction = fmin(*fraction, by_load);
    met = true;
  }
  *fraction = fmax(*fraction, f->at.fraction);
  return met;
}

static po_status jump_on(loop_state *f, double value) {
  const po_path_state before = state_of(f);
  const size_t from = f->at.index;
  if (!po_stable_find(f->path, f->control, from, 1, value, &f->at))
    return po_fail(
        PO_NOT_FOUND,
        "the curve ends at approach %.6g and has no equilibrium after the jump at approach "
        "%.6g: the preload is not reached",
        f->path->point[f->path->count - 1].approach, before.approach);
  return add_jump(f, true, before, from, state_of(f));
}

static po_status start(loop_state *f) {
  f->at = (po_path_place){0, 0.0};
  if (f->control != PO_LOAD_CONTROL)
    return PO_OK;
  po_stable_find(f->path, f->control, 0, 1, 0.0, &f->at);
  return add_jump(f, true, po_stable_apart(PO_LOAD_CONTROL, 0.0), 0, state_of(f));
}

static po_status load(loop_state *f) {
  po_status status = start(f);
  while (!status) {
    double fraction;
    if (!po_stable_is(f->path, f->control, f->at.index)) {
      status = jump_on(f, po_stable_controlled(f->path, f->control, f->at.index));
      continue;
    }
    if (meets_preload(f, &fraction)) {
      status = move(f, fraction);
      f->loop->preload = state_of(f);
      note_doubt(f, po_path_doubt_at(f->path, f->at));
      return status;
    }
    status = move(f, 1.0);
    if (!status && f->at.index + 2 == f->path->count)
      return po_fail(PO_NOT_FOUND, "the curve ends at approach %.6g: the preload is not reached",
                     f->path->point[f->at.index + 1].approach);
    f->at = (po_path_place){f->at.index + 1, 0.0};
  }
  return status;
}

static void note_tension(loop_state *f) {
  const po_path_state here = state_of(f);
  if (here.load < f->loop->pull_off.load)
    f->loop->pull_off = here;
}

/* The last jump, to a state before the curve begins. Through a spring the bodies are then as good
 * as apart. */
static po_status separate(loop_state *f, po_path_state before, double value) {
  const po_curve_point *first = &f->path->point[0];
  if (f->control == PO_DISPLACEMENT_CONTROL)
    return po_fail(PO_NOT_FOUND,
                   "the curve begins at approach %.6g and has no equilibrium after the jump at "
                   "approach %.6g",
                   first->approach, value);
  return add_jump(f, false, before, f->at.index, po_stable_apart(f->control, value));
}

static po_status unload(loop_state *f) {
  po_status status = PO_OK;
  f->loop->pull_off = state_of(f);
  f->record.loading = false;
  for (;;) {
    status = move(f, 0.0);
    if (status)
      return status;
    note_tension(f);
    if (f->at.index == 0)
      return PO_OK;
    if (po_stable_is(f->path, f->control, f->at.index - 1)) {
      f->at = (po_path_place){f->at.index - 1, 1.0};
      continue;
    }
    const po_path_state before = state_of(f);
    const double value = po_stable_controlled(f->path, f->control, f->at.index);
    const size_t from = f->at.index;
    if (!po_stable_find(f->path, f->control, from, -1, value, &f->at))
      return separate(f, before, value);
    status = add_jump(f, false, before, from, state_of(f));
    if (status)
      return status;
    note_tension(f);
  }
}

/* One loop. Under load control loading begins at load 0, at which the curve has a stable
 * equilibrium. */
static po_status follow(const po_path *path, po_control control, po_preload preload, bool rows,
                        po_loop *loop) {
  *loop = (po_loop){.control = control,
                    .has_rows = rows,
                    .pull_off_error = {NAN, NAN},
                    .energy_lost_error = NAN,
                    .work_error = NAN,
                    .energy_error = NAN};
  po_curve_point *points = NULL;
  po_path held = *path;
  loop_state f = {.path = &held, .control = control, .preload = preload, .loop = loop};
  po_status status =
      path->count < 2 ? po_fail(PO_NOT_FOUND, "the curve has fewer than two points") : PO_OK;
  if (!status)
    status = po_path_add_extrema(&held, control, &points);
  f.record = po_loop_record_begin(&held, control, loop);
  if (!status)
    status = load(&f);
  if (!status)
    status = unload(&f);
  if (control == PO_LOAD_CONTROL)
    loop->work = NAN;
  free(points);
  return status;
}

po_status po_hysteresis_follow(const po_path *path, po_preload preload, po_control spring,
                               bool rows, po_hysteresis *hysteresis) {
  po_loop *of = hysteresis->of;
  *hysteresis = (po_hysteresis){.has_spring = false};
  po_status status = follow(path, PO_DISPLACEMENT_CONTROL, preload, rows, &of[PO_AT_APPROACH]);
  const po_preload load = {(double)NAN, fmax(0.0, of[PO_AT_APPROACH].preload.load)};
  po_path_place at_zero;
  hysteresis->has_load = !status && po_stable_find(path, PO_LOAD_CONTROL, 0, 1, 0.0, &at_zero);
  if (hysteresis->has_load)
    status = follow(path, PO_LOAD_CONTROL, load, false, &of[PO_AT_LOAD]);
  hysteresis->has_spring = !status && isfinite(spring);
  if (hysteresis->has_spring)
    status = follow(path, spring, preload, rows, &of[PO_THROUGH_SPRING]);
  if (status)
    po_hysteresis_clear(hysteresis);
  return status;
}
