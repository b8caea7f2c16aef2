/* SPDX-License-Identifier: BSD-3-Clause
 * Any bytes as an HDF5 table, of bodies or of bonds by the first byte. */
#include "fuzz.h"

#include <hdf5.h>

#include "table_hdf5.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct table table;
    struct message message = {""};
    if (size < 1)
        return 0;
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    const enum table_kind kind = data[0] & 1 ? TABLE_BONDS : TABLE_BODIES;
    if (table_hdf5_read(fuzz_file("table.h5", data + 1, size - 1), kind, &table, &message) != 0) {
        fuzz_one_line(&message);
        return 0;
    }
    for (int k = 0; table_column(kind, k) != NULL; ++k)
        for (int64_t row = 0; table_has(&table, k) && row < table.rows; ++row)
            fuzz_must(table_refusal(kind, k, table.column[k][row]) == NULL, "a number fits its column");
    table_destroy(&table);
    return 0;
}
