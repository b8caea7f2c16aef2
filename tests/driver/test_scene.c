/* SPDX-License-Identifier: BSD-3-Clause
 * What the scene reader reads: the shipped pendulum, defaults, --set. The path of pendulum.yaml is the argument. */
#define _POSIX_C_SOURCE 200809L
#include "scene_support.h"

static const char *pendulum;

static void read_pendulum(struct scene *scene, const char *const *sets, int n)
{
    struct message message;
    if (scene_read(pendulum, sets, n, scene, &message) != 0)
        fail_msg("%s", message.text);
}

static void read_text(struct scene *scene, const char *text, const char *const *sets, int n)
{
    struct message message;
    write_bytes("spin_2-a.yaml", text, strlen(text));
    if (scene_read("spin_2-a.yaml", sets, n, scene, &message) != 0)
        fail_msg("%s", message.text);
}

TEST(the_shipped_pendulum)
{
    const double alpha[3] = {0.0, 4.828427124746190, 0.0}, omega[3] = {0.2, 0.0, 0.2}, rho0[3] = {0.0, 0.0, 1.0};
    struct scene s;
    read_pendulum(&s, NULL, 0);
    assert_string_equal(s.name, "pendulum");
    assert_int_equal(s.translates, 0);
    assert_int_equal(s.turns, 1);
    assert_true(s.inertia == 1.0);
    assert_same_bits(s.alpha, alpha, 3);
    assert_same_bits(s.omega, omega, 3);
    assert_true(calls_for(&s, "pendulum"));
    assert_true(*number_setting(&s, "pendulum.weight") == 1.0);
    assert_same_bits(number_setting(&s, "pendulum.rho0"), rho0, 3);
    assert_ptr_equal(s.stepper, vti_stepper_find("vti2"));
    assert_true(s.h == 0.015625 && s.t_end == 10.0);
    /* turned by 135 degrees about y: |alpha|/2 = tan(3 pi/8), to the 16 digits that the file writes */
    assert_close(2.0 * atan(s.alpha[1] / 2.0), 0.75 * PI, 1e-15);
}

TEST(what_is_left_out_has_a_default)
{
    struct scene s;
    read_text(&s, "bodies: {mass: 2, x: [1, 2, 3], v: [0, 0, 0]}\nh: 2^-6\nt_end: 1\n", NULL, 0);
    assert_string_equal(s.name, "spin_2-a");
    assert_ptr_equal(s.stepper, vti_stepper_find("vti2"));
    assert_int_equal(s.translates, 1);
    assert_int_equal(s.turns, 0);
    assert_false(calls_for(&s, "pendulum"));
    assert_true(s.mass == 2.0 && s.inertia == 0.0 && s.x[2] == 3.0 && s.h == 0.015625);
}

/** Quotes, comments, flow and block style, tags and anchors without aliases are YAML's business. */
TEST(ways_of_writing)
{
    static const char *const texts[] = {
        "{name: a, bodies: {inertia: 1/2, alpha: [1, 2, 3], omega: [4, 5, 6]}, h: 1/64, t_end: 1}",
        "--- # head\nname: a\nt_end: '1'\nh: \"1/64\"\nbodies:\n  omega:\n  - 4\n  - 5\n  - 6.0\n  inertia: .5\n"
        "  alpha: [1,\n2, 3\n]\n...\n",
        "name: &n a\nbodies: &b\n    inertia: !!float 0.5\n    alpha: [\"1\", +2, 3e0]\n    omega: [4, 10/2, 6]\n"
        "h: 1 / 64\nt_end: 1\n",
        "\xef\xbb\xbfname: a\r\nbodies:\r\n  inertia: 0.5\r\n  alpha: [1, 2, 3]\r\n  omega: [4, 5, 6]\r\nh: 1/64\r\n"
        "t_end: 1\r\n",
    };
    struct scene s, first;
    read_text(&first, texts[0], NULL, 0);
    assert_true(first.inertia == 0.5 && first.alpha[1] == 2.0 && first.omega[2] == 6.0 && first.h == 0.015625);
    for (size_t k = 1; k < sizeof texts / sizeof texts[0]; ++k) {
        read_text(&s, texts[k], NULL, 0);
        assert_memory_equal(&s, &first, sizeof s);
    }
}

TEST(set_replaces_and_adds)
{
    static const char *const sets[] = {
        "h=1", "bodies.omega=[0, 0,1]", "pendulum.weight= 2 ", "stepper=vti3", "bodies.mass=3", "h=1/8", "name=other"};
    const double omega[3] = {0.0, 0.0, 1.0};
    struct scene s;
    read_pendulum(&s, sets, 7);
    assert_true(s.h == 0.125); /* the later one counts */
    assert_same_bits(s.omega, omega, 3);
    assert_true(*number_setting(&s, "pendulum.weight") == 2.0 && s.inertia == 1.0 && s.mass == 3.0);
    assert_ptr_equal(s.stepper, vti_stepper_find("vti3"));
    assert_string_equal(s.name, "other");
}

TEST(set_adds_a_section)
{
    static const char *const sets[] = {"pendulum.weight=0", "pendulum.rho0=[1, 0, 0]"};
    struct scene s;
    read_text(&s, "bodies: {inertia: 1, alpha: [1, 2, 3], omega: [4, 5, 6]}\nh: 1/64\nt_end: 1\n", sets, 2);
    assert_true(calls_for(&s, "pendulum") && *number_setting(&s, "pendulum.weight") == 0.0 &&
                *number_setting(&s, "pendulum.rho0") == 1.0);
}

/** --set mends what the file has wrong: the check comes after it. */
TEST(set_mends)
{
    static const char *const sets[] = {"h=0.5", "t_end=2"};
    struct scene s;
    read_text(&s, "bodies: {inertia: 1, alpha: [1, 2, 3], omega: [4, 5, 6]}\nh: wrong\n", sets, 2);
    assert_true(s.h == 0.5 && s.t_end == 2.0);
}

/** Every stepper that takes moments in space can be named. */
TEST(every_stepper_in_space)
{
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        char set[64];
        const char *const sets[] = {set};
        struct scene s;
        struct message message;
        snprintf(set, sizeof set, "stepper=%s", vti_stepper_at(k)->name);
        const int result = scene_read(pendulum, sets, 1, &s, &message);
        assert_int_equal(result, vti_stepper_at(k)->frame == VTI_FRAME_SPACE ? 0 : -1);
        assert_true(result != 0 || s.stepper == vti_stepper_at(k));
    }
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_shipped_pendulum),  cmocka_unit_test(what_is_left_out_has_a_default),
        cmocka_unit_test(ways_of_writing),       cmocka_unit_test(set_replaces_and_adds),
        cmocka_unit_test(set_adds_a_section),    cmocka_unit_test(set_mends),
        cmocka_unit_test(every_stepper_in_space)};
    pendulum = argc > 1 ? argv[1] : "pendulum.yaml";
    return cmocka_run_group_tests(tests, enter_directory, leave_directory);
}
