#include "po_confine.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <linux/landlock.h>
#include <stdint.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

/* The rights to change files that the first version of Landlock knows. */
static const uint64_t CHANGE = LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
                               LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
                               LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
                               LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
                               LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;

/* Rights of later versions: to link or rename to another folder (2), to truncate (3). */
static const uint64_t REFER = 1U << 13, TRUNCATE = 1U << 14;

/* The capabilities that permit a process of root to read the memory of any process, Landlock and
 * PR_SET_DUMPABLE notwithstanding: Linux 6.14 accepts CAP_PERFMON, and with it CAP_SYS_ADMIN, for
 * the environment. */
static const unsigned long SEEING[] = {CAP_SYS_PTRACE, CAP_SYS_ADMIN,
#ifdef CAP_PERFMON
                                       CAP_PERFMON
#endif
};

void po_hide(void) {
  (void)prctl(PR_SET_DUMPABLE, 0L, 0L, 0L, 0L);
}

void po_blind(void) {
  for (size_t i = 0; i < sizeof SEEING / sizeof *SEEING; ++i)
    (void)prctl(PR_CAPBSET_DROP, SEEING[i], 0L, 0L, 0L);
  (void)prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0L, 0L, 0L);
}

static long version(void) {
  return syscall(SYS_landlock_create_ruleset, NULL, 0L, LANDLOCK_CREATE_RULESET_VERSION);
}

bool po_can_confine(void) {
  return version() >= 1;
}

static int allow(int rules, const char *folder, uint64_t rights) {
  struct landlock_path_beneath_attr rule = {.allowed_access = rights,
                                            .parent_fd = open(folder, O_PATH | O_CLOEXEC)};
  if (rule.parent_fd < 0)
    return errno;
  const long failed = syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0L);
  const int error = failed ? errno : 0;
  close(rule.parent_fd);
  return error;
}

int po_confine(const char *folder) {
  const long known = version();
  if (known < 0)
    return errno;
  const uint64_t later = (known >= 2 ? REFER : 0) | (known >= 3 ? TRUNCATE : 0);
  struct landlock_ruleset_attr handled = {.handled_access_fs = CHANGE | later};
  const int rules = (int)syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0L);
  if (rules < 0)
    return errno;
  int error = allow(rules, folder, CHANGE | later);
  if (!error)
    error = allow(rules, "/dev",
                  LANDLOCK_ACCESS_FS_WRITE_FILE | (later & TRUNCATE)); /* /dev/null, terminals */
  if (!error && (prctl(PR_SET_NO_NEW_PRIVS, 1L, 0L, 0L, 0L) != 0 ||
                 syscall(SYS_landlock_restrict_self, rules, 0L) != 0))
    error = errno;
  close(rules);
  return error;
}
