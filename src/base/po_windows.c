/* What libpulloff takes of the operating system, for Windows, in place of po_file.c and
 * po_machine.c. Names of files are in UTF-8; a file is overwritten in place. */
#include <errno.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <windows.h>

#include "po_file.h"
#include "po_machine.h"
#include "po_memory.h"
#include "po_text.h"

static FILE *open_file(const char *path, const wchar_t *mode) {
  wchar_t wide[MAX_PATH];
  errno = ENOENT;
  return MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, wide, MAX_PATH)
             ? _wfopen(wide, mode)
             : NULL;
}

po_status po_file_read(const char *path, char **data, size_t *size) {
  FILE *file = open_file(path, L"rb");
  if (!file)
    return po_fail(PO_CANNOT_READ, "%s cannot be opened: %s", path, strerror(errno));
  char bytes[1 << 14];
  po_text text = {0};
  po_text_add(&text, "%s", "");
  for (size_t got; !text.failed && (got = fread(bytes, 1, sizeof bytes, file)) > 0;)
    po_text_add_bytes(&text, bytes, got);
  const bool broken = ferror(file);
  fclose(file);
  if (broken)
    po_text_clear(&text);
  if (broken)
    return po_fail(PO_CANNOT_READ, "%s cannot be read: %s", path, strerror(errno));
  *size = text.length;
  *data = po_text_take(&text);
  return *data ? PO_OK : PO_NO_MEMORY;
}

po_status po_file_write(const char *path, const char *data, size_t size) {
  if (po_no_memory_or(PO_OK))
    return PO_NO_MEMORY;
  FILE *file = open_file(path, L"wb");
  const bool written = file && fwrite(data, 1, size, file) == size;
  if ((file && fclose(file) != 0) || !written)
    return po_fail(PO_CANNOT_WRITE, "%s cannot be written: %s", path, strerror(errno));
  return PO_OK;
}

/* No name of a file is that of a pipe that a shell made. */
uint64_t po_path_pipe(const char *path) {
  (void)path;
  return 0;
}

/* The C library has no memory of another alignment that free() frees. */
void *po_machine_allocate(size_t alignment, size_t bytes) {
  (void)alignment;
  return malloc(bytes);
}

double po_machine_memory(void) {
  MEMORYSTATUSEX memory = {.dwLength = sizeof memory};
  GlobalMemoryStatusEx(&memory);
  return (double)memory.ullTotalPhys;
}

/* A thread has a locale of its own only in this mode, and then a name of it. */
typedef struct {
  int mode;
  char name[];
} locale_before;

bool po_machine_plain_locale(void **before) {
  const int mode = _configthreadlocale(_ENABLE_PER_THREAD_LOCALE);
  const char *name = setlocale(LC_ALL, NULL);
  locale_before *kept = malloc(sizeof *kept + strlen(name) + 1);
  *before = kept;
  if (kept) {
    kept->mode = mode;
    strcpy(kept->name, name);
    setlocale(LC_ALL, "C");
  } else {
    _configthreadlocale(mode);
  }
  return kept;
}

void po_machine_set_locale(void *before) {
  locale_before *kept = before;
  setlocale(LC_ALL, kept->name);
  _configthreadlocale(kept->mode);
  free(kept);
}
