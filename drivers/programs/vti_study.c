/* SPDX-License-Identifier: BSD-3-Clause
 * vti-study: time-step convergence studies, sweeps of them over values of scenes (--sweep), and studies of cost
 * (--cost). Arguments in, files and a table out; the work is in study/, cost/ and io/. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "folder.h"
#include "number.h"
#include "options.h"
#include "terminal.h"
#include "study_go.h"
#include "study_tasks.h"
#include "table_hdf5.h"

/* What vti-plot makes of study.h5, of a study and of a sweep. */
static const char *const study_pictures[] = {"convergence.png", "invariants.png", NULL};
static const char *const survey_pictures[] = {"ensemble.png", NULL};

/** What the program reads. */
struct study_inputs {
    struct input input[INPUTS_OF_SCENE * COST_CASES];
    int count;
};

/** The same of a survey, whose tables may be many. */
struct survey_inputs {
    struct input *input; /* to the end of the program */
    int count;
};

static struct option_list sets, sweeps;
static const char *steppers, *steps, *end_times, *output;
static int64_t most_evals, repeats;
static double megabytes = REFERENCE_BYTES / 1e6;
static int cost, resume, force, plot = 1;
static const char *const *scenes;
static int scenes_count;

static const struct option_row rows[] = {
    OPTION_PARAGRAPH(
        "Runs a scene (default: the paper's pendulum) with several steppers and steps, measures every run\n"
        "against a reference solution and fits the orders of convergence. Writes study.h5, study.csv,\n"
        "timing.csv and pictures.\n"),
    {"-o", "FOLDER", OPTION_TEXT, &output, OPTION_ANY,
     "output folder (default study-SCENE; sweep-SCENE with --sweep or several scenes, cost with --cost)"},
    {"--steppers", "A,B", OPTION_TEXT, &steppers, OPTION_ANY,
     "steppers (default vti1,vti2,vti3); rivals, what others use, by their names too: vti-run --list steppers"},
    {"--h", "STEPS", OPTION_TEXT, &steps, OPTION_ANY,
     "one step, a list, or a ladder by factors of two (default: seven or ten from around the scene's h, 2^-4:2^-13 for "
     "the pendulum); numbers may be written 0.01, 1/64 or 2^-6"},
    {"--t-end", "T", OPTION_TEXT, &end_times, OPTION_ANY,
     "end time (default: the scene's). A run takes the whole steps that fit into it"},
    {"--tolerance", "TOL", OPTION_KEY, &sets, OPTION_ANY,
     "choose steps whose estimated error in velocity and angular velocity is at most TOL; for srkn11, srkn14 and "
     "srkn6. The steps of --h are then only where runs are compared, and the first step that is tried"},
    {"--control", "HOW", OPTION_KEY, &sets, OPTION_ANY,
     "integrating or naive: steps of up to h that follow how fast bodies turn, as in vti-run"},
    {"--set", "PATH=VALUE", OPTION_EACH, &sets, OPTION_ANY, "override a value of the scene; may be repeated"},
    {"--sweep", "PATH=VALUES", OPTION_EACH, &sweeps, OPTION_ANY,
     "the study at each of many values of the scene: a range 1:1000 or 0:1:1/8 (ends included) or a list 100,200; may "
     "be repeated, and then every value goes with every other. Means and spreads are over the first one. Several "
     "scenes may be named"},
    {"--resume", NULL, OPTION_ON, &resume, OPTION_ANY,
     "go on with a study that was interrupted, if there is one in the folder, else start"},
    {"--memory", "MB", OPTION_NUMBER, &megabytes, 0, 0, "500 or 1e4 megabytes",
     "most that the reference solution takes on every rank (default 1000). What is longer is integrated again by every "
     "run, window by window; of scenes with contacts or many bodies fewer states are compared"},
    {"--force", NULL, OPTION_ON, &force, OPTION_ANY,
     "replace files that are no results of vti, or write-protected, too; what the scene is read from is never "
     "replaced"},
    {"--no-plot", NULL, OPTION_OFF, &plot, OPTION_ANY, "no pictures"},
    OPTION_PARAGRAPH(
        "What accuracy costs, errors against force evaluations and time, and the price of each error.\n"
        "Several scenes; each to its own ends T,... or those of --t-end T,...; --steppers knows rivals too\n"
        "(default all); default steps: down by factors of sqrt(2) until an error of 3e-11. Writes cost.csv,\n"
        "errors.csv, prices.csv and machine.txt.\n"),
    {"--cost", NULL, OPTION_ON, &cost, OPTION_ANY, "measure this instead"},
    {"--evals", "MOST", OPTION_WHOLE, &most_evals, 1, 1e15, "50 or 1e3",
     "most force evaluations of a run (default 2^22 over the number of bodies, at most 2^18)"},
    {"--repeats", "N", OPTION_WHOLE, &repeats, 1, COST_REPEATS, "5", "how often each run is timed (default 5)"},
    OPTION_PARAGRAPH(
        "Every run is kept in the folder half a second after it is done. After any end before the last file is\n"
        "written the same command with --resume goes on and gives the same bytes as if nothing had\n"
        "happened, timing.csv excepted. SIGTERM, SIGUSR1 and Ctrl-C end it with code 75; Open MPI's mpirun\n"
        "makes 1 of that, unless it was SIGUSR1, and talks over our message unless it is told to be\n"
        "--quiet. That of Open MPI 5 knows no --quiet, and after SIGTERM and Ctrl-C it does not pass our\n"
        "message on; what is done is kept there too.\n"
        "\n"
        "study.csv has the verdict on every run: good, doubtful or bad, and the numbers behind it. Where\n"
        "one is bad, all files are written and the code is 3. A run that fails is a row with the reason,\n"
        "and the code is 3 too."),
    {0}};

static const struct options options = {
    "vti-study", "mpirun -n RANKS ",
    "[options] [SCENE.yaml]\n   or: mpirun -n RANKS vti-study --sweep PATH=VALUES [options] [SCENE.yaml]...\n   or: "
    "mpirun -n RANKS vti-study --cost [options] [SCENE.yaml[@T,...]]...",
    rows, -1};

/** Values of the scene that no run would have, as options have others in their place. */
static int check_sets(struct message *message)
{
    if (options_refuse_set(&sets, "stepper", "use --steppers", message) != 0 ||
        (steps != NULL && options_refuse_set(&sets, "h", "--h has the steps", message) != 0))
        return -1;
    return end_times != NULL ? options_refuse_set(&sets, "t_end", "--t-end has the end", message) : 0;
}

/** The command line. What is asked for beyond its options must go together. */
static enum options_end read_arguments(int argc, char **argv, int rank, struct message *message)
{
    const enum options_end asked = options_read(&options, argc, argv, rank == 0, &scenes, &scenes_count, message);
    if (asked == OPTIONS_GO && cost && sweeps.count > 0) {
        message_set(message, "--sweep: does not go with --cost; leave one of them out");
        return OPTIONS_WRONG;
    }
    if (asked == OPTIONS_GO && output != NULL && output[0] == '\0') {
        message_set(message, "-o: '' is no folder; name one, or leave -o out");
        return OPTIONS_WRONG;
    }
    if (asked == OPTIONS_GO && check_sets(message) != 0)
        return OPTIONS_WRONG;
    if (asked != OPTIONS_GO || cost)
        return asked;
    if (most_evals > 0 || repeats > 0)
        message_set(message, "%s: goes with --cost only; see vti-study --help",
                    most_evals > 0 ? "--evals" : "--repeats");
    else
        return OPTIONS_GO;
    return OPTIONS_WRONG;
}

/** From four times the scene's h down by factors of two, or from h itself where a larger one might not be stable. */
static void make_ladder(const struct scene *scene, struct plan *plan)
{
    const int stiff = scene_first_with(scene, EFFECT_STIFF) != NULL;
    const int64_t n = stiff ? 7 : 10;
    for (int64_t k = 0; k < n; ++k)
        plan->h[k] = ldexp(scene->h, (int)(stiff ? -k : 2 - k));
    plan->h_count = n;
    plan->h_around = 1;
}

/** The shipped pendulum where no scene is named. */
static int default_scene(struct message *message)
{
    static char shipped[BESIDE_PATH];
    static const char *const one[] = {shipped, NULL};
    if (scenes_count > 0)
        return 0;
    if (beside_scene("pendulum.yaml", shipped) != 0)
        return message_set(message,
                           "the shipped scene pendulum.yaml was not found beside the program; name a scene file");
    scenes = one;
    scenes_count = 1;
    return 0;
}

/** What is the same for all scenes. */
static int read_plan(struct plan *plan, struct message *message)
{
    plan->memory = 1e6 * megabytes;
    if (end_times != NULL && (number_read(end_times, &plan->t_end) != 0 || !(plan->t_end > 0.0)))
        return message_set(message, "--t-end: '%s' is not a positive number; write 10, 1e3 or 2^7", end_times);
    plan->steppers_count = methods_read("--steppers", steppers != NULL ? steppers : "vti1,vti2,vti3", plan->steppers,
                                        STUDY_STEPPERS, message);
    if (plan->steppers_count > 0 && steps != NULL)
        plan->h_count = ladder_read(steps, plan->h, message);
    return plan->steppers_count > 0 && plan->h_count >= 0 ? 0 : -1;
}

static int make_plan(struct scene *scene, struct tables *tables, struct plan *plan, struct message *message)
{
    if (default_scene(message) != 0 || scene_read(scenes[0], sets.text, sets.count, scene, message) != 0 ||
        tables_read(scene, tables, message) != 0 || read_plan(plan, message) != 0)
        return -1;
    plan->scene = scene;
    if (end_times == NULL)
        plan->t_end = scene->t_end;
    if (steps == NULL)
        make_ladder(scene, plan);
    return 0;
}

/** All scenes, and the tables of all values, which survey_check has met. */
static int list_inputs(const struct survey_plan *plan, struct survey_inputs *inputs, struct message *message)
{
    const struct survey_files *files = plan->files;
    inputs->input = calloc((size_t)plan->scenes_count + (size_t)files->tables_count, sizeof *inputs->input);
    if (inputs->input == NULL)
        return message_set(message, "out of memory; use fewer tables");
    for (int k = 0; k < plan->scenes_count; ++k)
        inputs->input[inputs->count++] = (struct input){plan->scenes[k], "the scene"};
    for (int64_t k = 0; k < files->tables_count; ++k)
        inputs->input[inputs->count++] =
            (struct input){files->tables[k].path, tables_kind(files->tables[k].kind)->file};
    return 0;
}

static int make_survey_plan(struct survey_plan *plan, struct sweep *sweep, struct survey_inputs *inputs,
                            struct message *message)
{
    static struct scene read[SURVEY_SCENES]; /* with their tables to the end of the program */
    static struct tables tables[SURVEY_SCENES];
    static struct survey_files files;
    static struct plan common;
    if (default_scene(message) != 0 || read_plan(&common, message) != 0)
        return -1;
    if (scenes_count > SURVEY_SCENES)
        return message_set(message, "%s: more than %d scenes; use fewer at a time", scenes[SURVEY_SCENES],
                           SURVEY_SCENES);
    for (int k = 0; k < sweeps.count; ++k)
        if (sweep_add(sweep, sweeps.text[k], message) != 0)
            return -1;
    for (int k = 0; k < sets.count; ++k)
        if (sweep_check_set(sweep, sets.text[k], message) != 0)
            return -1;
    for (int k = 0; k < sweep->count; ++k)
        if (end_times != NULL && strcmp(sweep->axis[k].key, "t_end") == 0)
            return message_set(message, "--t-end: t_end is swept already; leave one of them out");
    *plan = (struct survey_plan){.scenes = scenes,
                                 .scenes_count = scenes_count,
                                 .sets = sets.text,
                                 .first = read,
                                 .sets_count = sets.count,
                                 .sweep = sweep,
                                 .files = &files,
                                 .read_tables = tables_read};
    for (int k = 0; k < scenes_count; ++k) {
        plan->each[k] = common;
        plan->each[k].scene = &read[k];
        if (survey_read_first(plan, k, &read[k], &tables[k], message) != 0)
            return -1;
        if (steps == NULL)
            make_ladder(&read[k], &plan->each[k]);
    }
    return survey_check(plan, message) != 0 ? -1 : list_inputs(plan, inputs, message);
}

/** Collective. */
static int run_survey(int rank, char folder[FOLDER_PATH], int *wants_plot)
{
    static struct survey_plan plan;
    static struct sweep sweep;
    static struct survey_inputs inputs;
    struct message message = {""};
    int failed = study_agree(make_survey_plan(&plan, &sweep, &inputs, &message), rank, &message);
    if (failed != 0)
        return failed;
    if (output != NULL)
        snprintf(folder, FOLDER_PATH, "%s", output);
    else
        snprintf(folder, FOLDER_PATH, "sweep-%s", plan.first[0].name);
    const struct study_place place = {folder, resume, force, inputs.input, inputs.count, plot ? survey_pictures : NULL};
    failed = study_go_survey(&plan, &place, rank);
    *wants_plot = rank == 0 && plot;
    return failed;
}

static int make_cost_plan(struct cost_scenes *read, struct cost_plan *plan, struct message *message)
{
    enum { REPEATS = 5 };
    plan->most_evals = most_evals;
    plan->repeats = repeats > 0 ? (int)repeats : REPEATS;
    plan->memory = 1e6 * megabytes;
    if (default_scene(message) != 0 ||
        cost_scenes_read(scenes, scenes_count, sets.text, sets.count, end_times, read, plan, message) != 0 ||
        cost_plan_methods(plan, steppers, message) != 0)
        return -1;
    return steps != NULL ? cost_plan_steps(plan, steps, message) : 0;
}

/** A cost study. Collective. */
static int run_cost(int rank)
{
    static struct cost_scenes read;
    static struct cost_plan plan;
    static struct study_inputs inputs;
    struct message message = {""};
    int failed = study_agree(make_cost_plan(&read, &plan, &message), rank, &message);
    for (int k = 0; k < read.count; ++k)
        inputs.count += overwrite_inputs(read.paths[k], &read.scenes[k], inputs.input + inputs.count);
    const struct study_place place = {
        output != NULL ? output : "cost", resume, force, inputs.input, inputs.count, NULL};
    if (failed == 0)
        failed = study_go_cost(&plan, &place, rank);
    cost_scenes_destroy(&read);
    return failed;
}

static int run(int argc, char **argv, int rank, char folder[FOLDER_PATH], int *wants_plot)
{
    static struct scene scene;
    static struct tables tables;
    static struct plan plan;
    static struct study_inputs inputs;
    struct message message = {""};
    const enum options_end asked = read_arguments(argc, argv, rank, &message);
    if (asked == OPTIONS_TOLD)
        return 0;
    if (asked == OPTIONS_GO && cost)
        return run_cost(rank);
    if (asked == OPTIONS_GO && (sweeps.count > 0 || scenes_count > 1))
        return run_survey(rank, folder, wants_plot);
    int failed = asked == OPTIONS_GO ? make_plan(&scene, &tables, &plan, &message) : -1;
    failed = study_agree(failed, rank, &message);
    if (failed == 0) {
        if (output != NULL)
            snprintf(folder, FOLDER_PATH, "%s", output);
        else
            snprintf(folder, FOLDER_PATH, "study-%s", scene.name);
        inputs.count = overwrite_inputs(scenes[0], &scene, inputs.input);
        const struct study_place place = {folder,       resume,       force,
                                          inputs.input, inputs.count, plot ? study_pictures : NULL};
        failed = study_go(&plan, &place, rank);
        *wants_plot = rank == 0 && plot;
    }
    tables_destroy(&tables);
    return failed;
}

int main(int argc, char **argv)
{
    static char folder[FOLDER_PATH];
    struct message message = {""};
    int rank, wants_plot = 0;
    method_admit();
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0)
        log_as("vti-study");
    int failed = run(argc, argv, rank, folder, &wants_plot);
    if (failed >= 0 && study_agree(options_output_end(&message), rank, &message) != 0)
        failed = -1;
    MPI_Finalize();
    /* forking is not safe on every transport while MPI is up, so pictures come last */
    if (failed >= 0 && wants_plot && beside_draw(folder, "study.h5", &message) != 0) {
        fprintf(stderr, "vti-study: %s\n", message.text);
        failed = -1;
    }
    if (failed > 0 && rank > 0)
        return EXIT_SUCCESS; /* rank 0 says it: mpirun would end the pictures with the first that ends so */
    return failed == WATCH_ASKED ? EXIT_RESUME : failed < 0 ? EXIT_FAILURE : failed > 0 ? EXIT_BAD : EXIT_SUCCESS;
}
