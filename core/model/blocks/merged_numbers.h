// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/scratch_file.h"
#include "core/model/blocks/run_files.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace tetra {

/// The number that each site of each block has in the whole model.
class MergedNumbers {
public:
    /// Goes once through all runs. 4 bytes a site of a block, in a file in `workFolder` that the system may keep in
    /// memory. Errors: unreadable runs, no room, too many sites, cancelled.
    static Result<MergedNumbers> make(const RunFiles& runs, const std::filesystem::path& workFolder,
                                      const Progress& progress);

    /// In all blocks, each once.
    std::uint32_t siteCount() const noexcept { return siteCount_; }
    std::span<const std::uint32_t> ofBlock(std::uint32_t block) const
    {
        return file_.as<const std::uint32_t>().subspan(firsts_[block], firsts_[block + 1] - firsts_[block]);
    }

private:
    explicit MergedNumbers(ScratchFile file) : file_(std::move(file)) {}
    Status fill(const RunFiles& runs, const Progress& progress);

    ScratchFile file_;
    std::vector<std::uint64_t> firsts_; ///< where each block's numbers begin, and the end
    std::uint32_t siteCount_ = 0;
};

} // namespace tetra
