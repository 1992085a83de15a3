#include "po_plot_verb.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "po_environment.h"
#include "po_file.h"
#include "po_options.h"
#include "po_plot.h"

po_status po_plot_take_file(const char *text, const char **file) {
  *file = text;
  return po_plot_is_figure(text)
             ? PO_OK
             : po_options_refuse("plot", text,
                                 "the name of a file that ends in .svg, .png or .pdf");
}

po_status po_plot_with(const po_text *script, const char *name, const char *file) {
  char *figures = po_path_join(po_environment_data(), "reports/figures");
  const po_status status = figures ? po_plot_draw(script, figures, name, file) : PO_NO_MEMORY;
  free(figures);
  return status;
}

po_status po_plot_to_file(const po_request *request, const po_result *result, const char *file) {
  po_text script = {0};
  po_status status = po_plot_solve(request, result, &script);
  if (!status)
    status = po_plot_with(&script, "solve.gp", file);
  po_text_clear(&script);
  return status;
}

void po_plot_size(size_t *columns, size_t *rows) {
  enum { COLUMNS = 66, ROWS = 21, BESIDE = 14, BELOW = 5, LEAST = 20 };
  struct winsize window;
  *columns = COLUMNS;
  *rows = ROWS;
  if (isatty(STDOUT_FILENO) && ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col &&
      window.ws_row) {
    *columns = window.ws_col > LEAST + BESIDE ? window.ws_col - BESIDE : LEAST;
    *rows = window.ws_row > LEAST + BELOW ? window.ws_row - BELOW : LEAST;
  }
}

po_status po_plot_to_terminal(const po_request *request, const po_result *result) {
  size_t columns, rows;
  po_text text = {0};
  po_plot_size(&columns, &rows);
  const po_status status = po_plot_print(request, result, columns, rows, &text);
  if (!status)
    fputs(po_text_string(&text), stdout);
  po_text_clear(&text);
  return status;
}
