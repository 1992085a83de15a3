/* How the functions of the library begin and end. */
#include <gsl/gsl_errno.h>
#include <stdio.h>

#include "po_library.h"
#include "po_lock.h"
#include "po_machine.h"

static int users; /* threads between enter and leave */
static gsl_error_handler_t *handler;

/* The first thread changes the state of the process. */
static void begin_use(void) {
  po_lock_take(PO_LOCK_CALLS);
  if (users == 0)
    handler = gsl_set_error_handler_off();
  users += 1;
  po_lock_release(PO_LOCK_CALLS);
}

/* The last thread restores it. */
static void end_use(void) {
  po_lock_take(PO_LOCK_CALLS);
  users -= 1;
  if (users == 0)
    gsl_set_error_handler(handler);
  po_lock_release(PO_LOCK_CALLS);
}

po_status po_library_enter(po_library_call *call) {
  po_message_clear();
  po_no_memory_forget();
  call->entered = false;
  if (!po_machine_plain_locale(&call->locale))
    return po_fail(PO_NO_MEMORY, "out of memory for the locale C");
  begin_use();
  call->entered = true;
  fegetenv(&call->floating_point);
  fesetenv(FE_DFL_ENV);
  return PO_OK;
}

pulloff_status po_library_end(po_status status, pulloff_message *message) {
  if (message)
    snprintf(message->text, sizeof message->text, "%s",
             !status         ? ""
             : *po_message() ? po_message()
                             : po_status_text(status));
  return (pulloff_status)status;
}

pulloff_status po_library_leave(const po_library_call *call, po_status status,
                                pulloff_message *message) {
  if (call->entered) {
    fesetenv(&call->floating_point);
    po_machine_set_locale(call->locale);
    end_use();
  }
  return po_library_end(status, message);
}
