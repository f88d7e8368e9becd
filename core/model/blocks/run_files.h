// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/model/blocks/block_run.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tetra {

/// Of its file, in all.
std::uint64_t runBytes(const BlockRunHeader& header) noexcept;

/// That a mesh of so many tetrahedra fits a model, or as many as are expected in the end as far as that can be known.
/// An Error (OutOfResource) if not.
Status checkMeshSize(std::uint64_t tetrahedra, std::uint64_t expected);

/// The runs of all blocks of a build, as files in one folder. Reading is safe from any number of threads.
class RunFiles {
public:
    /// Runs of `blockCount` blocks that depend on what `fingerprint` stands for.
    RunFiles(std::filesystem::path folder, std::uint64_t fingerprint, std::uint32_t blockCount);
    ~RunFiles();
    RunFiles(const RunFiles&) = delete;
    RunFiles& operator=(const RunFiles&) = delete;

    std::uint32_t blockCount() const noexcept { return static_cast<std::uint32_t>(headers_.size()); }
    std::filesystem::path path(std::uint32_t block) const;
    std::uint64_t fingerprint() const noexcept { return fingerprint_; }

    /// Whether the run of the block is there, whole and of this build: reads all of it.
    bool intact(std::uint32_t block) const;

    /// Of a run that is there; for building.
    Result<BlockRunHeader> readHeader(std::uint32_t block) const;

    /// Reads the headers; comes before the members below, when all runs are there.
    Status open();
    const BlockRunHeader& header(std::uint32_t block) const { return headers_[block]; }
    Status readWords(std::uint32_t block, std::uint64_t first, std::span<std::uint32_t> words) const;
    Status readTetrahedra(std::uint32_t block, std::uint64_t first, std::uint64_t count, std::span<std::byte> to) const;

private:
    class OpenFile;

    Result<BlockRunHeader> readHeader(const OpenFile& file, std::uint32_t block) const;
    Status read(std::uint32_t block, std::uint64_t offset, std::span<std::byte> to) const;
    Error unreadable(std::uint32_t block, int systemError) const;
    Error unreadable(std::uint32_t block, const std::string& why) const;
    Error damaged(std::uint32_t block) const;

    std::filesystem::path folder_;
    std::uint64_t fingerprint_;
    std::vector<BlockRunHeader> headers_;
    std::vector<int> descriptors_; ///< none if there are too many to keep them open
};

} // namespace tetra
