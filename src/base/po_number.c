#include "po_number.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_encoding.h"

void po_number_print(double value, char text[PO_NUMBER_LENGTH]) {
  if (isnan(value)) {
    strcpy(text, "nan");
    return;
  }
  for (int digits = 15; digits <= 17; ++digits) {
    snprintf(text, PO_NUMBER_LENGTH, "%.*g", digits, value);
    if (strtod(text, NULL) == value)
      return;
  }
}

const char *po_number_or(const char *format, double value, const char *word,
                         char text[PO_NUMBER_LENGTH]) {
  if (!isfinite(value))
    return word;
  snprintf(text, PO_NUMBER_LENGTH, format, value);
  return text;
}

/* strtod also accepts hexadecimal numbers, "nan", "infinity" and leading blanks; this check refuses
 * them. */
static bool number_is_decimal(const char *text) {
  const char *c = text + (*text == '+' || *text == '-');
  const size_t whole = strspn(c, "0123456789");
  c += whole;
  size_t fraction = 0;
  if (*c == '.') {
    fraction = strspn(c + 1, "0123456789");
    c += 1 + fraction;
  }
  if (whole + fraction == 0)
    return false;
  if (*c == 'e' || *c == 'E') {
    c += 1;
    c += *c == '+' || *c == '-';
    const size_t exponent = strspn(c, "0123456789");
    if (exponent == 0)
      return false;
    c += exponent;
  }
  return *c == '\0';
}

bool po_number_parse(const char *text, double *value) {
  if (!number_is_decimal(text))
    return false;
  errno = 0;
  const double number = strtod(text, NULL);
  if (errno == ERANGE || !isfinite(number))
    return false;
  *value = number;
  return true;
}

const char *po_number_fault(const char *text) {
  static const char DIGITS[] = "0123456789";
  char number[PO_NUMBER_LONGEST];
  double value = 0;
  size_t length = strspn(text, "+-.,eE0123456789");
  while (length && !strchr(DIGITS, text[length - 1]))
    --length;
  if (!length || length >= sizeof number)
    return "";
  memcpy(number, text, length);
  number[length] = '\0';
  char *comma = strchr(number, ','), *point = strchr(number, '.');
  const char *rest = text + length + strspn(text + length, "' ");
  rest += po_encoding_blank(rest);
  if ((comma && point) || (rest > text + length && *rest && strchr(DIGITS, *rest)))
    return "; it has marks or blanks between thousands";
  if (comma)
    *comma = '.';
  if (!po_number_parse(number, &value))
    return "";
  if ((isalpha((unsigned char)*rest) && *rest != 'x') || (*rest && strchr("%[(", *rest)) ||
      ((unsigned char)*rest >= 0x80 && strncmp(rest, "\u00B1", 2) != 0))
    return "; a unit or other text follows the number";
  return comma && !text[length] ? "; it has a comma in place of a decimal point" : "";
}

bool po_number_parse_count(const char *text, size_t *value) {
  const size_t digits = strlen(text);
  if (digits == 0 || digits > 15 || strspn(text, "0123456789") != digits)
    return false;
  *value = (size_t)strtoull(text, NULL, 10);
  return true;
}
