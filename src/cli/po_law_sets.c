#include "po_law_sets.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "po_csv.h"
#include "po_deadline.h"
#include "po_environment.h"
#include "po_file.h"
#include "po_key_table.h"
#include "po_law_store.h"
#include "po_live.h"
#include "po_memory.h"
#include "po_number.h"

enum { MESSAGE = 512, FILE_NAME = PO_LAW_NAME_MOST + 32 };

/* What is known of a row. */
typedef struct {
  po_status status; /* PO_INTERRUPTED: it was not reached */
  po_particle_numbers numbers;
  double error, parabola_excess, seconds;
  double length, force; /* the units of the numbers */
  char file[FILE_NAME]; /* "": none */
  char reason[MESSAGE]; /* "": none */
} law_row;

typedef struct {
  const po_law_line *line;
  po_csv table;
  int *keys; /* of the columns */
  law_row *rows;
  po_law_store store;
  size_t done, kept; /* kept: of a command before */
  bool broken;       /* by a file that cannot be written, or without memory */
  po_status status;
  char message[MESSAGE];
  po_live live;
} sets;

static bool must_end(const sets *s) {
  bool broken;
#pragma omp atomic read
  broken = s->broken;
  return broken || *s->line->request.stop;
}

/* Refuses columns that the verb does not take, or that are given twice. */
static po_status check_columns(const sets *s) {
  for (size_t c = 0; c < s->table.column_count; ++c) {
    const int key = s->keys[c];
    const char *column = s->table.columns[c];
    char flag[PO_FLAG_LENGTH];
    po_key_flag(key, flag);
    if (!(PO_KEYS[key].verbs & PO_FOR_COMPARE) && !po_key_is_group(key))
      return po_fail(PO_BAD_INPUT,
                     "%s:%zu: the column %s has no effect on a law: expected names of options of "
                     "contact-law, such as tabor or radius_m",
                     s->table.path, s->table.column_line, column);
    if (PO_KEYS[key].owner == PO_OWNER_SI && !s->line->scene.given.si)
      return po_fail(PO_BAD_INPUT,
                     "%s:%zu: the column %s is in SI units: expected --from-physical beside --sets",
                     s->table.path, s->table.column_line, column);
    if (s->line->scene.given.text[key])
      return po_fail(PO_BAD_INPUT, "%s:%zu: the column %s is given, too: expected it or --%s",
                     s->table.path, s->table.column_line, column, flag);
  }
  return PO_OK;
}

static po_status open_sets(sets *s) {
  po_status status = po_csv_read(s->line->sets, s->line->sets, &s->table);
  if (status)
    return status;
  s->keys = po_allocate(s->table.column_count, sizeof *s->keys);
  s->rows = po_allocate(s->table.row_count, sizeof *s->rows);
  if (!s->keys || !s->rows)
    return PO_NO_MEMORY;
  for (size_t k = 0; k < s->table.row_count; ++k)
    s->rows[k] = (law_row){.status = PO_INTERRUPTED, .seconds = NAN};
  status = po_key_table_keys(&s->table, s->keys);
  return status ? status : check_columns(s);
}

/* Adds the cells of a row to the texts of its scene. Returned: false without memory. */
static bool take_cells(const sets *s, size_t k, po_texts *given, char **cells) {
  bool failed = false;
  for (size_t c = 0; c < s->table.column_count; ++c) {
    cells[c] = po_key_table_text(&s->table, k, c, s->keys[c], &failed);
    if (cells[c])
      given->text[s->keys[c]] = cells[c];
  }
  return !failed;
}

/* Writes the name of the function of a row: NAME_ROW, with as many digits for each row. */
static void name_row(const sets *s, size_t k, char *name, size_t size) {
  const int digits = snprintf(NULL, 0, "%zu", s->table.row_count);
  snprintf(name, size, "%s_%0*zu", s->line->name, digits, k + 1);
}

static void name_file(const po_law_line *line, law_row *row) {
  static const char *const ENDINGS[] = {"h", "csv", "table"}; /* of PO_PARTICLE_FORMATS */
  snprintf(row->file, sizeof row->file, "%.*s.%s", FILE_NAME - 8, line->name,
           ENDINGS[line->format]);
}

static void take_stored(const po_law_stored *stored, law_row *row) {
  row->status = stored->status;
  row->numbers = stored->numbers;
  row->error = stored->error;
  row->parabola_excess = stored->parabola_excess;
  row->seconds = stored->seconds;
  snprintf(row->reason, sizeof row->reason, "%s", stored->reason);
}

/* Writes the law of a row and stores it; also that its scene has none, which is found by a solve.
 * Only what depends on nothing but the row and the options is stored. */
static po_status keep_row(const sets *s, const char *key, const po_law_made *made,
                          const law_row *row) {
  const po_law_stored stored = {row->status,          row->numbers, row->error,
                                row->parabola_excess, row->seconds, row->reason};
  po_status status = PO_OK;
  if (row->status && row->status != PO_BAD_INPUT)
    return PO_OK;
  if (!row->status)
    status = po_file_write(po_path_join(s->line->output, row->file).text, made->file.data,
                           made->file.length);
  return status ? status : po_law_store_put(&s->store, key, &stored, &made->file);
}

/* Makes and writes the law of a completed line. Status: as make_row. */
static po_status make_law(const sets *s, const po_law_line *line, const char *key, double begin,
                          law_row *row) {
  po_law_made made = {.numbers = {0}};
  row->status = po_no_memory_or(po_law_line_make(line, &made));
  if (row->status && row->status != PO_INTERRUPTED)
    snprintf(row->reason, sizeof row->reason, "%s", po_message());
  row->numbers = made.numbers;
  row->error = made.error;
  row->parabola_excess = made.parabola_excess;
  row->seconds = po_clock_wall() - begin;
  const po_status status =
      row->status == PO_NO_MEMORY ? PO_NO_MEMORY : keep_row(s, key, &made, row);
  po_law_made_clear(&made);
  return status;
}

/* Takes the law of a row from the folder, or makes and writes it. Returned: *kept, which of both.
 * Status: those that end all: PO_CANNOT_WRITE, PO_NO_MEMORY. */
static po_status make_row(const sets *s, size_t k, bool *kept) {
  law_row *row = &s->rows[k];
  po_law_line line = *s->line;
  po_law_stored stored;
  char name[FILE_NAME], key[PO_DIGEST_LENGTH];
  char **cells = po_allocate(s->table.column_count, sizeof *cells);
  const double begin = po_clock_wall();
  name_row(s, k, name, sizeof name);
  line.name = name;
  line.scene.given.prefix = "";
  name_file(&line, row);
  *kept = false;
  po_status status = cells && take_cells(s, k, &line.scene.given, cells) ? PO_OK : PO_NO_MEMORY;
  if (!status)
    status = po_no_memory_or(po_law_line_complete(&line, false));
  if (!status)
    status = po_law_store_key(&s->store, &line, key);
  row->length = line.request.in_si ? line.request.units.length : 1.0;
  row->force = line.request.in_si ? line.request.units.force : 1.0;
  if (!status && po_law_store_find(&s->store, key, row->file, &stored)) {
    take_stored(&stored, row);
    *kept = true;
  } else if (!status) {
    status = make_law(s, &line, key, begin, row);
  } else if (status != PO_NO_MEMORY) { /* a cell is refused */
    row->status = status;
    snprintf(row->reason, sizeof row->reason, "%s", po_message());
    row->seconds = po_clock_wall() - begin;
    status = PO_OK;
  }
  for (size_t c = 0; cells && c < s->table.column_count; ++c)
    free(cells[c]);
  free(cells);
  return status;
}

static void do_row(sets *s, size_t k) {
  po_no_memory_forget();
  bool kept;
  const po_status status = make_row(s, k, &kept);
#pragma omp critical(po_law_sets)
  {
    if (status && !s->broken) {
      s->status = status;
      snprintf(s->message, sizeof s->message, "%s", po_message());
#pragma omp atomic write
      s->broken = true;
    }
    s->done += 1;
    s->kept += kept;
    po_live_show(&s->live, "%zu of %zu laws", s->done, s->table.row_count);
  }
}

/* With one thread no parallel region is used, because it allocates memory and ends the program if
 * there is none. */
static void do_rows(sets *s, int threads) {
  const size_t count = s->table.row_count;
  s->live = po_live_begin(false);
  if (threads <= 1)
    for (size_t k = 0; k < count && !must_end(s); ++k)
      do_row(s, k);
  else {
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (size_t k = 0; k < count; ++k)
      if (!must_end(s))
        do_row(s, k);
  }
  po_live_end(&s->live);
}

/* Adds a cell, in quotes if it has what separates cells. */
static void add_cell(po_text *text, const char *cell) {
  if (!strpbrk(cell, ",\"")) {
    po_text_add(text, "%s", cell);
    return;
  }
  po_text_add(text, "\"");
  for (const char *c = cell; *c; ++c)
    po_text_add(text, *c == '"' ? "\"\"" : "%c", *c);
  po_text_add(text, "\"");
}

static void add_numbers(po_text *text, const law_row *row) {
  const po_particle_numbers *n = &row->numbers;
  const double energy = row->force * row->length;
  const double value[] = {n->jump_in * row->length,
                          n->jump_out * row->length,
                          n->pull_off * row->force,
                          n->pull_off_overlap * row->length,
                          n->energy_lost * energy,
                          n->energy_lost_error * energy,
                          row->error,
                          row->seconds};
  const size_t count = sizeof value / sizeof *value;
  for (size_t k = 0; k < count; ++k) {
    char number[PO_NUMBER_LENGTH];
    const bool known = (!row->status || k + 1 == count) && isfinite(value[k]);
    po_number_print(value[k], number);
    po_text_add(text, ",%s", known ? number : "nan");
  }
}

static po_status write_summary(const sets *s) {
  const po_file_path path = po_path_join(s->line->output, "summary.csv");
  const bool si = s->line->scene.given.si;
  const char *m = si ? "_m" : "", *n = si ? "_n" : "", *j = si ? "_j" : "";
  po_text text = {0};
  po_text_add(&text,
              "# what: contact laws of the rows of a table; force_error: greatest difference of "
              "the force from the computed one, over the pull-off force\n"
              "# units: %s; nan: not known, or no jumps\nrow",
              si ? "SI, at the end of the name of each column"
                 : "overlaps in epsilon, force in the unit of each file, energy in this times "
                   "epsilon; seconds elapsed");
  for (size_t c = 0; c < s->table.column_count; ++c)
    po_text_add(&text, ",%s", s->table.columns[c]);
  po_text_add(&text,
              ",status,jump_in%s,jump_out%s,pull_off_force%s,pull_off_overlap%s,energy_lost%s,"
              "energy_lost_error%s,force_error,seconds,file,reason\n",
              m, m, n, m, j, j);
  for (size_t k = 0; k < s->table.row_count; ++k) {
    const law_row *row = &s->rows[k];
    po_text_add(&text, "%zu", k + 1);
    for (size_t c = 0; c < s->table.column_count; ++c) {
      po_text_add(&text, ",");
      add_cell(&text, po_csv_cell(&s->table, k, c));
    }
    po_text_add(&text, ",%s", po_status_name(row->status));
    add_numbers(&text, row);
    po_text_add(&text, ",%s,", row->status ? "-" : row->file);
    add_cell(&text, *row->reason ? row->reason : "-");
    po_text_add(&text, "\n");
  }
  const po_status status =
      text.failed ? PO_NO_MEMORY : po_file_write(path.text, text.data, text.length);
  po_text_clear(&text);
  return status;
}

static void warn_of_parabolas(const sets *s) {
  size_t count = 0, greatest = 0;
  for (size_t k = 0; k < s->table.row_count; ++k) {
    count += s->rows[k].parabola_excess > PO_LAW_PARABOLA_EXCESS;
    if (s->rows[k].parabola_excess > s->rows[greatest].parabola_excess)
      greatest = k;
  }
  if (count)
    fprintf(stderr,
            "pulloff: warning: in %zu of %zu rows the contact is so wide that by JKR theory the "
            "parabola r^2/(2R) pulls more than a sphere, in row %zu by %.0f %%; --profile "
            "exact_sphere is the sphere\n",
            count, s->table.row_count, greatest + 1, 100.0 * s->rows[greatest].parabola_excess);
}

/* Says what was made. Status: PO_BAD_INPUT if no row has a law. */
static po_status conclude(const sets *s) {
  size_t laws = 0, refused = 0, first = s->table.row_count;
  for (size_t k = 0; k < s->table.row_count; ++k) {
    laws += s->rows[k].status == PO_OK;
    refused += s->rows[k].reason[0] != '\0';
    if (s->rows[k].reason[0] && first == s->table.row_count)
      first = k;
  }
  warn_of_parabolas(s);
  if (*s->line->request.stop)
    return po_fail(
        PO_INTERRUPTED,
        "interrupted: %s/summary.csv has %zu of %zu laws; the same command goes on there",
        s->line->output, laws, s->table.row_count);
  if (!laws)
    return po_fail(s->rows[first].status, "no row of %s has a law; row %zu: %s", s->table.path,
                   first + 1, s->rows[first].reason);
  printf("%zu %s in %s, with summary.csv\n", laws, po_one_or_more(laws, "law", "laws"),
         s->line->output);
  if (s->kept)
    printf("%zu %s there already, made from the same %s and options\n", s->kept,
           po_one_or_more(s->kept, "row was", "rows were"), po_one_or_more(s->kept, "row", "rows"));
  if (refused)
    printf("%zu %s no law, the first is row %zu: %s\n", refused,
           po_one_or_more(refused, "row has", "rows have"), first + 1, s->rows[first].reason);
  return PO_OK;
}

po_status po_law_sets(const po_law_line *line) {
  sets s = {.line = line};
  po_options_begin_messages(0); /* which name columns, not options */
  if (!line->output)
    return po_fail(PO_BAD_INPUT, "--output is missing: expected a folder for the laws of --sets");
  po_status status = open_sets(&s);
  if (!status)
    status = po_folder_make(line->output);
  if (!status)
    status = po_law_store_open(line->output, &s.store);
  if (!status) {
    do_rows(&s, line->jobs > 0 ? line->jobs : po_environment_cores());
    status = s.broken ? po_fail(s.status, "%s", s.message) : write_summary(&s);
  }
  if (!status)
    status = conclude(&s);
  po_law_store_clear(&s.store);
  free(s.keys);
  free(s.rows);
  po_csv_clear(&s.table);
  return status;
}
