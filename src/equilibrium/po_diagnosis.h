/* How well an equilibrium was solved, and how well it can be: the residual in more digits than the
 * solver carries, condition numbers, and what the inputs' last bits do to the load. */
#ifndef PO_DIAGNOSIS_H
#define PO_DIAGNOSIS_H

#include "po_equilibrium.h"

/* Condition numbers are of the 1-norm, of the Jacobian of changes in parts of 1 + H. */
typedef struct {
  double residual;           /* largest of the discrete equations, in parts of 1 + H */
  double rounding;           /* what one rounding of each term of these equations makes, likewise */
  double condition;          /* at fixed approach: infinite at a fold */
  double bordered_condition; /* with the border of the arclength functional along the branch: finite
                                at folds */
} po_diagnosis;

/* The load of an equilibrium at fixed approach as a function of its inputs. At a pull-off, where
 * the load does not change along the branch, these are also the changes of the pull-off load. */
typedef struct {
  double tabor, amplitude, wavelength, radius; /* d load / d ln(key); 0 for what is not there */
  double residual; /* the change of the load, to first order, if the residual were taken away */
  double rounding; /* a bound of the same for one rounding of each term of the equations */
} po_sensitivity;

/* Fills the part of a state beyond its first `core` nodes from the equations there, by iteration:
 * far out tractions hardly act back. Status: PO_NOT_CONVERGED. */
po_status po_diagnosis_complete(po_equilibrium *e, size_t core, double *state);

/* Given: a state, n + 1, near an equilibrium, at a fold or not. The residual is evaluated in long
 * double (64 bits of mantissa, law and undeformed gap included; the influence matrix as it is).
 * Status: PO_NO_MEMORY; PO_SINGULAR. Source: LAPACK dgecon. */
po_status po_diagnosis_make(po_equilibrium *e, const double *state, po_diagnosis *made);

/* Given: as above, not at a fold. By the adjoint: one transposed solve. What waves that are
 * averaged far out do is left out. Accuracy: 1e-5 of differences of whole solves
 * (tests/unit/test_diagnosis.c). Status: as above. */
po_status po_sensitivity_make(po_equilibrium *e, const double *state, po_sensitivity *made);

#endif
