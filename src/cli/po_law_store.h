/* The laws that a folder has already: laws.jsonl, a line a row of the table that has been finished
 * (po_lines.h). A law is used again if its key, which covers all that determines it, is the same
 * and its file is unchanged. */
#ifndef PO_LAW_STORE_H
#define PO_LAW_STORE_H

#include "po_digest.h"
#include "po_file.h"
#include "po_json_value.h"
#include "po_law_line.h"

/* What the summary has of a law. Beside the numbers of the law: its error, the excess of the
 * parabola and the seconds. */
typedef struct {
  po_status status; /* PO_OK, or PO_BAD_INPUT: the scene has no law */
  po_particle_numbers numbers;
  double error, parabola_excess, seconds;
  const char *reason; /* why there is no law; "" */
} po_law_stored;

typedef struct {
  po_file_path folder;
  char program[PO_DIGEST_LENGTH];
  json_t *lines; /* an object: the document of each key */
} po_law_store;

/* Reads the laws of a folder. Returned: to be cleared also after a failure. Status: PO_CANNOT_READ,
 * PO_NO_MEMORY. */
po_status po_law_store_open(const char *folder, po_law_store *store);
void po_law_store_clear(po_law_store *store);

/* Returned: a digest of all that determines the law of a completed line. Status: PO_NO_MEMORY. */
po_status po_law_store_key(const po_law_store *store, const po_law_line *line,
                           char key[PO_DIGEST_LENGTH]);

/* Finds a law. Given: the name of its file. Returned: whether it is there; *stored, whose reason
 * belongs to the store. */
bool po_law_store_find(const po_law_store *store, const char *key, const char *file,
                       po_law_stored *stored);

/* Appends a law. Given: the content of its file. Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_law_store_put(const po_law_store *store, const char *key, const po_law_stored *stored,
                           const po_text *content);

#endif
