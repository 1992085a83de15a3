/* Runs a fuzz target on the inputs of a corpus, with any compiler: replay FOLDER-OR-FILE... */
#include <dirent.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include "fuzz.h"
#include "po_file.h"

/* Limit of the processor time of an input, in seconds. The slowest of the corpus takes a hundredth
 * of it. */
enum { TIME_LIMIT = 20 };

static char current[PATH_MAX];

static void say_which(void) {
  static const char BEFORE[] = "replay: ended by this input: ";
  ssize_t put = write(STDERR_FILENO, BEFORE, sizeof BEFORE - 1);
  put = write(STDERR_FILENO, current, strlen(current));
  put = write(STDERR_FILENO, "\n", 1);
  (void)put;
}

/* Called by the address sanitizer, which handles the signals of a crash itself. */
void __asan_on_error(void);
void __asan_on_error(void) {
  say_which();
}

static void end(int signal_number) {
  say_which();
  signal(signal_number, SIG_DFL);
  raise(signal_number);
}

/* Limits the processor time, so that a busy machine does not matter. 0: no limit. */
static void limit_time(int seconds) {
  const struct itimerval limit = {.it_value = {.tv_sec = seconds}};
  setitimer(ITIMER_PROF, &limit, NULL);
}

static size_t replay_file(const char *path) {
  char *bytes = NULL;
  size_t size = 0;
  snprintf(current, sizeof current, "%s", path);
  fuzz_require(po_file_read(path, &bytes, &size) == PO_OK, "%s", po_message());
  /* The buffer has the exact size of the input, so that a sanitizer detects a read beyond it. */
  uint8_t *exact = malloc(size ? size : 1);
  fuzz_require(exact != NULL, "no memory for %s", path);
  memcpy(exact, bytes, size);
  free(bytes);
  limit_time(TIME_LIMIT);
  LLVMFuzzerTestOneInput(exact, size);
  limit_time(0);
  free(exact);
  return 1;
}

static size_t replay_path(const char *path) {
  struct stat found;
  struct dirent **entries = NULL;
  fuzz_require(stat(path, &found) == 0, "%s is not there", path);
  if (!S_ISDIR(found.st_mode))
    return replay_file(path);
  const int names = scandir(path, &entries, NULL, alphasort);
  size_t count = 0;
  for (int i = 0; i < names; ++i) {
    if (entries[i]->d_name[0] != '.')
      count += replay_file(po_path_join(path, entries[i]->d_name).text);
    free(entries[i]);
  }
  free(entries);
  return count;
}

int main(int argc, char **argv) {
  size_t count = 0;
  FILE *report = fdopen(dup(STDOUT_FILENO), "w");
  signal(SIGPROF, end);
  signal(SIGABRT, end);
  if (!report || !freopen("/dev/null", "w", stdout))
    return 1;
  for (int i = 1; i < argc; ++i)
    count += replay_path(argv[i]);
  fprintf(report, "%zu inputs replayed\n", count);
  return count ? 0 : 1;
}
