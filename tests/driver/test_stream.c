/* SPDX-License-Identifier: BSD-3-Clause
 * A stream that has lost something is not one that ends well, however much space there is by then. */
#define _GNU_SOURCE /* fopencookie: a file that fails when it is told to */
#include "support.h"

#include "stream.h"

struct disk {
    int fails; /* writes from now on that find no space */
    size_t taken;
};

static ssize_t take(void *self, const char *bytes, size_t size)
{
    struct disk *disk = self;
    (void)bytes;
    if (disk->fails > 0) {
        --disk->fails;
        errno = ENOSPC;
        return 0;
    }
    disk->taken += size;
    return (ssize_t)size;
}

static FILE *disk_open(struct disk *disk)
{
    cookie_io_functions_t calls = {NULL, take, NULL, NULL};
    FILE *file = fopencookie(disk, "w", calls);
    assert_non_null(file);
    return file;
}

TEST(test_all_taken)
{
    struct disk disk = {0, 0};
    FILE *file = disk_open(&disk);
    assert_true(fputs("all of it", file) >= 0);
    assert_int_equal(stream_end(file, fclose), 0);
    assert_int_equal(disk.taken, 9);
}

TEST(test_last_write_fails)
{
    struct disk disk = {1, 0};
    FILE *file = disk_open(&disk);
    assert_true(fputs("all of it", file) >= 0);
    errno = 0;
    assert_int_equal(stream_end(file, fclose), -1);
    assert_int_equal(errno, ENOSPC);
}

/** The write that is lost is not the last one, and the stream closes, or is flushed, without a complaint. */
TEST(test_earlier_write_fails)
{
    int (*const ends[])(FILE *) = {fclose, fflush};
    for (size_t k = 0; k < 2; ++k) {
        struct disk disk = {1, 0};
        FILE *file = disk_open(&disk);
        assert_true(fputs("lost", file) >= 0);
        assert_int_equal(fflush(file), EOF);
        errno = 0;
        assert_int_equal(stream_end(file, ends[k]), -1);
        assert_int_equal(errno, ENOSPC);
        if (ends[k] == fflush)
            fclose(file);
    }
}

RUN_TESTS(cmocka_unit_test(test_all_taken), cmocka_unit_test(test_last_write_fails),
          cmocka_unit_test(test_earlier_write_fails))
