/* SPDX-License-Identifier: BSD-3-Clause
 * Finds what is installed beside the running program: the scenes, and vti-plot, which it runs to draw pictures. */
#define _POSIX_C_SOURCE 200809L
#include "study_go.h"

#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "folder.h"

/** path = folder of the running program / relative / name, if that can be read. */
static int find(const char *relative, const char *name, char path[BESIDE_PATH])
{
    char self[BESIDE_PATH / 2];
    const ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    if (length <= 0)
        return -1;
    self[length] = '\0';
    *strrchr(self, '/') = '\0';
    const int written = snprintf(path, BESIDE_PATH, "%s/%s%s", self, relative, name);
    return written > 0 && written < BESIDE_PATH && access(path, R_OK) == 0 ? 0 : -1;
}

int beside_scene(const char *name, char path[BESIDE_PATH])
{
    /* build/drivers beside build/scenes; bin beside share/vti/scenes */
    return find("../scenes/", name, path) == 0 || find("../share/vti/scenes/", name, path) == 0 ? 0 : -1;
}

int beside_draw(const char *folder, const char *name, struct message *message)
{
    char program[BESIDE_PATH], file[FOLDER_PATH];
    if (find("", "vti-plot", program) != 0)
        return message_set(message, "vti-plot was not found beside this program; use --no-plot");
    if (folder_path(folder, name, 0, file, message) != 0)
        return -1;
    const pid_t child = fork();
    if (child == 0) {
        execl(program, program, file, (char *)NULL);
        _exit(127);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child || status != 0)
        return message_set(message, "%s: no pictures were drawn; see the lines above, or use --no-plot", file);
    return 0;
}
