/* Elementary functions of numbers of twice the precision. */
#ifndef PO_TWO_FUNCTIONS_H
#define PO_TWO_FUNCTIONS_H

#include "po_two.h"

/* For what is computed seldom or needs more digits than a double has. po_two_sinpi: of pi x. Given:
 * |exponent| <= 700 of the exponential; x > 0 for the logarithm and the power. Accuracy: 1e-29 of
 * the result; of the exponential times 1 + |exponent|; of the power times 1 + |exponent| +
 * |logarithm of the result|; of the logarithm and the sine in the vicinity of a zero absolutely
 * (tests/theory/test_tables_math.c). */
po_two po_two_exp(po_two exponent);
po_two po_two_log(po_two x);
po_two po_two_pow(po_two x, po_two exponent);
po_two po_two_sinpi(po_two x);

#endif
