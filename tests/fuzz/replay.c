/* Runs a fuzz target on the inputs of a corpus, with any compiler: replay ARCHIVE.tar|FILE... */
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
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

/* The buffer has the exact size of the input, so that a sanitizer detects a read beyond it. */
static void replay_input(const char *bytes, size_t size) {
  uint8_t *exact = malloc(size ? size : 1);
  fuzz_require(exact != NULL, "no memory for %s", current);
  memcpy(exact, bytes, size);
  limit_time(TIME_LIMIT);
  LLVMFuzzerTestOneInput(exact, size);
  limit_time(0);
  free(exact);
}

/* The files of a tar archive: blocks of 512 bytes, a header with the name at byte 0, the size in
 * octal at 124 and the type at 156, then the content. */
static size_t replay_archive(const char *path, const char *bytes, size_t size) {
  enum { BLOCK = 512, SIZE_AT = 124, TYPE_AT = 156 };
  size_t count = 0, at = 0;
  while (at + BLOCK <= size && bytes[at]) {
    const size_t length = strtoul(bytes + at + SIZE_AT, NULL, 8);
    fuzz_require(length <= size - at - BLOCK, "%s is truncated", path);
    if (bytes[at + TYPE_AT] == '0') {
      snprintf(current, sizeof current, "%s of %s", bytes + at, path);
      replay_input(bytes + at + BLOCK, length);
      ++count;
    }
    at += BLOCK + (length + BLOCK - 1) / BLOCK * BLOCK;
  }
  fuzz_require(at + BLOCK <= size, "%s is truncated", path);
  return count;
}

static size_t replay_path(const char *path) {
  const size_t length = strlen(path);
  char *bytes = NULL;
  size_t size = 0, count = 1;
  snprintf(current, sizeof current, "%s", path);
  fuzz_require(po_file_read(path, &bytes, &size) == PO_OK, "%s", po_message());
  if (length > 4 && !strcmp(path + length - 4, ".tar"))
    count = replay_archive(path, bytes, size);
  else
    replay_input(bytes, size);
  free(bytes);
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
