/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A call of threads_sum opens its parts and wakes those who sleep; every thread, the caller's too, begins with the part
 * of its own number, so that slices stay in its cache, and takes what nobody has taken after it. A part that is taken
 * is waited for, one that is not is done by the caller: threads that have not been woken in time hold nobody up. */
#define _GNU_SOURCE /* sched_getaffinity */
#include "threads.h"

#include <pthread.h>
#include <sched.h>
#include <unistd.h>

enum { PATIENCE = 64 }; /* looks, with the processor offered to others in between, before a thread sleeps */

/** Of a part: 2 c while it is open in call c, 2 c + 1 once somebody has taken it. Numbers of calls only grow, so that
 *  one who comes late takes nothing twice. */
static uint64_t part_state[THREADS_MOST];
/** Of threads. */
static int64_t numbers[THREADS_MOST];

static struct {
    int64_t used, started; /* threads; the caller's is not started */
    uint64_t call;
    int64_t parts;
    int64_t (*work)(void *self, int64_t part);
    void *self;
    int64_t left, sum;       /* parts that are not done, and of those that are */
    int64_t asleep, waiting; /* threads that wait for a call, and 1 if the caller waits for its end */
    pthread_mutex_t lock;
    pthread_cond_t go, done;
} pool = {
    .used = 1, .lock = PTHREAD_MUTEX_INITIALIZER, .go = PTHREAD_COND_INITIALIZER, .done = PTHREAD_COND_INITIALIZER};

#define GET(x) __atomic_load_n(&(x), __ATOMIC_SEQ_CST)
#define PUT(x, value) __atomic_store_n(&(x), value, __ATOMIC_SEQ_CST)
#define ADD(x, value) __atomic_add_fetch(&(x), value, __ATOMIC_SEQ_CST)

int64_t threads_most(void)
{
#ifdef CPU_COUNT
    cpu_set_t set;
    const int64_t count = sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
#else
    const int64_t count = sysconf(_SC_NPROCESSORS_ONLN);
#endif
    return count < 1 ? 1 : count < THREADS_MOST ? count : THREADS_MOST;
}

void threads_use(int64_t count)
{
    pool.used = count < THREADS_MOST ? count : THREADS_MOST;
}

int64_t threads_used(void)
{
    return pool.used;
}

/* ---- parts ------------------------------------------------------------------------------------------------------- */

/** Does part k if it is open. What the caller has written before it opened the part is seen from here on, and stays
 *  until the part is done. */
static void try_part(int64_t k)
{
    uint64_t state = GET(part_state[k]);
    if ((state & 1) != 0 || state == 0 ||
        !__atomic_compare_exchange_n(&part_state[k], &state, state + 1, 0, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST))
        return;
    ADD(pool.sum, pool.work(pool.self, k));
    if (ADD(pool.left, -1) > 0 || GET(pool.waiting) == 0)
        return;
    pthread_mutex_lock(&pool.lock);
    pthread_cond_signal(&pool.done);
    pthread_mutex_unlock(&pool.lock);
}

static void try_all(int64_t own)
{
    const int64_t parts = GET(pool.parts);
    for (int64_t k = 0; k < parts; ++k)
        try_part((own + k) % parts);
}

/** Until there is another call than the last one. Returns it. */
static uint64_t wait_for_call(uint64_t last)
{
    for (int look = 0; look < PATIENCE; ++look) {
        if (GET(pool.call) != last)
            return GET(pool.call);
        sched_yield();
    }
    pthread_mutex_lock(&pool.lock);
    ADD(pool.asleep, 1);
    while (GET(pool.call) == last)
        pthread_cond_wait(&pool.go, &pool.lock);
    ADD(pool.asleep, -1);
    pthread_mutex_unlock(&pool.lock);
    return GET(pool.call);
}

static void *live(void *number)
{
    const int64_t *own = number;
    uint64_t call = 0;
    while ((call = wait_for_call(call)) > 0)
        try_all(*own);
    return NULL;
}

/* ---- calls ------------------------------------------------------------------------------------------------------- */

/** What the system does not give, the others do. */
static void start(int64_t count)
{
    pthread_attr_t detached;
    pthread_attr_init(&detached);
    pthread_attr_setdetachstate(&detached, PTHREAD_CREATE_DETACHED);
    while (pool.started < count) {
        pthread_t thread;
        int64_t *number = &numbers[pool.started];
        *number = pool.started + 1;
        if (pthread_create(&thread, &detached, live, number) != 0)
            break;
        ++pool.started;
    }
    pthread_attr_destroy(&detached);
}

static void open_parts(int64_t parts, int64_t (*work)(void *self, int64_t part), void *self)
{
    const uint64_t call = pool.call + 1;
    pool.work = work;
    pool.self = self;
    PUT(pool.sum, 0);
    PUT(pool.left, parts);
    PUT(pool.parts, parts);
    for (int64_t k = 0; k < parts; ++k)
        PUT(part_state[k], 2 * call);
    PUT(pool.call, call);
    if (GET(pool.asleep) == 0)
        return;
    pthread_mutex_lock(&pool.lock);
    pthread_cond_broadcast(&pool.go);
    pthread_mutex_unlock(&pool.lock);
}

static void wait_for_parts(void)
{
    for (int look = 0; look < PATIENCE; ++look) {
        if (GET(pool.left) == 0)
            return;
        sched_yield();
    }
    pthread_mutex_lock(&pool.lock);
    PUT(pool.waiting, 1);
    while (GET(pool.left) > 0)
        pthread_cond_wait(&pool.done, &pool.lock);
    PUT(pool.waiting, 0);
    pthread_mutex_unlock(&pool.lock);
}

int64_t threads_sum(int64_t parts, int64_t (*work)(void *self, int64_t part), void *self)
{
    if (parts == 1 || pool.used == 1 || parts > THREADS_MOST) {
        int64_t sum = 0;
        for (int64_t k = 0; k < parts; ++k)
            sum += work(self, k);
        return sum;
    }
    start((parts < pool.used ? parts : pool.used) - 1);
    open_parts(parts, work, self);
    try_all(0);
    wait_for_parts();
    return GET(pool.sum);
}
