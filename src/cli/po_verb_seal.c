#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "po_csv_form.h"
#include "po_file.h"
#include "po_options.h"
#include "po_quote.h"
#include "po_reference.h"
#include "po_text.h"
#include "po_verbs.h"

static const char HELP[] =
    "Usage: pulloff seal [OPTION]... FILE...\n"
    "Makes reference tables of CSV files: completes the header lines that every table must have,\n"
    "and writes the checksum. Use it only for a table whose numbers you have just checked: a "
    "table\n"
    "with a correct checksum counts as undamaged. A table with nan or text in a column of numbers\n"
    "is refused; one with semicolons, decimal commas or UTF-16 is written with commas and points.\n"
    "Options are needed for the headers that the files do not have; they replace "
    "those\n"
    "that they have. reference/README.md describes the headers.\n"
    "\n"
    "  --what TEXT         what the numbers are\n"
    "  --source TEXT       where they come from: a citation with the equation or figure\n"
    "  --kind KIND         oracle (exact, or many digits by an independent method) or published\n"
    "  --method TEXT       how they were computed or read off\n"
    "  --units TEXT        their units\n"
    "  --uncertainty U     a bound of their error: a number, or in words with columns\n"
    "                      NAME_uncertainty\n"
    "  --date DATE         when they were made (default: today)\n"
    "  --generator TEXT    the program that made them (default: by hand)\n"
    "  --command TEXT      the command that makes them again (default: pulloff seal FILE)\n"
    "  -h, --help          print this text\n"
    "\n"
    "Example: pulloff seal --what 'pull-off of my tip' --source 'Smith 2024, Fig. 3' \\\n"
    "           --kind published --method digitised --units 'pi w R' --uncertainty 0.01 tip.csv\n";

/* The headers that a reference table must have, except the checksum. */
enum { DATE = 6, GENERATOR, COMMAND, HEADERS };

/* The line is an array of the values of the headers, in the order of these rows. */
#define HEADER(header, number)                                                                     \
  {                                                                                                \
    .name = header, .kind = PO_OPTION_IS_TEXT, .place = (number) * sizeof(char *),                 \
    .expected = "a text"                                                                           \
  }
static const po_option OPTIONS[HEADERS + 1] = {
    HEADER("what", 0),         HEADER("source", 1),
    HEADER("kind", 2),         HEADER("method", 3),
    HEADER("units", 4),        HEADER("uncertainty", 5),
    HEADER("date", DATE),      HEADER("generator", GENERATOR),
    HEADER("command", COMMAND)};

/* Returned: the length of the key of a header line `# key: value`; 0 if the line is no header. */
static size_t key_of(const char *line, const char **key) {
  if (line[0] != '#')
    return 0;
  *key = line + 1 + strspn(line + 1, " ");
  const size_t length = strcspn(*key, ":");
  return (*key)[length] == ':' ? length : 0;
}

static int find_name(const char *key, size_t length) {
  for (int i = 0; i < HEADERS; ++i)
    if (strlen(OPTIONS[i].name) == length && strncmp(OPTIONS[i].name, key, length) == 0)
      return i;
  return -1;
}

/* Splits the lines of a file into headers, without those that are replaced and without the
 * checksum, and all others. Returned: in `had`, the headers that the file keeps. */
static void split(char *bytes, const char *const values[HEADERS], po_text *header, po_text *rows,
                  bool had[HEADERS]) {
  for (char *at = bytes; *at;) {
    const size_t length = strcspn(at, "\n");
    const char end = at[length];
    at[length] = '\0';
    const char *key = "";
    const size_t size = key_of(at, &key);
    const int name = find_name(key, size);
    const bool digest = size == strlen("sha256") && strncmp(key, "sha256", size) == 0;
    if (name >= 0 && !values[name])
      had[name] = true;
    if (!length || digest || (size && name >= 0 && values[name]))
      ; /* left out */
    else if (at[0] == '#')
      po_text_add(header, "%s\n", at);
    else
      po_text_add(rows, "%s\n", at);
    at += length + (end != '\0');
  }
}

static void today(char date[16]) {
  const time_t now = time(NULL);
  struct tm utc;
  gmtime_r(&now, &utc);
  strftime(date, 16, "%Y-%m-%d", &utc);
}

/* Names all headers that neither the file nor the user gives. */
static po_status refuse_missing(const char *path, const char *const values[HEADERS],
                                const bool had[HEADERS]) {
  po_text missing = {0};
  size_t count = 0;
  for (int i = 0; i < DATE; ++i)
    if (!values[i] && !had[i])
      po_text_add(&missing, "%s--%s", count++ ? ", " : "", OPTIONS[i].name);
  const po_status status =
      count ? po_fail(PO_BAD_INPUT, "%s lacks %zu %s: expected the %s %s", path, count,
                      po_one_or_more(count, "header", "headers"),
                      po_one_or_more(count, "option", "options"), po_text_string(&missing))
            : PO_OK;
  po_text_clear(&missing);
  return status;
}

static void add_headers(const char *path, const char *const values[HEADERS],
                        const bool had[HEADERS], po_text *header) {
  char date[16];
  today(date);
  for (int i = 0; i < HEADERS; ++i) {
    if (had[i])
      continue;
    po_text_add(header, "# %s: ", OPTIONS[i].name);
    if (values[i])
      po_text_add(header, "%s", values[i]);
    else if (i == COMMAND) {
      po_text_add(header, "pulloff seal ");
      po_text_add_word(header, path);
    } else
      po_text_add(header, "%s", i == DATE ? date : "by hand");
    po_text_add(header, "\n");
  }
}

/* Writes the table to a file beside it, reads that as a reference, and takes its place. */
static po_status replace_file(const char *path, const po_text *text) {
  po_file_path beside;
  po_reference reference = {0};
  snprintf(beside.text, sizeof beside.text, "%s.seal-%ld", path, (long)getpid());
  po_status status = po_file_write(beside.text, text->data, text->length);
  if (!status)
    status = po_reference_read(beside.text, path, &reference);
  if (!status)
    status = po_reference_check_cells(&reference);
  po_reference_close(&reference);
  unlink(beside.text);
  return status ? status : po_file_write(path, text->data, text->length);
}

/* Writes the table back with complete headers and its checksum. The file becomes a plain
 * table (po_csv_form.h). Given: `values`, for each header its text, or
 * NULL; a header that the file has is replaced if a text is given. generator, command and date have
 * defaults. Status: PO_BAD_INPUT if headers are missing, all of which the message names;
 * PO_CANNOT_READ (the file, or what makes it no table, with its line: also a cell that is no number
 * in a column of numbers); PO_CANNOT_WRITE; the file is then unchanged. */
static po_status seal_table(const char *path, const char *const values[HEADERS]) {
  char digest[PO_DIGEST_LENGTH], separator = 0;
  bool had[HEADERS] = {false};
  po_text found = {0}, header = {0}, rows = {0}, text = {0};
  for (int i = 0; i < HEADERS; ++i)
    if (values[i] && (strchr(values[i], '\n') || po_quote_find(values[i], strlen(values[i]))))
      return po_fail(PO_BAD_INPUT,
                     "--%s has several lines or a control character: expected one line",
                     OPTIONS[i].name);
  po_status status = po_file_read(path, &found.data, &found.length);
  found.capacity = found.length + 1;
  if (!status)
    status = po_csv_make_plain(path, NULL, &found, &separator);
  if (!status) {
    split(found.data, values, &header, &rows, had);
    status = refuse_missing(path, values, had);
  }
  if (!status) {
    add_headers(path, values, had, &header);
    po_csv_seal(&header, &rows, &text, digest);
    status = replace_file(path, &text);
  }
  po_text_clear(&found);
  po_text_clear(&header);
  po_text_clear(&rows);
  po_text_clear(&text);
  return status;
}

int po_verb_seal(int argc, char **argv) {
  const po_options options = {"seal", HELP, OPTIONS, argc, argv, PO_SEVERAL};
  const char *values[HEADERS] = {NULL};
  po_status status = PO_OK;
  if (!po_options_read(&options, values, &status))
    return po_options_end(status);
  if (optind == argc)
    status = po_fail(PO_BAD_INPUT, "seal needs the names of tables (see pulloff seal --help)");
  for (int i = optind; !status && i < argc; ++i) {
    status = seal_table(argv[i], values);
    if (!status)
      printf("%s is sealed\n", argv[i]);
  }
  return po_options_end(status);
}
