/* The visitor of a trace. It gives each point to the parts that read the branch: the points
 * (po_trace_points.h), the special points and the pull-off (po_special_list.h), the profile
 * (po_contact_profile.h), what is diagnosed (po_kept.h, po_balance.h, po_reverse_trace.h), and the
 * stopping rule (po_stopping.h); and ends the trace where one of these, the user or the time limit
 * asks for it. */
#ifndef PO_READER_H
#define PO_READER_H

#include "po_balance.h"
#include "po_branch_point.h"
#include "po_estimate.h"
#include "po_kept.h"
#include "po_request.h"
#include "po_result.h"
#include "po_special_list.h"
#include "po_stopping.h"
#include "po_trace_points.h"

/* Who keeps minima of the load and folds, for more than the result says of them. */
typedef struct {
  void (*begin)(void *data, double tolerance); /* a trace begins, forget those of others */
  /* Given: the margin of the stopping rule there. Returned: false: no memory */
  bool (*special)(void *data, const po_branch_point *point, double margin);
  void *data;
  bool minima_only; /* nobody asks for the errors of folds */
} po_keeper;

typedef struct {
  const po_request *request;
  const po_surface *surface; /* nodes only when rigid */
  po_result *result;
  const po_keeper *keeper; /* NULL: none */
  po_balance *balance;     /* of the energy; NULL unless diagnostics are wanted */
  po_kept *kept;           /* states for diagnosis; likewise */
  po_passage *out, *back;  /* special points of the way out and back; likewise */
  double begin;            /* points at a smaller approach are not recorded before it is reached */
  bool begun;
  po_stopping stopping;
  po_trace_points points;
  po_special_list special;
  size_t most_nodes; /* of the surface so far */
  double deadline;   /* on po_clock_thread; INFINITY: none */
  po_status status;
} po_reader;

/* Sets what a trace begins with, and frees what it leaves. */
po_reader po_reader_begin(const po_request *request, po_result *result, double deadline);
void po_reader_end(po_reader *reader);

/* A po_branch_visit; data is the reader. Ends the trace when stopped, past the deadline, out of
 * memory, at trouble, or (without an approach_end) once it was pressed enough, and as far as the
 * preload. */
bool po_reader_visit(const po_branch_point *point, void *data);

/* The same on the reverse trace: data is the reader. Ends the trace when stopped, past the
 * deadline, or out of memory. */
bool po_reader_visit_back(const po_branch_point *point, void *data);

#endif
