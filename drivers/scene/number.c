/* SPDX-License-Identifier: BSD-3-Clause */
#include "number.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "double_pair.h"
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

/** The decimal number without a sign at *p, which then stands behind it. */
static int read_decimal(const char **p, double *value)
{
    int is_zero;
    const char *end = skip_decimal(*p, &is_zero);
    if (end == NULL)
        return -1;
    char *stop;
    const double x = strtod(*p, &stop);
    /* in a locale with a decimal comma strtod stops at the point: what it has read so far is wrong */
    if (stop != end || !isfinite(x) || (x == 0.0 && !is_zero))
        return -1;
    *p = end;
    *value = x;
    return 0;
}

/* ---- quotients and powers ---------------------------------------------------------------------------------------- */

static int read_second(const char **p, double *value)
{
    const double sign = **p == '-' ? -1.0 : 1.0;
    *p = skip_sign(*p);
    if (read_decimal(p, value) != 0)
        return -1;
    *value *= sign;
    return 0;
}

/** a if nothing follows it at *p, else a/b or a^b. */
static int read_rest(const char **p, double a, double *value)
{
    const char operation = **p;
    double b;
    *value = a;
    if (operation != '/' && operation != '^')
        return 0;
    *p = skip_blanks(*p + 1);
    if (read_second(p, &b) != 0)
        return -1;
    *value = operation == '/' ? a / b : plain_power(a, b);
    return isfinite(*value) && (*value != 0.0 || a == 0.0) ? 0 : -1;
}

int number_read(const char *text, double *value)
{
    const char *p = skip_blanks(text);
    const double sign = *p == '-' ? -1.0 : 1.0;
    double a, x;
    p = skip_sign(p);
    if (read_decimal(&p, &a) != 0)
        return -1;
    p = skip_blanks(p);
    if (read_rest(&p, a, &x) != 0 || *skip_blanks(p) != '\0')
        return -1;
    *value = sign * x;
    return 0;
}

/* ---- writing ----------------------------------------------------------------------------------------------------- */

/** A number greater than 0 as the decimal d.ddd... 10^exponent of 19 digits, which are those of digits + rest, 0 <= rest
 *  < 1. */
struct decimal {
    uint64_t digits;
    double rest;
    int exponent;
};

enum { DECIMAL = 19, EXACT = 22 /* the highest power of 10 that is a double */ };

/** What the rest and what follows from it may be off by. */
static const double doubt = 1e-6;

static double power_of_ten(int k)
{
    static const double power[EXACT + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                            1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    return power[k];
}

/** 1 for 1e-25 <= value < 1e18, whose digits are those of value times one power of ten that is a double, or two: the
 *  first product is exact, the second one errs by less than 2^-100 of itself. */
static int decimal_of(double value, struct decimal *d)
{
    if (!(value >= 1e-25 && value < 1e18))
        return 0;
    int binary;
    frexp(value, &binary);
    d->exponent =
        (int)floor((binary - 1) * 0.30102999566398120); /* of the power of two below, or one less than its own */
    for (;; ++d->exponent) {
        const int shift = DECIMAL - 1 - d->exponent, first = shift < EXACT ? shift : EXACT;
        struct pair p = product(value, power_of_ten(first));
        if (shift > EXACT)
            p = times(p, pair_of(power_of_ten(shift - EXACT)));
        if ((p.hi - 1e19) + p.lo >= 0.0)
            continue;
        const double whole = floor(p.lo); /* p.hi > 2^53 is whole */
        d->digits = (uint64_t)p.hi + (uint64_t)(int64_t)whole;
        d->rest = p.lo - whole;
        return 1;
    }
}

/** The nearest decimal of fewer digits, and how far it is away in units of the last of the 19; 0 where that is in doubt,
 *  between two. */
static int decimal_round(const struct decimal *d, int digits, struct decimal *to, double *away)
{
    const uint64_t unit = (uint64_t)power_of_ten(DECIMAL - digits);
    const double left = (double)(d->digits % unit) + d->rest, half = 0.5 * (double)unit;
    const int up = left > half;
    to->digits = d->digits / unit + (uint64_t)up;
    to->rest = 0.0;
    to->exponent = d->exponent;
    if (to->digits == (uint64_t)power_of_ten(digits)) {
        to->digits /= 10;
        ++to->exponent;
    }
    *away = up ? (double)unit - left : left;
    return fabs(left - half) > doubt;
}

/** As printf writes it with %g. */
static void decimal_text(const struct decimal *d, int digits, char *text)
{
    char digit[DECIMAL] = "";
    uint64_t left = d->digits;
    int count = digits;
    for (int k = digits; k-- > 0; left /= 10)
        digit[k] = (char)('0' + left % 10);
    while (count > 1 && digit[count - 1] == '0')
        --count;
    const int is_plain = d->exponent >= -4 && d->exponent < digits, point = is_plain ? d->exponent + 1 : 1;
    if (point <= 0) {
        *text++ = '0';
        *text++ = '.';
        for (int k = point; k < 0; ++k)
            *text++ = '0';
    }
    for (int k = 0; k < count || k < point; ++k) {
        if (k == point && k > 0)
            *text++ = '.';
        *text++ = k < count ? digit[k] : '0';
    }
    if (!is_plain)
        snprintf(text, sizeof "e-308", "e%+03d", d->exponent);
    else
        *text = '\0';
}

/** Writes the number if the digits that it takes are beyond doubt. What is less than half an ulp away reads back; below
 *  a power of two, a quarter. */
static int shortest(double value, char *text)
{
    struct decimal all, d;
    int binary;
    if (!decimal_of(fabs(value), &all))
        return 0;
    const double mantissa = frexp(fabs(value), &binary), ulp = 0x1p-53 / mantissa * (double)all.digits;
    int digits = DBL_DIG;
    for (;; ++digits) {
        double away;
        if (!decimal_round(&all, digits, &d, &away))
            return 0;
        if (digits == 17 || away < (mantissa > 0.5 ? 0.5 : 0.25) * ulp - doubt)
            break;
        if (away < 0.5 * ulp + doubt)
            return 0;
    }
    if (value < 0.0)
        *text++ = '-';
    decimal_text(&d, digits, text);
    return 1;
}

/** Writes any number, as slowly as trying takes. */
static void try_digits(double value, char text[NUMBER_TEXT])
{
    /* every decimal of up to DBL_DIG digits is what its double prints with that many; only subnormal ones hold fewer */
    int digits = fabs(value) < DBL_MIN ? 1 : DBL_DIG;
    do
        snprintf(text, NUMBER_TEXT, "%.*g", digits, value);
    while (digits++ < 17 && isfinite(value) && strtod(text, NULL) != value);
}

const char *number_text(double value, char text[NUMBER_TEXT])
{
    if (!shortest(value, text))
        try_digits(value, text);
    return text;
}
