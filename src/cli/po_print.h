/* One solved scene, or any JSON document, on standard output. */
#ifndef PO_PRINT_H
#define PO_PRINT_H

#include "po_case.h"
#include "po_json_value.h"
#include "po_request.h"
#include "po_result.h"
#include "po_scene_flags.h"

/* Prints a document and releases it. NULL is one for which there was no memory. Status:
 * PO_NO_MEMORY. */
po_status po_print_document(json_t *document);

/* The document of schema "pulloff/1"; with `physical` for a scene that was given so. */
po_status po_print_json(const po_request *request, const po_scene_flags *flags,
                        const po_result *result);

/* Prints the command that makes the pins of a case. */
void po_print_bless(const po_case *kase);

/* A table for people. */
void po_print_text(const po_request *request, const po_scene_flags *flags, const po_result *result);

#endif
