#!/bin/sh
# Slices stepped by threads, under the thread sanitizer of every compiler that has one: threads.sh ROOT
# shellcheck disable=SC2046  # sources are words
set -eu
root=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# races COMPILER
races() {
    echo 'int main(void) { return 0; }' >"$work/$1.c"
    "$1" -fsanitize=thread "$work/$1.c" -o "$work/$1" 2>/dev/null || { echo "threads: $1 skipped"; return 0; }
    "$1" -std=c99 -O1 -g -fsanitize=thread -ffp-contract=off -I"$root/include" \
        $(find "$root/src" -name 'vti_*.c' ! -name '*_avx*') "$root/tests/hard/test_threads.c" -lm -pthread -o "$work/$1"
    "$work/$1"
    "$1" -std=c99 -O1 -g -fsanitize=thread -I"$root/include" -I"$root/tests" -I"$root/drivers/threads" \
        "$root/drivers/threads/threads.c" "$root/tests/driver/test_parts.c" -lcmocka -lm -pthread -o "$work/$1-parts"
    "$work/$1-parts" >"$work/$1.log" 2>&1 || { cat "$work/$1.log" && exit 1; }
    echo "threads: $1 finds no race, and the bits are those of one thread"
}

races gcc &
first=$!
races clang
wait $first
