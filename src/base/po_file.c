#include "po_file.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "po_memory.h"
#include "po_text.h"

/* Far above the size of any case, reference or record; prevents a device or a wrong file from
 * filling the memory. */
static const size_t LONGEST_FILE = (size_t)256 << 20;

/* Seconds in which another program has to open the other end of a pipe. */
enum { LONGEST_WAIT = 5 };

/* Reads to the end. A pipe is read as long as a program writes it; one that nobody has opened for
 * writing may be opened yet. */
static po_status read_descriptor(int file, const char *path, po_text *text) {
  char bytes[1 << 14];
  struct stat found;
  struct pollfd wait = {.fd = file, .events = POLLIN};
  bool awaited = fstat(file, &found) == 0 && S_ISFIFO(found.st_mode);
  po_text_add(text, "%s", "");
  while (!text->failed) {
    const ssize_t got = read(file, bytes, sizeof bytes);
    if (got < 0 && errno == EAGAIN)
      (void)poll(&wait, 1, -1);
    else if (got < 0 && errno != EINTR)
      return po_fail(PO_CANNOT_READ, "%s cannot be read: %s", path, strerror(errno));
    if (got == 0 && !awaited)
      break;
    if (got == 0 && poll(&wait, 1, 1000 * LONGEST_WAIT) == 0)
      return po_fail(PO_CANNOT_READ,
                     "%s is a pipe that no program has opened for writing in %d s: expected a "
                     "file, or a pipe with a writer, which is read once",
                     path, LONGEST_WAIT);
    awaited = awaited && got < 0;
    if (got > 0)
      po_text_add_bytes(text, bytes, (size_t)got);
    if (text->length > LONGEST_FILE)
      return po_fail(PO_CANNOT_READ, "%s is longer than %zu bytes", path, LONGEST_FILE);
  }
  return text->failed ? PO_NO_MEMORY : PO_OK;
}

po_status po_file_read(const char *path, char **data, size_t *size) {
  const int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0)
    return po_fail(PO_CANNOT_READ, "%s cannot be opened: %s", path, strerror(errno));
  po_text text = {0};
  const po_status status = read_descriptor(file, path, &text);
  close(file);
  if (status) {
    po_text_clear(&text);
    return status;
  }
  *data = text.data;
  *size = text.length;
  return PO_OK;
}

static int write_all(int file, const char *data, size_t size) {
  while (size > 0) {
    const ssize_t put = write(file, data, size);
    if (put < 0 && errno == EINTR)
      continue;
    if (put < 0)
      return errno;
    data += put;
    size -= (size_t)put;
  }
  return 0;
}

/* Writes and closes a file. Returned: 0 or the errno. A disk may report that it is full only at
 * fsync or close. */
static int write_and_close(int file, const char *data, size_t size, bool flush) {
  int error = write_all(file, data, size);
  if (!error && flush && fsync(file) != 0)
    error = errno;
  if (close(file) != 0 && !error)
    error = errno;
  return error;
}

/* Opens a pipe or a device for writing. A pipe without a reader cannot be opened. Returned: the
 * descriptor, or -1 and the errno. */
static int open_in_place(const char *path) {
  const struct timespec pause = {.tv_nsec = 100000000};
  for (int tenths = 10 * LONGEST_WAIT;; --tenths) {
    const int file = open(path, O_WRONLY | O_CLOEXEC | O_NONBLOCK);
    if (file >= 0)
      (void)fcntl(file, F_SETFL, 0); /* writes wait until the pipe has room */
    if (file >= 0 || errno != ENXIO || tenths == 0)
      return file;
    nanosleep(&pause, NULL);
  }
}

static po_status write_in_place(const char *path, const char *data, size_t size) {
  const int file = open_in_place(path);
  const int error = file < 0 ? errno : write_and_close(file, data, size, false);
  if (file < 0 && error == ENXIO)
    return po_fail(PO_CANNOT_WRITE, "%s cannot be written: no program has opened it for reading",
                   path);
  if (error)
    return po_fail(PO_CANNOT_WRITE, "%s cannot be written: %s", path, strerror(error));
  return PO_OK;
}

/* Resolves symbolic links. The target need not exist. Returned: 0 or the errno. */
static int follow_links(const char *path, char target[PATH_MAX]) {
  enum { MOST_LINKS = 40 }; /* the limit of Linux */
  size_t length = (size_t)snprintf(target, PATH_MAX, "%s", path);
  for (int links = 0; links <= MOST_LINKS && length < PATH_MAX; ++links) {
    char link[PATH_MAX];
    const ssize_t got = readlink(target, link, sizeof link - 1);
    if (got < 0)
      return 0; /* `target` is not a link, or does not exist */
    link[got] = '\0';
    const char *name = strrchr(target, '/');
    const size_t folder = link[0] == '/' || !name ? 0 : (size_t)(name + 1 - target);
    length = folder + (size_t)snprintf(target + folder, PATH_MAX - folder, "%s", link);
  }
  return length < PATH_MAX ? ELOOP : ENAMETOOLONG;
}

/* Writes a temporary file and renames it. Given: found, the attributes of the existing file, or
 * NULL. */
static po_status write_beside(const char *path, const struct stat *found, const char *data,
                              size_t size) {
  char target[PATH_MAX], beside[PATH_MAX];
  const int lost = follow_links(path, target);
  if (lost)
    return po_fail(PO_CANNOT_WRITE, "%s cannot be written: %s", path, strerror(lost));
  if (snprintf(beside, sizeof beside, "%s.part-%ld", target, (long)getpid()) >= (int)sizeof beside)
    return po_fail(PO_CANNOT_WRITE, "%s cannot be written: the name is too long", path);
  const int file = open(beside, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0)
    return po_fail(PO_CANNOT_WRITE, "%s cannot be written: %s", path, strerror(errno));
  if (found)
    (void)fchmod(file, found->st_mode & 07777); /* a new file has the default permissions */
  int error = write_and_close(file, data, size, true);
  if (!error && rename(beside, target) != 0)
    error = errno;
  if (error) {
    unlink(beside);
    return po_fail(PO_CANNOT_WRITE, "%s cannot be written: %s", path, strerror(error));
  }
  return PO_OK;
}

po_status po_file_write(const char *path, const char *data, size_t size) {
  struct stat found;
  if (po_no_memory_or(PO_OK))
    return PO_NO_MEMORY;
  const bool there = stat(path, &found) == 0;
  if (there && !S_ISREG(found.st_mode) && !S_ISDIR(found.st_mode))
    return write_in_place(path, data, size);
  return write_beside(path, there ? &found : NULL, data, size);
}

po_status po_folder_make(const char *path) {
  char part[PATH_MAX];
  const size_t length = strlen(path);
  if (length == 0 || length >= sizeof part)
    return po_fail(PO_CANNOT_WRITE, "the folder '%s' cannot be created: its name is %s", path,
                   length ? "too long" : "empty");
  memcpy(part, path, length + 1);
  for (size_t i = 1; i <= length; ++i) {
    if (path[i] != '/' && path[i] != '\0')
      continue;
    part[i] = '\0';
    struct stat found;
    if (mkdir(part, 0777) != 0) {
      const int error =
          errno == EEXIST && stat(part, &found) == 0 && !S_ISDIR(found.st_mode) ? ENOTDIR : errno;
      if (error != EEXIST)
        return po_fail(PO_CANNOT_WRITE, "the folder %s cannot be created: %s: %s", path, part,
                       strerror(error));
    }
    part[i] = path[i];
  }
  return PO_OK;
}

bool po_path_exists(const char *path) {
  struct stat found;
  return stat(path, &found) == 0;
}

uint64_t po_path_pipe(const char *path) {
  struct stat found;
  if (stat(path, &found) != 0 || !S_ISFIFO(found.st_mode))
    return 0;
  char *named = realpath(path, NULL);
  free(named);
  return named ? 0 : found.st_ino;
}

bool po_path_is_same(const char *a, const char *b) {
  struct stat x, y;
  return stat(a, &x) == 0 && stat(b, &y) == 0 && x.st_dev == y.st_dev && x.st_ino == y.st_ino;
}

po_file_path po_path_join(const char *folder, const char *name) {
  const size_t length = name[0] == '/' ? 0 : strlen(folder);
  const bool slash = length && folder[length - 1] != '/';
  po_file_path path;
  snprintf(path.text, sizeof path.text, "%.*s%s%s", (int)length, folder, slash ? "/" : "", name);
  return path;
}

po_file_path po_program_find(const char *name) {
  po_file_path path = po_path_join("", name);
  const bool has_slash = strchr(name, '/');
  const char *rest = has_slash ? NULL : getenv("PATH");
  if (has_slash && access(name, X_OK) == 0)
    return path;
  for (size_t length; rest && *rest; rest += length + (rest[length] == ':')) {
    length = strcspn(rest, ":");
    snprintf(path.text, sizeof path.text, "%.*s/%s", (int)length, rest, name);
    if (access(path.text, X_OK) == 0)
      return path;
  }
  return (po_file_path){""};
}

static int name_order(const void *a, const void *b) {
  return strcmp(*(char *const *)a, *(char *const *)b);
}

static po_status names_add(char ***names, size_t *count, const char *name) {
  char **larger = po_resize(*names, *count + 1, sizeof **names);
  if (!larger)
    return PO_NO_MEMORY;
  *names = larger;
  larger[*count] = po_copy_text(name);
  if (!larger[*count])
    return PO_NO_MEMORY;
  *count += 1;
  return PO_OK;
}

po_status po_folder_list(const char *path, const char *ending, char ***names, size_t *count) {
  *names = NULL;
  *count = 0;
  DIR *folder = opendir(path);
  if (!folder)
    return po_fail(PO_CANNOT_READ, "the folder %s cannot be read: %s", path, strerror(errno));
  po_status status = PO_OK;
  const size_t tail = strlen(ending);
  for (struct dirent *entry; !status && (entry = readdir(folder));) {
    const size_t length = strlen(entry->d_name);
    if (entry->d_name[0] != '.' && length > tail &&
        strcmp(entry->d_name + length - tail, ending) == 0)
      status = names_add(names, count, entry->d_name);
  }
  closedir(folder);
  if (status) {
    po_names_free(*names, *count);
    *names = NULL;
    *count = 0;
  } else if (*count)
    qsort(*names, *count, sizeof **names, name_order);
  return status;
}

void po_names_free(char **names, size_t count) {
  for (size_t i = 0; i < count; ++i)
    free(names[i]);
  free(names);
}
