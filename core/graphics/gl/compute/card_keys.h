// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/graphics/gl/compute/card_mesh.h"
#include "core/graphics/gl/compute/compute_programs.h"
#include "core/graphics/volume/facing.h"

#include <cstdint>
#include <span>

namespace tetra {

/// Keys on the graphics card by which cells are sorted front to back (S14). They are made from the powers of the eye to
/// the circumspheres, which are right for Delaunay meshes but for rounding and cospherical ties, and then raised, round
/// by round, over those of the neighbours in front, until every face is right: so they are exact whatever they began
/// with, and near ties cost rounds only. As StorageBuffer.
class CardKeys {
public:
    /// Makes keys for all cells of a mesh with neighbours. False if they are not right after mostRounds rounds: then
    /// there is a circle, or the mesh is far from Delaunay, and the processor has to order it. `bounds` is the mesh's.
    /// O(cells) a round. Errors: cancelled, those of checkDriver().
    Result<bool> make(const ComputeContext& context, const ComputePrograms& programs, const CardMesh& mesh,
                      const EyePoint& eye, const Eigen::AlignedBox3d& bounds, const Progress& progress = {});
    /// Takes an order of all cells that the processor has made.
    void take(const ComputeContext& context, std::span<const std::uint32_t> order);

    /// One word for each cell: in an order, less than those of the cells behind.
    const StorageBuffer& keys() const noexcept { return keys_; }
    unsigned bits() const noexcept { return bits_; }     ///< how many bits of each word count
    unsigned rounds() const noexcept { return rounds_; } ///< that make() took, those that found nothing more included

    static constexpr unsigned mostRounds = 256;

private:
    void begin(const ComputeContext& context, const GlProgram& program, const CardMesh& mesh, const EyePoint& eye,
               const Eigen::AlignedBox3d& bounds);
    bool relax(const ComputeContext& context, const GlProgram& program, const CardMesh& mesh);

    StorageBuffer facing_;
    StorageBuffer keys_;
    StorageBuffer changes_;
    unsigned bits_ = 32;
    unsigned rounds_ = 0;
};

} // namespace tetra
