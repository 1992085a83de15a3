#include "po_print_solver.h"

#include "po_text.h"

void po_print_solver(const po_solver *solver, FILE *stream) {
  po_text command = {0};
  for (unsigned i = 0; i < solver->file->command_count; ++i) {
    po_text_add(&command, "%s", i ? " " : "");
    po_text_add_word(&command, solver->command[i]);
  }
  fprintf(stream, "solver   %s (%s)", solver->name, solver->path);
  if (solver->knob)
    fprintf(stream, ", %s %s", solver->file->knob->name, solver->knob);
  fprintf(stream, "\ncommand  %s\n", po_text_string(&command));
  po_text_clear(&command);
}
