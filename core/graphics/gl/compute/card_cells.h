// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/gl/compute/card_keys.h"
#include "core/graphics/gl/compute/key_sort.h"

#include <functional>

namespace tetra {

/// The cells of a mesh that show something in a picture, in the memory of the graphics card: chosen, sorted and made
/// ready to be drawn there. 32 bytes a cell, 20 a vertex and up to 4 MiB. As StorageBuffer.
class CardCells {
public:
    /// Sets the uniforms of a view and a volume (image.glsl, cell.glsl, volume.frag) in the program in use.
    using SetView = std::function<void(const GlProgram& program)>;

    /// Chooses the cells whose values are seen (classifyCells) and that may be in the picture, and sorts them. `keys`
    /// are of all cells of `mesh`. Errors: those of checkDriver().
    Status choose(const ComputeContext& context, const ComputePrograms& programs, const CardMesh& mesh,
                  const CardKeys& keys, const VolumeTransfer& transfer, const SetView& setView);

    std::size_t count() const noexcept { return count_; } ///< of what choose() chose
    std::size_t chunkCount() const noexcept;
    /// What choose() sent to the card.
    std::size_t sentBytes() const noexcept { return sentBytes_; }

    /// Makes a chunk of the cells ready, front to back, with ComputePrograms::setUp, whose uniforms are set; leaves it
    /// in use. How many cells there are.
    int setUpChunk(const ComputeContext& context, const ComputePrograms& programs, const CardMesh& mesh,
                   std::size_t chunk);
    /// Lets the program in use, ComputePrograms::draw, read that chunk.
    void bindChunk(const GlProgram& program) const;

private:
    void sendTransfer(const ComputeContext& context, const VolumeTransfer& transfer);

    StorageBuffer projected_;
    StorageBuffer vertexSegments_;
    StorageBuffer segmentsOfCell_;
    StorageBuffer shown_;
    StorageBuffer knots_;
    StorageBuffer visibleBefore_;
    StorageBuffer chunk_;
    KeySort sort_;
    PrefixSums sums_;
    std::size_t count_ = 0;
    std::size_t cellsPerChunk_ = 1;
    std::size_t sentBytes_ = 0;
};

} // namespace tetra
