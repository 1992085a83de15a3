/* A quasi-static loading and unloading loop along a curve of equilibria, with its jumps.
 *
 * Where a jump ends. The surface relaxes against a local damping, so that the deflection u obeys
 * du/dt = -(half Laplacian) u + local forces at fixed approach (or fixed load). Such equations
 * preserve order: if the surfaces of one state are nowhere farther apart than those of another
 * state, this remains so. An equilibrium loses stability by its slowest mode, which has one sign
 * (Krein and Rutman). Perturbed along this mode, the surfaces approach each other everywhere (in
 * loading) or separate everywhere (in unloading), monotonically in time, and come to rest at the
 * first equilibrium in that order. Along a traced branch this is, in loading, the next stable
 * equilibrium after the fold at the same approach (or load), and in unloading the previous one. The
 * argument does not use energies; a test checks that every jump lowers the energy.
 * tests/unit/test_relaxation.c integrates the equations in time from folds with several stable
 * equilibria at the same approach and reaches the same states. An equilibrium on a closed branch,
 * which no trace that starts far out meets, is not found. */
#ifndef PO_LOOP_H
#define PO_LOOP_H

#include "po_path.h"

/* Follows a curve of equilibria from separation to the preload and back, at given approach, at
 * given load, and through a spring. The load-controlled loop begins at load 0 and is reversed at
 * the load of the displacement-controlled preload, or at load 0 if that load is tensile; that
 * through the spring is reversed at the preload. Without a stable equilibrium at load 0 there is no
 * load-controlled loop. Given: a preload with an approach or a load >= 0;
 * the stiffness of the spring, INFINITY: none; whether the loops at given approach and through the
 * spring have rows, whose row_area_error is then what the trapezoidal rule lacks. Returned:
 * hysteresis, to be cleared with po_hysteresis_clear. Status: PO_NOT_FOUND if the curve ends before
 * the preload, or does not begin far enough out; PO_NO_MEMORY. */
po_status po_hysteresis_follow(const po_path *path, po_preload preload, po_control spring,
                               bool rows, po_hysteresis *hysteresis);

/* Completes the rows of a loop whose states were moved to what is stated of special points: ends
 * and losses of jumps, positions of the base, and the indentation. */
void po_loop_rows_end(po_loop *loop);

#endif
