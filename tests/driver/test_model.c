/* SPDX-License-Identifier: BSD-3-Clause
 * From scene to model: what the scene names is there, what it does not name is not, and what is conserved follows. */
#define _POSIX_C_SOURCE 200809L
#include "model_support.h"

#include "step_errors.h"

#define MOMENTA "momentum_x momentum_y momentum_z angular_x angular_y angular_z"
#define CHAIN "bodies: {mass: 1, chain: {count: 4, spacing: 1}"
#define WALL "wall: {stiffness: 10, planes: [[0, 0, 2, -6]]}\n"

/* ---- absence ----------------------------------------------------------------------------------------------------- */

static const struct {
    const char *text;
    int translates, force, turns, moment;
    const char *effects, *invariants;
} cases[] = {
    {CHAIN "}\n", 1, 0, 0, 0, "", MOMENTA},
    {CHAIN ", omega: [0, 0, 1]}\n", 1, 0, 1, 0, "", MOMENTA},
    {CHAIN ", random: {seed: 1, omega: 1}}\n", 1, 0, 1, 0, "", MOMENTA},
    {"bodies: {inertia: 1, alpha: [0, 0, 0], omega: [0, 0, 1]}\n", 0, 0, 1, 0, "", "angular_x angular_y angular_z"},
    {CHAIN "}\nbinder: {axial: 1}\n", 1, 1, 0, 0, "binder", MOMENTA},
    {CHAIN "}\nbinder: {moment: 1}\n", 1, 0, 1, 1, "binder", MOMENTA},
    {CHAIN "}\nbinder: {shear: {stiffness: 1}}\n", 1, 1, 1, 1, "binder", MOMENTA},
    {CHAIN "}\nbinder: {shear: {stiffness: 1, form: printed}}\n", 1, 1, 1, 1, "binder",
     "momentum_x momentum_y momentum_z spin_x spin_y spin_z"},
    {CHAIN "}\ncontact: {stiffness: 1}\n", 1, 1, 0, 0, "contact", MOMENTA},
    {CHAIN "}\n" WALL, 1, 1, 0, 0, "wall", "momentum_x momentum_y angular_z"},
    /* what turns on its own keeps its spin at the wall, which turns nothing */
    {CHAIN ", omega: [0, 0, 1]}\n" WALL, 1, 1, 1, 0, "wall", "momentum_x momentum_y angular_z spin_x spin_y"},
    {CHAIN "}\n" WALL "binder: {shear: {stiffness: 1, form: printed}}\n", 1, 1, 1, 1, "binder wall",
     "momentum_x momentum_y spin_x spin_y spin_z"},
    {CHAIN "}\ngravity: [0, 0, -1]\n", 1, 1, 0, 0, "gravity", "momentum_x momentum_y angular_z"},
    {CHAIN "}\ngravity: [1, 2, 3]\n", 1, 1, 0, 0, "gravity", ""},
    {CHAIN "}\ngravity: [0, 0, -1]\n" WALL "contact: {stiffness: 1}\nbinder: {axial: 2, moment: 1}\n", 1, 1, 1, 1,
     "binder contact wall gravity", "momentum_x momentum_y angular_z spin_x spin_y"},
    {"bodies: {inertia: 1}\npendulum: {weight: 1, rho0: [0, 0, 1]}\n", 0, 0, 1, 1, "pendulum",
     "angular_z arm_dot_omega arm_length"},
};

TEST(what_is_there)
{
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k) {
        char text[512];
        struct scene scene;
        struct model model;
        snprintf(text, sizeof text, "%s" TIME, cases[k].text);
        make_model(text, &scene, &model);
        const vti_bodies *b = &model.bodies;
        const int there[] = {b->x.c[0] != NULL,     b->v.c[0] != NULL,     b->mass.p != NULL,
                             b->force.c[0] != NULL, b->alpha.c[0] != NULL, b->omega.c[0] != NULL,
                             b->inertia.p != NULL,  b->moment.c[0] != NULL};
        const int expected[] = {cases[k].translates, cases[k].translates, cases[k].translates, cases[k].force,
                                cases[k].turns,      cases[k].turns,      cases[k].turns,      cases[k].moment};
        if (memcmp(there, expected, sizeof there) != 0)
            fail_msg("wrong views: %s", text);
        assert_int_equal(model.translates, cases[k].translates);
        assert_int_equal(model.turns, cases[k].turns);
        assert_true(scene.translates == model.translates && scene.turns == model.turns); /* no table adds to it */
        assert_effects(&model, cases[k].effects);
        assert_invariants(&model, cases[k].invariants);
        assert_int_equal(bonds_of(&model).count, strstr(cases[k].effects, "binder") != NULL ? 3 : 0);
        assert_true((acting(&model, "contact") != NULL) == (strstr(cases[k].effects, "contact") != NULL));
        model_destroy(&model);
    }
}

/** A stiffness that is not named is a term that is not there. */
TEST(terms)
{
    struct scene scene;
    struct model model;
    make_model(CHAIN "}\nbinder: {moment: 3, shear: {stiffness: 5, form: quartic}}\n" TIME, &scene, &model);
    const vti_bonds bonds = bonds_of(&model);
    assert_true(bonds.moment.p[0] == 3.0 && bonds.shear.p[0] == 5.0 && bonds.axial.p == NULL);
    assert_int_equal(bonds.shear_form, VTI_SHEAR_QUARTIC);
    assert_int_equal(model.effects[0].terms, 2);
    assert_string_equal(model.effects[0].term[1], "binder_shear");
    model_destroy(&model);
}

TEST(planes_are_made_unit)
{
    struct scene scene;
    struct model model;
    make_model(CHAIN "}\nwall: {stiffness: 10, planes: [[0, 0, 2, -6], [3e200, 0, -4e200, 5e200]]}\n" TIME, &scene,
               &model);
    const vti_walls *walls = acting(&model, "wall");
    const double expected[8] = {0, 0, 1, -3, 0.6, 0, -0.8, 1};
    for (int k = 0; k < 8; ++k)
        assert_close(walls->plane[k], expected[k], EPS);
    assert_int_equal(walls->count, 2);
    model_destroy(&model);
}

/* ---- contacts ---------------------------------------------------------------------------------------------------- */

/** Neighbours of a chain that is pressed together: 1 - 0.8/1 = 0.2 of overlap. Bonds keep them from contact unless
 *  asked. */
TEST(contact_inside_bonds)
{
    static const char *const bonded[] = {"", ", bonded: no", ", bonded: yes"};
    const double energy = 0.4 * 100.0 * pow(0.2, 2.5);
    struct scene scene;
    struct model model;
    for (int k = 0; k < 3; ++k) {
        char text[512];
        snprintf(text, sizeof text,
                 "bodies: {mass: 1, diameter: 1, chain: {count: 4, spacing: 0.8}}\nbinder: {axial: 1}\n"
                 "contact: {stiffness: 100%s}\n" TIME,
                 bonded[k]);
        make_model(text, &scene, &model);
        assert_close(model_energy(&model, &model.bodies), k == 2 ? 3 * energy : 0.0, 1e-13);
        assert_true((model.bodies.force.c[0][0] < 0.0) == (k == 2));
        model_destroy(&model);
    }
}

/** Forces and energy are those of the bodies that are passed in, wherever their views lie and however far they have
 *  gone. */
TEST(contacts_follow_the_bodies)
{
    double x[4][3] = {{0, 0, 0}, {100, 0, 0}, {200, 0, 0}, {0, 0.5, 0}}, force[4][3]; /* 0 and 3 were far apart */
    struct scene scene;
    struct model model;
    make_model(CHAIN "}\ncontact: {stiffness: 100}\n" TIME, &scene, &model);
    vti_bodies other = model.bodies;
    assert_int_equal(other.x.count, other.count); /* which slices of threads keep, for a library that looks at lists */
    other.x = vti_view_packed(x[0]);
    other.force = vti_view_packed(force[0]);
    assert_true(other.sealed != 0); /* the model's are checked once, and not at every step */
    other.sealed = 0;               /* these views are others */
    assert_close(model_energy(&model, &other), 0.4 * 100.0 * pow(0.5, 2.5), 1e-13);
    assert_int_equal(model_forces(&model, &model.bodies), VTI_OK);
    assert_int_equal(model_forces(&model, &other), VTI_OK);
    assert_close(force[3][1], 100.0 * pow(0.5, 1.5), 1e-13);
    assert_close(force[0][1], -100.0 * pow(0.5, 1.5), 1e-13);
    assert_true(force[2][0] == 0.0 && model.bodies.force.c[0][0] == 0.0);
    assert_true(model_energy(&model, &model.bodies) == 0.0); /* its own bodies just touch */
    model_destroy(&model);
}

/** A body that is nowhere is named, by the model and by the loop. */
TEST(a_body_that_is_nowhere)
{
    struct scene scene;
    struct model model;
    struct message message;
    make_model(CHAIN "}\ncontact: {stiffness: 100}\n" TIME, &scene, &model);
    model.bodies.v.c[0][6] = NAN;
    assert_int_equal(loop_run(&model, scene.stepper, 0.1, 0, 3, NULL, 0, &message), -1);
    assert_one_line(&message);
    assert_non_null(strstr(message.text, "vti2 at h = 0.1"));
    assert_non_null(strstr(message.text, "step 1"));
    assert_non_null(strstr(message.text, "body 2"));
    model.bodies.x.c[0][6] = NAN;
    assert_int_equal(loop_run(&model, scene.stepper, 0.1, 0, 3, NULL, 0, &message), -1);
    assert_non_null(strstr(message.text, "vti2 at h = 0.1: the start (t = 0): contacts: body 2"));
    assert_int_equal(model_forces(&model, &model.bodies), MODEL_E_PAIRS);
    assert_string_equal(model_text(&model, MODEL_E_PAIRS), model.trouble.text);
    assert_true(isnan(model_energy(&model, &model.bodies)));
    assert_string_equal(model_text(&model, VTI_E_MASS), vti_status_text(VTI_E_MASS));
    model_destroy(&model);
}

/* ---- the stable step --------------------------------------------------------------------------------------------- */

static double overlap(const struct model *model)
{
    return model_deformation(model, &model->bodies).overlap;
}

static double stable(struct model *model)
{
    struct message message;
    vti_stable h;
    const vti_deformation at = {overlap(model), 0, 0};
    assert_int_equal(model_stable_step(model, &model->bodies, &at, &h, &message), 0);
    return h.h;
}

/** Overlaps by hand, 2/5 K o^{5/2} = e; the bound is vti_stable_step's, which has tests of its own. */
TEST(overlaps_and_stable_steps)
{
    struct scene scene;
    struct model model;
    make_model("bodies: {mass: 2, diameter: 1, x: [0, 0, 5], v: [0, 0, -3]}\ngravity: [0, 0, -10]\n"
               "wall: {stiffness: 1000, planes: [[0, 0, 1, 0], [1, 0, 0, -9], [0, 0, -1, -9]]}\n" TIME,
               &scene, &model);
    /* e = m v^2 + m g (z - D/2) = 18 + 90; two planes are not in its way */
    assert_close(overlap(&model), pow(2.5 * 108.0 / 1000.0, 0.4), 4 * EPS);
    /* three planes, a third of the body at each: omega^2 = 1.5 K sqrt(o) (3/m)/(D/2)^2 */
    assert_close(stable(&model), 2.0 / sqrt(1500.0 * sqrt(overlap(&model)) * 1.5 / 0.25), 1e-15);
    model_destroy(&model);
    make_model("bodies: {mass: 1, x: [0, 0, 5], v: [0, 0, -3]}\ngravity: [0, 0, -10]\n" TIME, &scene, &model);
    assert_true(overlap(&model) == 0.0 && isinf(stable(&model)));
    model_destroy(&model);
    make_model(CHAIN ", v: [1e9, 0, 0]}\ncontact: {stiffness: 1e-9}\n" TIME, &scene, &model);
    assert_true(overlap(&model) == 0.0); /* what flies as a whole does not meet itself */
    model_destroy(&model);
    make_model(CHAIN ", v: [1e9, 0, 0]}\nwall: {stiffness: 1e-9, planes: [[-1, 0, 0, -100]]}\n" TIME, &scene, &model);
    assert_true(overlap(&model) == 1.0); /* no deeper than the centre */
    model_destroy(&model);
    /* a cylinder is fallen into down to its lowest line, along its axis as far as to a plane; where it is not met in
     * falling nothing is */
#define IN                                                                                                             \
    "bodies: {mass: 2, diameter: 1, x: [-2, 0.5, 1], v: [0, 0, 0]}\ngravity: [0, 0, -10]\nwall: {stiffness: 1e5, "
    make_model(IN "cylinders: [[0, 1, 0, 0, 0, 0, 3]]}\n" TIME, &scene, &model);
    assert_close(overlap(&model), pow(2.5 * 20.0 * 3.5 / 1e5, 0.4), 1e-14);
    model_destroy(&model);
    make_model(IN "cylinders: [[0, 0, 1, 0, 0, 0, 3]], planes: [[0, 0, 1, -9]]}\n" TIME, &scene, &model);
    assert_close(overlap(&model), pow(2.5 * 20.0 * 9.5 / 1e5, 0.4), 1e-14);
    model_destroy(&model);
    make_model(IN "cylinders: [[0, 3, 4, 0, 0, 0, 30]]}\n" TIME, &scene, &model);
    /* the axis is (0, 0.6, 0.8), and of (0, 0, -1) it leaves (0, 0.48, -0.36) across it */
    const double across = 0.6;
    const double rho2 = 4.0 + 0.25 + 1.0 - 1.1 * 1.1, along = 0.5 * 0.48 - 1.0 * 0.36;
    const double straight = (sqrt(along * along + across * across * (29.5 * 29.5 - rho2)) - along) / (across * across);
    assert_close(overlap(&model), pow(2.5 * 20.0 * straight / 1e5, 0.4), 1e-14);
    model_destroy(&model);
#undef IN
    /* what a spring holds already may go to one body: 2 U in place of m v^2 */
    make_model("bodies: {chain: {count: 2, spacing: 0.6}, mass: 1, diameter: 1}\ncontact: {stiffness: 1e3}\n" TIME,
               &scene, &model);
    assert_close(overlap(&model), 0.4 * pow(2.0, 0.4), 1e-14);
    model_destroy(&model);
    make_model("bodies: {mass: 1, diameter: 1, x: [0, 0, 0.4], v: [0, 0, 0]}\n"
               "wall: {stiffness: 1e3, planes: [[0, 0, 1, 0]]}\n" TIME,
               &scene, &model);
    assert_close(overlap(&model), 0.2 * pow(2.0, 0.4), 1e-14);
    model_destroy(&model);
    make_model(CHAIN "}\nbinder: {axial: 100}\n" TIME, &scene, &model);
    /* inner bodies have two bonds: omega^2 = K (2/m + 2/m)/L0^2 */
    assert_close(stable(&model), 2.0 / sqrt(400.0), 1e-16);
    model_destroy(&model);
}

/* ---- steps that a bound at rest allows, and that blow up --------------------------------------------------------- */

/** The largest energy over that at the start, of `steps` steps of h; infinite if one is refused. */
static double growth(const char *text, double h, int64_t steps)
{
    struct scene scene;
    struct model model;
    struct message message;
    make_model(text, &scene, &model);
    const double start = model_energy(&model, &model.bodies);
    double most = 1.0;
    for (int64_t k = 0; k < steps && isfinite(most); k += 10) {
        if (loop_run(&model, scene.stepper, h, k, k + 10, NULL, 0, &message) < 0)
            most = INFINITY;
        const double now = model_energy(&model, &model.bodies) / start;
        most = now <= most ? most : isnan(now) ? INFINITY : now;
    }
    model_destroy(&model);
    return most;
}

/** Each was said to be far within the stable step, or not to oscillate; each blows up at the h given. At half of the
 *  bound that energies allow it does not, though one impact may gain some per cent (EQUATIONS 6.5). */
TEST(what_energies_allow)
{
    static const struct {
        const char *text;
        double h, gains; /* what it was seen to gain, at least */
    } scenes[] = {
        {"bodies: {mass: 1, lattice: {counts: [3, 3, 3], spacing: 2}, diameter: 1, random: {seed: 2, v: 1}}\n"
         "contact: {stiffness: 1e6}\nh: 0.02\nt_end: 20\n",
         0.02, 10},
        {"bodies: {mass: 1, diameter: 1, table: meet.csv}\n"
         "contact: {stiffness: 1e6}\nh: 0.05\nt_end: 20\n",
         0.05, 10},
        {"bodies: {mass: 1, diameter: 1, table: press.csv}\n"
         "binder: {table: bond.csv, axial: 1, shear: {stiffness: 100}}\nh: 0.05\nt_end: 20\n",
         0, 100},
        {"bodies: {mass: 1, diameter: 1, x: [-2, 0, 31], v: [0, 0, 0]}\ngravity: [0, 0, -9.81]\n"
         "wall: {stiffness: 1e5, cylinders: [[0, 1, 0, 0, 0, 30, 3]]}\nh: 0.0075\nt_end: 20\n",
         0.0075, 10},
        {"bodies: {mass: 1, diameter: 1, table: pull.csv}\nbinder: {table: long.csv, axial: 1e4}\n"
         "wall: {stiffness: 1e6, planes: [[1, 0, 0, -1]]}\nh: 2^-6\nt_end: 20\n",
         0x1p-6, 10},
    };
    write_text("pull.csv", "x,y,z,vx,vy,vz\n0,0,0,0,0,0\n1,0,0,0,0,0\n");
    write_text("long.csv", "i,j,length,nx,ny,nz,turn_x,turn_y,turn_z,turn_w\n1,0,2,1,0,0,0,0,0,1\n");
    write_text("meet.csv", "x,y,z,vx,vy,vz\n0,0,0,0.5,0,0\n2,0,0,-0.5,0,0\n");
    write_text("press.csv", "x,y,z,vx,vy,vz\n0,0,0,0.65,0.001,0\n1,0,0,-0.65,0,0.001\n");
    write_text("bond.csv", "i,j\n0,1\n");
    for (size_t k = 0; k < sizeof scenes / sizeof scenes[0]; ++k) {
        struct scene scene;
        struct model model;
        struct model_limits limits;
        struct message message;
        make_model(scenes[k].text, &scene, &model);
        assert_int_equal(model_find_limits(&model, &limits, &message), 0);
        model_destroy(&model);
        const double h = scenes[k].h > 0 ? scenes[k].h : 0.474 * limits.rest.h;
        const double above = growth(scenes[k].text, h, 4000),
                     below = growth(scenes[k].text, 0.5 * limits.within.h, 40000);
        print_message("at rest %.4g (%s), within %.4g (%s): energy x %.3g at h = %g, x %.3g at half\n", limits.rest.h,
                      limits.rest_by, limits.within.h, limits.within_by, above, h, below);
        assert_true(limits.rest.h > h && limits.within.h < h);
        assert_true(above > scenes[k].gains);
        assert_below(below, 1.1);
    }
}

/** A bonded pair with a wall far away: flying along it deforms nothing, flying at it or turning at it may, if friction
 *  is there along it too. */
TEST(flying_along_a_wall)
{
    static const struct {
        const char *v, *more;
        int strains;
    } flights[] = {
        {"5, 0, 0", "", 0}, {"0, -5, 0", "", 1}, {"5, 0, 0", "friction: {sliding: 0.5, stiffness: 100}\n", 1}};
    for (size_t k = 0; k < sizeof flights / sizeof flights[0]; ++k) {
        struct scene scene;
        struct model model;
        char text[TEXT_SIZE];
        snprintf(text, sizeof text,
                 "bodies: {chain: {count: 2, spacing: 1}, mass: 1, diameter: 1, v: [%s], omega: [0, 0, 0.3]}\n"
                 "binder: {moment: 5, axial: 100}\nwall: {planes: [[0, 1, 0, -100]], stiffness: 1000}\n%sh: 0.01\n"
                 "t_end: 1\n",
                 flights[k].v, flights[k].more);
        make_model(text, &scene, &model);
        const vti_deformation at = model_deformation(&model, &model.bodies);
        assert_int_equal(at.strain > 0.1, flights[k].strains);
        model_destroy(&model);
    }
}

/** What is smooth is seen at any distance: gaps are those of what touches. */
TEST(longest_gap_of_what_touches)
{
    static const char *const bonds[] = {"", "binder: {axial: 1e9}\n", "binder: {axial: 1e9, break: {stretch: 1}}\n"};
    double gap[3];
    for (int k = 0; k < 3; ++k) {
        struct scene scene;
        struct model model;
        struct message message;
        char text[512];
        snprintf(text, sizeof text,
                 CHAIN ", diameter: 1, random: {seed: 1, v: 0.01}}\ncontact: {stiffness: 10, bonded: yes}\n%s" TIME,
                 bonds[k]);
        make_model(text, &scene, &model);
        assert_int_equal(model_longest_gap(&model, &gap[k], &message), 0);
        model_destroy(&model);
    }
    assert_true(gap[0] > 0.1 && gap[1] == gap[0] && gap[2] == gap[0]);
}

/* ---- estimates of errors ----------------------------------------------------------------------------------------- */

/** An estimate has jumped that is ten times both before it and no rounding of the fastest body. */
TEST(jumps_of_estimates)
{
    static const double error[][2] = {{1, 0},     {1, 1e-14},  {0.01, 1e-14}, {1, 9e-13}, /* v has passed through 0 */
                                      {5, 1e-14}, {51, 1e-14}, {1, 1e-14},    {1, 3e-12}},
                        large[2] = {1e9, 1e9};
    struct step_errors *errors = step_errors_create(2);
    double v[2][3] = {{0, 0.5, 0}, {1, 0, 0}};
    vti_bodies bodies = vti_bodies_none(2);
    bodies.v = bodies.omega = vti_view_packed(v[0]);
    assert_non_null(errors);
    for (int k = 0; k < 8; ++k)
        step_errors_take(errors, k, &bodies, error[k]);
    assert_true(errors->found.jumps == 2.0 && errors->found.jump_t == 5.0);
    assert_true(errors->found.most[0] == 51.0 && errors->found.most_t[0] == 5.0 && errors->found.most_t[1] == 7.0);
    step_errors_part(errors);
    step_errors_take(errors, 8, &bodies, large);
    assert_true(errors->found.jumps == 2.0);
    step_errors_destroy(errors);
}

RUN_TESTS_IN_FOLDER(cmocka_unit_test(what_energies_allow), cmocka_unit_test(what_is_there), cmocka_unit_test(terms),
                    cmocka_unit_test(planes_are_made_unit), cmocka_unit_test(contact_inside_bonds),
                    cmocka_unit_test(contacts_follow_the_bodies), cmocka_unit_test(a_body_that_is_nowhere),
                    cmocka_unit_test(overlaps_and_stable_steps), cmocka_unit_test(flying_along_a_wall),
                    cmocka_unit_test(jumps_of_estimates), cmocka_unit_test(longest_gap_of_what_touches))
