/* Rows: one for each number of a structure, from which its documents, tables, units, check
 * quantities and descriptions follow. A block is the rows of one structure; a row may stand for a
 * block or a list of blocks. po_result_rows.h lists the blocks of a result. */
#ifndef PO_ROWS_H
#define PO_ROWS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "po_dimension.h"

typedef enum {
  PO_ROW_NUMBER,  /* double */
  PO_ROW_COUNT,   /* unsigned integer */
  PO_ROW_INTEGER, /* int >= 0 */
  PO_ROW_FLAG,    /* bool */
  PO_ROW_TEXT,    /* char[], made printable when it is read */
  PO_ROW_WORD,    /* enumeration or bool; its words are `names` */
  PO_ROW_STATUS,  /* po_status */
  PO_ROW_LABEL,   /* by `label`; not read */
  PO_ROW_LABELS,  /* the same, an array of two */
  PO_ROW_PART,    /* an object */
  PO_ROW_INLINE,  /* the rows of another block, in the same object */
  PO_ROW_LIST,    /* an array of objects: a pointer and a size_t */
} po_row_type;

enum { PO_LABEL_LENGTH = 8 };
typedef char po_label[PO_LABEL_LENGTH];

typedef struct po_block po_block;

/* Every cell is filled; where a cell does not apply, texts are "" and the rest is 0 or NULL.
 * tests/harness/test_rows.c checks this. */
typedef struct {
  const char *key;
  po_row_type type;
  po_dimension dimension;
  size_t offset, size; /* of the member */
  size_t count;        /* of a list, and of a part that has one: offset of its number of items. One
                          that is omitted is absent without items */
  size_t present;      /* of an optional part: offset of the bool that says whether it is there */
  const po_block *block;
  const char *const *names; /* of a word; ends with NULL */
  bool hidden;              /* not in documents; its unit is converted */
  bool alias;               /* another row has the same member and converts its unit */
  bool omitted;             /* a document has no member for an absent part; otherwise it has null */
  bool (*absent)(const void *owner);           /* further reason why a part is absent */
  double (*get)(const void *owner);            /* a number that is derived from members */
  void (*set)(void *owner, double value);      /* its inverse; NULL: it is not read */
  const char *(*word)(const void *owner);      /* a word that is derived */
  void (*take)(void *owner, const char *word); /* its inverse */
  void (*label)(const void *list_owner, size_t index, po_label label[2]);
  const char *error; /* path of the error bound, from the same block */
  const char *null;  /* when a document has null for it, or no member */
  const char *says;  /* what it is */
} po_row;

struct po_block {
  const char *name; /* of the definition in the JSON Schema */
  const po_row *row;
  size_t count, size;         /* rows; size of the structure */
  void (*settle)(void *item); /* completes a structure that was read; NULL: it is complete */
};

/* A row and the structure that has its member. */
typedef struct {
  const po_row *row; /* NULL: there is no such path */
  const void *owner; /* NULL: it is in a part that is absent, or in an item that is not there */
} po_field;

/* Finds the row at a path such as "pull_off.force" or "cycles.0.energy_lost". Given: a structure,
 * or NULL to find the row only. */
po_field po_block_find(const po_block *block, const void *owner, const char *path);

/* Returned: the number at a path, of a list the number of its items; NAN: there is none. */
double po_block_number(const po_block *block, const void *owner, const char *path);

/* The value of a number, count, integer or flag; of a list the number of its items. */
double po_row_number(const po_row *row, const void *owner);
void po_row_put(const po_row *row, void *owner, double value);

/* The value of a member that is an unsigned integer, an enumeration or a bool. */
uint64_t po_row_bits(const po_row *row, const void *owner);
void po_row_put_bits(const po_row *row, void *owner, uint64_t bits);

bool po_row_is_absent(const po_row *row, const void *owner);
size_t po_row_items(const po_row *row, const void *owner);
void *po_row_item(const po_row *row, const void *owner, size_t index);

#endif
