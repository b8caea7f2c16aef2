#!/bin/sh
# The same bits from every compiler, optimisation level and vector width that this machine has.
#
#     bits.sh compare|store ROOT      with, or into, tests/hard/digest.txt
#
# Builds the core and digest.c once for each of them, without meson, and compares what they print.
# shellcheck disable=SC2046,SC2086  # flags and sources are words
set -eu
mode=$1
root=$2
here=$root/tests/hard
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The flags that the bits need (meson.build); -std=c99 alone would keep gcc from contracting, but not clang.
flags="-std=c99 -ffp-contract=off -fno-math-errno -fno-trapping-math -I$root/include"

has() {
    for flag in "$@"; do
        grep -qw "$flag" /proc/cpuinfo || return 1
    done
}

levels="-O0 -O1 -O2 -O3"
if [ "$(uname -m)" = x86_64 ]; then
    has sse4_2 popcnt && levels="$levels -O3,-march=x86-64-v2"
    has avx2 fma bmi2 && levels="$levels -O3,-march=x86-64-v3"
    has avx512f avx512bw avx512cd avx512dq avx512vl && levels="$levels -O3,-march=x86-64-v4"
fi

sources=$(ls "$root"/src/vti_*.c | grep -v '_avx')

# keep PROGRAM: what it prints, and no program
keep() {
    "$1" >"$1.txt"
    rm "$1"
}

# builds COMPILER: at each level, and with the wide kernels of bonds among which the library picks as it runs
builds() {
    for level in $levels; do
        "$1" $flags $(echo "$level" | tr , ' ') $sources "$here/digest.c" -lm -o "$work/$1$level"
        keep "$work/$1$level"
    done
    case $levels in
    *v2*)
        "$1" $flags -O3 -mavx2 -c "$root/src/vti_bond_avx2.c" -o "$work/$1-avx2.o"
        "$1" $flags -O3 -DVTI_WIDE $sources "$work/$1-avx2.o" "$here/digest.c" -lm -o "$work/$1-wide"
        keep "$work/$1-wide"
        ;;
    esac
}

pids=
for compiler in gcc clang; do
    if command -v $compiler >/dev/null; then
        builds $compiler &
        pids="$pids $!"
    fi
done
for pid in $pids; do
    wait "$pid" || { echo "bits: a build failed"; exit 1; }
done

# differs KEPT MADE LABEL: says so if they do
differs() {
    ! diff "$1" "$2" >"$work/diff" || return 1
    echo "$3 differs from $(basename "$1"):"
    cat "$work/diff"
}

first=$(find "$work" -name '*.txt' | sort | head -n 1)
[ "$mode" = compare ] || cp "$first" "$here/digest.txt"

bad=0
count=0
for made in "$work"/*.txt; do
    label=$(basename "$made" .txt)
    differs "$here/digest.txt" "$made" "$label" && bad=1
    count=$((count + 1))
done
echo "bits: $count builds, $(wc -l <"$here/digest.txt") digests"
exit $bad
