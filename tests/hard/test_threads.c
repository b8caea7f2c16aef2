/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Slices of the same bodies stepped by threads of their own: the bits of one thread. Under -fsanitize=thread (./dev
 * sanitize) also that no thread touches what another writes. */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>

#include "digest.h"

enum { THREADS = 2, STEPS = 200 };

struct team {
    scene s;
    vti_effect effects[EFFECTS];
    const vti_stepper *method;
    int threads;
    enum storage storage;
    pthread_barrier_t barrier;
};

struct member {
    struct team *team;
    int number, status;
};

static void load(struct team *t, const vti_bodies *mine)
{
    vti_apply(t->effects, EFFECTS, mine); /* bonds and contacts too load the slice's bodies alone */
    pthread_barrier_wait(&t->barrier);    /* nobody's positions are moved before all have read them */
}

static void *work(void *argument)
{
    struct member *m = argument;
    struct team *const t = m->team;
    const vti_bodies all = scene_bodies(&t->s, t->storage);
    const int64_t first = BODIES * m->number / t->threads, end = BODIES * (m->number + 1) / t->threads;
    const vti_bodies mine = vti_bodies_slice(all, first, end - first);
    load(t, &mine);
    for (int k = 0; k < STEPS; ++k) {
        for (int64_t stage = 0; stage < t->method->stages; ++stage) {
            const int status = vti_step_stage(t->method, stage, 1.0 / 64, &mine, NULL);
            m->status = status != VTI_OK ? status : m->status;
            pthread_barrier_wait(&t->barrier); /* nobody's positions are read before all have moved */
            load(t, &mine);
        }
        const int status = vti_step_finish(t->method, 1.0 / 64, &mine);
        m->status = status != VTI_OK ? status : m->status;
    }
    return NULL;
}

/** Returns the hash of the state at the end, or ends the program. */
static uint64_t run(const char *stepper, enum storage storage, int threads)
{
    static struct team t;
    struct member members[THREADS];
    pthread_t thread[THREADS];
    uint64_t hash = HASH_START;
    scene_make(&t.s, 1);
    scene_effects(&t.s, t.effects);
    t.method = vti_stepper_find(stepper);
    t.threads = threads;
    t.storage = storage;
    pthread_barrier_init(&t.barrier, NULL, (unsigned)threads);
    for (int k = 0; k < threads; ++k) {
        const struct member member = {&t, k, VTI_OK};
        members[k] = member;
        if (pthread_create(&thread[k], NULL, work, &members[k]) != 0)
            exit(77); /* skipped: no threads here */
    }
    for (int k = 0; k < threads; ++k) {
        pthread_join(thread[k], NULL);
        if (members[k].status != VTI_OK) {
            fprintf(stderr, "%s: %s\n", stepper, vti_status_text(members[k].status));
            exit(1);
        }
    }
    pthread_barrier_destroy(&t.barrier);
    hash_add(&hash, t.s.x[0], 3 * BODIES);
    hash_add(&hash, t.s.alpha[0], 3 * BODIES);
    hash_add(&hash, t.s.quat[0], 4 * BODIES);
    hash_add(&hash, t.s.v[0], 3 * BODIES);
    hash_add(&hash, t.s.omega[0], 3 * BODIES);
    return hash;
}

int main(void)
{
    static const char *const steppers[] = {"vti1", "vti2", "exact", "srkn6"};
    int bad = 0;
    for (int k = 0; k < 4; ++k)
        for (int storage = 0; storage < STORAGES; ++storage)
            if (run(steppers[k], (enum storage)storage, 1) != run(steppers[k], (enum storage)storage, THREADS)) {
                fprintf(stderr, "%s, storage %d: two threads, other bits than one\n", steppers[k], storage);
                bad = 1;
            }
    return bad;
}
