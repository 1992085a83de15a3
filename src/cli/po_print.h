/* One solved scene on standard output. */
#ifndef PO_PRINT_H
#define PO_PRINT_H

#include "po_outcome.h"

/* The document of schema "pulloff/1". */
po_status po_print_json(const po_request *request, const po_outcome *outcome);

/* A table for people. */
po_status po_print_text(const po_request *request, const po_outcome *outcome);

#endif
