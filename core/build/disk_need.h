// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/blocks/block_runs.h"

#include <tan/base.h>
#include <tan/data.h>

#include <cstdint>
#include <filesystem>

namespace tetra {

/// What a build in blocks takes on the model's disk, in bytes.
struct DiskNeed {
    std::uint64_t model = 0;
    std::uint64_t workFiles = 0; ///< beside the model until it is complete

    std::uint64_t total() const noexcept { return model + workFiles; }
};

/// As it seems from what the blocks' runs are expected to come to.
DiskNeed diskNeed(const RunTotals& expected, SampleType type, DomainClass domain) noexcept;

/// "model about 1.5 GB, work files 2.3 GB".
Message textOf(const DiskNeed& need);

/// An error (CannotWrite) with both numbers unless `free` bytes have room for what is not `written` yet. `folder`, that
/// of the model, is for its text.
Status checkRoom(const DiskNeed& need, std::uint64_t written, std::uint64_t free, const std::filesystem::path& folder);

} // namespace tetra
