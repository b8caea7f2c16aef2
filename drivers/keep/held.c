/* SPDX-License-Identifier: BSD-3-Clause */
#include "held.h"

#include <hdf5.h>
#include <stdio.h>
#include <string.h>

int held_begins(const char *path)
{
    static const char hdf5[] = "\x89HDF\r\n\x1a\n";
    char start[sizeof hdf5 - 1];
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return 0;
    const size_t size = fread(start, 1, sizeof start, file);
    fclose(file);
    return size == sizeof start && memcmp(start, hdf5, sizeof start) == 0;
}

int held_is(const char *path)
{
    hid_t file = H5I_INVALID_HID;
    if (!held_begins(path))
        return 0;
    H5E_BEGIN_TRY
    {
        file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
        if (file >= 0)
            H5Fclose(file);
    }
    H5E_END_TRY;
    return file < 0;
}

int held_has(const char *path, const char *attribute)
{
    htri_t found = 0;
    H5E_BEGIN_TRY
    {
        const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
        if (file >= 0) {
            found = H5Aexists(file, attribute);
            H5Fclose(file);
        }
    }
    H5E_END_TRY;
    return found > 0;
}
