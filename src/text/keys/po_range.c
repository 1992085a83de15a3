#include "po_range.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "po_elementary.h"

void po_range_round(double value, char text[PO_NUMBER_LENGTH]) {
  snprintf(text, PO_NUMBER_LENGTH, "%.6g", value);
}

void po_range_print(const po_range *range, size_t index, char text[PO_NUMBER_LENGTH]) {
  const double part = (double)index / (double)(range->count - 1);
  po_range_round(range->log ? range->from * po_pow(range->to / range->from, part)
                            : range->from + part * (range->to - range->from),
                 text);
}

bool po_range_read_scale(const char *scale, bool *log) {
  *log = strcmp(scale, "log") == 0;
  return *log || strcmp(scale, "linear") == 0;
}
