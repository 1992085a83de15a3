#include "po_ask_folder.h"

#include <fcntl.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "po_digest.h"
#include "po_file.h"
#include "po_memory.h"

/* Files in the folder of a process. */
static const char KEY_FILE[] = "key", RESPONSE_FILE[] = "response.jsonl";

/* Seconds after which a folder without a key belongs to no process that has just begun, or that is
 * asked nothing to measure its start. */
static const time_t DEBRIS_AGE = 600;

static int remove_entry(const char *path, const struct stat *found, int type, struct FTW *walk) {
  (void)found;
  (void)type;
  const bool last =
      walk->level == 0 || (walk->level == 1 && strcmp(path + walk->base, KEY_FILE) == 0);
  return last ? 0 : remove(path);
}

/* The key goes last: if the program is killed in between, the next run still knows the folder as
 * one of its own. */
void po_ask_folder_remove(const char *folder) {
  char *key = po_path_join(folder, KEY_FILE);
  nftw(folder, remove_entry, 16, FTW_DEPTH | FTW_PHYS | FTW_MOUNT);
  if (key)
    remove(key);
  remove(folder);
  free(key);
}

/* Writes the key into the folder and locks the file. */
static po_status lock_key(po_ask_folder *f, const char *key) {
  char *path = po_path_join(f->path, KEY_FILE);
  if (!path)
    return PO_NO_MEMORY;
  po_status status = po_file_write(path, key, strlen(key));
  if (!status)
    f->lock = open(path, O_RDONLY | O_CLOEXEC);
  if (f->lock >= 0)
    (void)flock(f->lock, LOCK_EX | LOCK_NB);
  free(path);
  return status;
}

po_status po_ask_folder_make(const char *parent, const char *key, po_ask_folder *f) {
  *f = (po_ask_folder){.path = po_path_join(parent, "ask-XXXXXX"), .lock = -1};
  po_status status = f->path ? po_folder_make(parent) : PO_NO_MEMORY;
  if (!status && !mkdtemp(f->path))
    status = po_fail(PO_CANNOT_WRITE, "a folder for the solver cannot be created in %s", parent);
  char *real = status ? NULL : realpath(f->path, NULL);
  if (!status && real) {
    free(f->path);
    f->path = real;
    f->request = po_path_join(real, "request.json");
    f->table = po_path_join(real, "request.csv");
    f->response = po_path_join(real, RESPONSE_FILE);
  }
  if (!status && !(f->request && f->table && f->response))
    status = PO_NO_MEMORY;
  if (!status && key)
    status = lock_key(f, key);
  return status;
}

po_status po_ask_folder_write(const po_ask_folder *f, const po_solver *solver,
                              const po_question *questions, const bool *open, size_t count) {
  po_text request = {0}, table = {0};
  po_status status = po_questions_json(solver, questions, open, count, &request);
  if (!status)
    status = po_questions_table(solver, questions, open, count, &table);
  if (!status)
    status = po_file_write(f->request, request.data, request.length);
  if (!status)
    status = po_file_write(f->table, table.data, table.length);
  po_text_clear(&request);
  po_text_clear(&table);
  return status;
}

void po_ask_folder_clear(po_ask_folder *f) {
  free(f->path);
  free(f->request);
  free(f->table);
  free(f->response);
  if (f->lock >= 0)
    close(f->lock);
  *f = (po_ask_folder){.lock = -1};
}

/* Reports whether a folder was made with the same key by a run that does not live any more. */
static bool ask_folder_is_left(const char *folder, const char *key) {
  char *path = po_path_join(folder, KEY_FILE), found[PO_DIGEST_LENGTH] = "";
  const int file = path ? open(path, O_RDONLY | O_CLOEXEC) : -1;
  free(path);
  if (file < 0)
    return false;
  const bool same =
      read(file, found, sizeof found - 1) == (ssize_t)strlen(key) && strcmp(found, key) == 0;
  const bool left = same && flock(file, LOCK_EX | LOCK_NB) == 0;
  close(file);
  return left;
}

/* Reports whether a folder has no key and is ten minutes old: its run was killed before it had
 * begun.
 */
static bool ask_folder_is_debris(const char *folder) {
  struct stat found;
  char *path = po_path_join(folder, KEY_FILE);
  const bool debris = path && !po_path_exists(path) && stat(folder, &found) == 0 &&
                      time(NULL) - found.st_mtime > DEBRIS_AGE;
  free(path);
  return debris;
}

/* Returned: the path of the response in a folder, to be freed; NULL without memory. */
static char *ask_folder_response(const char *folder) {
  return po_path_join(folder, RESPONSE_FILE);
}

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
      po_result_clear(&answer.result);
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
    char *response = path && ask_folder_is_left(path, key) ? ask_folder_response(path) : NULL;
    if (response)
      status = take_left(questions, count, done, response, take, context);
    if ((response && !status) || (path && !status && ask_folder_is_debris(path)))
      po_ask_folder_remove(path);
    free(response);
    free(path);
  }
  po_names_free(names, name_count);
  free(done);
  return status;
}
