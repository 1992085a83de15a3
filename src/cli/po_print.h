/* One solved scene on standard output. */
#ifndef PO_PRINT_H
#define PO_PRINT_H

#include "po_outcome.h"
#include "po_scene_flags.h"

/* The document of schema "pulloff/1"; with `physical` for a scene that was given so. */
po_status po_print_json(const po_request *request, const po_scene_flags *flags,
                        const po_outcome *outcome);

/* A table for people. */
po_status po_print_text(const po_request *request, const po_scene_flags *flags,
                        const po_outcome *outcome);

#endif
