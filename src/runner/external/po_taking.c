#include "po_taking.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "po_memory.h"
#include "po_quote.h"

size_t po_taking_first(const po_taking *t) {
  size_t i = 0;
  while (i < t->count && !t->open[i])
    ++i;
  return i;
}

po_status po_taking_give_up(po_taking *t, size_t question, po_status status, const char *reason) {
  po_answer answer = {.result = po_result_none(), .repeat = 1, .setup = NAN, .solve = NAN};
  answer.result.status = status;
  answer.result.work.seconds = (double)NAN;
  po_quote_text(reason, answer.result.reason, sizeof answer.result.reason);
  t->open[question] = false;
  t->spoiled[question] = t->unusual = true;
  const po_status taken = t->take(t->context, question, &answer, true);
  po_result_clear(&answer.result);
  return taken;
}

/* Returned: the question with an id that the present process was asked; `count`: none. */
static size_t find_question(const po_taking *t, const char *id) {
  size_t i = 0;
  while (i < t->count && !(t->asked[i] && strcmp(t->questions[i].id, id) == 0))
    ++i;
  return i;
}

/* Takes an answer to a known question. */
static po_status take_answer(po_taking *t, size_t q, po_answer *answer) {
  const po_question *question = &t->questions[q];
  const unsigned repeats = question->repeats;
  char reason[80];
  if (t->spoiled[q])
    return PO_OK; /* its status is final */
  if (answer->result.status == PO_INVALID)
    return po_taking_give_up(t, q, PO_INVALID, answer->result.reason);
  if (answer->repeat > repeats) {
    snprintf(reason, sizeof reason, "repeat is %u: expected at most %u", answer->repeat, repeats);
    return po_taking_give_up(t, q, PO_INVALID, reason);
  }
  const unsigned bit = 1U << (answer->repeat - 1);
  if (t->seen[q] & bit) {
    snprintf(reason, sizeof reason, "two answers for repeat %u: expected one", answer->repeat);
    return po_taking_give_up(t, q, PO_INVALID, reason);
  }
  t->seen[q] |= bit;
  t->ever = true;
  /* a failure needs no repetition */
  const bool final = t->seen[q] == (1U << repeats) - 1 || answer->result.status != PO_OK;
  if (final)
    t->open[q] = false;
  return t->take(t->context, q, answer, final);
}

static double reported_by(const po_answer *answer) {
  return (isfinite(answer->setup) ? answer->setup : 0) +
         (isfinite(answer->solve) ? answer->solve : 0);
}

static po_status take_line(po_taking *t, const char *line, size_t length) {
  po_answer answer;
  po_status status = po_answer_read(line, length, &answer);
  const size_t q = find_question(t, answer.id);
  const bool invalid = answer.result.status == PO_INVALID;
  if (!status && q < t->count) {
    po_answer_check(&t->questions[q], &answer);
    t->found.answered += 1;
    t->found.reported += reported_by(&answer);
    status = take_answer(t, q, &answer);
  } else if (!status) {
    t->unusual = true;
    if (!t->complaint[0])
      snprintf(t->complaint, sizeof t->complaint,
               invalid ? "%s" : "an answer has the id %.30s, which was not asked",
               invalid ? answer.result.reason : answer.id);
  }
  po_result_clear(&answer.result);
  return status;
}

/* A response, and the longest line in it, of more bytes end the process. */
static const size_t MOST_BYTES = (size_t)256 << 20, LONGEST_LINE = (size_t)32 << 20;

static bool refuse_line(po_response *response, const char *why) {
  if (!response->wrong[0])
    snprintf(response->wrong, sizeof response->wrong, "%s", why);
  return false;
}

static bool open_file(po_response *response) {
  struct stat found;
  response->file = open(response->path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (response->file < 0)
    return errno == ENOENT ||
           refuse_line(response, "the response cannot be opened, or is a symbolic link");
  if (fstat(response->file, &found) != 0 || !S_ISREG(found.st_mode)) {
    close(response->file);
    response->file = -1;
    return refuse_line(response, "the response is not a regular file");
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

/* Reads what has been added to the file. Returned: false if something is wrong with it, or without
 * memory. */
static bool read_more(po_response *response) {
  char bytes[1 << 14];
  struct stat found;
  if (response->wrong[0] || (response->file < 0 && !open_file(response)))
    return false;
  if (response->file < 0)
    return true;
  if (fstat(response->file, &found) == 0 && found.st_size < (off_t)response->read)
    return refuse_line(response, "the response became shorter: expected that lines are only added");
  drop_taken(response);
  for (;;) {
    const ssize_t got = pread(response->file, bytes, sizeof bytes, (off_t)response->read);
    if (got < 0 && errno == EINTR)
      continue;
    if (got <= 0)
      return !response->pending.failed;
    response->read += (size_t)got;
    po_text_add_bytes(&response->pending, bytes, (size_t)got);
    if (response->read > MOST_BYTES)
      return refuse_line(response, "the response has more than 256 MB");
    if (memchr(bytes, '\n', (size_t)got))
      return !response->pending.failed; /* first take these lines */
    if (response->pending.length > LONGEST_LINE)
      return refuse_line(response, "a line of the response has more than 32 MB");
  }
}

/* Returned: the next complete line that is not blank, *length bytes that end with a NUL; NULL if
 * there is none. */
static const char *next_line(po_response *response, bool last, size_t *length) {
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

po_status po_taking_lines(po_taking *t, bool last) {
  po_response *response = &t->response;
  po_status status = PO_OK;
  bool more = true;
  while (!status && more) {
    const size_t before = response->read;
    if (!read_more(response))
      return response->wrong[0] ? PO_OK : PO_NO_MEMORY;
    more = response->read > before;
    size_t length = 0;
    const char *line = NULL;
    while (!status && (line = next_line(response, last && !more, &length))) {
      const size_t mark = t->found.lines ? 0 : po_quote_mark(line);
      line += mark;
      length -= mark;
      t->found.lines += 1;
      status = take_line(t, line, length);
    }
  }
  return status;
}

static void close_response(po_response *response) {
  if (response->file >= 0)
    close(response->file);
  po_text_clear(&response->pending);
}

void po_taking_begin(po_taking *t, const char *response) {
  close_response(&t->response);
  t->response = (po_response){.path = response, .file = -1};
  t->found = (po_taking_count){0};
  t->complaint[0] = '\0';
  t->unusual = false;
  for (size_t q = 0; q < t->count; ++q) {
    t->asked[q] = t->open[q];
    if (t->open[q])
      t->seen[q] = 0;
  }
}

po_status po_taking_make(const po_question *questions, size_t count, po_answer_taker *take,
                         void *context, po_taking *t) {
  *t = (po_taking){.questions = questions,
                   .count = count,
                   .take = take,
                   .context = context,
                   .response.file = -1,
                   .open = po_allocate(count, sizeof(bool)),
                   .asked = po_allocate(count, sizeof(bool)),
                   .seen = po_allocate(count, sizeof(unsigned)),
                   .spoiled = po_allocate(count, sizeof(bool))};
  if (!(t->open && t->asked && t->seen && t->spoiled))
    return PO_NO_MEMORY;
  for (size_t i = 0; i < count; ++i)
    t->open[i] = true;
  return PO_OK;
}

void po_taking_clear(po_taking *t) {
  close_response(&t->response);
  free(t->open);
  free(t->asked);
  free(t->seen);
  free(t->spoiled);
  *t = (po_taking){.response.file = -1};
}
