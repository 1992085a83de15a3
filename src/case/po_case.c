#include "po_case.h"

#include <ctype.h>

#include "po_text.h"

bool po_case_is_name(const char *text) {
  for (const char *c = text; *c; ++c)
    if (!isalnum((unsigned char)*c) && *c != '_' && *c != '-')
      return false;
  return *text != '\0' && *text != '-';
}

bool po_sweep_names(const po_sweep *sweep, po_key key) {
  return sweep->named >> key & 1U;
}

const char *po_case_argument(const po_case *kase) {
  return kase->is_own ? kase->shown : kase->file->name;
}

const char *po_case_word(const po_case *kase) {
  return kase->word ? kase->word : kase->file->name;
}

po_status po_case_set_own(po_case *kase) {
  po_text word = {0};
  if (kase->shown[0] == '-') /* which would be an option */
    po_text_add(&word, "./");
  po_text_add_word(&word, kase->shown);
  kase->is_own = true;
  kase->word = word.data;
  return word.failed ? PO_NO_MEMORY : PO_OK;
}
