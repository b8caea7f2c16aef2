/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A Runge-Kutta method is of order p if for every rooted tree t of up to p nodes
 *
 *     sum_i b_i Phi_i(t) = 1/gamma(t),   Phi_i([t_1 ... t_m]) = prod_k sum_j a_ij Phi_j(t_k),
 *     gamma(t) = |t| prod_k gamma(t_k)
 *
 * (E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed. (1993), II.2): the tableaus
 * of the rivals meet all these conditions to rounding, and not those of order p + 1. The conditions are 200 for order 8
 * and 486 for order 9: a wrong digit breaks some of them. */
#include "journey.h"

#include "runge_kutta.h"

enum { TREES_MOST = 2000, ORDER_MOST = 10 };

/** What a tree's parent needs: sum_j a_ij Phi_j, and the same of absolute values, which bounds the rounding. */
struct tree {
    int order;
    long double gamma, inner[TABLEAU_STAGES], size[TABLEAU_STAGES];
};

static struct tree trees[TREES_MOST];
static int trees_count;

/** Phi of a tree on its way. */
struct product {
    long double gamma, phi[TABLEAU_STAGES], size[TABLEAU_STAGES];
};

/** How far the worst condition of each order is off, over the rounding of coefficients that are right to 1/2 EPS. */
static double worst[ORDER_MOST + 1];
static int64_t conditions[ORDER_MOST + 1];

static void hold_to(const struct tableau *t, int order, const struct product *p)
{
    long double sum = 0.0L, size = 0.0L;
    for (int i = 0; i < t->stages; ++i) {
        sum += (long double)t->b[i] * p->phi[i];
        size += fabsl((long double)t->b[i]) * p->size[i];
    }
    const long double off = fabsl(sum - 1.0L / (p->gamma * order)), rounding = (0.5L * EPS) * order * size;
    worst[order] = fmax(worst[order], (double)(off / rounding));
    ++conditions[order];
}

static void keep(const struct tableau *t, int order, const struct product *p)
{
    assert_true(trees_count < TREES_MOST);
    struct tree *tree = &trees[trees_count++];
    memset(tree, 0, sizeof *tree);
    tree->order = order;
    tree->gamma = p->gamma * order;
    for (int i = 0; i < t->stages; ++i)
        for (int j = 0; j < i; ++j) {
            tree->inner[i] += (long double)t->a[i][j] * p->phi[j];
            tree->size[i] += fabsl((long double)t->a[i][j]) * p->size[j];
        }
}

/** All trees of that order whose further children, of left nodes together, are none after trees[last]. */
static void grow(const struct tableau *t, int order, int left, int last, const struct product *so_far)
{
    if (left == 0) {
        hold_to(t, order, so_far);
        keep(t, order, so_far);
        return;
    }
    for (int k = 0; k <= last; ++k) {
        struct product p = *so_far;
        if (trees[k].order > left)
            continue;
        p.gamma *= trees[k].gamma;
        for (int i = 0; i < t->stages; ++i) {
            p.phi[i] *= trees[k].inner[i];
            p.size[i] *= trees[k].size[i];
        }
        grow(t, order, left - trees[k].order, k, &p);
    }
}

static void assert_order(const char *name, const struct tableau *t)
{
    /* rooted trees of 1, 2, ... nodes: A. Cayley (1857) */
    static const int64_t known[] = {0, 1, 1, 2, 4, 9, 20, 48, 115, 286, 719};
    struct product one = {1.0L, {0.0L}, {0.0L}};
    for (int i = 0; i < t->stages; ++i)
        one.phi[i] = one.size[i] = 1.0L;
    trees_count = 0;
    memset(worst, 0, sizeof worst);
    memset(conditions, 0, sizeof conditions);
    for (int order = 1; order <= t->order + 1; ++order) {
        grow(t, order, order - 1, trees_count - 1, &one);
        print_message("%s: order %d: %lld conditions, off by %.3g roundings\n", name, order,
                      (long long)conditions[order], worst[order]);
        assert_int_equal(conditions[order], known[order]);
        if (order <= t->order)
            assert_below(worst[order], 1.0);
    }
    assert_below(1e6, worst[t->order + 1]);
}

/** Weights e such that b - e makes a formula of that order, and no higher. */
static void assert_embedded(const char *name, const struct tableau *t, const double *e, int order)
{
    struct tableau embedded = *t;
    embedded.order = order;
    for (int i = 0; i < t->stages; ++i)
        embedded.b[i] -= e[i];
    assert_order(name, &embedded);
}

TEST(conditions_hold)
{
    assert_embedded("dop853's error of order 5", &tableau_dop853, tableau_dop853_error[0], 5);
    assert_embedded("dop853's error of order 3", &tableau_dop853, tableau_dop853_error[1], 3);
    assert_order("rk4", &tableau_rk4);
    assert_order("pd8", &tableau_pd8);
    assert_order("dop853", &tableau_dop853);
    assert_order("vern9", &tableau_vern9);
}

/** pd8 is GSL's rk8pd: the same stages with another order of their sums. */
TEST(pd8_is_rk8pd)
{
    struct scene scene;
    struct journey ours, gsl;
    read_scene("chain", &scene);
    begin(&ours, &scene, method_of("pd8"), 1.0 / 16);
    begin(&gsl, &scene, method_of("rk8pd"), 1.0 / 16);
    go(&ours, 32);
    go(&gsl, 32);
    const vti_bodies a = travel_bodies(&ours.travel), b = travel_bodies(&gsl.travel);
    assert_below(attitude_distance(&a, &b), 1e-12);
    assert_below(velocity_distance(&a, &b), 1e-12);
    assert_int_equal(travel_force_evals(&ours.travel), travel_force_evals(&gsl.travel));
    end(&ours);
    end(&gsl);
}

RUN_TESTS_OF_SCENES(cmocka_unit_test(conditions_hold), cmocka_unit_test(pd8_is_rk8pd))
