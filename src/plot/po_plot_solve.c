/* The figure of one solve as data of a gnuplot script. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_hermite.h"
#include "po_input.h"
#include "po_plot.h"

/* Points drawn on each interval of the branch, from its cubic polynomials. */
enum { POINTS_PER_INTERVAL = 6 };

void po_plot_assign(po_text *script, const char *variable, const char *value) {
  po_text_add(script, "%s = '", variable);
  for (const char *c = value; *c; ++c)
    po_text_add(script, *c == '\'' ? "''" : "%c", *c);
  po_text_add(script, "'\n");
}

void po_plot_assign_load_unit(po_text *script, const po_request *request) {
  po_plot_assign(script, "load_unit",
                 strcmp(po_input_load_unit(request), "pi w R") == 0 ? "πwR" : "πwε");
}

/* The points of the branch from `begin` to `end` - 1. */
static void add_stretch(po_text *script, const po_curve_point *p, size_t begin, size_t end) {
  for (size_t i = begin; i + 1 < end; ++i) {
    const double h = p[i + 1].position - p[i].position;
    for (int k = 0; k < POINTS_PER_INTERVAL; ++k) {
      const double x = h * k / POINTS_PER_INTERVAL;
      po_text_add(
          script, "%.9g %.9g\n",
          po_hermite_value(p[i].approach, p[i].approach_rate, p[i + 1].approach,
                           p[i + 1].approach_rate, x, h),
          po_hermite_value(p[i].load, p[i].load_rate, p[i + 1].load, p[i + 1].load_rate, x, h));
    }
  }
  po_text_add(script, "%.9g %.9g\n\n\n", p[end - 1].approach, p[end - 1].load);
}

/* A block for each part of the branch that is stable, or unstable; neighbours share a point.
 * Returned: the number of blocks. */
static size_t add_stretches(po_text *script, const po_result *o, bool stable) {
  size_t blocks = 0;
  po_text_add(script, "$%s << EOD\n", stable ? "stable" : "unstable");
  for (size_t begin = 0, end; begin + 1 < o->curve_count; begin = end) {
    const bool is_stable = o->curve[begin].unstable_modes == 0;
    end = begin + 1;
    while (end < o->curve_count && (o->curve[end].unstable_modes == 0) == is_stable)
      ++end;
    if (is_stable != stable)
      continue;
    add_stretch(script, o->curve, begin, end < o->curve_count ? end + 1 : end);
    ++blocks;
  }
  po_text_add(script, "NaN NaN\nEOD\n");
  return blocks;
}

static void add_curve(const po_result *o, po_text *script) {
  const size_t stable = add_stretches(script, o, true), unstable = add_stretches(script, o, false);
  po_text_add(script, "stable_count = %zu\nunstable_count = %zu\n$folds << EOD\n", stable,
              unstable);
  for (size_t i = 0; i < o->fold_count; ++i)
    po_text_add(script, "%.9g %.9g\n", o->folds[i].approach, o->folds[i].load);
  po_text_add(script, "NaN NaN\nEOD\n$pull_off << EOD\n");
  if (o->has_pull_off)
    po_text_add(script, "%.9g %.9g\n", o->pull_off.approach, -o->pull_off.force);
  po_text_add(script, "NaN NaN\nEOD\n");
}

/* The jumps at given approach: rows of approach, load before and after, loading (1) or unloading. A
 * jump to infinite separation ends at load 0. */
static void add_jumps(const po_result *o, po_text *script) {
  const po_loop *loop = &o->hysteresis.displacement;
  size_t count = 0;
  po_text_add(script, "$jumps << EOD\n");
  for (size_t k = 0; o->has_hysteresis && k < loop->jump_count; ++k, ++count) {
    const po_jump *jump = &loop->jumps[k];
    const double after = isfinite(jump->after.load) ? jump->after.load : 0.0;
    const double approach =
        isfinite(jump->before.approach) ? jump->before.approach : jump->after.approach;
    po_text_add(script, "%.9g %.9g %.9g %d\n", approach, jump->before.load, after, jump->loading);
  }
  po_text_add(script, "NaN NaN NaN 0\nEOD\njump_count = %zu\n", count);
}

static void add_profile(const po_result *o, po_text *script) {
  po_text_add(script, "$profile << EOD\n");
  for (size_t i = 0; i < o->profile_count; ++i)
    po_text_add(script, "%.9g %.9g %.9g\n", o->profile[i].radius, o->profile[i].gap,
                o->profile[i].traction);
  po_text_add(script, "NaN NaN NaN\nEOD\n");
  if (o->profile_count)
    po_text_add(script, "profile_approach = %.9g\n", o->profile_approach);
}

static void add_staircase(const char *name, const po_staircase *s, po_text *script) {
  po_text_add(script, "$%s << EOD\n", name);
  for (size_t k = 0; k < s->count; ++k) {
    const po_step *step = &s->step[k];
    const double from =
        isfinite(step->preload.approach) ? step->preload.approach : step->until.approach;
    po_text_add(script, "%.9g %.9g\n%.9g %.9g\n\n", from, -step->pull_off.load,
                step->until.approach, -step->pull_off.load);
  }
  po_text_add(script, "NaN NaN\nEOD\n");
}

po_status po_plot_solve(const po_request *request, const po_result *o, po_text *script) {
  enum { WIDTH = 680, ONE_ROW = 400, TWO_ROWS = 660 };
  const bool curve = o->curve_count > 1, profile = o->profile_count > 1;
  const bool staircase = o->has_staircases && o->staircase.of[0].count > 0;
  const int panels = curve + profile + staircase;
  if (!panels)
    return po_fail(PO_BAD_INPUT, "the result has no curve, profile or staircase to plot: %s",
                   *o->reason ? o->reason : po_status_text(o->status));
  char *command = po_input_command(request);
  if (!command)
    return PO_NO_MEMORY;
  po_text_add(script, "figure_width = %d\nfigure_height = %d\npanel_count = %d\n", WIDTH,
              panels > 2 ? TWO_ROWS : ONE_ROW, panels);
  po_text_add(script, "has_curve = %d\nhas_profile = %d\nhas_staircase = %d\n", curve, profile,
              staircase);
  po_plot_assign(script, "caption", command);
  po_plot_assign_load_unit(script, request);
  free(command);
  add_curve(o, script);
  add_jumps(o, script);
  add_profile(o, script);
  add_staircase("staircase", &o->staircase.of[0], script);
  add_staircase("jkr", &o->theory.staircase.of[0], script);
  po_text_add(script, "has_jkr = %d\n",
              o->theory.has_staircases && o->theory.staircase.of[0].count);
  return script->failed ? PO_NO_MEMORY : PO_OK;
}

po_status po_plot_pull_offs(size_t number, const char *name, const po_plot_pull_off *point,
                            size_t count, po_text *script) {
  char variable[40];
  po_text_add(script, "$curve%zu << EOD\n", number);
  for (size_t i = 0; i < count; ++i)
    po_text_add(script, "%.9g %.9g %.9g\n", point[i].x, point[i].force, point[i].error);
  po_text_add(script, "NaN NaN NaN\nEOD\n");
  snprintf(variable, sizeof variable, "name%zu", number);
  po_plot_assign(script, variable, name);
  return script->failed ? PO_NO_MEMORY : PO_OK;
}
