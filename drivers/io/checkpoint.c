/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "checkpoint.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "digest.h"
#include "quote.h"
#include "state.h"
#include "sync.h"
#include "table.h"

/* The file: this, the state, and the digest of both. */
struct head {
    char magic[16];
    struct checkpoint checkpoint;
};

static const char magic[16] = "vti checkpoint4";

/* ---- writing ----------------------------------------------------------------------------------------------------- */

static int fail(const char *path, struct message *message)
{
    return message_set(message, "%s: cannot be written: %s; %s", path, strerror(errno), folder_remedy(errno));
}

static int write_all(const char *path, const void *bytes, size_t size)
{
    FILE *file = folder_new(path);
    if (file == NULL)
        return -1;
    const int failed = fwrite(bytes, 1, size, file) != size || sync_file(file) != 0;
    return fclose(file) != 0 || failed ? -1 : 0;
}

/** The file as it will be, in memory from malloc; NULL if there is none. */
static unsigned char *pack(const struct checkpoint *checkpoint, const vti_bodies *bodies, const struct verdict *verdict,
                           size_t *size)
{
    struct head head;
    const size_t state = sizeof(double) * (size_t)checkpoint->state_doubles;
    unsigned char *bytes = malloc(sizeof head + state + sizeof(uint64_t));
    if (bytes == NULL)
        return NULL;
    memset(&head, 0, sizeof head); /* padding has a value too */
    memcpy(head.magic, magic, sizeof magic);
    head.checkpoint = *checkpoint;
    memcpy(bytes, &head, sizeof head);
    double *doubles = (double *)(void *)(bytes + sizeof head);
    state_get(bodies, doubles);
    verdict_get(verdict, doubles + state_size(bodies));
    const uint64_t digest = digest_add(DIGEST_START, bytes, sizeof head + state);
    memcpy(bytes + sizeof head + state, &digest, sizeof digest);
    *size = sizeof head + state + sizeof digest;
    return bytes;
}

int checkpoint_write(struct journal *journal, struct checkpoint *checkpoint, const vti_bodies *bodies,
                     const struct verdict *verdict, struct message *message)
{
    char part[FOLDER_PATH], path[FOLDER_PATH];
    size_t size = 0;
    if (folder_path(journal->folder, "checkpoint", 1, part, message) != 0 ||
        folder_path(journal->folder, "checkpoint", 0, path, message) != 0 || journal_sync(journal, message) != 0)
        return -1;
    checkpoint->rows = journal->rows.mark;
    checkpoint->frames = journal->frames.mark;
    checkpoint->state_doubles = state_size(bodies) + verdict_size(verdict);
    unsigned char *bytes = pack(checkpoint, bodies, verdict, &size);
    if (bytes == NULL)
        return message_set(message, "%s: out of memory; use fewer bodies", path);
    int failed = write_all(part, bytes, size) != 0 ? fail(part, message) : 0;
    free(bytes);
    if (failed == 0 && rename(part, path) != 0)
        failed = fail(path, message);
    if (failed == 0 && sync_path(journal->folder) != 0)
        failed = fail(journal->folder, message);
    if (failed != 0)
        unlink(part);
    return failed;
}

/* ---- reading ----------------------------------------------------------------------------------------------------- */

static int damaged(const char *path, const char *what, const char *folder, struct message *message)
{
    if (folder != NULL)
        return message_set(message, "%.600s: %s; delete %.300s and start the run anew", path, what, folder);
    return message_set(message, "%.600s: %s; start anew without --resume, or choose another place with -o", path, what);
}

/** All bytes of the file, from malloc. Returns 1, 0 if there is no file, or -1. */
static int read_all(const char *path, unsigned char **bytes, size_t *size)
{
    struct stat info;
    FILE *file = fopen(path, "rb");
    *bytes = NULL;
    if (file == NULL)
        return errno == ENOENT ? 0 : -1;
    if (fstat(fileno(file), &info) == 0 && S_ISREG(info.st_mode)) {
        *size = (size_t)info.st_size;
        *bytes = malloc(*size + 1);
    }
    const int ok = *bytes != NULL && fread(*bytes, 1, *size, file) == *size;
    fclose(file);
    return ok ? 1 : -1;
}

/** "bodies.csv holds other bodies": with the same scene and options they can only have changed in their table. */
static const char *other_numbers(const char *table, const char *what, char *text, size_t size)
{
    char shown[160];
    const int named = table[0] != '\0';
    snprintf(text, size, "%s %s other %s", named ? quote_tail(shown, sizeof shown, table) : "the scene",
             named ? "holds" : "has", what);
    return text;
}

/** The same for the first table of an effect. */
static const char *other_table(const struct scene *scene, char *text, size_t size)
{
    int k = 1;
    while (k + 1 < TABLES && tables_path(scene, k)[0] == '\0')
        ++k;
    return other_numbers(tables_path(scene, k), tables_kind(k) != NULL ? tables_kind(k)->rows : "tables", text, size);
}

static int check_identity(const struct identity *have, const struct identity *want, const struct scene *scene,
                          const char *path, struct message *message)
{
    char text[256];
    if (strncmp(have->version, want->version, sizeof have->version) != 0)
        return message_set(message,
                           "%s: is of vti %.16s and this is vti %.16s; resume with that version, or start anew "
                           "with -o elsewhere",
                           path, have->version, want->version);
    const char *other = NULL;
    if (have->scene != want->scene)
        other = "the scene file has another text";
    else if (have->overrides != want->overrides)
        other = "--set, --h or --stepper differ";
    else if (have->bodies != want->bodies)
        other = other_numbers(scene->table, "bodies", text, sizeof text);
    else if (have->tables != want->tables)
        other = other_table(scene, text, sizeof text);
    if (other == NULL)
        return 0;
    return message_set(message,
                       "%s: is of another run: %s; resume with the scene, tables and options of that run, or "
                       "start anew with -o elsewhere",
                       path, other);
}

/** Whether the bytes are a whole checkpoint; takes its head. */
static int unpack(const unsigned char *bytes, size_t size, struct head *head)
{
    uint64_t digest;
    if (size < sizeof *head + sizeof digest)
        return 0;
    memcpy(head, bytes, sizeof *head);
    memcpy(&digest, bytes + size - sizeof digest, sizeof digest);
    return memcmp(head->magic, magic, sizeof magic) == 0 &&
           digest == digest_add(DIGEST_START, bytes, size - sizeof digest);
}

int checkpoint_bytes(const struct journal *journal, unsigned char **bytes, size_t *size, struct message *message)
{
    char path[FOLDER_PATH];
    *bytes = NULL;
    if (folder_path(journal->folder, "checkpoint", 0, path, message) != 0)
        return -1;
    const int result = read_all(path, bytes, size);
    return result < 0 ? damaged(path, "cannot be read", journal->folder, message) : result;
}

int checkpoint_take(const unsigned char *bytes, size_t size, const char *path, const char *folder,
                    const struct identity *identity, const struct scene *scene, struct checkpoint *checkpoint,
                    const vti_bodies *bodies, struct verdict *verdict, struct message *message)
{
    struct head head;
    const int64_t doubles = state_size(bodies) + verdict_size(verdict);
    if (!unpack(bytes, size, &head))
        return damaged(path, "is no checkpoint of vti-run, or is damaged", folder, message);
    if (check_identity(&head.checkpoint.identity, identity, scene, path, message) != 0)
        return -1;
    if (head.checkpoint.state_doubles != doubles || size != sizeof head + 8 * (size_t)doubles + sizeof(uint64_t))
        return damaged(path, "holds other quantities than this program does", folder, message);
    *checkpoint = head.checkpoint;
    /* who starts anew from step 0 moves the velocities of a lagging method anew */
    if (checkpoint->step > 0) {
        const double *state = (const double *)(const void *)(bytes + sizeof head);
        state_put(state, bodies);
        verdict_put(verdict, state + state_size(bodies));
    }
    return 0;
}

int checkpoint_read(const struct journal *journal, const struct identity *identity, const struct scene *scene,
                    struct checkpoint *checkpoint, const vti_bodies *bodies, struct verdict *verdict,
                    struct message *message)
{
    char path[FOLDER_PATH];
    unsigned char *bytes;
    size_t size = 0;
    int result = checkpoint_bytes(journal, &bytes, &size, message);
    if (result > 0 && (folder_path(journal->folder, "checkpoint", 0, path, message) != 0 ||
                       checkpoint_take(bytes, size, path, journal->folder, identity, scene, checkpoint, bodies, verdict,
                                       message) != 0))
        result = -1;
    free(bytes);
    return result;
}
