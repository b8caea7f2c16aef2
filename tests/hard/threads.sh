#!/bin/sh
# Slices stepped by threads, under the thread sanitizer of every compiler that has one: threads.sh ROOT
# shellcheck disable=SC2046  # sources are words
set -eu
root=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for compiler in gcc clang; do
    echo 'int main(void) { return 0; }' >"$work/try.c"
    "$compiler" -fsanitize=thread "$work/try.c" -o "$work/try" 2>/dev/null || { echo "threads: $compiler skipped"; continue; }
    "$compiler" -std=c99 -O1 -g -fsanitize=thread -ffp-contract=off -I"$root/include" \
        $(ls "$root"/src/vti_*.c | grep -v _avx) "$root/tests/hard/test_threads.c" -lm -pthread -o "$work/threads"
    "$work/threads"
    "$compiler" -std=c99 -O1 -g -fsanitize=thread -I"$root/include" -I"$root/tests" -I"$root/drivers/threads" \
        "$root/drivers/threads/threads.c" "$root/tests/driver/test_parts.c" -lcmocka -lm -pthread -o "$work/parts"
    "$work/parts" >"$work/log" 2>&1 || { cat "$work/log" && exit 1; }
    echo "threads: $compiler finds no race, and the bits are those of one thread"
done
