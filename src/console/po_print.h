/* Prints the result of one solve, as text or JSON, or any JSON document on standard output. */
#ifndef PO_PRINT_H
#define PO_PRINT_H

#include <stdio.h>

#include "po_case.h"
#include "po_given.h"
#include "po_json_value.h"
#include "po_request.h"
#include "po_result.h"
#include "po_solver.h"

/* Prints a document and releases it. A document is NULL if memory ran out while it was built; the
 * status is then PO_NO_MEMORY. */
po_status po_print_document(json_t *document);

/* Prints the line with the digest of a document, as po_print_document prints it, and releases the
 * document. Status: PO_NO_MEMORY. */
po_status po_print_digest(json_t *document);

/* Prints the document of schema "pulloff/1". It has the block `physical` if the scene was given in
 * SI units. */
po_status po_print_json(const po_request *request, const po_given *given, const po_result *result);

/* Prints the command that writes the pins of a case. */
void po_print_bless(const po_case *kase);

/* Prints the name of an external solver, its manifest, the value of its knob, and its command. */
void po_print_solver(const po_solver *solver, FILE *stream);

/* Prints the scene, the units, the status and the pull-off with its errors. */
void po_print_summary(const po_request *request, const po_result *result);

/* Prints the result as text for the terminal. */
po_status po_print_text(const po_request *request, const po_given *given, const po_result *result);

#endif
