/* Answers that an external solver wrote for a run that was killed. */
#ifndef PO_RECOVER_H
#define PO_RECOVER_H

#include "po_taking.h"

/* Takes the successful answers that processes wrote for the same key (see po_ask) while this
 * program was killed, and removes their folders. A process that is still running, of another run in
 * the same folder, is left alone. Status: PO_NO_MEMORY, that of `take`. */
po_status po_recover(const po_question *questions, size_t count, const char *folder,
                     const char *key, po_answer_taker *take, void *context);

#endif
