/* The printed output of a series of scenes in which one parameter varies. */
#ifndef PO_PRINT_SERIES_H
#define PO_PRINT_SERIES_H

#include <stddef.h>

#include "po_request.h"
#include "po_result.h"
#include "po_status.h"
#include "po_texts.h"

typedef struct {
  po_texts given;
  char text[PO_NUMBER_LENGTH]; /* the value of the parameter that varies */
} po_series_scene;

typedef struct {
  const char *name; /* of the parameter that varies */
  size_t count;     /* of values, requests, scenes and results */
  const double *values;
  const po_request *requests;
  const po_series_scene *scenes;
  const po_result *results;
} po_printed_series;

/* Prints the document pulloff-line/1 if `json` is set. Otherwise prints a row for each pull-off, in
 * the units in which the scenes are given, or, with `folds`, a block of rows for each fold of the
 * first scene. Then writes the pull-offs as CSV to the file `curve`; "-" is standard output, on
 * which no rows are printed; NULL: none. */
po_status po_print_series(const po_printed_series *series, bool folds, bool json,
                          const char *curve);

#endif
