#!/bin/sh
# The core on other machines than this: aarch64 (run by qemu-user) and i386 with SSE2 and with the x87.
#
#     arch.sh ROOT            runs all of it
#     arch.sh ROOT read       whether the tests can be compiled so, by this machine's compiler
#
# aarch64 and SSE2 have to print tests/hard/digest.txt and to pass the tests of units and effects (with bare/cmocka.h in the
# place of CMocka). The x87, whose registers are wider, has other bits: at the end of each stepper's run, 192 steps of h = 1/64,
# its numbers have to be within 1e-11 of this machine's.
# shellcheck disable=SC2086  # flags, sources and tests are words
set -eu
root=$1
here=$root/tests/hard
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
flags="-std=c99 -O2 -ffp-contract=off -fno-math-errno -fno-trapping-math -Wall -Wextra -Werror -I$root/include"
sources=$(find "$root/src" -name 'vti_*.c' ! -name '*_avx*' | sort)
# neither those that need a library of its own or a table that is made, nor the long ones
tests=$(find "$root/tests/unit" "$root/tests/effects" -name 'test_*.c' ! -name '*rrv_table*' ! -name '*units*' \
    ! -name '*stable*' ! -name '*torus*' ! -name 'test_checked.c' | sort)
bad=0

if [ "${2:-}" = read ]; then
    for test in $tests; do
        gcc $flags -I"$root/tests" -I"$here/bare" -fsyntax-only "$test" || bad=1
    done
    exit $bad
fi

# core NAME COMPILER...: the core's objects as NAME
core() {
    name=$1
    shift
    mkdir "$work/$name"
    for source in $sources; do
        "$@" $flags -c "$source" -o "$work/$name/$(basename "$source" .c).o"
    done
}

# same NAME RUNNER COMPILER...: does the digest of NAME print the stored one? RUNNER is one word, empty for none.
same() {
    name=$1
    runner=$2
    shift 2
    "$@" $flags -static "$here/digest.c" "$work/$name"/*.o -lm -o "$work/digest"
    $runner "$work/digest" >"$work/$name.txt"
    if diff "$here/digest.txt" "$work/$name.txt" >"$work/diff"; then
        echo "$name: the same bits"
    else
        bad=1
        echo "$name: other bits"
        cat "$work/diff"
    fi
}

# pass NAME RUNNER COMPILER...: do the tests pass?
pass() {
    name=$1
    runner=$2
    shift 2
    passed=0
    for test in $tests; do
        # in 128 bits by software, which long double is on aarch64, the reference of the whole range takes minutes
        [ "$name $(basename "$test")" = "aarch64 test_rrv_range.c" ] && continue
        "$@" $flags -I"$root/tests" -I"$here/bare" -static "$test" "$work/$name"/*.o -lm -o "$work/test"
        if $runner "$work/test" >"$work/out" 2>&1; then
            passed=$((passed + 1))
        else
            bad=1
            echo "$name: $(basename "$test" .c) fails"
            cat "$work/out"
        fi
    done
    echo "$name: $passed tests pass"
}

core aarch64 aarch64-linux-gnu-gcc
same aarch64 qemu-aarch64 aarch64-linux-gnu-gcc
pass aarch64 qemu-aarch64 aarch64-linux-gnu-gcc

sse2="i686-linux-gnu-gcc -msse2 -mfpmath=sse"
core i386-sse2 $sse2
same i386-sse2 "" $sse2
pass i386-sse2 "" $sse2

i686-linux-gnu-gcc -mfpmath=387 -static $flags $sources "$here/digest.c" -lm -o "$work/i386-x87"
gcc $flags $sources "$here/digest.c" -lm -o "$work/native"
"$work/native" --numbers >"$work/a"
"$work/i386-x87" --numbers >"$work/b"
paste -d' ' "$work/a" "$work/b" | awk '
    { d = $2 - $4; d = d < 0 ? -d : d; if (!(d <= most[$1])) most[$1] = d; bad = bad || !(d <= 1e-11) }
    END { for (s in most) printf "i386-x87: %s within %.1e\n", s, most[s] | "sort"; exit bad || NR == 0 }' || bad=1
exit $bad
