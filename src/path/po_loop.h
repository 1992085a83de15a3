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

#include <stdbool.h>

#include "po_stable.h"

/* The preload: loading is reversed when the approach (eps) or the load (pi w R) reaches this value;
 * NAN: no limit. Under load control only the load counts. */
typedef struct {
  double approach, load;
} po_preload;

/* A jump between two equilibria at fixed approach or at fixed load. After complete separation the
 * approach is -INFINITY and the position NAN. */
typedef struct {
  bool loading;
  po_path_state before, after;
  double energy_lost; /* decrease of U at fixed approach, of U - W approach at fixed load, in pi w R
                         eps; NAN: unbounded, the bodies separate under tension */
  double interpolated;      /* po_path_energy_difference where it ends */
  double energy_lost_error; /* bound of the error of energy_lost; NAN: unknown */
} po_jump;

typedef struct {
  po_control control;
  po_path_state preload;        /* the state at which loading was reversed */
  po_path_state pull_off;       /* the state with the greatest tension in unloading */
  po_path_error pull_off_error; /* bounds of the errors of its approach and load; NAN: unknown */
  po_jump *jumps;               /* the jumps of loading, then those of unloading */
  size_t jump_count, loading_jumps;
  double energy_lost; /* the sum over all jumps; NAN if one of them is */
  double work; /* integral of the load over the approach along the complete loop, by quadrature of
                  the loads; NAN unless the loop is closed */
  double energy_lost_error, work_error; /* bounds of their errors; NAN: unknown */
  double interpolated; /* greatest po_path_energy_difference of preload and ends of jumps */
  double energy_error; /* bound of the errors of the energies of all states at their approaches;
                          NAN: unknown */
} po_loop;

/* Follows a curve of equilibria from separation to the preload and back. Under load control loading
 * begins at load 0. Returned: loop, to be cleared with po_loop_clear. Status: PO_NOT_FOUND if the
 * curve ends before the preload, or does not begin far enough out; PO_NO_MEMORY. */
po_status po_loop_follow(const po_path *path, po_control control, po_preload preload,
                         po_loop *loop);
void po_loop_clear(po_loop *loop);

#endif
