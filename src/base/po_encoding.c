#include "po_encoding.h"

#include <stdbool.h>
#include <string.h>

#include "po_quote.h"

size_t po_encoding_blank(const char *text) {
  static const char *const BLANKS[] = {"\u00A0", "\u2007", "\u2009", "\u202F"};
  for (size_t i = 0; i < sizeof BLANKS / sizeof *BLANKS; ++i)
    if (strncmp(text, BLANKS[i], strlen(BLANKS[i])) == 0)
      return strlen(BLANKS[i]);
  return 0;
}

static void add_character(po_text *text, unsigned long code) {
  const int more = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  static const unsigned char FIRST[] = {0, 0xC0, 0xE0, 0xF0};
  char bytes[4] = {(char)(FIRST[more] | (code >> (6 * more)))};
  for (int k = 1; k <= more; ++k)
    bytes[k] = (char)(0x80 | ((code >> (6 * (more - k))) & 0x3F));
  po_text_add_bytes(text, bytes, (size_t)more + 1);
}

/* A surrogate without its partner becomes U+FFFD, as is usual. */
static void decode_utf16(po_text *text, bool big) {
  po_text utf8 = {0};
  const unsigned char *byte = (const unsigned char *)text->data;
  unsigned long high = 0;
  for (size_t i = 2; i + 1 < text->length; i += 2) {
    const unsigned long unit = byte[i + big] | (unsigned long)byte[i + !big] << 8;
    const bool second = unit >= 0xDC00 && unit < 0xE000;
    if (high && !second)
      add_character(&utf8, 0xFFFD);
    if (unit >= 0xD800 && unit < 0xDC00)
      high = unit;
    else {
      add_character(&utf8, !second ? unit
                           : high  ? 0x10000 + ((high - 0xD800) << 10) + (unit - 0xDC00)
                                   : 0xFFFD);
      high = 0;
    }
  }
  po_text_add(&utf8, "%s", "");
  po_text_clear(text);
  *text = utf8;
}

/* Whether bytes that are not UTF-8 are characters of Latin-1. Bytes from 80 to 9F are controls
 * there, and letters in several other encodings. */
static bool is_latin1(const po_text *text) {
  const char *at = text->data, *end = text->data + text->length, *bad = at;
  for (const char *c = at; c < end; ++c)
    if ((unsigned char)*c >= 0x80 && (unsigned char)*c < 0xA0)
      return false;
  while ((bad = po_quote_find(bad, (size_t)(end - bad))) && (unsigned char)*bad < 0x80)
    ++bad;
  return bad;
}

static void decode_latin1(po_text *text) {
  po_text utf8 = {0};
  for (size_t i = 0; i < text->length; ++i)
    add_character(&utf8, (unsigned char)text->data[i]);
  po_text_clear(text);
  *text = utf8;
}

/* The first bytes of files that are no text but are often taken for tables. */
static const struct {
  const char *bytes, *what;
} FORMATS[] = {{"PK\003\004", "a ZIP archive, as those of .xlsx, .ods and .npz are"},
               {"\037\213", "compressed by gzip"},
               {"BZh", "compressed by bzip2"},
               {"\3757zXZ", "compressed by xz"},
               {"\320\317\021\340", "a workbook of old spreadsheets (.xls)"},
               {"\223NUMPY", "an array of NumPy (.npy)"},
               {"\211HDF", "an HDF5 file"},
               {"MATLAB 5.0", "a MAT-file"},
               {"%PDF", "a PDF document"},
               {"\211PNG", "a PNG image"},
               {"\377\330\377", "a JPEG image"}};

/* What a file is by its first bytes; NULL: it is not known. */
static const char *format_of(const po_text *text) {
  for (size_t k = 0; k < sizeof FORMATS / sizeof *FORMATS; ++k) {
    const size_t length = strlen(FORMATS[k].bytes);
    if (text->length >= length && memcmp(text->data, FORMATS[k].bytes, length) == 0)
      return FORMATS[k].what;
  }
  return NULL;
}

po_status po_encoding_decode(const char *name, po_text *text) {
  const char *t = text->data, *format = format_of(text);
  if (format)
    return po_fail(PO_CANNOT_READ, "%s is %s: expected a table in text, with separators", name,
                   format);
  const bool wide =
      text->length >= 4 && (memcmp(t, "\xFF\xFE\0\0", 4) == 0 || memcmp(t, "\0\0\xFE\xFF", 4) == 0);
  if (wide)
    return po_fail(PO_CANNOT_READ, "%s is text in UTF-32: expected UTF-8 or UTF-16", name);
  const bool little = text->length >= 2 && memcmp(t, "\xFF\xFE", 2) == 0;
  const bool big = text->length >= 2 && memcmp(t, "\xFE\xFF", 2) == 0;
  if ((little || big) && text->length % 2)
    return po_fail(PO_CANNOT_READ,
                   "%s is text in UTF-16 with an odd number of bytes: the file is truncated", name);
  if (little || big)
    decode_utf16(text, big);
  else if (text->length && memchr(t, '\0', text->length))
    return po_fail(PO_CANNOT_READ,
                   "%s is not a text file: it contains a NUL byte, as UTF-16 without a byte order "
                   "mark does: expected UTF-8",
                   name);
  else if (text->length && is_latin1(text))
    decode_latin1(text);
  for (char *end = text->failed ? NULL : strchr(text->data, '\r'); end; end = strchr(end, '\r')) {
    const size_t count = strspn(end, "\r");
    if (end[count] != '\n' && (end == text->data || end[-1] != '\n'))
      memset(end, '\n', count);
    end += count;
  }
  if (!text->failed && text->length && text->data[text->length - 1] != '\n')
    po_text_add(text, "\n");
  return text->failed ? PO_NO_MEMORY : PO_OK;
}
