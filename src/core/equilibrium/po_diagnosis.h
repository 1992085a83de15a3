/* Accuracy of one equilibrium: the residual of Eq 15 in extended precision, condition numbers, and
 * the sensitivity of the load to the parameters of the scene. */
#ifndef PO_DIAGNOSIS_H
#define PO_DIAGNOSIS_H

#include "po_diagnostics.h"
#include "po_equilibrium.h"

/* Fills the gaps of a state beyond its first `core` nodes by fixed-point iteration of Eq 15, which
 * contracts because tractions far out hardly deflect the surface. Given: state, n + 1, with the
 * first `core` gaps and the approach. Status: PO_NOT_CONVERGED. */
po_status po_diagnosis_complete(po_equilibrium *e, size_t core, double *state);

/* Diagnoses an equilibrium. Given: a state, n + 1, near an equilibrium, which may be a fold. The
 * residual, the law and the initial gap are evaluated in twice the precision (po_dd.h); the
 * influence matrix is the one of the solver. Status: PO_NO_MEMORY; PO_SINGULAR. Source: LAPACK
 * dgecon for the condition numbers. */
po_status po_diagnosis_make(po_equilibrium *e, const double *state, po_diagnosis *made);

/* The derivatives of f + deflection of Eq 15 at a node by the logarithms of the parameters, with
 * the tractions fixed. Given: the radius of the node, eps; whether waves are resolved there; the
 * deflection, eps. */
po_sensitivity po_sensitivity_sources(const po_scene *scene, double r, bool resolved,
                                      double deflection);

/* Computes the sensitivities by the adjoint method: one transposed solve. Given: as for
 * po_diagnosis_make, but not at a fold. The derivative of the averaged waves beyond the core with
 * respect to the wavelength is neglected. Accuracy: agrees to 1e-5 with differences of complete
 * solves (tests/unit/test_diagnosis.c). Status: as po_diagnosis_make. */
po_status po_sensitivity_make(po_equilibrium *e, const double *state, po_sensitivity *made);

#endif
