// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/gl/compute/storage_buffer.h"
#include "core/graphics/gl/gl_program.h"

#include <vector>

namespace tetra {

/// Sums on the graphics card. Keeps the room that it needs, a two thousandth of the numbers'. As StorageBuffer.
class PrefixSums {
public:
    /// Each of the first `count` words of `numbers` becomes the sum of those before it. `program` is
    /// ComputePrograms::sums.
    void run(const ComputeContext& context, const GlProgram& program, const StorageBuffer& numbers, std::size_t count);

private:
    std::vector<StorageBuffer> blocks_; ///< sums of blocks, and of blocks of those ...
};

} // namespace tetra
