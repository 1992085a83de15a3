/* The lines of a response of an external solver, to a question that wants every quantity. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "po_answer.h"
#include "po_json.h"

/* What an answer that was accepted must satisfy. */
static void require_result(const po_result *o) {
  const po_loop *loop = &o->hysteresis.of[PO_AT_APPROACH];
  fuzz_require(isfinite(o->pull_off.force) && isfinite(o->pull_off.approach),
               "a pull-off that is not finite is accepted");
  fuzz_require(o->curve_count >= 3, "a curve of %zu points is accepted", o->curve_count);
  for (size_t i = 0; i < o->curve_count; ++i)
    fuzz_require(isfinite(o->curve[i].approach) && isfinite(o->curve[i].load),
                 "point %zu of the curve is not finite", i);
  for (size_t i = 0; i < o->fold_count; ++i)
    fuzz_require(isfinite(o->folds[i].approach) && o->folds[i].kind <= PO_JUMP_OUT,
                 "fold %zu is accepted", i);
  for (size_t i = 0; i < loop->jump_count; ++i)
    fuzz_require(loop->jumps[i].loading == (i < loop->loading_jumps), "jump %zu is out of order",
                 i);
}

static void read_line(const char *line, size_t length) {
  static const po_question EVERY = {.repeats = 1, .want = ~0U};
  po_answer answer;
  const po_status status = po_answer_read(line, length, &answer);
  fuzz_require(status == PO_OK || status == PO_NO_MEMORY, "the status of an answer is %d",
               (int)status);
  po_answer_check(&EVERY, &answer);
  po_result *o = &answer.result;
  fuzz_require(o->status == PO_OK || o->status == PO_UNSUPPORTED || o->status == PO_FAILED ||
                   o->status == PO_INVALID,
               "an answer has the status %s", po_status_name(o->status));
  fuzz_require((o->status == PO_OK) || *o->reason, "an answer that is refused has no reason");
  fuzz_require_words("a reason", o->reason, false);
  if (o->status == PO_OK)
    require_result(o);
  /* what is stored in a record is read back */
  const po_request request = po_request_default();
  json_t *document = po_json_result(&request, o);
  po_result again;
  fuzz_require(document && po_json_read_result(document, &again) == PO_OK,
               "an answer is not read back");
  fuzz_require(again.status == o->status && again.fold_count == o->fold_count,
               "an answer is read back differently");
  po_result_clear(&again);
  json_decref(document);
  po_result_clear(&answer.result);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  for (size_t begin = 0; begin < size;) {
    const uint8_t *end = memchr(data + begin, '\n', size - begin);
    const size_t length = end ? (size_t)(end - data) - begin : size - begin;
    read_line((const char *)data + begin, length);
    begin += length + 1;
  }
  return 0;
}
