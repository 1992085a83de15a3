/* The time of one equilibrium, and of its parts, on the mesh of a solved scene: with the influence
 * matrix and the factors in hierarchical form, and with dense ones. */
#ifndef ONE_EQUILIBRIUM_H
#define ONE_EQUILIBRIUM_H

#include "operations.h"
#include "po_result.h"

typedef struct {
  operations work;
  double seconds;
} timed;

typedef struct {
  double
      seconds; /* factors, the correction of a state 1e-3 eps of approach away, and the tangent */
  size_t iterations, active; /* Newton iterations; nodes of the factors */
  timed product, factors, solve;
} way_cost;

typedef struct {
  size_t nodes;
  way_cost hierarchical, dense;
  bool has_dense;
} equilibrium_cost;

/* Given: a scene on a bounded surface, and its result with a profile; the largest number of nodes
 * that is also solved with dense matrices. Status: that of the solver; PO_NO_MEMORY. */
po_status equilibrium_measure(const po_scene *scene, const po_result *solved, size_t most_dense,
                              equilibrium_cost *cost);

#endif
