// SPDX-License-Identifier: Apache-2.0
// The kinds of file a run is written in: JSON, growing tables, HDF5 tables, files in one piece.
#include "check.h"
#include "mill.h"

#include "record/json.h"
#include "record/series_file.h"
#include "record/table.h"

#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static void json_is_written_with_its_escapes_and_without_nan(void)
{
    qn_json j;
    char *text;
    qn_json_begin(&j);
    qn_json_text(&j, "name", "a \"b\" \\ \n \xc3\xa9");
    qn_json_number(&j, "third", 1.0 / 3.0);
    qn_json_number(&j, "tenth", 0.1);
    qn_json_number(&j, "nothing", (double)NAN);
    qn_json_open(&j, "list", '[');
    qn_json_integer(&j, NULL, -3);
    qn_json_flag(&j, NULL, true);
    qn_json_close(&j);
    qn_json_open(&j, "empty", '{');
    qn_json_close(&j);
    qn_json_hex(&j, "hash", 0x00ff);
    CHECK_STATUS(qn_json_end(&j, &text));
    int same = strcmp(text, "{\n  \"name\": \"a \\\"b\\\" \\\\ \\u000a \xc3\xa9\",\n"
                            "  \"third\": 0.3333333333333333,\n  \"tenth\": 0.1,\n"
                            "  \"nothing\": null,\n  \"list\": [\n    -3,\n    true\n  ],\n"
                            "  \"empty\": {},\n  \"hash\": \"00000000000000ff\"\n}\n");
    free(text);
    CHECK(same == 0);
}

static bool holds(const char *path, const char *expected)
{
    char *text;
    int64_t length;
    if (qn_file_read(path, &text, &length) != QN_OK) return false;
    bool same = strcmp(text, expected) == 0;
    if (!same) printf("  %s holds: %s\n", path, text);
    free(text);
    return same;
}

static void a_growing_table_is_cut_before_a_step(void)
{
    qn_series_file s;
    CHECK_STATUS(qn_atomic_text("t.csv", "step,x\n0,1\n10,2\n20,3\n20,4\n30,5\n"));
    CHECK_STATUS(qn_series_file_open(&s, "t.csv", "step,x", 20));
    qn_series_file_integer(&s, 20);
    qn_series_file_number(&s, 0.1);
    qn_series_file_end_row(&s);
    CHECK_STATUS(qn_series_file_sync(&s));
    qn_series_file_close(&s);
    CHECK(holds("t.csv", "step,x\n0,1\n10,2\n20,0.10000000000000001\n"));
}

static void a_growing_table_loses_what_was_written_by_half(void)
{
    static const char *const halves[] = {
        "", "st", "step,x", "step,x\n0,1\n10", "step,x\n0,1\n10,2.", "step,x\n0,1\n\n20,1\n"};
    static const char *const left[] = {"step,x\n",      "step,x\n",      "step,x\n",
                                       "step,x\n0,1\n", "step,x\n0,1\n", "step,x\n0,1\n"};
    for (int i = 0; i < 6; i++) {
        qn_series_file s;
        CHECK_STATUS(qn_atomic_text("h.csv", halves[i]));
        CHECK_STATUS(qn_series_file_open(&s, "h.csv", "step,x", 1000));
        qn_series_file_close(&s);
        CHECK(holds("h.csv", left[i]));
    }
}

static void a_growing_table_of_other_columns_is_refused_untouched(void)
{
    qn_series_file s;
    CHECK_STATUS(qn_atomic_text("o.csv", "step,y\n0,1\n"));
    CHECK(qn_series_file_open(&s, "o.csv", "step,x", 1000) == QN_INPUT);
    CHECK(holds("o.csv", "step,y\n0,1\n"));
}

static void a_table_of_words_and_numbers_is_read_back(void)
{
    double *numbers;
    int64_t rows;
    CHECK_STATUS(qn_atomic_text("r.csv", "step,who,x\n0,shell,0.1\n1,7,nan\n"));
    CHECK_STATUS(qn_series_file_read("r.csv", 3, &numbers, &rows));
    bool right =
        rows == 2 && isnan(numbers[1]) && numbers[2] == 0.1 && numbers[4] == 7 && isnan(numbers[5]);
    free(numbers);
    CHECK(right);
    CHECK(qn_series_file_read("r.csv", 4, &numbers, &rows) == QN_IO);
}

static double numbers[6] = {1, 2, 3, 4, 5, 1e-300};
static int64_t names[2] = {1, INT64_MAX};

static qn_status write_table(const char *path)
{
    const qn_column columns[] = {{"x", "m", "place", QN_DOUBLE, 3, 2, numbers},
                                 {"id", "1", "name", QN_INT64, 1, 2, names},
                                 {"none", "1", "empty", QN_FLOAT, 3, 0, NULL}};
    hid_t file;
    QN_TRY(qn_h5_begin(&file));
    QN_TRY(qn_table_write(file, "t", columns, 3, false));
    return qn_h5_commit(file, path);
}

static qn_status read_table(const char *path, qn_column column)
{
    hid_t file;
    QN_TRY(qn_h5_open(path, &file));
    qn_status status = qn_table_read(file, "t", &column, 1);
    qn_h5_close(file);
    return status;
}

static void a_table_in_hdf5_is_read_back_bit_for_bit(void)
{
    double x[6] = {0};
    int64_t id[2] = {0};
    CHECK_STATUS(write_table("t.h5"));
    CHECK_STATUS(read_table("t.h5", (qn_column){"x", "m", "", QN_DOUBLE, 3, 2, x}));
    CHECK_STATUS(read_table("t.h5", (qn_column){"id", "1", "", QN_INT64, 1, 2, id}));
    CHECK_STATUS(read_table("t.h5", (qn_column){"none", "1", "", QN_FLOAT, 3, 0, NULL}));
    CHECK(memcmp(x, numbers, sizeof x) == 0 && memcmp(id, names, sizeof id) == 0);
}

static void a_table_of_another_shape_is_refused_with_a_sentence(void)
{
    double x[12];
    CHECK_STATUS(write_table("t.h5"));
    CHECK(read_table("t.h5", (qn_column){"y", "m", "", QN_DOUBLE, 3, 2, x}) == QN_IO);
    CHECK(strstr(qn_error(), "t has no column y"));
    CHECK(read_table("t.h5", (qn_column){"x", "m", "", QN_DOUBLE, 3, 4, x}) == QN_IO);
    CHECK(strstr(qn_error(), "2 rows of 3 numbers, expected 4 of 3"));
    CHECK(read_table("t.h5", (qn_column){"x", "m", "", QN_FLOAT, 3, 2, x}) == QN_IO);
    CHECK(strstr(qn_error(), "does not hold 32-bit numbers"));
}

static void a_table_with_a_changed_number_is_refused(void)
{
    double x[6];
    char *bytes;
    int64_t length;
    CHECK_STATUS(write_table("t.h5"));
    CHECK_STATUS(qn_file_read("t.h5", &bytes, &length));
    char *place = memmem(bytes, (size_t)length, numbers, sizeof numbers);
    if (place) place[20] ^= 1;
    qn_status status = qn_atomic_write("t.h5", bytes, (size_t)length);
    free(bytes);
    CHECK(place && status == QN_OK);
    CHECK(read_table("t.h5", (qn_column){"x", "m", "", QN_DOUBLE, 3, 2, x}) == QN_IO);
    CHECK(strstr(qn_error(), "damaged"));
}

static void a_file_that_is_not_hdf5_is_refused_with_a_sentence(void)
{
    double x[6];
    CHECK_STATUS(qn_atomic_text("text.h5", "hello\n"));
    CHECK(read_table("text.h5", (qn_column){"x", "m", "", QN_DOUBLE, 3, 2, x}) == QN_IO);
    CHECK(strstr(qn_error(), "no HDF5 file"));
    CHECK(read_table("missing.h5", (qn_column){"x", "m", "", QN_DOUBLE, 3, 2, x}) == QN_IO);
    CHECK(strstr(qn_error(), "No such file"));
}

static void equal_tables_make_equal_files(void)
{
    CHECK_STATUS(write_table("a.h5"));
    sleep(1);  // time stamps in HDF5 are in whole seconds
    CHECK_STATUS(write_table("b.h5"));
    CHECK(same_file(".", ".", "a.h5"));
    CHECK_STATUS(qn_folder_make("copy"));
    CHECK(rename("b.h5", "copy/a.h5") == 0);
    CHECK(same_file(".", "copy", "a.h5"));
}

static void a_write_that_fails_leaves_the_old_file(void)
{
    remove_folder("locked");
    CHECK_STATUS(qn_folder_make("locked/inner"));
    CHECK_STATUS(qn_atomic_text("locked/a.txt", "old\n"));
    CHECK(mkdir("locked/a.txt.partial", 0777) == 0);  // in the way of the temporary file
    CHECK(qn_atomic_text("locked/a.txt", "new\n") == QN_IO);
    CHECK(strstr(qn_error(), "locked/a.txt.partial could not be written"));
    CHECK(holds("locked/a.txt", "old\n"));
}

int main(int argc, char **argv)
{
    TEST(json_is_written_with_its_escapes_and_without_nan);
    TEST(a_growing_table_is_cut_before_a_step);
    TEST(a_growing_table_loses_what_was_written_by_half);
    TEST(a_growing_table_of_other_columns_is_refused_untouched);
    TEST(a_table_of_words_and_numbers_is_read_back);
    TEST(a_table_in_hdf5_is_read_back_bit_for_bit);
    TEST(a_table_of_another_shape_is_refused_with_a_sentence);
    TEST(a_table_with_a_changed_number_is_refused);
    TEST(a_file_that_is_not_hdf5_is_refused_with_a_sentence);
    TEST(equal_tables_make_equal_files);
    TEST(a_write_that_fails_leaves_the_old_file);
    DONE;
}
