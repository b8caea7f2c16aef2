/* SPDX-License-Identifier: BSD-3-Clause
 * What --version says of a program: which build it is, and what of the processor it uses. */
#ifndef VTI_VERSION_H
#define VTI_VERSION_H

/** Prints program, version, commit, compiler, flags and vector units, one a line. */
void version_print(const char *program);

#endif
