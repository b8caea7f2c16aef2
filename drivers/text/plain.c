/* SPDX-License-Identifier: BSD-3-Clause */
#include "plain.h"

#include <math.h>

/* ---- pairs of doubles: hi + lo with |lo| <= ulp(hi)/2 ------------------------------------------------------------ */

struct pair {
    double hi, lo;
};

static struct pair pair_of(double a)
{
    const struct pair r = {a, 0.0};
    return r;
}

/** a + b for |a| >= |b| or a = 0 (Dekker 1971), exactly. */
static struct pair ordered_sum(double a, double b)
{
    const double s = a + b;
    const struct pair r = {s, b - (s - a)};
    return r;
}

/** a + b, exactly (Knuth, The Art of Computer Programming 2, 4.2.2). */
static struct pair sum(double a, double b)
{
    const double s = a + b, c = s - a;
    const struct pair r = {s, (a - (s - c)) + (b - c)};
    return r;
}

/** a b, exactly: the halves of 26 bits have exact products (Dekker 1971). */
static struct pair product(double a, double b)
{
    static const double split = 134217729.0; /* 2^27 + 1 */
    const double p = a * b, sa = split * a, sb = split * b;
    const double ah = sa - (sa - a), al = a - ah, bh = sb - (sb - b), bl = b - bh;
    const struct pair r = {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
    return r;
}

static struct pair add(struct pair a, struct pair b)
{
    const struct pair s = sum(a.hi, b.hi), t = sum(a.lo, b.lo), u = ordered_sum(s.hi, s.lo + t.hi);
    return ordered_sum(u.hi, u.lo + t.lo);
}

static struct pair times(struct pair a, struct pair b)
{
    const struct pair p = product(a.hi, b.hi);
    return ordered_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

static struct pair negative(struct pair a)
{
    const struct pair r = {-a.hi, -a.lo};
    return r;
}

static struct pair over(struct pair a, struct pair b)
{
    const struct pair q = pair_of(a.hi / b.hi), rest = add(a, negative(times(q, b)));
    const struct pair q2 = pair_of(rest.hi / b.hi), rest2 = add(rest, negative(times(q2, b)));
    return add(add(q, q2), pair_of(rest2.hi / b.hi));
}

/* ---- angles ------------------------------------------------------------------------------------------------------ */

static const struct pair two_pi = {0x1.921fb54442d18p+2, 0x1.1a62633145c07p-52};

/** sin x (odd = 1) or cos x (odd = 0) of x = 2 pi k/n in [0, pi/4] by Taylor's series. */
static struct pair series_of_turn(int64_t k, int64_t n, int odd)
{
    const struct pair x = times(two_pi, over(pair_of((double)k), pair_of((double)n))), xx = negative(times(x, x));
    struct pair term = odd ? x : pair_of(1.0), all = term;
    for (int j = odd + 1; j < 30; j += 2) {
        term = over(times(term, xx), pair_of((double)(j * (j + 1))));
        all = add(all, term);
    }
    return all;
}

/** cos x of x = 2 pi k/n in [0, pi], from the first eighth of the turn. */
static struct pair cos_of_half(int64_t k, int64_t n)
{
    if (4 * k == n)
        return pair_of(0.0);
    if (4 * k > n)
        return negative(cos_of_half(n - 2 * k, 2 * n));                                /* -cos(pi - x) */
    return 8 * k <= n ? series_of_turn(k, n, 0) : series_of_turn(n - 4 * k, 4 * n, 1); /* sin(pi/2 - x) */
}

/** r times the cosine; r's exponent apart, so that no product of halves overflows. */
double plain_cos_turn(double r, int64_t k, int64_t n)
{
    int e;
    const double m = frexp(r, &e);
    k %= n;
    k = k < 0 ? k + n : k;
    return ldexp(times(cos_of_half(2 * k > n ? n - k : k, n), pair_of(m)).hi, e);
}

/** sin x = cos(x - pi/2) in [0, pi], and odd. */
double plain_sin_turn(double r, int64_t k, int64_t n)
{
    k %= n;
    k = k < 0 ? k + n : k;
    return 2 * k > n ? -plain_sin_turn(r, n - k, n) : plain_cos_turn(r, 4 * k - n, 4 * n);
}

/* ---- powers ------------------------------------------------------------------------------------------------------ */

static const struct pair ln2 = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

/** log2 a of 0 < a < infinity: a = m 2^e, ln m = 2 (s + s^3/3 + ...) with s = (m - 1)/(m + 1), |s| < 0.172. */
static struct pair log2_of(double a)
{
    int e;
    double m = frexp(a, &e);
    if (m < 0.70710678118654752) {
        m *= 2.0;
        --e;
    }
    const struct pair s = over(pair_of(m - 1.0), sum(m, 1.0)), ss = times(s, s);
    struct pair power = s, all = s;
    for (int j = 3; j < 48; j += 2) {
        power = times(power, ss);
        all = add(all, over(power, pair_of((double)j)));
    }
    return add(pair_of((double)e), over(add(all, all), ln2));
}

/** 2^a = 2^e exp(f ln 2), |f| <= 1/2, by the series of exp. */
static double exp2_of(struct pair a)
{
    if (!(fabs(a.hi) < 1100.0))
        return a.hi > 0.0 ? INFINITY : a.hi < 0.0 ? 0.0 : a.hi;
    const double e = rint(a.hi);
    const struct pair x = times(add(a, pair_of(-e)), ln2);
    struct pair term = pair_of(1.0), all = term;
    for (int j = 1; j < 30; ++j) {
        term = over(times(term, x), pair_of((double)j));
        all = add(all, term);
    }
    return ldexp(all.hi, (int)e);
}

/** a^n for 1 <= n <= 64 by squaring a's mantissa, its exponent apart: exact while the power has at most 106 bits. */
static double whole_power(double a, int n, int inverse)
{
    int e;
    struct pair base = pair_of(frexp(a, &e)), all = pair_of(1.0);
    for (int left = n; left > 0; left /= 2) {
        if (left % 2 == 1)
            all = times(all, base);
        base = times(base, base);
    }
    if (inverse)
        all = over(pair_of(1.0), all);
    return ldexp(all.hi, inverse ? -n * e : n * e);
}

double plain_log2(double a)
{
    if (!(a > 0.0) || isinf(a))
        return a == 0.0 ? -INFINITY : a > 0.0 ? a : NAN;
    return log2_of(a).hi;
}

double plain_exp2(double a)
{
    return exp2_of(pair_of(a));
}

double plain_power(double a, double b)
{
    if (b == 0.0 || a == 1.0)
        return 1.0;
    if (!(a > 0.0) || isinf(a) || !isfinite(b))
        return !(a >= 0.0) || isnan(b) ? NAN : (a > 1.0) == (b > 0.0) ? INFINITY : 0.0;
    if (fabs(b) <= 64.0 && b == rint(b))
        return whole_power(a, (int)fabs(b), b < 0.0);
    const struct pair l = log2_of(a);
    const double about = l.hi * b;
    return fabs(about) < 1100.0 ? exp2_of(times(l, pair_of(b))) : plain_exp2(about);
}
