/* A module has no limits but its address space. */
#ifndef PO_LIVE_RESOURCE_H
#define PO_LIVE_RESOURCE_H

struct rlimit {
  unsigned long rlim_cur, rlim_max;
};
#define RLIMIT_AS 9
#define RLIM_INFINITY (~0ul)

static inline int getrlimit(int resource, struct rlimit *limit) {
  (void)resource;
  (void)limit;
  return -1;
}

#endif
