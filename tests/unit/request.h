/* The request that the tests of what is read off a branch begin with. */
#ifndef REQUEST_H
#define REQUEST_H

#include "po_request.h"

static inline po_request request_of(double tabor, double amplitude, double wavelength,
                                    double outer) {
  po_request request = po_request_default();
  request.scene.tabor = tabor;
  request.scene.amplitude = amplitude;
  request.scene.wavelength = wavelength;
  request.scene.outer_radius = outer;
  request.mesh.scheme = PO_TRIANGLE;
  request.mesh.nodes = 301;
  return request;
}

#endif
