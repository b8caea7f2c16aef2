/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The torus with contact inside its bonds as well: test_torus_contact [t]. Bonded bodies touch at rest, so that the
 * onset of the contact, a kink of its stiffness, sits where every bond oscillates, and energy climbs (E20). With every
 * K times L0^2, the printed shear and this contact, h = 1e-2 gets to t = 500, which the printed numbers do not
 * (E19). */
#include "torus.h"

enum { PAIRS = RING * (RING - 1) / 2 };

static int until = 100;

/** Contact between all pairs, bonded or not. */
static void touch_everywhere(torus *t)
{
    static int64_t pair[PAIRS][2];
    int64_t n = 0;
    for (int i = 0; i < RING; ++i)
        for (int j = i + 1; j < RING; ++j) {
            pair[n][0] = i;
            pair[n++][1] = j;
        }
    t->contacts.count = n;
    t->contacts.pair = pair[0];
    t->effects[1] = vti_contacts_effect(&t->contacts);
}

static void scale(torus *t, double by)
{
    for (int k = 0; k < RING; ++k) {
        t->w.moment[k] *= by;
        t->w.axial[k] *= by;
        t->w.shear[k] *= by;
    }
    t->contacts.stiffness *= by;
    t->walls.stiffness *= by;
}

/** The E-error of the paper to t, in shares of E_0 = 40, sampled every 0.1; E at the end in *last. */
static double energy_error(torus *t, const char *stepper, double h, double end, double *last)
{
    const double every = 0.1;
    const vti_bodies b = crowd_bodies(&t->c);
    const int samples = (int)lround(end / every);
    double squares = 0;
    for (int k = 0; k < samples; ++k) {
        crowd_steps(&t->c, vti_stepper_find(stepper), h, lround(every / h), t->effects, 3);
        *last = vti_energy(t->effects, 3, &b);
        squares += pow(*last / 40 - 1, 2) / samples;
    }
    return sqrt(squares);
}

/** h = 2e-3 to t = 100: +1.3 to +4.9 of 40 as seen of eight starts that differ by 1e-13; without the contact inside
 *  0.12 % at all times. With 500 for t and h = 1e-3, 41.18. */
TEST(energy_climbs)
{
    static torus t;
    const double h = until > 100 ? 1e-3 : 2e-3;
    double last = NAN;
    torus_start(&t, VTI_SHEAR_OBJECTIVE);
    touch_everywhere(&t);
    const double error = energy_error(&t, "vti2", h, until, &last);
    print_message("contact inside bonds, h = %g: E = %.2f at t = %d, E-error %.2g\n", h, last, until, error);
    assert_true(last > 40 + (until > 100 ? 0.5 : 1.0));
    torus_start(&t, VTI_SHEAR_OBJECTIVE);
    assert_below(energy_error(&t, "vti2", h, 100, &last), 3e-3);
}

/** The printed shear is chaotic: starts that differ by 1e-13 end with other errors. VTI-2 at h = 1e-2 has 1.8 to 4.8 %
 *  in seven of them, at h = 5e-3 a tenth of that; all seven run with 500 for t. */
TEST(other_reading_of_the_figure)
{
    static torus t;
    static const char *const steppers[] = {"vti2", "vti3", "vti2"};
    static const double h[] = {1e-2, 1e-2, 5e-3}, most[] = {0.08, 0.08, 0.008};
    const int starts = until > 100 ? 7 : 1;
    double last = NAN;
    for (int k = 0; k < 3; ++k)
        for (int s = 0; s < starts; ++s) {
            torus_start(&t, VTI_SHEAR_PRINTED);
            scale(&t, t.diameter * t.diameter); /* L0 = D_p */
            touch_everywhere(&t);
            t.effects[0] = vti_bonds_effect(&t.w.bonds);
            t.effects[2] = vti_walls_effect(&t.walls);
            t.c.v[3][1] = 1e-13 * s;
            const double error = energy_error(&t, steppers[k], h[k], 500, &last);
            print_message("K times L0^2, %s, h = %g: E-error to t = 500 %.2g\n", steppers[k], h[k], error);
            assert_below(error, most[k]);
        }
    torus_start(&t, VTI_SHEAR_PRINTED); /* with the numbers as printed */
    touch_everywhere(&t);
    assert_true(!(energy_error(&t, "vti2", 1e-2, 0.1, &last) < 1)); /* over, or NaN */
}

int main(int argc, char **argv)
{
    if (argc > 1)
        until = (int)strtol(argv[1], NULL, 10);
    const struct CMUnitTest tests[] = {cmocka_unit_test(energy_climbs), cmocka_unit_test(other_reading_of_the_figure)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
