/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "machine.h"

#include <string.h>
#include <sys/utsname.h>
#include <unistd.h>

/** The model's name as Linux tells it, or that of the architecture. */
static void write_cpu(const char *otherwise, FILE *file)
{
    char line[512];
    FILE *info = fopen("/proc/cpuinfo", "r");
    const char *name = NULL;
    while (info != NULL && name == NULL && fgets(line, sizeof line, info) != NULL)
        if (strncmp(line, "model name", 10) == 0 && strchr(line, ':') != NULL) {
            name = strchr(line, ':') + 1;
            line[strcspn(line, "\n")] = '\0';
            name += strspn(name, " \t");
        }
    fprintf(file, "cpu: %s\n", name != NULL ? name : otherwise);
    if (info != NULL)
        fclose(info);
}

void machine_write(FILE *file)
{
    struct utsname system;
    if (uname(&system) != 0)
        memset(&system, 0, sizeof system);
    write_cpu(system.machine, file);
    fprintf(file, "cores: %ld\n", sysconf(_SC_NPROCESSORS_ONLN));
    fprintf(file, "system: %s %s %s\n", system.sysname, system.release, system.machine);
#if defined(__clang__)
    fprintf(file, "compiler: %s\n", __VERSION__);
#else
    fprintf(file, "compiler: gcc %s\n", __VERSION__);
#endif
    fprintf(file, "flags: %s\n", VTI_FLAGS);
}
