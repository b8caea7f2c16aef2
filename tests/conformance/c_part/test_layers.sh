#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Includes point down only:
#     L0  include/, src/             C99, math.h, string.h and the library's own
#     L1  drivers/check              L0 and libc: the conformance kit, for hosts
#     L2  drivers/text, threads, neighbours, tables, scene, effects, clumps, sim, verdict  L0 and libc; no GSL, HDF5 or MPI
#     L3  drivers/rivals             what is below, and GSL
#         then reference, study, sweep, cost  what is below, and the kit
#         then keep, io, run           what is below
#     L4  drivers/programs       L3 and below, and popt
# The core neither allocates nor prints nor ends the program.
#     test_layers.sh SOURCE_DIRECTORY
set -eu
cd "$1"
failed=0

complain() {
    echo "$*" >&2
    failed=1
}

# system_headers FILE..., own_headers FILE...: "file name" of each #include <name>, or "name"
system_headers() {
    grep -HE '^[[:space:]]*#[[:space:]]*include[[:space:]]*<' "$@" | sed -E 's/^([^:]*):[^<]*<([^>]*)>.*/\1 \2/' || true
}
own_headers() {
    grep -HE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' "$@" | sed -E 's/^([^:]*):[^"]*"([^"]*)".*/\1 \2/' || true
}

# names of headers without their folders, which no two of the library share
nameless() {
    sed -E 's: ([a-z.]+/)+: :'
}

# from LIST FOLDER...: every "file name" of the list names a file of one of the folders, or one that is made of NAME.in there
from() {
    list=$1
    shift
    while read -r file name; do
        [ -n "$file" ] || continue
        found=0
        for folder in "$@"; do
            case $name in */*) ;; *) [ ! -f "$folder/$name" ] && [ ! -f "$folder/$name.in" ] || found=1 ;; esac
        done
        [ "$found" = 1 ] || complain "$file includes \"$name\", which is not in: $*"
    done <<EOF
$list
EOF
}

# without LIST PATTERN: no name of the list matches the extended regular expression
without() {
    bad=$(printf '%s\n' "$1" | grep -E " ($2)" || true)
    [ -z "$bad" ] || complain "includes that point up or sideways:
$bad"
}

# L0
core="include/*.h src/*.[ch] src/*/*.[ch]"
# shellcheck disable=SC2086  # patterns of files
{
    strangers=$(system_headers $core | grep -vE ' (float|iso646|limits|math|stdarg|stdbool|stddef|stdint|string)\.h$' || true)
    [ -z "$strangers" ] || complain "the core includes more than C99, math.h and string.h:
$strangers"
    from "$(own_headers include/*.h)" include
    # one room sees what is below it; kernels of a vector unit are compiled as one, so that moves see turns and multistep methods,
    # and dashpots friction, which is carried by the kernels of the same table
    from "$(own_headers src/*.[ch] | nameless)" include src src/lanes src/inertia src/move src/multistep
    from "$(own_headers src/lanes/*.h | nameless)" include src src/lanes
    from "$(own_headers src/move/*.h | nameless)" include src src/lanes src/inertia src/move src/multistep
    from "$(own_headers src/inertia/*.[ch] | nameless)" include src src/lanes src/inertia src/move
    from "$(own_headers src/multistep/*.[ch] | nameless)" include src src/lanes src/move src/multistep
    from "$(own_headers src/bonds/*.[ch] | nameless)" include src src/lanes src/bonds
    from "$(own_headers src/contacts/*.[ch] | nameless)" include src src/lanes src/contacts
    from "$(own_headers src/dissipation/*.[ch] src/friction/*.[ch] | nameless)" include src src/lanes src/contacts src/dissipation src/friction
    calls='(malloc|calloc|realloc|free|alloca|printf|fprintf|sprintf|snprintf|puts|putchar|fopen|exit|_Exit|abort|assert|getenv|setlocale|rand)'
    bad=$(sed -E 's://.*$::; s:"([^"\\]|\\.)*":"":g' $core | awk '{
            line = $0
            while (1) {
                if (comment) { i = index(line, "*/"); if (!i) next; line = substr(line, i + 2); comment = 0 }
                i = index(line, "/*"); if (!i) break
                rest = substr(line, i + 2); printf "%s ", substr(line, 1, i - 1); line = rest; comment = 1
            }
            print line }' | grep -nE "(^|[^A-Za-z0-9_])$calls[[:space:]]*\(" || true)
    [ -z "$bad" ] || complain "the core calls what it must not:
$bad"
}
[ -n "$(own_headers src/*.c)" ] || complain "no includes found in src: this test does not see what it should"

# L1
from "$(own_headers drivers/check/*.[ch])" include drivers/check

# L2 to L4: the rooms of drivers/ from the lowest to the highest. Each sees itself and those before it. Three rooms know each
# other by four headers, as docs/architecture.md explains: a scene is read by what its effects declare (kinds.h, kind.h), and
# effects act in a model (model.h, shape.h).
below=include
for room in text threads neighbours tables scene effects effects/contacts effects/bonds clumps sim verdict \
    rivals rivals/inertia rivals/variable reference check study sweep cost keep io io/vtkhdf run programs; do
    below="$below drivers/$room"
    beyond='-'
    case $room in
    scene) beyond='kinds?[.]h' ;;
    effects*) beyond='(model|shape)[.]h' ;;
    rivals) below="$below drivers/rivals/inertia drivers/rivals/variable" ;; # one room in three folders
    esac
    # shellcheck disable=SC2086  # several folders
    [ $room = check ] || from "$(own_headers drivers/$room/*.[ch] | grep -vE " $beyond\$" || true)" $below
done
for room in drivers/*/ drivers/*/*/; do
    case " $below drivers/plot drivers/plot/pages " in
    *" ${room%/} "*) ;;
    *) case $room in */__pycache__/) ;; *) complain "$room has no place in the order of rooms" ;; esac ;;
    esac
done

# only PATTERN PLACE...: of drivers/, these folders and files alone include system headers of the pattern
all=$(system_headers $(find drivers -name '*.[ch]'))
only() {
    pattern=$1
    shift
    bad=$(printf '%s\n' "$all" | grep -E " ($pattern)" | grep -vE "^drivers/($(echo "$*" | tr ' ' '|'))[/ ]" || true)
    [ -z "$bad" ] || complain "$pattern is included outside: $*
$bad"
}
only libfyaml scene
only pthread threads
only gsl/ rivals reference study cost
only mpi reference study cost
only 'hdf5|H5' io keep/held.c run/run_restart.c
only sqlite3 keep
only popt programs
stray=$(ls drivers/*.[ch] 2>/dev/null || true)
[ -z "$stray" ] || complain "sources outside the rooms of drivers/: $stray"

# the core's private headers stay in src; tests of kernels alone see them
private=$(ls src/*.h src/*/*.h | sed 's:.*/::; s:[.]:[.]:' | paste -s -d '|')
private=$(grep -rlE "#[[:space:]]*include[[:space:]]*[\"<]([^\">]*/)?($private)[\">]" --include='*.[ch]' include drivers bench examples fortran || true)
[ -z "$private" ] || complain "headers that are private to src are included by: $private"
exit $failed
