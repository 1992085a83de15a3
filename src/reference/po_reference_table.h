/* A reference, and what is read from its table: which rows are of a scene, their numbers, their
 * points. Tables of reference data and of pins are read by it alike. */
#ifndef PO_REFERENCE_TABLE_H
#define PO_REFERENCE_TABLE_H

#include "po_check.h"
#include "po_csv.h"
#include "po_input.h"
#include "po_request.h"
#include "po_result.h"
#include "po_status.h"

typedef enum { PO_LEDGER_ORACLE, PO_LEDGER_PUBLISHED, PO_LEDGER_PIN } po_ledger;

typedef struct {
  const char *name; /* as the case names it */
  po_ledger ledger;
  po_reference_type type;
  char *path;                    /* of pins: their file */
  char *shown;                   /* of pins: how messages and records call it */
  po_csv table;                  /* of a table and of pins; empty when nothing is pinned yet */
  char digest[PO_DIGEST_LENGTH]; /* of the whole file; of the name for a closed form */
} po_reference;

/* What a reference says of one number. */
typedef struct {
  double value;
  double uncertainty; /* absolute; NAN: not given */
} po_reference_number;

/* A point of a reference curve or a special point. */
typedef struct {
  double approach;
  double load;
  double approach_uncertainty;
  double load_uncertainty;
  po_special_kind kind; /* of special points */
} po_reference_point;

/* "oracle", "published", "pin". */
const char *po_ledger_name(po_ledger ledger);

/* Reads the table in the file `path`, which messages call `shown`, and checks its headers and its
 * checksum: reference->table, digest and ledger. Status: PO_CANNOT_READ with file and line. */
po_status po_reference_read(const char *path, const char *shown, po_reference *reference);
void po_reference_close(po_reference *reference);

/* Whether the headers of its table that name keys of the scene hold for a scene; whether a row,
 * these headers included, is of a scene. */
bool po_reference_headers_hold(const po_reference *reference, const po_request *request);
bool po_reference_row_is_of(const po_reference *reference, size_t row, const po_request *request);

/* A number of a row, with its uncertainty: that of the column NAME_uncertainty, else as for all
 * rows. Status: PO_CANNOT_READ: the column is missing or holds no number. */
po_status po_reference_cell(const po_reference *reference, size_t row, const char *name,
                            po_reference_number *number);

/* A row as a point of the curve or as a special point, by `quantity`; *fits: whether it is of that
 * quantity, as a row may be a special point of the other one. Status: as above. */
po_status po_reference_row_point(const po_reference *reference, size_t row, po_quantity quantity,
                                 po_reference_point *point, bool *fits);

#endif
