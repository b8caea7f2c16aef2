/* SPDX-License-Identifier: BSD-3-Clause
 * What a run says beforehand of the disk that it takes, beside what it takes then. */
#define _POSIX_C_SOURCE 200809L
#include <sys/stat.h>

#include "scene_support.h"

#include "folder.h"
#include "sizes.h"

static const char *folder; /* of the shipped scenes */

static double size_of(const char *name)
{
    struct stat info;
    return stat(name, &info) == 0 ? (double)info.st_size : 0.0;
}

static void no_progress(int64_t done, int64_t all, double seconds)
{
    (void)done, (void)all, (void)seconds;
}

static void not_saved(int64_t step, int64_t steps, double t, double left, double seconds)
{
    (void)step, (void)steps, (void)t, (void)left, (void)seconds;
}

static void assert_about(const char *what, double told, double found, double least)
{
    if (!(told > least * found && told < found / least))
        fail_msg("%s: %.0f bytes are told, and it has %.0f", what, told, found);
}

/** Long enough that frames are most of it: all of them in the journal, which is there until run_close. Of contacts
 *  three are told of each sphere, where a block of spheres that touch has 2.5. */
static const struct {
    const char *scene, *sets[3];
    int fields, dump, contacts;
} cases[] = {
    {"heap", {"t_end=0.2"}, 0, 1, 0},
    {"heap", {"t_end=0.1", "bodies.lattice.spacing=0.9999", "bodies.random.v=1e-3"}, 0, 1, 1},
    {"pile", {"t_end=2"}, FIELD_FORCE, 1, 0},
    {"torus", {"t_end=1"}, FIELD_LOADS, 0, 0},
    {"clump-pile", {"t_end=0.02"}, 0, 1, 0},
    {"ellipsoid-chain", {"t_end=20"}, 0, 1, 0},
};

TEST(sizes)
{
    static const char *const files[] = {"out.h5",   "out.csv",        "out.xdmf",
                                        "out.dump", "out-spheres.h5", "out-contacts.h5"};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k) {
        static const struct run_watch watch = {no_progress, not_saved};
        static struct run run;
        char path[1024];
        struct message message = {""};
        snprintf(path, sizeof path, "%s/%s.yaml", folder, cases[k].scene);
        const struct run_request request = {.scene = path,
                                            .sets = cases[k].sets,
                                            .sets_count = cases[k].contacts ? 3 : 1,
                                            .output = "out.h5",
                                            .record_every = 50,
                                            .frames_every = 5,
                                            .checkpoint_seconds = 60.0,
                                            .fields = cases[k].fields,
                                            .contacts = cases[k].contacts,
                                            .dump = cases[k].dump};
        if (run_open(&request, &run, &message) != 0)
            fail_msg("%s", message.text);
        const struct run_sizes told = sizes_of(&run);
        if (run_go(&run, &watch, &message) != RUN_COMPLETE)
            fail_msg("%s", message.text);
        double all = 0.0;
        for (size_t f = 0; f < sizeof files / sizeof files[0]; ++f)
            all += size_of(files[f]);
        print_message("%s: %.3g and %.3g bytes told, %.3g and %.3g found\n", cases[k].scene, told.files, told.journal,
                      all, size_of("out.run"));
        assert_about(cases[k].scene, told.files, all, cases[k].contacts ? 0.8 : 0.92);
        assert_about("out.run", told.journal, size_of("out.run"), cases[k].contacts ? 0.7 : 0.8);
        assert_true(told.needed == told.files + told.journal);
        run_close(&run);
        for (size_t f = 0; f < sizeof files / sizeof files[0]; ++f)
            remove(files[f]);
    }
}

TEST(words)
{
    char text[32];
    assert_string_equal(sizes_text(1.23e8, text), "123 MB");
    assert_string_equal(sizes_text(2.314e9, text), "2.31 GB");
    assert_string_equal(sizes_text(1.5e12, text), "1.5 TB");
}

TEST(space)
{
    assert_true(folder_space(".") > 0.0);
    assert_true(isinf(folder_space("no/such/folder")));
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(sizes), cmocka_unit_test(words), cmocka_unit_test(space)};
    folder = argc > 1 ? argv[1] : ".";
    method_admit();
    return cmocka_run_group_tests(tests, enter_directory, leave_directory);
}
