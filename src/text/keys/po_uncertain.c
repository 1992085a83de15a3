#include "po_uncertain.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_memory.h"
#include "po_number.h"
#include "po_quote.h"

static const char SIGN[] = "+-";

bool po_uncertain_may(int key) {
  if (key < 0 || key >= PO_KEY_ALL)
    return false;
  const po_key target = po_key_target((po_key)key);
  return po_key_is_continuous((po_key)key) || po_key_is_list((po_key)key) ||
         key == PO_KEY_TABLE_SCALE || key == PO_KEY_RELAXATION_TIME_S || target == PO_KEY_PRELOAD ||
         target == PO_KEY_PRELOAD_LOAD;
}

static po_status refuse_value(po_texts *given, int key, const char *text) {
  char name[PO_KEY_NAME_LENGTH], shown[PO_QUOTE_LENGTH];
  given->wrong = key;
  po_texts_write_name(given, key, name);
  return po_fail(PO_BAD_INPUT, "%s is %s: expected %s", name, po_quote(text, shown),
                 po_uncertain_may(key) ? "a number, or with +- a number and its uncertainty > 0"
                                       : "a value without uncertainty");
}

/* Reads one number with its uncertainty, which ends at `end`, and cuts the latter off. Returned:
 * false if it is none. */
static bool cut_uncertainty(char *number, char *end, po_uncertain_number *read) {
  char *sign = strstr(number, SIGN), after = *end;
  *sign = *end = '\0';
  const bool valid = po_number_parse(number, &read->value) &&
                     po_number_parse(sign + strlen(SIGN), &read->deviation) &&
                     read->deviation > 0.0;
  *sign = *SIGN;
  *end = after;
  if (valid)
    memmove(sign, end, strlen(end) + 1);
  return valid;
}

/* Reads the uncertain numbers of one text, several of a list. */
static po_status read_text(po_texts *given, int key, po_uncertain_inputs *u) {
  const char *whole = given->text[key];
  char *number = u->text[key] = po_copy_text(whole);
  if (!number)
    return PO_NO_MEMORY;
  for (int body = 0; number; ++body) {
    char *comma = po_key_is_list((po_key)key) ? strchr(number, ',') : NULL;
    const char *sign = strstr(number, SIGN);
    if (sign && (!comma || sign < comma)) {
      po_uncertain_number *grown = po_grow(u->number, u->count, &u->room, sizeof *grown);
      if (!grown)
        return PO_NO_MEMORY;
      u->number = grown;
      grown[u->count] = (po_uncertain_number){.key = key, .body = body};
      if (!cut_uncertainty(number, comma ? comma : number + strlen(number), &grown[u->count]))
        return refuse_value(given, key, whole);
      u->count += 1;
      comma = po_key_is_list((po_key)key) ? strchr(number, ',') : NULL;
    }
    number = comma ? comma + 1 : NULL;
  }
  given->text[key] = u->text[key];
  return PO_OK;
}

po_status po_uncertain_read(po_texts *given, po_uncertain_inputs *u) {
  *u = (po_uncertain_inputs){0};
  po_status status = PO_OK;
  for (int key = 0; key < PO_KEY_ALL && !status; ++key)
    if (given->text[key] && key != PO_KEY_PROFILE_FILE && key != PO_KEY_VISCOELASTIC &&
        strstr(given->text[key], SIGN))
      status = po_uncertain_may(key) ? read_text(given, key, u)
                                     : refuse_value(given, key, given->text[key]);
  return status;
}

/* Where number `index` of a text begins; of one that is no list the text. */
static const char *number_at(po_key key, const char *text, int index) {
  for (; index && po_key_is_list(key); --index)
    text += strcspn(text, ",") + 1;
  return text;
}

/* Makes the request of the texts with one number moved. */
static po_status move_input(const po_texts *given, const po_uncertain_number *number, double by,
                            po_uncertain_maker *maker, const void *user, po_request *request) {
  po_texts moved = *given;
  const char *whole = given->text[number->key];
  const char *place = number_at((po_key)number->key, whole, number->body);
  char text[(PO_KEY_LIST_MOST + 1) * PO_NUMBER_LENGTH], value[PO_NUMBER_LENGTH];
  po_number_print(number->value + by, value);
  snprintf(text, sizeof text, "%.*s%s%s", (int)(place - whole), whole, value,
           po_key_is_list((po_key)number->key) ? place + strcspn(place, ",") : "");
  moved.text[number->key] = text;
  return maker(&moved, user, request);
}

/* Which number of a list an input is. */
static const char *part_of(const po_uncertain_number *number, const char *text) {
  static const char *const PARTS[] = {" of body 1", " of body 2", " of the interface"};
  return po_key_is_list((po_key)number->key) && strchr(text, ',') ? PARTS[number->body] : "";
}

static po_status vary(po_uncertain_inputs *u, size_t k, const po_texts *given,
                      po_uncertain_maker *maker, const void *user, const po_request *request) {
  const po_uncertain_number *number = &u->number[k];
  const char *text = given->text[number->key];
  po_variation *v = &u->variation[k];
  char name[PO_KEY_NAME_LENGTH];
  po_status status = PO_OK;
  *v = (po_variation){.value = number->value, .deviation = number->deviation};
  po_texts_write_name(given, number->key, name);
  /* the name of the key, not that of the option: documents are those of the library and of cases */
  snprintf(v->source, sizeof v->source, "%.28s%s", PO_KEYS[number->key].name,
           part_of(number, text));
  for (int more = 0; more < 2 && !status; ++more) {
    po_request *moved = &u->moved[2 * k + (size_t)more];
    const double by = PO_VARIATION_REACH * number->deviation;
    status = move_input(given, number, more ? by : -by, maker, user, moved);
    if (status == PO_BAD_INPUT)
      status = po_fail(status, "%s is %s+-%g, and moved by twice its uncertainty it is refused: %s",
                       name, text, number->deviation, po_message());
    v->moved[more] = moved;
    v->unit[more] = moved->in_si ? moved->units.force / request->units.force : 1.0;
  }
  return status;
}

po_status po_uncertain_vary(po_uncertain_inputs *u, const po_texts *given,
                            po_uncertain_maker *maker, const void *user, po_request *request) {
  u->variation = po_allocate(u->count, sizeof *u->variation);
  u->moved = po_allocate(2 * u->count, sizeof *u->moved);
  po_status status = u->variation && u->moved ? PO_OK : PO_NO_MEMORY;
  for (size_t k = 0; k < u->count && !status; ++k)
    status = vary(u, k, given, maker, user, request);
  request->variation = u->variation;
  request->variations = u->count;
  return status;
}

void po_uncertain_clear(po_uncertain_inputs *u) {
  for (int key = 0; key < PO_KEY_ALL; ++key)
    free(u->text[key]);
  free(u->number);
  free(u->variation);
  free(u->moved);
  *u = (po_uncertain_inputs){0};
}
