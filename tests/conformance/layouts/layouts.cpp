// SPDX-License-Identifier: BSD-3-Clause
// The scene of test_layouts.py in C++: vectors of structs, of arrays, of numbers, and threads.            layouts_cpp TABLE
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "vti.h"

namespace
{

using Vector = std::array<double, 3>;

void must(int status)
{
    if (status != VTI_OK)
        throw std::runtime_error(vti_status_text(status));
}

struct Sphere {
    Vector x, v, alpha, omega, force, moment;
    double mass, inertia, diameter;
};

struct Table {
    explicit Table(const char *path)
    {
        std::ifstream file(path);
        std::size_t n = 0, bonds = 0, planes = 0;
        file >> n >> bonds >> planes >> steps >> h;
        for (double &k : stiffness)
            file >> k;
        plane.resize(4 * planes);
        for (double &p : plane)
            file >> p;
        spheres.resize(n);
        for (Sphere &s : spheres) {
            for (Vector *q : {&s.x, &s.v, &s.alpha, &s.omega})
                for (double &c : *q)
                    file >> c;
            file >> s.mass >> s.inertia >> s.diameter;
        }
        pair.resize(2 * bonds);
        for (std::int64_t &i : pair)
            file >> i;
        if (!file)
            throw std::runtime_error("the table ends early");
    }
    std::vector<Sphere> spheres;
    std::vector<double> plane;
    std::vector<std::int64_t> pair;
    std::array<double, 4> stiffness{};
    int steps = 0;
    double h = 0;
};

/// The scene on bodies that are somewhere, stepped in slices, each by a thread of its own where there are several.
class Scene
{
  public:
    Scene(const Table &scene, const vti_bodies &spheres, const vti_scalars &diameter)
        : table(scene), bodies(spheres), rest(2 * scene.pair.size())
    {
        const auto count = static_cast<std::int64_t>(table.pair.size() / 2);
        bonds = {count,
                 table.pair.data(),
                 0,
                 rest.data(),
                 vti_scalars_one(&table.stiffness[0]),
                 vti_scalars_one(&table.stiffness[1]),
                 vti_scalars_one(&table.stiffness[2]),
                 VTI_SHEAR_OBJECTIVE};
        walls = {static_cast<std::int64_t>(table.plane.size() / 4), table.plane.data(), diameter, table.stiffness[3]};
        must(vti_bodies_check_values(&bodies, nullptr));
        must(vti_bonds_rest(count, table.pair.data(), 0, &bodies.x, rest.data(), nullptr));
    }

    void run(const char *name, int slices)
    {
        forces();
        for (int k = 0; k < table.steps; ++k) {
            each(slices, [this](const vti_bodies &b) { must(vti_step_begin(method, table.h, &b, nullptr)); });
            forces();
            each(slices, [this](const vti_bodies &b) { must(vti_step_finish(method, table.h, &b)); });
        }
        std::printf("= %s, %d slices\n", name, slices);
        for (std::int64_t i = 0; i < bodies.count; ++i) {
            for (const vti_view *q : {&bodies.x, &bodies.v, &bodies.alpha, &bodies.omega})
                for (const double *c : q->c)
                    std::printf("%.17g ", c[i * q->stride]);
            std::printf("\n");
        }
    }

  private:
    void forces() const
    {
        const std::array<vti_effect, 2> effects{{vti_bonds_effect(&bonds), vti_walls_effect(&walls)}};
        must(vti_apply(effects.data(), walls.count > 0 ? 2 : 1, &bodies));
    }

    void each(int slices, const std::function<void(const vti_bodies &)> &half) const
    {
        std::vector<std::thread> threads;
        for (int s = 0; s < slices; ++s) {
            const std::int64_t first = bodies.count * s / slices, end = bodies.count * (s + 1) / slices;
            const vti_bodies part = vti_bodies_slice(bodies, first, end - first);
            if (slices == 1)
                half(part);
            else
                threads.emplace_back([half, part] { half(part); });
        }
        for (std::thread &thread : threads)
            thread.join();
    }

    const Table &table;
    vti_bodies bodies;
    std::vector<double> rest;
    vti_bonds bonds{};
    vti_walls walls{};
    const vti_stepper *method = vti_stepper_find("vti2");
};

void run_structs(const Table &table, int slices)
{
    std::vector<Sphere> s = table.spheres;
    const auto member = [](Vector &v) { return vti_view_member(v.data(), sizeof(Sphere)); };
    vti_bodies b = vti_bodies_none(static_cast<std::int64_t>(s.size()));
    b.x = member(s[0].x);
    b.v = member(s[0].v);
    b.alpha = member(s[0].alpha);
    b.omega = member(s[0].omega);
    b.force = member(s[0].force);
    b.moment = member(s[0].moment);
    b.mass = vti_scalars_member(&s[0].mass, sizeof(Sphere));
    b.inertia = vti_scalars_member(&s[0].inertia, sizeof(Sphere));
    Scene(table, b, vti_scalars_member(&s[0].diameter, sizeof(Sphere))).run("std::vector of structs", slices);
}

/// One vector for each quantity, of arrays of three, or one for each component.
void run_arrays(const Table &table, int slices, bool components)
{
    const std::size_t n = table.spheres.size();
    std::vector<Vector> packed[6];
    std::vector<double> separate[6][3], mass(n), inertia(n), diameter(n);
    vti_bodies b = vti_bodies_none(static_cast<std::int64_t>(n));
    vti_view *const views[6] = {&b.x, &b.v, &b.alpha, &b.omega, &b.force, &b.moment};
    Vector Sphere::*const members[6] = {&Sphere::x,     &Sphere::v,     &Sphere::alpha,
                                        &Sphere::omega, &Sphere::force, &Sphere::moment};
    for (int q = 0; q < 6; ++q) {
        for (const Sphere &s : table.spheres) {
            packed[q].push_back(s.*members[q]);
            for (std::size_t c = 0; c < 3; ++c)
                separate[q][c].push_back((s.*members[q])[c]);
        }
        *views[q] = components ? vti_view_separate(separate[q][0].data(), separate[q][1].data(), separate[q][2].data())
                               : vti_view_packed(packed[q][0].data());
    }
    for (std::size_t i = 0; i < n; ++i) {
        mass[i] = table.spheres[i].mass;
        inertia[i] = table.spheres[i].inertia;
        diameter[i] = table.spheres[i].diameter;
    }
    b.mass = vti_scalars_array(mass.data());
    b.inertia = vti_scalars_array(inertia.data());
    Scene(table, b, vti_scalars_array(diameter.data()))
        .run(components ? "std::vector for each component" : "std::vector of std::array", slices);
}

} // namespace

int main(int argc, char **argv)
try {
    const Table table(argc == 2 ? argv[1] : "");
    for (const int slices : {1, 3}) {
        run_structs(table, slices);
        run_arrays(table, slices, false);
        run_arrays(table, slices, true);
    }
} catch (const std::exception &trouble) {
    std::fprintf(stderr, "layouts_cpp: %s\n", trouble.what());
    return 1;
}
