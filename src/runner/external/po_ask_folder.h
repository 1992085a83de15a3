/* The folder in which one process of an external solver runs, with its request and response. */
#ifndef PO_ASK_FOLDER_H
#define PO_ASK_FOLDER_H

#include "po_taking.h"

typedef struct {
  po_file_path path, request, table, response; /* absolute */
  int lock; /* the folder, locked while this program lives; -1: not locked */
} po_ask_folder;

/* Creates an empty folder. Given: `parent`, which is created if it does not exist; `key`, see
 * po_ask, or NULL. Returned: to be unlocked whatever the status. Status: PO_CANNOT_WRITE,
 * PO_NO_MEMORY. */
po_status po_ask_folder_make(const char *parent, const char *key, po_ask_folder *folder);

/* Unlocks the folder. */
void po_ask_folder_unlock(po_ask_folder *folder);

/* Removes a folder and everything in it. */
void po_ask_folder_remove(const char *path);

/* Takes the successful answers that processes wrote for the same key (see po_ask) while this
 * program was killed, and removes their folders. A process that is still running, of another run in
 * the same folder, is left alone. Status: PO_NO_MEMORY, that of `take`. */
po_status po_recover(const po_question *questions, size_t count, const char *folder,
                     const char *key, po_answer_taker *take, void *context);

#endif
