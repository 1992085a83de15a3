#include "po_use.h"

#include <stdio.h>
#include <string.h>

po_status po_use_check(const char *what, const po_use *uses, size_t count) {
  const po_use *idle = NULL;
  size_t taken = 0, named = 0;
  for (size_t i = 0; i < count; ++i) {
    if (uses[i].given && !uses[i].taken && !idle)
      idle = &uses[i];
    taken += uses[i].taken;
  }
  char names[1000] = "";
  for (size_t i = 0; idle && i < count; ++i)
    if (uses[i].taken) {
      const char *before = named == 0 ? "only " : named + 1 < taken ? ", " : " or ";
      snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", before, uses[i].name);
      ++named;
    }
  return idle ? po_fail(PO_BAD_INPUT, "%s has no effect on %s: expected %s", idle->name, what,
                        *names ? names : "it to be left out")
              : PO_OK;
}
