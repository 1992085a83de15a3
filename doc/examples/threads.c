/* Solves smooth spheres of several Tabor parameters at the same time, one thread each, and prints
 * the pull-off force beside that of the JKR theory, in pi w R.
 *
 *     cc threads.c $(pkg-config --cflags --libs pulloff) -pthread && ./a.out
 */
#include <math.h>
#include <pthread.h>
#include <pulloff.h>
#include <stdio.h>

enum { COUNT = 8 };

typedef struct {
  double tabor, force, error, jkr;
  pulloff_status status;
  pulloff_message message;
} task;

static void *run(void *data) {
  task *t = data;
  pulloff_scene *scene = NULL;
  pulloff_result *result = NULL, *theory = NULL;
  t->status = pulloff_scene_create(&scene, &t->message);
  if (!t->status)
    t->status = pulloff_scene_set_number(scene, "tabor", t->tabor, &t->message);
  if (!t->status)
    t->status = pulloff_solve(scene, &result, &t->message);
  if (!t->status)
    t->status = pulloff_theory("jkr", scene, (double)NAN, (double)NAN, &theory, &t->message);
  if (!t->status)
    t->status = pulloff_result_number(theory, "pull_off_force", &t->jkr, &t->message);
  pulloff_pull_off pull_off = {.force = NAN};
  if (!t->status && pulloff_result_pull_off(result, &pull_off)) {
    t->force = pull_off.force;
    t->error = pull_off.force_error;
  }
  pulloff_result_destroy(theory);
  pulloff_result_destroy(result);
  pulloff_scene_destroy(scene);
  return NULL;
}

int main(void) {
  static task tasks[COUNT];
  pthread_t threads[COUNT];
  bool started[COUNT];
  int failures = 0;
  for (int i = 0; i < COUNT; ++i) {
    tasks[i].tabor = 0.25 * (i + 1);
    started[i] = pthread_create(&threads[i], NULL, run, &tasks[i]) == 0;
    if (!started[i])
      run(&tasks[i]);
  }
  printf("%8s %14s %9s %8s\n", "tabor", "force", "error", "JKR");
  for (int i = 0; i < COUNT; ++i) {
    if (started[i])
      pthread_join(threads[i], NULL);
    if (tasks[i].status)
      printf("%8g %s\n", tasks[i].tabor, tasks[i].message.text);
    else
      printf("%8g %14.9f %9.1e %8g\n", tasks[i].tabor, tasks[i].force, tasks[i].error,
             tasks[i].jkr);
    failures += tasks[i].status != PULLOFF_OK;
  }
  return failures ? 1 : 0;
}
