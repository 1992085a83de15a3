/* The values of a quantity that runs along a range: the sweep of a case, the scenes of
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
  bool log;        /* equal factors; else equal steps. Both ends are then > 0 */
} po_range;

/* Value number `index`, from 0, as text. */
void po_range_print(const po_range *range, size_t index, char text[PO_NUMBER_LENGTH]);

/* A value that is computed, not given: rounded to 6 significant digits and used as printed. A
 * command that solves one scene again is then exact, and the last bits of pow and exp, which differ
 * between libraries, do not matter. */
void po_range_round(double value, char text[PO_NUMBER_LENGTH]);

/* Reads "log" or "linear" into *log; false when it is neither. */
bool po_range_read_scale(const char *scale, bool *log);

#endif
