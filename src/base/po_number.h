/* Numbers as text: printed so that they read back to the same bits, read strictly. */
#ifndef PO_NUMBER_H
#define PO_NUMBER_H

#include <stdbool.h>
#include <stddef.h>

enum { PO_NUMBER_LENGTH = 32 }; /* room for any double printed with 17 digits, and its NUL */

/* The shortest of %.15g, %.16g, %.17g that reads back to the same double; "inf", "-inf", "nan". */
void po_number_print(double value, char text[PO_NUMBER_LENGTH]);

/* Whether `text` is, from its first character to its last, a decimal number that is finite as a
 * double; then *value is that double. No "inf", "nan", hexadecimal, spaces or trailing text. A
 * number too small for a double is refused too. */
bool po_number_parse(const char *text, double *value);

/* The same, but "inf" is accepted also, as INFINITY. */
bool po_number_parse_or_infinity(const char *text, double *value);

/* Whether `text` is a count: decimal digits only, at most 10^15; then *value is it. */
bool po_number_parse_count(const char *text, size_t *value);

#endif
