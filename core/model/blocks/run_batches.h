// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/blocks/run_files.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// Reads the batches of one run one after the other through a buffer.
class RunBatches {
public:
    RunBatches(const RunFiles& files, std::uint32_t block, std::uint32_t bufferWords)
        : files_(&files), block_(block), bufferWords_(bufferWords)
    {
    }

    /// The bits of the running key of the next batch, greater ones for greater keys; none at the end. An Error if the
    /// file cannot be read.
    Result<std::optional<std::uint32_t>> nextKey();

    /// A group of the batch whose key was asked for.
    struct Group {
        std::uint32_t tetrahedronCount = 0;
        std::uint32_t destroyedCount = 0;
        std::span<const std::uint32_t> points; ///< until the next call
    };
    /// The number of groups, then as many groups.
    Result<std::uint32_t> groupCount();
    Result<Group> nextGroup();

private:
    Status fetch(std::uint32_t words);
    std::uint32_t take() { return buffer_[position_++]; }

    const RunFiles* files_;
    std::uint32_t block_;
    std::uint32_t bufferWords_;
    std::uint64_t read_ = 0; ///< words of the file that are or were in the buffer
    std::vector<std::uint32_t> buffer_;
    std::size_t position_ = 0;
};

} // namespace tetra
