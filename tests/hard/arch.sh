#!/bin/sh
# The core's bits on other machines than this: aarch64 (run by qemu-user) and i386 with SSE2 and with the x87.
#
#     arch.sh ROOT
#
# aarch64 and SSE2 have to print tests/hard/digest.txt; of the x87, whose registers are wider, the largest difference of the
# numbers at the end of each stepper's run is shown.
# shellcheck disable=SC2046,SC2086  # flags and sources are words
set -eu
root=$1
here=$root/tests/hard
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
flags="-std=c99 -O2 -ffp-contract=off -fno-math-errno -fno-trapping-math -I$root/include"
sources="$(ls "$root"/src/vti_*.c | grep -v '_avx') $here/digest.c"
bad=0

# same NAME [RUNNER]: does what was built as NAME print the stored digest?
same() {
    name=$1
    shift
    "$@" "$work/$name" | grep -v '^libm' >"$work/$name.txt"
    if diff "$here/digest.txt" "$work/$name.txt" >"$work/diff"; then
        echo "$name: the same bits"
    else
        bad=1
        echo "$name: other bits"
        cat "$work/diff"
    fi
}

aarch64-linux-gnu-gcc $flags -static $sources -lm -o "$work/aarch64"
same aarch64 qemu-aarch64

i686-linux-gnu-gcc -msse2 -mfpmath=sse -static $flags $sources -lm -o "$work/i386-sse2"
same i386-sse2
i686-linux-gnu-gcc -mfpmath=387 -static $flags $sources -lm -o "$work/i386-x87"
gcc $flags $sources -lm -o "$work/native"
"$work/native" --numbers >"$work/a"
"$work/i386-x87" --numbers >"$work/b"
paste -d' ' "$work/a" "$work/b" | awk '{ d = $2 - $4; d = d < 0 ? -d : d; if (d > most[$1]) most[$1] = d }
    END { for (s in most) printf "i386-x87: %s within %.1e\n", s, most[s] }' | sort
exit $bad
