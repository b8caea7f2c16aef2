#!/bin/sh
# One test under valgrind, which meson test runs as: memcheck.sh PROGRAM [ARGUMENTS]
#
# Only what valgrind finds counts: its long double has 53 bits, and tests that need more fail there.
found=0
valgrind --quiet --error-exitcode=99 --leak-check=full "$@" || found=$?
[ $found != 99 ]
