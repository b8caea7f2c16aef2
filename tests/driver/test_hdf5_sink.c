/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Datasets that are written row by row: whatever order rows come in, and however many at a time, each stands in its
 * place when the file is closed. */
#define _POSIX_C_SOURCE 200809L
#include "hdf5_sink.h"

#include "message.h"
#include "scratch.h"
#include "support.h"

enum { ROWS = 40000, COLUMNS = 3, LARGE = 20000 }; /* LARGE rows are more than wait */

static char folder[1024], path[sizeof folder + 16];
static double row[ROWS][COLUMNS], found[ROWS][COLUMNS];
static int64_t number[ROWS], found_number[ROWS];

static struct hdf5_sink begin(void)
{
    const hsize_t dims[2] = {ROWS, COLUMNS};
    struct message message;
    struct hdf5_sink s = hdf5_file(path, &message);
    assert_int_equal(s.failed, 0);
    hdf5_dataset(&s, "rows", H5T_NATIVE_DOUBLE, 2, dims, NULL);
    hdf5_dataset(&s, "numbers", H5T_NATIVE_INT64, 1, dims, NULL);
    return s;
}

/** Rows of both datasets, each of which waits by itself. */
static void put(struct hdf5_sink *s, int first, int count)
{
    hdf5_rows(s, "rows", (hsize_t)first, (hsize_t)count, row[first]);
    hdf5_rows(s, "numbers", (hsize_t)first, (hsize_t)count, &number[first]);
}

static void read_back(const char *name, hid_t type, void *values)
{
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT), set = H5Dopen2(file, name, H5P_DEFAULT);
    assert_true(set >= 0);
    assert_true(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
    H5Dclose(set);
    H5Fclose(file);
}

static void end(struct hdf5_sink *s)
{
    assert_int_equal(hdf5_close_file(s), 0);
    memset(found, 0, sizeof found);
    memset(found_number, 0, sizeof found_number);
    read_back("rows", H5T_NATIVE_DOUBLE, found);
    read_back("numbers", H5T_NATIVE_INT64, found_number);
    assert_memory_equal(found, row, sizeof row);
    assert_memory_equal(found_number, number, sizeof number);
}

/** As runs write them: one piece after the other. */
TEST(one_after_the_other)
{
    struct hdf5_sink s = begin();
    for (int first = 0; first < ROWS; first += 25)
        put(&s, first, 25);
    end(&s);
}

/** From behind: no call begins where the one before has ended, and rows wait each time. */
TEST(from_behind)
{
    struct hdf5_sink s = begin();
    for (int first = ROWS - 25; first >= 0; first -= 25)
        put(&s, first, 25);
    end(&s);
}

/** Every other piece, then those between them; rows that are written twice keep what came last. */
TEST(with_gaps)
{
    struct hdf5_sink s = begin();
    for (int from = 0; from < 2; ++from)
        for (int first = 10 * from; first < ROWS; first += 20) {
            const double right = row[first][1];
            row[first][1] = -1.0;
            put(&s, first, 10);
            row[first][1] = right;
            put(&s, first, 10);
        }
    end(&s);
}

/** More than waits at once, while a few wait that belong before, after and elsewhere. */
TEST(large_beside_small)
{
    struct hdf5_sink s = begin();
    put(&s, 0, 7);
    put(&s, 7, LARGE);
    put(&s, ROWS - 1, 1);
    put(&s, LARGE + 7, ROWS - LARGE - 8);
    end(&s);
}

/** A dataset that there is not. */
TEST(no_such_dataset)
{
    struct hdf5_sink s = begin();
    hdf5_rows(&s, "none", 0, 1, row[0]);
    assert_int_equal(hdf5_close_file(&s), -1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_after_the_other), cmocka_unit_test(from_behind),
                                       cmocka_unit_test(with_gaps), cmocka_unit_test(large_beside_small),
                                       cmocka_unit_test(no_such_dataset)};
    if (!scratch_make(folder, sizeof folder))
        return 1;
    snprintf(path, sizeof path, "%s/rows.h5", folder);
    for (int r = 0; r < ROWS; ++r) {
        number[r] = 1000 + r;
        for (int c = 0; c < COLUMNS; ++c)
            row[r][c] = r + 0.25 * c;
    }
    hdf5_start();
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    return remove(path) != 0 || rmdir(folder) != 0 || failed != 0;
}
