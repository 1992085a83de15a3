/* The forms in which instruments and other programs write tables. */
#ifndef PO_CSV_FORM_H
#define PO_CSV_FORM_H

#include "po_status.h"
#include "po_text.h"

/* Splits a line into cells, of which it stores at most `most`. Given: the separator; ' ': any
 * number of blanks. Cells are without the blanks around them; in a quoted cell the separator is
 * text, and two quotes are one. Returned: the number of cells, 0 if a quote is not closed or text
 * follows it. */
size_t po_csv_split(char *line, char separator, char **cells, size_t most);

/* Rewrites a table as po_csv.h describes it: UTF-8, lines that end in LF, names of columns first,
 * commas between the cells, decimal points. Each line stays a line. Read are: UTF-16 with a byte
 * order mark and Latin-1 (po_encoding.h); CR as the end of lines; no newline after the last line;
 * semicolons, tabs or blanks between the cells; decimal commas; empty cells after the last;
 * no-break spaces around cells; comments between the rows, if columns are wanted; a first column
 * without a name, which is then named index; lines of text before the names; names behind a #; a
 * line of units below the names, which is added to them. Given: `name` of the file in messages;
 * `wanted`, words with which names of columns begin, ended by NULL, that the line of names must
 * have: lines before it are then left out; NULL: the line of names is the first line of words above
 * a row that has as many cells, and text before it becomes header lines. If there is none, the
 * table begins with the first two rows of as many numbers, and has no line of names. Returned:
 * separator, that of the given text. Status: PO_CANNOT_READ (UTF-32; both decimal commas and
 * points; commas that may separate thousands), PO_NO_MEMORY. */
po_status po_csv_make_plain(const char *name, const char *const *wanted, po_text *text,
                            char *separator);

#endif
