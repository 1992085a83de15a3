#include "po_text.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_quote.h"

static bool text_reserve(po_text *text, size_t extra) {
  if (text->failed)
    return false;
  const size_t needed = text->length + extra + 1;
  if (needed <= text->capacity)
    return true;
  const size_t capacity = needed > 2 * text->capacity ? needed : 2 * text->capacity;
  char *data = po_resize(text->data, capacity, 1);
  if (!data) {
    text->failed = true;
    return false;
  }
  text->data = data;
  text->capacity = capacity;
  return true;
}

void po_text_add(po_text *text, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  va_list again;
  va_copy(again, arguments);
  const int length = vsnprintf(NULL, 0, format, arguments);
  va_end(arguments);
  if (length < 0)
    text->failed = true;
  else if (text_reserve(text, (size_t)length)) {
    vsnprintf(text->data + text->length, (size_t)length + 1, format, again);
    text->length += (size_t)length;
  }
  va_end(again);
}

void po_text_add_bytes(po_text *text, const char *bytes, size_t size) {
  if (!text_reserve(text, size))
    return;
  memcpy(text->data + text->length, bytes, size);
  text->length += size;
  text->data[text->length] = '\0';
}

/* The characters without a special meaning in a shell. */
static const char PLAIN[] =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+,./:=@%";

void po_text_add_word(po_text *text, const char *word) {
  if (*word && strspn(word, PLAIN) == strlen(word)) {
    po_text_add(text, "%s", word);
    return;
  }
  const bool escaped = po_quote_find(word, strlen(word)) || strpbrk(word, "\t\n\v\f\r");
  po_text_add(text, escaped ? "$'" : "'");
  for (const char *c = word; *c; ++c) {
    if (escaped && !isprint((unsigned char)*c))
      po_text_add(text, "\\%03o", (unsigned)(unsigned char)*c);
    else if (*c == '\'')
      po_text_add(text, escaped ? "\\'" : "'\\''");
    else if (*c == '\\' && escaped)
      po_text_add(text, "\\\\");
    else
      po_text_add_bytes(text, c, 1);
  }
  po_text_add(text, "'");
}

const char *po_text_string(const po_text *text) {
  return text->data ? text->data : "";
}

void po_text_clear(po_text *text) {
  free(text->data);
  *text = (po_text){0};
}

char *po_text_take(po_text *text) {
  if (text->failed)
    po_text_clear(text);
  char *data = text->data;
  *text = (po_text){0};
  return data;
}

po_status po_text_print(po_text *text) {
  const po_status status = text->failed ? PO_NO_MEMORY : PO_OK;
  if (!status)
    fputs(po_text_string(text), stdout);
  po_text_clear(text);
  return status;
}

const char *po_one_or_more(size_t count, const char *one, const char *more) {
  return count == 1 ? one : more;
}
