/* The energy of the interaction beyond the mesh of an unbounded surface. */
#ifndef PO_FAR_ENERGY_H
#define PO_FAR_ENERGY_H

#include <stdbool.h>
#include <stddef.h>

#include "po_scene.h"

/* Ratio of the ends of a piece at least, of the pieces of an integral that follow the rows of a
 * table: a few rows in so short a piece do no harm. */
static const double PO_SHORTEST_PIECE = 1.02;

/* The integral of phi(H) r dr from `begin` to infinity, phi averaged over the waves; less that of
 * the initial gap at approach 0 if the energy is infinite (po_scene_has_infinite_energy). Given:
 * the radius where the panel to infinity begins, eps; its nodes, with their gaps; the approach; the
 * table of panels (po_panel_table_get) can be made. Accuracy: the deflection is interpolated
 * between the nodes, everything else is exact to 1e-10 (tests/unit/test_energy.c). */
double po_far_energy(const po_scene *scene, double begin, size_t nodes, const double *node,
                     const double *gap, double approach);

/* Whether the energy beyond the mesh must be integrated in this way. Otherwise the weights of the
 * traction are exact for it: where it falls as a whole power of the radius that is not too high. */
bool po_far_energy_is_apart(const po_scene *scene);

#endif
