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

/* For whom answers are recovered. */
typedef struct {
  const po_question *questions;
  po_answer_taker *take;
  void *context;
  po_taking *taking;
} recovery;

/* Takes a complete successful answer that an interrupted run left. Of repeated solves, all would be
 * needed: such a point is solved again. A question without such an answer stays open, since another
 * folder may have one. */
static po_status take_left(void *context, size_t question, po_answer *answer, bool final) {
  const recovery *r = context;
  if (!answer->result.status && r->questions[question].repeats == 1)
    return r->take(r->context, question, answer, final);
  r->taking->open[question] = true;
  r->taking->spoiled[question] = false;
  r->taking->seen[question] = 0;
  return PO_OK;
}

po_status po_recover(const po_question *questions, size_t count, const char *folder,
                     const char *key, po_answer_taker *take, void *context) {
  char **names = NULL;
  size_t name_count = 0;
  po_taking taking;
  recovery r = {questions, take, context, &taking};
  po_status status = po_taking_make(questions, count, take_left, &r, &taking);
  if (!status && po_path_exists(folder))
    status = po_folder_list(folder, "", &names, &name_count);
  for (size_t i = 0; !status && i < name_count; ++i) {
    char *path = strncmp(names[i], "ask-", 4) == 0 ? po_path_join(folder, names[i]) : NULL;
    char *response =
        path && ask_folder_is_left(path, key) ? po_path_join(path, RESPONSE_FILE) : NULL;
    if (response) {
      po_taking_begin(&taking, response);
      status = po_taking_lines(&taking, false);
    }
    if ((response && !status) || (path && !status && ask_folder_is_debris(path)))
      po_ask_folder_remove(path);
    free(response);
    free(path);
  }
  po_names_free(names, name_count);
  po_taking_clear(&taking);
  return status;
}
