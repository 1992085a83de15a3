/* The end of a verb: its message, in which options stand for keys, and its exit code. */
#include <stdio.h>
#include <string.h>

#include "po_options.h"

static int exit_code(po_status status) {
  switch (status) {
  case PO_OK:
    return PO_EXIT_OK;
  case PO_BAD_INPUT:
    return PO_EXIT_USAGE;
  case PO_CANNOT_READ:
  case PO_CANNOT_WRITE:
  case PO_MISSING_TOOL:
    return PO_EXIT_FILE;
  case PO_INTERRUPTED:
    return PO_EXIT_INTERRUPTED;
  case PO_CHECK_FAILED:
    return PO_EXIT_OUTSIDE;
  default:
    return PO_EXIT_SOLVE;
  }
}

/* The verb takes the options of a scene, and its scene is in SI units. */
static unsigned verb_of_keys = 0;
static bool scene_is_in_si = false;

void po_options_begin_messages(unsigned verb) {
  verb_of_keys = verb;
  scene_is_in_si = false;
}

void po_options_message_in_si(void) {
  scene_is_in_si = true;
}

/* The key of which a message says something here: a name that has a _, or any before " is ". */
static int key_at(const char *word, bool first, size_t length) {
  for (int key = 0; key < PO_KEY_ALL; ++key)
    if (PO_KEYS[key].verbs & verb_of_keys && strlen(PO_KEYS[key].name) == length &&
        strncmp(PO_KEYS[key].name, word, length) == 0 &&
        (strchr(PO_KEYS[key].name, '_') || (first && strncmp(word + length, " is ", 4) == 0)))
      return key;
  return -1;
}

/* Adds the option that sets a key: of a scene in SI units that in these, and the unit of the value.
 */
static void add_flag(int key, po_text *text) {
  char flag[PO_FLAG_LENGTH];
  const int si = scene_is_in_si ? po_key_in_si(key) : -1;
  po_key_flag(si < 0 ? key : si, flag);
  po_text_add(text, "--%s%s", flag, si >= 0 && strchr(PO_KEYS[si].name, '_') ? " in epsilon" : "");
}

/* Names the options in place of the keys in the message of a status, which what checks a scene
 * writes for the readers of case files, too. */
static void name_options(void) {
  static const char FAILED[] = "the solve failed: ",
                    WORD[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./";
  const char *message = po_message();
  const size_t begin = strncmp(message, FAILED, strlen(FAILED)) == 0 ? strlen(FAILED) : 0;
  po_text text = {0};
  for (const char *at = message; *at;) {
    const size_t length = strspn(at, WORD);
    const int key = length ? key_at(at, at == message + begin, length) : -1;
    if (key < 0)
      po_text_add_bytes(&text, at, length ? length : 1);
    else
      add_flag(key, &text);
    at += length ? length : 1;
  }
  if (!text.failed)
    po_fail(PO_BAD_INPUT, "%s", po_text_string(&text));
  po_text_clear(&text);
}

int po_options_end(po_status status) {
  if (status == PO_BAD_INPUT && verb_of_keys)
    name_options();
  if (status)
    fprintf(stderr, "pulloff: %s\n", *po_message() ? po_message() : po_status_text(status));
  return exit_code(status);
}
