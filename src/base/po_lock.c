#include "po_lock.h"

#include <pthread.h>

static pthread_mutex_t locks[PO_LOCKS] = {PTHREAD_MUTEX_INITIALIZER, PTHREAD_MUTEX_INITIALIZER,
                                          PTHREAD_MUTEX_INITIALIZER, PTHREAD_MUTEX_INITIALIZER};

static void take_all(void) {
  for (int lock = 0; lock < PO_LOCKS; ++lock)
    pthread_mutex_lock(&locks[lock]);
}

static void release_all(void) {
  for (int lock = PO_LOCKS - 1; lock >= 0; --lock)
    pthread_mutex_unlock(&locks[lock]);
}

/* Without memory for it, fork() is as before. */
static void watch_forks(void) {
  pthread_atfork(take_all, release_all, release_all);
}

void po_lock_take(po_lock lock) {
  static pthread_once_t once = PTHREAD_ONCE_INIT;
  pthread_once(&once, watch_forks);
  pthread_mutex_lock(&locks[lock]);
}

void po_lock_release(po_lock lock) {
  pthread_mutex_unlock(&locks[lock]);
}
