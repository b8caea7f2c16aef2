/* SPDX-License-Identifier: BSD-3-Clause
 * Scenes of clumps: bodies of several spheres each, against single spheres, closed forms and what collisions keep. */
#define _POSIX_C_SOURCE 200809L
#include "model_support.h"

#include "state.h"

static void go(struct model *model, int64_t steps, double h)
{
    struct message message;
    if (loop_run(model, vti_stepper_find("vti2"), h, 0, steps, NULL, 0, &message) != 0)
        fail_msg("%s", message.text);
}

static double at(const vti_view *view, int64_t i, int c)
{
    return view->c[c][i * view->stride];
}

/* ---- a clump of one sphere --------------------------------------------------------------------------------------- */

#define FALLING                                                                                                        \
    "lattice: {counts: [3, 3, 3], spacing: 1.1, corner: [0, 0, 1]}, mass: 0.7, random: {seed: 3, v: 2, omega: 1}}\n"   \
    "contact: {stiffness: 200}\nwall: {stiffness: 300, planes: [[0, 0.1, 1, 0]]}\ngravity: [0, 0, -1]\n" TIME

/** Wherever the sphere is in its template, as the body's place is its centre of mass. */
TEST(one_sphere_has_the_bits_of_a_sphere)
{
    static const char *const of[] = {"bodies: {diameter: 1.02, " FALLING,
                                     "bodies: {clumps: {spheres: [[0, 0, 0, 1.02]]}, " FALLING,
                                     "bodies: {clumps: {spheres: [[3, 1, 2, 1.02]]}, " FALLING};
    double *after[3];
    int64_t size = 0;
    for (int k = 0; k < 3; ++k) {
        struct scene scene;
        struct model model;
        make_model(of[k], &scene, &model);
        assert_true(model.bodies.spin.c[0] == NULL);
        go(&model, 200, 1.0 / 64.0);
        size = state_size(&model.bodies);
        after[k] = malloc(sizeof(double) * (size_t)size);
        state_get(&model.bodies, after[k]);
        model_destroy(&model);
    }
    assert_int_equal(size, 27 * 12);
    assert_memory_equal(after[0], after[1], sizeof(double) * (size_t)size);
    assert_memory_equal(after[0], after[2], sizeof(double) * (size_t)size);
    for (int k = 0; k < 3; ++k)
        free(after[k]);
}

/* ---- mass, moments, places --------------------------------------------------------------------------------------- */

/** Two disjoint spheres of diameters 2 and 1 on x, 3 apart, of density 6/pi: masses 8 and 1, 2/5 m R^2 and m d^2. */
TEST(a_dumbbell_by_hand)
{
    struct scene scene;
    struct model model;
    make_model("bodies: {clumps: {spheres: [[1, 0, 0, 2], [4, 0, 0, 1]], density: 6/3.14159265358979324}, x: [5, 6, "
               "7], v: [0, 0, 0], alpha: [0, 0, 2], omega: [1, 2, 3]}\ncontact: {stiffness: 1}\n" TIME,
               &scene, &model);
    const double own = 0.4 * 8.0 + 0.4 * 0.25, about = own + 8.0 / 9.0 + 64.0 / 9.0;
    assert_close(model.bodies.mass.p[0], 9.0, 20 * EPS);
    assert_close(at(&model.bodies.moments, 0, 0), own, 40 * EPS);
    assert_close(at(&model.bodies.moments, 0, 1), about, 40 * EPS);
    assert_close(at(&model.bodies.moments, 0, 2), about, 40 * EPS);
    /* a quarter of a turn about z takes the axis of the dumbbell from x to y */
    assert_close(at(&model.bodies.spin, 0, 0), about, 80 * EPS);
    assert_close(at(&model.bodies.spin, 0, 1), 2.0 * own, 80 * EPS);
    assert_close(at(&model.bodies.spin, 0, 2), 3.0 * about, 80 * EPS);
    const vti_bodies *spheres = model_spheres(&model);
    assert_int_equal(spheres->count, 2);
    assert_close(at(&spheres->x, 0, 1), 6.0 - 1.0 / 3.0, 20 * EPS);
    assert_close(at(&spheres->x, 1, 1), 6.0 + 8.0 / 3.0, 20 * EPS);
    assert_close(at(&spheres->x, 1, 0), 5.0, 20 * EPS);
    assert_true(model.diameter.p[0] == 2.0 && model.diameter.p[1] == 1.0);
    model_destroy(&model);
}

/** Two spheres at -1 and 1 on x, of a body that turns about z: drag on them slows it by 2 c Omega, on the body not at
 *  all. */
TEST(drag_on_spheres)
{
    for (int on_spheres = 0; on_spheres < 2; ++on_spheres) {
        struct scene scene;
        struct model model;
        char text[400];
        snprintf(text, sizeof text,
                 "bodies: {clumps: {spheres: [[-1, 0, 0, 1], [1, 0, 0, 1]]}, mass: 2, x: [0, 0, 0], v: [1, 0, 0], "
                 "alpha: [0, 0, 0], omega: [0, 0, 3]}\ndrag: {linear: 0.5, on: %s}\n" TIME,
                 on_spheres ? "spheres" : "bodies");
        make_model(text, &scene, &model);
        const double j = 2.0 * (0.4 * 0.25 + 1.0), energy = model_energy(&model, &model.bodies);
        go(&model, 128, 1.0 / 128.0);
        const double omega = 3.0 * (on_spheres ? exp(-2.0 * 0.5 / j) : 1.0),
                     v = exp(on_spheres ? -2.0 * 0.5 / 2.0 : -0.5 / 2.0);
        assert_close(at(&model.bodies.omega, 0, 2), omega, 1e-4); /* spheres by turns: (h c/m)^2 */
        assert_close(at(&model.bodies.v, 0, 0), v, 1e-4);
        assert_close(model_energy(&model, &model.bodies) + vti_booked(model.effects, 1), energy, 1e-12);
        model_destroy(&model);
    }
}

/** One step of 2, which is enough where flows are exact: of spheres, and of a dumbbell that moves and turns along its
 *  axis alone. The ledger closes to rounding. */
static void slow_down(const char *text, struct scene *scene, struct model *model)
{
    make_model(text, scene, model);
    const double energy = model_energy(model, &model->bodies);
    go(model, 1, 2.0);
    assert_close(model_energy(model, &model->bodies) + vti_booked(model->effects, 1), energy, 100 * EPS * energy);
}

/** Each sphere by its own diameter, as a body and in a clump: Stokes' c = 3 pi mu D and pi mu D^3, Newton's k = pi/8
 *  C_D rho D^2, under which v0/v = 1 + k v0 t/m; exponents and quotients to some ten roundings. */
TEST(drag_by_diameters)
{
    static const double D[2] = {2.0, 1.0}, m[2] = {3.0, 0.5};
    const double mu = 0.125, k = PI / 8.0 * 0.44 * 0.75, t = 2.0;
    struct scene scene;
    struct model model;
    write_text("b.csv", "x,y,z,vx,vy,vz,omega_x,omega_y,omega_z,mass,diameter\n0,0,0,2,0,0,0,0,3,3,2\n"
                        "5,0,0,2,0,0,0,0,3,0.5,1\n");
    slow_down("bodies: {table: b.csv}\ndrag: {viscosity: 0.125}\nh: 2\nt_end: 2\n", &scene, &model);
    for (int i = 0; i < 2; ++i) {
        assert_close(at(&model.bodies.v, i, 0), 2.0 * exp(-3.0 * PI * mu * D[i] * t / m[i]), 100 * EPS);
        assert_close(at(&model.bodies.omega, i, 2), 3.0 * exp(-PI * mu * D[i] * t / (0.1 * m[i])), 100 * EPS);
    }
    model_destroy(&model);
    slow_down("bodies: {table: b.csv}\ndrag: {density: 0.75}\nh: 2\nt_end: 2\n", &scene, &model);
    for (int i = 0; i < 2; ++i) {
        assert_close(at(&model.bodies.v, i, 0), 2.0 / (1.0 + k * D[i] * D[i] * 2.0 * t / m[i]), 100 * EPS);
        assert_true(at(&model.bodies.omega, i, 2) == 3.0);
    }
    model_destroy(&model);
#define DUMBBELL                                                                                                       \
    "bodies: {clumps: {spheres: [[1, 0, 0, 2], [4, 0, 0, 1]]}, mass: 9, x: [5, 6, 7], v: [2, 0, 0], alpha: [0, 0, "    \
    "0], omega: [3, 0, 0]}\nh: 2\nt_end: 2\n"
    const double about_axis = 0.4 * 8.0 + 0.4 * 0.25; /* spheres of masses 8 and 1 */
    slow_down(DUMBBELL "drag: {viscosity: 0.125, on: spheres}\n", &scene, &model);
    assert_close(at(&model.bodies.v, 0, 0), 2.0 * exp(-3.0 * PI * mu * (2.0 + 1.0) * t / 9.0), 100 * EPS);
    assert_close(at(&model.bodies.omega, 0, 0), 3.0 * exp(-PI * mu * (8.0 + 1.0) * t / about_axis), 100 * EPS);
    model_destroy(&model);
    slow_down(DUMBBELL "drag: {density: 0.75, coefficient: 0.22, on: spheres}\n", &scene, &model);
    assert_close(at(&model.bodies.v, 0, 0), 2.0 / (1.0 + k / 2.0 * (4.0 + 1.0) * 2.0 * t / 9.0), 100 * EPS);
    model_destroy(&model);
}

#define TWO "clumps: {spheres: [[0, 0, 0, 1], [1, 0, 0, 1], [0, 0, 0, 2]], counts: [2, 1]"

/** Templates take turns, or are named by the table; bodies may have masses of their own. */
TEST(templates)
{
    struct scene scene;
    struct model model;
    make_model("bodies: {chain: {count: 5, spacing: 3}, " TWO ", density: 1}}\ncontact: {stiffness: 1}\n" TIME, &scene,
               &model);
    static const int64_t turns[] = {0, 0, 1, 2, 2, 3, 4, 4};
    static const double diameters[] = {1, 1, 2, 1, 1, 2, 1, 1};
    assert_int_equal(model.clumps.list.count, 8);
    assert_memory_equal(model.clumps.list.body, turns, sizeof turns);
    assert_same_bits(model.diameter.p, diameters, 8);
    assert_close(model.bodies.mass.p[1], 4.0 * model.bodies.mass.p[0], 20 * EPS);
    model_destroy(&model);
    write_text("b.csv", "x,y,z,mass,clump,young,poisson\n0,0,0,3,1,100,0.2\n5,0,0,4,0,200,0.2\n");
    make_model("bodies: {table: b.csv, " TWO "}}\ncontact: {}\nwall: {young: 300, poisson: 0, planes: [[0, 0, 1, "
               "-5]]}\n" TIME,
               &scene, &model);
    static const int64_t named[] = {0, 1, 1};
    assert_int_equal(model.clumps.list.count, 3);
    assert_memory_equal(model.clumps.list.body, named, sizeof named);
    assert_close(at(&model.bodies.moments, 0, 0), 0.4 * 3.0, 10 * EPS);
    assert_close(at(&model.bodies.moments, 1, 0), 0.4 * 4.0 * 0.25, 10 * EPS);
    assert_true(model.modulus.p[1] == model.modulus.p[2] && model.modulus.p[1] == 2.0 * model.modulus.p[0]);
    model_destroy(&model);
}

/** Random attitudes leave the velocities of the same seed as they are. */
TEST(random_attitudes)
{
    struct scene scene;
    struct model with, without;
    make_model("bodies: {chain: {count: 9, spacing: 3}, random: {seed: 5, v: 1, omega: 1, alpha: 3}, " TWO
               ", density: 1}}\n" TIME,
               &scene, &with);
    make_model("bodies: {chain: {count: 9, spacing: 3}, random: {seed: 5, v: 1, omega: 1}, " TWO
               ", density: 1}}\n" TIME,
               &scene, &without);
    double most = 0.0;
    for (int64_t i = 0; i < 9; ++i)
        for (int c = 0; c < 3; ++c) {
            assert_true(at(&with.bodies.v, i, c) == at(&without.bodies.v, i, c));
            assert_true(at(&with.bodies.omega, i, c) == at(&without.bodies.omega, i, c));
            assert_true(fabs(at(&with.bodies.alpha, i, c)) <= 3.0 && at(&without.bodies.alpha, i, c) == 0.0);
            most = fmax(most, fabs(at(&with.bodies.alpha, i, c)));
        }
    assert_true(most > 2.0);
    model_destroy(&with);
    model_destroy(&without);
}

/* ---- contacts ---------------------------------------------------------------------------------------------------- */

#define MEETING                                                                                                        \
    "clumps: {spheres: [[1, 0, 0, 1], [-0.5, 0.8, 0, 1], [-0.5, -0.8, 0, 1.1], [0, 0, 0.7, 1.3]], density: 1}, "       \
    "omega: [0.3, 0.5, -0.2]"

/** Spheres of one body, which overlap here, are no contacts. */
TEST(no_contact_inside_a_clump)
{
    struct scene scene;
    struct model model;
    make_model("bodies: {x: [0, 0, 0], v: [1, 0, 0], alpha: [0, 0, 0], " MEETING "}\ncontact: {stiffness: 100}\n" TIME,
               &scene, &model);
    const double kinetic = vti_kinetic_translation(&model.bodies) + vti_kinetic_rotation(&model.bodies);
    assert_true(model_energy(&model, &model.bodies) == kinetic);
    model_destroy(&model);
}

struct kept {
    double momentum[3], angular[3], energy;
};

static struct kept measure(struct model *model)
{
    const double origin[3] = {0.0, 0.0, 0.0};
    struct kept kept;
    vti_momentum(&model->bodies, kept.momentum);
    vti_angular_momentum(&model->bodies, origin, kept.angular);
    kept.energy = model_energy(model, &model->bodies);
    return kept;
}

static void assert_momenta_kept(const struct kept *start, const struct kept *end, int64_t steps)
{
    const double off = 10.0 * sqrt((double)steps) * EPS; /* sums of up to 10 roundings per step, at random signs */
    for (int c = 0; c < 3; ++c) {
        assert_close(end->momentum[c], start->momentum[c], 4.0 * off);
        assert_close(end->angular[c], start->angular[c], 8.0 * off);
    }
}

/** Two clumps collide: P and L are kept to rounding, the energy to second order in h, and both have turned. */
TEST(two_clumps_collide)
{
    double error[2];
    write_text("b.csv", "x,y,z,vx,vy,vz\n-1.6,0.3,0.2,1,0,0.1\n1.6,0,-0.2,-1,0.2,0\n");
    for (int k = 0; k < 2; ++k) {
        struct scene scene;
        struct model model;
        const int64_t steps = 1000 << k;
        make_model("bodies: {table: b.csv, " MEETING "}\ncontact: {stiffness: 50}\n" TIME, &scene, &model);
        const struct kept start = measure(&model);
        const double spin = at(&model.bodies.spin, 0, 0);
        go(&model, steps, 4.0 / (double)steps);
        const struct kept end = measure(&model);
        assert_momenta_kept(&start, &end, steps);
        assert_true(fabs(at(&model.bodies.spin, 0, 0) - spin) > 0.01);
        error[k] = fabs(end.energy - start.energy);
        model_destroy(&model);
    }
    assert_true(error[0] < 1e-3 && error[1] < 0.5 * error[0]);
}

/* ---- refusals ---------------------------------------------------------------------------------------------------- */

#define CLUMPS "bodies: {x: [0, 0, 0], v: [0, 0, 0], clumps: {spheres: "

TEST(refused_scenes)
{
    static const struct refusal files[] = {
        {CLUMPS "[[0, 0, 0, 1], [1, 0, 0, 1], [0, 0, 0, 2], [1, 0, 0, 1]]}, mass: 1}\n" TIME,
         "1:56: bodies.clumps.spheres: row [3] is there a second time, first by row [1]; keep one"},
        {CLUMPS "[]}, mass: 1}\n" TIME, "1:56: bodies.clumps.spheres: no spheres; give rows x, y, z, D"},
        {CLUMPS "[[0, 0, 0]]}, mass: 1}\n" TIME,
         "1:57: bodies.clumps.spheres[0]: 3 values in a list of four numbers x, y, z, D; write them as in [0, 0, 0, "
         "1]"},
        {CLUMPS "[[0, 0, 0, -1]]}, mass: 1}\n" TIME,
         "1:67: bodies.clumps.spheres[0]: the diameter '-1' is not positive; the fourth number must be > 0"},
        {CLUMPS "[[0, 0, 0, 1]], counts: [2]}, mass: 1}\n" TIME,
         "1:80: bodies.clumps.counts: 2 spheres in all, and there are 1; count each once"},
        {CLUMPS "[[0, 0, 0, 1]], counts: [0.5, 0.5]}, mass: 1}\n" TIME,
         "1:80: bodies.clumps.counts: 0.5 is not a whole number; spheres are counted"},
        {CLUMPS "[[0, 0, 0, 1]], density: 1}, mass: 1}\n" TIME,
         "1:81: bodies.clumps.density: given besides bodies.mass; keep one of them"},
        {CLUMPS "[[0, 0, 0, 1]]}}\n" TIME, "1:1: bodies.mass: missing; bodies that translate need it, the mass m"},
        {CLUMPS "[[0, 0, 0, 1]]}, mass: 1, inertia: 1}\n" TIME,
         "1:91: bodies.inertia: given besides bodies.clumps, whose spheres say it; leave it out"},
        {CLUMPS "[[0, 0, 0, 1]]}, mass: 1, diameter: 1}\n" TIME,
         "1:92: bodies.diameter: given besides bodies.clumps, whose spheres say it; leave it out"},
        {"bodies: {alpha: [0, 0, 0], omega: [0, 0, 0], clumps: {spheres: [[0, 0, 0, 1]]}, mass: 1}\n" TIME,
         "1:46: bodies.clumps: has no position; give bodies.x and bodies.v, or bodies.ring, chain, lattice or table"},
        {"bodies: {x: [0, 0, 0], v: [0, 0, 0], clumps: {density: 1}}\n" TIME,
         "1:38: bodies.clumps.spheres: missing; add 'spheres:', the spheres of the templates"},
    };
    assert_files_refused(files, sizeof files / sizeof files[0]);
}

static void assert_model_refused(const char *text, const char *line)
{
    struct scene scene;
    struct model model;
    struct message message;
    assert_refused(text, try_model(text, &scene, &model, &message), &message, line);
}

TEST(refused_models)
{
    assert_model_refused(CLUMPS "[[0, 0, 0, 1e-200]]}, mass: 1}\n" TIME,
                         "t: bodies.clumps: the volume or a moment of template 0 is 0 or not finite; give spheres of "
                         "moderate size");
    assert_model_refused("bodies: {chain: {count: 2, spacing: 2}, mass: 1, clumps: {spheres: [[0, 0, 0, 1], [1, 0, 0, "
                         "1]]}}\nbinder: {axial: 1}\ncontact: {stiffness: 1}\n" TIME,
                         "t: contact.bonded: spheres of clumps touch, whether these are bonded or not; give yes");
    assert_model_refused("bodies: {chain: {count: 2, spacing: 2}, mass: 1, clumps: {spheres: [[0, 0, 0, 1]]}}\n"
                         "binder: {axial: 1, break: {stretch: 0.1}}\n" TIME,
                         "t: bonds of bodies.clumps neither break nor are made on the way; leave out binder.break, "
                         "columns break_... of its table, and binder.when");
    write_text("b.csv", "x,y,z,mass,clump\n0,0,0,3,2\n");
    assert_model_refused("bodies: {table: b.csv, " TWO "}}\n" TIME,
                         "b.csv:2: clump: there is no template 2; bodies.clumps has 2, from 0");
    assert_model_refused("bodies: {table: b.csv, " TWO ", density: 1}}\n" TIME,
                         "b.csv: gives what the scene gives as bodies.clumps.density too; keep one of them");
    assert_model_refused("bodies: {table: b.csv, diameter: 1}\n" TIME,
                         "b.csv: has a column clump, and the scene no bodies.clumps; give both or neither");
    write_text("b.csv", "x,y,z,mass,clump\n0,0,0,3,0.5\n");
    assert_model_refused("bodies: {table: b.csv, " TWO "}}\n" TIME,
                         "b.csv:2:9: clump: '0.5' is not a whole number from 0; write 0, 1, 2 and so on");
    write_text("b.csv", "x,y,z,mass,diameter\n0,0,0,3,2\n");
    assert_model_refused("bodies: {table: b.csv, " TWO "}}\n" TIME,
                         "b.csv: gives what the scene gives as bodies.clumps too; keep one of them");
    write_text("b.csv", "omega_x,omega_y,omega_z,mass\n0,0,0,3\n");
    assert_model_refused("bodies: {table: b.csv, " TWO "}}\n" TIME,
                         "b.csv: no columns x, y, z; bodies.clumps needs them");
    write_text("b.csv", "x,y,z\n0,0,0\n");
    assert_model_refused("bodies: {table: b.csv, " TWO "}}\n" TIME,
                         "b.csv: no column mass; bodies that translate need it, or bodies.mass");
}

/** Bonds hold clumps at their centres, and whoever knows spheres alone is told. */
TEST(bonded_clumps)
{
    struct scene scene;
    struct model model;
    struct message message;
    make_model("bodies: {chain: {count: 3, spacing: 2.5}, " TWO ", density: 1}}\nbinder: {axial: 10, moment: "
               "1}\ncontact: {stiffness: 1, bonded: yes}\n" TIME,
               &scene, &model);
    assert_effects(&model, "binder contact");
    assert_int_equal(model_of_spheres(&model, "rk4", "leave it out", &message), -1);
    assert_string_equal(message.text, "t: bodies.clumps: rk4 knows bodies that are spheres; leave it out");
    model_destroy(&model);
}

/** Clumps of a sphere each are bonded as these are, to the bit. */
TEST(bonded_spheres_of_one_are_bonded_bodies)
{
    double *after[2];
    int64_t size = 0;
    write_text("bonds.csv", "i,j,axial,shear\n0,1,30,5\n2,1,20,4\n");
    for (int k = 0; k < 2; ++k) {
        struct scene scene;
        struct model model;
        char text[400];
        snprintf(text, sizeof text,
                 "bodies: {chain: {count: 3, spacing: 2}, mass: 0.7, random: {seed: 3, v: 1, omega: 1}, clumps: "
                 "{spheres: [[1, 2, 3, 1]]}}\nbinder: {table: bonds.csv, moment: 3, on: %s}\n" TIME,
                 k == 0 ? "bodies" : "spheres");
        make_model(text, &scene, &model);
        assert_int_equal(model.on_spheres[0], k);
        go(&model, 200, 1.0 / 64.0);
        size = state_size(&model.bodies);
        after[k] = malloc(sizeof(double) * (size_t)size);
        state_get(&model.bodies, after[k]);
        model_destroy(&model);
    }
    assert_memory_equal(after[0], after[1], sizeof(double) * (size_t)size);
    free(after[0]);
    free(after[1]);
}

#define DUMBBELLS                                                                                                      \
    "bodies: {table: b.csv, mass: 2, clumps: {spheres: [[-1, 0, 0, 1], [1, 0, 0, 1.2]]}}\n"                            \
    "binder: {table: bonds.csv, on: spheres, "

/** Two dumbbells on a line, joined by the spheres that face each other: L0 = 3, k = K/L0^2 = 1, reduced mass 1.
 *  Velocity Verlet has s = v h sin(n w)/sin w of it, 4 sin^2(w/2) = h^2. Bonds end where spheres are, not bodies. */
TEST(a_bond_between_spheres)
{
    const double h = 1.0 / 16.0, w = 2.0 * asin(0.5 * h);
    struct scene scene;
    struct model model;
    write_text("b.csv", "x,y,z,vx,vy,vz\n0,0,0,-0.05,0,0\n5,0,0,0.05,0,0\n");
    write_text("bonds.csv", "i,j\n2,1\n");
    make_model(DUMBBELLS "axial: 9}\n" TIME, &scene, &model);
    const double gap = at(&model.bodies.x, 1, 0) - at(&model.bodies.x, 0, 0);
    go(&model, 100, h);
    const double stretch = at(&model.bodies.x, 1, 0) - at(&model.bodies.x, 0, 0) - gap;
    assert_close(stretch, 0.1 * h * sin(100 * w) / sin(w), 1000 * EPS); /* 100 steps of numbers of 5 */
    assert_true(at(&model.bodies.omega, 0, 2) == 0.0);
    model_destroy(&model);
}

/** Bodies may be turned at t = 0: nothing pulls then. */
TEST(bonds_between_spheres_begin_at_rest)
{
    struct scene scene;
    struct model model;
    write_text("b.csv", "x,y,z,alpha_x,alpha_y,alpha_z\n0,0,0,1,-3,0.5\n5,0,0,0.3,2,7\n");
    write_text("bonds.csv", "i,j\n0,3\n1,2\n");
    make_model(DUMBBELLS "axial: 9, moment: 2, shear: {stiffness: 3}}\n" TIME, &scene, &model);
    for (int i = 0; i < 2; ++i)
        for (int c = 0; c < 3; ++c) { /* stiffnesses of 9 over lengths of 3 */
            assert_close(at(&model.bodies.force, i, c), 0.0, 100 * EPS);
            assert_close(at(&model.bodies.moment, i, c), 0.0, 100 * EPS);
        }
    assert_close(model_energy(&model, &model.bodies), 0.0, EPS);
    model_destroy(&model);
}

/** Aslant, with all terms: momenta to rounding, the energy to second order. What is bonded is no contact, all else
 *  is. */
TEST(bonds_between_spheres_keep)
{
    double error[2];
    write_text("b.csv",
               "x,y,z,vx,vy,vz,omega_x,omega_y,omega_z\n0,0,0,0,0.1,0,0.3,0.2,-0.1\n1.5,1.2,0.4,0,-0.1,0,0,-0.2,0.3\n");
    write_text("bonds.csv", "i,j,moment,shear\n0,3,0.5,0.4\n1,2,0.2,1\n");
    for (int k = 0; k < 2; ++k) {
        struct scene scene;
        struct model model;
        const int64_t steps = 1000 << k;
        make_model(DUMBBELLS "axial: 5}\ncontact: {stiffness: 50}\n" TIME, &scene, &model);
        assert_int_equal(model.effects_count, 2);
        const struct kept start = measure(&model);
        go(&model, steps, 8.0 / (double)steps);
        const struct kept end = measure(&model);
        assert_momenta_kept(&start, &end, steps);
        error[k] = fabs(end.energy - start.energy);
        model_destroy(&model);
    }
    assert_true(error[0] < 1e-3 && error[1] < 0.3 * error[0]);
    struct scene scene;
    struct model model;
    double of[2];
    write_text("b.csv", "x,y,z\n0,0,0\n3,0,0\n"); /* spheres 1 and 2 overlap by 0.1 */
    write_text("bonds.csv", "i,j\n1,2\n");
    for (int k = 0; k < 2; ++k) {
        make_model(k == 0 ? DUMBBELLS "axial: 9}\ncontact: {stiffness: 50}\n" TIME
                          : DUMBBELLS "axial: 9}\ncontact: {stiffness: 50, bonded: yes}\n" TIME,
                   &scene, &model);
        of[k] = model_energy(&model, &model.bodies);
        model_destroy(&model);
    }
    assert_true(of[0] == 0.0 && of[1] > 0.0);
}

TEST(bonds_between_spheres_refused)
{
    write_text("b.csv", "x,y,z\n0,0,0\n5,0,0\n");
    write_text("bonds.csv", "i,j\n2,3\n");
    assert_model_refused(DUMBBELLS "axial: 9}\n" TIME,
                         "bonds.csv:2: spheres 2 and 3 are of one body, 1; name spheres of two");
    write_text("bonds.csv", "i,j\n2,4\n");
    assert_model_refused(DUMBBELLS "axial: 9}\n" TIME,
                         "bonds.csv:2: j: '4' is not a sphere; there are 4, counted from 0");
    write_text("bonds.csv", "i,j\n2,1\n1,2\n");
    assert_model_refused(DUMBBELLS "axial: 9}\n" TIME,
                         "bonds.csv:3: spheres 1 and 2 are bonded a second time, first by line 2; keep one");
}

RUN_TESTS_IN_FOLDER(cmocka_unit_test(one_sphere_has_the_bits_of_a_sphere), cmocka_unit_test(a_dumbbell_by_hand),
                    cmocka_unit_test(drag_on_spheres), cmocka_unit_test(drag_by_diameters), cmocka_unit_test(templates),
                    cmocka_unit_test(random_attitudes), cmocka_unit_test(no_contact_inside_a_clump),
                    cmocka_unit_test(two_clumps_collide), cmocka_unit_test(refused_scenes),
                    cmocka_unit_test(refused_models), cmocka_unit_test(bonded_clumps),
                    cmocka_unit_test(bonded_spheres_of_one_are_bonded_bodies), cmocka_unit_test(a_bond_between_spheres),
                    cmocka_unit_test(bonds_between_spheres_begin_at_rest), cmocka_unit_test(bonds_between_spheres_keep),
                    cmocka_unit_test(bonds_between_spheres_refused))
