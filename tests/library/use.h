/* Functions of the tests of the library. They see the public header only. */
#ifndef USE_H
#define USE_H

#include <stdlib.h>
#include <string.h>

#include "pulloff.h"

/* Sets the keys of a text "key value key value". */
static inline pulloff_status set_words(pulloff_scene *scene, const char *words,
                                       pulloff_message *message) {
  char copy[400], *rest = copy;
  strncpy(copy, words, sizeof copy - 1);
  copy[sizeof copy - 1] = '\0';
  pulloff_status status = PULLOFF_OK;
  const char *key;
  while (!status && (key = strtok_r(NULL, " ", &rest)))
    status = pulloff_scene_set(scene, key, strtok_r(NULL, " ", &rest), message);
  return status;
}

/* Solves the scene of a text. Returned: the status of the first function that fails; *result, NULL
 * if there is none. */
static inline pulloff_status solve_words(const char *words, pulloff_result **result,
                                         pulloff_message *message) {
  pulloff_scene *scene = NULL;
  *result = NULL;
  pulloff_status status = pulloff_scene_create(&scene, message);
  if (!status)
    status = set_words(scene, words, message);
  if (!status)
    status = pulloff_solve(scene, result, message);
  pulloff_scene_destroy(scene);
  return status;
}

/* Removes the times, which differ from solve to solve, from a document. */
static inline void remove_seconds(char *text) {
  for (char *at = text; (at = strstr(at, "\"seconds\"")) != NULL;) {
    char *end = strchr(at, '\n');
    end = end ? end : at + strlen(at);
    memmove(at, end, strlen(end) + 1);
  }
}

#endif
