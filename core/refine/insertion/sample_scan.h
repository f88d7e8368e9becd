// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/insertion/local_delaunay.h"
#include "core/refine/lattice/lattice_samples.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// How large the error may be at each point of a lattice, in units of the values.
class ErrorLimits {
public:
    virtual ~ErrorLimits() = default;
    virtual double at(const std::array<std::uint32_t, 3>& point) const = 0;

    double least = 0; ///< nowhere less ...
    double most = 0;  ///< ... and this everywhere but from `first` to `last`
    std::array<std::int32_t, 3> first{0, 0, 0};
    std::array<std::int32_t, 3> last{-1, -1, -1};
    bool twoValued = false; ///< it is `least` everywhere between the two

    /// Where it is known already that no error is beyond its limit: a tetrahedron that did not change and lies between
    /// the two is not looked at.
    void settle(const std::array<std::int32_t, 3>& from, const std::array<std::int32_t, 3>& to)
    {
        settledFirst = from;
        settledLast = to;
    }
    std::array<std::int32_t, 3> settledFirst{0, 0, 0};
    std::array<std::int32_t, 3> settledLast{-1, -1, -1};
};

/// A sample that a mesh is too far from, the worst of its tetrahedron.
struct WorstSample {
    double excess = 0; ///< the error divided by its limit, more than 1
    double error = 0;
    PackedPoint point = 0;
    std::uint32_t slot = 0;
    std::array<PackedPoint, 4> tetrahedron{}; ///< what the slot held
};

/// The worse first, then the first in the lattice.
inline bool isWorse(const WorstSample& one, const WorstSample& other)
{
    if (one.excess != other.excess)
        return one.excess > other.excess;
    if (one.error != other.error)
        return one.error > other.error;
    return one.point < other.point;
}

/// Whether the tetrahedron in which the sample was found still exists, and the sample is not a vertex yet: it may have
/// been inserted to repair a flipped tetrahedron elsewhere, and several blocks share the samples on their borders.
inline bool stands(const LocalDelaunay& mesh, const WorstSample& sample)
{
    const DelaunayTetrahedron& now = mesh.mesh()[sample.slot];
    return now.determinant() > 0 && now.vertices == sample.tetrahedron && !mesh.isVertex(sample.point);
}

/// The samples to look at in a tetrahedron.
enum class ScannedPart {
    All,
    Limited, ///< only where the limits are not the largest
};

/// Looks at the samples in tetrahedra (closed, so that those on faces are looked at more than once), but for vertices,
/// and appends the worst of each tetrahedron that has one beyond the limits. Exact about what lies where; errors are
/// one division of exact integers for samples of up to 16 bits (S8), and rounded in doubles else.
void scanSamples(const LocalDelaunay& mesh, std::span<const std::uint32_t> slots, const LatticeSamples& samples,
                 const ErrorLimits& limits, ScannedPart part, std::vector<WorstSample>& worst);

/// The slots that scanSamples() has to look at: in floats, sixteen rows of samples at a time, so that what lies
/// close to a face or to its limit counts as in and beyond. None is left out that has a sample beyond its limit. No
/// sample is farther from 0 than `reach`. Where the machine has no vectors for that, all are suspects.
struct FilteredTetrahedra {
    std::vector<std::uint32_t> suspects;
    std::vector<std::uint32_t> fine; ///< some of the others: none of their samples is beyond the least limit
};
void filterTetrahedra(const LocalDelaunay& mesh, std::span<const std::uint32_t> slots, const LatticeSamples& samples,
                      double reach, const ErrorLimits& limits, ScannedPart part, FilteredTetrahedra& filtered);

} // namespace tetra
