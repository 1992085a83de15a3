/* How far the numbers of a result can be relied on: how well the discrete equations hold, how
 * they are conditioned, and how many digits of the pull-off force the inputs' last bits leave. */
#ifndef PO_DIAGNOSTICS_H
#define PO_DIAGNOSTICS_H

#include <stdbool.h>
#include <stddef.h>

#include "po_balance.h"
#include "po_diagnosis.h"
#include "po_kept.h"
#include "po_reverse_trace.h"

/* The equations at one state of the branch. */
typedef struct {
  po_kept_kind at;
  double approach, load;
  size_t nodes;
  po_diagnosis found;
} po_diagnosed_state;

/* The pull-off force when an input is moved to the next number a double holds, up and down, and
 * the scene solved anew, for each of tabor, radius, and, of a wavy scene, amplitude, wavelength. */
typedef struct {
  size_t solves; /* 0: not done */
  size_t failed; /* of these */
  double change; /* largest of the force, relative; NAN: none */
  double
      predicted; /* the same from the sensitivities, and what the residual and rounding do; NAN */
  double folds;  /* largest change of a fold's approach, eps; NAN: another number of folds */
} po_moved;

typedef struct {
  po_diagnosed_state *states; /* in the order start, pull_off, end, folds */
  size_t state_count;
  size_t undiagnosed;   /* states that could not be */
  double residual;      /* the largest of the states; NAN: none, as of a rigid scene */
  double rounding;      /* what rounding may make of a residual, the largest */
  bool has_sensitivity; /* whether that of the force is set */
  po_sensitivity force; /* d ln(force) / d ln(key); residual and rounding relative to the force */
  po_moved moved;
  double energy_defect;    /* of dU = W dapproach along the branch, see po_balance.h; NAN: none */
  double energy_defect_at; /* approach where it is largest */
  po_reverse_trace reverse_trace;
  double seconds; /* for all of this, by the clock */
} po_diagnostics;

/* Decimal digits that a relative change leaves: at most those of a double. NAN of NAN. */
double po_digits_left(double change);

#endif
