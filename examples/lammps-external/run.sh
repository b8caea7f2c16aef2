#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Builds and checks this example with the LAMMPS of the distribution:   run.sh PROJECT_BUILD_FOLDER WORK_FOLDER
set -eu
build=$(realpath "$1")
mkdir -p "$2"
work=$(realpath "$2")
cd "$(dirname "$0")"

pkg-config --exists liblammps || { echo "lammps-external: there is no liblammps here; the package is liblammps-dev" >&2; exit 1; }
# shellcheck disable=SC2046  # one word per flag
mpicc -std=c99 -O2 -ffp-contract=off -Wall -Wextra -pedantic -Wconversion -Wshadow -Wstrict-prototypes -Wvla \
    -I../../include $(pkg-config --cflags liblammps) chain.c report.c scene.c -o "$work/lammps_chain" \
    "$build/src/libvti.a" $(pkg-config --libs liblammps) -lm
exec python3 check.py ../chain "$build/drivers/vti-run" "$work/lammps_chain"
