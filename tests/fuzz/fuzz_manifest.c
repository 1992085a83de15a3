/* The manifest of an external solver, and the request that is written for it. */
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "po_input.h"
#include "po_json.h"
#include "po_question.h"

static void require_request(const po_solver *solver, const po_request *request) {
  po_question question = {.id = "1", .request = *request, .repeats = 1, .limit = 1};
  const bool open = true;
  po_text text = {0}, table = {0};
  json_t *document = NULL;
  question.want = solver->quantities;
  fuzz_require(po_questions_print(solver, &question, &open, 1, &text, &table) == PO_OK &&
                   po_json_parse(text.data, text.length, &document) == PO_OK,
               "a request is not JSON: %s", po_message());
  fuzz_require_words("a table", table.data, true);
  json_decref(document);
  po_text_clear(&text);
  po_text_clear(&table);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  const char *path = fuzz_path("solvers/manifest.yaml");
  po_solver *solver = NULL;
  char why[PO_SOLVER_WHY];
  fuzz_write(path, (const char *)data, size);
  const po_status status = po_solver_read(path, NULL, &solver);
  fuzz_require_message(status);
  if (status)
    return 0;
  po_request request = po_input_default();
  fuzz_require(*solver->name && solver->command[0][0] == '/' && solver->time_limit > 0,
               "a solver without a name, a program or a time limit is accepted");
  fuzz_require_words("the name of a solver", solver->name, false);
  for (int wavy = 0; wavy < 2; ++wavy) {
    if (po_solver_accepts(solver, &request, why))
      require_request(solver, &request);
    else
      fuzz_require_words("a reason", why, false);
    po_key_set(&request, PO_KEY_AMPLITUDE, "1");
    po_key_set(&request, PO_KEY_WAVELENGTH, "20");
  }
  po_solver_destroy(solver);
  return 0;
}
