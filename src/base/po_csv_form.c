#include "po_csv_form.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "po_encoding.h"
#include "po_memory.h"
#include "po_number.h"
#include "po_quote.h"

static const char BLANKS[] = " \t";
static const char SEPARATORS[] = ",;\t ";

/* More columns are not looked at for the form of a table. */
enum { MOST_CELLS = 4096 };

typedef struct {
  char *at;
  size_t length;
} span;

typedef struct {
  const char *name;          /* of the file */
  const char *const *wanted; /* see po_csv_make_plain */
  span *lines;
  size_t count;
  size_t names; /* the line of names, or the first row if none has a name */
  size_t units; /* the line of units below the names; 0: there is none */
  bool is_nameless;
  char separator;
  bool decimal_comma;
  size_t columns;
  char *scratch, *cells[MOST_CELLS]; /* those of the line that was split last */
} form;

static size_t blanks_at(const char *text, char separator) {
  return strspn(text, separator == '\t' ? " " : BLANKS);
}

/* Cuts the first cell off a line. Returned: the cell, NULL if it is malformed; *rest, what follows
 * the separator, NULL after the last cell. */
static char *cut_cell(char **rest, char separator) {
  char *from = *rest + blanks_at(*rest, separator), *cell = from, *to = from;
  const bool quoted = *from == '"';
  if (quoted) {
    for (++from; *from && (*from != '"' || from[1] == '"'); ++from) {
      from += *from == '"';
      *to++ = *from;
    }
    if (*from++ != '"')
      return NULL;
  }
  char *stop = separator == ' ' ? strpbrk(from, BLANKS) : strchr(from, separator);
  *rest = stop ? stop + 1 : NULL;
  if (stop)
    *stop = '\0';
  if (separator == ' ' && stop && !(*rest)[strspn(*rest, BLANKS)])
    *rest = NULL; /* blanks at the end */
  size_t length = strlen(from);
  while (length > 0 && (from[length - 1] == ' ' || from[length - 1] == '\t'))
    --length;
  from[length] = '\0';
  if (quoted && *from)
    return NULL;
  if (quoted)
    *to = '\0';
  return cell;
}

size_t po_csv_split(char *line, char separator, char **cells, size_t most) {
  size_t count = 0;
  for (char *rest = line; rest; ++count) {
    char *cell = cut_cell(&rest, separator);
    if (!cell)
      return 0;
    if (count < most)
      cells[count] = cell;
  }
  return count;
}

/* -- Lines -- */

static po_status find_lines(po_text *text, form *f) {
  size_t longest = 0, count = 0;
  for (const char *c = text->data; (c = strchr(c, '\n')); ++c)
    ++count;
  f->lines = po_allocate(count + 1, sizeof *f->lines);
  if (!f->lines)
    return PO_NO_MEMORY;
  for (char *at = text->data + po_quote_mark(text->data), *stop; (stop = strchr(at, '\n'));
       at = stop + 1) {
    size_t length = (size_t)(stop - at);
    while (length && at[length - 1] == '\r')
      --length;
    longest = length > longest ? length : longest;
    f->lines[f->count++] = (span){at, length};
  }
  f->scratch = po_allocate(longest + 1, 1);
  return f->scratch ? PO_OK : PO_NO_MEMORY;
}

/* -- Names, separator, decimal mark -- */

static bool is_blank(const span *line) {
  return strspn(line->at, " \t\r") >= line->length;
}

static bool is_comment(const span *line) {
  return line->length && *line->at == '#';
}

/* Splits a line, without the # before names, into cells. Returned: their number; 0: malformed, or
 * too many. */
static size_t split(form *f, size_t k, char separator) {
  const span *line = &f->lines[k];
  const size_t skip = is_comment(line);
  memcpy(f->scratch, line->at + skip, line->length - skip);
  f->scratch[line->length - skip] = '\0';
  for (char *c = f->scratch; *c; ++c)
    if ((unsigned char)*c >= 0x80)
      memset(c, ' ', po_encoding_blank(c));
  const size_t count = po_csv_split(f->scratch, separator, f->cells, MOST_CELLS);
  return count <= MOST_CELLS ? count : 0;
}

/* Writes the number in a cell with a point and an ASCII minus. Given: mark, the decimal mark.
 * Returned: whether it is one with this mark. */
static bool write_number(const char *cell, char mark, char *number, size_t size) {
  static const char MINUS[] = "\xE2\x88\x92"; /* U+2212 */
  size_t used = 0;
  bool marked = false;
  for (const char *c = cell; *c && used + 1 < size; ++c) {
    const bool minus = strncmp(c, MINUS, strlen(MINUS)) == 0;
    if (*c == (mark == '.' ? ',' : '.'))
      return false;
    marked = marked || *c == mark;
    number[used++] = minus ? '-' : *c == mark ? '.' : *c;
    c += minus ? strlen(MINUS) - 1 : 0;
  }
  number[used] = '\0';
  double value = 0;
  return used + 1 < size && marked && po_number_parse(number, &value);
}

static bool is_number(const char *cell, char mark) {
  char number[PO_NUMBER_LONGEST];
  double value = 0;
  return po_number_parse(cell, &value) || write_number(cell, mark, number, sizeof number);
}

static bool begins_with(const char *name, const char *word) {
  const size_t length = strlen(word);
  return strncmp(name, word, length) == 0 && strchr("_ ([/", name[length]);
}

/* Returned: the number of the cells that were split last, without empty ones beyond the `least`
 * first, as separators at the end of a line make them. */
static size_t without_end(const form *f, size_t count, size_t least) {
  while (count > least && !*f->cells[count - 1])
    --count;
  return count;
}

/* Whether the cells that were split last are names of columns. */
static bool are_names(const form *f, size_t count, bool wanted) {
  for (size_t i = 0; i < count; ++i)
    if (is_number(f->cells[i], ',') || (!wanted && !*f->cells[i] && i > 0))
      return false;
  for (const char *const *word = wanted ? f->wanted : NULL; word && *word; ++word) {
    size_t i = 0;
    while (i < count && !begins_with(f->cells[i], *word))
      ++i;
    if (i == count)
      return false;
  }
  return count > 1;
}

/* Whether a line is a row of so many cells, one of which is a number. */
static bool is_row(form *f, size_t k, char separator, size_t columns) {
  const size_t count = split(f, k, separator);
  bool number = false;
  for (size_t i = 0; i < count; ++i)
    number = number || is_number(f->cells[i], '.') || is_number(f->cells[i], ',');
  return number && without_end(f, count, columns) == columns;
}

static bool is_unit(const char *cell) {
  static const char *const UNITS[] = {"m",  "mm", "um", "\u00B5m", "\u03BCm", "nm", "pm",
                                      "N",  "mN", "uN", "\u00B5N", "\u03BCN", "nN", "pN",
                                      "Pa", "s",  "ms", "V",       "mV"};
  const size_t length = strlen(cell);
  const bool brackets = length > 2 && ((*cell == '[' && cell[length - 1] == ']') ||
                                       (*cell == '(' && cell[length - 1] == ')'));
  for (size_t u = 0; !brackets && u < sizeof UNITS / sizeof *UNITS; ++u)
    if (strcmp(cell, UNITS[u]) == 0)
      return true;
  return brackets;
}

/* Whether a line is one of so many units. */
static bool are_units(form *f, size_t k, char separator, size_t columns) {
  const size_t count = without_end(f, split(f, k, separator), columns);
  for (size_t i = 0; i < count; ++i)
    if (!is_unit(f->cells[i]))
      return false;
  return count == columns;
}

/* Returned: the first line from k on that is neither blank nor a comment; count: there is none. */
static size_t next_line(const form *f, size_t k) {
  while (k < f->count && (is_blank(&f->lines[k]) || is_comment(&f->lines[k])))
    ++k;
  return k;
}

/* Whether so many cells stand in the line `next`, that of units or of a row. Returned: units, the
 * line of units, 0 if there is none. */
static bool are_columns(form *f, size_t next, char separator, size_t columns, size_t *units) {
  *units = are_units(f, next, separator, columns) ? next : 0;
  if (*units)
    next = next_line(f, next + 1);
  return next < f->count && is_row(f, next, separator, columns);
}

/* Finds the line of names. Given: wanted, whether it has these names; row, whether a row follows.
 */
static bool find_names(form *f, bool wanted, bool row) {
  size_t next = 0;
  for (size_t k = 0; k < f->count; ++k) {
    next = next > k ? next : next_line(f, k + 1);
    if (row && next == f->count)
      return false;
    if (!row && is_comment(&f->lines[k]))
      continue;
    for (const char *separator = SEPARATORS; *separator; ++separator) {
      const size_t count = without_end(f, split(f, k, *separator), 2);
      if (!are_names(f, count, wanted))
        continue;
      if (row && !are_columns(f, next, *separator, count, &f->units))
        continue;
      f->names = k;
      f->separator = *separator;
      f->columns = count;
      return true;
    }
  }
  return false;
}

/* Whether the cells that were split last are numbers. */
static bool are_numbers(const form *f, size_t count) {
  for (size_t i = 0; i < count; ++i)
    if (!is_number(f->cells[i], '.') && !is_number(f->cells[i], ','))
      return false;
  return count > 1;
}

/* Finds the first row of a table without names: two lines of as many numbers. */
static bool find_rows(form *f) {
  f->units = 0; /* a line of units that was seen has no rows */
  for (size_t k = next_line(f, 0), next = 0; k < f->count; k = next) {
    next = next_line(f, k + 1);
    for (const char *separator = ";\t ,"; *separator && next < f->count; ++separator) {
      const size_t count = without_end(f, split(f, k, *separator), 2);
      if (!are_numbers(f, count) || !is_row(f, next, *separator, count))
        continue;
      f->names = k;
      f->is_nameless = true;
      f->separator = *separator;
      f->columns = count;
      return true;
    }
  }
  return false;
}

/* Whether a number with a comma may be one with separated thousands: 1,234. */
static bool may_be_thousands(const char *cell) {
  cell += strspn(cell, "+-");
  const size_t whole = strspn(cell, "0123456789");
  return whole >= 1 && whole <= 3 && *cell != '0' && strlen(cell) == whole + 4 &&
         strspn(cell + whole + 1, "0123456789") == 3;
}

static po_status find_decimal_mark(form *f) {
  char number[PO_NUMBER_LONGEST],
      shown[2][64] = {"", ""}; /* the first with a point, with a comma */
  size_t line[2] = {0};
  bool proven = false;
  for (size_t k = f->names + !f->is_nameless; k < f->count; ++k) {
    const size_t count = is_comment(&f->lines[k]) ? 0 : split(f, k, f->separator);
    for (size_t i = 0; i < count; ++i)
      for (int comma = 0; comma < 2; ++comma) {
        if (!write_number(f->cells[i], comma ? ',' : '.', number, sizeof number))
          continue;
        proven = proven || (comma && !may_be_thousands(f->cells[i]));
        if (!line[comma])
          po_quote_text(f->cells[i], shown[comma], sizeof shown[comma]);
        line[comma] = line[comma] ? line[comma] : k + 1;
      }
  }
  f->decimal_comma = line[1];
  if (line[0] && line[1])
    return po_fail(PO_CANNOT_READ,
                   "%s:%zu: %s has a decimal comma, and %s on line %zu a decimal point: expected "
                   "the same in all rows",
                   f->name, line[1], shown[1], shown[0], line[0]);
  if (line[1] && !proven)
    return po_fail(PO_CANNOT_READ,
                   "%s:%zu: %s has a decimal comma or a comma between thousands, and no other "
                   "number shows which: expected decimal points",
                   f->name, line[1], shown[1]);
  return PO_OK;
}

/* -- Writing -- */

/* In quotes where the reader would take it for something else: a first cell with # for a comment.
 */
static void add_cell(po_text *text, const char *cell, bool first) {
  const size_t length = strlen(cell);
  po_text_add(text, first ? "" : ",");
  if (length && !(first && *cell == '#') && !strpbrk(cell, ",\"") && !strchr(BLANKS, cell[0]) &&
      !strchr(BLANKS, cell[length - 1])) {
    po_text_add_bytes(text, cell, length);
    return;
  }
  po_text_add(text, "\"");
  for (const char *c = cell; *c; ++c)
    po_text_add(text, *c == '"' ? "\"\"" : "%c", *c);
  po_text_add(text, "\"");
}

/* A wanted name with its unit, r (µm), r [um], r/um, becomes r_um. */
static void write_name(const form *f, const char *cell, char *name, size_t size) {
  size_t stem = 0, used = 0;
  for (const char *const *word = f->wanted; word && *word; ++word)
    if (begins_with(cell, *word))
      stem = strlen(*word);
  for (const char *c = cell; *c && used + 2 < size; ++c) {
    const bool micro = strncmp(c, "\u00B5", 2) == 0 || strncmp(c, "\u03BC", 2) == 0;
    if (stem && (size_t)(c - cell) >= stem && strchr("_ ()[]/", *c))
      continue;
    if (stem && (size_t)(c - cell) >= stem && used == stem)
      name[used++] = '_';
    name[used++] = micro && stem ? 'u' : *c;
    c += micro && stem;
  }
  name[used] = '\0';
}

/* Adds the name of column i, with its unit, if it has one. */
static void add_name(const form *f, size_t i, const char *cell, const char *unit, po_text *text) {
  char name[200];
  po_text whole = {0};
  po_text_add(&whole, unit && strchr("[(", *unit) ? "%s %s" : unit ? "%s (%s)" : "%s", cell, unit);
  write_name(f, po_text_string(&whole), name, sizeof name);
  const bool fits = whole.length + 2 < sizeof name;
  add_cell(text, i == 0 && !*name ? "index" : fits ? name : po_text_string(&whole), i == 0);
  text->failed = text->failed || whole.failed;
  po_text_clear(&whole);
}

static void add_names(form *f, po_text *text) {
  po_text units = {0}; /* cells, each with its NUL */
  for (size_t i = 0, count = f->units ? split(f, f->units, f->separator) : 0; i < count; ++i)
    po_text_add_bytes(&units, f->cells[i], strlen(f->cells[i]) + 1);
  const char *unit = f->units && !units.failed ? units.data : NULL;
  const size_t count = split(f, f->names, f->separator);
  for (size_t i = 0; i < f->columns && i < count; ++i) {
    add_name(f, i, f->cells[i], unit, text);
    unit = unit ? unit + strlen(unit) + 1 : NULL;
  }
  text->failed = text->failed || units.failed;
  po_text_clear(&units);
}

/* Adds a row; one that is malformed stays as it is, and is refused by the reader. */
static void add_row(form *f, size_t k, po_text *text) {
  const size_t count = without_end(f, split(f, k, f->separator), f->columns);
  for (size_t i = 0; i < count; ++i) {
    char number[PO_NUMBER_LONGEST];
    const char mark = f->decimal_comma ? ',' : '.';
    const bool is = write_number(f->cells[i], mark, number, sizeof number);
    add_cell(text, is ? number : f->cells[i], i == 0);
  }
  if (!count)
    po_text_add_bytes(text, f->lines[k].at, f->lines[k].length);
}

/* Adds a line before the names. */
static void add_preamble(const form *f, size_t k, po_text *text) {
  const span *line = &f->lines[k];
  if (f->wanted || is_blank(line))
    return;
  if (!is_comment(line))
    po_text_add(text, "# line %zu: ", k + 1);
  po_text_add_bytes(text, line->at, line->length);
}

static void write(form *f, po_text *text) {
  const size_t names = f->units ? f->units : f->names;
  for (size_t k = 0; k < f->count; ++k) {
    const span *line = &f->lines[k];
    if (k == names && !f->is_nameless)
      add_names(f, text);
    else if (k < f->names)
      add_preamble(f, k, text);
    else if (k < names)
      ; /* the names, written with the units */
    else if (is_comment(line))
      po_text_add_bytes(text, line->at, f->wanted ? 1 : line->length);
    else if (!is_blank(line))
      add_row(f, k, text);
    po_text_add(text, "\n");
  }
}

po_status po_csv_make_plain(const char *name, const char *const *wanted, po_text *text,
                            char *separator) {
  po_status status = po_encoding_decode(name, text);
  form *f = status ? NULL : po_allocate(1, sizeof *f);
  if (!f)
    return status ? status : PO_NO_MEMORY;
  *f = (form){.name = name, .wanted = wanted, .separator = ','};
  status = find_lines(text, f);
  const bool found =
      !status && ((wanted && (find_names(f, true, true) || find_names(f, true, false))) ||
                  find_names(f, false, true) || (!wanted && find_rows(f)));
  if (found)
    status = find_decimal_mark(f);
  if (found && !status) {
    po_text plain = {0};
    write(f, &plain);
    po_text_clear(text);
    *text = plain;
    status = plain.failed ? PO_NO_MEMORY : PO_OK;
  }
  *separator = f->separator;
  free(f->lines);
  free(f->scratch);
  free(f);
  return status;
}
