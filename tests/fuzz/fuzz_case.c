/* The YAML of a case, parsed, expanded to its points, and planned. */
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "po_case.h"
#include "po_plan.h"

/* A plan looks up every reference for every point. More points take more time and test nothing new.
 */
enum { MOST_PLANNED = 2000 };

static void require_points(const po_case *kase) {
  fuzz_require(kase->point_count > 0, "a case without points is accepted");
  for (size_t i = 0; i < kase->point_count; ++i) {
    const po_point *point = &kase->points[i];
    fuzz_require(po_request_check(&point->request) == PO_OK, "point %zu is accepted, but: %s", i,
                 po_message());
    if (i > 0 && i + 1 < kase->point_count && i % 64)
      continue; /* the first, the last, and a few between */
    fuzz_require_words("a label", point->label, false);
    fuzz_require_request(&point->request);
    po_text command = {0};
    po_input_add_command(&point->request, &command);
    fuzz_require_words("a command", command.data, false);
    po_text_clear(&command);
  }
}

static po_status plan(const po_case *kase, char key[PO_DIGEST_LENGTH]) {
  po_plan *made = NULL;
  po_status status = po_plan_create(kase, FUZZ_DATA, NULL, &made);
  json_t *lines = status ? NULL : po_plan_describe(made);
  fuzz_require_message(status);
  for (size_t i = 0; i < json_array_size(lines); ++i)
    fuzz_require_words("the plan", json_string_value(json_array_get(lines, i)), false);
  json_decref(lines);
  if (made)
    memcpy(key, made->key, PO_DIGEST_LENGTH);
  po_plan_destroy(made);
  return status;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  const char *path = fuzz_path("cases/fuzz.yaml");
  fuzz_write(path, (const char *)data, size);
  po_case *kase = NULL;
  const po_status status = po_case_read(path, "cases/fuzz.yaml", &kase);
  fuzz_require_message(status);
  if (status)
    return 0;
  require_points(kase);
  if (kase->point_count <= MOST_PLANNED) {
    char key[PO_DIGEST_LENGTH] = "", again[PO_DIGEST_LENGTH] = "";
    const po_status planned = plan(kase, key);
    if (size % 8 == 0) /* only for some inputs: planning takes most of the time */
      fuzz_require(plan(kase, again) == planned && strcmp(key, again) == 0,
                   "two plans of a case differ");
  }
  po_case_destroy(kase);
  return 0;
}
