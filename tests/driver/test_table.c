/* SPDX-License-Identifier: BSD-3-Clause
 * Tables of bodies and bonds as CSV: what is read, and the one line that each fault gets. */
#define _POSIX_C_SOURCE 200809L
#include "model_support.h"

#include "binder.h"
#include "tables.h"
#include "table_csv.h"

#define HOLD " is too small or too large to hold; give a number from 5e-324 to 1.79e308 in size, or 0"
#define NUMBER " is not a number; write 0.01, 1e-3, 1/64 or 2^-6"
#define BODY_NAMES                                                                                                     \
    "x, y, z, vx, vy, vz, alpha_x, alpha_y, alpha_z, omega_x, omega_y, omega_z, moment_a, moment_b, moment_c, "        \
    "principal_x, principal_y, principal_z, mass, inertia, diameter, young, poisson, clump"
#define BOND_NAMES                                                                                                     \
    "i, j, moment, axial, shear, break_stretch, break_normal, break_shear, break_bending, break_torsion, "             \
    "break_energy, "                                                                                                   \
    "length, nx, ny, nz, turn_x, turn_y, turn_z, turn_w"

TEST(reads)
{
    static const char *const texts[] = {
        "x,y,z,mass,omega_x,omega_y,omega_z\n1,2,3,4,5,6,7\n-1,1/2,3e0,2^-6,0,0,1\n",
        "\xef\xbb\xbfx, y ,\tz\t,mass, \tomega_x\t ,omega_y,omega_z\t\r\n 1 ,2,3,4,5,6,7\r\n-1,.5,3.0,0.015625,0,0,1",
        "omega_z,mass,x,z,y,omega_y,omega_x\n7,4,1,3,2,6,5\n1,1/64,-1,3,0.5,0,0\n"};
    struct table t;
    struct message message;
    for (int k = 0; k < 3; ++k) {
        write_text("b.csv", texts[k]);
        if (table_csv_read("b.csv", &table_bodies, &t, &message) != 0)
            fail_msg("%s", message.text);
        assert_int_equal(t.rows, 2);
        assert_true(t.column[BODY_X][0] == 1.0 && t.column[BODY_X + 1][1] == 0.5 && t.column[BODY_X + 2][1] == 3.0);
        assert_true(t.column[BODY_MASS][0] == 4.0 && t.column[BODY_MASS][1] == 0.015625);
        assert_true(t.column[BODY_OMEGA][0] == 5.0 && t.column[BODY_OMEGA + 2][1] == 1.0);
        assert_false(table_has(&t, BODY_V) || table_has(&t, BODY_DIAMETER));
        table_destroy(&t);
    }
}

TEST(reads_many_rows)
{
    enum { ROWS = 100000 };
    struct table t;
    struct message message;
    FILE *file = fopen("b.csv", "wb");
    assert_non_null(file);
    fprintf(file, "i,j,axial\n");
    for (int k = 0; k < ROWS; ++k)
        fprintf(file, "%d,%d,%.17g\n", k, k + 1, 1.0 / (k + 1));
    assert_int_equal(fclose(file), 0);
    assert_int_equal(table_csv_read("b.csv", &binder_table, &t, &message), 0);
    assert_int_equal(t.rows, ROWS);
    for (int k = 0; k < ROWS; ++k)
        assert_true(t.column[BOND_I][k] == k && t.column[BOND_J][k] == k + 1 &&
                    t.column[BOND_AXIAL][k] == 1.0 / (k + 1));
    table_destroy(&t);
}

/* ---- files that are refused -------------------------------------------------------------------------------------- */

static const struct {
    const struct table_kind *kind;
    const char *text, *line;
} refused[] = {
    {&table_bodies, "", "b.csv: an empty file; give a line of names and a row a line"},
    {&table_bodies, "\n", "b.csv:1:1: unknown column ''; known are " BODY_NAMES},
    {&table_bodies, "x,y,z\n", "b.csv:1: no bodies; give a row for each"},
    {&table_bodies, "x,y,z\r0,0,0\r1,0,0\r",
     "b.csv:1:6: a line that ends with a carriage return alone; let lines end with newlines (tr '\\r' '\\n')"},
    {&table_bodies, "x,y,z\r\n0,0,0\r1,0,0\n",
     "b.csv:2:6: a line that ends with a carriage return alone; let lines end with newlines (tr '\\r' '\\n')"},
    {&table_bodies, "x,y,zz\n0,0,0\n", "b.csv:1:5: unknown column 'zz'; known are " BODY_NAMES},
    {&table_bodies, "x,y,z,\n0,0,0,\n", "b.csv:1:7: unknown column ''; known are " BODY_NAMES},
    {&binder_table, "i,j,k\n0,1,2\n", "b.csv:1:5: unknown column 'k'; known are " BOND_NAMES},
    {&table_bodies, "x,y, x\n0,0,0\n", "b.csv:1:6: x: a second time; keep one of the columns"},
    {&table_bodies, "x,z\n0,0\n", "b.csv:1: no column y; give x, y and z or none of them"},
    {&table_bodies, "x,y,z,vx\n0,0,0,0\n", "b.csv:1: no column vy; give vx, vy and vz or none of them"},
    {&table_bodies, "vx,vy,vz\n0,0,0\n", "b.csv:1: no columns x, y, z; bodies with vx, vy, vz need them"},
    {&binder_table, "i,axial\n0,1\n", "b.csv:1: no column j; bonds need i and j"},
    {&binder_table, "j,axial\n1,1\n", "b.csv:1: no column i; bonds need i and j"},
    {&table_bodies, "x,y,z\n0,0,0\n0,0,0,0\n",
     "b.csv:3: 4 values in a row of 3 columns; give one for each name in line 1"},
    {&table_bodies, "x,y,z\n0;0;0\n", "b.csv:2: 1 value in a row of 3 columns; give one for each name in line 1"},
    {&table_bodies, "\xef\xbb\xbfx;y;z\r\n0,5;0;0\r\n",
     "b.csv:1:4: columns are parted by ';'; let commas part them, and points stand in numbers"},
    {&table_bodies, "x\ty\tz\n0\t0\t0\n",
     "b.csv:1:1: columns are parted by tabs; let commas part them, and points stand in numbers"},
    {&table_bodies, "x,\"y\",z\n0,0,0\n", "b.csv:1:3: a name in quotation marks; write names and numbers without any"},
    {&table_bodies, "x,y,z\n0,0,0\n \n", "b.csv:3: an empty line; remove it"},
    {&table_bodies, "x,y,z\n0,1e-400,0\n", "b.csv:2:3: y: '1e-400'" HOLD},
    {&table_bodies, "x,y,z\n0,1/1e-308/2,0\n", "b.csv:2:3: y: '1/1e-308/2'" NUMBER},
    {&table_bodies, "x,y,z\n0,1e999^2,0\n", "b.csv:2:3: y: '1e999^2'" HOLD},
    {&table_bodies, "x,y,z\n0,1e-400x,0\n", "b.csv:2:3: y: '1e-400x'" NUMBER},
    {&table_bodies, "x,y,z\n0,,0\n", "b.csv:2:3: y: ''" NUMBER},
    {&table_bodies, "x,y,z\n0,0,0\n0, nan,0\n", "b.csv:3:4: y: 'nan'" NUMBER},
    {&table_bodies, "x,y,z,mass\n0,0,0,1\n0,0,0,-1\n", "b.csv:3:7: mass: '-1' is not positive; it must be > 0"},
    {&table_bodies, "inertia\n0\n", "b.csv:2:1: inertia: '0' is not positive; it must be > 0"},
    {&table_bodies, "diameter\n-0\n", "b.csv:2:1: diameter: '-0' is not positive; it must be > 0"},
    {&binder_table, "i,j\n-1,0\n", "b.csv:2:1: i: '-1' is not a body; bodies are counted 0, 1, 2 and so on"},
    {&binder_table, "i,j\n0,1.5\n", "b.csv:2:3: j: '1.5' is not a body; bodies are counted 0, 1, 2 and so on"},
    {&binder_table, "i,j\n0,1e300\n", "b.csv:2:3: j: '1e300' is not a body; bodies are counted 0, 1, 2 and so on"},
    {&binder_table, "i,j,axial\n0,1,-1\n", "b.csv:2:5: axial: '-1' is negative; it must be >= 0"},
    {&binder_table, "i,j,shear\n0,1,NaN\n", "b.csv:2:5: shear: 'NaN'" NUMBER},
};

TEST(refusals)
{
    for (size_t k = 0; k < sizeof refused / sizeof refused[0]; ++k) {
        struct table t;
        struct message message;
        write_text("b.csv", refused[k].text);
        assert_refused(refused[k].text, table_csv_read("b.csv", refused[k].kind, &t, &message), &message,
                       refused[k].line);
        assert_int_equal(t.rows, 0); /* destroyed */
    }
}

TEST(what_is_no_file)
{
    struct table t;
    struct message message;
    assert_refused("missing", table_csv_read("none.csv", &table_bodies, &t, &message), &message,
                   "none.csv: cannot be read: No such file or directory; give the path of a table");
    assert_refused("directory", table_csv_read(".", &table_bodies, &t, &message), &message,
                   ".: cannot be read: Is a directory; give the path of a table");
    write_bytes("b.csv", "x,y,z\n0,0,\0000\n", 14);
    assert_refused("a byte 0", table_csv_read("b.csv", &table_bodies, &t, &message), &message,
                   "b.csv:2:5: a byte 0; give a text file");
}

/* ---- tables that do not go with their scene ---------------------------------------------------------------------- */

#define BODIES "bodies: {table: b.csv, mass: 1}\n"
#define BONDED BODIES "binder: {table: c.csv, axial: 1}\n"
#define THREE "x,y,z\n0,0,0\n1,0,0\n1,1,0\n"

static const struct {
    const char *scene, *bodies, *bonds, *line;
} mismatched[] = {
    {BONDED, THREE, "i,j\n0,1\n1,3\n", "c.csv:3: j: '3' is not a body; there are 3, counted from 0"},
    {BONDED, THREE, "i,j\n3,1\n1,3\n", "c.csv:2: i: '3' is not a body; there are 3, counted from 0"},
    {BONDED, THREE, "i,j\n0,1\n2,2\n", "c.csv:3: body 2 is bonded to itself; name two bodies"},
    {BONDED, THREE, "i,j\n0,1\n1,2\n1,0\n1,2\n",
     "c.csv:4: bodies 1 and 0 are bonded a second time, first by line 2; keep one"},
    {BONDED, "x,y,z\n0,0,0\n1,0,0\n1,0,0\n", "i,j\n0,1\n2,1\n",
     "c.csv:3: the centres of bodies 2 and 1 give no direction to their bond; move one of them"},
    {BONDED, "omega_x,omega_y,omega_z\n0,0,0\n", "i,j\n0,1\n", "b.csv: no columns x, y, z; binder needs them"},
    {BODIES "binder: {table: c.csv}\n", THREE, "i,j\n0,1\n",
     "c.csv: no column moment, axial or shear; bonds need one of them, or binder.moment"},
    {BODIES "binder: {table: c.csv}\n", THREE, "i,j,axial,moment\n0,1,1,0\n1,2,0,0\n",
     "c.csv:3: no stiffness; give this bond one, or leave it out"},
    {BODIES "binder: {table: c.csv, axial: 1, shear: {form: objective}}\n", THREE, "i,j\n0,1\n",
     "c.csv: no column shear, of which the scene gives binder.shear.form; give that column, or binder.shear.stiffness"},
    {BODIES "binder: {table: c.csv, shear: {form: quartic, stiffness: 2}}\n", THREE, "i,j,shear\n0,1,1\n",
     "c.csv: gives shear, which the scene gives as binder.shear too; keep one of them"},
    {BONDED, THREE, "i,j,axial\n0,1,1\n",
     "c.csv: gives axial, which the scene gives as binder.axial too; keep one of them"},
    {BODIES "binder: {table: c.csv, axial: 1, break: {stretch: 1}}\n", THREE, "i,j,break_stretch\n0,1,1\n",
     "c.csv: gives break_stretch, which the scene gives in binder.break too; keep one of them"},
    {BONDED, THREE, "i,j,break_bending\n0,1,1\n",
     "c.csv: bonds have no stiffness that could reach break_bending; give binder.moment"},
    {BONDED, THREE, "i,j,length,nx,ny,nz\n0,1,1,1,0,0\n1,2,1,0,0,0\n",
     "c.csv:3: nx, ny and nz give no direction; one of them must not be 0"},
    {BONDED, THREE, "i,j,nx,nz\n0,1,1,0\n", "c.csv:1: nx, ny and nz come together; give all three"},
    {BONDED, THREE, "i,j,turn_x,turn_w\n0,1,0,1\n",
     "c.csv:1: turn_x, turn_y, turn_z and turn_w come together; give all four"},
    {BONDED, THREE, "i,j,turn_x,turn_y,turn_z,turn_w\n0,1,0,0,0,1\n1,2,0,0,0,0\n",
     "c.csv:3: turn_x, turn_y, turn_z and turn_w are no quaternion; 0, 0, 0, 1 turns nothing"},
    {BODIES "binder: {table: c.csv, shear: {stiffness: 1, form: printed}}\n", THREE,
     "i,j,turn_x,turn_y,turn_z,turn_w\n0,1,0,0,0,1\n",
     "c.csv: the printed shear knows no turn_x, turn_y, turn_z, turn_w; give shear.form: objective"},
    {BONDED, THREE, "i,j,length\n0,1,0\n", "c.csv:2:5: length: '0' is not positive; it must be > 0"},
    {BONDED, THREE, "i,j,break_energy\n0,1,0\n", "c.csv:2:5: break_energy: '0' is not positive; it must be > 0"},
    {BONDED, THREE, "i,j,moment\n0,1,1\n", "b.csv: no column inertia; bodies that turn need it, or bodies.inertia"},
    {BODIES, "x,y,z,mass\n0,0,0,1\n", "", "b.csv: gives what the scene gives as bodies.mass too; keep one of them"},
    {"bodies: {table: b.csv, density: 1}\n", "x,y,z,mass\n0,0,0,1\n", "",
     "b.csv: gives what the scene gives as bodies.density too; keep one of them"},
    {"bodies: {table: b.csv, density: 1}\n", "x,y,z\n0,0,0\n", "",
     "b.csv: no column diameter; bodies.density needs it, or bodies.diameter"},
    {"bodies: {table: b.csv, inertia: 1, v: [0, 0, 1]}\n", "omega_x,omega_y,omega_z\n0,0,1\n", "",
     "b.csv: no columns x, y, z; bodies.v needs them"},
    {"bodies: {table: b.csv}\n", "x,y,z\n0,0,0\n", "",
     "b.csv: no column mass; bodies that translate need it, or bodies.mass"},
    {"bodies: {table: b.csv}\n", "omega_x,omega_y,omega_z,mass\n0,0,1,1\n", "",
     "b.csv: no column inertia; bodies that turn need it, or bodies.inertia"},
    {"bodies: {table: b.csv}\n", "mass\n1\n", "",
     "b.csv: nothing moves; give columns x, y, z or omega_x, omega_y, omega_z"},
    {"bodies: {table: b.csv, inertia: 1}\nrotor: 4\n", "omega_x,omega_y,omega_z\n0,0,1\n", "",
     "b.csv: no columns moment_a, moment_b, moment_c; rotor is for such bodies, as a sphere's turn is one, of any "
     "order: "
     "give them, or leave it out"},
    {BODIES "contact: {}\n", "x,y,z,diameter\n0,0,0,1\n", "",
     "b.csv: no columns young and poisson; contact needs them, or contact.stiffness, or contact.young and "
     "contact.poisson"},
    {BODIES "contact: {young: 1, poisson: 0}\n", "x,y,z,diameter,young,poisson\n0,0,0,1,1,0\n", "",
     "b.csv: gives young, which the scene gives as contact.young too; keep one of them"},
    {BODIES "contact: {}\n", "x,y,z,diameter,young\n0,0,0,1,1\n", "",
     "b.csv:1: young and poisson come together; give both"},
    {BODIES "contact: {}\n", "x,y,z,diameter,young,poisson\n0,0,0,1,1,0.3\n1,0,0,1,1,0.6\n", "",
     "b.csv:3: poisson: '0.6' is above 0.5; no material has that"},
    {BODIES "wall: {young: 1, poisson: 0, planes: [[0, 0, 1, 0]]}\n", "x,y,z,diameter\n0,0,1,1\n", "",
     "t: wall.young: bodies have no material; give contact.young and contact.poisson, or columns young and poisson of "
     "bodies.table"},
    {BODIES "contact: {stiffness: 1}\n", THREE, "", "b.csv: no column diameter; contact needs it, or bodies.diameter"},
    {"bodies: {table: b.csv, inertia: 1}\ngravity: [0, 0, 1]\n", "omega_x,omega_y,omega_z\n0,0,1\n", "",
     "b.csv: no columns x, y, z; gravity needs them"},
    {"bodies: {table: b.csv, inertia: 1, mass: 1}\npendulum: {weight: 1, rho0: [0, 0, 1]}\n", THREE, "",
     "b.csv: has columns x, y, z; a pendulum hangs bodies on fixed pivots, where they cannot translate"},
    {"bodies: {mass: 1, inertia: 1, chain: {count: 2, spacing: 1}}\nbinder: {table: c.csv}\n", "", "i,j,axial\n0,2,1\n",
     "c.csv:2: j: '2' is not a body; there are 2, counted from 0"},
    /* what is too small to divide by, whatever it follows from; mass of bodies that do not translate is not looked
     * at */
    {"bodies: {mass: 1e-320, chain: {count: 2, spacing: 1}}\n", "", "",
     "t: bodies.mass: '1e-320' is too small to divide by; choose units in which it is larger"},
    {"bodies: {table: b.csv}\n", "x,y,z,mass\n0,0,0,1\n1,0,0,1e-309\n", "",
     "b.csv:3: mass: '1e-309' is too small to divide by; choose units in which it is larger"},
    {"bodies: {density: 1e-300, diameter: 1e-9, chain: {count: 2, spacing: 1}}\n", "", "",
     "t: bodies.density: '1e-300' and the diameter 1e-09 give a mass of 0, which is too small to divide by; choose "
     "units "
     "in which it is larger"},
    {"bodies: {table: b.csv, density: 1e300}\n", "x,y,z,diameter\n0,0,0,1\n1,0,0,1e3\n", "",
     "b.csv:3: bodies.density: '1e+300' and the diameter 1000 give a mass of inf, which is too large to divide by; "
     "choose "
     "units in which it is smaller"},
    {"bodies: {mass: 1e-308, diameter: 1e-20, omega: [0, 0, 1], chain: {count: 2, spacing: 1}}\n", "", "",
     "t: bodies.inertia: the mass 1e-308 and the diameter 1e-20 give 0, which is too small to divide by; choose units "
     "in "
     "which it is larger, or give it"},
    {BODIES, "x,y,z,omega_x,omega_y,omega_z,diameter\n0,0,0,0,0,1,1\n1,0,0,0,0,1,1e-160\n", "",
     "b.csv:3: bodies.inertia: the mass 1 and the diameter 1e-160 give 1e-321, which is too small to divide by; choose "
     "units in which it is larger, or give it"},
    {"bodies: {inertia: 1e-320, alpha: [0, 0, 0], omega: [0, 0, 1]}\n", "", "",
     "t: bodies.inertia: '1e-320' is too small to divide by; choose units in which it is larger"},
    {"bodies: {table: b.csv}\n", "omega_x,omega_y,omega_z,inertia\n0,0,1,1\n0,0,1,1e-320\n", "",
     "b.csv:3: inertia: '1e-320' is too small to divide by; choose units in which it is larger"},
    {"bodies: {table: b.csv}\n", "omega_x,omega_y,omega_z,moment_a,moment_b,moment_c\n0,0,1,1,1e-320,1\n", "",
     "b.csv:2: moment_b: '1e-320' is too small to divide by; choose units in which it is larger"},
    {"bodies: {mass: 1e-300, x: [0, 0, 0], v: [0, 0, 0], clumps: {spheres: [[0, 0, 0, 1e-9], [1e-9, 0, 0, 1e-9]]}}\n",
     "", "",
     "t: bodies.clumps: spheres of the mass 1e-300 in all give a moment of inertia of 3.5e-319, which is too small to "
     "divide by; choose units in which it is larger"},
    /* what a table leaves out */
    {"bodies: {table: b.csv, inertia: 1}\ndrag: {linear: 1}\n", "omega_x,omega_y,omega_z\n0,0,1\n", "",
     "t: drag acts on bodies that translate; give columns x, y, z"},
    {BODIES "drag: {angular: 1}\n", "x,y,z\n0,0,0\n", "",
     "t: drag.angular acts on bodies that turn; give columns omega_x, omega_y, omega_z"},
    {BODIES "drag: {density: 1}\n", "x,y,z\n0,0,0\n", "",
     "t: drag.density acts by diameters; give a column diameter, or bodies.diameter"},
    {"bodies: {table: b.h5}\n", "", "", "b.h5: HDF5 tables are not read here; give a CSV file"},
    /* without a table too: so close that they fall on one number */
    {"bodies: {mass: 1, chain: {count: 2, spacing: 1e-9, start: [1e9, 0, 0]}}\nbinder: {axial: 1}\n", "", "",
     "t: the centres of bodies 0 and 1 give no direction to their bond; move one of them"},
    {BODIES "contact: {stiffness: 1}\n", "x,y,z,diameter\n5,0,0,1\n0,2,3,1\n0,0,0,1\n1e-152,2,3,2\n", "",
     "t: the centres of bodies 1 and 3 give no direction to their contact; move one of them"},
};

TEST(mismatches)
{
    for (size_t k = 0; k < sizeof mismatched / sizeof mismatched[0]; ++k) {
        struct scene scene;
        struct model model;
        struct message message;
        char text[512];
        snprintf(text, sizeof text, "%s" TIME, mismatched[k].scene);
        write_text("b.csv", mismatched[k].bodies);
        write_text("c.csv", mismatched[k].bonds);
        assert_refused(text, try_model(text, &scene, &model, &message), &message, mismatched[k].line);
        assert_null(model.memory); /* destroyed */
    }
}

/* ---- models of tables -------------------------------------------------------------------------------------------- */

/** The form of shear stands in the scene, stiffnesses in the table. */
TEST(shear_of_each_bond)
{
    struct scene scene;
    struct model model;
    write_text("b.csv", "x,y,z\n0,0,0\n1,0,0\n1,2,0\n");
    write_text("c.csv", "i,j,shear\n1,0,3\n1,2,4\n");
    make_model("bodies: {table: b.csv, mass: 1, inertia: 1}\nbinder: {table: c.csv, shear: {form: quartic}}\n" TIME,
               &scene, &model);
    const vti_bonds bonds = bonds_of(&model);
    assert_int_equal(bonds.shear_form, VTI_SHEAR_QUARTIC);
    assert_true(bonds.shear.stride == 1 && bonds.shear.p[0] == 3.0 && bonds.shear.p[1] == 4.0);
    model_destroy(&model);
}

TEST(bodies_and_bonds)
{
    static const double x[9] = {0, 0, 0, 1, 0, 0, 1, 2, 0}, v[9] = {0, 0, 1, 0, 0, 2, 0, 0, 3}, zero[9] = {0};
    struct scene scene;
    struct model model;
    write_text("b.csv", "x,y,z,vx,vy,vz,mass,diameter\n0,0,0,0,0,1,1,1\n1,0,0,0,0,2,2,2\n1,2,0,0,0,3,3,1\n");
    write_text("c.csv", "i,j,moment,axial\n1,0,10,100\n1,2,20,0\n");
    make_model("bodies: {table: b.csv, omega: [0, 1, 0]}\nbinder: {table: c.csv, shear: {stiffness: 7}}\n" TIME, &scene,
               &model);
    assert_same_bits(model.bodies.x.c[0], x, 9);
    assert_same_bits(model.bodies.v.c[0], v, 9);
    assert_same_bits(model.bodies.alpha.c[0], zero, 9);
    assert_int_equal(model.bodies.mass.stride, 1);
    assert_int_equal(model.bodies.inertia.stride, 1);
    for (int i = 0; i < 3; ++i) {
        const double m = i + 1.0, d = i == 1 ? 2.0 : 1.0;
        assert_true(model.bodies.mass.p[i] == m && model.diameter.p[i] == d);
        assert_close(model.bodies.inertia.p[i], 0.1 * m * d * d, 2 * EPS);
        assert_true(model.bodies.omega.c[1][3 * i] == 1.0);
    }
    const vti_bonds bonds = bonds_of(&model);
    assert_int_equal(bonds.count, 2);
    assert_int_equal(bonds.pair[0], 1);
    assert_true(bonds.moment.stride == 1 && bonds.moment.p[1] == 20.0);
    assert_true(bonds.axial.stride == 1 && bonds.axial.p[0] == 100.0 && bonds.axial.p[1] == 0.0);
    assert_true(bonds.shear.stride == 0 && bonds.shear.p[0] == 7.0);
    assert_true(bonds.rest[0] == 1.0 && bonds.rest[3] == 1.0); /* from 0 to 1 */
    assert_true(bonds.rest[5] == -1.0 && bonds.rest[7] == 2.0);
    model_destroy(&model);
}

/** m = density pi/6 D^3 and J = m D^2/10, of diameters that are all the same or not. */
TEST(density)
{
    static const double pi = 3.14159265358979323846;
    struct scene scene;
    struct model model;
    write_text("b.csv", "x,y,z,diameter\n0,0,0,1\n1,0,0,2\n1,2,0,3\n");
    make_model("bodies: {table: b.csv, density: 12, omega: [0, 1, 0]}\n" TIME, &scene, &model);
    for (int i = 0; i < 3; ++i) {
        const double d = i + 1.0, m = 2.0 * pi * d * d * d;
        assert_close(model.bodies.mass.p[i * model.bodies.mass.stride], m, 4 * EPS * m);
        assert_close(model.bodies.inertia.p[i * model.bodies.inertia.stride], 0.1 * m * d * d, 8 * EPS * m * d * d);
    }
    model_destroy(&model);
    make_model("bodies: {chain: {count: 2, spacing: 3}, density: 12, omega: [0, 1, 0]}\n" TIME, &scene, &model);
    assert_int_equal(model.bodies.mass.stride, 0);
    assert_close(*model.bodies.mass.p, 54.0 * pi, 1e3 * EPS);
    assert_close(*model.bodies.inertia.p, 48.6 * pi, 1e3 * EPS);
    model_destroy(&model);
}

/** Bonds that are under stress at t = 0: U = K^a/2 (r/L0 - 1)^2 + K^s (1 - cos gamma). */
TEST(rest_of_bonds)
{
    struct scene scene;
    struct model model;
    write_text("b.csv", "x,y,z,mass,diameter\n0,0,0,1,1\n1,0,0,2,2\n1,2,0,3,1\n");
    write_text("c.csv", "i,j,length,nx,ny,nz\n1,0,0.8,3,4,0\n1,2,2.5,0,-2,0\n");
    make_model("bodies: {table: b.csv}\nbinder: {table: c.csv, axial: 10, shear: {stiffness: 7}}\n" TIME, &scene,
               &model);
    const vti_bonds bonds = bonds_of(&model);
    assert_close(bonds.rest[0], 0.6, EPS);
    assert_close(bonds.rest[1], 0.8, EPS);
    assert_true(bonds.rest[3] == 0.8 && bonds.rest[5] == -1.0 && bonds.rest[7] == 2.5);
    const double axial = 5 * (0.25 * 0.25 + 0.2 * 0.2), shear = 7 * (1 - 0.6);
    assert_close(model_energy(&model, &model.bodies), axial + shear, 20 * EPS);
    model_destroy(&model);
}

/** A rotation at rest, of any length in the file: K^m/2 (2 asin 0.6)^2 where nothing has turned, and nothing is held
 *  where body 0 has turned by it. */
TEST(turns_of_bonds)
{
    struct scene scene;
    struct model model;
    write_text("b.csv", "x,y,z,alpha_x,alpha_y,alpha_z,mass,diameter\n0,0,0,0,0,0,1,1\n1,0,0,0,1.5,0,1,1\n");
    write_text("c.csv", "i,j,turn_x,turn_y,turn_z,turn_w\n0,1,0,1.2,0,1.6\n");
    make_model("bodies: {table: b.csv}\nbinder: {table: c.csv, moment: 10, shear: {stiffness: 7}}\n" TIME, &scene,
               &model);
    const vti_bonds bonds = bonds_of(&model);
    assert_true(bonds.turn != NULL && bonds.turn[0] == 0 && bonds.turn[2] == 0);
    assert_close(bonds.turn[1], 0.6, EPS);
    assert_close(bonds.turn[3], 0.8, EPS);
    assert_below(model_energy(&model, &model.bodies), 100 * EPS * EPS);
    model.bodies.alpha.c[1][3] = 0;
    const double theta = 2 * asin(0.6), bent = 7 * (1 - cos(theta / 2));
    assert_close(model_energy(&model, &model.bodies), 5 * theta * theta + bent, 100 * EPS);
    model_destroy(&model);
}

/** What limits the step is named by its number in the table, whatever has broken. */
TEST(limits_name_the_bond)
{
    struct scene scene;
    struct model model;
    int64_t broken = 0;
    char text[128];
    const vti_stable stable = {.effect = 0, .element = 0, .i = 1, .j = 2};
    write_text("b.csv", THREE);
    write_text("c.csv", "i,j,length\n0,1,0.1\n1,2,1\n");
    make_model("bodies: {table: b.csv, mass: 1}\nbinder: {table: c.csv, axial: 1, break: {stretch: 2}}\n" TIME, &scene,
               &model);
    assert_int_equal(vti_effects_rupture(model.effects, model.effects_count, &model.bodies, &broken), VTI_OK);
    assert_int_equal(broken, 1);
    model_limit_text(&model, NULL, &stable, text, sizeof text);
    assert_string_equal(text, "bond 1 of bodies 1 and 2");
    model_destroy(&model);
}

/** In the words of each effect; where j, or the wall, is -1, of clumps, whose spheres' forces turn them. */
TEST(limits_in_words)
{
    static const struct {
        vti_stable stable;
        const char *words;
    } limit[] = {{{.effect = -1}, "nothing oscillates"},
                 {{.effect = 0, .element = 0, .i = 2, .j = -1}, "pull of bonds on body 2"},
                 {{.effect = 1, .element = 0, .i = 1, .j = 2}, "contact of bodies 1 and 2"},
                 {{.effect = 1, .element = -1, .i = 1, .j = -1}, "pull of contacts on body 1"},
                 {{.effect = 2, .element = 3, .i = 1, .j = -1}, "wall 3 at body 1"},
                 {{.effect = 2, .element = -1, .i = 1, .j = -1}, "pull of walls on body 1"},
                 {{.effect = 3, .element = 0, .i = 0, .j = -1}, "friction at body 0"},
                 {{.effect = 3, .element = 0, .i = 0, .j = 2}, "friction of bodies 0 and 2"}};
    struct scene scene;
    struct model model;
    char text[128];
    make_model("bodies: {chain: {count: 3, spacing: 1}, mass: 1}\nbinder: {axial: 1}\ncontact: {stiffness: 1}\n"
               "wall: {stiffness: 1, planes: [[0, 0, 1, -9]]}\nfriction: {sliding: 1, poisson: 0.3}\n" TIME,
               &scene, &model);
    for (size_t k = 0; k < sizeof limit / sizeof limit[0]; ++k) {
        model_limit_text(&model, NULL, &limit[k].stable, text, sizeof text);
        assert_string_equal(text, limit[k].words);
    }
    model_destroy(&model);
}

/** Bodies of two materials on a wall of a third: U = 2/5 k_H delta^{5/2}, k_H = (4/3) E* sqrt(R*), of a pair and at the
 *  wall, which alone serves as well. */
TEST(materials_of_bodies)
{
    struct scene scene;
    struct model model;
    const double first = 1000 / (1 - 0.09), other = 4000 / (1 - 0.04), plane = 8000 / (1 - 0.0625);
    const double pair = 1 / (1 / first + 1 / other), low = 1 / (1 / first + 1 / plane);
    const double in_pair = 0.4 * 4 / 3 * pair * sqrt(1 / (1 / 0.5 + 1 / 1.0)) * pow(0.1, 2.5);
    const double at_wall = 0.4 * 4 / 3 * low * sqrt(0.5) * pow(0.05, 2.5);
    write_text("b.csv", "x,y,z,diameter,young,poisson\n0,0,0.45,1,1000,0.3\n1.4,0,0.45,2,4000,0.2\n");
    for (int k = 0; k < 4; ++k) {
        char text[256];
        snprintf(text, sizeof text, "bodies: {table: b.csv, mass: 1}\n%s%s" TIME, k % 2 == 0 ? "contact: {}\n" : "",
                 k > 0 ? "wall: {young: 8000, poisson: 0.25, planes: [[0, 0, 1, 0], [1, 0, 0, -9]]}\n" : "");
        if (k == 3)
            write_text("b.csv", "x,y,z,diameter,young,poisson\n0,0,0.45,1,1000,0.3\n1.6,0,2.45,2,4000,0.2\n");
        make_model(text, &scene, &model);
        /* the second sphere is pressed into the wall by 0.55, at first */
        const double deep = k == 3 ? 0 : 0.4 * 4 / 3 / (1 / other + 1 / plane) * pow(0.55, 2.5);
        const double expected = (k % 2 == 0 ? in_pair : 0) + (k > 0 ? at_wall + deep : 0);
        assert_close(model_energy(&model, &model.bodies), expected, 1e-13 * (1 + expected));
        assert_true(isfinite(model_deformation(&model, &model.bodies).overlap));
        model_destroy(&model);
    }
    /* a wall takes that of the contact, too */
    write_text("b.csv", "x,y,z,diameter\n0,0,0.45,1\n");
    make_model("bodies: {table: b.csv, mass: 1}\ncontact: {young: 1000, poisson: 0.3}\n"
               "wall: {young: 8000, poisson: 0.25, planes: [[0, 0, 1, 0]]}\n" TIME,
               &scene, &model);
    assert_close(model_energy(&model, &model.bodies), at_wall, 1e-13);
    model_destroy(&model);
}

/** A table of bonds turns bodies that nothing in the scene turns; bodies of a table may also turn and stay. */
TEST(what_tables_add)
{
    struct scene scene;
    struct model model;
    write_text("c.csv", "i,j,moment\n0,1,10\n");
    make_model("bodies: {mass: 1, chain: {count: 3, spacing: 1}}\nbinder: {table: c.csv}\n" TIME, &scene, &model);
    assert_false(scene.turns);
    assert_true(model.turns && model.bodies.moment.c[0] != NULL && model.bodies.force.c[0] == NULL);
    assert_int_equal(bonds_of(&model).count, 1);
    model_destroy(&model);
    write_text("b.csv", "alpha_x,alpha_y,alpha_z\n0,0,0\n1,0,0\n");
    make_model("bodies: {table: b.csv, inertia: 1}\npendulum: {weight: 1, rho0: [0, 0, 1]}\n" TIME, &scene, &model);
    assert_true(model.turns && !model.translates && model.bodies.x.c[0] == NULL);
    assert_true(model.bodies.alpha.c[0][3] == 1.0 && model.bodies.omega.c[0][3] == 0.0);
    model_destroy(&model);
}

/** Tables that somebody has read already are used, and left alone. */
TEST(given_tables)
{
    struct scene scene;
    struct model model;
    struct message message;
    struct tables tables;
    memset(&tables, 0, sizeof tables);
    write_text("b.csv", THREE);
    assert_int_equal(table_csv_read("b.csv", &table_bodies, &tables.bodies, &message), 0);
    write_text("t.yaml", "bodies: {table: b.h5, mass: 1}\n" TIME);
    assert_int_equal(scene_read("t.yaml", NULL, 0, &scene, &message), 0);
    scene.tables = &tables;
    assert_int_equal(model_create(&scene, &model, &message), 0);
    assert_int_equal(model.bodies.count, 3);
    model_destroy(&model);
    assert_int_equal(tables.bodies.rows, 3);
    table_destroy(&tables.bodies);
}

RUN_TESTS_IN_FOLDER(cmocka_unit_test(reads), cmocka_unit_test(reads_many_rows), cmocka_unit_test(refusals),
                    cmocka_unit_test(what_is_no_file), cmocka_unit_test(mismatches),
                    cmocka_unit_test(shear_of_each_bond), cmocka_unit_test(bodies_and_bonds), cmocka_unit_test(density),
                    cmocka_unit_test(rest_of_bonds), cmocka_unit_test(turns_of_bonds),
                    cmocka_unit_test(materials_of_bodies), cmocka_unit_test(limits_name_the_bond),
                    cmocka_unit_test(limits_in_words), cmocka_unit_test(what_tables_add),
                    cmocka_unit_test(given_tables))
