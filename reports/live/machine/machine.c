/* What wasi-libc lacks, and what the solver takes of an operating system, which the module does not
 * have. */
#include <errno.h>
#include <stdint.h>
#include <stdlib.h>

#include "po_file.h"
#include "po_machine.h"

/* Replaces that of wasi-libc, which grows the memory by as little as 64 KiB: every growth costs the
 * browser a new ArrayBuffer, and a scene three times its time. */
void *sbrk(intptr_t more) {
  static uintptr_t end;
  const uintptr_t PAGE = 65536, STEP = 512; /* at least 32 MiB */
  const uintptr_t pages = (uintptr_t)__builtin_wasm_memory_size(0);
  if (!end)
    end = pages * PAGE;
  if (more <= 0)
    return (void *)end;
  const uintptr_t before = end, room = pages * PAGE - end;
  if ((uintptr_t)more > room) {
    const uintptr_t least = ((uintptr_t)more - room + PAGE - 1) / PAGE;
    const uintptr_t wanted = least > STEP ? least : STEP;
    if (__builtin_wasm_memory_grow(0, wanted) == SIZE_MAX &&
        __builtin_wasm_memory_grow(0, least) == SIZE_MAX) {
      errno = ENOMEM;
      return (void *)-1;
    }
  }
  end = before + (uintptr_t)more;
  return (void *)before;
}

/* The module has no files, and so no pipes. */
uint64_t po_path_pipe(const char *path) {
  (void)path;
  return 0;
}

/* In place of po_machine.c. */
void *po_machine_allocate(size_t alignment, size_t bytes) {
  return aligned_alloc(alignment, bytes);
}

/* Half of the 4 GiB that a module can have, because memory that is freed may be in pieces. */
double po_machine_memory(void) {
  return 2147483648.0;
}

/* The module has one locale. */
bool po_machine_plain_locale(void **before) {
  *before = NULL;
  return true;
}

void po_machine_set_locale(void *before) {
  (void)before;
}
