/* Equally or geometrically spaced values in a range: for the sweep of a case and the scenes of
 * `pulloff follow`. */
#ifndef PO_RANGE_H
#define PO_RANGE_H

#include <stdbool.h>
#include <stddef.h>

#include "po_number.h"

enum { PO_MOST_VALUES = 10000 };

typedef struct {
  double from, to; /* the first and the last value */
  size_t count;    /* at least 2 */
  bool log;        /* true: equal ratios (both ends are > 0); false: equal differences */
} po_range;

/* Prints the value with this index, from 0, as text. */
void po_range_print(const po_range *range, size_t index, char text[PO_NUMBER_LENGTH]);

/* Prints a computed value, rounded to 6 significant digits; the printed value is used. A command
 * that repeats one scene is then exact, and the last bits of pow and exp, which differ between
 * libraries, have no effect. */
void po_range_round(double value, char text[PO_NUMBER_LENGTH]);

/* Parses "log" or "linear" into *log. Returned: false for other texts. */
bool po_range_read_scale(const char *scale, bool *log);

#endif
