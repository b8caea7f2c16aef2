#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Each public header compiles alone and included twice, and vti.h in two files of one program, without a warning: as C99
# and C17, and as C++98 and C++17, with every compiler that is installed.
#     test_headers.sh INCLUDE_DIRECTORY
set -eu
include=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
warnings="-pedantic -Wall -Wextra -Wconversion -Wshadow -Werror"
ran=0

# check SUFFIX COMPILER STANDARD
check() {
    for header in "$include"/*.h "$include"/../drivers/check/vti_check.h; do
        printf '#include "%s"\n#include "%s"\n' "$header" "$header" >"$work/alone.$1"
        # shellcheck disable=SC2086  # the warnings are separate words
        "$2" "-std=$3" $warnings -fsyntax-only "$work/alone.$1" || {
            echo "$header does not compile alone and without warnings as $3 with $2" >&2
            exit 1
        }
    done
    printf '#include "vti.h"\ndouble angle(const double *a);\n' | tee "$work/main.$1" >"$work/other.$1"
    printf 'double angle(const double *a)\n{\n    return vti_rrv_angle(a);\n}\n' >>"$work/other.$1"
    printf 'int main(void)\n{\n    const double a[3] = {0, 0, 0};\n    return angle(a) != vti_rrv_angle(a);\n}\n' \
        >>"$work/main.$1"
    # shellcheck disable=SC2086
    "$2" "-std=$3" $warnings -I "$include" "$work/main.$1" "$work/other.$1" -o "$work/program" -lm && "$work/program" || {
        echo "vti.h cannot be used in two files of a program, as $3 with $2" >&2
        exit 1
    }
    echo "ok: $2 -std=$3"
    ran=$((ran + 1))
}

for compiler in gcc clang; do
    command -v "$compiler" >/dev/null || continue
    for standard in c99 c17; do
        check c "$compiler" "$standard"
    done
done
for compiler in g++ clang++; do
    command -v "$compiler" >/dev/null || continue
    for standard in c++98 c++17; do
        check cpp "$compiler" "$standard"
    done
done
[ "$ran" -gt 0 ] || exit 77 # skipped: neither gcc nor clang
