#include "po_case.h"

#include <ctype.h>

#include "po_case_parts.h"

bool po_case_is_name(const char *text) {
  for (const char *c = text; *c; ++c)
    if (!isalnum((unsigned char)*c) && *c != '_' && *c != '-')
      return false;
  return *text != '\0' && *text != '-';
}

_Static_assert(PO_KEY_END <= 64, "the keys of a sweep are bits of po_sweep.named");

bool po_sweep_names(const po_sweep *sweep, po_key key) {
  return sweep->named >> key & 1U;
}

const char *po_case_word(const po_case *kase) {
  return kase->word ? kase->word : kase->file->name;
}

bool po_sweep_varies(const po_sweep *sweep, po_key key) {
  if (po_sweep_names(sweep, key))
    return true;
  for (int other = 0; other < PO_KEY_END; ++other)
    if (po_key_target((po_key)other) == key && po_sweep_names(sweep, (po_key)other))
      return true;
  return false;
}

/* Whether a key is drawn, directly or by a group. */
static bool draws(const po_draw *draw, po_key key) {
  const int drawn = po_key_of_name(draw->key);
  return drawn == (int)key || (drawn >= 0 && po_key_target((po_key)drawn) == key);
}

bool po_case_draws(const po_case_file *file, po_key key) {
  for (unsigned i = 0; file->sample && i < file->sample->keys_count; ++i)
    if (draws(&file->sample->keys[i], key))
      return true;
  return false;
}

bool po_case_varies(const po_case_file *file, po_key key) {
  for (unsigned i = 0; i < file->sweep_count; ++i)
    if (po_sweep_varies(&file->sweep[i], key))
      return true;
  return po_case_draws(file, key);
}
