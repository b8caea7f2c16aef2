/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Pairs of doubles, hi + lo with |lo| <= ulp(hi)/2: numbers of about 100 bits in plain arithmetic. */
#ifndef VTI_DOUBLE_PAIR_H
#define VTI_DOUBLE_PAIR_H

struct pair {
    double hi, lo;
};

static inline struct pair pair_of(double a)
{
    const struct pair r = {a, 0.0};
    return r;
}

/** a + b for |a| >= |b| or a = 0 (Dekker 1971), exactly. */
static inline struct pair ordered_sum(double a, double b)
{
    const double s = a + b;
    const struct pair r = {s, b - (s - a)};
    return r;
}

/** a + b, exactly (Knuth, The Art of Computer Programming 2, 4.2.2). */
static inline struct pair sum(double a, double b)
{
    const double s = a + b, c = s - a;
    const struct pair r = {s, (a - (s - c)) + (b - c)};
    return r;
}

/** a b, exactly: the halves of 26 bits have exact products (Dekker 1971). */
static inline struct pair product(double a, double b)
{
    static const double split = 134217729.0; /* 2^27 + 1 */
    const double p = a * b, sa = split * a, sb = split * b;
    const double ah = sa - (sa - a), al = a - ah, bh = sb - (sb - b), bl = b - bh;
    const struct pair r = {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
    return r;
}

static inline struct pair add(struct pair a, struct pair b)
{
    const struct pair s = sum(a.hi, b.hi), t = sum(a.lo, b.lo), u = ordered_sum(s.hi, s.lo + t.hi);
    return ordered_sum(u.hi, u.lo + t.lo);
}

static inline struct pair times(struct pair a, struct pair b)
{
    const struct pair p = product(a.hi, b.hi);
    return ordered_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

static inline struct pair negative(struct pair a)
{
    const struct pair r = {-a.hi, -a.lo};
    return r;
}

static inline struct pair over(struct pair a, struct pair b)
{
    const struct pair q = pair_of(a.hi / b.hi), rest = add(a, negative(times(q, b)));
    const struct pair q2 = pair_of(rest.hi / b.hi), rest2 = add(rest, negative(times(q2, b)));
    return add(add(q, q2), pair_of(rest2.hi / b.hi));
}

#endif
