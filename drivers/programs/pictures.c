/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "pictures.h"

#include <sys/wait.h>
#include <unistd.h>

#include "beside.h"
#include "folder.h"

int pictures_draw(const char *folder, const char *name, struct message *message)
{
    char program[BESIDE_PATH], file[FOLDER_PATH];
    if (beside_program("vti-plot", program) != 0)
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
