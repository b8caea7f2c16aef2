/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Dashpots and friction by chunks of the bodies, on three threads: friction's loads and springs have the bits of one
 * piece; a sweep of dashpots is adjoint to the sweep back, and loses what it books. */
#define _POSIX_C_SOURCE 200809L
#include "model_support.h"

#include "contacts/contact.h"
#include "friction.h"
#include "threads.h"

enum { N = 13 * 8 * 11, CONTACT = 0, WALL = 1, FRICTION = 2, DASHPOT = 3 };

#define SCENE                                                                                                          \
    "bodies: {lattice: {counts: [13, 8, 11], spacing: 0.99, corner: [0, 0, 0.49]}, diameter: 1, mass: 1.5,\n"          \
    "         random: {seed: 5, v: 1, omega: 2}}\n"                                                                    \
    "contact: {stiffness: 1000}\nwall: {stiffness: 1000, planes: [[0, 0, 1, 0]], spins: [%s]}\n" TIME
#define FRICTION_OF                                                                                                    \
    "friction: {sliding: 0.3, poisson: 0.3, rolling: 0.1, rolling_stiffness: 50, twisting: 0.1,\n"                     \
    "           twisting_stiffness: 50}\n"
#define DASHPOTS "dashpot: {zeta: 0.4, ratio: 0.5, tangential: 2, rolling: 0.7, twisting: 0.5, pull: yes}\n"

static void make_scene(const char *spin, const char *effects, struct scene *scene, struct model *model)
{
    char text[1024];
    snprintf(text, sizeof text, SCENE "%s", spin, effects);
    make_model(text, scene, model);
}

static const struct chunks *chunks_of_model(const struct model *model)
{
    struct effect_surfaces surfaces = {NULL, NULL, 0.0, NULL};
    model->instances[CONTACT].kind->surfaces(&model->instances[CONTACT], &surfaces);
    assert_non_null(surfaces.chunks);
    return surfaces.chunks;
}

/* ---- chunks ------------------------------------------------------------------------------------------------------ */

/** Groups of a round share no chunk, and every two chunks are in one. */
TEST(rounds)
{
    struct chunks c;
    int64_t round = 0, inside = 0;
    assert_int_equal(chunks_create(&c, 100000), 0);
    assert_true(c.count == CHUNKS_MOST && c.ends[c.rounds - 1] == c.groups);
    for (int64_t g = 0; g < c.groups; ++g) {
        const int64_t low = c.group[g].low, high = c.group[g].high;
        while (g == c.ends[round])
            ++round;
        inside += low == high;
        assert_true(low <= high && (low == high) == (round == 0) && c.rank[low * c.count + high] == g);
        for (int64_t o = round > 0 ? c.ends[round - 1] : 0; o < g; ++o)
            assert_true(c.group[o].low != low && c.group[o].low != high && c.group[o].high != low &&
                        c.group[o].high != high);
    }
    assert_int_equal(inside, c.count);
    chunks_destroy(&c);
}

/** As if every seventh pair's bond had broken where it is: it touches at that distance. The bodies of one more pair
 *  have been apart since, by which the list is taken again. */
static void part(struct model *model)
{
    struct message message;
    struct contact_self *contact = model->instances[CONTACT].self;
    const vti_contacts *list = &contact->contacts;
    contact->parts = 1;
    for (int64_t k = 0; k < list->count; k += 7)
        assert_int_equal(
            partings_add(&contact->partings, list->pair[2 * k], list->pair[2 * k + 1], 0.985, &list->diameter), 0);
    assert_int_equal(partings_add(&contact->partings, 0, N - 1, 0.5, &list->diameter), 0);
    assert_int_equal(contact_release(&model->instances[CONTACT], &model->bodies, 0, NULL, &message), 0);
    assert_non_null(list->length.p);
}

/** Every pair of the list is in one group, that of its bodies' chunks, in the order of the list, with its length. */
TEST(groups)
{
    struct scene scene;
    struct model model;
    make_scene("0", FRICTION_OF, &scene, &model);
    part(&model);
    const struct chunks *c = chunks_of_model(&model);
    const vti_contacts *list = model.effects[CONTACT].self;
    int64_t pairs = 0, begun = 0;
    assert_true(c->count > 3 && c->groups == c->count * (c->count + 1) / 2);
    for (int64_t k = 0; k < c->count; ++k)
        begun += c->of[k].count;
    for (int64_t i = 1; i < N; ++i)
        assert_in_range(chunks_of(c, i), chunks_of(c, i - 1), chunks_of(c, i - 1) + 1);
    assert_int_equal(chunks_of(c, N - 1), c->count - 1);
    for (int64_t g = 0; g < c->groups; ++g) {
        const struct chunk_group *group = &c->group[g];
        const int64_t *const pair = group->contacts.pair;
        int64_t at = 0;
        pairs += group->contacts.count;
        for (int64_t k = 0; k < group->contacts.count; ++k) {
            while (list->pair[2 * at] != pair[2 * k] || list->pair[2 * at + 1] != pair[2 * k + 1])
                assert_true(++at < list->count);
            assert_same_bits(&group->contacts.length.p[k], &list->length.p[at], 1);
            assert_int_equal(chunks_of(c, pair[2 * k]), group->low);
            assert_int_equal(chunks_of(c, pair[2 * k + 1]), group->high);
            assert_true(k == 0 || pair[2 * k] > pair[2 * k - 2] ||
                        (pair[2 * k] == pair[2 * k - 2] && pair[2 * k + 1] > pair[2 * k - 1]));
        }
    }
    assert_true(pairs == list->count && pairs == begun && pairs > 2 * N);
    model_destroy(&model);
}

/* ---- friction ---------------------------------------------------------------------------------------------------- */

/** Friction in one piece, beside a model's. */
struct whole {
    vti_friction friction;
    vti_history history;
    vti_walls walls;
    vti_sum lost[VTI_FRICTION_BOOKS], work;
};

static void make_whole(const struct model *model, struct whole *w)
{
    static vti_held entries[16384];
    static int64_t slot[16384];
    const struct friction_self *self = model->instances[FRICTION].self;
    memset(slot, 0, sizeof slot);
    memset(w, 0, sizeof *w);
    w->history.slots = 16384;
    w->history.held = entries;
    w->history.slot = slot;
    w->friction = self->friction;
    w->friction.history = &w->history;
    w->friction.lost = w->lost;
    w->walls = *self->friction.walls;
    w->walls.work = &w->work;
    w->friction.walls = &w->walls;
}

static const double *loads_of(const vti_effect *effect, const vti_bodies *b)
{
    assert_int_equal(vti_apply(effect, 1, b), VTI_OK);
    return b->force.c[0];
}

/** What slices of the bodies feel, each by itself, as threads do it. */
static void assert_slices_same(const struct effect *e, const vti_bodies *b, const double *force, const double *moment)
{
    enum { SLICES = 3 };
    for (int64_t k = 0; k < SLICES; ++k) {
        const int64_t first = threads_begin(N, k, SLICES), count = threads_begin(N, k + 1, SLICES) - first;
        vti_bodies slice = vti_bodies_slice(*b, first, count);
        struct effect_part part;
        memset(&part, 0, sizeof part);
        assert_int_equal(vti_bodies_seal(&slice), VTI_OK);
        assert_int_equal(friction_take_part(e, &slice, &part), 0);
        assert_int_equal(vti_apply(&part.made, 1, &slice), VTI_OK);
        assert_same_bits(force + 3 * first, b->force.c[0] + 3 * first, 3 * count);
        assert_same_bits(moment + 3 * first, b->moment.c[0] + 3 * first, 3 * count);
        free(part.memory);
    }
}

static void assert_same_loads(struct model *model, const vti_effect *whole)
{
    const vti_bodies *b = &model->bodies;
    static double force[3 * N], moment[3 * N];
    const vti_effect *parts = &model->effects[FRICTION];
    memcpy(force, loads_of(whole, b), sizeof force);
    memcpy(moment, b->moment.c[0], sizeof moment);
    assert_same_bits(force, loads_of(parts, b), 3 * N);
    assert_same_bits(moment, b->moment.c[0], 3 * N);
    assert_slices_same(&model->instances[FRICTION], b, force, moment);
    double energies[2][VTI_FRICTION_BOOKS];
    whole->energy(whole->self, b, energies[0]);
    parts->energy(parts->self, b, energies[1]);
    for (int k = 0; k < VTI_FRICTION_BOOKS; ++k) {
        assert_true(energies[0][k] > 0.0);
        assert_close(energies[1][k], energies[0][k], 4 * EPS * energies[0][k]);
    }
}

/** Over drifts in which touches begin, slide and end, some of them of bonds that have broken, by all bodies and by
 *  slices, and with what a checkpoint keeps. */
TEST(friction_as_in_one_piece)
{
    struct scene scene;
    struct model model;
    struct whole w;
    make_scene("1", FRICTION_OF, &scene, &model);
    make_whole(&model, &w);
    part(&model);
    const vti_effect whole = vti_friction_effect(&w.friction), *parts = &model.effects[FRICTION];
    const struct friction_self *self = model.instances[FRICTION].self;
    const vti_drifted drifted = {.t = 1.0 / 64, .law = VTI_LAW_EXACT9};
    for (int step = 0; step < 6; ++step) {
        assert_int_equal(vti_drift(VTI_LAW_EXACT9, VTI_FRAME_SPACE, drifted.t, &model.bodies, NULL), VTI_OK);
        assert_int_equal(model_find_pairs(&model, &model.bodies), VTI_OK);
        whole.carry(whole.self, &model.bodies, &drifted);
        parts->carry(parts->self, &model.bodies, &drifted);
        assert_same_loads(&model, &whole);
    }
    assert_true(w.history.used > 1000 && w.history.missed == 0 && w.work.high != 0.0);
    for (int k = 0; k < VTI_FRICTION_BOOKS; ++k) {
        const double lost = vti_sum_value(&w.lost[k]);
        assert_true(lost > 0.0);
        assert_close(vti_sum_value(&self->friction.lost[k]), lost, 4 * EPS * lost);
    }
    assert_close(vti_sum_value(self->friction.walls->work), vti_sum_value(&w.work), 4 * EPS * fabs(w.work.high));
    const int64_t size = model_memory_size(&model);
    double *memory = calloc((size_t)size, sizeof *memory);
    assert_non_null(memory);
    model_memory_get(&model, memory);
    assert_int_equal(model_memory_put(&model, memory, size), 0);
    assert_same_loads(&model, &whole);
    free(memory);
    model_destroy(&model);
}

/** Springs for which one chunk, the first or another, has no room are missed by all; once. */
TEST(springs_that_found_no_room)
{
    for (int64_t chunk = 0; chunk < 2; ++chunk) {
        struct scene scene;
        struct model model;
        make_scene("0", FRICTION_OF, &scene, &model);
        const struct friction_self *self = model.instances[FRICTION].self;
        const vti_effect *e = &model.effects[FRICTION];
        const vti_drifted drifted = {.t = 1.0 / 64, .law = VTI_LAW_EXACT9};
        vti_history *history = &self->chunk[chunk].history;
        const int64_t slots = history->slots;
        assert_int_equal(model_find_pairs(&model, &model.bodies), VTI_OK);
        assert_int_equal(e->check(e->self, &model.bodies), VTI_OK);
        history->slots = 2;
        e->carry(e->self, &model.bodies, &drifted);
        history->slots = slots;
        const int64_t missed = self->friction.history->missed;
        assert_true(missed > 0 && (chunk == 0 || history->missed == 0));
        assert_int_equal(e->check(e->self, &model.bodies), VTI_E_HISTORY);
        e->carry(e->self, &model.bodies, &drifted);
        assert_int_equal(self->friction.history->missed, missed);
        model_destroy(&model);
    }
}

/* ---- dashpots ---------------------------------------------------------------------------------------------------- */

enum { VELOCITIES = 6 * N };

static void put_velocities(const struct model *model, const double *v)
{
    memcpy(model->bodies.v.c[0], v, 3 * N * sizeof *v);
    memcpy(model->bodies.omega.c[0], v + 3 * N, 3 * N * sizeof *v);
}

/** Velocities v after the flow beside a drift of no length, which follows (1.0) or has been (-1.0). */
static void flow(const struct model *model, double side, const double *v, double *after)
{
    const vti_effect *e = &model->effects[model->effects_count - 1];
    put_velocities(model, v);
    e->flow(e->self, &model->bodies, 0.05, side * 1e-300);
    memcpy(after, model->bodies.v.c[0], 3 * N * sizeof *v);
    memcpy(after + 3 * N, model->bodies.omega.c[0], 3 * N * sizeof *v);
}

/** The product that belongs to the kinetic energy. */
static double product(const struct model *model, const double *v, const double *w)
{
    double sum = 0.0;
    for (int k = 0; k < VELOCITIES; ++k)
        sum += v[k] * w[k] * (k < 3 * N ? *model->bodies.mass.p : *model->bodies.inertia.p);
    return sum;
}

/** Each touch is a symmetric map of velocities, so that the sweep back, which takes touches the other way round, is the
 *  adjoint of the sweep: v.(F w) = (B v).w. */
TEST(dashpots_back_and_forth)
{
    static double v[VELOCITIES], w[VELOCITIES], forth[VELOCITIES], back[VELOCITIES];
    struct scene scene;
    struct model model;
    uint64_t seed = 1;
    make_scene("0", DASHPOTS, &scene, &model);
    (void)chunks_of_model(&model);
    for (int k = 0; k < VELOCITIES; ++k) {
        seed = seed * UINT64_C(6364136223846793005) + 1442695040888963407u;
        v[k] = (double)(seed >> 11) * 0x1p-53 - 0.5;
        seed = seed * UINT64_C(6364136223846793005) + 1442695040888963407u;
        w[k] = (double)(seed >> 11) * 0x1p-53 - 0.5;
    }
    flow(&model, 1.0, w, forth);
    const vti_effect *e = &model.effects[model.effects_count - 1];
    const double lost = 0.5 * (product(&model, w, w) - product(&model, forth, forth));
    assert_true(lost > 0.1 * product(&model, w, w));
    assert_close(vti_booked(e, 1), lost, VELOCITIES * EPS * product(&model, w, w));
    flow(&model, -1.0, v, back);
    const double scale = sqrt(product(&model, v, v) * product(&model, w, w));
    assert_close(product(&model, v, forth), product(&model, back, w), VELOCITIES * EPS * scale);
    flow(&model, 1.0, v, back); /* which the sweep forth is not */
    assert_true(fabs(product(&model, v, forth) - product(&model, back, w)) > 1e-6 * scale);
    model_destroy(&model);
}

static int use_threads(void **state)
{
    (void)state;
    threads_use(3);
    return 0;
}

RUN_TESTS(cmocka_unit_test_setup(rounds, use_threads), cmocka_unit_test(groups),
          cmocka_unit_test(friction_as_in_one_piece), cmocka_unit_test(springs_that_found_no_room),
          cmocka_unit_test(dashpots_back_and_forth))
