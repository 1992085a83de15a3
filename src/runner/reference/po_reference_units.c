/* Reference tables whose columns are in SI units. */
#include <math.h>
#include <string.h>

#include "po_memory.h"
#include "po_number.h"
#include "po_reference.h"
#include "po_si.h"

/* Whether a name ends in a unit. Keys of the scene such as mie_m do not. Returned: *factor, by
 * which its numbers are divided. */
static bool has_unit(const char *name, const po_units *units, size_t *stem, double *factor) {
  po_dimension dimension = PO_DIMENSION_NONE;
  double size = 0;
  if (po_key_of_name(name) >= 0 || !po_si_parse(name, stem, &dimension, &size))
    return false;
  *factor = po_si_unit_of(units, dimension).factor / size;
  return true;
}

/* The texts of the converted cells, one after the other. */
typedef struct {
  char *next;
} store;

/* Divides the number in a text; a text that is no number, such as -, stays. */
static void convert(char **text, double factor, store *to) {
  double value = 0;
  if (!po_number_parse(*text, &value))
    return;
  po_number_print(value / factor, to->next);
  *text = to->next;
  to->next += PO_NUMBER_LENGTH;
}

static void convert_column(po_csv *table, size_t column, double factor, store *to) {
  for (size_t r = 0; r < table->row_count; ++r)
    convert(&table->cells[r * table->column_count + column], factor, to);
}

/* Reports whether another column has the same name. */
static bool has_twin(const po_csv *table, size_t column) {
  for (size_t c = 0; c < table->column_count; ++c)
    if (c != column && strcmp(table->columns[c], table->columns[column]) == 0)
      return true;
  return false;
}

static const char UNCERTAINTY[] = "uncertainty";

/* Converts an uncertainty without a unit. Given: its column, -1: none; the one factor of all
 * columns, NAN: they differ; first, the first of them, without its unit, which follows its name. */
static po_status convert_uncertainty(po_csv *table, int column, double factor, const char *first,
                                     store *to) {
  po_csv_header *header = (po_csv_header *)po_csv_find_header(table, UNCERTAINTY);
  double value = 0;
  const bool number = header && po_number_parse(header->value, &value) && value != 0.0;
  if (isnan(factor) && (column >= 0 || number))
    return po_fail(PO_CANNOT_READ,
                   "%s:%zu: %s has no unit, and the columns have several: expected columns such as "
                   "%s_uncertainty_%s",
                   table->path, column >= 0 ? table->column_line : header->line, UNCERTAINTY, first,
                   first + strlen(first) + 1);
  if (column >= 0)
    convert_column(table, (size_t)column, factor, to);
  if (number)
    convert(&header->value, factor, to);
  return PO_OK;
}

bool po_reference_has_units(const po_reference *reference) {
  const po_csv *table = &reference->table;
  const po_units any = {.length = 1, .force = 1, .work = 1, .tension = 1, .traction = 1};
  size_t stem = 0;
  double factor = 0;
  for (size_t c = 0; c < table->column_count; ++c)
    if (has_unit(table->columns[c], &any, &stem, &factor))
      return true;
  for (size_t i = 0; i < table->header_count; ++i)
    if (has_unit(table->headers[i].key, &any, &stem, &factor))
      return true;
  return false;
}

po_status po_reference_use_units(po_reference *reference, const po_units *units) {
  po_csv *table = &reference->table;
  size_t stem = 0, cells = table->header_count + table->row_count; /* with an uncertainty */
  double factor = 0, only = 0;                                     /* 0: none yet; NAN: several */
  for (size_t c = 0; c < table->column_count; ++c)
    if (has_unit(table->columns[c], units, &stem, &factor))
      cells += table->row_count;
  reference->converted = po_allocate(cells, PO_NUMBER_LENGTH);
  if (!reference->converted)
    return PO_NO_MEMORY;
  store to = {reference->converted};
  const int uncertainty = po_csv_find_column(table, UNCERTAINTY);
  const char *first = NULL;
  for (size_t c = 0; c < table->column_count; ++c) {
    if (!has_unit(table->columns[c], units, &stem, &factor))
      continue;
    table->columns[c][stem] = '\0';
    if (has_twin(table, c))
      return po_fail(PO_CANNOT_READ, "%s:%zu: the column %s is given twice, in two units",
                     table->path, table->column_line, table->columns[c]);
    if (po_key_of_name(table->columns[c]) < 0) { /* not of a key, which has no uncertainty */
      only = only == 0 || only == factor ? factor : (double)NAN;
      first = first ? first : table->columns[c];
    }
    convert_column(table, c, factor, &to);
  }
  for (size_t i = 0; i < table->header_count; ++i)
    if (has_unit(table->headers[i].key, units, &stem, &factor)) {
      table->headers[i].key[stem] = '\0';
      convert(&table->headers[i].value, factor, &to);
    }
  return only == 0 ? PO_OK : convert_uncertainty(table, uncertainty, only, first, &to);
}
