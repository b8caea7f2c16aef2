/* SPDX-License-Identifier: BSD-3-Clause */
#include "number.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plain.h"

/* ---- the grammar: decimal numbers only, whatever strtod knows beyond them ---------------------------------------- */

static const char *skip_blanks(const char *p)
{
    while (*p == ' ' || *p == '\t')
        ++p;
    return p;
}

static const char *skip_digits(const char *p)
{
    while (*p >= '0' && *p <= '9')
        ++p;
    return p;
}

static const char *skip_sign(const char *p)
{
    return *p == '+' || *p == '-' ? p + 1 : p;
}

/** Behind digits[.digits][e[sign]digits] with at least one digit before the exponent; NULL if p starts with no such
 *  thing. *is_zero: all its digits are 0. */
static const char *skip_decimal(const char *p, int *is_zero)
{
    const char *end = skip_digits(p);
    int digits = (int)(end > p);
    if (*end == '.') {
        const char *fraction = end + 1;
        end = skip_digits(fraction);
        digits = digits || end > fraction;
    }
    *is_zero = 1;
    for (const char *q = p; q < end; ++q)
        *is_zero = *is_zero && (*q == '0' || *q == '.');
    if (!digits)
        return NULL;
    if (*end == 'e' || *end == 'E') {
        const char *exponent = skip_sign(end + 1);
        const char *exponent_end = skip_digits(exponent);
        if (exponent_end > exponent)
            end = exponent_end;
    }
    return end;
}

/** The decimal number without a sign at *p, which then stands behind it. *fits becomes 0 if no double holds it. */
static int read_decimal(const char **p, double *value, int *fits)
{
    int is_zero;
    const char *end = skip_decimal(*p, &is_zero);
    if (end == NULL)
        return -1;
    char *stop;
    const double x = strtod(*p, &stop);
    /* in a locale with a decimal comma strtod stops at the point: what it has read so far is wrong */
    if (stop != end)
        return -1;
    *fits &= isfinite(x) && (x != 0.0 || is_zero);
    *p = end;
    *value = x;
    return 0;
}

/* ---- quotients and powers ---------------------------------------------------------------------------------------- */

static int read_second(const char **p, double *value, int *fits)
{
    const double sign = **p == '-' ? -1.0 : 1.0;
    *p = skip_sign(*p);
    if (read_decimal(p, value, fits) != 0)
        return -1;
    *value *= sign;
    return 0;
}

/** a if nothing follows it at *p, else a/b or a^b. */
static int read_rest(const char **p, double a, double *value, int *fits)
{
    const char operation = **p;
    double b;
    *value = a;
    if (operation != '/' && operation != '^')
        return 0;
    *p = skip_blanks(*p + 1);
    if (read_second(p, &b, fits) != 0)
        return -1;
    if (!*fits)
        return 0;
    *value = operation == '/' ? a / b : plain_power(a, b);
    *fits &= isfinite(*value) && (*value != 0.0 || a == 0.0);
    return 0;
}

/** Returns 0 if text is a number, whether it fits or not. */
static int parse(const char *text, double *value, int *fits)
{
    const char *p = skip_blanks(text);
    const double sign = *p == '-' ? -1.0 : 1.0;
    double a, x;
    p = skip_sign(p);
    *fits = 1;
    if (read_decimal(&p, &a, fits) != 0)
        return -1;
    p = skip_blanks(p);
    if (read_rest(&p, a, &x, fits) != 0 || *skip_blanks(p) != '\0')
        return -1;
    *value = sign * x;
    return 0;
}

int number_read(const char *text, double *value)
{
    double x;
    int fits;
    if (parse(text, &x, &fits) != 0 || !fits)
        return -1;
    *value = x;
    return 0;
}

const char *number_refusal(const char *text)
{
    double x;
    int fits;
    return parse(text, &x, &fits) == 0 && !fits
               ? "is too small or too large to hold; give a number from 5e-324 to 1.79e308 in size, or 0"
               : "is not a number; " NUMBER_WRITE;
}

/* ---- writing ----------------------------------------------------------------------------------------------------- */

enum { DIGITS = 17 }; /* that every double is read back from */

/** Whether value is what is read, in a locale with a decimal point. */
static int reads(const char *text, double value)
{
    return strtod(text, NULL) == value || !isfinite(value);
}

/** Writes so many digits. Returns whether they are read as value. */
static int write_digits(int digits, double value, char text[NUMBER_TEXT])
{
    char written[NUMBER_TEXT]; /* gcc -O3 -fsanitize=undefined warns that text may be NULL if it prints there */
    snprintf(written, sizeof written, "%.*g", digits, value);
    memcpy(text, written, sizeof written);
    return reads(text, value);
}

/** A decimal number: its digits and a zero, and the power of ten of the first. */
struct decimal {
    char sign, digit[DIGITS + 1];
    int exponent;
};

static struct decimal all_digits(double value)
{
    struct decimal d = {'\0', "", 0};
    char written[NUMBER_TEXT];
    snprintf(written, sizeof written, "%.*e", DIGITS - 1, value);
    const char *p = written;
    d.sign = *p == '-' ? *p++ : '\0';
    d.digit[0] = p[0];
    memcpy(d.digit + 1, p + 2, DIGITS - 1);
    d.exponent = atoi(p + DIGITS + 2);
    return d;
}

/** Leaves so many digits, rounded. Returns -1 where those that go are a half, of which the digits alone do not show to
 *  which side value is. */
static int leave(struct decimal *d, int digits)
{
    if (d->digit[digits] == '5' && strspn(d->digit + digits + 1, "0") == (size_t)(DIGITS - digits - 1))
        return -1;
    int k = digits - 1;
    if (d->digit[digits] < '5')
        return 0;
    while (k >= 0 && d->digit[k] == '9')
        d->digit[k--] = '0';
    if (k >= 0)
        ++d->digit[k];
    else
        d->digit[0] = '1';
    d->exponent += k < 0;
    return 0;
}

/** As %.*g writes them. */
static void put_digits(const struct decimal *d, int digits, char text[NUMBER_TEXT])
{
    const int is_short = d->exponent >= -4 && d->exponent < digits, whole = is_short ? d->exponent + 1 : 1;
    char *p = text;
    int last = digits;
    while (last > 1 && d->digit[last - 1] == '0')
        --last;
    if (d->sign != '\0')
        *p++ = d->sign;
    if (whole <= 0)
        *p++ = '0';
    for (int k = 0; k < whole; ++k)
        *p++ = d->digit[k];
    if (last > whole)
        *p++ = '.';
    for (int k = whole; k < last; ++k)
        *p++ = k < 0 ? '0' : d->digit[k];
    *p = '\0';
    if (!is_short)
        snprintf(p, 8, "e%+03d", d->exponent);
}

/** write_digits without printf where all digits tell. */
static int write_rounded(const struct decimal *all, int digits, double value, char text[NUMBER_TEXT])
{
    struct decimal d = *all;
    if (leave(&d, digits) != 0)
        return write_digits(digits, value, text);
    put_digits(&d, digits, text);
    return reads(text, value);
}

const char *number_text(double value, char text[NUMBER_TEXT])
{
    value = number_plain(value);
    /* every decimal of up to DBL_DIG digits is what its double prints with that many; only subnormal ones hold fewer */
    if (!(fabs(value) >= DBL_MIN && isfinite(value))) {
        for (int digits = 1; !write_digits(digits, value, text) && digits < DIGITS;)
            ++digits;
        return text;
    }
    const struct decimal all = all_digits(value);
    char shorter[NUMBER_TEXT];
    if (!write_rounded(&all, DIGITS - 1, value, text)) /* half of all doubles */
        put_digits(&all, DIGITS, text);
    else if (write_rounded(&all, DBL_DIG, value, shorter))
        memcpy(text, shorter, sizeof shorter);
    return text;
}

int number_ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}
