/* Starts an external solver with the command and the environment of its manifest. */
#ifndef PO_LAUNCH_H
#define PO_LAUNCH_H

#include "po_ask_folder.h"
#include "po_process.h"

/* Given: `folder`, in which the process runs. Status: see po_process_start; PO_NO_MEMORY. */
po_status po_launch(const po_solver *solver, const po_ask_folder *folder, po_process *process);

#endif
