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
  nftw(folder, remove_entry, 16, FTW_DEPTH | FTW_PHYS | FTW_MOUNT);
  remove(po_path_join(folder, KEY_FILE).text);
  remove(folder);
}

/* Writes the key into the folder and locks the file. */
static po_status lock_key(po_ask_folder *f, const char *key) {
  const po_file_path path = po_path_join(f->path.text, KEY_FILE);
  const po_status status = po_file_write(path.text, key, strlen(key));
  if (!status)
    f->lock = open(path.text, O_RDONLY | O_CLOEXEC);
  if (f->lock >= 0)
    (void)flock(f->lock, LOCK_EX | LOCK_NB);
  return status;
}

po_status po_ask_folder_make(const char *parent, const char *key, po_ask_folder *f) {
  po_file_path made = po_path_join(parent, "ask-XXXXXX");
  *f = (po_ask_folder){.lock = -1};
  const po_status status = po_folder_make(parent);
  if (status)
    return status;
  const bool is_made = mkdtemp(made.text);
  if (!is_made || !realpath(made.text, f->path.text)) {
    if (is_made)
      rmdir(made.text);
    f->path.text[0] = '\0'; /* realpath may have left a part of it */
    return po_fail(PO_CANNOT_WRITE, "a folder for the solver cannot be created in %s", parent);
  }
  f->request = po_path_join(f->path.text, "request.json");
  f->table = po_path_join(f->path.text, "request.csv");
  f->response = po_path_join(f->path.text, RESPONSE_FILE);
  return key ? lock_key(f, key) : PO_OK;
}

void po_ask_folder_unlock(po_ask_folder *f) {
  if (f->lock >= 0)
    close(f->lock);
  f->lock = -1;
}

/* Reports whether a folder was made with the same key by a run that does not live any more. */
static bool ask_folder_is_left(const char *folder, const char *key) {
  char found[PO_DIGEST_LENGTH] = "";
  const int file = open(po_path_join(folder, KEY_FILE).text, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
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
  return !po_path_exists(po_path_join(folder, KEY_FILE).text) && stat(folder, &found) == 0 &&
         time(NULL) - found.st_mtime > DEBRIS_AGE;
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
    const po_file_path path = po_path_join(folder, names[i]);
    if (strncmp(names[i], "ask-", 4) != 0)
      continue;
    const bool left = ask_folder_is_left(path.text, key);
    if (left) {
      const po_file_path response = po_path_join(path.text, RESPONSE_FILE);
      po_taking_begin(&taking, response.text);
      status = po_taking_lines(&taking, false);
    }
    if (!status && (left || ask_folder_is_debris(path.text)))
      po_ask_folder_remove(path.text);
  }
  po_names_free(names, name_count);
  po_taking_clear(&taking);
  return status;
}
