/* SPDX-License-Identifier: BSD-3-Clause
 * A fuzz target without libFuzzer: every file in the folders that are the arguments, whole, cut at every byte, and with
 * seeded changes.      replay FOLDER... */
#define _POSIX_C_SOURCE 200809L
#include <dirent.h>
#include <sys/stat.h>

#include "fuzz.h"

enum { MOST = 8192, CHANGES = 1000 };

static uint64_t seed;

/** xorshift64* */
static size_t below(size_t n)
{
    seed ^= seed >> 12;
    seed ^= seed << 25;
    seed ^= seed >> 27;
    return (size_t)((seed * UINT64_C(2685821657736338717)) >> 33) % n;
}

/** Changes, removes or doubles bytes, or copies them to another place. */
static size_t change(uint8_t *bytes, size_t size)
{
    const size_t at = below(size), n = 1 + below(size - at < 16 ? size - at : 16);
    switch (below(5)) {
    case 0:
        bytes[at] = (uint8_t)below(256);
        return size;
    case 1:
        memmove(bytes + at, bytes + at + n, size - at - n);
        return size - n;
    case 2:
        memmove(bytes + at + n, bytes + at, size - at);
        return size + n;
    case 3:
        memmove(bytes + below(size - n + 1), bytes + at, n);
        return size;
    default:
        bytes[at] = (uint8_t)(bytes[at] ^ 1U << below(8));
        return size;
    }
}

static void replay(const uint8_t *bytes, size_t size)
{
    static uint8_t changed[2 * MOST];
    seed = 20240301; /* the same changes whatever the order of the files */
    LLVMFuzzerTestOneInput(bytes, size);
    for (size_t cut = 0; cut < size; ++cut)
        LLVMFuzzerTestOneInput(bytes, cut);
    for (int k = 0; k < CHANGES; ++k) {
        size_t n = size;
        memcpy(changed, bytes, size);
        for (size_t times = 1 + below(4); times > 0 && n > 0; --times)
            n = change(changed, n);
        LLVMFuzzerTestOneInput(changed, n);
    }
}

/** Folders inside are passed over. */
static int replay_file(const char *path)
{
    static uint8_t bytes[MOST];
    struct stat info;
    if (stat(path, &info) != 0 || !S_ISREG(info.st_mode))
        return 0;
    FILE *file = fopen(path, "rb");
    fuzz_must(file != NULL, "a stored input can be read");
    const size_t size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    replay(bytes, size);
    return 1;
}

int main(int argc, char **argv)
{
    int files = 0;
    for (int k = 1; k < argc; ++k) {
        DIR *folder = opendir(argv[k]);
        fuzz_must(folder != NULL, "a folder can be read");
        for (const struct dirent *entry; (entry = readdir(folder)) != NULL;) {
            char path[4096];
            snprintf(path, sizeof path, "%s/%s", argv[k], entry->d_name);
            files += replay_file(path);
        }
        closedir(folder);
    }
    printf("%d inputs, each with its cuts and %d changes\n", files, CHANGES);
    return files > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
