/* The two low-order elements of the paper, one row of the influence matrix at a time. */
#ifndef PO_ELEMENT_H
#define PO_ELEMENT_H

#include <stddef.h>
#include <stdint.h>

#include "po_status.h"

/* Rings of constant traction (App. A, Eqs A1-A4) between the n + 1 edges: row[j * stride] is the
 * deflection at r (E* = 1) per unit traction on ring j. Returned: evaluations of F, Eq A2.
 * Accuracy: 1e-15 of the largest radius, measured 6e-16 on every row of reference/kernel.csv
 * (tests/theory/test_tables_surface.c). */
uint64_t po_ring_influence(size_t n, const double *edge, double r, double *row, size_t stride);

/* Load weight of each ring: (c2^2 - c1^2)/2. */
void po_ring_weights(size_t n, const double *edge, double *weight);

typedef struct po_triangle po_triangle;

/* Overlapping triangles (Sec. 3.1) on n >= 2 nodes, ascending from 0: traction p_j at node j,
 * falling linearly to 0 at its neighbours (half a triangle at either end). Tables for
 * po_triangle_influence. The nodes must outlive the object. Status: PO_NO_MEMORY. */
po_status po_triangle_create(size_t n, const double *node, po_triangle **triangle);
void po_triangle_destroy(po_triangle *triangle);

/* row[j * stride]: the deflection at r (E* = 1) per unit traction at node j. Returned: evaluations
 * of the kernel. Accuracy: 1e-12 relative, each coefficient, measured 3.1e-13 on every row of
 * reference/kernel.csv (tests/theory/test_tables_surface.c). */
uint64_t po_triangle_influence(const po_triangle *triangle, double r, double *row, size_t stride);

/* Load weight of each triangle: the integral of it times r dr. */
void po_triangle_weights(size_t n, const double *node, double *weight);

#endif
