#include "po_interrupt.h"

static volatile sig_atomic_t interrupted;

static void hear(int number) {
  (void)number;
  interrupted = 1;
}

const volatile sig_atomic_t *po_interrupt_listen(void) {
  struct sigaction action = {.sa_handler = hear, .sa_flags = (int)SA_RESETHAND | SA_RESTART};
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, NULL);
  sigaction(SIGTERM, &action, NULL);
  return &interrupted;
}
