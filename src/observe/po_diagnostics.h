/* Diagnostics of a result: residuals of the discrete equations, condition numbers, and the number
 * of digits of the pull-off force that are determined by the parameters of the scene. */
#ifndef PO_DIAGNOSTICS_H
#define PO_DIAGNOSTICS_H

#include <stdbool.h>
#include <stddef.h>

#include "po_balance.h"
#include "po_diagnosis.h"
#include "po_kept.h"
#include "po_reverse_trace.h"

/* The diagnosis of one state of the branch. */
typedef struct {
  po_kept_kind at;
  double approach, load;
  size_t nodes;
  po_diagnosis found;
} po_diagnosed_state;

/* Changes of the results when a parameter is changed by one unit in the last place, up and down,
 * and the scene is solved again: for the Tabor parameter, the radius and, of a wavy scene,
 * amplitude and wavelength. */
typedef struct {
  size_t solves;    /* number of solves; 0: none was made */
  size_t failed;    /* number of these that failed */
  double change;    /* largest relative change of the pull-off force; NAN: none */
  double excess;    /* largest change of the pull-off force over the sum of the error estimates of
                       both solves; NAN: none, or not estimated */
  double predicted; /* bound of the same from the sensitivities, the residual and rounding; NAN:
                       none */
  double
      folds; /* largest change of the approach of a fold, eps; NAN: the number of folds changed */
} po_moved;

typedef struct {
  po_diagnosed_state *states; /* in the order start, pull_off, end, folds */
  size_t state_count;
  size_t undiagnosed;   /* number of states whose diagnosis failed */
  double residual;      /* largest of all states; NAN: none, as for a rigid scene */
  double rounding;      /* largest bound of a residual due to rounding */
  bool has_sensitivity; /* whether `force` is set */
  po_sensitivity
      force; /* d ln(force) / d ln(parameter); residual and rounding relative to the force */
  po_moved moved;
  double energy_defect;    /* of dU = W d(approach) along the branch, see po_balance.h; NAN: none */
  double energy_defect_at; /* approach where it is largest */
  po_reverse_trace reverse_trace;
  double seconds; /* wall time of the diagnostics */
} po_diagnostics;

/* Number of decimal digits that are unchanged by a relative change, at most those of a double; NAN
 * for NAN. */
double po_digits_left(double change);

#endif
