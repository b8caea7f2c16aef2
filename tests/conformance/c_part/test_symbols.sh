#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The shared library exports exactly the functions that the headers declare with VTI_API, all of them vti_..., and calls
# nothing that allocates, prints or ends the program.
# Of other archives, which hosts link too, every name that others could meet begins with vti_.
#     test_symbols.sh SHARED_LIBRARY INCLUDE_DIRECTORY [ARCHIVE...]
set -eu
library=$1 include=$2
shift 2
command -v nm >/dev/null || exit 77
exported=$(nm -D --defined-only "$library" | awk '{print $NF}' | sed 's/@.*//' | sort)
declared=$(sed -nE 's/^VTI_API .*[ *](vti_[a-z0-9_]+)\(.*/\1/p' "$include"/*.h | sort)
[ -n "$declared" ] || { echo "no declarations found in $include" >&2; exit 1; }

foreign=$(printf '%s\n' "$exported" | grep -v '^vti_' || true)
[ -z "$foreign" ] || { echo "exported without the prefix vti_: $foreign" >&2; exit 1; }
[ "$exported" = "$declared" ] || {
    echo "exported and declared differ:" >&2
    printf '%s\n%s\n' "$exported" "$declared" | sort | uniq -u >&2
    exit 1
}
for archive; do # in Fortran __vti_ begins names in modules, and VTIBEG is vtibeg_; sanitizers add names of their own
    foreign=$(nm -g --defined-only "$archive" | awk 'NF == 3 { print $NF }' | grep -Ev '^(vti_|__vti_|vti[a-z0-9]+_$|__odr_asan\.)' || true)
    [ -z "$foreign" ] || { echo "$archive exports without the prefix vti_: $foreign" >&2; exit 1; }
done
forbidden=$(nm -D --undefined-only "$library" | awk '{print $NF}' | sed 's/@.*//' |
    grep -E '^(malloc|calloc|realloc|free|.*printf.*|puts|putchar|fputs|fwrite|fopen|exit|_exit|abort|__assert_fail|getenv)$' ||
    true)
[ -z "$forbidden" ] || { echo "the library calls: $forbidden" >&2; exit 1; }
# Of libm nothing but what is exact whatever the machine; atan2 is not, and serves measures of angles only.
inexact=$(nm -D --undefined-only "$library" | awk '{print $NF}' | sed 's/@.*//' |
    grep -E '^(a?(sin|cos|tan)h?|atan2|sincos|exp.*|log.*|pow|cbrt|hypot|fma|[elt]gamma|erfc?)[fl]?$' | grep -vx atan2 || true)
[ -z "$inexact" ] || { echo "the library calls, whose bits depend on libm: $inexact" >&2; exit 1; }
printf '%s\n' "$exported" | wc -l | sed 's/$/ symbols, as declared/'
