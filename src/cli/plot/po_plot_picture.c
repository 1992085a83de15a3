/* Pictures: their captions, parts, axes and ranges. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_elementary.h"
#include "po_input.h"
#include "po_memory.h"
#include "po_plot.h"

/* Ratio of the ends of a linear axis, at most. */
static const double MOST_LINEAR = 20.0;
/* Part of the extent of an axis that stays free at each end. */
static const double MARGIN = 0.05;

const char *po_plot_load_unit(const char *load_unit) {
  return strcmp(load_unit, "pi w R") == 0 ? "πwR" : "πwε";
}

/* Returned: the prefix with which a magnitude is not below `least`; in *factor, what the number is
 * then multiplied by. */
static const char *prefix_of(double value, double least, double *factor) {
  static const char *const PREFIX[] = {"a", "f", "p", "n", "µ", "m", "", "k", "M", "G", "T"};
  enum { NONE = 6, LAST = sizeof PREFIX / sizeof *PREFIX - 1 };
  int k = NONE;
  *factor = 1.0;
  for (; k > 0 && fabs(value) * *factor < least; --k)
    *factor *= 1e3;
  for (; k < LAST && fabs(value) * *factor >= 999.99; ++k)
    *factor /= 1e3;
  return PREFIX[k];
}

const char *po_plot_prefix(double greatest, double *factor) {
  return prefix_of(greatest, 0.99999, factor);
}

/* Appends a quantity with the prefix that fits it. */
static void add_quantity(po_text *text, const char *symbol, double value, const char *unit) {
  /* 0.3 nm and 0.2 N/m, but 80 mJ/m² */
  const double least = strcmp(unit, "m") == 0     ? 0.099999
                       : strcmp(unit, "N/m") == 0 ? 0.0099999
                                                  : 0.99999;
  double factor;
  const char *prefix = prefix_of(value, least, &factor);
  if (isfinite(value) && value != 0.0)
    po_text_add(text, "%s%s = %.5g %s%s", text->length ? ", " : "", symbol, value * factor, prefix,
                unit);
}

char *po_plot_caption(const po_request *request) {
  const po_scene *scene = &request->scene;
  po_text text = {0};
  const po_units *units = &request->units;
  if (!request->in_si) {
    po_input_add_command(request, &text);
    return po_text_take(&text);
  }
  if (po_profile_is_sphere(&scene->profile)) {
    add_quantity(&text, "R", scene->radius * units->length, "m");
  } else {
    char profile[PO_KEY_TEXT_LENGTH];
    po_key_print(request, PO_KEY_PROFILE, profile);
    po_text_add(&text, "profile %s (ε)", profile);
  }
  add_quantity(&text, "w", units->work, "J/m²");
  add_quantity(&text, "E*", po_scene_stiffness(scene) * units->tension, "Pa");
  add_quantity(&text, "ε", units->length, "m");
  for (size_t k = 0; k < po_scene_waves(scene); ++k) {
    add_quantity(&text, "A", po_scene_wave(scene, k).amplitude * units->length, "m");
    add_quantity(&text, "λ", po_scene_wave(scene, k).length * units->length, "m");
  }
  add_quantity(&text, "preload", request->preload.load * units->force, "N");
  add_quantity(&text, "preload", request->preload.approach * units->length, "m");
  add_quantity(&text, "spring", request->stiffness * (units->force / units->length), "N/m");
  return po_text_take(&text);
}

po_plot_picture po_plot_begin(char *caption, const po_request *request) {
  return (po_plot_picture){.caption = caption,
                           .load_unit = po_input_load_unit(request),
                           .units = request->in_si ? &request->units : NULL,
                           .status = caption ? PO_OK : PO_NO_MEMORY};
}

bool po_plot_is_jump(po_plot_style style) {
  return style == PO_PLOT_JUMP_LOADING || style == PO_PLOT_JUMP_UNLOADING;
}

void po_plot_clear(po_plot_picture *picture) {
  for (size_t k = 0; k < picture->count; ++k) {
    po_plot_panel *panel = &picture->panel[k];
    for (size_t i = 0; i < panel->count; ++i)
      free(panel->series[i].point);
    free(panel->series);
    po_text_clear(&panel->y.tics);
  }
  free(picture->caption);
  *picture = (po_plot_picture){0};
}

po_plot_panel *po_plot_add_panel(po_plot_picture *picture) {
  return &picture->panel[picture->count++];
}

po_plot_series *po_plot_add_series(po_plot_picture *picture, po_plot_panel *panel,
                                   po_plot_style style, const char *title) {
  static po_plot_series none; /* takes no points */
  po_plot_series *grown = po_grow(panel->series, panel->count, &panel->room, sizeof *grown);
  if (!grown) {
    picture->status = PO_NO_MEMORY;
    return &none;
  }
  panel->series = grown;
  po_plot_series *series = &grown[panel->count++];
  *series = (po_plot_series){.style = style};
  snprintf(series->title, sizeof series->title, "%s", title);
  return series;
}

void po_plot_add_point(po_plot_picture *picture, po_plot_series *series, po_plot_point point) {
  if (picture->status)
    return;
  po_plot_point *grown = po_grow(series->point, series->count, &series->room, sizeof *grown);
  if (!grown) {
    picture->status = PO_NO_MEMORY;
    return;
  }
  series->point = grown;
  grown[series->count++] = point;
}

po_plot_axis po_plot_axis_of(const po_plot_picture *picture, const char *words, const char *symbol,
                             po_dimension dimension) {
  po_plot_axis axis = {.symbol = symbol, .si = picture->units, .low = NAN, .high = NAN};
  snprintf(axis.words, sizeof axis.words, "%s", words);
  const bool length = dimension == PO_DIMENSION_LENGTH || dimension == PO_DIMENSION_GAP;
  const bool energy = dimension == PO_DIMENSION_ENERGY;
  const bool load = dimension == PO_DIMENSION_LOAD || energy,
             traction = dimension == PO_DIMENSION_TRACTION;
  const char *text = length     ? "ε"
                     : load     ? po_plot_load_unit(picture->load_unit)
                     : traction ? "(w/με)"
                                : "";
  const char *letters = length     ? "epsilon"
                        : load     ? picture->load_unit
                        : traction ? "w/(mu epsilon)"
                                   : "";
  po_si_unit unit = {.factor = 1.0, .shift = dimension == PO_DIMENSION_GAP};
  if (axis.si) {
    unit = po_si_prefixed(picture->units, dimension);
    text = letters = unit.text;
  }
  axis.factor = unit.factor;
  axis.shift = unit.shift;
  /* an energy is a load times a length */
  snprintf(axis.in_figure, sizeof axis.in_figure, "%s%s", text, energy && !axis.si ? "ε" : "");
  snprintf(axis.in_letters, sizeof axis.in_letters, "%s%s", letters,
           energy && !axis.si ? " epsilon" : "");
  return axis;
}

double po_plot_shown(const po_plot_axis *axis, double value) {
  return (value + axis->shift) * axis->factor;
}

bool po_plot_is_log(double first, double last) {
  return first > 0.0 && last > MOST_LINEAR * first;
}

static void widen(double range[2], double value) {
  range[0] = fmin(range[0], value);
  range[1] = fmax(range[1], value);
}

/* Sets an end of the range of an axis that is NAN to that of the points, with a margin. */
static void set_range(po_plot_axis *axis, const double found[2]) {
  double low = isnan(axis->low) ? found[0] : axis->low;
  double high = isnan(axis->high) ? found[1] : axis->high;
  if (low > high)
    low = high = 0.0;
  if (axis->log) {
    const double factor = po_pow(high / low, MARGIN);
    axis->low = isnan(axis->low) ? low / factor : low;
    axis->high = isnan(axis->high) ? high * factor : high;
    return;
  }
  const double margin = high > low ? MARGIN * (high - low) : 0.5;
  const double free =
      low >= 0.0 && low < margin ? 0.0 : low - margin; /* not below 0 for a margin */
  axis->low = isnan(axis->low) ? free : low;
  axis->high = isnan(axis->high) ? high + margin : high;
}

void po_plot_set_ranges(po_plot_panel *panel) {
  for (int of_y = 0; of_y < 2; ++of_y) {
    double found[2] = {INFINITY, -INFINITY};
    for (size_t k = 0; k < panel->count; ++k)
      for (size_t i = 0; i < panel->series[k].count; ++i) {
        const po_plot_point *p = &panel->series[k].point[i];
        const bool outside = of_y && (p->x < panel->x.low || p->x > panel->x.high);
        if (isfinite(p->x) && isfinite(p->y) && !outside && panel->series[k].style != PO_PLOT_GAP)
          widen(found, of_y ? p->y : p->x);
      }
    set_range(of_y ? &panel->y : &panel->x, found);
  }
}
