#include "po_machine.h"

#include <fcntl.h>
#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

void *po_machine_allocate(size_t alignment, size_t bytes) {
  return aligned_alloc(alignment, bytes);
}

/* The limit that a control group sets to its processes (Linux), bytes; "max" or an absent file:
 * none. */
static const char GROUP_LIMIT[] = "/sys/fs/cgroup/memory.max";

/* Returned: that limit; INFINITY if there is none. Allocates nothing. */
static double group_limit(void) {
  char text[32];
  const int file = open(GROUP_LIMIT, O_RDONLY | O_CLOEXEC);
  if (file < 0)
    return INFINITY;
  const ssize_t length = read(file, text, sizeof text - 1);
  close(file);
  text[length > 0 ? length : 0] = '\0';
  char *end;
  const double bytes = strtod(text, &end);
  return end == text ? INFINITY : bytes;
}

double po_machine_memory(void) {
  double bytes = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
  struct rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    bytes = fmin(bytes, (double)limit.rlim_cur);
  return fmin(bytes, group_limit());
}

bool po_machine_plain_locale(void **before) {
  const locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0); /* allocates nothing */
  if (!plain)
    return false;
  *before = uselocale(plain);
  return true;
}

void po_machine_set_locale(void *before) {
  freelocale(uselocale(before));
}
