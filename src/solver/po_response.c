#include "po_response.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

const size_t PO_RESPONSE_BYTES = (size_t)256 << 20, PO_RESPONSE_LINE = (size_t)32 << 20;

static bool refuse(po_response *response, const char *why) {
  if (!response->wrong[0])
    snprintf(response->wrong, sizeof response->wrong, "%s", why);
  return false;
}

static bool open_file(po_response *response) {
  struct stat found;
  response->file = open(response->path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (response->file < 0)
    return errno == ENOENT ||
           refuse(response, "the response cannot be opened, or is a symbolic link");
  if (fstat(response->file, &found) != 0 || !S_ISREG(found.st_mode)) {
    close(response->file);
    response->file = -1;
    return refuse(response, "the response is not a regular file");
  }
  return true;
}

/* Removes the lines that were taken. */
static void drop_taken(po_response *response) {
  po_text *p = &response->pending;
  if (!response->taken)
    return;
  memmove(p->data, p->data + response->taken, p->length - response->taken + 1);
  p->length -= response->taken;
  response->taken = 0;
}

bool po_response_read(po_response *response) {
  char bytes[1 << 14];
  struct stat found;
  if (response->wrong[0] || (response->file < 0 && !open_file(response)))
    return false;
  if (response->file < 0)
    return true;
  if (fstat(response->file, &found) == 0 && found.st_size < (off_t)response->read)
    return refuse(response, "the response became shorter: expected that lines are only added");
  drop_taken(response);
  for (;;) {
    const ssize_t got = pread(response->file, bytes, sizeof bytes, (off_t)response->read);
    if (got < 0 && errno == EINTR)
      continue;
    if (got <= 0)
      return !response->pending.failed;
    response->read += (size_t)got;
    po_text_add_bytes(&response->pending, bytes, (size_t)got);
    if (response->read > PO_RESPONSE_BYTES)
      return refuse(response, "the response has more than 256 MB");
    if (memchr(bytes, '\n', (size_t)got))
      return !response->pending.failed; /* first take these lines */
    if (response->pending.length > PO_RESPONSE_LINE)
      return refuse(response, "a line of the response has more than 32 MB");
  }
}

const char *po_response_line(po_response *response, bool last, size_t *length) {
  po_text *p = &response->pending;
  for (;;) {
    char *begin = p->data ? p->data + response->taken : NULL;
    const size_t left = p->length - response->taken;
    char *end = left ? memchr(begin, '\n', left) : NULL;
    if (!end && !(last && left))
      return NULL;
    *length = end ? (size_t)(end - begin) : left;
    response->taken += *length + (end != NULL);
    if (end)
      *end = '\0';
    if (strspn(begin, " \t\r") < *length || memchr(begin, '\0', *length))
      return begin;
  }
}

void po_response_close(po_response *response) {
  if (response->file >= 0)
    close(response->file);
  response->file = -1;
  po_text_clear(&response->pending);
}
