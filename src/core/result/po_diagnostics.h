/* Diagnostics of a result: residuals of the discrete equations, condition numbers, and the number
 * of digits of the pull-off force that are determined by the parameters of the scene. */
#ifndef PO_DIAGNOSTICS_H
#define PO_DIAGNOSTICS_H

#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"

typedef enum { PO_KEPT_START, PO_KEPT_FOLD, PO_KEPT_PULL_OFF, PO_KEPT_END } po_kept_kind;

/* Condition numbers are in the 1-norm. The Jacobian is scaled: equations and unknowns are relative
 * to 1 + H. */
typedef struct {
  double residual;           /* largest residual of Eq 15 at a node, relative to 1 + H */
  double rounding;           /* bound of the same if each term of the equation is rounded once */
  double condition;          /* at given approach: infinite at a fold */
  double bordered_condition; /* with the border of the arclength functional along the branch: finite
                                at a fold */
} po_diagnosis;

/* Derivatives of the load of an equilibrium at given approach. At pull-off the load is stationary
 * along the branch, so that they are also the derivatives of the load at pull-off. Loads are in pi
 * w R. */
typedef struct {
  double tabor, amplitude, wavelength,
      radius;      /* d load / d ln(parameter); 0 for parameters that the scene does not have */
  double residual; /* first-order change of the load when the residual is removed */
  double rounding; /* bound of the change of the load when each term of Eq 15 is rounded once */
} po_sensitivity;

/* The result of the reverse trace. */
typedef struct {
  bool made;             /* whether it was made: on panels only */
  po_status status;      /* of the reverse trace */
  char reason[256];      /* why the status is not PO_OK */
  size_t points;         /* steps and special points visited */
  size_t folds, extrema; /* numbers found */
  bool same; /* whether the special points of both traces agree in kind and number of unstable modes
              */
  /* largest differences between the two traces, eps and pi w R; 0 without special points, NAN if
   * `same` is false */
  double fold_approach, fold_load, extremum_approach, extremum_load;
  double excess; /* largest difference of a fold relative to the sum of both error estimates; 0 and
                    NAN as above */
} po_reverse_trace;

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
  double energy_defect; /* of dU = W d(approach) along the branch, see po_collector.h; NAN: none */
  double energy_defect_at; /* approach where it is largest */
  po_reverse_trace reverse_trace;
  double seconds; /* wall time of the diagnostics */
} po_diagnostics;

#endif
