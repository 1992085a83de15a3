/* Every reference table there is, whether or not a case uses it: present, intact, known.
 *
 * reference/index.txt names the tables of the folder, one file name a line; so one that was deleted
 * is noticed. Tables of the folders published/ (which need not be there) are found, not listed. */
#ifndef PO_REFERENCE_LIST_H
#define PO_REFERENCE_LIST_H

#include <stdbool.h>
#include <stddef.h>

#include "po_reference.h"

typedef struct {
  char *name; /* "reference/struve.csv" */
  bool listed;
  bool intact;       /* present, complete, of the checksum it states */
  char message[300]; /* why it is not */
  po_ledger ledger;  /* of an intact one, as is what follows */
  size_t rows;
  char uncertainty[120];
} po_reference_entry;

typedef struct {
  po_reference_entry *entries; /* sorted by name */
  size_t count;
} po_reference_list;

/* Reads and checks all tables of a data folder. Status: PO_CANNOT_READ (the index or the folder),
 * PO_NO_MEMORY; a table that is not intact is in the list, not a status. */
po_status po_reference_list_open(const char *data_folder, po_reference_list *list);
void po_reference_list_close(po_reference_list *list);

#endif
