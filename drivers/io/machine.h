/* SPDX-License-Identifier: BSD-3-Clause
 * The machine and the build that times were taken with. */
#ifndef VTI_MACHINE_H
#define VTI_MACHINE_H

#include <stdio.h>

/** Lines "key: value": cpu, cores, system, compiler, flags. */
void machine_write(FILE *file);

#endif
