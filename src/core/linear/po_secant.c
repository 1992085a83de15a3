#include "po_secant.h"

#include <string.h>

#include "po_linear.h"

void po_secant_allocate(po_secant *s, size_t capacity, po_arena *arrays) {
  *s = (po_secant){.capacity = capacity};
  s->u = po_arena_reserve(arrays, capacity * PO_SECANT_DEPTH, sizeof *s->u);
  s->v = po_arena_reserve(arrays, capacity * PO_SECANT_DEPTH, sizeof *s->v);
  s->scale = po_arena_reserve(arrays, capacity, sizeof *s->scale);
  s->step = po_arena_reserve(arrays, capacity, sizeof *s->step);
}

void po_secant_clear(po_secant *s, size_t n) {
  s->n = n;
  po_secant_drop(s);
  for (size_t j = 0; j < n; ++j)
    s->scale[j] = 1.0;
}

void po_secant_begin(po_secant *s) {
  s->has_step = false;
}

void po_secant_drop(po_secant *s) {
  s->count = 0;
  s->sign = 1;
  s->has_step = false;
}

/* v = step' / |step|^2 of the last step, with components relative to their scales. Returned: v .
 * z. */
static double last_step(const po_secant *s, const double *z, double *v) {
  double square = 0.0;
  for (size_t j = 0; j < s->n; ++j) {
    const double part = s->step[j] / s->scale[j];
    square += part * part;
    v[j] = part / s->scale[j];
  }
  if (!(square > 0.0))
    return 0.0;
  for (size_t j = 0; j < s->n; ++j)
    v[j] /= square;
  return po_linear_dot(s->n, v, z);
}

void po_secant_step(po_secant *s, double *change) {
  for (size_t k = 0; k < s->count; ++k)
    po_linear_add(s->n, po_linear_dot(s->n, s->v + k * s->capacity, change), s->u + k * s->capacity,
                  change);
  if (s->count == PO_SECANT_DEPTH) { /* the oldest correction is the least useful one, but the later
                                        ones depend on it: drop all */
    po_secant_drop(s);
  } else if (s->has_step) {
    double *u = s->u + s->count * s->capacity, *v = s->v + s->count * s->capacity;
    const double denominator = 1.0 - last_step(s, change, v);
    if (denominator > PO_LEAST_DETERMINANT) {
      for (size_t j = 0; j < s->n; ++j)
        u[j] = change[j] /= denominator;
      ++s->count;
    }
  }
  memcpy(s->step, change, s->n * sizeof *change);
  s->has_step = true;
}
