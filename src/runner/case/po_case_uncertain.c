/* Uncertain numbers of a case, "0.05+-0.002": their uncertainties are cut off when the file is
 * read; each point has the requests with its numbers less and more. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_case_internal.h"
#include "po_memory.h"

/* Adds the numbers that were read, and replaces the texts by those without uncertainties. Given:
 * the place of the text of each key. */
static po_status take(po_case *kase, int item, unsigned setting, po_uncertain_inputs *read,
                      char **values[PO_KEY_ALL]) {
  for (size_t k = 0; k < read->count; ++k) {
    po_case_number *grown =
        po_grow(kase->uncertain, kase->uncertain_count, &kase->uncertain_room, sizeof *grown);
    if (!grown)
      return PO_NO_MEMORY;
    kase->uncertain = grown;
    grown[kase->uncertain_count++] = (po_case_number){read->number[k], item, setting};
  }
  for (int key = 0; key < PO_KEY_ALL; ++key)
    if (read->text[key]) {
      free(*values[key]);
      *values[key] = read->text[key];
      read->text[key] = NULL;
    }
  return PO_OK;
}

/* Reads the texts at some places; NULL: no key has one there. */
static po_status read_texts(po_case *kase, int item, unsigned setting, const char *prefix,
                            char **values[PO_KEY_ALL]) {
  po_texts given = {.prefix = prefix};
  po_uncertain_inputs read;
  for (int key = 0; key < PO_KEY_ALL; ++key)
    given.text[key] = values[key] ? *values[key] : NULL;
  po_status status = po_uncertain_read(&given, &read);
  if (!status)
    status = take(kase, item, setting, &read, values);
  po_uncertain_clear(&read);
  return status;
}

static po_status read_words(po_case *kase, int item, unsigned setting, const char *prefix,
                            po_scene_words *words) {
  char **values[PO_KEY_ALL];
  for (int key = 0; key < PO_KEY_ALL; ++key)
    values[key] = &words->values[key];
  return read_texts(kase, item, setting, prefix, values);
}

po_status po_case_uncertain_scene(po_case *kase, const po_yaml *yaml) {
  po_scene_words *scene = &kase->file->scene;
  po_status status = read_words(kase, -1, 0, "scene.", scene);
  if (!status && scene->physical)
    status = read_words(kase, -1, 0, "scene.physical.", scene->physical);
  return status ? po_case_refuse_for(yaml, "scene", status) : PO_OK;
}

/* Reads setting number `index` of an item of the sweep. */
static po_status read_setting(po_case *kase, unsigned item, unsigned index, const char *where,
                              const po_yaml *yaml) {
  po_sweep *sweep = &kase->file->sweep[item];
  char of[2 * PO_CASE_WHERE_LENGTH];
  if (sweep->together) {
    snprintf(of, sizeof of, "%s.together[%u].", where, index + 1);
    const po_status status =
        read_words(kase, (int)item, index, sweep->table ? "" : of, &sweep->together[index]);
    if (status == PO_BAD_INPUT && sweep->table)
      return po_fail(status, "%s: row %u: %s", sweep->table, index + 1, po_message());
    return status ? po_case_refuse_for(yaml, where, status) : PO_OK;
  }
  const int key = po_texts_key(sweep->axis.key);
  char **values[PO_KEY_ALL] = {NULL};
  if (key < 0)
    return PO_OK;
  values[key] = &sweep->axis.values[index];
  snprintf(of, sizeof of, "%s.values[%u]", where, index + 1);
  const po_status status = read_texts(kase, (int)item, index, "", values);
  return status ? po_case_refuse_for(yaml, of, status) : PO_OK;
}

po_status po_case_uncertain_sweep(po_case *kase, unsigned item, const char *where,
                                  const po_yaml *yaml) {
  const po_sweep *sweep = &kase->file->sweep[item];
  const unsigned count = sweep->together   ? sweep->together_count
                         : sweep->axis.key ? sweep->axis.values_count
                                           : 0;
  po_status status = PO_OK;
  for (unsigned k = 0; k < count && !status; ++k)
    status = read_setting(kase, item, k, where, yaml);
  return status;
}

/* -- Points -- */

/* The place of the text of a number. */
static char **place_of(const po_case *kase, const po_case_number *n) {
  const int key = n->number.key;
  po_scene_words *scene = &kase->file->scene;
  if (n->item < 0)
    return &(po_case_is_in_si(key) ? scene->physical : scene)->values[key];
  po_sweep *sweep = &kase->file->sweep[n->item];
  return sweep->together ? &sweep->together[n->setting].values[key]
                         : &sweep->axis.values[n->setting];
}

/* Whether a point has a number. */
static bool has_number(const po_case *kase, const po_point *point, const po_case_number *n) {
  return n->item < 0 ||
         po_case_swept_text(kase, point, (unsigned)n->item, n->number.key) == *place_of(kase, n);
}

typedef struct {
  const po_case *kase;
  const po_point *point;
  const po_yaml *yaml;
  const po_texts *given; /* of the uncertain numbers of the point */
  char **place[PO_KEY_ALL];
} maker;

/* Makes the request of the point with one text changed, in the file, for as long as it is made. */
static po_status make_request(const po_texts *texts, const void *user, po_request *request) {
  const maker *m = user;
  po_point moved = *m->point;
  po_text label = {0};
  int key = 0;
  while (key < PO_KEY_ALL - 1 && texts->text[key] == m->given->text[key])
    ++key;
  *request = m->point->request;
  if (!po_key_set(request, key, texts->text[key]))
    return po_fail(PO_BAD_INPUT, "%s is %s: expected %s", PO_KEYS[key].name, texts->text[key],
                   PO_KEYS[key].expected);
  char *whole = *m->place[key];
  *m->place[key] = (char *)texts->text[key];
  const po_status status = po_case_make_request(m->kase, m->yaml, true, &moved, &label);
  *m->place[key] = whole;
  po_text_clear(&label);
  *request = moved.request;
  request->in_si = m->kase->is_physical;
  return status ? status : po_request_check(request);
}

po_status po_case_uncertain_point(po_case *kase, po_point *point, const po_yaml *yaml) {
  po_texts given = {.prefix = ""};
  maker m = {.kase = kase, .point = point, .yaml = yaml, .given = &given};
  po_uncertain_inputs *u = NULL;
  for (size_t k = 0; k < kase->uncertain_count; ++k) {
    const po_case_number *n = &kase->uncertain[k];
    if (!has_number(kase, point, n))
      continue;
    if (!u)
      u = point->uncertain = po_allocate(1, sizeof *u);
    po_uncertain_number *grown = u ? po_grow(u->number, u->count, &u->room, sizeof *grown) : NULL;
    if (!grown)
      return PO_NO_MEMORY;
    u->number = grown;
    grown[u->count++] = n->number;
    m.place[n->number.key] = place_of(kase, n);
    given.text[n->number.key] = *m.place[n->number.key];
  }
  const po_status status =
      u ? po_uncertain_vary(u, &given, make_request, &m, &point->request) : PO_OK;
  return status == PO_BAD_INPUT ? po_fail(status, "%s:%zu: scene (%s): %s", yaml->name,
                                          po_yaml_line(yaml, "scene"), point->label, po_message())
                                : status;
}

void po_case_uncertain_clear(po_point *point) {
  if (point->uncertain)
    po_uncertain_clear(point->uncertain);
  free(point->uncertain);
}
