#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The binary interface of the library is the one that is stored, or the stored one is written anew.
#     abi.sh compare|store PROJECT FOLDER
# FOLDER holds constants.txt, the constants of the headers, and vti-MACHINE.abi, functions and types as abidw of abigail-tools
# describes them. Any change is reported. One that breaks a program that is linked already needs another VTI_ABI where a
# struct has changed, and another major version (of 0.y.z the minor one).
set -eu
task=$1 project=$2 folder=$3
stored=$folder/vti-$(uname -m).abi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$project"

# Constants have no type in the functions' signatures, so abidw does not see them.
grep -ohE 'VTI_[A-Z0-9_]+ = -?[0-9]+|ROW\(VTI_[A-Z0-9_]+, -?[0-9]+|define VTI_(ABI|TERMS) [0-9]+' include/*.h |
    sed 's/define //; s/ = / /; s/ROW(//; s/,//' |
    LC_ALL=C sort >"$work/constants.txt"
[ "$(wc -l <"$work/constants.txt")" -gt 20 ]

changed() {
    echo "The binary interface has changed. If that is meant to be: ./dev abi, and see in abi.sh what it means for versions."
    exit 1
}

if [ "$task" = compare ]; then
    diff "$folder/constants.txt" "$work/constants.txt" || changed
    if [ ! -f "$stored" ]; then
        echo "skipped: no description is stored for this machine, $(uname -m)"
        exit 77
    fi
fi
if ! command -v abidiff >/dev/null || ! command -v abidw >/dev/null; then
    echo "skipped: abidiff is not here (package abigail-tools)"
    exit 77
fi

# The library with debug information and unoptimised, so that nothing is optimised out of the description, without the kernels of
# wider vector units, which show nothing.
# shellcheck disable=SC2046  # sources are words
${CC:-cc} -std=c99 -g -O0 -fPIC -fvisibility=hidden -Iinclude -shared -Wl,-soname,libvti.so $(find src -name '*.c' ! -name '*_avx*' | sort) \
    -o "$work/libvti.so" -lm

if [ "$task" = store ]; then
    abidw --no-corpus-path --no-comp-dir-path --no-show-locs --out-file "$work/vti.abi" "$work/libvti.so"
    mkdir -p "$folder"
    mv "$work/constants.txt" "$folder/constants.txt"
    mv "$work/vti.abi" "$stored"
else
    abidiff "$stored" "$work/libvti.so" || changed
fi
