/* The picture of the theories beside a solve: a row a theory. */
#include <math.h>
#include <stdio.h>

#include "po_plot.h"

void po_plot_theories(const po_result *o, po_plot_picture *picture) {
  static const struct {
    po_plot_style style;
    const char *title;
  } HOLDS[] = {[PO_HOLDS_UNKNOWN] = {PO_PLOT_UNKNOWN, "not known whether the assumptions hold"},
               [PO_HOLDS_NO] = {PO_PLOT_FAILS, "an assumption does not hold"},
               [PO_HOLDS_YES] = {PO_PLOT_HOLDS, "the assumptions hold"}};
  po_plot_panel *panel = po_plot_add_panel(picture);
  panel->x = po_plot_axis_of(picture, "pull-off force", "", PO_DIMENSION_LOAD);
  panel->y = po_plot_axis_of(picture, "theory", "", PO_DIMENSION_NONE);
  panel->y.low = 0.0;
  panel->y.high = (double)o->theory_count + 1.0;
  char title[64];
  snprintf(title, sizeof title, "computed, %.4g %s", po_plot_shown(&panel->x, o->pull_off.force),
           panel->x.in_figure);
  po_plot_series *s = po_plot_add_series(picture, panel, PO_PLOT_LEVEL, title);
  for (int end = 0; end < 2 && o->has_pull_off; ++end)
    po_plot_add_point(picture, s,
                      (po_plot_point){o->pull_off.force, end ? panel->y.high : 0.0, 0.0});
  for (int holds = PO_HOLDS_YES; holds >= PO_HOLDS_UNKNOWN; --holds) {
    s = po_plot_add_series(picture, panel, HOLDS[holds].style, HOLDS[holds].title);
    for (size_t k = 0; k < o->theory_count; ++k)
      if ((int)o->theories[k].holds == holds && isfinite(o->theories[k].force))
        po_plot_add_point(
            picture, s, (po_plot_point){o->theories[k].force, (double)(o->theory_count - k), 0.0});
  }
  for (size_t k = 0; k < o->theory_count; ++k)
    po_text_add(&panel->y.tics, "%s'%s%s' %zu", k ? ", " : "",
                po_theory_words(o->theories[k].theory),
                isfinite(o->theories[k].force) ? "" : " (none)", o->theory_count - k);
  picture->failed = picture->failed || panel->y.tics.failed;
}
