/* SPDX-License-Identifier: BSD-3-Clause
 * Numbers as people write them, in scene files and on the command line alike: 0.01, 1e-3, 1/64, 2^-6. They are the same
 * bits on every processor. */
#ifndef VTI_NUMBER_H
#define VTI_NUMBER_H

#include <math.h>

/** What messages say to write. */
#define NUMBER_WRITE "write 0.01, 1e-3, 1/64 or 2^-6"
#define NUMBER_WRITE_COUNT "write 80 or 1e5"

/** Reads one finite number that fills text (blanks around it and around / and ^ are allowed): a decimal number, a
 *  quotient a/b or a power a^b of two decimal numbers. As in mathematics the sign in front belongs to the whole: -2^-2
 *  is -1/4. A number too large for a double, or too small to be told from 0, is refused, and so are hexadecimal
 *  numbers, infinities and NaN. Returns 0, or -1 and leaves *value alone. Does not depend on the locale. */
int number_read(const char *text, double *value);

/** What is said of a text that number_read refuses: that it is none, or one that no double holds. */
const char *number_refusal(const char *text);

enum { NUMBER_TEXT = 32 };

/** Writes the shortest decimal number that reads back as the same double, 0.1 and not 0.10000000000000001, and returns
 *  text. NaN is nan, whatever its sign. */
const char *number_text(double value, char text[NUMBER_TEXT]);

/** The larger; once NaN, it stays. */
static inline double number_larger(double most, double x)
{
    return isnan(most) || x <= most ? most : x;
}

/** Whether a step may divide by it, as the core asks of masses and inertias: it is positive, and so is its inverse,
 *  which of numbers below 1e-308 is none. */
static inline int number_divides(double a)
{
    return a > 0.0 && isfinite(a) && isfinite(1.0 / a);
}

/** For qsort: doubles, none of them NaN, by size. */
int number_ascending(const void *a, const void *b);

/** value, but NaN without a sign: printf writes -nan where the processor has set one, as x86-64 does in 0/0. */
static inline double number_plain(double value)
{
    return isnan(value) ? fabs((double)NAN) : value;
}

/** The same within one expression: printf("%s", NUMBER(h)). */
#define NUMBER(value) number_text((value), (char[NUMBER_TEXT]){0})

#endif
