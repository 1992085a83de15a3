/* A table of parameter sets, as users write it: the columns are keys, each row is a set. */
#ifndef PO_KEY_TABLE_H
#define PO_KEY_TABLE_H

#include "po_csv.h"
#include "po_texts.h"

/* Finds the keys of the columns. Given: room for them. Status: PO_BAD_INPUT: the table has no rows,
 * or a column is not named like a key of a scene. */
po_status po_key_table_keys(const po_csv *csv, int *keys);

/* Returned: the text of a cell as case files and options write it, where commas take the place of
 * the semicolons of lists, laws and profiles; to be freed. NULL: the key is not given, as the cell
 * is "-"; or without memory, which sets *failed. */
char *po_key_table_text(const po_csv *csv, size_t row, size_t column, po_key key, bool *failed);

#endif
