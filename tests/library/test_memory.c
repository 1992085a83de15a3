/* The k-th allocation of a call of the library fails, for a sample of k: the call returns a status,
 * loses no memory, and the next call succeeds. The allocator of glibc is replaced by functions that
 * count. */
#include <errno.h>
#include <math.h>
#include <stdio.h>

#include "use.h"

extern void *__libc_malloc(size_t);
extern void *__libc_calloc(size_t, size_t);
extern void *__libc_realloc(void *, size_t);
extern void *__libc_memalign(size_t, size_t);
extern void __libc_free(void *);

static long live;       /* blocks that are allocated */
static long made;       /* allocations since the last reset */
static long fails = -1; /* the number of the allocation that fails; -1: none */

static bool refused(void) {
  if (made++ != fails)
    return false;
  errno = ENOMEM;
  return true;
}

static void *counted(void *memory) {
  live += memory != NULL;
  return memory;
}

void *malloc(size_t size) {
  return refused() ? NULL : counted(__libc_malloc(size));
}

void *calloc(size_t count, size_t size) {
  return refused() ? NULL : counted(__libc_calloc(count, size));
}

void *realloc(void *old, size_t size) {
  if (refused())
    return NULL;
  void *memory = __libc_realloc(old, size);
  live += memory && !old;
  return memory;
}

void *aligned_alloc(size_t alignment, size_t size) {
  return refused() ? NULL : counted(__libc_memalign(alignment, size));
}

void *memalign(size_t alignment, size_t size) {
  return aligned_alloc(alignment, size);
}

int posix_memalign(void **memory, size_t alignment, size_t size) {
  *memory = aligned_alloc(alignment, size);
  return *memory ? 0 : ENOMEM;
}

void free(void *memory) {
  live -= memory != NULL;
  __libc_free(memory);
}

typedef pulloff_status use(pulloff_message *message);

static pulloff_status use_solve(pulloff_message *message) {
  pulloff_result *result;
  char *text = NULL;
  pulloff_status status =
      solve_words("tabor 1 tolerance 1e-2 want curve,profile,hysteresis,preload", &result, message);
  if (!status)
    status = pulloff_result_json(result, &text, message);
  pulloff_free(text);
  pulloff_result_destroy(result);
  return status;
}

static pulloff_status use_rigid(pulloff_message *message) {
  pulloff_result *result;
  const pulloff_status status =
      solve_words("tabor 0 amplitude 0.5 wavelength 20 want curve", &result, message);
  pulloff_result_destroy(result);
  return status;
}

static pulloff_status use_scene(pulloff_message *message) {
  const pulloff_physical tip = {
      .modulus = 2e9, .work = 0.05, .distance = 3e-10, .radius = 1e-7, .outer_radius = INFINITY};
  pulloff_scene *scene = NULL, *copy = NULL;
  pulloff_result *result = NULL;
  pulloff_status status = pulloff_scene_create(&scene, message);
  if (!status)
    status = pulloff_scene_set_physical(scene, &tip, NULL, message);
  if (!status)
    status = pulloff_scene_copy(scene, &copy, message);
  if (!status)
    status = pulloff_theory("jkr", copy, (double)NAN, 3, &result, message);
  pulloff_result_destroy(result);
  pulloff_scene_destroy(scene);
  pulloff_scene_destroy(copy);
  return status;
}

static pulloff_status use_series(pulloff_message *message) {
  const double values[] = {1, 1.05, 1.1};
  enum { COUNT = sizeof values / sizeof *values };
  pulloff_result *results[COUNT] = {NULL};
  pulloff_scene *scene = NULL;
  pulloff_status status = pulloff_scene_create(&scene, message);
  if (!status)
    status = pulloff_scene_set(scene, "tolerance", "1e-2", message);
  if (!status)
    status = pulloff_follow(scene, "tabor", values, COUNT, results, message);
  for (int k = 0; k < COUNT; ++k)
    pulloff_result_destroy(results[k]);
  pulloff_scene_destroy(scene);
  return status;
}

/* Lets each of a sample of allocations fail. Returned: the number of faults. */
static int try_all(const char *name, use *function, long sample) {
  static pulloff_message message;
  int faults = 0;
  long refusals = 0;
  function(&message); /* what is allocated once and kept */
  made = 0;
  const pulloff_status usual = function(&message);
  const long all = made, step = all / sample + 1;
  for (long k = 0; k < all; k += k < sample ? 1 : step) {
    const long before = live;
    made = 0;
    fails = k;
    const pulloff_status status = function(&message);
    fails = -1;
    const bool good = status == PULLOFF_NO_MEMORY ? *message.text != '\0' : status == usual;
    if (!good || live != before || function(&message) != usual) {
      fprintf(stderr, "FAILED: %s, allocation %ld of %ld: status %d (%s), %ld blocks lost\n", name,
              k, all, (int)status, message.text, live - before);
      ++faults;
    }
    refusals += status == PULLOFF_NO_MEMORY;
  }
  printf("%-8s %ld allocations, %ld calls without memory, %d faults\n", name, all, refusals,
         faults);
  return faults + (usual != PULLOFF_OK) + (refusals == 0);
}

/* The first solves of the process, which fill tables: a failure must not affect later calls. */
static int try_first(void) {
  enum { FIRST = 60 };
  static pulloff_message message;
  int refusals = 0;
  for (fails = 0; fails < FIRST; ++fails) {
    made = 0;
    refusals += use_solve(&message) == PULLOFF_NO_MEMORY;
  }
  fails = -1;
  const pulloff_status status = use_solve(&message);
  printf("first    %d calls without memory, then %s\n", refusals, pulloff_status_text(status));
  return status != PULLOFF_OK || refusals != FIRST;
}

int main(void) {
  int faults = try_first();
  faults += try_all("scene", use_scene, 1000);
  faults += try_all("solve", use_solve, 24);
  faults += try_all("rigid", use_rigid, 24);
  faults += try_all("series", use_series, 12);
  return faults != 0;
}
