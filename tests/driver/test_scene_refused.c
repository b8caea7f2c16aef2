/* SPDX-License-Identifier: BSD-3-Clause
 * Scenes that are refused, and the one line that each of them gets: place, key, value, remedy. */
#define _POSIX_C_SOURCE 200809L
#include "scene_support.h"

#define SPIN "bodies: {inertia: 1, alpha: [0, 0, 0], omega: [0, 0, 1]}\n"
#define BODIES "bodies:\n  inertia: 1\n  alpha: [0, 0, 0]\n  omega: [0, 0, 1]\n"
#define TIME "h: 1/64\nt_end: 1\n"
#define NUMBER " is not a number; write 0.01, 1e-3, 1/64 or 2^-6"
#define ROOT_KEYS                                                                                                      \
    "name, bodies, drag, binder, bond_dashpot, contact, wall, friction, dashpot, gravity, pendulum, stepper, rotor, "  \
    "h, tolerance, control, speed, turning, t_end"
#define BODY_KEYS                                                                                                      \
    "ring, chain, lattice, table, mass, density, inertia, moments, principal, diameter, clumps, x, v, alpha, omega, "  \
    "random"
#define POSITIONS "bodies.x and bodies.v, or bodies.ring, chain, lattice or table"
#define NOTHING "1:1: bodies: nothing moves; give " POSITIONS ", or bodies.alpha and bodies.omega"
#define STEPPERS "vti1, vti2, vti3, vti3-leapfrog, exact, suzuki4, kl6, kl8, srkn6, srkn11, srkn14, chin4"
#define BRACKETS "; look at the brackets, quotes and indentation here and just above"

static const struct refusal files[] = {
    {"", "1:1: no scene in it; write at least bodies, h and t_end"},
    {"# only a comment\n", "1:1: no scene in it; write at least bodies, h and t_end"},
    {"{}\n", "1:1: bodies: missing; add 'bodies:', the spheres"},
    {"5\n", "1:1: '5' is not a scene; write its keys, each on a line of its own: " ROOT_KEYS},
    {"\x01\x02\x03", "1:1: a control character; give a text file in UTF-8"},
    {"h: \xff\n", "1:4: bytes that are no characters; give a text file in UTF-8"},
    {SPIN "h: 'open\n", "2:5: not YAML: single-quoted scalar without closing quote" BRACKETS},
    {SPIN "h: [1, 2\n", "3:1: not YAML: flow sequence without a closing bracket" BRACKETS},
    {SPIN "h: 1\n  t_end: 2\n", "2:4: not YAML: invalid multiline plain key" BRACKETS},
    {SPIN "\th: 1\n", "2:1: not YAML: tab character may not be used as indentation" BRACKETS},
    {SPIN TIME "%%\n", "4:2: not YAML: Unsupported directive" BRACKETS},
    {"%YAML 2.1\n---\n" SPIN TIME, "1:1: not YAML: it cannot be read on from here" BRACKETS},
    {SPIN TIME "# \xed\xa0\x80\n", "4:3: bytes that are no characters; give a text file in UTF-8"},
    {SPIN TIME "---\nh: 2\n", "4:1: a second document; a scene is one document, without '---' inside"},
    {SPIN "h: &a 1/64\nt_end: *a\n", "3:8: an alias; aliases are not read in scenes, write the value itself"},
    {SPIN TIME "? [a, b]\n: 1\n", "4:3: a list or section stands where a key belongs; write 'key: value'"},
    {SPIN TIME "name: \"two\\nlines\"\n", "4:7: a line break or control character in a value; write it on one line"},
    {SPIN TIME "name: two\n  lines\n", "4:7: a line break or control character in a value; write it on one line"},
    {SPIN TIME "name: 'two\n  lines'\n", "4:7: a line break or control character in a value; write it on one line"},
    {SPIN TIME "name: |-\n  # a\n", "5:1: a line break or control character in a value; write it on one line"},
    {SPIN TIME "name: 'it''s'\n", "4:7: name: 'it's' cannot name files; write 1 to 63 letters, digits, _ or -"},
    {SPIN TIME "name: 'a''''b'\n", "4:7: quotes side by side in a value; write it without them"},
    {SPIN TIME "\"a\\0b\": 1\n", "4:1: a line break or control character in a value; write it on one line"},
    {SPIN TIME "steper: vti2\n", "4:1: steper: unknown key 'steper'; known here: " ROOT_KEYS},
    {SPIN TIME
     "x\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4"
     "\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4"
     "\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4: 1\n",
     "4:1: xäääääääääääääääääääääääääääää...: unknown key 'xäääääääääääääääääääääääääääää...'; known "
     "here: " ROOT_KEYS},
    {SPIN TIME "<<: {h: 1}\n", "4:1: <<: unknown key '<<'; known here: " ROOT_KEYS},
    {BODIES "  omga: [0, 0, 1]\n" TIME, "5:3: bodies.omga: unknown key 'omga'; known in bodies: " BODY_KEYS},
    {SPIN TIME "h: 2\n", "4:1: h: given a second time, first on line 2; keep one of them"},
    {BODIES "  inertia: 2\n" TIME, "5:3: bodies.inertia: given a second time, first on line 2; keep one of them"},
    {SPIN, "1:1: h: missing; add 'h:', the time step"},
    {SPIN "h: 1\n", "1:1: t_end: missing; add 't_end:', the time at which the run ends"},
    {"bodies:\n" TIME, "1:7: bodies: '' is not a section; write its keys, each on a line of its own: " BODY_KEYS},
    {"bodies: [1]\n" TIME,
     "1:9: bodies: a list of 1 is not a section; write its keys, each on a line of its own: " BODY_KEYS},
    {"bodies: {inertia: 1}\n" TIME, NOTHING},
    {"bodies: {alpha: [0, 0, 0], omega: [0, 0, 1]}\n" TIME,
     "1:1: bodies.inertia: missing; bodies that turn need it, the moment of inertia J"},
    {"bodies: {x: [0, 0, 0], v: [0, 0, 1]}\n" TIME,
     "1:1: bodies.mass: missing; bodies that translate need it, the mass m"},
    {"bodies: {mass: 1, density: 1, diameter: 1, x: [0, 0, 0], v: [0, 0, 1]}\n" TIME,
     "1:28: bodies.density: given besides bodies.mass; keep one of them"},
    {"bodies: {x: [0, 0, 0], v: [0, 0, 1], density: 1}\n" TIME,
     "1:1: bodies.diameter: missing; spheres of a density need it, the diameter D"},
    {"bodies: {inertia: 1, alpha: [0, 0, 0]}\n" TIME,
     "1:29: bodies.alpha: given without bodies.omega; give both or neither"},
    {"bodies: {mass: 1, v: [0, 0, 0]}\n" TIME, "1:22: bodies.v: given without bodies.x; give both or neither"},
    {"bodies:\n  inertia: 0\n  alpha: [0, 0, 0]\n  omega: [0, 0, 1]\n" TIME,
     "2:12: bodies.inertia: '0' is not positive; the moment of inertia J must be > 0"},
    {"bodies:\n  inertia: [1]\n  alpha: [0, 0, 0]\n  omega: [0, 0, 1]\n" TIME,
     "2:12: bodies.inertia: a list of 1" NUMBER},
    {"bodies:\n  inertia: {J: 1}\n  alpha: [0, 0, 0]\n  omega: [0, 0, 1]\n" TIME,
     "2:12: bodies.inertia: a section" NUMBER},
    {BODIES "  moments: [1, 1, 1]\n" TIME,
     "5:12: bodies.moments: given besides bodies.inertia, which spheres have; keep one"},
    {BODIES "  principal: [0, 0, 1]\n" TIME,
     "5:14: bodies.principal: given without bodies.moments; give both or neither"},
    {"bodies: {moments: [1, 2, 3.1], alpha: [0, 0, 0], omega: [0, 0, 1]}\n" TIME,
     "1:19: bodies.moments: one of 1, 2, 3.1 is more than the sum of the others; no body has such moments, give "
     "smaller "
     "ones"},
    {"bodies: {moments: [1, 1e-320, 1], alpha: [0, 0, 0], omega: [0, 0, 1]}\n" TIME,
     "1:19: bodies.moments: 1e-320 is too small to divide by; choose units in which it is larger"},
    {"bodies: {moments: [1, -2, 3], alpha: [0, 0, 0], omega: [0, 0, 1]}\n" TIME,
     "1:23: bodies.moments[1]: '-2' is not positive; the principal moments of inertia A, B, C must be > 0"},
    {BODIES "  x: [0, 0]\n" TIME, "5:6: bodies.x: 2 values in a list of three numbers; write them as in [0, 0, 1]"},
    {BODIES "  x: [0, 0, 0, 0]\n" TIME,
     "5:6: bodies.x: 4 values in a list of three numbers; write them as in [0, 0, 1]"},
    {BODIES "  x: 0 0 0\n" TIME, "5:6: bodies.x: '0 0 0' is not a list of three numbers; write them as in [0, 0, 1]"},
    {BODIES "  x: {x: 0, y: 0, z: 0}\n" TIME,
     "5:6: bodies.x: a section is not a list of three numbers; write them as in [0, 0, 1]"},
    {BODIES "  x: [0, nan, 0]\n" TIME, "5:10: bodies.x[1]: 'nan'" NUMBER},
    {BODIES "  x: [0, , 0]\n" TIME, "5:10: not YAML: flow sequence with invalid extra comma" BRACKETS},
    {SPIN "pendulum: {}\n" TIME, "2:1: pendulum.weight: missing; add 'weight:', the weight m g"},
    {SPIN "pendulum:\n  weight: 1\n" TIME, "2:1: pendulum.rho0: missing; add 'rho0:', the arm in the body's frame"},
    {SPIN "pendulum:\n  weight: -1\n  rho0: [0, 0, 1]\n" TIME,
     "3:11: pendulum.weight: '-1' is negative; the weight m g must be >= 0"},
    {SPIN "pendulum:\n  weight: 1\n  rho0: [0, -0, 0.0]\n" TIME,
     "4:9: pendulum.rho0: '[0, -0, 0.0]' has no length; the arm in the body's frame must not be zero"},
    {SPIN "h:\nt_end: 1\n", "2:2: h: ''" NUMBER},
    {SPIN "h: 0\nt_end: 1\n", "2:4: h: '0' is not positive; the time step must be > 0"},
    {SPIN "h: 1\nt_end: 0\n", "3:8: t_end: '0' is not positive; the time at which the run ends must be > 0"},
    {SPIN "h: 1e-16\nt_end: 1\n", "3:8: t_end: '1' is more than 2^53 steps of h = 1e-16; take a larger h"},
    {SPIN TIME "stepper: rk4\n", "4:10: stepper: 'rk4' is not a stepper; take one of " STEPPERS},
    {SPIN TIME "stepper: [vti2]\n", "4:10: stepper: a list of 1 is not a word; write a single word"},
    {SPIN TIME "control: exact\n", "4:10: control: 'exact' is not one of integrating, naive; take one of them"},
    {SPIN TIME "control: naive\ntolerance: 1e-6\n",
     "4:10: control: given besides tolerance: steps go by how fast bodies turn or by their errors; keep one"},
    {SPIN TIME "control: naive\nspeed: 2\n",
     "5:8: speed: given without a tolerance, whose unit it is; give both or neither"},
    {SPIN TIME "turning: 2\n",
     "4:10: turning: given without a tolerance or a control, whose unit it is; give one of them, or leave it out"},
    {SPIN TIME "rotor: 3\n", "4:8: rotor: '3' is not one of 2, 4, 6; take one of them"},
    {SPIN TIME "rotor: 4\n",
     "4:8: rotor: a sphere's turn is one, of any order; give bodies.moments or bodies.clumps, or leave it out"},
    {SPIN TIME "stepper: vti1-body\n", "4:10: stepper: 'vti1-body' wants moments in the body's frame, and "
                                       "scenes give them in space; take one of " STEPPERS},
    {SPIN TIME "name: ../etc/passwd\n",
     "4:7: name: '../etc/passwd' cannot name files; write 1 to 63 letters, digits, _ or -"},
    {SPIN TIME "name: ''\n", "4:7: name: '' cannot name files; write 1 to 63 letters, digits, _ or -"},
    {SPIN TIME "name: a23456789b123456789c123456789d123456789e123456789f123456789g1234\n",
     "4:7: name: 'a23456789b123456789c123456789d123456789e123456789f123456789g...' cannot name files; write 1 "
     "to 63 letters, digits, _ or -"},
    {SPIN TIME "name: \"a\\e[31m\"\n", "4:7: a line break or control character in a value; write it on one line"},
    {SPIN TIME "name: \"\\u009b31m\\u00e4\"\n",
     "4:7: name: '??31mä' cannot name files; write 1 to 63 letters, digits, _ or -"},
};

static const struct refusal overrides[] = {
    {"h", "is not path=value; write h=1e-3 or bodies.omega=[0,0,1], say"},
    {"=1", "is not path=value; write h=1e-3 or bodies.omega=[0,0,1], say"},
    {"h=[1", "h: not YAML: flow sequence without a closing bracket" BRACKETS},
    {"h=0", "h: '0' is not positive; the time step must be > 0"},
    {"h=#x", "h: no value in it; write one"},
    {"h=*a", "h: an alias; aliases are not read in scenes, write the value itself"},
    {"h=1\n---\n2", "h: a second document; a scene is one document, without '---' inside"},
    {"bodies=1", "bodies: a section is not set as a whole; set one of its keys: " BODY_KEYS},
    {"bodies.omga=[0, 0, 1]", "bodies.omga: unknown key 'omga'; known in bodies: " BODY_KEYS},
    {"bodies.omega.x=1", "bodies.omega.x: unknown key 'omega.x'; known in bodies: " BODY_KEYS},
    {"bodies..omega=1", "bodies..omega: unknown key '.omega'; known in bodies: " BODY_KEYS},
    {"pendulums.weight=1", "pendulums.weight: unknown key 'pendulums.weight'; known here: " ROOT_KEYS},
    {"pendulum.weight=1", "pendulum.rho0: missing; add 'rho0:', the arm in the body's frame"},
    {"bodies.omega=[0, 1, x]", "bodies.omega[2]: 'x'" NUMBER},
    {"bodies.x=[0, 0, 0]", "bodies.x: given without bodies.v; give both or neither"},
    {"t_end=1e300", "t_end: '1e300' is more than 2^53 steps of h = 1/64; take a larger h"},
};

TEST(files_are_refused)
{
    assert_files_refused(files, sizeof files / sizeof files[0]);
}

TEST(overrides_are_refused)
{
    write_bytes("t.yaml", SPIN TIME, strlen(SPIN TIME));
    assert_sets_refused(overrides, sizeof overrides / sizeof overrides[0]);
}

RUN_TESTS_IN_FOLDER(cmocka_unit_test(files_are_refused), cmocka_unit_test(overrides_are_refused))
