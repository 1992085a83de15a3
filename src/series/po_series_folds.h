/* The folds of the first scene of a series, followed along it. */
#ifndef PO_SERIES_FOLDS_H
#define PO_SERIES_FOLDS_H

#include "po_request.h"
#include "po_result.h"

/* Traces the first scene and follows each of its folds from scene to scene. Two folds that merge
 * end there; folds that appear later in the series are not found. Given: requests, `count` of
 * neighbouring scenes, elastic and on panels, all wavy or all smooth, all bounded or all unbounded.
 * Returned: a result for each scene, to be cleared whatever the status: for the first scene that of
 * its trace; for the others `followed` and as many folds as the first scene has, in its order, with
 * error estimates but without energy and position; approach and load are NAN from the scene on
 * where a fold has ended. Status: PO_INTERRUPTED, PO_NO_MEMORY; PO_BAD_INPUT for other scenes. A
 * trace that fails does not fail the series. */
po_status po_series_folds(const po_request *requests, size_t count, po_result *results);

#endif
