/* The two low-order elements of the paper: rings (App. A) and overlapping triangles (Sec. 3.1).
 * Each function computes one row of the influence matrix. */
#ifndef PO_ELEMENT_H
#define PO_ELEMENT_H

#include <stddef.h>
#include <stdint.h>

#include "po_status.h"

/* The influence of rings of constant traction, Eq A3 and Eq A4. Given: edge, n + 1 radii; r.
 * Returned: row[j * stride], the deflection at r (E* = 1) per unit traction on ring j; the number
 * of evaluations of F, Eq A2. Accuracy: 1e-15 of the largest radius, measured 6e-16 on every row of
 * reference/kernel.csv (tests/theory/test_tables_surface.c). */
uint64_t po_ring_influence(size_t n, const double *edge, double r, double *row, size_t stride);

typedef struct po_triangle po_triangle;

/* Overlapping triangles (Sec. 3.1, Eq 13): the traction is p_j at node j and decreases linearly to
 * 0 at its neighbours (half a triangle at each end). Creates the tables for po_triangle_influence.
 * Given: node, n >= 2 radii, ascending from 0, which must exist as long as the object. Status:
 * PO_NO_MEMORY. */
po_status po_triangle_create(size_t n, const double *node, po_triangle **triangle);
void po_triangle_destroy(po_triangle *triangle);

/* The influence of the triangles, G_ij of Eq 13. Given: r. Returned: row[j * stride], the
 * deflection at r (E* = 1) per unit traction at node j; the number of evaluations of the kernel.
 * Accuracy: 1e-12 relative for each coefficient, measured 3.1e-13 on every row of
 * reference/kernel.csv (tests/theory/test_tables_surface.c). */
uint64_t po_triangle_influence(const po_triangle *triangle, double r, double *row, size_t stride);

#endif
