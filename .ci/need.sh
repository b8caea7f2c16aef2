# shellcheck shell=sh
# What the project needs, how it is recognised, and what it is called by those who package it. Sourced by ./dev.

# For whom | how it is recognised (one that is there is enough) | apt | dnf | brew | conda (a dash: not there).
needs='
study | command:meson                     | meson                      | meson              | meson             | meson
study | command:ninja command:ninja-build | ninja-build                | ninja-build        | ninja             | ninja
study | command:cc                        | gcc libc6-dev              | gcc                | gcc               | c-compiler
study | command:pkg-config                | pkg-config                 | pkgconf-pkg-config | pkgconf           | pkg-config
study | pkg-config:gsl                    | libgsl-dev                 | gsl-devel          | gsl               | gsl
study | pkg-config:ompi-c header:mpicc/mpi.h | libopenmpi-dev          | openmpi-devel      | open-mpi          | openmpi-mpicc
study | command:mpirun                    | openmpi-bin                | openmpi            | open-mpi          | openmpi
study | pkg-config:hdf5-serial pkg-config:hdf5 command:h5cc | libhdf5-dev | hdf5-devel      | hdf5              | hdf5
study | pkg-config:libfyaml               | libfyaml-dev               | libfyaml-devel     | libfyaml          | libfyaml
study | pkg-config:popt                  | libpopt-dev                | popt-devel         | popt              | popt
study | pkg-config:sqlite3               | libsqlite3-dev             | sqlite-devel       | sqlite            | sqlite
study | command:help2man                  | help2man                   | help2man           | help2man          | help2man
study | python3:h5py                      | python3-h5py               | python3-h5py       | -                 | h5py
study | python3:matplotlib                | python3-matplotlib         | python3-matplotlib | python-matplotlib | matplotlib
tests | command:c++                       | g++                        | gcc-c++            | gcc               | cxx-compiler
tests | command:gfortran                  | gfortran                   | gcc-gfortran       | gcc               | gfortran
tests | pkg-config:cmocka                 | libcmocka-dev              | libcmocka-devel    | cmocka            | cmocka
tests | python3:mpmath                    | python3-mpmath             | python3-mpmath     | -                 | mpmath
more  | command:valgrind                  | valgrind                   | valgrind           | -                 | valgrind
more  | command:cmake                     | cmake                      | cmake              | cmake             | cmake
'

# there KIND:NAME...: whether one of them is; header:COMPILER/NAME is one that this compiler finds (Debian has mpicc
# without it)
there() {
    for what in "$@"; do
        name=${what#*:}
        case $what in
        command:*) command -v "$name" >/dev/null && return 0 ;;
        header:*) echo "#include <${name#*/}>" | "${name%/*}" -E -x c /dev/stdin >/dev/null 2>&1 && return 0 ;;
        pkg-config:*) pkg-config --exists "$name" 2>/dev/null && return 0 ;;
        python3:*) python3 -c "import importlib.util as u, sys; sys.exit(u.find_spec('$name') is None)" 2>/dev/null && return 0 ;;
        esac
    done
    return 1
}

# missing GROUP...: the rows of those groups that nothing on PATH fulfils
missing() {
    for group in "$@"; do
        echo "$needs" | grep "^$group " | while IFS='|' read -r _ probes names; do
            # shellcheck disable=SC2086  # one word per probe
            there $probes || echo "$probes|$names"
        done
    done
}

# column NUMBER: of rows, the names in it, each once, in one line
column() {
    cut -d'|' -f"$1" | tr -s ' ' '\n' | awk '$0 != "" && $0 != "-" && !seen[$0]++' | paste -s -d' ' -
}

# need GROUP...: sees that what they need is there. An environment that has it all (conda, modules, spack) is taken as
# it is; where something is missing the system's own programs come first (another python or meson does not see the
# system's packages), and what is missing then is installed by apt, or named for those who have no apt.
need() {
    [ -n "$(missing "$@")" ] || return 0
    if command -v dpkg-query >/dev/null; then
        PATH=/usr/bin:/bin:$PATH
        # shellcheck disable=SC2046
        need_packages $(missing "$@" | column 2)
        return 0
    fi
    rows=$(missing "$@" | grep -v -e command:valgrind -e command:cmake) || return 0 # tests do without these two
    {
        echo "dev: missing, as commands, pkg-config or python3 know them: $(echo "$rows" | column 1)"
        echo "    dnf install $(echo "$rows" | column 3)"
        echo "    brew install $(echo "$rows" | column 4)            (h5py, mpmath: pip install)"
        echo "    conda install -c conda-forge $(echo "$rows" | column 5)"
    } >&2
    exit 1
}

# need_packages PACKAGE...: installs those of Debian's or Ubuntu's packages that are missing, or says how to.
need_packages() {
    if ! command -v dpkg-query >/dev/null; then
        echo "dev: there is no apt here; needed are, by Debian's names: $*" >&2
        return 0
    fi
    absent=
    for package in "$@"; do
        dpkg-query -W -f '${Status}\n' "$package" 2>/dev/null | grep -q 'ok installed' || absent="$absent $package"
    done
    [ -n "$absent" ] || return 0
    by_hand="apt-get install -y --no-install-recommends$absent"
    if [ "$(id -u)" = 0 ]; then
        as_root=env
    elif command -v sudo >/dev/null; then
        as_root=sudo
    else
        echo "dev: packages are missing, and there is no sudo; as root: $by_hand" >&2
        exit 1
    fi
    echo "dev: installing$absent"
    # shellcheck disable=SC2086  # one word per package
    { $as_root apt-get update -qq &&
        $as_root DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $absent >/dev/null; } ||
        { echo "dev: that failed; as root: $by_hand" >&2; exit 1; }
}

# need_clang: clang with what its sanitizers and profiles link, which it only recommends
need_clang() {
    need_packages clang llvm
    runtime=libclang-rt-$(clang -dumpversion | cut -d. -f1)-dev
    need_packages "$runtime"
}
