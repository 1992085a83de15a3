/* A key of the scene and values of it: of a sweep, of a condition. */
#ifndef PO_AXIS_H
#define PO_AXIS_H

#include <stdbool.h>

#include "po_request.h"

/* A value of an axis as a number: of a name, its place in the list of names. */
typedef struct {
  double number;
  unsigned index; /* of the value as written */
} po_axis_value;

/* A key and values of it, as written; or from, to, count and scale, from which the values are made
 * (po_case_axis.c). */
typedef struct {
  char *key;
  char **values;
  unsigned values_count;
  char *from_text;
  char *to_text;
  char *count_text;
  char *scale;              /* "log", "linear"; NULL: linear */
  po_axis_value *ascending; /* the values by their numbers; NULL: not checked yet */
} po_axis;

/* Whether all conditions of a list hold for a scene. */
bool po_axes_hold(const po_axis *axes, unsigned count, const po_request *request);

#endif
