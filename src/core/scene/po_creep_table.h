/* Viscoelastic materials that are given as a table: a Prony series of the modulus or of the
 * compliance. See doc/guide.md, "Viscoelastic bodies". */
#ifndef PO_CREEP_TABLE_H
#define PO_CREEP_TABLE_H

#include <stdbool.h>
#include <stdint.h>

#include "po_creep.h"
#include "po_digest.h"

typedef struct po_creep_table {
  char *path;                    /* as given */
  char digest[PO_DIGEST_LENGTH]; /* of the content */
  bool in_seconds;               /* the times have a unit: tau_0 is 1 s */
  double relaxed;                /* modulus, Pa; NAN: the weights have no unit of a modulus */
  po_creep_terms terms;
  uint64_t pipe; /* po_path_pipe; 0: a file */
  struct po_creep_table *next;
} po_creep_table;

/* Reads a table, or finds it among those that were read: a file (po_csv.h) with the column `time`
 * and one of `modulus` and `compliance`. It stays in memory until the program ends. Thread-safe.
 * Status: PO_CANNOT_READ, with file and line, if the file cannot be read, a time does not rise or
 * is not from 1e-12 to 1e12, a weight is not > 0, or there is no relaxed modulus > 0;
 * PO_NO_MEMORY. */
po_status po_creep_table_read(const char *path, const po_creep_table **table);

/* The terms of the compliance of a solid whose modulus relaxes as
 *
 *   E(t) = relaxed + sum_m weight_m exp(-t/time_m).
 *
 * Its Laplace transform times s has one zero -1/tau between two poles -1/time_m, and one beyond the
 * longest time. Given: relaxed > 0; 1 to PO_MOST_CREEP_TERMS terms, ascending times > 0, weights
 * > 0. Accuracy: 1e-13 of each time and of J(t) (tests/unit/test_creep_table.c). */
void po_creep_of_modulus(double relaxed, const po_creep_terms *modulus, po_creep_terms *compliance);

/* Releases all tables that were read. No material set from one may be used after it. */
void po_creep_table_clear(void);

#endif
