/* Faults on demand, preloaded into the program (LD_PRELOAD). The k-th allocation, or the k-th call
 * that opens, reads, writes or renames a file, fails as it does on a machine without memory or on a
 * full disk. README.md says how it is used.
 *
 *   FAULT_KIND    which calls are counted: a name of KINDS below
 *   FAULT_AT      the number of the call that fails, from 1; absent: no call fails
 *   FAULT_MODE    once (default): only this call fails; on: this call and all later ones fail;
 *                 kill: the process is killed at this call
 *   FAULT_TRACE   prints the place of the failing call (for addr2line)
 *   FAULT_REPORT  the file for the counts: the number of calls of each kind, whether a fault was
 *                 delivered, and the place that allocated each block that was not released
 *
 * Calls are counted from the beginning of main on. Needs glibc. */
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

typedef enum {
  ALLOCATE,
  OPEN,
  READ,
  WRITE,
  SHORT_WRITE,
  CLOSE,
  FSYNC,
  RENAME,
  MKDIR,
  UNLINK,
  KIND_COUNT
} fault_kind;

static const struct {
  const char *name;
  int error;
} KINDS[KIND_COUNT] = {
    [ALLOCATE] = {"allocate", ENOMEM},
    [OPEN] = {"open", EMFILE},
    [READ] = {"read", EIO},
    [WRITE] = {"write", ENOSPC},
    [SHORT_WRITE] = {"short", ENOSPC},
    [CLOSE] = {"close", EIO},
    [FSYNC] = {"fsync", EIO},
    [RENAME] = {"rename", EIO},
    [MKDIR] = {"mkdir", ENOSPC},
    [UNLINK] = {"unlink", EACCES},
};

typedef enum { ONCE, ON, KILL } fault_mode;

static fault_kind target;
static fault_mode mode;
static unsigned long fail_at;
static bool trace;
static atomic_bool armed;
static atomic_ulong counts[KIND_COUNT], delivered;
static _Thread_local bool inside; /* the shim's own calls are not counted */

static void tell_place(void) {
  void *frames[40];
  inside = true;
  const int count = backtrace(frames, 40);
  backtrace_symbols_fd(frames, count, STDERR_FILENO);
  inside = false;
}

/* Returns whether this call must fail, and sets errno if so. */
static bool fails(fault_kind kind) {
  if (!armed || inside)
    return false;
  const unsigned long number = ++counts[kind];
  if (kind != target || fail_at == 0 || number < fail_at || (mode != ON && number > fail_at))
    return false;
  ++delivered;
  if (trace)
    tell_place();
  if (mode == KILL)
    kill(getpid(), SIGKILL);
  errno = KINDS[kind].error;
  return true;
}

/* Blocks that are not released yet, in a hash table with open addressing. */
enum { SLOTS = 1 << 20 };
typedef struct {
  void *block, *caller;
} slot;
static slot *slots;
static pthread_mutex_t slots_lock = PTHREAD_MUTEX_INITIALIZER;

static slot *find_slot(const void *block, const void *wanted) {
  const size_t start = (size_t)((uintptr_t)block >> 4) * 2654435761u % SLOTS;
  slot *removed = NULL;
  for (size_t i = 0; i < SLOTS; ++i) {
    slot *at = &slots[(start + i) % SLOTS];
    if (at->block == wanted && wanted)
      return at;
    if (!at->block && at->caller) { /* removed */
      removed = removed ? removed : at;
      continue;
    }
    if (!at->block)
      return wanted ? NULL : removed ? removed : at;
  }
  return wanted ? NULL : removed;
}

static void *keep(void *block, void *caller) {
  if (!slots || !block || inside || !armed)
    return block;
  pthread_mutex_lock(&slots_lock);
  slot *at = find_slot(block, NULL);
  if (at)
    *at = (slot){block, caller};
  pthread_mutex_unlock(&slots_lock);
  return block;
}

static void forget(void *block) {
  if (!slots || !block || inside)
    return;
  pthread_mutex_lock(&slots_lock);
  slot *at = find_slot(block, block);
  if (at)
    at->block = NULL;
  pthread_mutex_unlock(&slots_lock);
}

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *block, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void __libc_free(void *block);

#define CALLER __builtin_return_address(0)

void *malloc(size_t size) {
  return fails(ALLOCATE) ? NULL : keep(__libc_malloc(size), CALLER);
}

void *calloc(size_t count, size_t size) {
  return fails(ALLOCATE) ? NULL : keep(__libc_calloc(count, size), CALLER);
}

static void *resize(void *block, size_t size, void *caller) {
  if (fails(ALLOCATE))
    return NULL;
  forget(block);
  void *larger = __libc_realloc(block, size);
  keep(larger || size == 0 ? larger : block, caller);
  return larger;
}

void *realloc(void *block, size_t size) {
  return resize(block, size, CALLER);
}

void *reallocarray(void *block, size_t count, size_t size) {
  if (size && count > SIZE_MAX / size) {
    errno = ENOMEM;
    return NULL;
  }
  return resize(block, count * size, CALLER);
}

void *memalign(size_t alignment, size_t size) {
  return fails(ALLOCATE) ? NULL : keep(__libc_memalign(alignment, size), CALLER);
}

void *aligned_alloc(size_t alignment, size_t size) {
  return fails(ALLOCATE) ? NULL : keep(__libc_memalign(alignment, size), CALLER);
}

int posix_memalign(void **block, size_t alignment, size_t size) {
  if (fails(ALLOCATE))
    return ENOMEM;
  void *made = keep(__libc_memalign(alignment, size), CALLER);
  if (!made)
    return ENOMEM;
  *block = made;
  return 0;
}

static char *copy(const char *text, size_t length, void *caller) {
  char *made = fails(ALLOCATE) ? NULL : keep(__libc_malloc(length + 1), caller);
  if (made) {
    memcpy(made, text, length);
    made[length] = '\0';
  }
  return made;
}

char *strdup(const char *text) {
  return copy(text, strlen(text), CALLER);
}

char *strndup(const char *text, size_t most) {
  return copy(text, strnlen(text, most), CALLER);
}

void free(void *block) {
  forget(block);
  __libc_free(block);
}

/* The functions of the C library that are wrapped below. */
static struct {
  int (*open)(const char *, int, ...);
  FILE *(*fopen)(const char *, const char *);
  DIR *(*opendir)(const char *);
  ssize_t (*read)(int, void *, size_t);
  ssize_t (*write)(int, const void *, size_t);
  int (*close)(int);
  int (*fsync)(int);
  int (*rename)(const char *, const char *);
  int (*mkdir)(const char *, mode_t);
  int (*unlink)(const char *);
} real;

/* The address of a function in the next library. POSIX guarantees that a pointer to data can hold
 * it.
 */
static void find(const char *name, void *function) {
  void *found = dlsym(RTLD_NEXT, name);
  memcpy(function, &found, sizeof found);
}

static void find_all(void) {
  find("open", &real.open);
  find("fopen", &real.fopen);
  find("opendir", &real.opendir);
  find("read", &real.read);
  find("write", &real.write);
  find("close", &real.close);
  find("fsync", &real.fsync);
  find("rename", &real.rename);
  find("mkdir", &real.mkdir);
  find("unlink", &real.unlink);
}

#define READY (real.unlink ? (void)0 : find_all())

int open(const char *path, int flags, ...) {
  READY;
  va_list arguments;
  va_start(arguments, flags);
  const mode_t permissions = flags & (O_CREAT | O_TMPFILE) ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  return fails(OPEN) ? -1 : real.open(path, flags, permissions);
}

FILE *fopen(const char *path, const char *how) {
  READY;
  return fails(OPEN) ? NULL : real.fopen(path, how);
}

DIR *opendir(const char *path) {
  READY;
  return fails(OPEN) ? NULL : real.opendir(path);
}

ssize_t read(int file, void *bytes, size_t size) {
  READY;
  return fails(READ) ? -1 : real.read(file, bytes, size);
}

/* A short write writes half of the bytes, and the next call fails, as on a disk that becomes full.
 */
ssize_t write(int file, const void *bytes, size_t size) {
  READY;
  static atomic_bool full;
  if (fails(WRITE))
    return -1;
  if (full && !inside) {
    full = mode == ON;
    errno = ENOSPC;
    return -1;
  }
  if (fails(SHORT_WRITE)) {
    full = true;
    return real.write(file, bytes, (size + 1) / 2);
  }
  return real.write(file, bytes, size);
}

/* Linux closes the descriptor in any case. */
int close(int file) {
  READY;
  const bool failing = fails(CLOSE);
  const int result = real.close(file);
  if (!failing)
    return result;
  errno = EIO;
  return -1;
}

int fsync(int file) {
  READY;
  return fails(FSYNC) ? -1 : real.fsync(file);
}

int rename(const char *from, const char *to) {
  READY;
  return fails(RENAME) ? -1 : real.rename(from, to);
}

int mkdir(const char *path, mode_t permissions) {
  READY;
  return fails(MKDIR) ? -1 : real.mkdir(path, permissions);
}

int unlink(const char *path) {
  READY;
  return fails(UNLINK) ? -1 : real.unlink(path);
}

/* Standard output must use the write above, because the C library calls its own. */
static ssize_t write_output(void *cookie, const char *bytes, size_t size) {
  (void)cookie;
  size_t done = 0;
  while (done < size) {
    const ssize_t put = write(STDOUT_FILENO, bytes + done, size - done);
    if (put < 0)
      return 0; /* an error of a stream that fopencookie made */
    done += (size_t)put;
  }
  return (ssize_t)size;
}

static void read_orders(void) {
  const char *kind = getenv("FAULT_KIND"), *at = getenv("FAULT_AT"), *how = getenv("FAULT_MODE");
  while (target < KIND_COUNT && kind && strcmp(kind, KINDS[target].name) != 0)
    ++target;
  fail_at = at ? strtoul(at, NULL, 10) : 0;
  mode = how && strcmp(how, "on") == 0 ? ON : how && strcmp(how, "kill") == 0 ? KILL : ONCE;
  trace = getenv("FAULT_TRACE") != NULL;
  unsetenv("LD_PRELOAD"); /* not for the programs that it starts */
}

/* The libraries whose blocks the program owns. Others keep some blocks as long as they are loaded.
 */
static bool is_owned(const char *object) {
  static const char *const OTHERS[] = {"libc.so",  "libgomp",    "libopenblas", "libgfortran",
                                       "ld-linux", "libomp",     "libpthread",  "libstdc++",
                                       "libgcc_s", "libquadmath"};
  for (size_t i = 0; i < sizeof OTHERS / sizeof *OTHERS; ++i)
    if (strstr(object, OTHERS[i]))
      return false;
  return true;
}

static void report(const char *path) {
  FILE *file = real.fopen(path, "w");
  if (!file)
    return;
  for (int kind = 0; kind < KIND_COUNT; ++kind)
    fprintf(file, "count %s %lu\n", KINDS[kind].name, (unsigned long)counts[kind]);
  fprintf(file, "delivered %lu\n", (unsigned long)delivered);
  for (size_t i = 0; slots && i < SLOTS; ++i) {
    Dl_info place;
    if (slots[i].block && dladdr(slots[i].caller, &place) && is_owned(place.dli_fname))
      fprintf(file, "kept %s+0x%lx\n", place.dli_fname,
              (unsigned long)((char *)slots[i].caller - (char *)place.dli_fbase));
  }
  fclose(file);
}

__attribute__((destructor)) static void end(void) {
  const char *path = getenv("FAULT_REPORT");
  armed = false;
  inside = true;
  if (path)
    report(path);
}

static int (*real_main)(int, char **, char **);

static int main_with_faults(int argc, char **argv, char **environment) {
  READY;
  read_orders();
  void *frames[2];
  if (trace)
    backtrace(frames, 2); /* the first call loads a library, which allocates */
  if (getenv("FAULT_REPORT"))
    slots = mmap(NULL, SLOTS * sizeof *slots, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS,
                 -1, 0);
  if (target == WRITE || target == SHORT_WRITE) {
    FILE *output = fopencookie(NULL, "w", (cookie_io_functions_t){.write = write_output});
    if (output)
      stdout = output;
  }
  armed = true;
  return real_main(argc, argv, environment);
}

/* The start of a program, with main_with_faults instead of its main. */
int __libc_start_main(int (*begin)(int, char **, char **), int argc, char **argv,
                      void (*init)(void), void (*fini)(void), void (*rtld_fini)(void),
                      void *stack_end);
int __libc_start_main(int (*begin)(int, char **, char **), int argc, char **argv,
                      void (*init)(void), void (*fini)(void), void (*rtld_fini)(void),
                      void *stack_end) {
  int (*next)(int (*)(int, char **, char **), int, char **, void (*)(void), void (*)(void),
              void (*)(void), void *) = NULL;
  find("__libc_start_main", &next);
  real_main = begin;
  return next(main_with_faults, argc, argv, init, fini, rtld_fini, stack_end);
}
