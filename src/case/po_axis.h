/* An axis: a key of the scene and a list of its values. Sweeps and conditions consist of axes. */
#ifndef PO_AXIS_H
#define PO_AXIS_H

#include <stdbool.h>

#include "po_request.h"

/* A value of an axis as a number. A name, such as that of a scheme, is represented by its place in
 * the list of names. */
typedef struct {
  double number;
  unsigned index; /* of the value in po_axis.values */
} po_axis_value;

/* A key and its values as written; or from, to, count and scale, from which po_axis_fill computes
 * the values. */
typedef struct {
  char *key;
  char **values;
  unsigned values_count;
  char *from_text;
  char *to_text;
  char *count_text;
  char *scale;              /* "log" or "linear"; NULL: linear */
  po_axis_value *ascending; /* the values sorted by number; NULL: not checked yet */
} po_axis;

/* Reports whether a scene fulfils all conditions of a list: for each axis, the value of the key is
 * one of those of the axis. */
bool po_axes_hold(const po_axis *axes, unsigned count, const po_request *request);

#endif
