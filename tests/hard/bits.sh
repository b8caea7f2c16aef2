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

levels="-O0 -O1,-DVTI_WIDTH=1 -O2 -O3" # of which one is that of compilers without vectors
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

# wide COMPILER LABEL UNIT...: with kernels for these vector units, among which the library picks as it runs
wide() {
    compiler=$1
    label=$1-$2
    shift 2
    objects=
    defines=
    for unit in "$@"; do
        case $unit in
        AVX2) options=-mavx2 ;;
        AVX512) options="-mavx512f -mavx512dq -mavx512vl" ;;
        esac
        for source in "$root"/src/vti_*_"$(echo "$unit" | tr AVX avx)".c; do
            object=$work/$label-$(basename "$source" .c).o
            "$compiler" $flags -O3 $options -c "$source" -o "$object"
            objects="$objects $object"
        done
        defines="$defines -DVTI_HAS_$unit"
    done
    "$compiler" $flags -O3 $defines $sources $objects "$here/digest.c" -lm -o "$work/$label"
    keep "$work/$label"
}

# builds COMPILER: at each level, and with the kernels for wide units
builds() {
    for level in $levels; do
        "$1" $flags $(echo "$level" | tr , ' ') $sources "$here/digest.c" -lm -o "$work/$1$level"
        keep "$work/$1$level"
    done
    case $levels in *v2*) wide "$1" avx2 AVX2 ;; esac
    case $levels in *v4*) wide "$1" avx512 AVX2 AVX512 ;; esac
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
