/* "Did you mean": a known word that is close to an unknown one. */
#ifndef PO_SUGGEST_H
#define PO_SUGGEST_H

#include "po_status.h"

/* Appends "; did you mean NAME?" to the message of po_fail if a known word is close to the given
 * one: so few letters are missing, superfluous, wrong or exchanged that a slip is likely, or the
 * given word is its beginning. Case, - and _ do not count. Of a list with commas, the first part
 * that is not known is meant, and of a word like morse:1 the part before the colon.
 * A refused number in another
 * notation is explained, if `known` names a number (po_number_fault).
 * Given: `known`, words with blanks or commas between them. Returned: status. */
po_status po_suggest(po_status status, const char *given, const char *known);

#endif
