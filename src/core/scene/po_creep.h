/* The creep of a linearly viscoelastic half-space with a constant Poisson ratio. The deflection by
 * a traction that is applied at time 0 and kept grows as
 *
 *   J(t) = 1 - (1 - k) sum_m w_m exp(-t/tau_m),   sum_m w_m = 1,
 *
 * relative to that of the relaxed body. k = J(0) is the ratio of the relaxed to the glassy modulus.
 * Times are in tau_0. See doc/method.md, "Viscoelastic bodies". */
#ifndef PO_CREEP_H
#define PO_CREEP_H

#include <stdbool.h>
#include <stddef.h>

#include "po_status.h"

typedef enum {
  PO_CREEP_NONE,  /* elastic */
  PO_CREEP_SLS,   /* one retardation time, tau_0: the standard linear solid */
  PO_CREEP_GAMMA, /* w(tau) = tau^(n - 1) exp(-tau)/Gamma(n), tau in tau_0 */
} po_creep_kind;

typedef struct {
  po_creep_kind kind;
  double ratio;    /* k, relaxed over glassy modulus, 0 < k <= 1 */
  double exponent; /* n of PO_CREEP_GAMMA */
} po_creep;

#define PO_CREEP_EXPECTED                                                                          \
  "sls:K or gamma:K,N, with the ratio of the relaxed to the glassy modulus K, 0 < K <= 1, and an " \
  "exponent N from 0.05 to 10"

/* Reads "sls:K" or "gamma:K,N". False if the text is not that; then the material is unchanged. */
bool po_creep_read(const char *text, po_creep *creep);

/* Writes the text of a material that is not PO_CREEP_NONE, which po_creep_read reads back. */
enum { PO_CREEP_TEXT = 80 };
void po_creep_write(const po_creep *creep, char text[PO_CREEP_TEXT]);

/* One retardation time, and its weight (1 - k) w_m. */
typedef struct {
  double time, weight;
} po_creep_term;

enum { PO_MOST_CREEP_TERMS = 160 };

typedef struct {
  double instant; /* J(0) */
  size_t count;
  po_creep_term term[PO_MOST_CREEP_TERMS]; /* ascending times */
} po_creep_terms;

/* The terms of a material for a test. The weights of the Gamma spectrum are those of the
 * trapezoidal rule in ln(tau); retardation times that are too short to matter are one term. Given:
 * duration, the shortest time, tau_0, in which the test changes anything, > 0. Accuracy: 1e-8 of
 * J(t) at t >= duration (tests/unit/test_creep.c). */
void po_creep_terms_fill(const po_creep *creep, double duration, po_creep_terms *terms);

/* J(t), t >= 0 in tau_0. */
double po_creep_compliance(const po_creep_terms *terms, double t);

#endif
