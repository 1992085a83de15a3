/* Prints results on standard output: of one solve, as text or JSON, and any JSON document. */
#ifndef PO_PRINT_H
#define PO_PRINT_H

#include <stdio.h>

#include "po_case.h"
#include "po_json_value.h"
#include "po_physical.h"
#include "po_request.h"
#include "po_result.h"
#include "po_solver.h"
#include "po_texts.h"

/* Prints a document and releases it. A document is NULL if memory ran out while it was built; the
 * status is then PO_NO_MEMORY. */
po_status po_print_document(json_t *document);

/* Prints the line with the digest of a document, as po_print_document prints it, and releases the
 * document. Status: PO_NO_MEMORY. */
po_status po_print_digest(json_t *document);

/* Prints the document of schema "pulloff/1". It has the block `physical` if the scene was given in
 * SI units. */
po_status po_print_json(const po_request *request, const po_texts *given, const po_result *result);

/* Prints the name of an external solver, its manifest, the value of its knob, and its command. */
void po_print_solver(const po_solver *solver, FILE *stream);

/* Prints the scene, the units, the status and the pull-off with its errors. */
void po_print_summary(const po_request *request, const po_result *result);

/* Prints the result as text for the terminal. */
po_status po_print_text(const po_request *request, const po_texts *given, const po_result *result);

/* {"input": {"modulus_pa", "work_j_per_m2", "distance_m", "radius_m", ...}, "units": {"length_m",
 * "force_n", "traction_pa"}}: the options that were given, and the units by which dimensionless
 * numbers are multiplied. */
json_t *po_json_physical_input(const po_texts *given, const po_units *units);

/* The same object with "pull_off", "folds", "extrema" and, if they are wanted, "curve",
 * "profile" and "theories". */
json_t *po_json_physical(const po_texts *given, const po_request *request, const po_result *result);

/* The same input as text for the terminal. */
void po_print_physical_input(const po_texts *given);

/* -- Parts of po_print_text -- */

/* The input and the results in SI units, for scenes given with --from-physical. */
void po_print_physical(const po_texts *given, const po_request *request, const po_result *result);

/* The pull-off and its errors in SI units, if there is one. */
void po_print_physical_pull_off(const po_units *units, const po_result *result);

/* A line for each source of uncertainty of the pull-off force, and one for all. Given: the unit of
 * the force, as a factor and by name. */
void po_print_uncertain(const po_result *result, double unit, const char *name);

/* The loops and the staircases of the result, of the JKR theory, too, and the sizes of the results
 * that are too long for the terminal: in SI units if the scene is. */
void po_print_loading(const po_request *request, const po_result *result);

/* A change in percent: rounded to 1e-4, so that a derivative that vanishes is printed as 0. */
double po_print_percent(double change);

/* An error with two digits; empty if none was estimated. */
const char *po_print_error(double error, char text[16]);

#endif
