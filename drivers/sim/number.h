/* SPDX-License-Identifier: BSD-3-Clause
 * Numbers as people write them, in scene files and on the command line alike: 0.01, 1e-3, 1/64, 2^-6. */
#ifndef VTI_NUMBER_H
#define VTI_NUMBER_H

/** Reads one finite number that fills text (blanks around it are allowed): a decimal number, a quotient a/b or a power
 *  a^b of two decimal numbers. Returns 0, or -1 and leaves *value alone. Does not depend on the locale. */
int number_read(const char *text, double *value);

#endif
