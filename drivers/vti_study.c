/* SPDX-License-Identifier: BSD-3-Clause
 * vti-study: the time-step convergence study. Arguments in, files and a table out; the work is in study/ and io/. */
#define _POSIX_C_SOURCE 200809L
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "beside.h"
#include "cost_scenes.h"
#include "folder.h"
#include "number.h"
#include "output.h"
#include "pictures.h"
#include "study_go.h"
#include "table_hdf5.h"
#include "version.h"

static const char usage[] =
    "Usage: mpirun -n RANKS vti-study [options] [SCENE.yaml]\n"
    "       mpirun -n RANKS vti-study --cost [options] [SCENE.yaml[@T,...]]...\n"
    "\n"
    "Runs a scene (default: the paper's pendulum) with several steppers and steps, measures every run against a "
    "reference\n"
    "solution and fits the orders of convergence. Writes study.h5, study.csv, timing.csv and pictures.\n"
    "\n"
    "  --steppers A,B    steppers (default vti1,vti2,vti3)\n"
    "  --h STEPS         one step, a list, or a ladder by factors of two (default: seven or ten from\n"
    "                    around the scene's h, 2^-4:2^-13 for the pendulum); numbers may be written 0.01, 1/64 or "
    "2^-6\n"
    "  --t-end T         end time (default: the scene's). A run takes the whole steps that fit into it\n"
    "  --set PATH=VALUE  override a value of the scene; may be repeated\n"
    "  -o FOLDER         output folder (default study-SCENE)\n"
    "  --resume          go on with a study that was interrupted, if there is one in the folder, else start\n"
    "  --memory MB       most that the reference solution takes on every rank (default 1000). What is longer is\n"
    "                    integrated again by every run, window by window; of scenes with contacts or many bodies "
    "fewer\n"
    "                    states are compared\n"
    "  --force           replace files that are no results of vti too; what the scene is read from is never replaced\n"
    "  --no-plot         no pictures\n"
    "  -h, --help        this text\n"
    "  --version         version, commit, compiler, flags and vector units\n"
    "\n"
    "  --cost            what accuracy costs: errors against force evaluations and time, and the price of each error.\n"
    "                    Several scenes; each to its own ends T,... or those of --t-end T,...; --steppers knows "
    "rivals\n"
    "                    too (default all); default steps: down by factors of sqrt(2) until an error of 3e-11.\n"
    "                    Writes cost.csv, errors.csv, prices.csv and machine.txt\n"
    "  --evals MOST      most force evaluations of a run (default 2^22 over the number of bodies)\n"
    "  --repeats N       how often each run is timed, 1 to 64 (default 5)\n"
    "\n"
    "Every run is kept in the folder as soon as it is done. After any end before the last file is written the same "
    "command\n"
    "with --resume goes on and gives the same bytes as if nothing had happened, timing.csv excepted. SIGTERM, SIGUSR1 "
    "and\n"
    "Ctrl-C end it with code 75; Open MPI's mpirun makes 1 of that, unless it was SIGUSR1, and talks over our message\n"
    "unless it is told to be --quiet. That of Open MPI 5 knows no --quiet, and after SIGTERM and Ctrl-C it does not "
    "pass\n"
    "our message on; what is done is kept there too.\n"
    "\n"
    "study.csv has the verdict on every run: good, doubtful or bad, and the numbers behind it. Where one is bad, all "
    "files\n"
    "are written and the code is 3.\n";

enum { SETS = 64, EXIT_BAD = 3, EXIT_RESUME = 75 /* EX_TEMPFAIL of sysexits.h */ };

/** What the program reads. */
struct study_inputs {
    struct input input[3 * COST_CASES];
    int count;
};

struct arguments {
    const char *scene, *steppers, *h, *t_end, *folder, *evals, *repeats, *memory;
    const char *const *scenes;
    const char *sets[SETS];
    int sets_count, scenes_count, plot, help, cost, resume, force;
};

static int read_arguments(int argc, char **argv, struct arguments *a, struct message *message)
{
    enum { STEPPERS = 256, H, T_END, SET, NO_PLOT, COST, EVALS, REPEATS, RESUME, FORCE, MEMORY };
    static const struct option options[] = {{"steppers", required_argument, NULL, STEPPERS},
                                            {"h", required_argument, NULL, H},
                                            {"t-end", required_argument, NULL, T_END},
                                            {"set", required_argument, NULL, SET},
                                            {"no-plot", no_argument, NULL, NO_PLOT},
                                            {"cost", no_argument, NULL, COST},
                                            {"evals", required_argument, NULL, EVALS},
                                            {"repeats", required_argument, NULL, REPEATS},
                                            {"resume", no_argument, NULL, RESUME},
                                            {"force", no_argument, NULL, FORCE},
                                            {"memory", required_argument, NULL, MEMORY},
                                            {"help", no_argument, NULL, 'h'},
                                            {NULL, 0, NULL, 0}};
    const struct arguments defaults = {.plot = 1};
    *a = defaults;
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv, ":ho:", options, NULL)) != -1;) {
        if (c == STEPPERS)
            a->steppers = optarg;
        else if (c == H)
            a->h = optarg;
        else if (c == T_END)
            a->t_end = optarg;
        else if (c == NO_PLOT)
            a->plot = 0;
        else if (c == COST)
            a->cost = 1;
        else if (c == RESUME)
            a->resume = 1;
        else if (c == FORCE)
            a->force = 1;
        else if (c == EVALS)
            a->evals = optarg;
        else if (c == REPEATS)
            a->repeats = optarg;
        else if (c == MEMORY)
            a->memory = optarg;
        else if (c == 'h')
            a->help = 1;
        else if (c == 'o')
            a->folder = optarg;
        else if (c == SET && a->sets_count < SETS)
            a->sets[a->sets_count++] = optarg;
        else if (c == SET)
            return message_set(message, "--set: given more than %d times; put the values into a scene file", SETS);
        else if (c == ':')
            return message_set(message, "%s: needs a value; see vti-study --help", argv[optind - 1]);
        else
            return message_set(message, "%s: is not an option; see vti-study --help", argv[optind - 1]);
    }
    a->scene = optind < argc ? argv[optind] : NULL;
    a->scenes = (const char *const *)argv + optind;
    a->scenes_count = argc - optind;
    if (!a->cost && (a->evals != NULL || a->repeats != NULL))
        return message_set(message, "%s: goes with --cost only; see vti-study --help",
                           a->evals != NULL ? "--evals" : "--repeats");
    if (!a->cost && optind + 1 < argc)
        return message_set(message, "%s: only one scene can be studied at a time; remove it", argv[optind + 1]);
    return 0;
}

static int read_memory(const char *text, double *bytes, struct message *message)
{
    *bytes = REFERENCE_BYTES;
    if (text == NULL)
        return 0;
    if (number_read(text, bytes) != 0 || !(*bytes > 0.0))
        return message_set(message, "--memory: '%s' is not a positive number of megabytes; write 500 or 1e4", text);
    *bytes *= 1e6;
    return 0;
}

/** From four times the scene's h down by factors of two, or from h itself where a larger one might not be stable. */
static int64_t ladder_around(const struct scene *scene, double h[LADDER_MOST])
{
    const int stiff = scene->has_binder || scene->has_contact || scene->has_wall;
    const int64_t n = stiff ? 7 : 10;
    for (int64_t k = 0; k < n; ++k)
        h[k] = ldexp(scene->h, (int)(stiff ? -k : 2 - k));
    return n;
}

/** The file of a scene and its tables. */
static void add_inputs(const char *path, const struct scene *scene, struct study_inputs *inputs)
{
    const struct input three[] = {{path, "the scene"},
                                  {scene->table, "the scene's table of bodies"},
                                  {scene->binder.table, "the scene's table of bonds"}};
    for (int k = 0; k < 3; ++k)
        inputs->input[inputs->count++] = three[k];
}

static int make_plan(const struct arguments *a, struct scene *scene, struct tables *tables, struct plan *plan,
                     struct message *message)
{
    char shipped[BESIDE_PATH];
    if (a->scene == NULL && beside_scene("pendulum.yaml", shipped) != 0)
        return message_set(message,
                           "the shipped scene pendulum.yaml was not found beside the program; name a scene file");
    if (scene_read(a->scene != NULL ? a->scene : shipped, a->sets, a->sets_count, scene, message) != 0 ||
        tables_read(scene, tables, message) != 0)
        return -1;
    plan->scene = scene;
    plan->t_end = scene->t_end;
    if (a->t_end != NULL && (number_read(a->t_end, &plan->t_end) != 0 || !(plan->t_end > 0.0)))
        return message_set(message, "--t-end: '%s' is not a positive number; write 10, 1e3 or 2^7", a->t_end);
    if (read_memory(a->memory, &plan->memory, message) != 0)
        return -1;
    if (study_read_steppers(a->steppers != NULL ? a->steppers : "vti1,vti2,vti3", plan, message) != 0)
        return -1;
    plan->h_count = a->h != NULL ? ladder_read(a->h, plan->h, message) : ladder_around(scene, plan->h);
    return plan->h_count > 0 ? 0 : -1;
}

static int make_cost_plan(const struct arguments *a, struct cost_scenes *scenes, struct cost_plan *plan,
                          struct message *message)
{
    char shipped[BESIDE_PATH];
    const char *const pendulum[] = {shipped};
    if (a->scenes_count == 0 && beside_scene("pendulum.yaml", shipped) != 0)
        return message_set(message,
                           "the shipped scene pendulum.yaml was not found beside the program; name a scene file");
    if (cost_plan_limits(plan, a->evals, a->repeats, message) != 0 ||
        read_memory(a->memory, &plan->memory, message) != 0 || cost_plan_methods(plan, a->steppers, message) != 0)
        return -1;
    if (cost_scenes_read(a->scenes_count > 0 ? a->scenes : pendulum, a->scenes_count > 0 ? a->scenes_count : 1, a->sets,
                         a->sets_count, a->t_end, scenes, plan, message) != 0)
        return -1;
    return a->h != NULL ? cost_plan_steps(plan, a->h, message) : 0;
}

/** A cost study. Collective. */
static int run_cost(const struct arguments *arguments, int rank)
{
    static struct cost_scenes scenes;
    static struct cost_plan plan;
    static struct study_inputs inputs;
    struct message message = {""};
    int failed = study_agree(make_cost_plan(arguments, &scenes, &plan, &message), rank, &message);
    for (int k = 0; k < scenes.count; ++k)
        add_inputs(scenes.paths[k], &scenes.scenes[k], &inputs);
    const struct study_place place = {arguments->folder != NULL ? arguments->folder : "cost", arguments->resume,
                                      arguments->force, inputs.input, inputs.count};
    if (failed == 0)
        failed = cost_go(&plan, &place, rank);
    cost_scenes_destroy(&scenes);
    return failed;
}

static int run(int argc, char **argv, int rank, char folder[FOLDER_PATH], int *wants_plot)
{
    static struct scene scene;
    static struct tables tables;
    static struct plan plan;
    static struct study_inputs inputs;
    struct arguments arguments;
    struct message message = {""};
    if (version_asked(argc, argv, "vti-study", rank == 0))
        return 0;
    int failed = read_arguments(argc, argv, &arguments, &message);
    if (failed == 0 && arguments.help) {
        if (rank == 0)
            fputs(usage, stdout);
        return 0;
    }
    if (failed == 0 && arguments.cost)
        return run_cost(&arguments, rank);
    if (failed == 0)
        failed = make_plan(&arguments, &scene, &tables, &plan, &message);
    failed = study_agree(failed, rank, &message);
    if (failed == 0) {
        if (arguments.folder != NULL)
            snprintf(folder, FOLDER_PATH, "%s", arguments.folder);
        else
            snprintf(folder, FOLDER_PATH, "study-%s", scene.name);
        add_inputs(arguments.scene != NULL ? arguments.scene : "", &scene, &inputs);
        const struct study_place place = {folder, arguments.resume, arguments.force, inputs.input, inputs.count};
        failed = study_go(&plan, &place, rank);
        *wants_plot = rank == 0 && arguments.plot;
    }
    tables_destroy(&tables);
    return failed;
}

int main(int argc, char **argv)
{
    static char folder[FOLDER_PATH];
    struct message message = {""};
    int rank, wants_plot = 0;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    int failed = run(argc, argv, rank, folder, &wants_plot);
    if (failed >= 0 && study_agree(output_end(&message), rank, &message) != 0)
        failed = -1;
    MPI_Finalize();
    /* forking is not safe on every transport while MPI is up, so pictures come last */
    if (failed >= 0 && wants_plot && pictures_draw(folder, "study.h5", &message) != 0) {
        fprintf(stderr, "vti-study: %s\n", message.text);
        failed = -1;
    }
    return failed == WATCH_ASKED ? EXIT_RESUME : failed < 0 ? EXIT_FAILURE : failed > 0 ? EXIT_BAD : EXIT_SUCCESS;
}
