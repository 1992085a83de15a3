/* What the machine does: rates that bound those of the solver (roofline). */
#ifndef MACHINE_H
#define MACHINE_H

#include "po_status.h"

/* Rounds of a measurement, of which the median counts, and the processor time of each, s. */
enum { ROUNDS = 5 };
extern const double LEAST_TIME;

/* The median time of one call of a function, s, measured with as many calls in a round as take
 * LEAST_TIME. */
double median_time(void (*call)(void *data), void *data);

typedef struct {
  double in_double, in_single; /* operations a second: products of two square matrices */
  double memory;               /* bytes a second: a matrix of 128 MiB times a vector */
} machine_rates;

/* One thread. Status: PO_NO_MEMORY. */
po_status machine_measure(machine_rates *rates);

#endif
