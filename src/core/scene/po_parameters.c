#include "po_parameters.h"

#include <string.h>

#include "po_number.h"

bool po_parameters_read(const char *text, size_t count, double *values) {
  for (size_t k = 0; k < count; ++k) {
    char number[PO_NUMBER_LENGTH];
    const size_t length = strcspn(text, ",;");
    if (length >= sizeof number)
      return false;
    memcpy(number, text, length);
    number[length] = '\0';
    if (!po_number_parse(number, &values[k]))
      return false;
    text += length;
    if ((*text == '\0') != (k + 1 == count))
      return false;
    text += *text != '\0';
  }
  return true;
}

bool po_parameters_follow(const char *text, const char *name, const char **rest) {
  const size_t length = strlen(name);
  if (strncmp(text, name, length) != 0 || (text[length] != ':' && text[length] != '\0'))
    return false;
  *rest = text[length] == ':' ? text + length + 1 : NULL;
  return true;
}
