/* The pictures of one solve, and of the theories beside it. */
#include <math.h>
#include <stdio.h>

#include "po_hermite.h"
#include "po_plot.h"

/* Points drawn on each interval of the branch, from its cubic polynomials. */
enum { POINTS_PER_INTERVAL = 6 };
/* The picture of a branch begins where the load, and the profile ends where the traction, is this
 * part of the greatest tension. */
static const double SEEN_LOAD = 0.02, SEEN_TRACTION = 0.01;
/* The part of the extent of a loop that stays free at its ends. */
static const double FREE = 0.05;
/* The branch is drawn up to a load of so many pull-off forces, unless a loop reaches beyond. */
static const double MOST_LOAD = 2.0;

static const po_plot_point GAP = {(double)NAN, (double)NAN, 0.0};

/* What is drawn: a branch over the approach, or over the position of the base of a spring. */
typedef struct {
  po_plot_picture *picture;
  const po_curve_point *p;
  size_t count;
  po_control control;
} branch;

static double over(const branch *b, double approach, double load) {
  return po_held(b->control, approach, load);
}

static void add_state(const branch *b, po_plot_series *to, double approach, double load) {
  po_plot_add_point(b->picture, to, (po_plot_point){over(b, approach, load), load, 0.0});
}

/* Adds the branch between two positions on it. */
static void add_between(const branch *b, po_plot_series *to, double one, double other) {
  const double from = fmin(one, other), until = fmax(one, other);
  for (size_t i = 0; i + 1 < b->count; ++i) {
    const po_curve_point *p = &b->p[i], *q = p + 1;
    const double h = q->position - p->position;
    const double begin = fmax(0.0, from - p->position), end = fmin(h, until - p->position);
    for (int k = 0; end > begin && k <= POINTS_PER_INTERVAL; ++k) {
      const double x = begin + (end - begin) * k / POINTS_PER_INTERVAL;
      add_state(
          b, to,
          po_hermite_value(p->approach, p->approach_rate, q->approach, q->approach_rate, x, h),
          po_hermite_value(p->load, p->load_rate, q->load, q->load_rate, x, h));
    }
  }
  po_plot_add_point(b->picture, to, GAP);
}

/* Adds the parts of the branch that are stable at given approach, or unstable. */
static void add_parts(const branch *b, bool stable, po_plot_series *to) {
  for (size_t begin = 0, end; begin + 1 < b->count; begin = end) {
    const bool is_stable = b->p[begin].unstable_modes == 0;
    for (end = begin + 1; end + 1 < b->count && (b->p[end].unstable_modes == 0) == is_stable;)
      ++end;
    if (is_stable == stable)
      add_between(b, to, b->p[begin].position, b->p[end].position);
  }
}

/* Adds the path of loading or unloading between its jumps. */
static void add_path(const branch *b, const po_loop *loop, bool loading, po_plot_series *to) {
  double at = loading ? b->p[0].position : loop->preload.position;
  for (size_t k = 0; k < loop->jump_count; ++k) {
    const po_jump *jump = &loop->jumps[k];
    if (jump->loading != loading)
      continue;
    add_between(b, to, at, jump->before.position);
    at = jump->after.position;
  }
  if (isfinite(at))
    add_between(b, to, at, loading ? loop->preload.position : b->p[0].position);
}

static void add_jumps(const branch *b, const po_loop *loop, bool loading, po_plot_series *to) {
  for (size_t k = 0; k < loop->jump_count; ++k) {
    const po_jump *jump = &loop->jumps[k];
    if (jump->loading != loading)
      continue;
    add_state(b, to, jump->before.approach, jump->before.load);
    add_state(b, to, jump->after.approach, jump->after.load);
  }
}

/* The range of the branch that shows its attraction, all jumps of a loop, and its preload. */
static void set_range(const branch *b, const po_result *o, const po_loop *loop, po_plot_axis *x) {
  const double force = o->has_pull_off ? o->pull_off.force : 0.0;
  double low = INFINITY;
  size_t last = b->count - 1;
  for (size_t i = 0; i < b->count; ++i)
    if (fabs(b->p[i].load) >= SEEN_LOAD * force)
      low = fmin(low, over(b, b->p[i].approach, b->p[i].load));
  while (last > 1 && force > 0.0 && b->p[last].load > MOST_LOAD * force)
    --last;
  double high = over(b, b->p[last].approach, b->p[last].load);
  for (size_t k = 0; loop && k < loop->jump_count; ++k) {
    const po_path_state *before = &loop->jumps[k].before;
    low = fmin(low, over(b, before->approach, before->load));
  }
  if (loop)
    high = over(b, loop->preload.approach, loop->preload.load);
  x->low = low - FREE * (high - low);
  x->high = high + FREE * (high - low);
}

/* Load over approach, or over the position of the base if the branch is held by a spring. Given:
 * the loop that is drawn, NULL: the stability at given approach. */
static void add_loads(const branch *b, const po_result *o, const po_loop *loop) {
  po_plot_picture *picture = b->picture;
  po_plot_panel *panel = po_plot_add_panel(picture);
  const bool base = po_is_spring(b->control);
  panel->x = po_plot_axis_of(picture, base ? "position of the base" : "approach",
                             base ? "{/:Italic z}" : "Δ", PO_DIMENSION_LENGTH);
  panel->y = po_plot_axis_of(picture, "load", "{/:Italic W}", PO_DIMENSION_LOAD);
  set_range(b, o, loop, &panel->x);
  po_plot_series *s;
  if (!loop) {
    add_parts(b, false, po_plot_add_series(picture, panel, PO_PLOT_UNSTABLE, "unstable"));
    add_parts(b, true, po_plot_add_series(picture, panel, PO_PLOT_STABLE, "stable"));
    s = po_plot_add_series(picture, panel, PO_PLOT_FOLD, "fold");
    for (size_t i = 0; i < o->fold_count; ++i)
      add_state(b, s, o->folds[i].approach, o->folds[i].load);
    s = po_plot_add_series(picture, panel, PO_PLOT_PULL_OFF, "pull-off");
    if (o->has_pull_off)
      add_state(b, s, o->pull_off.approach, -o->pull_off.force);
    return;
  }
  add_between(b, po_plot_add_series(picture, panel, PO_PLOT_EQUILIBRIA, "equilibria"), -INFINITY,
              INFINITY);
  for (int loading = 1; loading >= 0; --loading) {
    s = po_plot_add_series(picture, panel, loading ? PO_PLOT_LOADING : PO_PLOT_UNLOADING,
                           loading ? "loading" : "unloading");
    add_path(b, loop, loading, s);
  }
  for (int loading = 1; loading >= 0 && loop->jump_count; --loading)
    add_jumps(b, loop, loading,
              po_plot_add_series(picture, panel,
                                 loading ? PO_PLOT_JUMP_LOADING : PO_PLOT_JUMP_UNLOADING,
                                 loading ? "" : "jump"));
  s = po_plot_add_series(picture, panel, PO_PLOT_PULL_OFF, "pull-off");
  if (loop->pull_off.load < 0.0)
    add_state(b, s, loop->pull_off.approach, loop->pull_off.load);
}

static void add_profile(po_plot_picture *picture, const po_result *o) {
  char title[64];
  po_plot_panel *panel = po_plot_add_panel(picture);
  panel->x = po_plot_axis_of(picture, "radius", "{/:Italic r}", PO_DIMENSION_LENGTH);
  snprintf(title, sizeof title, "traction at approach %.4g %s",
           po_plot_shown(&panel->x, o->profile_approach), panel->x.in_figure);
  panel->y = po_plot_axis_of(picture, "traction", "", PO_DIMENSION_TRACTION);
  panel->second = po_plot_axis_of(picture, "gap", "", PO_DIMENSION_GAP);
  double least = 0.0, reach = 0.0;
  for (size_t i = 0; i < o->profile_count; ++i)
    least = fmax(least, SEEN_TRACTION * fabs(o->profile[i].traction));
  for (size_t i = 0; i < o->profile_count; ++i)
    if (fabs(o->profile[i].traction) > least)
      reach = o->profile[i].radius;
  panel->x.low = 0.0;
  panel->x.high = (1.0 + 3.0 * FREE) * reach;
  for (int gap = 0; gap < 2; ++gap) {
    po_plot_series *s = po_plot_add_series(picture, panel, gap ? PO_PLOT_GAP : PO_PLOT_TRACTION,
                                           gap ? "gap (right)" : title);
    for (size_t i = 0; i < o->profile_count && o->profile[i].radius <= panel->x.high; ++i)
      po_plot_add_point(picture, s,
                        (po_plot_point){o->profile[i].radius,
                                        gap ? o->profile[i].gap : o->profile[i].traction, 0.0});
  }
}

static void add_steps(po_plot_picture *picture, const po_staircase *s, po_plot_series *to) {
  for (size_t k = 0; k < s->count; ++k) {
    const po_step *step = &s->step[k];
    const po_path_state *from = isfinite(step->preload.approach) ? &step->preload : &step->until;
    const double force = -step->pull_off.load;
    po_plot_add_point(picture, to,
                      (po_plot_point){po_held(s->control, from->approach, from->load), force, 0.0});
    po_plot_add_point(
        picture, to,
        (po_plot_point){po_held(s->control, step->until.approach, step->until.load), force, 0.0});
    po_plot_add_point(picture, to, GAP);
  }
}

/* The pull-off force over the preload. */
static void add_staircase(po_plot_picture *picture, const po_staircase *ours,
                          const po_staircase *jkr) {
  po_plot_panel *panel = po_plot_add_panel(picture);
  const bool base = po_is_spring(ours->control);
  panel->x = po_plot_axis_of(
      picture, base ? "preload, farthest position of the base" : "preload, largest approach",
      base ? "{/:Italic z}" : "Δ", PO_DIMENSION_LENGTH);
  panel->y = po_plot_axis_of(picture, "pull-off force", "", PO_DIMENSION_LOAD);
  panel->y.low = 0.0;
  if (jkr)
    add_steps(picture, jkr, po_plot_add_series(picture, panel, PO_PLOT_THEORY, "JKR theory"));
  po_plot_series *s = po_plot_add_series(picture, panel, PO_PLOT_STEPS, "computed");
  add_steps(picture, ours, s);
  if (picture->status)
    return;
  /* The JKR theory knows steps at preloads far beyond those that were traced. */
  const double first = s->point[0].x, extent = s->point[s->count - 2].x - first;
  panel->x.low = first - FREE * extent;
  panel->x.high = first + (1.0 + FREE) * extent;
}

typedef double (*number_of)(const po_rate_point *point);

static double load_of(const po_rate_point *p) {
  return p->load;
}

static double work_of(const po_rate_point *p) {
  return p->energy.work;
}

static double stored_of(const po_rate_point *p) {
  return p->energy.stored + p->energy.spring;
}

static double dissipated_of(const po_rate_point *p) {
  return p->energy.dissipated;
}

static double jumps_of(const po_rate_point *p) {
  return p->energy.jumps;
}

/* Adds a number of each state of unloading over the position of the base. */
static void add_history(po_plot_picture *picture, po_plot_panel *panel, const po_rate *rate,
                        po_plot_style style, const char *title, number_of number) {
  po_plot_series *s = po_plot_add_series(picture, panel, style, title);
  for (size_t i = 0; i < rate->history_count; ++i)
    po_plot_add_point(picture, s,
                      (po_plot_point){rate->history[i].base, number(&rate->history[i]), 0.0});
}

/* Load and energies of a viscoelastic body over the position of the base, which moves to the left.
 */
static void add_unloading(po_plot_picture *picture, const po_request *request, const po_result *o) {
  const po_rate *rate = &o->rate;
  const bool base = !isnan(request->stiffness);
  const char *words = base ? "position of the base" : "approach",
             *symbol = base ? "{/:Italic z}" : "Δ";
  po_plot_panel *panel = po_plot_add_panel(picture);
  panel->x = po_plot_axis_of(picture, words, symbol, PO_DIMENSION_LENGTH);
  panel->y = po_plot_axis_of(picture, "load", "{/:Italic W}", PO_DIMENSION_LOAD);
  add_history(picture, panel, rate, PO_PLOT_UNLOADING, "unloading", load_of);
  po_plot_series *s = po_plot_add_series(picture, panel, PO_PLOT_PULL_OFF, "pull-off");
  const double force = o->pull_off.force;
  po_plot_add_point(
      picture, s,
      (po_plot_point){o->pull_off.approach - (base ? force / request->stiffness : 0.0), -force,
                      0.0});
  panel = po_plot_add_panel(picture);
  panel->x = po_plot_axis_of(picture, words, symbol, PO_DIMENSION_LENGTH);
  panel->y = po_plot_axis_of(picture, "energy", "", PO_DIMENSION_ENERGY);
  add_history(picture, panel, rate, PO_PLOT_LINE, "work", work_of);
  add_history(picture, panel, rate, PO_PLOT_LINE, "dissipated", dissipated_of);
  add_history(picture, panel, rate, PO_PLOT_LINE, "stored", stored_of);
  if (rate->jumps)
    add_history(picture, panel, rate, PO_PLOT_LINE, "jumps", jumps_of);
}

po_plot_picture po_plot_of_solve(const po_request *request, const po_result *o) {
  po_plot_picture picture = po_plot_begin(po_plot_caption(request), request);
  branch b = {&picture, o->curve, o->curve_count, request->stiffness};
  const po_hysteresis *h = o->has_hysteresis ? &o->hysteresis : NULL;
  const po_loop *spring = h && h->has_spring ? &h->of[PO_THROUGH_SPRING] : NULL;
  if (b.count > 1 && spring)
    add_loads(&b, o, spring);
  b.control = PO_DISPLACEMENT_CONTROL;
  if (b.count > 1)
    add_loads(&b, o, spring ? spring : h ? &h->of[PO_AT_APPROACH] : NULL);
  if (o->profile_count > 1)
    add_profile(&picture, o);
  if (o->rate.history_count > 1)
    add_unloading(&picture, request, o);
  for (int k = o->staircase.has_spring ? 2 : 0; o->has_staircases && k >= 0; k -= 2)
    if (o->staircase.of[k].count)
      add_staircase(&picture, &o->staircase.of[k],
                    o->theory.has_staircases ? &o->theory.staircase.of[k] : NULL);
  if (!picture.status && !picture.count)
    picture.status =
        po_fail(PO_BAD_INPUT, "the result has no curve, profile or staircase to plot%s%s",
                o->status ? ": " : "",
                !o->status   ? ""
                : *o->reason ? o->reason
                             : po_status_text(o->status));
  return picture;
}

/* A row a theory. */
po_plot_picture po_plot_of_theories(const po_request *request, const po_result *o) {
  static const struct {
    po_plot_style style;
    const char *title;
  } HOLDS[] = {[PO_HOLDS_UNKNOWN] = {PO_PLOT_UNKNOWN, "not known whether the assumptions hold"},
               [PO_HOLDS_NO] = {PO_PLOT_FAILS, "an assumption does not hold"},
               [PO_HOLDS_YES] = {PO_PLOT_HOLDS, "the assumptions hold"}};
  po_plot_picture picture = po_plot_begin(po_plot_caption(request), request);
  po_plot_panel *panel = po_plot_add_panel(&picture);
  panel->x = po_plot_axis_of(&picture, "pull-off force", "", PO_DIMENSION_LOAD);
  panel->y = po_plot_axis_of(&picture, "theory", "", PO_DIMENSION_NONE);
  panel->y.low = 0.0;
  panel->y.high = (double)o->theory_count + 1.0;
  char title[64];
  snprintf(title, sizeof title, "computed, %.4g %s", po_plot_shown(&panel->x, o->pull_off.force),
           panel->x.in_figure);
  po_plot_series *s = po_plot_add_series(&picture, panel, PO_PLOT_LEVEL, title);
  for (int end = 0; end < 2 && o->has_pull_off; ++end)
    po_plot_add_point(&picture, s,
                      (po_plot_point){o->pull_off.force, end ? panel->y.high : 0.0, 0.0});
  for (int holds = PO_HOLDS_YES; holds >= PO_HOLDS_UNKNOWN; --holds) {
    s = po_plot_add_series(&picture, panel, HOLDS[holds].style, HOLDS[holds].title);
    for (size_t k = 0; k < o->theory_count; ++k)
      if ((int)o->theories[k].holds == holds && isfinite(o->theories[k].force))
        po_plot_add_point(
            &picture, s, (po_plot_point){o->theories[k].force, (double)(o->theory_count - k), 0.0});
  }
  for (size_t k = 0; k < o->theory_count; ++k)
    po_text_add(&panel->y.tics, "%s'%s%s' %zu", k ? ", " : "",
                PO_THEORIES[o->theories[k].theory].words,
                isfinite(o->theories[k].force) ? "" : " (none)", o->theory_count - k);
  if (panel->y.tics.failed)
    picture.status = PO_NO_MEMORY;
  return picture;
}
