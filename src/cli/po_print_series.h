/* The printed output of a series of scenes in which one parameter varies. */
#ifndef PO_PRINT_SERIES_H
#define PO_PRINT_SERIES_H

#include <stddef.h>

#include "po_request.h"
#include "po_result.h"
#include "po_scene_flags.h"
#include "po_status.h"

typedef struct {
  po_scene_flags flags; /* with the units, if the scene is given in SI units */
  double value;         /* of the parameter that varies */
} po_series_scene;

typedef struct {
  const char *name; /* of the parameter that varies */
  size_t count;     /* of requests, scenes and results */
  const po_request *requests;
  const po_series_scene *scenes;
  const po_result *results;
} po_printed_series;

/* Prints a row for each pull-off, in the units in which the scenes are given. */
po_status po_print_series(const po_printed_series *series);

/* Prints a block of rows for each fold of the first scene. */
po_status po_print_series_folds(const po_printed_series *series);

/* Prints the document pulloff-line/1. */
po_status po_print_series_json(const po_printed_series *series);

/* Writes the pull-offs as CSV to a file; "-" is standard output. */
po_status po_print_series_curve(const po_printed_series *series, const char *file);

#endif
