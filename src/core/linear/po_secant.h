/* Broyden's updates of an approximate inverse M of a Jacobian: each step of an iteration adds a
 * rank-one correction to a product (1 + u_k v_k') ... (1 + u_1 v_1') M. Source: C. T. Kelley,
 * Iterative Methods for Linear and Nonlinear Equations, SIAM 1995, Sec. 7.3. */
#ifndef PO_SECANT_H
#define PO_SECANT_H

#include <stdbool.h>
#include <stddef.h>

#include "po_memory.h"

/* Least determinant of a correction of rank one. That of an update is the denominator 1 - v.z, the
 * inverse of the factor by which it lengthens the step: with a smaller one it is left out. Factors
 * whose border changes by a smaller one are discarded. */
static const double PO_LEAST_DETERMINANT = 0.2;

/* The largest number of corrections; then all are dropped. */
enum { PO_SECANT_DEPTH = 16 };

typedef struct {
  size_t n, capacity, count;
  double *u, *v; /* capacity x PO_SECANT_DEPTH: the vectors u_k and v_k */
  double *scale; /* n: components of a step are measured relative to these scales */
  double *step;  /* n: the last step */
  bool has_step; /* the next change is computed at the end of the last step */
  int sign; /* of the determinant of the Jacobian over that of M, if GMRES found it; otherwise 1 */
} po_secant;

/* Allocates updates for vectors of length up to `capacity`. The memory belongs to `arrays`, which
 * says whether it ran out. */
void po_secant_allocate(po_secant *s, size_t capacity, po_arena *arrays);

/* Deletes all corrections, because M has changed. Vectors then have length n and all scales are
 * 1. */
void po_secant_clear(po_secant *s, size_t n);

/* Call if the next change is not computed at the end of the last step: a new iteration begins, or a
 * step was shortened. */
void po_secant_begin(po_secant *s);

/* Deletes all corrections. */
void po_secant_drop(po_secant *s);

/* Given: change = -M residual, n. Returned: in `change`, the corrected step, which is stored. */
void po_secant_step(po_secant *s, double *change);

#endif
