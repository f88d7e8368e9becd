// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/data/lattice.h"
#include "core/data/scalar_field.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace tetra {

class MappedFile;

/// Where a dataset came from: kept in every model built from it.
struct Source {
    std::string name;           ///< what the user calls it: the file's name, or a sample's
    std::filesystem::path path; ///< empty when it was never a file
    std::uint64_t hash =
        0; ///< XXH3 of the samples' bytes in memory order, then of the positions' and the tetrahedra's if there are any
};

/// Where each point lies, all finite; shared and never changed.
using PointPositions = std::shared_ptr<const std::vector<Eigen::Vector3d>>;

/// The tetrahedra of an irregular mesh, by numbers of points, positive: (b-a) . ((c-a) x (d-a)) > 0; shared and never
/// changed.
using PointTetrahedra = std::shared_ptr<const std::vector<std::array<std::uint32_t, 4>>>;

/// Source::hash of such values, positions and tetrahedra.
std::uint64_t contentHash(const ScalarField& values, const PointPositions& positions,
                          const PointTetrahedra& tetrahedra = nullptr);

/// The reference model (2.3): points with one scalar each. Immutable, cheap to copy.
///
/// Regular: the lattice says where the points lie. Curvilinear (and rectilinear): the lattice is the computational
/// space, with spacing 1 and origin 0, and `positions` the physical one. Scattered: `positions` alone; the lattice's
/// size is {points, 1, 1} and says nothing more. Irregular: as scattered, and `tetrahedra` fill the domain: a
/// conforming mesh that uses every point, of one or more components, whose boundary is a manifold (checkIrregular() in
/// core/data/cells/irregular_check.h).
struct Dataset {
    DomainClass domain = DomainClass::RegularLattice;
    Lattice lattice;
    PointPositions positions = nullptr; ///< one a point in the order of the values; null for a regular lattice
    ScalarField values;                 ///< one sample per point, all finite
    Source source;
    std::vector<std::string> remarks{}; ///< what reading changed, in sentences for the user
    /// The file whose bytes the values are; null if they are in memory.
    std::shared_ptr<const MappedFile> mappedFile = nullptr;
    PointTetrahedra tetrahedra = nullptr; ///< of irregular data, else null

    std::uint64_t pointCount() const noexcept { return values.count(); }
    Eigen::Vector3d position(std::uint64_t point) const
    {
        if (positions)
            return (*positions)[point];
        const auto place = lattice.coordinates(point);
        return lattice.position(place[0], place[1], place[2]);
    }
    /// Of all points in physical space. O(1) for a regular lattice, else O(points).
    Eigen::AlignedBox3d bounds() const;
    /// An error naming the mapped file if it was cut or changed: values read since may be zeros or others. Who made
    /// something out of the values asks before it counts. One system call.
    Status checkIntact() const;
};

} // namespace tetra
