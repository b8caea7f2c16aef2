#!/bin/sh
# The same bits from both compilers, whatever the optimisation and vector width that this machine has.
#
#     bits.sh compare|store ROOT [COMPILER=LIBVTI.A...]      with, or into, tests/hard/digest.txt
#
# Builds the core and digest.c for each of them, without meson, and compares what they print. Of libraries that are given, built
# by -O3 with all kernels, the objects are taken as they are.
# shellcheck disable=SC2046,SC2086  # flags and sources are words
set -eu
mode=$1
root=$2
here=$root/tests/hard
shift 2
libraries=$*
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The flags that the bits need (meson.build); -std=c99 alone would keep gcc from contracting, but not clang.
flags="-std=c99 -ffp-contract=off -fno-math-errno -fno-trapping-math -I$root/include"

has() {
    for flag in "$@"; do
        grep -qw "$flag" /proc/cpuinfo || return 1
    done
}

# What each build may do that another does not: keep the order of the source (-O0), do without vectors as compilers that
# have none (VTI_WIDTH=1), write vectors of its own (-O3), fuse and write the widest that there are (v3 or v4).
wide=
units=
if [ "$(uname -m)" = x86_64 ]; then
    has avx2 fma bmi2 && wide=-O3,-march=x86-64-v3 && units=AVX2
    has avx512f avx512bw avx512cd avx512dq avx512vl && wide=-O3,-march=x86-64-v4 && units="AVX2 AVX512"
fi

# ./dev lint has built the library by clang
lint=$root/build-lint-clang
if [ -f "$lint/build.ninja" ]; then
    ninja -C "$lint" --quiet src/libvti.a
    libraries="$libraries clang=$lint/src/libvti.a"
fi

sources="$(find "$root/src" -name 'vti_*.c' ! -name '*_avx*') $here/digest.c"

# run PROGRAM: what it prints, and no program; it may fuse nothing, in places that few bodies reach either
run() {
    if command -v objdump >/dev/null && objdump -d "$1" | grep -E 'vfn?m(add|sub)'; then
        echo "$(basename "$1") fuses a product and a sum"
        return 1
    fi
    "$1" >"$1.txt"
    rm "$1"
}

# objects FOLDER COMPILER-WITH-FLAGS SOURCE...: of src/ROOM/FILE named as Meson does
objects() {
    into=$1
    with=$2
    shift 2
    for source in "$@"; do
        $with $flags -c "$source" -o "$into/$(echo "${source#"$root"/src/}" | sed 's:^/.*/:: ; s:/:_:g').o"
    done
}

# core COMPILER: the objects of -O3, those of kernels for wide units among them
core() {
    mkdir "$work/$1-O3"
    for library in $libraries; do
        case $library in
        "$1="*)
            (cd "$work/$1-O3" && ar x "${library#*=}")
            return
            ;;
        esac
    done
    objects "$work/$1-O3" "$1 -O3" $sources
    for unit in $units; do
        case $unit in
        AVX2) options=-mavx2 ;;
        AVX512) options="-mavx512f -mavx512dq -mavx512vl" ;;
        esac
        objects "$work/$1-O3" "$1 -O3 $options" $(find "$root/src" -name "vti_*_$(echo "$unit" | tr AVX avx).c")
    done
}

# picks COMPILER: without and with kernels for wide units, among which the library picks as it runs
picks() {
    core "$1"
    objects "$work/$1-O3" "$1 -O3" "$here/digest.c"
    defines=
    for unit in plain $units; do
        [ $unit = plain ] || defines="$defines -DVTI_HAS_$unit"
        objects "$work/$1-O3" "$1 -O3 $defines" $(grep -l VTI_HAS_ $sources)
        "$1" "$work/$1-O3"/*.o -lm -o "$work/$1-picks-$unit"
        run "$work/$1-picks-$unit"
    done
}

# builds COMPILER: at each level, and with the kernels for wide units
builds() {
    [ "$1$wide" = gcc ] || [ "$1" != gcc ] || wide=$wide,-fno-tree-slp-vectorize # as meson.build has it
    for level in -O0 -O1,-DVTI_WIDTH=1 $wide; do
        "$1" $flags $(echo "$level" | tr , ' ') $sources -lm -o "$work/$1$level"
        run "$work/$1$level"
    done
    picks "$1"
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
