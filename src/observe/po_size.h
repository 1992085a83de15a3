/* How many nodes and how much memory a solve needs, before it is solved. */
#ifndef PO_SIZE_H
#define PO_SIZE_H

#include "po_request.h"

typedef struct {
  size_t nodes; /* of the finest mesh; 0 for a rigid scene */
  double bytes; /* greatest memory of a process that solves the scene alone */
} po_size;

/* The most nodes that a mesh of panels has. */
extern const size_t PO_MOST_NODES_OF_MESH;

/* An upper estimate for a request that is valid. Accuracy: a solve needs between 1/8 of it and all
 * of it (tests/cost/size.py). A search of all preloads may need more than the estimate. */
po_size po_request_size(const po_request *request);

#endif
