// SPDX-License-Identifier: BSD-3-Clause
// A host in C++ that keeps each component in a vector of its own: a chain of bonded spheres, by VTI-2.
//     host_cpp chain/bodies.csv
#include <array>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "vti.h"

namespace
{

void must(int status)
{
    if (status != VTI_OK)
        throw std::runtime_error(vti_status_text(status));
}

/// n three-vectors as x..., y..., z...
struct Vectors {
    explicit Vectors(std::size_t n = 0)
        : component{{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)}}
    {
    }
    vti_view view()
    {
        return vti_view_separate(component[0].data(), component[1].data(), component[2].data());
    }
    std::array<std::vector<double>, 3> component;
};

class Chain
{
  public:
    explicit Chain(const std::string &path)
    {
        std::ifstream file(path);
        if (!file)
            throw std::runtime_error(path + ": cannot be opened; call this in the folder examples, or with the path of the table");
        std::string line;
        for (std::getline(file, line); std::getline(file, line);) { // behind the line of names
            const std::array<double, 14> row = numbers(line);
            for (std::size_t k = 0; k < 3; ++k) {
                x.component[k].push_back(row[k]);
                v.component[k].push_back(row[3 + k]);
                alpha.component[k].push_back(row[6 + k]);
                omega.component[k].push_back(row[9 + k]);
            }
            mass.push_back(row[12]);
            inertia.push_back(row[13]);
        }
        force = moment = Vectors(mass.size());
        bodies = vti_bodies_none(static_cast<std::int64_t>(mass.size()));
        bodies.x = x.view();
        bodies.v = v.view();
        bodies.force = force.view();
        bodies.alpha = alpha.view();
        bodies.omega = omega.view();
        bodies.moment = moment.view();
        bodies.mass = vti_scalars_array(mass.data());
        bodies.inertia = vti_scalars_array(inertia.data());
        must(vti_bodies_check_values(&bodies, nullptr));
        bond();
    }

    // bodies and bonds point into this object
    Chain(const Chain &) = delete;
    Chain &operator=(const Chain &) = delete;

    void run(double h, int steps)
    {
        const vti_stepper *method = vti_stepper_find("vti2");
        forces();
        for (int k = 0; k < steps; ++k) {
            must(vti_step_begin(method, h, &bodies, nullptr));
            forces();
            must(vti_step_finish(method, h, &bodies));
        }
    }

    void print() const
    {
        for (std::size_t i = 0; i < mass.size(); ++i) {
            for (const Vectors *q : {&x, &v, &alpha, &omega})
                for (const std::vector<double> &c : q->component)
                    std::printf("%.17g ", c[i]);
            std::printf("\n");
        }
    }

  private:
    static std::array<double, 14> numbers(const std::string &line)
    {
        std::istringstream text(line);
        std::array<double, 14> row;
        for (double &value : row) {
            text >> value;
            if (!text)
                throw std::runtime_error("a line of fewer than 14 numbers");
            text.ignore(1); // the comma
        }
        return row;
    }

    void bond()
    {
        for (std::int64_t k = 0; k + 1 < bodies.count; ++k)
            pair.insert(pair.end(), {k, k + 1});
        rest.resize(2 * pair.size());
        bonds.count = bodies.count - 1;
        bonds.pair = pair.data();
        bonds.rest = rest.data();
        bonds.moment = vti_scalars_one(&stiffness[0]);
        bonds.axial = vti_scalars_one(&stiffness[1]);
        bonds.shear = vti_scalars_one(&stiffness[2]);
        bonds.shear_form = VTI_SHEAR_OBJECTIVE;
        must(vti_bonds_rest(bonds.count, bonds.pair, 0, &bodies.x, rest.data(), nullptr));
        must(vti_bonds_check(&bonds, bodies.count, nullptr));
        binder = vti_bonds_effect(&bonds);
    }

    /// This host's forces: those of the library's binder. A host with forces of its own computes them here.
    void forces()
    {
        must(vti_apply(&binder, 1, &bodies));
    }

    Vectors x, v, force, alpha, omega, moment;
    std::vector<double> mass, inertia, rest;
    std::vector<std::int64_t> pair;
    std::array<double, 3> stiffness = {{10.0, 200.0, 200.0}};
    vti_bodies bodies = {};
    vti_bonds bonds = {};
    vti_effect binder = {};
};

} // namespace

int main(int argc, char **argv)
try {
    Chain chain(argc > 1 ? argv[1] : "chain/bodies.csv");
    chain.run(1.0 / 512.0, 5120);
    chain.print();
} catch (const std::exception &trouble) {
    std::fprintf(stderr, "host_cpp: %s\n", trouble.what());
    return 1;
}
