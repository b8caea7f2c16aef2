/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A digest of the core's bits: steppers on a scene of every effect in every storage, with dissipation too, of bodies of
 * three moments and by multistep methods; each effect alone, measures, algebra.
 *
 *     digest              one line "name hash" for each
 *     digest --numbers    the numbers at the end of each stepper's run, for machines whose bits have to differ */
#include "digest_more.h"

enum { STEPS = 192, STATES = 64 };
static const double H = 1.0 / 64;
static int numbers;

/* ---- steppers ---------------------------------------------------------------------------------------------------- */

struct play {
    scene here, probed;
    vti_effect effects[EFFECTS];
    const vti_stepper *method;
};

/** Forces; steppers of the body's frame want R^T RM. */
static void load(const struct play *p, const vti_bodies *b)
{
    must(vti_apply(p->effects, EFFECTS, b), "vti_apply");
    for (int64_t i = 0; p->method->frame == VTI_FRAME_BODY && i < b->count; ++i) {
        double q[4], *const m = b->moment.c[0] + 3 * i;
        if (b->alpha.c[0] != NULL)
            vti_rrv_to_pair(b->alpha.c[0] + 3 * i, q);
        else
            memcpy(q, b->quat.xyzw[0] + 4 * i, sizeof q);
        vti_pair_rotate(q, -1.0, m, m);
    }
}

static void step(const struct play *p, const vti_bodies *b, const vti_bodies *probed)
{
    for (int64_t k = 0; k <= p->method->stages; ++k) {
        if (p->method->probe != NULL && p->method->probe[k] != 0.0) {
            must(vti_step_probe(p->method, k, H, b, probed), "vti_step_probe");
            load(p, probed);
        }
        if (k == p->method->stages)
            break;
        must(vti_step_stage(p->method, k, H, b, NULL), p->method->name);
        load(p, b);
    }
    must(vti_step_finish(p->method, H, b), "vti_step_finish");
}

static void print_state(const struct play *p, const vti_bodies *b)
{
    for (int i = 0; numbers && i < BODIES; ++i)
        for (int k = 0; k < 3; ++k)
            printf("%s %.17g\n%s %.17g\n%s %.17g\n", p->method->name, p->here.x[i][k], p->method->name, p->here.v[i][k],
                   p->method->name, p->here.omega[i][k]);
    if (numbers)
        printf("energy %.17g\n", vti_energy(p->effects, EFFECTS, b));
}

static void run(const vti_stepper *method)
{
    static struct play p;
    uint64_t hash = HASH_START;
    for (int storage = 0; storage < STORAGES; ++storage) {
        scene_make(&p.here, 1);
        scene_effects(&p.here, p.effects);
        p.method = method;
        p.probed = p.here;
        vti_bodies b = scene_bodies(&p.here, (enum storage)storage);
        vti_bodies probed = scene_bodies(&p.probed, (enum storage)storage);
        probed.force = b.force;
        probed.moment = b.moment;
        load(&p, &b);
        must(vti_step_start(method, H, &b), "vti_step_start");
        for (int k = 0; k < STEPS; ++k) {
            step(&p, &b, &probed);
            if (k % 16 == 15)
                add_state(&hash, &p.here);
        }
        must(vti_step_sync(method, H, &b), "vti_step_sync");
        add_state(&hash, &p.here);
        print_state(&p, &b);
    }
    if (!numbers)
        say("stepper", method->name, hash);
}

/* ---- effects ----------------------------------------------------------------------------------------------------- */

/** Attitudes of any angle, with half turns among them and, in places, bodies that coincide. */
static void shake(scene *s, uint64_t *seed)
{
    for (int i = 0; i < BODIES; ++i) {
        double shift[3];
        draw_vector(seed, 0.2, shift, 3);
        draw_vector(seed, 1.0, s->quat[i], 4);
        s->quat[i][3] = i % 17 == 0 ? 0.0 : s->quat[i][3];
        vti_rrv_from_quat_xyzw(s->quat[i], s->alpha[i]);
        for (int k = 0; k < 3; ++k)
            s->x[i][k] = i % 29 == 28 ? s->x[i - 1][k] : s->x[i][k] + shift[k];
    }
}

static void effect(const char *what, const char *which, scene *s, const vti_effect *e)
{
    uint64_t hash = HASH_START, seed = 2;
    for (int state = 0; state < STATES; ++state) {
        shake(s, &seed);
        for (int storage = 0; storage < STORAGES; ++storage) {
            const vti_bodies b = scene_bodies(s, (enum storage)storage);
            double energies[VTI_TERMS] = {0.0};
            must(vti_apply(e, 1, &b), which);
            e->energy(e->self, &b, energies);
            hash_add(&hash, s->force[0], 3 * BODIES);
            hash_add(&hash, s->moment[0], 3 * BODIES);
            hash_add(&hash, energies, VTI_TERMS);
        }
    }
    say(what, which, hash);
}

/** Every combination of terms in every form of shear: each is a kernel of its own. */
static void bonds(void)
{
    static scene s;
    vti_effect effects[EFFECTS];
    for (int form = VTI_SHEAR_OBJECTIVE; form <= VTI_SHEAR_PRINTED; ++form)
        for (int terms = form == VTI_SHEAR_OBJECTIVE ? 1 : 4; terms < 8; ++terms) {
            char name[16];
            scene_make(&s, 3);
            scene_effects(&s, effects);
            s.bonds.moment.p = terms & 1 ? s.bonds.moment.p : NULL;
            s.bonds.axial.p = terms & 2 ? s.bonds.axial.p : NULL;
            s.bonds.shear.p = terms & 4 ? s.bonds.shear.p : NULL;
            s.bonds.shear_form = form;
            const vti_effect e = vti_bonds_effect(&s.bonds);
            snprintf(name, sizeof name, "%d.%d", form, terms);
            effect("bonds", name, &s, &e);
        }
}

static void others(void)
{
    static scene s;
    vti_effect effects[EFFECTS];
    for (int k = 1; k < EFFECTS; ++k) {
        scene_make(&s, 3);
        scene_effects(&s, effects);
        effect("effect", effects[k].name, &s, &effects[k]);
    }
}

/* ---- measures ---------------------------------------------------------------------------------------------------- */

static void measures(void)
{
    static scene s, other;
    vti_effect effects[EFFECTS];
    uint64_t hash = HASH_START, angles_hash = HASH_START, seed = 5;
    scene_make(&s, 3);
    scene_effects(&s, effects);
    for (int state = 0; state < STATES; ++state) {
        const vti_bodies b = scene_bodies(&s, state % 2 ? BY_QUATERNION : BY_ALPHA), r = scene_bodies(&other, BY_ALPHA);
        const vti_deformation at = {0.1, 0.0, 0};
        vti_stable stable;
        double about[3], found[14] = {0.0}, scratch[BODIES], angles[3];
        other = s;
        shake(&s, &seed);
        draw_vector(&seed, 10.0, about, 3);
        found[0] = vti_kinetic_translation(&b);
        found[1] = vti_kinetic_rotation(&b);
        found[2] = vti_energy(effects, EFFECTS, &b);
        vti_momentum(&b, found + 3);
        vti_spin(&b, found + 6);
        vti_angular_momentum(&b, about, found + 9);
        found[12] = vti_max_turn(H, &b);
        must(vti_stable_step(effects, EFFECTS, &b, &at, scratch, &stable), "vti_stable_step");
        found[13] = stable.h;
        angles[0] = vti_h1_density(&b);
        angles[1] = vti_h1_distance(&b, &r);
        angles[2] = vti_attitude_distance(&b, &r);
        hash_add(&hash, found, 14);
        hash_add(&angles_hash, angles, 3);
    }
    say("measures", "momenta,energies", hash);
    say("measures", "angles", angles_hash);
}

/* ---- algebra ----------------------------------------------------------------------------------------------------- */

/** A vector of any size from subnormal to 2^1000. */
static void draw_any(uint64_t *seed, double v[3])
{
    draw_vector(seed, 1.0, v, 3);
    for (int left = (int)(draw(seed) % 2060) - 1060; left != 0; left += left < 0 ? 1 : -1)
        for (int k = 0; k < 3; ++k)
            v[k] *= left < 0 ? 0.5 : 2.0;
}

static void algebra(void)
{
    uint64_t hash = HASH_START, angles_hash = HASH_START, seed = 7;
    for (int n = 0; n < 2000; ++n) {
        double a[3], b[3], r[3], q[4], R[9];
        draw_any(&seed, a);
        draw_any(&seed, b);
        vti_rrv_compose(a, b, r);
        hash_add(&hash, r, 3);
        vti_rrv_relative(a, b, r);
        hash_add(&hash, r, 3);
        vti_rrv_rotate(a, b, r);
        hash_add(&hash, r, 3);
        vti_rrv_rotate_back(a, b, r);
        hash_add(&hash, r, 3);
        vti_rrv_to_quat_xyzw(a, q);
        hash_add(&hash, q, 4);
        vti_rrv_from_quat_xyzw(q, r);
        hash_add(&hash, r, 3);
        vti_rrv_to_matrix(a, R);
        hash_add(&hash, R, 9);
        vti_rrv_from_matrix(R, r);
        hash_add(&hash, r, 3);
        r[0] = vti_rrv_angle(a);
        r[1] = vti_rrv_distance(a, b);
        hash_add(&angles_hash, r, 2);
        vti_rrv_to_rotvec(a, r);
        hash_add(&angles_hash, r, 3);
        draw_vector(&seed, 4.0, a, 3);
        vti_rrv_from_rotvec(a, r);
        hash_add(&angles_hash, r, 3);
    }
    say("algebra", "vti_rrv.h", hash);
    say("algebra", "vti_rrv.h,angles", angles_hash);
}

int main(int argc, char **argv)
{
    numbers = argc > 1 && strcmp(argv[1], "--numbers") == 0;
    for (int64_t i = 0; i < vti_stepper_count(); ++i)
        run(vti_stepper_at(i));
    if (numbers)
        return 0;
    for (int64_t i = 0; i < vti_stepper_count(); ++i)
        if (vti_stepper_at(i)->frame == VTI_FRAME_SPACE && vti_stepper_at(i)->probe == NULL)
            tops(vti_stepper_at(i), H, STEPS / 2);
    for (int64_t i = 0; i < vti_multistep_count(); ++i)
        multistep(vti_multistep_at(i), H / 2, STEPS);
    for (int general = 0; general < 2; ++general) {
        dissipation("vti2", general, H, STEPS);
        dissipation("vti3", general, H, STEPS);
    }
    bonds();
    others();
    measures();
    algebra();
    return 0;
}
