#include "po_utf8.h"

#include <string.h>

#include "po_memory.h"

static const char REPLACEMENT[] = "\xEF\xBF\xBD"; /* U+FFFD */

/* The length that the first byte of a character announces, and the range of the second byte, which
 * excludes overlong forms, surrogates and what lies above U+10FFFF; 0: no first byte. */
static size_t announced(unsigned char first, unsigned char *least, unsigned char *most) {
  *least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  *most = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (first < 0x80)
    return 1;
  if (first < 0xC2 || first > 0xF4)
    return 0;
  return first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
}

/* How many bytes at `text` begin a character of the announced length: fewer when it is broken off.
 */
static size_t present(const char *text, size_t *length) {
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
  return present(text, &length) == length ? length : 0;
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

char *po_utf8_copy(const char *text) {
  char *copy = po_resize(NULL, (sizeof REPLACEMENT - 1) * strlen(text) + 1, 1);
  if (!copy)
    return NULL;
  char *to = copy;
  while (*text) {
    size_t length = 0;
    const size_t count = present(text, &length);
    if (length > 0 && count == length) {
      memcpy(to, text, length);
      to += length;
      text += length;
    } else if (count > 0 && text[count] == '\0')
      break;
    else {
      memcpy(to, REPLACEMENT, sizeof REPLACEMENT - 1);
      to += sizeof REPLACEMENT - 1;
      text += 1;
    }
  }
  *to = '\0';
  return copy;
}
