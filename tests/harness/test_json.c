/* A JSON document is printed and read completely, or not at all. */
#include <check.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "po_json_value.h"
#include "po_quote.h"
#include "po_status.h"
#include "run.h"

/* The allocations that the program makes for jansson, which the linker brings here; the one
 * numbered `failing` from 1 finds no memory. */
static size_t allocations, failing;

void *__real_malloc(size_t size);
void *__wrap_malloc(size_t size);
void *__wrap_malloc(size_t size) {
  if (++allocations != failing)
    return __real_malloc(size);
  errno = ENOMEM;
  return NULL;
}

static void begin(size_t number) {
  allocations = 0;
  failing = number;
}

/* Returned: the number of allocations so far; later ones do not fail. */
static size_t end(void) {
  failing = 0;
  return allocations;
}

static json_t *make_document(void) {
  json_t *list = po_json_empty_array();
  po_json_append(&list, po_json_number(2.385));
  po_json_append(&list,
                 PO_JSON_OBJECT({"inner", po_json_number(NAN)}, {"outer", po_json_count(7)}));
  json_t *more = PO_JSON_OBJECT({"note", po_json_text("Bl\xE4tter")}, {"name", po_json_text("x")});
  json_t *document = PO_JSON_OBJECT({"name", po_json_text("caf\xC3\xA9")}, {"list", list},
                                    {"flag", json_boolean(true)}, {"nothing", po_json_text(NULL)});
  po_json_set(&document, "count", po_json_count(3));
  po_json_set_all(&document, more);
  return document;
}

static const char EXPECTED[] =
    "{\"name\":\"caf\xC3\xA9\",\"list\":[2.3849999999999998,{\"inner\":null,\"outer\":7}],"
    "\"flag\":true,\"nothing\":null,\"count\":3,\"note\":\"Bl\xEF\xBF\xBDtter\"}\n";

/* Prints the document while allocation number k fails. */
static po_status print_document(size_t k, po_text *text, size_t *total) {
  begin(k);
  json_t *document = make_document();
  const po_status status = po_json_print_line(document, text);
  json_decref(document);
  *total = end();
  return status;
}

/* Regression: a document without one of its members, for lack of memory, was printed as complete.
 */
TEST(document_is_whole_or_none) {
  json_t *document = NULL;
  po_text text = {0};
  size_t total = 0;
  ck_assert_int_eq(po_json_parse("[]", 2, &document), PO_OK); /* sets the allocations of jansson */
  json_decref(document);
  ck_assert_int_eq(print_document(0, &text, &total), PO_OK);
  ck_assert_str_eq(po_text_string(&text), EXPECTED);
  ck_assert_uint_gt(total, 20);
  po_text_clear(&text);
  for (size_t k = 1; k <= total; ++k) {
    size_t made;
    po_message_clear();
    const po_status status = print_document(k, &text, &made);
    if (status)
      ck_assert_msg(status == PO_NO_MEMORY && strstr(po_message(), "memory"), "allocation %zu", k);
    else
      ck_assert_msg(strcmp(po_text_string(&text), EXPECTED) == 0, "allocation %zu: %s", k,
                    po_text_string(&text));
    po_text_clear(&text);
  }
}

TEST(reading_tells_damage_from_lack_of_memory) {
  json_t *document = NULL;
  ck_assert_int_eq(po_json_parse("[]", 2, &document), PO_OK);
  json_decref(document);
  begin(0);
  po_json_parse(EXPECTED, strlen(EXPECTED), &document);
  const size_t total = end();
  ck_assert_uint_gt(total, 20);
  json_decref(document);
  for (size_t k = 1; k <= total; ++k) {
    begin(k);
    const po_status status = po_json_parse(EXPECTED, strlen(EXPECTED), &document);
    end();
    ck_assert_msg(status == PO_NO_MEMORY && !document, "allocation %zu: %s", k,
                  po_status_name(status));
  }
  for (size_t cut = 0; cut + 2 < strlen(EXPECTED); ++cut) {
    ck_assert_int_eq(po_json_parse(EXPECTED, cut, &document), PO_CANNOT_READ);
    ck_assert_ptr_null(document);
  }
}

/* Names of files are bytes, and texts may be truncated inside a character. Regression: both were
 * reported as lack of memory. */
static const struct {
  const char *text, *repaired;
} TEXTS[] = {
    {"", ""},
    {"plain", "plain"},
    {"\xC3\xBC\xE2\x82\xAC\xF0\x9F\x98\x80", "\xC3\xBC\xE2\x82\xAC\xF0\x9F\x98\x80"},
    {"lat\xE4in", "lat\xEF\xBF\xBDin"},
    {"cut \xC3", "cut "},
    {"cut \xF0\x9F\x98", "cut "},
    {"\xC3\xC3\xBC", "\xEF\xBF\xBD\xC3\xBC"},
    {"overlong \xC0\xAF", "overlong \xEF\xBF\xBD\xEF\xBF\xBD"},
    {"surrogate \xED\xA0\x80.", "surrogate \xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD."},
    {"\xF4\x8F\xBF\xBF\xF4\x90\x80\x80",
     "\xF4\x8F\xBF\xBF\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD"},
    {"\x80\xFF", "\xEF\xBF\xBD\xEF\xBF\xBD"},
};

TABLE_TEST(text_becomes_utf8, TEXTS) {
  const char *text = TEXTS[_i].text, *repaired = TEXTS[_i].repaired;
  char *copy = po_quote_utf8(text);
  ck_assert_ptr_nonnull(copy);
  ck_assert_str_eq(copy, repaired);
  json_t *value = po_json_text(text);
  ck_assert_str_eq(json_string_value(value), repaired);
  json_decref(value);
  free(copy);
}
