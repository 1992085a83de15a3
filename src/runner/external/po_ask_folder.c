#include "po_ask_folder.h"

#include <fcntl.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "po_file.h"

static const char RESPONSE_FILE[] = "response.jsonl";

enum { NAME_LENGTH = 32 }; /* length of the name of a folder: ask-KEY-XXXXXX */

static int remove_entry(const char *path, const struct stat *found, int type, struct FTW *walk) {
  (void)found;
  (void)type;
  (void)walk;
  return remove(path);
}

void po_ask_folder_remove(const char *folder) {
  nftw(folder, remove_entry, 16, FTW_DEPTH | FTW_PHYS | FTW_MOUNT);
}

/* The beginning of the names of the folders that belong to a key. */
static void name_start(const char *key, char name[NAME_LENGTH]) {
  snprintf(name, NAME_LENGTH, "ask-%.16s%s", key ? key : "", key ? "-" : "");
}

/* Opens a folder and locks it. The system unlocks it when the process ends. Returned: the
 * descriptor; -1 if another process has locked it. */
static int lock_folder(const char *folder) {
  const int file = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file >= 0 && flock(file, LOCK_EX | LOCK_NB) == 0)
    return file;
  if (file >= 0)
    close(file);
  return -1;
}

po_status po_ask_folder_make(const char *parent, const char *key, po_ask_folder *f) {
  char name[NAME_LENGTH];
  name_start(key, name);
  *f = (po_ask_folder){.lock = -1};
  const po_status status = po_folder_make(parent);
  if (status)
    return status;
  do { /* again if another run removed the folder before it was locked */
    po_ask_folder_unlock(f);
    po_file_path made = po_path_join(parent, strcat(name, "XXXXXX"));
    const bool is_made = mkdtemp(made.text);
    if (!is_made || !realpath(made.text, f->path.text)) {
      if (is_made)
        rmdir(made.text);
      f->path.text[0] = '\0'; /* realpath may have left a part of it */
      return po_fail(PO_CANNOT_WRITE, "a folder for the solver cannot be created in %s", parent);
    }
    f->lock = lock_folder(f->path.text);
    name_start(key, name);
  } while (!po_path_exists(f->path.text));
  f->request = po_path_join(f->path.text, "request.json");
  f->table = po_path_join(f->path.text, "request.csv");
  f->response = po_path_join(f->path.text, RESPONSE_FILE);
  return PO_OK;
}

void po_ask_folder_unlock(po_ask_folder *f) {
  if (f->lock >= 0)
    close(f->lock);
  f->lock = -1;
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

/* Takes the answers in a folder and removes it, if it is of a run that does not live any more. */
static po_status recover_folder(po_taking *taking, const char *folder) {
  const int lock = lock_folder(folder);
  if (lock < 0)
    return PO_OK;
  const po_file_path response = po_path_join(folder, RESPONSE_FILE);
  po_taking_begin(taking, response.text);
  const po_status status = po_taking_lines(taking, false);
  if (!status)
    po_ask_folder_remove(folder);
  close(lock);
  return status;
}

po_status po_recover(const po_question *questions, size_t count, const char *folder,
                     const char *key, po_answer_taker *take, void *context) {
  char **names = NULL, start[NAME_LENGTH];
  size_t name_count = 0;
  po_taking taking;
  recovery r = {questions, take, context, &taking};
  name_start(key, start);
  po_status status = po_taking_make(questions, count, take_left, &r, &taking);
  if (!status && po_path_exists(folder))
    status = po_folder_list(folder, "", &names, &name_count);
  for (size_t i = 0; !status && i < name_count; ++i)
    if (strncmp(names[i], start, strlen(start)) == 0)
      status = recover_folder(&taking, po_path_join(folder, names[i]).text);
  po_names_free(names, name_count);
  po_taking_clear(&taking);
  return status;
}
