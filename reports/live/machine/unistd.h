/* The memory of the machine for po_memory_of_machine, which multiplies a number of pages by their
 * size: half of the 4 GiB that a module can have, because memory that is freed may be in pieces. */
#ifndef PO_LIVE_UNISTD_H
#define PO_LIVE_UNISTD_H

#include_next <unistd.h>
#define _SC_PHYS_PAGES 85
#define sysconf(name) ((name) == _SC_PHYS_PAGES ? 32768L : 65536L)

#endif
