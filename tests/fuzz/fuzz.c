#include "fuzz.h"

#include <dirent.h>
#include <fcntl.h>
#include <ftw.h>
#include <jansson.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "po_case.h"
#include "po_csv.h"
#include "po_environment.h"
#include "po_file.h"
#include "po_json_value.h"
#include "po_memory.h"
#include "po_record.h"

/* Linked instead of the function that describes the running program (--wrap). Computing the digest
 * of the program takes longer than everything else for an input, and the keys in the corpus would
 * change with each build. */
po_status __wrap_po_environment_program(char digest[PO_DIGEST_LENGTH]);
po_status __wrap_po_environment_program(char digest[PO_DIGEST_LENGTH]) {
  strcpy(digest, "program");
  return PO_OK;
}

/* Linked instead of the comparison of checksums: no fuzzer guesses one. */
bool __wrap_po_digest_agrees(const char *stated, const char *computed);
bool __wrap_po_digest_agrees(const char *stated, const char *computed) {
  (void)stated;
  (void)computed;
  return true;
}

void fuzz_require(bool holds, const char *format, ...) {
  if (holds)
    return;
  va_list arguments;
  va_start(arguments, format);
  fputs("fuzz: a property does not hold: ", stderr);
  vfprintf(stderr, format, arguments);
  fputs("\n", stderr);
  va_end(arguments);
  abort();
}

/* The length of the UTF-8 character at `c`; 0 if it is not valid. Surrogates and overlong encodings
 * are not valid. */
static size_t character_length(const unsigned char *c) {
  if (c[0] < 0x80)
    return 1;
  const size_t length = c[0] >= 0xf0 ? 4 : c[0] >= 0xe0 ? 3 : 2;
  static const unsigned SMALLEST[] = {0, 0, 0x80, 0x800, 0x10000};
  unsigned value = c[0] & (0x7fu >> length);
  if (c[0] < 0xc2 || c[0] > 0xf4)
    return 0;
  for (size_t i = 1; i < length; ++i) {
    if ((c[i] & 0xc0) != 0x80)
      return 0;
    value = value << 6 | (c[i] & 0x3fu);
  }
  const bool surrogate = value >= 0xd800 && value <= 0xdfff;
  return value < SMALLEST[length] || value > 0x10ffff || surrogate ? 0 : length;
}

void fuzz_require_words(const char *what, const char *text, bool lines) {
  const unsigned char *c = (const unsigned char *)text;
  while (*c) {
    const size_t length = character_length(c);
    fuzz_require(length > 0, "%s is not UTF-8 at byte %td: %s", what, (const char *)c - text, text);
    const bool control = *c < 0x20 || *c == 0x7f || (c[0] == 0xc2 && c[1] < 0xa0);
    fuzz_require(!control || (lines && *c == '\n'),
                 "%s has the control character %02x at byte %td: %s", what, *c,
                 (const char *)c - text, text);
    c += length;
  }
}

void fuzz_require_message(po_status status) {
  if (status && status != PO_NOT_FOUND)
    fuzz_require(*po_message() != '\0', "the status %s has no message", po_status_name(status));
  if (status)
    fuzz_require_words("a message", po_message(), false);
  po_message_clear();
}

void fuzz_require_request(const po_request *request) {
  po_request back = po_request_default();
  for (int key = 0; key < PO_KEY_COUNT; ++key) {
    char text[PO_KEY_TEXT_LENGTH];
    const double value = po_key_number(request, (po_key)key);
    po_key_print(request, (po_key)key, text);
    if (po_key_is_idle(request, (po_key)key))
      continue;
    fuzz_require(po_key_set(&back, (po_key)key, text), "%s is printed as %s, which is refused",
                 PO_KEYS[key].name, text);
    fuzz_require(po_key_number(&back, (po_key)key) == value,
                 "%s is printed as %s, which is another", PO_KEYS[key].name, text);
    fuzz_require(po_key_matches(request, (po_key)key, text), "%s does not match its own text %s",
                 PO_KEYS[key].name, text);
  }
}

static char scratch[PATH_MAX];

static int remove_one(const char *path, const struct stat *found, int type, struct FTW *place) {
  (void)found, (void)type, (void)place;
  return remove(path);
}

static void remove_scratch(void) {
  nftw(scratch, remove_one, 16, FTW_DEPTH | FTW_PHYS);
}

const char *fuzz_path(const char *name) {
  enum { MOST = 64 };
  static char *paths[MOST];
  static size_t count = 0;
  if (!*scratch) {
    const char *folder = getenv("TMPDIR");
    snprintf(scratch, sizeof scratch, "%s/pulloff-fuzz-XXXXXX", folder ? folder : "/tmp");
    fuzz_require(mkdtemp(scratch) != NULL, "no scratch folder %s can be made", scratch);
    atexit(remove_scratch);
  }
  for (size_t i = 0; i < count; ++i)
    if (strcmp(paths[i] + strlen(scratch) + 1, name) == 0)
      return paths[i];
  fuzz_require(count < MOST, "there are more than %d scratch files", MOST);
  char *path = po_copy_text(po_path_join(scratch, name).text);
  fuzz_require(path != NULL, "no memory for a path");
  return paths[count++] = path;
}

void fuzz_write(const char *path, const char *bytes, size_t size) {
  int file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) {
    char folder[PATH_MAX];
    snprintf(folder, sizeof folder, "%s", path);
    *strrchr(folder, '/') = '\0';
    po_folder_make(folder);
    file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  }
  fuzz_require(file >= 0 && write(file, bytes, size) == (ssize_t)size, "%s cannot be written",
               path);
  close(file);
}

void fuzz_empty(const char *folder) {
  DIR *stream = opendir(folder);
  for (struct dirent *entry; stream && (entry = readdir(stream));)
    if (entry->d_type == DT_REG)
      unlinkat(dirfd(stream), entry->d_name, 0);
  if (stream)
    closedir(stream);
}

size_t fuzz_split(const uint8_t *data, size_t size, fuzz_part *parts, size_t most) {
  static const char CUT[] = "%%\n";
  const size_t cut = sizeof CUT - 1;
  char *text = malloc(size + 1);
  fuzz_require(text != NULL, "no memory for an input");
  memcpy(text, data, size);
  text[size] = '\0';
  size_t count = 0, begin = 0;
  for (size_t i = 0; i + cut <= size && count + 1 < most; ++i)
    if ((i == begin || text[i - 1] == '\n') && memcmp(text + i, CUT, cut) == 0) {
      text[i] = '\0';
      parts[count++] = (fuzz_part){text + begin, i - begin};
      begin = i + cut;
      i = begin - 1;
    }
  parts[count++] = (fuzz_part){text + begin, size - begin};
  return count;
}

fuzz_part fuzz_fill(const fuzz_part *part, const fuzz_token *tokens, size_t count) {
  po_text text = {0};
  for (size_t i = 0; i < part->size;) {
    const fuzz_token *token = NULL;
    for (size_t k = 0; !token && part->bytes[i] == '@' && k < count; ++k)
      if (strncmp(part->bytes + i, tokens[k].token, strlen(tokens[k].token)) == 0)
        token = &tokens[k];
    if (token)
      po_text_add_bytes(&text, token->value, strlen(token->value));
    else
      po_text_add_bytes(&text, part->bytes + i, 1);
    i += token ? strlen(token->token) : 1;
  }
  po_text_add_bytes(&text, "", 0);
  fuzz_require(!text.failed, "no memory for an input");
  return (fuzz_part){text.data, text.length};
}

po_case_run *fuzz_run(const char *name) {
  char path[PATH_MAX], shown[64];
  po_case *kase = NULL;
  po_plan *plan = NULL;
  po_case_run *run = calloc(1, sizeof *run);
  snprintf(path, sizeof path, "%s/cases/%s.yaml", FUZZ_DATA, name);
  snprintf(shown, sizeof shown, "cases/%s.yaml", name);
  po_status status = run ? po_case_read(path, shown, &kase) : PO_NO_MEMORY;
  if (!status)
    status = po_plan_create(kase, FUZZ_DATA, NULL, &plan);
  if (!status)
    status = po_case_run_create(plan, run);
  fuzz_require(!status, "the case %s cannot be planned: %s", name, po_message());
  return run;
}

void fuzz_run_reset(po_case_run *run) {
  const size_t count = run->plan->kase->point_count;
  for (size_t i = 0; i < count; ++i) {
    po_result_clear(&run->points[i].result);
    po_result_clear(&run->points[i].trace);
    run->points[i].done = false;
    run->points[i].checksum[0] = '\0';
  }
  po_check_results_clear(&run->check_results);
  po_check_results_clear(&run->measured);
  json_decref(run->environment);
  run->environment = NULL;
  run->kept = run->finished = false;
  run->damaged = run->current = run->untidy = false;
  run->resumed = run->altered = 0;
  po_case_run_ask(run, &(po_point_range){0, count}, 1);
}

void fuzz_require_same_point(const po_case_run *a, const po_case_run *b, size_t point) {
  json_t *x = po_record_point(a, point), *y = po_record_point(b, point);
  fuzz_require(x && y, "point %zu cannot be written: %s", point, po_message());
  if (!json_equal(x, y)) {
    po_text first = {0}, second = {0};
    po_json_print_line(x, &first);
    po_json_print_line(y, &second);
    fuzz_require(false, "point %zu is written as\n%sand read back as\n%s", point,
                 po_text_string(&first), po_text_string(&second));
  }
  json_decref(x);
  json_decref(y);
}
