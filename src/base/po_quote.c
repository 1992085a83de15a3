#include "po_quote.h"

#include <stdio.h>
#include <string.h>

#include "po_memory.h"

/* Returned: whether a character is U+0000 to U+001F or U+007F to U+009F. */
static bool is_control(const char *text, size_t length) {
  const unsigned char *byte = (const unsigned char *)text;
  return length == 1 ? byte[0] < 0x20 || byte[0] == 0x7F
                     : length == 2 && byte[0] == 0xC2 && byte[1] < 0xA0;
}

/* Validation of UTF-8: file names are arbitrary bytes, and a truncated text may end inside a
 * character. */

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

/* Returned: the number of bytes at `text` that belong to its first character, and in *length the
 * number, 1 to 4, that the first byte announces (0: it cannot begin a character). The returned
 * number is smaller than *length if the character is incomplete. */
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

/* Returned: the length in bytes, 1 to 4, of the UTF-8 character at `text`; 0 if the bytes are not a
 * character (a stray byte, an overlong form, a surrogate, above U+10FFFF). Source: the table of
 * well-formed byte sequences of the Unicode Standard (Table 3-7). */
static size_t utf8_character(const char *text) {
  size_t length = 0;
  return present(text, &length) == length ? length : 0;
}

const char *po_quote_find(const char *text, size_t length) {
  for (size_t i = 0; i < length;) {
    const size_t count = utf8_character(text + i);
    const bool blank = text[i] == '\t' || text[i] == '\n' || text[i] == '\r';
    if (count == 0 || (is_control(text + i, count) && !blank))
      return text + i;
    i += count;
  }
  return NULL;
}

size_t po_quote_mark(const char *text) {
  static const char MARK[] = "\xEF\xBB\xBF";
  return strncmp(text, MARK, sizeof MARK - 1) == 0 ? sizeof MARK - 1 : 0;
}

/* Quotes the first `length` bytes of a text. */
static char *quote(const char *text, size_t length, char *shown, size_t size) {
  size_t used = 0;
  for (size_t i = 0; i < length;) {
    const size_t found = utf8_character(text + i), count = found ? found : 1;
    const bool hidden = found == 0 || is_control(text + i, count);
    if (used + (hidden ? 4 * count : count) + 1 > size)
      break;
    for (size_t k = 0; k < count; ++k, ++used)
      if (!hidden)
        shown[used] = text[i + k];
      else
        used += (size_t)snprintf(shown + used, 5, "\\x%02x", (unsigned char)text[i + k]) - 1;
    i += count;
  }
  shown[used] = '\0';
  return shown;
}

char *po_quote_text(const char *text, char *shown, size_t size) {
  return quote(text, strlen(text), shown, size);
}

char *po_quote(const char *value, char shown[PO_QUOTE_LENGTH]) {
  if (*value == '\0')
    return strcpy(shown, "empty");
  size_t length = 0;
  while (value[length]) { /* up to the last character that ends within the limit */
    const size_t found = utf8_character(value + length);
    if (length + (found ? found : 1) > PO_QUOTE_BYTES)
      break;
    length += found ? found : 1;
  }
  quote(value, length, shown, PO_QUOTE_LENGTH);
  return value[length] ? strcat(shown, PO_QUOTE_CUT) : shown;
}

static const char REPLACEMENT[] = "\xEF\xBF\xBD"; /* U+FFFD */

char *po_quote_utf8(const char *text) {
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
