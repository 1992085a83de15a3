/* Numbers and keys of a scene: a line is `key value`, or a number. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "po_number.h"

static void require_number(const char *text) {
  double value = 0, back = 0;
  size_t count = 0;
  char printed[PO_NUMBER_LENGTH];
  if (po_number_parse(text, &value)) {
    fuzz_require(isfinite(value), "%s is read as a number that is not finite", text);
    po_number_print(value, printed);
    fuzz_require(po_number_parse(printed, &back) && back == value, "%s is printed as %s", text,
                 printed);
  }
  if (po_number_parse_count(text, &count)) {
    char *end = NULL;
    fuzz_require(count == strtoull(text, &end, 10) && *end == '\0', "%s is no count", text);
    fuzz_require(po_number_parse(text, &value) && value == (double)count,
                 "%s is a count and no number", text);
  }
}

static void set(po_request *request, const char *name, const char *text) {
  const int key = po_key_of_name(name);
  po_request before;
  char printed[PO_KEY_TEXT_LENGTH];
  if (key < 0)
    return;
  memcpy(&before, request, sizeof before); /* with its padding, unlike an assignment */
  fuzz_require(strcmp(PO_KEYS[key].name, name) == 0, "%s is the key of another name", name);
  if (!po_key_set(request, (po_key)key, text)) {
    fuzz_require(memcmp(&before, request, sizeof before) == 0, "a refused %s changes the request",
                 name);
    /* A table is also matched by the digest of its content, and a profile without one by "-". */
    fuzz_require(key == PO_KEY_PROFILE_FILE || !po_key_matches(request, (po_key)key, text),
                 "%s matches a refused %s", name, text);
    fuzz_require(*PO_KEYS[key].expected != '\0', "nothing is expected of %s", name);
    return;
  }
  /* A parameter of another profile or law is kept for later, and has no number until then. */
  const bool kept = isnan(po_key_number(request, (po_key)key));
  fuzz_require(po_key_is_group(key) || po_key_matches(request, (po_key)key, text) == !kept,
               "%s is set to %s and %s it", name, text,
               kept ? "already matches" : "does not match");
  po_key_print(request, (po_key)key, printed);
  fuzz_require_words("a value", printed, false);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_part text;
  fuzz_split(data, size, &text, 1);
  po_request request;
  memset(&request, 0, sizeof request); /* the padding, which is compared */
  request = po_request_default();
  char *rest = NULL;
  for (char *line = strtok_r(text.bytes, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest)) {
    char *blank = strchr(line, ' ');
    require_number(line);
    if (blank) {
      *blank = '\0';
      require_number(blank + 1);
      set(&request, line, blank + 1);
    }
  }
  const po_status status = po_request_check(&request);
  fuzz_require_message(status);
  po_text command = {0};
  if (!status) {
    po_input_add_command(&request, &command);
    fuzz_require_words("a command", command.data, false);
    fuzz_require_request(&request);
  }
  po_text_clear(&command);
  free(text.bytes);
  return 0;
}
