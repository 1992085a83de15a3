/* Curves, profiles, staircases and loops as CSV tables. */
#ifndef PO_TABLES_H
#define PO_TABLES_H

#include "po_input.h"
#include "po_physical.h"
#include "po_request.h"
#include "po_result.h"
#include "po_status.h"

/* Tables of lists of a result: the branch, the profile, the steps of all staircases, and the states
 * of the loop that a test records: that through the spring, without one that at given approach. */
typedef enum { PO_PROFILE_TABLE, PO_CURVE_TABLE, PO_STAIRCASE_TABLE, PO_LOOP_TABLE,
               PO_HISTORY_TABLE } po_table;

/* Writes a table. The branch has the columns position, approach, load, energy, contact_radius,
 * approach_rate, load_rate, unstable_modes and energy_error, with a spring unstable_modes_at_base;
 * the profile at result->profile_approach radius, gap and traction; a step of a
 * staircase control, from_approach, from_load, until_approach, until_load, open, force,
 * force_error, approach, approach_error, energy_lost and energy_lost_error; a state of a loop
 * phase, jump, base, approach, indentation, load, contact_radius, stiffness and energy_lost; a state of
 * the history of a viscoelastic body time, moved, base, approach, load, contact_radius, stored,
 * adhesive, spring, work, dissipated and jumps. Tables
 * of a request in SI units have no columns in the metric of the solver, and the unit at the end of
 * each name: approach_nm. The headers state the scene, the units and the checksum of all other
 * lines. The path
 * "-" is standard output. Returned: digest, that checksum, unless it is NULL. Status:
 * PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_tables_write(po_table table, const char *path, const po_request *request,
                          const po_result *result, char *digest);

/* Writes the smoothed table of the profile at its rows, in the unit of the file, with the columns
 * r, gap and removed: what the row had more. Otherwise as po_tables_write. */
po_status po_tables_write_smoothed(const char *path, const po_request *request);

/* Writes the pull-offs of a series, one scene in each row, with the columns KEY, force,
 * force_error, approach, approach_error, contact_radius, contact_radius_error and followed (0:
 * traced); nan where a scene has no pull-off. All rows have the prefixes of the first scene. Given:
 * the name of the parameter and its values. Otherwise as po_tables_write. */
po_status po_tables_write_series(const char *path, const char *key, const double *values,
                                 const po_request *requests, const po_result *results,
                                 size_t count);

/* Writes lines of a header and rows, which begin with the line of column names, as a table with a
 * checksum. The path "-" is standard output. Status: PO_CANNOT_WRITE, PO_NO_MEMORY. */
po_status po_tables_write_rows(const char *path, const po_text *header, const po_text *rows);

#endif
