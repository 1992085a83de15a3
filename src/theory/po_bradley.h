/* The rigid smooth sphere (Bradley). */
#ifndef PO_BRADLEY_H
#define PO_BRADLEY_H

/* The load W/(pi w R) = -2 (4 x^6 - 1)/(3 x^8), x = 1 - approach: Eq 23 (Bradley 1932). Given:
 * approach/eps < 1. Returned: the load, > 0 compressive, with the minimum -2 at approach 0; NaN
 * outside the domain. Accuracy: 4 ulp of the larger term (tests/theory/test_tables_theory.c). */
double po_bradley_load(double approach);

#endif
