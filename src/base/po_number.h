/* Conversion between numbers and text: printed numbers read back to the same bits; input is parsed
 * strictly. */
#ifndef PO_NUMBER_H
#define PO_NUMBER_H

#include <stdbool.h>
#include <stddef.h>

enum {
  PO_NUMBER_LENGTH = 32,  /* the longest text of a double with 17 digits, and its NUL */
  PO_NUMBER_LONGEST = 512 /* longer numbers are read only in plain notation */
};

/* Prints the shortest of %.15g, %.16g and %.17g that reads back to the same double; "inf", "-inf"
 * or "nan" for other values. */
void po_number_print(double value, char text[PO_NUMBER_LENGTH]);

/* Returned: in `text`, a number in a format of printf; `word` if it is not finite. */
const char *po_number_or(const char *format, double value, const char *word,
                         char text[PO_NUMBER_LENGTH]);

/* Parses a decimal number. The complete text must be a number that is finite as a double; "inf",
 * "nan", hexadecimal numbers, spaces, trailing text and underflow are refused. Returned: whether
 * `text` is such a number; only then *value is set. */
bool po_number_parse(const char *text, double *value);

/* Why a text is not a number, if it is one in another notation. Returned: words to append to the
 * message that refuses it: it has a decimal comma, marks or blanks between thousands, or a unit or
 * other text after the number; "" otherwise. */
const char *po_number_fault(const char *text);

/* Parses a count: decimal digits only, at most 10^15. Returned: whether `text` is one; only then
 * *value is set. */
bool po_number_parse_count(const char *text, size_t *value);

#endif
