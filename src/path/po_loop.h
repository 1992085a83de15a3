/* Loading and unloading along a curve of equilibria, with its jumps, as a slow test does it.
 *
 * Where a jump lands. The surface relaxes against a local damping, so the deflection u obeys
 * du/dt = -(half Laplacian) u + local forces, at fixed approach (or fixed load). Such equations
 * keep order: if one state's surfaces are nowhere farther apart than another's, they stay so. An
 * equilibrium loses stability by its slowest mode, which has one sign (Krein and Rutman); pushed
 * along it the surfaces close everywhere (in loading) or open everywhere (in unloading), for ever,
 * and come to rest at the first equilibrium in that order. Along a traced branch this is the next
 * stable equilibrium after the fold at that approach (or load) in loading, the one next before it
 * in unloading. Nothing above reads energies: that every jump goes down in energy is a test.
 * tests/unit/test_relaxation.c relaxes the equations in time from folds of scenes that have several
 * stable equilibria there, and lands on the same. An equilibrium on a closed branch of its own,
 * which no trace from far out meets, would not be seen. */
#ifndef PO_LOOP_H
#define PO_LOOP_H

#include <stdbool.h>

#include "po_stable.h"

/* Where loading is reversed: as soon as the approach or the load is this; NAN: not by this. In load
 * control only the load counts. */
typedef struct {
  double approach, load;
} po_preload;

/* From one equilibrium to another at fixed approach, or at fixed load. Apart for ever the approach
 * is -INFINITY and the position NAN. */
typedef struct {
  bool loading;
  po_path_state before, after;
  double energy_lost; /* drop of U, or under a load of U - W approach; NAN: boundless, the bodies
                         part under tension */
} po_jump;

typedef struct {
  po_control control;
  po_path_state preload;  /* where loading was reversed */
  po_path_state pull_off; /* the greatest tension met in unloading */
  po_jump *jumps;         /* loading, then unloading */
  size_t jump_count, loading_jumps;
  double energy_lost; /* in all jumps; NAN as theirs is */
  double work; /* integral of load d approach over the whole path, by quadrature of the loads;
                  NAN unless the path is closed */
} po_loop;

/* Follows a curve from apart to the preload and back. In load control the bodies come together
 * under no load. Returned: to be given to po_loop_clear. Status: PO_NOT_FOUND when the curve ends
 * before the preload is reached, or
 * begins too close; PO_NO_MEMORY. */
po_status po_loop_follow(const po_path *path, po_control control, po_preload preload,
                         po_loop *loop);
void po_loop_clear(po_loop *loop);

#endif
