#include "po_uncertain_line.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_number.h"

static const char SIGN[] = "+-";

po_uncertain_line po_uncertain_line_begin(const po_options *options) {
  return (po_uncertain_line){.line = po_solve_line_begin(), .options = options};
}

void po_uncertain_line_clear(po_uncertain_line *u) {
  for (size_t k = 0; k < u->count; ++k)
    free(u->given[k].text);
  free(u->given);
  free(u->variation);
  free(u->moved);
}

static void name_of(const po_uncertain_line *u, int option, char name[40]) {
  struct option table[PO_MOST_OPTIONS];
  const struct option *row = table;
  po_options_table(u->options, table);
  while (row->name && row->val != option)
    ++row;
  snprintf(name, 40, "%s", row->name ? row->name : "");
}

/* Whether a number may be uncertain: one of the scene, in SI units or not, or of the preload. */
static bool may_vary(int option) {
  const int key = option - PO_OPTION_KEYS;
  if (key < 0)
    return false;
  const po_key target = po_key_target((po_key)key);
  return po_key_is_continuous(key) || key == PO_KEY_TABLE_SCALE || target == PO_KEY_PRELOAD ||
         target == PO_KEY_PRELOAD_LOAD;
}

static po_status read_uncertain(const po_uncertain_line *u, po_given_option *given) {
  char *sign = strstr(given->text, SIGN), name[40];
  const char *deviation = sign + strlen(SIGN);
  *sign = '\0';
  if (may_vary(given->option) && po_number_parse(given->text, &given->value) &&
      po_number_parse(deviation, &given->deviation) && given->deviation > 0.0)
    return PO_OK;
  *sign = *SIGN;
  name_of(u, given->option, name);
  return po_options_refuse(name, given->text,
                           may_vary(given->option)
                               ? "a number, or with +- a number and its uncertainty > 0"
                               : "a value without uncertainty");
}

po_status po_uncertain_line_take(void *to, int option) {
  po_uncertain_line *u = to;
  po_given_option *given = po_grow(u->given, u->count, &u->room, sizeof *given);
  if (!given)
    return PO_NO_MEMORY;
  u->given = given;
  given += u->count++;
  *given = (po_given_option){.option = option, .text = optarg ? po_copy_text(optarg) : NULL};
  if (optarg && !given->text)
    return PO_NO_MEMORY;
  if (given->text && strstr(given->text, SIGN)) {
    const po_status status = read_uncertain(u, given);
    if (status)
      return status;
  }
  optarg = given->text;
  return po_solve_line_take(&u->line, option);
}

/* Reads the line again, with one number moved. */
static po_status read_moved(const po_uncertain_line *u, const po_given_option *which, double by,
                            po_solve_line *moved) {
  char text[PO_NUMBER_LENGTH];
  po_status status = PO_OK;
  *moved = po_solve_line_begin();
  moved->warned = true;
  po_number_print(which->value + by, text);
  for (size_t k = 0; k < u->count && !status; ++k) {
    optarg = &u->given[k] == which ? text : u->given[k].text;
    status = po_solve_line_take(moved, u->given[k].option);
  }
  return status ? status : po_solve_line_end(moved);
}

static po_status vary(po_uncertain_line *u, const po_given_option *given, size_t number) {
  po_variation *v = &u->variation[number];
  po_status status = PO_OK;
  *v = (po_variation){.value = given->value, .deviation = given->deviation};
  name_of(u, given->option, v->source);
  for (int more = 0; more < 2 && !status; ++more) {
    po_solve_line *moved = &u->moved[2 * number + (size_t)more];
    const double by = PO_VARIATION_REACH * given->deviation;
    status = read_moved(u, given, more ? by : -by, moved);
    if (status == PO_BAD_INPUT)
      status =
          po_fail(status, "--%s is %s+-%g, and moved by twice its uncertainty it is refused: %s",
                  v->source, given->text, given->deviation, po_message());
    v->moved[more] = &moved->request;
    v->unit[more] =
        moved->request.in_si ? moved->request.units.force / u->line.request.units.force : 1.0;
  }
  return status;
}

po_status po_uncertain_line_end(po_uncertain_line *u) {
  po_status status = po_solve_line_end(&u->line);
  u->variation = po_allocate(u->count, sizeof *u->variation);
  u->moved = po_allocate(2 * u->count, sizeof *u->moved);
  if (!u->variation || !u->moved)
    return PO_NO_MEMORY;
  size_t number = 0;
  for (size_t k = 0; k < u->count && !status; ++k)
    if (u->given[k].deviation > 0.0)
      status = vary(u, &u->given[k], number++);
  u->line.request.variation = u->variation;
  u->line.request.variations = number;
  return status;
}
