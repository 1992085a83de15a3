#include "po_progress.h"

#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

#include "po_clock.h"

/* Least time between separate lines in seconds, so that a log does not become long. */
static const double PLAIN_INTERVAL = 2;

static void clear_line(po_progress *progress) {
  if (progress->width)
    fprintf(stderr, "\r%*s\r", (int)progress->width, "");
  progress->width = 0;
}

static void span(double seconds, char text[32]) {
  if (seconds < 90)
    snprintf(text, 32, "%.0f s", seconds);
  else
    snprintf(text, 32, "%.0f min %02d s", (seconds - (double)((int)seconds % 60)) / 60,
             (int)seconds % 60);
}

static void show(po_progress *progress, const char *what) {
  char elapsed[32], remaining[32], line[160];
  const double seconds = po_clock_wall() - progress->begin;
  span(seconds, elapsed);
  span(progress->done ? seconds * (progress->effort / progress->spent - 1) : 0, remaining);
  const int width =
      progress->done
          ? snprintf(line, sizeof line, "%zu/%zu solves, %s elapsed, about %s remaining (%.60s)",
                     progress->done, progress->total, elapsed, remaining, what)
          : snprintf(line, sizeof line, "0/%zu solves", progress->total);
  clear_line(progress);
  fprintf(stderr, progress->live ? "%s" : "%s\n", line);
  progress->width = progress->live ? (size_t)width : 0;
  progress->last = po_clock_wall();
}

void po_progress_begin(po_progress *progress, size_t total, double effort) {
  const double now = po_clock_wall();
  *progress = (po_progress){.live = isatty(STDERR_FILENO) == 1,
                            .total = total,
                            .effort = effort,
                            .begin = now,
                            .last = now};
  if (total && progress->live)
    show(progress, "");
}

void po_progress_step(po_progress *progress, const char *what, double effort) {
  progress->done += 1;
  progress->spent += effort;
  if (progress->live || po_clock_wall() - progress->last > PLAIN_INTERVAL)
    show(progress, what);
}

void po_progress_say(po_progress *progress, const char *format, ...) {
  clear_line(progress);
  va_list arguments;
  va_start(arguments, format);
  vfprintf(stderr, format, arguments);
  va_end(arguments);
  fputc('\n', stderr);
  progress->last = po_clock_wall();
}

void po_progress_end(po_progress *progress) {
  clear_line(progress);
}
