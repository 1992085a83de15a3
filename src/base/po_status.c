#include "po_status.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "po_quote.h"

enum { MESSAGE_LENGTH = 1024 };
static _Thread_local char message[MESSAGE_LENGTH];

/* The first message of PO_NO_MEMORY since po_no_memory_forget; "" if there is none. */
static _Thread_local char first_no_memory[MESSAGE_LENGTH];

static const struct {
  po_status status;
  const char *identifier, *text;
} STATUSES[] = {
#define PO_STATUS_ROW(name, value, text) {name, #name, text},
    PO_STATUS_LIST(PO_STATUS_ROW)
#undef PO_STATUS_ROW
};
enum { STATUS_COUNT = sizeof STATUSES / sizeof *STATUSES };

const char *po_status_text(po_status status) {
  for (size_t k = 0; k < STATUS_COUNT; ++k)
    if (STATUSES[k].status == status)
      return STATUSES[k].text;
  return "unknown status";
}

const char *po_status_name(po_status status) {
  static _Thread_local char name[64];
  const char *upper = "PO_UNKNOWN";
  for (size_t k = 0; k < STATUS_COUNT; ++k)
    upper = STATUSES[k].status == status ? STATUSES[k].identifier : upper;
  size_t i = 0;
  for (const char *c = upper + 3; *c && i + 1 < sizeof name; ++c)
    name[i++] = (char)tolower((unsigned char)*c);
  name[i] = '\0';
  return name;
}

bool po_status_find(const char *name, po_status *status) {
  for (size_t k = 0; k < STATUS_COUNT && name; ++k)
    if (strcmp(name, po_status_name(STATUSES[k].status)) == 0) {
      *status = STATUSES[k].status;
      return true;
    }
  return false;
}

po_status po_fail(po_status status, const char *format, ...) {
  char text[2 * MESSAGE_LENGTH];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  for (char *c = text; *c; ++c)
    if (*c == '\n' || *c == '\r')
      *c = ' ';
  po_quote_text(text, message, sizeof message);
  if (status == PO_NO_MEMORY && !first_no_memory[0])
    snprintf(first_no_memory, sizeof first_no_memory, "%s", message);
  return status;
}

const char *po_message(void) {
  return message;
}

void po_message_clear(void) {
  message[0] = '\0';
}

po_status po_no_memory_or(po_status status) {
  if (!first_no_memory[0])
    return status;
  memcpy(message, first_no_memory, sizeof message);
  return PO_NO_MEMORY;
}

void po_no_memory_forget(void) {
  first_no_memory[0] = '\0';
}
