/* Threads that solve different scenes at the same time get the results of single solves, to the
 * last bit; messages belong to the call; the state of the process and of the threads is restored.
 * Runs under the thread and address sanitizers, too (.ci/run). */
#include <gsl/gsl_errno.h>
#include <locale.h>
#include <pthread.h>
#include <stdio.h>

#include "scenes.h"
#include "use.h"

extern int openblas_get_num_threads(void);
extern void openblas_set_num_threads(int threads);

/* THREADS and ROUNDS are set by the build: four threads and one round under a sanitizer, which looks
 * at the order of accesses and not at results. */
enum { BLAS_THREADS = 2 };

static char *single[SCENE_COUNT];
static pulloff_status status_of[SCENE_COUNT];
static int failures;
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

static void expect(bool holds, const char *what, const char *detail) {
  if (holds)
    return;
  pthread_mutex_lock(&lock);
  ++failures;
  fprintf(stderr, "FAILED: %s: %s\n", what, detail);
  pthread_mutex_unlock(&lock);
}

/* The document of a scene, without times, to be freed; NULL if there is none. */
static char *document(const char *words, pulloff_status *status) {
  pulloff_message message;
  pulloff_result *result;
  char *text = NULL;
  *status = solve_words(words, &result, &message);
  if (result)
    pulloff_result_json(result, &text, &message);
  if (text)
    remove_seconds(text);
  pulloff_result_destroy(result);
  return text;
}

/* A wrong value, whose message contains the value of this thread. */
static void fail_once(int number) {
  char value[40];
  pulloff_message message;
  pulloff_scene *scene;
  expect(!pulloff_scene_create(&scene, NULL), "scene", "created");
  snprintf(value, sizeof value, "-%d", number + 1);
  expect(pulloff_scene_set(scene, "tabor", value, &message) == PULLOFF_BAD_INPUT, "bad value",
         value);
  char expected[120];
  snprintf(expected, sizeof expected, "tabor is %s: expected a finite number >= 0", value);
  expect(strcmp(message.text, expected) == 0, "message of the call", message.text);
  pulloff_scene_destroy(scene);
}

static void *work(void *data) {
  const int number = *(const int *)data;
  for (int k = 0; k < ROUNDS * SCENE_COUNT; ++k) {
    const int scene = (k + number) % SCENE_COUNT;
    pulloff_status status;
    char *text = document(SCENES[scene], &status);
    expect(status == status_of[scene], "status", SCENES[scene]);
    expect(text && single[scene] && strcmp(text, single[scene]) == 0, "document", SCENES[scene]);
    pulloff_free(text);
    fail_once(100 * number + k);
  }
  return NULL;
}

static void note_error(const char *reason, const char *file, int line, int code) {
  (void)reason, (void)file, (void)line, (void)code;
}

int main(void) {
  pthread_t threads[THREADS];
  int numbers[THREADS];
  setlocale(LC_ALL, "de_DE.UTF-8"); /* if it is installed: a comma in numbers */
  gsl_set_error_handler(note_error);
  openblas_set_num_threads(BLAS_THREADS);
  const int blas = openblas_get_num_threads();
  for (int i = 0; i < SCENE_COUNT; ++i)
    single[i] = document(SCENES[i], &status_of[i]);
  for (int i = 0; i < THREADS; ++i) {
    numbers[i] = i;
    if (pthread_create(&threads[i], NULL, work, &numbers[i]) != 0)
      return 99;
  }
  for (int i = 0; i < THREADS; ++i)
    pthread_join(threads[i], NULL);
  expect(gsl_set_error_handler(NULL) == note_error, "the error handler of GSL", "is restored");
  expect(openblas_get_num_threads() == blas, "the threads of OpenBLAS", "are restored");
  for (int i = 0; i < SCENE_COUNT; ++i)
    pulloff_free(single[i]);
  printf("%d threads, %d scenes, %d rounds, %d failures\n", THREADS, SCENE_COUNT, ROUNDS, failures);
  return failures != 0;
}
