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
  PO_CREEP_PRONY, /* a table of times and weights (po_creep_table.h) */
} po_creep_kind;

struct po_creep_table;

typedef struct {
  po_creep_kind kind;
  double ratio;                       /* k, relaxed over glassy modulus, 0 < k <= 1 */
  double exponent;                    /* n of PO_CREEP_GAMMA */
  const struct po_creep_table *table; /* of PO_CREEP_PRONY; otherwise NULL */
  const char *shown;                  /* its path in documents; NULL: as given */
} po_creep;

#define PO_CREEP_EXPECTED                                                                          \
  "sls:K or gamma:K,N, with the ratio of the relaxed to the glassy modulus K, 0 < K <= 1, and an " \
  "exponent N from 0.05 to 10, or prony:FILE, a CSV file with the columns time and modulus or "    \
  "compliance"

enum { PO_CREEP_PATH_LENGTH = 1000, PO_CREEP_TEXT = PO_CREEP_PATH_LENGTH + 8 };

/* Reads "sls:K", "gamma:K,N" or "prony:FILE". If that fails, the material is unchanged. Status:
 * PO_BAD_INPUT, without a message, if the text is not that; PO_CANNOT_READ, as
 * po_creep_table_read, or for a path longer than PO_CREEP_PATH_LENGTH; PO_NO_MEMORY. */
po_status po_creep_read(const char *text, po_creep *creep);

/* Writes the text of a material that is not PO_CREEP_NONE, which po_creep_read reads back; or, as
 * its identity, with the digest of the content of a table in place of the path. */
void po_creep_write(const po_creep *creep, char text[PO_CREEP_TEXT]);
void po_creep_write_identity(const po_creep *creep, char text[PO_CREEP_TEXT]);

/* Returned: what follows "prony:"; NULL: the text names no table. */
const char *po_creep_file_of(const char *text);

/* The path of a table; NULL: the material is none. */
const char *po_creep_file(const po_creep *creep);

/* Returned: whether the times of a material are in s, so that tau_0 is 1 s. */
bool po_creep_is_in_seconds(const po_creep *creep);

/* The relaxed modulus of a table whose weights have a unit, modulus_mpa or compliance_per_gpa, Pa:
 * Young's modulus, the shear modulus or another one, as the table does not say; NAN otherwise. */
double po_creep_relaxed(const po_creep *creep);

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
 * J(t) at t >= duration (tests/unit/test_rate.c). */
void po_creep_terms_fill(const po_creep *creep, double duration, po_creep_terms *terms);

/* The mean of the retardation times, tau_0, by their weights. */
double po_creep_mean_time(const po_creep *creep);

/* J(t), t >= 0 in tau_0. */
double po_creep_compliance(const po_creep_terms *terms, double t);

#endif
