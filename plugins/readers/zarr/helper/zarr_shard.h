// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/zarr/helper/zarr_array.h"

#include <tan/base.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// Where the chunks lie in the file of a shard.
class ShardIndex {
public:
    /// Of a file with these bytes. The error is a sentence about the file, "it".
    static Result<ShardIndex> of(const ZarrArray& array, std::span<const std::byte> file);

    /// The bytes of a chunk, by its numbers within the shard; nothing if nobody wrote it. The error is a sentence about
    /// the file, "it".
    Result<std::optional<std::span<const std::byte>>> chunk(const std::vector<std::uint64_t>& numbers) const;

private:
    std::span<const std::byte> file_, index_;
    std::vector<std::uint64_t> counts_; ///< of chunks along each axis
    bool isBigEndian_ = false;
};

} // namespace tetra
