/* The map of a run in which two numbers vary. */
#include <math.h>
#include <stdio.h>

#include "po_elementary.h"
#include "po_plot.h"

/* The shades of a map of characters, from the smallest to the greatest value. */
static const char SHADES[] = ".:-=+*#%@";
enum { SHADE_COUNT = sizeof SHADES - 1 };

/* Part of a step by which a cell is larger on the right and above: a drawing program leaves a pale
 * line between two cells that only touch. */
static const double OVERLAP = 0.1;

/* The border between two values of an axis, or beyond an end of it: half a step away. Given:
 * `more`, steps farther. */
static double border(const double *value, size_t count, size_t index, double more) {
  const bool log_scale = po_plot_is_log(value[0], value[count - 1]);
  const size_t inner = index == 0 ? 1 : index == count ? count - 1 : index;
  const double a = value[inner - 1], b = value[inner];
  const double part = (index == 0 ? -0.5 : index == count ? 1.5 : 0.5) + more;
  return log_scale ? a * po_pow(b / a, part) : a + part * (b - a);
}

static void find_range(const po_plot_map *map, double range[2]) {
  range[0] = INFINITY;
  range[1] = -INFINITY;
  for (size_t k = 0; k < map->columns * map->rows; ++k)
    if (isfinite(map->value[k])) {
      range[0] = fmin(range[0], map->value[k]);
      range[1] = fmax(range[1], map->value[k]);
    }
}

static void add_axis(po_text *script, char axis, const double *value, size_t count) {
  const double low = border(value, count, 0, 0.0), high = border(value, count, count, 0.0);
  po_text_add(script, "set %crange [%.9g:%.9g]\n", axis, low, high);
  if (po_plot_is_log(value[0], value[count - 1]))
    po_plot_add_log_tics(script, axis, low, high);
}

void po_plot_map_data(const po_plot_map *map, po_text *script) {
  po_text_add(script, "$map << EOD\n");
  for (size_t j = 0; j < map->rows; ++j)
    for (size_t i = 0; i < map->columns; ++i)
      if (isfinite(map->value[j * map->columns + i]))
        po_text_add(script, "%.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", map->x[i], map->y[j],
                    border(map->x, map->columns, i, 0.0),
                    border(map->x, map->columns, i + 1, OVERLAP), border(map->y, map->rows, j, 0.0),
                    border(map->y, map->rows, j + 1, OVERLAP), map->value[j * map->columns + i]);
  po_text_add(script, "EOD\n");
  add_axis(script, 'x', map->x, map->columns);
  add_axis(script, 'y', map->y, map->rows);
  double range[2]; /* gnuplot would leave out cells whose overlap ends beyond the axes */
  find_range(map, range);
  if (range[0] < range[1])
    po_text_add(script, "set cbrange [%.9g:%.9g]\n", range[0], range[1]);
}

static char shade_of(double value, const double range[2]) {
  if (!isfinite(value))
    return ' ';
  const double part = range[1] > range[0] ? (value - range[0]) / (range[1] - range[0]) : 0.0;
  return SHADES[(int)fmin(SHADE_COUNT - 1, floor(part * SHADE_COUNT))];
}

void po_plot_map_print(const po_plot_picture *picture, size_t columns, size_t rows, po_text *text) {
  enum { ROWS_PER_LABEL = 5 };
  const po_plot_map *map = picture->map;
  double range[2];
  find_range(map, range);
  /* every value has the same number of characters; if there are too many values, some are left out
   */
  const size_t wide = map->columns < columns ? columns / map->columns : 1;
  const size_t every = map->columns > columns ? (map->columns - 1) / columns + 1 : 1;
  const size_t every_row = map->rows > rows ? (map->rows - 1) / rows + 1 : 1;
  po_text_add(text, "%s: pull-off force in %s over %s and %s\n", picture->caption,
              picture->load_unit, map->x_name, map->y_name);
  po_text_add(text, "%s from %.4g to %.4g, in steps of %.4g\n", SHADES, range[0], range[1],
              (range[1] - range[0]) / SHADE_COUNT);
  size_t shown = 0, width = 0;
  for (size_t down = 0; down < map->rows; down += every_row, ++shown) {
    const size_t j = map->rows - 1 - down;
    char label[32] = "";
    if (shown % ROWS_PER_LABEL == 0 || down + every_row >= map->rows)
      snprintf(label, sizeof label, "%.4g", map->y[j]);
    po_text_add(text, "%*s |", PO_PLOT_LABEL, label);
    width = 0;
    for (size_t i = 0; i < map->columns; i += every)
      for (size_t k = 0; k < wide; ++k, ++width)
        po_text_add(text, "%c", shade_of(map->value[j * map->columns + i], range));
    po_text_add(text, "\n");
  }
  po_plot_add_floor(text, width, map->x[0], map->x[map->columns - 1]);
  po_text_add(text, "%*s  %s, upwards %s\n", PO_PLOT_LABEL, "", map->x_name, map->y_name);
}
