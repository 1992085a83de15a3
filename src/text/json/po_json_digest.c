#include "po_json_digest.h"

#include <stdlib.h>
#include <string.h>

#include "po_memory.h"

/* Members without a line: those with one of these names, and objects with one of the others. (A
 * loop has a number called `work`, which is a result.) */
static const char *const NO_RESULT[] = {"schema",
                                        "digest",
                                        "reason",
                                        "seconds",
                                        "condition",
                                        "bordered_condition",
                                        "error_over_tolerance"};
static const char *const NO_RESULTS[] = {"input",         "work",    "physical",
                                         "interpolation", "assumes", "parabola"};

static bool is_one_of(const char *key, const char *const *names, size_t count) {
  for (size_t k = 0; k < count; ++k)
    if (strcmp(key, names[k]) == 0)
      return true;
  return false;
}

static bool is_result(const char *key, const json_t *value) {
  return !is_one_of(key, NO_RESULT, sizeof NO_RESULT / sizeof *NO_RESULT) &&
         !(json_is_object(value) &&
           is_one_of(key, NO_RESULTS, sizeof NO_RESULTS / sizeof *NO_RESULTS));
}

static int by_bytes(const void *left, const void *right) {
  return strcmp(*(const char *const *)left, *(const char *const *)right);
}

/* The lines so far, and the path of the present value, which grows and shrinks. Lack of memory is
 * kept in both and reported at the end. */
typedef struct {
  po_text path, lines;
} writer;

static void add_leaf(writer *w, const json_t *value) {
  po_text_add(&w->lines, "%s=", po_text_string(&w->path));
  if (json_is_number(value)) {
    const double number = json_number_value(value) == 0.0 ? 0.0 : json_number_value(value);
    uint64_t bits; /* -0 has those of 0, because some programs do not keep its sign */
    memcpy(&bits, &number, sizeof bits);
    po_text_add(&w->lines, "%016llx\n", (unsigned long long)bits);
    return;
  }
  po_text_add(&w->lines, "%s\n",
              json_is_string(value)  ? json_string_value(value)
              : json_is_true(value)  ? "true"
              : json_is_false(value) ? "false"
                                     : "null");
}

static void add_value(writer *w, const json_t *value);

/* Adds the value of a member or an element. */
static void add_part(writer *w, const char *name, const json_t *value) {
  const size_t length = w->path.length;
  po_text_add(&w->path, "/%s", name);
  add_value(w, value);
  w->path.length = length;
  if (w->path.data)
    w->path.data[length] = '\0';
}

static void add_object(writer *w, const json_t *object) {
  const char **keys = po_allocate(json_object_size(object), sizeof *keys), *key;
  json_t *value;
  size_t count = 0;
  w->path.failed = w->path.failed || !keys;
  if (!keys)
    return;
  json_object_foreach((json_t *)object, key, value) {
    if (is_result(key, value))
      keys[count++] = key;
  }
  qsort(keys, count, sizeof *keys, by_bytes);
  for (size_t k = 0; k < count; ++k)
    add_part(w, keys[k], json_object_get(object, keys[k]));
  free(keys);
}

static void add_value(writer *w, const json_t *value) {
  if (json_is_object(value)) {
    add_object(w, value);
  } else if (json_is_array(value)) {
    for (size_t k = 0; k < json_array_size(value); ++k) {
      char number[24];
      snprintf(number, sizeof number, "%zu", k);
      add_part(w, number, json_array_get(value, k));
    }
  } else {
    add_leaf(w, value);
  }
}

po_status po_json_digest(const json_t *document, char digest[PO_RESULT_DIGEST_LENGTH]) {
  if (!document)
    return PO_NO_MEMORY;
  writer w = {0};
  add_value(&w, document);
  char whole[PO_DIGEST_LENGTH];
  po_digest_bytes(po_text_string(&w.lines), w.lines.length, whole);
  memcpy(digest, whole, PO_RESULT_DIGEST_LENGTH - 1);
  digest[PO_RESULT_DIGEST_LENGTH - 1] = '\0';
  const po_status status = w.path.failed || w.lines.failed ? PO_NO_MEMORY : PO_OK;
  po_text_clear(&w.path);
  po_text_clear(&w.lines);
  return status;
}

void po_json_seal(json_t **document) {
  char digest[PO_RESULT_DIGEST_LENGTH];
  json_t *value = po_json_digest(*document, digest) ? NULL : po_json_text(digest);
  po_json_set(document, "digest", value);
}

/* The beginning of a document with a checksum, which follows; then what ends this member. */
static const struct {
  const char *begin, *end;
  size_t brace; /* length of the beginning of the document, which is the first part of `begin` */
} FORMS[] = {{"{\n  \"checksum\": \"", "\",\n", 2}, {"{\"checksum\":\"", "\",", 1}};
enum { FORM_COUNT = sizeof FORMS / sizeof *FORMS };

po_status po_json_print_checked(const json_t *document, bool line, po_text *text,
                                char digest[PO_DIGEST_LENGTH]) {
  const size_t brace = FORMS[line].brace;
  po_text plain = {0};
  po_status status = line ? po_json_print_line(document, &plain) : po_json_print(document, &plain);
  if (!status) {
    po_digest_bytes(plain.data, plain.length, digest);
    po_text_add(text, "%s%s%s", FORMS[line].begin, digest, FORMS[line].end);
    po_text_add_bytes(text, plain.data + brace, plain.length - brace);
    if (text->failed)
      status = po_fail(PO_NO_MEMORY, "out of memory while a JSON document was written");
  }
  po_text_clear(&plain);
  return status;
}

po_status po_json_parse_checked(const char *bytes, size_t size, json_t **document, bool *intact) {
  char stated[PO_DIGEST_LENGTH] = "", computed[PO_DIGEST_LENGTH];
  size_t brace = 0, rest = 0;
  for (size_t k = 0; k < FORM_COUNT && !rest; ++k) {
    const size_t begin = strlen(FORMS[k].begin);
    const size_t length = begin + PO_DIGEST_LENGTH - 1 + strlen(FORMS[k].end);
    if (size <= length || memcmp(bytes, FORMS[k].begin, begin) != 0)
      continue;
    memcpy(stated, bytes + begin, PO_DIGEST_LENGTH - 1);
    brace = FORMS[k].brace;
    rest = length;
  }
  po_digest_two(bytes, brace, bytes + rest, size - rest, computed);
  *intact = po_digest_agrees(stated, computed);
  return po_json_parse(bytes, size, document);
}
