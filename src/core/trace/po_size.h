/* How many nodes and how much memory a trace needs. */
#ifndef PO_SIZE_H
#define PO_SIZE_H

#include <stddef.h>

#include "po_request.h"

typedef struct {
  size_t nodes; /* of the finest mesh; 0 for a rigid scene */
  double bytes; /* greatest memory of a process that solves the scene alone */
} po_size;

/* The most nodes that a mesh of panels has. */
extern const size_t PO_MOST_NODES_OF_MESH;

/* An upper estimate for a valid request that is traced with its own range of the attraction, see
 * po_request_size. */
po_size po_trace_size(const po_request *request);

#endif
