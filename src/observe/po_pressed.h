/* What the pull-offs of a branch take: the preload of each, and the greatest that any preload
 * gives. */
#ifndef PO_PRESSED_H
#define PO_PRESSED_H

#include "po_path.h"
#include "po_request.h"
#include "po_result.h"
#include "po_stopping.h"

/* Given: the branch, and how far it went; a result with its special points, its pull-off, and how
 * the trace ended. Returned: preloads of the pull-off and of the greatest of all, and the
 * staircases when they are wanted, with their errors. Status: PO_NO_MEMORY. */
po_status po_pressed_read(const po_request *request, const po_path *path,
                          const po_stopping *stopping, po_result *result);

#endif
