/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "run_files.h"

#include <string.h>
#include <unistd.h>

#include "quote.h"
#include "run_formats.h"

enum { HDF5, CSV, XDMF, DUMP, SPHERES, CONTACTS, KINDS };

/* ---- names ------------------------------------------------------------------------------------------------------- */

/** OUT.xdmf, which is XML, names files that stand beside it: whether it can. Its readers leave blanks in front out, and
 *  take what stands before a colon for none of the name. Returns 0, or -1 with one line in *message. */
static int check_characters(const char *name, struct message *message)
{
    char shown[QUOTE_SIZE];
    const char *colon = strchr(name, ':');
    if (name[0] == ' ' || colon != NULL)
        return message_set(
            message,
            "-o: '%s' has a %s, and what reads OUT.xdmf would look for another file; choose another name "
            "with -o",
            quote(shown, sizeof shown, name), colon != NULL ? "colon" : "blank in front");
    for (size_t k = 0, n, all = strlen(name); k < all; k += n) {
        n = quote_character(name + k, all - k);
        if (n == 0)
            return message_set(
                message,
                "-o: byte %zu of the file's name, \\x%02x, is no character of UTF-8, and OUT.xdmf could not "
                "name the file; choose another name with -o",
                k + 1, (unsigned)(unsigned char)name[k]);
        if ((unsigned char)name[k] < 0x20 || strncmp(name + k, "\xef\xbf\xbe", 3) == 0 ||
            strncmp(name + k, "\xef\xbf\xbf", 3) == 0)
            return message_set(message,
                               "-o: '%s' has a control character at byte %zu, and OUT.xdmf could not name the file; "
                               "choose another name with -o",
                               quote(shown, sizeof shown, name), k + 1);
    }
    return 0;
}

int run_files_name(struct run_files *files, const char *output, int dump, struct message *message)
{
    static const char *const endings[] = {".h5", ".hdf5", ".hdf", ".vtkhdf"};
    const char *slash = strrchr(output, '/'), *name = slash != NULL ? slash + 1 : output, *dot = strrchr(name, '.');
    int known = 0;
    for (size_t k = 0; dot != NULL && dot != name && k < sizeof endings / sizeof endings[0]; ++k)
        known |= strcmp(dot, endings[k]) == 0;
    if (!known)
        return message_set(message, "-o: '%.200s' does not end in .h5, .hdf5, .hdf or .vtkhdf; write OUT.h5", output);
    const size_t folder = slash != NULL ? (size_t)(slash - output) : 0, stem = (size_t)(dot - name);
    if (folder >= sizeof files->folder - sizeof files->hdf5 - 8 || stem >= sizeof files->stem - 16)
        return message_set(message, "-o: '%.200s...' is too long; use a shorter path", output);
    if (check_characters(name, message) != 0)
        return -1;
    memset(files, 0, sizeof *files);
    if (folder > 0)
        memcpy(files->folder, output, folder);
    else
        files->folder[0] = slash != NULL ? '/' : '.';
    memcpy(files->stem, name, stem);
    snprintf(files->hdf5, sizeof files->hdf5, "%s", name);
    snprintf(files->run, sizeof files->run, "%s.run", files->stem);
    files->dump = dump;
    return 0;
}

static void name_of(const struct run_files *files, int kind, char name[264])
{
    static const char *const endings[KINDS] = {NULL, ".csv", ".xdmf", ".dump", "-spheres.h5", "-contacts.h5"};
    if (kind == HDF5)
        snprintf(name, 264, "%s", files->hdf5);
    else
        snprintf(name, 264, "%.240s%s", files->stem, endings[kind]); /* run_files_name has seen to it */
}

/* ---- what is there ----------------------------------------------------------------------------------------------- */

/* LAMMPS, whose dumps may begin as ours, writes the numbers of its box with exponents that %g has not. */
static const char *const of_lammps[] = {"e+0", "e-01", "e-02", "e-03", "e-04", NULL};

/* As the files begin since the first version; of clumps the number of the molecule comes before the place. */
static const struct mark marks[KINDS] = {
    {NULL, NULL, NULL},
    {"t,", ",angular_x,angular_y,angular_z", NULL},
    {"<?xml version=\"1.0\"?>\n<Xdmf ", "bodies over time", NULL},
    {"ITEM: TIME\n0\nITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n", " x y z", of_lammps},
    {NULL, "spheres_of", NULL}, /* and not the run whose output is called OUT-spheres.h5 */
    {NULL, "contacts_of", NULL},
};

/** Which are wanted, OUT.xdmf if so said. */
static void find_wanted(const struct run_files *files, int xdmf, int wanted[KINDS])
{
    const int found[KINDS] = {1, 1, xdmf, files->dump, files->spheres, files->contacts};
    memcpy(wanted, found, sizeof found);
}

int run_files_check(const struct run_files *files, struct message *message)
{
    int wanted[KINDS];
    char name[KINDS][264];
    struct output outputs[KINDS];
    int count = 0;
    find_wanted(files, 1, wanted);
    for (int kind = 0; kind < KINDS; ++kind) {
        name_of(files, kind, name[kind]);
        if (wanted[kind])
            outputs[count++] = (struct output){name[kind], marks[kind]};
    }
    const struct overwrite overwrite = {.folder = files->folder,
                                        .outputs = outputs,
                                        .outputs_count = count,
                                        .inputs = files->inputs,
                                        .inputs_count = files->inputs_count,
                                        .kept = {files->run, files->left},
                                        .force = files->force};
    return overwrite_check(&overwrite, message);
}

/* ---- writing ----------------------------------------------------------------------------------------------------- */

static int write_hdf5(const struct run_files *files, const struct record *record, int kind, const char *name,
                      struct message *message)
{
    char path[FOLDER_PATH];
    if (folder_output(files->folder, name, 1, path, message) != 0)
        return -1;
    return kind == SPHERES    ? spheres_hdf5_write(record, path, message)
           : kind == CONTACTS ? contacts_hdf5_write(record, path, message)
                              : run_hdf5_write(record, path, message);
}

static int write_text(const struct run_files *files, const struct record *record, int kind, const char *name,
                      struct message *message)
{
    struct message ignored = {""};
    char spheres[264];
    message->text[0] = '\0';
    name_of(files, SPHERES, spheres);
    FILE *file = folder_open(files->folder, name, message);
    if (file == NULL)
        return -1;
    const int failed = kind == CSV    ? run_csv_write(record, file, message)
                       : kind == XDMF ? run_xdmf_write(record, files->hdf5, spheres, file, message)
                                      : run_dump_write(record, file, message);
    return folder_close(file, files->folder, name, message->text[0] == '\0' ? message : &ignored) != 0 ? -1 : failed;
}

/** A file of an earlier run, which would not belong to those of this one. Files that are not ours, or
 *  write-protected, stay. */
static void remove_earlier(const struct run_files *files, int kind)
{
    char name[264], path[FOLDER_PATH];
    struct message ignored = {""};
    name_of(files, kind, name);
    if (folder_output(files->folder, name, 0, path, &ignored) == 0 && overwrite_is_ours(path, &marks[kind]) &&
        (files->force || !overwrite_is_protected(path)))
        unlink(path);
}

static int wants_xdmf(const struct run_files *files, int64_t frames)
{
    return files->xdmf || frames <= RUN_XDMF_FRAMES;
}

int run_files_has_xdmf(const struct run_files *files, const struct record *record)
{
    return wants_xdmf(files, record->journal->frames.mark.count);
}

int run_files_contacts(const struct run_files *files, char path[FOLDER_PATH], struct message *message)
{
    char name[264];
    name_of(files, CONTACTS, name);
    return folder_output(files->folder, name, 0, path, message);
}

double run_files_touches(const struct run_files *files, const struct record *record, int64_t frames)
{
    const double of_each = 3.0;
    return files->contacts ? of_each * (double)model_spheres(record->model)->count * (double)frames : 0.0;
}

double run_files_bytes(const struct run_files *files, const struct record *record, int64_t rows, int64_t frames)
{
    return run_hdf5_bytes(record, rows, frames) + run_csv_bytes(record, rows) +
           (wants_xdmf(files, frames) ? run_xdmf_bytes(record, frames) : 0.0) +
           (files->dump ? run_dump_bytes(record, frames) : 0.0) +
           (files->spheres ? spheres_hdf5_bytes(record, frames) : 0.0) +
           (files->contacts ? contacts_hdf5_bytes((double)frames, run_files_touches(files, record, frames)) : 0.0);
}

int run_files_are_there(const struct run_files *files, int64_t frames)
{
    int wanted[KINDS];
    char name[264], path[FOLDER_PATH];
    struct message ignored;
    find_wanted(files, wants_xdmf(files, frames), wanted);
    for (int kind = 0; kind < KINDS; ++kind) {
        name_of(files, kind, name);
        if (wanted[kind] && (folder_output(files->folder, name, 0, path, &ignored) != 0 || access(path, F_OK) != 0))
            return 0;
    }
    return 1;
}

int run_files_write(const struct run_files *files, const struct record *record, struct message *message)
{
    int wanted[KINDS];
    char name[KINDS][264];
    const char *names[KINDS];
    int failed = 0, count = 0;
    find_wanted(files, run_files_has_xdmf(files, record), wanted);
    if (run_files_check(files, message) != 0)
        return -1;
    for (int kind = 0; kind < KINDS; ++kind) {
        if (!wanted[kind])
            continue;
        name_of(files, kind, name[kind]);
        names[count++] = name[kind];
        if (failed == 0)
            failed = (marks[kind].begins == NULL ? write_hdf5 : write_text)(files, record, kind, name[kind], message);
    }
    if (folder_finish(files->folder, names, count, failed, message) != 0)
        return -1;
    for (int kind = 0; kind < KINDS; ++kind)
        if (!wanted[kind])
            remove_earlier(files, kind);
    return 0;
}
