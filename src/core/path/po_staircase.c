#include "po_staircase.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "po_memory.h"

/* A stable stretch of the curve, and the unloading path below its lower end. */
typedef struct {
  size_t start, end;     /* indices of its first and last point */
  po_path_state deepest; /* the state of lowest load on the unloading path below it; load INFINITY:
                            there is none */
  po_loss unloading;     /* the jumps of unloading from its lower end on */
} stretch;

typedef struct {
  const po_path *path;
  po_control control;
  stretch *all;
  size_t *stretch_of; /* for each segment its stretch, by the index of its first point; SIZE_MAX:
                         unstable */
  size_t count;
  po_staircase *staircase;
  size_t step_room;
  bool decreasing;       /* no step is open: the load decreases towards a minimum */
  po_path_state deepest; /* the pull-off if loading were reversed here */
  po_loss loading;       /* the jumps of loading up to here */
} walk;

static const po_path_state NOTHING = {.load = (double)INFINITY, .position = (double)NAN};

static po_path_state state(const walk *w, po_path_place place) {
  return po_path_at(w->path, place);
}

static po_path_state point(const walk *w, size_t index) {
  return state(w, (po_path_place){index, 0.0});
}

static po_path_state deeper(po_path_state a, po_path_state b) {
  return b.load < a.load ? b : a;
}

/* Returned: the state of lowest load on the unloading path from a place on a stretch: minima of the
 * load and the ends of stretches count. Other points close to a minimum may have a lower load by
 * the error of their mesh. */
static po_path_state deepest_from(const walk *w, const stretch *s, po_path_place place) {
  po_path_state deepest = deeper(s->deepest, state(w, place));
  for (size_t k = s->start; k <= place.index; ++k)
    if (k == s->start || w->path->point[k].minimum)
      deepest = deeper(deepest, point(w, k));
  return deepest;
}

/* Adds a jump. Given: the point where it begins, and the place on the curve where it ends; NULL:
 * none. */
static void add_jump(const walk *w, size_t from, const po_path_state *before,
                     const po_path_state *after, const po_path_place *end, po_loss *to) {
  const po_path_doubt doubt = po_doubt_of_jump(w->path, w->control, from, end);
  *to = po_loss_sum(*to, po_loss_of_jump(w->control, before, after, doubt));
}

/* Determines the unloading path from the lower end of a stretch; those of all stretches below are
 * known. */
static void unload(const walk *w, stretch *s) {
  s->deepest = NOTHING;
  if (s->start == 0)
    return;
  const po_path_state before = point(w, s->start);
  const double value = po_stable_controlled(w->path, w->control, s->start);
  po_path_state after = po_stable_apart(w->control, value);
  po_path_place to;
  const bool found = po_stable_find(w->path, w->control, s->start, -1, value, &to);
  if (found) {
    const stretch *below = &w->all[w->stretch_of[to.index]];
    after = state(w, to);
    s->deepest = deepest_from(w, below, to);
    s->unloading = below->unloading;
  } else if (w->control == PO_DISPLACEMENT_CONTROL) {
    after.energy = NAN; /* the jump ends farther out than the curve begins */
  }
  add_jump(w, s->start, &before, &after, found ? &to : NULL, &s->unloading);
}

static po_status find_stretches(walk *w) {
  const size_t n = w->path->count;
  w->all = po_allocate(n, sizeof *w->all);
  w->stretch_of = po_allocate(n, sizeof *w->stretch_of);
  if (!w->all || !w->stretch_of)
    return PO_NO_MEMORY;
  for (size_t k = 0; k < n; ++k) {
    w->stretch_of[k] = SIZE_MAX;
    if (!po_stable_is(w->path, w->control, k))
      continue;
    if (k == 0 || w->stretch_of[k - 1] == SIZE_MAX) {
      w->all[w->count++] = (stretch){.start = k};
      unload(w, &w->all[w->count - 1]);
    }
    w->stretch_of[k] = w->count - 1;
    w->all[w->count - 1].end = k + 1;
  }
  return PO_OK;
}

static po_step *last_step(const walk *w) {
  return w->staircase->count ? &w->staircase->step[w->staircase->count - 1] : NULL;
}

static void end_step(walk *w, po_path_state until) {
  po_step *step = last_step(w);
  if (step && step->open) {
    step->until = until;
    step->open = false;
  }
}

static po_status begin_step(walk *w, po_path_state preload, bool jumped) {
  po_staircase *s = w->staircase;
  po_step *moved = po_grow(s->step, s->count, &w->step_room, sizeof *moved);
  if (!moved)
    return PO_NO_MEMORY;
  s->step = moved;
  s->step[s->count++] = (po_step){.preload = preload,
                                  .jumped = jumped,
                                  .open = true,
                                  .pull_off = w->deepest,
                                  .preload_error = {NAN, NAN},
                                  .pull_off_error = {NAN, NAN}};
  w->decreasing = false;
  return PO_OK;
}

/* Adds a cycle: preloads from here on have the jumps of loading up to here and those of unloading
 * from this stretch. */
static po_status add_cycle(walk *w, const stretch *s, po_path_state preload) {
  po_step *step = last_step(w);
  po_cycle *moved = po_resize(step->cycle, step->cycle_count + 1, sizeof *moved);
  if (!moved)
    return PO_NO_MEMORY;
  step->cycle = moved;
  moved[step->cycle_count++] = (po_cycle){preload, po_loss_sum(w->loading, s->unloading), NAN};
  return PO_OK;
}

/* Processes a jump of loading from a point, at which the state is `before`, to a place on a
 * stretch. */
static po_status arrive(walk *w, const stretch *s, size_t from, po_path_state before,
                        po_path_place place) {
  const po_path_state after = state(w, place);
  add_jump(w, from, &before, &after, &place, &w->loading);
  const double position = w->deepest.position;
  w->deepest = deepest_from(w, s, place);
  if (!w->decreasing && w->deepest.position == position)
    return add_cycle(w, s, before);
  end_step(w, before);
  w->decreasing = w->deepest.position == after.position; /* the load decreases further */
  if (w->decreasing)
    return PO_OK;
  const po_status status = begin_step(w, before, true);
  return status ? status : add_cycle(w, s, before);
}

/* Follows loading on a stretch from a place to its end. A step begins at a minimum that was
 * located: beside others the load also rises where the mesh changes, by its error. */
static po_status load_along(walk *w, const stretch *s, po_path_place from) {
  po_path_state last = state(w, from);
  for (size_t k = from.index + 1; k <= s->end; ++k) {
    const po_path_state here = point(w, k);
    const po_curve_point *p = &w->path->point[k];
    if (p->minimum ? w->decreasing || here.load < w->deepest.load
                   : p->load_rate < 0.0 && here.load < w->deepest.load) {
      if (!w->decreasing)
        end_step(w, last.load > w->deepest.load
                        ? state(w, po_path_where(w->path, k - 1, PO_LOAD_CONTROL, w->deepest.load))
                        : last);
      w->decreasing = true;
      w->deepest = here;
    } else if (w->decreasing && last.load < 0.0 && w->path->point[k - 1].minimum) {
      po_status status = begin_step(w, last, false);
      if (!status)
        status = add_cycle(w, s, last);
      if (status)
        return status;
    }
    last = here;
  }
  w->staircase->reached = last;
  return PO_OK;
}

static bool begin(walk *w, po_path_place *at) {
  *at = (po_path_place){0, 0.0};
  if (w->control == PO_LOAD_CONTROL)
    return po_stable_find(w->path, w->control, 0, 1, 0.0, at);
  return w->stretch_of[0] != SIZE_MAX ||
         po_stable_find(w->path, w->control, 0, 1, po_stable_controlled(w->path, w->control, 0),
                        at);
}

static po_status climb(walk *w) {
  po_path_place at;
  if (!begin(w, &at))
    return PO_OK;
  po_status status = PO_OK;
  const stretch *s = &w->all[w->stretch_of[at.index]];
  w->decreasing = true;
  w->deepest = state(w, at);
  if (w->control == PO_LOAD_CONTROL)
    status = arrive(w, s, 0, po_stable_apart(PO_LOAD_CONTROL, 0.0), at);
  else if (po_is_spring(w->control) && at.index > 0)
    status = arrive(w, s, 0, point(w, 0), at);
  while (!status) {
    status = load_along(w, s, at);
    const size_t from = s->end;
    const po_path_state before = point(w, from);
    if (status || s->end + 1 >= w->path->count ||
        !po_stable_find(w->path, w->control, s->end, 1,
                        po_stable_controlled(w->path, w->control, s->end), &at))
      break;
    s = &w->all[w->stretch_of[at.index]];
    status = arrive(w, s, from, before, at);
  }
  if (last_step(w) && last_step(w)->open)
    last_step(w)->until = w->staircase->reached;
  return status;
}

static po_status read_staircase(const po_path *path, po_control control, po_staircase *staircase) {
  *staircase = (po_staircase){.control = control, .reached = NOTHING};
  if (path->count < 2)
    return PO_OK;
  po_path held = *path;
  po_curve_point *points;
  walk w = {.path = &held, .control = control, .staircase = staircase};
  po_status status = po_path_add_extrema(&held, control, &points);
  if (!status)
    status = find_stretches(&w);
  if (!status)
    status = climb(&w);
  free(w.all);
  free(w.stretch_of);
  free(points);
  return status;
}

po_status po_staircases_read(const po_path *path, po_control spring, po_staircases *staircases) {
  const po_control controls[PO_TESTS] = {PO_DISPLACEMENT_CONTROL, PO_LOAD_CONTROL, spring};
  po_status status = PO_OK;
  *staircases = (po_staircases){.has_spring = po_is_spring(spring)};
  for (int k = 0; k < 2 + staircases->has_spring && !status; ++k)
    status = read_staircase(path, controls[k], &staircases->of[k]);
  if (status)
    po_staircases_clear(staircases);
  return status;
}

const po_step *po_staircase_greatest(const po_staircase *staircase) {
  const po_step *greatest = NULL;
  for (size_t k = 0; k < staircase->count; ++k)
    if (!greatest || staircase->step[k].pull_off.load < greatest->pull_off.load)
      greatest = &staircase->step[k];
  return greatest;
}
