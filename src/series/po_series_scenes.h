/* The scenes of a line, for what follows special points along it. */
#ifndef PO_SERIES_SCENES_H
#define PO_SERIES_SCENES_H

#include "po_follow.h"
#include "po_request.h"
#include "po_result.h"

/* The parameter of a scene is its number on the line. */
typedef struct {
  const po_request *requests;
  po_result *results;
  size_t count;
} po_series_scenes;

/* Whether nothing but numbers of the scene differ, and only what can be followed is wanted. */
bool po_series_alike(const po_request *a, const po_request *b);

/* A follower for the scenes from one to another, in whichever is the more demanding, to a
 * tolerance; it begins at the first. Status: PO_NO_MEMORY. */
po_status po_series_follower(const po_series_scenes *l, size_t first, size_t last, double tolerance,
                             po_follower **follower);

/* Whether the contact of a followed special point reaches the end of the core of its surface, so
 * that a trace would enlarge the core. Given: the radius of the domain of the panels. */
bool po_series_is_cut_off(const po_request *request, double domain, const po_branch_point *special);

/* What a follower had done when it was last asked. */
typedef struct {
  po_solve_work work;
  uint64_t kernel;
} po_series_work;

/* Adds what it did since, in so many seconds. */
void po_series_add_work(const po_follower *follower, double seconds, po_series_work *before,
                        po_work *work);

#endif
