/* The table of a reference, for reference data and for pins: the rows of a scene, and the numbers
 * and points in a row. */
#ifndef PO_REFERENCE_TABLE_H
#define PO_REFERENCE_TABLE_H

#include "po_check.h"
#include "po_csv.h"
#include "po_input.h"
#include "po_request.h"
#include "po_result.h"
#include "po_status.h"
#include "po_text.h"

typedef enum { PO_LEDGER_ORACLE, PO_LEDGER_PUBLISHED, PO_LEDGER_PIN } po_ledger;

typedef struct {
  const char *name; /* as in the case file */
  po_ledger ledger;
  po_reference_type type;
  char *path;                    /* of the file of pins; NULL for other references */
  char *shown;                   /* name of that file in messages and records */
  po_csv table;                  /* if the reference is a table or pins; empty without pins */
  char digest[PO_DIGEST_LENGTH]; /* of the whole file; of the name if there is no file */
  char *converted;               /* cells of the table that were in SI units; NULL: none */
} po_reference;

/* A number of a reference. */
typedef struct {
  double value;
  double uncertainty; /* absolute; NAN: not given */
} po_reference_number;

/* A point of a reference curve, or a special point. */
typedef struct {
  double approach;
  double load;
  double approach_uncertainty;
  double load_uncertainty;
  po_special_kind kind; /* of special points */
} po_reference_point;

/* Returned: the name of a reference in messages and records: the path of the file of pins, else the
 * name in the case file. */
const char *po_reference_shown(const po_reference *reference);

/* Returned: "oracle", "published" or "pin". */
const char *po_ledger_name(po_ledger ledger);

/* Reads a table, checks its headers and its checksum, and fills reference->table, digest and
 * ledger.
 * Given: `shown`, the name of the file in messages.
 * Status: PO_CANNOT_READ with file and line. */
po_status po_reference_read(const char *path, const char *shown, po_reference *reference);
void po_reference_close(po_reference *reference);

/* Converts the columns and the headers whose names end in an SI unit, such as force_nN, radius_m or
 * load_uncertainty_nN, to the dimensionless ones without it. An uncertainty without a unit has that
 * of all such columns. Given: the units of the scene that is compared. Status: PO_CANNOT_READ with
 * file and line; PO_NO_MEMORY. */
po_status po_reference_use_units(po_reference *reference, const po_units *units);

/* Finds the first row from number *row on that belongs to a scene: all columns and headers that are
 * keys of the scene have its values. Returned: whether there is one; its number in *row. */
bool po_reference_next_row(const po_reference *reference, const po_request *request, size_t *row);

/* Says which row is nearest to a scene that the table does not contain, and by what they differ:
 * "nearest is line 7: tabor 0.5 instead of 0.51". Returned: false for a table without rows. */
bool po_reference_nearest(const po_reference *reference, const po_request *request, po_text *words);

/* Reads a number of a row with its uncertainty. The uncertainty is in the column NAME_uncertainty,
 * else in the column or the header `uncertainty`. Status: PO_CANNOT_READ (the column is missing or
 * does not hold a number). */
po_status po_reference_cell(const po_reference *reference, size_t row, const char *name,
                            po_reference_number *number);

#endif
