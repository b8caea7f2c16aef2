/* SPDX-License-Identifier: BSD-3-Clause
 * What --version says of a program: which build it is, and what of the processor it uses. */
#ifndef VTI_VERSION_H
#define VTI_VERSION_H

/** If --version is among the arguments (before "--"): prints program, version, commit, compiler, flags and vector units, one a
 *  line, if print is not 0, and returns 1. Else returns 0. */
int version_asked(int argc, char **argv, const char *program, int print);

#endif
