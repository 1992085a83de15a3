/* What a solver cannot do: write outside its folder, and read the memory and the environment of
 * this program. po_confine and po_blind are called between fork and exec. */
#ifndef PO_CONFINE_H
#define PO_CONFINE_H

#include <stdbool.h>

/* Restricts this process and its descendants to creating, changing and removing files in one folder
 * and to writing to /dev. Owners, permissions and times of other files are not protected. Returned:
 * 0, or an errno; ENOSYS or EOPNOTSUPP if the kernel has no Landlock. */
int po_confine(const char *folder);

/* Gives up the capabilities by which a program of root, executed next, could read the memory and
 * the environment of other processes. Without such capabilities this has no effect. */
void po_blind(void);

/* Closes the files /proc/PID/environ and /proc/PID/mem of this process to other processes of the
 * user: its environment may contain secrets. Until its end this process writes no core file, and a
 * debugger can be attached only by root. */
void po_hide(void);

/* Reports whether this kernel can confine the files that a process writes to a folder. */
bool po_can_confine(void);

#endif
