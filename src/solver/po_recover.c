#include "po_recover.h"

#include <stdlib.h>
#include <string.h>

#include "po_ask_folder.h"
#include "po_file.h"
#include "po_memory.h"
#include "po_response.h"

/* Takes the complete successful answers of a response that an interrupted run left. */
static po_status take_left(const po_question *questions, size_t count, bool *done, const char *path,
                           po_answer_taker *take, void *context) {
  po_response response = {.path = path, .file = -1};
  po_status status = PO_OK;
  const char *line = NULL;
  size_t length = 0, before = 0;
  do {
    before = response.read;
    if (!po_response_read(&response))
      break;
    while (!status && (line = po_response_line(&response, false, &length))) {
      po_answer answer;
      status = po_answer_read(line, length, &answer);
      size_t q = 0;
      while (q < count && (done[q] || strcmp(questions[q].id, answer.id) != 0))
        ++q;
      if (!status && q < count)
        po_answer_check(&questions[q], &answer);
      /* of repeated solves, all would be needed: such a point is solved again */
      if (!status && q < count && answer.result.status == PO_OK && questions[q].repeats == 1 &&
          answer.repeat == 1) {
        done[q] = true;
        status = take(context, q, &answer, true);
      }
      po_answer_clear(&answer);
    }
  } while (!status && response.read > before);
  po_response_close(&response);
  return status;
}

po_status po_recover(const po_question *questions, size_t count, const char *folder,
                     const char *key, po_answer_taker *take, void *context) {
  char **names = NULL;
  size_t name_count = 0;
  bool *done = po_allocate(count, sizeof *done);
  po_status status = done ? PO_OK : PO_NO_MEMORY;
  if (!status && po_path_exists(folder))
    status = po_folder_list(folder, "", &names, &name_count);
  for (size_t i = 0; !status && i < name_count; ++i) {
    char *path = strncmp(names[i], "ask-", 4) == 0 ? po_path_join(folder, names[i]) : NULL;
    char *response = path && po_ask_folder_is_left(path, key) ? po_ask_folder_response(path) : NULL;
    if (response)
      status = take_left(questions, count, done, response, take, context);
    if ((response && !status) || (path && !status && po_ask_folder_is_debris(path)))
      po_ask_folder_remove(path);
    free(response);
    free(path);
  }
  po_names_free(names, name_count);
  free(done);
  return status;
}
