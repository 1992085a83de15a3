#include "po_utf8.h"

/* Returned: the length that the first byte of a character announces, and in *least and *most the
 * range of the second byte, which excludes overlong forms, surrogates and code points above
 * U+10FFFF; 0 if no character begins with this byte. */
static size_t announced(unsigned char first, unsigned char *least, unsigned char *most) {
  *least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  *most = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (first < 0x80)
    return 1;
  if (first < 0xC2 || first > 0xF4)
    return 0;
  return first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
}

size_t po_utf8_present(const char *text, size_t *length) {
  const unsigned char *c = (const unsigned char *)text;
  unsigned char least, most;
  *length = announced(c[0], &least, &most);
  size_t count = *length > 0;
  while (count < *length && c[count] >= least && c[count] <= most) {
    least = 0x80;
    most = 0xBF;
    count += 1;
  }
  return count;
}

size_t po_utf8_character(const char *text) {
  size_t length = 0;
  return po_utf8_present(text, &length) == length ? length : 0;
}

bool po_utf8_is_valid(const char *text) {
  while (*text) {
    const size_t length = po_utf8_character(text);
    if (length == 0)
      return false;
    text += length;
  }
  return true;
}
