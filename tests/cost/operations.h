/* Floating-point operations and memory traffic of the parts of an equilibrium. */
#ifndef OPERATIONS_H
#define OPERATIONS_H

#include "po_equilibrium.h"

/* Additions and multiplications, each counted as one; bytes of matrices and factors that are read
 * or written once. What is smaller by an order, such as vectors, is not counted. */
typedef struct {
  double flops, bytes;
} operations;

/* A product with the influence matrix; the factors of the Jacobian at the state last factorised;
 * and a solve with them. */
operations operations_of_product(const po_equilibrium *e);
operations operations_of_factors(const po_equilibrium *e);
operations operations_of_solve(const po_equilibrium *e);

#endif
