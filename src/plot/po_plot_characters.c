/* Plots of characters, for a terminal. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_plot.h"

typedef struct {
  double x[2], y[2]; /* ranges */
  size_t columns, rows;
  char *cell;
} canvas;

static void widen(double range[2], double value) {
  if (!isfinite(value))
    return;
  range[0] = fmin(range[0], value);
  range[1] = fmax(range[1], value);
}

/* A range without extent becomes one of length 1 about its value. */
static void open_range(double range[2]) {
  if (range[0] > range[1])
    range[0] = range[1] = 0;
  if (range[0] == range[1]) {
    range[0] -= 0.5;
    range[1] += 0.5;
  }
}

static void put(canvas *c, double x, double y, char mark) {
  if (!isfinite(x) || !isfinite(y))
    return;
  const double column = (x - c->x[0]) / (c->x[1] - c->x[0]) * (double)(c->columns - 1);
  const double row = (c->y[1] - y) / (c->y[1] - c->y[0]) * (double)(c->rows - 1);
  c->cell[lround(row) * (long)c->columns + lround(column)] = mark;
}

/* A line in steps of less than a character. */
static void draw_line(canvas *c, const po_plot_series *s, size_t i) {
  if (!isfinite(s->x[i] + s->y[i] + s->x[i + 1] + s->y[i + 1]))
    return;
  const double across = fabs(s->x[i + 1] - s->x[i]) / (c->x[1] - c->x[0]) * (double)c->columns;
  const double along = fabs(s->y[i + 1] - s->y[i]) / (c->y[1] - c->y[0]) * (double)c->rows;
  const int steps = 2 * (int)fmax(across, along) + 1;
  for (int k = 0; k <= steps; ++k)
    put(c, s->x[i] + (s->x[i + 1] - s->x[i]) * k / steps,
        s->y[i] + (s->y[i + 1] - s->y[i]) * k / steps, s->mark);
}

static void draw(canvas *c, const po_plot_series *s) {
  for (size_t i = 0; i < s->count; ++i) {
    if (!s->is_line)
      put(c, s->x[i], s->y[i], s->mark);
    else if (i + 1 < s->count)
      draw_line(c, s, i);
  }
}

static void add_rows(const canvas *c, const char *y_name, po_text *text) {
  enum { LABEL = 10 };
  for (size_t row = 0; row < c->rows; ++row) {
    char label[32] = "";
    const double y = c->y[1] - (c->y[1] - c->y[0]) * (double)row / (double)(c->rows - 1);
    if (row % 5 == 0 || row + 1 == c->rows)
      snprintf(label, sizeof label, "%.4g", y);
    size_t length = c->columns;
    while (length && c->cell[row * c->columns + length - 1] == ' ')
      --length;
    po_text_add(text, "%*s |%.*s\n", LABEL, label, (int)length, c->cell + row * c->columns);
  }
  po_text_add(text, "%*s +", LABEL, "");
  for (size_t k = 0; k < c->columns; ++k)
    po_text_add(text, "-");
  char from[32], to[32];
  snprintf(from, sizeof from, "%.4g", c->x[0]);
  snprintf(to, sizeof to, "%.4g", c->x[1]);
  const int gap = (int)c->columns - (int)strlen(from);
  po_text_add(text, "\n%*s  %s%*s\n", LABEL, y_name, from, gap > 1 ? gap : 1, to);
}

void po_plot_characters(const po_plot_series *series, size_t count, const char *x_name,
                        const char *y_name, size_t columns, size_t rows, po_text *text) {
  canvas c = {{INFINITY, -INFINITY}, {INFINITY, -INFINITY}, columns, rows, NULL};
  for (size_t k = 0; k < count; ++k)
    for (size_t i = 0; i < series[k].count; ++i)
      if (isfinite(series[k].x[i]) && isfinite(series[k].y[i])) {
        widen(c.x, series[k].x[i]);
        widen(c.y, series[k].y[i]);
      }
  open_range(c.x);
  open_range(c.y);
  c.cell = po_reserve(columns * rows, 1);
  if (!c.cell) {
    text->failed = true;
    return;
  }
  memset(c.cell, ' ', columns * rows);
  for (size_t k = 0; k < count; ++k)
    draw(&c, &series[k]);
  add_rows(&c, y_name, text);
  po_text_add(text, "%*s%s\n", 12 + (int)(columns > strlen(x_name) ? columns - strlen(x_name) : 0),
              "", x_name);
  free(c.cell);
}
