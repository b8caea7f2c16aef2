#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Installs the module files that a program which uses vti needs.      install_modules.sh OBJECT_FOLDER FOLDER
set -eu
case $2 in
/*) into=${DESTDIR:-}$2 ;;
*) into=$MESON_INSTALL_DESTDIR_PREFIX/$2 ;;
esac
mkdir -p "$into"
for file in "$1"/*.mod; do
    case $file in
    */vti_f77_*) ;; # of the procedures without modules
    *) install -m 644 "$file" "$into" ;;
    esac
done
[ -n "${MESON_INSTALL_QUIET:-}" ] || echo "Installed Fortran modules to $into"
