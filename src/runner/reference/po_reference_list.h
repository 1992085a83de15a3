/* All reference tables, including those that no case uses, and whether each is intact.
 *
 * reference/index.txt lists the tables of the folder, one file name a line, so that a deleted table
 * is detected. Tables in reference/published/ are not listed; that folder may be absent. */
#ifndef PO_REFERENCE_LIST_H
#define PO_REFERENCE_LIST_H

#include <stdbool.h>
#include <stddef.h>

#include "po_reference.h"

typedef struct {
  char *name;        /* "reference/struve.csv" */
  bool listed;       /* in reference/index.txt */
  bool intact;       /* the file exists, is complete, and its checksum agrees */
  char message[300]; /* the reason if the table is not intact */
  po_ledger ledger;  /* this and the following members: only if the table is intact */
  size_t rows;
  char uncertainty[120];
} po_reference_entry;

typedef struct {
  po_reference_entry *entries; /* sorted by name */
  size_t count;
} po_reference_list;

/* Reads and checks all tables of a data folder. A table that is not intact is reported in its
 * entry. Status: PO_CANNOT_READ (the index or the folder), PO_NO_MEMORY. */
po_status po_reference_list_open(const char *data_folder, po_reference_list *list);
void po_reference_list_close(po_reference_list *list);

/* Status: PO_CANNOT_READ with the message of the first table that is not intact, and how many more.
 */
po_status po_reference_list_check(const po_reference_list *list);

#endif
