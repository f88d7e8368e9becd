// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_writer.h"
#include "plugins/api/output_file.h"

#include <tan/base.h>

#include <memory>
#include <utility>
#include <vector>

namespace tetra {

/// What writers write into: files that appear whole or not at all (FileWriter), a piece of a quarter of a megabyte at a
/// time, after each of which it is told how far the writing is and looked whether it should stop.
class SafeOutput : public OutputFile {
public:
    static Result<std::unique_ptr<SafeOutput>> create(const std::filesystem::path& target, MarkedText activity,
                                                      const Progress& progress);

    const std::filesystem::path& target() const override { return target_; }
    void expect(std::uint64_t bytes) override { expected_ = bytes; }
    Status bytes(std::span<const std::byte> bytes) override;
    Result<OutputFile*> another(const std::filesystem::path& target) override;
    void remark(Message sentence) override { remarks_.push_back(std::move(sentence)); }

    /// Puts all files into their places, the first one last.
    Status commit();
    /// Those on all files, the first one's first.
    std::vector<Message> remarks() const;

private:
    SafeOutput(FileWriter file, std::filesystem::path target, MarkedText activity, const Progress& progress)
        : file_(std::move(file)), target_(std::move(target)), activity_(activity), progress_(progress)
    {
    }
    std::uint64_t written() const;

    FileWriter file_;
    std::filesystem::path target_;
    MarkedText activity_;
    Progress progress_;
    std::uint64_t expected_ = 0;
    std::vector<Message> remarks_;
    std::vector<std::unique_ptr<SafeOutput>> others_;
    const SafeOutput* first_ = this; ///< of several files: to which this one was added
};

} // namespace tetra
