/* The plots of one solve as characters. */
#include <math.h>
#include <stdlib.h>

#include "po_input.h"
#include "po_memory.h"
#include "po_plot.h"

/* Columns of numbers that series refer to. */
typedef struct {
  double *x, *y;
  size_t count;
} points;

static bool reserve(points *p, size_t room) {
  p->x = po_allocate(room, sizeof *p->x);
  p->y = po_allocate(room, sizeof *p->y);
  return p->x && p->y;
}

static void release(points *p, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    free(p[k].x);
    free(p[k].y);
  }
}

static void add(points *p, double x, double y) {
  p->x[p->count] = x;
  p->y[p->count++] = y;
}

/* The parts of the branch that are stable, or unstable. A line belongs to the point where it
 * begins. */
static void add_parts(const po_result *o, bool stable, points *p) {
  for (size_t i = 0; i + 1 < o->curve_count; ++i)
    if ((o->curve[i].unstable_modes == 0) == stable) {
      add(p, o->curve[i].approach, o->curve[i].load);
      add(p, o->curve[i + 1].approach, o->curve[i + 1].load);
      add(p, NAN, NAN);
    }
}

static void print_curve(const po_request *request, const po_result *o, size_t columns, size_t rows,
                        po_text *text) {
  enum { UNSTABLE, STABLE, JUMPS, FOLDS, PULL_OFF, COUNT };
  const po_loop *loop = &o->hysteresis.displacement;
  const size_t jumps = o->has_hysteresis ? loop->jump_count : 0;
  points p[COUNT] = {{0}};
  const bool reserved = reserve(&p[UNSTABLE], 3 * o->curve_count) &&
                        reserve(&p[STABLE], 3 * o->curve_count) && reserve(&p[JUMPS], 3 * jumps) &&
                        reserve(&p[FOLDS], o->fold_count) && reserve(&p[PULL_OFF], 1);
  if (reserved) {
    add_parts(o, false, &p[UNSTABLE]);
    add_parts(o, true, &p[STABLE]);
    for (size_t k = 0; k < jumps; ++k) {
      const double after = loop->jumps[k].after.load;
      add(&p[JUMPS], loop->jumps[k].before.approach, loop->jumps[k].before.load);
      add(&p[JUMPS], loop->jumps[k].before.approach, isfinite(after) ? after : 0);
      add(&p[JUMPS], NAN, NAN);
    }
    for (size_t i = 0; i < o->fold_count; ++i)
      add(&p[FOLDS], o->folds[i].approach, o->folds[i].load);
    if (o->has_pull_off)
      add(&p[PULL_OFF], o->pull_off.approach, -o->pull_off.force);
    static const char MARKS[] = {'.', '*', '|', 'o', 'X'};
    po_plot_series series[COUNT];
    for (int k = 0; k < COUNT; ++k)
      series[k] = (po_plot_series){p[k].x, p[k].y, p[k].count, MARKS[k], k < FOLDS};
    po_text_add(text,
                "load in %s against approach in epsilon\n"
                "* stable, . unstable, o fold, X pull-off%s\n",
                po_input_load_unit(request), jumps ? ", | jump" : "");
    po_plot_characters(series, COUNT, "approach", "load", columns, rows, text);
  }
  release(p, COUNT);
  text->failed = text->failed || !reserved;
}

static void print_profile(const po_result *o, size_t columns, size_t rows, po_text *text) {
  points p[1] = {{0}};
  const bool reserved = reserve(p, o->profile_count);
  if (reserved) {
    double largest = 0;
    for (size_t i = 0; i < o->profile_count; ++i)
      largest = fmax(largest, fabs(o->profile[i].traction));
    for (size_t i = 0, last = 0; i < o->profile_count; ++i) {
      if (fabs(o->profile[i].traction) > 1e-2 * largest)
        last = i;
      p->count = last + 1;
      p->x[i] = o->profile[i].radius;
      p->y[i] = o->profile[i].traction;
    }
    const po_plot_series series = {p->x, p->y, p->count, '*', true};
    po_text_add(text, "traction P = p mu epsilon/w against radius in epsilon at approach %.6g\n",
                o->profile_approach);
    po_plot_characters(&series, 1, "radius", "traction", columns, rows, text);
  }
  release(p, 1);
  text->failed = text->failed || !reserved;
}

static void add_steps(const po_staircase *s, points *p) {
  for (size_t k = 0; k < s->count; ++k) {
    const po_step *step = &s->step[k];
    add(p, isfinite(step->preload.approach) ? step->preload.approach : step->until.approach,
        -step->pull_off.load);
    add(p, step->until.approach, -step->pull_off.load);
    add(p, NAN, NAN);
  }
}

static void print_staircase(const po_request *request, const po_result *o, size_t columns,
                            size_t rows, po_text *text) {
  points p[2] = {{0}};
  const bool reserved = reserve(&p[0], 3 * o->theory.staircase.of[0].count) &&
                        reserve(&p[1], 3 * o->staircase.of[0].count);
  if (reserved) {
    add_steps(&o->theory.staircase.of[0], &p[0]);
    add_steps(&o->staircase.of[0], &p[1]);
    const po_plot_series series[] = {{p[0].x, p[0].y, p[0].count, '.', true},
                                     {p[1].x, p[1].y, p[1].count, '*', true}};
    po_text_add(text, "pull-off force in %s against preload in epsilon: * computed%s\n",
                po_input_load_unit(request), p[0].count ? ", . JKR theory" : "");
    po_plot_characters(series, 2, "largest approach", "force", columns, rows, text);
  }
  release(p, 2);
  text->failed = text->failed || !reserved;
}

po_status po_plot_print(const po_request *request, const po_result *o, size_t columns, size_t rows,
                        po_text *text) {
  const size_t before = text->length;
  if (o->curve_count > 1)
    print_curve(request, o, columns, rows, text);
  if (o->profile_count > 1)
    print_profile(o, columns, rows, text);
  if (o->has_staircases && o->staircase.of[0].count)
    print_staircase(request, o, columns, rows, text);
  if (text->failed)
    return PO_NO_MEMORY;
  return text->length > before
             ? PO_OK
             : po_fail(PO_BAD_INPUT, "the result has no curve, profile or staircase to plot: %s",
                       *o->reason ? o->reason : po_status_text(o->status));
}
