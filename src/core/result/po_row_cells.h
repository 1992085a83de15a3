/* The cells of rows of the structure S, for the files that define rows. The type of each member is
 * checked when they are compiled. */
#ifndef PO_ROW_CELLS_H
#define PO_ROW_CELLS_H

#include <stddef.h>

#include "po_rows.h"

#define NONE PO_DIMENSION_NONE
#define TIME PO_DIMENSION_TIME
#define LENGTH PO_DIMENSION_LENGTH
#define GAP PO_DIMENSION_GAP
#define LOAD PO_DIMENSION_LOAD
#define ENERGY PO_DIMENSION_ENERGY
#define STIFFNESS PO_DIMENSION_STIFFNESS
#define TRACTION PO_DIMENSION_TRACTION

// clang-format off
#define SIZE_OF(member) sizeof(((S *)0)->member)
#define AT(type, member) _Generic(((S *)0)->member, type : offsetof(S, member))
#define AT_COUNT(member) \
  _Generic(((S *)0)->member, unsigned : offsetof(S, member), unsigned long : offsetof(S, member), \
   unsigned long long : offsetof(S, member))
#define TEXTS(bound, absence, text) .error = bound, .null = absence, .says = text

/* A number: a member, one that documents do not have, one that another row has, too, or one that is
 * computed of a member or of several. */
#define NUMBER(name, member, of, bound, absence, text) \
  {.key = name, .type = PO_ROW_NUMBER, .dimension = of, .offset = AT(double, member), TEXTS(bound, absence, text)}
#define HIDDEN(name, member, of, text) \
  {.key = name, .type = PO_ROW_NUMBER, .dimension = of, .offset = AT(double, member), .hidden = true, TEXTS("", "", text)}
#define FORM(name, member, of, getter, setter, bound, absence, text) \
  {.key = name, .type = PO_ROW_NUMBER, .dimension = of, .offset = AT(double, member), .get = getter, .set = setter, \
   TEXTS(bound, absence, text)}
#define DERIVED(name, of, getter, bound, absence, text) \
  {.key = name, .type = PO_ROW_NUMBER, .dimension = of, .get = getter, .alias = true, TEXTS(bound, absence, text)}
#define COUNT(name, member, text) \
  {.key = name, .type = PO_ROW_COUNT, .offset = AT_COUNT(member), .size = SIZE_OF(member), TEXTS("", "", text)}
#define DERIVED_COUNT(name, getter, text) {.key = name, .type = PO_ROW_COUNT, .get = getter, TEXTS("", "", text)}
#define INTEGER(name, member, text) \
  {.key = name, .type = PO_ROW_INTEGER, .offset = AT(int, member), .size = sizeof(int), TEXTS("", "", text)}
#define OPTIONAL_INTEGER(name, member, flag, absence, text) \
  {.key = name, .type = PO_ROW_INTEGER, .offset = AT(int, member), .size = sizeof(int), .present = AT(bool, flag), \
   .omitted = true, TEXTS("", absence, text)}
#define FLAG(name, member, text) \
  {.key = name, .type = PO_ROW_FLAG, .offset = AT(bool, member), .size = sizeof(bool), TEXTS("", "", text)}
#define TEXT(name, member, text) \
  {.key = name, .type = PO_ROW_TEXT, .offset = offsetof(S, member), .size = SIZE_OF(member), TEXTS("", "", text)}
#define WORD(name, member, words, text) \
  {.key = name, .type = PO_ROW_WORD, .offset = offsetof(S, member), .size = SIZE_OF(member), .names = words, TEXTS("", "", \
   text)}
#define STATUS(name, member, text) \
  {.key = name, .type = PO_ROW_STATUS, .offset = AT(po_status, member), .size = SIZE_OF(member), TEXTS("", "", text)}
#define LABEL(name, one_or_two, function, text) {.key = name, .type = one_or_two, .label = function, TEXTS("", "", text)}

/* Parts: of a member, of several members (a group), which may be absent, and lists. */
#define PART(name, member, of, text) \
  {.key = name, .type = PO_ROW_PART, .offset = offsetof(S, member), .block = &of, TEXTS("", "", text)}
#define GROUP(name, of, text) {.key = name, .type = PO_ROW_PART, .block = &of, TEXTS("", "", text)}
#define OPTIONAL(name, member, flag, of, absence, text) \
  {.key = name, .type = PO_ROW_PART, .offset = offsetof(S, member), .present = AT(bool, flag), .block = &of, TEXTS("", \
   absence, text)}
#define OPTIONAL_GROUP(name, flag, of, absence, text) \
  {.key = name, .type = PO_ROW_PART, .present = AT(bool, flag), .block = &of, TEXTS("", absence, text)}
#define INLINE(member, of) {.key = "", .type = PO_ROW_INLINE, .offset = offsetof(S, member), .block = &of, TEXTS("", "", "")}
#define LIST(name, member, length, of, missing, absence, text) \
  {.key = name, .type = PO_ROW_LIST, .offset = offsetof(S, member), .count = AT(size_t, length), .block = &of, \
   .absent = missing, TEXTS("", absence, text)}
#define BLOCK(definition, rows, after) {definition, rows, sizeof rows / sizeof *rows, sizeof(S), after}
// clang-format on

#endif
