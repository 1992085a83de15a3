#include "po_plot_case_map.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "po_memory.h"
#include "po_plot.h"
#include "po_plot_verb.h"

/* The least number of values of both keys; a case with fewer values of one is a set of curves. */
enum { LEAST_VALUES = 8 };

/* The number of different values of a key in a case. */
static size_t count_values(const po_case *kase, po_key key) {
  size_t count = 0;
  for (size_t i = 0; i < kase->point_count; ++i) {
    const double value = po_key_number(&kase->points[i].request, key);
    bool is_new = isfinite(value);
    for (size_t k = 0; k < i && is_new; ++k)
      is_new = po_key_number(&kase->points[k].request, key) != value;
    count += is_new;
  }
  return count;
}

size_t po_plot_varied_values(const po_case *kase, int key) {
  bool swept = false;
  for (unsigned i = 0; i < kase->file->sweep_count; ++i)
    swept = swept || po_sweep_names(&kase->file->sweep[i], (po_key)key);
  return swept && po_key_is_continuous(key) ? count_values(kase, (po_key)key) : 0;
}

bool po_plot_case_is_map(const po_case *kase, po_key keys[2]) {
  size_t count = 0;
  for (unsigned i = kase->file->sweep_count; i-- > 0;) {
    size_t of_item = 0;
    for (int key = 0; key < PO_KEY_END; ++key) {
      if (!po_sweep_names(&kase->file->sweep[i], (po_key)key))
        continue;
      if (++of_item > 1 || count == 2 || po_plot_varied_values(kase, key) < LEAST_VALUES)
        return false;
      keys[count++] = (po_key)key;
    }
  }
  return count == 2;
}

static int by_value(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Values that differ by their rounding, because they are computed from other keys, are the same. */
static bool is_above(double a, double b) {
  return a - b > 1e-12 * fabs(b);
}

/* The different values of a key, ascending. Returned: their number. */
static size_t values_of(const po_case *kase, po_key key, double *value) {
  size_t count = 0;
  for (size_t i = 0; i < kase->point_count; ++i) {
    const double here = po_key_number(&kase->points[i].request, key);
    if (isfinite(here))
      value[count++] = here;
  }
  qsort(value, count, sizeof *value, by_value);
  size_t different = 0;
  for (size_t i = 0; i < count; ++i)
    if (different == 0 || is_above(value[i], value[different - 1]))
      value[different++] = value[i];
  return different;
}

/* The index of a value in a list of values. */
static size_t index_of(const double *value, size_t count, double wanted) {
  size_t k = 0;
  while (k + 1 < count && is_above(wanted, value[k]))
    ++k;
  return k;
}

/* Fills the forces. Returned: whether any point has a pull-off. */
static bool fill(const po_case_run *run, const po_case *kase, const po_key keys[2],
                 const po_plot_map *map, double *force) {
  bool any = false;
  for (size_t k = 0; k < map->columns * map->rows; ++k)
    force[k] = NAN;
  for (size_t i = 0; i < kase->point_count; ++i) {
    const po_request *request = &kase->points[i].request;
    const double x = po_key_number(request, keys[0]), y = po_key_number(request, keys[1]);
    if (!run->results[i].has_pull_off || !isfinite(x) || !isfinite(y))
      continue;
    const size_t row = index_of(map->y, map->rows, y);
    force[row * map->columns + index_of(map->x, map->columns, x)] = run->results[i].pull_off.force;
    any = true;
  }
  return any;
}

static po_status draw(const po_case *kase, const po_key keys[2], const po_plot_map *map,
                      const char *file) {
  po_text script = {0};
  po_plot_assign(&script, "caption", kase->file->title);
  po_plot_assign(&script, "x_name", po_key_name(keys[0]));
  po_plot_assign(&script, "y_name", po_key_name(keys[1]));
  po_plot_assign_load_unit(&script, &kase->points[0].request);
  po_status status = po_plot_map_data(map, &script);
  if (!status)
    status = po_plot_with(&script, "map.gp", file);
  po_text_clear(&script);
  return status;
}

static po_status print(const po_case *kase, const po_key keys[2], const po_plot_map *map) {
  size_t columns, rows;
  po_text text = {0};
  po_plot_size(&columns, &rows);
  po_plot_map_print(map, po_key_name(keys[0]), po_key_name(keys[1]), columns, rows, &text);
  if (!text.failed)
    printf("%s: pull-off force in %s over %s and %s\n%s", kase->file->title,
           po_input_load_unit(&kase->points[0].request), po_key_name(keys[0]), po_key_name(keys[1]),
           po_text_string(&text));
  const po_status status = text.failed ? PO_NO_MEMORY : PO_OK;
  po_text_clear(&text);
  return status;
}

po_status po_plot_case_map(const po_case_run *run, const po_case *kase, const po_key keys[2],
                           const char *file) {
  double *x = po_allocate(kase->point_count, sizeof *x);
  double *y = po_allocate(kase->point_count, sizeof *y);
  double *force = NULL;
  po_status status = x && y ? PO_OK : PO_NO_MEMORY;
  po_plot_map map = {0};
  if (!status) {
    map = (po_plot_map){x, y, values_of(kase, keys[0], x), values_of(kase, keys[1], y), NULL};
    map.value = force = po_allocate(map.columns * map.rows, sizeof *force);
    status = force ? PO_OK : PO_NO_MEMORY;
  }
  if (!status && !fill(run, kase, keys, &map, force))
    status = po_fail(PO_BAD_INPUT, "no point of the case %s has a pull-off", kase->file->name);
  if (!status)
    status = file ? draw(kase, keys, &map, file) : print(kase, keys, &map);
  free(force);
  free(x);
  free(y);
  return status;
}
