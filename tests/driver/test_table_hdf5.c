/* SPDX-License-Identifier: BSD-3-Clause
 * Tables of bodies and bonds as HDF5: what is read, whatever the type of the numbers, and the line that each fault
 * gets. */
#define _POSIX_C_SOURCE 200809L
#include <hdf5.h>

#include "model_support.h"

#include "binder.h"

#include "table_csv.h"
#include "table_hdf5.h"

#define BODY_NAMES                                                                                                     \
    "x, y, z, vx, vy, vz, alpha_x, alpha_y, alpha_z, omega_x, omega_y, omega_z, moment_a, moment_b, moment_c, "        \
    "principal_x, principal_y, principal_z, mass, inertia, diameter, young, poisson, clump"

/* ---- writing ----------------------------------------------------------------------------------------------------- */

/** Nothing is written where values is NULL. */
static void put(hid_t group, const char *name, hid_t type, int dimensions, hsize_t n, const double *values)
{
    const hsize_t size[2] = {n, 1};
    const hid_t space = H5Screate_simple(dimensions, size, NULL);
    const hid_t set = H5Dcreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(set >= 0);
    assert_true(values == NULL || H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
    H5Dclose(set);
    H5Sclose(space);
}

static hid_t open_file(const char *path)
{
    remove(path);
    const hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(file >= 0);
    return file;
}

static hid_t open_group(hid_t file, const char *name)
{
    const hid_t group = H5Gcreate2(file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(group >= 0);
    return group;
}

/** Three bodies and two bonds in one file. */
static void write_both(const char *path)
{
    static const double x[] = {0, 1, 1}, y[] = {0, 0, 2}, z[] = {0, 0, 0}, mass[] = {1, 2, 3}, i[] = {1, 1},
                        j[] = {0, 2}, axial[] = {0.5, 100};
    const hid_t file = open_file(path), bodies = open_group(file, "bodies"), bonds = open_group(file, "bonds");
    put(bodies, "x", H5T_IEEE_F64BE, 1, 3, x);
    put(bodies, "y", H5T_IEEE_F32LE, 1, 3, y);
    put(bodies, "z", H5T_IEEE_F64LE, 1, 3, z);
    put(bodies, "mass", H5T_STD_U8LE, 1, 3, mass);
    put(bonds, "i", H5T_STD_I64LE, 1, 2, i);
    put(bonds, "j", H5T_STD_I32BE, 1, 2, j);
    put(bonds, "axial", H5T_IEEE_F64LE, 1, 2, axial);
    H5Gclose(bodies);
    H5Gclose(bonds);
    H5Fclose(file);
}

/* ---- reading ----------------------------------------------------------------------------------------------------- */

TEST(reads)
{
    struct scene scene;
    struct model model;
    struct tables tables;
    struct message message;
    write_both("b.h5");
    write_text("t.yaml", "bodies: {table: b.h5}\nbinder: {table: b.h5}\n" TIME);
    assert_int_equal(scene_read("t.yaml", NULL, 0, &scene, &message), 0);
    if (tables_read(&scene, &tables, &message) != 0)
        fail_msg("%s", message.text);
    assert_ptr_equal(scene.tables, &tables);
    assert_int_equal(tables.bodies.rows, 3);
    assert_true(tables.bodies.column[BODY_X][2] == 1.0 && tables.bodies.column[BODY_X + 1][2] == 2.0);
    assert_true(tables.bodies.column[BODY_MASS][1] == 2.0);
    assert_true(tables.effect[EFFECT_binder].column[BOND_I][1] == 1.0 &&
                tables.effect[EFFECT_binder].column[BOND_J][1] == 2.0);
    assert_int_equal(model_create(&scene, &model, &message), 0);
    assert_true(model.translates && !model.turns && model.bodies.mass.p[2] == 3.0);
    assert_int_equal(bonds_of(&model).count, 2);
    assert_true(bonds_of(&model).axial.p[0] == 0.5);
    model_destroy(&model);
    tables_destroy(&tables);
}

/* ---- refusals ---------------------------------------------------------------------------------------------------- */

static void refused(const struct table_kind *kind, const char *line)
{
    struct table table;
    struct message message;
    assert_refused(line, table_hdf5_read("b.h5", kind, &table, &message), &message, line);
    assert_int_equal(table.rows, 0);
    assert_null(table.column[0]);
}

/** One dataset of two values, in the group. */
static void refused_set(const struct table_kind *kind, const char *name, int dimensions, double a, double b,
                        const char *line)
{
    const double values[2] = {a, b};
    const hid_t file = open_file("b.h5"), group = open_group(file, kind->rows);
    put(group, name, H5T_IEEE_F64LE, dimensions, 2, values);
    H5Gclose(group);
    H5Fclose(file);
    refused(kind, line);
}

TEST(values)
{
    refused_set(&table_bodies, "radius", 1, 1, 1, "b.h5: /bodies/radius: unknown column; known are " BODY_NAMES);
    refused_set(&binder_table, "mass", 1, 1, 1,
                "b.h5: /bonds/mass: unknown column; known are i, j, moment, axial, shear, break_stretch, "
                "break_normal, break_shear, break_bending, break_torsion, break_energy, length, nx, ny, nz, turn_x, "
                "turn_y, turn_z, turn_w");
    refused_set(&table_bodies, "x", 2, 1, 1,
                "b.h5: /bodies/x: is not a list of numbers; give a dataset of numbers, of one dimension");
    refused_set(&table_bodies, "x", 1, 1, NAN, "b.h5: row 1: x: 'nan' is not finite; give a number");
    refused_set(&table_bodies, "x", 1, -INFINITY, 1, "b.h5: row 0: x: '-inf' is not finite; give a number");
    refused_set(&table_bodies, "mass", 1, 1, 0, "b.h5: row 1: mass: '0' is not positive; it must be > 0");
    refused_set(&binder_table, "axial", 1, 1, -0.5, "b.h5: row 1: axial: '-0.5' is negative; it must be >= 0");
    refused_set(&binder_table, "i", 1, 0.5, 0,
                "b.h5: row 0: i: '0.5' is not a body; bodies are counted 0, 1, 2 and so on");
    refused_set(&table_bodies, "y", 1, 1, 1, "b.h5: no column x; give x, y and z or none of them");
    refused_set(&binder_table, "i", 1, 1, 1, "b.h5: no column j; bonds need i and j");
}

TEST(groups)
{
    static const double one[3] = {1, 1, 1};
    struct table table;
    struct message message;
    hid_t file = open_file("b.h5"), group;
    put(file, "bodies", H5T_IEEE_F64LE, 1, 3, one);
    H5Fclose(file);
    refused(&table_bodies, "b.h5: no group /bodies; put a dataset for each column into it");
    refused(&binder_table, "b.h5: no group /bonds; put a dataset for each column into it");
    file = open_file("b.h5");
    group = open_group(file, "bodies");
    H5Gclose(open_group(group, "x"));
    H5Gclose(group);
    H5Gclose(open_group(file, "bonds"));
    H5Fclose(file);
    refused(&table_bodies, "b.h5: /bodies/x: is not a list of numbers; give a dataset of numbers, of one dimension");
    refused(&binder_table, "b.h5: no bonds; give a row for each");
    file = open_file("b.h5");
    group = open_group(file, "bodies");
    put(group, "x", H5T_IEEE_F64LE, 1, 3, NULL);
    H5Gclose(group);
    H5Fclose(file);
    refused(&table_bodies, "b.h5: /bodies/x: holds no values, nothing has been written to it here; write them into "
                           "this file");
    file = open_file("b.h5");
    group = open_group(file, "bodies");
    put(group, "x", H5T_IEEE_F64LE, 1, 3, one);
    put(group, "y", H5T_IEEE_F64LE, 1, 2, one);
    H5Gclose(group);
    H5Fclose(file);
    refused(&table_bodies, "b.h5: /bodies/y: 2 rows, and x has 3; give all columns the same number");
    assert_refused("missing", table_hdf5_read("none.h5", &table_bodies, &table, &message), &message,
                   "none.h5: cannot be read: No such file or directory; give the path of a table");
}

/** Every truncation of a whole file, and a file that is no HDF5 at all: one line and no crash. */
TEST(damaged_files)
{
    struct table table;
    struct message message;
    write_text("b.h5", "x,y,z\n0,0,0\n");
    refused(&table_bodies, "b.h5: is not a whole HDF5 file; give one, or a table in CSV");
    write_both("b.h5");
    FILE *whole = fopen("b.h5", "rb");
    assert_non_null(whole);
    static char bytes[1 << 16];
    const size_t size = fread(bytes, 1, sizeof bytes, whole);
    fclose(whole);
    assert_in_range(size, 1000, sizeof bytes - 1);
    for (size_t n = 0; n < size; n += 13) {
        write_bytes("b.h5", bytes, n);
        assert_int_equal(table_hdf5_read("b.h5", &table_bodies, &table, &message), -1);
        assert_one_line(&message);
        assert_memory_equal(message.text, "b.h5: ", 6);
    }
}

RUN_TESTS_IN_FOLDER(cmocka_unit_test(reads), cmocka_unit_test(values), cmocka_unit_test(groups),
                    cmocka_unit_test(damaged_files))
