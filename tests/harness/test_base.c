/* Tests of text, numbers, digests, files and tables. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "po_csv.h"
#include "po_digest.h"
#include "po_file.h"
#include "po_number.h"
#include "po_order.h"
#include "po_tables.h"
#include "po_text.h"
#include "run.h"

static char folder[] = "/tmp/pulloff-test-XXXXXX";
static char path[64];

static void make_folder(void) {
  strcpy(folder, "/tmp/pulloff-test-XXXXXX");
  ck_assert_ptr_nonnull(mkdtemp(folder));
  snprintf(path, sizeof path, "%s/file", folder);
}

static void remove_folder(void) {
  unlink(path);
  rmdir(folder);
}

static const struct {
  double value;
  const char *text;
} PRINTED[] = {{0.1, "0.1"},
               {1.0 / 3.0, "0.333333333333333"},
               {2.0 / 3.0, "0.6666666666666666"},
               {-2.385e-7, "-2.385e-07"},
               {0.1 + 0.2, "0.30000000000000004"},
               {5e-324, "4.94065645841247e-324"},
               {1e22, "1e+22"},
               {-0.0, "-0"}};

TABLE_TEST(number_prints_short_and_exact, PRINTED) {
  char text[PO_NUMBER_LENGTH];
  po_number_print(PRINTED[_i].value, text);
  ck_assert(strtod(text, NULL) == PRINTED[_i].value);
  if (_i != 1) /* 1/3 needs 16 digits */
    ck_assert_str_eq(text, PRINTED[_i].text);
}

TEST(number_prints_what_is_not_finite) {
  char text[PO_NUMBER_LENGTH];
  po_number_print(-(double)INFINITY, text);
  ck_assert_str_eq(text, "-inf");
  po_number_print(-(double)NAN, text);
  ck_assert_str_eq(text, "nan");
}

static const struct {
  const char *text;
  bool taken;
  double value;
} PARSED[] = {
    {"2.385", true, 2.385}, {"-1e-3", true, -1e-3}, {"+.5", true, 0.5},     {"5.", true, 5},
    {"1E5", true, 1e5},     {"", false, 0},         {".", false, 0},        {"1e", false, 0},
    {"1 ", false, 0},       {" 1", false, 0},       {"nan", false, 0},      {"inf", false, 0},
    {"0x10", false, 0},     {"1,5", false, 0},      {"1e999", false, 0},    {"1e-999", false, 0},
    {"--1", false, 0},      {"1.2.3", false, 0},    {"infinity", false, 0}, {"1f", false, 0}};

TABLE_TEST(number_parses_strictly, PARSED) {
  double value = -77;
  ck_assert_int_eq(po_number_parse(PARSED[_i].text, &value), PARSED[_i].taken);
  ck_assert_double_eq(value, PARSED[_i].taken ? PARSED[_i].value : -77);
}

TEST(number_takes_infinity_where_allowed) {
  double value = 0;
  ck_assert(po_key_parse(PO_KEY_OUTER_RADIUS, "inf", &value) && isinf(value));
  ck_assert(!po_key_parse(PO_KEY_OUTER_RADIUS, "-inf", &value));
  ck_assert(!po_key_parse(PO_KEY_OUTER_RADIUS, "nan", &value));
  size_t count = 0;
  ck_assert(po_number_parse_count("501", &count) && count == 501);
  ck_assert(!po_number_parse_count("", &count) && !po_number_parse_count("5.0", &count));
  ck_assert(!po_number_parse_count("-5", &count) && !po_number_parse_count("+5", &count));
  ck_assert(!po_number_parse_count("99999999999999999999", &count));
}

/* FIPS 180-4 examples. */
TEST(digest_is_sha256) {
  char digest[PO_DIGEST_LENGTH];
  po_digest_bytes("abc", 3, digest);
  ck_assert_str_eq(digest, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  po_digest_bytes("", 0, digest);
  ck_assert_str_eq(digest, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(text_grows) {
  po_text text = {0};
  ck_assert_str_eq(po_text_string(&text), "");
  for (int i = 0; i < 1000; ++i)
    po_text_add(&text, "%03d,", i);
  po_text_add_bytes(&text, "end", 3);
  ck_assert_uint_eq(text.length, 4003);
  ck_assert_str_eq(text.data + 3996, "999,end");
  po_text_clear(&text);
}

TEST(words_are_quoted_for_a_shell) {
  static const char *const WORDS[][2] = {{"my/tip-1.5_a.yaml", "my/tip-1.5_a.yaml"},
                                         {"", "''"},
                                         {"my tip", "'my tip'"},
                                         {"it's", "'it'\\''s'"},
                                         {"$(reboot)", "'$(reboot)'"},
                                         {"a\\b", "'a\\b'"},
                                         {"~", "'~'"},
                                         {"gr\303\266\303\237e", "'gr\303\266\303\237e'"},
                                         {"gr\366\337e", "$'gr\\366\\337e'"},
                                         {"two\nlines", "$'two\\012lines'"},
                                         {"it's\033\\", "$'it\\'s\\033\\\\'"}};
  for (size_t i = 0; i < sizeof WORDS / sizeof *WORDS; ++i) {
    po_text text = {0};
    po_text_add_word(&text, WORDS[i][0]);
    ck_assert_str_eq(po_text_string(&text), WORDS[i][1]);
    po_text_clear(&text);
  }
}

TEST(file_is_written_whole_or_not_at_all) {
  char *data = NULL;
  size_t size = 0;
  ck_assert_int_eq(po_file_write(path, "first", 5), PO_OK);
  ck_assert_int_eq(po_file_write(path, "second\0x", 8), PO_OK);
  ck_assert_int_eq(po_file_read(path, &data, &size), PO_OK);
  ck_assert_uint_eq(size, 8);
  ck_assert(memcmp(data, "second\0x", 9) == 0);
  free(data);
  /* Writing to the path of a folder fails, and the folder contains no new file. */
  char **names = NULL;
  size_t count = 0;
  ck_assert_int_eq(po_file_write(folder, "x", 1), PO_CANNOT_WRITE);
  ck_assert_int_eq(po_folder_list(folder, "e", &names, &count), PO_OK);
  ck_assert_uint_eq(count, 1);
  ck_assert_str_eq(names[0], "file");
  po_names_free(names, count);
  ck_assert_int_eq(po_file_write("/dev/full", "x", 1), PO_CANNOT_WRITE);
  ck_assert_ptr_nonnull(strstr(po_message(), "No space left"));
  ck_assert_int_eq(po_file_read(folder, &data, &size), PO_CANNOT_READ);
  ck_assert_int_eq(po_folder_make(path), PO_CANNOT_WRITE);
  ck_assert_int_eq(po_folder_make(folder), PO_OK);
}

static po_status read_text(const char *text, po_csv *csv) {
  ck_assert_int_eq(po_file_write(path, text, strlen(text)), PO_OK);
  return po_csv_read(path, "t.csv", csv);
}

TEST(csv_reads_headers_columns_rows) {
  po_csv csv;
  double value = 0;
  ck_assert_int_eq(read_text("# what: a: b\n#units:\na,b\n1,2\n2.385,-4e3\n", &csv), PO_OK);
  ck_assert_str_eq(po_csv_find_header(&csv, "what")->value, "a: b");
  ck_assert_str_eq(po_csv_find_header(&csv, "units")->value, "");
  ck_assert_ptr_null(po_csv_find_header(&csv, "why"));
  ck_assert_int_eq(po_csv_find_column(&csv, "b"), 1);
  ck_assert_int_eq(po_csv_find_column(&csv, "c"), -1);
  ck_assert_uint_eq(csv.row_count, 2);
  ck_assert_uint_eq(csv.lines[1], 5);
  ck_assert_int_eq(po_csv_number(&csv, 1, 1, &value), PO_OK);
  ck_assert_double_eq(value, -4e3);
  char digest[PO_DIGEST_LENGTH];
  po_digest_bytes("# what: a: b\n#units:\na,b\n1,2\n2.385,-4e3\n", 40, digest);
  ck_assert_str_eq(csv.digest, digest);
  po_csv_clear(&csv);
  /* the digest covers all lines except its own, wherever that is */
  ck_assert_int_eq(read_text("# what: a: b\n#units:\n# sha256: x\na,b\n1,2\n2.385,-4e3\n", &csv),
                   PO_OK);
  ck_assert_str_eq(csv.digest, digest);
  po_csv_clear(&csv);
  ck_assert_int_eq(read_text("# sha256: x\n# what: a: c\n#units:\na,b\n1,2\n2.385,-4e3\n", &csv),
                   PO_OK);
  ck_assert_str_ne(csv.digest, digest);
  po_csv_clear(&csv);
}

TEST(csv_is_sealed) {
  po_text header = {0}, rows = {0}, file = {0};
  char digest[PO_DIGEST_LENGTH];
  po_text_add(&header, "# what: sealed\n");
  po_text_add(&rows, "a\n2.385\n");
  po_csv_seal(&header, &rows, &file, digest);
  po_csv csv;
  ck_assert_int_eq(read_text(po_text_string(&file), &csv), PO_OK);
  ck_assert_str_eq(csv.digest, digest);
  ck_assert_str_eq(po_csv_find_header(&csv, "sha256")->value, digest);
  po_csv_clear(&csv);
  po_text_clear(&header);
  po_text_clear(&rows);
  po_text_clear(&file);
}

/* Tables as spreadsheets write them: a byte order mark, quotes, blanks, CR LF, blank lines. Such
 * tables used to be refused by messages that asked for the columns that are there. */
static const char *const SPREADSHEET[] = {
    "\xEF\xBB\xBF# x: 1\nr,gap\n2.385,-1\n",
    "# x: 1\n\"r\",\"gap\"\n\"2.385\",\"-1\"\n",
    "# x: 1  \nr , gap\n 2.385 ,\t-1\t\n",
    "\xEF\xBB\xBF# x: 1\r\n \"r\" , \"gap\" \r\n2.385,-1\r\n",
    "# x: 1\n\nr,gap\n2.385,-1\n\n  \n\n",
    "# x: 1\r\r\r\nr,gap\r\r\n2.385,-1\r\r\n", /* of two conversions */
};

TABLE_TEST(csv_reads_what_spreadsheets_write, SPREADSHEET) {
  po_csv csv;
  ck_assert_int_eq(read_text(SPREADSHEET[_i], &csv), PO_OK);
  ck_assert_int_eq(po_csv_find_column(&csv, "r"), 0);
  ck_assert_int_eq(po_csv_find_column(&csv, "gap"), 1);
  ck_assert_uint_eq(csv.row_count, 1);
  ck_assert_str_eq(po_csv_find_header(&csv, "x")->value, "1");
  double value = 0;
  ck_assert(po_csv_number(&csv, 0, 0, &value) == PO_OK && value == 2.385);
  ck_assert(po_csv_number(&csv, 0, 1, &value) == PO_OK && value == -1);
  po_csv_clear(&csv);
}

TEST(csv_quoted_cells_contain_commas_and_quotes) {
  po_csv csv;
  ck_assert_int_eq(read_text("name,\"a, b\"\n\"say \"\"so\"\", twice\",1\n", &csv), PO_OK);
  ck_assert_str_eq(csv.columns[1], "a, b");
  ck_assert_str_eq(po_csv_cell(&csv, 0, 0), "say \"so\", twice");
  po_csv_clear(&csv);
}

static const struct {
  const char *text;
  const char *message;
} DAMAGED[] = {
    {"", "t.csv is empty: expected a table"},
    {"# what: x\n", "t.csv:2: there is no line of column names"},
    {"a,b\n#1,2\n3,4\n",
     "t.csv:2: a line with # stands after the names of the columns: expected a row"},
    {"a,b\n1\n", "t.csv:2: the row has 1 cell: expected 2, separated by commas"},
    {"a,b\n1,2,3\n", "t.csv:2: the row has 3 cells: expected 2, separated by commas (decimal "
                     "commas need another separator)"},
    {"a,b\n1,2\n\n3,4\n", "t.csv:3: the row has 0 cells: expected 2, separated by commas"},
    {"a,b\n1,\"2\n", "t.csv:2: a quoted cell does not end with its quote: expected \"...\" on one "
                     "line"},
    {"\"a\"b,c\n1,2\n",
     "t.csv:1: a quoted cell does not end with its quote: expected \"...\" on one "
     "line"},
    {"a,b\n1,\n", "t.csv:2: the cell of column b is empty"},
    {"a,b\n,1\n", "t.csv:2: the cell of column a is empty"},
    {"\xEF\xBB\xBF", "t.csv:2: there is no line of column names"},
    {"a,a\n1,2\n", "t.csv:1: the column a is given twice"},
    {"a,\n1,2\n", "t.csv:1: column 2 has no name"},
    {"# sha256: 0\na,b\n1,2", "t.csv:3: the last line has no newline: the file is truncated"},
    {"# x\na\n1\n", "t.csv:1: '# x' is not a header: expected '# key: value'"},
    {"# x: 1\n# x: 2\na\n1\n", "t.csv:2: the header x is given twice"},
};

TABLE_TEST(csv_refuses_damage, DAMAGED) {
  po_csv csv;
  ck_assert_int_eq(read_text(DAMAGED[_i].text, &csv), PO_CANNOT_READ);
  ck_assert_str_eq(po_message(), DAMAGED[_i].message);
}

/* Regression: each name was compared with all before it, and a header of 100,000 lines took
 * minutes, which the time limit of a test ends. */
TEST(csv_finds_the_first_repeated_name_of_many) {
  po_text text = {0};
  po_csv csv;
  for (int k = 0; k < 200000; ++k)
    po_text_add(&text, "# key%d: %d\n", k == 170000 ? 9 : k == 180000 ? 3 : k, k);
  po_text_add(&text, "a,b\n1,2\n");
  ck_assert_int_eq(read_text(text.data, &csv), PO_CANNOT_READ);
  ck_assert_str_eq(po_message(), "t.csv:170001: the header key9 is given twice");
  po_text_clear(&text);
  for (int k = 0; k < 200000; ++k)
    po_text_add(&text, "%sc%d", k ? "," : "", k == 170000 ? 9 : k == 180000 ? 3 : k);
  po_text_add(&text, "\n");
  ck_assert_int_eq(read_text(text.data, &csv), PO_CANNOT_READ);
  ck_assert_str_eq(po_message(), "t.csv:1: the column c9 is given twice");
  po_text_clear(&text);
}

static const struct {
  const char *text, *fault;
} FAULTS[] = {{"1,5", "; it has a comma in place of a decimal point"},
              {"-1,5e-6", "; it has a comma in place of a decimal point"},
              {"1.5 nm", "; a unit or other text follows the number"},
              {"1,5nm", "; a unit or other text follows the number"},
              {"2 [m]", "; a unit or other text follows the number"},
              {"7 \u00B5m", "; a unit or other text follows the number"},
              {"1,234.5", "; it has marks or blanks between thousands"},
              {"1.234,5", "; it has marks or blanks between thousands"},
              {"1\u00A0234", "; it has marks or blanks between thousands"},
              {"1'234", "; it has marks or blanks between thousands"},
              {"-1", ""},
              {"1e400", ""},
              {"0x10", ""},
              {"0.05+-0.01", ""},
              {"0.05\u00B10.01", ""},
              {"1,2,3", ""},
              {"", ""},
              {"nm", ""}};

TABLE_TEST(number_faults_are_named, FAULTS) {
  ck_assert_str_eq(po_number_fault(FAULTS[_i].text), FAULTS[_i].fault);
}

TEST(csv_rows_read_back_exactly) {
  const double values[] = {0.1, 1.0 / 3.0, -2.385e-300};
  po_text text = {0};
  po_csv csv;
  po_text_add(&text, "a,b,c\n");
  for (int i = 0; i < 100; ++i)
    po_csv_add_row(&text, values, 3);
  ck_assert_int_eq(read_text(text.data, &csv), PO_OK);
  ck_assert_uint_eq(csv.row_count, 100);
  for (size_t c = 0; c < 3; ++c) {
    double value = 0;
    ck_assert_int_eq(po_csv_number(&csv, 99, c, &value), PO_OK);
    ck_assert(value == values[c]);
  }
  po_csv_clear(&csv);
  po_text_clear(&text);
}

TEST(the_place_of_a_number_among_others) {
  static const double NUMBERS[] = {0.0, 1.0, 1.0, 2.5}, AT[] = {-1, 0, 0.5, 1, 2.4, 2.5, 9};
  static const size_t EXPECTED[] = {0, 0, 0, 2, 2, 3, 3};
  for (size_t k = 0; k < sizeof AT / sizeof *AT; ++k)
    ck_assert_uint_eq(po_order_last_up_to(NUMBERS, 4, AT[k]), EXPECTED[k]);
  ck_assert_uint_eq(po_order_last_up_to(NUMBERS, 1, 3.0), 0);
}

FIXTURE(make_folder, remove_folder)
