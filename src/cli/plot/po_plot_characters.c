/* Plots of characters, for a terminal. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_elementary.h"
#include "po_memory.h"
#include "po_plot.h"

enum { MOST_STEPS = 10000 }; /* of a line that leaves the plot */
enum { LABEL = 10 };         /* before the plot, for values of y */
enum { LEGEND = 76 };        /* characters of a line of the legend, at most */

#define MARK(key, macro, mark) mark,
static const char MARKS[] = {PO_PLOT_STYLES(MARK)};
/* Several curves have different characters. */
static const char CURVES[] = "*o+x#@%&";

static char mark_of(const po_plot_series *s, size_t index) {
  return s->style == PO_PLOT_CURVE || s->style == PO_PLOT_LINE ? CURVES[index % (sizeof CURVES - 1)]
                                                               : MARKS[s->style];
}

static bool is_line(po_plot_style style) {
  return style < PO_PLOT_HOLDS;
}

typedef struct {
  const po_plot_panel *panel;
  double x[2], y[2]; /* ranges */
  size_t columns, rows;
  char *cell;
} canvas;

/* The part of a range at which a value is. */
static double part(const po_plot_axis *axis, const double range[2], double value) {
  return axis->log ? po_log(value / range[0]) / po_log(range[1] / range[0])
                   : (value - range[0]) / (range[1] - range[0]);
}

static void put(canvas *c, double column, double row, char mark) {
  if (column >= -0.5 && row >= -0.5 && column < (double)c->columns - 0.5 &&
      row < (double)c->rows - 0.5)
    c->cell[lround(row) * (long)c->columns + lround(column)] = mark;
}

/* Draws the line from a point to the next, in steps of less than a character, or the point. */
static void draw(canvas *c, const po_plot_point *p, bool line, char mark) {
  double at[2][2];
  for (int k = 0; k <= line; ++k) {
    if (!isfinite(p[k].x) || !isfinite(p[k].y))
      return;
    at[k][0] =
        part(&c->panel->x, c->x, po_plot_shown(&c->panel->x, p[k].x)) * (double)(c->columns - 1);
    at[k][1] = (1.0 - part(&c->panel->y, c->y, po_plot_shown(&c->panel->y, p[k].y))) *
               (double)(c->rows - 1);
  }
  if (!line) {
    put(c, at[0][0], at[0][1], mark);
    return;
  }
  const double across = fabs(at[1][0] - at[0][0]), along = fabs(at[1][1] - at[0][1]);
  const int steps = 2 * (int)fmin(fmax(across, along), MOST_STEPS) + 1;
  for (int k = 0; k <= steps; ++k)
    put(c, at[0][0] + (at[1][0] - at[0][0]) * k / steps,
        at[0][1] + (at[1][1] - at[0][1]) * k / steps, mark);
}

static void draw_series(canvas *c, const po_plot_series *s, char mark) {
  const bool arrow = po_plot_is_jump(s->style);
  const bool line = is_line(s->style);
  if (line && s->count == 1)
    draw(c, s->point, false, mark);
  for (size_t i = 0; i + line < s->count; i += 1 + arrow)
    draw(c, &s->point[i], line, mark);
}

/* Appends the line below a plot, with the first and the last x below it. */
static void add_floor(po_text *text, size_t width, double first, double last) {
  char from[32], to[32];
  snprintf(from, sizeof from, "%.4g", first);
  snprintf(to, sizeof to, "%.4g", last);
  po_text_add(text, "%*s +", LABEL, "");
  for (size_t k = 0; k < width; ++k)
    po_text_add(text, "-");
  const int gap = (int)width - (int)strlen(from);
  po_text_add(text, "\n%*s  %s%*s\n", LABEL, "", from, gap > 1 ? gap : 1, to);
}

static void add_rows(const canvas *c, po_text *text) {
  for (size_t row = 0; row < c->rows; ++row) {
    char label[32] = "";
    const double at = 1.0 - (double)row / (double)(c->rows - 1);
    const double y = c->panel->y.log ? c->y[0] * po_pow(c->y[1] / c->y[0], at)
                                     : c->y[0] + (c->y[1] - c->y[0]) * at;
    if (row % 5 == 0 || row + 1 == c->rows)
      snprintf(label, sizeof label, "%.4g", y);
    size_t length = c->columns;
    while (length && c->cell[row * c->columns + length - 1] == ' ')
      --length;
    po_text_add(text, "%*s |%.*s\n", LABEL, label, (int)length, c->cell + row * c->columns);
  }
  add_floor(text, c->columns, c->x[0], c->x[1]);
}

/* The title of each mark, once. */
static void add_legend(const po_plot_panel *panel, po_text *text) {
  size_t used = 0;
  for (size_t k = 0; k < panel->count; ++k) {
    const po_plot_series *s = &panel->series[k];
    const size_t length = strlen(s->title) + 4;
    if (!s->count || !*s->title || !mark_of(s, k))
      continue;
    po_text_add(text, "%s%c %s",
                !used                    ? ""
                : used + length > LEGEND ? ",\n"
                                         : ", ",
                mark_of(s, k), s->title);
    used = used + length > LEGEND ? length : used + length;
  }
  po_text_add(text, "\n");
}

static po_status print_panel(po_plot_panel *panel, size_t columns, size_t rows, po_text *text) {
  po_plot_set_ranges(panel);
  const po_plot_axis *x = &panel->x, *y = &panel->y;
  canvas c = {panel,
              {po_plot_shown(x, x->low), po_plot_shown(x, x->high)},
              {po_plot_shown(y, y->low), po_plot_shown(y, y->high)},
              columns,
              rows,
              po_reserve(columns * rows, 1)};
  if (!c.cell)
    return PO_NO_MEMORY;
  memset(c.cell, ' ', columns * rows);
  for (size_t k = 0; k < panel->count; ++k)
    if (mark_of(&panel->series[k], k))
      draw_series(&c, &panel->series[k], mark_of(&panel->series[k], k));
  po_text_add(text, "%s%s%s against %s%s%s\n", y->words, *y->in_letters ? " in " : "",
              y->in_letters, x->words, *x->in_letters ? " in " : "", x->in_letters);
  add_legend(panel, text);
  add_rows(&c, text);
  free(c.cell);
  return PO_OK;
}

/* The shades of a map of characters, from the smallest to the greatest value. */
static const char SHADES[] = ".:-=+*#%@";
enum { SHADE_COUNT = sizeof SHADES - 1 };

static char shade_of(const po_plot_map *map, double value) {
  if (!isfinite(value))
    return ' ';
  const double at = map->high > map->low ? (value - map->low) / (map->high - map->low) : 0.0;
  return SHADES[(int)fmin(SHADE_COUNT - 1, floor(at * SHADE_COUNT))];
}

/* Prints the map of a picture. */
static void print_map(const po_plot_picture *picture, size_t columns, size_t rows, po_text *text) {
  enum { ROWS_PER_LABEL = 5 };
  const po_plot_map *map = picture->map;
  /* every value has the same number of characters; if there are too many values, some are left out
   */
  const size_t wide = map->columns < columns ? columns / map->columns : 1;
  const size_t every = map->columns > columns ? (map->columns - 1) / columns + 1 : 1;
  const size_t every_row = map->rows > rows ? (map->rows - 1) / rows + 1 : 1;
  po_text_add(text, "%s: pull-off force in %s over %s and %s\n", picture->caption,
              picture->load_unit, map->x_name, map->y_name);
  po_text_add(text, "%s from %.4g to %.4g, in steps of %.4g\n", SHADES, map->low, map->high,
              (map->high - map->low) / SHADE_COUNT);
  size_t shown = 0, width = 0;
  for (size_t down = 0; down < map->rows; down += every_row, ++shown) {
    const size_t j = map->rows - 1 - down;
    char label[32] = "";
    if (shown % ROWS_PER_LABEL == 0 || down + every_row >= map->rows)
      snprintf(label, sizeof label, "%.4g", map->y[j]);
    po_text_add(text, "%*s |", LABEL, label);
    width = 0;
    for (size_t i = 0; i < map->columns; i += every)
      for (size_t k = 0; k < wide; ++k, ++width)
        po_text_add(text, "%c", shade_of(map, map->value[j * map->columns + i]));
    po_text_add(text, "\n");
  }
  add_floor(text, width, map->x[0], map->x[map->columns - 1]);
  po_text_add(text, "%*s  %s, upwards %s\n", LABEL, "", map->x_name, map->y_name);
}

po_status po_plot_print(po_plot_picture *picture, size_t columns, size_t rows, po_text *text) {
  po_status status = PO_OK;
  if (picture->map)
    print_map(picture, columns, rows, text);
  for (size_t k = 0; k < picture->count && !status; ++k)
    status = print_panel(&picture->panel[k], columns, rows, text);
  return status ? status : text->failed ? PO_NO_MEMORY : PO_OK;
}
