/* Broyden's updates of a fixed approximate inverse M of a Jacobian: what successive steps of an
 * iteration tell about it, as a product of rank-one corrections, (1 + u_k v_k') ... (1 + u_1 v_1')
 * M. C. T. Kelley, Iterative Methods for Linear and Nonlinear Equations, SIAM 1995, Sec. 7.3. */
#ifndef PO_SECANT_H
#define PO_SECANT_H

#include <stdbool.h>
#include <stddef.h>

enum { PO_SECANT_DEPTH = 16 };

typedef struct {
  size_t n, capacity, count;
  double *u, *v; /* capacity x PO_SECANT_DEPTH: the corrections */
  double *scale; /* n: components of a step are compared in parts of these */
  double *step;  /* n: the last step */
  bool has_step; /* the next change follows from the last step */
} po_secant;

/* Given: room for vectors of `capacity`. Returned: whether there was memory. */
bool po_secant_allocate(po_secant *s, size_t capacity);
void po_secant_free(po_secant *s);

/* Forgets all corrections: M is new, vectors have n components, all scales are 1. */
void po_secant_clear(po_secant *s, size_t n);

/* The next change does not follow from the last: another iteration begins, or a step was cut. */
void po_secant_begin(po_secant *s);

/* Given: change = -M residual, n. Returned in place: the step to take, which is remembered. */
void po_secant_step(po_secant *s, double *change);

#endif
