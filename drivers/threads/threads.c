/* SPDX-License-Identifier: BSD-3-Clause */
#include "threads.h"

#ifdef _OPENMP
#include <omp.h>

int threads_are_there(void)
{
    return 1;
}

int64_t threads_most(void)
{
    return omp_get_max_threads();
}
#else
int threads_are_there(void)
{
    return 0;
}

int64_t threads_most(void)
{
    return 1;
}
#endif

static int64_t used = 1;

void threads_use(int64_t count)
{
    used = count;
}

int64_t threads_used(void)
{
    return used;
}

int64_t threads_sum(int64_t parts, int64_t (*work)(void *self, int64_t part), void *self)
{
    int64_t sum = 0;
    if (parts == 1)
        return work(self, 0);
#ifdef _OPENMP
#pragma omp parallel for schedule(static, 1) num_threads((int)parts) reduction(+ : sum)
#endif
    for (int64_t k = 0; k < parts; ++k)
        sum += work(self, k);
    return sum;
}
