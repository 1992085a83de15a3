/* Threads with a stack of 128 kB solve every scene, follow a series and evaluate closed forms. Half
 * of such a stack may be the thread-local variables of OpenBLAS. One solve took 1.2 MB. */
#include <math.h>
#include <pthread.h>
#include <stdio.h>

#include "scenes.h"
#include "use.h"

enum { STACK = 128 * 1024 };

static const char *const FORMS[] = {"jkr", "maugis", "guduru", "kesari-lew", "bradley"};
enum { FORM_COUNT = sizeof FORMS / sizeof *FORMS };

static void print(pulloff_result *result) {
  char *text = NULL;
  if (result && pulloff_result_json(result, &text, NULL) == PULLOFF_OK)
    puts(text);
  pulloff_free(text);
  pulloff_result_destroy(result);
}

static void *work(void *data) {
  pulloff_result *result[3] = {NULL};
  for (int i = 0; i < SCENE_COUNT; ++i) {
    solve_words(SCENES[i], &result[0], NULL);
    print(result[0]);
  }
  pulloff_scene *scene = NULL;
  if (pulloff_scene_create(&scene, NULL) ||
      set_words(scene, "tabor 1 amplitude 1 wavelength 20", NULL))
    return NULL;
  static const double AMPLITUDES[] = {1.0, 1.1, 1.2};
  pulloff_follow(scene, "amplitude", AMPLITUDES, 3, result, NULL);
  for (int i = 0; i < 3; ++i)
    print(result[i]);
  for (int i = 0; i < FORM_COUNT; ++i) {
    pulloff_theory(FORMS[i], scene, (double)NAN, (double)NAN, &result[0], NULL);
    print(result[0]);
  }
  pulloff_scene_destroy(scene);
  return data;
}

int main(void) {
  pthread_attr_t small;
  pthread_t thread;
  char solved;
  void *done = NULL;
  if (pthread_attr_init(&small) || pthread_attr_setstacksize(&small, STACK) ||
      pthread_create(&thread, &small, work, &solved) || pthread_join(thread, &done))
    return 99;
  return done == &solved ? 0 : 1;
}
