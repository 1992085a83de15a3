#include "po_key_options.h"

#include <stdio.h>
#include <string.h>

#include "po_input.h"
#include "po_scene_flags.h"

void po_key_flag(int key, char flag[PO_FLAG_LENGTH_OF_NAME]) {
  snprintf(flag, PO_FLAG_LENGTH_OF_NAME, "%s",
           key == PO_KEY_WAVES ? "wave" : po_key_name((po_key)key));
  for (char *c = flag; *c; ++c)
    if (*c == '_')
      *c = '-';
}

/* The value of the option of a key. */
static int option_of(int key) {
  switch (key) {
  case PO_KEY_TABOR:
    return PO_FLAG_TABOR;
  case PO_KEY_COUPLING:
    return PO_FLAG_COUPLING;
  case PO_KEY_PROFILE:
    return PO_FLAG_PROFILE;
  case PO_KEY_PROFILE_FILE:
    return PO_FLAG_PROFILE_FILE;
  case PO_KEY_WAVES:
    return PO_FLAG_WAVE;
  default:
    break;
  }
  if (po_key_is_parameter(key, PO_OWNER_PROFILE))
    return PO_FLAG_PARAMETER + po_key_parameter(key);
  const int length = po_length_of_key(key);
  return length >= 0 ? PO_FLAG_LENGTH + length : PO_OPTION_KEYS + key;
}

size_t po_key_options(unsigned verb, struct option table[PO_MOST_OPTIONS], size_t count) {
  static char names[PO_KEY_END][2][PO_FLAG_LENGTH_OF_NAME]; /* the second in metres */
  for (int key = 0; key < PO_KEY_END; ++key) {
    if (!(po_key_row_of(key)->verbs & verb))
      continue;
    const int value = option_of(key);
    po_key_flag(key, names[key][0]);
    table[count++] = (struct option){names[key][0], required_argument, NULL, value};
    if (!po_key_row_of(key)->is_length)
      continue;
    snprintf(names[key][1], sizeof names[key][1], "%.29s-m", names[key][0]);
    table[count++] = (struct option){names[key][1], required_argument, NULL,
                                     value - PO_FLAG_LENGTH + PO_FLAG_METRES};
  }
  return count;
}

enum { COLUMN = 26, WIDTH = 93 };

/* Appends words in the right column. Given: used, the characters of the line so far. */
static void add_words(po_text *help, const char *text, size_t used) {
  const bool full = used + 2 > COLUMN;
  po_text_add(help, "%s%*s", full ? "\n" : "", (int)(full ? COLUMN : COLUMN - used), "");
  for (size_t column = COLUMN; *text;) {
    const size_t word = strcspn(text, " ");
    if (column > COLUMN && column + 1 + word > WIDTH) {
      po_text_add(help, "\n%*s", COLUMN, "");
      column = COLUMN;
    }
    po_text_add(help, "%s%.*s", column > COLUMN ? " " : "", (int)word, text);
    column += word + (column > COLUMN);
    text += word + (text[word] == ' ');
  }
  po_text_add(help, "\n");
}

static const char *help_of(const po_key_row *row, unsigned verb) {
  return verb == PO_FOR_THEORY && *row->help_of_form ? row->help_of_form : row->help;
}

/* Appends the options of the keys of some owners. Those without help come before the next one. */
static void add_options(unsigned verb, po_key_owner first, po_key_owner last, po_text *help) {
  size_t used = 0;
  for (int key = 0; key < PO_KEY_END; ++key) {
    const po_key_row *row = po_key_row_of(key);
    if (!(row->verbs & verb) || row->owner < first || row->owner > last)
      continue;
    char flag[PO_FLAG_LENGTH_OF_NAME], option[64];
    po_key_flag(key, flag);
    const size_t length = (size_t)snprintf(option, sizeof option, "--%s %s", flag, row->value);
    const bool fits = used && used + 2 + length <= WIDTH;
    po_text_add(help, "%s%s", fits ? ", " : used ? ",\n  " : "  ", option);
    used = (fits ? used : 0) + 2 + length;
    if (!*help_of(row, verb))
      continue;
    add_words(help, help_of(row, verb), used);
    used = 0;
  }
}

/* Appends the names of the keys that a series may vary, as the end of the help of an option. */
static void add_varying(po_text *help) {
  po_text names = {0};
  for (int key = 0; key < PO_KEY_END; ++key)
    if (po_key_is_continuous(key) && po_key_row_of(key)->verbs & PO_FOR_FOLLOW) {
      char flag[PO_FLAG_LENGTH_OF_NAME];
      po_key_flag(key, flag);
      po_text_add(&names, "%s, ", flag);
    }
  po_text_add(&names, "or in SI units radius-m, amplitude-m, wavelength-m, outer-radius-m, "
                      "modulus-pa, work-j-per-m2 or distance-m");
  add_words(help, po_text_string(&names), 0);
  po_text_clear(&names);
}

void po_key_help(unsigned verb, const char *text, po_text *help) {
  while (*text) {
    const int line = (int)strcspn(text, "\n");
    if (strncmp(text, "@scene", 6) == 0)
      add_options(verb, PO_OWNER_SCENE, PO_OWNER_PROFILE, help);
    else if (strncmp(text, "@trace", 6) == 0)
      add_options(verb, PO_OWNER_TRACE, PO_OWNER_TRACE, help);
    else if (strncmp(text, "@mesh", 5) == 0)
      add_options(verb, PO_OWNER_MESH, PO_OWNER_MESH, help);
    else if (strncmp(text, "@varying", 8) == 0)
      add_varying(help);
    else
      po_text_add(help, "%.*s\n", line, text);
    text += line + (text[line] == '\n');
  }
}
