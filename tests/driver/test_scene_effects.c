/* SPDX-License-Identifier: BSD-3-Clause
 * Arrangements and effects in scene files: those that are refused, and the one line that each of them gets. */
#define _POSIX_C_SOURCE 200809L
#include "model_support.h"

#define NUMBER " is not a number; write 0.01, 1e-3, 1/64 or 2^-6"
#define COUNT " is not a whole number; write 80 or 1e5"
#define POSITIONS "bodies.x and bodies.v, or bodies.ring, chain, lattice or table"
#define ONE_OF "; positions come from one of x, ring, chain, lattice and table"
#define POINT "bodies: {mass: 1, diameter: 1, x: [0, 0, 0], v: [0, 0, 1]}\n"
#define SPIN "bodies: {inertia: 1, alpha: [0, 0, 0], omega: [0, 0, 1]}\n"
#define RING(keys) "bodies:\n  mass: 1\n  ring: {" keys "}\n" TIME
#define CHAINED(keys) "bodies:\n  mass: 1\n  chain: {" keys "}\n" TIME
#define LATTICE(keys) "bodies:\n  mass: 1\n  lattice: {" keys "}\n" TIME
#define WALL(keys) "wall: {stiffness: 1, planes: [[1, 0, 0, 0]]" keys "}\n"
#define WALLS " for 1 walls; give one for each plane, then for each cylinder"
#define NUMBERS " is not a list of numbers; write them as in [1, 2]"
#define CHAIN "bodies: {mass: 1, chain: {count: 2, spacing: 1}}\n"

static const struct refusal refused[] = {
    /* ring */
    {RING("count: 2, diameter: 1"), "3:17: bodies.ring.count: '2' bodies make no ring; give at least 3"},
    {RING("count: 0, diameter: 1"), "3:17: bodies.ring.count: '0' is not positive; the number of bodies must be > 0"},
    {RING("count: 3.5, diameter: 1"), "3:17: bodies.ring.count: '3.5'" COUNT},
    {RING("count: 2e8, diameter: 1"), "3:17: bodies.ring.count: more than 100000000 bodies; give fewer"},
    {RING("count: 1e300, diameter: 1"),
     "3:17: bodies.ring.count: '1e300' is too large; give a whole number up to 2^53"},
    {RING("count: 3"), "3:3: bodies.ring.diameter: missing; add 'diameter:', the diameter of the ring"},
    {RING("diameter: 3"), "3:3: bodies.ring.count: missing; add 'count:', the number of bodies"},
    {RING("count: 3, diameter: 0"),
     "3:30: bodies.ring.diameter: '0' is not positive; the diameter of the ring must be > 0"},
    {RING("count: 3, diameter: 1, radius: 1"),
     "3:33: bodies.ring.radius: unknown key 'radius'; known in bodies.ring: count, diameter, center"},
    {RING("count: 3, diameter: 1, center: [0, 0, inf]"), "3:48: bodies.ring.center[2]: 'inf'" NUMBER},
    {"bodies:\n  mass: 1\n  ring: 80\n" TIME, "3:9: bodies.ring: '80' is not a section; write its keys, each on a "
                                              "line of its own: count, diameter, center"},
    {"bodies: {mass: 1, ring: {count: 3, diameter: 1}, x: [0, 0, 0]}\n" TIME,
     "1:19: bodies.ring: given besides bodies.x" ONE_OF},

    /* chain and lattice */
    {CHAINED("count: 3, spacing: 0"),
     "3:30: bodies.chain.spacing: '0' is not positive; the distance of neighbours must be > 0"},
    {CHAINED("count: 3, spacing: 1, direction: [0, 0, 0]"),
     "3:44: bodies.chain.direction: '[0, 0, 0]' has no length; the direction of the chain must not be zero"},
    {LATTICE("counts: [4, 0, 4], spacing: 1"),
     "3:25: bodies.lattice.counts[1]: '0' is not positive; the bodies along x, y, z must be > 0"},
    {LATTICE("counts: [4, 4, 1/3], spacing: 1"), "3:28: bodies.lattice.counts[2]: '1/3'" COUNT},
    {LATTICE("counts: [4, 4], spacing: 1"),
     "3:21: bodies.lattice.counts: 2 values in a list of three whole numbers; write them as in [4, 4, 4]"},
    {LATTICE("counts: 64, spacing: 1"),
     "3:21: bodies.lattice.counts: '64' is not a list of three whole numbers; write them as in [4, 4, 4]"},
    {LATTICE("counts: [4, [4], 4], spacing: 1"), "3:25: bodies.lattice.counts[1]: a list of 1" COUNT},
    {LATTICE("counts: [2^53, 2^53, 2^53], spacing: 1"),
     "3:21: bodies.lattice.counts: more than 100000000 bodies; give fewer"},

    /* all bodies */
    {"bodies: {mass: 1, chain: {count: 2, spacing: 1}, omega: [0, 0, 1], diameter: -1}\n" TIME,
     "1:78: bodies.diameter: '-1' is not positive; the diameter D must be > 0"},
    {"bodies: {inertia: 1, omega: [0, 0, 1], alpha: [0, 0, 0], random: {seed: 1}}\n" TIME,
     "1:58: bodies.random: none of v, omega and alpha; give one of them or more"},
    {"bodies: {inertia: 1, omega: [0, 0, 1], alpha: [0, 0, 0], random: {seed: 1, v: 1}}\n" TIME,
     "1:79: bodies.random.v: nothing translates; give " POSITIONS},
    {"bodies: {mass: 1, chain: {count: 2, spacing: 1}, random: {v: 1}}\n" TIME,
     "1:50: bodies.random.seed: missing; add 'seed:', the seed"},
    {"bodies: {mass: 1, chain: {count: 2, spacing: 1}, random: {seed: -1, v: 1}}\n" TIME,
     "1:65: bodies.random.seed: '-1' is negative; the seed must be >= 0"},
    {"bodies: {mass: 1, chain: {count: 2, spacing: 1}, random: {seed: 1, v: -1}}\n" TIME,
     "1:71: bodies.random.v: '-1' is not positive; the largest component of random v must be > 0"},
    {"bodies: {table: ''}\n" TIME, "1:17: bodies.table: '' is not a path; name the file of bodies"},
    {"bodies: {x: [0, 0, 0], v: [0, 0, 0], mass: 1, table: a.csv}\n" TIME,
     "1:54: bodies.table: given besides bodies.x" ONE_OF},

    /* binder */
    {CHAIN "binder: {}\n" TIME, "2:1: binder: no stiffness; give moment, axial or shear"},
    {CHAIN "binder: {axial: 0}\n" TIME, "2:17: binder.axial: '0' is not positive; the stiffness K^a must be > 0"},
    {CHAIN "binder: {moment: -1}\n" TIME, "2:18: binder.moment: '-1' is not positive; the stiffness K^m must be > 0"},
    {CHAIN "binder: {axial: 1, bending: 3}\n" TIME, "2:20: binder.bending: unknown key 'bending'; known in binder: "
                                                    "table, on, when, most, from, until, moment, axial, shear, break"},
    {CHAIN "binder: {shear: 200}\n" TIME, "2:17: binder.shear: '200' is not a section; write its keys, each on a "
                                          "line of its own: stiffness, form"},
    {CHAIN "binder: {shear: {form: objective}}\n" TIME,
     "2:10: binder.shear.stiffness: missing; add 'stiffness:', the stiffness K^s"},
    {"bodies: {table: b.csv, mass: 1}\nbinder: {table: c.csv, axial: 1, shear: {}}\n" TIME,
     "2:34: binder.shear.stiffness: missing; add 'stiffness:', the stiffness K^s"},
    {CHAIN "binder: {shear: {stiffness: 1, form: exact}}\n" TIME,
     "2:38: binder.shear.form: 'exact' is not one of objective, quartic, printed; take one of them"},
    {"bodies: {x: [0, 0, 0], v: [0, 0, 0], mass: 1}\nbinder: {axial: 1}\n" TIME,
     "2:1: binder: a single body has no bonds; give bodies.ring, chain, lattice or table"},
    {"bodies: {table: a.csv}\nbinder: {axial: 1}\n" TIME,
     "2:1: binder: bodies of a table have no neighbours; give table, a file of bonds"},

    /* binder.break */
    {CHAIN "binder: {axial: 1, most: 3}\n" TIME, "2:26: binder.most: all bonds are made at t = 0; give when: touching"},
    {CHAIN "binder: {axial: 1, from: 3}\n" TIME, "2:26: binder.from: all bonds are made at t = 0; give when: touching"},
    {CHAIN "binder: {axial: 1, until: 3}\n" TIME,
     "2:27: binder.until: all bonds are made at t = 0; give when: touching"},
    {CHAIN "contact: {stiffness: 1, bonded: yes}\nbinder: {axial: 1, when: touching, from: 3, until: 3}\n" TIME,
     "3:52: binder.until: is not later than from, 3; give a later time"},
    {CHAIN "binder: {axial: 1, when: touching}\n" TIME,
     "2:26: binder.when: bonds that are made where bodies touch need their contact; give contact"},
    {CHAIN "binder: {axial: 1, when: touching}\ncontact: {stiffness: 1}\n" TIME,
     "2:26: binder.when: bonds that are made where bodies touch need their contact; give contact.bonded: yes"},
    {CHAIN "binder: {axial: 1, when: touching, table: b.csv}\ncontact: {stiffness: 1, bonded: yes}\n" TIME,
     "2:43: binder.table: bonds that are made where bodies touch are in no table; remove it"},
    {CHAIN
     "binder: {when: touching, shear: {stiffness: 1, form: printed}}\ncontact: {stiffness: 1, bonded: yes}\n" TIME,
     "2:54: binder.shear.form: the printed shear knows bonds of t = 0 only; give objective or quartic"},
    {CHAIN "binder: {when: touching}\ncontact: {stiffness: 1, bonded: yes}\n" TIME,
     "2:1: binder: no stiffness; give moment, axial or shear"},
    {CHAIN "binder: {axial: 1, break: {}}\n" TIME,
     "2:20: binder.break: no limit; give stretch, normal, shear, bending, torsion or energy"},
    {CHAIN "binder: {axial: 1, break: {stretch: 0}}\n" TIME,
     "2:37: binder.break.stretch: '0' is not positive; the limit of stretch must be > 0"},
    {CHAIN "binder: {axial: 1, break: {stretch: 1, torsion: 2}}\n" TIME,
     "2:49: binder.break.torsion: bonds have no stiffness that could reach it; give binder.moment"},
    {CHAIN "binder: {axial: 1, break: {shear: 2}}\n" TIME,
     "2:35: binder.break.shear: bonds have no stiffness that could reach it; give binder.shear"},
    {CHAIN "binder: {moment: 1, break: {normal: 2}}\n" TIME,
     "2:37: binder.break.normal: bonds have no stiffness that could reach it; give binder.axial"},

    {CHAIN "binder: {axial: 1, table: t.csv, on: spheres}\n" TIME,
     "2:38: binder.on: there are no clumps; give bodies.clumps, or leave it out"},
    {"bodies: {clumps: {spheres: [[0, 0, 0, 1]]}, chain: {count: 2, spacing: 1}, mass: 1}\n"
     "binder: {axial: 1, on: spheres}\n" TIME,
     "2:24: binder.on: spheres have no neighbours; give table, a file of their bonds"},
    {"bodies: {clumps: {spheres: [[0, 0, 0, 1]]}, chain: {count: 2, spacing: 1}, mass: 1}\n"
     "binder: {table: t.csv, shear: {stiffness: 1, form: printed}, on: spheres}\n" TIME,
     "2:52: binder.shear.form: the printed shear knows bonds of bodies only; give objective or quartic"},
    /* drag */
    {CHAIN "drag: {}\n" TIME, "2:1: drag: no coefficient; give linear, quadratic or angular, viscosity or density"},
    {CHAIN "drag: {linear: -1}\n" TIME, "2:16: drag.linear: '-1' is negative; the coefficient c must be >= 0"},
    {SPIN "drag: {quadratic: 1}\n" TIME,
     "2:19: drag.quadratic: acts on bodies that translate; give bodies.x or an arrangement of them"},
    {POINT "drag: {angular: 1}\n" TIME, "2:17: drag.angular: acts on bodies that turn; give bodies.omega"},
    {CHAIN "drag: {viscosity: 1, angular: 1}\n" TIME,
     "2:31: drag.angular: given besides drag.viscosity, which says it; keep one of them"},
    {CHAIN "drag: {quadratic: 1, density: 1}\n" TIME,
     "2:19: drag.quadratic: given besides drag.density, which says it; keep one of them"},
    {CHAIN "drag: {linear: 1, coefficient: 1}\n" TIME,
     "2:32: drag.coefficient: given without drag.density; give that too"},
    {SPIN "drag: {viscosity: 1}\n" TIME,
     "2:19: drag.viscosity: acts on bodies that translate; give bodies.x or an arrangement of them"},
    {"bodies: {mass: 1, x: [0, 0, 0], v: [0, 0, 1]}\ndrag: {density: 1}\n" TIME,
     "2:17: drag.density: acts by the diameter; give bodies.diameter"},
    {"bodies: {clumps: {spheres: [[0, 0, 0, 1]]}, mass: 1, x: [0, 0, 0], v: [0, 0, 0]}\ndrag: {density: 1}\n" TIME,
     "2:17: drag.density: acts by diameters, which spheres of clumps have; give on: spheres"},
    {CHAIN "drag: {linear: 1, on: spheres}\n" TIME,
     "2:23: drag.on: there are no clumps; give bodies.clumps, or leave it out"},
    {CHAIN "drag: {angular: 1, medium: [1, 0, 0]}\n" TIME,
     "2:28: drag.medium: nothing is drawn along with it; give linear, quadratic, viscosity or density"},
    {CHAIN "drag: {linear: 1, on: air}\n" TIME, "2:23: drag.on: 'air' is not one of bodies, spheres; take one of them"},

    /* friction */
    {CHAIN "friction: {sliding: 1, poisson: 0.3}\n" TIME, "2:1: friction: nothing touches; give contact or wall"},
    {CHAIN "contact: {stiffness: 1}\nfriction: {poisson: 0.3}\n" TIME,
     "3:1: friction: no coefficient above 0; give sliding, rolling or twisting"},
    {CHAIN "contact: {stiffness: 1}\nfriction: {sliding: 1}\n" TIME,
     "3:21: friction.sliding: has no stiffness; give friction.stiffness or friction.poisson"},
    {CHAIN "contact: {stiffness: 1}\nfriction: {sliding: 1, stiffness: 1, poisson: 0.3}\n" TIME,
     "3:47: friction.poisson: given with friction.stiffness; keep one of them"},
    {CHAIN "contact: {stiffness: 1}\nfriction: {sliding: 1, poisson: 0.7}\n" TIME,
     "3:33: friction.poisson: '0.7' is above 0.5; no material has that"},
    {CHAIN "contact: {stiffness: 1}\nfriction: {sliding: 0, rolling: 1, rolling_stiffness: 1}\ndashpot: {ratio: 1, "
           "zeta: 1}\n" TIME,
     "3:21: friction.sliding: is 0, which sets dashpot.ratio no limit; leave that out, or give a limit above 0"},
    {CHAIN "contact: {stiffness: 1}\nfriction: {sliding: 1, poisson: 0, twisting: 0}\ndashpot: {twisting: 1}\n" TIME,
     "3:46: friction.twisting: is 0, which sets dashpot.twisting no limit; leave that out, or give a limit above 0"},
    {CHAIN "contact: {stiffness: 1}\nfriction: {rolling: 1}\n" TIME,
     "3:21: friction.rolling: has no stiffness; give friction.rolling_stiffness"},
    {CHAIN "contact: {stiffness: 1}\nfriction: {sliding: 1, poisson: 0.3, rolling_stiffness: 1}\n" TIME,
     "3:57: friction.rolling_stiffness: has no limit, and would do nothing; give friction.rolling, or leave it out"},
    {CHAIN "contact: {stiffness: 1}\nfriction: {sliding: 1, poisson: 0.3, twisting_stiffness: 1}\n" TIME,
     "3:58: friction.twisting_stiffness: has no limit, and would do nothing; give friction.twisting, or leave it out"},
    {CHAIN "contact: {stiffness: 1}\nfriction: {stiffness: 9, rolling: 1, rolling_stiffness: 1}\n" TIME,
     "3:23: friction.stiffness: has no limit, and would do nothing; give friction.sliding, or leave it out"},
    {CHAIN "contact: {stiffness: 1}\nfriction: {poisson: 0.3, rolling: 1, rolling_stiffness: 1}\n" TIME,
     "3:21: friction.poisson: has no limit, and would do nothing; give friction.sliding, or leave it out"},
    {CHAIN WALL("") "friction: {sliding: 1, poisson: 0.3, wall_sliding: rough}\n" TIME,
     "3:52: friction.wall_sliding: 'rough'" NUMBERS},
    {CHAIN WALL("") "friction: {sliding: 1, poisson: 0.3, wall_sliding: [-0.5]}\n" TIME,
     "3:53: friction.wall_sliding[0]: '-0.5' is negative; the coefficient mu of each wall must be >= 0"},
    {CHAIN WALL("") "friction: {rolling: 1, rolling_stiffness: 1, wall_sliding: [0.5]}\n" TIME,
     "3:60: friction.wall_sliding: needs friction.sliding, that of bodies; give one above 0, as small as you like"},

    /* bond_dashpot */
    {CHAIN "contact: {stiffness: 1}\nbond_dashpot: {zeta: 1}\n" TIME,
     "3:1: bond_dashpot: there are no bonds; give binder"},
    {CHAIN "binder: {axial: 1}\nbond_dashpot: {zeta: 0}\n" TIME,
     "3:1: bond_dashpot: no coefficient above 0; give zeta"},

    /* dashpot */
    {CHAIN "dashpot: {zeta: 1}\n" TIME, "2:1: dashpot: nothing touches; give contact or wall"},
    {CHAIN "contact: {stiffness: 1}\ndashpot: {}\n" TIME,
     "3:1: dashpot: no coefficient above 0; give restitution, zeta or normal"},
    {CHAIN "contact: {stiffness: 1}\ndashpot: {ratio: 0.5, normal: 0}\n" TIME,
     "3:1: dashpot: no coefficient above 0; give restitution, zeta or normal"},
    {CHAIN "contact: {stiffness: 1}\ndashpot: {ratio: 0.5, tangential: 1}\n" TIME,
     "3:18: dashpot.ratio: there is no normal coefficient that it could be a share of; give restitution, zeta or "
     "normal, or leave it out"},
    {CHAIN "contact: {stiffness: 1}\ndashpot: {tangential: 1, pull: yes}\n" TIME,
     "3:32: dashpot.pull: there is no normal coefficient that could pull; give restitution, zeta or normal, or leave "
     "it "
     "out"},
    {CHAIN "contact: {stiffness: 1}\ndashpot: {zeta: 1, restitution: 0.5}\n" TIME,
     "3:33: dashpot.restitution: given with dashpot.zeta; keep one of them"},
    {CHAIN "contact: {stiffness: 1}\ndashpot: {restitution: 1.5}\n" TIME,
     "3:24: dashpot.restitution: '1.5' is above 1; give a share of the velocity"},
    {CHAIN "contact: {stiffness: 1}\ndashpot: {restitution: 1e-9}\n" TIME,
     "3:24: dashpot.restitution: '1e-9' is below 1e-6; give zeta, 1 or more"},
    {CHAIN WALL("") "dashpot: {restitution: 0.5, wall_restitution: half}\n" TIME,
     "3:47: dashpot.wall_restitution: 'half'" NUMBERS},
    {CHAIN WALL("") "dashpot: {restitution: 0.5, wall_restitution: [0]}\n" TIME,
     "3:48: dashpot.wall_restitution[0]: '0' is not positive; the restitution e of each wall must be > 0"},
    {CHAIN WALL("") "dashpot: {restitution: 0.5, wall_restitution: [1.5]}\n" TIME,
     "3:47: dashpot.wall_restitution: 1.5 is not from 1e-6 to 1; give shares of the velocity"},

    /* contact, wall, gravity, pendulum */
    {CHAIN "contact: {}\n" TIME,
     "2:1: contact: no stiffness; give contact.stiffness, or contact.young and contact.poisson"},
    {CHAIN "contact: {young: 70e9}\n" TIME,
     "2:1: contact: no stiffness; give contact.stiffness, or contact.young and contact.poisson"},
    {CHAIN "contact: {poisson: 0.2}\n" TIME,
     "2:1: contact: no stiffness; give contact.stiffness, or contact.young and contact.poisson"},
    {CHAIN "contact: {stiffness: 1, young: 70e9, poisson: 0.2}\n" TIME,
     "2:32: contact.young: given with contact.stiffness; keep one of them"},
    {CHAIN "contact: {stiffness: 1, poisson: 0.2}\n" TIME,
     "2:34: contact.poisson: given with contact.stiffness; keep one of them"},
    {CHAIN "contact: {young: 70e9, poisson: 0.6}\n" TIME,
     "2:33: contact.poisson: '0.6' is above 0.5; no material has that"},
    {CHAIN "contact: {young: 0, poisson: 0.2}\n" TIME,
     "2:18: contact.young: '0' is not positive; the Young's modulus E must be > 0"},
    {CHAIN "contact: {stiffness: 0}\n" TIME,
     "2:22: contact.stiffness: '0' is not positive; the stiffness K^pp must be > 0"},
    {CHAIN "contact: {stiffness: 1, bonded: maybe}\n" TIME,
     "2:33: contact.bonded: 'maybe' is not one of yes, no; take one of them"},
    {SPIN "contact: {stiffness: 1}\n" TIME, "2:1: contact: acts on bodies that translate; give " POSITIONS},
    {"bodies: {mass: 1, x: [0, 0, 0], v: [0, 0, 1]}\ncontact: {stiffness: 1}\n" TIME,
     "1:1: bodies.diameter: missing; spheres in contact need it, the diameter D"},
    {"bodies: {mass: 1, x: [0, 0, 0], v: [0, 0, 1]}\nwall: {stiffness: 1, planes: [[1, 0, 0, 0]]}\n" TIME,
     "1:1: bodies.diameter: missing; spheres in contact need it, the diameter D"},
    {POINT "wall: {planes: [[1, 0, 0, 0]]}\n" TIME,
     "2:1: wall.stiffness: missing; add 'stiffness:', the stiffness K^pw"},
    {POINT "wall: {stiffness: 1, planes: [[0, 0, 1, 0], [1, 0, 0, 0], [0, 0, 2, 0]]}\n" TIME,
     "2:30: wall.planes: row [2] is there a second time, first by row [0]; keep one"},
    {POINT "wall: {stiffness: 1, planes: [[3, 1, 7, 4], [0, 1, 0, 0], [9, 3, 21, 12]]}\n" TIME,
     "2:30: wall.planes: row [2] is there a second time, first by row [0]; keep one"},
    {POINT "wall: {stiffness: 1, planes: [[0, 0, 1, 0]], velocities: [[0, 0, 1], [1, 0, 0], [1, 0, 0]], "
           "cylinders: [[0, 0, 1, 1, 2, 3, 4], [0, 0, -2, 1, 2, 8, 4]]}\n" TIME,
     "2:104: wall.cylinders: row [1] is there a second time, first by row [0]; keep one"},
    {POINT "wall: {stiffness: 1, planes: [[0, 0, 1e-320, 1]]}\n" TIME,
     "2:32: wall.planes[0]: '[0, 0, 1e-320, 1]' has no unit normal; its first three numbers are zero, too small or too "
     "large"},
    {POINT "turning: 0\n" TIME, "2:10: turning: '0' is not positive; the angular velocity of the scene must be > 0"},
    {POINT "wall: {stiffness: 1}\n" TIME, "2:1: wall.planes: no planes; give a list of them, such as [[1, 0, 0, 0]]"},
    {POINT "wall: {stiffness: 1, planes: []}\n" TIME,
     "2:30: wall.planes: no planes; give a list of them, such as [[1, 0, 0, 0]]"},
    {POINT "wall: {stiffness: 1, planes: floor}\n" TIME,
     "2:30: wall.planes: 'floor' is not a list of planes; write them as in [[1, 0, 0, 0], [0, 1, 0, 0]]"},
    {POINT "wall: {stiffness: 1, planes: [1, 0, 0, 0]}\n" TIME,
     "2:31: wall.planes[0]: '1' is not a list of four numbers nx, ny, nz, d; write them as in [1, 0, 0, 0]"},
    {POINT "wall:\n  stiffness: 1\n  planes: [[1, 0, 0, 0], [0, 0, 1]]\n" TIME,
     "4:26: wall.planes[1]: 3 values in a list of four numbers nx, ny, nz, d; write them as in [1, 0, 0, 0]"},
    {POINT "wall:\n  stiffness: 1\n  planes:\n  - [1, 0, 0, 0]\n  - [0, up, 1, 0]\n" TIME,
     "6:9: wall.planes[1][1]: 'up'" NUMBER},
    {POINT "wall:\n  stiffness: 1\n  planes: [[0, 0, 0, 1]]\n" TIME,
     "4:13: wall.planes[0]: '[0, 0, 0, 1]' has no unit normal; its first three numbers are zero, too small or too "
     "large"},
    {POINT "wall:\n  stiffness: 1\n  planes: [[1.7e308, 1.7e308, 0, 0]]\n" TIME,
     "4:13: wall.planes[0]: '[1.7e308, 1.7e308, 0, 0]' has no unit normal; its first three numbers are zero, too small "
     "or too "
     "large"},
    {POINT WALL(", young: 1") TIME, "2:53: wall.young: given with wall.stiffness; keep one of them"},
    {POINT WALL(", poisson: 0") TIME, "2:55: wall.poisson: given with wall.stiffness; keep one of them"},
    {POINT "wall: {stiffnesses: [1], young: 1, planes: [[1, 0, 0, 0]]}\n" TIME,
     "2:33: wall.young: given with wall.stiffnesses; keep one of them"},
    {POINT "wall: {young: 1, planes: [[1, 0, 0, 0]]}\n" TIME, "2:15: wall.young: needs wall.poisson; give both"},
    {POINT "wall: {poisson: 0, planes: [[1, 0, 0, 0]]}\n" TIME, "2:17: wall.poisson: needs wall.young; give both"},
    {POINT "wall: {young: 1, poisson: 0.6, planes: [[1, 0, 0, 0]]}\n" TIME,
     "2:27: wall.poisson: '0.6' is above 0.5; no material has that"},
    {POINT WALL(", stiffnesses: [1]") TIME, "2:59: wall.stiffnesses: given with wall.stiffness; keep one of them"},
    {POINT "wall: {stiffnesses: [1, 2], planes: [[1, 0, 0, 0]]}\n" TIME, "2:21: wall.stiffnesses: 2 rows" WALLS},
    {POINT "wall: {stiffnesses: [0], planes: [[1, 0, 0, 0]]}\n" TIME,
     "2:22: wall.stiffnesses[0]: '0' is not positive; the stiffness K^pw of each wall must be > 0"},
    {POINT "wall: {stiffnesses: 3, planes: [[1, 0, 0, 0]]}\n" TIME, "2:21: wall.stiffnesses: '3'" NUMBERS},
    {POINT "wall: {stiffnesses: [soft], planes: [[1, 0, 0, 0]]}\n" TIME, "2:22: wall.stiffnesses[0]: 'soft'" NUMBER},
    {POINT WALL(", cylinders: drum") TIME,
     "2:57: wall.cylinders: 'drum' is not a list of cylinders; write them as in [[0, 1, 0, 0, 0, 0, 5]]"},
    {POINT WALL(", cylinders: [[0, 1, 0, 0, 0, 0]]") TIME,
     "2:58: wall.cylinders[0]: 6 values in a list of seven numbers ax, ay, az, x, y, z, R; write them as in "
     "[0, 1, 0, 0, 0, 0, 5]"},
    {POINT WALL(", cylinders: [[0, 0, 0, 0, 0, 0, 1]]") TIME,
     "2:59: wall.cylinders[0]: '[0, 0, 0, ...]' has no axis; its first three numbers are zero, too small or too large"},
    {POINT WALL(", cylinders: [[0, 1, 0, 0, 0, 0, -1]]") TIME,
     "2:77: wall.cylinders[0]: the radius '-1' is not positive; the seventh number must be > 0"},
    {POINT WALL(", cylinders: [[0, 1, 0, 0, 0, 0, nan]]") TIME, "2:77: wall.cylinders[0][6]: 'nan'" NUMBER},
    {POINT WALL(", velocities: [[0, 0, 1], [0, 0, 0]]") TIME, "2:58: wall.velocities: 2 rows" WALLS},
    {POINT WALL(", velocities: []") TIME, "2:58: wall.velocities: 0 rows" WALLS},
    {POINT WALL(", velocities: [0, 0, 1]") TIME,
     "2:59: wall.velocities[0]: '0' is not a list of three numbers; write them as in [0, 0, 1]"},
    {POINT WALL(", velocities: [[0, 0, up]]") TIME, "2:66: wall.velocities[0][2]: 'up'" NUMBER},
    {POINT WALL(", spins: [1, 2]") TIME, "2:53: wall.spins: 2 rows" WALLS},
    {POINT WALL(", spins: fast") TIME, "2:53: wall.spins: 'fast'" NUMBERS},
    {POINT WALL(", spins: [inf]") TIME, "2:54: wall.spins[0]: 'inf'" NUMBER},
    {SPIN "wall: {stiffness: 1, planes: [[1, 0, 0, 0]]}\n" TIME,
     "2:1: wall: acts on bodies that translate; give " POSITIONS},
    {SPIN "gravity: [0, 0, -1]\n" TIME, "2:10: gravity: acts on bodies that translate; give " POSITIONS},
    {POINT "gravity: -9.81\n" TIME,
     "2:10: gravity: '-9.81' is not a list of three numbers; write them as in [0, 0, 1]"},
    {CHAIN "pendulum: {weight: 1, rho0: [0, 0, 1]}\n" TIME,
     "2:1: pendulum: hangs bodies on fixed pivots, where they turn and cannot translate; remove it or "
     "bodies.chain"},
    {"bodies: {mass: 1}\npendulum: {weight: 1, rho0: [0, 0, 1]}\n" TIME,
     "1:1: bodies.inertia: missing; bodies that turn need it, the moment of inertia J"},
};

TEST(refusals)
{
    assert_files_refused(refused, sizeof refused / sizeof refused[0]);
}

static const struct refusal overrides[] = {
    {"binder.shear.form=wrong", "binder.shear.form: 'wrong' is not one of objective, "
                                "quartic, printed; take one of them"},
    {"binder.shear=3", "binder.shear: a section is not set as a whole; set one of its keys: stiffness, form"},
    {"wall.planes=[[1, 0, 0]]", "wall.planes[0]: 3 values in a list of four numbers nx, "
                                "ny, nz, d; write them as in [1, 0, 0, 0]"},
    {"wall.planes=[[0, 0, 0, 0]]", "wall.planes[0]: '[0, 0, 0, 0]' has no unit normal; "
                                   "its first three numbers are zero, too small or too large"},
};

TEST(refused_overrides)
{
    write_text("t.yaml", "bodies: {mass: 1, chain: {count: 2, spacing: 1}}\nbinder: {axial: 1}\n"
                         "wall: {stiffness: 1, planes: [[0, 0, 1, 0]]}\n" TIME);
    assert_sets_refused(overrides, sizeof overrides / sizeof overrides[0]);
}

/** More planes than a scene holds. */
TEST(too_many_planes)
{
    enum { SIZE = 16 * 1024 };
    char *text = malloc(SIZE);
    struct scene scene;
    struct message message;
    assert_non_null(text);
    snprintf(text, SIZE, "%s", POINT TIME "wall:\n  stiffness: 1\n  planes:\n");
    for (int k = 0; k < SCENE_PLANES_MAX + 1; ++k)
        quote_append(text, SIZE, "  - [1, 0, 0, 0]\n");
    write_text("t.yaml", text);
    free(text);
    assert_refused("257 planes", scene_read("t.yaml", NULL, 0, &scene, &message), &message,
                   "t.yaml:7:3: wall.planes: 257 planes; give at most 256");
}

/** A path that is absolute stays, any other starts at the folder of the scene; too long ones are refused. */
TEST(paths_of_tables)
{
    static const struct {
        const char *set, *path;
    } read[] = {
        {"bodies.table=b.csv", "./b.csv"}, {"bodies.table=../b.csv", "./../b.csv"}, {"bodies.table=/b.csv", "/b.csv"}};
    char set[600] = "bodies.table=";
    const char *sets[] = {set};
    struct scene scene;
    struct message message;
    write_text("t.yaml", "bodies: {table: a.csv}\n" TIME);
    for (size_t k = 0; k < sizeof read / sizeof read[0]; ++k) {
        assert_int_equal(scene_read("./t.yaml", &read[k].set, 1, &scene, &message), 0);
        assert_string_equal(scene.table, read[k].path);
    }
    assert_int_equal(scene_read("t.yaml", NULL, 0, &scene, &message), 0);
    assert_string_equal(scene.table, "a.csv");
    memset(set + strlen(set), 'a', SCENE_PATH_SIZE - 1);
    assert_int_equal(scene_read("t.yaml", sets, 1, &scene, &message), 0);
    assert_int_equal(strlen(scene.table), SCENE_PATH_SIZE - 1);
    assert_int_equal(scene_read("./t.yaml", sets, 1, &scene, &message), -1);
    assert_one_line(&message);
    assert_non_null(strstr(message.text, "aaa...' is too long; keep folder and name below 512 letters"));
}

RUN_TESTS_IN_FOLDER(cmocka_unit_test(refusals), cmocka_unit_test(refused_overrides), cmocka_unit_test(too_many_planes),
                    cmocka_unit_test(paths_of_tables))
