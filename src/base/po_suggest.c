#include "po_suggest.h"

#include <ctype.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "po_number.h"

/* Longer words are not compared. */
enum { LONGEST = 32 };

static const char ENDS_PART[] = ",:=", ENDS_KNOWN[] = " ,:;";

static char folded(char c) {
  return c == '_' ? '-' : (char)tolower((unsigned char)c);
}

static size_t least(size_t a, size_t b) {
  return a < b ? a : b;
}

/* The least number of letters to insert, leave out, replace or exchange with the next one (optimal
 * string alignment: Damerau 1964 in the form in which no letter is changed twice). */
static size_t edits(const char *a, size_t m, const char *b, size_t n) {
  size_t rows[3][LONGEST + 1];
  size_t *two_before = rows[0], *before = rows[1], *row = rows[2];
  for (size_t j = 0; j <= n; ++j)
    row[j] = j;
  for (size_t i = 1; i <= m; ++i) {
    size_t *oldest = two_before;
    two_before = before;
    before = row;
    row = oldest;
    row[0] = i;
    for (size_t j = 1; j <= n; ++j) {
      const char x = folded(a[i - 1]), y = folded(b[j - 1]);
      row[j] = least(least(before[j], row[j - 1]) + 1, before[j - 1] + (x != y));
      if (i > 1 && j > 1 && x == folded(b[j - 2]) && folded(a[i - 2]) == y)
        row[j] = least(row[j], two_before[j - 2] + 1);
    }
  }
  return row[n];
}

/* How far a given word is from a known one: the edits, or one letter if it is the beginning. */
static size_t distance(const char *given, size_t length, const char *known, size_t other) {
  if (length >= 3 && length < other && edits(given, length, known, length) == 0)
    return 1;
  return edits(given, length, known, other);
}

/* Finds the known word nearest to a given one. Returned: whether one is close; if it is the word
 * itself, *size is 0. */
static bool find(const char *given, size_t length, const char *known, const char **name,
                 size_t *size) {
  size_t nearest = length < 3 ? 0 : (length + 5) / 4; /* one slip, of long words more */
  bool found = false;
  for (size_t n; *known; known += n) {
    known += strspn(known, ENDS_KNOWN);
    n = strcspn(known, ENDS_KNOWN);
    const size_t dashes = strspn(known, "-"), letters = n - dashes;
    if (letters == length && strncmp(given, known + dashes, length) == 0) {
      *size = 0;
      return true;
    }
    const size_t off = letters < 3 || letters > LONGEST
                           ? LONGEST
                           : distance(given, length, known + dashes, letters);
    if (off < nearest || (found && off == nearest && n < *size)) {
      nearest = off;
      *name = known;
      *size = n;
      found = true;
    }
    if (known[n] == ':')
      n += strcspn(known + n, " ;"); /* mie:m,n is one word */
  }
  return found;
}

po_status po_suggest(po_status status, const char *given, const char *known) {
  const char *number = strstr(known, "number");
  const bool pair = strstr(po_message(), "two with a comma"); /* a comma is no slip then */
  if (number && number[strlen("number")] != 's' && !pair && *po_number_fault(given))
    return po_fail(status, "%s%s", po_message(), po_number_fault(given));
  given += strspn(given, "-");
  for (size_t length; *given; given += length + (given[length] == ',')) {
    const char *name = NULL;
    size_t size = 0;
    length = strcspn(given, ",");
    const size_t word = least(length, strcspn(given, ENDS_PART));
    if (word > LONGEST || !isalpha((unsigned char)*given) ||
        !find(given, word, known, &name, &size))
      return status;
    if (size && (name != known || known[size])) /* not if it is the only one */
      return po_fail(status, "%s; did you mean %.*s?", po_message(), (int)size, name);
  }
  return status;
}
