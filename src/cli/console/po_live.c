#include "po_live.h"

#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

#include "po_deadline.h"

/* Seconds before the first line, and between lines. */
static const double FIRST = 1, TERMINAL_INTERVAL = 0.2, PLAIN_INTERVAL = 10;

po_live po_live_begin(bool plain) {
  const double now = po_clock_wall();
  return (po_live){
      .is_terminal = isatty(STDERR_FILENO) == 1, .plain = plain, .begin = now, .last = now};
}

/* Returned: whether a line is due. */
static bool is_due(const po_live *live) {
  if (!live->is_terminal && !live->plain)
    return false;
  const double now = po_clock_wall();
  return now - live->begin > FIRST &&
         now - live->last > (live->is_terminal ? TERMINAL_INTERVAL : PLAIN_INTERVAL);
}

void po_live_end(po_live *live) {
  if (live->width)
    fprintf(stderr, "\r%*s\r", (int)live->width, "");
  live->width = 0;
}

void po_live_show(po_live *live, const char *format, ...) {
  char line[120];
  va_list arguments;
  if (!is_due(live))
    return;
  va_start(arguments, format);
  vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  po_live_end(live);
  live->last = po_clock_wall();
  const int width = fprintf(stderr, "%.60s, %.0f s elapsed", line, live->last - live->begin);
  if (live->is_terminal)
    live->width = width > 0 ? (size_t)width : 0;
  else
    fputc('\n', stderr);
}

static volatile sig_atomic_t interrupted;

static void note_signal(int number) {
  (void)number;
  interrupted = 1;
}

const volatile sig_atomic_t *po_interrupt_listen(void) {
  struct sigaction action = {.sa_handler = note_signal, .sa_flags = (int)SA_RESETHAND | SA_RESTART};
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, NULL);
  sigaction(SIGTERM, &action, NULL);
  return &interrupted;
}
